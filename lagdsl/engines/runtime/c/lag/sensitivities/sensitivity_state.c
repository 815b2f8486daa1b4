/* Columns between two calls: their row, directions of inputs that callers change, and all of them as bytes. */
#include <math.h>
#include <string.h>

#include "lag/linalg/record.h"
#include "lag/run.h"
#include "lag/sensitivities/sensitivities.h"

lag_status lag_sensitivities_row(lag_run *run, double *row)
{
    return lag_sensitivities_get(lag_sensitivities_of(run), run, run->stepper.t, run->stepper.x, row);
}

void lag_sensitivities_inputs(lag_sensitivities *s, const lag_model *model, const double *u)
{
    for (size_t k = 0; k < s->of.count; ++k) {
        lag_columns_put(s, k, lag_motion_size(model), model->nu, u + k * model->nu, s->columns.x, lag_columns_variables(model));
    }
    s->columns.shifted = 1;
    s->work.motion.product.by_input.width = model->nu;
    s->work.known.t = (double)NAN;
}

/* All that is remembered between two calls: the rest is found anew. */
static void record_columns(lag_sensitivities *s, const lag_model *model, lag_record *record)
{
    lag_columns *columns = &s->columns;
    const size_t all = columns->lanes * columns->blocks;
    lag_record_doubles(record, all * lag_columns_variables(model), columns->x);
    lag_record_doubles(record, all * model->nw, columns->w);
    lag_record_doubles(record, all * lag_motion_size(model), columns->before);
    lag_record_doubles(record, all, columns->extent);
    lag_record_doubles(record, 1, &columns->t);
    lag_record_doubles(record, 1, &columns->t_before);
    lag_record_doubles(record, 1, &columns->rejected);
    lag_record_doubles(record, model->np, s->scales);
    lag_record_doubles(record, s->of.count * model->ncontact, s->instant.until);
    lag_record_bytes(record, &s->fault, sizeof s->fault);
    if (model->ndelay > 0) {
        lag_delay_pieces *pieces = &s->past.pieces;
        lag_record_doubles(record, lag_columns_past_memory(model, s->of.count), s->past.moved); /* the first of its arrays */
        lag_record_bytes(record, &pieces->first, sizeof pieces->first);
        lag_record_bytes(record, &pieces->count, sizeof pieces->count);
        lag_record_bytes(record, &pieces->level, sizeof pieces->level);
        lag_record_bytes(record, &s->past.happened, sizeof s->past.happened);
    }
}

size_t lag_sensitivities_saved_size(const lag_sensitivities *s, const lag_model *model)
{
    lag_record record = {NULL, NULL, 0};
    record_columns((lag_sensitivities *)s, model, &record); /* which counts only */
    return record.count;
}

void lag_sensitivities_save(const lag_sensitivities *s, const lag_model *model, unsigned char *bytes)
{
    lag_record record = {bytes, NULL, 0};
    record_columns((lag_sensitivities *)s, model, &record); /* which writes to the bytes only */
}

void lag_sensitivities_load(lag_sensitivities *s, const lag_model *model, const unsigned char *bytes)
{
    lag_record record = {NULL, bytes, 0};
    record_columns(s, model, &record);
    s->columns.t_dense = (double)NAN;
    s->instant.pending = 0;
    lag_columns_follow_parameters(s, model);
}
