/* Steps of fixed length, at a bounded cost: one without events; else pieces of it, from event to event. */
#include <math.h>
#include <string.h>

#include "lag/fixed.h"
#include "lag/run.h"

/* A step is cut into so many pieces at most. */
enum { MOST_PIECES = 200 };

/* The method that takes such steps and has states within them. */
static const lag_method *method_of(lag_fixed_step *step)
{
    return step == lag_leapfrog ? &lag_steps_leapfrog : step == lag_ros2 ? &lag_steps_ros2 : &lag_steps_rk4;
}

/* One step to `end`, which keeps what it began with. LAG_EVENT_PENDING: something has changed there. */
static lag_status step_once(lag_run *run, double h, double end, lag_fixed_step *step, double *memory)
{
    lag_stepper *s = &run->stepper;
    const unsigned iterations = run->projection.iterations;
    int moved = 0;
    s->t_before = s->t;
    memcpy(s->x_before, s->x, s->ode->size * sizeof(double));
    const lag_status status = step(s->ode, s->t, h, s->x, memory);
    if (status != LAG_OK) {
        return status;
    }
    s->t = end;
    run->projection.iterations = 2;
    (void)lag_projection_apply(&run->projection, s->t, s->x, &moved);
    run->projection.iterations = iterations;
    return run->motion.model->event != NULL ? lag_guards_detect(&run->guards, s->t, s->x) : LAG_OK;
}

/* From where the run is to `end` in pieces that end where something happens. */
static lag_status run_in_pieces(lag_run *run, double h, double end, lag_fixed_step *step)
{
    const lag_method *chosen = run->options.method;
    const lag_method *method = run->stepper.method;
    run->options.method = run->stepper.method = method_of(step);
    run->stepper.h_fixed = run->stepper.h = h;
    run->instants.contacts.flight = h;
    const lag_status status = lag_run_to(run, end, MOST_PIECES);
    run->instants.contacts.flight = 0.0;
    run->options.method = chosen;
    run->stepper.method = method;
    return status;
}

double lag_run_end_of_step(lag_run *run, double h)
{
    lag_clock *pace = &run->pace;
    if (pace->period != h || lag_clock_instant(pace, pace->next) != run->stepper.t) {
        *pace = lag_clock_of(run->stepper.t, h);
    }
    ++pace->next;
    return lag_clock_instant(pace, pace->next);
}

lag_status lag_run_fixed(lag_run *run, double h, lag_fixed_step *step, double *memory)
{
    lag_stepper *s = &run->stepper;
    lag_status status = run->motion.model->nu > 0 ? lag_run_jump(run) : LAG_OK;
    status = status == LAG_OK ? lag_guards_begin(&run->guards, s->t, s->x) : status;
    if (status != LAG_OK) {
        return status;
    }
    const double end = lag_run_end_of_step(run, h);
    run->motion.until = end; /* inputs that jump there do so as the next step begins */
    status = run->motion.model->ndelay > 0 || lag_instants_next(&run->instants) < end - LAG_SAME_TICK * h ? LAG_EVENT_PENDING : step_once(run, h, end, step, memory);
    if (status == LAG_EVENT_PENDING) {
        if (s->t == end) {
            s->t = s->t_before;
            memcpy(s->x, s->x_before, s->ode->size * sizeof(double));
        }
        status = run_in_pieces(run, h, end, step);
    }
    lag_instants_after(&run->instants, s->t, h);
    status = status == LAG_OK ? lag_run_ticks(run) : status;
    run->motion.until = (double)INFINITY;
    return status;
}
