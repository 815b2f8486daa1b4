/*
 * The explicit Runge-Kutta method of Dormand and Prince of order 8 with error estimates of orders 5 and 3 and dense output of
 * order 7, with PI step control.
 *
 * Source: Hairer, Norsett and Wanner, Solving Ordinary Differential Equations I, 2nd ed., sections II.5 (method, page 181),
 * II.6 (dense output), II.10 (error estimate); coefficients as in the authors' program DOP853. Step control: Hairer and Wanner,
 * Solving Ordinary Differential Equations II, 2nd ed., section IV.2 (formula 2.43).
 */
#include "lag/methods/dop853.h"

#include <string.h>

#include "lag/linalg/arena.h"
#include "lag/linalg/order.h"
#include "lag/methods/attempts.h"

/* Stages whose states are of the fifth order, as places of the step. */
static const unsigned char PASSES[LAG_DOP853_SLOPES] = {[6] = 1, [9] = 2, [10] = 3};

static const double BETA = 0.04; /* weight of the error before, in the step control */
static const double GROW = 3.0; /* more would harm the dense output of the step that follows a transient */
static const double AFTER_TROUBLE = 0.25;

static lag_attempt_arrays place(const lag_stepper *s)
{
    const size_t size = s->ode->size;
    lag_attempt_arrays at; /* times are not set to zero, which takes its time */
    at.size = size;
    at.lanes = 1;
    at.x = s->x;
    at.tolerance = s->tolerance;
    at.slope = s->work;
    at.stage = at.slope + LAG_DOP853_SLOPES * size;
    at.x_new = at.stage + size;
    return at;
}

lag_attempt_arrays lag_dop853_last(const lag_stepper *s)
{
    lag_attempt_arrays at = place(s);
    at.x = s->x_before;
    at.t[0] = s->t_before;
    lag_fill(LAG_ATTEMPT_LANES, s->t - s->t_before, at.h);
    return at;
}

/* (7, size) */
static double *place_dense(const lag_stepper *s)
{
    return s->work + (LAG_DOP853_SLOPES + 2) * s->ode->size;
}

static size_t memory_of_dop853(const lag_ode *ode)
{
    return (LAG_DOP853_SLOPES + 2 + LAG_DOP853_TERMS) * ode->size;
}

/* ---- attempts ---- */

void lag_attempt_begin(lag_stepper *s, double limit)
{
    lag_attempt *attempt = &s->attempt;
    if (!attempt->begun || attempt->t != s->t || attempt->first != s->h || attempt->limit != limit) {
        attempt->begun = 1;
        attempt->made = attempt->dense = 0;
        attempt->rejections = attempt->evaluations = 0;
        attempt->t = s->t;
        attempt->first = attempt->next = s->h;
        attempt->limit = limit;
    }
    if (!attempt->made) {
        attempt->h = lag_stepper_length(s, attempt->next, limit);
        attempt->t_new = lag_stepper_end(s, attempt->h, limit);
    }
}

int lag_attempt_shorten(lag_stepper *s)
{
    lag_attempt *attempt = &s->attempt;
    const double part = isfinite(attempt->error) ? fmax(LAG_DOP853_SHRINK, LAG_DOP853_SAFETY * pow(attempt->error, -1.0 / 8.0)) : AFTER_TROUBLE;
    ++attempt->rejections;
    if (attempt->h <= s->h_least) {
        return 0;
    }
    attempt->next = fmax(attempt->h * part, s->h_least);
    attempt->made = 0;
    return 1;
}

static int rates_of_stage(void *context, size_t i, const double *t, const double *x, double *xd)
{
    lag_stepper *s = context;
    const int found = lag_stepper_rates(s, *t, x, xd) == LAG_OK;
    if (found && PASSES[i] > 0) {
        lag_stepper_pass(s, PASSES[i], *t);
    }
    return found;
}

static void try_alone(lag_stepper *s, lag_attempt_arrays *at)
{
    lag_attempt *attempt = &s->attempt;
    at->t[0] = s->t;
    lag_fill(LAG_ATTEMPT_LANES, attempt->h, at->h);
    memcpy(at->slope, s->f, at->size * sizeof(double));
    attempt->made = 1;
    attempt->bare = attempt->dense = 0;
    attempt->error = (double)INFINITY;
    if (lag_attempt_stages(at, rates_of_stage, s)) {
        lag_attempt_errors(at, &attempt->error);
    }
    if (attempt->error <= 1.0 && lag_stepper_rates(s, attempt->t_new, at->x_new, at->slope + LAG_DOP853_END * at->size) != LAG_OK) {
        attempt->error = (double)INFINITY;
    }
    if (attempt->error <= 1.0) {
        lag_attempt_urges(at, &attempt->urge);
    }
}

/* Factor for the next step after this error; `before`: the error of the last accepted step. */
static double factor_of(double error, double before)
{
    const double integral = pow(error, 1.0 / 8.0 - 0.2 * BETA);
    const double factor = LAG_DOP853_SAFETY / integral * pow(lag_higher(before, 1e-4), BETA);
    return lag_lower(GROW, lag_higher(LAG_DOP853_SHRINK, error > 0.0 ? factor : GROW));
}

/* The attempt becomes the step. */
static void accept(lag_stepper *s, const lag_attempt_arrays *at)
{
    const lag_attempt *attempt = &s->attempt;
    double *end_slope = at->slope + LAG_DOP853_END * at->size;
    const double h = attempt->h;
    const double proposed = lag_lower(attempt->next, s->h_most);
    const double factor = factor_of(attempt->error, s->last.error > 0.0 ? s->last.error : 1e-4);
    const double next = h * (attempt->rejections > 0 ? lag_lower(factor, 1.0) : factor);
    s->last.urge = attempt->urge;
    s->h = h < proposed && attempt->rejections == 0 ? lag_higher(next, proposed) : next;
    s->last.error = lag_higher(attempt->error, 1e-4);
    s->last.h = h;
    lag_stepper_pass(s, LAG_PASSED_END, attempt->t_new);
    lag_stepper_accept(s, attempt->t_new, at->x_new, end_slope);
}

static lag_status step_dop853(lag_stepper *s, double limit)
{
    lag_attempt *attempt = &s->attempt;
    lag_attempt_arrays at = place(s);
    int more = 1;
    do {
        lag_attempt_begin(s, limit);
        if (!attempt->made) {
            try_alone(s, &at);
        }
        more = attempt->error > 1.0 && lag_attempt_shorten(s);
    } while (more);
    attempt->begun = 0;
    s->counts.rejections += attempt->rejections;
    s->counts.evaluations += attempt->evaluations;
    if (attempt->error > 1.0) {
        s->h = attempt->next;
        return LAG_STEP_TOO_SMALL;
    }
    accept(s, &at);
    return LAG_OK;
}

static void begin_dop853(lag_stepper *s)
{
    (void)s;
}

static lag_status prepare_dense_dop853(lag_stepper *s)
{
    lag_attempt_arrays at = lag_dop853_last(s);
    if (s->attempt.dense) {
        s->counts.evaluations += LAG_DOP853_SLOPES - LAG_DOP853_END - 1;
        return LAG_OK;
    }
    if (s->attempt.bare) {
        memcpy(at.slope, s->f_before, at.size * sizeof(double));
        lag_fill(LAG_ATTEMPT_LANES, s->attempt.h, at.h);
        if (!lag_attempt_stages(&at, rates_of_stage, s)) {
            return s->trouble.status;
        }
        lag_fill(LAG_ATTEMPT_LANES, s->t - s->t_before, at.h);
    }
    for (size_t i = LAG_DOP853_END + 1; i < LAG_DOP853_SLOPES; ++i) {
        if (!lag_attempt_stage(&at, i, rates_of_stage, s)) {
            return s->trouble.status;
        }
    }
    lag_attempt_dense(&at, place_dense(s));
    return LAG_OK;
}

static void dense_dop853(const lag_stepper *s, double t, double *x)
{
    const double *terms = place_dense(s);
    const size_t size = s->ode->size;
    const double h = s->t - s->t_before;
    const double part = h > 0.0 ? (t - s->t_before) / h : 1.0;
    size_t i = 0;
#if defined(__GNUC__)
    for (; i + LAG_WIDTH <= size; i += LAG_WIDTH) {
        lag_wide sum = {0.0};
        for (size_t k = LAG_DOP853_TERMS; k-- > 0;) {
            sum = (sum + lag_wide_at(terms + k * size + i)) * (k % 2 == 0 ? part : 1.0 - part);
        }
        lag_wide_to(x + i, lag_wide_at(s->x_before + i) + sum);
    }
#endif
    for (; i < size; ++i) {
        double sum = 0.0;
        for (size_t k = LAG_DOP853_TERMS; k-- > 0;) {
            sum = (sum + terms[k * size + i]) * (k % 2 == 0 ? part : 1.0 - part);
        }
        x[i] = s->x_before[i] + sum;
    }
}

const lag_method lag_dop853 = {
    .name = "dop853",
    .order = 8,
    .highest_order = 8,
    .dense_order = 7,
    .implicit = 0,
    .factor = 1e-2,
    .error_order = 7,
    .memory = memory_of_dop853,
    .begin = begin_dop853,
    .step = step_dop853,
    .prepare_dense = prepare_dense_dop853,
    .dense = dense_dop853,
};
