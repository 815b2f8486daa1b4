/* Steps of fixed length, at a bounded cost. */
#include <string.h>

#include "lag/fixed.h"
#include "lag/run.h"

/* A relation that has changed was zero less than so many steps ago: one, and round-off. */
static const double AGO = 1.5;

/* Carries out the events of a step of fixed length at its end. */
static lag_status follow_fixed(lag_run *run, double h)
{
    lag_status status = LAG_OK;
    if (run->motion.model->event == NULL) {
        return status;
    }
    lag_instants_after(&run->instants, run->stepper.t, h);
    run->instants.contacts.flight = h;
    run->instants.refraction.passed = AGO * h;
    run->instants.iteration.began = run->stepper.t_before;
    run->instants.iteration.start = run->stepper.x_before;
    status = lag_zero_crossing_look(&run->crossings, run->stepper.t, run->stepper.x);
    if (status == LAG_EVENT_PENDING) {
        status = lag_run_event(run, h, run->crossings.changed);
    }
    run->instants.contacts.flight = 0.0;
    status = status == LAG_OK ? lag_run_ticks(run) : status;
    run->instants.refraction.passed = 0.0;
    run->instants.iteration.start = NULL;
    return status;
}

/* The end of a step of length h from t; of one after the other, as a whole number of steps from the first. */
static double end_of_step(lag_clock *pace, double t, double h)
{
    if (pace->period != h || lag_clock_instant(pace, pace->next) != t) {
        *pace = lag_clock_of(t, h);
    }
    ++pace->next;
    return lag_clock_instant(pace, pace->next);
}

lag_status lag_run_fixed(lag_run *run, double h, lag_status (*step)(const lag_ode *, size_t, double, double, double *, double *),
    double *memory)
{
    lag_stepper *s = &run->stepper;
    const unsigned iterations = run->projection.iterations;
    int moved = 0;
    lag_status status = run->motion.model->nu > 0 ? lag_run_jump(run) : LAG_OK;
    status = status == LAG_OK ? lag_zero_crossing_begin(&run->crossings, s->t, s->x) : status;
    if (status != LAG_OK) {
        return status;
    }
    memcpy(s->x_before, s->x, s->ode->size * sizeof(double));
    status = step(s->ode, run->motion.model->nq, s->t, h, s->x, memory);
    if (status == LAG_OK) {
        s->t_before = s->t;
        s->t = end_of_step(&run->pace, s->t, h);
        run->projection.iterations = 2;
        (void)lag_projection_apply(&run->projection, s->t, s->x, &moved);
        run->projection.iterations = iterations;
    }
    return status == LAG_OK ? follow_fixed(run, h) : status;
}
