/* States within the last step: rows of a run at requested times, the past of what is delayed; how far a step goes. */
#include <math.h>

#include "lag/linalg/order.h"
#include "lag/run.h"

/* Pieces of the past are at least this part of a step: there may be a corner that nobody told. */
static const double LEAST = 1e-6;

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
    const double known = run->stepper.t + lag_delays_shortest(&run->motion.delays); /* delayed values are those of steps that are over */
    return lag_lower(lag_lower(stop, known), lag_instants_next(&run->instants));
}

int lag_run_reads_inside(const lag_run *run, double t)
{
    return lag_run_next_row(run) < t || lag_guards_count(&run->guards) > 0;
}

double lag_run_next_row(const lag_run *run)
{
    return run->counts.row < run->options.count ? run->options.times[run->counts.row] : (double)INFINITY;
}

lag_status lag_run_row(lag_run *run, double t, const double *x)
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
    lag_status status = LAG_OK;
    while (status == LAG_OK && lag_run_next_row(run) < t) {
        const double time = lag_run_next_row(run);
        status = lag_run_inside(run, time, run->point);
        if (status == LAG_OK && run->motion.model->na > 0) {
            status = lag_run_watch(run, time, run->point, NULL);
        }
        if (status == LAG_OK) {
            status = lag_run_row(run, time, run->point);
        }
    }
    while (status == LAG_OK && up_to && lag_run_next_row(run) == t) {
        status = lag_run_row(run, t, run->stepper.x);
    }
    return status;
}

/* ---- the past ---- */

/* The delayed expressions at time t, into `values` (ndelay). */
static lag_status sample_row(lag_run *run, double t, double *values)
{
    const lag_stepper *s = &run->stepper;
    const lag_status status = lag_stepper_dense(&run->stepper, fmin(fmax(t, s->t_before), s->t), run->point);
    if (status != LAG_OK) {
        return status;
    }
    lag_motion_set_state(&run->motion, t, run->point);
    return lag_delays_evaluate(&run->motion.delays, values);
}

lag_status lag_run_keep_past(lag_run *run, double t)
{
    lag_delay_pieces *pieces = &run->motion.delays.pieces;
    lag_status status = LAG_OK;
    if (pieces->count == 0) {
        return LAG_OK;
    }
    lag_delays_cut(&run->motion.delays, run->stepper.t_before);
    double h = t - lag_delay_end(pieces);
    const double least = LEAST * h;
    while (status == LAG_OK && lag_delay_end(pieces) < t) {
        const double a = lag_delay_end(pieces);
        const double b = a + h * (1.0 + LEAST) < t ? a + h : t;
        const double half = 0.5 * (b - a);
        for (size_t j = 0; j < LAG_DELAY_SAMPLES && status == LAG_OK; ++j) {
            status = sample_row(run, j == 0 ? b : a + half * (1.0 + lag_delay_places[j]), pieces->sample + j * pieces->n);
        }
        if (status == LAG_OK && lag_delay_try(pieces, run->accuracy.relative, b) > 1.0 && half > least && a + half > a) {
            h = half;
        } else if (status == LAG_OK) {
            status = lag_delay_add(pieces);
            h *= 2.0;
        }
    }
    if (status == LAG_OK && lag_run_companion(run) != NULL) {
        status = lag_run_companion(run)->past(run, t);
    }
    (void)lag_delays_next(&run->motion.delays); /* up to where it reads on this side of a jump */
    return status;
}
