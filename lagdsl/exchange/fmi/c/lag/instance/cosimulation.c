/*
 * Co-simulation: the integrators of the runtime, from one communication point to the next. Steps may end behind a
 * communication point; dense output gives the values at it, so communication points cost no steps. After an input has
 * jumped, the run goes back to the communication point and stops at the next one, because the input may jump there again.
 */
#include "lag/instance/instance_internal.h"

#include <math.h>
#include <string.h>

#include "lag/linalg/finite.h"
#include "lag/fixed.h"

/* Without a stop time, a step ends at most this many communication steps behind a communication point. */
static const double AHEAD = 1000.0;
/* The classical Runge-Kutta method wants h |lambda| to be less. */
static const double STABLE = 2.5;

/* Up to where the run knows the motion. */
static double reached(const lag_run *run)
{
    return run->half.open ? run->half.t : run->stepper.t;
}

/* The state at a time that the run has reached. */
static lag_status deliver(lag_instance *instance, double t)
{
    lag_run *run = instance->run;
    lag_status status = run->half.open ? lag_run_keep_past(run, t) : LAG_OK; /* inputs may change from here on */
    if (run->stepper.t == t) {
        memcpy(instance->x, run->stepper.x, lag_motion_size(instance->fmu->model) * sizeof(double));
    } else if (status == LAG_OK) {
        status = lag_run_inside(instance->run, t, instance->x);
    }
    instance->held.t = t;
    instance->values.known = 0;
    if (status == LAG_OK && !lag_finite(lag_motion_size(instance->fmu->model), instance->x)) {
        status = LAG_NOT_FINITE;
    }
    return status == LAG_OK ? lag_run_count_turns(instance->run, t, instance->x) : status;
}

/* One step of the integrator; where it fails beyond `end`, one that stays before. */
static lag_status step(lag_instance *instance, double end, double *far)
{
    lag_run *run = instance->run;
    lag_status status = lag_run_step(run, *far);
    if (status != LAG_OK && *far > end) {
        *far = end;
        run->stepper.h = end - run->stepper.t;
        status = lag_run_step(run, *far);
    }
    return status;
}

/*
 * Carries out the rest of the last step. One that was cut short at this communication point may have ended on a singular position, which is
 * looked at where a run begins only.
 */
static lag_status finish(lag_instance *instance, double far)
{
    lag_run *run = instance->run;
    const int cut = run->half.open && run->stepper.t == instance->held.t && lag_run_crosses(run->motion.model, &run->options);
    lag_status status = lag_run_finish(run, far);
    return status == LAG_OK && cut ? lag_run_restart(run, far) : status;
}

/* True if the step must stop at the time up to which the motion is known, because event mode has work there. */
static int stops_here(const lag_instance *instance, double end, int stops)
{
    const lag_run *run = instance->run;
    const double t = reached(run);
    return (stops & LAG_STOP_EVENTS) != 0 && t > instance->held.t && t <= end && ((run->half.open && run->half.own) || lag_run_due(run, t));
}

/* From where the run is to `end`, or to where it has to stop before; *event: event mode has something to do there. */
static lag_status advance(lag_instance *instance, double end, double far, int stops, int *event)
{
    lag_run *run = instance->run;
    const int once = (stops & LAG_STOP_STEPS) != 0;
    lag_status status = LAG_OK;
    *event = stops_here(instance, end, stops);
    for (double k = 0.0; status == LAG_OK && !*event && reached(run) < end && !(once && k > 0.0); k += 1.0) {
        status = k < LAG_MOST_STEPS ? finish(instance, far) : LAG_TOO_LONG;
        status = status == LAG_OK ? step(instance, end, &far) : status;
        *event = status == LAG_OK && stops_here(instance, end, stops);
        if (status == LAG_OK && instance->fmu->model->nturn > 0 && reached(run) < end) {
            status = deliver(instance, reached(run));
        }
    }
    return status == LAG_OK ? deliver(instance, fmin(reached(run), end)) : status;
}

/*
 * Steps of one length, none longer than the option wants it. The exact Jacobian decides once whether they are too long for the explicit method, so that
 * all steps cost the same.
 */
static lag_status advance_by_fixed_steps(lag_instance *instance, double end)
{
    lag_run *run = instance->run;
    lag_held *held = &instance->held;
    const double begun = held->t;
    const double count = fmax(1.0, ceil((end - begun) / held->step - LAG_SAME_TICK));
    lag_status status = count <= LAG_MOST_STEPS ? LAG_OK : LAG_TOO_LONG;
    if (held->implicit < 0) {
        held->implicit = held->step * lag_stiffness_fastest(&run->methods.stiffness, &run->stepper) > STABLE;
    }
    for (double k = 0.0; k < count && status == LAG_OK; k += 1.0) {
        status = lag_run_fixed(run, (end - begun) / count, held->implicit ? lag_ros2 : lag_rk4, instance->scratch);
        run->stepper.t = status == LAG_OK && k + 1.0 == count ? end : run->stepper.t;
        status = status == LAG_OK ? deliver(instance, run->stepper.t) : status;
        status = status == LAG_OK ? lag_instance_assert(instance) : status;
    }
    return status;
}

lag_status lag_instance_step(lag_instance *instance, double h, int stops, lag_progress *told)
{
    lag_held *held = &instance->held;
    lag_run *run = instance->run;
    lag_status status = lag_instance_begin(instance);
    /* times of importers are sums: a tick at the end of a step has the inputs of the next one, whatever the sum has lost */
    const double end = lag_instants_same(&run->instants, held->t + h);
    const double stop = held->stop < (double)INFINITY ? held->stop : end + AHEAD * (end - held->t);
    const double far = held->jumped ? end : fmax(end, stop); /* the latest time at which a step may end */
    *told = (lag_progress){.t = held->t};
    /* after the importer has set a value, the run goes back to the communication point, and on from there */
    if (status == LAG_OK && held->jumped && !held->stopped) {
        lag_instance_chain_inputs(instance);
        status = lag_instance_follow_inputs(instance);
        if (status != LAG_OK) {
            return status;
        }
        status = lag_instance_carry_out(instance);
        status = status == LAG_OK && !held->stopped ? lag_run_restart(run, far) : status;
        held->jumped = status != LAG_OK;
    }
    if (status == LAG_OK && !held->stopped && end > held->t) {
        status = held->step > 0.0 ? advance_by_fixed_steps(instance, end) : advance(instance, end, far, stops, &told->event);
        /* at the stop no step follows that would begin with what happens there: clocks tick, as at the end of a run */
        if (status == LAG_OK && !told->event && held->t == end && end + LAG_SAME_TICK * h >= held->stop) {
            status = finish(instance, run->stepper.t);
            status = status == LAG_OK ? lag_run_ticks(run) : status;
            status = status == LAG_OK ? deliver(instance, run->stepper.t) : status;
        }
    }
    if (status != LAG_OK) {
        const lag_status at = run->stepper.t <= end ? deliver(instance, run->stepper.t) : LAG_OK;
        held->jumped = 1;
        held->stopped = held->stopped || status == LAG_STOPPED;
        status = status == LAG_STOPPED ? at : status;
    }
    told->t = held->t;
    told->terminate = held->stopped;
    told->early = held->t < end;
    return lag_instance_judge(instance, status);
}
