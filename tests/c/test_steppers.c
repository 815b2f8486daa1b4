/* Orders, error control, dense output of the methods that choose their steps. */
#include <string.h>

#include "check.h"
#include "lag/methods/radau.h"
#include "lag/stepper.h"
#include "problems.h"

enum { MOST_MEMORY = 4096 };

static double block[MOST_MEMORY];

static lag_stepper *place(lag_stepper *s, const lag_ode *ode, const double *x, double tolerance)
{
    CHECK(lag_stepper_memory(ode) <= MOST_MEMORY);
    lag_stepper_place(s, ode, block);
    memcpy(s->x, x, ode->size * sizeof(double));
    for (size_t i = 0; i < ode->size; ++i) {
        s->tolerance[i] = tolerance;
    }
    s->h_least = 1e-14;
    return s;
}

static lag_status go(lag_stepper *s, const lag_method *method, double stop)
{
    lag_status status = lag_stepper_begin(s, method, stop - s->t);
    while (status == LAG_OK && s->t < stop) {
        status = lag_stepper_step(s, stop);
    }
    return status;
}

/* Absolute and relative tolerance alike, as the test sets of the literature have it. */
static lag_status go_relatively(lag_stepper *s, const lag_method *method, double stop, double tolerance)
{
    lag_status status = lag_stepper_begin(s, method, stop - s->t);
    while (status == LAG_OK && s->t < stop) {
        for (size_t i = 0; i < s->ode->size; ++i) {
            s->tolerance[i] = tolerance * (1.0 + fabs(s->x[i]));
        }
        status = lag_stepper_step(s, stop);
    }
    return status;
}

static double distance(size_t size, const double *x, const double *y)
{
    double most = 0.0;
    for (size_t i = 0; i < size; ++i) {
        most = fmax(most, fabs(x[i] - y[i]));
    }
    return most;
}

static const lag_ode SMOOTH = {.size = 3, .nq = 1, .rates = smooth_rates, .jacobian = smooth_jacobian};
static const lag_ode LINEAR = {.size = 3, .nq = 1, .rates = linear_rates, .jacobian = linear_jacobian};

typedef struct errors {
    double at_end, inside; /* inside the steps by dense output */
    size_t steps;
} errors;

/* Over so many steps of one length; the tolerance rejects nothing. */
static errors measure(const lag_method *method, const lag_ode *ode, void (*solution)(double t, double *x), double stop, int steps)
{
    double exact[3];
    double x[3];
    errors found = {0.0, 0.0, 0};
    lag_stepper s;
    solution(0.0, x);
    place(&s, ode, x, 1e10);
    s.h = s.h_most = stop / (double)steps;
    CHECK(lag_stepper_begin(&s, method, stop) == LAG_OK);
    while (s.t < stop) {
        CHECK(lag_stepper_step(&s, stop) == LAG_OK);
        for (int part = 1; part < 8; ++part) {
            const double t = s.t_before + (s.t - s.t_before) * (double)part / 8.0;
            CHECK(lag_stepper_dense(&s, t, x) == LAG_OK);
            solution(t, exact);
            found.inside = fmax(found.inside, distance(3, x, exact));
        }
    }
    solution(stop, exact);
    found.at_end = distance(3, s.x, exact);
    found.steps = s.counts.steps;
    CHECK(found.steps == (size_t)steps);
    return found;
}

static void orders(const lag_method *method, errors coarse, errors fine)
{
    const double finer = log((double)fine.steps / (double)coarse.steps);
    const double order = log(coarse.at_end / fine.at_end) / finer;
    const double dense = log(coarse.inside / fine.inside) / finer;
    (void)printf("%s: order %.2f (nominal %u), of its dense output %.2f (%u), %zu and %zu steps\n", method->name, order,
        method->order, dense, method->dense_order, coarse.steps, fine.steps);
    CHECK(order >= (double)method->order - 0.3);
    CHECK(dense >= (double)method->dense_order - 0.3);
}

static double arenstorf_error(double tolerance)
{
    static const lag_ode ode = {.size = 4, .nq = 2, .rates = arenstorf_rates};
    lag_stepper s;
    place(&s, &ode, ARENSTORF_START, tolerance);
    CHECK(go(&s, &lag_dop853, ARENSTORF_PERIOD) == LAG_OK);
    CHECK(s.t == ARENSTORF_PERIOD);
    const double error = distance(4, s.x, ARENSTORF_START);
    (void)printf("dop853: Arenstorf, tolerance %.0e: error %.1e, %zu steps, %zu rejected, %zu evaluations\n", tolerance, error,
        s.counts.steps, s.counts.rejections, s.counts.evaluations);
    return error;
}

/*
 * Values at t = 2 from the Test Set for Initial Value Problem Solvers (Mazzia and Magherini 2008), problem vdpol. `worst` and `most`
 * are the error and 0.85 of the right-hand sides of CVODES (SUNDIALS, by CasADi 3.8.2, exact Jacobian), the best of three absolute tolerances.
 */
static void van_der_pol(double tolerance, double worst, size_t most)
{
    static double epsilon = 1e-6;
    static const lag_ode ode = {.size = 2, .nq = 1, .context = &epsilon, .rates = van_der_pol_rates, .jacobian = van_der_pol_jacobian};
    static const double start[2] = {2.0, 0.0};
    static const double exact[2] = {0.1706167732170483e1, -0.8928097010247975};
    lag_stepper s;
    place(&s, &ode, start, tolerance);
    CHECK(go_relatively(&s, &lag_radau, 2.0, tolerance) == LAG_OK);
    const double error = distance(2, s.x, exact);
    (void)printf("radau: van der Pol, tolerance %.0e: error %.1e, %zu steps, %zu rejected, %zu evaluations, %zu Jacobians, %zu "
                 "decompositions\n",
        tolerance, error, s.counts.steps, s.counts.rejections, s.counts.evaluations, s.counts.jacobians, s.counts.decompositions);
    CHECK(error <= worst);
    CHECK(s.counts.evaluations <= most);
}

/* The error against a run that is far more accurate goes with the tolerance. */
static void double_pendulum(void)
{
    static const lag_ode ode = {.size = 4, .nq = 2, .rates = double_pendulum_rates};
    static const double start[4] = {1.0, 1.5, 0.0, 0.0};
    double reference[4];
    lag_stepper s;
    place(&s, &ode, start, 1e-14);
    CHECK(go(&s, &lag_dop853, 10.0) == LAG_OK);
    memcpy(reference, s.x, sizeof reference);
    CHECK_NEAR(double_pendulum_energy(reference), double_pendulum_energy(start), 1e-12);
    for (double tolerance = 1e-6; tolerance > 1e-13; tolerance *= 1e-2) {
        place(&s, &ode, start, tolerance);
        CHECK(go(&s, &lag_dop853, 10.0) == LAG_OK);
        const double error = distance(4, s.x, reference);
        (void)printf("dop853: double pendulum, tolerance %.0e: error %.1e, %zu evaluations\n", tolerance, error, s.counts.evaluations);
        CHECK(error <= 1e3 * tolerance);
    }
}

/* Stiff directions that turn: steps are limited by accuracy, not by how far the Jacobian changes. */
static void turning(const lag_method *method, double tolerance, size_t most)
{
    static const lag_ode ode = {.size = 2, .nq = 0, .rates = turning_rates, .jacobian = turning_jacobian};
    static const double start[2] = {0.0, 1.0};
    const double exact[2] = {sin(3.0), cos(3.0)};
    lag_stepper s;
    place(&s, &ode, start, tolerance);
    CHECK(go(&s, method, 3.0) == LAG_OK);
    const double error = distance(2, s.x, exact);
    (void)printf("%s: stiff direction that turns, tolerance %.0e: error %.1e, %zu steps, %zu rejected, %zu evaluations, %zu Jacobians\n",
        method->name, tolerance, error, s.counts.steps, s.counts.rejections, s.counts.evaluations, s.counts.jacobians);
    CHECK(error <= tolerance);
    CHECK(s.counts.evaluations <= most);
}

static lag_status wall_rates(void *context, double t, const double *x, double *xd)
{
    (void)context;
    (void)t;
    xd[0] = 1.0;
    return x[0] > 1.0 ? LAG_SINGULAR : LAG_OK;
}

static void trouble_stops_at_the_wall(void)
{
    static const lag_ode ode = {.size = 1, .nq = 0, .rates = wall_rates};
    static const double start[1] = {0.0};
    lag_stepper s;
    place(&s, &ode, start, 1e-8);
    CHECK(go(&s, &lag_dop853, 2.0) == LAG_STEP_TOO_SMALL);
    CHECK(s.trouble.status == LAG_SINGULAR);
    CHECK_NEAR(s.t, 1.0, 1e-9);
    CHECK_NEAR(s.x[0], s.t, 1e-12);
}

static void a_step_can_be_taken_back(const lag_method *method)
{
    double x[3];
    double once[3];
    lag_stepper s;
    smooth_exact(0.0, x);
    place(&s, &SMOOTH, x, 1e-8);
    s.h = 0.01;
    CHECK(lag_stepper_begin(&s, method, 2.0) == LAG_OK);
    CHECK(lag_stepper_step(&s, 2.0) == LAG_OK);
    memcpy(once, s.x, sizeof once);
    const double t = s.t;
    lag_stepper_undo(&s, 0.01);
    CHECK(s.t == 0.0 && distance(3, s.x, x) == 0.0);
    CHECK(lag_stepper_step(&s, 2.0) == LAG_OK);
    CHECK(s.t == t && distance(3, s.x, once) == 0.0);
}

int main(void)
{
    orders(&lag_dop853, measure(&lag_dop853, &SMOOTH, smooth_exact, 2.0, 6), measure(&lag_dop853, &SMOOTH, smooth_exact, 2.0, 12));
    orders(&lag_radau5, measure(&lag_radau5, &LINEAR, linear_exact, 4.0, 16), measure(&lag_radau5, &LINEAR, linear_exact, 4.0, 32));
    orders(&lag_radau9, measure(&lag_radau9, &LINEAR, linear_exact, 4.0, 4), measure(&lag_radau9, &LINEAR, linear_exact, 4.0, 8));
    orders(&lag_radau13, measure(&lag_radau13, &LINEAR, linear_exact, 8.0, 4), measure(&lag_radau13, &LINEAR, linear_exact, 8.0, 8));
    double before = 1.0;
    for (double tolerance = 1e-6; tolerance > 1e-13; tolerance *= 1e-2) {
        const double error = arenstorf_error(tolerance);
        CHECK(error < 0.1 * before);
        before = error;
    }
    CHECK(before <= 1e-6);
    van_der_pol(1e-4, 4.2e-6, (size_t)(0.85 * 2312));
    van_der_pol(2e-7, 5.6e-9, (size_t)(0.85 * 6224));
    van_der_pol(1e-8, 1.0e-10, (size_t)(0.85 * 11831));
    turning(&lag_radau, 1e-6, 4000);
    turning(&lag_radau, 1e-10, 5500);
    turning(&lag_radau5, 1e-6, 4000);
    double_pendulum();
    trouble_stops_at_the_wall();
    a_step_can_be_taken_back(&lag_dop853);
    a_step_can_be_taken_back(&lag_radau);
    (void)printf("steppers: ok\n");
    return EXIT_SUCCESS;
}
