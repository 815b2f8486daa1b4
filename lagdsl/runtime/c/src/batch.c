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

lag_status lag_batch_forward_dynamics(
    const lag_model *model, const lag_batch *batch, double *qdd, double *lam, size_t *coordinate)
{
    lag_status first = LAG_OK;
    for (size_t i = 0; i < batch->count && first != LAG_SINGULAR; ++i) {
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
