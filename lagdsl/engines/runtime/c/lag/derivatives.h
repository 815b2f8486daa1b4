/*
 * Accelerations that bring a motion back to its constraints by themselves, and the exact derivatives of everything that follows from them:
 *
 *     M qdd - J' lam = f ,   J qdd = gamma - 2 rate (J qd + b) - rate^2 phi
 *
 * so that residuals of positions die out as exp(-rate t), critically damped; those of velocities alone follow d/dt r = -rate
 * r. At rate zero, and on the constraints at any rate, they are the accelerations of lag/dynamics.h. If J loses rank, lam
 * and its derivatives are those of least length.
 *
 * Source: Baumgarte, Computer Methods in Applied Mechanics and Engineering 1 (1972) 1.
 */
#ifndef LAG_DERIVATIVES_H
#define LAG_DERIVATIVES_H

#include "lag/dynamics.h"
#include "lag/equations/motion.h"

/* The equations of motion at a state, and the residuals of its constraints; later the right sides of what follows. */
typedef struct lag_derivatives_terms {
    double *mass, *force;     /* (nq, nq) (nq) */
    double *jacobian, *gamma; /* (nc, nq) (nc) */
    double *phi, *residual;   /* (nc) */
} lag_derivatives_terms;

/* Memory of one call. */
typedef struct lag_derivatives_work {
    double *motion, *rows; /* (nq) (nc) how the residuals of the equations change */
    double *pulled;        /* (nc) */
    double *unused;        /* (nc, nq) */
} lag_derivatives_work;

/* A state and the values that are known at it; all pointers lead into memory of the caller. */
typedef struct lag_derivatives {
    const lag_model *model;
    double rate;                 /* [1/s] */
    lag_arguments at;            /* the state, with its solution and the present direction */
    double *qdd, *lam;           /* (nq) (nc) */
    double *x;                   /* (2 nq + nz + nu + np) the direction of q, qd, z, u, p, for the caller to set */
    double time;                 /* and of time */
    double *dqdd, *dlam;         /* (nq) (nc) what follows from it */
    double *alone;               /* what changes with time alone, as time_tangent() tells */
    double *least;               /* (nq) J least = lam */
    lag_derivatives_terms terms;
    lag_derivatives_work work;
    int timed;                   /* `alone` is filled */
    lag_system system;
} lag_derivatives;

/* Doubles for it. */
size_t lag_derivatives_memory(const lag_model *model);

/* Lays it out; the direction is zero. */
void lag_derivatives_place(lag_derivatives *derivatives, const lag_model *model, double *memory);

/*
 * Natural sizes of coordinates (nq) and rows (nc), which must stay; off the constraints they tell which rows count where these depend on
 * each other. Not said: all that are not very short.
 */
void lag_derivatives_size(lag_derivatives *derivatives, const double *sizes, const double *row_sizes);

/*
 * qdd and lam at t q qd z u w p, after prepare(), whose arrays must stay as long as derivatives are asked for; what they need is factored.
 * LAG_SINGULAR, LAG_NOT_FINITE as lag_forward_dynamics().
 */
lag_status lag_derivatives_factor(lag_derivatives *derivatives, const lag_arguments *at, double rate, size_t *coordinate);

/*
 * dqdd and dlam along the direction, then what follows from them: of d/dt (q, qd, z), outputs, named values, the energies T + V, T, V, and of
 * the residuals phi and J qd + b. LAG_MISSING: the model was compiled without named values.
 */
lag_status lag_derivatives_along(lag_derivatives *derivatives);
lag_status lag_derivatives_rates(lag_derivatives *derivatives, double *rates);
lag_status lag_derivatives_outputs(lag_derivatives *derivatives, double *y);
lag_status lag_derivatives_definitions(lag_derivatives *derivatives, double *d);
lag_status lag_derivatives_energies(lag_derivatives *derivatives, double *energies);
lag_status lag_derivatives_residuals(lag_derivatives *derivatives, double *phi, double *residual);

/*
 * The same accelerations (nq) and multipliers (nc) for a motion, which is there then. Other than lag_motion_solve() it takes the whole
 * system, and has an answer off the constraints, too, where rows depend on each other. Loads that depend on these are found without pull, and
 * stay those in w with it.
 */
lag_status lag_motion_pulled(lag_motion *motion, double rate, double t, const double *x, double *qdd, double *lam);

#endif
