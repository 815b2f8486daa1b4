/*
 * Arrays of doubles in memory of the caller: laid out, filled, looked through. Indices and flags in it are doubles, too, exact up to
 * 2^53: a caller may declare the memory as an array of doubles, and C (6.5, effective types) lets nothing else lie in such an array.
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

/* Every entry of x (count) becomes `value`. */
static inline void lag_fill(size_t count, double value, double *x)
{
    for (size_t i = 0; i < count; ++i) {
        x[i] = value;
    }
}

/* True if one of the flags (count) is set. */
static inline int lag_any(size_t count, const double *flags)
{
    size_t i = 0;
    while (i < count && flags[i] == 0.0) {
        ++i;
    }
    return i < count;
}

#endif
