/* Small dense linear algebra: row-major matrices, nothing allocated. */
#ifndef LAG_LINALG_H
#define LAG_LINALG_H

#include <stddef.h>

/* Sums of products are known to this part of their terms: a row that is smaller beside others is zero. */
static const double LAG_ROUNDING = 1e-14;

/* Residuals of equations of order one are round-off below this. */
static const double LAG_EXACT = 1e-13;

/* Cholesky factor L of the symmetric a (n, n), into its lower half. Returns the index of the first pivot that is not above
 * `tolerance` (the factor is complete before it), n if there is none. */
size_t lag_cholesky(size_t n, double *a, double tolerance);

/* x (n) := (L L')^-1 x. */
void lag_cholesky_solve(size_t n, const double *factor, double *x);

/* Eigenvalues (n) and eigenvectors, the columns of v (n, n), of the symmetric a (n, n), which is destroyed: cyclic Jacobi. */
void lag_symmetric_eigen(size_t n, double *a, double *value, double *v);

/*
 * A' P = Q R for the rows of a (m, n): Householder reflections of the rows, each time of the one that has the longest rest.
 * Returns the rank: the number of pivots above `tolerance` times the first, at most `most`. Afterwards row i of a came from
 * row pivot[i] (m; kept as doubles, a workspace is of one type) and holds column i of R left of its diagonal; from there on
 * it holds the reflection vector, whose factor is tau[i] (rank). diagonal (rank) is that of R.
 */
size_t lag_qr(size_t m, size_t n, double *a, double *tau, double *diagonal, double *pivot, size_t most, double tolerance);

/* x (n) := Q x, or Q' x, for the factors of lag_qr; entries of x are `stride` apart. */
void lag_qr_apply(size_t rank, size_t n, const double *a, const double *tau, double *x, size_t stride);
void lag_qr_apply_transposed(size_t rank, size_t n, const double *a, const double *tau, double *x, size_t stride);

/* x (n, count) := Q' x, and x (count, n) := x Q. */
void lag_qr_apply_to_columns(size_t rank, size_t n, const double *a, const double *tau, size_t count, double *x);
void lag_qr_apply_to_rows(size_t rank, size_t n, const double *a, const double *tau, size_t count, double *x);

/* Takes from x (m) its parts along the orthonormal rows of `basis` (count, m). */
void lag_remove_parts(size_t count, size_t m, const double *basis, double *x);

/* Makes x (m), which does not depend on these rows, orthogonal to them and of unit length. */
void lag_orthonormalize(size_t count, size_t m, const double *basis, double *x);

#endif
