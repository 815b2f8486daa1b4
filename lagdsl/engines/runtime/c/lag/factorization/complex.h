/* Arithmetic of complex numbers, each stored as two doubles. */
#ifndef LAG_COMPLEX_H
#define LAG_COMPLEX_H

#include <math.h>

/* |re| + |im| */
static inline double lag_complex_size(const double *z)
{
    return fabs(z[0]) + fabs(z[1]);
}

/* z / w; the parts of w are not so far apart that squares could overflow. */
static inline void lag_complex_divide(const double *z, const double *w, double *quotient)
{
    const double length = w[0] * w[0] + w[1] * w[1];
    const double re = (z[0] * w[0] + z[1] * w[1]) / length;
    quotient[1] = (z[1] * w[0] - z[0] * w[1]) / length;
    quotient[0] = re;
}

/* z w into a place of neither */
static inline void lag_complex_multiply(const double *z, const double *w, double *product)
{
    product[0] = z[0] * w[0] - z[1] * w[1];
    product[1] = z[0] * w[1] + z[1] * w[0];
}

/* z -= v w */
static inline void lag_complex_subtract_product(double *z, const double *v, const double *w)
{
    const double re = v[0] * w[0] - v[1] * w[1];
    z[1] -= v[0] * w[1] + v[1] * w[0];
    z[0] -= re;
}

#endif
