/* Values that follow from the present state: computed on demand, kept until the importer sets a value. */
#include "lag/instance/instance_internal.h"

#include <math.h>
#include <string.h>

#include "lag/derivatives.h"
#include "lag/linalg/finite.h"

lag_status lag_instance_ready(lag_instance *instance)
{
    lag_held *held = &instance->held;
    if (!held->moving && !held->initialized) {
        return lag_instance_begin_at(instance);
    }
    if (!held->prepared) {
        held->prepared = 1;
        return lag_instance_judge(instance, lag_motion_parameters(&instance->run->motion, instance->p));
    }
    return LAG_OK;
}

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
    double *xd = instance->values.xd;
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
    return status == LAG_OK && !lag_finite(lag_motion_size(model), instance->values.xd) ? LAG_NOT_FINITE : status;
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
        status = lag_projection_look(projection, level > 0);
        for (size_t i = 0; i < model->nc; ++i) {
            const double part = level > 0 || model->position_level[i] ? fabs(projection->phi[i]) / instance->run->sizes.rows[i] : 0.0;
            status = status == LAG_OK && !isfinite(part) ? LAG_NOT_FINITE : status;
            values->residual[level] = fmax(values->residual[level], part);
            values->slip = level > 0 ? fmax(values->slip, part / lag_projection_pace(projection, i)) : 0.0;
        }
    }
    return status;
}

static lag_status outputs(lag_instance *instance)
{
    const lag_model *model = instance->fmu->model;
    const lag_status status = model->ny > 0 ? model->output(&instance->run->motion.at, instance->values.y) : LAG_OK;
    if (status == LAG_OK) {
        lag_run_unwind(instance->run, instance->values.y);
    }
    return status;
}

/* The values of one role; what they need is known. */
static lag_status find(lag_instance *instance, unsigned role)
{
    const lag_model *model = instance->fmu->model;
    lag_motion *motion = &instance->run->motion;
    double *energy = instance->values.energy;
    switch (role) {
    case LAG_ROLE_MULTIPLIER:
        return accelerations(instance);
    case LAG_ROLE_DERIVATIVE:
        return rates(instance);
    case LAG_ROLE_OUTPUT:
        return outputs(instance);
    case LAG_ROLE_LOCAL:
        return model->nd > 0 ? model->definition(&motion->at, instance->values.local) : LAG_OK;
    case LAG_ROLE_ENERGY:
        return model->energies(&motion->at, &energy[0], &energy[1], &energy[2], &energy[3]);
    case LAG_ROLE_RESIDUAL:
        return residuals(instance);
    case LAG_ROLE_INDICATOR:
        return lag_instance_find_indicators(instance);
    default:
        return lag_derivatives_look(&instance->derivatives, &motion->at, role == LAG_PULLED ? lag_instance_rate(instance) : 0.0, &motion->coordinate);
    }
}

/* They are known from now on. Indicators have accelerations of their own, and only one kind of derivatives is kept. */
static lag_status let_know(lag_instance *instance, unsigned role)
{
    const unsigned kinds = 1U << LAG_DERIVATIVES | 1U << LAG_PULLED;
    const lag_status status = lag_instance_judge(instance, find(instance, role));
    instance->values.known &= ~(role == LAG_ROLE_INDICATOR ? 1U << LAG_ROLE_MULTIPLIER : role >= LAG_ROLES ? kinds : 0);
    instance->values.known |= status == LAG_OK ? 1U << role : 0;
    return status;
}

lag_status lag_instance_evaluate(lag_instance *instance, unsigned role)
{
    const lag_model *model = instance->fmu->model;
    const unsigned *known = &instance->values.known;
    lag_status status = lag_instance_ready(instance);
    /* pulled accelerations need those of the model only where loads follow from these */
    const int needs_motion = role != LAG_ROLE_DERIVATIVE || model->nc == 0 || model->nz + model->nload > 0;
    if (status == LAG_OK && (*known & 1U << role) == 0 && needs_motion && (*known & 1U << LAG_ROLE_MULTIPLIER) == 0) {
        status = let_know(instance, LAG_ROLE_MULTIPLIER);
    }
    return status == LAG_OK && (*known & 1U << role) == 0 ? let_know(instance, role) : status;
}

lag_status lag_instance_assert(lag_instance *instance, double t, const double *x)
{
    instance->run->conditions.begun = 0;
    instance->values.known = 0;
    return instance->fmu->model->na > 0 ? lag_run_watch(instance->run, t, x, NULL) : LAG_OK;
}
