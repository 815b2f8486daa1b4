#include "lag/run/results.h"

#include <math.h>
#include <string.h>

#include "lag/equations/motion.h"
#include "lag/linalg/arena.h"
#include "lag/linalg/vector.h"
#include "lag/run.h"

/* Of a row with so many discretes. */
static size_t width_of(const lag_model *model, size_t variables)
{
    return 1 + lag_motion_size(model) + variables + model->ny + 3;
}

size_t lag_results_width(const lag_model *model)
{
    return width_of(model, lag_places_of(model).contact);
}

static double largest(size_t count, const double *x)
{
    double most = 0.0;
    for (size_t i = 0; i < count; ++i) {
        most = fmax(most, fabs(x[i]));
    }
    return most;
}

/* Largest residuals of position and velocity level; the motion looks at the state. */
static void find_residuals(lag_run *run, double *residual)
{
    const lag_model *model = run->motion.model;
    double *phi = run->projection.phi;
    residual[0] = residual[1] = 0.0;
    if (model->nc > 0) {
        const lag_status positions = lag_projection_evaluate(&run->projection, 0);
        residual[0] = positions == LAG_OK ? largest(model->nc, phi) : (double)NAN;
        const lag_status velocities = lag_projection_evaluate(&run->projection, 1);
        residual[1] = velocities == LAG_OK ? largest(model->nc, phi) : (double)NAN;
    }
}

void lag_run_solve(lag_run *run, double t, const double *x, int after_event)
{
    if (lag_run_crosses(run->motion.model, &run->options) && run->sizes.found) { /* before a start is known nothing tells ranks */
        lag_singular_row(&run->ranks.singular, t, x, after_event);
    } else {
        lag_motion_try(&run->motion, t, x);
    }
}

/* Outputs and, where rows are not `bare`, energy and residuals at x. Without accelerations those outputs are no numbers that read them. */
static void observe(lag_run *run, double t, const double *x, int after_event, int bare, double *values)
{
    lag_motion *motion = &run->motion;
    const lag_model *model = motion->model;
    double *energy = values + model->ny;
    double parts[3];
    if (model->ny > 0) {
        lag_run_solve(run, t, x, after_event);
        if (model->output(&motion->at, values) != LAG_OK) {
            lag_fill(model->ny, (double)NAN, values);
        }
    } else {
        lag_motion_set_state(motion, t, x);
    }
    if (bare) {
        return;
    }
    if (model->energies == NULL || model->energies(&motion->at, energy, parts, parts + 1, parts + 2) != LAG_OK) {
        *energy = (double)NAN;
    }
    find_residuals(run, energy + 1);
}

static lag_status empty_when_full(lag_results *results)
{
    if (results->row < results->most_rows && results->note < results->most_notes) {
        return LAG_OK;
    }
    const lag_status status = results->full(results->context, results);
    results->row = results->note = 0;
    return status;
}

lag_status lag_results_row(lag_results *results, lag_run *run, double t, const double *x)
{
    const lag_model *model = run->motion.model;
    const size_t size = lag_motion_size(model);
    const size_t variables = run->motion.places.contact;
    const lag_status status = empty_when_full(results);
    double *row = results->rows + results->row * width_of(model, variables);
    if (status != LAG_OK) {
        return status;
    }
    row[0] = t;
    lag_copy(size, x, row + 1);
    lag_copy(variables, run->motion.w, row + 1 + size);
    (void)lag_run_count_turns(run, t, x); /* where it cannot, outputs are as the model has them */
    observe(run, t, x, results->any && results->after == t, results->bare, row + 1 + size + variables);
    lag_run_unwind(run, row + 1 + size + variables);
    if (results->extremes != NULL) {
        lag_extremes_row(results->extremes, row + 1);
    }
    const size_t number = results->row++;
    results->any = 1;
    results->last = t;
    return results->companion != NULL ? results->companion->row(run, number, t, x) : LAG_OK;
}

lag_status lag_results_step(lag_results *results, lag_run *run, double t)
{
    return results->extremes == NULL ? LAG_OK : lag_extremes_step(results->extremes, run, t);
}

static int is_there(const lag_results *results, double t)
{
    return results->any && results->last == t;
}

lag_status lag_results_at(lag_results *results, lag_run *run, double t, const double *x)
{
    return is_there(results, t) ? LAG_OK : lag_results_row(results, run, t, x);
}

lag_status lag_results_end(lag_results *results, lag_run *run, double t, const double *x)
{
    const int told = is_there(results, t) && results->after == t;
    return results->any && !told ? lag_results_row(results, run, t, x) : LAG_OK;
}

static lag_status note(lag_results *results, const lag_event_notice *notice)
{
    const lag_status status = empty_when_full(results);
    if (status != LAG_OK) {
        return status;
    }
    if (results->companion != NULL) {
        results->companion->note(results->companion, results->note);
    }
    results->notes[results->note++] = (lag_note){notice->t, notice->what, notice->which};
    return LAG_OK;
}

lag_status lag_results_record_event(lag_results *results, lag_run *run, const lag_event_notice *notice)
{
    const double t = notice->t;
    lag_status status = LAG_OK;
    switch (notice->what) {
    case LAG_BEFORE:
        status = lag_results_at(results, run, t, notice->x);
        while (run->counts.row < run->options.count && run->options.times[run->counts.row] <= t) {
            ++run->counts.row;
        }
        return status;
    case LAG_AFTER:
        results->after = t;
        if (results->companion != NULL) {
            results->companion->after(results->companion);
        }
        return lag_results_row(results, run, t, notice->x);
    default:
        return note(results, notice);
    }
}
