/*
 * Attempts of the next steps of several steppers at once, all of them with DOP853 and of one size: their rates are found in lanes. Each stepper
 * has its own time, length and error, and takes its attempt over when it is asked for the step, with the bits that it would have found
 * alone.
 *
 * Open lanes go on without their steppers as long as nothing but steps happens: the state, its tolerances and the control of the length stay in
 * lanes, and the stepper is left behind. It catches up before the first step that ends at its limit, fails, or leads to what somebody has to be told.
 */
#ifndef LAG_ATTEMPTS_H
#define LAG_ATTEMPTS_H

#include "lag/methods/accuracy.h"
#include "lag/methods/dop853.h"
#include "lag/stepper.h"

/* xd (size, lanes) at t (lanes) and x (size, lanes). `fault` of a lane becomes nan where it has no rates; who asks looks for numbers that are nan. */
typedef void lag_rates_in_lanes(void *context, const double *t, const double *x, double *xd, double *fault);
/* Told of the ends of attempts of which some are accepted, just after the rates there. `broken` of a lane becomes 1 where its run has to be told of them. */
typedef void lag_ends_in_lanes(void *context, const double *t, const double *x, double *broken);

/* Numbers of lanes; flags are 0 or 1. */
typedef double lag_of_lanes[LAG_ATTEMPT_LANES];

/* The steps of the lanes: what lag_stepper and lag_attempt tell of one, and how far a lane goes without them. */
typedef struct lag_lane_steps {
    lag_of_lanes used, open;           /* there is an attempt; the lane may go on without its stepper */
    lag_of_lanes t_new, first, next;   /* lag_attempt: h, t are those of the arrays */
    lag_of_lanes limit, h_least, h_most;
    lag_of_lanes before;               /* the error of the last accepted step */
    lag_of_lanes rejections;           /* of this step */
    lag_of_lanes row, dense;           /* somebody looks inside of steps that go beyond this time; and of this one */
    lag_of_lanes border;               /* and at steps that are more urgent than this */
    lag_of_lanes left;                 /* so many are made at most */
    lag_of_lanes steps, rejected, evaluations; /* since the stepper was there: of steps that are over */
    lag_of_lanes accepted, refused;    /* the attempt is the next step, or is to be tried with a shorter one, without the stepper */
} lag_lane_steps;

/* Tolerances of open lanes (lag/methods/accuracy.h), each array (size, lanes). */
typedef struct lag_lane_accuracy {
    double *largest, *floor, *most, *least;
    const double *group; /* (size) */
    double relative;
} lag_lane_accuracy;

/* Results of attempts. */
typedef struct lag_lane_outcomes {
    lag_of_lanes error, urge;
    lag_of_lanes behind, again;     /* lengths that follow an attempt that is accepted, or is not */
    lag_of_lanes t_new;             /* ends of those that can be steps */
    lag_of_lanes step_fault, fault; /* no number: the step failed; it or what followed did */
    lag_of_lanes broken;            /* as told of the ends */
} lag_lane_outcomes;

typedef struct lag_attempts {
    lag_attempt_arrays at, further; /* of the step, and of what its dense output needs beside */
    int used, dense;                /* there are attempts; and some that dense output is wanted of */
    double *x, *tolerance, *inside; /* (size, lanes) */
    double *terms;                  /* (7, size, lanes) of the dense output */
    size_t width; /* doubles in a register of the processor */
    lag_rates_in_lanes *rates;
    lag_ends_in_lanes *ends; /* null: nobody asks */
    void *context;
    lag_lane_steps step;
    lag_lane_accuracy accuracy;
    lag_lane_outcomes found;
} lag_attempts;

/* Doubles for `attempts`, and its layout; the caller sets rates, ends and context. */
size_t lag_attempts_memory(size_t size, size_t lanes);
void lag_attempts_place(lag_attempts *attempts, size_t size, size_t lanes, size_t width, double *memory);

/* Lane k becomes the attempt of s, for which lag_attempt_begin() was called. */
void lag_attempts_enter(lag_attempts *attempts, const lag_stepper *s, size_t k);
/*
 * It becomes open, with tolerances that follow its state: the caller sets `row`, `border` and `left` of it. Where an attempt of it is `accepted`, or
 * `refused`, it goes on when the next attempts are made; or it is closed, and settled.
 */
void lag_attempts_open(lag_attempts *attempts, size_t k, const lag_accuracy *accuracy);
/* The stepper of lane k catches up, and so do the scales of its tolerances: it is where the attempt began. The number of steps that it did not make itself. */
size_t lag_attempts_close(lag_attempts *attempts, size_t k, lag_stepper *s, lag_accuracy *accuracy);
/* The state of lane k at a time within its attempt, of which the dense output was wanted. */
void lag_attempts_inside(const lag_attempts *attempts, size_t k, double t, double *x);

/* The next attempts of so many groups of lanes, in all lanes that are used. */
void lag_attempts_make(lag_attempts *groups, size_t count);

/*
 * Lane k, which was made, to its stepper. 1: it can go on by lag_stepper_step() with the same limit. 0: its attempt has to be repeated,
 * with a shorter step.
 */
int lag_attempts_settle(lag_attempts *attempts, lag_stepper *s, size_t k);

/* For the method: the next attempt of a step to `limit`, which goes on with the one that was begun if that is of the same step. */
void lag_attempt_begin(lag_stepper *s, double limit);
/* The attempt is rejected. 0: it was as short as steps may be. */
int lag_attempt_shorten(lag_stepper *s);

#endif
