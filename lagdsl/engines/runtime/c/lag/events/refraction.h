/*
 * Energy jumps at a surface g(q, t) = 0, and kinks of position maps and constraints: rates behind a place at which the Lagrangian or the direction of a constraint
 * jumps, as behind the step of a potential energy or the corner of a track.
 *
 * The step is the limit of a steep smooth one that depends on the position by the indicator g(q, t) of the relation alone.
 * Across it Lagrange's equations leave p+ - p- = grad g mu + J' P with p = dL/dqd: momenta change along the gradient of g
 * only, and by impulses of the constraints; and the energy h = qd p - L changes by -mu dg/dt - b' P, so not at all where place and
 * constraints rest. That is refraction. If h does not suffice for the other side, the motion turns back elastically. The excess of h is convex in
 * mu, with the slope dh/dmu + dg/dt + b' dP/dmu = dg/dt along the motion, as dh = v dp; a parabola where T is quadratic.
 *
 * The rows of a constraint that is continuous differ by a multiple of grad g on both sides, so J' P may be that of either side. Where grad g
 * is a combination of the rows, as where a rope becomes taut, impulses of the constraints determine the rates, and the blow is plastic. Closed contacts
 * that the blow drives in push, as on the flank of that steep step: they are rows of the impulse problem beside the step.
 *
 * Source: L. D. Landau, E. M. Lifshitz, Mechanics (3rd ed., 1976), section 7, problem (refraction at a step of the potential energy);
 * L. A. Pars, A Treatise on Analytical Dynamics (1965), chapter XIV (impulses).
 */
#ifndef LAG_REFRACTION_H
#define LAG_REFRACTION_H

#include "lag/contacts/contact.h"
#include "lag/events/noise.h"

typedef struct lag_refraction {
    lag_motion *motion;
    lag_contacts *contacts; /* their impulse problem, and the rows of their blows, are used */
    lag_impulse *impulse;
    lag_noise *noise;
    double *gradient;       /* (nq) of g */
    double *along;          /* (nq) change of the rates for mu = 1 */
    double *before;         /* (nq) momenta on this side */
    double *rows, *speeds;  /* (nc, nq) (nc) of the constraints on this side: J, J qd + b */
    double *rate;           /* (2 nq + nz) */
    double *g, *own;        /* (nindicator) (nindicator) */
    double *truth;          /* (nindicator) relations on this side */
} lag_refraction;

void lag_refraction_place(lag_refraction *refraction, lag_contacts *contacts, lag_noise *noise, lag_layout *layout);

/*
 * Relation `which` is about to change at x, at time t but for `lookahead` [s], infinite where it was located; its entry of w is that of before. If the
 * Lagrangian or the direction of a constraint jumps with the relation and the relation depends on positions: sets the rates behind it and *refracted to 1;
 * sets *back to 1 if the motion turns back and the relation stays. Otherwise changes nothing. Other relations between quantities that
 * jump with it, abs(mod(x, 2) - 1), have turned where it is refracted and not thrown back. LAG_CHATTER: the motion turns back at once, again
 * and again, as forces press it against the step. LAG_MOMENTUM_UNREACHABLE: no rates have the momentum, or the energy, behind it.
 */
lag_status lag_refraction_cross(
    lag_refraction *refraction, double t, double *x, size_t which, double lookahead, int *refracted, int *back);

#endif
