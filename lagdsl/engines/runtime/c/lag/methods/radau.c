/*
 * Implicit Runge-Kutta methods Radau IIA of orders 5, 9 and 13: L-stable and stiffly accurate, with an error estimate of the order
 * of the stages and the collocation polynomial as dense output.
 *
 * Source: see lag/methods/radau.h; when a Jacobian or a decomposition is kept and when the order changes as in the authors' programs
 * RADAU5 and RADAU; step control by Gustafsson, section IV.8, formula (8.25).
 */
#include "lag/methods/radau.h"

#include <math.h>
#include <string.h>

static const double SAFETY = 0.9;
static const double SHRINK = 0.2;
static const double GROW = 8.0;
/* A step that would grow by less keeps its length, and so its decomposition. */
static const double WORTH_IT = 1.2;
/* The order goes up where Newton's method contracts by this, after some steps, and tolerances are so small a part of the state. */
static const double HIGHER = 2e-3;
enum { SETTLED = 10 };
static const double ACCURATE[LAG_RADAU_TABLES] = {0.0, 1e5, 1e9};
/* It goes down where Newton's method contracts by this while the length of steps stays within these bounds, or fails. */
static const double LOWER = 0.8;
static const double STEADY[2] = {0.8, 1.2};
/*
 * The error between the ends is not looked at, for UNSEEN steps in a row, where the last look saw less than one part of LITTLE of the error at the end,
 * foretells less than that of the tolerance, and what it foretells from has not grown by more than LITTLE.
 */
enum { UNSEEN = 4, LITTLE = 10 };
/*
 * After a step that could not be solved the next ones are shorter than it by this; the bound recedes by so much at each of them, and falls where a
 * first guess is as good as the solution.
 */
static const double BELOW = 0.8;
static const double RECEDE = 1.03;

static void begin_radau(lag_stepper *s)
{
    lag_radau_memo *memo = lag_radau_remembered(s);
    lag_radau_memo found = s->looked ? *memo : (lag_radau_memo){.level = 0.0};
    while (2 * lag_radau_tables[(size_t)found.level].stages - 1 < s->method->order) {
        found.level += 1.0;
    }
    *memo = (lag_radau_memo){
        .level = found.level,
        .trust = 1.0,
        .fresh = found.fresh,
        .usable = found.usable,
        .decomposed = found.decomposed,
        .placed = found.placed,
    };
    lag_radau_keep_band(memo, s->ode);
}

/* The collocation polynomial of the last step in Newton's form: 0 and the nodes are its places. */
static void dense_radau(const lag_stepper *s, double t, double *x)
{
    const lag_radau_places at = lag_radau_place(s);
    const size_t n = s->ode->size;
    const size_t terms = (size_t)at.memo->polynomial;
    const double h = s->t - s->t_before;
    const double part = h > 0.0 ? (t - s->t_before) / h : 1.0;
    const double *node = lag_radau_tables[(terms - 3) / 2].node;
    for (size_t i = 0; i < n; ++i) {
        double sum = 0.0;
        for (size_t k = terms; k-- > 0;) {
            sum = at.dense[k * n + i] + sum * (part - node[k]);
        }
        x[i] = s->x_before[i] + part * sum;
    }
}

/* First guess of the stages: the polynomial of the step before, continued. */
static void predict(const lag_stepper *s, const lag_radau_places *at, double h)
{
    const size_t n = s->ode->size;
    if (at->memo->polynomial == 0.0) {
        memset(at->z, 0, at->table->stages * n * sizeof(double));
        return;
    }
    for (size_t k = 0; k < at->table->stages; ++k) {
        dense_radau(s, s->t + at->table->node[k] * h, at->point);
        for (size_t i = 0; i < n; ++i) {
            at->z[k * n + i] = at->point[i] - s->x[i];
        }
    }
}

double lag_radau_error(const lag_stepper *s, const lag_radau_places *at, double h)
{
    const size_t n = s->ode->size;
    for (size_t i = 0; i < n; ++i) {
        double sum = 0.0;
        for (size_t k = 0; k < at->table->stages; ++k) {
            sum += at->table->error[k] * at->z[k * n + i];
        }
        at->right[i] = sum / h;
        at->error[i] = s->f[i] + at->right[i];
    }
    lag_radau_solve_real(s->ode, at, at->error);
    return lag_stepper_norm(s, at->error);
}

/* The estimate (8.19); filtered once more, (8.20), after a rejected step. */
static double error_of(lag_stepper *s, const lag_radau_places *at, double h, int again)
{
    const size_t n = s->ode->size;
    const double size = lag_radau_error(s, at, h);
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
        at->error[i] += at->right[i];
    }
    lag_radau_solve_real(s->ode, at, at->error);
    return lag_stepper_norm(s, at->error);
}

void lag_radau_weights(const lag_radau_table *table, double place, double *value, double *slope)
{
    for (size_t k = 0; k < table->stages; ++k) {
        value[k] = place / table->node[k];
        slope[k] = 1.0 / table->node[k];
        for (size_t j = 0; j < table->stages; ++j) {
            if (j != k) {
                const double span = table->node[k] - table->node[j];
                slope[k] = (slope[k] * (place - table->node[j]) + value[k]) / span;
                value[k] *= (place - table->node[j]) / span;
            }
        }
    }
}

/*
 * Error of the dense output, as a part of the tolerance of the run: the defect of the collocation polynomial between two of its nodes, by
 * the same matrix. The estimate above is that of the end only: a stiff motion meets its equilibrium at the nodes, however
 * long the step is, and not between them.
 */
static double error_within(lag_stepper *s, const lag_radau_places *at, double h, size_t node)
{
    const size_t n = s->ode->size;
    const double place = 0.5 * (at->table->node[node - 1] + at->table->node[node]);
    double value[LAG_RADAU_STAGES];
    double slope[LAG_RADAU_STAGES];
    lag_radau_weights(at->table, place, value, slope);
    for (size_t i = 0; i < n; ++i) {
        at->point[i] = s->x[i];
        at->right[i] = 0.0;
        for (size_t k = 0; k < at->table->stages; ++k) {
            at->point[i] += value[k] * at->z[k * n + i];
            at->right[i] += slope[k] * at->z[k * n + i];
        }
    }
    if (lag_stepper_rates(s, s->t + place * h, at->point, at->error) != LAG_OK) {
        return (double)INFINITY;
    }
    for (size_t i = 0; i < n; ++i) {
        at->error[i] -= at->right[i] / h;
    }
    lag_radau_solve_real(s->ode, at, at->error);
    return s->method->factor * lag_stepper_norm(s, at->error);
}

/*
 * The error of a step whose end has this one: that between its ends counts, too. A look costs an evaluation, and only few motions need it. The
 * polynomial of the step before, continued, misses the stages by as high a power of the length: by their ratio the miss foretells what a look would see.
 */
static double error_along(lag_stepper *s, const lag_radau_places *at, double h, const lag_radau_outcome *solved, double error)
{
    lag_radau_memo *memo = at->memo;
    const double seen = fmax(memo->within, 1.0 / (LITTLE * LITTLE));
    if (memo->missed > 0.0 && memo->unseen < UNSEEN && LITTLE * seen * solved->missed < memo->missed) {
        memo->unseen += 1.0;
        return error;
    }
    memo->within = error_within(s, at, h, at->table->stages / 2);
    if (memo->within > error) {
        memo->within = fmax(memo->within, error_within(s, at, h, at->table->stages - 1));
    }
    memo->missed = LITTLE * memo->within < error ? solved->missed : 0.0;
    memo->unseen = 0.0;
    return fmax(error, memo->within);
}

/* Gustafsson's prediction from two errors, (8.25). */
static double factor_of(const lag_stepper *s, unsigned stages, double h, double error)
{
    const double exponent = 1.0 / (double)(stages + 1);
    if (!(error > 0.0)) {
        return GROW;
    }
    if (!isfinite(error)) {
        return 0.0;
    }
    const double trend = s->last.error > 0.0 ? h / s->last.h * pow(s->last.error / error, exponent) : 1.0;
    return fmin(1.0, trend) * pow(error, -exponent);
}

/* Divided differences of z/node for number i of the state; returns the slope of the polynomial at the end, times h. */
static double differences(const lag_radau_places *at, size_t n, size_t i)
{
    const size_t stages = at->table->stages;
    const double *node = at->table->node;
    double *term = at->dense + i;
    double sum = 0.0;
    double slope = 0.0;
    for (size_t k = 0; k < stages; ++k) {
        term[k * n] = at->z[k * n + i] / node[k];
    }
    for (size_t order = 1; order < stages; ++order) {
        for (size_t k = stages; k-- > order;) {
            term[k * n] = (term[k * n] - term[(k - 1) * n]) / (node[k] - node[k - order]);
        }
    }
    for (size_t k = stages; k-- > 0;) {
        slope = sum + slope * (1.0 - node[k]);
        sum = term[k * n] + sum * (1.0 - node[k]);
    }
    return sum + slope;
}

/* The slope at the end is that of the collocation polynomial there, as the stage equations say it. */
static void accept(lag_stepper *s, const lag_radau_places *at, double h, double t_new)
{
    const size_t n = s->ode->size;
    for (size_t i = 0; i < n; ++i) {
        at->point[i] = s->x[i] + at->z[(at->table->stages - 1) * n + i];
        at->slope[i] = differences(at, n, i) / h;
    }
    at->memo->polynomial = (double)at->table->stages;
    lag_stepper_accept(s, t_new, at->point, at->slope);
}

/* The table of the next step: by how Newton's method did, and by how the length of steps changes. */
static void choose_order(lag_stepper *s, const lag_radau_places *at, const lag_radau_outcome *solved, double ratio)
{
    lag_radau_memo *memo = at->memo;
    const size_t level = (size_t)memo->level;
    const unsigned order = 2 * at->table->stages - 1;
    const int slow = solved->smooth >= LOWER && ratio >= STEADY[0] && ratio <= STEADY[1];
    memo->age += 1.0;
    if (order > s->method->order && (!solved->converged || slow)) {
        memo->level -= 1.0;
    } else if (order < s->method->highest_order && solved->converged && memo->age >= SETTLED && solved->smooth <= HIGHER &&
               lag_stepper_norm(s, s->x) >= ACCURATE[level + 1]) {
        memo->level += 1.0;
    } else {
        return;
    }
    memo->age = memo->decomposed = memo->missed = 0.0;
    memo->trust = 1.0;
    memo->trusted = 0.0;
    s->last.error = 0.0;
}

/* Length of the next step, where `factor` is what the error of this one, of length h, allows for. */
static double next_length(const lag_radau_places *at, double h, double factor)
{
    lag_radau_memo *memo = at->memo;
    const int keep = memo->usable != 0.0 && memo->turning == 0.0 && factor >= 1.0 && factor < WORTH_IT;
    double next = keep ? h : h * fmin(factor, GROW);
    if (memo->wall > 0.0) {
        next = fmin(next, BELOW * memo->wall);
        memo->wall *= RECEDE;
        memo->wall = next < 0.5 * memo->wall ? 0.0 : memo->wall;
    }
    return next;
}

/* One trial. Infinite: the stage equations could not be solved. */
static lag_status try_step(lag_stepper *s, const lag_radau_places *at, double h, int again, lag_radau_outcome *solved, double *error)
{
    const lag_status status = lag_radau_solve(s, at, h, !again, predict, solved);
    *error = solved->rejected ? solved->error : (double)INFINITY;
    *error = status == LAG_OK && solved->converged ? error_of(s, at, h, again) : *error;
    *error = *error < 1.0 ? error_along(s, at, h, solved, *error) : *error;
    return status;
}

/* The step is done. */
static void accept_step(lag_stepper *s, const lag_radau_places *at, const lag_radau_outcome *solved, double h, double next, double error)
{
    s->h = next;
    s->last.error = fmax(error, 1e-2);
    s->last.h = h;
    choose_order(s, at, solved, next / h);
}

/* It is to be tried again, shorter; by half at most where its error is not known, or that of an iterate. */
static void shorten(lag_stepper *s, const lag_radau_places *at, const lag_radau_outcome *solved, double h, double factor)
{
    const double least = solved->converged && factor > 0.0 ? SHRINK : 0.5;
    ++s->counts.rejections;
    s->h = fmax(h * fmax(least, fmin(factor, 0.9)), s->h_least);
    lag_radau_fail(at, solved);
    if (!solved->converged && !solved->rejected) {
        at->memo->wall = h;
        choose_order(s, at, solved, 0.0);
    }
}

static lag_status step_radau(lag_stepper *s, double limit)
{
    for (int rejected = 0;; rejected = 1) {
        const lag_radau_places at = lag_radau_place(s);
        const double most = (double)lag_radau_iterations(at.table->stages);
        const double proposed = fmin(s->h, s->h_most);
        const double h = lag_stepper_length(s, s->h, limit);
        const double t_new = lag_stepper_end(s, h, limit);
        double error = 0.0;
        lag_radau_outcome solved;
        const lag_status status = try_step(s, &at, h, rejected, &solved, &error);
        if (status != LAG_OK) {
            return status;
        }
        const double safety = SAFETY * (2.0 * most + 1.0) / (2.0 * most + (double)solved.iterations);
        const double factor = safety * factor_of(s, at.table->stages, h, error);
        if (error < 1.0) {
            accept(s, &at, h, t_new);
            lag_radau_keep(s, &at, &solved);
            const double next = next_length(&at, h, factor);
            accept_step(s, &at, &solved, h, h < proposed && !rejected ? fmax(next, proposed) : next, error);
            return LAG_OK;
        }
        if (h <= s->h_least) {
            ++s->counts.rejections;
            return LAG_STEP_TOO_SMALL;
        }
        shorten(s, &at, &solved, h, factor);
    }
}

size_t lag_radau_level(const lag_stepper *s, double factor)
{
    size_t level = 0;
    while (level + 1 < LAG_RADAU_TABLES && lag_stepper_norm(s, s->x) >= factor * ACCURATE[level + 1]) {
        ++level;
    }
    return level;
}

int lag_radau_reaches(lag_stepper *s, double h, double *kept)
{
    const lag_method *method = s->method;
    const lag_trouble trouble = s->trouble;
    const size_t size = s->ode->size;
    const lag_radau_places at = lag_radau_place(s);
    lag_radau_outcome solved;
    double error = 0.0;
    memcpy(kept, s->tolerance, size * sizeof(double));
    for (size_t i = 0; i < size; ++i) {
        s->tolerance[i] *= lag_radau.factor / method->factor;
    }
    s->method = &lag_radau;
    const lag_status status = try_step(s, &at, h, 0, &solved, &error);
    s->method = method;
    s->trouble = trouble;
    memcpy(s->tolerance, kept, size * sizeof(double));
    s->looked = status == LAG_OK && error < 1.0;
    return s->looked;
}

static lag_status prepare_dense_radau(lag_stepper *s)
{
    (void)s;
    return LAG_OK;
}

/* Members that the four methods share. The least number of stages is that of the dense output and of the error estimate. */
#define RADAU(NAME, LEAST, MOST)                                                                                              \
    {                                                                                                                         \
        .name = NAME, .order = 2 * (LEAST)-1, .highest_order = 2 * (MOST)-1, .dense_order = (LEAST), .implicit = 1,            \
        .factor = 1e-1, .error_order = (LEAST), .memory = lag_radau_memory, .begin = begin_radau, .step = step_radau,          \
        .prepare_dense = prepare_dense_radau, .dense = dense_radau                                                            \
    }

const lag_method lag_radau = RADAU("radau", 3, 7);
const lag_method lag_radau5 = RADAU("radau5", 3, 3);
const lag_method lag_radau9 = RADAU("radau9", 5, 5);
const lag_method lag_radau13 = RADAU("radau13", 7, 7);
