/* Two masses on a line whose sum of places is to be zero, told twice: q0 + q1 = 0 and 2 q0 + 2 q1 = 0. All in closed form. */
#include <string.h>

#include "check.h"
#include "lag/derivatives.h"
#include "linear.h"

static const double K = 3.0;
static const double DIRECTION[4] = {0.3, -0.1, 0.7, 0.2};

static lag_status constraint_tangent(const lag_arguments *at, double *phi, double *residual)
{
    for (size_t i = 0; i < 2; ++i) {
        phi[i] = (double)(i + 1) * (at->dq[0] + at->dq[1]);
        residual[i] = (double)(i + 1) * (at->dqd[0] + at->dqd[1]);
    }
    return LAG_OK;
}

static lag_model model(void)
{
    memset(&linear, 0, sizeof linear);
    linear.n = linear.bars = 2;
    linear.mass[0] = 1.0;
    linear.mass[1] = 3.0;
    linear.force[0] = 5.0;
    linear.force[1] = -2.0;
    for (size_t i = 0; i < 2; ++i) {
        linear.bar[i][0] = linear.bar[i][1] = (double)(i + 1);
    }
    lag_model made = linear_model();
    made.rank = 1;
    made.constraint_tangent = constraint_tangent;
    return made;
}

/* The value that q0'' + q1'' must have. */
static double pull(double rate, const double *x)
{
    return -2.0 * rate * (x[2] + x[3]) - rate * rate * (x[0] + x[1]);
}

/* m0 a0 = f0 + l, m1 a1 = f1 + l with a0 + a1 given; l is shared between the rows as 1 : 2. */
static void expect(double sum, const double *f, const double *a, const double *lam)
{
    const double l = (sum - f[0] - f[1] / 3.0) / (1.0 + 1.0 / 3.0);
    CHECK_NEAR(a[0], f[0] + l, 1e-13);
    CHECK_NEAR(a[1], (f[1] + l) / 3.0, 1e-13);
    CHECK_NEAR(lam[0], l / 5.0, 1e-13);
    CHECK_NEAR(lam[1], 2.0 * l / 5.0, 1e-13);
}

static void test_closed_form(double rate)
{
    static const double none[2];
    const lag_model made = model();
    const double x[4] = {0.4, 0.1, -0.2, 0.5};
    double workspace[1];
    double *memory = malloc(lag_derivatives_memory(&made) * sizeof(double)); /* exactly what is declared */
    lag_derivatives d;
    const lag_arguments at = {.q = x, .qd = x + 2, .p = workspace, .workspace = workspace};
    CHECK(memory != NULL);
    lag_derivatives_place(&d, &made, memory);
    CHECK(lag_derivatives_factor(&d, &at, rate, NULL) == LAG_OK);
    expect(pull(rate, x), linear.force, d.qdd, d.lam);
    memcpy(d.x, DIRECTION, sizeof DIRECTION);
    CHECK(lag_derivatives_along(&d) == LAG_OK);
    expect(pull(rate, DIRECTION), none, d.dqdd, d.dlam);
    double rates[4], phi[2], residual[2];
    CHECK(lag_derivatives_rates(&d, rates) == LAG_OK);
    CHECK(rates[0] == DIRECTION[2] && rates[1] == DIRECTION[3] && rates[2] == d.dqdd[0] && rates[3] == d.dqdd[1]);
    CHECK(lag_derivatives_residuals(&d, phi, residual) == LAG_OK);
    CHECK(phi[1] == 2.0 * (DIRECTION[0] + DIRECTION[1]) && residual[0] == DIRECTION[2] + DIRECTION[3]);
    CHECK(lag_derivatives_definitions(&d, rates) == LAG_MISSING && lag_derivatives_energies(&d, rates) == LAG_MISSING);
    d.time = 1.0;
    CHECK(lag_derivatives_along(&d) == LAG_MISSING);
    free(memory);
}

static void slope(lag_motion *motion, const double *x, double *xd)
{
    memcpy(xd, x + 2, 2 * sizeof(double));
    CHECK(lag_motion_pulled(motion, K, 0.0, x, xd + 2, motion->lam) == LAG_OK);
}

/* q0 + q1 dies out critically damped, whatever else the masses do. */
static void test_residuals_die_out(void)
{
    const lag_model made = model();
    const double h = 1e-3;
    double x[4] = {0.4, 0.1, -0.2, 0.5};
    double k[4][4], y[4];
    const double first = x[0] + x[1];
    const double speed = x[2] + x[3];
    double *memory = calloc(lag_motion_memory(&made), sizeof(double));
    lag_motion motion;
    CHECK(memory != NULL);
    lag_motion_place(&motion, &made, memory);
    CHECK(lag_motion_parameters(&motion, made.defaults) == LAG_OK);
    for (int step = 1; step <= 2000; ++step) {
        static const double part[4] = {0.0, 0.5, 0.5, 1.0};
        for (size_t stage = 0; stage < 4; ++stage) {
            for (size_t i = 0; i < 4; ++i) {
                y[i] = x[i] + (stage > 0 ? part[stage] * h * k[stage - 1][i] : 0.0);
            }
            slope(&motion, y, k[stage]);
        }
        for (size_t i = 0; i < 4; ++i) {
            x[i] += h / 6.0 * (k[0][i] + 2.0 * k[1][i] + 2.0 * k[2][i] + k[3][i]);
        }
        const double t = h * step;
        CHECK_NEAR(x[0] + x[1], (first + (speed + K * first) * t) * exp(-K * t), 1e-11);
    }
    CHECK(fabs(x[0] + x[1]) < 0.05 * first);
    free(memory);
}

int main(void)
{
    test_closed_form(0.0);
    test_closed_form(K);
    test_residuals_die_out();
    (void)printf("derivatives: ok\n");
    return EXIT_SUCCESS;
}
