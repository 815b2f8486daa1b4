/*
 * The impulse problem: rates after an instant at which T, a prescribed motion, a constraint or a contact changes them, while positions stay.
 *
 *     p(t, q, v+, w+) - p(t, q, v-, w-) = J' P + Wc' Pc,   J v+ + b = 0,   0 <= Pc, gap rate+ + e gap rate- >= 0, one of the two zero
 *
 * with p = dL/dqd. Over an instant all finite forces drop out of Lagrange's equations: momenta change by impulses of rows only. Rows are those
 * of the constraints, bilateral; rates that are held; and gaps that strike by Newton's law, unilateral, a linear complementarity problem whose matrix is
 * symmetric and positive semidefinite. Where T is not quadratic in the rates Newton's method solves such problems with the M of the rates so far.
 *
 * Source: L. A. Pars, A Treatise on Analytical Dynamics (1965), chapter XIV; H. Goldstein, Classical Mechanics (2nd ed., 1980), exercises
 * of chapter 2 on impulsive forces; Pfeiffer, Glocker, Multibody Dynamics with Unilateral Contacts, 1996.
 */
#ifndef LAG_IMPULSE_H
#define LAG_IMPULSE_H

#include "lag/equations/discretes.h"
#include "lag/dynamics.h"
#include "lag/equations/motion.h"

typedef struct lag_impulse {
    lag_motion *motion;
    lag_places places;
    double *before;    /* (nq) momenta that the problem begins with */
    double *now;       /* (nq) momenta at the rates looked at last, */
    double *mass;      /* (nq, nq) M, */
    double *jacobian;  /* (nc, nq) and the rows of the constraints with */
    double *residual;  /* (nc) what they lack: J qd + b */
    double *w;         /* (nw) the discretes with contacts as in `holding` */
    double *holding;   /* (ncontact) flags of closed contacts that hold like constraints; zero but across a step of energy */
    double *chosen;    /* (nq) coordinates that take part, ascending, */
    size_t count;      /* so many */
    double *change;    /* (nq) of the rates in the last step of Newton's method, */
    double part;       /* of which so much was taken */
    double *aim;       /* (nq) momenta to which it leads in the first order */
    double *size;      /* (nq) of the terms of the momenta */
    double *from;      /* (nq) momenta before that step */
    double *point;     /* (2 nq + nz) */
    double *work;      /* of one step */
} lag_impulse;

/* Gaps that strike. */
typedef struct lag_blow {
    size_t count;
    const double *rows;   /* (count, nq) dgap/dq */
    const double *speed;  /* (count) rates of the gaps before it */
    const double *factor; /* (count) restitution */
} lag_blow;

/* Doubles for it. */
size_t lag_impulse_memory(const lag_model *model);

void lag_impulse_place(lag_impulse *impulse, lag_motion *motion, double *memory);

/* Remembers the momenta at x = (q, qd, z) with discretes w (nw). */
lag_status lag_impulse_keep(lag_impulse *impulse, double t, const double *x, const double *w);

/* Momenta, M and the rows of the constraints at x, with the discretes that hold now but all contacts open that are not `holding`. */
lag_status lag_impulse_look(lag_impulse *impulse, double t, const double *x);

/* 1: momenta that were kept and those that were looked at, at rates qd, differ by more than this part of what enters them. */
int lag_impulse_differs(lag_impulse *impulse, const double *qd, double part);

/*
 * With the discretes that hold now: rates at which the momenta are those that were kept, but for impulses of the constraints. Closed
 * contacts do not take part. Rates that are `held` (nq flags, or null; at most one for each reset of the model) stay if
 * the others can do it. *jumped: rates changed by more than round-off. LAG_MOMENTUM_UNREACHABLE: no rates have these momenta, and
 * motion->coordinate has the one that is farthest from its own; x is changed. LAG_SINGULAR: some rates are not determined.
 */
lag_status lag_impulse_balance(lag_impulse *impulse, double t, double *x, const double *held, int *jumped);

/* The rates in x at time t, which satisfy the lasting constraints, after a blow. Closed contacts take part as its gaps, not as constraints. */
lag_status lag_impulse_strike(lag_impulse *impulse, double t, double *x, const lag_blow *blow);

/* Change of the rates (nq) for a unit impulse along `row` (nq), with what was looked at last. LAG_SINGULAR: some rates are not determined. */
lag_status lag_impulse_respond(lag_impulse *impulse, const double *row, double *change);

#endif
