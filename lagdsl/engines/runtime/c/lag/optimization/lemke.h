/*
 * The linear complementarity problem 0 <= z, A z + b >= 0, z'(A z + b) = 0 by Lemke's method, with lexicographic pivots, so that ties make no
 * cycle. A need not be symmetric; where it is copositive plus, a ray means that there is no solution.
 *
 * Source: Cottle, Pang, Stone, The Linear Complementarity Problem (1992), sections 4.4 and 4.9.
 */
#ifndef LAG_LEMKE_H
#define LAG_LEMKE_H

#include <stddef.h>

/* Doubles for n unknowns. */
size_t lag_lemke_memory(size_t n);

/* z (n) for a (n, n) and b (n), which stay. Returns 1, or 0 where the method ends on a ray: z is zero then. */
int lag_lemke(size_t n, const double *a, const double *b, double *z, double *memory);

#endif
