/*
 * Impacts: rates jump so that momentum is balanced in the whole mechanism.
 *
 *     M (v+ - v-) = Jc' p + J' P,   J v+ + b = 0,   0 <= p, Jc v+ + e Jc v- >= 0, one of the two zero for each gap
 *
 * Newton's law of impact as a linear complementarity problem, whose matrix is symmetric and positive semidefinite. Where T is not quadratic in the
 * rates, momenta dL/dqd change instead of M v: Newton's method solves such problems with the M of the rates so far.
 *
 * Source: Pfeiffer, Glocker, Multibody Dynamics with Unilateral Contacts, 1996.
 */
#ifndef LAG_IMPACT_H
#define LAG_IMPACT_H

#include "lag/equations/discretes.h"
#include "lag/equations/motion.h"

typedef struct lag_impact {
    lag_motion *motion;
    lag_places places;
    double *struck;                     /* (nq + nz) by component: the blow has a gap in it */
    double *chosen;                     /* (nq) coordinates that the blow may move, ascending, */
    size_t count;                       /* so many */
    double *mass, *jacobian, *residual; /* (nq, nq) (nc, nq) (nc), cut down to these coordinates */
    double *opened;                     /* (nw) */
    double *response, *compliance;      /* (ngap, nq) (ngap, ngap) */
    double *force, *gamma, *lam;        /* (nq) (nc) (nc) */
    double *wanted, *impulse;           /* (ngap) */
    double *rates, *step;               /* (nq) before the blow; the change in one step, */
    double *kept, *reached;             /* (nq) momenta before the blow and now */
    double *from, *now;                 /* (nq) those of the chosen coordinates before a step and behind it */
    double *system, *search;
} lag_impact;

/* Participants of one impact. */
typedef struct lag_blow {
    size_t count;
    const double *rows;   /* (count, nq) dgap/dq */
    const double *speed;  /* (count) rates of the gaps */
    const double *factor; /* (count) restitution */
} lag_blow;

/* Doubles for it. */
size_t lag_impact_memory(const lag_model *model);

void lag_impact_place(lag_impact *impact, lag_motion *motion, double *memory);

/*
 * The rates in x = (q, qd, z) at time t, which satisfy the lasting constraints, after the blow. Closed contacts take part as gaps, not
 * as constraints. LAG_SINGULAR: some rates are not determined; x stays. LAG_MOMENTUM_UNREACHABLE: no rates have these momenta,
 * motion->coordinate is one that takes part.
 */
lag_status lag_impact_strike(lag_impact *impact, double t, double *x, const lag_blow *blow);

#endif
