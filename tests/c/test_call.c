/* One value at one state: a mass p under a load u + z - w, where u and z begin as p and t, and w is 1 while it speeds up. */
#include "check.h"
#include "lag/call.h"
#include "lag/dynamics.h"

static unsigned prepared, started;

static lag_status prepare(const lag_arguments *at)
{
    at->workspace[0] = at->p[0];
    ++prepared;
    return LAG_OK;
}

static lag_status start(const lag_arguments *at, double *q, double *qd, double *z, double *u)
{
    q[0] = qd[0] = 0.0;
    z[0] = at->t;
    u[0] = at->workspace[0];
    ++started;
    return LAG_OK;
}

static lag_status discrete_start(const lag_arguments *at, double *w)
{
    (void)at;
    w[0] = 0.0;
    return LAG_OK;
}

static lag_status dynamics(const lag_arguments *at, double *mass, double *force, double *jacobian, double *gamma)
{
    (void)jacobian;
    (void)gamma;
    mass[0] = at->workspace[0];
    force[0] = at->u[0] + at->z[0] - at->w[0] + 0.0 * at->q[0];
    return LAG_OK;
}

static lag_status standing(const lag_arguments *at, double *next)
{
    next[0] = at->qdd[0] > 0.0;
    return LAG_OK;
}

static lag_status inverse_dynamics(const lag_arguments *at, double *force)
{
    force[0] = at->workspace[0] * at->qdd[0] - at->u[0] - at->z[0] + at->w[0] + 10.0 * at->qd[0];
    return LAG_OK;
}

static lag_status output(const lag_arguments *at, double *y)
{
    y[0] = 2.0 * at->qdd[0];
    return LAG_OK;
}

static const double DEFAULTS[1] = {4.0};
static const lag_model MODEL = {
    .version = LAG_MODEL_VERSION,
    .size = sizeof(lag_model),
    .nq = 1,
    .nz = 1,
    .nu = 1,
    .nw = 1,
    .np = 1,
    .ny = 1,
    .workspace = 1,
    .prepared = 1,
    .defaults = DEFAULTS,
    .prepare = prepare,
    .start = start,
    .discrete_start = discrete_start,
    .dynamics = dynamics,
    .standing = standing,
    .inverse_dynamics = inverse_dynamics,
    .output = output,
};

static double q[1], qd[1], z[1], u[1], w[1], p[1], qdd[1];
static double workspace[1], zero[1], first[4], stands[2], solved[1], parameters[1], results[1];

static lag_call laid_out(int what)
{
    const lag_call call = {
        .model = &MODEL,
        .what = what,
        .at = {.q = q, .qd = qd, .z = z, .u = u, .w = w, .p = p, .qdd = qdd, .workspace = workspace},
        .memory = malloc(lag_jacobian_memory(&MODEL, NULL) * sizeof(double)), /* exactly what is declared */
        .zero = zero,
        .start = first,
        .standing = stands,
        .solved = solved,
        .parameters = parameters,
        .results = results,
        .started = (double)NAN,
    };
    prepared = started = 0;
    return call;
}

static void test_what_is_left_out(void)
{
    lag_call call = laid_out(LAG_CALL_SOLVE);
    call.at.t = 2.0;
    CHECK(lag_call_once(&call, 0) == LAG_OK);
    CHECK(results[0] == (4.0 + 2.0 - 1.0) / 4.0);
    call.at.t = -9.0; /* slows down: w stays 0 */
    CHECK(lag_call_once(&call, 0) == LAG_OK);
    CHECK(results[0] == (4.0 - 9.0) / 4.0);
    u[0] = 1.0;
    z[0] = 3.0;
    w[0] = 7.0;
    CHECK(lag_call_once(&call, LAG_GIVEN_U | LAG_GIVEN_Z) == LAG_OK);
    CHECK(results[0] == (1.0 + 3.0 - 1.0) / 4.0);
    CHECK(lag_call_once(&call, LAG_GIVEN_U | LAG_GIVEN_Z | LAG_GIVEN_W) == LAG_OK);
    CHECK(results[0] == (1.0 + 3.0 - 7.0) / 4.0);
    free(call.memory);
}

static void test_prepares_once(void)
{
    lag_call call = laid_out(LAG_CALL_OUTPUT);
    p[0] = 0.5;
    for (size_t k = 0; k < 3; ++k) {
        CHECK(lag_call_once(&call, LAG_GIVEN_P) == LAG_OK);
        CHECK(results[0] == 2.0 * (0.5 - 1.0) / 0.5);
    }
    CHECK(prepared == 1 && started == 1);
    CHECK(lag_call_once(&call, 0) == LAG_OK);
    CHECK(results[0] == 2.0 * (4.0 - 1.0) / 4.0);
    CHECK(lag_call_once(&call, 0) == LAG_OK);
    CHECK(prepared == 2 && started == 2);
    p[0] = 0.25;
    CHECK(lag_call_once(&call, LAG_GIVEN_P) == LAG_OK);
    CHECK(results[0] == 2.0 * (0.25 - 1.0) / 0.25);
    call.at.t = 1.0;
    CHECK(lag_call_once(&call, LAG_GIVEN_P) == LAG_OK);
    CHECK(prepared == 3 && started == 4);
    free(call.memory);
}

static void test_accelerations_that_are_given_stay(void)
{
    lag_call call = laid_out(LAG_INVERSE_DYNAMICS);
    qdd[0] = 5.0;
    qd[0] = 0.5;
    CHECK(lag_call_once(&call, 0) == LAG_OK);
    CHECK(results[0] == 4.0 * 5.0 - 4.0 + 1.0);
    CHECK(lag_call_once(&call, LAG_GIVEN_QD) == LAG_OK);
    CHECK(results[0] == 4.0 * 5.0 - 4.0 + 1.0 + 5.0);
    free(call.memory);
}

static void test_statuses(void)
{
    lag_call call = laid_out(LAG_CALL_SOLVE);
    call.left = 2;
    CHECK(lag_call_once(&call, 0) == LAG_OK);
    results[0] = 0.0;
    CHECK(lag_call_once(&call, 0) == LAG_ATTENTION);
    CHECK(results[0] == (4.0 - 1.0) / 4.0);
    CHECK(lag_call_once(&call, 0) == LAG_OK);
    p[0] = 0.0; /* no inertia */
    CHECK(lag_call_once(&call, LAG_GIVEN_P) == LAG_SINGULAR);
    CHECK(call.coordinate == 0);
    call.what = LAG_CORRECTION;
    CHECK(lag_call_once(&call, LAG_GIVEN_W) == LAG_MISSING);
    free(call.memory);
}

int main(void)
{
    test_what_is_left_out();
    test_prepares_once();
    test_accelerations_that_are_given_stay();
    test_statuses();
    return 0;
}
