/* Model exchange: the importer integrates. */
#include "lag/instance/instance_internal.h"

#include <math.h>

/* Projections are too many where there are less than so many steps between them; the limit becomes so many times larger, up to this. */
static const double SELDOM = 50.0;
static const double RELAXED = 4.0;
static const double MOST_LIMIT = 1e-4;

lag_status lag_instance_set_time(lag_instance *instance, double t)
{
    if (!isfinite(t)) {
        return lag_instance_fail(instance, LAG_NOT_FINITE, "the time is infinite or not a number");
    }
    instance->known = t == instance->held.t ? instance->known : 0;
    instance->held.t = t;
    instance->held.exchanged = 1;
    return LAG_OK;
}

lag_status lag_instance_set_states(lag_instance *instance, const double *x)
{
    const size_t count = lag_instance_state_count(instance->fmu);
    for (size_t i = 0; i < count; ++i) {
        if (!isfinite(x[i])) {
            return lag_instance_fail(instance, LAG_NOT_FINITE, "state number %zu is infinite or not a number", i);
        }
    }
    lag_instance_tie(instance);
    for (size_t i = 0; i < count; ++i) {
        instance->x[lag_instance_state_entry(instance->fmu, i)] = x[i];
    }
    lag_instance_follow_states(instance);
    instance->known = 0;
    return LAG_OK;
}

void lag_instance_states(const lag_instance *instance, double *x)
{
    lag_instance_gather_states(instance->fmu, instance->x, x);
}

lag_status lag_instance_derivatives(lag_instance *instance, double *xd)
{
    const lag_status status = lag_instance_know(instance, LAG_KNOWN_RATES);
    if (status == LAG_OK) {
        lag_instance_gather_states(instance->fmu, instance->xd, xd);
    }
    return status;
}

/*
 * True if the constraint residuals are too large. A less accurate importer would have to restart again and again; after
 * frequent requests the bound is raised, and the stabilized accelerations reduce the rest.
 */
static int is_off(lag_instance *instance)
{
    lag_held *held = &instance->held;
    held->limit = fmax(held->limit, held->tolerance);
    held->since += 1.0;
    if (fmax(instance->residual[0], instance->slip) <= held->limit) {
        return 0;
    }
    held->limit = held->since < SELDOM ? fmin(fmax(held->limit, MOST_LIMIT), RELAXED * held->limit) : held->limit;
    held->since = 0.0;
    return 1;
}

lag_status lag_instance_completed(lag_instance *instance, int *events, int *terminate)
{
    lag_held *held = &instance->held;
    *events = *terminate = 0;
    lag_status status = lag_instance_know(instance, LAG_KNOWN_RESIDUALS);
    if (status == LAG_OK) {
        *events = is_off(instance);
        lag_noise_follow(&instance->run->instants.noise, instance->x);
        lag_contacts_follow(&instance->run->instants.contacts, instance->x);
        status = lag_instance_judge(instance, lag_instance_assert(instance, held->t, instance->x));
    }
    if (status == LAG_OK) {
        status = lag_instance_judge(instance, lag_run_count_turns(instance->run, held->t, instance->x));
    }
    lag_instance_leave_inputs(instance);
    if (held->t != held->last) {
        held->span = held->t - held->last;
        held->last = held->t;
    }
    return status;
}
