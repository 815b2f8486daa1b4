/*
 * Derivatives of variables, exact: a direction of the knowns, and how everything changes along it. Relations and contacts are held. Adjoint
 * ones are the same, known by known. Only where constraints decide about the start it takes differences (start_derivatives.c).
 */
#include "lag/instance/instance_internal.h"

#include <math.h>
#include <string.h>

#include "lag/linalg/arena.h"

/* Changes along a direction; the arrays lie in `slopes` of the instance. */
typedef struct changes {
    double *rates, *y, *local; /* (2 nq + nz) (ny) (nd) */
    double *energy;            /* (3) */
    double *residual[2];       /* (nc) of positions, of velocities */
    double *value[2];          /* (nc) these themselves */
    double worst[2];           /* how the largest of them change */
    unsigned known;            /* as in lag_instance */
} changes;

size_t lag_instance_slopes(const lag_model *model)
{
    const size_t after = lag_motion_size(model) + model->nu + model->ny + model->nd + 3 + 4 * model->nc;
    const size_t starts = lag_instance_start_slopes_memory(model);
    return after > starts ? after : starts;
}

static changes lay_out(const lag_instance *instance)
{
    const lag_model *model = instance->fmu->model;
    double *memory = instance->scratch.slopes;
    changes to = {.known = 0};
    to.rates = lag_take(&memory, lag_motion_size(model));
    to.y = lag_take(&memory, model->ny);
    to.local = lag_take(&memory, model->nd);
    to.energy = lag_take(&memory, 3);
    for (size_t level = 0; level < 2; ++level) {
        to.residual[level] = lag_take(&memory, model->nc);
        to.value[level] = lag_take(&memory, model->nc);
    }
    return to;
}

/* ---- the direction ---- */

/* Entry of a known in the direction; null if it is no known. */
static double *place_of(lag_instance *instance, const lag_known *known)
{
    const lag_model *model = instance->fmu->model;
    const lag_variable *variable = &instance->fmu->variables[known->variable];
    const size_t index = variable->first + known->element;
    double *x = instance->derivatives.x;
    switch ((lag_role)variable->role) {
    case LAG_ROLE_TIME:
        return &instance->derivatives.time;
    case LAG_ROLE_STATE:
        return x + index;
    case LAG_ROLE_DEPENDENT:
        return instance->held.phase == LAG_PHASE_START ? x + index : NULL;
    case LAG_ROLE_INPUT:
        return x + lag_motion_size(model) + index;
    case LAG_ROLE_PARAMETER:
        return x + lag_motion_size(model) + model->nu + index;
    default:
        return NULL;
    }
}

static void clear(lag_instance *instance)
{
    const lag_model *model = instance->fmu->model;
    lag_fill(lag_motion_size(model) + model->nu + model->np, 0.0, instance->derivatives.x);
    instance->derivatives.time = 0.0;
}

/* True if the motion begins at the start values: initialization moved none of them onto the constraints. */
static lag_status unmoved(lag_instance *instance, int *same)
{
    const lag_model *model = instance->fmu->model;
    const size_t n = model->nq;
    double *starts = instance->scratch.slopes;
    const lag_status status = model->start(&instance->derivatives.at, starts, starts + n, starts + 2 * n, starts + lag_motion_size(model));
    for (size_t i = 0; i < lag_motion_size(model) && *same; ++i) {
        *same = instance->x[i] == (instance->starts.given[i] != 0.0 ? instance->starts.values[i] : starts[i]);
    }
    return status;
}

/*
 * True if the start stays although constraints determine it: no start value and no value that the constraints read changes.
 * Parameters count, too, because they change the distance between states.
 */
static lag_status stays(lag_instance *instance, const double *starts, int *still)
{
    const lag_model *model = instance->fmu->model;
    lag_derivatives *d = &instance->derivatives;
    const size_t size = lag_motion_size(model);
    *still = model->ne == 0 && instance->fmu->start->free == NULL;
    for (size_t i = 0; i < size && *still; ++i) {
        *still = d->x[i] == 0.0 && (instance->starts.given[i] != 0.0 || starts[i] == 0.0);
    }
    int same = 1;
    lag_status status = LAG_OK;
    for (size_t i = 0; i < model->np && same; ++i) {
        same = d->at.dp[i] == 0.0;
    }
    if (!same && *still) {
        status = unmoved(instance, still);
    }
    if (status == LAG_OK) {
        status = lag_derivatives_residuals(d, d->terms.phi, d->terms.residual);
    }
    for (size_t i = 0; i < model->nc && *still; ++i) {
        *still = d->terms.phi[i] == 0.0 && d->terms.residual[i] == 0.0;
    }
    return status;
}

/* Until initialization ends, states and inputs that were not set follow the parameters, as far as constraints let them. */
static lag_status follow_parameters(lag_instance *instance)
{
    const lag_model *model = instance->fmu->model;
    lag_derivatives *d = &instance->derivatives;
    const size_t n = model->nq;
    const size_t size = lag_motion_size(model);
    double *starts = instance->scratch.slopes;
    int still = d->time == 0.0;
    if (model->start_tangent == NULL) {
        return lag_instance_judge(instance, LAG_MISSING);
    }
    lag_status status = model->start_tangent(&d->at, starts, starts + n, starts + 2 * n, starts + size);
    for (size_t i = 0; i < model->nu; ++i) {
        d->x[size + i] += instance->inputs.given[i] != 0.0 ? 0.0 : starts[size + i];
    }
    if (status == LAG_OK && still && model->nc + model->ne > 0) {
        status = stays(instance, starts, &still);
    } else if (still) {
        for (size_t i = 0; i < size; ++i) {
            d->x[i] += instance->starts.given[i] != 0.0 ? 0.0 : starts[i];
        }
    }
    if (status == LAG_OK && !still) {
        status = lag_instance_start_slopes(instance);
    }
    return lag_instance_judge(instance, status);
}

/* Everything is ready for what changes along the direction that stands in `derivatives`. */
static lag_status find_changes(lag_instance *instance)
{
    lag_status status = LAG_OK;
    if (instance->held.phase == LAG_PHASE_START) {
        status = follow_parameters(instance);
    }
    return status == LAG_OK ? lag_instance_judge(instance, lag_derivatives_along(&instance->derivatives)) : status;
}

/* ---- what changes ---- */

/* The largest residual changes as the row does that has it. */
static lag_status residuals(lag_instance *instance, changes *to)
{
    const lag_model *model = instance->fmu->model;
    lag_derivatives *d = &instance->derivatives;
    lag_status status = lag_derivatives_residuals(d, to->residual[0], to->residual[1]);
    for (size_t level = 0; level < 2 && status == LAG_OK && model->nc > 0; ++level) {
        double most = 0.0;
        to->worst[level] = 0.0;
        status = (level == 0 ? model->position_constraint : model->velocity_constraint)(&d->at, to->value[level], d->work.unused);
        for (size_t i = 0; i < model->nc; ++i) {
            const double part = to->value[level][i] / instance->run->sizes.rows[i];
            if ((level > 0 || model->position_level[i]) && fabs(part) > most) {
                most = fabs(part);
                to->worst[level] = (part < 0.0 ? -1.0 : 1.0) * to->residual[level][i] / instance->run->sizes.rows[i];
            }
        }
    }
    return status;
}

static lag_status find(lag_instance *instance, changes *to, unsigned what)
{
    lag_derivatives *d = &instance->derivatives;
    if ((to->known & what) == what) {
        return LAG_OK;
    }
    to->known |= what;
    switch (what) {
    case LAG_KNOWN_RATES:
        return lag_derivatives_rates(d, to->rates);
    case LAG_KNOWN_OUTPUTS:
        return lag_derivatives_outputs(d, to->y);
    case LAG_KNOWN_LOCALS:
        return lag_derivatives_definitions(d, to->local);
    case LAG_KNOWN_ENERGIES:
        return lag_derivatives_energies(d, to->energy);
    default:
        return residuals(instance, to);
    }
}

/* Change of one unknown. */
static lag_status change(lag_instance *instance, changes *to, const lag_known *unknown, double *value)
{
    const lag_variable *variable = &instance->fmu->variables[unknown->variable];
    const size_t index = variable->first + unknown->element;
    const double *array = NULL;
    lag_status status = LAG_OK;
    if (lag_instance_is_free(instance, variable)) {
        *value = instance->derivatives.at.dp[index];
        return LAG_OK;
    }
    switch ((lag_role)variable->role) {
    case LAG_ROLE_STATE:
    case LAG_ROLE_DEPENDENT:
        array = instance->derivatives.x;
        break;
    case LAG_ROLE_DERIVATIVE:
        status = find(instance, to, LAG_KNOWN_RATES);
        array = to->rates;
        break;
    case LAG_ROLE_OUTPUT:
        status = find(instance, to, LAG_KNOWN_OUTPUTS);
        array = to->y;
        break;
    case LAG_ROLE_LOCAL:
        status = find(instance, to, LAG_KNOWN_LOCALS);
        array = to->local;
        break;
    case LAG_ROLE_MULTIPLIER:
        array = instance->derivatives.dlam;
        break;
    case LAG_ROLE_ENERGY:
        status = find(instance, to, LAG_KNOWN_ENERGIES);
        array = to->energy;
        break;
    case LAG_ROLE_RESIDUAL:
        status = find(instance, to, LAG_KNOWN_RESIDUALS);
        array = to->worst;
        break;
    default:
        return lag_instance_fail(instance, LAG_MISSING, "%s has no derivatives", instance->fmu->variables[unknown->variable].name);
    }
    *value = status == LAG_OK ? array[index] * lag_instance_factor(instance, (lag_role)variable->role, index) : 0.0;
    if (status == LAG_OK && !isfinite(*value)) {
        status = LAG_NOT_FINITE;
    }
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

/* True if one of the unknowns is such an acceleration (`pulled`) or is not. */
static int has(const lag_instance *instance, int pulled, const lag_known *unknown, size_t unknowns)
{
    size_t i = 0;
    while (i < unknowns && is_pulled(instance, &unknown[i]) != pulled) {
        ++i;
    }
    return i < unknowns;
}

/* Everything is ready for what changes along a direction, of one kind. */
static lag_status set_direction(lag_instance *instance, int pulled, const lag_known *known, size_t knowns, const double *seed)
{
    lag_status status = lag_instance_evaluate(instance, pulled ? LAG_KNOWN_PULLED : LAG_KNOWN_DERIVATIVES);
    clear(instance);
    for (size_t k = 0; k < knowns && status == LAG_OK; ++k) {
        double *place = place_of(instance, &known[k]);
        if (place == NULL) {
            return lag_instance_fail(
                instance, LAG_MISSING, "there are no derivatives with respect to %s", instance->fmu->variables[known[k].variable].name);
        }
        *place += seed[k];
    }
    if (instance->held.phase == LAG_PHASE_MOTION) {
        lag_instance_follow_direction(instance->fmu, instance->derivatives.x);
    }
    return status == LAG_OK ? find_changes(instance) : status;
}

lag_status lag_instance_directional(lag_instance *instance, const lag_known *unknown, size_t unknowns, const lag_known *known,
    size_t knowns, const double *seed, double *sensitivity)
{
    lag_status status = LAG_OK;
    for (int pulled = 0; pulled < 2 && status == LAG_OK; ++pulled) {
        changes to = lay_out(instance);
        if (!has(instance, pulled, unknown, unknowns)) {
            continue;
        }
        status = set_direction(instance, pulled, known, knowns, seed);
        for (size_t i = 0; i < unknowns && status == LAG_OK; ++i) {
            if (is_pulled(instance, &unknown[i]) == pulled) {
                status = change(instance, &to, &unknown[i], &sensitivity[i]);
            }
        }
    }
    return status;
}

/* Adds how all unknowns of one kind change with one known, times their seeds. */
static lag_status add_changes(lag_instance *instance, int pulled, const lag_known *unknown, size_t unknowns, const lag_known *known,
    const double *seed, double *sensitivity)
{
    static const double one = 1.0;
    changes to = lay_out(instance);
    lag_status status = set_direction(instance, pulled, known, 1, &one);
    for (size_t i = 0; i < unknowns && status == LAG_OK; ++i) {
        double value = 0.0;
        if (is_pulled(instance, &unknown[i]) == pulled) {
            status = change(instance, &to, &unknown[i], &value);
            *sensitivity += seed[i] * value;
        }
    }
    return status;
}

lag_status lag_instance_adjoint(lag_instance *instance, const lag_known *unknown, size_t unknowns, const lag_known *known,
    size_t knowns, const double *seed, double *sensitivity)
{
    lag_status status = LAG_OK;
    lag_fill(knowns, 0.0, sensitivity);
    for (int pulled = 0; pulled < 2; ++pulled) {
        const int any = has(instance, pulled, unknown, unknowns);
        for (size_t k = 0; any && k < knowns && status == LAG_OK; ++k) {
            status = add_changes(instance, pulled, unknown, unknowns, &known[k], seed, &sensitivity[k]);
        }
    }
    return status;
}
