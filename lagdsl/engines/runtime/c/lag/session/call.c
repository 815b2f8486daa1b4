#include "lag/call.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

#include "lag/dynamics.h"

/* To the bit. */
static int equal(size_t count, const double *a, const double *b)
{
    for (size_t i = 0; i < count; ++i) {
        uint64_t bits[2];
        memcpy(bits, a + i, sizeof *bits);
        memcpy(bits + 1, b + i, sizeof *bits);
        if (bits[0] != bits[1]) {
            return 0;
        }
    }
    return 1;
}

/* Computes what only parameters change, where they did. */
static lag_status prepare(lag_call *call, const lag_arguments *at, int given)
{
    const size_t count = call->model->np;
    const int wanted = (given & LAG_GIVEN_P) != 0 ? LAG_PREPARED_GIVEN : LAG_PREPARED_DEFAULTS;
    if (call->prepared == wanted && (wanted == LAG_PREPARED_DEFAULTS || equal(count, call->parameters, at->p))) {
        return LAG_OK;
    }
    call->prepared = LAG_PREPARED_NONE;
    call->started = (double)NAN;
    const lag_status status = lag_prepare(call->model, at);
    if (status == LAG_OK) {
        call->prepared = wanted;
        memcpy(call->parameters, at->p, wanted == LAG_PREPARED_GIVEN ? count * sizeof(double) : 0);
    }
    return status;
}

/* The initial states and inputs, where they are left out. */
static lag_status start(lag_call *call, lag_arguments *at, int given)
{
    const lag_model *model = call->model;
    const int states = model->nz > 0 && (given & LAG_GIVEN_Z) == 0;
    const int inputs = model->nu > 0 && (given & LAG_GIVEN_U) == 0;
    if (!states && !inputs) {
        return LAG_OK;
    }
    if (call->started != at->t) {
        const lag_status status = lag_evaluate(model, LAG_START, at, call->start);
        if (status != LAG_OK && status != LAG_NOT_FINITE) {
            return status;
        }
        call->started = at->t;
    }
    double *z = call->start + 2 * model->nq;
    at->z = states ? z : at->z;
    at->u = inputs ? z + model->nz : at->u;
    return LAG_OK;
}

static lag_status solve(lag_call *call, lag_arguments *at, double *qdd)
{
    double *lam = qdd + call->model->nq;
    const lag_status status = lag_forward_dynamics(call->model, at, call->memory, qdd, lam, &call->coordinate);
    at->qdd = qdd;
    at->lam = lam;
    return status;
}

/* The discretes, where they are left out. */
static lag_status stand(lag_call *call, lag_arguments *at, int given)
{
    const lag_model *model = call->model;
    if (model->nw == 0 || (given & LAG_GIVEN_W) != 0) {
        return LAG_OK;
    }
    double *started = call->standing;
    double *standing = started + model->nw;
    const double *qdd = at->qdd;
    lag_evaluate(model, LAG_DISCRETE_START, at, started);
    at->w = started;
    const lag_status status = solve(call, at, call->solved);
    if (status == LAG_SINGULAR) {
        return status;
    }
    lag_evaluate(model, LAG_STANDING, at, standing);
    at->w = standing;
    at->qdd = qdd;
    return LAG_OK;
}

static lag_status value(lag_call *call, lag_arguments *at)
{
    const lag_model *model = call->model;
    lag_status status;
    switch (call->what) {
    case LAG_CALL_SOLVE:
        return solve(call, at, call->results);
    case LAG_CALL_OUTPUT:
        status = solve(call, at, call->solved);
        return status == LAG_SINGULAR ? status : lag_evaluate(model, LAG_OUTPUT, at, call->results);
    case LAG_CALL_RATES_JACOBIAN:
    case LAG_CALL_OUTPUT_JACOBIAN: {
        double *outputs = call->results + (2 * model->nq + model->nz) * call->x.count;
        return lag_jacobian(model, call->tangents, at, call->x, call->memory, call->results,
            call->what == LAG_CALL_OUTPUT_JACOBIAN ? outputs : NULL, &call->coordinate);
    }
    default:
        return lag_evaluate(model, (lag_function)call->what, at, call->results);
    }
}

lag_status lag_call_once(lag_call *call, int given)
{
    lag_arguments at = call->at;
    at.qd = (given & LAG_GIVEN_QD) != 0 ? at.qd : call->zero;
    at.p = (given & LAG_GIVEN_P) != 0 ? at.p : call->model->defaults;
    lag_status status = prepare(call, &at, given);
    status = status == LAG_OK ? start(call, &at, given) : status;
    status = status == LAG_OK ? stand(call, &at, given) : status;
    status = status == LAG_OK ? value(call, &at) : status;
    if (call->left > 0 && --call->left == 0 && status != LAG_SINGULAR) {
        return LAG_ATTENTION;
    }
    return status;
}
