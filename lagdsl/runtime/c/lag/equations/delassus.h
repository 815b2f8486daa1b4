/*
 * Multipliers of the rows that elimination left to run time.
 *
 * With the multipliers x of these rows zero, elimination() gives accelerations a and multipliers l; a unit of x_i adds Y_i
 * and K_i to them. The rows then require S x = gamma - J a with the small matrix S = J Y' (Delassus). S is symmetric, and
 * singular if rows depend on each other. It is factored by Cholesky's method, each time on the row that has the longest
 * rest. S has the square of J's condition; a step of refinement whose residual comes from J itself takes that back as long
 * as S has digits left (corrected seminormal equations: Bjorck, Linear Algebra and its Applications 88/89, 1987).
 */
#ifndef LAG_DELASSUS_H
#define LAG_DELASSUS_H

#include <stddef.h>

#include "lag/model.h"

/* Entries of J that may not be zero. */
typedef struct lag_delassus_pattern {
    const lag_pattern *entries; /* those of J (m, n); null: all */
    double *first, *end;        /* (kept) where the entries of each row begin, and one behind the last */
} lag_delassus_pattern;

/* Rows of two components share nothing. */
typedef struct lag_delassus_components {
    double *component;            /* (kept) that of each row */
    int several;                  /* there are several: */
    double *coordinate, *beside;  /* (n) (n) the first coordinate of each, and the next one in the same; n: none */
    double *leader, *follower;    /* (n) (kept) the first row of each, and the next one in the same; kept: none */
} lag_delassus_components;

/* Memory of one call. */
typedef struct lag_delassus_work {
    double *part, *x, *rest; /* (kept) */
} lag_delassus_work;

/* One system; everything points into memory of the caller. */
typedef struct lag_delassus {
    size_t n, m, kept;              /* accelerations, rows, rows that are left */
    size_t rank, dependent;         /* independent ones of these; others, less those that are zero */
    const size_t *row;              /* (kept) which rows */
    const double *response;         /* Y (kept, n) */
    const double *lam_response;     /* K (kept, m), zero at the kept rows */
    const double *jacobian;         /* J (kept, n) */
    lag_delassus_pattern pattern;
    lag_delassus_components components;
    double *lead, *reach;           /* (kept) the factor of each row is zero before and behind these columns */
    double *factor;                 /* (kept, rank) S = L L', rows as they stand, of those not chosen the first part */
    double *left;                   /* (kept) what is left of the diagonal of S */
    double *weight;                 /* (kept) for comparing rows */
    double *chosen;                 /* (kept) the independent rows in turn, then the others */
    double *excess;                 /* (dependent, m) combinations of multipliers that change nothing, of length one */
    double *gram;                   /* (dependent, dependent) factor of their products */
    lag_delassus_work work;
} lag_delassus;

/* Doubles that `kept` of m rows of n accelerations need. */
size_t lag_delassus_memory(size_t n, size_t m, size_t kept);

/*
 * Lays out the system in `memory`; Y, K and J are set by the caller and must stay. With the pattern of all rows of J (m, n), and components (n);
 * null: not known.
 */
void lag_delassus_place(lag_delassus *system, size_t n, size_t m, size_t kept, const size_t *row, const lag_pattern *entries,
    const size_t *components, double *memory);

/* True if kept row i of J has an entry that is not zero. */
int lag_delassus_holds(const lag_delassus *system, size_t i);

/*
 * Factors S, of whose rows `rank` are independent; none: S is round-off. LAG_MISSING: it has too few digits left to be solved, or the other rows
 * do not depend on them here; the dense system tells.
 */
lag_status lag_delassus_factor(lag_delassus *system, size_t rank);

/* From a (n) and l (m) to accelerations and multipliers, of least Euclidean norm, for gamma (kept). */
void lag_delassus_solve(lag_delassus *system, const double *gamma, double *a, double *lam);

#endif
