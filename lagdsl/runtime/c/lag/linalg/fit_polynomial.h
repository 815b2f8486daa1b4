/* Polynomials in time for the derivatives of rates and states of a fitted motion (lag/run/branch_switching.c). */
#ifndef LAG_FIT_POLYNOMIAL_H
#define LAG_FIT_POLYNOMIAL_H

#include <stddef.h>

enum { LAG_FIT_NODES = 7 };

/* Node number i, as a part of the interval. */
double lag_fit_node(size_t i);

/* Polynomials through values (count, width) at the last `count` nodes; rows of `values` become coefficients of the powers of time. */
void lag_fit_interpolate(size_t count, size_t width, double *values);

/* The state at a part of the interval: qd and z as integrals of the polynomials, q as double integrals; not projected. */
void lag_fit_state_at(size_t n, size_t width, const double *coefficients, const double *start, double length, double part, double *x);

#endif
