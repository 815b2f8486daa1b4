/*
 * Maximizes c'x subject to A x <= b, x >= 0, where b >= 0: a linear program that has a solution to begin with, as the complementarity problem of
 * it and its dual.
 *
 * Source: Cottle, Pang, Stone, The Linear Complementarity Problem (1992), section 1.2.
 */
#ifndef LAG_LINEAR_PROGRAM_H
#define LAG_LINEAR_PROGRAM_H

#include <stddef.h>

/* Doubles for n unknowns and m inequalities. */
size_t lag_linear_program_memory(size_t n, size_t m);

/* x (n) for a (m, n), b (m), c (n). Returns 1; 0: it is not bounded. */
int lag_linear_program(size_t n, size_t m, const double *a, const double *b, const double *c, double *x, double *memory);

#endif
