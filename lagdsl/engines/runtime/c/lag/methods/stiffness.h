/*
 * Is the step limited by stability instead of accuracy? The explicit method itself measures h |lambda| at every step; where that
 * stays near the border of its stability region, the Jacobian tells whether its fastest eigenvalue decays, so that an implicit
 * method may step over it, or oscillates, which every method has to follow.
 *
 * An implicit step costs more: it is tried where that costs no more than a part of the explicit steps to the end, and given up where it makes less
 * of the same work than the explicit one did. Work is counted in evaluations of the rates.
 *
 * Source of the test: Hairer and Wanner, Solving Ordinary Differential Equations II, 2nd ed., section IV.2, (2.38).
 */
#ifndef LAG_STIFFNESS_H
#define LAG_STIFFNESS_H

#include "lag/stepper.h"

typedef struct lag_stiffness {
    unsigned signs;     /* steps in a row that speak for a change */
    unsigned wait;      /* steps until the next question */
    unsigned needed;    /* signs for a change back to the explicit method; doubled by every one to a motion that is not stiff */
    double t;           /* at the last question to the implicit method, or when the explicit one began, */
    lag_step_counts before; /* and the work then */
    double progress;    /* of the explicit method for each evaluation, when it was left */
    double spent;       /* evaluations of the explicit method before it began last, */
    double visit, lost; /* and the work of the implicit one, in the same measure: since it began, and all that was in vain */
    double trial;       /* what a trial was found to cost last */
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
 * A step of the explicit method of which h |lambda| is at most this asks for nothing: where all of several steps are so, one call of
 * lag_stiffness_rest() stands for the questions after them. Negative: each step is to be told.
 */
double lag_stiffness_border(const lag_stiffness *stiffness);
void lag_stiffness_rest(lag_stiffness *stiffness);

/*
 * The eigenvalue of the Jacobian at the present state of `s` that is largest in magnitude, by the power method on vectors that the tolerances of
 * `s` scale, and whether it decays noticeably (by 1/20 of its magnitude); 0 where it is not to be had.
 */
double lag_stiffness_fastest(const lag_stiffness *stiffness, lag_stepper *s, int *decays);

#endif
