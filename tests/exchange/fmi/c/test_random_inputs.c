/* Calls at random on a model with inputs, a parameter and an assertion: see random_calls.h. */
#include <math.h>

#include "oscillator.h"

static lag_status residual_tangent(const lag_arguments *at, double *motion, double *rows)
{
    (void)rows;
    motion[0] = at->p[0] * at->dq[0] + at->dp[0] * at->q[0] - at->du[0];
    return LAG_OK;
}

static lag_status rates_tangent(const lag_arguments *at, double *rates)
{
    rates[0] = -at->dz[0];
    return LAG_OK;
}

static lag_status output_tangent(const lag_arguments *at, double *y)
{
    y[0] = at->dq[0];
    y[1] = at->dqdd[0];
    return LAG_OK;
}

static lag_model model;

/* The oscillator with its derivatives. */
const lag_fmu lag_exported = {
    .model = &model,
    .token = "oscillator",
    .nvariable = OSC_VARIABLES,
    .variables = OSC_TABLE,
    .start = &OSC_START,
    .nominal = OSC_SIZES,
    .experiment = {0.0, 10.0, 1e-6},
    .sizes = {OSC_GROUP, OSC_SIZES, OSC_CAPS, NULL},
    .kinds = LAG_MODEL_EXCHANGE | LAG_CO_SIMULATION,
};

#include "random_calls.h"

enum { LIVES = 80 };

int main(void)
{
    model = OSC;
    model.residual_tangent = residual_tangent;
    model.state_derivative_tangent = rates_tangent;
    model.output_tangent = output_tangent;
    for (int version = 2; version <= 3; ++version) {
        CHECK(visit_at_random(23, LIVES, version) > 20 * LIVES);
    }
    return 0;
}
