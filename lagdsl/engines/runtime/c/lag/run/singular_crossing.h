/*
 * Motion across and out of singular positions, where rows of J depend on each other and branches of the constraint set meet.
 *
 * The rates keep their direction there. From the state in front of the position the accelerations are polynomials in time that satisfy the
 * equations at nodes behind it, whose states are projected onto the constraints (collocation). Where that fails, half the length is tried.
 * Branches meet if the polynomials also satisfy the constraints where J loses rank, in the combinations of rows that vanish there. Where they
 * miss each other the motion turns away, and steps of the run go on, as short as they must be.
 *
 * Sources: Allgower and Georg, Numerical Continuation Methods, 1990, chapter 8 (a predictor along the tangent jumps over a branch point);
 * Bayo and Avello, Nonlinear Dynamics 5 (1994) 209 (the four-bar); Hairer, Norsett and Wanner, Solving Ordinary Differential Equations I,
 * 2nd ed., section II.7 (collocation).
 */
#ifndef LAG_SINGULAR_CROSSING_H
#define LAG_SINGULAR_CROSSING_H

#include "lag/equations/motion.h"
#include "lag/stepper.h"

struct lag_run;
enum { LAG_COLLOCATION_NODES = 7 };

/* A fitted motion behaves as a step that was done: it has a dense output. The next one is to be done by another method. */
extern const lag_method lag_collocation;

typedef struct lag_singular {
    struct lag_run *run;
    double distance;                 /* [s] to a singular position ahead; 0: the state is near one; negative: none is known */
    double margin;                   /* of the rank at the end of the last step; infinite: not known */
    double *rows;                    /* (nq, rows) those of J that are independent in general, scaled, as columns; */
    double *phi, *drift;             /* (rows) their residuals, of positions, and of rates */
    double *values, *coefficients;   /* (7, nq + nz) derivatives of rates and states of first order at the nodes; of their polynomials */
    double *multipliers;             /* (7, nc) */
    double *state, *rates, *largest; /* (2 nq + nz) */
    double *memory;                  /* of singular values */
} lag_singular;

size_t lag_singular_memory(const lag_model *model);
void lag_singular_place(lag_singular *singular, struct lag_run *run, double *memory);
/* The motion begins at the present state, which may be singular if `attention` is asked for. */
void lag_singular_begin(lag_singular *singular, int attention);
/* Before a step, not beyond `limit`. *done: a fitted motion is there as a step that was done. LAG_BRANCH_POINT: branches cannot be told apart. */
lag_status lag_singular_ahead(lag_singular *singular, double limit, int *done);
/* After a step that ended on the constraints, where lag/equations/rank.h asks for it. LAG_ATTENTION: it is to be tried with the length *shorter. */
lag_status lag_singular_after(lag_singular *singular, double *shorter);
/*
 * Accelerations and multipliers into motion.qdd and motion.lam for a row of x at time t: where J is nearly singular and the state moves, the
 * limits along the motion; a multiplier without a limit is no number. After an event at t the motion is another one than before it.
 */
void lag_singular_row(lag_singular *singular, double t, const double *x, int after_event);
/* A fitted state back onto the constraints; near the singular position, where round-off would move it, it stays as it is. */
void lag_singular_project(lag_singular *singular, double t, double *x);
/* Independent rows at the state x at time t, and in general; *weakest has the largest share in the combination that is next to vanish. */
size_t lag_singular_rank(lag_singular *singular, double t, const double *x, size_t *general, size_t *weakest);

/* For its parts: the motion from x at time t across a position so far ahead, into `coefficients`; its length, 0 where none is found. */
double lag_collocation_fit(lag_singular *singular, double t, const double *x, double distance);
double lag_collocation_node(size_t i);
/* Polynomials of `values` (7, width) at the nodes from `first` on; one of them at a part of the length; the state there, not projected. */
void lag_collocation_interpolate(size_t first, size_t width, const double *values, double *coefficients);
double lag_collocation_value(size_t width, const double *coefficients, double part);
void lag_collocation_state(const lag_model *model, const double *coefficients, const double *start, double length, double part, double *x);
int lag_run_row_counts(const struct lag_run *run, size_t row); /* true: the row lasts, and is independent in general */
/* The least pivot of J (lag/equations/rank.h) at x at time t; `rows`, `phi` and `drift` there, and their number, 0 where there are none. */
double lag_singular_margin(lag_singular *singular, double t, const double *x);
size_t lag_singular_rows(lag_singular *singular, double t, const double *x);

#endif
