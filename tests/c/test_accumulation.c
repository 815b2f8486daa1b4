/*
 * Tests contacts/accumulation.c: with r, the fastest parting over the fastest approach of all contacts of an instant, a flight of T takes T/(1 - r)
 * with all that follow; contacts are held where that is too short, and told at the limit of the series.
 */
#include "law.h"

/* A ball that strikes at 0 s with 5 m/s, g = 10: it flies for e s, and e + e^2 + ... = e/(1 - e). Contacts rest where what is left is below `zeno`. */
static lag_run *ball(lag_model *model, double restitution, double zeno)
{
    law_clear(1);
    law.contacts = 1;
    law.gap[0][0] = 1.0;
    law.qd[0] = -5.0;
    law.force[0] = -10.0;
    law.restitution[0] = restitution;
    law.zeno_time = zeno;
    *model = law_model();
    return law_begin(model, LAG_OK);
}

static void bounces_end_at_the_limit_of_their_series(void)
{
    static const double restitutions[] = {0.1, 0.5, 0.9};
    for (size_t k = 0; k < sizeof restitutions / sizeof restitutions[0]; ++k) {
        const double e = restitutions[k];
        const double left = e / (1.0 - e);
        lag_model model;
        double closed = 0.0;
        lag_run *run = ball(&model, e, 1.001 * left);
        CHECK(run->motion.w[law_at.contact] == 1.0); /* it is held */
        CHECK_NEAR(run->instants.contacts.until[0], left, 1e-12 * left);
        CHECK_NEAR(lag_contacts_end_of_bounces(&run->instants.contacts), left, 1e-12 * left);
        CHECK(law_count(LAG_CLOSED, &closed) == 0); /* but not told yet */
        CHECK(lag_run_to(run, 9.5, 0) == LAG_OK);
        CHECK(law_count(LAG_CLOSED, &closed) == 1 && law_count(LAG_IMPACT, &closed) == 1);
        free(run);
    }
}

/* The rest is too long to be left out before the next bounce, and then it is not: left e^2/(1 - e), told at e + e^2/(1 - e), the same time. */
static void the_limit_is_the_same_wherever_bounces_are_left_out(void)
{
    for (int later = 0; later < 4; ++later) {
        lag_model model;
        double closed = 0.0;
        double struck = 0.0;
        const double left = pow(0.5, later + 1) / 0.5;
        lag_run *run = ball(&model, 0.5, 1.001 * left);
        CHECK(lag_run_to(run, 3.0, 0) == LAG_OK);
        CHECK(law_count(LAG_IMPACT, &struck) == 1u + (size_t)later && law_count(LAG_CLOSED, &closed) == 1);
        CHECK_NEAR(closed, 1.0, 1e-9);
        free(run);
    }
}

/* A flight is as long as the next; nothing accumulates. */
static void elastic_bounces_do_not_accumulate(void)
{
    lag_model model;
    lag_run *run = ball(&model, 1.0, 0.9); /* it flies for 1 s */
    CHECK(run->motion.w[law_at.contact] == 0.0);
    CHECK_NEAR(run->stepper.x[1], 5.0, 1e-14);
    free(run);
}

/* It strikes anew at 1 s and gets to v^2/2g = 1.25 m, unless a flight of this height is hidden. */
static void flights_that_are_hidden_are_none(void)
{
    static const double hidden[] = {1.249, 1.251};
    for (int k = 0; k < 2; ++k) {
        lag_model model;
        lag_run *run = ball(&model, 1.0, 0.0);
        run->instants.contacts.hidden[0] = hidden[k];
        CHECK(lag_run_to(run, 1.5, 0) == LAG_OK);
        CHECK(run->motion.w[law_at.contact] == (double)k);
        CHECK_NEAR(run->stepper.x[0], k == 0 ? 1.25 : 0.0, 1e-9);
        free(run);
    }
}

/*
 * A block that rocks from corner 1 (z + a) to corner 0 (z - a), m = 1, I = 3, both without restitution. Corner 0 strikes with u: P = u/(1/m + 1/I) = 3u/4
 * stops it; corner 1, which carried the block, parts with P (1/m - 1/I) = u/2. So r = 1/2: speeds of both corners stand for energies in the
 * same way. About corner 0 the block turns back with (m + I) a'' = -m g, its gap with twice that, -g/2: T = 2 u/g, and 4 u/g with all that follow.
 */
static void a_contact_that_opens_continues_the_series_of_the_one_that_closes(void)
{
    static const double u = 0.2;
    law_clear(2);
    law.contacts = 2;
    law.gap[0][0] = law.gap[1][0] = law.gap[1][1] = 1.0;
    law.gap[0][1] = -1.0;
    law.mass[1] = 3.0;
    law.force[0] = -10.0;
    law.qd[0] = -0.5 * u;
    law.qd[1] = 0.5 * u;
    law.zeno_time = 1.001 * 0.4 * u;
    lag_model model = law_model();
    lag_run *run = law_begin(&model, LAG_OK);
    CHECK_NEAR(run->instants.contacts.until[0], 0.4 * u, 1e-10);
    CHECK(run->motion.w[law_at.contact] == 1.0 && run->motion.w[law_at.contact + 1] == 1.0);
    free(run);
    law.zeno_time = 0.999 * 0.4 * u; /* that is too long to leave it out */
    model = law_model();
    run = law_begin(&model, LAG_OK);
    CHECK(run->motion.w[law_at.contact] == 1.0 && run->motion.w[law_at.contact + 1] == 0.0);
    CHECK(run->instants.contacts.until[0] == (double)INFINITY);
    CHECK_NEAR(run->stepper.x[2] + run->stepper.x[3], 0.5 * u, 1e-12);
    free(run);
}

/*
 * The same with corner 1 at twice the distance, z + 2 a: P = 3u/4 parts it with P (1/m - 2/I) = u/4. A unit impulse gives corner 0 a speed of
 * 1 + 1/3, corner 1 one of 1 + 4/3, so equal energies stop 2 and sqrt(7) m/s: r = 1/4 2/sqrt(7). It comes back with -3 m g/(m + I) = -7.5.
 */
static void speeds_are_compared_by_the_energies_that_stop_them(void)
{
    static const double u = 0.2;
    const double left = u / 15.0 / (1.0 - 0.5 / sqrt(7.0));
    law_clear(2);
    law.contacts = 2;
    law.gap[0][0] = law.gap[1][0] = 1.0;
    law.gap[0][1] = -1.0;
    law.gap[1][1] = 2.0;
    law.mass[1] = 3.0;
    law.force[0] = -10.0;
    law.qd[0] = -2.0 / 3.0 * u;
    law.qd[1] = u / 3.0;
    law.zeno_time = 1.001 * left;
    const lag_model model = law_model();
    lag_run *run = law_begin(&model, LAG_OK);
    CHECK_NEAR(run->instants.contacts.until[0], left, 1e-10);
    free(run);
}

/* Two balls strike at once, one bounces up to 1 s, the other is elastic: one component, and it goes on; two, and each is judged by itself. */
static void contacts_of_other_components_do_not_count(void)
{
    static const size_t apart[2] = {0, 1};
    for (int coupled = 0; coupled < 2; ++coupled) {
        law_clear(2);
        law.contacts = 2;
        for (size_t i = 0; i < 2; ++i) {
            law.gap[i][i] = 1.0;
            law.qd[i] = -5.0;
            law.force[i] = -10.0;
        }
        law.restitution[0] = 0.5;
        law.restitution[1] = 1.0;
        law.zeno_time = 1.001;
        lag_model model = law_model();
        model.components = coupled ? NULL : apart;
        lag_run *run = law_begin(&model, LAG_OK);
        CHECK(run->motion.w[law_at.contact] == (coupled ? 0.0 : 1.0));
        CHECK(run->motion.w[law_at.contact + 1] == 0.0);
        free(run);
    }
}

int main(void)
{
    bounces_end_at_the_limit_of_their_series();
    the_limit_is_the_same_wherever_bounces_are_left_out();
    elastic_bounces_do_not_accumulate();
    flights_that_are_hidden_are_none();
    a_contact_that_opens_continues_the_series_of_the_one_that_closes();
    speeds_are_compared_by_the_energies_that_stop_them();
    contacts_of_other_components_do_not_count();
    (void)printf("accumulation: ok\n");
    return EXIT_SUCCESS;
}
