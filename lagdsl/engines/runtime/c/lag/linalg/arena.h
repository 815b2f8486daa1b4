/*
 * Arrays of doubles in memory of the caller: laid out, filled, looked through. Indices in it are doubles, too, exact up to 2^53: a
 * caller may declare the memory as an array of doubles, and C (6.5, effective types) lets nothing but them and characters lie in it.
 */
#ifndef LAG_ARENA_H
#define LAG_ARENA_H

#include <stddef.h>

/* The index that a double holds: one instruction, where a conversion to an unsigned number is several. */
static inline size_t lag_index(double x)
{
    return (size_t)(ptrdiff_t)x;
}

/* The next `count` doubles; *memory goes on behind them. */
static inline double *lag_take(double **memory, size_t count)
{
    double *start = *memory;
    *memory += count;
    return start;
}

/* The same for each of these arrays; null behind the last. */
static inline void lag_take_all(double **memory, size_t count, double **const *arrays)
{
    for (; *arrays != NULL; ++arrays) {
        **arrays = lag_take(memory, count);
    }
}

/*
 * Arrays that lie one behind the other. One function lays out what a part of a program works in; where there is no `memory` yet it counts the doubles, and
 * the arrays are null.
 */
typedef struct lag_layout {
    double *memory;
    size_t count; /* so many doubles are laid out */
} lag_layout;

/* The next `count` doubles. */
static inline double *lag_lay(lag_layout *layout, size_t count)
{
    double *start = layout->memory != NULL ? layout->memory + layout->count : NULL;
    layout->count += count;
    return start;
}

/* The same for each of these arrays; null behind the last. */
static inline void lag_lay_all(lag_layout *layout, size_t count, double **const *arrays)
{
    for (; *arrays != NULL; ++arrays) {
        **arrays = lag_lay(layout, count);
    }
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

/* Sizes in bytes, rounded up so that anything may follow. */
static inline size_t lag_padded(size_t bytes)
{
    return (bytes + 15) / 16 * 16;
}

static inline size_t lag_larger(size_t a, size_t b)
{
    return a > b ? a : b;
}

/* Every entry of x (count) becomes `value`. */
static inline void lag_fill(size_t count, double value, double *x)
{
    for (size_t i = 0; i < count; ++i) {
        x[i] = value;
    }
}

/* The next `count` doubles, each of this value. */
static inline double *lag_lay_filled(lag_layout *layout, size_t count, double value)
{
    double *start = lag_lay(layout, count);
    lag_fill(start != NULL ? count : 0, value, start);
    return start;
}

/* The first entry of x (count) that is not zero; count: there is none. */
static inline size_t lag_first(size_t count, const double *x)
{
    size_t i = 0;
    while (i < count && x[i] == 0.0) {
        ++i;
    }
    return i;
}

/* True if an entry of x (count) is not zero. */
static inline int lag_any(size_t count, const double *x)
{
    return lag_first(count, x) < count;
}

#endif
