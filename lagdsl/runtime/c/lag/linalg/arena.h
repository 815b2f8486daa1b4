/*
 * Arrays of doubles in memory of the caller: laid out, filled, looked through. Indices in it are doubles, too, exact up to 2^53: a
 * caller may declare the memory as an array of doubles, and C (6.5, effective types) lets nothing but them and characters lie in it.
 */
#ifndef LAG_MEMORY_H
#define LAG_MEMORY_H

#include <stddef.h>

/* The next `count` doubles; *memory goes on behind them. */
static inline double *lag_take(double **memory, size_t count)
{
    double *start = *memory;
    *memory += count;
    return start;
}

/* As many flags, all zero, in the room of `count` doubles. */
static inline unsigned char *lag_take_flags(double **memory, size_t count)
{
    unsigned char *flags = (unsigned char *)(void *)lag_take(memory, count);
    for (size_t i = 0; i < count; ++i) {
        flags[i] = 0;
    }
    return flags;
}

/* Every entry of x (count) becomes `value`. */
static inline void lag_fill(size_t count, double value, double *x)
{
    for (size_t i = 0; i < count; ++i) {
        x[i] = value;
    }
}

/* Whether a flag (count) is set. */
static inline int lag_any(size_t count, const double *flags)
{
    size_t i = 0;
    while (i < count && flags[i] == 0.0) {
        ++i;
    }
    return i < count;
}

#endif
