/*
 * Derivatives of variables, exact: a direction of the knowns, and how everything changes along it. Relations and contacts are held. Adjoint
 * ones are the same, known by known; those in time are along the motion. Only where constraints decide about the start it takes differences
 * (instance_start.c).
 */
#include "lag/instance/instance_internal.h"

#include <math.h>
#include <string.h>

#include "lag/linalg/arena.h"

/* By role: the direction of knowns, and how unknowns change along it, in `slopes` of the instance; null: these have no derivatives. */
typedef struct changes {
    double *of[LAG_ROLES];
    unsigned known; /* one bit for each role */
} changes;

static changes lay_out(lag_instance *instance)
{
    const lag_model *model = instance->fmu->model;
    const size_t size = lag_motion_size(model);
    lag_derivatives *d = &instance->derivatives;
    double *memory = instance->scratch;
    changes to = {.known = 0};
    to.of[LAG_ROLE_TIME] = &d->time;
    to.of[LAG_ROLE_STATE] = to.of[LAG_ROLE_DEPENDENT] = d->x;
    to.of[LAG_ROLE_INPUT] = d->x + size;
    to.of[LAG_ROLE_PARAMETER] = to.of[LAG_ROLE_FREE] = d->x + size + model->nu;
    to.of[LAG_ROLE_MULTIPLIER] = d->dlam;
    to.of[LAG_ROLE_DERIVATIVE] = lag_take(&memory, size);
    to.of[LAG_ROLE_OUTPUT] = lag_take(&memory, model->ny);
    to.of[LAG_ROLE_LOCAL] = lag_take(&memory, model->nd);
    to.of[LAG_ROLE_ENERGY] = lag_take(&memory, 3);
    return to;
}

/* ---- the direction ---- */

/* Roles of knowns; until a motion begins dependent entries are, too. */
static const unsigned KNOWN = LAG_BIT(TIME) | LAG_BIT(STATE) | LAG_BIT(INPUT) | LAG_BIT(PARAMETER) | LAG_BIT(FREE);

/* Until initialization ends, states and inputs that were not set follow the parameters, as far as constraints let them. */
static lag_status follow_parameters(lag_instance *instance)
{
    const lag_model *model = instance->fmu->model;
    lag_derivatives *d = &instance->derivatives;
    const size_t n = model->nq;
    const size_t size = lag_motion_size(model);
    double *starts = instance->scratch;
    if (model->start_tangent == NULL) {
        return LAG_MISSING;
    }
    const lag_status status = model->start_tangent(&d->at, starts, starts + n, starts + 2 * n, starts + size);
    for (size_t i = 0; i < model->nu; ++i) {
        d->x[size + i] += instance->inputs.given[i] ? 0.0 : starts[size + i];
    }
    if (status != LAG_OK || model->nc + model->ne > 0 || d->time != 0.0) {
        return status == LAG_OK ? lag_instance_start_slopes(instance) : status;
    }
    for (size_t i = 0; i < size; ++i) {
        d->x[i] += instance->starts.given[i] ? 0.0 : starts[i];
    }
    return LAG_OK;
}

/* ---- what changes ---- */

/* Functions that tell it for all variables of a role; null: `derivatives` have it. */
static lag_status (*const FOLLOWING[LAG_ROLES])(lag_derivatives *, double *) = {
    [LAG_ROLE_DERIVATIVE] = lag_derivatives_rates,
    [LAG_ROLE_OUTPUT] = lag_derivatives_outputs,
    [LAG_ROLE_LOCAL] = lag_derivatives_definitions,
    [LAG_ROLE_ENERGY] = lag_derivatives_energies,
};

/* Change of one unknown. */
static lag_status change(lag_instance *instance, changes *to, const lag_known *unknown, double *value)
{
    const lag_variable *variable = &instance->fmu->variables[unknown->variable];
    const lag_role role = (lag_role)variable->role;
    const size_t index = variable->first + unknown->element;
    if (to->of[role] == NULL) {
        return lag_instance_fail(instance, LAG_MISSING, "%s has no derivatives", variable->name);
    }
    lag_status status = LAG_OK;
    if (FOLLOWING[role] != NULL && (to->known & 1U << role) == 0) {
        status = FOLLOWING[role](&instance->derivatives, to->of[role]);
        to->known |= 1U << role;
    }
    *value = to->of[role][index] * lag_instance_factor(instance, role, index);
    status = status == LAG_OK && !isfinite(*value) ? LAG_NOT_FINITE : status;
    return lag_instance_judge(instance, status);
}

/* ---- what importers ask for ---- */

/* True for an acceleration with constraint stabilization; all other unknowns follow from the model's accelerations. */
static int is_pulled(const lag_instance *instance, const lag_known *unknown)
{
    const lag_model *model = instance->fmu->model;
    const lag_variable *variable = &instance->fmu->variables[unknown->variable];
    const size_t index = variable->first + unknown->element;
    return variable->role == LAG_ROLE_DERIVATIVE && model->nc > 0 && index >= model->nq && index < 2 * model->nq;
}

/* Everything is ready for what changes along a direction, of one kind. */
static lag_status set_direction(lag_instance *instance, const changes *to, int pulled, const lag_known *known, size_t knowns, const double *seed)
{
    const lag_model *model = instance->fmu->model;
    lag_derivatives *d = &instance->derivatives;
    const unsigned roles = KNOWN | (instance->held.moving ? 0 : 1U << LAG_ROLE_DEPENDENT);
    lag_status status = lag_instance_evaluate(instance, pulled ? LAG_PULLED : LAG_DERIVATIVES);
    lag_fill(lag_motion_size(model) + model->nu + model->np, 0.0, d->x);
    d->time = 0.0;
    for (size_t k = 0; k < knowns && status == LAG_OK; ++k) {
        const lag_variable *variable = &instance->fmu->variables[known[k].variable];
        if ((roles & 1U << variable->role) == 0) {
            return lag_instance_fail(instance, LAG_MISSING, "there are no derivatives with respect to %s", variable->name);
        }
        to->of[variable->role][variable->first + known[k].element] += seed[k];
    }
    if (status != LAG_OK) {
        return status;
    }
    if (instance->held.moving) {
        lag_instance_follow_states(instance->fmu, NULL, d->x);
    } else {
        status = follow_parameters(instance);
    }
    return lag_instance_judge(instance, status == LAG_OK ? lag_derivatives_along(d) : status);
}

lag_status lag_instance_slopes(lag_instance *instance, int adjoint, const lag_known *unknown, size_t unknowns, const lag_known *known,
    size_t knowns, const double *seed, double *sensitivity)
{
    static const double one = 1.0;
    size_t of_kind[2] = {0, 0};
    lag_status status = LAG_OK;
    for (size_t i = 0; i < unknowns; ++i) {
        ++of_kind[is_pulled(instance, &unknown[i])];
    }
    lag_fill(adjoint ? knowns : unknowns, 0.0, sensitivity);
    for (int pulled = 0; pulled < 2; ++pulled) {
        const size_t directions = of_kind[pulled] == 0 ? 0 : adjoint ? knowns : 1;
        for (size_t k = 0; k < directions && status == LAG_OK; ++k) {
            changes to = lay_out(instance);
            status = set_direction(instance, &to, pulled, known + k, adjoint ? 1 : knowns, adjoint ? &one : seed);
            for (size_t i = 0; i < unknowns && status == LAG_OK; ++i) {
                double value = 0.0;
                status = is_pulled(instance, &unknown[i]) == pulled ? change(instance, &to, &unknown[i], &value) : LAG_OK;
                sensitivity[adjoint ? k : i] += adjoint ? seed[i] * value : value;
            }
        }
    }
    return status;
}

lag_status lag_instance_get_output_derivative(lag_instance *instance, size_t variable, int order, double *values)
{
    const lag_model *model = instance->fmu->model;
    lag_derivatives *d = &instance->derivatives;
    const size_t size = lag_motion_size(model);
    changes to = lay_out(instance);
    if (order != 1) {
        return lag_instance_fail(instance, LAG_MISSING, "derivatives of outputs are known up to order 1");
    }
    lag_status status = lag_instance_evaluate(instance, LAG_ROLE_DERIVATIVE);
    status = status == LAG_OK ? lag_instance_evaluate(instance, LAG_DERIVATIVES) : status;
    memcpy(d->x, instance->values.of[LAG_ROLE_DERIVATIVE], size * sizeof(double));
    lag_instance_inputs_at(instance, 1, instance->held.t, d->x + size);
    lag_fill(model->np, 0.0, d->x + size + model->nu);
    d->time = 1.0;
    status = status == LAG_OK ? lag_instance_judge(instance, lag_derivatives_along(d)) : status;
    for (size_t i = 0; i < instance->fmu->variables[variable].count && status == LAG_OK; ++i) {
        status = change(instance, &to, &(lag_known){variable, i}, &values[i]);
    }
    return status;
}
