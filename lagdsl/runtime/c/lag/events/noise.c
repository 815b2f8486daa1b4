#include "lag/events/noise.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "lag/linalg/arena.h"

/* Relative change of the numbers: so many roundings of each are round-off. A larger one could lead across a jump that is near. */
static const double CHANGE = 16.0 * DBL_EPSILON;

static size_t count_of(const lag_model *model)
{
    return model->nindicator + model->ncorner;
}

size_t lag_noise_memory(const lag_model *model)
{
    return count_of(model) > 0 ? 2 * lag_motion_size(model) + 4 * count_of(model) : 0;
}

void lag_noise_place(lag_noise *noise, lag_motion *motion, double *memory)
{
    const lag_model *model = motion->model;
    const size_t size = count_of(model) > 0 ? lag_motion_size(model) : 0;
    noise->motion = motion;
    noise->peak = lag_take(&memory, size);
    noise->point = lag_take(&memory, size);
    noise->value = lag_take(&memory, count_of(model));
    noise->other = lag_take(&memory, count_of(model));
    noise->opposite = lag_take(&memory, count_of(model));
    noise->sigma = memory;
    memset(noise->peak, 0, size * sizeof(double));
    memset(noise->sigma, 0, count_of(model) * sizeof(double));
}

void lag_noise_follow(lag_noise *noise, const double *x)
{
    const lag_model *model = noise->motion->model;
    const size_t size = count_of(model) > 0 ? lag_motion_size(model) : 0;
    for (size_t i = 0; i < size; ++i) {
        const double magnitude = fabs(x[i]);
        noise->peak[i] = magnitude > noise->peak[i] ? magnitude : noise->peak[i];
    }
}

/* Bit k of the number of an entry tells its sign in change k. */
static int same_sign(size_t entry, unsigned k)
{
    return ((entry >> k) & 1u) == 0;
}

/* Indicators, then distances of corners, with accelerations and multipliers of x at time t. */
static lag_status evaluate(lag_motion *motion, double t, const double *x, double *values)
{
    const lag_model *model = motion->model;
    double solved = 0.0;
    lag_status status = lag_motion_solve(motion, t, x);
    if (status == LAG_OK && model->nindicator > 0) {
        status = model->indicator(&motion->at, values);
    }
    return status == LAG_OK && model->ncorner > 0 ? model->corner(&motion->at, values + model->nindicator, &solved) : status;
}

/* The same after change k, or after the opposite one (`sign` -1), into `values`. */
static lag_status change(lag_noise *noise, double t, const double *x, unsigned k, double sign, double *values)
{
    lag_motion *motion = noise->motion;
    const lag_model *model = motion->model;
    for (size_t i = 0; i < lag_motion_size(model); ++i) {
        const double by = sign * CHANGE * noise->peak[i];
        noise->point[i] = same_sign(i, k) ? x[i] + by : x[i] - by;
    }
    return evaluate(motion, t - sign * CHANGE * fabs(t), noise->point, values);
}

void lag_noise_find(lag_noise *noise, double t, const double *x)
{
    const lag_model *model = noise->motion->model;
    unsigned changes = 1;
    lag_noise_follow(noise, x);
    if (evaluate(noise->motion, t, x, noise->value) != LAG_OK) {
        return;
    }
    for (size_t i = 0; i < count_of(model); ++i) {
        noise->sigma[i] = DBL_MIN;
    }
    while (changes < 32 && (lag_motion_size(model) >> changes) > 0) {
        ++changes;
    }
    for (unsigned k = 0; k < changes; ++k) {
        if (change(noise, t, x, k, 1.0, noise->other) != LAG_OK || change(noise, t, x, k, -1.0, noise->opposite) != LAG_OK) {
            continue;
        }
        for (size_t i = 0; i < count_of(model); ++i) { /* a jump that is near lies on one side */
            const double by = fmin(fabs(noise->other[i] - noise->value[i]), fabs(noise->opposite[i] - noise->value[i]));
            noise->sigma[i] = by > noise->sigma[i] && isfinite(by) ? by : noise->sigma[i];
        }
    }
}
