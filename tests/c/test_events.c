/* Tests events/clock.c: instants of clocks, counted without adding up, and events that crowd; and zeros, by which events are located. */
#include "check.h"
#include "lag/events/clock.h"
#include "lag/linalg/root.h"

typedef struct counted {
    int kind, calls;
} counted;

static double value(void *context, double x)
{
    counted *c = context;
    ++c->calls;
    switch (c->kind) {
    case 0:
        return x - 0.3;
    case 1:
        return x * x * x * x * x * x * x * x * x - 1e-6; /* flat */
    case 2:
        return x < 0.7 ? -1.0 : 1.0; /* a jump */
    case 3:
        return cos(3.0 * x) - 0.5;
    default:
        return exp(-50.0 * x) - 1e-10;
    }
}

static void roots(void)
{
    const double exact[5] = {0.3, pow(1e-6, 1.0 / 9.0), 0.7, acos(0.5) / 3.0, log(1e10) / 50.0};
    for (int kind = 0; kind < 5; ++kind) {
        counted c = {kind, 0};
        const double a = 0.0;
        const double b = 1.0;
        const double fa = value(&c, a);
        const double fb = value(&c, b);
        c.calls = 0;
        const double x = lag_root(value, &c, a, fa, b, fb, 1e-14);
        CHECK_NEAR(x, exact[kind], 2e-14);
        CHECK(lag_root_sign(value(&c, x)) == lag_root_sign(fb));
        CHECK(c.calls <= 52);
    }
    counted smooth = {3, 0};
    (void)lag_root(value, &smooth, 0.0, 0.5, 1.0, cos(3.0) - 0.5, 1e-14);
    CHECK(smooth.calls <= 15);
}

static void clocks_count(void)
{
    const lag_clock fast = lag_clock_of(0.0, 0.1);
    const lag_clock slow = lag_clock_of(0.0, 0.3);
    const lag_clock late = lag_clock_of(0.05, 0.1);
    const lag_clock odd = lag_clock_of(0.0, 3.14159265358979312);
    for (unsigned long long k = 0; k < 100000; ++k) {
        CHECK(lag_clock_instant(&fast, 3 * k) == lag_clock_instant(&slow, k));
        CHECK(lag_clock_instant(&fast, k) == (double)k / 10.0);
        CHECK(lag_clock_instant(&late, k) == (double)(2 * k + 1) / 20.0);
        CHECK(lag_clock_instant(&odd, k) == (double)k * 3.14159265358979312);
    }
}

static void clocks_seek(void)
{
    lag_clock clock = lag_clock_of(0.5, 0.1);
    lag_clock_seek(&clock, -3.0);
    CHECK(clock.next == 0);
    lag_clock_seek(&clock, 0.5);
    CHECK(clock.next == 0);
    lag_clock_seek(&clock, 0.55);
    CHECK(clock.next == 1);
    lag_clock_seek(&clock, 0.8);
    CHECK(clock.next == 3);
    lag_clock_seek(&clock, 1e6);
    CHECK(lag_clock_instant(&clock, clock.next) == 1e6);
    const double far[] = {1e17, 1e200, -1e200, (double)INFINITY};
    for (size_t i = 0; i < 4; ++i) { /* where ticks cannot be counted any more there are none */
        lag_clock_seek(&clock, far[i]);
        CHECK(lag_clock_instant(&clock, clock.next) >= far[i]);
    }
}

/* Round-off of the time does not move a tick: within 1e-9 of the period it is due, before and behind. */
static void a_tick_is_due_but_for_round_off(void)
{
    lag_clock clock = lag_clock_of(0.0, 0.5);
    lag_clock_enter(&clock, 1.0 + 1e-12);
    CHECK(clock.next == 2 && lag_clock_is_due(&clock, 1.0 + 1e-12) && lag_clock_is_due(&clock, 1.0 - 1e-12));
    CHECK(!lag_clock_is_due(&clock, 1.0 - 1e-8));
    lag_clock_enter(&clock, 1.0 + 1e-8);
    CHECK(clock.next == 3);
    CHECK(lag_clocks_same(1, &clock, 1.0 + 1e-12) == 1.0 && lag_clocks_same(1, &clock, 1.25) == 1.25);
    CHECK(lag_clocks_next(1, &clock) == 1.5 && lag_clocks_due(1, &clock, 1.5) == 0 && lag_clocks_due(1, &clock, 1.0) == 1);
}

/* So many events, each `ratio` times as long behind the one before, up to the one that is too many; all of them: none is. */
static int until_crowded(double first, double ratio, int relations, int most)
{
    lag_crowd crowd = {.last = -(double)INFINITY, .interval = (double)INFINITY, .first = (double)INFINITY};
    double t = 1.0;
    double interval = first;
    int count = 1;
    while (count < most && !lag_crowds(&crowd, t, 10.0, relations)) {
        t += interval;
        interval *= ratio;
        ++count;
    }
    return count;
}

/*
 * Intervals of 1/2 of the one before have a sum: they crowd once 2^-k < 1e-6, k = 20, behind the first that is shorter. Equal ones have none, as
 * long as they are no moments. Series of contacts end otherwise. A thousand at one time, or moments, are too many in any case.
 */
static void events_that_have_a_limit_crowd(void)
{
    const int halves = until_crowded(1.0, 0.5, 1, 1000);
    CHECK(halves >= 20 && halves <= 25);
    CHECK(until_crowded(1.0, 0.5, 0, 30) == 30);
    CHECK(until_crowded(1e-3, 1.0, 1, 5000) == 5000);
    CHECK(until_crowded(1e-3, 1.001, 1, 5000) == 5000);
    CHECK(until_crowded(0.0, 1.0, 0, 5000) >= 1000 && until_crowded(0.0, 1.0, 0, 5000) <= 1005);
    CHECK(until_crowded(0.9e-9, 1.0, 0, 5000) >= 1000 && until_crowded(0.9e-9, 1.0, 0, 5000) <= 1005);
}

int main(void)
{
    roots();
    clocks_count();
    clocks_seek();
    a_tick_is_due_but_for_round_off();
    events_that_have_a_limit_crowd();
    (void)printf("events: ok\n");
    return EXIT_SUCCESS;
}
