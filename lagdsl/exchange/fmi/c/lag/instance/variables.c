/* Values of variables: where each of them stands, and what follows when it is set. */
#include "lag/instance/instance_internal.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

/* The array that a variable is in, as it is known now; null: its role has none. */
static const double *array_of(const lag_instance *instance, lag_role role)
{
    switch (role) {
    case LAG_ROLE_TIME:
        return &instance->held.t;
    case LAG_ROLE_PARAMETER:
        return instance->p;
    case LAG_ROLE_CONSTANT:
        return instance->fmu->constants.numbers;
    case LAG_ROLE_STATE:
    case LAG_ROLE_DEPENDENT:
        return instance->x;
    case LAG_ROLE_DERIVATIVE:
        return instance->values.xd;
    case LAG_ROLE_INPUT:
        return instance->run->motion.u;
    case LAG_ROLE_OUTPUT:
        return instance->values.y;
    case LAG_ROLE_LOCAL:
        return instance->values.local;
    case LAG_ROLE_DISCRETE:
        return instance->run->motion.w;
    case LAG_ROLE_MULTIPLIER:
        return instance->run->motion.lam;
    case LAG_ROLE_INDICATOR:
        return instance->values.g;
    case LAG_ROLE_ENERGY:
        return instance->values.energy;
    case LAG_ROLE_RESIDUAL:
        return instance->values.residual;
    case LAG_ROLE_OPTION:
        return &instance->held.step;
    case LAG_ROLE_CLOCK:
        break;
    }
    return NULL;
}

/* Values that must be known before this role can be read; 0 if the state is enough. */
static unsigned needed(lag_role role)
{
    switch (role) {
    case LAG_ROLE_DERIVATIVE:
        return LAG_KNOWN_RATES;
    case LAG_ROLE_OUTPUT:
        return LAG_KNOWN_OUTPUTS;
    case LAG_ROLE_LOCAL:
        return LAG_KNOWN_LOCALS;
    case LAG_ROLE_MULTIPLIER:
        return LAG_KNOWN_MOTION;
    case LAG_ROLE_INDICATOR:
        return LAG_KNOWN_INDICATORS;
    case LAG_ROLE_ENERGY:
        return LAG_KNOWN_ENERGIES;
    case LAG_ROLE_RESIDUAL:
        return LAG_KNOWN_RESIDUALS;
    case LAG_ROLE_TIME:
    case LAG_ROLE_PARAMETER:
    case LAG_ROLE_CONSTANT:
    case LAG_ROLE_STATE:
    case LAG_ROLE_DEPENDENT:
    case LAG_ROLE_INPUT:
    case LAG_ROLE_DISCRETE:
    case LAG_ROLE_OPTION:
    case LAG_ROLE_CLOCK:
        break;
    }
    return 0;
}

/* 1: entries of x. */
static int is_state(lag_role role)
{
    return role == LAG_ROLE_STATE || role == LAG_ROLE_DEPENDENT;
}

/* Numbers that only a motion gone wrong lets be none. */
static int is_motion(lag_role role)
{
    return is_state(role) || role == LAG_ROLE_DERIVATIVE || role == LAG_ROLE_INPUT || role == LAG_ROLE_MULTIPLIER;
}

/* LAG_NOT_FINITE: a value of the motion that is none, or a whole number that an importer has no room for. */
static lag_status check_found(lag_instance *instance, const lag_variable *variable, const double *values)
{
    const lag_model *model = instance->fmu->model;
    const int motion = is_motion((lag_role)variable->role);
    for (size_t i = 0; i < variable->count; ++i) {
        if (motion && !isfinite(values[i])) {
            return lag_instance_fail(
                instance, LAG_NOT_FINITE, "t = %.10g s: %s is infinite or not a number", instance->held.t, variable->name);
        }
        if (variable->type == LAG_TYPE_INTEGER && !(fabs(values[i]) <= (double)INT32_MAX)) {
            return lag_instance_fail(instance, LAG_NOT_FINITE, "t = %.10g s: %s is %.10g, which an Integer cannot be", instance->held.t,
                variable->role == LAG_ROLE_DISCRETE ? model->discretes[variable->first + i].name : variable->name, values[i]);
        }
    }
    return LAG_OK;
}

double lag_instance_factor(const lag_instance *instance, lag_role role, size_t index)
{
    return role == LAG_ROLE_MULTIPLIER && instance->fmu->row_factors != NULL ? instance->fmu->row_factors[index] : 1.0;
}

lag_status lag_instance_get(lag_instance *instance, size_t variable, double *values)
{
    const lag_variable *which = &instance->fmu->variables[variable];
    const lag_role role = (lag_role)which->role;
    const unsigned what = needed(role);
    const int follows = is_state(role) || role == LAG_ROLE_INPUT || role == LAG_ROLE_DISCRETE || lag_instance_is_free(instance, which);
    lag_status status = LAG_OK;
    if ((what & ~instance->values.known) != 0) {
        status = lag_instance_evaluate(instance, what);
    } else if (follows) {
        status = lag_instance_ready(instance);
    }
    if (status == LAG_OK && role == LAG_ROLE_INPUT && instance->held.polynomial) {
        lag_instance_inputs_at(instance, instance->held.t, instance->run->motion.u);
    }
    const double *array = array_of(instance, role) + which->first;
    if (status == LAG_OK) {
        for (size_t i = 0; i < which->count; ++i) {
            values[i] = array[i] * lag_instance_factor(instance, role, which->first + i);
        }
        status = check_found(instance, which, values);
    }
    return status;
}

/* ---- setting ---- */

/* The values that entry `i` may have; null: any. */
static const lag_range *range_of(const lag_fmu *fmu, const lag_variable *variable, size_t i)
{
    const lag_range *ranges = variable->role == LAG_ROLE_PARAMETER ? fmu->parameter_range :
                              variable->role == LAG_ROLE_INPUT     ? fmu->inputs.range :
                                                                     NULL;
    return ranges == NULL ? NULL : ranges + variable->first + i;
}

static lag_status check(lag_instance *instance, const lag_variable *variable, const double *values)
{
    for (size_t i = 0; i < variable->count; ++i) {
        const double value = values[i];
        if (isnan(value) || (isinf(value) && variable->role != LAG_ROLE_PARAMETER)) {
            return lag_instance_fail(instance, LAG_NOT_FINITE, "the value for %s is infinite or not a number", variable->name);
        }
        const lag_range *range = range_of(instance->fmu, variable, i);
        if (range != NULL && (value < range->least || value > range->most)) {
            const lag_slot *slots = variable->role == LAG_ROLE_PARAMETER ? instance->fmu->model->parameters : instance->fmu->model->inputs;
            return lag_instance_fail(instance, LAG_NOT_FINITE, "%s is from %g to %g, not %g", slots[variable->first + i].name, range->least,
                range->most, value);
        }
        if (variable->type == LAG_TYPE_BOOLEAN && value != 0.0 && value != 1.0) {
            return lag_instance_fail(instance, LAG_NOT_FINITE, "%s is true or false, not %g", variable->name, value);
        }
        if ((variable->type == LAG_TYPE_INTEGER || variable->type == LAG_TYPE_ENUMERATION) && value != floor(value)) {
            return lag_instance_fail(instance, LAG_NOT_FINITE, "%s is a whole number, not %g", variable->name, value);
        }
    }
    return LAG_OK;
}

/* 1: something changed. */
static int put(size_t count, const double *values, double *array)
{
    int changed = 0;
    for (size_t i = 0; i < count; ++i) {
        changed = changed || array[i] != values[i];
        array[i] = values[i];
    }
    return changed;
}

/* States until initialization ends are starts, afterwards the state. */
static int put_states(lag_instance *instance, const lag_variable *variable, const double *values)
{
    int changed = 0;
    if (instance->held.phase == LAG_PHASE_MOTION) {
        lag_instance_tie(instance);
        changed = put(variable->count, values, instance->x + variable->first);
        lag_instance_follow_states(instance);
        return changed;
    }
    for (size_t i = 0; i < variable->count; ++i) {
        double *given = &instance->starts.given[variable->first + i];
        changed = changed || *given == 0.0;
        *given = 1.0;
    }
    return put(variable->count, values, instance->starts.values + variable->first) || changed;
}

lag_status lag_instance_set(lag_instance *instance, size_t variable, const double *values)
{
    const lag_variable *which = &instance->fmu->variables[variable];
    lag_held *held = &instance->held;
    const lag_status status = check(instance, which, values);
    int changed = 0;
    if (status != LAG_OK) {
        return status;
    }
    switch ((lag_role)which->role) {
    case LAG_ROLE_PARAMETER:
        changed = put(which->count, values, instance->starts.parameters + which->first);
        changed = put(which->count, values, instance->p + which->first) || changed;
        held->prepared = held->prepared && !changed;
        break;
    case LAG_ROLE_STATE:
    case LAG_ROLE_DEPENDENT:
        changed = put_states(instance, which, values);
        break;
    case LAG_ROLE_INPUT:
        lag_instance_set_inputs(instance, which->first, which->count, values);
        return LAG_OK;
    case LAG_ROLE_OPTION:
        if (values[0] < 0.0) {
            return lag_instance_fail(instance, LAG_NOT_FINITE, "the length of steps cannot be %g s", values[0]);
        }
        changed = put(1, values, &held->step);
        held->implicit = -1;
        break;
    case LAG_ROLE_TIME:
    case LAG_ROLE_CONSTANT:
    case LAG_ROLE_DERIVATIVE:
    case LAG_ROLE_OUTPUT:
    case LAG_ROLE_LOCAL:
    case LAG_ROLE_DISCRETE:
    case LAG_ROLE_MULTIPLIER:
    case LAG_ROLE_INDICATOR:
    case LAG_ROLE_ENERGY:
    case LAG_ROLE_RESIDUAL:
    case LAG_ROLE_CLOCK:
        return lag_instance_fail(instance, LAG_MISSING, "%s cannot be set", which->name);
    }
    if (changed) {
        held->jumped = 1;
        held->initialized = 0;
        instance->values.known = 0;
    }
    return LAG_OK;
}
