/* Values of variables: where each of them stands, and what follows when it is set. */
#include "lag/instance/instance_internal.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

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
    const int motion = is_motion((lag_role)variable->role);
    const int whole = variable->type == LAG_TYPE_INTEGER;
    for (size_t i = 0; i < variable->count; ++i) {
        if ((motion && !isfinite(values[i])) || (whole && !(fabs(values[i]) <= (double)INT32_MAX))) {
            const lag_slot *entries = variable->role == LAG_ROLE_DISCRETE ? instance->fmu->model->discretes + variable->first : NULL;
            return lag_instance_fail(instance, LAG_NOT_FINITE,
                whole ? "t = %.10g s: %s is %.10g, which an Integer cannot be" : "t = %.10g s: %s is infinite or not a number (%g)",
                instance->held.t, entries != NULL ? entries[i].name : variable->name, values[i]);
        }
    }
    return LAG_OK;
}

double lag_instance_factor(const lag_instance *instance, lag_role role, size_t index)
{
    return role == LAG_ROLE_MULTIPLIER && instance->fmu->row_factors != NULL ? instance->fmu->row_factors[index] : 1.0;
}

double lag_instance_value(const lag_instance *instance, const lag_variable *variable, size_t i)
{
    const lag_role role = (lag_role)variable->role;
    return instance->values.of[role][variable->first + i] * lag_instance_factor(instance, role, variable->first + i);
}

lag_status lag_instance_look(lag_instance *instance, const lag_variable *variable)
{
    const lag_role role = (lag_role)variable->role;
    const int plain = role == LAG_ROLE_TIME || role == LAG_ROLE_CONSTANT || role == LAG_ROLE_OPTION || role == LAG_ROLE_PARAMETER;
    const int held = is_state(role) || role == LAG_ROLE_INPUT || role == LAG_ROLE_DISCRETE || lag_instance_is_free(instance, variable);
    const lag_status status = held ? lag_instance_ready(instance) : plain ? LAG_OK : lag_instance_evaluate(instance, role);
    if (status == LAG_OK && role == LAG_ROLE_INPUT && instance->held.polynomial) {
        lag_instance_inputs_at(instance, 0, instance->held.t, instance->run->motion.u);
    }
    return status;
}

lag_status lag_instance_get(lag_instance *instance, size_t variable, double *values)
{
    const lag_variable *which = &instance->fmu->variables[variable];
    const lag_status status = lag_instance_look(instance, which);
    for (size_t i = 0; i < which->count && status == LAG_OK; ++i) {
        values[i] = lag_instance_value(instance, which, i);
    }
    return status == LAG_OK ? check_found(instance, which, values) : status;
}

/* ---- setting ---- */

static lag_status check_ranges(lag_instance *instance, const lag_variable *variable, const double *values)
{
    const lag_fmu *fmu = instance->fmu;
    const int is_input = variable->role == LAG_ROLE_INPUT;
    const lag_slot *slots = is_input ? fmu->model->inputs : fmu->model->parameters;
    const lag_range *ranges = is_input ? fmu->inputs.range : variable->role == LAG_ROLE_PARAMETER ? fmu->parameter_range : NULL;
    for (size_t i = 0; i < variable->count && ranges != NULL; ++i) {
        const lag_range *range = &ranges[variable->first + i];
        if (values[i] < range->least || values[i] > range->most) {
            return lag_instance_fail(instance, LAG_NOT_FINITE, "%s is from %g to %g, not %g", slots[variable->first + i].name, range->least,
                range->most, values[i]);
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
    if (instance->held.moving) {
        lag_instance_tie(instance);
        changed = put(variable->count, values, instance->x + variable->first);
        lag_instance_follow_states(instance->fmu, instance->offsets, instance->x);
        return changed;
    }
    for (size_t i = 0; i < variable->count; ++i) {
        unsigned char *given = &instance->starts.given[variable->first + i];
        changed = changed || !*given;
        *given = 1;
    }
    return put(variable->count, values, instance->starts.values + variable->first) || changed;
}

lag_status lag_instance_set(lag_instance *instance, size_t variable, const double *values)
{
    const lag_variable *which = &instance->fmu->variables[variable];
    lag_held *held = &instance->held;
    const lag_status status = check_ranges(instance, which, values);
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
        lag_instance_set_inputs(instance, 0, which->first, which->count, values);
        return LAG_OK;
    case LAG_ROLE_OPTION:
        if (values[0] < 0.0) {
            return lag_instance_fail(instance, LAG_NOT_FINITE, "the length of steps cannot be %g s", values[0]);
        }
        changed = put(1, values, &held->step);
        held->implicit = -1;
        break;
    default:
        return lag_instance_fail(instance, LAG_MISSING, "%s cannot be set", which->name);
    }
    if (changed) {
        held->jumped = 1;
        held->initialized = 0;
        instance->values.known = 0;
    }
    return LAG_OK;
}
