#include "lag/run/extremes.h"

#include <math.h>

#include "lag/equations/motion.h"
#include "lag/linalg/arena.h"
#include "lag/run.h"
#include "lag/run/course.h"

/* A number turns around where it goes back by this part of its range. */
static const double TURNED = 0.05;

size_t lag_extremes_memory(const lag_model *model)
{
    const size_t size = lag_motion_size(model);
    return 2 * (size + lag_places_of(model).contact + model->ny) + (3 + LAG_SAMPLES + 1) * size + (LAG_SAMPLES + 2 + LAG_PASSED) * model->ny + LAG_PASSED;
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
    extremes->outputs = lag_take(&memory, (LAG_SAMPLES + 2) * model->ny);
    extremes->when = lag_take(&memory, LAG_PASSED);
    extremes->passed = memory;
    lag_fill(LAG_PASSED, (double)NAN, extremes->when);
    lag_fill(extremes->count, (double)INFINITY, extremes->low);
    lag_fill(extremes->count, -(double)INFINITY, extremes->high);
    lag_fill(3 * size, 0.0, extremes->turns);
    extremes->searched = 0;
}

void lag_extremes_include(lag_extremes *extremes, size_t i, double value)
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
        lag_extremes_include(extremes, i, values[i]);
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

/* True if the cubics show that some number exceeds its range so far. */
static int exceeds_range(const lag_extremes *extremes, const lag_stepper *s)
{
    const double h = s->t - s->t_before;
    for (size_t i = 0; i < extremes->size; ++i) {
        const double a = s->x_before[i];
        const double b = s->x[i];
        double up = 0.0;
        double down = 0.0;
        lag_bulge_find(a, h * s->f_before[i], b, h * s->f[i], &up, &down);
        if ((up > 0.0 && fmax(a, b) + (1.0 + LAG_DOUBT) * up > extremes->high[i]) ||
            (down > 0.0 && fmin(a, b) - (1.0 + LAG_DOUBT) * down < extremes->low[i])) {
            return 1;
        }
    }
    return 0;
}

/* The vertex of the parabola through three values at equal distances, if it lies between them. */
static void include_vertex(lag_extremes *extremes, size_t i, double a, double b, double c)
{
    const double bend = a - 2.0 * b + c;
    if (bend != 0.0 && fabs(a - c) <= 2.0 * fabs(bend)) {
        lag_extremes_include(extremes, i, b - 0.125 * (a - c) * (a - c) / bend);
    }
}

static lag_status include_samples(lag_extremes *extremes, lag_stepper *s, double t)
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
            include_vertex(extremes, i, x[(k - 1) * n + i], x[k * n + i], x[(k + 1) * n + i]);
        }
    }
    return LAG_OK;
}

lag_status lag_extremes_step(lag_extremes *extremes, lag_run *run, double t)
{
    lag_stepper *s = &run->stepper;
    const int whole = t == s->t;
    lag_status status = LAG_OK;
    if (t > s->t_before && exceeds_range(extremes, s)) {
        status = include_samples(extremes, s, t);
    }
    if (t > s->t_before && run->motion.model->ny > 0 && status == LAG_OK) {
        lag_extremes_outputs(extremes, run, t);
    }
    if (whole && status == LAG_OK) {
        for (size_t i = 0; i < extremes->size; ++i) {
            lag_extremes_include(extremes, i, s->x[i]);
        }
        count_turns(extremes, s->x);
    }
    return status;
}
