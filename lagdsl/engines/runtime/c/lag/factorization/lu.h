/* Decomposition of dense square matrices by Gaussian elimination with partial pivoting, real and complex; row by row. */
#ifndef LAG_LU_H
#define LAG_LU_H

#include <stddef.h>

/*
 * P a = L U into a (n, n); pivot (n) holds row numbers, as doubles: a workspace is of one type. Returns 0 where a pivot is zero
 * or no number, else 1.
 */
int lag_lu(size_t n, double *a, double *pivot);

/* x (n) := a^-1 x. */
void lag_lu_solve(size_t n, const double *a, const double *pivot, double *x);

/* The same for complex numbers, each stored as two doubles: a (n, n, 2), x (n, 2). */
int lag_lu_complex(size_t n, double *a, double *pivot);
void lag_lu_complex_solve(size_t n, const double *a, const double *pivot, double *x);

#endif
