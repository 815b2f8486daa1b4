/*
 * Searches the last step of a run for events. Pieces of the step are so short that a polynomial of degree three through four
 * values of lag/events/guards.h and one of degree four through five of them differ little. Hence a value cannot
 * change and change back between two samples without a minimum of the polynomial near zero, and the search takes one more sample there.
 * The pieces follow the time scale of the values alone; it is remembered from step to step.
 */
#ifndef LAG_SCAN_H
#define LAG_SCAN_H

#include <float.h>
#include <math.h>

#include "lag/run.h"

/* Roots are found to so many units in the last place of time, */
static const double LAG_SCAN_ULPS = 4.0;
/* and are one where they differ by so many times that. */
static const double LAG_SCAN_TOGETHER = 8.0;
/* A piece is no longer than this part of the experiment. */
static const double LAG_SCAN_LONGEST = 0.02;

/* That of a step of length h to time t; of the last one. */
static inline double lag_scan_tolerance_at(double t, double h)
{
    return LAG_SCAN_ULPS * DBL_EPSILON * fmax(fabs(t), h);
}

static inline double lag_scan_tolerance(const lag_run *run)
{
    const lag_stepper *s = &run->stepper;
    return lag_scan_tolerance_at(s->t, s->t - s->t_before);
}

/* LAG_EVENT_PENDING if a guard has left its mode at a time within the last step. */
lag_status lag_scan_detect(lag_run *run, double t);

/* The first root of what has changed at b, and not at a; with it changes what does so at the same time but for round-off. */
double lag_scan_earliest(lag_run *run, double a, double b);

#endif
