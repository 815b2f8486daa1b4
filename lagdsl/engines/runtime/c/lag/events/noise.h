/*
 * Round-off of the indicators of a model, and of the distances of its corners, at a state. A number x enters an indicator g with a relative error
 * of the unit round-off eps, so g is known to about eps |dg/dx x|: only what enters g counts, in its own units. Numbers are states, inputs and the
 * time. The derivatives are differences along two changes of all numbers at once, each by its own irregular part: what two numbers do does not cancel.
 */
#ifndef LAG_NOISE_H
#define LAG_NOISE_H

#include "lag/contacts/contact.h"
#include "lag/equations/projection.h"

/* A value beyond this many times its last known rounding error is clear of it. */
static const double LAG_CLEARLY = 1e6;

typedef struct lag_noise {
    lag_motion *motion;
    double tolerance;     /* of the motion, relative */
    lag_contacts *contacts;
    const double *peak;   /* (2 nq + nz + nu) largest magnitude of each number so far: theirs */
    double *point, *u;    /* (2 nq + nz) (nu) */
    double *dz;           /* (nz) rates of states */
    double *value, *other, *opposite; /* (3 nindicator + ncorner) indicators, distances, rates and accelerations of indicators */
    double *sigma;        /* the same: round-off, as it was found last; zero: not yet */
    double *largest;      /* (2 nindicator) rates and accelerations of indicators that were largest so far */
} lag_noise;

void lag_noise_place(lag_noise *noise, lag_contacts *contacts, lag_layout *layout);

/* Values at x at time t; rates and accelerations are no numbers where they depend on the rates of inputs, accelerations or multipliers. */
lag_status lag_noise_update(lag_noise *noise, double t, const double *x);

/* Values and sigma at x at time t. The state that `motion` was evaluated at last is another one afterwards. */
lag_status lag_noise_find(lag_noise *noise, double t, const double *x);

/* Error of indicator `which` if the numbers have the relative one of the tolerance; after lag_noise_find. */
double lag_noise_known(const lag_noise *noise, size_t which);

/*
 * Flags in `held` (nindicator) of relations that the rows of constraints hold at x at time t: they are zero, as far as the motion is known, and their gradients and time derivatives are combinations of the rows. These are the derivatives at other rates that the rows admit. `point`
 * (2 nq + nz) is for its own use.
 */
void lag_noise_hold(lag_noise *noise, lag_projection *projection, double t, const double *x, double *point, double *held);

/* The size of coordinate j, or of rate j - nq. */
double lag_noise_extent(const lag_noise *noise, const double *x, size_t j);

/*
 * After lag_noise_find: the gradient (nq) by q of indicator `which`, and *drift, its rate with time, inputs and states, the positions held, from its rate
 * in the directions of single coordinates. 0: it depends on rates, or not on positions.
 */
int lag_noise_differentiate(lag_noise *noise, double t, const double *x, size_t which, double *gradient, double *drift);

#endif
