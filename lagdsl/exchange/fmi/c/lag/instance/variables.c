/*
 * Values of variables: where each of them stands, and what follows when it is set. Values that follow from the present state are computed on
 * demand, and kept until a value is set.
 */
#include "lag/instance/instance_internal.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

#include "lag/linalg/finite.h"
#include "lag/linalg/vector.h"

/* Roles of values that are there before a motion begins, and from then on; of numbers that only a motion gone wrong lets be none. */
static const unsigned PLAIN = LAG_BIT(TIME) | LAG_BIT(CONSTANT) | LAG_BIT(OPTION) | LAG_BIT(PARAMETER);
static const unsigned STORED = LAG_BIT(STATE) | LAG_BIT(DEPENDENT) | LAG_BIT(INPUT) | LAG_BIT(DISCRETE) | LAG_BIT(FREE);
static const unsigned MOVED = LAG_BIT(STATE) | LAG_BIT(DEPENDENT) | LAG_BIT(DERIVATIVE) | LAG_BIT(INPUT) | LAG_BIT(MULTIPLIER);

/* Accelerations of the model, also for states off its constraints; in co-simulation those of rows. */
static lag_status accelerations(lag_instance *instance)
{
    lag_motion *motion = &instance->run->motion;
    const lag_held *held = &instance->held;
    if (instance->fmu->model->nc == 0) {
        return lag_motion_solve(motion, held->t, instance->x);
    }
    if (held->moving && !held->exchanged && lag_run_crosses(instance->fmu->model, &instance->run->options)) {
        lag_run_solve(instance->run, held->t, instance->x, held->t <= instance->run->counts.entered);
        return LAG_OK;
    }
    return lag_motion_pulled(motion, 0.0, held->t, instance->x, motion->qdd, motion->lam);
}

/* dx/dt; not finite values are an error here. */
static lag_status rates(lag_instance *instance)
{
    const lag_model *model = instance->fmu->model;
    lag_motion *motion = &instance->run->motion;
    const size_t n = model->nq;
    double *xd = instance->values.of[LAG_ROLE_DERIVATIVE];
    lag_status status = LAG_OK;
    memcpy(xd, instance->x + n, n * sizeof(double));
    if (model->nc > 0) {
        status = lag_motion_pulled(motion, lag_instance_rate(instance), instance->held.t, instance->x, xd + n, instance->values.unasked);
    } else {
        memcpy(xd + n, motion->qdd, n * sizeof(double));
    }
    if (status == LAG_OK && model->nz > 0) {
        status = model->state_derivative(&motion->at, xd + 2 * n);
    }
    return status == LAG_OK && !lag_finite(lag_motion_size(model), xd) ? LAG_NOT_FINITE : status;
}

/* The largest residuals of positions and of velocities, rows of size one. */
static lag_status residuals(lag_instance *instance)
{
    const lag_model *model = instance->fmu->model;
    lag_values *values = &instance->values;
    lag_projection *projection = &instance->run->projection;
    lag_status status = LAG_OK;
    values->residual[0] = values->residual[1] = values->slip = 0.0;
    lag_projection_measure(projection, instance->x + model->nq);
    for (size_t level = 0; level < 2 && status == LAG_OK && model->nc > 0; ++level) {
        status = lag_projection_evaluate(projection, level > 0);
        for (size_t i = 0; i < model->nc; ++i) {
            const double part = level > 0 || model->position_level[i] ? fabs(projection->phi[i]) / instance->run->sizes.rows[i] : 0.0;
            status = status == LAG_OK && !isfinite(part) ? LAG_NOT_FINITE : status;
            values->residual[level] = fmax(values->residual[level], part);
            values->slip = level > 0 ? fmax(values->slip, part / lag_projection_pace(projection, i)) : 0.0;
        }
    }
    return status;
}

/* The values of one role; what they need is known. */
static lag_status find(lag_instance *instance, unsigned role)
{
    const lag_model *model = instance->fmu->model;
    lag_motion *motion = &instance->run->motion;
    double *energy = instance->values.energy;
    lag_status status = LAG_OK;
    switch (role) {
    case LAG_ROLE_MULTIPLIER:
        return accelerations(instance);
    case LAG_ROLE_DERIVATIVE:
        return rates(instance);
    case LAG_ROLE_OUTPUT:
        status = model->output(&motion->at, instance->values.of[role]);
        lag_run_unwind(instance->run, instance->values.of[role]);
        return status;
    case LAG_ROLE_LOCAL:
        return model->definition(&motion->at, instance->values.of[role]);
    case LAG_ROLE_ENERGY:
        return model->energies(&motion->at, &energy[0], &energy[1], &energy[2], &energy[3]);
    case LAG_ROLE_RESIDUAL:
        return residuals(instance);
    case LAG_ROLE_INDICATOR:
        return lag_instance_find_indicators(instance);
    default:
        return lag_derivatives_factor(&instance->derivatives, &motion->at, role == LAG_PULLED ? lag_instance_rate(instance) : 0.0, &motion->coordinate);
    }
}

/* Indicators have accelerations of their own, and only one kind of derivatives is kept. */
lag_status lag_instance_evaluate(lag_instance *instance, unsigned role)
{
    const lag_model *model = instance->fmu->model;
    const unsigned kinds = 1U << LAG_DERIVATIVES | 1U << LAG_PULLED;
    /* pulled accelerations need those of the model only where loads follow from these */
    const int needs_motion = role != LAG_ROLE_MULTIPLIER && (role != LAG_ROLE_DERIVATIVE || model->nc == 0 || model->nz + model->nload > 0);
    lag_status status = lag_instance_ready(instance);
    if (status != LAG_OK || ((instance->values.known | STORED) & 1U << role) != 0) {
        return status;
    }
    status = needs_motion ? lag_instance_evaluate(instance, LAG_ROLE_MULTIPLIER) : LAG_OK;
    status = status == LAG_OK ? lag_instance_judge(instance, find(instance, role)) : status;
    instance->values.known &= ~(role == LAG_ROLE_INDICATOR ? 1U << LAG_ROLE_MULTIPLIER : role >= LAG_ROLES ? kinds : 0);
    instance->values.known |= status == LAG_OK ? 1U << role : 0;
    return status;
}

lag_status lag_instance_assert(lag_instance *instance)
{
    instance->run->conditions.begun = 0;
    instance->values.known = 0;
    return instance->fmu->model->na > 0 ? lag_run_watch(instance->run, instance->held.t, instance->x, NULL) : LAG_OK;
}

/* ---- values ---- */

/* LAG_NOT_FINITE: a value of the motion that is none, or a whole number that an importer has no room for. */
static lag_status check_found(lag_instance *instance, const lag_variable *variable, const double *values)
{
    const int motion = (MOVED & 1U << variable->role) != 0;
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

lag_status lag_instance_get(lag_instance *instance, size_t variable, double *values)
{
    const lag_variable *which = &instance->fmu->variables[variable];
    const lag_role role = (lag_role)which->role;
    const double *found = role == LAG_ROLE_CONSTANT ? instance->fmu->constants.numbers : instance->values.of[role];
    const lag_status status = (PLAIN & 1U << role) != 0 ? LAG_OK : lag_instance_evaluate(instance, role);
    if (role == LAG_ROLE_INPUT) { /* the motion may have looked at them elsewhere in time */
        lag_instance_inputs_at(instance, 0, instance->held.t, instance->run->motion.u);
    }
    for (size_t i = 0; i < which->count && status == LAG_OK; ++i) {
        values[i] = found[which->first + i] * lag_instance_factor(instance, role, which->first + i);
    }
    return status == LAG_OK ? check_found(instance, which, values) : status;
}

/* ---- setting ---- */

/* 1: something changed. */
static int put(size_t count, const double *values, double *array)
{
    const int changed = !lag_same(count, array, values);
    lag_copy(count, values, array);
    return changed;
}

/* States until initialization ends are starts, afterwards the state. */
static int put_states(lag_instance *instance, const lag_variable *variable, const double *values)
{
    int changed = 0;
    if (instance->held.moving) {
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
    int changed = 0;
    switch ((lag_role)which->role) {
    case LAG_ROLE_PARAMETER:
    case LAG_ROLE_FREE:
        changed = put(which->count, values, instance->starts.parameters + which->first);
        changed = put(which->count, values, instance->p + which->first) || changed;
        held->prepared = held->prepared && !changed;
        break;
    case LAG_ROLE_STATE:
    case LAG_ROLE_DEPENDENT:
        changed = put_states(instance, which, values);
        break;
    case LAG_ROLE_INPUT:
        return lag_instance_set_input(instance, variable, 0, values);
    case LAG_ROLE_OPTION:
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
