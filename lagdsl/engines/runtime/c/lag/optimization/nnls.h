/*
 * Minimises x'A x/2 + b'x subject to x >= 0, A symmetric and positive semidefinite; what of b is outside of the range of A is left
 * out. At the solution A x + b >= 0 too, one of the two zero for each i: a linear complementarity problem.
 *
 * Source: Lawson, Hanson, Solving Least Squares Problems, 1974, ch. 23, on the normal equations.
 */
#ifndef LAG_NNLS_H
#define LAG_NNLS_H

#include <stddef.h>

/* Doubles for n unknowns. */
size_t lag_nnls_memory(size_t n);

/* x (n) for a (n, n) and b (n), which stay. */
void lag_nnls(size_t n, const double *a, const double *b, double *x, double *memory);

#endif
