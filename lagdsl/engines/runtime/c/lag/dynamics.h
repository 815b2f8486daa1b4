/*
 * Accelerations and multipliers of a model, whatever the ranks:  M a - J' lam = f,  J a = gamma.
 *
 * Where the model has them eliminated and that keeps enough digits (lag/equations/delassus.h), that is taken. Elsewhere it is the
 * null-space method, as in the generated NumPy modules. Coordinates are scaled to a unit diagonal of M and rows of J to
 * unit length, so that ranks do not depend on units. With J' = Q R, the first components of y = Q'a follow from J a = gamma,
 * the others from the rows of M a = f + J'lam that no multiplier enters, and lam from the rest, of least Euclidean norm.
 * M may be singular; only its restriction to the null space of J must not be.
 */
#ifndef LAG_DYNAMICS_H
#define LAG_DYNAMICS_H

#include "lag/equations/delassus.h"
#include "lag/model.h"

/*
 * Rows of which less than this part is left beside others depend on them (RANK_TOLERANCE of the NumPy modules). So a solution satisfies rows if it
 * leaves less than this part of what was there.
 */
static const double LAG_REACHED = 1e-8;

/* Of rows that depend on each other, those that count. */
typedef struct lag_row_choice {
    /* (m) 1: this one counts as the dependent one, where the others do as well; null: what rounding says */
    const unsigned char *late;
    /* (n) (m) natural sizes: those count that are long in these; null: all that are not very short */
    const double *sizes, *row_sizes;
} lag_row_choice;

/* Memory of one call. */
typedef struct lag_system_work {
    double *copy;           /* (n, n) */
    double *y, *h, *rest;   /* (n) */
    double *l, *row_rest;   /* (m) */
} lag_system_work;

/* One system; everything points into memory of the caller. */
typedef struct lag_system {
    size_t n, m;            /* unknown accelerations, rows */
    size_t rank;            /* independent rows */
    size_t combinations;    /* of rows that are not zero, which vanish */
    size_t indefinite;      /* 1: `factor` holds eigenvectors, 0: a Cholesky factor */
    const double *mass;     /* (n, n) */
    const double *jacobian; /* (m, n) */
    const size_t *components; /* (n) coordinates of different ones share no row and no entry of M; null: all are of one */
    lag_row_choice choice;
    double *column_scale;   /* (n) */
    double *row_scale;      /* (m) */
    double *rows;           /* (m, n) factors of the scaled J' */
    double *tau, *diagonal; /* (min(m, n)) */
    double *pivot;          /* (m) */
    double *reduced;        /* (n, n) Q' M Q of the scaled M */
    double *factor;         /* of its part beyond the rank, tightly packed */
    double *eigenvalue;     /* (n) */
    double *excess;         /* (m, m) orthonormal combinations of rows that vanish, one per row beyond the rank that is not zero */
    lag_system_work work;
} lag_system;

/* Doubles that a system of n unknowns and m rows needs. */
size_t lag_system_memory(size_t n, size_t m);

/* Lays out `system` in `memory`. `components` (n) are numbers of what M and J couple; null: all that there is. */
void lag_system_place(lag_system *system, size_t n, size_t m, const size_t *components, double *memory);

/*
 * Factors the system of `mass` (n, n) and `jacobian` (m, n), of whose rows at most `most` are independent; both must stay.
 * LAG_SINGULAR: *coordinate (if not null) is the index of the coordinate with the largest part in the undetermined direction.
 */
lag_status lag_system_factor(
    lag_system *system, const double *mass, const double *jacobian, size_t most, size_t *coordinate);

/*
 * For lag_system_factor(): `column_scale`, `row_scale` and the scaled `rows` for the mass and the Jacobian that were set; `dependent`: some rows follow
 * from others.
 */
void lag_system_scale(lag_system *system, int dependent);

/* Solution a (n), lam (m) for force (n) and gamma (m), refined to working accuracy. */
void lag_system_solve(lag_system *system, const double *force, const double *gamma, double *a, double *lam);

/* The shortest v (n), in scaled coordinates, with J v = gamma (m) for the independent rows. */
void lag_system_least(lag_system *system, const double *gamma, double *v);

/* Doubles that the functions below need beside the workspace of the model. */
size_t lag_dynamics_memory(const lag_model *model);

/* Accelerations qdd (nq) and multipliers lam (nc) at t q qd z u w p, after prepare(). */
lag_status lag_forward_dynamics(
    const lag_model *model, const lag_arguments *at, double *memory, double *qdd, double *lam, size_t *coordinate);

/* The same along a motion: `chord` is that of lag/equations/feedback.h. */
lag_status lag_forward_dynamics_along(
    const lag_model *model, const lag_arguments *at, double *memory, double *chord, double *qdd, double *lam, size_t *coordinate);

/* At or below this pivot of elimination(), the dense system decides whether the position is singular. */
double lag_smallest_pivot(const lag_model *model);

/*
 * Completes the results of elimination() for the rows that it left; qdd and lam hold its accelerations and multipliers and
 * receive the final ones. `memory` is lag_delassus_memory(nc, nk). LAG_MISSING: it kept too few digits, or has values that
 * are no numbers.
 */
lag_status lag_solve_eliminated(
    const lag_model *model,
    const double *response,
    const double *lam_response,
    const double *jacobian,
    const double *gamma,
    double pivot,
    double *memory,
    double *qdd,
    double *lam);

/* The first part of it: with `system`, lag_delassus_solve() completes any number of right-hand sides. */
lag_status lag_factor_eliminated(
    const lag_model *model,
    const double *response,
    const double *lam_response,
    const double *jacobian,
    double pivot,
    double *memory,
    lag_delassus *system);

/* Results of elimination() for several states or, with qdd null, of dynamics(): every array in groups of `lanes`. */
typedef struct lag_formed {
    size_t lanes;
    const double *qdd, *lam, *response, *lam_response, *pivot; /* (nq) (nc) (nk, nq) (nk, nc) () */
    const double *mass, *force;                                /* (nq, nq) (nq) */
    const double *jacobian, *gamma;                            /* (nk, nq) (nk), or (nc, nq) (nc) */
} lag_formed;

/* The same for the state of one lane. LAG_MISSING: elimination is no way to solve this one. */
lag_status lag_forward_dynamics_of_lane(
    const lag_model *model,
    const lag_formed *formed,
    size_t lane,
    double *memory,
    double *qdd,
    double *lam,
    size_t *coordinate);

#endif
