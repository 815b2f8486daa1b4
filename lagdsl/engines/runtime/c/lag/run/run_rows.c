/* Rows of a run at requested times, and how far a step goes. */
#include <math.h>

#include "lag/run.h"

lag_status lag_run_inside(lag_run *run, double t, double *x)
{
    int moved = 0;
    const lag_status status = lag_stepper_dense(&run->stepper, t, x);
    if (status == LAG_OK && run->stepper.method == &lag_collocation) {
        lag_singular_project(&run->ranks.singular, t, x);
    } else if (status == LAG_OK) {
        (void)lag_projection_apply(&run->projection, t, x, &moved); /* where it cannot, the row is as the method found it */
    }
    return status;
}

double lag_run_limit(const lag_run *run, double stop)
{
    return fmin(stop, lag_instants_next(&run->instants));
}

int lag_run_looks_inside(const lag_run *run, double t)
{
    const lag_run_options *options = &run->options;
    return (run->counts.row < options->count && options->times[run->counts.row] < t) || lag_guards_count(&run->guards) > 0;
}

static lag_status record(lag_run *run, double t, const double *x)
{
    const size_t size = run->stepper.ode->size;
    if (run->options.rows != NULL) {
        for (size_t i = 0; i < size; ++i) {
            run->options.rows[run->counts.row * size + i] = x[i];
        }
    }
    ++run->counts.row;
    if (run->options.results != NULL) {
        const lag_status status = lag_results_at(run->options.results, run, t, x);
        if (status != LAG_OK) {
            return status;
        }
    }
    const lag_run_callbacks *callbacks = &run->options.callbacks;
    return callbacks->output != NULL ? callbacks->output(callbacks->context, run, t, x) : LAG_OK;
}

lag_status lag_run_rows(lag_run *run, double t, int up_to)
{
    const lag_run_options *options = &run->options;
    lag_status status = LAG_OK;
    while (status == LAG_OK && run->counts.row < options->count && options->times[run->counts.row] < t) {
        const double time = options->times[run->counts.row];
        status = lag_run_inside(run, time, run->point);
        if (status == LAG_OK && run->motion.model->na > 0) {
            status = lag_run_watch(run, time, run->point, NULL);
        }
        if (status == LAG_OK) {
            status = record(run, time, run->point);
        }
    }
    while (status == LAG_OK && up_to && run->counts.row < options->count && options->times[run->counts.row] == t) {
        status = record(run, t, run->stepper.x);
    }
    return status;
}
