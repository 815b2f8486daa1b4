/*
 * Eigenvalues of a small real matrix that is not symmetric: to Hessenberg form, then QR steps with complex shifts.
 *
 * Source: Golub and Van Loan, Matrix Computations, 4th ed., sections 7.4 and 7.5.
 */
#ifndef LAG_EIGENVALUES_H
#define LAG_EIGENVALUES_H

#include <stddef.h>

/* Doubles for a matrix (n, n). */
size_t lag_eigenvalues_memory(size_t n);

/* The smallest real part among the eigenvalues of a (n, n); infinite for n = 0, not a number where they are not found. */
double lag_least_real_part(size_t n, const double *a, double *arena);

#endif
