#include "lag/events/clock.h"

#include <math.h>

/* So many intervals in a row, each shorter than the one before, down to this part of the first, */
enum { MANY = 20 };
static const double PART = 1e-6;
/* or so many events in a row, each this part of the experiment after the one before. */
enum { DENSE = 1000 };
static const double BRIEF = 1e-10;

static const double LARGEST_DENOMINATOR = 1e6;
static const double LARGEST_WHOLE = 9007199254740992.0; /* 2^53 */

/* The smallest denominator of a fraction that is x to the last bit, by continued fractions; 0: none that is short. */
static double denominator_of(double x)
{
    double p0 = 1.0;
    double q0 = 0.0;
    double rest = x;
    double p = floor(rest);
    double q = 1.0;
    while (q <= LARGEST_DENOMINATOR && fabs(p) < LARGEST_WHOLE) {
        if (p / q == x) {
            return q;
        }
        const double part = rest - floor(rest);
        if (!(part > 0.0)) {
            return 0.0;
        }
        rest = 1.0 / part;
        const double p1 = floor(rest) * p + p0;
        const double q1 = floor(rest) * q + q0;
        p0 = p;
        q0 = q;
        p = p1;
        q = q1;
    }
    return 0.0;
}

static double common_divisor(double a, double b)
{
    while (b > 0.0) {
        const double rest = fmod(a, b);
        a = b;
        b = rest;
    }
    return a;
}

lag_clock lag_clock_of(double first, double period)
{
    lag_clock clock = {.first = first, .period = period};
    const double a = denominator_of(first);
    const double b = denominator_of(period);
    if (a > 0.0 && b > 0.0) {
        clock.denominator = a / common_divisor(a, b) * b;
        clock.first_part = nearbyint(first * clock.denominator);
        clock.period_part = nearbyint(period * clock.denominator);
    }
    return clock;
}

double lag_clock_instant(const lag_clock *clock, unsigned long long k)
{
    if ((double)k >= LARGEST_WHOLE) {
        return (double)INFINITY;
    }
    const double whole = clock->first_part + (double)k * clock->period_part;
    if (clock->denominator > 0.0 && fabs(whole) < LARGEST_WHOLE) {
        return whole / clock->denominator;
    }
    return clock->first + (double)k * clock->period;
}

double lag_clock_nearest(const lag_clock *clock, double t)
{
    const double about = nearbyint((t - clock->first) / clock->period);
    return lag_clock_instant(clock, about > 0.0 ? (unsigned long long)fmin(about, LARGEST_WHOLE) : 0);
}

void lag_clock_seek(lag_clock *clock, double t)
{
    const double about = floor((t - clock->first) / clock->period) - 1.0;
    clock->next = about > 0.0 ? (unsigned long long)fmin(about, LARGEST_WHOLE) : 0;
    while (lag_clock_instant(clock, clock->next) < t) {
        ++clock->next;
    }
}

void lag_clock_enter(lag_clock *clock, double t)
{
    lag_clock_seek(clock, t - LAG_SAME_TICK * clock->period);
}

int lag_clock_is_due(const lag_clock *clock, double t)
{
    return lag_clock_instant(clock, clock->next) <= t + LAG_SAME_TICK * clock->period;
}

double lag_clocks_next(size_t count, const lag_clock *clocks)
{
    double next = (double)INFINITY;
    for (size_t i = 0; i < count; ++i) {
        next = fmin(next, lag_clock_instant(&clocks[i], clocks[i].next));
    }
    return next;
}

size_t lag_clocks_due(size_t count, const lag_clock *clocks, double t)
{
    size_t i = 0;
    while (i < count && !lag_clock_is_due(&clocks[i], t)) {
        ++i;
    }
    return i;
}

double lag_clocks_same(size_t count, const lag_clock *clocks, double t)
{
    double same = t;
    for (size_t i = 0; i < count; ++i) {
        const double instant = lag_clock_nearest(&clocks[i], t);
        same = instant < same && t - instant <= LAG_SAME_TICK * clocks[i].period ? instant : same;
    }
    return same;
}

int lag_crowds(lag_crowd *crowd, double t, double length, int relations)
{
    const double interval = t - crowd->last;
    crowd->ratio = interval / crowd->interval;
    if (relations && crowd->interval < (double)INFINITY && interval < crowd->interval) {
        ++crowd->shrinking;
    } else {
        crowd->first = interval;
        crowd->shrinking = 1;
    }
    crowd->dense = interval <= BRIEF * length ? crowd->dense + 1 : 0;
    crowd->last = t;
    crowd->interval = interval;
    return (crowd->shrinking > MANY && interval < PART * crowd->first) || crowd->dense > DENSE;
}
