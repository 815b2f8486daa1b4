/*
 * Time events: the discretes that depend on time, parameters and other discretes only change at instants that are computed ahead. The
 * integrator steps to them exactly, so that nothing is stepped over however short it is.
 *
 * An entry stays as it is while its distances are positive. Where the model says that a distance is affine in time, its zero is exact; else it is smooth,
 * and its first zero is searched where values and rates tell its shape. Distances that depend on other entries are looked at anew after each event.
 */
#ifndef LAG_TIMED_H
#define LAG_TIMED_H

#include "lag/equations/motion.h"
#include "lag/linalg/arena.h"

typedef struct lag_timed {
    lag_motion *motion;
    double length;                            /* of the experiment [s]; 0: not known */
    double next;                              /* time of the next change, or up to which there is none */
    double shown;                             /* the last change shows there, which may be lost in round-off before */
    double *value, *told;                     /* (ntimed) */
    double *before;                           /* (ntimed) the entries before the last change */
    double *distance, *rate, *affine, *entry; /* (ndistance) */
    double *zero;                             /* (ndistance) the time at which it reaches zero */
} lag_timed;

void lag_timed_place(lag_timed *timed, lag_motion *motion, lag_layout *layout);

/* Entries are what they are at time t, */
lag_status lag_timed_set(lag_timed *timed, double t);
/* or just behind it. */
lag_status lag_timed_set_behind(lag_timed *timed, double t);

/* The first time behind t that is another one. */
double lag_timed_behind(const lag_timed *timed, double t);

/* Finds `next` after time t, with the present discretes. */
lag_status lag_timed_find_next(lag_timed *timed, double t);

/* The time of it, or of the next jump of what is delayed. */
double lag_timed_next(const lag_timed *timed);

/* True if that is now, or later by round-off: lag_timed_change() carries it out. */
int lag_timed_due(const lag_timed *timed, double t);

/* The entries that change now, into w; `before` holds what they were. */
lag_status lag_timed_change(lag_timed *timed, double t);

/* 1: lag_timed_change() changed what is told. */
int lag_timed_is_reported(const lag_timed *timed);

#endif
