/*
 * Events. A guard is a relation, a contact or dry friction; its value passes zero downward when it changes (lag/events/guards.h). In co-simulation the
 * run finds the guards that leave their modes. In model exchange importers compare the signs of indicators at their steps, so an indicator is clearly
 * of one sign behind every event:
 *
 * - An armed guard leaves a round-off behind zero; one that changes at zero itself, as `limit(u, -1, 1) >= 1` does, a part of that before zero,
 *   because its value may never get behind.
 * - One that an event leaves within its dead band, or behind zero, is not armed: it leaves so far behind zero as the event left it, and the band more.
 *   The band is what the tolerance lets the value do. Importers may be less exact than they have told, or tell nothing: a guard that leaves
 *   without having been armed gets a band that is larger by a factor.
 * - It is armed once an importer has asked where it is farther before zero than that.
 */
#include "lag/instance/instance_internal.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "lag/linalg/arena.h"

/* A guard that changes at zero leaves so early, as a part of its round-off. */
static const double EARLY = 0.5;
/* In event mode guards leave together that are nearer to the zeros of their indicators than so many round-offs; behind an event none is. */
static const double TOGETHER = 4.0;
/* The band of a guard that has left without having been armed becomes so many times larger. */
static const double WIDER = 4.0;
/* A short time before the first step, as a part of the experiment. */
static const double SHORT_TIME = 1e-6;
/* Importers find events so late at most, as a part of the experiment. */
static const double LATE = 1e-9;

/* ---- indicators ---- */

/* True for a relation that does not hold now. */
static int is_false(const lag_instance *instance, size_t i)
{
    const lag_run *run = instance->run;
    return i < instance->fmu->model->nindicator && run->motion.w[run->motion.places.relation + i] == 0.0;
}

/* Guards that are off are infinite; FMI wants numbers. */
static double value_of(const lag_instance *instance, size_t i)
{
    const double value = instance->run->guards.value[i];
    return isinf(value) ? 1.0 : value;
}

/* FMI wants no indicator to be zero after an event; where no force acts, the force of a contact is zero, and so is its round-off. */
static double round_off(const lag_instance *instance, size_t i)
{
    return fmax(DBL_MIN, lag_guards_noise(&instance->run->guards, i));
}

static double dead_band(const lag_instance *instance, size_t i)
{
    return fmax(round_off(instance, i), lag_guards_known(&instance->run->guards, i));
}

/* True if guard i has been clear of its dead band since the last event. */
static int is_armed(const lag_instance *instance, size_t i)
{
    return instance->held.t > instance->armed[i];
}

/* The way of guard i until it leaves; negative: it has left. */
static double distance_to_leave(const lag_instance *instance, size_t i)
{
    const lag_model *model = instance->fmu->model;
    const double sigma = round_off(instance, i);
    const int at_zero = i < model->nindicator && is_false(instance, i) != (model->strict[i] != 0); /* `>=` that does not hold, `>` that does */
    const double before = lag_guards_touches(&instance->run->guards, i) ? dead_band(instance, i) : 0.0;
    const double behind = is_armed(instance, i) ? -before : instance->latched[i];
    return value_of(instance, i) + behind + (at_zero ? -EARLY * sigma : sigma);
}

lag_status lag_instance_find_indicators(lag_instance *instance)
{
    const lag_selection *indicators = &instance->fmu->indicators;
    const size_t count = lag_guard_count(instance->fmu->model);
    lag_status status = count > 0 ? lag_guards_detect(&instance->run->guards, instance->held.t, instance->x) : LAG_OK;
    status = status == LAG_EVENT_PENDING ? LAG_OK : status;
    for (size_t i = 0; i < count && status == LAG_OK; ++i) {
        if (value_of(instance, i) > instance->latched[i]) {
            instance->armed[i] = fmin(instance->armed[i], instance->held.t);
        }
    }
    for (size_t k = 0; k < indicators->count && status == LAG_OK; ++k) {
        const size_t i = indicators->entries[k];
        instance->values.of[LAG_ROLE_INDICATOR][k] = is_false(instance, i) ? -distance_to_leave(instance, i) : distance_to_leave(instance, i);
    }
    return status;
}

/* An event has ended at the present state: what is within its dead band now, or behind zero, is no event until it goes further. */
static lag_status disarm(lag_instance *instance)
{
    lag_run *run = instance->run;
    const double t = instance->held.t;
    instance->values.known = 0;
    if (instance->fmu->model->nindicator > 0) {
        lag_noise_find(&run->instants.noise, t, instance->x);
    }
    const lag_status status = lag_guards_begin(&run->guards, t, instance->x);
    for (size_t i = 0; i < lag_guard_count(instance->fmu->model) && status == LAG_OK; ++i) {
        const double behind = dead_band(instance, i) + fmax(0.0, -value_of(instance, i));
        instance->latched[i] = is_armed(instance, i) ? behind : fmax(behind, instance->latched[i]);
        instance->armed[i] = value_of(instance, i) > instance->latched[i] ? t : (double)INFINITY;
    }
    return status;
}

/* ---- event mode ---- */

/*
 * Guards that have left, flagged in `left`, beside those that are flagged. In co-simulation the run tells them. In model exchange the importer has led them to
 * the other side, and others stay, however far behind zero. Flights of a contact that was not clear of its dead band are none within it.
 */
static lag_status find_left(lag_instance *instance, double t, double *left)
{
    lag_guards *guards = &instance->run->guards;
    lag_contacts *contacts = &instance->run->instants.contacts;
    const int exchanged = instance->held.exchanged;
    const size_t relations = instance->fmu->model->nindicator;
    const size_t count = lag_guard_count(instance->fmu->model);
    if (exchanged && relations > 0) {
        lag_noise_find(guards->noise, t, instance->x); /* where the importer began, numbers may have been zero */
    }
    const lag_status status = count > 0 ? lag_guards_detect(guards, t, instance->x) : LAG_OK;
    for (size_t i = 0; i < count && (status == LAG_OK || status == LAG_EVENT_PENDING); ++i) {
        const double near = TOGETHER * (round_off(instance, i) - DBL_MIN); /* the force of an open contact is zero without round-off: no `<` */
        const int leaves = exchanged ? distance_to_leave(instance, i) < near : guards->changed[i] != 0.0;
        const double behind = i < relations ? fmax(0.0, -guards->value[i]) : 0.0;
        instance->latched[i] *= exchanged && leaves && !is_armed(instance, i) ? WIDER : 1.0;
        left[i] = left[i] != 0.0 || leaves;
        if (exchanged && i - relations < instance->fmu->model->ncontact) {
            const double band = guards->noise->tolerance * lag_contacts_scale(contacts, i - relations); /* of the gap; this guard may be a force */
            contacts->hidden[i - relations] = *lag_contacts_flag(contacts, i - relations) != 0.0 ? band : is_armed(instance, i) ? 0.0 : instance->latched[i];
        }
        guards->depth[i] = !exchanged ? guards->depth[i] : left[i] != 0.0 ? 0.0 : behind;
    }
    return status == LAG_EVENT_PENDING ? LAG_OK : status;
}

/* The next instant that is known ahead; the stop, if it lies behind that by round-off. */
static double next_instant(const lag_instance *instance)
{
    const lag_instants *instants = &instance->run->instants;
    const double next = lag_instants_next(instants);
    return next > instance->held.stop && lag_instants_due(instants, instance->held.stop) ? instance->held.stop : next;
}

/* The present, or an instant before the end that lies so shortly behind it that an importer could not go there by a step. */
static double present(const lag_instance *instance)
{
    const double t = instance->held.t;
    const double next = next_instant(instance);
    return t < instance->held.stop && next <= lag_timed_behind(&instance->run->instants.timed, t) ? fmax(t, next) : t;
}

/*
 * Places the run at time t and the present state and moves it onto the constraints down to round-off: a residual rate would act as an
 * impact, and a residual gap would not be zero when its contact opens.
 */
static lag_status place(lag_instance *instance, double t)
{
    lag_run *run = instance->run;
    int moved = 0;
    lag_status status = lag_run_move(run, t, instance->x, run->half.open ? run->half.next : run->stepper.h);
    status = status == LAG_OK ? lag_instance_balance_inputs(instance) : status;
    if (status == LAG_OK && lag_projection_exact(&run->projection, t, run->stepper.x, &moved) != LAG_OK) {
        status = lag_projection_apply(&run->projection, t, run->stepper.x, &moved);
    }
    if (status == LAG_OK) {
        memcpy(instance->x, run->stepper.x, lag_motion_size(instance->fmu->model) * sizeof(double));
    }
    return status;
}

lag_status lag_instance_leave_event(lag_instance *instance, lag_status status)
{
    if (status == LAG_OK || status == LAG_STOPPED) {
        memcpy(instance->x, instance->run->stepper.x, lag_motion_size(instance->fmu->model) * sizeof(double));
        instance->held.stopped = instance->held.stopped || status == LAG_STOPPED;
        lag_instance_tie(instance);
        status = disarm(instance);
    }
    return status == LAG_OK ? lag_run_count_turns(instance->run, instance->held.t, instance->x) : status;
}

lag_status lag_instance_carry_out(lag_instance *instance)
{
    lag_held *held = &instance->held;
    lag_run *run = instance->run;
    const int located = run->half.open && run->half.own && run->half.t == held->t;
    const double t = present(instance);
    const double h = located ? run->half.length : SHORT_TIME * fmax(run->instants.contacts.length, fabs(t));
    const size_t count = lag_guard_count(instance->fmu->model);
    instance->values.known = 0;
    held->jumped = 1;
    lag_fill(located ? 0 : count, 0.0, run->half.pending);
    /* As the importer led them, and after inputs have jumped: a projection moves values, too. */
    lag_status status = held->exchanged ? find_left(instance, t, run->half.pending) : LAG_OK;
    status = status == LAG_OK ? place(instance, t) : status;
    status = status == LAG_OK ? find_left(instance, t, run->half.pending) : status;
    int any = lag_any(count, run->half.pending);
    if (status == LAG_OK && !any) {
        status = lag_instants_conditions(&run->instants, t, instance->x, &any);
    }
    if (status == LAG_OK && any) {
        run->instants.instant.late = held->exchanged ? LATE * run->instants.contacts.length : 0.0;
        status = lag_run_instant(run, &(lag_cause){lag_run_due(run, t) ? LAG_CAUSE_TIME : LAG_CAUSE_GUARDS, h, run->half.pending});
        run->instants.instant.late = 0.0;
    }
    status = status == LAG_OK ? lag_run_ticks(run) : status;
    return lag_instance_judge(instance, lag_instance_leave_event(instance, status));
}

lag_status lag_instance_update(lag_instance *instance, lag_update *told)
{
    double *before = instance->scratch;
    const size_t count = lag_motion_size(instance->fmu->model);
    lag_status status = lag_instance_begin(instance);
    memcpy(before, instance->x, count * sizeof(double));
    status = status == LAG_OK ? lag_instance_follow_inputs(instance) : status;
    status = status == LAG_OK ? lag_instance_carry_out(instance) : status;
    *told = (lag_update){.next = next_instant(instance), .terminate = instance->held.stopped};
    told->states_changed = memcmp(before, instance->x, count * sizeof(double)) != 0;
    return status;
}

lag_status lag_instance_terminate(lag_instance *instance)
{
    if (!instance->held.moving || instance->held.stopped) {
        return LAG_OK;
    }
    lag_status status = lag_instance_ready(instance);
    status = status == LAG_OK ? lag_run_move(instance->run, instance->held.t, instance->x, 0.0) : status;
    return lag_instance_judge(instance, status == LAG_OK ? lag_instance_leave_event(instance, lag_run_end(instance->run)) : status);
}

lag_status lag_instance_clock(lag_instance *instance, size_t which, double t, double *period, double *tick)
{
    const lag_status status = lag_instance_ready(instance);
    lag_clock clock = instance->run->instants.clocks.each[which];
    if (status == LAG_OK) {
        lag_clock_enter(&clock, t);
        *period = clock.period;
        *tick = lag_clock_instant(&clock, clock.next);
    }
    return status;
}
