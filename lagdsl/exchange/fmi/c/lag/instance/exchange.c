/* Model exchange: the importer integrates. */
#include "lag/instance/instance_internal.h"

#include <math.h>

/* Stabilized accelerations keep residuals of constraints within so many tolerances of the importer, or this if it is less. */
static const double KEPT = 100.0;
static const double MOST_KEPT = 1e-4;

lag_status lag_instance_set_time(lag_instance *instance, double t)
{
    if (!isfinite(t)) {
        return lag_instance_fail(instance, LAG_NOT_FINITE, "the time is infinite or not a number");
    }
    instance->values.known = t == instance->held.t ? instance->values.known : 0;
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
    instance->values.known = 0;
    return LAG_OK;
}

void lag_instance_states(const lag_instance *instance, double *x)
{
    lag_instance_gather_states(instance->fmu, instance->x, x);
}

lag_status lag_instance_derivatives(lag_instance *instance, double *xd)
{
    const lag_status status = lag_instance_evaluate(instance, LAG_KNOWN_RATES);
    if (status == LAG_OK) {
        lag_instance_gather_states(instance->fmu, instance->values.xd, xd);
    }
    return status;
}

/* True if they do not: event mode moves the state onto the constraints. */
static int is_off(const lag_instance *instance)
{
    const double tolerance = instance->held.tolerance;
    return fmax(instance->values.residual[0], instance->values.slip) > fmax(tolerance, fmin(KEPT * tolerance, MOST_KEPT));
}

lag_status lag_instance_completed(lag_instance *instance, int *events, int *terminate)
{
    lag_held *held = &instance->held;
    *events = *terminate = 0;
    lag_status status = lag_instance_evaluate(instance, LAG_KNOWN_RESIDUALS);
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
    return status;
}
