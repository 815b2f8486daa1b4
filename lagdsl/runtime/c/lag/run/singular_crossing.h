/*
 * Motion out of and across singular positions, where several branches of the constraint set meet: fitted, not integrated.
 *
 * Rows of J are scaled to size one; along a branch that crosses a singular position some of its singular values pass through
 * zero and change their sign. A step that jumps across shows it: seen in the singular vectors of the state before, J has
 * turned around. There the derivatives of rates and states are polynomials in time that agree with the equations at
 * collocation points behind the position, whose states are projected onto the constraints. The height of the saddle of the
 * vanishing combinations of rows decides whether branches meet (lag/run/branch_point.h).
 *
 * Source: Hairer, Norsett and Wanner, Solving Ordinary Differential Equations I, 2nd ed., section II.7.
 */
#ifndef LAG_SINGULAR_H
#define LAG_SINGULAR_H

#include "lag/linalg/levenberg_marquardt.h"
#include "lag/equations/motion.h"
#include "lag/run/branch_point.h"
#include "lag/stepper.h"

struct lag_run;

/* A fitted motion behaves as a step that was done: it has a dense output. The next one is to be done by another method. */
extern const lag_method lag_branch_switching;

typedef struct lag_singular {
    struct lag_run *run;
    lag_parts parts;             /* of J */
    double *counts;              /* (nc + nq) independent rows of each part in general */
    size_t general;              /* all of them */
    /* what is to be done before the next step */
    int leave;                   /* 1: rank is lost here; 2: nearly */
    double distance;             /* [s] to a singular position ahead; 0: none is known */
    double margin;               /* smallest singular value at the present state; infinite: not looked at */
    double *before, *now;        /* (nc, nq) J, scaled, at the beginning of a step and at another state */
    double *block, *other, *turned; /* (nc, nq) (nc, nq) (k, k), k: the smaller of both */
    int seen;                    /* 1: here are those of `before`, part after part: */
    double *kept;                /* (nc + nq) number of rows that are independent of those before them, */
    double *factors;             /* (nc, nq) reflections, of lag_qr, */
    double *tau, *diagonal, *pivot; /* (nc) */
    double *left;                /* (nc) */
    lag_branch_point saddle;
    double *branch, *earlier, *coefficients, *best; /* (7, nq + nz) */
    double *state, *rates, *origin, *end; /* (2 nq + nz) */
    double *multipliers, *limits; /* (2, 7, nc) at the points of a fitted motion, (nc) at its beginning */
    double *memory;              /* of singular and other values */
} lag_singular;

/* A singular value of J, rows of size one, below which rank counts as lost. */
#define LAG_LOST 1e-7

/* Doubles for it. */
size_t lag_singular_memory(const lag_model *model);

void lag_singular_place(lag_singular *singular, struct lag_run *run, double *memory);

/* Rows with a zero in `lasting` (nc) come and go, or depend on others. */
void lag_singular_count(lag_singular *singular, const double *lasting);

/* The motion begins at the present state, which may be singular if `attention` is asked for. */
void lag_singular_begin(lag_singular *singular, int attention);

/*
 * Independent rows at the state x at time t, of those that last; *general: as many as there are in general. If some are
 * lost, *weakest is the row with the largest share in the vanishing combination.
 */
size_t lag_singular_rank(lag_singular *singular, double t, const double *x, size_t *general, size_t *weakest);

/*
 * Before a step, not beyond `limit`. *done: a motion across or out of a singular position is there as a step that was done. LAG_BRANCH_POINT:
 * branches cannot be told apart.
 */
lag_status lag_singular_ahead(lag_singular *singular, double limit, int *done);

/*
 * After a step that ended on the constraints and where lag/equations/rank.h asks for attention. LAG_OK: it is good, or was replaced by one across
 * a singular position. LAG_ATTENTION: it is to be tried with the length *shorter. LAG_PROJECTION_FAILED, LAG_BRANCH_POINT.
 */
lag_status lag_singular_after(lag_singular *singular, double limit, double *shorter);

/*
 * Accelerations and multipliers into motion.qdd and motion.lam for a row of the state x at time t. Where J is singular, or nearly,
 * and the state moves, they are the limits along the motion; a multiplier without a limit is no number. After an event at that time
 * the motion is another one than before it.
 */
void lag_singular_row(lag_singular *singular, double t, const double *x, int after_event);

/* A fitted state back onto the constraints; near the singular position, where round-off would move it, it stays as it is. */
void lag_singular_project(lag_singular *singular, double t, double *x);

/* For its parts. */

/* 1: the fitted motion from the state x at time t into *length, `best` and `end`, out of a singular position, */
int lag_fit_out(lag_singular *singular, double t, const double *x, double limit, double *length);
/* or across one so far ahead, beyond `limit` where nothing shorter fits, */
int lag_fit_across(lag_singular *singular, double t, const double *x, double distance, double limit, double *length);
/* or from a state beside one, where it moves. */
int lag_fit_beside(lag_singular *singular, double t, const double *x, double *length);
/* The state at a part of that motion, not projected. */
void lag_fit_state(const lag_singular *singular, const double *x, double length, double part, double *state);
/*
 * Turn of J from `before` to `jacobian` (nc, nq): 1 for none, 0 if a direction is lost, negative if one has changed its
 * sign. `seen` is 0 where `before` is new.
 */
double lag_singular_turn(lag_singular *singular, const double *jacobian);
/* The smallest of the singular values of J at a state that are not zero in general; J into `jacobian` (nc, nq), scaled. */
double lag_singular_margin(lag_singular *singular, double t, const double *x, double *jacobian);

#endif
