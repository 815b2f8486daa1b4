/*
 * Back to the constraints, after a step: the smallest change in the metric of the mass matrix. dq minimises dq' M dq subject to
 * phi(q + dq) = 0, and dv minimises dv' M dv subject to J (v + dv) + b = 0. Both are solutions of the system of lag/dynamics.h
 * without forces, so that dependent rows and singular M are no special cases.
 *
 * Source: Eich, SIAM J. Numer. Anal. 30 (1993) 1467.
 */
#ifndef LAG_PROJECTION_H
#define LAG_PROJECTION_H

#include "lag/equations/motion.h"

/* The system that gives one change. */
typedef struct lag_projection_step {
    double *mass;          /* (nq, nq), */
    int formed;            /* where it is that of the present projection */
    int factored;          /* the system is that of the residuals that were looked at last */
    lag_system solver;
    double *chosen;        /* (nc, nq) */
    double *right, *force; /* (nc) (nq) */
    double *change, *lam;  /* (nq) (nc) */
    double *response;      /* (nc, nq) */
    double *correction;
    double *system;        /* memory of it, or of its blocks */
} lag_projection_step;

typedef struct lag_projection {
    lag_motion *motion;
    size_t rows;           /* of position level */
    unsigned iterations;   /* at most so many for positions; a bound on the cost */
    double *limits;        /* (nc) residuals that need no correction, */
    double *round_off;     /* (nc) and those that cannot be corrected */
    const double *least;   /* one of the two */
    double *sizes;         /* (nq) natural sizes of the coordinates */
    double *phi;           /* (nc) residuals, and */
    double *jacobian;      /* (nc, nq) their Jacobian, as they were evaluated last */
    lag_projection_step step;
    double *point;         /* (nq) */
    double *component;     /* (nc) that of the coordinates of each row, */
    double *largest;       /* (nq + nz) and what is largest in each of them */
    size_t count;          /* of states that were moved */
    size_t lost;           /* nc; or a condition on rates that the last projection could not satisfy */
} lag_projection;

/* Doubles for the projection of a model. */
size_t lag_projection_memory(const lag_model *model);

/* Lays it out in `memory`. Sizes are one and limits zero until they are set. */
void lag_projection_place(lag_projection *projection, lag_motion *motion, double *memory);

/* phi and J where the motion is: of position_constraint(), or of velocity_constraint(). */
lag_status lag_projection_evaluate(lag_projection *projection, int velocities);

/*
 * Limits for a residual that is `tolerance` in SI units, and the same part of the row's size where that is below one; round-off of
 * large rows passes.
 */
void lag_projection_limits(lag_projection *projection, double tolerance, const double *row_sizes);

/*
 * Moves x = (q, qd, z) at time t onto the constraints. *moved: whether anything had to change. LAG_PROJECTION_FAILED: the positions cannot be
 * repaired from here, or the rates; x is then as before.
 */
lag_status lag_projection_apply(lag_projection *projection, double t, double *x, int *moved);

/* The same down to round-off, whatever the limits. */
lag_status lag_projection_exact(lag_projection *projection, double t, double *x, int *moved);

/*
 * Moves the rates only, down to round-off; those that are `held` (nq flags, or null; at most one for each reset of the model) stay if the
 * others can do it.
 */
lag_status lag_projection_rates(lag_projection *projection, double t, double *x, const double *held);

/* The component of a coordinate; 0 where rows are not known by component. */
size_t lag_component_of(const lag_model *model, size_t coordinate);

/* Measures rates (nq); then the largest of a row's component, in natural sizes a second, one at least. */
void lag_projection_measure(lag_projection *projection, const double *rates);
double lag_projection_pace(const lag_projection *projection, size_t row);

/*
 * Residual of a row of position level at (t, x) with the present discretes, as a part of the row's size (of one, where no limits are set).
 * Not a number where there is none.
 */
double lag_projection_distance(lag_projection *projection, double t, const double *x, size_t row);

/*
 * step.change: the change of least inertia that makes the residuals phi vanish in the first order, with the Jacobian at hand; of all rows, or of those of
 * position level. Coordinates without inertia that other rows hold (charges, by the sums of currents) may be free as far as positions go: then as little
 * changes as can.
 */
lag_status lag_projection_smallest(lag_projection *projection, int every);

/*
 * step.response: the same for a residual of one in each row alone, zero of rows that do not count. LAG_MISSING: the model has the function correction(),
 * for residuals that go together.
 */
lag_status lag_projection_response(lag_projection *projection, int every);

/*
 * The change of least inertia that takes residuals of the constraints away to first order, M change - J' lam = 0 and
 * J change = -residual, by the function correction() of a model: solved as elimination() solves the equations of motion, without forming M.
 */

/* Doubles that it needs beside the workspace of the model. */
size_t lag_correction_memory(const lag_model *model);

/*
 * change (nq) for residuals (nc) at t q qd z u w p. `jacobian` (nc, nq) is J there, `sizes` (nc) what residuals are measured in.
 * LAG_MISSING: the model has no such function, or it keeps too few digits here; the dense system tells.
 */
lag_status lag_correction(const lag_model *model, const lag_arguments *at, const double *residual, const double *jacobian,
    const double *sizes, double *memory, double *change);

#endif
