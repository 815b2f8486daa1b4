/* Rows of the columns: at the present, within the last step, at notices. */
#include <math.h>
#include <string.h>

#include "lag/linalg/arena.h"
#include "lag/run.h"
#include "lag/sensitivities/sensitivities.h"

/* All columns and their directions at time t, in columns.x, or in columns.inside; x is the state there. */
static lag_status columns_at(lag_sensitivities *s, lag_run *run, double t, const double *x, double **found)
{
    const size_t height = lag_columns_variables(run->motion.model) * s->columns.lanes;
    lag_status status = LAG_OK;
    *found = s->columns.x;
    if (t == s->columns.t) {
        return LAG_OK;
    }
    *found = s->columns.inside;
    memcpy(*found, s->columns.x, s->columns.blocks * height * sizeof(double));
    for (size_t block = 0; block < s->columns.blocks && status == LAG_OK; ++block) {
        status = lag_columns_dense(s, run, block, t, *found + block * height);
    }
    return status == LAG_OK ? lag_columns_project(s, run, t, x, *found) : status;
}

/* lag_sensitivities_width() */
static size_t width_of(const lag_sensitivities *s, const lag_model *model)
{
    return lag_motion_size(model) + s->discretes + model->ny;
}

lag_status lag_sensitivities_get(lag_sensitivities *s, lag_run *run, double t, const double *x, double *derivatives)
{
    const lag_model *model = run->motion.model;
    const size_t n = lag_motion_size(model);
    const size_t lanes = s->columns.lanes;
    const size_t width = width_of(s, model);
    double *found = NULL;
    lag_status status = columns_at(s, run, t, x, &found);
    if (status == LAG_OK && model->ny > 0) {
        status = lag_columns_set_state(s, run, t, x, 1);
    }
    for (size_t block = 0; block < s->columns.blocks && status == LAG_OK; ++block) {
        const size_t own = lag_columns_lanes(s, block);
        const double *point = found + block * lag_columns_variables(model) * lanes;
        const double *discretes = s->columns.w + block * model->nw * lanes;
        if (model->ny > 0) {
            status = lag_columns_rates(s, run, block, t, x, point, s->work.rates, s->work.y);
        }
        for (size_t lane = 0; lane < own && block * lanes + lane < s->of.count; ++lane) {
            double *to = derivatives + (block * lanes + lane) * width;
            lag_lane_get(own, lane, n, point, to);
            lag_lane_get(own, lane, s->discretes, discretes, to + n);
            lag_lane_get(own, lane, model->ny, s->work.y, to + n + s->discretes);
        }
    }
    return status;
}

lag_status lag_columns_row(lag_run *run, size_t number, double t, const double *x)
{
    lag_sensitivities *s = lag_sensitivities_of(run);
    const size_t entries = s->of.count * width_of(s, run->motion.model);
    return s->results.rows == NULL ? LAG_OK : lag_sensitivities_get(s, run, t, x, s->results.rows + number * entries);
}

void lag_columns_note(lag_companion *companion, size_t number)
{
    const lag_sensitivities *s = (const lag_sensitivities *)(const void *)companion;
    if (s->results.times == NULL) {
        return;
    }
    memcpy(s->results.times + number * s->of.count, s->instant.time, s->of.count * sizeof(double));
}

lag_status lag_columns_back(lag_run *run, double t)
{
    lag_sensitivities *s = lag_sensitivities_of(run);
    const size_t count = s->columns.blocks * lag_columns_variables(run->motion.model) * s->columns.lanes;
    double *found = NULL;
    if (t == s->columns.t) {
        return LAG_OK;
    }
    s->work.known.t = (double)NAN;
    const lag_status status = columns_at(s, run, t, run->stepper.x, &found);
    memcpy(s->columns.x, found, count * sizeof(double));
    s->columns.t = t;
    return status;
}
