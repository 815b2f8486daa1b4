/* Checks that results are finite. */
#ifndef LAG_FINITE_H
#define LAG_FINITE_H

#include <stddef.h>

/* 1 where no entry of x (count) is infinite or nan: zero times such an entry is nan, and four sums wait for each other less
 * than one. */
static inline int lag_finite(size_t count, const double *x)
{
    double a = 0.0, b = 0.0, c = 0.0, d = 0.0;
    size_t i = 0;
    for (; i + 3 < count; i += 4) {
        a += 0.0 * x[i];
        b += 0.0 * x[i + 1];
        c += 0.0 * x[i + 2];
        d += 0.0 * x[i + 3];
    }
    for (; i < count; ++i) {
        a += 0.0 * x[i];
    }
    return (a + b) + (c + d) == 0.0;
}

#endif
