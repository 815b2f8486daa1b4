/* Van der Pol's oscillator, two states of first order: stiff where its parameter is small. */
#ifndef OSCILLATOR_H
#define OSCILLATOR_H

#include "lag/model.h"

static inline lag_status oscillator_prepare(const lag_arguments *at)
{
    (void)at;
    return LAG_OK;
}

static inline lag_status oscillator_start(const lag_arguments *at, double *q, double *qd, double *z, double *u)
{
    (void)at;
    (void)q;
    (void)qd;
    (void)u;
    z[0] = 2.0;
    z[1] = 0.0;
    return LAG_OK;
}

static inline lag_status oscillator_dynamics(const lag_arguments *at, double *mass, double *force, double *jacobian, double *gamma)
{
    (void)at;
    (void)mass;
    (void)force;
    (void)jacobian;
    (void)gamma;
    return LAG_OK;
}

static inline lag_status oscillator_residual(const lag_arguments *at, double *motion, double *rows)
{
    (void)at;
    (void)motion;
    (void)rows;
    return LAG_OK;
}

static inline lag_status oscillator_rates(const lag_arguments *at, double *rates)
{
    const double *z = at->z;
    rates[0] = z[1];
    rates[1] = ((1.0 - z[0] * z[0]) * z[1] - z[0]) / at->p[0];
    return LAG_OK;
}

static inline lag_status oscillator_tangent(const lag_arguments *at, double *rates)
{
    const double *z = at->z;
    rates[0] = at->dz[1];
    rates[1] = (-(2.0 * z[0] * z[1] + 1.0) * at->dz[0] + (1.0 - z[0] * z[0]) * at->dz[1]) / at->p[0];
    return LAG_OK;
}

static const lag_slot OSCILLATOR_Z[2] = {{"x", "1", NULL}, {"v", "1/s", NULL}};
static const double OSCILLATOR_EPSILON[1] = {1e-6};

static const lag_model OSCILLATOR = {
    .version = LAG_MODEL_VERSION,
    .size = sizeof(lag_model),
    .name = "Oscillator",
    .nz = 2,
    .np = 1,
    .states = OSCILLATOR_Z,
    .defaults = OSCILLATOR_EPSILON,
    .prepare = oscillator_prepare,
    .start = oscillator_start,
    .dynamics = oscillator_dynamics,
    .residual_tangent = oscillator_residual,
    .state_derivative = oscillator_rates,
    .state_derivative_tangent = oscillator_tangent,
};

#endif
