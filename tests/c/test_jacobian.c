/*
 * Two coordinates, one state, one input, one parameter, with or without a row of constraints:
 *
 *     p q0'' = u - q0^2 q0' + lam,  2 q1'' = -z q1 + q0 lam,  q0'' + q0 q1'' + q0' q1' = 0,  z' = q0'' - z q1',  y = lam + q1 u
 *
 * Written for any number of lanes: three of them need no vectors.
 */
#include <string.h>

#include "check.h"
#include "lag/batch.h"
#include "lag/dynamics.h"

enum { LANES = 3, STATES = 8, VARIABLES = 7, RATES = 5 };

static int constrained;
static double smallest = 1.0;

static lag_status prepare(const lag_arguments *at)
{
    CHECK(at->context == &smallest);
    at->workspace[0] = 1.0 / at->p[0];
    return LAG_OK;
}

static lag_status dynamics(const lag_arguments *at, double *mass, double *force, double *jacobian, double *gamma)
{
    mass[0] = at->p[0];
    mass[1] = mass[2] = 0.0;
    mass[3] = 2.0;
    force[0] = at->u[0] - at->q[0] * at->q[0] * at->qd[0];
    force[1] = -at->z[0] * at->q[1];
    if (constrained) {
        jacobian[0] = 1.0;
        jacobian[1] = at->q[0];
        gamma[0] = -at->qd[0] * at->qd[1];
    }
    return LAG_OK;
}

static void eliminate(
    const lag_arguments *at, size_t l, size_t k, double *qdd, double *lam, double *response, double *jacobian, double *gamma)
{
    const double q0 = at->q[k];
    qdd[k] = at->workspace[k] * (at->u[k] - q0 * q0 * at->qd[k]);
    qdd[l + k] = 0.5 * (-at->z[k] * at->q[l + k]);
    if (constrained) {
        lam[k] = 0.0;
        response[k] = at->workspace[k];
        response[l + k] = 0.5 * q0;
        jacobian[k] = 1.0;
        jacobian[l + k] = q0;
        gamma[k] = -at->qd[k] * at->qd[l + k];
    }
}

static lag_status elimination(
    const lag_arguments *at,
    double *qdd,
    double *lam,
    double *response,
    double *lam_response,
    double *jacobian,
    double *gamma,
    double *pivot)
{
    eliminate(at, 1, 0, qdd, lam, response, jacobian, gamma);
    if (constrained) {
        lam_response[0] = 0.0;
    }
    *pivot = smallest;
    return LAG_OK;
}

static lag_status prepare_states(const lag_arguments *at)
{
    CHECK(at->context == &smallest);
    for (size_t k = 0; k < LANES; ++k) {
        at->workspace[k] = 1.0 / at->p[k];
    }
    return LAG_OK;
}

/* The first lane of every vector always has to be solved again. */
static lag_status eliminate_states(
    const lag_arguments *at,
    double *qdd,
    double *lam,
    double *response,
    double *lam_response,
    double *jacobian,
    double *gamma,
    double *pivot)
{
    for (size_t k = 0; k < LANES; ++k) {
        eliminate(at, LANES, k, qdd, lam, response, jacobian, gamma);
        if (constrained) {
            lam_response[k] = 0.0;
        }
        pivot[k] = k == 0 ? 0.0 : 1.0;
    }
    return LAG_OK;
}

static void tangents(const lag_arguments *at, size_t l, double *motion, double *rows)
{
    const double q0 = at->q[0];
    const double lam = constrained ? at->lam[0] : 0.0;
    for (size_t k = 0; k < l; ++k) {
        const double dq0 = at->dq[k];
        motion[k] = at->dp[k] * at->qdd[0] + 2.0 * q0 * at->qd[0] * dq0 + q0 * q0 * at->dqd[k] - at->du[k];
        motion[l + k] = at->dz[k] * at->q[1] + at->z[0] * at->dq[l + k] - dq0 * lam;
        if (constrained) {
            rows[k] = dq0 * at->qdd[1] + at->dqd[k] * at->qd[1] + at->qd[0] * at->dqd[l + k];
        }
    }
}

static void rate_tangents(const lag_arguments *at, size_t l, double *rates)
{
    for (size_t k = 0; k < l; ++k) {
        rates[k] = at->dqdd[k] - at->dz[k] * at->qd[1] - at->z[0] * at->dqd[l + k];
    }
}

static void output_tangents(const lag_arguments *at, size_t l, double *y)
{
    for (size_t k = 0; k < l; ++k) {
        y[k] = (constrained ? at->dlam[k] : 0.0) + at->dq[l + k] * at->u[0] + at->q[1] * at->du[k];
    }
}

static lag_status residual_tangent(const lag_arguments *at, double *motion, double *rows)
{
    tangents(at, 1, motion, rows);
    return LAG_OK;
}

static lag_status state_derivative_tangent(const lag_arguments *at, double *rates)
{
    rate_tangents(at, 1, rates);
    return LAG_OK;
}

static lag_status output_tangent(const lag_arguments *at, double *y)
{
    output_tangents(at, 1, y);
    return LAG_OK;
}

static lag_status primal(const lag_arguments *at)
{
    at->workspace[1] = at->qdd[0];
    return LAG_OK;
}

static lag_status motion(const lag_arguments *at, double *qdd, double *lam, double *pivot)
{
    return elimination(at, qdd, lam, NULL, NULL, NULL, NULL, pivot);
}

static lag_status residual_in_lanes(const lag_arguments *at, double *dr, double *ds)
{
    tangents(at, LANES, dr, ds);
    return LAG_OK;
}

static lag_status acceleration_in_lanes(const lag_arguments *at, double *dqdd, double *dlam, double *ds, double *pivot)
{
    tangents(at, LANES, dqdd, ds);
    for (size_t k = 0; k < LANES; ++k) {
        dqdd[k] *= -at->workspace[0];
        dqdd[LANES + k] *= -0.5;
        if (constrained) {
            dlam[k] = 0.0;
        }
        pivot[k] = smallest;
    }
    return LAG_OK;
}

static lag_status rates_in_lanes(const lag_arguments *at, double *rates)
{
    rate_tangents(at, LANES, rates);
    return LAG_OK;
}

static lag_status outputs_in_lanes(const lag_arguments *at, double *y)
{
    output_tangents(at, LANES, y);
    return LAG_OK;
}

static const size_t kept[1] = {0};
static const unsigned char redundant[1] = {0};

static lag_model made(int with_elimination)
{
    const size_t rows = constrained ? 1 : 0;
    lag_model model = {
        .version = LAG_MODEL_VERSION, .context = &smallest, .nq = 2, .nz = 1, .nu = 1, .np = 1, .nc = rows, .ny = 1, .rank = rows, .workspace = 2,
        .prepared = 1, .prepare = prepare, .dynamics = dynamics, .residual_tangent = residual_tangent,
        .state_derivative_tangent = state_derivative_tangent, .output_tangent = output_tangent, .nk = rows, .kept_rows = kept,
        .redundant = redundant,
    };
    model.elimination = with_elimination ? elimination : NULL;
    return model;
}

typedef struct state {
    double q[2], qd[2], z[1], u[1], p[1], workspace[2];
    lag_arguments at;
} state;

static void draw_state(unsigned long long *seed, state *x)
{
    double *const values[] = {x->q, x->q + 1, x->qd, x->qd + 1, x->z, x->u};
    for (size_t i = 0; i < 6; ++i) {
        *values[i] = draw(seed);
    }
    x->p[0] = 1.5 + draw(seed);
    x->at = (lag_arguments){.q = x->q, .qd = x->qd, .z = x->z, .u = x->u, .p = x->p, .workspace = x->workspace, .context = &smallest};
}

/* qd, qdd, z' and y at the state. */
static void evaluate(const lag_model *model, state *x, double *rates, double *y)
{
    double *memory = malloc((lag_dynamics_memory(model) + 1) * sizeof(double));
    double lam[1] = {0.0};
    CHECK(memory != NULL);
    CHECK(prepare(&x->at) == LAG_OK);
    CHECK(lag_forward_dynamics(model, &x->at, memory, rates + 2, lam, NULL) == LAG_OK);
    rates[0] = x->qd[0];
    rates[1] = x->qd[1];
    rates[4] = rates[2] - x->z[0] * x->qd[1];
    y[0] = lam[0] + x->q[1] * x->u[0];
    free(memory);
}

/* By central differences: rates (5, 7) and outputs (1, 7). */
static void differences(const lag_model *model, state *x, double *rates, double *outputs)
{
    double *const variable[VARIABLES] = {x->q, x->q + 1, x->qd, x->qd + 1, x->z, x->u, x->p};
    const double step = 1e-5;
    for (size_t k = 0; k < VARIABLES; ++k) {
        double above[RATES], below[RATES], y_above[1], y_below[1];
        const double own = *variable[k];
        *variable[k] = own + step;
        evaluate(model, x, above, y_above);
        *variable[k] = own - step;
        evaluate(model, x, below, y_below);
        *variable[k] = own;
        for (size_t i = 0; i < RATES; ++i) {
            rates[i * VARIABLES + k] = (above[i] - below[i]) / (2.0 * step);
        }
        outputs[k] = (y_above[0] - y_below[0]) / (2.0 * step);
    }
}

static lag_status differentiate(
    const lag_model *model, const lag_tangents *tangents_of, state *x, lag_range range, double *rates, double *outputs)
{
    double *memory = malloc((lag_jacobian_memory(model, tangents_of) + 1) * sizeof(double)); /* the sanitizer looks */
    size_t coordinate = 7;
    CHECK(memory != NULL);
    CHECK(lag_jacobian_workspace(model, tangents_of) == 2);
    CHECK(prepare(&x->at) == LAG_OK);
    const lag_status status = lag_jacobian(model, tangents_of, &x->at, range, memory, rates, outputs, &coordinate);
    CHECK(status != LAG_SINGULAR || coordinate == 0);
    free(memory);
    return status;
}

static void check_all(const double *found, const double *expected, size_t count, double tolerance)
{
    for (size_t i = 0; i < count; ++i) {
        CHECK_NEAR(found[i], expected[i], tolerance);
    }
}

static const lag_tangents of_residual = {
    .lanes = LANES, .workspace = 2, .primal = primal, .residual = residual_in_lanes, .state_derivative = rates_in_lanes,
    .output = outputs_in_lanes,
};
static const lag_tangents of_acceleration = {
    .lanes = LANES, .workspace = 2, .primal = primal, .acceleration = acceleration_in_lanes,
    .state_derivative = rates_in_lanes, .output = outputs_in_lanes,
};
static const lag_tangents of_motion = {
    .lanes = LANES, .workspace = 2, .motion = motion, .acceleration = acceleration_in_lanes,
    .state_derivative = rates_in_lanes, .output = outputs_in_lanes,
};

/* Every way gives the same, and that is what differences give. */
static void jacobians(void)
{
    unsigned long long seed = 1;
    const lag_model model = made(1), dense = made(0);
    for (int k = 0; k < 50; ++k) {
        state x;
        double expected[RATES * VARIABLES], outputs[VARIABLES], single[RATES * VARIABLES], y[VARIABLES], many[RATES * VARIABLES];
        double several[RATES * 3];
        draw_state(&seed, &x);
        differences(&dense, &x, expected, outputs);
        CHECK(differentiate(&dense, NULL, &x, (lag_range){0, VARIABLES}, single, y) == LAG_OK);
        check_all(single, expected, RATES * VARIABLES, 1e-6);
        check_all(y, outputs, VARIABLES, 1e-6);
        const lag_tangents *ways[] = {&of_residual, &of_acceleration, constrained ? &of_acceleration : &of_motion};
        for (size_t way = 0; way < 3; ++way) {
            CHECK(differentiate(&model, ways[way], &x, (lag_range){0, VARIABLES}, many, outputs) == LAG_OK);
            check_all(many, single, RATES * VARIABLES, 1e-12);
            check_all(outputs, y, VARIABLES, 1e-12);
            CHECK(differentiate(&model, ways[way], &x, (lag_range){4, 3}, several, NULL) == LAG_OK);
            for (size_t i = 0; i < RATES; ++i) {
                check_all(several + i * 3, single + i * VARIABLES + 4, 3, 1e-12);
            }
            smallest = 1e-9; /* then nothing that was eliminated is used */
            CHECK(differentiate(&model, ways[way], &x, (lag_range){0, VARIABLES}, many, NULL) == LAG_OK);
            smallest = 1.0;
            check_all(many, single, RATES * VARIABLES, 1e-12);
        }
    }
}

static void failures(void)
{
    unsigned long long seed = 2;
    const lag_model model = made(1);
    double rates[RATES * VARIABLES], outputs[VARIABLES];
    const lag_tangents *ways[] = {NULL, &of_residual, &of_acceleration};
    for (size_t way = 0; way < 3; ++way) {
        state x;
        draw_state(&seed, &x);
        x.q[1] = (double)INFINITY;
        CHECK(differentiate(&model, ways[way], &x, (lag_range){0, VARIABLES}, rates, outputs) == LAG_NOT_FINITE);
        if (!constrained) {
            draw_state(&seed, &x);
            x.p[0] = 0.0;
            CHECK(differentiate(&model, ways[way], &x, (lag_range){0, VARIABLES}, rates, outputs) == LAG_SINGULAR);
            CHECK(isnan(rates[0]) && isnan(outputs[VARIABLES - 1]));
        }
    }
}

static const lag_states several = {
    .lanes = LANES, .workspace = LANES, .prepare = prepare_states, .elimination = eliminate_states
};

/* Many states at once are each as alone, those of a lane that has to be solved again, too. */
static void batches(size_t p_stride)
{
    unsigned long long seed = 3;
    const lag_model model = made(1);
    double q[2 * STATES], qd[2 * STATES], z[STATES], u[STATES], p[STATES], workspace[2], t = 0.0;
    double alone[2 * STATES], together[2 * STATES], lam[STATES], lam_together[STATES];
    for (size_t i = 0; i < 2 * STATES; ++i) {
        q[i] = draw(&seed);
        qd[i] = draw(&seed);
    }
    for (size_t i = 0; i < STATES; ++i) {
        z[i] = draw(&seed);
        u[i] = draw(&seed);
        p[i] = 2.0 + draw(&seed);
    }
    const lag_tangents *tangents_of = constrained ? &of_acceleration : &of_motion;
    double *memory = malloc((lag_jacobian_memory(&model, tangents_of) + 1) * sizeof(double));
    double *lanes = malloc((lag_batch_memory(&model, &several) + 1) * sizeof(double));
    CHECK(memory != NULL && lanes != NULL);
    const lag_batch batch = {
        .count = STATES, .t = {&t, 0}, .q = {q, 2}, .qd = {qd, 2}, .z = {z, 1}, .u = {u, 1}, .w = {&t, 0}, .p = {p, p_stride},
        .workspace = workspace, .memory = memory, .lanes = lanes,
    };
    CHECK(lag_batch_forward_dynamics(&model, NULL, &batch, alone, lam, NULL) == LAG_OK);
    CHECK(lag_batch_forward_dynamics(&model, &several, &batch, together, lam_together, NULL) == LAG_OK);
    check_all(together, alone, 2 * STATES, 0.0);
    check_all(lam_together, lam, constrained ? STATES : 0, 0.0);
    double rates[STATES * RATES * 5], outputs[STATES * 5], own[RATES * 5], y[5];
    CHECK(lag_batch_jacobian(&model, tangents_of, &batch, (lag_range){0, 5}, rates, outputs, NULL) == LAG_OK);
    for (size_t i = 0; i < STATES; ++i) {
        state x;
        memcpy(x.q, q + 2 * i, sizeof x.q);
        memcpy(x.qd, qd + 2 * i, sizeof x.qd);
        x.z[0] = z[i];
        x.u[0] = u[i];
        x.p[0] = p[i * p_stride];
        x.at = (lag_arguments){.q = x.q, .qd = x.qd, .z = x.z, .u = x.u, .p = x.p, .workspace = x.workspace, .context = &smallest};
        CHECK(differentiate(&model, tangents_of, &x, (lag_range){0, 5}, own, y) == LAG_OK);
        check_all(rates + i * RATES * 5, own, RATES * 5, 0.0);
        check_all(outputs + i * 5, y, 5, 0.0);
    }
    free(memory);
    free(lanes);
}

int main(void)
{
    for (constrained = 0; constrained < 2; ++constrained) {
        jacobians();
        failures();
        batches(0);
        batches(1);
    }
    (void)printf("jacobian: ok\n");
    return 0;
}
