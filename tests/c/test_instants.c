/*
 * Tests events/instant.c (clocks, the start and the end act once, in the first pass), events/timed.c (changes with time are computed ahead) and
 * events/event_notice.c (the name of what something happened to).
 */
#include "law.h"
#include "machine.h"

/* ---- instants ---- */

/* Counts ticks, the start and the end, and goes through three passes more at each of them. */
static void count(const lag_arguments *at, double *next, double *reset, double *value)
{
    const double tick = at->w[law_at.clock];
    const double initial = at->w[law_at.initial];
    const double terminal = at->w[law_at.terminal];
    (void)reset;
    (void)value;
    next[0] = at->w[0] + tick;
    next[1] = at->w[1] + initial;
    next[2] = at->w[2] + terminal;
    next[3] = tick + initial + terminal > 0.0 ? 3.0 : fmax(at->w[3] - 1.0, 0.0);
}

/* Ticks at 1/4, 3/4, 5/4 and 7/4 s. */
static void clocks_and_the_ends_act_in_the_first_pass_only(void)
{
    double at = 0.0;
    law_clear(1);
    law.variables = 4;
    law.clocks = law.ends = 1;
    law.first = 0.25;
    law.period = 0.5;
    law.pass = count;
    const lag_model model = law_model();
    lag_run *run = law_begin(&model, LAG_OK);
    const double *w = run->motion.w;
    CHECK_NEAR(w[0], 0.0, 0.0);
    CHECK_NEAR(w[1], 1.0, 0.0);
    CHECK_NEAR(w[2], 0.0, 0.0);
    CHECK_NEAR(lag_instants_next(&run->instants), 0.25, 0.0);
    CHECK(lag_run_to(run, 2.0, 0) == LAG_OK && lag_run_end(run) == LAG_OK);
    CHECK_NEAR(w[0], 4.0, 0.0);
    CHECK_NEAR(w[1], 1.0, 0.0);
    CHECK_NEAR(w[2], 1.0, 0.0);
    CHECK(law_count(LAG_TICK, &at) == 4);
    CHECK_NEAR(at, 0.25, 0.0);
    free(run);
}

static void a_clock_has_a_positive_period(void)
{
    static const double periods[] = {0.0, -1.0};
    for (size_t k = 0; k < 2; ++k) {
        law_clear(1);
        law.clocks = 1;
        law.period = periods[k];
        const lag_model model = law_model();
        lag_run *run = law_begin(&model, LAG_BAD_CLOCK);
        free(run);
    }
}

/* ---- time ---- */

static enum { LINE, WAVE, DIP } shape;

/* The distance of the truth w from its change, and its rate. */
static lag_status time_event(
    const lag_arguments *at, double *value, double *told, double *distance, double *rate, double *affine, double *entry)
{
    const double t = at->t;
    const double g = shape == LINE ? t - 0.3 : shape == WAVE ? sin(3.0 * t) - 0.5 : 1.0 + 1e-8 - cosh(t - 4.0);
    const double slope = shape == LINE ? 1.0 : shape == WAVE ? 3.0 * cos(3.0 * t) : -sinh(t - 4.0);
    const double sense = at->w[law_at.timed] != 0.0 ? 1.0 : -1.0;
    value[0] = g > 0.0 ? 1.0 : 0.0;
    told[0] = 1.0;
    distance[0] = sense * g;
    rate[0] = sense * slope;
    affine[0] = shape == LINE ? 1.0 : 0.0;
    entry[0] = 0.0;
    return LAG_OK;
}

/* The next change behind t, with the truth that holds there. */
static double next_behind(double t)
{
    law_clear(1);
    law.timed = 1;
    lag_model model = law_model();
    model.ndistance = 1;
    model.time_event = time_event;
    lag_run *run = law_begin(&model, LAG_OK);
    lag_timed *timed = &run->instants.timed;
    CHECK_NEAR(timed->length, 10.0, 0.0);
    CHECK(lag_timed_set(timed, t) == LAG_OK && lag_timed_find_next(timed, t) == LAG_OK);
    const double next = timed->next;
    const double before = run->motion.w[law_at.timed];
    if (next < 10.0) {
        CHECK(lag_timed_due(timed, next) && !lag_timed_due(timed, next - 1e-9));
        CHECK(lag_timed_change(timed, next) == LAG_OK);
        CHECK(run->motion.w[law_at.timed] == 1.0 - before && lag_timed_is_reported(timed));
    }
    free(run);
    return next;
}

static void a_line_is_zero_where_it_says(void)
{
    shape = LINE;
    CHECK_NEAR(next_behind(0.0), 0.3, 1e-16);
    CHECK(next_behind(0.5) == (double)INFINITY);
}

/* sin 3 t = 1/2 at pi/18, then at 5 pi/18, then a period of 2 pi/3 later. */
static void a_curve_is_zero_where_it_first_is(void)
{
    const double pi = acos(-1.0);
    shape = WAVE;
    CHECK_NEAR(next_behind(0.0), pi / 18.0, 1e-14);
    CHECK_NEAR(next_behind(0.2), 5.0 * pi / 18.0, 1e-14);
    CHECK_NEAR(next_behind(1.0), pi / 18.0 + 2.0 * pi / 3.0, 1e-14);
}

/* 1 + 1e-8 - cosh(t - 4) is positive for 3e-4 s of 10 s; acosh(1 + h) = 2 asinh(sqrt(h/2)). */
static void nothing_is_stepped_over_however_short_it_is(void)
{
    shape = DIP;
    const double half = 2.0 * asinh(sqrt(0.5e-8));
    CHECK_NEAR(next_behind(0.0), 4.0 - half, 1e-11);
    CHECK_NEAR(next_behind(4.0), 4.0 + half, 1e-11);
}

/* ---- notices ---- */

static const char *name_of(lag_event_kind what)
{
    const lag_event_notice notice = {.what = what};
    return lag_event_notice_name(&MACHINE, &notice);
}

static void a_notice_has_the_name_of_what_it_happened_to(void)
{
    CHECK(strcmp(name_of(LAG_TICK), "sample(0, 0.05)") == 0);
    CHECK(strcmp(name_of(LAG_TRUE), "x > 0.1") == 0 && strcmp(name_of(LAG_FALSE), "x > 0.1") == 0);
    CHECK(strcmp(name_of(LAG_IMPACT), "floor") == 0 && strcmp(name_of(LAG_CLOSED), "floor") == 0 && strcmp(name_of(LAG_OPENED), "floor") == 0);
    CHECK(strcmp(name_of(LAG_REINIT), "der(x)") == 0);
    CHECK(name_of(LAG_BEFORE) == NULL && name_of(LAG_AFTER) == NULL);
    CHECK(strcmp(lag_event_kind_name(LAG_BEFORE), "before") == 0 && strcmp(lag_event_kind_name(LAG_TICK), "tick") == 0);
    CHECK(strcmp(lag_event_kind_name(LAG_JUMP), "jump") == 0 && strcmp(lag_event_kind_name(LAG_REVERSES), "reverses") == 0);
}

int main(void)
{
    clocks_and_the_ends_act_in_the_first_pass_only();
    a_clock_has_a_positive_period();
    a_line_is_zero_where_it_says();
    a_curve_is_zero_where_it_first_is();
    nothing_is_stepped_over_however_short_it_is();
    a_notice_has_the_name_of_what_it_happened_to();
    (void)printf("instants: ok\n");
    return EXIT_SUCCESS;
}
