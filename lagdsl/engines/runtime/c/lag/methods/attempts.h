/*
 * Attempts of the next steps of several steppers at once, all of them with DOP853 and of one size: their rates are found in lanes. Each stepper
 * has its own time, length and error, and takes its attempt over when it is asked for the step, with the bits that it would have found
 * alone.
 */
#ifndef LAG_ATTEMPTS_H
#define LAG_ATTEMPTS_H

#include "lag/methods/dop853.h"
#include "lag/stepper.h"

/* xd (size, lanes) at t (lanes) and x (size, lanes). `fault` of a lane becomes nan where it has no rates; who asks looks for numbers that are nan. */
typedef void lag_rates_in_lanes(void *context, const double *t, const double *x, double *xd, double *fault);
/* Told of the ends of attempts of which some are accepted, just after the rates there. */
typedef void lag_ends_in_lanes(void *context, const double *t, const double *x);

typedef struct lag_attempts {
    lag_attempt_arrays at, further; /* of the step, and of what its dense output needs beside */
    int used, dense;                /* there are attempts; and some that dense output is wanted of */
    double *x, *tolerance, *inside; /* (size, lanes) */
    double *terms;                  /* (7, size, lanes) of the dense output */
    size_t width; /* doubles in a register of the processor */
    lag_rates_in_lanes *rates;
    lag_ends_in_lanes *ends; /* null: nobody asks */
    void *context;
    double error[LAG_ATTEMPT_LANES], urge[LAG_ATTEMPT_LANES];
    double t_new[LAG_ATTEMPT_LANES]; /* ends of those that are accepted */
    double step_fault[LAG_ATTEMPT_LANES], fault[LAG_ATTEMPT_LANES]; /* no number: the step failed; it or what followed did */
} lag_attempts;

/* Doubles for `attempts`, and its layout; the caller sets rates, ends and context. */
size_t lag_attempts_memory(size_t size, size_t lanes);
void lag_attempts_place(lag_attempts *attempts, size_t size, size_t lanes, size_t width, double *memory);

/* Lane k becomes the attempt of s, for which lag_attempt_begin() was called. */
void lag_attempts_enter(lag_attempts *attempts, const lag_stepper *s, size_t k);

/* The attempts of the steppers s (count, lanes) that are not null, of so many groups of lanes. */
void lag_attempts_make(lag_attempts *groups, size_t count, lag_stepper *const *s);

/*
 * Lane k, which was made, to its stepper. 1: it can go on by lag_stepper_step() with the same limit. 0: its attempt has to be repeated,
 * with a shorter step.
 */
int lag_attempts_settle(const lag_attempts *attempts, lag_stepper *s, size_t k);

/* For the method: the next attempt of a step to `limit`, which goes on with the one that was begun if that is of the same step. */
void lag_attempt_begin(lag_stepper *s, double limit);
/* The attempt is rejected. 0: it was as short as steps may be. */
int lag_attempt_shorten(lag_stepper *s);

#endif
