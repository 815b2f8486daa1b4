/*
 * The impulse problem: rates after an instant at which T, a prescribed motion, a constraint or a contact changes them, while positions stay.
 *
 *     p(t, q, v+, w+) - p(t, q, v-, w-) = sum of rows' impulses,   J v+ + b = 0
 *
 * with p = dL/dqd. Over an instant all finite forces drop out of Lagrange's equations: momenta change by impulses of rows only. Rows are those
 * of the constraints, bilateral; rates that are held; and gaps and slips, with the law of lag/optimization/friction_problem.h. Where T is not quadratic in the
 * rates Newton's method solves such problems with the M of the rates so far. Accelerations satisfy a problem of the same form, with forces for impulses.
 *
 * Restitution by Newton's law or by Poisson's: docs/explanation/hybrid_model.md, part 2 of a pass.
 *
 * Source: L. A. Pars, A Treatise on Analytical Dynamics (1965), chapter XIV; H. Goldstein, Classical Mechanics (2nd ed., 1980), exercises
 * of chapter 2 on impulsive forces; Pfeiffer, Glocker, Multibody Dynamics with Unilateral Contacts (1996), chapter 8 (Poisson's law in two phases).
 */
#ifndef LAG_IMPULSE_H
#define LAG_IMPULSE_H

#include "lag/dynamics.h"
#include "lag/equations/motion.h"
#include "lag/impulses/inequalities.h"

/* So many round-offs of what enters are round-off. */
static const double LAG_FEW = 16.0;

typedef struct lag_impulse {
    lag_motion *motion;
    double *before;    /* (nq) momenta that the problem begins with */
    double *now;       /* (nq) momenta at the rates evaluated last, */
    double *mass;      /* (nq, nq) M, */
    double *jacobian;  /* (nc, nq) and the rows of the constraints with */
    double *residual;  /* (nc) what they lack: J qd + b */
    double *w;         /* (nw) the discretes without contacts and friction */
    double *change;    /* (nq) of the rates in the last step of Newton's method, */
    double part;       /* of which so much was taken */
    double *aim;       /* (nq) momenta to which it leads in the first order */
    double *size;      /* (nq) of the terms of the momenta */
    double *from;      /* (nq) momenta before that step */
    double *point;     /* (2 nq + nz) */
    double *rates;     /* (nq) those before */
    double *work;      /* of one step */
} lag_impulse;

void lag_impulse_place(lag_impulse *impulse, lag_motion *motion, lag_layout *layout);

/* Remembers the momenta at x = (q, qd, z) with discretes w (nw). */
lag_status lag_impulse_keep_momenta(lag_impulse *impulse, double t, const double *x, const double *w);

/* Momenta, M and the rows of the constraints at x, with the discretes that hold now but all contacts open. */
lag_status lag_impulse_evaluate(lag_impulse *impulse, double t, const double *x);

/* 1: momenta that were kept and those evaluated, at rates qd, differ by more than this part of what enters them. */
int lag_impulse_differs(lag_impulse *impulse, const double *qd, double part);

/*
 * With the discretes that hold now: rates at which the momenta are those that were kept, but for impulses of the constraints. Closed
 * contacts do not take part, but as `rows` (or null), whose speeds are those at impulse->rates. Rates that are `held` (nq flags, or null; at most one for each reset of the model) stay if
 * the others can do it. *jumped: rates changed by more than round-off. LAG_MOMENTUM_UNREACHABLE: no rates have these momenta, and
 * motion->coordinate has the one that is farthest from its own; x is changed. LAG_SINGULAR: some rates are not determined.
 */
lag_status lag_impulse_balance(lag_impulse *impulse, double t, double *x, const double *held, lag_inequalities *rows, int *jumped);

/*
 * The rates in x at time t, which satisfy the lasting constraints, after a blow, whose impulses are rows->force. Closed contacts and friction
 * take part as its rows, not as constraints. LAG_NO_FORCES: no impulses satisfy the law.
 */
lag_status lag_impulse_impact(lag_impulse *impulse, double t, double *x, lag_inequalities *rows);

/*
 * Accelerations, as impulse->change, at x at time t, where `rows` act with rows->force beside the constraints that the discretes w (nw) have; speeds of rows are
 * their accelerations where all others are zero. LAG_NO_FORCES: no forces satisfy the law. LAG_SINGULAR: some accelerations are not determined.
 */
lag_status lag_impulse_accelerate(lag_impulse *impulse, double t, const double *x, const double *w, lag_inequalities *rows);

/* Change of the rates (nq) for a unit impulse along `row` (nq), with what was evaluated last. LAG_SINGULAR: some rates are not determined. */
lag_status lag_impulse_respond(lag_impulse *impulse, const double *row, double *change);

/* ---- parts of it ---- */

/* Doubles of the work of one step. */
size_t lag_impulse_step_memory(const lag_model *model);

/*
 * impulse->change of the rates in the first order, from momenta, M and rows as they were evaluated; `held` rates stay if the others can do it, and
 * `rows` act (null: none), whose speeds are those at impulse->rates; the rates so far are qd (nq).
 * LAG_NO_FORCES: no impulses satisfy the law.
 */
lag_status lag_impulse_step_find(lag_impulse *impulse, const double *held, lag_inequalities *rows, const double *qd);

/* The speed of row i at rates qd, from its speed at impulse->rates. */
double lag_impulse_speed_at(const lag_impulse *impulse, const lag_inequalities *rows, size_t i, const double *qd);

#endif
