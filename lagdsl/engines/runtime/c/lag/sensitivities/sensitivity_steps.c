/* Columns along one step, stage by stage with the method of the state: DOP853, and Radau by its collocation equations, which are linear in them. */
#include <math.h>
#include <string.h>

#include "lag/linalg/arena.h"
#include "lag/run.h"
#include "lag/sensitivities/sensitivities.h"

static size_t size_of(const lag_run *run)
{
    return run->stepper.ode->size;
}

/* Arrays of a block, for the sums of DOP853. */
static lag_attempt_arrays arrays_of(const lag_sensitivities *s, const lag_run *run, size_t block)
{
    const lag_stepper *stepper = &run->stepper;
    const size_t count = size_of(run) * s->columns.lanes;
    lag_attempt_arrays at;
    at.size = size_of(run);
    at.lanes = s->columns.lanes;
    at.x = s->columns.before + block * count;
    at.tolerance = s->work.tolerance;
    at.slope = s->work.slopes + block * LAG_DOP853_SLOPES * count;
    at.stage = s->work.point;
    at.x_new = s->columns.x + block * lag_columns_variables(run->motion.model) * s->columns.lanes;
    lag_fill(LAG_ATTEMPT_LANES, stepper->t - stepper->t_before, at.h);
    lag_fill(LAG_ATTEMPT_LANES, stepper->t_before, at.t);
    return at;
}

/* Directions of inputs and parameters of the block, behind the columns in work.point. */
static void set_point(const lag_sensitivities *s, const lag_run *run, size_t block)
{
    const size_t count = size_of(run) * s->columns.lanes;
    const size_t height = lag_columns_variables(run->motion.model) * s->columns.lanes;
    memcpy(s->work.point + count, s->columns.x + block * height + count, (height - count) * sizeof(double));
}

/* Rates of all blocks at stage i, 0 being the beginning and LAG_DOP853_END the end. */
static lag_status explicit_stage(lag_sensitivities *s, lag_run *run, const lag_attempt_arrays *of_state, size_t i)
{
    const lag_combination *stage = &lag_dop853_stages[i];
    const double t = of_state->t[0] + (i > 0 ? stage->node * of_state->h[0] : 0.0);
    lag_status status = LAG_OK;
    memcpy(s->work.state_of_stage, of_state->x, of_state->size * sizeof(double));
    if (i > 0) {
        lag_combine(of_state->size, stage, of_state->h, of_state->slope, of_state->x, s->work.state_of_stage);
    }
    status = lag_columns_look(s, run, t, s->work.state_of_stage, 0);
    for (size_t block = 0; block < s->columns.blocks && status == LAG_OK; ++block) {
        const lag_attempt_arrays at = arrays_of(s, run, block);
        const size_t count = at.size * at.lanes;
        memcpy(at.stage, at.x, count * sizeof(double));
        if (i > 0) {
            lag_combine(count, stage, at.h, at.slope, at.x, at.stage);
        }
        if (i == LAG_DOP853_END) {
            memcpy(at.x_new, at.stage, count * sizeof(double));
        }
        set_point(s, run, block);
        status = lag_columns_rates(s, run, block, t, s->work.state_of_stage, s->work.point, at.slope + i * count, NULL);
    }
    return status;
}

/*
 * Sizes that errors of a block are measured by: tolerances of the state for a change of order one of what it is differentiated by, and as parts of the size
 * of each column.
 */
static void set_tolerances(const lag_sensitivities *s, const lag_run *run, size_t block, const lag_attempt_arrays *at)
{
    const double *tolerance = run->stepper.tolerance;
    for (size_t lane = 0; lane < at->lanes; ++lane) {
        double before = 0.0;
        double behind = 0.0;
        for (size_t i = 0; i < at->size; ++i) {
            const double a = at->x[i * at->lanes + lane] / tolerance[i];
            const double b = at->x_new[i * at->lanes + lane] / tolerance[i];
            before += a * a;
            behind += b * b;
        }
        const double length = fmax(s->columns.extent[block * at->lanes + lane], run->accuracy.relative * sqrt(fmax(before, behind) / (double)at->size));
        for (size_t i = 0; i < at->size; ++i) {
            s->work.tolerance[i * at->lanes + lane] = length > 0.0 ? length * tolerance[i] : 1.0;
        }
    }
}

static double largest_error(lag_sensitivities *s, lag_run *run)
{
    double most = 0.0;
    for (size_t block = 0; block < s->columns.blocks; ++block) {
        const lag_attempt_arrays at = arrays_of(s, run, block);
        double error[LAG_ATTEMPT_LANES];
        set_tolerances(s, run, block, &at);
        lag_attempt_errors(&at, error);
        for (size_t lane = 0; lane < at.lanes; ++lane) {
            most = fmax(most, error[lane]);
        }
    }
    return most;
}

/* One step with DOP853; the error of the worst column as a part of what it may be. */
static lag_status explicit_step(lag_sensitivities *s, lag_run *run, double *error)
{
    const lag_attempt_arrays of_state = lag_dop853_last(&run->stepper);
    lag_status status = LAG_OK;
    for (size_t i = 0; i <= LAG_DOP853_END && status == LAG_OK; ++i) {
        status = explicit_stage(s, run, &of_state, i);
    }
    *error = status == LAG_OK ? largest_error(s, run) : 0.0;
    return status;
}

/* ---- Radau ---- */

/* The Jacobian at stage i of the state, and the slopes there along the columns where the step begins and what is not the state. */
static lag_status implicit_stage(lag_sensitivities *s, lag_run *run, const lag_radau_places *of_state, size_t i)
{
    const lag_stepper *stepper = &run->stepper;
    const size_t n = size_of(run);
    const double t = stepper->t_before + of_state->table->node[i] * (stepper->t - stepper->t_before);
    double *jacobian = s->work.collocation.jacobian + i * lag_radau_entries(stepper->ode);
    for (size_t j = 0; j < n; ++j) {
        s->work.state_of_stage[j] = stepper->x_before[j] + of_state->z[i * n + j];
    }
    lag_status status = lag_radau_jacobian(stepper->ode, t, s->work.state_of_stage, jacobian);
    status = status == LAG_OK ? lag_columns_look(s, run, t, s->work.state_of_stage, 0) : status;
    for (size_t block = 0; block < s->columns.blocks && status == LAG_OK; ++block) {
        const lag_attempt_arrays at = arrays_of(s, run, block);
        memcpy(s->work.point, at.x, n * at.lanes * sizeof(double));
        set_point(s, run, block);
        status = lag_columns_rates(s, run, block, t, s->work.state_of_stage, s->work.point, at.slope + i * n * at.lanes, NULL);
    }
    return status;
}

/* The systems that were decomposed for the last step of the state, whatever has been chosen for the next one. */
static lag_radau_places last_of_state(const lag_stepper *stepper, lag_radau_memo *memo)
{
    lag_radau_places at = lag_radau_place(stepper);
    *memo = *at.memo;
    memo->decomposed = stepper->t - stepper->t_before;
    memo->turning = memo->before; /* the step was solved with a Jacobian that changes */
    at.memo = memo;
    at.table = &lag_radau_tables[((size_t)memo->polynomial - 3) / 2];
    return at;
}

/* One step by the collocation equations of the last one. LAG_MISSING: they were not solved; they will be for a shorter step. */
static lag_status implicit_step(lag_sensitivities *s, lag_run *run)
{
    lag_radau_memo memo;
    const lag_radau_places of_state = last_of_state(&run->stepper, &memo);
    const size_t n = size_of(run);
    const size_t rows = of_state.table->stages * n;
    double *z = s->work.collocation.z;
    lag_status status = LAG_OK;
    for (size_t i = 0; i < of_state.table->stages && status == LAG_OK; ++i) {
        status = implicit_stage(s, run, &of_state, i);
    }
    for (size_t k = 0; k < s->of.count && status == LAG_OK; ++k) {
        const size_t lane = k % s->columns.lanes;
        const lag_attempt_arrays at = arrays_of(s, run, k / s->columns.lanes);
        for (size_t i = 0; i < rows; ++i) {
            s->work.collocation.slope[i] = at.slope[i * at.lanes + lane];
        }
        status = lag_columns_collocate(&run->stepper, &of_state, &s->work.collocation) ? LAG_OK : LAG_MISSING;
        for (size_t i = 0; i < rows; ++i) {
            at.slope[i * at.lanes + lane] = z[i];
        }
        for (size_t i = 0; i < n; ++i) {
            at.x_new[i * at.lanes + lane] = at.x[i * at.lanes + lane] + z[rows - n + i];
        }
    }
    return status;
}

/* Value at a part of the step of the polynomial through zero and the stages z. */
static void implicit_dense(const lag_sensitivities *s, const lag_run *run, size_t block, double part, double *to)
{
    const lag_radau_places of_state = lag_radau_place(&run->stepper);
    const lag_radau_table *table = &lag_radau_tables[((size_t)of_state.memo->polynomial - 3) / 2];
    const lag_attempt_arrays at = arrays_of(s, run, block);
    const size_t count = at.size * at.lanes;
    memcpy(to, at.x, count * sizeof(double));
    for (size_t k = 0; k < table->stages; ++k) {
        double weight = part / table->node[k];
        for (size_t j = 0; j < table->stages; ++j) {
            weight *= j != k ? (part - table->node[j]) / (table->node[k] - table->node[j]) : 1.0;
        }
        for (size_t i = 0; i < count; ++i) {
            to[i] += weight * at.slope[k * count + i];
        }
    }
}

/* ---- all ---- */

/* Columns where the step begins, wherever those that were found last stand; 1: another step was tried from there. */
static int return_to_beginning(lag_sensitivities *s, const lag_run *run)
{
    lag_columns *columns = &s->columns;
    const size_t count = size_of(run) * columns->lanes;
    const size_t height = lag_columns_variables(run->motion.model) * columns->lanes;
    const double t = run->stepper.t_before;
    const int again = fabs(t - columns->t_before) < fabs(t - columns->t); /* over a corner time goes on by some roundings */
    for (size_t block = 0; block < columns->blocks; ++block) {
        double *now = columns->x + block * height;
        double *before = columns->before + block * count;
        memcpy(again ? now : before, again ? before : now, count * sizeof(double));
    }
    columns->t_before = t;
    columns->t_dense = (double)NAN;
    return again;
}

lag_status lag_sensitivities_step(lag_run *run)
{
    lag_sensitivities *s = lag_sensitivities_of(run);
    lag_stepper *stepper = &run->stepper;
    const double h = stepper->t - stepper->t_before;
    const size_t height = lag_columns_variables(run->motion.model) * s->columns.lanes;
    double error = 0.0;
    const int again = return_to_beginning(s, run);
    lag_status status = stepper->method->implicit ? implicit_step(s, run) : explicit_step(s, run, &error);
    if (status == LAG_MISSING && h * LAG_DOP853_SHRINK > stepper->h_least) {
        s->columns.t = stepper->t;
        lag_stepper_undo(stepper, h * LAG_DOP853_SHRINK);
        return LAG_TOO_LONG;
    }
    if (status != LAG_OK) {
        return status;
    }
    s->columns.t = stepper->t;
    const double factor = error > 0.0 ? LAG_DOP853_SAFETY * pow(error, -1.0 / 8.0) : 1.0 / LAG_DOP853_SHRINK;
    const int rounding = again && error > 0.5 * s->columns.rejected; /* a shorter step did not help */
    if (error > 1.0 && !rounding && h * LAG_DOP853_SHRINK > stepper->h_least) {
        s->columns.rejected = error;
        lag_stepper_undo(stepper, h * fmax(LAG_DOP853_SHRINK, factor));
        return LAG_TOO_LONG;
    }
    s->columns.rejected = (double)INFINITY;
    stepper->h = error > 0.0 && !rounding ? fmin(stepper->h, h * fmin(factor, 1.0 / LAG_DOP853_SHRINK)) : stepper->h;
    for (size_t block = 0; block < s->columns.blocks && status == LAG_OK; ++block) {
        status = lag_columns_project(s, run, block, stepper->t, stepper->x, s->columns.x + block * height);
    }
    return status;
}

/* The stages of the dense output, whose terms are found for all blocks. */
static lag_status prepare_dense(lag_sensitivities *s, lag_run *run)
{
    const lag_stepper *stepper = &run->stepper;
    lag_status status = lag_stepper_dense(&run->stepper, stepper->t, s->work.state); /* its own further stages */
    const lag_attempt_arrays of_state = lag_dop853_last(stepper);
    for (size_t i = LAG_DOP853_END + 1; i < LAG_DOP853_SLOPES && status == LAG_OK; ++i) {
        status = explicit_stage(s, run, &of_state, i);
    }
    for (size_t block = 0; block < s->columns.blocks && status == LAG_OK; ++block) {
        lag_attempt_arrays at = arrays_of(s, run, block);
        const size_t count = at.size * at.lanes;
        lag_combine(count, &lag_dop853_stages[LAG_DOP853_END], at.h, at.slope, at.x, s->work.point);
        at.x_new = s->work.point; /* without the projection behind the step */
        lag_attempt_dense(&at, s->work.terms + block * LAG_DOP853_TERMS * count);
    }
    s->columns.t_dense = stepper->t;
    return status;
}

lag_status lag_columns_dense(lag_sensitivities *s, lag_run *run, size_t block, double t, double *to)
{
    const lag_stepper *stepper = &run->stepper;
    const size_t count = size_of(run) * s->columns.lanes;
    const double h = s->columns.t - s->columns.t_before;
    const double part = h > 0.0 ? (t - s->columns.t_before) / h : 1.0;
    lag_status status = LAG_OK;
    if (stepper->method->implicit) {
        implicit_dense(s, run, block, part, to);
        return LAG_OK;
    }
    if (s->columns.t_dense != stepper->t) {
        status = prepare_dense(s, run);
    }
    const double *terms = s->work.terms + block * LAG_DOP853_TERMS * count;
    const double *before = s->columns.before + block * count;
    for (size_t i = 0; i < count && status == LAG_OK; ++i) {
        double sum = 0.0;
        for (size_t k = LAG_DOP853_TERMS; k-- > 0;) {
            sum = (sum + terms[k * count + i]) * (k % 2 == 0 ? part : 1.0 - part);
        }
        to[i] = before[i] + sum;
    }
    return status;
}
