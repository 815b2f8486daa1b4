/*
 * A model with all that a run can have, written by hand: a ball falls on a floor, on which it comes to rest, moves to the side,
 * pushed by a controller that looks every 0.05 s and braked through a lag of first order, and is thrown back at x = 0.1.
 */
#ifndef MACHINE_H
#define MACHINE_H

#include "lag/model.h"

enum { PUSH, FLOOR, BLOWS, BEYOND, SAMPLED, PASSED, TICK, MACHINE_DISCRETES };

static inline lag_status machine_prepare(const lag_arguments *at)
{
    (void)at;
    return LAG_OK;
}

static inline lag_status machine_start(const lag_arguments *at, double *q, double *qd, double *z, double *u)
{
    (void)at;
    (void)u;
    q[0] = 0.04; /* height */
    q[1] = 0.0; /* to the side */
    qd[0] = 0.0;
    qd[1] = 1.0;
    z[0] = 0.0;
    return LAG_OK;
}

static inline lag_status machine_discrete_start(const lag_arguments *at, double *w)
{
    (void)at;
    for (int i = 0; i < MACHINE_DISCRETES; ++i) {
        w[i] = 0.0;
    }
    return LAG_OK;
}

static inline lag_status machine_position(const lag_arguments *at, double *phi, double *jacobian)
{
    phi[0] = at->w[FLOOR] * at->q[0];
    jacobian[0] = at->w[FLOOR];
    jacobian[1] = 0.0;
    return LAG_OK;
}

static inline lag_status machine_velocity(const lag_arguments *at, double *residual, double *jacobian)
{
    residual[0] = at->w[FLOOR] * at->qd[0];
    jacobian[0] = at->w[FLOOR];
    jacobian[1] = 0.0;
    return LAG_OK;
}

static inline lag_status machine_mass(const lag_arguments *at, double *mass)
{
    (void)at;
    mass[0] = mass[3] = 1.0;
    mass[1] = mass[2] = 0.0;
    return LAG_OK;
}

static inline lag_status machine_dynamics(const lag_arguments *at, double *mass, double *force, double *jacobian, double *gamma)
{
    force[0] = -10.0;
    force[1] = at->w[PUSH] - at->z[0];
    jacobian[0] = at->w[FLOOR];
    jacobian[1] = gamma[0] = 0.0;
    return machine_mass(at, mass);
}

static inline lag_status machine_inverse_dynamics(const lag_arguments *at, double *force)
{
    force[0] = at->qdd[0] + 10.0;
    force[1] = at->qdd[1] - at->w[PUSH] + at->z[0];
    return LAG_OK;
}

static inline lag_status machine_residual_tangent(const lag_arguments *at, double *motion, double *rows)
{
    motion[0] = rows[0] = 0.0;
    motion[1] = at->dz[0];
    return LAG_OK;
}

static inline lag_status machine_constraint_tangent(const lag_arguments *at, double *phi, double *residual)
{
    phi[0] = at->w[FLOOR] * at->dq[0];
    residual[0] = at->w[FLOOR] * at->dqd[0];
    return LAG_OK;
}

static inline lag_status machine_rates(const lag_arguments *at, double *rates)
{
    rates[0] = 10.0 * (at->qd[1] - at->z[0]);
    return LAG_OK;
}

static inline lag_status machine_rates_tangent(const lag_arguments *at, double *rates)
{
    rates[0] = 10.0 * (at->dqd[1] - at->dz[0]);
    return LAG_OK;
}

static inline lag_status machine_indicator(const lag_arguments *at, double *g)
{
    g[0] = at->q[1] - 0.1;
    return LAG_OK;
}

static inline lag_status machine_indicator_rate(const lag_arguments *at, double *rate, double *acceleration)
{
    rate[0] = at->qd[1];
    acceleration[0] = at->qdd[1];
    return LAG_OK;
}

static inline lag_status machine_standing(const lag_arguments *at, double *w)
{
    for (int i = 0; i < MACHINE_DISCRETES; ++i) {
        w[i] = at->w[i];
    }
    w[BEYOND] = at->q[1] > 0.1 ? 1.0 : 0.0;
    return LAG_OK;
}

static inline lag_status machine_contact(
    const lag_arguments *at, double *gap, double *speed, double *jacobian, double *restitution, double *capture_speed, double *rest)
{
    gap[0] = at->q[0];
    speed[0] = at->qd[0];
    jacobian[0] = 1.0;
    jacobian[1] = 0.0;
    restitution[0] = 0.5;
    capture_speed[0] = rest[0] = -1.0;
    return LAG_OK;
}

static inline lag_status machine_clock(const lag_arguments *at, double *first, double *period)
{
    (void)at;
    first[0] = 0.0;
    period[0] = 0.05;
    return LAG_OK;
}

static inline lag_status machine_event(const lag_arguments *at, double *next, double *reset, double *value, double *collision,
    double *restitution, double *stop, double *fail)
{
    const double *w = at->w;
    (void)collision;
    (void)restitution;
    (void)stop;
    (void)fail;
    for (int i = 0; i < MACHINE_DISCRETES; ++i) {
        next[i] = w[i];
    }
    if (w[TICK] != 0.0 && w[SAMPLED] == 0.0) {
        next[PUSH] = at->q[1] > 0.1 ? -1.0 : 1.0;
    }
    next[SAMPLED] = w[TICK];
    next[PASSED] = w[BEYOND];
    reset[0] = w[BEYOND] != 0.0 && w[PASSED] == 0.0 ? 1.0 : 0.0;
    value[0] = -0.5 * at->qd[1];
    return LAG_OK;
}

static const lag_slot MACHINE_Q[2] = {{"h", "m", NULL}, {"x", "m", NULL}};
static const lag_slot MACHINE_Z[1] = {{"a", "1", NULL}};
static const lag_slot MACHINE_ROWS[1] = {{"floor", "m", NULL}};
static const lag_slot MACHINE_W[MACHINE_DISCRETES] = {{"f", "N", NULL}, {"closed(floor)", "1", NULL}, {"impacts(floor)", "1", NULL},
    {"x > 0.1", "1", NULL}, {"sample(0, 0.05)", "1", NULL}, {"x > 0.1", "1", NULL}, {"sample(0, 0.05)", "1", NULL}};
static const unsigned char MACHINE_KINDS[MACHINE_DISCRETES] = {
    LAG_KIND_VARIABLE, LAG_KIND_CONTACT, LAG_KIND_IMPACTS, LAG_KIND_RELATION, LAG_KIND_CONDITION, LAG_KIND_CONDITION,
    LAG_KIND_CLOCK};
static const unsigned char MACHINE_ONE[1] = {1};
static const unsigned char MACHINE_NONE[1] = {0};
static const size_t MACHINE_CONTACT_ROWS[1] = {0};
static const size_t MACHINE_RESET_PLACES[1] = {3};
static const char *const MACHINE_RESETS[1] = {"der(x)"};

static const lag_model MACHINE = {
    .version = LAG_MODEL_VERSION,
    .size = sizeof(lag_model),
    .name = "Machine",
    .nq = 2,
    .nz = 1,
    .nw = MACHINE_DISCRETES,
    .nc = 1,
    .rank = 1,
    .nindicator = 1,
    .ncontact = 1,
    .ngap = 1,
    .nclock = 1,
    .nreset = 1,
    .coordinates = MACHINE_Q,
    .states = MACHINE_Z,
    .discretes = MACHINE_W,
    .constraints = MACHINE_ROWS,
    .position_level = MACHINE_ONE,
    .redundant = MACHINE_NONE,
    .kinds = MACHINE_KINDS,
    .strict = MACHINE_ONE,
    .contact_rows = MACHINE_CONTACT_ROWS,
    .reset_places = MACHINE_RESET_PLACES,
    .resets = MACHINE_RESETS,
    .prepare = machine_prepare,
    .start = machine_start,
    .position_constraint = machine_position,
    .velocity_constraint = machine_velocity,
    .mass_matrix = machine_mass,
    .dynamics = machine_dynamics,
    .inverse_dynamics = machine_inverse_dynamics,
    .residual_tangent = machine_residual_tangent,
    .constraint_tangent = machine_constraint_tangent,
    .state_derivative = machine_rates,
    .state_derivative_tangent = machine_rates_tangent,
    .discrete_start = machine_discrete_start,
    .indicator = machine_indicator,
    .indicator_rate = machine_indicator_rate,
    .standing = machine_standing,
    .contact = machine_contact,
    .clock = machine_clock,
    .event = machine_event,
};

#endif
