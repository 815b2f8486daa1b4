/* Orders of the methods with given steps, and what each is good for. */
#include <string.h>

#include "check.h"
#include "lag/fixed.h"
#include "problems.h"

enum { MOST_MEMORY = 64 };

static double memory[MOST_MEMORY];

/* q'' = -sin q - d q' + z, z' = (cos t - z)/tau: x = (q, qd, z). */
static lag_status driven_rates(void *context, double t, const double *x, double *xd)
{
    (void)context;
    xd[0] = x[1];
    xd[1] = -sin(x[0]) - 0.1 * x[1] + x[2];
    xd[2] = 2.0 * (cos(t) - x[2]);
    return LAG_OK;
}

static lag_status driven_jacobian(void *context, double t, const double *x, double *j)
{
    (void)context;
    (void)t;
    memset(j, 0, 9 * sizeof(double));
    j[1] = 1.0;
    j[3] = -cos(x[0]);
    j[4] = -0.1;
    j[5] = 1.0;
    j[8] = -2.0;
    return LAG_OK;
}

static void go(lag_fixed_step *step, const lag_ode *ode, double stop, size_t count, double *x)
{
    const double h = stop / (double)count;
    CHECK(lag_fixed_memory(ode->size) <= MOST_MEMORY);
    for (size_t i = 0; i < count; ++i) {
        CHECK(step(ode, (double)i * h, h, x, memory) == LAG_OK);
    }
}

static void order(lag_fixed_step *step, const char *name, double nominal)
{
    static const lag_ode ode = {.size = 3, .nq = 1, .rates = driven_rates, .jacobian = driven_jacobian};
    double error[2] = {0.0, 0.0};
    double exact[3] = {0.5, 0.0, 0.2};
    go(lag_rk4, &ode, 2.0, 2000, exact);
    for (size_t k = 0; k < 2; ++k) {
        double x[3] = {0.5, 0.0, 0.2};
        go(step, &ode, 2.0, (size_t)40 << k, x);
        for (int i = 0; i < 3; ++i) {
            error[k] = fmax(error[k], fabs(x[i] - exact[i]));
        }
    }
    (void)printf("%s: order %.2f (nominal %.0f)\n", name, log2(error[0] / error[1]), nominal);
    CHECK(log2(error[0] / error[1]) >= nominal - 0.3);
}

static lag_status pendulum_rates(void *context, double t, const double *x, double *xd)
{
    (void)context;
    (void)t;
    xd[0] = x[1];
    xd[1] = -sin(x[0]);
    return LAG_OK;
}

/* 2000 s of a pendulum at 25 steps per swing: the energy comes back. */
static void the_leapfrog_keeps_energy(void)
{
    static const lag_ode ode = {.size = 2, .nq = 1, .rates = pendulum_rates};
    double x[2] = {1.0, 0.0};
    double most = 0.0;
    for (size_t i = 0; i < 8000; ++i) {
        CHECK(lag_leapfrog(&ode, 0.0, 0.25, x, memory) == LAG_OK);
        most = fmax(most, fabs(0.5 * x[1] * x[1] - cos(x[0]) + cos(1.0)));
    }
    CHECK(most < 1e-2);
}

/* Steps a thousand times as long as the fast time of the oscillator. */
static void the_rosenbrock_method_is_stable(void)
{
    static double epsilon = 1e-6;
    static const lag_ode ode = {.size = 2, .nq = 1, .context = &epsilon, .rates = van_der_pol_rates, .jacobian = van_der_pol_jacobian};
    double x[2] = {2.0, -0.66};
    go(lag_ros2, &ode, 0.5, 500, x);
    CHECK_NEAR(x[1], x[0] / (1.0 - x[0] * x[0]), 1e-4);
}

static lag_status failing_rates(void *context, double t, const double *x, double *xd)
{
    (void)context;
    xd[0] = -x[0];
    return t > 0.5 ? LAG_NOT_FINITE : LAG_OK;
}

static lag_status one_jacobian(void *context, double t, const double *x, double *j)
{
    (void)context;
    (void)t;
    (void)x;
    j[0] = -1.0;
    return LAG_OK;
}

static void what_fails_changes_nothing(lag_fixed_step *step)
{
    static const lag_ode ode = {.size = 1, .nq = 0, .rates = failing_rates, .jacobian = one_jacobian};
    double x[1] = {1.0};
    CHECK(step(&ode, 0.0, 0.4, x, memory) == LAG_OK);
    const double before = x[0];
    CHECK(step(&ode, 0.4, 0.4, x, memory) == LAG_NOT_FINITE);
    CHECK(x[0] == before);
}

int main(void)
{
    order(lag_rk4, "rk4", 4.0);
    order(lag_leapfrog, "leapfrog", 2.0);
    order(lag_ros2, "ros2", 2.0);
    the_leapfrog_keeps_energy();
    the_rosenbrock_method_is_stable();
    what_fails_changes_nothing(lag_rk4);
    what_fails_changes_nothing(lag_leapfrog);
    what_fails_changes_nothing(lag_ros2);
    (void)printf("fixed: ok\n");
    return EXIT_SUCCESS;
}
