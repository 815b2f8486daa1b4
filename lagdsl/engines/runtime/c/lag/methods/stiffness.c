#include "lag/methods/stiffness.h"

#include <float.h>
#include <math.h>

#include "lag/methods/radau.h"

/* The stability region of DOP853 reaches to about -6 on the real axis; accuracy keeps h |lambda| near 1. */
static const double BORDER = 3.5;
/* Below this the explicit method could do steps as long as those of the implicit one. */
static const double EASY = 2.0;
enum { SIGNS = 15, PAUSE = 100, EVERY = 10, BACK = 2, ITERATIONS = 24 };
/* Products with the Jacobian that a look at its eigenvalues takes; a matrix of more columns is not formed for them. */
enum { PRODUCTS = ITERATIONS + 2 };
/* Evaluations of an explicit step. */
enum { EXPLICIT = 12 };
/* Trials in vain take no more than one of so many parts of the explicit work of a run. */
enum { PARTS = 4 };

/* Numbers of the matrix. */
static size_t matrix_numbers(size_t size)
{
    return size <= PRODUCTS ? size * size : 0;
}

size_t lag_stiffness_memory(size_t size)
{
    return matrix_numbers(size) + 5 * size;
}

void lag_stiffness_place(lag_stiffness *stiffness, size_t size, double *memory)
{
    *stiffness = (lag_stiffness){.needed = BACK, .matrix = memory};
    stiffness->v = memory + matrix_numbers(size);
    stiffness->f = stiffness->v + 3 * size;
    stiffness->point = stiffness->f + size;
}

/* out = matrix in */
static void multiply(size_t n, const double *matrix, const double *in, double *out)
{
    for (size_t i = 0; i < n; ++i) {
        double sum = 0.0;
        for (size_t j = 0; j < n; ++j) {
            sum += matrix[i * n + j] * in[j];
        }
        out[i] = sum;
    }
}

static double inner(const lag_stepper *s, const double *a, const double *b)
{
    double sum = 0.0;
    for (size_t i = 0; i < s->ode->size; ++i) {
        sum += a[i] / s->tolerance[i] * (b[i] / s->tolerance[i]);
    }
    return sum;
}

/* Prepares products with the Jacobian at the present state: by itself, or by the rates there. */
static lag_status prepare(const lag_stiffness *stiffness, lag_stepper *s)
{
    if (s->ode->size <= PRODUCTS) {
        ++s->counts.jacobians;
        return s->ode->jacobian(s->ode->context, s->t, s->x, stiffness->matrix);
    }
    ++s->counts.evaluations;
    return s->ode->rates(s->ode->context, s->t, s->x, stiffness->f);
}

/* out = Jacobian in: of a matrix that is not formed by a difference, as long as the tolerances, or as rounding asks for. */
static lag_status multiply_jacobian(const lag_stiffness *stiffness, lag_stepper *s, const double *in, double *out)
{
    const size_t n = s->ode->size;
    if (n <= PRODUCTS) {
        multiply(n, stiffness->matrix, in, out);
        return LAG_OK;
    }
    const double by = fmax(1.0, sqrt(DBL_EPSILON) * lag_stepper_norm(s, s->x)) / lag_stepper_norm(s, in);
    for (size_t i = 0; i < n; ++i) {
        stiffness->point[i] = s->x[i] + by * in[i];
    }
    ++s->counts.evaluations;
    const lag_status status = s->ode->rates(s->ode->context, s->t, stiffness->point, out);
    for (size_t i = 0; i < n; ++i) {
        out[i] = (out[i] - stiffness->f[i]) / by;
    }
    return status;
}

/* v0, towards the fastest eigenvector and of length 1, and its two products with the Jacobian behind it. Returns 0 where there are none. */
static int iterate(const lag_stiffness *stiffness, lag_stepper *s)
{
    const size_t n = s->ode->size;
    double *v0 = stiffness->v;
    double *v1 = v0 + n;
    lag_status status = prepare(stiffness, s);
    for (size_t i = 0; i < n; ++i) {
        v0[i] = s->tolerance[i] * (1.0 + 0.618 * (double)(i % 5)) * (i % 2 == 0 ? 1.0 : -1.0);
    }
    for (int k = 0; k < ITERATIONS && status == LAG_OK; ++k) {
        status = multiply_jacobian(stiffness, s, v0, v1);
        const double length = sqrt(inner(s, v1, v1));
        if (!(length > 0.0) || !isfinite(length)) {
            return 0;
        }
        for (size_t i = 0; i < n; ++i) {
            v0[i] = v1[i] / length;
        }
    }
    status = status == LAG_OK ? multiply_jacobian(stiffness, s, v0, v1) : status;
    return status == LAG_OK && multiply_jacobian(stiffness, s, v1, v1 + n) == LAG_OK;
}

double lag_stiffness_fastest(const lag_stiffness *stiffness, lag_stepper *s, int *decays)
{
    const size_t n = s->ode->size;
    const double *v0 = stiffness->v;
    const double *v1 = v0 + n;
    const double *v2 = v1 + n;
    const int found = iterate(stiffness, s);
    *decays = 0;
    if (n > PRODUCTS) {
        (void)prepare(stiffness, s); /* the system is left at the present state */
    }
    if (!found) {
        return 0.0;
    }
    /* lambda^2 = a lambda + b, in least squares on v2 = a v1 + b v0: one real eigenvalue or a pair */
    const double g11 = inner(s, v1, v1);
    const double g10 = inner(s, v1, v0);
    const double g00 = inner(s, v0, v0);
    const double determinant = g11 * g00 - g10 * g10;
    const double along = g10 / g00;
    if (!(determinant > 1e-12 * g11 * g00)) {
        *decays = along < 0.0;
        return fabs(along);
    }
    const double a = (inner(s, v2, v1) * g00 - inner(s, v2, v0) * g10) / determinant;
    const double b = (inner(s, v2, v0) * g11 - inner(s, v2, v1) * g10) / determinant;
    const double discriminant = 0.25 * a * a + b;
    if (discriminant < 0.0) {
        *decays = -0.5 * a > 0.05 * sqrt(-b);
        return sqrt(-b);
    }
    const double value = 0.5 * a + (a < 0.0 ? -1.0 : 1.0) * sqrt(discriminant);
    *decays = value < 0.0;
    return fabs(value);
}

/* The work of the implicit method since the last question, in evaluations. */
static double effort_since(const lag_stiffness *stiffness, const lag_stepper *s)
{
    const lag_step_counts *before = &stiffness->before;
    const lag_step_counts done = {
        .evaluations = s->counts.evaluations - before->evaluations,
        .jacobians = s->counts.jacobians - before->jacobians,
        .decompositions = s->counts.decompositions - before->decompositions,
    };
    return lag_radau_effort(s, &done);
}

static void mark(lag_stiffness *stiffness, const lag_stepper *s)
{
    stiffness->t = s->t;
    stiffness->before = s->counts;
}

/* Evaluations of the explicit method so far. */
static double spent(const lag_stiffness *stiffness, const lag_stepper *s)
{
    return stiffness->spent + (double)(s->counts.evaluations - stiffness->before.evaluations);
}

/*
 * Evaluations that a trial of the implicit method may cost: a part of what the explicit one takes to `stop`, without what was lost before. As nobody
 * knows what comes behind `stop`, it may also cost as much again as was spent; if anything was lost, it has to be that part of it.
 */
static double budget(const lag_stiffness *stiffness, const lag_stepper *s, double stop)
{
    const double ahead = EXPLICIT * (stop - s->t) / (s->t - s->t_before);
    const double so_far = spent(stiffness, s);
    return fmax(so_far - PARTS * stiffness->lost, (so_far + ahead) / PARTS - stiffness->lost);
}

/* True if the implicit method is to be tried; else the explicit one goes on for some steps. */
static int is_worth_a_trial(lag_stiffness *stiffness, lag_stepper *s, double stop)
{
    const double most = budget(stiffness, s, stop);
    int decays = 0;
    stiffness->wait = PAUSE;
    if (stiffness->trial > most || (s->t - s->t_before) * lag_stiffness_fastest(stiffness, s, &decays) <= BORDER || !decays) {
        return 0;
    }
    stiffness->trial = lag_radau_trial(s, EVERY * BACK);
    stiffness->wait = (unsigned)fmin(ceil(fmax(stiffness->trial - most, 0.0) / EXPLICIT), PAUSE);
    return stiffness->wait == 0;
}

const lag_method *lag_stiffness_method(lag_stiffness *stiffness, lag_stepper *s, double stop)
{
    const double h = s->t - s->t_before;
    int decays = 0;
    if (stiffness->wait > 0) {
        --stiffness->wait;
        return s->method;
    }
    if (!s->method->implicit) {
        stiffness->signs = s->last.urge > BORDER ? stiffness->signs + 1 : 0;
        if (stiffness->signs < SIGNS) {
            return s->method;
        }
        stiffness->signs = 0;
        if (!is_worth_a_trial(stiffness, s, stop)) {
            return s->method;
        }
        stiffness->spent = spent(stiffness, s);
        stiffness->visit = 0.0;
        stiffness->wait = EVERY;
        stiffness->progress = h / EXPLICIT;
        mark(stiffness, s);
        return &lag_radau;
    }
    stiffness->wait = EVERY;
    const double effort = effort_since(stiffness, s);
    const int slow = s->t - stiffness->t < stiffness->progress * effort;
    stiffness->visit += effort;
    mark(stiffness, s);
    const int easy = fmin(s->h, h) * lag_stiffness_fastest(stiffness, s, &decays) < EASY;
    stiffness->signs = easy || slow ? stiffness->signs + 1 : 0;
    if (stiffness->signs < stiffness->needed) {
        return s->method;
    }
    stiffness->lost += slow ? stiffness->visit : 0.0;
    stiffness->needed *= slow ? 1 : 2;
    stiffness->signs = 0;
    stiffness->wait = 0;
    mark(stiffness, s);
    return &lag_dop853;
}

double lag_stiffness_border(const lag_stiffness *stiffness)
{
    return stiffness->wait > 0 ? -1.0 : BORDER;
}

void lag_stiffness_rest(lag_stiffness *stiffness)
{
    stiffness->signs = 0;
}
