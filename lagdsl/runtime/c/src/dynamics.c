#include "lag/dynamics.h"

#include <math.h>

/* Where the functions of this file keep what. */
typedef struct places {
    double *mass, *force, *jacobian, *gamma; /* (nq, nq) (nq) (nc, nq) (nc) */
    double *qdd, *lam;                       /* (nq) (nc) */
    double *direction;                       /* (2 nq + nz) of q, qd and z in a row */
    double *zero_u, *zero_p;                 /* (nu) (np) */
    double *motion, *rows, *rates;           /* (nq) (nc) (nz) */
    double *dqdd, *dlam;                     /* (nq) (nc) */
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
    at.system = memory;
    return at;
}

size_t lag_dynamics_memory(const lag_model *model)
{
    const size_t n = model->nq;
    const size_t m = model->nc;
    return n * n + m * n + 6 * n + 4 * m + 2 * model->nz + model->nu + model->np + lag_system_memory(n, m);
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

static lag_status solve(
    const lag_model *model,
    const lag_arguments *at,
    const places *to,
    lag_system *system,
    double *qdd,
    double *lam,
    size_t *coordinate)
{
    lag_status status = model->dynamics(at, to->mass, to->force, to->jacobian, to->gamma);
    if (status != LAG_OK) {
        return status;
    }
    lag_system_place(system, model->nq, model->nc, to->system);
    status = lag_system_factor(system, to->mass, to->jacobian, model->rank, coordinate);
    if (status != LAG_OK) {
        fill(model->nq, (double)NAN, qdd);
        fill(model->nc, (double)NAN, lam);
        return status;
    }
    lag_system_solve(system, to->force, to->gamma, qdd, lam);
    return finite_or_not(model->nc, lam, finite_or_not(model->nq, qdd, LAG_OK));
}

/* Where eliminating lost more than this part of a pivot, the dense system tells whether it is singular. */
static const double smallest_pivot = 1e-6;

/* Whether qdd was found by elimination: only without constraints. */
static int eliminate(const lag_model *model, const lag_arguments *at, const places *to, double *qdd)
{
    double pivot = 0.0;
    if (model->elimination == NULL || model->nc > 0) {
        return 0;
    }
    const lag_status status = model->elimination(at, qdd, to->rows, to->jacobian, to->gamma, &pivot);
    return status == LAG_OK && pivot > smallest_pivot && finite_or_not(model->nq, qdd, LAG_OK) == LAG_OK;
}

lag_status lag_forward_dynamics(
    const lag_model *model, const lag_arguments *at, double *memory, double *qdd, double *lam, size_t *coordinate)
{
    const places to = place(model, memory);
    if (eliminate(model, at, &to, qdd)) {
        return LAG_OK;
    }
    lag_system system;
    return solve(model, at, &to, &system, qdd, lam, coordinate);
}

/* Column `which` of the Jacobian. */
static lag_status column(
    const lag_model *model, lag_arguments *at, const places *to, lag_system *system, size_t which, double *jacobian)
{
    const size_t n = model->nq;
    const size_t total = 2 * n + model->nz;
    to->direction[which] = 1.0;
    lag_status status = model->residual_tangent(at, to->motion, to->rows);
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
