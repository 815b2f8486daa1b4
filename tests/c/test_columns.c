/* M and the linear system by columns, for a model whose functions are written here. */
#include "check.h"
#include "lag/columns.h"

enum { N = 3, ROWS = 1 };

static const double mass_of_model[N][N] = {{4.0, 1.0, 0.5}, {1.0, 3.0, -0.25}, {0.5, -0.25, 2.0}};
static const double force_of_model[N] = {1.0, -2.0, 0.5};
static const double row_of_model[N] = {1.0, 0.0, -2.0};
static const double bias_of_model = 0.75;

static lag_status momentum_tangent(const lag_arguments *at, double *momentum)
{
    for (size_t i = 0; i < N; ++i) {
        momentum[i] = 0.0;
        for (size_t j = 0; j < N; ++j) {
            momentum[i] += mass_of_model[i][j] * at->dqd[j];
        }
    }
    return LAG_OK;
}

static lag_status inverse_dynamics(const lag_arguments *at, double *force)
{
    for (size_t i = 0; i < N; ++i) {
        force[i] = -force_of_model[i];
        for (size_t j = 0; j < N; ++j) {
            force[i] += mass_of_model[i][j] * at->qdd[j];
        }
    }
    return LAG_OK;
}

static lag_status velocity_constraint(const lag_arguments *at, double *residual, double *jacobian)
{
    residual[0] = 0.0;
    for (size_t i = 0; i < N; ++i) {
        residual[0] += row_of_model[i] * at->qd[i];
        jacobian[i] = row_of_model[i];
    }
    return LAG_OK;
}

static lag_status residual(const lag_arguments *at, double *motion, double *rows)
{
    const lag_status status = inverse_dynamics(at, motion);
    rows[0] = -bias_of_model;
    for (size_t i = 0; i < N; ++i) {
        motion[i] -= row_of_model[i] * at->lam[0];
        rows[0] += row_of_model[i] * at->qdd[i];
    }
    return status;
}

static lag_status failing(const lag_arguments *at, double *momentum)
{
    (void)at;
    (void)momentum;
    return LAG_NOT_FINITE;
}

int main(void)
{
    const double rates[N] = {0.3, 0.2, 0.1}, accelerations[N] = {9.0, 9.0, 9.0}, multipliers[ROWS] = {9.0};
    lag_arguments at = {0};
    lag_model model = {0};
    double memory[5 * N + ROWS], mass[N * N], force[N], jacobian[ROWS * N], gamma[ROWS];
    at.qd = rates;
    at.qdd = accelerations; /* not those of the caller count, but zeros */
    at.lam = multipliers;
    model.nq = N;
    model.nc = ROWS;
    model.momentum_tangent = momentum_tangent;
    model.inverse_dynamics = inverse_dynamics;
    model.velocity_constraint = velocity_constraint;
    model.residual = residual;
    CHECK(lag_mass_by_columns(&model, &at, memory, mass) == LAG_OK);
    for (size_t i = 0; i < N * N; ++i) {
        CHECK_NEAR(mass[i], mass_of_model[i / N][i % N], 0.0);
        mass[i] = 0.0;
    }
    CHECK(lag_dynamics_by_columns(&model, &at, memory, mass, force, jacobian, gamma) == LAG_OK);
    for (size_t i = 0; i < N; ++i) {
        CHECK_NEAR(mass[i * N + i], mass_of_model[i][i], 0.0);
        CHECK_NEAR(force[i], force_of_model[i], 0.0);
        CHECK_NEAR(jacobian[i], row_of_model[i], 0.0);
    }
    CHECK_NEAR(gamma[0], bias_of_model, 0.0);
    model.momentum_tangent = failing;
    CHECK(lag_dynamics_by_columns(&model, &at, memory, mass, force, jacobian, gamma) == LAG_NOT_FINITE);
    return 0;
}
