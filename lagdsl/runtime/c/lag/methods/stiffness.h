/*
 * Is the step limited by stability instead of accuracy? The explicit method itself measures h |lambda| at every step; where that
 * stays near the border of its stability region, the exact Jacobian tells whether its fastest eigenvalue decays, so that an implicit
 * method may step over it, or oscillates, which every method has to follow.
 *
 * Source of the test: Hairer and Wanner, Solving Ordinary Differential Equations II, 2nd ed., section IV.2, (2.38).
 */
#ifndef LAG_STIFFNESS_H
#define LAG_STIFFNESS_H

#include "lag/stepper.h"

typedef struct lag_stiffness {
    unsigned signs;     /* steps in a row that speak for a change */
    unsigned wait;      /* steps until the next question */
    unsigned needed;    /* signs for a change back to the explicit method; doubled by every change */
    double *matrix;     /* (size, size) */
    double *v;          /* (3, size) */
} lag_stiffness;

/* Doubles for states of `size` numbers. */
size_t lag_stiffness_memory(size_t size);

void lag_stiffness_place(lag_stiffness *stiffness, size_t size, double *arena);

/* The method for the next step; to be asked after every accepted one. */
const lag_method *lag_stiffness_method(lag_stiffness *stiffness, lag_stepper *s);

/*
 * The eigenvalue of the matrix that is largest in magnitude, by the power method on vectors that the tolerances of `s` scale, and
 * whether it decays noticeably (by 1/20 of its magnitude).
 */
double lag_stiffness_fastest(const lag_stiffness *stiffness, const lag_stepper *s, int *decays);

#endif
