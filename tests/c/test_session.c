/* A session is a run: same rows, to the bit; it begins again with other parameters; inputs may jump; derivatives are those of a closed form. */
#include <math.h>
#include <string.h>

#include "check.h"
#include "lag/session.h"
#include "machine.h"
#include "oscillator.h"

static lag_session *open(const lag_model *model, double tolerance)
{
    void *block = malloc(lag_session_size(model, NULL));
    CHECK(block != NULL);
    memset(block, 0xa5, lag_session_size(model, NULL));
    return lag_session_place(block, model, NULL, tolerance, 1.0);
}

static void rows_are_those_of_a_run(void)
{
    const double lasting[1] = {0.0};
    const lag_run_options options = {.tolerance = 1e-8, .length = 1.0, .careful = 2, .lasting.rows = lasting};
    lag_session *session = open(&MACHINE, 1e-8);
    lag_run *run = lag_run_place(malloc(lag_run_size(&MACHINE, &options)), &MACHINE, &options);
    CHECK(lag_session_begin(session, 0.0) == LAG_OK && lag_run_begin(run, 0.0, NULL) == LAG_OK);
    for (int i = 1; i <= 20; ++i) {
        CHECK(lag_session_to(session, 0.05 * i, 0) == LAG_OK && lag_run_to(run, 0.05 * i, 0) == LAG_OK);
        const double *row = lag_session_row(session);
        CHECK(row[0] == run->stepper.t);
        CHECK(memcmp(row + 1, run->stepper.x, lag_motion_size(&MACHINE) * sizeof *row) == 0);
    }
    CHECK(lag_session_width(session) == lag_results_width(&MACHINE));
    free(run);
    free(session);
}

static void another_parameter_is_another_motion(void)
{
    lag_session *session = open(&OSCILLATOR, 1e-6);
    CHECK(lag_session_begin(session, 0.0) == LAG_OK && lag_session_to(session, 0.5, 0) == LAG_OK);
    const double first = lag_session_row(session)[1];
    lag_session_parameters(session)[0] *= 2.0;
    CHECK(lag_session_begin(session, 0.0) == LAG_OK && lag_session_to(session, 0.5, 0) == LAG_OK);
    CHECK(lag_session_row(session)[1] != first);
    lag_session_parameters(session)[0] /= 2.0;
    CHECK(lag_session_begin(session, 0.0) == LAG_OK && lag_session_to(session, 0.5, 0) == LAG_OK);
    CHECK(lag_session_row(session)[1] == first);
    free(session);
}

/* z' = -p z + u. */
static lag_status decay(const lag_arguments *at, double *rates)
{
    rates[0] = -at->p[0] * at->z[0] + at->u[0];
    return LAG_OK;
}

static lag_status decay_tangent(const lag_arguments *at, double *rates)
{
    rates[0] = -at->dp[0] * at->z[0] - at->p[0] * at->dz[0] + at->du[0];
    return LAG_OK;
}

static lag_status decay_start(const lag_arguments *at, double *q, double *qd, double *z, double *u)
{
    (void)at;
    (void)q;
    (void)qd;
    z[0] = 1.0;
    u[0] = 0.0;
    return LAG_OK;
}

static void derivatives_are_those_of_the_closed_form(void)
{
    static const lag_slot z[1] = {{"z", "1", NULL}}, p[1] = {{"p", "1/s", NULL}}, u[1] = {{"u", "1/s", NULL}};
    static const double defaults[1] = {2.0};
    const unsigned which[2] = {1, 0};
    lag_model model = OSCILLATOR;
    model.nz = model.np = model.nu = 1;
    model.states = z;
    model.parameters = p;
    model.inputs = u;
    model.defaults = defaults;
    model.start = decay_start;
    model.state_derivative = decay;
    model.state_derivative_tangent = decay_tangent;
    lag_session *session = open(&model, 1e-11);
    void *block = malloc(lag_session_sensitivities_size(&model, 2));
    CHECK(lag_session_derivatives(session) == NULL);
    lag_session_differentiate(session, block, 2, which);
    for (int again = 0; again < 2; ++again) {
        CHECK(lag_session_begin(session, 0.0) == LAG_OK && lag_session_to(session, 0.5, 0) == LAG_OK);
        const double *found = lag_session_derivatives(session);
        CHECK(found != NULL && found[0] == 0.0);
        CHECK_NEAR(found[1], (1.0 - exp(-1.0)) / 2.0, 1e-10);
        CHECK_NEAR(found[lag_session_width(session) + 1], -0.5 * exp(-1.0), 1e-10);
    }
    free(block);
    free(session);
}

/* The ball strikes the floor after sqrt(2 h/g); the controller looks every 0.05 s. A call tells what happened during it alone. */
static void events_are_those_of_the_call(void)
{
    lag_session *session = open(&MACHINE, 1e-8);
    const double *events = lag_session_events(session);
    CHECK(lag_session_begin(session, 0.0) == LAG_OK && lag_session_to(session, 0.04, 0) == LAG_OK);
    CHECK(events[0] == 0.0);
    CHECK(lag_session_to(session, 0.095, 0) == LAG_OK);
    int impacts = 0;
    int ticks = 0;
    for (int k = 0; k < (int)events[0]; ++k) {
        const double *event = events + 1 + 3 * k;
        impacts += event[1] == LAG_IMPACT && fabs(event[0] - sqrt(2.0 * 0.04 / 10.0)) < 1e-6 && event[2] == 0.0;
        ticks += event[1] == LAG_TICK && fabs(event[0] - 0.05) < 1e-12;
    }
    CHECK(impacts == 1 && ticks == 1);
    CHECK(lag_session_begin(session, 0.0) == LAG_OK && lag_session_to(session, 0.04, 0) == LAG_OK && events[0] == 0.0);
    free(session);
}

int main(void)
{
    derivatives_are_those_of_the_closed_form();
    rows_are_those_of_a_run();
    another_parameter_is_another_motion();
    events_are_those_of_the_call();
    puts("session: ok");
    return EXIT_SUCCESS;
}
