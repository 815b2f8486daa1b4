/*
 * Tests run/run_scan.c (a guard that leaves and returns within one step is found), run/run_zero_crossings.c (its zero to the last bits),
 * run/run_instants.c (an event is told with the state before and behind it) and run/run_corners.c (a step ends at a kink of a force).
 */
#include <float.h>

#include "law.h"

/* Relations a q + b > 0 of one coordinate with q(0), v(0) and a constant acceleration: methods take steps as long as they may. */
static lag_run *parabola(lag_model *model, double q, double v, double acceleration)
{
    law_clear(1);
    law.q[0] = q;
    law.qd[0] = v;
    law.force[0] = acceleration;
    law.relations = law.relations > 0 ? law.relations : 1;
    law.relation[0][0] = 1.0;
    *model = law_model();
    return law_begin(model, LAG_OK);
}

/* ---- between the ends of a step ---- */

/* q = h - (t - 4)^2 is above zero for 2 sqrt(h), at shortest 2e-4 s of 10 s. */
static void a_guard_that_leaves_and_returns_within_one_step_is_found(void)
{
    static const double heights[] = {1.0, 1e-2, 1e-4, 1e-6, 1e-8};
    for (size_t k = 0; k < sizeof heights / sizeof heights[0]; ++k) {
        lag_model model;
        double rises = 0.0;
        double falls = 0.0;
        const double half = sqrt(heights[k]);
        lag_run *run = parabola(&model, heights[k] - 16.0, 8.0, -2.0);
        CHECK(lag_run_to(run, 10.0, 0) == LAG_OK);
        CHECK(law_count(LAG_TRUE, &rises) == 1 && law_count(LAG_FALSE, &falls) == 1);
        CHECK_NEAR(rises, 4.0 - half, 1e-13 / half); /* q is a sum of terms of up to 36 */
        CHECK_NEAR(falls, 4.0 + half, 1e-13 / half);
        free(run);
    }
}

static void what_does_not_reach_zero_is_no_event(void)
{
    static const double depths[] = {1.0, 1e-4, 1e-8, 1e-10};
    for (size_t k = 0; k < sizeof depths / sizeof depths[0]; ++k) {
        lag_model model;
        lag_run *run = parabola(&model, -depths[k] - 16.0, 8.0, -2.0);
        CHECK(lag_run_to(run, 10.0, 0) == LAG_OK);
        CHECK(law_told.count == 0);
        free(run);
    }
}

/* In one step, the other way round than they are numbered: q > late at `late`, 2 q > 2 and 5 q > 5 at 1 s, which is one instant. */
static void the_first_of_several_is_found_first(void)
{
    static const double times[] = {3.0, 1.001, 1.0 + 1e-9};
    static const lag_event_kind kinds[] = {LAG_BEFORE, LAG_TRUE, LAG_TRUE, LAG_AFTER, LAG_BEFORE, LAG_TRUE, LAG_AFTER};
    for (size_t i = 0; i < sizeof times / sizeof times[0]; ++i) {
        law_clear(1);
        law.relations = 3;
        law.qd[0] = law.relation[0][0] = 1.0;
        law.relation[1][0] = 2.0;
        law.relation[2][0] = 5.0;
        law.border[0] = -times[i];
        law.border[1] = -2.0;
        law.border[2] = -5.0;
        const lag_model model = law_model();
        lag_run *run = law_begin(&model, LAG_OK);
        CHECK(lag_run_to(run, 10.0, 0) == LAG_OK);
        CHECK(law_told.count == sizeof kinds / sizeof kinds[0]);
        for (size_t k = 0; k < law_told.count; ++k) {
            CHECK(law_told.what[k].what == kinds[k]);
            CHECK_NEAR(law_told.what[k].t, k < 4 ? 1.0 : times[i], 3e-14); /* the sum of the lengths of a few steps is rounded */
        }
        CHECK(law_told.what[1].which == 1 && law_told.what[2].which == 2 && law_told.what[5].which == 0);
        free(run);
    }
}

static lag_status ripple(const lag_arguments *at, double *g)
{
    g[0] = cos(20.0 * at->q[0]);
    return LAG_OK;
}

static lag_status ripple_rate(const lag_arguments *at, double *rate, double *acceleration)
{
    rate[0] = -20.0 * at->qd[0] * sin(20.0 * at->q[0]);
    acceleration[0] = -400.0 * at->qd[0] * at->qd[0] * cos(20.0 * at->q[0]); /* nothing accelerates */
    return LAG_OK;
}

/* cos 20 q with q = t, which a step of any length has exactly: pieces follow the relation. It turns at (k + 1/2) pi/20, 64 times in 10 s. */
static void pieces_of_a_step_are_as_short_as_the_guard_asks_for(void)
{
    size_t turns = 0;
    law_clear(1);
    law.relations = 1;
    law.qd[0] = 1.0;
    lag_model model = law_model();
    model.indicator = ripple;
    model.indicator_rate = ripple_rate;
    lag_run *run = law_begin(&model, LAG_OK);
    CHECK(lag_run_to(run, 10.0, 0) == LAG_OK);
    for (size_t k = 0; k < law_told.count; ++k) {
        if (law_told.what[k].what == LAG_TRUE || law_told.what[k].what == LAG_FALSE) {
            CHECK(law_told.what[k].what == (turns % 2 == 0 ? LAG_FALSE : LAG_TRUE));
            CHECK_NEAR(law_told.what[k].t, ((double)turns + 0.5) * acos(-1.0) / 20.0, 1e-13);
            ++turns;
        }
    }
    CHECK(turns == 64);
    free(run);
}

/* ---- zeros ---- */

/* 5 t^2 = 5/4 at 1/2 s, v t = 1 at 1/v: to four units in the last place of the time, or of the step. */
static void a_zero_is_found_to_the_last_bits(void)
{
    static const double cases[][4] = {/* q, v, a, t */
        {-1.25, 0.0, 10.0, 0.5}, {-1.0, 3.0, 0.0, 1.0 / 3.0}, {1.0, -0.125, 0.0, 8.0}, {-2.0, 0.0, 4.0, 1.0}, {-1.0, 0.7, 0.0, 1.0 / 0.7}};
    for (size_t k = 0; k < sizeof cases / sizeof cases[0]; ++k) {
        lag_model model;
        double at = 0.0;
        lag_run *run = parabola(&model, cases[k][0], cases[k][1], cases[k][2]);
        CHECK(lag_run_to(run, 10.0, 0) == LAG_OK);
        CHECK(law_count(cases[k][0] < 0.0 ? LAG_TRUE : LAG_FALSE, &at) == 1);
        CHECK_NEAR(at, cases[k][3], 4.0 * DBL_EPSILON * 10.0);
        free(run);
    }
}

/* ---- events ---- */

/* A ball with e = 1/2 strikes with 5 m/s at 1/2 s: -5 is told before, 5/2 behind it, and the run goes on from there. */
static void an_event_is_told_with_the_state_before_and_behind_it(void)
{
    law_clear(1);
    law.contacts = 1;
    law.gap[0][0] = 1.0;
    law.q[0] = 1.25;
    law.force[0] = -10.0;
    law.restitution[0] = 0.5;
    const lag_model model = law_model();
    lag_run *run = law_begin(&model, LAG_OK);
    CHECK(lag_run_to(run, 0.75, 0) == LAG_OK);
    CHECK(law_told.count == 3 && run->counts.events == 1);
    CHECK(law_told.what[0].what == LAG_BEFORE && law_told.what[2].what == LAG_AFTER);
    CHECK_NEAR(law_told.rate[0], -5.0, 1e-12);
    CHECK_NEAR(law_told.rate[2], 2.5, 1e-12);
    CHECK_NEAR(law_told.what[0].t, law_told.what[2].t, 0.0);
    CHECK_NEAR(run->stepper.x[0], 0.25 * 2.5 - 5.0 * 0.0625, 1e-10);
    free(run);
}

/* A motor stands still until 1 s, and has 4 m/s from then on. */
static void start_motor(void *context, double t, int before, double *u)
{
    (void)context;
    u[0] = t > 1.0 || (t == 1.0 && !before) ? 4.0 : 0.0;
}

/* It drives masses of 1 and 3 kg apart: a prescribed speed that jumps is a blow, in which the momentum stays: 3 and -1 m/s. */
static void inputs_that_jump_leave_the_momenta(void)
{
    lag_inputs *const inputs = start_motor;
    const lag_run_options options = {.tolerance = 1e-10, .length = 10.0, .callbacks = {.inputs = inputs, .tell = law_note}};
    law_clear(2);
    law.bars = 1;
    law.driven = 1;
    law.mass[1] = 3.0;
    law.bar[0][0] = 1.0;
    law.bar[0][1] = -1.0;
    const lag_model model = law_model();
    void *block = malloc(lag_run_size(&model, &options));
    CHECK(block != NULL);
    lag_run *run = lag_run_place(block, &model, &options);
    law_told.count = 0;
    CHECK(lag_run_begin(run, 0.0, NULL) == LAG_OK);
    run->motion.until = 1.0; /* the inputs of this row */
    CHECK(lag_run_to(run, 1.0, 0) == LAG_OK);
    CHECK_NEAR(run->stepper.x[2], 0.0, 0.0);
    CHECK(lag_run_jump(run) == LAG_OK);
    CHECK_NEAR(run->stepper.x[2], 3.0, 1e-12);
    CHECK_NEAR(run->stepper.x[3], -1.0, 1e-12);
    CHECK_NEAR(run->stepper.x[0], 0.0, 0.0);
    CHECK(law_told.count == 2 && law_told.what[0].what == LAG_BEFORE && law_told.what[1].what == LAG_AFTER);
    CHECK_NEAR(law_told.rate[0], 0.0, 0.0);
    CHECK_NEAR(law_told.rate[1], 3.0, 1e-12);
    free(run);
}

/* ---- corners ---- */

static void stiffens(const lag_arguments *at, double *force)
{
    force[1] += fabs(at->q[0]);
}

static lag_status kink(const lag_arguments *at, double *far, double *solved)
{
    far[0] = at->q[0];
    *solved = 0.0;
    return LAG_OK;
}

/*
 * q0 = 1 - t, q1'' = |q0|: q1(2) = 1/3 + 1/2 + 1/6 = 1. On both sides of the kink a polynomial of degree three, which a method of order eight has
 * exactly, however loose its tolerance: if a step ends there.
 */
static void a_step_ends_at_a_kink(void)
{
    const lag_run_options options = {.tolerance = 1e-2, .length = 10.0, .h_first = 0.3};
    law_clear(2);
    law.variables = 1; /* a model with discretes */
    law.q[0] = 1.0;
    law.qd[0] = -1.0;
    law.push = stiffens;
    lag_model model = law_model();
    model.ncorner = 1;
    model.corner = kink;
    void *block = malloc(lag_run_size(&model, &options));
    CHECK(block != NULL);
    lag_run *run = lag_run_place(block, &model, &options);
    CHECK(lag_run_begin(run, 0.0, NULL) == LAG_OK);
    CHECK(lag_run_to(run, 2.0, 0) == LAG_OK);
    CHECK_NEAR(run->stepper.x[1], 1.0, 1e-11);
    CHECK_NEAR(run->stepper.x[3], 1.0, 1e-11);
    CHECK(run->counts.events == 0); /* nothing else happens there */
    free(run);
}

int main(void)
{
    a_guard_that_leaves_and_returns_within_one_step_is_found();
    what_does_not_reach_zero_is_no_event();
    the_first_of_several_is_found_first();
    pieces_of_a_step_are_as_short_as_the_guard_asks_for();
    a_zero_is_found_to_the_last_bits();
    an_event_is_told_with_the_state_before_and_behind_it();
    inputs_that_jump_leave_the_momenta();
    a_step_ends_at_a_kink();
    (void)printf("scan: ok\n");
    return EXIT_SUCCESS;
}
