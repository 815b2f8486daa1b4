#include "lag/ensemble.h"

#include <math.h>
#include <string.h>

#include "lag/equations/discretes.h"
#include "lag/linalg/finite.h"
#include "lag/linalg/arena.h"

/* Rows and notes of a run before they are sorted. */
enum { ROWS = 16, NOTES = 64 };

/* The rows of one run that are kept. */
typedef struct keeper {
    const lag_ensemble *ensemble;
    size_t width, next, kept; /* numbers of a row of the run; place of the time that is waited for; rows so far */
    double *rows;             /* (count, lag_ensemble_width()) */
} keeper;

/* Memory of one thread. */
typedef struct bench {
    lag_run_options options;
    lag_results results;
    keeper kept;
    lag_note notes[NOTES];
} bench;

/* Doubles beside those of the run: rows, sizes of constraints, start values and the start, flags of constraints. */
static size_t own_memory(const lag_model *model)
{
    return ROWS * lag_results_width(model) + 2 * model->nc + 2 * lag_motion_size(model);
}

size_t lag_ensemble_width(const lag_model *model)
{
    return lag_motion_size(model) + lag_places_of(model).contact + model->ny;
}

size_t lag_ensemble_size(const lag_ensemble *ensemble)
{
    return lag_padded(sizeof(bench)) + lag_padded(own_memory(ensemble->model) * sizeof(double)) +
           lag_run_size(ensemble->model, ensemble->options);
}

/* Keeps the rows at the times that are asked for; a later row of the same time takes the place of the one before. */
static lag_status keep(void *context, lag_results *results)
{
    keeper *k = context;
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
        memcpy(k->rows + (k->kept - 1) * own, row + 1, own * sizeof(double));
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

static int is_stopped(const lag_ensemble *ensemble)
{
    return ensemble->stopped != NULL && atomic_load(ensemble->stopped);
}

/* On to `stop` in pieces. LAG_TOO_LONG: as many steps as allowed, or no more are wanted. */
static lag_status advance(const lag_ensemble *ensemble, lag_run *run, double stop, size_t *steps)
{
    lag_status status = LAG_TOO_LONG;
    while (status == LAG_TOO_LONG && *steps < ensemble->most_steps && !is_stopped(ensemble)) {
        const size_t left = ensemble->most_steps - *steps;
        const size_t piece = *steps > 0 ? ensemble->piece : ensemble->first_piece;
        status = lag_run_to(run, stop, left < piece ? left : piece);
        *steps += run->counts.steps;
    }
    return status;
}

/* From the start to the end, over the breaks. */
static lag_status move(const lag_ensemble *ensemble, lag_run *run, const double *x)
{
    size_t steps = 0;
    lag_status status = lag_run_begin(run, ensemble->t, x);
    for (size_t k = 0; status == LAG_OK && k < ensemble->breaks; ++k) {
        status = advance(ensemble, run, ensemble->at[k], &steps);
        if (status == LAG_OK) {
            status = lag_run_jump(run);
        }
    }
    if (status == LAG_OK) {
        status = advance(ensemble, run, ensemble->stop, &steps);
    }
    if (status == LAG_OK || status == LAG_STOPPED) {
        const lag_status end = lag_run_end(run);
        status = end == LAG_OK ? status : end;
    }
    return status;
}

static lag_status run_one(const lag_ensemble *ensemble, size_t i, bench *own, double *memory, void *block)
{
    const lag_model *model = ensemble->model;
    const size_t size = lag_motion_size(model);
    double *rows = lag_take(&memory, ROWS * lag_results_width(model));
    double *row_sizes = lag_take(&memory, model->nc);
    unsigned char *dependent = lag_take_flags(&memory, model->nc);
    double *starts = lag_take(&memory, size);
    double *x = lag_take(&memory, size);
    lag_initial told = {.given = !ensemble->equations, .dependent = dependent, .row_sizes = row_sizes};
    lag_fill(model->nc, 1.0, row_sizes);
    own->kept = (keeper){
        .ensemble = ensemble, .width = lag_results_width(model),
        .rows = ensemble->results.rows + i * ensemble->options->count * lag_ensemble_width(model)
    };
    own->results = (lag_results){
        .most_rows = ROWS, .most_notes = NOTES, .rows = rows, .notes = own->notes, .full = keep, .context = &own->kept
    };
    own->options = *ensemble->options;
    own->options.p = ensemble->p + i * model->np;
    own->options.u = ensemble->u == NULL ? NULL : ensemble->u + i * model->nu;
    own->options.sizes.natural = ensemble->natural + i * size;
    own->options.sizes.row_sizes = row_sizes;
    own->options.results = &own->results;
    lag_run *run = lag_run_place(block, model, &own->options);
    lag_status status = find_start(ensemble, i, run, starts, x, &told);
    const int started = status == LAG_OK;
    if (started) {
        status = move(ensemble, run, x);
    }
    (void)keep(&own->kept, &own->results);
    ensemble->results.kept[i] = own->kept.kept;
    ensemble->results.ended[i] = own->results.any ? own->results.last : (double)NAN;
    if (ensemble->failed != NULL && status != LAG_OK && status != LAG_STOPPED && !is_stopped(ensemble)) {
        ensemble->failed(ensemble->context, i, run, (int)status, starts, x, started ? NULL : &told);
    }
    return status;
}

size_t lag_ensemble_run(const lag_ensemble *ensemble, size_t first, size_t end, void *block)
{
    char *bytes = block;
    bench *own = block;
    double *memory = (double *)(void *)(bytes + lag_padded(sizeof(bench)));
    char *rest = bytes + lag_padded(sizeof(bench)) + lag_padded(own_memory(ensemble->model) * sizeof(double));
    for (size_t i = first; i < end; ++i) {
        const lag_status status = run_one(ensemble, i, own, memory, rest);
        if (is_stopped(ensemble)) {
            return i;
        }
        ensemble->results.status[i] = (int)status;
    }
    return end;
}
