/* Systems with known solutions. */
#ifndef PROBLEMS_H
#define PROBLEMS_H

#include <math.h>

#include "lag/ode.h"

/* An oscillator and an equation that depends on time and is not linear. */
static inline lag_status smooth_rates(void *context, double t, const double *x, double *xd)
{
    (void)context;
    xd[0] = x[1];
    xd[1] = -x[0];
    xd[2] = -sin(t) * x[2] * x[2];
    return LAG_OK;
}

static inline lag_status smooth_jacobian(void *context, double t, const double *x, double *j)
{
    (void)context;
    for (int i = 0; i < 9; ++i) {
        j[i] = 0.0;
    }
    j[1] = 1.0;
    j[3] = -1.0;
    j[8] = -2.0 * sin(t) * x[2];
    return LAG_OK;
}

/* From (0, 1, 1/2): sin t, cos t, 1/(3 - cos t). */
static inline void smooth_exact(double t, double *x)
{
    x[0] = sin(t);
    x[1] = cos(t);
    x[2] = 1.0 / (3.0 - cos(t));
}

/* Linear, so that Newton's method solves stage equations in one iteration: an oscillator, and decay under a load. */
static inline lag_status linear_rates(void *context, double t, const double *x, double *xd)
{
    (void)context;
    xd[0] = x[1];
    xd[1] = -x[0];
    xd[2] = sin(t) - x[2];
    return LAG_OK;
}

static inline lag_status linear_jacobian(void *context, double t, const double *x, double *j)
{
    (void)context;
    (void)t;
    (void)x;
    for (int i = 0; i < 9; ++i) {
        j[i] = 0.0;
    }
    j[1] = 1.0;
    j[3] = j[8] = -1.0;
    return LAG_OK;
}

/* From (0, 1, 1/2). */
static inline void linear_exact(double t, double *x)
{
    x[0] = sin(t);
    x[1] = cos(t);
    x[2] = 0.5 * (sin(t) - cos(t)) + exp(-t);
}

/* Distances from (sin t, cos t) decay at a rate of 1e6/s in a direction that turns with 10 rad/s, and of 1/s across it. */
static inline lag_status turning_jacobian(void *context, double t, const double *x, double *j)
{
    const double c = cos(10.0 * t);
    const double s = sin(10.0 * t);
    (void)context;
    (void)x;
    j[0] = -1e6 * c * c - s * s;
    j[1] = j[2] = (1.0 - 1e6) * s * c;
    j[3] = -1e6 * s * s - c * c;
    return LAG_OK;
}

static inline lag_status turning_rates(void *context, double t, const double *x, double *xd)
{
    double j[4];
    const double a = x[0] - sin(t);
    const double b = x[1] - cos(t);
    (void)turning_jacobian(context, t, x, j);
    xd[0] = j[0] * a + j[1] * b + cos(t);
    xd[1] = j[2] * a + j[3] * b - sin(t);
    return LAG_OK;
}

/* Orbit of Arenstorf: Hairer, Norsett and Wanner I, section II.0, formulas (0.1) and (0.2). */
static const double ARENSTORF_START[4] = {0.994, 0.0, 0.0, -2.00158510637908252240537862224};
static const double ARENSTORF_PERIOD = 17.0652165601579625588917206249;

static inline lag_status arenstorf_rates(void *context, double t, const double *x, double *xd)
{
    static const double mu = 0.012277471;
    const double nu = 1.0 - mu;
    const double a = x[0] + mu;
    const double b = x[0] - nu;
    const double d1 = pow(a * a + x[1] * x[1], 1.5);
    const double d2 = pow(b * b + x[1] * x[1], 1.5);
    (void)context;
    (void)t;
    xd[0] = x[2];
    xd[1] = x[3];
    xd[2] = x[0] + 2.0 * x[3] - nu * a / d1 - mu * b / d2;
    xd[3] = x[1] - 2.0 * x[2] - nu * x[1] / d1 - mu * x[1] / d2;
    return LAG_OK;
}

/* Van der Pol's oscillator in the stiff scaling: Hairer and Wanner II, section IV.10, with epsilon 1e-6. */
static inline lag_status van_der_pol_rates(void *context, double t, const double *x, double *xd)
{
    const double epsilon = *(const double *)context;
    (void)t;
    xd[0] = x[1];
    xd[1] = ((1.0 - x[0] * x[0]) * x[1] - x[0]) / epsilon;
    return LAG_OK;
}

static inline lag_status van_der_pol_jacobian(void *context, double t, const double *x, double *j)
{
    const double epsilon = *(const double *)context;
    (void)t;
    j[0] = 0.0;
    j[1] = 1.0;
    j[2] = (-2.0 * x[0] * x[1] - 1.0) / epsilon;
    j[3] = (1.0 - x[0] * x[0]) / epsilon;
    return LAG_OK;
}

/* Two pendulums of mass and length 1, one hanging from the other, g = 9.81; x = (angles from the vertical, their rates). */
static inline lag_status double_pendulum_rates(void *context, double t, const double *x, double *xd)
{
    static const double g = 9.81;
    const double s = sin(x[0] - x[1]);
    const double c = cos(x[0] - x[1]);
    const double f1 = -s * x[3] * x[3] - 2.0 * g * sin(x[0]);
    const double f2 = s * x[2] * x[2] - g * sin(x[1]);
    const double determinant = 2.0 - c * c;
    (void)context;
    (void)t;
    xd[0] = x[2];
    xd[1] = x[3];
    xd[2] = (f1 - c * f2) / determinant;
    xd[3] = (2.0 * f2 - c * f1) / determinant;
    return LAG_OK;
}

static inline double double_pendulum_energy(const double *x)
{
    const double kinetic = x[2] * x[2] + 0.5 * x[3] * x[3] + cos(x[0] - x[1]) * x[2] * x[3];
    return kinetic - 9.81 * (2.0 * cos(x[0]) + cos(x[1]));
}

#endif
