/*
 * The stage equations of a Radau method, by simplified Newton iterations with the exact Jacobian: one real and some complex systems
 * of the size of the state.
 *
 * Where stiff directions turn along a step, as they do in mechanisms, iterations with a Jacobian that is constant converge for short
 * steps only (Lubich, Integration of stiff mechanical systems by Runge-Kutta methods, ZAMP 44 (1993) 1022). Then the Jacobian is
 * taken as quadratic in time, by that at the start of the step before, at its start and at its predicted end; the last is the one at
 * the start of the next step. Where a Jacobian takes more work than an iteration, the polynomial is continued for as long as that saves work.
 *
 * Source: see lag/methods/radau.h; section IV.8, formulas (8.4) to (8.11).
 */
#include <math.h>
#include <string.h>

#include "lag/methods/radau.h"

/* Errors of the stage equations, as a part of the tolerance. */
static const double NEWTON_TOLERANCE = 3e-3;
/* Below this contraction rate of Newton's method, the next step keeps the Jacobian. */
static const double GOOD_RATE = 1e-3;
/* Above this contraction rate, the next TURNING steps use a Jacobian that changes along them. */
static const double SLOW = 0.1;
enum { TURNING = 50 };

enum { STAGES = LAG_RADAU_STAGES, PAIRS = LAG_RADAU_PAIRS, MEMO = sizeof(lag_radau_memo) / sizeof(double) };

size_t lag_radau_memory(const lag_ode *ode)
{
    const size_t vectors = 2 + 5 * STAGES;
    const size_t sides = (2 + LAG_RADAU_KRYLOV + 3) * STAGES;
    lag_radau_memo memo;
    lag_radau_keep_band(&memo, ode);
    return lag_dop853.memory(ode) + MEMO + 5 * lag_radau_entries(ode) + (3 + 2 * PAIRS) * lag_radau_matrix(ode, &memo) +
        (1 + PAIRS) * lag_radau_pivots(ode) + vectors * ode->size + sides * lag_radau_size(ode);
}

lag_radau_memo *lag_radau_remembered(const lag_stepper *s)
{
    return (lag_radau_memo *)(void *)(s->work + lag_dop853.memory(s->ode));
}

lag_radau_places lag_radau_place(const lag_stepper *s)
{
    const size_t n = s->ode->size;
    const size_t entries = lag_radau_entries(s->ode);
    lag_radau_places at;
    at.memo = lag_radau_remembered(s);
    const size_t matrix = lag_radau_matrix(s->ode, at.memo);
    at.table = &lag_radau_tables[(size_t)at.memo->level];
    at.jacobian = (double *)(void *)at.memo + MEMO;
    at.middle = at.jacobian + entries;
    at.matrix = at.middle + entries;
    at.factors = at.matrix + (lag_radau_is_sparse(s->ode) ? 2 * matrix : 0);
    at.pivots = at.factors + (1 + 2 * PAIRS) * matrix;
    at.z = at.pivots + (1 + PAIRS) * lag_radau_pivots(s->ode);
    at.w = at.z + STAGES * n;
    at.slope = at.w + STAGES * n;
    at.dense = at.slope + STAGES * n;
    at.right = at.dense + STAGES * n;
    at.point = at.right + STAGES * n;
    at.error = at.point + n;
    at.sides = at.error + n;
    at.reduced = at.sides + STAGES * lag_radau_size(s->ode);
    at.change = at.reduced + STAGES * lag_radau_rows(s->ode);
    at.bend = at.change + entries;
    at.trend = at.bend + entries;
    at.basis = at.trend + entries;
    return at;
}

unsigned lag_radau_iterations(unsigned stages)
{
    return 7 + (stages - 3) * 5 / 2;
}

static lag_status take_jacobian(lag_stepper *s, const lag_radau_places *at, double t, const double *x, double *matrix)
{
    ++s->counts.jacobians;
    const lag_status status = lag_radau_jacobian(s->ode, t, x, matrix);
    at->memo->decomposed = at->memo->placed = 0.0;
    if (status != LAG_OK) {
        s->trouble.status = status;
        s->trouble.time = t;
        memcpy(s->trouble.x, x, s->ode->size * sizeof(double));
    }
    return status;
}

/* Its change along a step that ends about at its last stage z; none, where the system has no rates there: shorter steps may not get there. */
static void take_change(lag_stepper *s, const lag_radau_places *at, double h)
{
    const size_t n = s->ode->size;
    const double before = at->memo->before;
    for (size_t i = 0; i < n; ++i) {
        at->point[i] = s->x[i] + at->z[(at->table->stages - 1) * n + i];
    }
    const int known = take_jacobian(s, at, s->t + h, at->point, at->change) == LAG_OK;
    for (size_t i = 0; i < lag_radau_entries(s->ode); ++i) {
        at->change[i] = known ? at->change[i] - at->jacobian[i] : 0.0;
        at->bend[i] = before > 0.0 ? (at->change[i] - h * at->trend[i]) * (h / (h + before)) : 0.0;
    }
    at->memo->ahead = h;
    at->memo->served = 0.0;
    at->memo->spent = lag_radau_renewal(s);
}

/* The same along a part of that step. */
static void cut_change(size_t entries, const lag_radau_places *at, double part)
{
    for (size_t i = 0; i < entries; ++i) {
        at->change[i] = part * (at->change[i] + (part - 1.0) * at->bend[i]);
        at->bend[i] *= part * part;
    }
    at->memo->decomposed = at->memo->placed = 0.0;
    at->memo->ahead *= part;
}

/*
 * A Jacobian for the steps to come. It serves about as many as the one before did; half of them ahead, it is nearest to all of their states. No
 * state behind the end of this step is predicted. The Jacobian is that of the present state where nothing predicts another, where the system has no
 * rates there, and where it takes less work than an iteration.
 */
static lag_status renew_jacobian(lag_stepper *s, const lag_radau_places *at, double h)
{
    lag_radau_memo *memo = at->memo;
    const double work = lag_radau_renewal(s);
    const double part = memo->polynomial > 0.0 && memo->turning == 0.0 && work > 1.0 ? fmin(0.5 * memo->served, 1.0) : 0.0;
    lag_status status = LAG_SINGULAR;
    memo->served = 0.0;
    memo->spent = work;
    memo->fresh = memo->ahead = 0.0;
    if (part > 0.0) {
        s->method->dense(s, s->t + part * h, at->point);
        status = take_jacobian(s, at, s->t + part * h, at->point, at->jacobian);
    }
    if (status != LAG_OK) {
        status = take_jacobian(s, at, s->t, s->x, at->jacobian);
        memo->fresh = status == LAG_OK ? 1.0 : 0.0;
    }
    memo->usable = status == LAG_OK ? 1.0 : 0.0;
    return status;
}

/* The Jacobian at the end of a step, and the same polynomial, continued along a step of that length behind it. */
static void move_along(size_t entries, const lag_radau_places *at)
{
    for (size_t i = 0; i < entries; ++i) {
        at->jacobian[i] += at->change[i];
        at->trend[i] = at->change[i] / at->memo->ahead;
        at->change[i] += 2.0 * at->bend[i];
    }
    at->memo->before = at->memo->ahead;
    at->memo->decomposed = at->memo->placed = 0.0;
}

/* Prepares Jacobian and factors of Newton's method for a step of length h. */
static lag_status prepare(lag_stepper *s, const lag_radau_places *at, double h)
{
    lag_radau_memo *memo = at->memo;
    lag_status status = LAG_OK;
    if (memo->usable == 0.0) {
        status = renew_jacobian(s, at, h);
    }
    if (status == LAG_OK && memo->turning > 0.0 && memo->ahead == 0.0) {
        take_change(s, at, h);
    } else if (memo->turning > 0.0 && memo->ahead != h) {
        cut_change(lag_radau_entries(s->ode), at, h / memo->ahead);
        memo->ahead = h;
    }
    return status;
}

void lag_radau_transform(size_t n, size_t stages, const double matrix[STAGES][STAGES], const double *in, double *out)
{
    for (size_t k = 0; k < stages; ++k) {
        const double *row = matrix[k];
        for (size_t i = 0; i < n; ++i) {
            out[k * n + i] = row[0] * in[i] + row[1] * in[n + i] + row[2] * in[2 * n + i];
        }
        for (size_t j = 3; j < stages; j += 2) { /* there are 3, 5 or 7 */
            for (size_t i = 0; i < n; ++i) {
                out[k * n + i] = out[k * n + i] + row[j] * in[j * n + i] + row[j + 1] * in[(j + 1) * n + i];
            }
        }
    }
}

static lag_status stage_slopes(lag_stepper *s, const lag_radau_places *at, double h)
{
    const size_t n = s->ode->size;
    lag_status status = LAG_OK;
    for (size_t k = 0; k < at->table->stages && status == LAG_OK; ++k) {
        for (size_t i = 0; i < n; ++i) {
            at->point[i] = s->x[i] + at->z[k * n + i];
        }
        status = lag_stepper_rates(s, s->t + at->table->node[k] * h, at->point, at->slope + k * n);
    }
    return status;
}

/* The slopes of the stages become the residual of the stage equations, in the coordinates w. */
static void residual(size_t n, const lag_radau_places *at, double h)
{
    const lag_radau_table *table = at->table;
    lag_radau_transform(n, table->stages, table->inverse, at->slope, at->right);
    memcpy(at->slope, at->right, table->stages * n * sizeof(double));
    for (size_t i = 0; i < n; ++i) {
        at->slope[i] -= table->mu / h * at->w[i];
    }
    for (size_t pair = 0; 2 * pair + 1 < table->stages; ++pair) {
        const double alpha = table->alpha[pair] / h;
        const double beta = table->beta[pair] / h;
        double *a = at->slope + (2 * pair + 1) * n;
        const double *w = at->w + (2 * pair + 1) * n;
        for (size_t i = 0; i < n; ++i) {
            a[i] -= alpha * w[i] + beta * w[n + i];
            a[n + i] -= alpha * w[n + i] - beta * w[i];
        }
    }
}

double lag_radau_inner(const lag_stepper *s, size_t stages, size_t apart, const double *a, const double *b)
{
    const size_t n = s->ode->size;
    double sum = 0.0;
    for (size_t i = 0; i < n; ++i) {
        const double by = 1.0 / s->tolerance[i];
        for (size_t k = 0; k < stages; ++k) {
            sum += a[k * apart + i] * by * (b[k * apart + i] * by);
        }
    }
    return sum;
}

double lag_radau_correction(const lag_stepper *s, const lag_radau_places *at, double h, size_t *directions)
{
    const size_t n = s->ode->size;
    const size_t stages = at->table->stages;
    lag_radau_decomposed(s->ode, at, at->sides);
    if (at->memo->turning > 0.0) {
        *directions += lag_radau_gmres(s, at, h, at->sides);
    }
    return sqrt(lag_radau_inner(s, stages, lag_radau_size(s->ode), at->sides, at->sides) / (double)(n > 0 ? stages * n : 1));
}

/* The slopes of the stages become right sides of the systems. */
static void take_sides(const lag_stepper *s, const lag_radau_places *at, double h)
{
    residual(s->ode->size, at, h);
    lag_radau_take_sides(s->ode, at, at->table->stages, at->slope, at->sides);
    if (at->memo->turning > 0.0 && lag_radau_is_sparse(s->ode)) {
        lag_radau_change_sides(s->ode, at, at->slope, at->sides);
    }
}

void lag_radau_add(const lag_ode *ode, size_t stages, const double *sides, double *w)
{
    for (size_t k = 0; k < stages; ++k) {
        for (size_t i = 0; i < ode->size; ++i) {
            w[k * ode->size + i] += sides[k * lag_radau_size(ode) + i];
        }
    }
}

/*
 * Error of the first iterate as a part of its correction, by the rate of contraction that was seen last. The rate is at most the length of the step
 * times the error of the Jacobian in use. Along the step this error grows with the length where that Jacobian is constant, with its square where it
 * is linear in time, and with its cube where it is quadratic: in a longer step there is less to trust.
 */
static double first_trust(const lag_radau_memo *memo, double h)
{
    const double order = memo->turning == 0.0 ? 1.0 : memo->before == 0.0 ? 2.0 : 3.0;
    const double seen = pow(fmax(memo->trust, 1e-16), 0.8);
    return h > memo->trusted && memo->trusted > 0.0 ? seen * pow(h / memo->trusted, order + 1.0) : seen;
}

/*
 * Simplified Newton iterations from the stages z, formulas (8.10) and (8.11). The error estimate is linear in the stages: where it is larger than
 * the tolerance by more than the iterate is off, further iterations lead to a step that is rejected. That takes a rate that was seen before.
 */
static lag_radau_outcome iterate(lag_stepper *s, const lag_radau_places *at, double h, int decides)
{
    const size_t n = s->ode->size;
    const size_t stages = at->table->stages;
    const unsigned most = lag_radau_iterations(at->table->stages);
    lag_radau_outcome result = {.smooth = 1.0};
    double before = 0.0;
    double trust = first_trust(at->memo, h);
    lag_radau_transform(n, stages, at->table->inverse, at->z, at->w);
    for (unsigned k = 0; k < most; ++k) {
        result.iterations = k + 1;
        if (stage_slopes(s, at, h) != LAG_OK) {
            return result;
        }
        take_sides(s, at, h);
        const double size = lag_radau_correction(s, at, h, &s->counts.directions);
        const double rate = before > 0.0 ? size / before : 0.0;
        result.missed = k == 0 ? size : result.missed;
        const double remaining = pow(rate, (double)(most - k)) / (1.0 - rate) * size;
        if (!isfinite(size) || (before > 0.0 && (rate >= 1.0 || remaining > NEWTON_TOLERANCE))) {
            return result;
        }
        lag_radau_add(s->ode, stages, at->sides, at->w);
        lag_radau_transform(n, stages, at->table->transform, at->w, at->z);
        trust = before > 0.0 ? rate / (1.0 - rate) : trust;
        if (size == 0.0 || trust * size < NEWTON_TOLERANCE) {
            at->memo->trust = trust;
            at->memo->trusted = h;
            result.converged = 1;
            result.smooth = k > 1 ? sqrt(rate * result.rate) : rate;
            result.rate = rate;
            return result;
        }
        result.error = decides && at->memo->trusted > 0.0 ? lag_radau_error(s, at, h) : 0.0;
        if (result.error > 1.0 + trust * size) {
            result.rejected = 1;
            return result;
        }
        result.rate = rate;
        before = size;
    }
    return result;
}

lag_status lag_radau_solve(lag_stepper *s, const lag_radau_places *at, double h, int decides,
    void (*guess)(const lag_stepper *s, const lag_radau_places *at, double h), lag_radau_outcome *outcome)
{
    *outcome = (lag_radau_outcome){.smooth = 1.0};
    for (;;) {
        guess(s, at, h);
        const lag_status status = prepare(s, at, h);
        if (status != LAG_OK) {
            return status;
        }
        if (lag_radau_decompose(s, at, h) == LAG_OK) {
            *outcome = iterate(s, at, h, decides);
        }
        const int latest = at->memo->turning > 0.0 ? at->memo->served == 0.0 : at->memo->fresh != 0.0;
        if (outcome->converged || outcome->rejected || latest) {
            return LAG_OK;
        }
        at->memo->usable = at->memo->served = at->memo->before = 0.0;
    }
}

/*
 * True if the Jacobian serves the next step. It is replaced where that step, with one iteration more than this one, takes more work than the steps
 * since it was taken did each, its own work included: that keeps the work of a step least.
 */
static int serves(lag_radau_memo *memo, const lag_radau_outcome *outcome)
{
    const double iterations = (double)outcome->iterations;
    memo->served += 1.0;
    memo->spent += iterations;
    return outcome->rate <= GOOD_RATE || (iterations + 1.0) * memo->served < memo->spent;
}

void lag_radau_keep(const lag_stepper *s, const lag_radau_places *at, const lag_radau_outcome *outcome)
{
    lag_radau_memo *memo = at->memo;
    memo->fresh = 0.0;
    memo->before = 0.0;
    if (outcome->missed < 0.1 * NEWTON_TOLERANCE) { /* the first guess was as good as the solution: much longer steps can be solved */
        memo->wall = 0.0;
    }
    if (memo->turning > 0.0) {
        const int goes_on = serves(memo, outcome) && lag_radau_renewal(s) > 1.0;
        move_along(lag_radau_entries(s->ode), at);
        memo->turning -= 1.0;
        const int known = goes_on || memo->served == 1.0; /* else the polynomial was continued too far to tell the next one */
        memo->before = known ? memo->before : 0.0;
        memo->ahead = goes_on ? memo->ahead : 0.0;
        memo->usable = memo->turning > 0.0 && known ? 1.0 : 0.0;
    } else {
        memo->usable = serves(memo, outcome) ? 1.0 : 0.0;
        memo->turning = outcome->smooth > SLOW ? TURNING : 0.0;
        memo->usable = memo->turning > 0.0 ? 0.0 : memo->usable;
        memo->ahead = 0.0;
    }
}

void lag_radau_fail(const lag_radau_places *at, const lag_radau_outcome *outcome)
{
    lag_radau_memo *memo = at->memo;
    if (outcome->converged || outcome->rejected) {
        return;
    }
    memo->usable = memo->turning > 0.0 ? 0.0 : memo->usable; /* it was that of a state that was only predicted */
    memo->turning = TURNING;
    memo->ahead = memo->decomposed = 0.0;
}
