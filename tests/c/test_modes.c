/*
 * Tests contacts/modes.c (which modes are looked for, and which go on; the problem of accelerations, first with the
 * limit at rest, then with that of sliding for what slips) on blocks with R = 2 and R_0 = 3.
 */
#include "law.h"

enum { SLIDES_BACK = -1, STICKS = 0, SLIDES = 1 };

/* The mode just behind the start of a block of 1 kg, and its acceleration. */
static int mode_of(double force, double speed, double *acceleration)
{
    law_clear(1);
    law.frictions = law.components[0] = 1;
    law.slip[0][0] = 1.0;
    law.sliding[0] = 2.0;
    law.sticking[0] = 3.0;
    law.force[0] = force;
    law.qd[0] = speed;
    const lag_model model = law_model();
    lag_run *run = law_begin(&model, LAG_OK);
    const double *w = run->motion.w;
    CHECK(lag_motion_solve(&run->motion, 0.0, run->stepper.x) == LAG_OK);
    *acceleration = run->motion.qdd[0];
    const int mode = (int)w[law_at.direction];
    CHECK((w[law_at.sticks] != 0.0) == (mode == STICKS));
    free(run);
    return mode;
}

/* The law at rest: a force of up to R_0 is borne; beyond it the block slips along the force, with R, less than R_0, against it. */
static void what_slips_from_rest_has_the_limit_of_sliding(void)
{
    double a = 0.0;
    CHECK(mode_of(0.0, 0.0, &a) == STICKS);
    CHECK(mode_of(2.5, 0.0, &a) == STICKS);
    CHECK_NEAR(a, 0.0, 1e-14);
    CHECK(mode_of(2.999999, 0.0, &a) == STICKS);
    CHECK(mode_of(3.000001, 0.0, &a) == SLIDES);
    CHECK_NEAR(a, 1.000001, 1e-12);
    CHECK(mode_of(-3.5, 0.0, &a) == SLIDES_BACK);
    CHECK_NEAR(a, -1.5, 1e-14);
}

/* Between R and R_0: it sticks at rest, and slides on where it slides. */
static void friction_that_slides_goes_on(void)
{
    double a = 0.0;
    CHECK(mode_of(2.5, 1.0, &a) == SLIDES);
    CHECK_NEAR(a, 0.5, 1e-14);
    CHECK(mode_of(2.5, -1.0, &a) == SLIDES_BACK);
    CHECK_NEAR(a, 4.5, 1e-14);
}

/* ---- along a motion ---- */

static double turning; /* the force is this, less t */

static void fades(const lag_arguments *at, double *force)
{
    force[0] += turning - at->t;
}

static void grows(const lag_arguments *at, double *force)
{
    force[0] += turning + at->t;
}

static lag_run *block(lag_model *model, void (*push)(const lag_arguments *, double *), double speed)
{
    law_clear(1);
    law.frictions = law.components[0] = 1;
    law.slip[0][0] = 1.0;
    law.sliding[0] = 2.0;
    law.sticking[0] = 3.0;
    law.qd[0] = speed;
    law.push = push;
    *model = law_model();
    return law_begin(model, LAG_OK);
}

/* The force 2 + t breaks it loose at 1 s; behind that v = (t - 1) + (t - 1)^2/2. */
static void a_guard_that_leaves_goes_where_it_left(void)
{
    lag_model model;
    double slipped = 0.0;
    turning = 2.0;
    lag_run *run = block(&model, grows, 0.0);
    CHECK(run->motion.w[law_at.sticks] == 1.0);
    CHECK(lag_run_to(run, 2.0, 0) == LAG_OK);
    CHECK(law_count(LAG_SLIPS, &slipped) == 1 && law_count(LAG_STICKS, &slipped) == 0);
    CHECK_NEAR(slipped, 1.0, 1e-11);
    CHECK(run->motion.w[law_at.direction] == 1.0);
    CHECK_NEAR(run->stepper.x[1], 1.5, 1e-8);
    free(run);
}

/* v = 1/2 - t^2/2 while the force 2 - t is R = 2 less t: it rests at 1 s, and sticks as |2 - t| <= 3 until 5 s, when it slips back. */
static void a_slip_that_ends_sticks_where_the_limit_at_rest_bears_it(void)
{
    lag_model model;
    double stuck = 0.0;
    double slipped = 0.0;
    turning = 2.0;
    lag_run *run = block(&model, fades, 0.5);
    CHECK(lag_run_to(run, 5.5, 0) == LAG_OK);
    CHECK(law_count(LAG_STICKS, &stuck) == 1 && law_count(LAG_SLIPS, &slipped) == 1);
    CHECK_NEAR(stuck, 1.0, 1e-9);
    CHECK_NEAR(slipped, 5.0, 1e-9);
    CHECK(run->motion.w[law_at.direction] == -1.0);
    free(run);
}

/* ---- contacts ---- */

/* A plate on two props at -1 and 1, and a moment: only the prop that is pressed stays. Masses 1 and 1, weight 10, moment 15: 1 opens. */
static void a_contact_stays_where_it_pushes_and_opens_where_it_would_pull(void)
{
    law_clear(2);
    law.contacts = 2;
    law.gap[0][0] = law.gap[1][0] = law.gap[1][1] = 1.0;
    law.gap[0][1] = -1.0;
    law.force[0] = -10.0;
    law.force[1] = 5.0;
    lag_model model = law_model();
    lag_run *run = law_begin(&model, LAG_OK);
    CHECK(run->motion.w[law_at.contact] == 1.0 && run->motion.w[law_at.contact + 1] == 1.0);
    free(run);
    law.force[1] = 15.0;
    model = law_model();
    run = law_begin(&model, LAG_OK);
    CHECK(run->motion.w[law_at.contact] == 1.0 && run->motion.w[law_at.contact + 1] == 0.0);
    CHECK(lag_motion_solve(&run->motion, 0.0, run->stepper.x) == LAG_OK);
    CHECK_NEAR(run->motion.lam[0], 12.5, 1e-12); /* q0'' - q1'' = 0: -10 + lam = 15 - lam */
    free(run);
}

/* A block on a floor with mu = 1/2 and 10 N: sticks below 5 N. Lifted, its friction is off. */
static void friction_under_a_contact_follows_it(void)
{
    for (int lifted = 0; lifted < 2; ++lifted) {
        law_clear(2);
        law.contacts = law.frictions = law.components[0] = 1;
        law.gap[0][0] = law.slip[0][1] = 1.0;
        law.mu[0] = 0.5;
        law.force[0] = lifted ? 1.0 : -10.0;
        law.force[1] = 4.9;
        const lag_model model = law_model();
        lag_run *run = law_begin(&model, LAG_OK);
        CHECK(run->motion.w[law_at.contact] == (lifted ? 0.0 : 1.0));
        CHECK(run->motion.w[law_at.sticks] == (lifted ? 0.0 : 1.0) && run->motion.w[law_at.direction] == 0.0);
        free(run);
    }
}

int main(void)
{
    what_slips_from_rest_has_the_limit_of_sliding();
    friction_that_slides_goes_on();
    a_guard_that_leaves_goes_where_it_left();
    a_slip_that_ends_sticks_where_the_limit_at_rest_bears_it();
    a_contact_stays_where_it_pushes_and_opens_where_it_would_pull();
    friction_under_a_contact_follows_it();
    (void)printf("modes: ok\n");
    return EXIT_SUCCESS;
}
