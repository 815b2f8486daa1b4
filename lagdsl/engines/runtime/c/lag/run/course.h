/* A number along a step, by few of its values: how far it may exceed them, and where they do not show it. */
#ifndef LAG_COURSE_H
#define LAG_COURSE_H

#include <stddef.h>

/* Values of a number at increasing places. */
typedef struct lag_course {
    const double *place, *y; /* (count + 1) */
    size_t count;
} lag_course;

/* So many values in turn are looked at together. */
enum { LAG_WINDOW = 5 };

/* The spread of values, and how far off the polynomial through all but one is there; no number where some are none. */
typedef struct lag_spread {
    double low, high, off;
} lag_spread;

/*
 * The cubic through both ends of a step and their slopes is off by this part of its own bulge at most, about: beyond what was seen
 * so far by less, a step is not worth its dense output. (Of an oscillation, with a step of three radians.)
 */
static const double LAG_DOUBT = 0.7;

/* Distances by which the cubic with values a, b and slopes fa, fb (of the whole step) exceeds its ends: up and down. */
void lag_bulge_find(double a, double fa, double b, double fb, double *up, double *down);

/* Weights (LAG_WINDOW) of values at these places in the divided difference of all of them, the largest of size one. */
void lag_spread_weights(const double *place, double *weight);

/* Of the values v (LAG_WINDOW). */
lag_spread lag_spread_of(const double *v, const double *weight);

/* True if the values do not show what is between them. */
int lag_spread_hides(const lag_spread *spread);

/* True if value k is a number and no value beside it is larger, nor none. */
int lag_course_peaks(const lag_course *course, size_t k);

/* The value that may be reached beside such a value. */
double lag_course_reach(const lag_course *course, size_t k);

#endif
