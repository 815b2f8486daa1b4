#include "lag/session/lane.h"

#include <math.h>
#include <string.h>

#include "lag/linalg/arena.h"
#include "lag/linalg/finite.h"
#include "lag/linalg/vector.h"

/* Doubles of a lane beside those of the run: rows, sizes of constraints, start values and the start, flags of constraints. */
static size_t own_memory(const lag_model *model)
{
    return LAG_LANE_ROWS * lag_results_width(model) + 2 * model->nc + 2 * lag_motion_size(model);
}

size_t lag_lane_size(const lag_ensemble *ensemble)
{
    return lag_padded(own_memory(ensemble->model) * sizeof(double)) + lag_padded(lag_run_size(ensemble->model, ensemble->options));
}

void lag_lane_place(lag_lane *own, const lag_ensemble *ensemble, void *bytes)
{
    const lag_model *model = ensemble->model;
    double *memory = bytes;
    own->rows = lag_take(&memory, LAG_LANE_ROWS * lag_results_width(model));
    own->row_sizes = lag_take(&memory, model->nc);
    own->dependent = lag_take_flags(&memory, model->nc);
    own->starts = lag_take(&memory, lag_motion_size(model));
    own->x = lag_take(&memory, lag_motion_size(model));
    own->block = (char *)bytes + lag_padded(own_memory(model) * sizeof(double));
    own->run = NULL;
}

/* Keeps the rows at the times that are asked for; a later row of the same time takes the place of the one before. */
static lag_status keep(void *context, lag_results *results)
{
    lag_keeper *k = context;
    const lag_run_options *options = k->ensemble->options;
    const size_t own = lag_ensemble_width(k->ensemble->model);
    for (size_t i = 0; i < results->row; ++i) {
        const double *row = results->rows + i * k->width;
        const int again = k->next > 0 && options->times[k->next - 1] == row[0];
        while (k->next < options->count && options->times[k->next] < row[0]) {
            ++k->next;
        }
        if (k->next < options->count && options->times[k->next] == row[0]) {
            ++k->next;
            ++k->kept;
        } else if (!again) {
            continue;
        }
        lag_copy(own, row + 1, k->rows + (k->kept - 1) * own);
    }
    results->row = results->note = 0;
    return LAG_OK;
}

/* The start x of run i, from `starts`: the model's start values and those that are given. */
static lag_status find_start(const lag_ensemble *ensemble, size_t i, lag_run *run, double *starts, double *x, lag_initial *told)
{
    const lag_model *model = ensemble->model;
    const size_t size = lag_motion_size(model);
    lag_status status = lag_run_start(run, ensemble->t, starts);
    for (size_t k = 0; ensemble->set != NULL && k < size; ++k) {
        starts[k] = ensemble->set[k] ? ensemble->x[i * size + k] : starts[k];
    }
    memcpy(x, starts, size * sizeof(double));
    if (status != LAG_OK) {
        return status;
    }
    if (!lag_finite(size, x) || !lag_finite(model->nu, run->motion.u)) {
        return LAG_NOT_FINITE;
    }
    status = lag_run_find(run, ensemble->t, ensemble->set, x, told);
    if (ensemble->results.found != NULL && model->np > 0) {
        memcpy(ensemble->results.found + i * model->np, run->motion.at.p, model->np * sizeof(double));
    }
    return status == LAG_OK && told->fault != LAG_INITIAL_NONE ? LAG_PROJECTION_FAILED : status;
}

/* On to where the next step begins, in pieces; *ended: there is none. LAG_TOO_LONG: as many steps as allowed. */
static lag_status approach(const lag_ensemble *ensemble, lag_lane *own, int *ended)
{
    lag_run *run = own->run;
    lag_status status = LAG_OK;
    *ended = 0;
    while (status == LAG_OK && !(*ended || (own->goal > run->stepper.t && own->left > 0))) {
        if (own->goal > run->stepper.t) {
            const size_t left = ensemble->most_steps - own->steps;
            const size_t piece = own->steps > 0 ? ensemble->piece : ensemble->first_piece;
            own->left = left < piece ? left : piece;
            status = own->left > 0 ? lag_run_restart(run, own->goal) : LAG_TOO_LONG;
        } else if (own->breaks < ensemble->breaks) {
            ++own->breaks;
            own->goal = own->breaks < ensemble->breaks ? ensemble->at[own->breaks] : ensemble->stop;
            own->left = 0;
            status = lag_run_jump(run);
        } else {
            *ended = 1;
        }
    }
    return status;
}

lag_status lag_lane_begin(lag_lane *own, const lag_ensemble *ensemble, size_t i, int *ended)
{
    const lag_model *model = ensemble->model;
    const size_t size = lag_motion_size(model);
    own->number = i;
    *ended = 0;
    own->told = (lag_initial){.given = !ensemble->equations, .dependent = own->dependent, .row_sizes = own->row_sizes};
    lag_fill(model->nc, 1.0, own->row_sizes);
    memset(own->dependent, 0, model->nc);
    own->kept = (lag_keeper){
        .ensemble = ensemble, .width = lag_results_width(model),
        .rows = ensemble->results.rows + i * ensemble->options->count * lag_ensemble_width(model)
    };
    own->results = (lag_results){
        .most_rows = LAG_LANE_ROWS, .most_notes = LAG_LANE_NOTES, .rows = own->rows, .notes = own->notes, .full = keep, .context = &own->kept,
        .bare = 1
    };
    own->options = *ensemble->options;
    own->options.p = ensemble->p + i * model->np;
    own->options.u = ensemble->u == NULL ? NULL : ensemble->u + i * model->nu;
    own->options.sizes.natural = ensemble->natural + i * size;
    own->options.sizes.row_sizes = own->row_sizes;
    own->options.results = &own->results;
    own->run = lag_run_place(own->block, model, &own->options);
    own->steps = own->left = own->breaks = 0;
    own->goal = ensemble->breaks > 0 ? ensemble->at[0] : ensemble->stop;
    lag_status status = find_start(ensemble, i, own->run, own->starts, own->x, &own->told);
    own->started = status == LAG_OK;
    status = own->started ? lag_run_begin(own->run, ensemble->t, own->x) : status;
    return status == LAG_OK ? approach(ensemble, own, ended) : status;
}

lag_status lag_lane_step(lag_lane *own, const lag_ensemble *ensemble, int *ended)
{
    lag_status status = lag_run_step(own->run, own->goal);
    status = status == LAG_OK ? lag_run_finish(own->run, own->goal) : status;
    *ended = 0;
    ++own->steps;
    --own->left;
    return status == LAG_OK ? approach(ensemble, own, ended) : status;
}

void lag_lane_end(lag_lane *own, const lag_ensemble *ensemble, lag_status status)
{
    if (own->started && (status == LAG_OK || status == LAG_STOPPED)) {
        const lag_status last = lag_run_end(own->run);
        status = last == LAG_OK ? status : last;
    }
    (void)keep(&own->kept, &own->results);
    ensemble->results.kept[own->number] = own->kept.kept;
    ensemble->results.ended[own->number] = own->results.any ? own->results.last : (double)NAN;
    ensemble->results.status[own->number] = (int)status;
    if (ensemble->failed != NULL && status != LAG_OK && status != LAG_STOPPED) {
        const lag_initial *told = own->started ? NULL : &own->told;
        ensemble->failed(ensemble->context, own->number, own->run, (int)status, own->starts, own->x, told);
    }
    own->run = NULL;
}
