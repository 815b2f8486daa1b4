/* Model exchange: the importer integrates. */
#include "lag/instance/instance_internal.h"

#include <math.h>

/* Stabilized accelerations keep residuals of constraints within so many tolerances of the importer, or this if it is less. */
static const double KEPT = 100.0;
static const double MOST_KEPT = 1e-4;

void lag_instance_set_time(lag_instance *instance, double t)
{
    instance->values.known = t == instance->held.t ? instance->values.known : 0;
    instance->held.t = t;
    instance->held.exchanged = 1;
}

void lag_instance_set_states(lag_instance *instance, const double *x)
{
    lag_instance_tie(instance);
    for (size_t i = 0; i < lag_instance_state_count(instance->fmu); ++i) {
        instance->x[lag_instance_state_entry(instance->fmu, i)] = x[i];
    }
    lag_instance_follow_states(instance);
    instance->values.known = 0;
}

void lag_instance_states(const lag_instance *instance, double *x)
{
    lag_instance_gather_states(instance->fmu, instance->x, x);
}

lag_status lag_instance_derivatives(lag_instance *instance, double *xd)
{
    const lag_status status = lag_instance_evaluate(instance, LAG_KNOWN_RATES);
    lag_instance_gather_states(instance->fmu, instance->values.xd, xd);
    return status;
}

lag_status lag_instance_completed(lag_instance *instance, int *events)
{
    const double tolerance = instance->held.tolerance;
    const double t = instance->held.t;
    lag_status status = lag_instance_evaluate(instance, LAG_KNOWN_RESIDUALS);
    *events = fmax(instance->values.residual[0], instance->values.slip) > fmax(tolerance, fmin(KEPT * tolerance, MOST_KEPT));
    if (status == LAG_OK) {
        lag_noise_follow(&instance->run->instants.noise, instance->x);
        lag_contacts_follow(&instance->run->instants.contacts, instance->x);
        status = lag_instance_assert(instance, t, instance->x);
        status = status == LAG_OK ? lag_run_count_turns(instance->run, t, instance->x) : status;
    }
    lag_instance_leave_inputs(instance);
    return lag_instance_judge(instance, status);
}
