/* Event mode: finds what has changed at the present state, and carries it out by the rules of the run. */
#include "lag/instance/instance_internal.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "lag/linalg/arena.h"

/* An instant that lies so many roundings of the time behind the present is now. */
static const double ROUNDINGS = 64.0;
/* Importers find events so late at most, as a part of the experiment. */
static const double LATE = 1e-9;

/*
 * Guards that have left, flagged in `left`, beside those that are flagged. In co-simulation the run tells them. In model exchange the importer has led them to
 * the other side, and others stay, however far behind zero; *flies: contacts among them were clear of their dead bands before; what the others do is rest.
 */
static lag_status find_left(lag_instance *instance, double t, double *left, int *flies)
{
    const lag_model *model = instance->fmu->model;
    lag_guards *guards = &instance->run->guards;
    const int exchanged = instance->held.exchanged;
    const size_t relations = model->nindicator;
    const size_t count = lag_guard_count(model);
    if (exchanged && relations > 0) {
        lag_noise_find(guards->noise, t, instance->x); /* where the importer began, numbers may have been zero */
    }
    lag_status status = count > 0 ? lag_guards_detect(guards, t, instance->x) : LAG_OK;
    for (size_t i = 0; i < count && (status == LAG_OK || status == LAG_EVENT_PENDING); ++i) {
        const int leaves = exchanged ? lag_instance_leaves(instance, i) : guards->changed[i] != 0.0;
        const double behind = i < relations ? fmax(0.0, -guards->value[i]) : 0.0;
        left[i] = left[i] != 0.0 || leaves;
        *flies = *flies || (i >= relations && i < relations + model->ncontact && left[i] != 0.0 && lag_instance_is_armed(instance, i));
        guards->depth[i] = !exchanged ? guards->depth[i] : left[i] != 0.0 ? 0.0 : behind;
    }
    return status == LAG_EVENT_PENDING ? LAG_OK : status;
}

/* The next instant that is known ahead; the stop, if it lies behind that by round-off. */
static double next_instant(const lag_instance *instance)
{
    const lag_instants *instants = &instance->run->instants;
    if (instance->fmu->model->event == NULL) {
        return (double)INFINITY;
    }
    const double next = lag_instants_next(instants);
    return next > instance->held.stop && lag_instants_due(instants, instance->held.stop) ? instance->held.stop : next;
}

/* The present, or an instant before the end that lies so shortly behind it that an importer could not go there by a step. */
static double present(const lag_instance *instance)
{
    const double t = instance->held.t;
    const double next = next_instant(instance);
    const double same = ROUNDINGS * DBL_EPSILON * fmax(fabs(t), instance->run->instants.contacts.length);
    return t < instance->held.stop && next - t <= same ? fmax(t, next) : t;
}

/*
 * Places the run at time t and the present state and moves it onto the constraints down to round-off: a residual rate would act as an
 * impact, and a residual gap would not be zero when its contact opens. If the run has located an event, it goes back to that
 * event.
 */
static lag_status place(lag_instance *instance, double t, int located)
{
    lag_run *run = instance->run;
    int moved = 0;
    lag_status status = located ? lag_run_back(run, t) : LAG_OK;
    if (status == LAG_OK) {
        const double h = located ? run->half.next : run->stepper.h;
        status = lag_run_move(run, t, located ? run->stepper.x : instance->x, h);
    }
    if (status == LAG_OK) {
        status = lag_instance_balance_inputs(instance);
    }
    if (status == LAG_OK && lag_projection_exact(&run->projection, t, run->stepper.x, &moved) != LAG_OK) {
        status = lag_projection_apply(&run->projection, t, run->stepper.x, &moved);
    }
    if (status == LAG_OK) {
        memcpy(instance->x, run->stepper.x, lag_instance_order(instance) * sizeof(double));
    }
    return status;
}

lag_status lag_instance_carry_out(lag_instance *instance)
{
    lag_held *held = &instance->held;
    lag_run *run = instance->run;
    const int located = run->half.open && run->half.own && run->half.t == held->t;
    const double t = located ? held->t : present(instance);
    const double h = located ? run->half.length : LAG_SHORT_TIME * fmax(run->instants.contacts.length, fabs(t));
    const size_t count = lag_guard_count(instance->fmu->model);
    int any = 0;
    int flies = !held->exchanged;
    instance->values.known = 0;
    held->jumped = 1;
    held->tied = 0;
    lag_fill(located ? 0 : count, 0.0, run->half.pending);
    /* As the importer led them, and after inputs have jumped: a projection moves values, too. */
    lag_status status = held->exchanged ? find_left(instance, t, run->half.pending, &flies) : LAG_OK;
    status = status == LAG_OK ? place(instance, t, located) : status;
    status = status == LAG_OK ? find_left(instance, t, run->half.pending, &flies) : status;
    any = lag_any(count, run->half.pending);
    if (status == LAG_OK && !any && instance->fmu->model->event != NULL) {
        status = lag_event_iteration_conditions(&run->instants.iteration, t, instance->x, &any);
    }
    if (status == LAG_OK && any) {
        run->instants.contacts.flight = flies ? 0.0 : (double)INFINITY;
        run->instants.late = held->exchanged ? LATE * run->instants.contacts.length : 0.0;
        status = lag_run_instant(run, &(lag_cause){lag_run_due(run, t) ? LAG_CAUSE_TIME : LAG_CAUSE_GUARDS, h, run->half.pending});
        run->instants.contacts.flight = run->instants.late = 0.0;
    }
    status = status == LAG_OK ? lag_run_ticks(run) : status;
    if (status == LAG_OK || status == LAG_STOPPED) {
        memcpy(instance->x, run->stepper.x, lag_instance_order(instance) * sizeof(double));
        lag_instance_note_stop(instance, status);
        status = lag_instance_arm(instance);
    }
    if (status == LAG_OK) {
        status = lag_run_count_turns(instance->run, held->t, instance->x);
    }
    return lag_instance_judge(instance, status);
}

lag_status lag_instance_enter_events(lag_instance *instance)
{
    instance->held.entered = 1;
    return LAG_OK;
}

lag_status lag_instance_update(lag_instance *instance, lag_update *told)
{
    lag_held *held = &instance->held;
    *told = (lag_update){.next = (double)INFINITY};
    lag_status status = lag_instance_begin(instance);
    status = status == LAG_OK ? lag_instance_ready(instance) : status;
    status = status == LAG_OK ? lag_instance_follow_inputs(instance) : status;
    if (status == LAG_OK && (held->entered || held->jumped)) {
        held->entered = 0;
        memcpy(instance->scratch.point, instance->x, lag_instance_order(instance) * sizeof(double));
        status = lag_instance_carry_out(instance);
        told->states_changed = memcmp(instance->scratch.point, instance->x, lag_instance_order(instance) * sizeof(double)) != 0;
    }
    told->next = next_instant(instance);
    told->terminate = held->stopped;
    return status;
}

lag_status lag_instance_enter_continuous(lag_instance *instance)
{
    return lag_instance_begin(instance);
}

lag_status lag_instance_terminate(lag_instance *instance)
{
    lag_run *run = instance->run;
    if (instance->held.phase == LAG_PHASE_START || instance->held.stopped) {
        return LAG_OK;
    }
    lag_status status = lag_instance_ready(instance);
    if (status == LAG_OK) {
        status = lag_run_move(run, instance->held.t, instance->x, 0.0);
    }
    if (status == LAG_OK) {
        status = lag_run_end(run);
        memcpy(instance->x, run->stepper.x, lag_instance_order(instance) * sizeof(double));
        instance->values.known = 0;
    }
    return status == LAG_STOPPED ? LAG_OK : lag_instance_judge(instance, status);
}
