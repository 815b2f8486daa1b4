/* A motion beyond a singular position: polynomials that satisfy the equations at nodes behind it, and on the constraints all the way. */
#include <math.h>
#include <string.h>

#include "lag/linalg/arena.h"
#include "lag/linalg/finite.h"
#include "lag/linalg/svd.h"
#include "lag/linalg/vector.h"
#include "lag/run.h"

enum { NODES = LAG_COLLOCATION_NODES, HALVINGS = 12, ITERATIONS = 30, SEARCH = 8, DOUBLINGS = 64 };

/* The first node, as a part of the length: there the rows are as independent as CLEAR. */
static const double FIRST = 0.3;
static const double CLEAR = 0.05;
/* A crossing is at least so many distances long. */
static const double LEAST = 4.0;
/* Iterations end at this change, or where a change does not shrink any more that is round-off, magnified by the nearness of the position. */
static const double CONVERGED = 1e-11, SETTLED = 1e-7;
/* Defects, as parts of what moves: good enough at once, and good enough where they do not shrink any more, for round-off. */
static const double ACCURATE = 1e-9, USEFUL = 1e-8;
/* Rank is lost where the least singular value is below this. */
static const double FOUND = 1e-6;
/* Residuals there, as parts of the sizes of rows: of combinations that vanish, and more for others, in which the motion is off. */
static const double MEETING = 1e-12, KEPT = 1e-9;

double lag_collocation_node(size_t i)
{
    return FIRST + (1.0 - FIRST) * (double)i / (double)(NODES - 1);
}

/* Sums of Lagrange's polynomials. */
void lag_collocation_interpolate(size_t first, size_t width, const double *values, double *coefficients)
{
    lag_fill(NODES * width, 0.0, coefficients);
    for (size_t i = first; i < NODES; ++i) {
        double basis[NODES] = {1.0};
        for (size_t j = first; j < NODES; ++j) {
            for (size_t k = NODES; k-- > 0 && j != i;) {
                const double below = k > 0 ? basis[k - 1] : 0.0;
                basis[k] = (below - lag_collocation_node(j) * basis[k]) / (lag_collocation_node(i) - lag_collocation_node(j));
            }
        }
        for (size_t k = 0; k < NODES; ++k) {
            lag_axpy(width, basis[k], values + i * width, coefficients + k * width);
        }
    }
}

double lag_collocation_value(size_t width, const double *coefficients, double part)
{
    double value = 0.0;
    for (size_t k = NODES; k-- > 0;) {
        value = value * part + coefficients[k * width];
    }
    return value;
}

void lag_collocation_state(const lag_model *model, const double *coefficients, const double *start, double length, double part, double *x)
{
    const size_t n = model->nq;
    const size_t width = n + model->nz;
    for (size_t j = 0; j < width; ++j) {
        double once = 0.0;
        double twice = 0.0;
        for (size_t k = NODES; k-- > 0;) {
            once = once * part + coefficients[k * width + j] / (double)(k + 1);
            twice = twice * part + coefficients[k * width + j] / (double)((k + 1) * (k + 2));
        }
        x[n + j] = start[n + j] + length * part * once;
        if (j < n) {
            x[j] = start[j] + length * part * (start[n + j] + length * part * twice);
        }
    }
}

/* x' at x, nq + nz of its numbers behind the rates into `values`; *change: how much they change. */
static int rates_at(lag_singular *s, double t, const double *x, double *values, double *change)
{
    const lag_model *model = s->run->motion.model;
    const lag_ode *ode = &s->run->motion.ode;
    const double *found = s->rates + model->nq;
    ++s->run->stepper.counts.evaluations;
    if (ode->rates(ode->context, t, x, s->rates) != LAG_OK || !lag_finite(ode->size, s->rates)) {
        return 0;
    }
    for (size_t j = 0; j < model->nq + model->nz; ++j) {
        *change = fmax(*change, fabs(found[j] - values[j]) / (1.0 + fabs(found[j])));
        values[j] = found[j];
    }
    return 1;
}

/* The polynomials of this length, by fixed-point iteration. */
static int collocate(lag_singular *s, double t, const double *x, double length)
{
    const lag_model *model = s->run->motion.model;
    const size_t width = model->nq + model->nz;
    double change = (double)INFINITY;
    int moved = 0;
    lag_fill(NODES * width, 0.0, s->values);
    lag_fill(NODES * width, 0.0, s->coefficients);
    if (!rates_at(s, t, x, s->coefficients, &change)) {
        return 0;
    }
    for (int k = 0; k < ITERATIONS; ++k) {
        const double previous = change;
        change = 0.0;
        for (size_t i = 0; i < NODES; ++i) {
            const double part = lag_collocation_node(i);
            lag_collocation_state(model, s->coefficients, x, length, part, s->state);
            if (lag_projection_exact(&s->run->projection, t + length * part, s->state, &moved) != LAG_OK ||
                !rates_at(s, t + length * part, s->state, s->values + i * width, &change)) {
                return 0;
            }
        }
        lag_collocation_interpolate(0, width, s->values, s->coefficients);
        if (change <= CONVERGED || (change <= SETTLED && change > 0.5 * previous)) {
            return 1;
        }
    }
    return 0;
}

/*
 * Defect: by how much the polynomials miss the equations between the position and the first node, where they are extrapolated. Over the length it
 * is a part of the scales of the state at the end, as those of a start from rest are zero.
 */
static double defect(lag_singular *s, double t, const double *x, double distance, double length)
{
    lag_run *run = s->run;
    const lag_model *model = run->motion.model;
    const size_t width = model->nq + model->nz;
    const double part = 0.5 * (FIRST + fmax(distance / length, 0.5 * FIRST));
    lag_accuracy behind = run->accuracy;
    behind.largest = memcpy(s->largest, run->accuracy.largest, behind.size * sizeof(double));
    double most = 0.0;
    int moved = 0;
    lag_collocation_state(model, s->coefficients, x, length, part, s->state);
    if (lag_projection_exact(&run->projection, t + length * part, s->state, &moved) != LAG_OK ||
        !rates_at(s, t + length * part, s->state, s->values, &(double){0.0})) {
        return (double)INFINITY;
    }
    lag_collocation_state(model, s->coefficients, x, length, 1.0, s->state);
    lag_accuracy_after(&behind, s->state, s->rates);
    for (size_t j = 0; j < width; ++j) {
        const double value = lag_collocation_value(width, s->coefficients + j, part);
        most = fmax(most, length * fabs(value - s->values[j]) * behind.relative / s->rates[model->nq + j]);
    }
    return most;
}

/*
 * Newton's method for the time at which the least singular value passes zero along the polynomials. 1 if branches meet there: in combinations
 * of rows that vanish the constraints hold.
 */
static int meets(lag_singular *s, double t, const double *x, double distance, double length)
{
    const lag_model *model = s->run->motion.model;
    const double ahead = 1e-3 * length;
    double time = distance;
    for (int k = 0; k < SEARCH && fabs(time - distance) <= length; ++k) {
        lag_collocation_state(model, s->coefficients, x, length, time / length, s->state);
        const size_t rows = lag_singular_rows(s, t + time, s->state);
        const lag_svd svd = lag_svd_of(model->nq, rows, s->rows, s->memory);
        const double least = svd.k > 0 ? svd.value[svd.k - 1] : 0.0;
        if (least <= FOUND) {
            size_t i = 0;
            while (i < svd.k && fabs(lag_dot(rows, svd.v + i * rows, s->phi)) <= MEETING + KEPT * svd.value[i]) {
                ++i;
            }
            return i > 0 && i == svd.k;
        }
        double there = 0.0;
        lag_collocation_state(model, s->coefficients, x, length, (time + ahead) / length, s->state);
        (void)lag_singular_rows(s, t + time + ahead, s->state);
        for (size_t j = 0; j < model->nq; ++j) {
            there += svd.u[(svd.k - 1) * model->nq + j] * lag_dot(rows, svd.v + (svd.k - 1) * rows, s->rows + j * rows);
        }
        time -= ahead * least / (there - least);
    }
    return 0;
}

/* The time, more than twice the distance, in which rates and accelerations lead to where rows are independent; infinite where they do not. */
static double time_to_clear(lag_singular *s, double t, const double *x, double distance)
{
    const size_t n = s->run->motion.model->nq;
    double time = fmax(2.0 * distance, s->run->stepper.h_least);
    memcpy(s->state, x, s->run->stepper.ode->size * sizeof(double));
    if (!rates_at(s, t, x, s->values, &(double){0.0})) {
        return (double)INFINITY;
    }
    for (int k = 0; k < DOUBLINGS; ++k, time *= 2.0) {
        for (size_t j = 0; j < n; ++j) {
            s->state[j] = x[j] + time * (x[n + j] + 0.5 * time * s->rates[n + j]);
        }
        if (lag_singular_margin(s, t + time, s->state) >= CLEAR) {
            return time;
        }
    }
    return (double)INFINITY;
}

double lag_collocation_fit(lag_singular *s, double t, const double *x, double distance)
{
    double length = time_to_clear(s, t, x, distance) / FIRST;
    double before = (double)INFINITY;
    for (int k = 0; k < HALVINGS && length < (double)INFINITY && length >= LEAST * distance; ++k, length *= 0.5) {
        const double error = collocate(s, t, x, length) ? defect(s, t, x, distance, length) : (double)INFINITY;
        if (error <= USEFUL && (error <= ACCURATE || error >= before) && meets(s, t, x, distance, length)) {
            return length;
        }
        before = error;
    }
    return 0.0;
}

/* ---- as a step that was done, and may be undone: in the work of a stepper nq, the length, then coefficients ---- */

static void begin_fit(lag_stepper *s)
{
    (void)s;
}

static void dense_fit(const lag_stepper *s, double t, double *x)
{
    const size_t n = (size_t)s->work[0];
    const lag_model sizes = {.nq = n, .nz = s->ode->size - 2 * n};
    lag_collocation_state(&sizes, s->work + 2, s->x_before, s->work[1], (t - s->t_before) / s->work[1], x);
}

const lag_method lag_collocation = {
    .name = "collocation", .order = NODES, .highest_order = NODES, .dense_order = NODES, .factor = 1.0, .begin = begin_fit, .dense = dense_fit};
