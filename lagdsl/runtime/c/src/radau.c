/*
 * The implicit Runge-Kutta method Radau IIA of order 5 with three stages: L-stable and stiffly accurate, with an error estimate
 * of order 3 and the collocation polynomial as dense output of order 3. Stage equations are solved by simplified Newton
 * iterations with the exact Jacobian, one real and one complex system of the size of the state.
 *
 * Source: Hairer and Wanner, Solving Ordinary Differential Equations II, 2nd ed., section IV.8; constants and the choice when a
 * Jacobian or a decomposition is kept as in the authors' program RADAU5; step control by Gustafsson, formula (8.25).
 */
#include <math.h>
#include <string.h>

#include "lag/lu.h"
#include "lag/stepper.h"

enum { NEWTON_MOST = 7 };

/* sqrt(6) = 2.449489742783178 */
static const double NODE[3] = {(4.0 - 2.449489742783178) / 10.0, (4.0 + 2.449489742783178) / 10.0, 1.0};

/* Eigenvalues of the inverse of the Runge-Kutta matrix, page 122. */
static const double MU = 3.637834252744496;
static const double ALPHA = 2.681082873627752;
static const double BETA = -3.050430199247411;

/* Their eigenvectors, and the inverse of that matrix. */
static const double T[3][3] = {
    {0.09443876248897524, -0.14125529502095421, 0.03002919410514742},
    {0.25021312296533332, 0.20412935229379994, -0.38294211275726192},
    {1.0, 1.0, 0.0}};
static const double INVERSE[3][3] = {
    {4.17871859155190428, 0.32768282076106237, 0.52337644549944951},
    {-4.17871859155190428, -0.32768282076106237, 0.47662355450055044},
    {0.50287263494578682, -2.57192694985560522, 0.59603920482822492}};

/* Weights of the stages in the error estimate, (8.19), and in the collocation polynomial. */
static const double ERROR[3] = {
    (-13.0 - 7.0 * 2.449489742783178) / 3.0, (-13.0 + 7.0 * 2.449489742783178) / 3.0, -1.0 / 3.0};
static const double DENSE[3][3] = {
    {(13.0 + 7.0 * 2.449489742783178) / 3.0, (-23.0 - 22.0 * 2.449489742783178) / 3.0, (10.0 + 15.0 * 2.449489742783178) / 3.0},
    {(13.0 - 7.0 * 2.449489742783178) / 3.0, (-23.0 + 22.0 * 2.449489742783178) / 3.0, (10.0 - 15.0 * 2.449489742783178) / 3.0},
    {1.0 / 3.0, -8.0 / 3.0, 10.0 / 3.0}};

/* Errors of the stage equations, as a part of the tolerance. */
static const double NEWTON_TOLERANCE = 1e-3;
static const double SAFETY = 0.9;
static const double SHRINK = 0.2;
static const double GROW = 8.0;
/* A step that would grow by less keeps its length, and so its decomposition. */
static const double WORTH_IT = 1.2;
/* Where Newton's method contracts by less than this the Jacobian is kept for the next step. */
static const double GOOD_RATE = 1e-3;

/* What is remembered between steps, as numbers. */
typedef struct memo {
    double fresh;      /* 1: the Jacobian is that of the present state */
    double usable;     /* 1: there is a Jacobian */
    double decomposed; /* step length of the decompositions, 0: none */
    double polynomial; /* 1: the dense output of the step before is there */
    double trust;      /* error of a Newton iterate as a part of the correction before, as seen at the step before */
} memo;

typedef struct places {
    memo *memo;
    double *jacobian;         /* (size, size) */
    double *real, *complex;   /* (size, size) and (size, size, 2), decomposed */
    double *pivots, *pivots2; /* (size) */
    double *z, *w, *slope;    /* (3, size) */
    double *dense;            /* (3, size) */
    double *right, *right2;   /* (size), (size, 2) */
    double *point;            /* (size) */
    double *error;            /* (size) */
} places;

enum { MEMO = sizeof(memo) / sizeof(double) };

static places place(const lag_stepper *s)
{
    const size_t n = s->ode->size;
    places at;
    at.memo = (memo *)(void *)s->work;
    at.jacobian = s->work + MEMO;
    at.real = at.jacobian + n * n;
    at.complex = at.real + n * n;
    at.pivots = at.complex + 2 * n * n;
    at.pivots2 = at.pivots + n;
    at.z = at.pivots2 + n;
    at.w = at.z + 3 * n;
    at.slope = at.w + 3 * n;
    at.dense = at.slope + 3 * n;
    at.right = at.dense + 3 * n;
    at.right2 = at.right + n;
    at.point = at.right2 + 2 * n;
    at.error = at.point + n;
    return at;
}

static size_t memory(size_t size)
{
    return MEMO + 4 * size * size + 19 * size;
}

static void begin(lag_stepper *s)
{
    const places at = place(s);
    *at.memo = (memo){0.0, 0.0, 0.0, 0.0, 1.0};
}

static lag_status take_jacobian(lag_stepper *s, const places *at)
{
    ++s->jacobians;
    const lag_status status = s->ode->jacobian(s->ode->context, s->t, s->x, at->jacobian);
    at->memo->fresh = at->memo->usable = status == LAG_OK ? 1.0 : 0.0;
    at->memo->decomposed = 0.0;
    if (status != LAG_OK) {
        s->trouble = status;
        s->trouble_time = s->t;
    }
    return status;
}

/* (mu/h) I - J and ((alpha + i beta)/h) I - J. */
static lag_status decompose(lag_stepper *s, const places *at, double h)
{
    const size_t n = s->ode->size;
    if (at->memo->decomposed == h) {
        return LAG_OK;
    }
    ++s->decompositions;
    for (size_t i = 0; i < n * n; ++i) {
        at->real[i] = at->complex[2 * i] = -at->jacobian[i];
        at->complex[2 * i + 1] = 0.0;
    }
    for (size_t i = 0; i < n; ++i) {
        at->real[i * n + i] += MU / h;
        at->complex[2 * (i * n + i)] += ALPHA / h;
        at->complex[2 * (i * n + i) + 1] += BETA / h;
    }
    const int regular = lag_lu(n, at->real, at->pivots) && lag_lu_complex(n, at->complex, at->pivots2);
    at->memo->decomposed = regular ? h : 0.0;
    return regular ? LAG_OK : LAG_SINGULAR;
}

/* out = matrix in, for three arrays of the state's size. */
static void transform(size_t n, const double matrix[3][3], const double *in, double *out)
{
    for (size_t i = 0; i < n; ++i) {
        for (size_t k = 0; k < 3; ++k) {
            out[k * n + i] = matrix[k][0] * in[i] + matrix[k][1] * in[n + i] + matrix[k][2] * in[2 * n + i];
        }
    }
}

static lag_status stage_slopes(lag_stepper *s, const places *at, double h)
{
    const size_t n = s->ode->size;
    lag_status status = LAG_OK;
    for (size_t k = 0; k < 3 && status == LAG_OK; ++k) {
        for (size_t i = 0; i < n; ++i) {
            at->point[i] = s->x[i] + at->z[k * n + i];
        }
        status = lag_stepper_rates(s, s->t + NODE[k] * h, at->point, at->slope + k * n);
    }
    return status;
}

/* One correction of w by Newton's method; its size as a part of the tolerances. */
static double correction(const lag_stepper *s, const places *at, double h)
{
    const size_t n = s->ode->size;
    for (size_t i = 0; i < n; ++i) {
        const double f[3] = {at->slope[i], at->slope[n + i], at->slope[2 * n + i]};
        const double w1 = at->w[n + i];
        const double w2 = at->w[2 * n + i];
        at->right[i] = INVERSE[0][0] * f[0] + INVERSE[0][1] * f[1] + INVERSE[0][2] * f[2] - MU / h * at->w[i];
        at->right2[2 * i] =
            INVERSE[1][0] * f[0] + INVERSE[1][1] * f[1] + INVERSE[1][2] * f[2] - (ALPHA * w1 - BETA * w2) / h;
        at->right2[2 * i + 1] =
            INVERSE[2][0] * f[0] + INVERSE[2][1] * f[1] + INVERSE[2][2] * f[2] - (ALPHA * w2 + BETA * w1) / h;
    }
    lag_lu_solve(n, at->real, at->pivots, at->right);
    lag_lu_complex_solve(n, at->complex, at->pivots2, at->right2);
    double sum = 0.0;
    for (size_t i = 0; i < n; ++i) {
        const double a = at->right[i] / s->tolerance[i];
        const double b = at->right2[2 * i] / s->tolerance[i];
        const double c = at->right2[2 * i + 1] / s->tolerance[i];
        sum += a * a + b * b + c * c;
    }
    return sqrt(sum / (3.0 * (double)(n > 0 ? n : 1)));
}

typedef struct outcome {
    int converged;
    unsigned iterations;
    double rate;
} outcome;

/* Simplified Newton iterations from the stages z, section IV.8, formulas (8.10) and (8.11). */
static outcome solve_stages(lag_stepper *s, const places *at, double h)
{
    const size_t n = s->ode->size;
    outcome result = {0, 0, 0.0};
    double before = 0.0;
    double trust = pow(fmax(at->memo->trust, 1e-16), 0.8);
    transform(n, INVERSE, at->z, at->w);
    for (unsigned k = 0; k < NEWTON_MOST; ++k) {
        result.iterations = k + 1;
        if (stage_slopes(s, at, h) != LAG_OK) {
            return result;
        }
        const double size = correction(s, at, h);
        const double rate = before > 0.0 ? size / before : 0.0;
        const double remaining = pow(rate, (double)(NEWTON_MOST - k)) / (1.0 - rate) * size;
        if (!isfinite(size) || (before > 0.0 && (rate >= 1.0 || remaining > NEWTON_TOLERANCE))) {
            return result;
        }
        for (size_t i = 0; i < n; ++i) {
            at->w[i] += at->right[i];
            at->w[n + i] += at->right2[2 * i];
            at->w[2 * n + i] += at->right2[2 * i + 1];
        }
        transform(n, T, at->w, at->z);
        result.rate = rate;
        trust = before > 0.0 ? rate / (1.0 - rate) : trust;
        if (size == 0.0 || trust * size < NEWTON_TOLERANCE) {
            at->memo->trust = trust;
            result.converged = 1;
            return result;
        }
        before = size;
    }
    return result;
}

static void dense(const lag_stepper *s, double t, double *x)
{
    const places at = place(s);
    const size_t n = s->ode->size;
    const double h = s->t - s->t_before;
    const double part = h > 0.0 ? (t - s->t_before) / h : 1.0;
    for (size_t i = 0; i < n; ++i) {
        x[i] = s->x_before[i] + part * (at.dense[i] + part * (at.dense[n + i] + part * at.dense[2 * n + i]));
    }
}

/* First guess of the stages: the polynomial of the step before, continued. */
static void predict(const lag_stepper *s, const places *at, double h)
{
    const size_t n = s->ode->size;
    if (at->memo->polynomial == 0.0) {
        memset(at->z, 0, 3 * n * sizeof(double));
        return;
    }
    for (size_t k = 0; k < 3; ++k) {
        dense(s, s->t + NODE[k] * h, at->point);
        for (size_t i = 0; i < n; ++i) {
            at->z[k * n + i] = at->point[i] - s->x[i];
        }
    }
}

/* Newton's method with the Jacobian at hand, and if that fails with a new one. */
static lag_status solve_step(lag_stepper *s, const places *at, double h, outcome *result)
{
    result->converged = 0;
    for (;;) {
        if (at->memo->usable == 0.0) {
            const lag_status status = take_jacobian(s, at);
            if (status != LAG_OK) {
                return status;
            }
        }
        predict(s, at, h);
        if (decompose(s, at, h) == LAG_OK) {
            *result = solve_stages(s, at, h);
        }
        if (result->converged || at->memo->fresh != 0.0) {
            return LAG_OK;
        }
        at->memo->usable = 0.0;
    }
}

/* The estimate (8.19); filtered once more, (8.20), after a rejected step. */
static double error_of(lag_stepper *s, const places *at, double h, int again)
{
    const size_t n = s->ode->size;
    for (size_t i = 0; i < n; ++i) {
        const double stages = ERROR[0] * at->z[i] + ERROR[1] * at->z[n + i] + ERROR[2] * at->z[2 * n + i];
        at->right2[i] = stages / h;
        at->error[i] = s->f[i] + at->right2[i];
    }
    lag_lu_solve(n, at->real, at->pivots, at->error);
    const double size = lag_stepper_norm(s, at->error);
    if (size < 1.0 || !again) {
        return size;
    }
    for (size_t i = 0; i < n; ++i) {
        at->point[i] = s->x[i] + at->error[i];
    }
    if (lag_stepper_rates(s, s->t, at->point, at->error) != LAG_OK) {
        return size;
    }
    for (size_t i = 0; i < n; ++i) {
        at->error[i] += at->right2[i];
    }
    lag_lu_solve(n, at->real, at->pivots, at->error);
    return lag_stepper_norm(s, at->error);
}

/* Gustafsson's prediction from two errors, (8.25). */
static double factor_of(const lag_stepper *s, double h, double error)
{
    if (!(error > 0.0)) {
        return GROW;
    }
    const double trend = s->error > 0.0 ? h / s->h_of_error * pow(s->error / error, 0.25) : 1.0;
    return fmin(1.0, trend) * pow(error, -0.25);
}

/* The slope at the end is that of the collocation polynomial there, as the stage equations say it. */
static void accept(lag_stepper *s, const places *at, double h, double t_new)
{
    const size_t n = s->ode->size;
    double *slope = at->slope + 2 * n;
    for (size_t i = 0; i < n; ++i) {
        at->point[i] = s->x[i] + at->z[2 * n + i];
        for (size_t k = 0; k < 3; ++k) {
            at->dense[k * n + i] =
                DENSE[0][k] * at->z[i] + DENSE[1][k] * at->z[n + i] + DENSE[2][k] * at->z[2 * n + i];
        }
        slope[i] = (at->dense[i] + 2.0 * at->dense[n + i] + 3.0 * at->dense[2 * n + i]) / h;
    }
    lag_stepper_accept(s, t_new, at->point, slope);
    at->memo->polynomial = 1.0;
}

static lag_status step(lag_stepper *s, double limit)
{
    const places at = place(s);
    for (int rejected = 0;; rejected = 1) {
        const double proposed = fmin(s->h, s->h_most);
        const double h = lag_stepper_length(s, limit);
        const double t_new = lag_stepper_end(s, h, limit);
        outcome solved = {0, 0, 0.0};
        const lag_status status = solve_step(s, &at, h, &solved);
        if (status != LAG_OK) {
            return status;
        }
        const double safety = SAFETY * (2.0 * NEWTON_MOST + 1.0) / (2.0 * NEWTON_MOST + (double)solved.iterations);
        const double error = solved.converged ? error_of(s, &at, h, rejected) : (double)INFINITY;
        const double factor = isfinite(error) ? safety * factor_of(s, h, error) : 0.5;
        if (error < 1.0) {
            const int renew = solved.rate > GOOD_RATE;
            accept(s, &at, h, t_new);
            s->error = fmax(error, 1e-2);
            s->h_of_error = h;
            const double next = !renew && factor >= 1.0 && factor < WORTH_IT ? h : h * fmin(factor, GROW);
            s->h = h < proposed && !rejected ? fmax(next, proposed) : next;
            at.memo->fresh = 0.0;
            at.memo->usable = renew ? 0.0 : 1.0;
            return LAG_OK;
        }
        ++s->rejections;
        if (h <= s->h_least) {
            return LAG_STUCK;
        }
        s->h = fmax(h * fmax(SHRINK, fmin(factor, 0.9)), s->h_least);
    }
}

static lag_status prepare_dense(lag_stepper *s)
{
    (void)s;
    return LAG_OK;
}

const lag_method lag_radau = {
    .name = "radau",
    .order = 5,
    .dense_order = 3,
    .implicit = 1,
    .factor = 1e-1,
    .error_order = 3,
    .memory = memory,
    .begin = begin,
    .step = step,
    .prepare_dense = prepare_dense,
    .dense = dense,
};
