/*
 * One singular value, or their number above a bound, without vectors: reflections from both sides to a matrix of two diagonals, then signs of
 * pivots. Absolute errors are round-off of the largest value. A tenth of the time of lag/linalg/svd.h, which has vectors.
 *
 * Source: Golub and Van Loan, Matrix Computations, 4th ed., sections 5.4.8, 8.4.1 and 8.6.1.
 */
#ifndef LAG_SINGULAR_VALUE_H
#define LAG_SINGULAR_VALUE_H

#include <stddef.h>

/* Doubles for a matrix (m, n), and for all that have no more rows and columns. */
size_t lag_singular_value_memory(size_t m, size_t n);

/* The singular value of a (m, n), finite, that `larger` others are not below; zero where there are no more than these. */
double lag_singular_value(size_t m, size_t n, const double *a, size_t larger, double *memory);

/* Number of singular values of a (m, n), finite, above the positive `bound`. */
size_t lag_singular_values_above(size_t m, size_t n, const double *a, double bound, double *memory);

#endif
