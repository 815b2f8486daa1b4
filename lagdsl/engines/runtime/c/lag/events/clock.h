/*
 * Instants first + k period, k = 0, 1, ..., counted in whole numbers: nothing adds up. If both are short fractions (0.1 is
 * 1/10), an instant is that fraction, rounded once, so clocks of 0.1 s and 0.3 s tick together.
 */
#ifndef LAG_CLOCK_H
#define LAG_CLOCK_H

#include <stddef.h>

/* An instant nearer to the present than this part of the period, or of a step of fixed length, is the present one. */
static const double LAG_SAME_TICK = 1e-9;

typedef struct lag_clock {
    double first, period;          /* [s]; period > 0 */
    unsigned long long next;       /* k of the next instant */
    double first_part, period_part; /* whole numbers of 1/denominator s */
    double denominator;            /* 0: no short fractions */
} lag_clock;

/* A clock before its first instant. */
lag_clock lag_clock_of(double first, double period);

/* The time of instant k; infinite where k cannot be counted any more (from 2^53 on). */
double lag_clock_instant(const lag_clock *clock, unsigned long long k);

/* The instant that is nearest to t. */
double lag_clock_nearest(const lag_clock *clock, double t);

/* Lets the next instant be the first that is not before t. */
void lag_clock_seek(lag_clock *clock, double t);

/* The same but for round-off: an instant just before t is due at t. */
void lag_clock_enter(lag_clock *clock, double t);

/* True if the next instant is at t or before, but for round-off. */
int lag_clock_is_due(const lag_clock *clock, double t);

/* The earliest of the next instants of `count` clocks; infinite if there is none. */
double lag_clocks_next(size_t count, const lag_clock *clocks);

/* The first of `count` clocks that is due at t; `count` if there is none. */
size_t lag_clocks_due(size_t count, const lag_clock *clocks, double t);

/* The earliest instant of `count` clocks that is t but for round-off; t if there is none before. */
double lag_clocks_same(size_t count, const lag_clock *clocks, double t);

/* Watches the times of events that were located for crowding towards an instant, so that time does not get beyond it (Zeno). */
typedef struct lag_crowd {
    double last, interval, first; /* time of the last event, time since the one before, and that where they began to shrink */
    double ratio;                 /* of that time to the one before it */
    unsigned shrinking;           /* so many intervals in a row, each shorter than the one before */
    unsigned dense;               /* so many events in a row, each a moment of the experiment after the one before */
} lag_crowd;

/* True if events crowd: the event at t, of relations or of contacts only, is one too many. Contacts close if theirs crowd. */
int lag_crowds(lag_crowd *crowd, double t, double length, int relations);

#endif
