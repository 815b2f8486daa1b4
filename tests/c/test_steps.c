/* Methods of fixed steps as methods of a run: their order, the ends of their steps, rows within them. */
#include <string.h>

#include "check.h"
#include "lag/run.h"
#include "spring.h"

extern const lag_method lag_steps_rk4, lag_steps_leapfrog, lag_steps_ros2;

enum { ROWS = 38, SIZE = 3 };

static lag_run *place(const lag_run_options *options)
{
    void *block = malloc(lag_run_size(&SPRING, options));
    CHECK(block != NULL);
    return lag_run_place(block, &SPRING, options);
}

/* The largest error of rows that lie within steps of length h. */
static double error(const lag_method *method, double h)
{
    double times[ROWS];
    double rows[ROWS][SIZE];
    double worst = 0.0;
    for (int i = 0; i < ROWS; ++i) {
        times[i] = 0.13 * i;
    }
    const lag_run_options options = {.method = method, .h_fixed = h, .count = ROWS, .times = times, .rows = rows[0]};
    lag_run *run = place(&options);
    CHECK(lag_run_begin(run, 0.0, NULL) == LAG_OK);
    CHECK(lag_run_to(run, 5.0, 0) == LAG_OK);
    for (int i = 0; i < ROWS; ++i) {
        worst = fmax(worst, fmax(fabs(rows[i][0] - cos(times[i])), fabs(rows[i][1] + sin(times[i]))));
        CHECK_NEAR(rows[i][2], 3.0 * times[i], 1e-12); /* a straight line is exact */
    }
    free(run);
    return worst;
}

/* With dense output of third order, whose error is of fourth, no row is worse than the order of the method. */
static void order(const lag_method *method, double wanted)
{
    const double coarse = error(method, 0.1);
    const double fine = error(method, 0.05);
    const double measured = log2(coarse / fine);
    (void)printf("%s: errors %.1e and %.1e, order %.2f\n", method->name, coarse, fine, measured);
    CHECK(coarse < 1e-2);
    CHECK_NEAR(measured, wanted, 0.25);
}

/* Ends of steps are counted: after a hundred thousand steps time is what a product gives, not what a sum does. */
static void ends_are_counted(void)
{
    const double h = 0.1;
    double sum = 0.0;
    const lag_run_options options = {.method = &lag_steps_leapfrog, .h_fixed = h};
    lag_run *run = place(&options);
    CHECK(lag_run_begin(run, 0.0, NULL) == LAG_OK);
    CHECK(lag_run_to(run, 1e9, 100000) == LAG_TOO_LONG);
    for (int i = 0; i < 100000; ++i) {
        sum += h;
    }
    CHECK(run->stepper.t == h + 99999 * h);
    CHECK(fabs(sum - 10000.0) > 1e-9); /* so that the sum would show */
    free(run);
}

/* The end is hit, in as many steps as it takes; a rest that is next to nothing belongs to the last one. */
static void the_end_is_hit(void)
{
    const double ends[3] = {1.0, 1.0005, 1.05};
    const size_t steps[3] = {10, 10, 11};
    for (int i = 0; i < 3; ++i) {
        const lag_run_options options = {.method = &lag_steps_rk4, .h_fixed = 0.1};
        lag_run *run = place(&options);
        CHECK(lag_run_begin(run, 0.0, NULL) == LAG_OK);
        CHECK(lag_run_to(run, ends[i], 0) == LAG_OK);
        CHECK(run->stepper.t == ends[i]);
        CHECK(run->stepper.counts.steps == steps[i]);
        free(run);
    }
}

int main(void)
{
    order(&lag_steps_rk4, 4.0);
    order(&lag_steps_leapfrog, 2.0);
    order(&lag_steps_ros2, 2.0);
    ends_are_counted();
    the_end_is_hit();
    (void)printf("steps: ok\n");
    return EXIT_SUCCESS;
}
