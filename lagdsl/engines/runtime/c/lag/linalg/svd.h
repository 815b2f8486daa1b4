/*
 * Singular values of small dense matrices: ranks, null spaces, solutions of minimum norm. A' P = Q R with pivoting, then one-sided
 * Jacobi rotations on R', which is nearly orthogonal by then.
 *
 * Source: Drmac and Veselic, New fast and accurate Jacobi SVD algorithm, SIAM J. Matrix Anal. Appl. 29 (2008) 1322.
 */
#ifndef LAG_SVD_H
#define LAG_SVD_H

#include <stddef.h>

/* Singular values below this part of the largest are round-off; residuals, too, of conditions that follow from others. */
static const double LAG_RANK = 1e-9;
/* The same of matrices that are known by and large: of differences, and in positions that are singular up to their residuals. */
static const double LAG_ROUGH_RANK = 1e-7;

/* A = sum of value[i] u[i] v[i]', values descending; vectors are rows here. */
typedef struct lag_svd {
    size_t m, n, k; /* of A (m, n); k: the smaller of both */
    double *value;  /* (k) */
    double *u;      /* (k, m) zero where the value is */
    double *v;      /* (n, n) orthonormal; beyond k they span what A makes zero */
    double *factors, *tau, *diagonal, *pivot, *turned;
} lag_svd;

/* Doubles for a matrix (m, n), and for all that have no more rows and columns. */
size_t lag_svd_memory(size_t m, size_t n);

/* Of A (m, n), with what is found in `memory`. A must be finite. */
lag_svd lag_svd_of(size_t m, size_t n, const double *a, double *memory);

/* Number of values above `tolerance` times the largest. */
size_t lag_svd_rank(const lag_svd *svd, double tolerance);

/*
 * The least-squares solution x (n) of A x = right (m) of smallest norm, with values up to `tolerance` times the largest as zero; `damping`,
 * as a part of the largest, shortens it.
 */
void lag_svd_solve(const lag_svd *svd, const double *right, double tolerance, double damping, double *x);

/* The same of A' x = right (n), x (m). */
void lag_svd_solve_transposed(const lag_svd *svd, const double *right, double tolerance, double *x);

#endif
