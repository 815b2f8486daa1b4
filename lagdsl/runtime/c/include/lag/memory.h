/* Laying out arrays in memory of the caller. */
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

#endif
