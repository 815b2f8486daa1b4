#include "lag/run/extremes.h"

#include <math.h>

#include "lag/equations/discretes.h"
#include "lag/linalg/arena.h"
#include "lag/run.h"

/* A number turns around where it goes back by this part of its range. */
static const double TURNED = 0.05;
/*
 * The cubic through both ends of a step and their slopes is off by this part of its own bulge at most, about: beyond what was seen
 * so far by less, a step is not worth its dense output. (Of an oscillation, with a step of three radians.)
 */
static const double DOUBT = 0.7;

size_t lag_extremes_memory(const lag_model *model)
{
    const size_t size = lag_motion_size(model);
    return 2 * (size + lag_places_of(model).contact + model->ny) + (3 + LAG_SAMPLES + 1) * size + model->ny;
}

void lag_extremes_place(lag_extremes *extremes, const lag_model *model, double *memory)
{
    const size_t size = lag_motion_size(model);
    extremes->size = size;
    extremes->count = size + lag_places_of(model).contact + model->ny;
    extremes->low = lag_take(&memory, extremes->count);
    extremes->high = lag_take(&memory, extremes->count);
    extremes->turns = lag_take(&memory, size);
    extremes->pivot = lag_take(&memory, size);
    extremes->way = lag_take(&memory, size);
    extremes->sample = lag_take(&memory, (LAG_SAMPLES + 1) * size);
    extremes->outputs = memory;
    lag_fill(extremes->count, (double)INFINITY, extremes->low);
    lag_fill(extremes->count, -(double)INFINITY, extremes->high);
    lag_fill(3 * size, 0.0, extremes->turns);
}

static void see(lag_extremes *extremes, size_t i, double value)
{
    if (value < extremes->low[i]) {
        extremes->low[i] = value;
    }
    if (value > extremes->high[i]) {
        extremes->high[i] = value;
    }
}

void lag_extremes_row(lag_extremes *extremes, const double *values)
{
    for (size_t i = 0; i < extremes->count; ++i) {
        see(extremes, i, values[i]);
    }
}

void lag_extremes_outputs(lag_extremes *extremes, size_t ny, const double *outputs)
{
    for (size_t i = 0; i < ny; ++i) {
        see(extremes, extremes->count - ny + i, outputs[i]);
    }
}

/* Counts where numbers turn around, from one state to the next. */
static void count_turns(lag_extremes *extremes, const double *x)
{
    for (size_t i = 0; i < extremes->size; ++i) {
        const double back = TURNED * (extremes->high[i] - extremes->low[i]);
        double *pivot = extremes->pivot + i;
        double *way = extremes->way + i;
        if (*way == 0.0) {
            *way = x[i] > extremes->low[i] ? 1.0 : -1.0;
            *pivot = x[i];
        } else if (*way * (x[i] - *pivot) >= 0.0) {
            *pivot = x[i];
        } else if (*way * (*pivot - x[i]) > back) {
            *way = -*way;
            *pivot = x[i];
            extremes->turns[i] += 1.0;
        }
    }
}

/* Distances by which the cubic with values a, b and slopes fa, fb (of the whole step) exceeds its ends: up and down. */
static void find_bulge(double a, double fa, double b, double fb, double *up, double *down)
{
    const double change = b - a;
    const double most = 3.0 * fabs(change);
    *up = *down = 0.0;
    if (fa * change > 0.0 && fb * change > 0.0 && fabs(fa) < most && fabs(fb) < most) {
        return; /* Fritsch and Carlson, SIAM J. Numer. Anal. 17 (1980) 238: it is monotone */
    }
    const double linear = 3.0 * change - 2.0 * fa - fb; /* the derivative is fa + 2 linear s + square s^2 */
    const double square = 3.0 * (fa + fb - 2.0 * change);
    const double root = linear * linear - fa * square;
    if (root < 0.0) {
        return;
    }
    const double sum = -(linear + (linear < 0.0 ? -sqrt(root) : sqrt(root)));
    const double places[2] = {sum != 0.0 ? fa / sum : -1.0, square != 0.0 ? sum / square : -1.0};
    for (int k = 0; k < 2; ++k) {
        const double s = places[k];
        if (s > 0.0 && s < 1.0) {
            const double value = a + s * (fa + s * (linear + s * square / 3.0));
            *up = fmax(*up, value - fmax(a, b));
            *down = fmax(*down, fmin(a, b) - value);
        }
    }
}

/* True if the cubics show that some number exceeds its range so far. */
static int gets_beyond(const lag_extremes *extremes, const lag_stepper *s)
{
    const double h = s->t - s->t_before;
    for (size_t i = 0; i < extremes->size; ++i) {
        const double a = s->x_before[i];
        const double b = s->x[i];
        double up = 0.0;
        double down = 0.0;
        find_bulge(a, h * s->f_before[i], b, h * s->f[i], &up, &down);
        if ((up > 0.0 && fmax(a, b) + (1.0 + DOUBT) * up > extremes->high[i]) ||
            (down > 0.0 && fmin(a, b) - (1.0 + DOUBT) * down < extremes->low[i])) {
            return 1;
        }
    }
    return 0;
}

/* The vertex of the parabola through three values at equal distances, if it lies between them. */
static void see_vertex(lag_extremes *extremes, size_t i, double a, double b, double c)
{
    const double bend = a - 2.0 * b + c;
    if (bend != 0.0 && fabs(a - c) <= 2.0 * fabs(bend)) {
        see(extremes, i, b - 0.125 * (a - c) * (a - c) / bend);
    }
}

static lag_status look_inside(lag_extremes *extremes, lag_stepper *s, double t)
{
    const size_t n = extremes->size;
    double *x = extremes->sample;
    for (size_t k = 0; k <= LAG_SAMPLES; ++k) {
        const lag_status status = lag_stepper_dense(s, s->t_before + (t - s->t_before) * (double)k / LAG_SAMPLES, x + k * n);
        if (status != LAG_OK) {
            return status;
        }
    }
    for (size_t i = 0; i < n; ++i) {
        for (size_t k = 1; k < LAG_SAMPLES; ++k) {
            see_vertex(extremes, i, x[(k - 1) * n + i], x[k * n + i], x[(k + 1) * n + i]);
        }
    }
    return LAG_OK;
}

lag_status lag_extremes_step(lag_extremes *extremes, lag_run *run, double t)
{
    lag_stepper *s = &run->stepper;
    const int whole = t == s->t;
    lag_status status = LAG_OK;
    if (t > s->t_before && gets_beyond(extremes, s)) {
        status = look_inside(extremes, s, t);
    }
    if (whole && status == LAG_OK) {
        for (size_t i = 0; i < extremes->size; ++i) {
            see(extremes, i, s->x[i]);
        }
        count_turns(extremes, s->x);
    }
    return status;
}
