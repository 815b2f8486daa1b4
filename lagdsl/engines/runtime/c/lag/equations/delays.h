/*
 * Delayed values: what expressions were some time ago. An expression is kept as polynomials in Chebyshev's form, piece by piece, from the
 * longest delay ago up to the end of the last step, and steps are at most as long as the shortest delay: so what is read is always known
 * (method of steps). A piece begins where a derivative of low order jumps, too: at the start of the motion, at events, and where
 * such a place comes back after a delay, one order higher. Steps end where one of these comes back.
 * Source: Hairer, Norsett and Wanner, Solving Ordinary Differential Equations I, 2nd ed., section II.17.
 *
 * Before a motion begins nothing has been, and a delayed value is what the expression is now.
 */
#ifndef LAG_DELAYS_H
#define LAG_DELAYS_H

#include <stddef.h>

#include "lag/status.h"

struct lag_motion;
struct lag_model;

/* Degree of a piece: that of the dense output of every method, at least; and its coefficients. */
enum { LAG_DELAY_DEGREE = 8, LAG_DELAY_TERMS = LAG_DELAY_DEGREE + 1 };
/* Pieces of which the run takes the memory. Where they do not suffice, neighbours become one if the tolerance admits it. */
enum { LAG_DELAY_PIECES = 4096 };
/* Jumps of derivatives of lower order are followed; level 0 is a jump of the value itself. */
enum { LAG_DELAY_SMOOTH = 10 };

typedef struct lag_delays {
    struct lag_motion *motion;
    size_t value, rate;    /* first entries of w */
    size_t first, count;   /* pieces: from `first` up to `count`; none: nothing has been */
    int level;             /* of the place at which the next piece begins */
    int jumped;            /* a value jumped in the last change */
    double direct;         /* 1: an expression reads delayed values itself */
    double change;         /* of the values, in parts of their sizes: for who looks at their rounding errors */
    double *time;          /* (ndelay) the delays [s] */
    double *from, *ahead;  /* (ndelay) the places of jumps before and behind what is read now; infinite: none */
    double *clear;         /* (ndelay) there is none up to here but those */
    double *from_before, *ahead_before; /* (ndelay) before the last change */
    double *size;          /* (ndelay) largest magnitudes so far */
    double *limit;         /* (ndelay) errors of the pieces that the tolerance admits */
    double *now, *other;   /* (ndelay) the expressions */
    double *step;          /* (ndelay (ndelay + 1)) of Newton's method */
    double *sample;        /* (LAG_DELAY_TERMS, ndelay) */
    double *begin, *order; /* (LAG_DELAY_PIECES + 1) where each piece begins, behind the last one where it ends; the level there */
    double *terms;         /* (LAG_DELAY_PIECES, ndelay, LAG_DELAY_TERMS) */
} lag_delays;

/* Doubles for them. */
size_t lag_delays_memory(const struct lag_model *model);

void lag_delays_place(lag_delays *delays, struct lag_motion *motion, double *memory);

/* Nothing has been. */
void lag_delays_clear(lag_delays *delays);

/* A motion begins at time t, in the state of motion->at: expressions have always been what they are. LAG_BAD_DELAY. */
lag_status lag_delays_begin(lag_delays *delays, double t);

/* The entries of w at time t, in the state of motion->at. */
void lag_delays_set(lag_delays *delays, double t);

/* The shortest delay. */
double lag_delays_shortest(const lag_delays *delays);

/* The next time at which a jump comes back, of those known; infinite without. */
double lag_delays_next(lag_delays *delays);

/* What is read up to time t has passed the jumps that come back until then; and the opposite of the last of these calls. */
void lag_delays_change(lag_delays *delays, double t);
void lag_delays_take_back(lag_delays *delays);

/* Forgets what is known behind time t. */
void lag_delays_cut(lag_delays *delays, double t);

/* Samples of the expressions at the places of Chebyshev's nodes in a piece, from its end to its beginning: x in [-1, 1]. */
extern const double lag_delay_nodes[LAG_DELAY_TERMS];

/*
 * The coefficients of `sample` as the next piece, up to `end`, tried: it counts if lag_delays_add() is called. `tolerance` is a part of
 * the sizes. The error is that of expression `which` at x, in parts of its limit, where it is `known` there.
 */
void lag_delays_try(lag_delays *delays, double tolerance, double end);
double lag_delays_misfit(const lag_delays *delays, size_t which, double x, double known);
/* LAG_LONG_PAST: there is no place for another one. */
lag_status lag_delays_add(lag_delays *delays, double end);

#endif
