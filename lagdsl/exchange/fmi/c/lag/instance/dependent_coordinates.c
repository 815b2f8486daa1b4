/* Coordinates that constraints with constant coefficients tie to others: importers integrate the others. */
#include "lag/instance/instance_internal.h"

#include <string.h>

size_t lag_instance_state_count(const lag_fmu *fmu)
{
    return fmu->states.entries == NULL ? lag_motion_size(fmu->model) : fmu->states.count;
}

size_t lag_instance_state_entry(const lag_fmu *fmu, size_t i)
{
    return fmu->states.entries == NULL ? i : fmu->states.entries[i];
}

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
    for (size_t i = 0; i < fmu->dependents.count && !instance->held.tied; ++i) {
        instance->offsets[i] = instance->x[fmu->dependents.coordinates[i]] - terms(fmu, i, instance->x);
    }
    instance->held.tied = 1;
}

void lag_instance_follow_states(lag_instance *instance)
{
    const lag_fmu *fmu = instance->fmu;
    double *q = instance->x;
    double *qd = instance->x + fmu->model->nq;
    for (size_t i = 0; i < fmu->dependents.count; ++i) {
        q[fmu->dependents.coordinates[i]] = instance->offsets[i] + terms(fmu, i, q);
        qd[fmu->dependents.coordinates[i]] = terms(fmu, i, qd);
    }
}

void lag_instance_follow_direction(const lag_fmu *fmu, double *x)
{
    for (size_t i = 0; i < fmu->dependents.count; ++i) {
        x[fmu->dependents.coordinates[i]] = terms(fmu, i, x);
        x[fmu->model->nq + fmu->dependents.coordinates[i]] = terms(fmu, i, x + fmu->model->nq);
    }
}

void lag_instance_gather_states(const lag_fmu *fmu, const double *x, double *states)
{
    for (size_t i = 0; i < lag_instance_state_count(fmu); ++i) {
        states[i] = x[lag_instance_state_entry(fmu, i)];
    }
}
