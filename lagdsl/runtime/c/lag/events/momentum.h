/*
 * Impulsive motion: rates after an instant at which T, a prescribed motion or a constraint changes, while positions stay.
 *
 * Over an instant Lagrange's equations leave p(t, q, v+, w+) - p(t, q, v-, w-) = J' P with p = dL/dqd, and the constraints
 * that hold afterwards J v+ + b = 0: momenta change by impulses of the constraints only. All finite forces drop out. This
 * balance determines the rates when a prescribed motion jumps in velocity (a ramp begins), a constraint closes (a clutch) or
 * a discrete mass changes.
 *
 * Source: L. A. Pars, A Treatise on Analytical Dynamics (1965), chapter XIV; H. Goldstein, Classical Mechanics (2nd ed., 1980),
 * exercises of chapter 2 on impulsive forces.
 */
#ifndef LAG_MOMENTUM_H
#define LAG_MOMENTUM_H

#include "lag/equations/discretes.h"
#include "lag/dynamics.h"
#include "lag/equations/motion.h"

typedef struct lag_momentum {
    lag_motion *motion;
    lag_places places;
    double *before;            /* (nq) momenta that were kept */
    double *now, *mass;        /* (nq) (nq, nq) */
    double *from;              /* (nq) momenta before a step of Newton's method */
    double *jacobian, *rows;   /* (nc, nq) (nc) */
    double *open;              /* (nw) discretes with contacts as in `holding` */
    double *holding;           /* (ncontact) flags of closed contacts that hold like constraints; zero but across a step */
    double *size;              /* (nq) of the momenta */
    double *chosen, *right;    /* (nc + most held, nq) (nc + most held) */
    double *force, *change;    /* (nq) */
    double part;               /* of the change that the last step took */
    double *lam;               /* (nc + most held) */
    double *way, *point;       /* (4 nway) (2 nq + nz) */
    double *system;
} lag_momentum;

/* Doubles for it. */
size_t lag_momentum_memory(const lag_model *model);

void lag_momentum_place(lag_momentum *momentum, lag_motion *motion, double *memory);

/* Remembers the momenta at x = (q, qd, z) with discretes w (nw). */
lag_status lag_momentum_keep(lag_momentum *momentum, double t, const double *x, const double *w);

/* Momenta, M and the rows of the constraints at x, with the discretes that hold now but all contacts open that are not `holding`. */
lag_status lag_momentum_look(lag_momentum *momentum, double t, const double *x);

/* 1: momenta that were kept and those that were looked at, at rates qd, differ by more than this part of what enters them. */
int lag_momentum_differs(lag_momentum *momentum, const double *qd, double part);

/*
 * With the discretes that hold now: rates at which the momenta are those that were kept, but for impulses of the constraints. Closed
 * contacts only push, and do not take part. Rates that are `held` (nq flags, or null; at most one for each reset of the model) stay if
 * the others can do it. *jumped: rates changed by more than round-off. LAG_MOMENTUM_UNREACHABLE: no rates have these momenta, and
 * motion->coordinate has the one that is farthest from its own; x is changed.
 */
lag_status lag_momentum_balance(lag_momentum *momentum, double t, double *x, const double *held, int *jumped);

/*
 * 1: a step of the rates, or a part of it, overshoots: momenta `now` behind it are no numbers, or far beyond the `aim` as seen from where the
 * step began; all (count). A convex T has no rates that a whole step of Newton's method must miss twice as far, so half of it is nearer.
 */
int lag_momentum_overshoots(size_t count, const double *step, const double *from, const double *now, const double *aim);

/*
 * Ways of masses are continuous: LAG_WAY_JUMP if one is elsewhere at x with the discretes of now than with `before` (nw) at `stood`, which is x with
 * the states z before the instant. Round-off is what the motion changes in a `moment` [s], as the instant is not known better, and that of
 * numbers of the size `peak` (2 nq + nz).
 */
lag_status lag_momentum_ways(
    lag_momentum *momentum, double t, const double *x, const double *stood, const double *before, double moment, const double *peak);

#endif
