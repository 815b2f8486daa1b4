/*
 * An exported model of which the motion is known: q'' = -k q + u and z' = -z, u with its derivative as a further input. Outputs are q and
 * q''; an assertion wants q < 3, an invariant k q^2 + q'^2 says nothing of the motion with u.
 */
#ifndef OSCILLATOR_H
#define OSCILLATOR_H

#include <math.h>

#include "lag/instance/instance.h"

enum { OSC_TIME, OSC_K, OSC_Q, OSC_QD, OSC_Z, OSC_QDD, OSC_ZD, OSC_U, OSC_UD, OSC_YQ, OSC_YA, OSC_STEP, OSC_ENERGY, OSC_BOTH, OSC_VARIABLES };

static inline lag_status osc_prepare(const lag_arguments *at)
{
    at->workspace[0] = at->p[0];
    return LAG_OK;
}

static inline lag_status osc_start(const lag_arguments *at, double *q, double *qd, double *z, double *u)
{
    q[0] = 4.0 / at->p[0];
    qd[0] = 0.0;
    z[0] = 1.0;
    u[0] = u[1] = 0.0;
    return LAG_OK;
}

static inline lag_status osc_mass(const lag_arguments *at, double *mass)
{
    (void)at;
    mass[0] = 1.0;
    return LAG_OK;
}

static inline lag_status osc_dynamics(const lag_arguments *at, double *mass, double *force, double *jacobian, double *gamma)
{
    (void)jacobian;
    (void)gamma;
    mass[0] = 1.0;
    force[0] = at->u[0] - at->workspace[0] * at->q[0];
    return LAG_OK;
}

static inline lag_status osc_no_rows(const lag_arguments *at, double *rows, double *jacobian)
{
    (void)at;
    (void)rows;
    (void)jacobian;
    return LAG_OK;
}

static inline lag_status osc_rates(const lag_arguments *at, double *rates)
{
    rates[0] = -at->z[0];
    return LAG_OK;
}

static inline lag_status osc_residual_tangent(const lag_arguments *at, double *motion, double *rows)
{
    (void)rows;
    motion[0] = at->workspace[0] * at->dq[0] + at->q[0] * at->dp[0] - at->du[0];
    return LAG_OK;
}

static inline lag_status osc_rates_tangent(const lag_arguments *at, double *rates)
{
    rates[0] = -at->dz[0];
    return LAG_OK;
}

static inline lag_status osc_output(const lag_arguments *at, double *y)
{
    y[0] = at->q[0];
    y[1] = at->qdd[0];
    return LAG_OK;
}

static inline lag_status osc_output_tangent(const lag_arguments *at, double *y)
{
    y[0] = at->dq[0];
    y[1] = at->dqdd[0];
    return LAG_OK;
}

/* Nothing changes with time alone. */
static inline lag_status osc_time_tangent(const lag_arguments *at, double *motion, double *rows, double *phi, double *residual, double *rates,
    double *y, double *total, double *kinetic, double *potential, double *jacobi, double *d)
{
    (void)at;
    (void)rows;
    (void)phi;
    (void)residual;
    (void)d;
    motion[0] = rates[0] = y[0] = y[1] = *total = *kinetic = *potential = *jacobi = 0.0;
    return LAG_OK;
}

static inline lag_status osc_energies(const lag_arguments *at, double *total, double *kinetic, double *potential, double *jacobi)
{
    *kinetic = 0.5 * at->qd[0] * at->qd[0];
    *potential = 0.5 * at->p[0] * at->q[0] * at->q[0];
    *total = *jacobi = *kinetic + *potential;
    return LAG_OK;
}

static inline lag_status osc_monitor(const lag_arguments *at, double *invariant, double *scale, double *assertion)
{
    (void)invariant;
    (void)scale;
    assertion[0] = at->q[0] < 3.0;
    return LAG_OK;
}

static const lag_slot OSC_SLOTS[2] = {{"q", "m", NULL}, {"r", "1", NULL}};
static const double OSC_DEFAULTS[1] = {4.0};
static const char *const OSC_ASSERTIONS[1] = {"q is too large"};

static const lag_model OSC = {
    .version = LAG_MODEL_VERSION,
    .size = sizeof(lag_model),
    .name = "Oscillator",
    .nq = 1,
    .nz = 1,
    .nu = 2,
    .np = 1,
    .ny = 2,
    .na = 1,
    .workspace = 1,
    .prepared = 1,
    .coordinates = OSC_SLOTS,
    .states = OSC_SLOTS + 1,
    .inputs = OSC_SLOTS,
    .parameters = OSC_SLOTS,
    .outputs = OSC_SLOTS,
    .assertions = OSC_ASSERTIONS,
    .defaults = OSC_DEFAULTS,
    .prepare = osc_prepare,
    .start = osc_start,
    .position_constraint = osc_no_rows,
    .velocity_constraint = osc_no_rows,
    .mass_matrix = osc_mass,
    .dynamics = osc_dynamics,
    .residual_tangent = osc_residual_tangent,
    .state_derivative = osc_rates,
    .state_derivative_tangent = osc_rates_tangent,
    .output = osc_output,
    .output_tangent = osc_output_tangent,
    .time_tangent = osc_time_tangent,
    .energies = osc_energies,
    .monitor = osc_monitor,
};

static const lag_variable OSC_TABLE[OSC_VARIABLES] = {
    {LAG_ROLE_TIME, LAG_TYPE_REAL, LAG_SET_NEVER, 0, 1, "v0"},
    {LAG_ROLE_PARAMETER, LAG_TYPE_REAL, LAG_SET_TUNABLE, 0, 1, "v1"},
    {LAG_ROLE_STATE, LAG_TYPE_REAL, LAG_SET_ALWAYS, 0, 1, "v2"},
    {LAG_ROLE_STATE, LAG_TYPE_REAL, LAG_SET_ALWAYS, 1, 1, "v3"},
    {LAG_ROLE_STATE, LAG_TYPE_REAL, LAG_SET_ALWAYS, 2, 1, "v4"},
    {LAG_ROLE_DERIVATIVE, LAG_TYPE_REAL, LAG_SET_NEVER, 1, 1, "v5"},
    {LAG_ROLE_DERIVATIVE, LAG_TYPE_REAL, LAG_SET_NEVER, 2, 1, "v6"},
    {LAG_ROLE_INPUT, LAG_TYPE_REAL, LAG_SET_ALWAYS, 0, 1, "v7"},
    {LAG_ROLE_INPUT, LAG_TYPE_REAL, LAG_SET_ALWAYS, 1, 1, "v8"},
    {LAG_ROLE_OUTPUT, LAG_TYPE_REAL, LAG_SET_NEVER, 0, 1, "v9"},
    {LAG_ROLE_OUTPUT, LAG_TYPE_REAL, LAG_SET_NEVER, 1, 1, "v10"},
    {LAG_ROLE_OPTION, LAG_TYPE_REAL, LAG_SET_TUNABLE, LAG_OPTION_STEP, 1, "v11"},
    {LAG_ROLE_ENERGY, LAG_TYPE_REAL, LAG_SET_NEVER, 0, 1, "v12"},
    {LAG_ROLE_OUTPUT, LAG_TYPE_REAL, LAG_SET_NEVER, 0, 2, "v13"},
};
static const double OSC_STATE[3] = {1.0, 0.0, 1.0};
static const size_t OSC_ENTRIES[3] = {0, 1, 2};
static const lag_start OSC_START = {.t = 0.0, .x = OSC_STATE};
static const double OSC_GROUP[3] = {0.0, 1.0, 2.0};
static const double OSC_SIZES[3] = {1.0, 1.0, 1.0};
static const double OSC_CAPS[3] = {HUGE_VAL, HUGE_VAL, HUGE_VAL};

static const lag_fmu OSC_FMU = {
    .model = &OSC,
    .token = "oscillator",
    .nvariable = OSC_VARIABLES,
    .variables = OSC_TABLE,
    .start = &OSC_START,
    .nominal = OSC_SIZES,
    .experiment = {0.0, 10.0, 1e-9},
    .sizes = {OSC_GROUP, OSC_SIZES, OSC_CAPS, NULL},
    .states = {3, OSC_ENTRIES},
    .kinds = LAG_MODEL_EXCHANGE | LAG_CO_SIMULATION,
};

#endif
