/* A session is a run: same rows, to the bit; it begins again with other parameters; inputs may jump. */
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
    rows_are_those_of_a_run();
    another_parameter_is_another_motion();
    events_are_those_of_the_call();
    puts("session: ok");
    return EXIT_SUCCESS;
}
