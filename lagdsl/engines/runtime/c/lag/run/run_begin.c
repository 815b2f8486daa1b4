/* A run begins, at the start values of its model or at a state that is given; what may happen to it; its end. */
#include <math.h>
#include <string.h>

#include "lag/equations/entries.h"
#include "lag/initial.h"
#include "lag/run.h"

/* Natural sizes, from the options or from the state x. */
static lag_status find_sizes(lag_run *run, double t, const double *x)
{
    const lag_model *model = run->motion.model;
    const lag_run_options *options = &run->options;
    const size_t size = lag_motion_size(model);
    lag_status status = LAG_OK;
    if (options->sizes.group == NULL) {
        lag_accuracy_groups(model, x, run->sizes.group, run->sizes.natural, run->sizes.cap);
    } else {
        memcpy(run->sizes.group, options->sizes.group, size * sizeof(double));
        memcpy(run->sizes.natural, options->sizes.natural, size * sizeof(double));
        memcpy(run->sizes.cap, options->sizes.cap, size * sizeof(double));
    }
    if (model->nc > 0 && options->sizes.row_sizes == NULL) {
        lag_motion_set_state(&run->motion, t, x);
        status = lag_projection_evaluate(&run->projection, 1);
    }
    for (size_t i = 0; i < model->nc; ++i) {
        double sum = 0.0;
        const lag_entries entries = lag_entries_of(model, i);
        for (size_t k = entries.first; k < entries.end; ++k) {
            const size_t j = lag_entry_column(&entries, k);
            const double entry = run->projection.jacobian[i * model->nq + j] * run->sizes.natural[j];
            sum += entry * entry;
        }
        run->sizes.rows[i] = options->sizes.row_sizes != NULL ? options->sizes.row_sizes[i] : sum > 0.0 ? sqrt(sum) : 1.0;
    }
    memcpy(run->projection.sizes, run->sizes.natural, model->nq * sizeof(double));
    lag_projection_limits(&run->projection, options->part * options->tolerance, run->sizes.rows);
    run->sizes.found = 1;
    return status;
}

/* Parameters and inputs, once; the start values of the model into run->point. */
static lag_status prepare(lag_run *run, double t)
{
    const lag_model *model = run->motion.model;
    lag_status status = LAG_OK;
    if (run->motion.at.p == NULL) {
        status = lag_motion_parameters(&run->motion, run->options.p != NULL ? run->options.p : model->defaults);
        if (status == LAG_OK) {
            status = lag_motion_start(&run->motion, t, run->point);
        }
        if (run->options.u != NULL) {
            memcpy(run->motion.u, run->options.u, model->nu * sizeof(double));
        }
    }
    return status;
}

lag_status lag_run_start(lag_run *run, double t, double *x)
{
    const lag_status status = prepare(run, t);
    memcpy(x, run->point, lag_motion_size(run->motion.model) * sizeof(double));
    return status;
}

lag_status lag_run_find(lag_run *run, double t, const unsigned char *set, double *x, lag_initial *told)
{
    told->p = told->p != NULL ? told->p : run->block.p;
    const lag_status status = lag_initial_find(&run->motion, run->options.start, set, t, x, run->block.initial, told);
    if (told->dependent != NULL) {
        lag_run_depend(run, told->dependent);
    }
    return status;
}

lag_status lag_run_move(lag_run *run, double t, const double *x, double h)
{
    const lag_model *model = run->motion.model;
    lag_stepper *s = &run->stepper;
    lag_status status = prepare(run, t);
    memcpy(s->x, x != NULL ? x : run->point, lag_motion_size(model) * sizeof(double));
    s->t = s->t_before = run->counts.entered = t;
    s->h = h;
    run->half.open = 0;
    run->half.left = 0.0;
    run->ranks.estimate.rank = 0;
    return status == LAG_OK && !run->sizes.found ? find_sizes(run, t, s->x) : status;
}

/* From the start values of the model to a state that is one. */
static lag_status find_start(lag_run *run, double t)
{
    lag_initial told = {.dependent = run->ranks.dependent};
    int moved = 0;
    if (run->options.start == NULL) {
        return lag_projection_apply(&run->projection, t, run->stepper.x, &moved);
    }
    return lag_run_find(run, t, NULL, run->stepper.x, &told);
}

lag_status lag_run_begin(lag_run *run, double t, const double *x)
{
    lag_stepper *s = &run->stepper;
    lag_turns_clear(&run->turns);
    lag_status status = lag_run_move(run, t, x, run->options.h_first);
    if (status == LAG_OK && x == NULL) {
        status = find_start(run, t);
    }
    while (lag_run_next_row(run) < t) {
        ++run->counts.row;
    }
    run->counts.begun = t;
    if (status == LAG_OK) {
        status = lag_run_enter(run);
    }
    const int stopped = status == LAG_STOPPED;
    status = stopped ? LAG_OK : status;
    if (status == LAG_OK) {
        status = lag_stepper_rates(s, t, s->x, s->f);
    }
    if (status == LAG_OK) {
        status = lag_run_watch(run, t, s->x, s->f);
    }
    if (status == LAG_OK) {
        status = lag_run_rows(run, t, 1);
    }
    return status == LAG_OK && stopped ? LAG_STOPPED : status;
}

/* ---- what may happen ---- */

lag_status lag_run_instant(lag_run *run, const lag_cause *cause)
{
    lag_companion *companion = lag_run_companion(run);
    if (cause->kind == LAG_CAUSE_TIME && cause->changed == NULL && !lag_run_due(run, run->stepper.t)) {
        return LAG_OK;
    }
    return companion != NULL ? companion->instant(run, cause) : lag_run_carry(run, cause);
}

lag_status lag_run_enter(lag_run *run)
{
    return lag_run_instant(run, &(lag_cause){LAG_CAUSE_START, 0.0, NULL});
}

lag_status lag_run_ticks(lag_run *run)
{
    return lag_run_instant(run, &(lag_cause){LAG_CAUSE_TIME, 0.0, NULL});
}

lag_status lag_run_jump(lag_run *run)
{
    return lag_run_instant(run, &(lag_cause){LAG_CAUSE_INPUTS, 0.0, NULL});
}

lag_status lag_run_over(lag_run *run, const double *stops, size_t count, size_t most_steps, size_t *passed)
{
    size_t steps = 0;
    lag_status status = LAG_OK;
    while (status == LAG_OK && *passed < count) {
        status = lag_run_to(run, stops[*passed], most_steps);
        steps += run->counts.steps;
        status = status == LAG_OK ? lag_run_jump(run) : status;
        *passed += status == LAG_OK;
        status = status == LAG_OK && most_steps > 0 && steps >= most_steps ? LAG_TOO_LONG : status;
    }
    run->counts.steps = steps;
    return status;
}

lag_status lag_run_end(lag_run *run)
{
    run->motion.until = (double)INFINITY;
    const lag_status status = lag_run_ticks(run);
    return status == LAG_OK ? lag_run_instant(run, &(lag_cause){LAG_CAUSE_END, 0.0, NULL}) : status;
}
