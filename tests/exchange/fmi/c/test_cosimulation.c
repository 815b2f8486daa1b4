/* Co-simulation of an oscillator by its closed form: communication steps, inputs, parameters, fixed steps, failures. */
#include "instances.h"
#include "oscillator.h"

#include "lag/instance/instance_internal.h"

static const double TOLERANCE = 1e-9;
/* Largest error of a motion of a few seconds. */
static const double OFF = 1e-7;

/* Steps that the integrator takes for itself. */
static size_t steps_alone(double stop)
{
    const lag_run_options options = {.tolerance = TOLERANCE, .sizes = {OSC_GROUP, OSC_SIZES, OSC_CAPS, NULL}};
    lag_run *run = lag_run_place(malloc(lag_run_size(&OSC, &options)), &OSC, &options);
    CHECK(lag_run_begin(run, 0.0, OSC_STATE) == LAG_OK);
    CHECK(lag_run_to(run, stop, 0) == LAG_OK);
    const size_t count = run->stepper.counts.steps;
    free(run);
    return count;
}

/* Communication steps of any length are no steps of the integrator. */
static void steps(void)
{
    unsigned long long seed = 1;
    lag_instance *one = begun(&OSC_FMU, 0.0, 10.0, TOLERANCE);
    lag_progress told;
    double t = 0.0;
    unsigned count = 0;
    while (t < 9.9) {
        const double h = 1e-3 + 0.02 * fabs(draw(&seed));
        CHECK_OK(one, lag_instance_step(one, h, 0, &told));
        t = t + h;
        ++count;
        CHECK(told.t == t && get(one, OSC_TIME) == t && !told.event && !told.early);
        CHECK_NEAR(get(one, OSC_YQ), cos(2.0 * t), OFF);
        CHECK_NEAR(get(one, OSC_QD), -2.0 * sin(2.0 * t), OFF);
        CHECK_NEAR(get(one, OSC_YA), -4.0 * cos(2.0 * t), 4.0 * OFF);
        CHECK_NEAR(get(one, OSC_Z), exp(-t), OFF);
        CHECK_NEAR(get(one, OSC_ENERGY), 2.0, 4.0 * OFF);
    }
    CHECK(count > 300 && one->run->stepper.counts.steps <= steps_alone(t) + 2);
    double both[2];
    CHECK_OK(one, lag_instance_get(one, OSC_BOTH, both));
    CHECK(both[0] == get(one, OSC_YQ) && both[1] == get(one, OSC_YA));
    free(one);
}

/* An input jumps at t = 1.3: before and behind it the motion is about another center. */
static void jump(void)
{
    lag_instance *one = begun(&OSC_FMU, 0.0, 10.0, TOLERANCE);
    step_to(one, 1.3, 13);
    set(one, OSC_U, 2.0);
    CHECK_NEAR(get(one, OSC_YA), 2.0 - 4.0 * cos(2.6), 4.0 * OFF);
    const double q = cos(2.6) - 0.5;
    const double qd = -2.0 * sin(2.6);
    for (unsigned k = 1; k <= 20; ++k) {
        const double s = 0.1 * k;
        step_to(one, 1.3 + s, 1);
        CHECK_NEAR(get(one, OSC_Q), 0.5 + q * cos(2.0 * s) + 0.5 * qd * sin(2.0 * s), OFF);
    }
    free(one);
}

/* u = 1 - t + t^2/2 + t^3/3: from rest about the particular solution. */
static double particular(double t, int order)
{
    const double u[4] = {1.0 - t + 0.5 * t * t + t * t * t / 3.0, -1.0 + t + t * t, 1.0 + 2.0 * t, 2.0};
    return order == 0 ? u[0] / 4.0 - u[2] / 16.0 : u[1] / 4.0 - u[3] / 16.0;
}

static double forced(double t)
{
    const double a = 1.0 - particular(0.0, 0);
    const double b = -0.5 * particular(0.0, 1);
    return particular(t, 0) + a * cos(2.0 * t) + b * sin(2.0 * t);
}

static void polynomial(void)
{
    const double derivatives[3] = {-1.0, 1.0, 2.0};
    lag_instance *one = begun(&OSC_FMU, 0.0, 10.0, TOLERANCE);
    set(one, OSC_U, 1.0);
    for (int order = 1; order <= 3; ++order) {
        CHECK_OK(one, lag_instance_set_input(one, OSC_U, order, &derivatives[order - 1]));
    }
    for (unsigned k = 1; k <= 100; ++k) {
        const double t = 0.02 * k;
        step_to(one, t, 1);
        CHECK_NEAR(get(one, OSC_Q), forced(t), OFF);
        CHECK_NEAR(get(one, OSC_U), 1.0 - t + 0.5 * t * t + t * t * t / 3.0, 1e-13);
    }
    const size_t before = one->run->stepper.counts.steps;
    CHECK(before <= steps_alone(2.0) + 10);
    set(one, OSC_U, get(one, OSC_U)); /* no jump */
    step_to(one, 2.0001, 1);
    CHECK(one->run->stepper.counts.steps <= before + 1);
    CHECK(lag_instance_set_input(one, OSC_U, 4, derivatives) == LAG_MISSING);
    free(one);
}

/* An input whose derivative is an input, too, goes as that says. */
static void chain(void)
{
    static const size_t rates[2] = {1, 2};
    lag_fmu fmu = OSC_FMU;
    fmu.inputs.rates = rates;
    lag_instance *one = begun(&fmu, 0.0, 10.0, TOLERANCE);
    set(one, OSC_U, 1.0);
    set(one, OSC_UD, -0.5);
    step_to(one, 1.0, 1); /* from q = 1: (u - u'/2 sin 2t ...)/4 */
    const double a = 1.0 - 0.25;
    const double b = 0.5 * 0.125;
    CHECK_NEAR(get(one, OSC_Q), 0.25 * (1.0 - 0.5) + a * cos(2.0) + b * sin(2.0), OFF);
    CHECK_NEAR(get(one, OSC_U), 0.5, 1e-15);
    free(one);
}

static void rates_of_outputs(void)
{
    lag_instance *one = begun(&OSC_FMU, 0.0, 10.0, 1e-12);
    const double slope = 0.7;
    double rate = 0.0;
    set(one, OSC_U, 0.3);
    CHECK_OK(one, lag_instance_set_input(one, OSC_U, 1, &slope));
    step_to(one, 1.7, 5);
    const double qd = get(one, OSC_QD);
    const double q = get(one, OSC_Q);
    CHECK_OK(one, lag_instance_get_output_derivative(one, OSC_YQ, 1, &rate));
    CHECK_NEAR(rate, qd, 1e-9);
    CHECK_OK(one, lag_instance_get_output_derivative(one, OSC_YA, 1, &rate));
    CHECK_NEAR(rate, slope - 4.0 * qd, 1e-9);
    CHECK(get(one, OSC_TIME) == 1.7 && get(one, OSC_Q) == q);
    CHECK(lag_instance_get_output_derivative(one, OSC_YQ, 2, &rate) == LAG_MISSING);
    free(one);
}

/* Another parameter from t = 1 on, and a state that is set. */
static void tunable(void)
{
    lag_instance *one = begun(&OSC_FMU, 0.0, 10.0, TOLERANCE);
    step_to(one, 1.0, 10);
    const double q = get(one, OSC_Q);
    const double qd = get(one, OSC_QD);
    set(one, OSC_K, 9.0);
    CHECK_NEAR(get(one, OSC_YA), -9.0 * q, 1e-14);
    step_to(one, 1.5, 3);
    CHECK_NEAR(get(one, OSC_Q), q * cos(1.5) + qd * sin(1.5) / 3.0, OFF);
    set(one, OSC_Q, 2.0);
    set(one, OSC_QD, 0.0);
    step_to(one, 2.5, 7);
    CHECK_NEAR(get(one, OSC_Q), 2.0 * cos(3.0), 2.0 * OFF);
    free(one);
}

/* Starts follow the parameters, those that are set stay; another time to begin; all over again in the same block. */
static void starts(void)
{
    lag_instance *one = placed(&OSC_FMU, 5.0, 10.0, 0.0);
    set(one, OSC_K, 16.0);
    CHECK(get(one, OSC_Q) == 0.25 && get(one, OSC_TIME) == 5.0);
    set(one, OSC_K, 8.0);
    set(one, OSC_QD, 0.5);
    CHECK(get(one, OSC_Q) == 0.5 && get(one, OSC_QD) == 0.5 && get(one, OSC_QDD) == -4.0);
    begin(one);
    step_to(one, 6.0, 10);
    const double w = sqrt(8.0);
    CHECK_NEAR(get(one, OSC_Q), 0.5 * cos(w) + 0.5 * sin(w) / w, OFF);
    one = lag_instance_place(one, &OSC_FMU);
    lag_instance_setup(one, LAG_CO_SIMULATION, 0.0, 10.0, 0.0);
    begin(one);
    CHECK(get(one, OSC_Q) == 1.0 && get(one, OSC_K) == 4.0);
    free(one);
}

/* Steps keep to a hundredth of a tolerance that is coarser than the experiment's; importers of states get what they gave. */
static void tolerances(void)
{
    const double own = OSC_FMU.experiment.tolerance;
    const double given[] = {0.0, 1e-11, own, 10.0 * own, 1e-4, 1e3};
    const double kept[] = {own, 1e-11, own, own, 1e-6, 1e-3};
    for (unsigned i = 0; i < sizeof given / sizeof *given; ++i) {
        lag_instance *one = begun(&OSC_FMU, 0.0, 10.0, given[i]);
        CHECK_NEAR(one->run->options.tolerance / kept[i], 1.0, 1e-12);
        free(one);
    }
    lag_instance *one = begun(&OSC_FMU, 0.0, 10.0, 1e-4);
    step_to(one, 10.0, 100);
    CHECK_NEAR(get(one, OSC_Q), cos(20.0), 1e-4);
    CHECK(one->run->stepper.counts.steps < steps_alone(10.0));
    lag_instance_setup(one, LAG_MODEL_EXCHANGE, 0.0, 10.0, 1e-4);
    CHECK(one->run->options.tolerance == 1e-4);
    free(one);
}

static double end_of_fixed(double length)
{
    lag_instance *one = begun(&OSC_FMU, 0.0, 10.0, TOLERANCE);
    set(one, OSC_STEP, length);
    step_to(one, 2.0, 8); /* 0.25 s each: no whole number of steps */
    CHECK(get(one, OSC_TIME) == 2.0);
    const double error = get(one, OSC_Q) - cos(4.0);
    free(one);
    return fabs(error);
}

static void fixed(void)
{
    const double order = log2(end_of_fixed(0.0625) / end_of_fixed(0.03125));
    CHECK(order > 3.7 && order < 4.3);
    lag_instance *one = placed(&OSC_FMU, 0.0, 10.0, TOLERANCE);
    set(one, OSC_K, 4e6); /* 0.05 s are sixteen turns in each step: explicit steps would run away */
    begin(one);
    set(one, OSC_STEP, 0.05);
    step_to(one, 5.0, 100);
    CHECK(fabs(get(one, OSC_Q)) < 1e-6);
    CHECK_NEAR(get(one, OSC_Z), exp(-5.0), 1e-4);
    free(one);
    CHECK_NEAR(end_of_fixed(0.24), end_of_fixed(0.125), 1e-15); /* both are two steps */
}

static void refused(void)
{
    lag_instance *one = begun(&OSC_FMU, 0.0, 10.0, TOLERANCE);
    const double value = 0.0;
    lag_progress told;
    step_to(one, 0.5, 5);
    CHECK(lag_instance_set(one, OSC_YQ, &value) == LAG_MISSING);
    set(one, OSC_STEP, 1e-9);
    CHECK(lag_instance_step(one, 0.1, 0, &told) == LAG_TOO_LONG && told.t == 0.5);
    set(one, OSC_STEP, 0.0);
    set(one, OSC_U, 20.0); /* towards q = 5 */
    CHECK(lag_instance_step(one, 3.0, 0, &told) == LAG_VIOLATED);
    CHECK(strstr(lag_instance_message(one), "q is too large") != NULL);
    CHECK(told.early && told.t > 0.5 && told.t < 3.5 && told.t == get(one, OSC_TIME) && get(one, OSC_Q) < 3.0);
    set(one, OSC_U, 0.0); /* stopped by force it goes on */
    set(one, OSC_QD, 0.0);
    CHECK_OK(one, lag_instance_step(one, 0.01, 0, &told));
    free(one);
}

int main(void)
{
    steps();
    jump();
    polynomial();
    chain();
    rates_of_outputs();
    tunable();
    starts();
    tolerances();
    fixed();
    refused();
    (void)printf("cosimulation: ok\n");
    return EXIT_SUCCESS;
}
