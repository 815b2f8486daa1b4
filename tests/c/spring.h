/*
 * A mass 1 on a spring of stiffness 1, and an angle that turns 3 rad/s: q = cos t from rest at 1. The outputs are q and that angle, known up
 * to whole turns. Written by hand.
 */
#ifndef SPRING_H
#define SPRING_H

#include <math.h>

#include "lag/model.h"

static inline lag_status spring_prepare(const lag_arguments *at)
{
    (void)at;
    return LAG_OK;
}

static inline lag_status spring_start(const lag_arguments *at, double *q, double *qd, double *z, double *u)
{
    (void)at;
    (void)u;
    q[0] = 1.0;
    qd[0] = z[0] = 0.0;
    return LAG_OK;
}

static inline lag_status spring_mass(const lag_arguments *at, double *mass)
{
    (void)at;
    mass[0] = 1.0;
    return LAG_OK;
}

static inline lag_status spring_dynamics(const lag_arguments *at, double *mass, double *force, double *jacobian, double *gamma)
{
    (void)jacobian;
    (void)gamma;
    force[0] = -at->q[0];
    return spring_mass(at, mass);
}

static inline lag_status spring_residual_tangent(const lag_arguments *at, double *motion, double *rows)
{
    (void)rows;
    motion[0] = at->dq[0];
    return LAG_OK;
}

static inline lag_status spring_rates(const lag_arguments *at, double *rates)
{
    (void)at;
    rates[0] = 3.0;
    return LAG_OK;
}

static inline lag_status spring_rates_tangent(const lag_arguments *at, double *rates)
{
    (void)at;
    rates[0] = 0.0;
    return LAG_OK;
}

static inline lag_status spring_output(const lag_arguments *at, double *y)
{
    y[0] = at->q[0];
    y[1] = atan2(sin(at->z[0]), cos(at->z[0]));
    return LAG_OK;
}

static inline lag_status spring_output_tangent(const lag_arguments *at, double *y)
{
    y[0] = at->dq[0];
    y[1] = at->dz[0];
    return LAG_OK;
}

static inline lag_status spring_turn(const lag_arguments *at, double *value, double *rate, double *turn, double *entry)
{
    value[0] = atan2(sin(at->z[0]), cos(at->z[0]));
    rate[0] = 3.0;
    turn[0] = 6.283185307179586;
    entry[0] = 1.0;
    return LAG_OK;
}

static inline lag_status spring_energies(const lag_arguments *at, double *total, double *kinetic, double *potential, double *jacobi)
{
    kinetic[0] = 0.5 * at->qd[0] * at->qd[0];
    potential[0] = 0.5 * at->q[0] * at->q[0];
    total[0] = jacobi[0] = kinetic[0] + potential[0];
    return LAG_OK;
}

static const lag_slot SPRING_Q[1] = {{"x", "m", NULL}};
static const lag_slot SPRING_Z[1] = {{"turned", "rad", NULL}};
static const lag_slot SPRING_Y[2] = {{"y", "m", NULL}, {"angle", "rad", NULL}};

static const lag_model SPRING = {
    .version = LAG_MODEL_VERSION,
    .size = sizeof(lag_model),
    .name = "Spring",
    .nq = 1,
    .nz = 1,
    .ny = 2,
    .nturn = 1,
    .coordinates = SPRING_Q,
    .states = SPRING_Z,
    .outputs = SPRING_Y,
    .prepare = spring_prepare,
    .start = spring_start,
    .mass_matrix = spring_mass,
    .dynamics = spring_dynamics,
    .residual_tangent = spring_residual_tangent,
    .state_derivative = spring_rates,
    .state_derivative_tangent = spring_rates_tangent,
    .output = spring_output,
    .output_tangent = spring_output_tangent,
    .turn = spring_turn,
    .energies = spring_energies,
};

#endif
