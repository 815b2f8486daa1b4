/*
 * Tests contacts/contact_impacts.c (impacts until nothing closes any more: who takes part in a blow), contacts/contact.c (which contacts touch, and what
 * does not get into each other) and contacts/contact_scale.c (each contact is judged by the numbers that enter its own gap).
 */
#include <float.h>

#include "law.h"

/* ---- blows ---- */

/* Newton's cradle: of three balls that touch the first has 2 m/s. One blow for all would leave -2/3, 4/3, 4/3; a sequence hands it on to the last. */
static void a_cradle_is_a_sequence_of_blows(void)
{
    law_clear(3);
    law.contacts = 2;
    for (size_t i = 0; i < 2; ++i) {
        law.gap[i][i] = -1.0;
        law.gap[i][i + 1] = 1.0;
        law.restitution[i] = 1.0;
    }
    law.qd[0] = 2.0;
    const lag_model model = law_model();
    lag_run *run = law_begin(&model, LAG_OK);
    size_t order[2] = {2, 2};
    size_t count = 0;
    for (size_t k = 0; k < law_told.count; ++k) {
        if (law_told.what[k].what == LAG_IMPACT) {
            CHECK(count < 2);
            order[count++] = law_told.what[k].which;
        }
    }
    CHECK(order[0] == 0 && order[1] == 1);
    CHECK_NEAR(run->stepper.x[3], 0.0, 1e-14);
    CHECK_NEAR(run->stepper.x[4], 0.0, 1e-14);
    CHECK_NEAR(run->stepper.x[5], 2.0, 1e-14);
    free(run);
}

/*
 * A ball strikes one that lies on a floor, both elastic but for the floor. A floor that carries holds: 1 m/s back up. One that touches without force is
 * reached by a blow of its own, behind the first, and takes all of it.
 */
static void a_contact_that_carries_takes_part_in_the_blow(void)
{
    for (int carries = 0; carries < 2; ++carries) {
        law_clear(2);
        law.contacts = 2;
        law.gap[0][0] = law.gap[1][1] = 1.0;
        law.gap[0][1] = -1.0;
        law.restitution[0] = 1.0;
        law.qd[0] = -1.0;
        law.force[1] = carries ? -5.0 : 0.0;
        const lag_model model = law_model();
        lag_run *run = law_begin(&model, LAG_OK);
        CHECK_NEAR(run->stepper.x[2], carries ? 1.0 : 0.0, 1e-13);
        CHECK_NEAR(run->stepper.x[3], 0.0, 1e-13);
        free(run);
    }
}

/* Newton: v+ = -e v-. With a friction that holds Poisson: mu = 1, the slip stops, and the gap parts with e all the same as rows are orthogonal. */
static void a_ball_parts_with_e_of_its_approach(void)
{
    for (int rough = 0; rough < 2; ++rough) {
        law_clear(2);
        law.contacts = 1;
        law.frictions = (size_t)rough;
        law.components[0] = 1;
        law.gap[0][0] = law.slip[0][1] = 1.0;
        law.mu[0] = 0.25;
        law.restitution[0] = 0.5;
        law.qd[0] = -2.0;
        law.qd[1] = 3.0;
        const lag_model model = law_model();
        lag_run *run = law_begin(&model, LAG_OK);
        CHECK_NEAR(run->stepper.x[2], 1.0, 1e-13);
        CHECK_NEAR(run->stepper.x[3], rough ? 3.0 - 0.25 * 3.0 : 3.0, 1e-13); /* mu times the impulse of 2 + 1 */
        CHECK(run->motion.w[law_at.impacts] == 1.0);
        free(run);
    }
}

/* ---- contacts at rest ---- */

static lag_run *ball(lag_model *model)
{
    law_clear(2);
    law.contacts = 1;
    law.gap[0][0] = 1.0;
    law.force[0] = -20.0;
    law.q[0] = 2.0;
    law.q[1] = 1e6; /* does not enter */
    *model = law_model();
    return law_begin(model, LAG_OK);
}

static void what_touches_at_rest_may_be_closed(void)
{
    static const double cases[][3] = {/* gap, rate, closes */
        {0.0, 0.0, 1.0}, {0.0, -1.0, 0.0}, {0.0, 1.0, 0.0}, {1e-6, 0.0, 0.0}, {1e-13, 0.0, 1.0}};
    lag_model model;
    double closing[1];
    double pierced[1];
    lag_run *run = ball(&model);
    for (size_t k = 0; k < sizeof cases / sizeof cases[0]; ++k) {
        const double x[4] = {cases[k][0], 1e6, cases[k][1], 0.0};
        CHECK(lag_contacts_begin(&run->instants.contacts, 0.0, x, closing, pierced) == LAG_OK);
        CHECK((closing[0] != 0.0) == (cases[k][2] != 0.0));
    }
    free(run);
}

static void a_gap_is_not_negative_at_the_start_nor_made_so(void)
{
    lag_model model;
    double flags[1];
    double gap[1];
    lag_run *run = ball(&model);
    lag_contacts *contacts = &run->instants.contacts;
    const double above[4] = {0.0, 1e6, 0.0, 0.0};
    const double below[4] = {-1e-3, 1e6, 0.0, 0.0};
    CHECK(lag_contacts_begin(contacts, 0.0, above, gap, flags) == LAG_OK && flags[0] == 0.0);
    CHECK(lag_contacts_begin(contacts, 0.0, below, gap, flags) == LAG_PENETRATION && flags[0] == 1.0);
    CHECK(lag_contacts_check_gaps(contacts, 0.0, below, above, run->motion.w, gap, flags) == LAG_PENETRATION && flags[0] == 1.0);
    CHECK(lag_contacts_check_gaps(contacts, 0.0, below, below, run->motion.w, gap, flags) == LAG_OK && flags[0] == 0.0); /* nothing has changed */
    free(run);
}

static void a_closed_contact_that_moves_apart_opens(void)
{
    lag_model model;
    lag_run *run = ball(&model);
    lag_contacts *contacts = &run->instants.contacts;
    const double rests[4] = {0.0, 1e6, 0.0, 0.0};
    const double rises[4] = {0.0, 1e6, 1e-3, 0.0};
    run->motion.w[law_at.contact] = 1.0;
    CHECK(lag_contacts_are_at_rest(contacts, 0.0, rests) && lag_contacts_open(contacts, 0.0, rests, 0) == LAG_OK && run->motion.w[law_at.contact] == 1.0);
    CHECK(!lag_contacts_are_at_rest(contacts, 0.0, rises) && lag_contacts_open(contacts, 0.0, rises, 0) == LAG_OK && run->motion.w[law_at.contact] == 0.0);
    free(run);
}

/* ---- scales ---- */

/* A gap of 2 m, though another coordinate is at a thousand kilometres: 16 eps 2 m; the force is the weight, 20 N. */
static void a_contact_is_judged_by_what_enters_its_gap(void)
{
    lag_model model;
    lag_run *run = ball(&model);
    lag_contacts *contacts = &run->instants.contacts;
    const double fast[4] = {0.5, 1e6, -3.0, 1e9};
    CHECK(lag_contacts_evaluate_at(contacts, 0.0, run->stepper.x) == LAG_OK);
    CHECK_NEAR(lag_contacts_gap_noise(contacts, 0), 16.0 * DBL_EPSILON * 2.0, 1e-30);
    CHECK_NEAR(lag_contacts_gap_band(contacts, 0), 2e-12, 1e-24);
    CHECK_NEAR(lag_contacts_speed_band(contacts, 0), 2e-12 / 10.0, 1e-24); /* that in 10 s */
    CHECK(lag_contacts_find_forces(contacts, 0.0, run->stepper.x) == LAG_OK);
    CHECK_NEAR(contacts->sizes.force[0], 20.0, 1e-12);
    CHECK_NEAR(lag_contacts_force_noise(contacts, 0), 20.0 * 1e-13, 1e-24);
    CHECK(lag_contacts_evaluate_at(contacts, 0.0, fast) == LAG_OK); /* the largest so far: 2 m, 3 m/s */
    CHECK_NEAR(lag_contacts_gap_noise(contacts, 0), 16.0 * DBL_EPSILON * 2.0, 1e-30);
    CHECK_NEAR(lag_contacts_speed_band(contacts, 0), 3e-12, 1e-24);
    free(run);
}

int main(void)
{
    a_cradle_is_a_sequence_of_blows();
    a_contact_that_carries_takes_part_in_the_blow();
    a_ball_parts_with_e_of_its_approach();
    what_touches_at_rest_may_be_closed();
    a_gap_is_not_negative_at_the_start_nor_made_so();
    a_closed_contact_that_moves_apart_opens();
    a_contact_is_judged_by_what_enters_its_gap();
    (void)printf("strikes: ok\n");
    return EXIT_SUCCESS;
}
