/*
 * The stage equations of a Radau method, by simplified Newton iterations with the exact Jacobian: one real and some complex systems
 * of the size of the state.
 *
 * Source: see lag/radau.h; section IV.8, formulas (8.4) to (8.11).
 */
#include <math.h>
#include <string.h>

#include "lag/lu.h"
#include "lag/radau.h"

/* Errors of the stage equations, as a part of the tolerance. */
static const double NEWTON_TOLERANCE = 3e-3;

enum { STAGES = LAG_RADAU_STAGES, PAIRS = LAG_RADAU_PAIRS, MEMO = sizeof(lag_radau_memo) / sizeof(double) };

size_t lag_radau_memory(size_t size)
{
    return MEMO + (2 + 2 * PAIRS) * size * size + (3 + PAIRS + 5 * STAGES) * size;
}

lag_radau_places lag_radau_place(const lag_stepper *s)
{
    const size_t n = s->ode->size;
    lag_radau_places at;
    at.memo = (lag_radau_memo *)(void *)s->work;
    at.table = &lag_radau_tables[(size_t)at.memo->level];
    at.jacobian = s->work + MEMO;
    at.real = at.jacobian + n * n;
    at.complex = at.real + n * n;
    at.pivots = at.complex + 2 * PAIRS * n * n;
    at.z = at.pivots + (1 + PAIRS) * n;
    at.w = at.z + STAGES * n;
    at.slope = at.w + STAGES * n;
    at.dense = at.slope + STAGES * n;
    at.right = at.dense + STAGES * n;
    at.point = at.right + STAGES * n;
    at.error = at.point + n;
    return at;
}

unsigned lag_radau_iterations(unsigned stages)
{
    return 7 + (stages - 3) * 5 / 2;
}

static lag_status take_jacobian(lag_stepper *s, const lag_radau_places *at)
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

/* ((alpha - i beta)/h) I - J, decomposed. */
static int decompose_pair(size_t n, const lag_radau_places *at, size_t pair, double h)
{
    double *matrix = at->complex + 2 * n * n * pair;
    for (size_t i = 0; i < n * n; ++i) {
        matrix[2 * i] = -at->jacobian[i];
        matrix[2 * i + 1] = 0.0;
    }
    for (size_t i = 0; i < n; ++i) {
        matrix[2 * (i * n + i)] += at->table->alpha[pair] / h;
        matrix[2 * (i * n + i) + 1] -= at->table->beta[pair] / h;
    }
    return lag_lu_complex(n, matrix, at->pivots + (1 + pair) * n);
}

/* (mu/h) I - J and the matrices of the pairs. */
static lag_status decompose(lag_stepper *s, const lag_radau_places *at, double h)
{
    const size_t n = s->ode->size;
    if (at->memo->decomposed == h) {
        return LAG_OK;
    }
    ++s->decompositions;
    for (size_t i = 0; i < n * n; ++i) {
        at->real[i] = -at->jacobian[i];
    }
    for (size_t i = 0; i < n; ++i) {
        at->real[i * n + i] += at->table->mu / h;
    }
    int regular = lag_lu(n, at->real, at->pivots);
    for (size_t pair = 0; 2 * pair + 1 < at->table->stages && regular; ++pair) {
        regular = decompose_pair(n, at, pair, h);
    }
    at->memo->decomposed = regular ? h : 0.0;
    return regular ? LAG_OK : LAG_SINGULAR;
}

/* out = matrix in, for as many arrays of n numbers as there are stages. */
static void transform(size_t n, size_t stages, const double matrix[STAGES][STAGES], const double *in, double *out)
{
    for (size_t k = 0; k < stages; ++k) {
        for (size_t i = 0; i < n; ++i) {
            double sum = 0.0;
            for (size_t j = 0; j < stages; ++j) {
                sum += matrix[k][j] * in[j * n + i];
            }
            out[k * n + i] = sum;
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

/* The right-hand sides of a pair, in at->slope, become its corrections. */
static void correct_pair(size_t n, const lag_radau_places *at, size_t pair, double h)
{
    const double alpha = at->table->alpha[pair] / h;
    const double beta = at->table->beta[pair] / h;
    double *a = at->slope + (2 * pair + 1) * n;
    double *b = a + n;
    const double *w1 = at->w + (2 * pair + 1) * n;
    const double *w2 = w1 + n;
    for (size_t i = 0; i < n; ++i) {
        at->right[2 * i] = a[i] - (alpha * w1[i] + beta * w2[i]);
        at->right[2 * i + 1] = b[i] - (alpha * w2[i] - beta * w1[i]);
    }
    lag_lu_complex_solve(n, at->complex + 2 * n * n * pair, at->pivots + (1 + pair) * n, at->right);
    for (size_t i = 0; i < n; ++i) {
        a[i] = at->right[2 * i];
        b[i] = at->right[2 * i + 1];
    }
}

/* The slopes of the stages become one correction of w by Newton's method; its size as a part of the tolerances. */
static double correction(const lag_stepper *s, const lag_radau_places *at, double h)
{
    const size_t n = s->ode->size;
    const size_t stages = at->table->stages;
    double sum = 0.0;
    transform(n, stages, at->table->inverse, at->slope, at->right);
    memcpy(at->slope, at->right, stages * n * sizeof(double));
    for (size_t i = 0; i < n; ++i) {
        at->slope[i] -= at->table->mu / h * at->w[i];
    }
    lag_lu_solve(n, at->real, at->pivots, at->slope);
    for (size_t pair = 0; 2 * pair + 1 < stages; ++pair) {
        correct_pair(n, at, pair, h);
    }
    for (size_t i = 0; i < stages * n; ++i) {
        const double part = at->slope[i] / s->tolerance[i % n];
        sum += part * part;
    }
    return sqrt(sum / (double)(n > 0 ? stages * n : 1));
}

/* Simplified Newton iterations from the stages z, formulas (8.10) and (8.11). */
static lag_radau_outcome iterate(lag_stepper *s, const lag_radau_places *at, double h)
{
    const size_t n = s->ode->size;
    const size_t stages = at->table->stages;
    const unsigned most = lag_radau_iterations(at->table->stages);
    lag_radau_outcome result = {0, 0, 0.0, 1.0};
    double before = 0.0;
    double trust = pow(fmax(at->memo->trust, 1e-16), 0.8);
    transform(n, stages, at->table->inverse, at->z, at->w);
    for (unsigned k = 0; k < most; ++k) {
        result.iterations = k + 1;
        if (stage_slopes(s, at, h) != LAG_OK) {
            return result;
        }
        const double size = correction(s, at, h);
        const double rate = before > 0.0 ? size / before : 0.0;
        const double remaining = pow(rate, (double)(most - k)) / (1.0 - rate) * size;
        if (!isfinite(size) || (before > 0.0 && (rate >= 1.0 || remaining > NEWTON_TOLERANCE))) {
            return result;
        }
        for (size_t i = 0; i < stages * n; ++i) {
            at->w[i] += at->slope[i];
        }
        transform(n, stages, at->table->transform, at->w, at->z);
        trust = before > 0.0 ? rate / (1.0 - rate) : trust;
        if (size == 0.0 || trust * size < NEWTON_TOLERANCE) {
            at->memo->trust = trust;
            result.converged = 1;
            result.smooth = k > 1 ? sqrt(rate * result.rate) : rate;
            result.rate = rate;
            return result;
        }
        result.rate = rate;
        before = size;
    }
    return result;
}

lag_status lag_radau_solve(lag_stepper *s, const lag_radau_places *at, double h,
    void (*guess)(const lag_stepper *s, const lag_radau_places *at, double h), lag_radau_outcome *outcome)
{
    *outcome = (lag_radau_outcome){0, 0, 0.0, 1.0};
    for (;;) {
        if (at->memo->usable == 0.0) {
            const lag_status status = take_jacobian(s, at);
            if (status != LAG_OK) {
                return status;
            }
        }
        guess(s, at, h);
        if (decompose(s, at, h) == LAG_OK) {
            *outcome = iterate(s, at, h);
        }
        if (outcome->converged || at->memo->fresh != 0.0) {
            return LAG_OK;
        }
        at->memo->usable = 0.0;
    }
}
