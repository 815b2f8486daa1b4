/* Rows of the columns: at the present, within the last step, at notices. */
#include <math.h>
#include <string.h>

#include "lag/linalg/arena.h"
#include "lag/run.h"
#include "lag/sensitivities/sensitivities.h"

/* The columns of the block at time t into `point`, whose directions of inputs and parameters are set. */
static lag_status columns_at(lag_sensitivities *s, lag_run *run, size_t block, double t, const double *x, double *point)
{
    const lag_model *model = run->motion.model;
    const size_t height = lag_columns_variables(model) * s->columns.lanes;
    memcpy(point, s->columns.x + block * height, height * sizeof(double));
    if (t == s->columns.t) {
        return LAG_OK;
    }
    const lag_status status = lag_columns_dense(s, run, block, t, point);
    return status == LAG_OK ? lag_columns_project(s, run, block, t, x, point) : status;
}

lag_status lag_sensitivities_get(lag_sensitivities *s, lag_run *run, double t, const double *x, double *derivatives)
{
    const lag_model *model = run->motion.model;
    const size_t n = lag_motion_size(model);
    const size_t lanes = s->columns.lanes;
    const size_t variables = lag_places_of(model).contact;
    const size_t width = lag_sensitivities_width(model);
    lag_status status = LAG_OK;
    for (size_t block = 0; block < s->columns.blocks && status == LAG_OK; ++block) {
        status = columns_at(s, run, block, t, x, s->work.point);
        if (status == LAG_OK && model->ny > 0 && block == 0) {
            status = lag_columns_look(s, run, t, x, 1);
        }
        if (status == LAG_OK && model->ny > 0) {
            status = lag_columns_rates(s, run, block, t, x, s->work.point, s->work.rates, s->work.y);
        }
        for (size_t lane = 0; lane < lanes && block * lanes + lane < s->of.count; ++lane) {
            double *to = derivatives + (block * lanes + lane) * width;
            lag_columns_get(s, lane, n, s->work.point, n, to);
            lag_columns_get(s, block * lanes + lane, variables, s->columns.w, model->nw, to + n);
            lag_columns_get(s, lane, model->ny, s->work.y, model->ny, to + n + variables);
        }
    }
    return status;
}

lag_status lag_columns_row(lag_run *run, size_t number, double t, const double *x)
{
    lag_sensitivities *s = lag_sensitivities_of(run);
    const size_t entries = s->of.count * lag_sensitivities_width(run->motion.model);
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
    const size_t height = lag_columns_variables(run->motion.model) * s->columns.lanes;
    lag_status status = LAG_OK;
    if (t == s->columns.t) {
        return LAG_OK;
    }
    s->work.known.t = (double)NAN;
    for (size_t block = 0; block < s->columns.blocks && status == LAG_OK; ++block) {
        status = columns_at(s, run, block, t, run->stepper.x, s->work.point);
        memcpy(s->columns.x + block * height, s->work.point, height * sizeof(double));
    }
    s->columns.t = t;
    return status;
}
