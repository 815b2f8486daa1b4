/* Event mode: finds what has changed at the present state, and carries it out by the rules of the run. */
#include "lag/instance/instance_internal.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "lag/linalg/arena.h"

/* During an event, a value has changed if it is behind zero, or behind the place of its indicator's zero but for this part of its round-off. */
static const double NEARLY = 0.4;
/* Values that are so many round-offs from zero pass it together. */
static const double TOGETHER = 4.0;
/* Bounces keep at least this part of the approach speed, whatever their restitution: a box that rocks does. */
static const double LEAST_PART = 0.9;
/* An instant that lies so many roundings of the time behind the present is now. */
static const double ROUNDINGS = 64.0;
/* Length of the last step, where nobody tells. */
static const double MOMENT = 1e-6;
/*
 * An event counts as one at its zero if relations lie behind zero by less than a hundredth of their way in a moment: in the first part of the
 * experiment, or in twice a hundred times the time since they passed zero, by their rates over the second part, and at most in the last part.
 */
static const double LATE = 1e-13;
static const double AHEAD = 1e-11;
static const double LATEST = 1e-9;
static const double MOMENTS = 200.0;

/* Relations flagged in `coming` that are not zero yet, but go there, wait: their flags become zero. */
static void wait_for_zeros(lag_instance *instance, double t, double *coming)
{
    lag_event_iteration *iteration = &instance->run->instants.iteration;
    const double *sigma = iteration->noise->sigma;
    const lag_status status = lag_event_iteration_look_ahead(iteration, t, instance->x, AHEAD * instance->run->instants.contacts.length);
    for (size_t i = 0; i < instance->fmu->model->nindicator && status == LAG_OK; ++i) {
        const double fall = fabs(iteration->now[i]) - fabs(iteration->then[i]);
        coming[i] = fabs(iteration->now[i]) > sigma[i] && fall > LAG_MOVES_CLEARLY * sigma[i] ? 0.0 : coming[i];
    }
}

/*
 * Flags of relations that have come to zero, by the round-off that is here: where the importer began it may have been less, or more, as that of a
 * square is. Then they are not there yet.
 */
static void find_zeros(lag_instance *instance, double t)
{
    lag_run *run = instance->run;
    const size_t count = instance->fmu->model->nindicator;
    double *changed = run->crossings.changed;
    double *coming = instance->room;
    for (size_t i = 0; i < count; ++i) {
        coming[i] = changed[i] != 0.0 && lag_instance_changes_at_zero(instance, i) && lag_instance_crossing_value(instance, i) > 0.0;
        changed[i] = coming[i] != 0.0 ? 0.0 : changed[i];
    }
    lag_noise_find(&run->instants.noise, t, instance->x);
    if (lag_any(count, coming)) {
        wait_for_zeros(instance, t, coming);
    }
    for (size_t i = 0; i < count; ++i) {
        const double nearly = NEARLY * lag_instance_margin(instance, i) - instance->latched[i];
        const int is_zero = lag_instance_changes_at_zero(instance, i) && lag_instance_room(instance, i) < nearly;
        changed[i] = changed[i] != 0.0 || coming[i] != 0.0 || is_zero;
    }
}

/*
 * Relations that are zero but for a few round-offs, and move clearly to the other side, change with those flagged in `changed`: the importer has found
 * one of the zeros that lie at one instant.
 */
static void join(lag_instance *instance, double t)
{
    lag_run *run = instance->run;
    lag_event_iteration *iteration = &run->instants.iteration;
    const size_t count = instance->fmu->model->nindicator;
    double *changed = run->crossings.changed;
    double *joining = instance->room;
    for (size_t i = 0; i < count; ++i) {
        const int is_near = fabs(lag_instance_crossing_value(instance, i)) <= TOGETHER * lag_instance_margin(instance, i);
        joining[i] = changed[i] == 0.0 && is_near && !lag_instance_is_held(instance, i) && instance->resting[i] == 0.0;
    }
    if (!lag_any(lag_instance_crossing_count(instance), changed) || !lag_any(count, joining) ||
        lag_event_iteration_look_ahead(iteration, t, instance->x, AHEAD * run->instants.contacts.length) != LAG_OK) {
        return;
    }
    for (size_t i = 0; i < count; ++i) {
        const double side = run->motion.w[run->crossings.places.relation + i] != 0.0 ? 1.0 : -1.0;
        const double fall = side * (iteration->now[i] - iteration->then[i]);
        changed[i] = changed[i] != 0.0 || (joining[i] != 0.0 && fall > LAG_MOVES_CLEARLY * lag_instance_round_off(instance, i));
    }
}

/* Relations that do not change stay in event mode while they are behind zero by no more than their latches. */
static void hold(lag_instance *instance)
{
    for (size_t i = 0; i < instance->fmu->model->nindicator; ++i) {
        const int changes = instance->run->crossings.changed[i] != 0.0 || lag_instance_changes_at_zero(instance, i);
        const double behind = fmax(0.0, -lag_instance_crossing_value(instance, i));
        instance->run->crossings.depth[i] = changes ? 0.0 : fmin(behind, instance->latched[i]);
    }
}

/*
 * Flags of what has changed, beside those that are set already, into those of the run's alert; *any: whether anything has, conditions and
 * values that `pre` reads included.
 */
static lag_status find(lag_instance *instance, double t, const double *located, int *any)
{
    const size_t count = lag_instance_crossing_count(instance);
    const lag_status status = lag_instance_look_at_crossings(instance, t, instance->x);
    double *changed = instance->run->crossings.changed;
    for (size_t i = 0; i < count && status == LAG_OK; ++i) {
        const double nearly = NEARLY * lag_instance_margin(instance, i) - instance->latched[i];
        changed[i] = lag_instance_room(instance, i) < nearly || (located != NULL && located[i] != 0.0);
    }
    if (status == LAG_OK && instance->fmu->model->nindicator > 0) {
        find_zeros(instance, t);
        join(instance, t);
        hold(instance);
    }
    *any = status == LAG_OK && lag_any(count, changed);
    const int asked = status == LAG_OK && !*any && instance->fmu->model->event != NULL;
    return asked ? lag_event_iteration_conditions(&instance->run->instants.iteration, t, instance->x, any) : status;
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

/*
 * Bounces that take less than twice this are none. One that begins at a part e of the approach speed u, and is accelerated back by a, takes T = 2 e u/a. If it
 * does not get clear of the margin m, or of the depth at which an importer has found it, the next one begins m deeper: bounces end at
 * u^2 (1 - e^2) = 2 a m, where T = 4 e/(1 - e^2) m/u; with e = 1 there is no end. If several contacts close, the fastest one decides.
 */
static double flight(const lag_instance *instance)
{
    const lag_zero_crossing *crossings = &instance->run->crossings;
    const size_t first = instance->fmu->model->nindicator;
    double shortest = (double)INFINITY;
    for (size_t i = 0; i < instance->fmu->model->ncontact; ++i) {
        const int open = instance->run->motion.w[crossings->places.contact + i] == 0.0;
        const double e = fmax(crossings->laws[i], LEAST_PART);
        const double depth = fmax(lag_instance_margin(instance, first + i), -lag_instance_crossing_value(instance, first + i));
        if (open && crossings->changed[first + i] != 0.0 && crossings->speed[i] < 0.0 && e < 1.0) {
            shortest = fmin(shortest, -4.0 * e / (1.0 - e * e) * depth / crossings->speed[i]);
        }
    }
    return shortest < (double)INFINITY ? shortest : 0.0;
}

/*
 * Time since the relations that have changed, and lie behind zero, have passed it, by their rates; zero for those that come back, or move by no more than
 * round-off.
 */
static double since_zero(lag_instance *instance, double t)
{
    lag_event_iteration *iteration = &instance->run->instants.iteration;
    const double ahead = AHEAD * instance->run->instants.contacts.length;
    double late = 0.0;
    const lag_status status = lag_event_iteration_look_ahead(iteration, t, instance->x, ahead);
    for (size_t i = 0; i < instance->fmu->model->nindicator && status == LAG_OK; ++i) {
        const double moved = iteration->then[i] - iteration->now[i];
        const int falls = instance->run->crossings.changed[i] != 0.0 && moved * iteration->now[i] > 0.0;
        late = falls && fabs(moved) > LAG_MOVES_CLEARLY * iteration->noise->sigma[i] ? fmax(late, ahead * (iteration->now[i] / moved)) : late;
    }
    return late;
}

/* An event may be carried out so long after its zero. */
static double lateness(lag_instance *instance, double t)
{
    const double length = instance->run->instants.contacts.length;
    return fmin(LATEST * length, fmax(LATE * length, MOMENTS * since_zero(instance, t)));
}

/* Length of the step that led here: the run's, the importer's. */
static double length_of_step(const lag_instance *instance, int located)
{
    const lag_run *run = instance->run;
    const double span = located ? run->half.length : instance->held.span;
    return span > 0.0 ? span : MOMENT * fmax(run->instants.contacts.length, fabs(instance->held.t));
}

/* True if an event has changed no number of the state by more than the importer's tolerance allows. */
static int is_idle(const lag_instance *instance)
{
    int idle = 1;
    for (size_t i = 0; i < lag_instance_order(instance); ++i) {
        idle = idle && fabs(instance->x[i] - instance->tangent[i]) <= instance->held.tolerance * fabs(instance->tangent[i]);
    }
    return idle;
}

/* True if the last event has turned relation or contact `i`. */
static int has_turned(const lag_instance *instance, size_t i)
{
    const lag_run *run = instance->run;
    const size_t first = instance->fmu->model->nindicator;
    const size_t place = i < first ? run->crossings.places.relation + i : run->crossings.places.contact + i - first;
    return run->motion.w[place] != run->instants.w_before[place];
}

static int is_closed(const lag_instance *instance, size_t i)
{
    const size_t first = instance->fmu->model->nindicator;
    return i >= first && instance->run->motion.w[instance->run->crossings.places.contact + i - first] != 0.0;
}

/*
 * Behind an event that has changed no number of the state, a value that still shows a change, and a contact that has closed without a blow, have been moved
 * there by the importer's errors. A contact that has opened, as where its ground stops, has not, nor has a relation that has turned.
 */
static lag_status widen(lag_instance *instance, int happened)
{
    const lag_status status = lag_instance_look_at_crossings(instance, instance->held.t, instance->x);
    for (size_t i = 0; i < lag_instance_crossing_count(instance) && status == LAG_OK; ++i) {
        const int turned = happened && has_turned(instance, i);
        const int shows = lag_instance_room(instance, i) + instance->latched[i] < NEARLY * lag_instance_margin(instance, i);
        if (turned ? is_closed(instance, i) : shows) {
            lag_instance_widen(instance, i);
        }
    }
    return status;
}

lag_status lag_instance_carry_out(lag_instance *instance)
{
    lag_held *held = &instance->held;
    lag_run *run = instance->run;
    const int located = run->half.open && run->half.own && run->half.t == held->t;
    const double t = located ? held->t : present(instance);
    const double h = length_of_step(instance, located);
    const size_t size = lag_instance_order(instance) * sizeof(double);
    const size_t events = run->events;
    int any = 0;
    instance->known = 0;
    held->jumped = 1;
    held->tied = 0;
    lag_status status = place(instance, t, located);
    memcpy(instance->tangent, instance->x, size);
    if (status == LAG_OK) {
        status = find(instance, t, located ? run->pending : NULL, &any);
    }
    if (status == LAG_OK && any) {
        run->instants.contacts.flight = located ? 0.0 : flight(instance);
        run->instants.late = located ? 0.0 : lateness(instance, t);
        status = (lag_run_due(run, t) ? lag_run_event_and_ticks : lag_run_event)(run, h, run->crossings.changed);
        run->instants.contacts.flight = run->instants.late = 0.0;
    }
    if (status == LAG_OK) {
        status = lag_run_ticks(run);
    }
    if (status == LAG_OK || status == LAG_STOPPED) {
        memcpy(instance->x, run->stepper.x, size);
        lag_instance_note_stop(instance, status);
        status = is_idle(instance) ? widen(instance, run->events > events) : LAG_OK;
        status = status == LAG_OK ? lag_instance_latch(instance, held->t, instance->x) : status;
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
    if (status == LAG_OK) {
        status = lag_instance_ready(instance);
    }
    if (status == LAG_OK && (held->exchanged || held->t == held->followed)) {
        status = lag_instance_follow_inputs(instance);
    }
    if (status == LAG_OK && (held->entered || held->jumped)) {
        held->entered = 0;
        memcpy(instance->point, instance->x, lag_instance_order(instance) * sizeof(double));
        status = lag_instance_carry_out(instance);
        told->states_changed = memcmp(instance->point, instance->x, lag_instance_order(instance) * sizeof(double)) != 0;
    }
    told->next = next_instant(instance);
    told->terminate = held->stopped;
    return status;
}

lag_status lag_instance_enter_continuous(lag_instance *instance)
{
    const lag_status status = lag_instance_begin(instance);
    instance->held.last = instance->held.t;
    instance->held.span = 0.0;
    return status;
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
        instance->known = 0;
    }
    return status == LAG_STOPPED ? LAG_OK : lag_instance_judge(instance, status);
}
