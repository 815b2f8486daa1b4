/*
 * Columns along one step, stage by stage with the method of the state: DOP853, and Radau by its collocation equations, which are linear in them; those of
 * fixed steps are in sensitivity_fixed.c.
 */
#include <float.h>
#include <math.h>
#include <string.h>

#include "lag/linalg/arena.h"
#include "lag/linalg/vector.h"
#include "lag/methods/step_control.h"
#include "lag/run.h"
#include "lag/sensitivities/sensitivities.h"

static size_t size_of(const lag_run *run)
{
    return run->stepper.ode->size;
}

/* Arrays of a block, for the sums of DOP853; `at` has those of another one. */
static inline void move_to(const lag_sensitivities *s, const lag_run *run, size_t block, lag_attempt_arrays *at)
{
    const lag_model *model = run->motion.model;
    const size_t columns = block * s->columns.lanes; /* before those of the block */
    at->lanes = lag_columns_lanes(s, block);
    at->x = lag_columns_before(s, at->size, block);
    at->slope = s->work.slopes + columns * LAG_DOP853_SLOPES * at->size;
    at->x_new = s->columns.x + columns * (at->size + model->nu + model->np);
}

/* The same of any. */
static lag_attempt_arrays arrays_of(const lag_sensitivities *s, const lag_run *run, size_t block)
{
    const lag_stepper *stepper = &run->stepper;
    lag_attempt_arrays at;
    at.size = size_of(run);
    at.tolerance = NULL; /* errors of columns are measured by those of the state */
    at.stage = s->work.point;
    lag_fill(LAG_ATTEMPT_LANES, stepper->t - stepper->t_before, at.h);
    lag_fill(LAG_ATTEMPT_LANES, stepper->t_before, at.t);
    move_to(s, run, block, &at);
    return at;
}

/* Directions of inputs and parameters of the block, behind the columns in work.point. */
static void set_point(const lag_sensitivities *s, const lag_run *run, const lag_attempt_arrays *at)
{
    const lag_model *model = run->motion.model;
    const size_t count = at->size * at->lanes;
    const size_t read = (s->work.motion.known ? (s->columns.shifted ? model->nu : 0) : model->nu + model->np) * at->lanes;
    memcpy(s->work.point + count, at->x_new + count, read * sizeof(double));
}

/* States at the stages from `first` to before `end`: columns need them one by one, and would have to wait for each. */
static void find_states(const lag_sensitivities *s, const lag_attempt_arrays *of_state, size_t first, size_t end)
{
    for (size_t i = first; i < end; ++i) {
        lag_combine(of_state->size, &lag_dop853_stages[i], of_state->h, of_state->slope, of_state->x, s->work.states + i * of_state->size);
    }
}

/* Rates of all blocks at stage i, 0 being the beginning and LAG_DOP853_END the end; `at` are the arrays of a block. */
static lag_status explicit_stage(lag_sensitivities *s, lag_run *run, const lag_attempt_arrays *of_state, size_t i, lag_attempt_arrays *at)
{
    const lag_combination *stage = &lag_dop853_stages[i];
    const double t = of_state->t[0] + (i > 0 ? stage->node * of_state->h[0] : 0.0);
    const double *state = i > 0 ? s->work.states + i * of_state->size : of_state->x;
    lag_status status = lag_columns_set_state(s, run, t, state, 0);
    const int plain = s->work.motion.known && !lag_any(s->columns.blocks * run->motion.model->nw * s->columns.lanes, s->columns.w);
    for (size_t block = 0; block < s->columns.blocks && status == LAG_OK; ++block) {
        move_to(s, run, block, at);
        const size_t count = at->size * at->lanes;
        double *found = i == LAG_DOP853_END ? at->x_new : at->stage;
        const double *x = i > 0 ? found : at->x;
        if (i > 0) {
            s->sums->combine(count, stage, at->h, at->slope, at->x, found);
        }
        if (plain) {
            lag_columns_sums(s, block)->rates(
                &s->work.motion.product, &s->columns.entries, block, at->lanes, x, at->x_new + count, at->slope + i * count);
            continue;
        }
        if (x != s->work.point) {
            memcpy(s->work.point, x, count * sizeof(double));
        }
        set_point(s, run, at);
        status = lag_columns_rates(s, run, block, t, state, s->work.point, at->slope + i * count, NULL);
    }
    return status;
}

/* The slopes in the first stage, or in the last, are those at this time and state. The past of delayed values moves on between two steps. */
static void remember_slopes(lag_sensitivities *s, const lag_model *model, size_t stage, double t, const double *x, size_t size)
{
    s->work.known.stage = stage;
    s->work.known.t = model->ndelay == 0 ? t : (double)NAN;
    memcpy(s->work.known.x, x, size * sizeof(double));
}

/* Rates at the beginning: those at the end of the step before, or of one that began there, where nothing has happened since. */
static lag_status first_stage(lag_sensitivities *s, lag_run *run, const lag_attempt_arrays *of_state, lag_attempt_arrays *at)
{
    lag_status status = LAG_OK;
    if (s->work.known.t != of_state->t[0] || !lag_same(of_state->size, s->work.known.x, of_state->x)) {
        status = explicit_stage(s, run, of_state, 0, at);
    } else if (s->work.known.stage != 0) {
        for (size_t block = 0; block < s->columns.blocks; ++block) {
            move_to(s, run, block, at);
            const size_t count = at->size * at->lanes;
            memcpy(at->slope, at->slope + s->work.known.stage * count, count * sizeof(double));
        }
    }
    remember_slopes(s, run->motion.model, 0, of_state->t[0], of_state->x, of_state->size);
    return status;
}

/*
 * Error of the worst column as a part of what it may be. The local error of a method of order p goes with the (p + 1)th power of h over the time in which the
 * motion changes, and its derivative by what stretches this time is p + 1 times the error itself: so much is in order where the error of the state is.
 */
static double largest_error(lag_sensitivities *s, lag_run *run, lag_attempt_arrays *at)
{
    double most = 0.0;
    for (size_t block = 0; block < s->columns.blocks; ++block) {
        const double *extent = s->columns.extent + block * s->columns.lanes;
        move_to(s, run, block, at);
        most = fmax(most, lag_columns_sums(s, block)->error(at, run->stepper.tolerance, run->accuracy.relative, extent));
    }
    return most / (run->stepper.method->order + 1);
}

/* One step with DOP853, and its error. */
static lag_status explicit_step(lag_sensitivities *s, lag_run *run, double *error)
{
    const lag_attempt_arrays of_state = lag_dop853_last(&run->stepper);
    lag_attempt_arrays at = arrays_of(s, run, 0);
    find_states(s, &of_state, 1, LAG_DOP853_END + 1);
    lag_status status = first_stage(s, run, &of_state, &at);
    for (size_t i = 1; i <= LAG_DOP853_END && status == LAG_OK; ++i) {
        status = explicit_stage(s, run, &of_state, i, &at);
    }
    *error = status == LAG_OK ? largest_error(s, run, &at) : 0.0;
    return status == LAG_OK && !isfinite(*error) ? LAG_NOT_FINITE : status;
}

/* ---- Radau ---- */

/* The Jacobian at stage i of the state, and the slopes there along the columns where the step begins and what is not the state. */
static lag_status implicit_stage(lag_sensitivities *s, lag_run *run, const lag_radau_places *of_state, size_t i)
{
    const lag_stepper *stepper = &run->stepper;
    const size_t n = size_of(run);
    const double t = stepper->t_before + of_state->table->node[i] * (stepper->t - stepper->t_before);
    for (size_t j = 0; j < n; ++j) {
        s->work.state_of_stage[j] = stepper->x_before[j] + of_state->z[i * n + j];
    }
    lag_status status = lag_columns_jacobian(s, run, t, s->work.state_of_stage, i);
    for (size_t block = 0; block < s->columns.blocks && status == LAG_OK; ++block) {
        const lag_attempt_arrays at = arrays_of(s, run, block);
        memcpy(s->work.point, at.x, n * at.lanes * sizeof(double));
        set_point(s, run, &at);
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

/* Columns of a block within the step, by weights of their stages. */
static void find_inside(const lag_attempt_arrays *at, size_t stages, const double *weight, double *to)
{
    const size_t count = at->size * at->lanes;
    memcpy(to, at->x, count * sizeof(double));
    for (size_t k = 0; k < stages; ++k) {
        lag_axpy(count, weight[k], at->slope + k * count, to);
    }
}

/*
 * Error of one column whose defect within the step is `error` (size), filtered as that of the state: as a part of what it may be. Its measure is the
 * tolerance of the state, times a part of the column, or what a change of order one makes of the state.
 */
static double implicit_part(const lag_run *run, const lag_radau_places *of_state, const lag_attempt_arrays *at, size_t lane, double extent, double *error)
{
    const lag_stepper *stepper = &run->stepper;
    double before = 0.0, behind = 0.0;
    lag_radau_solve_real(stepper->ode, of_state, error);
    for (size_t i = 0; i < at->size; ++i) {
        const double first = at->x[i * at->lanes + lane] / stepper->tolerance[i];
        const double last = at->x_new[i * at->lanes + lane] / stepper->tolerance[i];
        before += first * first;
        behind += last * last;
    }
    const double length = fmax(run->accuracy.relative * sqrt(fmax(before, behind) / (double)at->size), extent);
    return isfinite(length) ? stepper->method->factor * lag_stepper_norm(stepper, error) / (length > 0.0 ? length : 1.0) : (double)INFINITY;
}

/*
 * Error of the worst column, by the defect of its polynomial between two nodes, as a part of what it may be (see largest_error()). The steps of the state do
 * not tell it: a motion at rest has steps as long as the run, and its neighbours oscillate.
 */
static lag_status implicit_error(lag_sensitivities *s, lag_run *run, const lag_radau_places *of_state, double *error)
{
    const lag_stepper *stepper = &run->stepper;
    const lag_radau_table *table = of_state->table;
    const size_t node = table->stages / 2;
    const double place = 0.5 * (table->node[node - 1] + table->node[node]);
    const double h = stepper->t - stepper->t_before;
    const double t = stepper->t_before + place * h;
    double value[LAG_RADAU_STAGES], slope[LAG_RADAU_STAGES];
    lag_radau_weights(table, place, value, slope);
    lag_status status = lag_stepper_dense(&run->stepper, t, s->work.state);
    status = status == LAG_OK ? lag_columns_set_state(s, run, t, s->work.state, 0) : status;
    for (size_t block = 0; block < s->columns.blocks && status == LAG_OK; ++block) {
        const lag_attempt_arrays at = arrays_of(s, run, block);
        const size_t count = at.size * at.lanes;
        find_inside(&at, table->stages, value, s->work.point);
        set_point(s, run, &at);
        status = lag_columns_rates(s, run, block, t, s->work.state, s->work.point, s->work.rates, NULL);
        for (size_t lane = 0; lane < at.lanes && status == LAG_OK; ++lane) {
            double *defect = s->work.state_of_stage;
            for (size_t i = 0; i < at.size; ++i) {
                double rate = 0.0;
                for (size_t k = 0; k < table->stages; ++k) {
                    rate += slope[k] * at.slope[k * count + i * at.lanes + lane];
                }
                defect[i] = s->work.rates[i * at.lanes + lane] - rate / h;
            }
            *error = fmax(*error, implicit_part(run, of_state, &at, lane, s->columns.extent[block * s->columns.lanes + lane], defect));
        }
    }
    *error /= (double)(table->stages + 1);
    return status == LAG_OK && !isfinite(*error) ? LAG_NOT_FINITE : status;
}

/* One step by the collocation equations of the last one, and its error. LAG_MISSING: they were not solved; they will be for a shorter step. */
static lag_status implicit_step(lag_sensitivities *s, lag_run *run, double *error)
{
    lag_radau_memo memo;
    const lag_radau_places of_state = last_of_state(&run->stepper, &memo);
    const size_t last = of_state.table->stages - 1;
    lag_status status = LAG_OK;
    for (size_t i = 0; i <= last && status == LAG_OK; ++i) {
        status = implicit_stage(s, run, &of_state, i);
    }
    status = status == LAG_OK ? lag_columns_collocate(s, &run->stepper, &of_state) : status;
    for (size_t block = 0; block < s->columns.blocks && status == LAG_OK; ++block) {
        const lag_attempt_arrays at = arrays_of(s, run, block);
        const size_t count = at.size * at.lanes;
        for (size_t i = 0; i < count; ++i) {
            at.x_new[i] = at.x[i] + at.slope[last * count + i];
        }
    }
    return status == LAG_OK ? implicit_error(s, run, &of_state, error) : status;
}

/* Value at a part of the step of the polynomial through zero and the stages z. */
static void implicit_dense(const lag_sensitivities *s, const lag_run *run, size_t block, double part, double *to)
{
    const lag_radau_places of_state = lag_radau_place(&run->stepper);
    const lag_radau_table *table = &lag_radau_tables[((size_t)of_state.memo->polynomial - 3) / 2];
    const lag_attempt_arrays at = arrays_of(s, run, block);
    double value[LAG_RADAU_STAGES], slope[LAG_RADAU_STAGES];
    lag_radau_weights(table, part, value, slope);
    find_inside(&at, table->stages, value, to);
}

/* ---- all ---- */

/* True if the method does not choose the length of its steps. */
static int is_fixed(const lag_run *run)
{
    return run->stepper.method->error_order == 0;
}

/* Columns where the step begins, wherever those that were found last stand; 1: another step was tried from there. */
static int return_to_beginning(lag_sensitivities *s, const lag_run *run)
{
    lag_columns *columns = &s->columns;
    const size_t variables = lag_columns_variables(run->motion.model);
    const double t = run->stepper.t_before;
    const int again = fabs(t - columns->t_before) < fabs(t - columns->t); /* over a corner time goes on by some roundings */
    for (size_t block = 0; block < columns->blocks; ++block) {
        double *now = columns->x + block * variables * columns->lanes;
        double *before = lag_columns_before(s, size_of(run), block);
        memcpy(again ? now : before, again ? before : now, size_of(run) * lag_columns_lanes(s, block) * sizeof(double));
    }
    columns->t_before = t;
    columns->t_dense = (double)NAN;
    return again;
}

/* Length of the next step as a part of this one, by this error. */
static double part_of(const lag_stepper *stepper, double error)
{
    const int implicit = stepper->method->implicit;
    return implicit ? LAG_DOP853_SAFETY * pow(error, -1.0 / (lag_radau_remembered(stepper)->polynomial + 1.0)) : lag_control_part(error);
}

lag_status lag_sensitivities_step(lag_run *run)
{
    lag_sensitivities *s = lag_sensitivities_of(run);
    lag_stepper *stepper = &run->stepper;
    const double h = stepper->t - stepper->t_before;
    double error = 0.0;
    if (stepper->method == &lag_collocation) { /* across a singular position, where neighbours go on along other branches */
        s->fault.t = stepper->t_before;
        s->fault.guard = 0;
        return LAG_NOT_SMOOTH;
    }
    const int again = return_to_beginning(s, run);
    lag_status status = is_fixed(run) ? lag_columns_fixed_step(s, run) :
        stepper->method->implicit ? implicit_step(s, run, &error) : explicit_step(s, run, &error);
    if (status == LAG_MISSING && h * LAG_DOP853_SHRINK > stepper->h_least) {
        s->columns.t = stepper->t;
        lag_stepper_undo(stepper, h * LAG_DOP853_SHRINK);
        return LAG_TOO_LONG;
    }
    if (status != LAG_OK) {
        return status;
    }
    s->columns.t = stepper->t;
    const double factor = error > 0.0 ? part_of(stepper, error) : 1.0 / LAG_DOP853_SHRINK;
    /* implicit steps that are far too long have errors as large as the column, whatever their length */
    const int large = stepper->method->implicit && error * run->accuracy.relative > sqrt(DBL_EPSILON);
    const int rounding = again && !large && error > 0.5 * s->columns.rejected; /* a shorter step did not help */
    if (error > 1.0 && !rounding && h * LAG_DOP853_SHRINK > stepper->h_least) {
        s->columns.rejected = error;
        lag_stepper_undo(stepper, h * fmax(LAG_DOP853_SHRINK, factor));
        return LAG_TOO_LONG;
    }
    s->columns.rejected = (double)INFINITY;
    if (run->motion.model->nc == 0 && !stepper->method->implicit && !is_fixed(run)) { /* no projection follows */
        remember_slopes(s, run->motion.model, LAG_DOP853_END, stepper->t, stepper->x, size_of(run));
    }
    stepper->h = error > 0.0 && !rounding ? fmin(stepper->h, h * fmin(factor, 1.0 / LAG_DOP853_SHRINK)) : stepper->h;
    return lag_columns_project(s, run, stepper->t, stepper->x, s->columns.x);
}

/* Terms of the dense output of a block. */
static double *terms_of(const lag_sensitivities *s, const lag_run *run, size_t block)
{
    return s->work.terms + block * LAG_DOP853_TERMS * size_of(run) * s->columns.lanes;
}

/* The stages of the dense output, whose terms are found for all blocks. */
static lag_status prepare_dense(lag_sensitivities *s, lag_run *run)
{
    const lag_stepper *stepper = &run->stepper;
    lag_status status = lag_stepper_dense(&run->stepper, stepper->t, s->work.state); /* its own further stages */
    const lag_attempt_arrays of_state = lag_dop853_last(stepper);
    lag_attempt_arrays at = arrays_of(s, run, 0);
    find_states(s, &of_state, LAG_DOP853_END + 1, LAG_DOP853_SLOPES);
    for (size_t i = LAG_DOP853_END + 1; i < LAG_DOP853_SLOPES && status == LAG_OK; ++i) {
        status = explicit_stage(s, run, &of_state, i, &at);
    }
    for (size_t block = 0; block < s->columns.blocks && status == LAG_OK; ++block) {
        move_to(s, run, block, &at);
        s->sums->combine(at.size * at.lanes, &lag_dop853_stages[LAG_DOP853_END], at.h, at.slope, at.x, s->work.point);
        at.x_new = s->work.point; /* without the projection behind the step */
        s->sums->dense(&at, terms_of(s, run, block));
    }
    return status;
}

lag_status lag_columns_dense(lag_sensitivities *s, lag_run *run, size_t block, double t, double *to)
{
    const lag_stepper *stepper = &run->stepper;
    const double h = s->columns.t - s->columns.t_before;
    const double part = h > 0.0 ? (t - s->columns.t_before) / h : 1.0;
    lag_status status = LAG_OK;
    if (stepper->method->implicit && !is_fixed(run)) {
        implicit_dense(s, run, block, part, to);
        return LAG_OK;
    }
    if (s->columns.t_dense != stepper->t) {
        status = is_fixed(run) ? lag_columns_prepare_fixed(s, run) : prepare_dense(s, run);
        s->columns.t_dense = stepper->t;
    }
    if (is_fixed(run)) {
        lag_columns_fixed_dense(s, run, block, h, part, to);
        return status;
    }
    if (status == LAG_OK) {
        const double *before = lag_columns_before(s, size_of(run), block);
        s->sums->interpolate(size_of(run) * lag_columns_lanes(s, block), terms_of(s, run, block), part, before, to);
    }
    return status;
}
