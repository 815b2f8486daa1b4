#include "lag/columns.h"

static void clear(size_t count, double *x)
{
    for (size_t i = 0; i < count; ++i) {
        x[i] = 0.0;
    }
}

static void negate(size_t count, double *x)
{
    for (size_t i = 0; i < count; ++i) {
        x[i] = -x[i];
    }
}

lag_status lag_mass_by_columns(const lag_model *model, const lag_arguments *at, double *arena, double *mass)
{
    const size_t n = model->nq;
    lag_arguments along = *at;
    lag_status status = LAG_OK;
    clear(n, arena);
    along.dqd = arena;
    for (size_t i = 0; i < n && status == LAG_OK; ++i) { /* M is symmetric: columns are rows */
        arena[i] = 1.0;
        status = model->momentum_tangent(&along, mass + i * n);
        arena[i] = 0.0;
    }
    return status;
}

lag_status lag_dynamics_by_columns(
    const lag_model *model,
    const lag_arguments *at,
    double *arena,
    double *mass,
    double *force,
    double *jacobian,
    double *gamma)
{
    const size_t n = model->nq;
    lag_arguments still = *at;
    double *const unused = arena + n + model->nc;
    lag_status status = lag_mass_by_columns(model, at, arena, mass);
    clear(n + model->nc, arena);
    still.qdd = arena;
    still.lam = arena + n;
    if (status == LAG_OK) {
        status = model->inverse_dynamics(&still, force);
    }
    if (status == LAG_OK) {
        status = model->velocity_constraint(at, gamma, jacobian);
    }
    if (status == LAG_OK) {
        status = model->residual(&still, unused, gamma);
    }
    if (status == LAG_OK) {
        negate(n, force);
        negate(model->nc, gamma);
    }
    return status;
}
