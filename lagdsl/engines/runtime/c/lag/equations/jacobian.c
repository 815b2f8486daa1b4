#include "lag/equations/jacobian.h"

#include <math.h>
#include <string.h>

#include "lag/equations/delassus.h"
#include "lag/dynamics.h"
#include "lag/linalg/finite.h"
#include "lag/linalg/arena.h"

/* Functions of `lanes` directions at once; with one lane they are those of the model itself. */
typedef struct functions {
    size_t lanes;
    lag_status (*residual)(const lag_arguments *at, double *motion, double *rows);
    lag_status (*acceleration)(const lag_arguments *at, double *qdd, double *lam, double *rows, double *pivot);
    lag_status (*state_derivative)(const lag_arguments *at, double *rates);
    lag_status (*output)(const lag_arguments *at, double *y);
} functions;

/* Arrays in lanes. */
typedef struct lanes_of_directions {
    double *x;                         /* directions of q, qd, z, u, p in a row */
    double *dqdd, *dlam;               /* (nq) (nc) */
    double *motion, *rows, *rates, *y; /* (nq) (nc) (nz) (ny) */
    double *pivot;
} lanes_of_directions;

/* Of the rows that elimination left. */
typedef struct kept_rows {
    double *response, *lam_response; /* (nk, nq) (nk, nc) */
    double *jacobian, *gamma;        /* (nk, nq) (nk) */
    double *delassus;
} kept_rows;

typedef struct dense_system {
    double *mass, *jacobian; /* (nq, nq) (nc, nq) */
    double *force, *gamma;   /* (nq) (nc) */
    double *system;
} dense_system;

/* Arrays that the functions of this file work in. */
typedef struct places {
    double *qdd, *lam;         /* (nq) (nc) at the state */
    double *one_qdd, *one_lam; /* (nq) (nc) along one direction */
    lanes_of_directions lanes;
    kept_rows kept;
    dense_system dense;
    double *dynamics;          /* of lag_forward_dynamics() */
} places;

static size_t variables(const lag_model *model)
{
    return 2 * model->nq + model->nz + model->nu + model->np;
}

static size_t lanes_of(const lag_tangents *tangents)
{
    return tangents == NULL || tangents->lanes == 0 ? 1 : tangents->lanes;
}

/* Lays out `at` and returns how many doubles that takes; what is in lanes comes first, so that it is aligned as `memory` is. */
static size_t place(const lag_model *model, size_t lanes, double *memory, places *at)
{
    const size_t n = model->nq;
    const size_t m = model->nc;
    double *end = memory;
    at->lanes.x = lag_take(&end, lanes * variables(model));
    at->lanes.dqdd = lag_take(&end, lanes * n);
    at->lanes.dlam = lag_take(&end, lanes * m);
    at->lanes.motion = lag_take(&end, lanes * n);
    at->lanes.rows = lag_take(&end, lanes * m);
    at->lanes.rates = lag_take(&end, lanes * model->nz);
    at->lanes.y = lag_take(&end, lanes * model->ny);
    at->lanes.pivot = lag_take(&end, lanes);
    at->qdd = lag_take(&end, n);
    at->lam = lag_take(&end, m);
    at->one_qdd = lag_take(&end, n);
    at->one_lam = lag_take(&end, m);
    at->dense.force = lag_take(&end, n);
    at->dense.gamma = lag_take(&end, m);
    at->dense.mass = lag_take(&end, n * n);
    at->dense.jacobian = lag_take(&end, m * n);
    at->kept.response = lag_take(&end, model->nk * n);
    at->kept.lam_response = lag_take(&end, model->nk * m);
    at->kept.jacobian = lag_take(&end, model->nk * n);
    at->kept.gamma = lag_take(&end, model->nk);
    at->kept.delassus = lag_take(&end, lag_delassus_memory(m, model->nk));
    at->dense.system = lag_take(&end, lag_system_memory(n, m));
    at->dynamics = lag_take(&end, lag_dynamics_memory(model));
    return (size_t)(end - memory);
}

size_t lag_jacobian_memory(const lag_model *model, const lag_tangents *tangents)
{
    const size_t n = model->nq;
    const size_t m = model->nc;
    const size_t lanes = lanes_of(tangents) * (variables(model) + 2 * n + 2 * m + model->nz + model->ny + 1);
    const size_t kept = model->nk * (2 * n + m + 1) + lag_delassus_memory(m, model->nk);
    const size_t dense = n * n + m * n + lag_system_memory(n, m);
    return lanes + 3 * n + 3 * m + kept + dense + lag_dynamics_memory(model) + lag_linearization_memory(model, lanes_of(tangents));
}

size_t lag_jacobian_workspace(const lag_model *model, const lag_tangents *tangents)
{
    return tangents != NULL && tangents->workspace > model->workspace ? tangents->workspace : model->workspace;
}

/* The solver for accelerations and multipliers: the dense system, or the small one that elimination left. */
typedef struct solver {
    lag_system dense;
    lag_delassus kept;
} solver;

static void pick(size_t count, size_t lanes, size_t lane, double factor, const double *from, double *to)
{
    for (size_t i = 0; i < count; ++i) {
        to[i] = factor * from[i * lanes + lane];
    }
}

static void put_lane(size_t count, size_t lanes, size_t lane, const double *from, double *to)
{
    for (size_t i = 0; i < count; ++i) {
        to[i * lanes + lane] = from[i];
    }
}

/* dqdd and dlam from dr and ds, by the dense system. */
static void solve_dense(const lag_model *model, solver *by, size_t lanes, size_t width, const places *to)
{
    for (size_t lane = 0; lane < width; ++lane) {
        pick(model->nq, lanes, lane, -1.0, to->lanes.motion, to->dense.force);
        pick(model->nc, lanes, lane, -1.0, to->lanes.rows, to->dense.gamma);
        lag_system_solve(&by->dense, to->dense.force, to->dense.gamma, to->one_qdd, to->one_lam);
        put_lane(model->nq, lanes, lane, to->one_qdd, to->lanes.dqdd);
        put_lane(model->nc, lanes, lane, to->one_lam, to->lanes.dlam);
    }
}

/* dqdd and dlam completed for the rows that elimination left. */
static void solve_kept(const lag_model *model, solver *by, size_t lanes, size_t width, const places *to)
{
    for (size_t lane = 0; lane < width; ++lane) {
        pick(model->nq, lanes, lane, 1.0, to->lanes.dqdd, to->one_qdd);
        pick(model->nc, lanes, lane, 1.0, to->lanes.dlam, to->one_lam);
        pick(model->nk, lanes, lane, -1.0, to->lanes.rows, to->kept.gamma);
        lag_delassus_solve(&by->kept, to->kept.gamma, to->one_qdd, to->one_lam);
        put_lane(model->nq, lanes, lane, to->one_qdd, to->lanes.dqdd);
        put_lane(model->nc, lanes, lane, to->one_lam, to->lanes.dlam);
    }
}

/* dqdd and dlam along the directions in x. LAG_MISSING: elimination is no way to find them here. */
static lag_status solve(
    const lag_model *model, const functions *f, const lag_arguments *at, solver *by, size_t width, const places *to)
{
    if (f->acceleration == NULL) {
        const lag_status status = f->residual(at, to->lanes.motion, to->lanes.rows);
        if (status == LAG_OK) {
            solve_dense(model, by, f->lanes, width, to);
        }
        return status;
    }
    const lag_status status = f->acceleration(at, to->lanes.dqdd, to->lanes.dlam, to->lanes.rows, to->lanes.pivot);
    if (status != LAG_OK) {
        return status;
    }
    if (model->nk > 0) {
        solve_kept(model, by, f->lanes, width, to);
    }
    return to->lanes.pivot[0] > lag_smallest_pivot(model) ? LAG_OK : LAG_MISSING;
}

/* `count` rows of lanes into columns `column` and following of a matrix `columns` wide. */
static void put(size_t count, size_t lanes, size_t width, const double *from, size_t columns, size_t column, double *to)
{
    for (size_t i = 0; i < count; ++i) {
        memcpy(to + i * columns + column, from + i * lanes, width * sizeof *to);
    }
}

/* The directions: of single variables, or, where `given` is not null, those of its columns. */
typedef struct directions {
    lag_range x;
    const double *given; /* (variables, x.count) */
} directions;

/* Directions k and following, into lanes that are zero. */
static void set_directions(const directions *of, size_t k, size_t lanes, size_t width, size_t count, double *to)
{
    for (size_t lane = 0; lane < width && of->given == NULL; ++lane) {
        to[(of->x.first + k + lane) * lanes + lane] = 1.0;
    }
    for (size_t i = 0; i < count && of->given != NULL; ++i) {
        memcpy(to + i * lanes, of->given + i * of->x.count + k, width * sizeof *to);
    }
}

/* Columns of the Jacobian at the motion in `to`, with `by` factored. */
static lag_status differentiate(
    const lag_model *model,
    const functions *f,
    const lag_arguments *at,
    const directions *of,
    solver *by,
    const places *to,
    double *rates,
    double *outputs)
{
    const size_t n = model->nq;
    const size_t lanes = f->lanes;
    const lag_range x = of->x;
    lag_status status = LAG_OK;
    lag_fill(lanes * variables(model), 0.0, to->lanes.x);
    for (size_t k = 0; k < x.count && status == LAG_OK; k += lanes) {
        const size_t width = x.count - k < lanes ? x.count - k : lanes;
        set_directions(of, k, lanes, width, variables(model), to->lanes.x);
        put(n, lanes, width, to->lanes.x + n * lanes, x.count, k, rates);
        status = solve(model, f, at, by, width, to);
        put(n, lanes, width, to->lanes.dqdd, x.count, k, rates + n * x.count);
        if (status == LAG_OK && model->nz > 0) {
            status = f->state_derivative(at, to->lanes.rates);
            put(model->nz, lanes, width, to->lanes.rates, x.count, k, rates + 2 * n * x.count);
        }
        if (status == LAG_OK && outputs != NULL && model->ny > 0) {
            status = f->output(at, to->lanes.y);
            put(model->ny, lanes, width, to->lanes.y, x.count, k, outputs);
        }
        for (size_t lane = 0; lane < width && of->given == NULL; ++lane) {
            to->lanes.x[(x.first + k + lane) * lanes + lane] = 0.0;
        }
    }
    return status;
}

/* `at` with the solution and with the directions in `to`. */
static lag_arguments along(const lag_model *model, const lag_arguments *at, size_t lanes, const places *to)
{
    lag_arguments here = *at;
    here.qdd = to->qdd;
    here.lam = to->lam;
    here.dq = to->lanes.x;
    here.dqd = here.dq + lanes * model->nq;
    here.dz = here.dqd + lanes * model->nq;
    here.du = here.dz + lanes * model->nz;
    here.dp = here.du + lanes * model->nu;
    here.dqdd = to->lanes.dqdd;
    here.dlam = to->lanes.dlam;
    return here;
}

/* qdd and lam, with the factors that derivatives need. LAG_MISSING: elimination is no way to find them here. */
static lag_status solve_by_elimination(const lag_model *model, const lag_arguments *at, const places *to, solver *by)
{
    lag_status status = model->elimination(
        at, to->qdd, to->lam, to->kept.response, to->kept.lam_response, to->kept.jacobian, to->kept.gamma, to->lanes.pivot);
    if (status == LAG_OK) {
        status = lag_factor_eliminated(
            model, to->kept.response, to->kept.lam_response, to->kept.jacobian, to->lanes.pivot[0], to->kept.delassus, &by->kept);
    }
    if (status == LAG_OK) {
        lag_delassus_solve(&by->kept, to->kept.gamma, to->qdd, to->lam);
    }
    return status;
}

static lag_status solve_by_dense(
    const lag_model *model, const lag_arguments *at, const places *to, solver *by, size_t *coordinate)
{
    lag_status status = lag_forward_dynamics(model, at, to->dynamics, to->qdd, to->lam, coordinate);
    if (status == LAG_OK) {
        status = model->dynamics(at, to->dense.mass, to->dense.force, to->dense.jacobian, to->dense.gamma);
    }
    if (status == LAG_OK) {
        lag_system_place(&by->dense, model->nq, model->nc, model->components, to->dense.system);
        status = lag_system_factor(&by->dense, to->dense.mass, to->dense.jacobian, model->rank, coordinate);
    }
    return status;
}

/* With the functions of several directions. */
static lag_status along_many(
    const lag_model *model,
    const lag_tangents *tangents,
    const lag_arguments *at,
    const directions *of,
    const places *to,
    double *rates,
    double *outputs,
    size_t *coordinate)
{
    const functions f = {
        tangents->lanes, tangents->residual, tangents->acceleration, tangents->state_derivative, tangents->output
    };
    const lag_arguments here = along(model, at, f.lanes, to);
    solver by;
    lag_status status;
    if (tangents->motion != NULL) {
        status = tangents->motion(at, to->qdd, to->lam, to->lanes.pivot);
        if (status == LAG_OK && !(to->lanes.pivot[0] > lag_smallest_pivot(model))) {
            status = LAG_MISSING;
        }
    } else if (tangents->acceleration != NULL) {
        status = solve_by_elimination(model, at, to, &by);
    } else {
        status = solve_by_dense(model, at, to, &by, coordinate);
    }
    if (status == LAG_OK && tangents->motion == NULL) {
        status = tangents->primal(&here);
    }
    return status == LAG_OK ? differentiate(model, &f, &here, of, &by, to, rates, outputs) : status;
}

/* With those of the model itself. */
static lag_status along_one(
    const lag_model *model,
    const lag_arguments *at,
    const directions *of,
    const places *to,
    double *rates,
    double *outputs,
    size_t *coordinate)
{
    const functions f = {1, model->residual_tangent, NULL, model->state_derivative_tangent, model->output_tangent};
    const lag_arguments here = along(model, at, f.lanes, to);
    solver by;
    const lag_status status = solve_by_dense(model, at, to, &by, coordinate);
    return status == LAG_OK ? differentiate(model, &f, &here, of, &by, to, rates, outputs) : status;
}

static lag_status find(
    const lag_model *model,
    const lag_tangents *tangents,
    const lag_arguments *at,
    const directions *of,
    double *memory,
    double *rates,
    double *outputs,
    size_t *coordinate)
{
    const size_t count = (2 * model->nq + model->nz) * of->x.count;
    const size_t output_count = outputs == NULL ? 0 : model->ny * of->x.count;
    places to;
    lag_status status = LAG_MISSING;
    place(model, lanes_of(tangents), memory, &to);
    if (lanes_of(tangents) > 1) {
        status = along_many(model, tangents, at, of, &to, rates, outputs, coordinate);
        if (status == LAG_OK && lag_finite(count, rates) && lag_finite(output_count, outputs)) {
            return LAG_OK;
        }
        status = status == LAG_OK ? LAG_MISSING : status;
    }
    if (status == LAG_MISSING) {
        status = along_one(model, at, of, &to, rates, outputs, coordinate);
    }
    if (status == LAG_OK) {
        return lag_finite(count, rates) && lag_finite(output_count, outputs) ? LAG_OK : LAG_NOT_FINITE;
    }
    lag_fill(count, (double)NAN, rates);
    lag_fill(output_count, (double)NAN, outputs);
    return status;
}

lag_status lag_jacobian(
    const lag_model *model,
    const lag_tangents *tangents,
    const lag_arguments *at,
    lag_range x,
    double *memory,
    double *rates,
    double *outputs,
    size_t *coordinate)
{
    const directions of = {x, NULL};
    return find(model, tangents, at, &of, memory, rates, outputs, coordinate);
}

lag_status lag_jacobian_along(
    const lag_model *model,
    const lag_tangents *tangents,
    const lag_arguments *at,
    size_t count,
    const double *given,
    double *memory,
    double *rates,
    double *outputs,
    size_t *coordinate)
{
    const directions of = {{0, count}, given};
    return find(model, tangents, at, &of, memory, rates, outputs, coordinate);
}
