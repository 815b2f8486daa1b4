/* Vectors of doubles. */
#ifndef LAG_VECTOR_H
#define LAG_VECTOR_H

#include <math.h>
#include <stddef.h>

/* x . y */
static inline double lag_dot(size_t count, const double *x, const double *y)
{
    double sum = 0.0;
    for (size_t i = 0; i < count; ++i) {
        sum += x[i] * y[i];
    }
    return sum;
}

/* The magnitudes of the terms of x . y: below a part of their sum it is round-off. */
static inline double lag_dot_size(size_t count, const double *x, const double *y)
{
    double sum = 0.0;
    for (size_t i = 0; i < count; ++i) {
        sum += fabs(x[i] * y[i]);
    }
    return sum;
}

/* True if x and y are equal, each number of them. */
static inline int lag_same(size_t count, const double *x, const double *y)
{
    size_t i = 0;
    while (i < count && x[i] == y[i]) {
        ++i;
    }
    return i == count;
}

/* One number after the other: what was written so a moment ago cannot be read in blocks before it has reached the cache. */
static inline void lag_copy(size_t count, const double *from, double *to)
{
    for (size_t i = 0; i < count; ++i) {
        to[i] = from[i];
    }
}

/* Entries (count) of one lane into the rows (count, lanes) of several, or out of them. */
static inline void lag_lane_put(size_t lanes, size_t lane, size_t count, const double *from, double *rows)
{
    for (size_t i = 0; i < count; ++i) {
        rows[i * lanes + lane] = from[i];
    }
}

static inline void lag_lane_get(size_t lanes, size_t lane, size_t count, const double *rows, double *to)
{
    for (size_t i = 0; i < count; ++i) {
        to[i] = rows[i * lanes + lane];
    }
}

/* y += factor x */
static inline void lag_axpy(size_t count, double factor, const double *x, double *y)
{
    for (size_t i = 0; i < count; ++i) {
        y[i] += factor * x[i];
    }
}

#endif
