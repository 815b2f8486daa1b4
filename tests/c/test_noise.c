/*
 * Tests events/noise.c: the rounding error of an indicator is about eps |dg/dx x|, of the numbers that enter it, of no others; gradients;
 * relations that rows hold.
 */
#include <float.h>

#include "law.h"

/* Each number is moved by 16 to 32 round-offs of its largest magnitude. */
static const double LEAST = 16.0 * DBL_EPSILON, MOST = 32.0 * DBL_EPSILON;

/* sigma of a q0 + b q1 + c at (q0, q1), which the motion has passed through alone. */
static double sigma_of(double a, double b, double c, double q0, double q1)
{
    law_clear(2);
    law.relations = 1;
    law.relation[0][0] = a;
    law.relation[0][1] = b;
    law.border[0] = c;
    law.q[0] = q0;
    law.q[1] = q1;
    const lag_model model = law_model();
    lag_run *run = law_begin(&model, LAG_OK);
    lag_noise_find(&run->instants.noise, 0.0, run->stepper.x);
    const double sigma = run->instants.noise.sigma[0];
    CHECK_NEAR(run->instants.noise.value[0], a * q0 + b * q1 + c, 1e-9 * (fabs(a * q0) + fabs(b * q1) + fabs(c)));
    free(run);
    return sigma;
}

/* g = 5 q0 - 15 at 3: a difference of 15 m and 15 m is known to 15 eps, though it is zero. */
static void an_error_is_that_of_the_numbers_not_of_their_sum(void)
{
    const double sigma = sigma_of(5.0, 0.0, -15.0, 3.0, 0.0);
    CHECK(sigma >= LEAST * 15.0 * (1.0 - 1e-1) && sigma <= MOST * 15.0 * (1.0 + 1e-1));
}

static void two_numbers_do_not_cancel(void)
{
    static const double signs[2] = {1.0, -1.0};
    for (size_t k = 0; k < 2; ++k) {
        const double sigma = sigma_of(1.0, signs[k], -3.0 - signs[k] * 3.0, 3.0, 3.0);
        CHECK(sigma >= DBL_EPSILON * 6.0 && sigma <= MOST * 6.0 * (1.0 + 1e-1));
    }
}

/* The other coordinate is a thousand kilometres away, or does not exist: the same to a rounding. */
static void numbers_that_do_not_enter_do_not_count(void)
{
    const double alone = sigma_of(1.0, 0.0, -3.0, 3.0, 0.0);
    CHECK_NEAR(sigma_of(1.0, 0.0, -3.0, 3.0, 1e6), alone, 0.0);
    CHECK_NEAR(sigma_of(1e-3, 0.0, -3e-3, 3.0, 1e6), 1e-3 * alone, 0.2e-3 * alone); /* in another unit */
}

/* The motion has been at 1000: near zero its numbers have the round-off of that. */
static void the_largest_magnitude_so_far_counts(void)
{
    double far[2] = {1000.0, 0.0};
    law_clear(1);
    law.relations = 1;
    law.relation[0][0] = 1.0;
    law.q[0] = 0.5;
    const lag_model model = law_model();
    lag_run *run = law_begin(&model, LAG_OK);
    lag_noise *noise = &run->instants.noise;
    lag_contacts_follow(noise->contacts, far);
    lag_noise_find(noise, 0.0, run->stepper.x);
    CHECK(noise->sigma[0] >= LEAST * 1000.0 * 0.99 && noise->sigma[0] <= MOST * 1000.0 * 1.01);
    /* with the relative error of the tolerance in place of 16 eps */
    CHECK_NEAR(lag_noise_known(noise, 0), noise->tolerance / LEAST * noise->sigma[0], 1e-12 * lag_noise_known(noise, 0));
    CHECK(noise->tolerance > 0.0);
    CHECK_NEAR(lag_noise_extent(noise, run->stepper.x, 0), 1000.0, 0.0);
    free(run);
}

/* g = 2 q0 - 7 q1 + 0 q2: its gradient, and that time does not enter. */
static void gradients_are_those_of_the_indicator(void)
{
    static const double expected[3] = {2.0, -7.0, 0.0};
    double gradient[3];
    double drift = 1.0;
    law_clear(3);
    law.relations = 1;
    memcpy(law.relation[0], expected, sizeof expected);
    law.q[0] = 0.25;
    law.q[1] = 4.0;
    law.q[2] = -3.0;
    const lag_model model = law_model();
    lag_run *run = law_begin(&model, LAG_OK);
    lag_noise_find(&run->instants.noise, 0.0, run->stepper.x);
    CHECK(lag_noise_differentiate(&run->instants.noise, 0.0, run->stepper.x, 0, gradient, &drift) == 1);
    for (size_t j = 0; j < 3; ++j) {
        CHECK_NEAR(gradient[j], expected[j], 1e-12);
    }
    CHECK_NEAR(drift, 0.0, 0.0);
    free(run);
}

/* q0 - q1 is zero as the bar holds it; q0 - 1 is zero at the moment. */
static void a_relation_is_held_by_rows_not_by_chance(void)
{
    double point[4];
    double held[2] = {0.0, 1.0};
    law_clear(2);
    law.bars = 1;
    law.relations = 2;
    law.bar[0][0] = law.relation[0][0] = law.relation[1][0] = 1.0;
    law.bar[0][1] = law.relation[0][1] = -1.0;
    law.border[1] = -1.0;
    law.q[0] = law.q[1] = 1.0;
    const lag_model model = law_model();
    lag_run *run = law_begin(&model, LAG_OK);
    lag_noise_hold(&run->instants.noise, &run->projection, 0.0, run->stepper.x, point, held);
    CHECK(held[0] == 1.0 && held[1] == 0.0);
    free(run);
}

int main(void)
{
    an_error_is_that_of_the_numbers_not_of_their_sum();
    two_numbers_do_not_cancel();
    numbers_that_do_not_enter_do_not_count();
    the_largest_magnitude_so_far_counts();
    gradients_are_those_of_the_indicator();
    a_relation_is_held_by_rows_not_by_chance();
    (void)printf("noise: ok\n");
    return EXIT_SUCCESS;
}
