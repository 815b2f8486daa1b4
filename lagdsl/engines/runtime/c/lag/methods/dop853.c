/*
 * The explicit Runge-Kutta method of Dormand and Prince of order 8 with error estimates of orders 5 and 3 and dense output of
 * order 7, with PI step control (lag/methods/step_control.h).
 *
 * Source: Hairer, Norsett and Wanner, Solving Ordinary Differential Equations I, 2nd ed., sections II.5 (method, page 181),
 * II.6 (dense output), II.10 (error estimate); coefficients as in the authors' program DOP853.
 */
#include "lag/methods/dop853.h"

#include <string.h>

#include "lag/linalg/arena.h"
#include "lag/linalg/order.h"
#include "lag/methods/attempts.h"
#include "lag/methods/step_control.h"

/* Stages whose states are of the fifth order, as places of the step. */
static const unsigned char PASSES[LAG_DOP853_SLOPES] = {[6] = 1, [9] = 2, [10] = 3};

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
    const double part = isfinite(attempt->error) ? lag_higher(LAG_DOP853_SHRINK, lag_control_part(attempt->error)) : AFTER_TROUBLE;
    ++attempt->rejections;
    if (attempt->h <= s->h_least) {
        return 0;
    }
    attempt->next = lag_higher(attempt->h * part, s->h_least);
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

/* The attempt becomes the step. */
static void accept(lag_stepper *s, const lag_attempt_arrays *at)
{
    const lag_attempt *attempt = &s->attempt;
    double *end_slope = at->slope + LAG_DOP853_END * at->size;
    const double h = attempt->h;
    const double before = lag_control_before(s->last.error);
    s->last.urge = attempt->urge;
    s->h = lag_control_next(h, lag_lower(attempt->next, s->h_most), attempt->error, before, (double)attempt->rejections);
    s->last.error = lag_control_before(attempt->error);
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

void lag_dop853_inside(size_t size, size_t lanes, const double *terms, const double *before, double part, double *x)
{
    size_t i = 0;
#if defined(__GNUC__)
    for (; i + LAG_WIDTH <= size && lanes == 1; i += LAG_WIDTH) {
        lag_wide sum = {0.0};
        for (size_t k = LAG_DOP853_TERMS; k-- > 0;) {
            sum = (sum + lag_wide_at(terms + k * size + i)) * (k % 2 == 0 ? part : 1.0 - part);
        }
        lag_wide_to(x + i, lag_wide_at(before + i) + sum);
    }
#endif
    for (; i < size; ++i) {
        double sum = 0.0;
        for (size_t k = LAG_DOP853_TERMS; k-- > 0;) {
            sum = (sum + terms[(k * size + i) * lanes]) * (k % 2 == 0 ? part : 1.0 - part);
        }
        x[i] = before[i * lanes] + sum;
    }
}

static void dense_dop853(const lag_stepper *s, double t, double *x)
{
    const double h = s->t - s->t_before;
    lag_dop853_inside(s->ode->size, 1, place_dense(s), s->x_before, h > 0.0 ? (t - s->t_before) / h : 1.0, x);
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
