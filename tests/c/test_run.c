/* Whole runs of small models that are written by hand. */
#include <string.h>

#include "check.h"
#include "lag/fixed.h"
#include "lag/run.h"
#include "oscillator.h"

static const double given; /* to the functions of models: its address */

static lag_status no_preparation(const lag_arguments *at)
{
    CHECK(at->context == &given);
    return LAG_OK;
}

static lag_status no_rates(const lag_arguments *at, double *rates)
{
    (void)at;
    (void)rates;
    return LAG_OK;
}

/* ---- a mass 1 on a circle of radius 1, g = 10, in Cartesian coordinates; the constraint stated twice ---- */

static lag_status circle_start(const lag_arguments *at, double *q, double *qd, double *z, double *u)
{
    (void)at;
    (void)z;
    (void)u;
    q[0] = 0.7;
    q[1] = 0.1; /* off the circle */
    qd[0] = qd[1] = 0.0;
    return LAG_OK;
}

static lag_status circle_position(const lag_arguments *at, double *phi, double *jacobian)
{
    const double *q = at->q;
    phi[0] = q[0] * q[0] + q[1] * q[1] - 1.0;
    phi[1] = 3.0 * phi[0];
    for (int i = 0; i < 2; ++i) {
        jacobian[i] = 2.0 * q[i];
        jacobian[2 + i] = 6.0 * q[i];
    }
    return LAG_OK;
}

static lag_status circle_velocity(const lag_arguments *at, double *residual, double *jacobian)
{
    const lag_status status = circle_position(at, residual, jacobian);
    residual[0] = jacobian[0] * at->qd[0] + jacobian[1] * at->qd[1];
    residual[1] = 3.0 * residual[0];
    return status;
}

static lag_status circle_mass(const lag_arguments *at, double *mass)
{
    (void)at;
    mass[0] = mass[3] = 1.0;
    mass[1] = mass[2] = 0.0;
    return LAG_OK;
}

static lag_status circle_dynamics(const lag_arguments *at, double *mass, double *force, double *jacobian, double *gamma)
{
    double phi[2];
    (void)circle_position(at, phi, jacobian);
    force[0] = 0.0;
    force[1] = -10.0;
    gamma[0] = -2.0 * (at->qd[0] * at->qd[0] + at->qd[1] * at->qd[1]);
    gamma[1] = 3.0 * gamma[0];
    return circle_mass(at, mass);
}

static lag_status circle_tangent(const lag_arguments *at, double *motion, double *rows)
{
    for (int i = 0; i < 2; ++i) {
        motion[i] = -2.0 * at->dq[i] * (at->lam[0] + 3.0 * at->lam[1]);
    }
    rows[0] = 2.0 * (at->dq[0] * at->qdd[0] + at->dq[1] * at->qdd[1]) + 4.0 * (at->qd[0] * at->dqd[0] + at->qd[1] * at->dqd[1]);
    rows[1] = 3.0 * rows[0];
    return LAG_OK;
}

/* The energy, and that the mass stays below y = 0.5. */
static lag_status circle_monitor(const lag_arguments *at, double *invariant, double *scale, double *assertion)
{
    invariant[0] = 0.5 * (at->qd[0] * at->qd[0] + at->qd[1] * at->qd[1]) + 10.0 * at->q[1];
    scale[0] = 10.0;
    assertion[0] = at->q[1] < 0.5 ? 1.0 : 0.0;
    return LAG_OK;
}

static const lag_slot CIRCLE_Q[2] = {{"x", "m", NULL}, {"y", "m", NULL}};
static const unsigned char BOTH[2] = {1, 1};

static const lag_model CIRCLE = {
    .version = LAG_MODEL_VERSION,
    .size = sizeof(lag_model),
    .name = "Circle",
    .nq = 2,
    .nc = 2,
    .ni = 1,
    .na = 1,
    .rank = 1,
    .coordinates = CIRCLE_Q,
    .position_level = BOTH,
    .context = &given,
    .prepare = no_preparation,
    .start = circle_start,
    .position_constraint = circle_position,
    .velocity_constraint = circle_velocity,
    .mass_matrix = circle_mass,
    .dynamics = circle_dynamics,
    .residual_tangent = circle_tangent,
    .state_derivative = no_rates,
    .state_derivative_tangent = no_rates,
    .monitor = circle_monitor,
};

/* Exactly the block that was asked for: the sanitizer sees one step beyond. */
static lag_run *place(const lag_model *model, const lag_run_options *options)
{
    void *block = malloc(lag_run_size(model, options));
    CHECK(block != NULL);
    return lag_run_place(block, model, options);
}

static double circle_gap(const double *x)
{
    const double gap = fabs(x[0] * x[0] + x[1] * x[1] - 1.0);
    return fmax(gap, fabs(2.0 * (x[0] * x[2] + x[1] * x[3])));
}

static void constraints_hold(const lag_method *method)
{
    static const double tolerance = 1e3;
    double times[201];
    double rows[201 * 4];
    for (int i = 0; i <= 200; ++i) {
        times[i] = (double)i / 20.0;
    }
    const lag_run_options options = {
        .tolerance = 1e-9, .method = method, .count = 201, .times = times, .rows = rows, .invariants.tolerance = &tolerance};
    lag_run *run = place(&CIRCLE, &options);
    CHECK(lag_run_begin(run, 0.0, NULL) == LAG_OK);
    CHECK(circle_gap(run->stepper.x) < 1e-11);
    CHECK_NEAR(rows[1] / rows[0], 0.1 / 0.7, 1e-4);
    CHECK(lag_run_to(run, 10.0, 0) == LAG_OK);
    CHECK(run->stepper.t == 10.0 && run->counts.row == 201);
    CHECK(run->projection.count > 10);
    for (size_t i = 0; i <= 200; ++i) {
        const double *x = rows + 4 * i;
        CHECK(circle_gap(x) < 1e-11);
        CHECK_NEAR(0.5 * (x[2] * x[2] + x[3] * x[3]) + 10.0 * (x[1] - rows[1]), 0.0, 2e-7);
    }
    CHECK(run->conditions.drift[0] < 2e-7);
    free(run);
}

static void what_is_violated_stops(void)
{
    static const double tolerance = 1e-6;
    static const double high[4] = {0.6, -0.8, 6.0, 4.5};
    const lag_run_options options = {.invariants.tolerance = &tolerance};
    lag_run *run = place(&CIRCLE, &options);
    CHECK(lag_run_begin(run, 0.0, high) == LAG_OK);
    CHECK(lag_run_to(run, 10.0, 0) == LAG_VIOLATED);
    CHECK(run->stepper.t > 0.1 && run->stepper.t < 1.0 && run->stepper.x[1] < 0.5);
    free(run);
}

/* Two runs in turns are what each is alone, to the bit. */
static void runs_do_not_know_of_each_other(void)
{
    static const double other[4] = {1.0, 0.0, 0.0, 1.0};
    const lag_run_options options = {.tolerance = 1e-7};
    lag_run *alone = place(&CIRCLE, &options);
    lag_run *first = place(&CIRCLE, &options);
    lag_run *second = place(&CIRCLE, &options);
    CHECK(lag_run_begin(alone, 0.0, NULL) == LAG_OK);
    CHECK(lag_run_begin(first, 0.0, NULL) == LAG_OK);
    CHECK(lag_run_begin(second, 0.0, other) == LAG_OK);
    for (int i = 1; i <= 5; ++i) {
        CHECK(lag_run_to(alone, 0.3 * i, 0) == LAG_OK);
    }
    for (int i = 1; i <= 5; ++i) {
        CHECK(lag_run_to(first, 0.3 * i, 0) == LAG_OK);
        CHECK(lag_run_to(second, 0.2 * i, 0) == LAG_OK);
    }
    CHECK(memcmp(alone->stepper.x, first->stepper.x, 4 * sizeof(double)) == 0);
    free(alone);
    free(first);
    free(second);
}

static void fixed_steps_stay_on_the_circle(void)
{
    lag_fixed_step *const steps[3] = {lag_rk4, lag_leapfrog, lag_ros2};
    const lag_run_options options = {0};
    for (int k = 0; k < 3; ++k) {
        double memory[4 * 4 + 4 * 4];
        CHECK(lag_fixed_memory(4) <= sizeof memory / sizeof memory[0]);
        lag_run *run = place(&CIRCLE, &options);
        CHECK(lag_run_begin(run, 0.0, NULL) == LAG_OK);
        for (int i = 0; i < 2000; ++i) {
            CHECK(lag_run_fixed(run, 0.005, steps[k], memory) == LAG_OK);
            CHECK(run->stepper.t == (double)(i + 1) / 200.0); /* not a sum */
        }
        CHECK(circle_gap(run->stepper.x) < 1e-8);
        free(run);
    }
}

/* Many lives of a run in the same memory: nothing is kept, nothing is lost. */
static void a_run_can_be_placed_again_and_again(void)
{
    static const double tolerance = 1e-6;
    const lag_run_options options = {.invariants.tolerance = &tolerance, .careful = 1};
    double first[4] = {0.0, 0.0, 0.0, 0.0};
    for (int i = 0; i < 1000; ++i) {
        lag_run *run = place(&CIRCLE, &options);
        CHECK(lag_run_begin(run, 0.0, NULL) == LAG_OK);
        CHECK(lag_run_to(run, 0.05, 0) == LAG_OK);
        if (i == 0) {
            memcpy(first, run->stepper.x, sizeof first);
        }
        CHECK(memcmp(first, run->stepper.x, sizeof first) == 0);
        free(run);
    }
}

/* ---- van der Pol's oscillator ---- */

static void stiffness_is_found(double epsilon, int stiff)
{
    const double p[1] = {epsilon};
    const lag_run_options options = {.p = p, .tolerance = 1e-6};
    lag_run *run = place(&OSCILLATOR, &options);
    CHECK(lag_run_begin(run, 0.0, NULL) == LAG_OK);
    CHECK(lag_run_to(run, 2.0, 0) == LAG_OK);
    (void)printf("epsilon %.0e: %zu steps, %zu evaluations, %zu Jacobians, %zu changes, now %s\n", epsilon, run->stepper.counts.steps,
        run->stepper.counts.evaluations, run->stepper.counts.jacobians, run->methods.changes, run->stepper.method->name);
    if (stiff) {
        CHECK(run->methods.changes > 0 && run->methods.change[0].implicit);
        CHECK_NEAR(run->stepper.x[0], 1.706167732170483, 1e-4);
        CHECK(run->stepper.counts.evaluations < 20000);
    } else {
        CHECK(run->methods.changes == 0);
    }
    free(run);
}

int main(void)
{
    constraints_hold(&lag_dop853);
    constraints_hold(&lag_radau);
    constraints_hold(NULL);
    what_is_violated_stops();
    runs_do_not_know_of_each_other();
    fixed_steps_stay_on_the_circle();
    a_run_can_be_placed_again_and_again();
    stiffness_is_found(1e-6, 1);
    stiffness_is_found(1.0, 0);
    (void)printf("run: ok\n");
    return EXIT_SUCCESS;
}
