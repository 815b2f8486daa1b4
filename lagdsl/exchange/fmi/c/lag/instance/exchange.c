/* Model exchange: the importer integrates the states. Coordinates that constraints with constant coefficients tie to others are none, and follow. */
#include "lag/instance/instance_internal.h"

#include <math.h>

/* Stabilized accelerations keep residuals of constraints within so many tolerances of the importer, or this if it is less. */
static const double KEPT = 100.0;
static const double MOST_KEPT = 1e-4;

/* ---- dependent coordinates ---- */

/* Sum of the terms of dependent coordinate `i`, in coordinates or in rates. */
static double terms(const lag_fmu *fmu, size_t i, const double *values)
{
    double sum = 0.0;
    for (size_t k = fmu->dependents.term_first[i]; k < fmu->dependents.term_first[i + 1]; ++k) {
        sum += fmu->dependents.term_weight[k] * values[fmu->dependents.term_of[k]];
    }
    return sum;
}

void lag_instance_tie(lag_instance *instance)
{
    const lag_fmu *fmu = instance->fmu;
    for (size_t i = 0; i < fmu->dependents.count; ++i) {
        instance->offsets[i] = instance->x[fmu->dependents.coordinates[i]] - terms(fmu, i, instance->x);
    }
}

void lag_instance_follow_states(const lag_fmu *fmu, const double *offsets, double *x)
{
    double *rates = x + fmu->model->nq;
    for (size_t i = 0; i < fmu->dependents.count; ++i) {
        x[fmu->dependents.coordinates[i]] = (offsets != NULL ? offsets[i] : 0.0) + terms(fmu, i, x);
        rates[fmu->dependents.coordinates[i]] = terms(fmu, i, rates);
    }
}

/* ---- states ---- */

void lag_instance_set_time(lag_instance *instance, double t)
{
    instance->values.known = t == instance->held.t ? instance->values.known : 0;
    instance->held.t = t;
    instance->held.exchanged = 1;
}

void lag_instance_set_states(lag_instance *instance, const double *x)
{
    for (size_t i = 0; i < instance->fmu->states.count; ++i) {
        instance->x[instance->fmu->states.entries[i]] = x[i];
    }
    lag_instance_follow_states(instance->fmu, instance->offsets, instance->x);
    instance->values.known = 0;
}

lag_status lag_instance_vector(lag_instance *instance, lag_role role, double *values)
{
    const lag_status status = lag_instance_evaluate(instance, role);
    const lag_selection *of = role == LAG_ROLE_INDICATOR ? &instance->fmu->indicators : &instance->fmu->states;
    for (size_t i = 0; i < of->count; ++i) { /* indicators stand one after the other */
        values[i] = instance->values.of[role][role == LAG_ROLE_INDICATOR ? i : of->entries[i]];
    }
    return status;
}

lag_status lag_instance_completed(lag_instance *instance, int *events)
{
    const double tolerance = instance->held.tolerance;
    lag_status status = lag_instance_evaluate(instance, LAG_ROLE_RESIDUAL);
    *events = fmax(instance->values.residual[0], instance->values.slip) > fmax(tolerance, fmin(KEPT * tolerance, MOST_KEPT));
    if (status == LAG_OK) {
        lag_contacts_follow(&instance->run->instants.contacts, instance->x);
        status = lag_instance_assert(instance);
        status = status == LAG_OK ? lag_run_count_turns(instance->run, instance->held.t, instance->x) : status;
    }
    lag_instance_leave_inputs(instance);
    return lag_instance_judge(instance, status);
}
