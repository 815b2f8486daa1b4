#include "lag/dynamics.h"
#include "lag/evaluate.h"

static lag_arguments state(const lag_batch *batch, size_t i)
{
    lag_arguments at;
    at.t = batch->t[i * batch->t_stride];
    at.q = batch->q + i * batch->q_stride;
    at.qd = batch->qd + i * batch->qd_stride;
    at.z = batch->z + i * batch->z_stride;
    at.u = batch->u + i * batch->u_stride;
    at.w = batch->w + i * batch->w_stride;
    at.p = batch->p + i * batch->p_stride;
    at.qdd = batch->qdd + i * batch->qdd_stride;
    at.lam = batch->lam + i * batch->lam_stride;
    at.dq = batch->dq + i * batch->dq_stride;
    at.dqd = batch->dqd + i * batch->dqd_stride;
    at.dz = batch->dz + i * batch->dz_stride;
    at.du = batch->du + i * batch->du_stride;
    at.dp = batch->dp + i * batch->dp_stride;
    at.dqdd = batch->dqdd + i * batch->dqdd_stride;
    at.dlam = batch->dlam + i * batch->dlam_stride;
    at.relations = NULL;
    at.times = NULL;
    at.workspace = batch->workspace;
    return at;
}

static lag_status prepare(const lag_model *model, const lag_batch *batch, size_t i)
{
    if (i > 0 && batch->p_stride == 0) {
        return LAG_OK;
    }
    return model->prepare(batch->p + i * batch->p_stride, batch->workspace);
}

lag_status lag_batch_evaluate(
    const lag_model *model, lag_function which, const lag_batch *batch, double *results, size_t width)
{
    for (size_t i = 0; i < batch->count; ++i) {
        const lag_arguments at = state(batch, i);
        lag_status status = prepare(model, batch, i);
        if (status == LAG_OK) {
            status = lag_evaluate(model, which, &at, results + i * width);
        }
        if (status != LAG_OK) {
            return status;
        }
    }
    return LAG_OK;
}

static lag_status one_by_one(
    const lag_model *model,
    const lag_batch *batch,
    size_t start,
    size_t end,
    double *qdd,
    double *lam,
    size_t *coordinate)
{
    lag_status first = LAG_OK;
    for (size_t i = start; i < end && first != LAG_SINGULAR; ++i) {
        const lag_arguments at = state(batch, i);
        lag_status status = prepare(model, batch, i);
        if (status == LAG_OK) {
            status = lag_forward_dynamics(model, &at, batch->memory, qdd + i * model->nq, lam + i * model->nc, coordinate);
        }
        if (first == LAG_OK || status == LAG_SINGULAR) {
            first = status;
        }
    }
    return first;
}

size_t lag_batch_memory(const lag_model *model)
{
    const size_t n = model->nq;
    const size_t m = model->nc;
    const size_t arguments = 1 + 2 * n + model->nz + model->nu + model->nw + model->np;
    const size_t formed = n * n + n + m * n + m + 1 + model->nk * (n + m) + m;
    return model->dynamics_lanes == NULL ? 0 : model->lanes * (arguments + formed) + model->workspace_lanes;
}

/* Array x of the states from `first` on, in groups of lanes; the last state fills lanes that have none. */
static double *interleave(
    double **memory, size_t lanes, size_t first, size_t count, size_t size, const double *x, size_t stride)
{
    double *start = *memory;
    for (size_t lane = 0; lane < lanes; ++lane) {
        const double *from = x + (first + (lane < count ? lane : count - 1)) * stride;
        for (size_t i = 0; i < size; ++i) {
            start[i * lanes + lane] = from[i];
        }
    }
    *memory += size * lanes;
    return start;
}

static lag_status prepare_lanes(
    const lag_model *model, const lag_batch *batch, size_t first, size_t count, double *workspace)
{
    if (first > 0 && batch->p_stride == 0) {
        return LAG_OK;
    }
    for (size_t lane = 0; lane < model->lanes; ++lane) {
        if (lane == 0 || (batch->p_stride != 0 && lane < count)) {
            const lag_status status = model->prepare(batch->p + (first + lane) * batch->p_stride, batch->workspace);
            if (status != LAG_OK) {
                return status;
            }
        }
        for (size_t i = 0; i < model->prepared; ++i) {
            workspace[i * model->lanes + lane] = batch->workspace[i];
        }
    }
    return LAG_OK;
}

/* Equations of `count` states from `first` on, at most as many as there are lanes. */
static lag_status form(
    const lag_model *model, const lag_batch *batch, size_t first, size_t count, lag_formed *formed)
{
    const size_t n = model->nq;
    const size_t m = model->nc;
    const size_t lanes = model->lanes;
    double *memory = batch->lanes;
    double *mass = memory;
    double *force = mass + n * n * lanes;
    double *jacobian = force + n * lanes;
    double *gamma = jacobian + m * n * lanes;
    lag_arguments at = state(batch, first);
    double *pivot = gamma + m * lanes;
    double *response = pivot + lanes;
    double *lam_response = response + model->nk * n * lanes;
    double *lam = lam_response + model->nk * m * lanes;
    at.workspace = lam + m * lanes;
    memory = at.workspace + model->workspace_lanes;
    at.times = interleave(&memory, lanes, first, count, 1, batch->t, batch->t_stride);
    at.q = interleave(&memory, lanes, first, count, n, batch->q, batch->q_stride);
    at.qd = interleave(&memory, lanes, first, count, n, batch->qd, batch->qd_stride);
    at.z = interleave(&memory, lanes, first, count, model->nz, batch->z, batch->z_stride);
    at.u = interleave(&memory, lanes, first, count, model->nu, batch->u, batch->u_stride);
    at.w = interleave(&memory, lanes, first, count, model->nw, batch->w, batch->w_stride);
    at.p = interleave(&memory, lanes, first, count, model->np, batch->p, batch->p_stride);
    formed->qdd = NULL;
    formed->lam = lam;
    formed->response = response;
    formed->lam_response = lam_response;
    formed->pivot = pivot;
    formed->mass = mass;
    formed->force = force;
    formed->jacobian = jacobian;
    formed->gamma = gamma;
    const lag_status status = prepare_lanes(model, batch, first, count, at.workspace);
    if (status == LAG_OK && model->elimination_lanes != NULL) { /* as for one state */
        formed->qdd = force;
        return model->elimination_lanes(&at, force, lam, response, lam_response, jacobian, gamma, pivot);
    }
    return status == LAG_OK ? model->dynamics_lanes(&at, mass, force, jacobian, gamma) : status;
}

lag_status lag_batch_forward_dynamics(
    const lag_model *model, const lag_batch *batch, double *qdd, double *lam, size_t *coordinate)
{
    if (batch->lanes == NULL || model->dynamics_lanes == NULL) {
        return one_by_one(model, batch, 0, batch->count, qdd, lam, coordinate);
    }
    lag_status worst = LAG_OK;
    for (size_t first = 0; first < batch->count; first += model->lanes) {
        const size_t count = batch->count - first < model->lanes ? batch->count - first : model->lanes;
        lag_formed formed;
        lag_status status = form(model, batch, first, count, &formed);
        if (status != LAG_OK) {
            return status;
        }
        for (size_t lane = 0; lane < count; ++lane) {
            const size_t i = first + lane;
            status = lag_forward_dynamics_of_lane(
                model, &formed, lane, batch->memory, qdd + i * model->nq, lam + i * model->nc, coordinate);
            if (status == LAG_MISSING) {
                status = one_by_one(model, batch, i, i + 1, qdd, lam, coordinate);
            }
            if (status == LAG_SINGULAR) {
                return status;
            }
            worst = worst == LAG_OK ? status : worst;
        }
    }
    return worst;
}

lag_status lag_batch_state_jacobian(
    const lag_model *model, const lag_batch *batch, double *jacobian, size_t *coordinate)
{
    const size_t total = 2 * model->nq + model->nz;
    lag_status first = LAG_OK;
    for (size_t i = 0; i < batch->count && first != LAG_SINGULAR; ++i) {
        const lag_arguments at = state(batch, i);
        lag_status status = prepare(model, batch, i);
        if (status == LAG_OK) {
            status = lag_state_jacobian(model, &at, batch->memory, jacobian + i * total * total, coordinate);
        }
        if (first == LAG_OK || status == LAG_SINGULAR) {
            first = status;
        }
    }
    return first;
}
