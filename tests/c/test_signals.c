/* Tables as inputs: values at their times, between and beyond them, and on both sides of jumps. */
#include "check.h"
#include "lag/signals.h"

static const double TIMES[5] = {0.0, 1.0, 1.0, 3.0, 4.0};
static const double VALUES[5] = {2.0, 4.0, -1.0, 1.0, 0.0};

static void steps(void)
{
    const lag_signal signal = {.kind = LAG_SIGNAL_STEPS, .count = 5, .time = TIMES, .value = VALUES};
    CHECK(lag_signal_at(&signal, -1.0, 0) == 2.0 && lag_signal_at(&signal, 0.5, 0) == 2.0);
    CHECK(lag_signal_at(&signal, 1.0, 0) == -1.0 && lag_signal_at(&signal, 1.0, 1) == 2.0);
    CHECK(lag_signal_at(&signal, 4.0, 1) == 1.0 && lag_signal_at(&signal, 9.0, 0) == 0.0);
}

static void lines(void)
{
    const lag_signal signal = {.kind = LAG_SIGNAL_LINES, .count = 5, .time = TIMES, .value = VALUES};
    CHECK(lag_signal_at(&signal, 0.5, 0) == 3.0 && lag_signal_at(&signal, 2.0, 0) == 0.0);
    CHECK(lag_signal_at(&signal, 1.0, 0) == -1.0 && lag_signal_at(&signal, 1.0, 1) == 4.0);
    CHECK(lag_signal_at(&signal, -1.0, 0) == 0.0 && lag_signal_at(&signal, 5.0, 0) == -1.0);
}

static void polynomials(void)
{
    static const double times[3] = {0.0, 1.0, 2.0};
    static const double powers[6] = {1.0, 0.0, 3.0, 0.0, 2.0, -1.0}; /* t^2 + 3, then 2 (t - 1) - 1 */
    const lag_signal signal = {.kind = LAG_SIGNAL_POLYNOMIAL, .count = 3, .terms = 3, .time = times, .value = powers};
    CHECK(lag_signal_at(&signal, 0.5, 0) == 3.25 && lag_signal_at(&signal, -2.0, 0) == 7.0);
    CHECK(lag_signal_at(&signal, 1.0, 0) == -1.0 && lag_signal_at(&signal, 1.0, 1) == 4.0);
    CHECK(lag_signal_at(&signal, 2.0, 0) == 1.0 && lag_signal_at(&signal, 3.0, 1) == 3.0);
}

static void inputs(void)
{
    const lag_signal own[2] = {{.kind = LAG_SIGNAL_HELD}, {.kind = LAG_SIGNAL_STEPS, .count = 5, .time = TIMES, .value = VALUES}};
    lag_signals signals = {2, own};
    double u[2] = {7.0, 8.0};
    lag_signals_tell(&signals, 1.0, 1, u);
    CHECK(u[0] == 7.0 && u[1] == 2.0);
}

int main(void)
{
    steps();
    lines();
    polynomials();
    inputs();
    (void)printf("signals: ok\n");
    return EXIT_SUCCESS;
}
