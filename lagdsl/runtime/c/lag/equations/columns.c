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

/* Number of each coordinate within its component, into `place` (nq); the most that there are in one. */
static size_t number(const lag_model *model, double *place)
{
    const size_t *component = model->components;
    size_t most = 0;
    for (size_t i = 0; i < model->nq; ++i) {
        size_t before = i;
        while (before > 0 && component != NULL && component[before - 1] != component[i]) {
            --before;
        }
        place[i] = before > 0 ? place[before - 1] + 1.0 : 0.0;
        most = place[i] + 1.0 > (double)most ? (size_t)place[i] + 1 : most;
    }
    return most;
}

/* Row i of M, from a row that is the sum of rows of several components; both may be one. */
static void take_own(const lag_model *model, size_t i, const double *sum, double *row)
{
    for (size_t j = 0; j < model->nq; ++j) {
        row[j] = model->components == NULL || model->components[j] == model->components[i] ? sum[j] : 0.0;
    }
}

/* M is symmetric: columns are rows. Coordinates of two components share no entry, so that one product serves a coordinate of each. */
lag_status lag_mass_by_columns(const lag_model *model, const lag_arguments *at, double *memory, double *mass)
{
    const size_t n = model->nq;
    const double *place = memory + n;
    const size_t most = number(model, memory + n);
    lag_arguments along = *at;
    lag_status status = LAG_OK;
    along.dqd = memory;
    for (size_t k = 0; k < most && status == LAG_OK; ++k) {
        size_t last = 0;
        for (size_t i = 0; i < n; ++i) {
            memory[i] = place[i] == (double)k ? 1.0 : 0.0;
            last = memory[i] != 0.0 ? i : last;
        }
        status = model->momentum_tangent(&along, mass + last * n);
        for (size_t i = 0; i <= last && status == LAG_OK; ++i) { /* the row of the last is the sum until then */
            if (memory[i] != 0.0) {
                take_own(model, i, mass + last * n, mass + i * n);
            }
        }
    }
    return status;
}

lag_status lag_dynamics_by_columns(
    const lag_model *model,
    const lag_arguments *at,
    double *memory,
    double *mass,
    double *force,
    double *jacobian,
    double *gamma)
{
    const size_t n = model->nq;
    lag_arguments still = *at;
    double *const unused = memory + n + model->nc;
    lag_status status = lag_mass_by_columns(model, at, memory, mass);
    clear(n + model->nc, memory);
    still.qdd = memory;
    still.lam = memory + n;
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
