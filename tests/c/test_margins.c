/* Tests optimization/margins.c: the largest least margin of limits over loads that unknowns share, against cases that are solved by hand. */
#include "check.h"
#include "lag/optimization/margins.h"

static double memory[16384];

static lag_margins begin(size_t unknowns, size_t sides)
{
    CHECK(lag_margins_memory(unknowns, sides, sides) <= sizeof memory / sizeof memory[0]);
    return lag_margins_of(unknowns, sides, memory);
}

/* |3 + y| + s <= 5 and |3 - y| + s <= 2: the sum 6 + 2 s <= 7, so s = 1/2 at y = 3/2. */
static void two_sides_share_a_load(void)
{
    lag_margins margins = begin(1, 2);
    for (size_t i = 0; i < 2; ++i) {
        double *limit = lag_margins_add(&margins, 1, 1.0);
        double *load = limit + 2;
        limit[0] = i == 0 ? 5.0 : 2.0;
        load[0] = 3.0;
        load[1] = i == 0 ? 1.0 : -1.0;
    }
    CHECK_NEAR(lag_margins_solve(&margins), 0.5, 1e-12);
    CHECK_NEAR(margins.y[0], 1.5, 1e-12);
    CHECK_NEAR(lag_margin_of(&margins, 0), 0.5, 1e-12);
}

/* Limits y and 2 - y of sizes 1 and 3: s <= y and 3 s <= 2 - y, so s = 1/2. Without loads an unknown may be negative: -y and 2 + y, too. */
static void limits_follow_unknowns_of_either_sign(void)
{
    for (int sign = -1; sign <= 1; sign += 2) {
        lag_margins margins = begin(1, 2);
        double *first = lag_margins_add(&margins, 0, 1.0);
        first[1] = sign;
        double *second = lag_margins_add(&margins, 0, 3.0);
        second[0] = 2.0;
        second[1] = -sign;
        CHECK_NEAR(lag_margins_solve(&margins), 0.5, 1e-12);
        CHECK_NEAR(margins.y[0], 0.5 * sign, 1e-12);
    }
}

/* The load (3 + y, 1) has the length 1 at least, at y = -3, where no first tangent of its disc is. */
static void a_load_of_two_components_has_its_length(void)
{
    lag_margins margins = begin(1, 1);
    double *limit = lag_margins_add(&margins, 2, 1.0);
    limit[0] = 1.5;
    limit[2] = 3.0;
    limit[3] = 1.0;
    limit[4] = 1.0;
    CHECK_NEAR(lag_margins_solve(&margins), 0.5, 1e-9);
    CHECK_NEAR(margins.y[0], -3.0, 1e-3);
}

/*
 * The ball in a groove of test_reserve.c: n = 5/2 - sqrt(3) y of the flanks, t = 5 sin 60 + y of friction within 2/5 n. With 4 N left on each side the flanks
 * press with 10 N, and friction bears nothing.
 */
static void forces_of_a_ball_in_a_groove(void)
{
    lag_margins margins = begin(1, 4);
    for (size_t i = 0; i < 4; ++i) {
        const int presses = i < 2;
        double *limit = lag_margins_add(&margins, presses ? 0 : 1, 10.0);
        limit[0] = presses ? 2.5 : 1.0;
        limit[1] = -sqrt(3.0) * (presses ? 1.0 : 0.4);
        limit[2] = presses ? 0.0 : 2.5 * sqrt(3.0);
        limit[3] = presses ? 0.0 : 1.0;
    }
    CHECK_NEAR(10.0 * lag_margins_solve(&margins), 4.0, 1e-10);
    for (size_t i = 0; i < 4; ++i) {
        CHECK_NEAR(lag_margin_of(&margins, i), i < 2 ? 10.0 : 4.0, 1e-10);
    }
    CHECK_NEAR(2.5 - sqrt(3.0) * margins.y[0], 10.0, 1e-10);
    CHECK_NEAR(2.5 * sqrt(3.0) + margins.y[0], 0.0, 1e-10);
}

/* One that is exceeded has a negative margin; one that nothing exceeds is told as its size. */
static void margins_are_negative_or_at_most_one(void)
{
    lag_margins margins = begin(0, 1);
    double *limit = lag_margins_add(&margins, 1, 2.0);
    limit[0] = 1.0;
    limit[1] = -4.0;
    CHECK_NEAR(lag_margins_solve(&margins), -1.5, 1e-12);
    limit[0] = 100.0;
    CHECK_NEAR(lag_margins_solve(&margins), 1.0, 1e-12);
}

int main(void)
{
    two_sides_share_a_load();
    limits_follow_unknowns_of_either_sign();
    a_load_of_two_components_has_its_length();
    forces_of_a_ball_in_a_groove();
    margins_are_negative_or_at_most_one();
    (void)printf("margins: ok\n");
    return EXIT_SUCCESS;
}
