#include "lag/methods/stiffness.h"

#include <float.h>
#include <math.h>

#include "lag/methods/dop853.h"
#include "lag/methods/radau.h"

/*
 * The stability region of DOP853 reaches to about -6 on the real axis; accuracy keeps h |lambda| near 1. Above this a step of an implicit method may be
 * longer, below it the explicit method could do steps as long as those of the implicit one.
 */
static const double EASY = 2.0;
/* Steps are steady while the next one is less than so many times as long as the last, and the last and the mean less than so many times as long as each other. */
static const double STEADY = 2.0;
/* Steps before the first question without signs: what a start does tells nothing. */
enum { FIRST = 60 };
enum { SIGNS = 15, EVERY = 10, BACK = 2, ITERATIONS = 24 };
/* Products with the Jacobian that a look at its eigenvalues takes; a matrix of more columns is not formed for them. */
enum { PRODUCTS = ITERATIONS + 2 };
/*
 * Trials in vain, and looks at eigenvalues, take no more than one of so many parts of the work of a run, as far as it is foreseen. Without signs it is
 * less: runs in lanes make evaluations together, and trials alone.
 */
enum { PARTS = 32, PARTS_WITHOUT_SIGNS = 4 * PARTS };

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
    *stiffness = (lag_stiffness){.needed = BACK, .question = FIRST, .matrix = memory};
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

double lag_stiffness_fastest(const lag_stiffness *stiffness, lag_stepper *s)
{
    const size_t n = s->ode->size;
    const double *v0 = stiffness->v;
    const double *v1 = v0 + n;
    const double *v2 = v1 + n;
    const int found = iterate(stiffness, s);
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
    if (!(determinant > 1e-12 * g11 * g00)) {
        return fabs(g10 / g00);
    }
    const double a = (inner(s, v2, v1) * g00 - inner(s, v2, v0) * g10) / determinant;
    const double b = (inner(s, v2, v0) * g11 - inner(s, v2, v1) * g10) / determinant;
    const double discriminant = 0.25 * a * a + b;
    return discriminant < 0.0 ? sqrt(-b) : 0.5 * fabs(a) + sqrt(discriminant);
}

/* The work of the implicit method since the last question, in evaluations. */
static double effort_since(const lag_stiffness *stiffness, const lag_stepper *s)
{
    const lag_step_counts *before = &stiffness->before;
    const lag_step_counts done = {
        .evaluations = s->counts.evaluations - before->evaluations,
        .jacobians = s->counts.jacobians - before->jacobians,
        .decompositions = s->counts.decompositions - before->decompositions,
        .directions = s->counts.directions - before->directions,
    };
    return lag_radau_effort(s, &done);
}

static void mark(lag_stiffness *stiffness, const lag_stepper *s)
{
    stiffness->t = s->t;
    stiffness->before = s->counts;
}

/* The evaluations of the explicit method since it was marked last are those since then. */
static void count_explicit(lag_stiffness *stiffness, const lag_stepper *s)
{
    stiffness->spent += (double)(s->counts.evaluations - stiffness->before.evaluations);
    mark(stiffness, s);
}

/* The last visit of the implicit method was in vain as far as the explicit one, by what it does behind it, would have taken less work. */
static void settle_visit(lag_stiffness *stiffness)
{
    stiffness->lost += fmax(0.0, stiffness->visit - stiffness->visited / stiffness->progress);
    stiffness->visit = stiffness->visited = 0.0;
}

/* The next question without signs: behind twice the steps, or when the work is so much that one more trial in vain is a small part of it. */
static void ask_later(lag_stiffness *stiffness, const lag_stepper *s, double probe)
{
    const double work = PARTS_WITHOUT_SIGNS * (stiffness->lost + probe) - stiffness->spent;
    stiffness->question = s->counts.steps + (size_t)fmax(SIGNS, fmin((double)s->counts.steps, work / LAG_DOP853_STAGES));
}

/*
 * True if the implicit method is to go on: one step of it reaches so far that it takes less work to `stop`, its begin included, than the
 * explicit one does. As nobody knows what comes behind `stop`, at least as much is expected to come as there was. A trial in vain may take one of
 * `parts` of all.
 */
static int is_worth_it(lag_stiffness *stiffness, lag_stepper *s, double stop, double parts)
{
    const double ahead = fmax((stop - s->t) / stiffness->progress, stiffness->spent);
    const lag_radau_plan plan = lag_radau_expect(s);
    const double h = stiffness->progress * plan.step * ahead / (ahead - plan.begin);
    const int affordable = stiffness->lost + plan.probe <= (stiffness->spent + ahead) / parts && plan.begin < ahead;
    int reaches = 0;
    if (affordable && h <= fmin(s->h_most, stop - s->t)) {
        reaches = lag_radau_reaches(s, h, stiffness->v);
        stiffness->visit = effort_since(stiffness, s);
        (void)lag_stepper_rates(s, s->t, s->x, stiffness->v); /* the system is left at the present state */
    }
    if (reaches) {
        stiffness->looks = 0.0;
        s->h = h;
    } else {
        settle_visit(stiffness);
    }
    ask_later(stiffness, s, plan.probe);
    return reaches;
}

/* True if the last step of the explicit method was one of so many near the border. */
static int is_limited(lag_stiffness *stiffness, lag_stepper *s)
{
    if (s->last.urge <= EASY) {
        stiffness->signs -= stiffness->signs > 0;
        return 0;
    }
    if (stiffness->signs == 0) {
        count_explicit(stiffness, s);
    }
    return ++stiffness->signs >= SIGNS;
}

/* True if steps since the mark are steady: they do not grow, as behind a start, or become short, as in front of a corner. */
static int is_steady(const lag_stiffness *stiffness, const lag_stepper *s)
{
    const double last = s->t - s->t_before;
    const double mean = (s->t - stiffness->t) / (double)(s->counts.steps - stiffness->before.steps);
    return fmax(s->h, mean) <= STEADY * last && last <= STEADY * mean;
}

/* After a step of the explicit method. */
static const lag_method *after_explicit(lag_stiffness *stiffness, lag_stepper *s, double stop)
{
    const int limited = is_limited(stiffness, s);
    if (!limited && s->counts.steps < stiffness->question) {
        return s->method;
    }
    const int known = limited || is_steady(stiffness, s);
    const double since = stiffness->t;
    const double before = stiffness->spent;
    count_explicit(stiffness, s);
    if (!known) {
        stiffness->question = s->counts.steps + SIGNS;
        return s->method;
    }
    const double mean = (s->t - since) / (stiffness->spent - before);
    stiffness->progress = limited ? mean : fmax(mean, (s->t - s->t_before) / LAG_DOP853_STAGES);
    stiffness->signs = 0;
    settle_visit(stiffness);
    const int changes = is_worth_it(stiffness, s, stop, limited ? PARTS : PARTS_WITHOUT_SIGNS);
    stiffness->wait = changes ? EVERY : 0;
    mark(stiffness, s);
    return changes ? &lag_radau : s->method;
}

/* True if the explicit method could do steps as long as those of the implicit one; looked at as often as that costs little. */
static int is_easy(lag_stiffness *stiffness, lag_stepper *s)
{
    if (stiffness->looks + PRODUCTS > stiffness->visit / PARTS) {
        return 0;
    }
    stiffness->looks += PRODUCTS;
    return fmin(s->h, s->t - s->t_before) * lag_stiffness_fastest(stiffness, s) < EASY;
}

/* After some steps of the implicit method. */
static const lag_method *after_implicit(lag_stiffness *stiffness, lag_stepper *s)
{
    const double effort = effort_since(stiffness, s);
    const int slow = s->t - stiffness->t < stiffness->progress * effort;
    stiffness->visit += effort;
    stiffness->visited += s->t - stiffness->t;
    stiffness->wait = EVERY;
    const int easy = is_easy(stiffness, s);
    mark(stiffness, s);
    stiffness->signs = easy || slow ? stiffness->signs + 1 : 0;
    if (stiffness->signs < stiffness->needed) {
        return s->method;
    }
    stiffness->needed *= slow ? 1 : 2;
    stiffness->signs = 0;
    stiffness->wait = 0;
    stiffness->question = s->counts.steps + SIGNS;
    return &lag_dop853;
}

const lag_method *lag_stiffness_method(lag_stiffness *stiffness, lag_stepper *s, double stop)
{
    if (stiffness->wait > 0) {
        --stiffness->wait;
        return s->method;
    }
    return s->method->implicit ? after_implicit(stiffness, s) : after_explicit(stiffness, s, stop);
}

double lag_stiffness_border(const lag_stiffness *stiffness)
{
    return stiffness->signs > 0 ? -1.0 : EASY;
}

size_t lag_stiffness_steps(const lag_stiffness *stiffness, const lag_stepper *s)
{
    return stiffness->question > s->counts.steps ? stiffness->question - s->counts.steps : 1;
}
