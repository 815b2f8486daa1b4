/*
 * Rates along columns where loads depend on the accelerations and multipliers that they cause (lag/equations/feedback.h): with s = L(qdd, lam, s, ...)
 * the change ds of the loads solves
 *
 *     (1 - L_s - L_qdd qdd_s - L_lam lam_s) ds = dL at fixed loads ,
 *
 * qdd_s and lam_s being the accelerations and multipliers that a unit load causes.
 */
#include <string.h>

#include "lag/factorization/lu.h"
#include "lag/linalg/arena.h"
#include "lag/linalg/vector.h"
#include "lag/run.h"
#include "lag/sensitivities/sensitivities.h"

size_t lag_loads_along_memory(const lag_model *model)
{
    const size_t n = model->nq;
    const size_t m = model->nc;
    const size_t each = n + m;
    return model->nload == 0 ? 0 :
        n * n + m * n + 2 * each + lag_system_memory(n, m) + lag_loads_memory(model) + model->nload * (each + model->nload + 2);
}

void lag_loads_along_place(lag_loads_along *a, const lag_model *model, double *memory)
{
    const size_t n = model->nq;
    const size_t m = model->nc;
    a->mass = lag_take(&memory, n * n);
    a->jacobian = lag_take(&memory, m * n);
    a->force = lag_take(&memory, n);
    a->gamma = lag_take(&memory, m);
    a->qdd = lag_take(&memory, n);
    a->lam = lag_take(&memory, m);
    a->qdd_by_load = lag_take(&memory, model->nload * n);
    a->lam_by_load = lag_take(&memory, model->nload * m);
    a->slope = lag_take(&memory, model->nload * model->nload);
    a->pivot = lag_take(&memory, model->nload);
    a->change = lag_take(&memory, model->nload);
    lag_layout layout = {lag_take(&memory, lag_loads_memory(model)), 0};
    lag_loads_place(&a->loads, model, &layout);
    a->system_memory = memory;
}

lag_status lag_loads_along_set_state(lag_loads_along *a, lag_motion *motion, double t, const double *x)
{
    const lag_model *model = motion->model;
    const size_t n = model->nq;
    const size_t m = model->nc;
    const size_t count = model->nload;
    lag_status status = lag_motion_solve(motion, t, x);
    status = status == LAG_OK ? model->dynamics(&motion->at, a->mass, a->force, a->jacobian, a->gamma) : status;
    if (status == LAG_OK) {
        lag_system_place(&a->system, n, m, model->components, a->system_memory);
        status = lag_system_factor(&a->system, a->mass, a->jacobian, model->rank, &motion->coordinate);
    }
    status = status == LAG_OK ? lag_loads_evaluate(&a->loads, model, &motion->at) : status;
    status = status == LAG_OK ? lag_loads_gain(&a->loads, model, &motion->at) : status;
    if (status != LAG_OK) {
        return status;
    }
    lag_fill(m, 0.0, a->gamma);
    for (size_t k = 0; k < count; ++k) {
        for (size_t j = 0; j < n; ++j) {
            a->force[j] = -a->loads.motion[j * count + k];
        }
        lag_system_solve(&a->system, a->force, a->gamma, a->qdd_by_load + k * n, a->lam_by_load + k * m);
        for (size_t i = 0; i < count; ++i) {
            a->slope[i * count + k] = (i == k ? 1.0 : 0.0) - a->loads.by_load[i * count + k] -
                lag_dot(n, a->loads.by_acceleration + i * n, a->qdd_by_load + k * n) -
                lag_dot(m, a->loads.by_multiplier + i * m, a->lam_by_load + k * m);
        }
    }
    return lag_lu(count, a->slope, a->pivot) ? LAG_OK : LAG_NO_FORCES;
}

/* dqdd and dlam along the direction of `at`, which points at them, with the change of the loads. */
static lag_status solve_along(lag_loads_along *a, const lag_model *model, const lag_arguments *at)
{
    const size_t n = model->nq;
    const size_t m = model->nc;
    lag_status status = model->residual_tangent(at, a->force, a->gamma);
    for (size_t i = 0; i < n; ++i) {
        a->force[i] = -a->force[i];
    }
    for (size_t i = 0; i < m; ++i) {
        a->gamma[i] = -a->gamma[i];
    }
    if (status == LAG_OK) {
        lag_system_solve(&a->system, a->force, a->gamma, a->qdd, a->lam);
        status = model->load_tangent(at, a->change);
    }
    if (status == LAG_OK) {
        lag_lu_solve(model->nload, a->slope, a->pivot, a->change);
    }
    for (size_t k = 0; k < model->nload && status == LAG_OK; ++k) {
        lag_axpy(n, a->change[k], a->qdd_by_load + k * n, a->qdd);
        lag_axpy(m, a->change[k], a->lam_by_load + k * m, a->lam);
    }
    return status;
}

/* Adds what the loads change to `count` results. */
static void add_loads(const lag_loads_along *a, size_t loads, size_t count, const double *gain, double *to)
{
    for (size_t i = 0; i < count; ++i) {
        to[i] += lag_dot(loads, gain + i * loads, a->change);
    }
}

lag_status lag_loads_along_rates(lag_loads_along *a, const lag_motion *motion, const double *direction, double *rates, double *y)
{
    const lag_model *model = motion->model;
    const size_t n = model->nq;
    lag_arguments at = motion->at;
    at.dq = direction;
    at.dqd = at.dq + n;
    at.dz = at.dqd + n;
    at.du = at.dz + model->nz;
    at.dp = at.du + model->nu;
    at.dqdd = a->qdd;
    at.dlam = a->lam;
    lag_status status = solve_along(a, model, &at);
    memcpy(rates, at.dqd, n * sizeof(double));
    memcpy(rates + n, a->qdd, n * sizeof(double));
    if (status == LAG_OK && model->nz > 0) {
        status = model->state_derivative_tangent(&at, rates + 2 * n);
        add_loads(a, model->nload, model->nz, a->loads.unused, rates + 2 * n);
    }
    if (status == LAG_OK && y != NULL && model->ny > 0) {
        status = model->output_tangent(&at, y);
        add_loads(a, model->nload, model->ny, a->loads.unused + model->nz * model->nload, y);
    }
    return status;
}
