/*
 * Tests events/guards.c: each guard is positive while its mode lasts, and has left below its dead band, or below where it began if that was
 * below zero. Relations come first, then contacts, then friction.
 */
#include <float.h>

#include "law.h"

/* A relation q0 - 3 > 0, a floor under q1, friction along q2, at these places. */
static lag_run *begin(lag_model *model, double q0, double q1)
{
    law_clear(3);
    law.relations = law.contacts = law.frictions = law.components[0] = 1;
    law.relation[0][0] = law.gap[0][1] = law.slip[0][2] = 1.0;
    law.border[0] = -3.0;
    law.under[0] = law.contacts;
    law.sliding[0] = 2.0;
    law.sticking[0] = 3.0;
    law.q[0] = q0;
    law.q[1] = q1;
    law.force[1] = -7.0;
    law.force[2] = 1.0;
    *model = law_model();
    return law_begin(model, LAG_OK);
}

static lag_status look(lag_run *run, double q0, double q1)
{
    const double x[6] = {q0, q1};
    return lag_guards_detect(&run->guards, 0.0, x);
}

/* A relation in the sense of its truth, a gap or a force, a reserve of 3 - 1. */
static void guards_are_positive_while_their_mode_lasts(void)
{
    lag_model model;
    lag_run *run = begin(&model, 5.0, 0.5);
    const double *value = run->guards.value;
    CHECK(lag_guard_count(&model) == 3 && lag_guards_count(&run->guards) == 3);
    CHECK(look(run, 5.0, 0.5) == LAG_OK);
    CHECK_NEAR(value[0], 2.0, 1e-15);
    CHECK_NEAR(value[1], 0.5, 1e-15);
    CHECK_NEAR(value[2], 2.0, 1e-14);
    free(run);
    run = begin(&model, 1.0, 0.0); /* a relation that does not hold; a contact that carries 7 N */
    CHECK(look(run, 1.0, 0.0) == LAG_OK);
    CHECK_NEAR(run->guards.value[0], 2.0, 1e-15);
    CHECK_NEAR(run->guards.value[1], 7.0, 1e-13);
    free(run);
}

static void a_guard_has_left_below_zero_and_no_other_with_it(void)
{
    lag_model model;
    lag_run *run = begin(&model, 5.0, 0.5);
    const double *changed = run->guards.changed;
    CHECK(look(run, 2.999, 0.5) == LAG_EVENT_PENDING && changed[0] == 1.0 && changed[1] == 0.0 && changed[2] == 0.0);
    CHECK(look(run, 5.0, -0.001) == LAG_EVENT_PENDING && changed[0] == 0.0 && changed[1] == 1.0 && changed[2] == 0.0);
    CHECK(look(run, 3.001, 0.001) == LAG_OK && changed[0] == 0.0 && changed[1] == 0.0);
    free(run);
}

/* Five is the largest number that has entered: 16 to 32 eps 5. */
static void within_its_rounding_error_it_has_not(void)
{
    lag_model model;
    lag_run *run = begin(&model, 5.0, 0.5);
    CHECK(look(run, 3.0 - 4.0 * DBL_EPSILON, 0.5) == LAG_OK);
    CHECK(look(run, 3.0 - 40.0 * 5.0 * DBL_EPSILON, 0.5) == LAG_EVENT_PENDING);
    CHECK(look(run, 5.0, -0.5 * DBL_EPSILON) == LAG_OK);
    CHECK(look(run, 5.0, -0.5 * 40.0 * DBL_EPSILON) == LAG_EVENT_PENDING);
    free(run);
}

/* The step begins where the relation is 1e-3 beyond its border and has not turned: it leaves where it gets deeper. */
static void one_that_begins_below_zero_leaves_below_its_beginning(void)
{
    lag_model model;
    const double x[6] = {2.999, 0.5};
    lag_run *run = begin(&model, 5.0, 0.5);
    CHECK(lag_guards_begin(&run->guards, 0.0, x) == LAG_OK);
    CHECK_NEAR(run->guards.depth[0], 1e-3, 1e-15);
    CHECK(look(run, 2.999, 0.5) == LAG_OK);
    CHECK(look(run, 2.9995, 0.5) == LAG_OK);
    CHECK(look(run, 2.9985, 0.5) == LAG_EVENT_PENDING && run->guards.changed[0] == 1.0);
    free(run);
}

int main(void)
{
    guards_are_positive_while_their_mode_lasts();
    a_guard_has_left_below_zero_and_no_other_with_it();
    within_its_rounding_error_it_has_not();
    one_that_begins_below_zero_leaves_below_its_beginning();
    (void)printf("guards: ok\n");
    return EXIT_SUCCESS;
}
