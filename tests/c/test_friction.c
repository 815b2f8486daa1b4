/*
 * Tests contacts/friction.c: the guard of friction is its slip along its direction while it slides, the reserve while it sticks, infinite while its
 * contact is open; in a plane the part of the slip along that of the beginning of the step.
 */
#include "law.h"

static lag_frictions *frictions;

/* A body on a floor (coordinate 0), in a plane (1 and 2), with R = 2 and R_0 = 3, pushed along 1 and moving at `speed`. */
static lag_run *body(lag_model *model, size_t components, double force, double speed)
{
    law_clear(3);
    law.frictions = 1;
    law.components[0] = components;
    law.slip[0][1] = law.slip[1][2] = 1.0;
    law.sliding[0] = 2.0;
    law.sticking[0] = 3.0;
    law.force[1] = force;
    law.qd[1] = speed;
    *model = law_model();
    lag_run *run = law_begin(model, LAG_OK);
    frictions = &run->instants.frictions;
    return run;
}

static void look(lag_run *run, double along, double aside)
{
    run->stepper.x[4] = along;
    run->stepper.x[5] = aside;
    CHECK(lag_motion_solve(&run->motion, 0.0, run->stepper.x) == LAG_OK);
    CHECK(lag_frictions_evaluate(frictions) == LAG_OK);
}

/* ---- one component ---- */

static void sticking_leaves_what_the_limit_has_beyond_the_force(void)
{
    lag_model model;
    lag_run *run = body(&model, 1, -2.25, 0.0);
    look(run, 0.0, 0.0);
    CHECK(*lag_frictions_sticks(frictions, 0) == 1.0);
    CHECK_NEAR(lag_frictions_force(frictions, 0), 2.25, 1e-14);
    CHECK_NEAR(lag_frictions_guard(frictions, 0), 0.75, 1e-14);
    CHECK(lag_frictions_dead_band(frictions, 0) > 0.0 && lag_frictions_dead_band(frictions, 0) < 1e-11);
    free(run);
}

static void sliding_lasts_while_the_slip_has_its_direction(void)
{
    for (int sense = -1; sense < 2; sense += 2) {
        lag_model model;
        lag_run *run = body(&model, 1, 0.0, sense * 4.0);
        CHECK(*lag_frictions_direction(frictions, 0) == (double)sense);
        look(run, sense * 0.5, 0.0);
        CHECK_NEAR(lag_frictions_guard(frictions, 0), 0.5, 0.0);
        look(run, -sense * 0.5, 0.0);
        CHECK_NEAR(lag_frictions_guard(frictions, 0), -0.5, 0.0);
        CHECK_NEAR(lag_frictions_speed(frictions, 0), 0.5, 0.0);
        /* zero: a part of the largest terms so far */
        CHECK(lag_frictions_speed_band(frictions, 0) > 0.0 && lag_frictions_speed_band(frictions, 0) < 4.0 * 1e-11);
        free(run);
    }
}

static void friction_under_an_open_contact_is_off(void)
{
    law_clear(2);
    law.contacts = law.frictions = law.components[0] = 1;
    law.gap[0][0] = law.slip[0][1] = 1.0;
    law.rest[0] = 0.5;
    law.mu[0] = 0.5;
    law.force[0] = -1.0;
    law.qd[1] = 1.0;
    const lag_model model = law_model();
    lag_run *run = law_begin(&model, LAG_OK);
    frictions = &run->instants.frictions;
    CHECK(!lag_frictions_acts(frictions, 0));
    CHECK(lag_frictions_guard(frictions, 0) == (double)INFINITY);
    CHECK(*lag_frictions_sticks(frictions, 0) == 0.0 && *lag_frictions_direction(frictions, 0) == 0.0);
    run->motion.w[law_at.contact] = 1.0;
    CHECK(lag_frictions_acts(frictions, 0));
    free(run);
}

/* ---- two components ---- */

/* From (4, 0): at (1, 3) one is left along it; it ends where that is nothing. Its length alone has no sign. */
static void a_slip_in_a_plane_is_guarded_along_that_of_the_beginning(void)
{
    lag_model model;
    lag_run *run = body(&model, 2, 0.0, 4.0);
    look(run, 4.0, 0.0);
    lag_frictions_begin(frictions);
    look(run, 1.0, 3.0);
    CHECK_NEAR(lag_frictions_guard(frictions, 0), 1.0, 1e-6);
    look(run, -1.0, 3.0);
    CHECK_NEAR(lag_frictions_guard(frictions, 0), -1.0, 1e-6);
    CHECK_NEAR(lag_frictions_speed(frictions, 0), sqrt(10.0), 1e-14);
    free(run);
}

/* Beside it 3 of 4 m/s are left: it turns and goes on. 1e-3 of 4 m/s: it ends. */
static void it_ends_where_nearly_nothing_is_left_beside_it_either(void)
{
    lag_model model;
    lag_run *run = body(&model, 2, 0.0, 4.0);
    look(run, 4.0, 0.0);
    lag_frictions_begin(frictions);
    look(run, -1e-3, 3.0);
    CHECK(lag_frictions_turns(frictions, 0));
    look(run, -1e-4, 1e-3);
    CHECK(!lag_frictions_turns(frictions, 0));
    free(run);
    run = body(&model, 1, 0.0, 4.0); /* one component does not turn */
    look(run, -1.0, 0.0);
    CHECK(!lag_frictions_turns(frictions, 0));
    free(run);
}

static void forces_in_a_plane_have_a_length(void)
{
    lag_model model;
    lag_run *run = body(&model, 2, 1.5, 0.0);
    law.force[2] = 2.0;
    look(run, 0.0, 0.0);
    CHECK(*lag_frictions_sticks(frictions, 0) == 1.0);
    CHECK_NEAR(lag_frictions_force(frictions, 0), 2.5, 1e-14);
    CHECK_NEAR(lag_frictions_guard(frictions, 0), 0.5, 1e-14);
    free(run);
}

int main(void)
{
    sticking_leaves_what_the_limit_has_beyond_the_force();
    sliding_lasts_while_the_slip_has_its_direction();
    friction_under_an_open_contact_is_off();
    a_slip_in_a_plane_is_guarded_along_that_of_the_beginning();
    it_ends_where_nearly_nothing_is_left_beside_it_either();
    forces_in_a_plane_have_a_length();
    (void)printf("friction: ok\n");
    return EXIT_SUCCESS;
}
