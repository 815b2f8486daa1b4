/* What follows from the present state, found when it is asked for and kept until something is set. */
#include "lag/parts.h"

#include <math.h>
#include <string.h>

#include "lag/derivatives.h"
#include "lag/finite.h"

lag_status lag_instance_ready(lag_instance *instance)
{
    lag_held *held = &instance->held;
    if (held->phase == LAG_PHASE_START && !held->initialized) {
        return lag_instance_settle(instance);
    }
    if (!held->prepared) {
        held->prepared = 1;
        return lag_instance_judge(instance, lag_motion_parameters(&instance->run->motion, instance->p));
    }
    return LAG_OK;
}

/* dx/dt; not finite values are an error here. */
static lag_status rates(lag_instance *instance)
{
    const lag_model *model = instance->fmu->model;
    const lag_motion *motion = &instance->run->motion;
    const size_t n = model->nq;
    memcpy(instance->xd, instance->x + n, n * sizeof(double));
    memcpy(instance->xd + n, motion->qdd, n * sizeof(double));
    const lag_status status = model->nz > 0 ? model->state_derivative(&motion->at, instance->xd + 2 * n) : LAG_OK;
    return status == LAG_OK && !lag_finite(lag_motion_size(model), instance->xd) ? LAG_NOT_FINITE : status;
}

/* The largest residuals of positions and of velocities, rows of size one. */
static lag_status residuals(lag_instance *instance)
{
    const lag_model *model = instance->fmu->model;
    const lag_arguments *at = &instance->run->motion.at;
    lag_projection *projection = &instance->run->projection;
    lag_status status = LAG_OK;
    instance->residual[0] = instance->residual[1] = 0.0;
    for (size_t level = 0; level < 2 && status == LAG_OK && model->nc > 0; ++level) {
        status = (level == 0 ? model->position_constraint : model->velocity_constraint)(at, projection->phi, projection->jacobian);
        for (size_t i = 0; i < model->nc && status == LAG_OK; ++i) {
            const double part = fabs(projection->phi[i]) / instance->run->row_sizes[i];
            if (!isfinite(part)) {
                return LAG_NOT_FINITE;
            }
            if (level > 0 || model->position_level[i]) {
                instance->residual[level] = fmax(instance->residual[level], part);
            }
        }
    }
    return status;
}

static lag_status outputs(lag_instance *instance)
{
    const lag_model *model = instance->fmu->model;
    const lag_status status = model->ny > 0 ? model->output(&instance->run->motion.at, instance->y) : LAG_OK;
    if (status == LAG_OK && instance->turning) {
        lag_instance_unwind(instance, instance->y);
    }
    return status;
}

/* One of what can be known; what it needs is. */
static lag_status find(lag_instance *instance, unsigned what)
{
    const lag_model *model = instance->fmu->model;
    lag_motion *motion = &instance->run->motion;
    double *energy = instance->energy;
    switch (what) {
    case LAG_KNOWN_MOTION:
        return lag_motion_solve_stabilized(motion, lag_instance_rate(instance), instance->held.t, instance->x);
    case LAG_KNOWN_RATES:
        return rates(instance);
    case LAG_KNOWN_OUTPUTS:
        return outputs(instance);
    case LAG_KNOWN_LOCALS:
        return model->nd > 0 ? model->definition(&motion->at, instance->local) : LAG_OK;
    case LAG_KNOWN_ENERGIES:
        return model->energies(&motion->at, &energy[0], &energy[1], &energy[2], &energy[3]);
    case LAG_KNOWN_RESIDUALS:
        return residuals(instance);
    case LAG_KNOWN_INDICATORS:
        return lag_instance_look(instance);
    case LAG_KNOWN_DERIVATIVES:
        return lag_derivatives_look(&instance->derivatives, &motion->at, lag_instance_rate(instance), &motion->coordinate);
    default:
        return LAG_MISSING;
    }
}

lag_status lag_instance_know(lag_instance *instance, unsigned what)
{
    lag_status status = lag_instance_ready(instance);
    unsigned missing = (what | LAG_KNOWN_MOTION) & ~instance->known;
    for (unsigned bit = LAG_KNOWN_MOTION; missing != 0 && status == LAG_OK; bit <<= 1) {
        if ((missing & bit) != 0) {
            status = lag_instance_judge(instance, find(instance, bit));
            instance->known |= status == LAG_OK ? bit : 0;
            instance->known &= bit == LAG_KNOWN_INDICATORS ? ~(unsigned)LAG_KNOWN_MOTION : ~0U; /* they want accelerations of their own */
            missing &= ~bit;
        }
    }
    return status;
}

lag_status lag_instance_assert(lag_instance *instance, double t, const double *x)
{
    const lag_model *model = instance->fmu->model;
    lag_watch *watch = &instance->run->watch;
    if (model->na == 0) {
        return LAG_OK;
    }
    instance->known = 0;
    lag_status status = lag_motion_solve(&instance->run->motion, t, x);
    if (status == LAG_OK) {
        status = model->monitor(&instance->run->motion.at, watch->value, watch->scale, watch->held);
    }
    for (size_t i = 0; i < model->na && status == LAG_OK; ++i) {
        status = watch->held[i] == 0.0 ? LAG_VIOLATED : LAG_OK;
    }
    return status;
}
