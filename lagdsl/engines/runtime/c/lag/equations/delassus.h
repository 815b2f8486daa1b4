/*
 * Multipliers of the rows that elimination left to run time.
 *
 * With the multipliers x of these rows zero, elimination() gives accelerations a and multipliers l; a unit of x_i adds Y_i
 * and K_i to them. The rows then require S x = gamma - J a with the small matrix S = J Y' (Delassus). S is symmetric, and
 * singular if rows depend on each other. It is factored by Cholesky's method, each time on the row that has the longest
 * rest, row by row with the entries that are not zero: a chain of rows costs about as much as it is long. S has the square of J's condition; a
 * step of refinement whose residual comes from J itself takes that back as long as S has digits left (corrected seminormal equations: Bjorck,
 * Linear Algebra and its Applications 88/89, 1987).
 */
#ifndef LAG_DELASSUS_H
#define LAG_DELASSUS_H

#include <stddef.h>

#include "lag/linalg/pivoted_cholesky.h"
#include "lag/model.h"

/* Memory of one call. */
typedef struct lag_delassus_work {
    double *part, *x; /* (kept) */
} lag_delassus_work;

/* Results of elimination() for the rows that it leaves. */
typedef struct lag_left_rows {
    double *response, *lam_response, *jacobian, *gamma; /* (nk, nq) (nk, nc) (nk, nq) (nk) */
} lag_left_rows;

/* Doubles of lag_arguments.kept that they take, and all in `memory` where there is no such memory (null). */
size_t lag_left_rows_kept(const lag_model *model);
lag_left_rows lag_left_rows_place(const lag_model *model, const lag_kept *kept, double **memory);

/* One system; everything points into memory of the caller. */
typedef struct lag_delassus {
    size_t n, m, kept;              /* accelerations, rows, rows that are left */
    size_t rank, dependent;         /* independent ones of these; others, less those that are zero */
    const size_t *row;              /* (kept) which rows */
    const double *response;         /* Y (kept, n) */
    const double *lam_response;     /* K (kept, m), zero at the kept rows */
    const double *jacobian;         /* J (kept, n) */
    lag_patterns patterns;
    lag_pivoted_cholesky factor;    /* of S */
    double *excess;                 /* (dependent, m) combinations of multipliers that change nothing, of length one */
    double *gram;                   /* (dependent, dependent) factor of their products */
    lag_delassus_work work;
} lag_delassus;

/* Doubles that `kept` of m rows need. */
size_t lag_delassus_memory(size_t m, size_t kept);

/* Lays out the system in `memory`; Y, K and J are set by the caller and must stay. `patterns`: those of lag_model, or null. */
void lag_delassus_place(
    lag_delassus *system, size_t n, size_t m, size_t kept, const size_t *row, const lag_patterns *patterns, double *memory);

/* The diagonal of S; returns the number of kept rows of J that have entries, but for those flagged in `redundant` (m), or null. */
size_t lag_delassus_weigh(lag_delassus *system, const unsigned char *redundant);

/*
 * Factors S behind that, of whose rows `rank` are independent; none: S is round-off. LAG_MISSING: it has too few digits left to be solved, or the other rows
 * do not depend on them here; the dense system tells.
 */
lag_status lag_delassus_factor(lag_delassus *system, size_t rank);

/* From a (n) and l (m) to accelerations and multipliers, of least Euclidean norm, for gamma (kept). */
void lag_delassus_solve(lag_delassus *system, const double *gamma, double *a, double *lam);

#endif
