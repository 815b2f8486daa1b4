/*
 * The choice of the method that makes more of the same work. Work is counted in evaluations of the rates.
 *
 * One step of the implicit method is tried beside the motion: as long as it has to be to take less work to the end than the explicit steps would.
 * Its error estimate knows what no eigenvalue tells: how much of fast components, decaying, oscillating or of round-off, is still part of the motion.
 * If it is below the tolerance, the implicit method goes on, and gives the run back where it makes less of the same work than the explicit one did.
 *
 * A trial is made where the explicit method itself measures h |lambda| near the border of its stability region at step after step, and beyond that as
 * often as trials in vain remain a small part of the work: steps are also short for reasons that no method sees in itself.
 *
 * Source of the measure: Hairer and Wanner, Solving Ordinary Differential Equations II, 2nd ed., section IV.2, (2.38).
 */
#ifndef LAG_STIFFNESS_H
#define LAG_STIFFNESS_H

#include "lag/stepper.h"

typedef struct lag_stiffness {
    unsigned signs;     /* late steps near the border without as many that are not; of the implicit method, questions in a row that speak for a change */
    unsigned wait;      /* steps of the implicit method until the next question */
    unsigned needed;    /* signs for a change back to the explicit method; doubled by every one to a motion that is not stiff */
    size_t question;    /* steps in all behind which the explicit method is asked without signs, too */
    double t;           /* at the last question to the implicit method, or when signs of the explicit one began, */
    lag_step_counts before; /* and the work then */
    double progress;    /* of the explicit method for each evaluation, when it was left */
    double spent;       /* evaluations of the explicit method before `before` */
    double visit, lost; /* and the work of the implicit one, in the same measure: since it began, and all that was in vain, */
    double visited;     /* and the time that it passed by since it began */
    double looks;       /* of the visit, that at eigenvalues */
    double *matrix;     /* (size, size) the Jacobian of a small system */
    double *v;          /* (3, size) */
    double *f, *point;  /* (size) the rates at the present state, and another state */
} lag_stiffness;

/* Doubles for states of `size` numbers. */
size_t lag_stiffness_memory(size_t size);

void lag_stiffness_place(lag_stiffness *stiffness, size_t size, double *memory);

/* The method for the next step of a motion to `stop`; to be asked after every accepted one. */
const lag_method *lag_stiffness_method(lag_stiffness *stiffness, lag_stepper *s, double stop);

/*
 * A step of the explicit method of which h |lambda| is at most this changes nothing here: lag_stiffness_method() need not be asked behind it.
 * Negative: it is to be asked behind each step.
 */
double lag_stiffness_border(const lag_stiffness *stiffness);

/* It is to be asked behind so many further steps of the explicit method, at least 1, whatever these are like. */
size_t lag_stiffness_steps(const lag_stiffness *stiffness, const lag_stepper *s);

/*
 * Magnitude of the eigenvalue of the Jacobian at the present state of `s` that is largest in magnitude, by the power method on vectors that the
 * tolerances of `s` scale; 0 where it is not to be had.
 */
double lag_stiffness_fastest(const lag_stiffness *stiffness, lag_stepper *s);

#endif
