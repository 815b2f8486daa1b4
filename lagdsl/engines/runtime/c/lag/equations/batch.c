#include "lag/batch.h"

#include "lag/dynamics.h"
#include "lag/linalg/finite.h"
#include "lag/linalg/arena.h"

static const double *of_state(lag_strided array, size_t i)
{
    return array.first + i * array.stride;
}

static lag_arguments state(const lag_model *model, const lag_batch *batch, size_t i)
{
    lag_arguments at;
    at.t = *of_state(batch->t, i);
    at.q = of_state(batch->q, i);
    at.qd = of_state(batch->qd, i);
    at.z = of_state(batch->z, i);
    at.u = of_state(batch->u, i);
    at.w = of_state(batch->w, i);
    at.p = of_state(batch->p, i);
    at.qdd = of_state(batch->qdd, i);
    at.lam = of_state(batch->lam, i);
    at.dq = of_state(batch->dq, i);
    at.dqd = of_state(batch->dqd, i);
    at.dz = of_state(batch->dz, i);
    at.du = of_state(batch->du, i);
    at.dp = of_state(batch->dp, i);
    at.dqdd = of_state(batch->dqdd, i);
    at.dlam = of_state(batch->dlam, i);
    at.times = NULL;
    at.context = model->context;
    at.workspace = batch->workspace;
    at.kept = NULL;
    return at;
}

static lag_status prepare_one(const lag_model *model, const lag_batch *batch, const lag_arguments *at, size_t i)
{
    if (i > 0 && batch->p.stride == 0) {
        return LAG_OK;
    }
    return model->prepare(at);
}

lag_status lag_batch_evaluate(
    const lag_model *model, lag_function which, const lag_batch *batch, double *results, size_t width)
{
    for (size_t i = 0; i < batch->count; ++i) {
        const lag_arguments at = state(model, batch, i);
        lag_status status = prepare_one(model, batch, &at, i);
        if (status == LAG_OK) {
            status = lag_evaluate(model, which, &at, results + i * width);
        }
        if (status != LAG_OK) {
            return status;
        }
    }
    return LAG_OK;
}

static lag_status worse(lag_status first, lag_status status)
{
    return first == LAG_OK || status == LAG_SINGULAR ? status : first;
}

/* One state after the other. */
static lag_status solve_singly(
    const lag_model *model, const lag_batch *batch, double *qdd, double *lam, size_t *coordinate)
{
    lag_status first = LAG_OK;
    for (size_t i = 0; i < batch->count && first != LAG_SINGULAR; ++i) {
        const lag_arguments at = state(model, batch, i);
        lag_status status = prepare_one(model, batch, &at, i);
        if (status == LAG_OK) {
            status = lag_forward_dynamics(model, &at, batch->memory, qdd + i * model->nq, lam + i * model->nc, coordinate);
        }
        first = worse(first, status);
    }
    return first;
}

/* A state that several at once could not solve. */
static lag_status solve_again(
    const lag_model *model, const lag_batch *batch, size_t i, double *qdd, double *lam, size_t *coordinate)
{
    const lag_arguments at = state(model, batch, i);
    const lag_status status = model->prepare(&at);
    return status == LAG_OK ? lag_forward_dynamics(model, &at, batch->memory, qdd, lam, coordinate) : status;
}

/* Arrays of several states, all in lanes; `at` are their arguments. */
typedef struct crowd {
    double *t, *q, *qd, *z, *u, *w, *p;
    double *mass, *force, *jacobian, *gamma;
    double *lam, *response, *lam_response, *pivot;
    lag_arguments at;
} crowd;

static size_t place(const lag_model *model, const lag_states *states, double *memory, crowd *all)
{
    const size_t n = model->nq;
    const size_t m = model->nc;
    const size_t kept = model->nk;
    const size_t lanes = states->lanes;
    const int dense = states->elimination == NULL;
    double *end = memory;
    all->t = lag_take(&end, lanes);
    all->q = lag_take(&end, lanes * n);
    all->qd = lag_take(&end, lanes * n);
    all->z = lag_take(&end, lanes * model->nz);
    all->u = lag_take(&end, lanes * model->nu);
    all->w = lag_take(&end, lanes * model->nw);
    all->p = lag_take(&end, lanes * model->np);
    all->force = lag_take(&end, lanes * n);
    all->jacobian = lag_take(&end, lanes * n * (dense ? m : kept));
    all->gamma = lag_take(&end, lanes * (dense ? m : kept));
    all->mass = lag_take(&end, dense ? lanes * n * n : 0);
    all->lam = lag_take(&end, dense ? 0 : lanes * m);
    all->response = lag_take(&end, dense ? 0 : lanes * kept * n);
    all->lam_response = lag_take(&end, dense ? 0 : lanes * kept * m);
    all->pivot = lag_take(&end, lanes);
    all->at = (lag_arguments){
        .times = all->t, .q = all->q, .qd = all->qd, .z = all->z, .u = all->u, .w = all->w, .p = all->p, .workspace = end,
        .context = model->context
    };
    return (size_t)(end - memory) + states->workspace;
}

size_t lag_batch_memory(const lag_model *model, const lag_states *states)
{
    const size_t n = model->nq;
    const size_t m = model->nc;
    const size_t kept = model->nk;
    const size_t arguments = 1 + 2 * n + model->nz + model->nu + model->nw + model->np;
    const size_t formed = states->elimination == NULL ? m * n + m + n * n : kept * n + kept + m + kept * n + kept * m;
    return states->lanes * (arguments + n + formed + 1) + states->workspace;
}

/* Two numbers at `to`, by one instruction where the compiler knows vectors: half as many writes. */
static void put_pair(double *to, double first, double second)
{
#if defined(__GNUC__)
    typedef double pair __attribute__((vector_size(16), aligned(8), may_alias));
    *(pair *)(void *)to = (pair){first, second};
#else
    to[0] = first;
    to[1] = second;
#endif
}

/*
 * Array x of the states from `first` on, in groups of lanes; the last state fills lanes that have none. Four lanes at a time:
 * their reads and writes wait for nothing.
 */
static void interleave(
    double *to, size_t lanes, size_t first, size_t count, size_t size, lag_strided x)
{
    const size_t stride = x.stride;
    if (size == 0 || (first > 0 && stride == 0)) {
        return;
    }
    const double *const from = of_state(x, first);
    size_t lane = 0;
    for (; lane + 4 <= count; lane += 4) {
        const double *const a = from + lane * stride;
        const double *const b = a + stride;
        const double *const c = b + stride;
        const double *const d = c + stride;
        double *own = to + lane;
        for (size_t i = 0; i < size; ++i, own += lanes) {
            put_pair(own, a[i], b[i]);
            put_pair(own + 2, c[i], d[i]);
        }
    }
    for (; lane < lanes; ++lane) {
        const double *const own = from + (lane < count ? lane : count - 1) * stride;
        for (size_t i = 0; i < size; ++i) {
            to[i * lanes + lane] = own[i];
        }
    }
}

/* Equations of `count` states from `first` on, at most as many as there are lanes. */
static lag_status form(
    const lag_model *model, const lag_states *states, const lag_batch *batch, size_t first, size_t count, const crowd *all)
{
    const size_t lanes = states->lanes;
    interleave(all->t, lanes, first, count, 1, batch->t);
    interleave(all->q, lanes, first, count, model->nq, batch->q);
    interleave(all->qd, lanes, first, count, model->nq, batch->qd);
    interleave(all->z, lanes, first, count, model->nz, batch->z);
    interleave(all->u, lanes, first, count, model->nu, batch->u);
    interleave(all->w, lanes, first, count, model->nw, batch->w);
    interleave(all->p, lanes, first, count, model->np, batch->p);
    lag_status status = first > 0 && batch->p.stride == 0 ? LAG_OK : states->prepare(&all->at);
    if (status == LAG_OK && states->elimination != NULL) {
        return states->elimination(
            &all->at, all->force, all->lam, all->response, all->lam_response, all->jacobian, all->gamma, all->pivot);
    }
    return status == LAG_OK ? states->dynamics(&all->at, all->mass, all->force, all->jacobian, all->gamma) : status;
}

/* Array x of `count` lanes to the states that they belong to, two numbers at a time. */
static void deal(size_t lanes, size_t count, size_t size, const double *x, double *to)
{
    for (size_t lane = 0; lane < count; ++lane, to += size) {
        const double *own = x + lane;
        size_t i = 0;
        for (; i + 2 <= size; i += 2, own += 2 * lanes) {
            put_pair(to + i, own[0], own[lanes]);
        }
        if (i < size) {
            to[i] = own[0];
        }
    }
}

/* True if elimination solved all lanes and left no row to run time. */
static int solved(const lag_model *model, const lag_states *states, const crowd *all)
{
    if (states->elimination == NULL || model->nk > 0) {
        return 0;
    }
    const double smallest = lag_smallest_pivot(model);
    int sound = lag_finite(states->lanes * model->nq, all->force) && lag_finite(states->lanes * model->nc, all->lam);
    for (size_t lane = 0; lane < states->lanes; ++lane) {
        sound &= all->pivot[lane] > smallest;
    }
    return sound;
}

/* States `first` and following from the lanes, each by itself. */
static lag_status solve_lanes(
    const lag_model *model,
    const lag_states *states,
    const lag_batch *batch,
    const crowd *all,
    size_t first,
    size_t count,
    double *qdd,
    double *lam,
    size_t *coordinate)
{
    const lag_formed formed = {
        .lanes = states->lanes,
        .qdd = states->elimination == NULL ? NULL : all->force,
        .lam = all->lam,
        .response = all->response,
        .lam_response = all->lam_response,
        .pivot = all->pivot,
        .mass = all->mass,
        .force = all->force,
        .jacobian = all->jacobian,
        .gamma = all->gamma,
    };
    lag_status worst = LAG_OK;
    for (size_t lane = 0; lane < count && worst != LAG_SINGULAR; ++lane) {
        double *own_qdd = qdd + (first + lane) * model->nq;
        double *own_lam = lam + (first + lane) * model->nc;
        lag_status status = lag_forward_dynamics_of_lane(model, &formed, lane, batch->memory, own_qdd, own_lam, coordinate);
        if (status == LAG_MISSING) {
            status = solve_again(model, batch, first + lane, own_qdd, own_lam, coordinate);
        }
        worst = worse(worst, status);
    }
    return worst;
}

lag_status lag_batch_forward_dynamics(
    const lag_model *model,
    const lag_states *states,
    const lag_batch *batch,
    double *qdd,
    double *lam,
    size_t *coordinate)
{
    if (model->nload > 0 || states == NULL || states->lanes == 0 || (states->elimination == NULL && states->dynamics == NULL)) {
        return solve_singly(model, batch, qdd, lam, coordinate);
    }
    const size_t lanes = states->lanes;
    crowd all;
    lag_status worst = LAG_OK;
    place(model, states, batch->lanes, &all);
    for (size_t first = 0; first < batch->count && worst != LAG_SINGULAR; first += lanes) {
        const size_t count = batch->count - first < lanes ? batch->count - first : lanes;
        const lag_status status = form(model, states, batch, first, count, &all);
        if (status != LAG_OK) {
            return status;
        }
        if (solved(model, states, &all)) {
            deal(lanes, count, model->nq, all.force, qdd + first * model->nq);
            deal(lanes, count, model->nc, all.lam, lam + first * model->nc);
        } else {
            worst = worse(worst, solve_lanes(model, states, batch, &all, first, count, qdd, lam, coordinate));
        }
    }
    return worst;
}

lag_status lag_batch_jacobian(
    const lag_model *model,
    const lag_tangents *tangents,
    const lag_batch *batch,
    lag_range x,
    double *rates,
    double *outputs,
    size_t *coordinate)
{
    const size_t width = (2 * model->nq + model->nz) * x.count;
    lag_status first = LAG_OK;
    for (size_t i = 0; i < batch->count && first != LAG_SINGULAR; ++i) {
        const lag_arguments at = state(model, batch, i);
        double *own = outputs == NULL ? NULL : outputs + i * model->ny * x.count;
        lag_status status = prepare_one(model, batch, &at, i);
        if (status == LAG_OK) {
            status = lag_jacobian(model, tangents, &at, x, batch->memory, rates + i * width, own, coordinate);
        }
        first = worse(first, status);
    }
    return first;
}
