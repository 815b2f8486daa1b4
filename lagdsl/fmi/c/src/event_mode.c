/*
 * Event mode, and the indicators that lead to it. An indicator is what passes zero when a relation or a contact changes (lag/alert.h), with a
 * margin: it changes its sign a little late, so that it is clearly of one sign or the other after every event, wherever an importer
 * has located it.
 */
#include "lag/parts.h"

#include <math.h>
#include <string.h>

/* The margin, as a part of the magnitudes seen, and of the size of the state: more than round-off. */
static const double PART = 1e-11;
static const double ROUNDING = 4e-13;
/* What is so much of its margin behind zero has changed, where an event is carried out anyway. */
static const double CLEARLY = 0.25;
/* Length of the last step, where nobody tells. */
static const double MOMENT = 1e-6;

size_t lag_instance_indicator_count(const lag_fmu *fmu)
{
    return fmu->model->nindicator + fmu->model->ncontact;
}

/* What passes zero downward when it changes. */
static double value(const lag_instance *instance, size_t i)
{
    return lag_alert_value(&instance->run->alert, i);
}

static double margin(const lag_instance *instance, size_t i)
{
    return PART * instance->largest[i] + ROUNDING * lag_contacts_size(&instance->run->motion, instance->x);
}

/* 1, or -1 for relations that do not hold. */
static double side(const lag_instance *instance, size_t i)
{
    const lag_run *run = instance->run;
    const int relation = i < instance->fmu->model->nindicator;
    return relation && run->motion.w[run->alert.places.relation + i] == 0.0 ? -1.0 : 1.0;
}

lag_status lag_instance_look(lag_instance *instance)
{
    const size_t count = lag_instance_indicator_count(instance->fmu);
    const lag_status status = count > 0 ? lag_alert_look(&instance->run->alert, instance->held.t, instance->x) : LAG_OK;
    for (size_t i = 0; i < count; ++i) {
        instance->g[i] = side(instance, i) * (value(instance, i) + margin(instance, i) + instance->latched[i]);
    }
    return status == LAG_HAPPENS ? LAG_OK : status;
}

lag_status lag_instance_indicators(lag_instance *instance, double *g)
{
    const lag_status status = lag_instance_know(instance, LAG_KNOWN_INDICATORS);
    if (status == LAG_OK) {
        memcpy(g, instance->g, lag_instance_indicator_count(instance->fmu) * sizeof(double));
    }
    return status;
}

lag_status lag_instance_latch(lag_instance *instance)
{
    const size_t count = lag_instance_indicator_count(instance->fmu);
    instance->known = 0;
    const lag_status status = count > 0 ? lag_instance_look(instance) : LAG_OK;
    for (size_t i = 0; i < count; ++i) {
        instance->latched[i] = fmax(0.0, -value(instance, i));
        instance->largest[i] = fmax(instance->largest[i], fabs(value(instance, i)));
    }
    return status;
}

lag_status lag_instance_release(lag_instance *instance)
{
    const size_t count = lag_instance_indicator_count(instance->fmu);
    const lag_status status = count > 0 ? lag_instance_know(instance, LAG_KNOWN_INDICATORS) : LAG_OK;
    for (size_t i = 0; i < count && status == LAG_OK; ++i) {
        instance->largest[i] = fmax(instance->largest[i], fabs(value(instance, i)));
        if (value(instance, i) > margin(instance, i)) {
            instance->latched[i] = 0.0;
        }
    }
    return status;
}

/* Flags of what has changed, into those of the run's alert; *any: whether anything has. */
static lag_status find(lag_instance *instance, int *any)
{
    const size_t count = lag_instance_indicator_count(instance->fmu);
    const lag_status status = count > 0 ? lag_instance_look(instance) : LAG_OK;
    *any = 0;
    for (size_t i = 0; i < count && status == LAG_OK; ++i) {
        const int changed = value(instance, i) < -instance->latched[i] - CLEARLY * margin(instance, i);
        instance->run->alert.changed[i] = changed;
        instance->largest[i] = changed ? 0.0 : instance->largest[i];
        *any = *any || changed;
    }
    return status;
}

lag_status lag_instance_carry_out(lag_instance *instance, int *happened)
{
    lag_held *held = &instance->held;
    lag_run *run = instance->run;
    const size_t order = lag_instance_order(instance);
    const double h = held->span > 0.0 ? held->span : MOMENT * fmax(run->instants.contacts.length, fabs(held->t));
    int any = 0;
    int moved = 0;
    instance->known = 0;
    lag_status status = lag_run_move(run, held->t, instance->x, 0.0);
    if (status == LAG_OK) {
        status = lag_projection_apply(&run->projection, held->t, run->stepper.x, &moved);
        memcpy(instance->x, run->stepper.x, order * sizeof(double));
    }
    if (status == LAG_OK) {
        status = find(instance, &any);
    }
    *happened = any || lag_run_due(run, held->t);
    if (status == LAG_OK && any) {
        status = lag_run_event(run, h, run->alert.changed);
    }
    if (status == LAG_OK) {
        status = lag_run_ticks(run);
    }
    memcpy(instance->x, run->stepper.x, order * sizeof(double));
    held->stopped = held->stopped || status == LAG_STOPPED;
    if (status == LAG_OK || status == LAG_STOPPED) {
        status = lag_instance_latch(instance);
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
    int happened = 0;
    *told = (lag_update){.next = (double)INFINITY};
    lag_status status = lag_instance_begin(instance);
    if (status == LAG_OK) {
        status = lag_instance_ready(instance);
    }
    if (status == LAG_OK && held->entered) {
        held->entered = 0;
        memcpy(instance->point, instance->x, lag_instance_order(instance) * sizeof(double));
        status = lag_instance_carry_out(instance, &happened);
        told->states_changed = memcmp(instance->point, instance->x, lag_instance_order(instance) * sizeof(double)) != 0;
    }
    told->next = instance->fmu->model->event != NULL ? lag_instants_next(&instance->run->instants) : (double)INFINITY;
    told->terminate = held->stopped;
    if (held->stopped) {
        (void)lag_instance_fail(instance, LAG_STOPPED, "t = %.10g s: the model ends the simulation", held->t);
    }
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
