/*
 * Tests events/event_iteration.c (passes run until nothing changes; E0804 if they do not end) and events/event_contacts.c (contacts in passes:
 * what strikes, closes and opens, each told once, in this order).
 */
#include "law.h"

/* ---- passes ---- */

static double last; /* the clause counts up to this */

static void count_up(const lag_arguments *at, double *next, double *reset, double *value)
{
    (void)reset;
    (void)value;
    next[0] = fmin(at->w[0] + 1.0, last);
}

static void flip(const lag_arguments *at, double *next, double *reset, double *value)
{
    (void)reset;
    (void)value;
    next[1] = 1.0 - at->w[1];
}

static lag_run *begin_with(size_t variables, void (*pass)(const lag_arguments *, double *, double *, double *), lag_status expected)
{
    static lag_model model;
    law_clear(1);
    law.variables = variables;
    law.pass = pass;
    model = law_model();
    return law_begin(&model, expected);
}

/* Each pass sees what the one before has left: all that follows from each other happens at one instant. */
static void passes_run_until_nothing_changes(void)
{
    static const double counts[] = {1.0, 2.0, 50.0, 99.0};
    for (size_t k = 0; k < sizeof counts / sizeof counts[0]; ++k) {
        last = counts[k];
        lag_run *run = begin_with(1, count_up, LAG_OK);
        CHECK_NEAR(run->motion.w[0], last, 0.0);
        CHECK_NEAR(run->stepper.t, 0.0, 0.0);
        free(run);
    }
}

static void passes_without_end_are_told_with_what_still_changes(void)
{
    lag_run *run = begin_with(3, flip, LAG_EVENT_ITERATION_FAILED);
    const double *guilty = run->instants.discretes.guilty;
    CHECK(guilty[0] == 0.0 && guilty[1] == 1.0 && guilty[2] == 0.0);
    free(run);
}

/* The first pass throws q across its border; the clause of the relation acts in the next one, at the same instant. */
static void throw_across(const lag_arguments *at, double *next, double *reset, double *value)
{
    reset[0] = at->w[0] == 0.0;
    value[0] = 2.0;
    next[0] = 1.0;
    next[1] = at->w[law_at.relation] != 0.0 ? 7.0 : at->w[1];
}

static void a_relation_that_a_pass_turns_acts_in_the_next_one(void)
{
    law_clear(1);
    law.variables = 2;
    law.relations = law.resets = 1;
    law.relation[0][0] = 1.0;
    law.q[0] = -1.0;
    law.pass = throw_across;
    const lag_model model = law_model();
    lag_run *run = law_begin(&model, LAG_OK);
    double first = -1.0;
    CHECK_NEAR(run->stepper.x[0], 2.0, 0.0);
    CHECK_NEAR(run->motion.w[1], 7.0, 0.0);
    CHECK(law_count(LAG_REINIT, &first) == 1);
    free(run);
}

/* Two clauses that set one rate to different values at one instant contradict each other. */
static void contradict(const lag_arguments *at, double *next, double *reset, double *value)
{
    reset[0] = reset[1] = at->w[0] == 0.0;
    value[0] = 1.0;
    value[1] = last;
    next[0] = 1.0;
}

static void one_number_has_one_value_behind_a_pass(void)
{
    for (int agree = 0; agree < 2; ++agree) {
        law_clear(1);
        law.variables = 1;
        law.resets = 2;
        law.reset[0] = law.reset[1] = 1;
        law.pass = contradict;
        last = agree ? 1.0 : 2.0;
        const lag_model model = law_model();
        lag_run *run = law_begin(&model, agree ? LAG_OK : LAG_CONFLICT);
        free(run);
    }
}

/* ---- contacts ---- */

static void set_ball(double height, double restitution)
{
    law_clear(1);
    law.contacts = 1;
    law.gap[0][0] = 1.0;
    law.q[0] = height;
    law.force[0] = -10.0;
    law.restitution[0] = restitution;
}

static void ends_up(const lag_arguments *at, double *force)
{
    force[0] += 10.0 - 1.0 + at->t; /* altogether t - 1 */
}

/* From 0.2 m: at 0.2 s. Without restitution it strikes, then closes; with it, it strikes. */
static void a_blow_is_told_before_what_it_leaves(void)
{
    for (int elastic = 0; elastic < 2; ++elastic) {
        set_ball(0.2, elastic ? 1.0 : 0.0);
        const lag_model model = law_model();
        lag_run *run = law_begin(&model, LAG_OK);
        double struck = 0.0;
        double closed = 0.0;
        CHECK(lag_run_to(run, 0.3, 0) == LAG_OK);
        CHECK(law_count(LAG_IMPACT, &struck) == 1 && law_count(LAG_CLOSED, &closed) == (elastic ? 0u : 1u));
        CHECK_NEAR(struck, 0.2, 1e-12);
        CHECK(law_told.count == (elastic ? 3u : 4u) && law_told.what[0].what == LAG_BEFORE && law_told.what[1].what == LAG_IMPACT);
        CHECK(law_told.what[law_told.count - 1].what == LAG_AFTER);
        CHECK(run->motion.w[law_at.contact] == (elastic ? 0.0 : 1.0));
        free(run);
    }
}

/* The force is t - 1: the contact bears it until 1 s, and q = (t - 1)^3/6 behind it. */
static void a_contact_opens_where_it_would_pull(void)
{
    set_ball(0.0, 0.0);
    law.push = ends_up;
    const lag_model model = law_model();
    lag_run *run = law_begin(&model, LAG_OK);
    double opened = 0.0;
    CHECK(run->motion.w[law_at.contact] == 1.0);
    CHECK(lag_run_to(run, 2.0, 0) == LAG_OK);
    CHECK(law_count(LAG_OPENED, &opened) == 1 && law_count(LAG_IMPACT, &opened) == 0);
    CHECK_NEAR(opened, 1.0, 1e-12);
    CHECK_NEAR(run->stepper.x[0], 1.0 / 6.0, 1e-9);
    free(run);
}

int main(void)
{
    passes_run_until_nothing_changes();
    passes_without_end_are_told_with_what_still_changes();
    a_relation_that_a_pass_turns_acts_in_the_next_one();
    one_number_has_one_value_behind_a_pass();
    a_blow_is_told_before_what_it_leaves();
    a_contact_opens_where_it_would_pull();
    (void)printf("passes: ok\n");
    return EXIT_SUCCESS;
}
