#include "lag/dynamics.h"

#include <math.h>

#include "lag/delassus.h"

/* Where the functions of this file keep what. */
typedef struct places {
    double *mass, *force, *jacobian, *gamma; /* (nq, nq) (nq) (nc, nq) (nc) */
    double *qdd, *lam;                       /* (nq) (nc) */
    double *direction;                       /* (2 nq + nz) of q, qd and z in a row */
    double *zero_u, *zero_p;                 /* (nu) (np) */
    double *motion, *rows, *rates;           /* (nq) (nc) (nz) */
    double *dqdd, *dlam;                     /* (nq) (nc) */
    double *directions;                      /* (2 nq + nz + nu + np) in lanes */
    double *motions, *rows_of;               /* (nq) (nc) in lanes */
    double *response, *lam_response;         /* (nk, nq) (nk, nc) */
    double *kept_jacobian, *kept_gamma;      /* (nk, nq) (nk) */
    double *delassus;
    double *system;
} places;

static double *take(double **memory, size_t count)
{
    double *start = *memory;
    *memory += count;
    return start;
}

static places place(const lag_model *model, double *memory)
{
    const size_t n = model->nq;
    const size_t m = model->nc;
    places at;
    at.mass = take(&memory, n * n);
    at.force = take(&memory, n);
    at.jacobian = take(&memory, m * n);
    at.gamma = take(&memory, m);
    at.qdd = take(&memory, n);
    at.lam = take(&memory, m);
    at.direction = take(&memory, 2 * n + model->nz);
    at.zero_u = take(&memory, model->nu);
    at.zero_p = take(&memory, model->np);
    at.motion = take(&memory, n);
    at.rows = take(&memory, m);
    at.rates = take(&memory, model->nz);
    at.dqdd = take(&memory, n);
    at.dlam = take(&memory, m);
    at.directions = take(&memory, model->lanes * (2 * n + model->nz + model->nu + model->np));
    at.motions = take(&memory, model->lanes * n);
    at.rows_of = take(&memory, model->lanes * m);
    at.response = take(&memory, model->nk * n);
    at.lam_response = take(&memory, model->nk * m);
    at.kept_jacobian = take(&memory, model->nk * n);
    at.kept_gamma = take(&memory, model->nk);
    at.delassus = take(&memory, lag_delassus_memory(m, model->nk));
    at.system = memory;
    return at;
}

size_t lag_dynamics_memory(const lag_model *model)
{
    const size_t n = model->nq;
    const size_t m = model->nc;
    const size_t lanes = model->lanes * (3 * n + m + model->nz + model->nu + model->np);
    const size_t kept = model->nk * (2 * n + m + 1) + lag_delassus_memory(m, model->nk);
    const size_t own = n * n + m * n + 6 * n + 4 * m + 2 * model->nz + model->nu + model->np;
    return own + lanes + kept + lag_system_memory(n, m);
}

static void fill(size_t count, double value, double *x)
{
    for (size_t i = 0; i < count; ++i) {
        x[i] = value;
    }
}

static lag_status finite_or_not(size_t count, const double *x, lag_status before)
{
    for (size_t i = 0; i < count; ++i) {
        if (!isfinite(x[i])) {
            return LAG_NOT_FINITE;
        }
    }
    return before;
}

static lag_status solve_formed(
    const lag_model *model,
    const places *to,
    lag_system *system,
    double *qdd,
    double *lam,
    size_t *coordinate)
{
    lag_system_place(system, model->nq, model->nc, to->system);
    const lag_status status = lag_system_factor(system, to->mass, to->jacobian, model->rank, coordinate);
    if (status != LAG_OK) {
        fill(model->nq, (double)NAN, qdd);
        fill(model->nc, (double)NAN, lam);
        return status;
    }
    lag_system_solve(system, to->force, to->gamma, qdd, lam);
    return finite_or_not(model->nc, lam, finite_or_not(model->nq, qdd, LAG_OK));
}

static lag_status solve(
    const lag_model *model,
    const lag_arguments *at,
    const places *to,
    lag_system *system,
    double *qdd,
    double *lam,
    size_t *coordinate)
{
    const lag_status status = model->dynamics(at, to->mass, to->force, to->jacobian, to->gamma);
    return status == LAG_OK ? solve_formed(model, to, system, qdd, lam, coordinate) : status;
}

/*
 * Where eliminating left less than this part of a pivot, the dense system tells whether it is singular. With rows left, their
 * multipliers take back much of the accelerations without them, and what these lost shows in what is left.
 */
static const double smallest_pivot = 1e-6;
static const double smallest_pivot_with_rows_left = 1e-4;

lag_status lag_factor_eliminated(
    const lag_model *model,
    const double *response,
    const double *lam_response,
    const double *jacobian,
    double pivot,
    double *memory,
    lag_delassus *system)
{
    const size_t solved = model->nc - model->nk;
    lag_delassus_place(system, model->nq, model->nc, model->nk, model->kept_rows, memory);
    system->response = response;
    system->lam_response = lam_response;
    system->jacobian = jacobian;
    const double smallest = model->nk > 0 ? smallest_pivot_with_rows_left : smallest_pivot;
    return pivot > smallest ? lag_delassus_factor(system, model->rank - solved) : LAG_MISSING;
}

lag_status lag_solve_eliminated(
    const lag_model *model,
    const double *response,
    const double *lam_response,
    const double *jacobian,
    const double *gamma,
    double pivot,
    double *memory,
    double *qdd,
    double *lam)
{
    lag_delassus system;
    if (lag_factor_eliminated(model, response, lam_response, jacobian, pivot, memory, &system) != LAG_OK) {
        return LAG_MISSING;
    }
    lag_delassus_solve(&system, gamma, qdd, lam);
    const lag_status finite = finite_or_not(model->nc, lam, finite_or_not(model->nq, qdd, LAG_OK));
    return finite == LAG_OK ? LAG_OK : LAG_MISSING;
}

static void pick(size_t count, const double *lanes, size_t stride, size_t lane, double *x)
{
    for (size_t i = 0; i < count; ++i) {
        x[i] = lanes[i * stride + lane];
    }
}

lag_status lag_forward_dynamics_of_lane(
    const lag_model *model,
    const lag_formed *formed,
    size_t lane,
    double *memory,
    double *qdd,
    double *lam,
    size_t *coordinate)
{
    const size_t n = model->nq;
    const size_t m = model->nc;
    const size_t kept = model->nk;
    const size_t lanes = model->lanes;
    const places to = place(model, memory);
    lag_system system;
    if (formed->qdd != NULL) {
        pick(n, formed->qdd, lanes, lane, qdd);
        pick(m, formed->lam, lanes, lane, lam);
        pick(kept * n, formed->response, lanes, lane, to.response);
        pick(kept * m, formed->lam_response, lanes, lane, to.lam_response);
        pick(kept * n, formed->jacobian, lanes, lane, to.kept_jacobian);
        pick(kept, formed->gamma, lanes, lane, to.kept_gamma);
        return lag_solve_eliminated(
            model,
            to.response,
            to.lam_response,
            to.kept_jacobian,
            to.kept_gamma,
            formed->pivot[lane],
            to.delassus,
            qdd,
            lam);
    }
    pick(n * n, formed->mass, lanes, lane, to.mass);
    pick(n, formed->force, lanes, lane, to.force);
    pick(m * n, formed->jacobian, lanes, lane, to.jacobian);
    pick(m, formed->gamma, lanes, lane, to.gamma);
    return solve_formed(model, &to, &system, qdd, lam, coordinate);
}

static lag_status eliminate(
    const lag_model *model, const lag_arguments *at, const places *to, double *qdd, double *lam)
{
    double pivot = 0.0;
    if (model->elimination == NULL) {
        return LAG_MISSING;
    }
    const double *jacobian = to->kept_jacobian;
    const lag_status status = model->elimination(
        at, qdd, lam, to->response, to->lam_response, to->kept_jacobian, to->kept_gamma, &pivot);
    return status == LAG_OK
        ? lag_solve_eliminated(
              model, to->response, to->lam_response, jacobian, to->kept_gamma, pivot, to->delassus, qdd, lam)
        : status;
}

lag_status lag_forward_dynamics(
    const lag_model *model, const lag_arguments *at, double *memory, double *qdd, double *lam, size_t *coordinate)
{
    const places to = place(model, memory);
    if (eliminate(model, at, &to, qdd, lam) == LAG_OK) {
        return LAG_OK;
    }
    lag_system system;
    return solve(model, at, &to, &system, qdd, lam, coordinate);
}

/* Tangents of the residual in the directions `first` and following, as many as there are lanes. */
static lag_status tangents(const lag_model *model, const lag_arguments *at, const places *to, size_t first)
{
    const size_t n = model->nq;
    const size_t total = 2 * n + model->nz;
    lag_arguments here = *at;
    here.dq = to->directions;
    here.dqd = here.dq + n * model->lanes;
    here.dz = here.dqd + n * model->lanes;
    here.du = here.dz + model->nz * model->lanes;
    here.dp = here.du + model->nu * model->lanes;
    fill(model->lanes * (total + model->nu + model->np), 0.0, to->directions);
    for (size_t lane = 0; lane < model->lanes && first + lane < total; ++lane) {
        to->directions[(first + lane) * model->lanes + lane] = 1.0;
    }
    return model->residual_tangent_lanes(&here, to->motions, to->rows_of);
}

/* The tangent of the residual in direction `which`, called for one after the other. */
static lag_status tangent(const lag_model *model, const lag_arguments *at, const places *to, size_t which)
{
    if (model->residual_tangent_lanes == NULL) {
        return model->residual_tangent(at, to->motion, to->rows);
    }
    lag_status status = which == 0 ? model->residual_tangent_primal(at) : LAG_OK;
    if (status == LAG_OK && which % model->lanes == 0) {
        status = tangents(model, at, to, which);
    }
    for (size_t i = 0; i < model->nq; ++i) {
        to->motion[i] = to->motions[i * model->lanes + which % model->lanes];
    }
    for (size_t i = 0; i < model->nc; ++i) {
        to->rows[i] = to->rows_of[i * model->lanes + which % model->lanes];
    }
    return status;
}

/* Column `which` of the Jacobian. */
static lag_status column(
    const lag_model *model, lag_arguments *at, const places *to, lag_system *system, size_t which, double *jacobian)
{
    const size_t n = model->nq;
    const size_t total = 2 * n + model->nz;
    to->direction[which] = 1.0;
    lag_status status = tangent(model, at, to, which);
    if (status != LAG_OK) {
        return status;
    }
    for (size_t i = 0; i < n; ++i) {
        to->motion[i] = -to->motion[i];
    }
    for (size_t i = 0; i < model->nc; ++i) {
        to->rows[i] = -to->rows[i];
    }
    lag_system_solve(system, to->motion, to->rows, to->dqdd, to->dlam);
    status = model->state_derivative_tangent(at, to->rates);
    for (size_t i = 0; i < n; ++i) {
        jacobian[i * total + which] = to->direction[n + i];
        jacobian[(n + i) * total + which] = to->dqdd[i];
    }
    for (size_t i = 0; i < model->nz; ++i) {
        jacobian[(2 * n + i) * total + which] = to->rates[i];
    }
    to->direction[which] = 0.0;
    return status;
}

lag_status lag_state_jacobian(
    const lag_model *model, const lag_arguments *at, double *memory, double *jacobian, size_t *coordinate)
{
    const size_t n = model->nq;
    const size_t total = 2 * n + model->nz;
    const places to = place(model, memory);
    lag_arguments here = *at;
    lag_system system;
    lag_status status = solve(model, at, &to, &system, to.qdd, to.lam, coordinate);
    if (status != LAG_OK) {
        fill(total * total, (double)NAN, jacobian);
        return status;
    }
    fill(total, 0.0, to.direction);
    fill(model->nu, 0.0, to.zero_u);
    fill(model->np, 0.0, to.zero_p);
    here.qdd = to.qdd;
    here.lam = to.lam;
    here.dq = to.direction;
    here.dqd = to.direction + n;
    here.dz = to.direction + 2 * n;
    here.du = to.zero_u;
    here.dp = to.zero_p;
    here.dqdd = to.dqdd;
    here.dlam = to.dlam;
    for (size_t which = 0; which < total && status == LAG_OK; ++which) {
        status = column(model, &here, &to, &system, which, jacobian);
    }
    return status == LAG_OK ? finite_or_not(total * total, jacobian, LAG_OK) : status;
}
