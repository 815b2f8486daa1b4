/*
 * Delayed values: what expressions were some time ago. Steps are at most as long as the shortest delay, so what is read is always known (method of
 * steps). A derivative of low order that jumps, as at the start of a motion and at events, jumps again after a delay, one order higher; steps end
 * there.
 * Source: Hairer, Norsett and Wanner, Solving Ordinary Differential Equations I, 2nd ed., section II.17.
 *
 * Before a motion begins nothing has been, and a delayed value is what the expression is now.
 */
#ifndef LAG_DELAYS_H
#define LAG_DELAYS_H

#include "lag/delays/pieces.h"
#include "lag/model.h"

/* Places at which a derivative jumps, by delays. */
typedef struct lag_delay_jumps {
    double *from, *ahead;  /* (ndelay) before and behind what is read now; infinite: none */
    double *clear;         /* (ndelay) there is none up to here but those */
    double *from_before, *ahead_before; /* (ndelay) before the last change */
    int any;               /* a value jumped in the last change */
} lag_delay_jumps;

typedef struct lag_delays {
    const lag_model *const *model; /* that of the motion, which may change, */
    const lag_arguments *at;       /* and its state */
    double *value, *rate;  /* (ndelay) the entries of w */
    lag_delay_pieces pieces;
    lag_delay_jumps jumps;
    double direct;         /* 1: an expression reads delayed values itself */
    double change;         /* of the values, in parts of their sizes: for who looks at their rounding errors */
    const double *along;   /* (2 ndelay) values and rates are displaced along this, for who differentiates by them; null: they are not, */
    double by;             /* by so much */
    double *time;          /* (ndelay) the delays [s] */
    double *now, *other;   /* (ndelay) the expressions */
    double *step;          /* (ndelay (ndelay + 1)) of Newton's method */
} lag_delays;

/* Doubles for them. */
size_t lag_delays_memory(const lag_model *model);

/* `value` and `rate` are entries of w; these and what follows must stay. */
void lag_delays_place(lag_delays *delays, const lag_model *const *model, const lag_arguments *at, double *value, double *rate, double *memory);

/* Nothing has been. */
void lag_delays_clear(lag_delays *delays);

/* A motion begins at time t, in the present state: expressions have always been what they are. LAG_BAD_DELAY. */
lag_status lag_delays_begin(lag_delays *delays, double t);

/* The entries of w at time t, in the present state. */
void lag_delays_set(lag_delays *delays, double t);

/* The same from now on displaced by so much along these values and rates (2 ndelay); null: as they are. */
void lag_delays_displace(lag_delays *delays, const double *along, double by);

/* The piece of `pieces`, which begin where those of the delays jump, in which delay i reads at time `at`: on this side of a jump. */
size_t lag_delays_piece(const lag_delays *delays, const lag_delay_pieces *pieces, size_t i, double at);

/* The shortest delay; infinite before a motion begins. */
double lag_delays_shortest(const lag_delays *delays);

/* The next time at which a jump comes back, of those known; infinite without. */
double lag_delays_next(lag_delays *delays);

/* Reading passes the jumps that come back up to time t; and the opposite of the last of these calls. */
void lag_delays_change(lag_delays *delays, double t);
void lag_delays_take_back(lag_delays *delays);

/* Forgets what is known behind time t. */
void lag_delays_cut(lag_delays *delays, double t);

/* The expressions in the present state, into `values` (ndelay). */
lag_status lag_delays_evaluate(lag_delays *delays, double *values);

#endif
