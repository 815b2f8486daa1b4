/*
 * Tests contacts/reserve.c (rows that share undetermined forces have one reserve, the largest least one, a linear
 * program) on a table of four legs at (1, 1), (1, -1), (-1, 1), (-1, -1), which a force pushes along x.
 */
#include "law.h"

enum { HEIGHT, TILT, ROLL, ALONG, ASIDE, DEGREES };
enum { LEGS = 4 };

static const double PLACES[LEGS][2] = {{1, 1}, {1, -1}, {-1, 1}, {-1, -1}};

/* Weight 40 N, `off` m from the middle towards the legs 0 and 1; mu = 1/2; slips with one component, or with two. */
static lag_run *table(lag_model *model, size_t components, double off, double along, double aside)
{
    law_clear(DEGREES);
    law.contacts = law.frictions = LEGS;
    for (size_t i = 0; i < LEGS; ++i) {
        law.gap[i][HEIGHT] = 1.0;
        law.gap[i][TILT] = PLACES[i][0];
        law.gap[i][ROLL] = PLACES[i][1];
        law.slip[components * i][ALONG] = 1.0;
        if (components > 1) {
            law.slip[components * i + 1][ASIDE] = 1.0;
        }
        law.components[i] = components;
        law.under[i] = i;
        law.mu[i] = 0.5;
    }
    law.force[HEIGHT] = -40.0;
    law.force[TILT] = -40.0 * off;
    law.force[ALONG] = along;
    law.force[ASIDE] = aside;
    *model = law_model();
    lag_run *run = law_begin(model, LAG_OK);
    for (size_t i = 0; i < LEGS; ++i) {
        CHECK(run->motion.w[law_at.contact + i] == 1.0);
    }
    return run;
}

/* Reserves of the state that it is in now. */
static const double *look(lag_run *run)
{
    lag_modes *modes = &run->instants.modes;
    CHECK(lag_motion_solve(&run->motion, run->stepper.t, run->stepper.x) == LAG_OK);
    CHECK(lag_frictions_evaluate(modes->frictions) == LAG_OK);
    CHECK(lag_reserve_evaluate(&modes->reserve) == LAG_OK);
    return modes->frictions->reserve;
}

/*
 * Legs bear 15, 15, 5, 5 N, so friction at most 7.5, 7.5, 2.5, 2.5. A push of 16 N of 20: with 6.5, 6.5, 1.5, 1.5 each has 1 N left, and no
 * distribution leaves more to all. The smallest forces, 4 each, would leave nothing, and less, to the legs behind.
 */
static void the_reserve_is_the_largest_least_one(void)
{
    lag_model model;
    lag_run *run = table(&model, 1, 0.5, 16.0, 0.0);
    const double *reserve = look(run);
    for (size_t k = 0; k < LEGS; ++k) {
        CHECK(run->motion.w[law_at.sticks + k] == 1.0);
        CHECK_NEAR(reserve[LEGS + k], 1.0, 1e-11);
        CHECK_NEAR(lag_frictions_guard(&run->instants.frictions, k), reserve[LEGS + k], 0.0);
    }
    free(run);
}

/* The weight at 3/4 m: limits are 8.75, 8.75, 1.25, 1.25 N. All that is left would be 3 N each, but the legs behind have 1.25 at most. */
static void no_leg_has_less_than_the_reserve(void)
{
    lag_model model;
    lag_run *run = table(&model, 1, 0.75, 8.0, 0.0);
    const double *reserve = look(run);
    for (size_t k = 0; k < LEGS; ++k) {
        CHECK_NEAR(reserve[LEGS + k], 1.25, 1e-11);
    }
    free(run);
}

/* (mu W - F)/4, wherever the weight is, as long as each leg can share: zero where the table slips. */
static void all_of_the_limits_are_used_before_it_slips(void)
{
    static const double pushes[] = {12.0, 18.0, 19.9, 19.9999};
    for (size_t k = 0; k < sizeof pushes / sizeof pushes[0]; ++k) {
        for (int skew = 0; skew < 2; ++skew) {
            lag_model model;
            lag_run *run = table(&model, 1, skew ? 0.5 * (pushes[k] >= 16.0) : 0.0, pushes[k], 0.0);
            CHECK_NEAR(look(run)[LEGS], (20.0 - pushes[k]) / 4.0, 1e-10);
            free(run);
        }
    }
}

/* In a plane: 16 N as (9.6, 12.8), within the discs, and the same reserve as along x. */
static void discs_share_as_limits_do(void)
{
    lag_model model;
    lag_run *run = table(&model, 2, 0.5, 9.6, 12.8);
    const double *reserve = look(run);
    for (size_t k = 0; k < LEGS; ++k) {
        CHECK_NEAR(reserve[LEGS + k], 1.0, 1e-10);
    }
    free(run);
}

/*
 * A ball of 10 N in a groove of flanks at 60 degrees, mu = 2/5. Forces n of the flanks and t of friction: n + sqrt(3) t = W. The smallest ones have
 * t = sqrt(3) n, beyond the limit; with t = 0 friction has mu n = 4 N left, and flanks more: the reserve of all four. No other forces have 4 N left:
 * n >= 10 + 5/2 |t| and n = 10 - sqrt(3) t.
 */
static void contacts_share_with_their_friction(void)
{
    const double sine = sqrt(0.75);
    law_clear(2);
    law.contacts = law.frictions = 2;
    for (size_t i = 0; i < 2; ++i) {
        const double side = i == 0 ? 1.0 : -1.0;
        law.gap[i][0] = side * sine;
        law.gap[i][1] = law.slip[i][0] = 0.5;
        law.slip[i][1] = -side * sine;
        law.components[i] = 1;
        law.under[i] = i;
        law.mu[i] = 0.4;
    }
    law.force[1] = -10.0;
    const lag_model model = law_model();
    lag_run *run = law_begin(&model, LAG_OK);
    const double *reserve = look(run);
    for (size_t i = 0; i < 4; ++i) {
        CHECK_NEAR(reserve[i], 4.0, 1e-10);
        CHECK_NEAR(fabs(run->motion.lam[i]), i < 2 ? 2.5 : 5.0 * sine, 1e-12); /* those of the motion are the smallest */
    }
    free(run);
}

/* A block on one foot: what is determined has no reserve but its own. */
static void what_shares_nothing_has_no_common_reserve(void)
{
    law_clear(2);
    law.contacts = law.frictions = law.components[0] = 1;
    law.gap[0][0] = law.slip[0][1] = 1.0;
    law.mu[0] = 0.5;
    law.force[0] = -40.0;
    law.force[1] = 8.0;
    const lag_model model = law_model();
    lag_run *run = law_begin(&model, LAG_OK);
    const double *reserve = look(run);
    CHECK(isnan(reserve[0]) && isnan(reserve[1]));
    CHECK_NEAR(lag_frictions_guard(&run->instants.frictions, 0), 12.0, 1e-12);
    free(run);
}

int main(void)
{
    the_reserve_is_the_largest_least_one();
    no_leg_has_less_than_the_reserve();
    all_of_the_limits_are_used_before_it_slips();
    discs_share_as_limits_do();
    contacts_share_with_their_friction();
    what_shares_nothing_has_no_common_reserve();
    (void)printf("reserve: ok\n");
    return EXIT_SUCCESS;
}
