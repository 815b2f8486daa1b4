#include "lag/sensitivities/sensitivities.h"

#include <math.h>
#include <string.h>

#include "lag/linalg/arena.h"
#include "lag/linalg/vector.h"
#include "lag/run.h"

size_t lag_columns_variables(const lag_model *model)
{
    return lag_motion_size(model) + model->nu + model->np;
}

size_t lag_sensitivities_width(const lag_model *model)
{
    return lag_motion_size(model) + lag_places_of(model).contact + model->ny;
}

static size_t lanes_for(size_t count)
{
    size_t lanes = 1;
    while (lanes < count && lanes < LAG_ATTEMPT_LANES) {
        lanes *= 2;
    }
    return lanes;
}

static size_t blocks_for(size_t count)
{
    const size_t lanes = lanes_for(count);
    return (count + lanes - 1) / lanes;
}

/* Values of the map of an instant. */
static size_t instant_values(const lag_model *model)
{
    return lag_motion_size(model) + model->nw + model->ncontact;
}

/* Values of any map. */
static size_t most_values(const lag_model *model)
{
    const size_t guards = lag_guard_count(model) + model->ncorner;
    const size_t times = 2 * model->nclock + model->ndistance;
    return lag_larger(lag_larger(instant_values(model) + model->ny, lag_motion_size(model) + model->np), lag_larger(guards, times));
}

/* Room for what is behind an instant, which serves for derivatives of other maps before. */
static size_t behind_values(const lag_model *model, size_t count)
{
    return lag_larger(count * instant_values(model), 2 * most_values(model));
}

/* Equations of accelerations, multipliers and rates of states. */
static size_t equations_of(const lag_model *model)
{
    return model->nq + model->nc + model->nz;
}

/* Doubles of what jacobian() tells. */
static size_t derivatives_of_motion(const lag_model *model)
{
    return model->nq + model->nc + equations_of(model) * (model->nq + model->nz + lag_columns_variables(model));
}

/*
 * Equations of stages are decomposed where that takes less than the corrections of Radau's own iteration. A decomposition goes with the cube of its rows,
 * in registers, once for all columns; each column needs several corrections, in single numbers. WORTH is how many multiplications of the one, times three,
 * take as long as all corrections that have one multiplication each. Measured (AVX-512, tolerance 1e-8): both take the same time at
 *
 *                                   2 columns               10 columns
 *     springs in a row, sparse      75 rows (WORTH 240)     205 rows (WORTH 390)
 *     pendulums in a row, dense     140 rows (WORTH 130)    beyond 511 rows, where it takes 0.7 of the time
 *
 * The matrix has at most 8 MB.
 */
enum { WORTH = 200, MOST_DECOMPOSED = 1024 };

/* Rows of the equations of stages of so many columns where they are decomposed. */
static size_t decomposed(const lag_model *model, size_t count)
{
    const lag_ode ode = lag_motion_ode(model);
    lag_radau_memo memo;
    lag_radau_keep_band(&memo, &ode);
    const double rows = (double)(LAG_RADAU_STAGES * lag_radau_others(&ode));
    const double solution = (double)((1 + 4 * LAG_RADAU_PAIRS) * lag_radau_matrix(&ode, &memo)); /* numbers of pairs are complex */
    const double correction = (double)(LAG_RADAU_STAGES * lag_radau_entries(&ode)) + solution;
    return rows <= MOST_DECOMPOSED && rows * rows * rows <= WORTH * (double)count * correction ? (size_t)rows : 0;
}

/* Doubles of both ways to solve them. */
static size_t memory_for_stages(const lag_model *model, size_t count)
{
    const lag_ode ode = lag_motion_ode(model);
    const size_t n = lag_motion_size(model);
    const size_t lanes = lanes_for(count);
    const size_t rows = decomposed(model, count);
    const size_t matrix = (rows + 1) * lag_stage_rows_apart(rows) + LAG_ATTEMPT_LANES;
    const size_t columns = rows * (1 + n + model->nu + lanes) + LAG_RADAU_STAGES * model->nq * lanes;
    return rows > 0 ? matrix + columns + n * n : LAG_RADAU_STAGES * (lag_radau_entries(&ode) + n + 3 * lag_radau_size(&ode));
}

/* The next `count` doubles from where a register begins; there is room for as many as it holds. */
static double *take_aligned(double **memory, size_t count)
{
    const uintptr_t bytes = LAG_ATTEMPT_LANES * sizeof(double);
    const uintptr_t over = (uintptr_t)*memory % bytes;
    double *start = lag_take(memory, LAG_ATTEMPT_LANES + count);
    return start + (over == 0 ? 0 : (bytes - over) / sizeof(double));
}

static void place_stages(lag_collocation_system *system, const lag_model *model, size_t count, double **memory)
{
    const lag_ode ode = lag_motion_ode(model);
    const size_t n = lag_motion_size(model);
    const size_t lanes = lanes_for(count);
    const size_t rows = decomposed(model, count);
    lag_stage_equations *equations = &system->equations;
    *equations = (lag_stage_equations){.nq = model->nq, .n = n, .width = n + model->nu};
    if (rows > 0) {
        equations->matrix = take_aligned(memory, (rows + 1) * lag_stage_rows_apart(rows));
        equations->pivots = lag_take(memory, rows);
        equations->jacobian = lag_take(memory, rows * equations->width);
        equations->coordinates = lag_take(memory, LAG_RADAU_STAGES * model->nq * lanes);
        equations->right = lag_take(memory, rows * lanes);
        system->jacobian = lag_take(memory, n * n);
        return;
    }
    system->jacobian = lag_take(memory, LAG_RADAU_STAGES * lag_radau_entries(&ode));
    system->slope = lag_take(memory, LAG_RADAU_STAGES * n);
    system->z = lag_take(memory, LAG_RADAU_STAGES * lag_radau_size(&ode));
    system->w = lag_take(memory, LAG_RADAU_STAGES * lag_radau_size(&ode));
    system->sides = lag_take(memory, LAG_RADAU_STAGES * lag_radau_size(&ode));
}

static size_t memory_for(const lag_model *model, size_t count)
{
    const size_t n = lag_motion_size(model);
    const size_t width = lanes_for(count);
    const size_t all = blocks_for(count) * width;
    const size_t variables = lag_columns_variables(model);
    const size_t columns = all * (3 * variables + model->nw + n + 2) + 3 * count * model->np + 2 * all + blocks_for(count) + 1;
    const size_t work = (3 + LAG_DOP853_SLOPES) * n + all * n * (LAG_DOP853_SLOPES + LAG_DOP853_TERMS) + width * (variables + n + model->ny) + variables + 2 * model->nw + model->nu + width * (n + model->ny) + (n + model->ny) * (n + model->nu + all) + lag_loads_along_memory(model);
    const size_t motion = derivatives_of_motion(model) + 2 * width * equations_of(model);
    const size_t implicit = memory_for_stages(model, count) + n * (n + 4);
    const size_t instant = 2 * n + model->nw + model->ncontact + count + model->ncontact * count + behind_values(model, count);
    return columns + work + motion + implicit + instant + lag_columns_past_memory(model, count) + model->np + n + most_values(model) + lag_guard_count(model) + lag_differences_memory(model, most_values(model));
}

static void place_instant(lag_columns_instant *instant, const lag_model *model, size_t count, double **memory)
{
    const size_t n = lag_motion_size(model);
    instant->f = lag_take(memory, n);
    instant->f_after = lag_take(memory, n);
    instant->w_after = lag_take(memory, model->nw);
    instant->until_after = lag_take(memory, model->ncontact);
    instant->time = lag_take(memory, count);
    instant->until = lag_take(memory, model->ncontact * count);
    instant->behind = lag_take(memory, behind_values(model, count));
    instant->sizes = lag_take(memory, most_values(model));
    instant->bend = lag_take(memory, lag_guard_count(model));
}

static size_t *take_numbers(double **memory, size_t count)
{
    return (size_t *)(void *)lag_take(memory, count);
}

static void place_entries(lag_parameter_entries *entries, const lag_columns *columns, size_t most, double **memory)
{
    const size_t all = columns->blocks * columns->lanes;
    entries->columns = columns->lanes;
    entries->lead = take_numbers(memory, all);
    entries->lead_part = lag_take(memory, all);
    entries->first = take_numbers(memory, columns->blocks + 1);
    entries->number = take_numbers(memory, most);
    entries->lane = take_numbers(memory, most);
    entries->part = lag_take(memory, most);
}

static void place_motion(lag_motion_derivatives *motion, const lag_model *model, size_t lanes, double **memory)
{
    const size_t equations = equations_of(model);
    const size_t size = lag_motion_size(model);
    motion->kept = (lag_kept){*memory, derivatives_of_motion(model)};
    motion->qdd = lag_take(memory, model->nq);
    motion->lam = lag_take(memory, model->nc);
    motion->response = lag_take(memory, (model->nq + model->nz) * equations);
    motion->by_state = lag_take(memory, equations * (lag_motion_size(model) + model->nu));
    motion->by_parameter = lag_take(memory, equations * model->np);
    motion->product = (lag_motion_product){
        .nq = model->nq,
        .np = model->np,
        .size = size,
        .by_state = {equations, size, size + model->nu, motion->by_state},
        .by_input = {equations, 0, size + model->nu, motion->by_state + size},
        .response = {model->nq + model->nz, equations, equations, motion->response},
        .along = lag_take(memory, lanes * equations),
        .sum = lag_take(memory, lanes * equations),
    };
}

static void place_work(lag_columns_work *work, const lag_model *model, size_t count, const lag_columns *columns, double **memory)
{
    const size_t n = lag_motion_size(model);
    const size_t all = columns->blocks * columns->lanes;
    const size_t variables = lag_columns_variables(model);
    work->state = lag_take(memory, n);
    work->state_of_stage = lag_take(memory, n);
    work->states = lag_take(memory, LAG_DOP853_SLOPES * n);
    work->known.x = lag_take(memory, n);
    work->slopes = lag_take(memory, all * n * LAG_DOP853_SLOPES);
    work->terms = lag_take(memory, all * n * LAG_DOP853_TERMS);
    work->point = lag_take(memory, columns->lanes * variables);
    work->rates = lag_take(memory, columns->lanes * n);
    work->y = lag_take(memory, columns->lanes * model->ny);
    work->one = lag_take(memory, variables + model->nw);
    work->u = lag_take(memory, model->nu);
    work->w = lag_take(memory, model->nw);
    work->one_rates = lag_take(memory, columns->lanes * (n + model->ny));
    work->by_state = lag_take(memory, n * (n + model->nu));
    work->outputs_by_state = lag_take(memory, model->ny * (n + model->nu));
    work->by_parameter = lag_take(memory, all * n);
    work->outputs_by_parameter = lag_take(memory, all * model->ny);
    place_motion(&work->motion, model, columns->lanes, memory);
    lag_loads_along_place(&work->loads, model, lag_take(memory, lag_loads_along_memory(model)));
    place_stages(&work->collocation, model, count, memory);
}

void lag_columns_put(const lag_sensitivities *s, size_t column, size_t row, size_t count, const double *from, double *blocks, size_t height)
{
    const size_t block = column / s->columns.lanes;
    const size_t lanes = lag_columns_lanes(s, block);
    lag_lane_put(lanes, column % s->columns.lanes, count, from, blocks + block * height * s->columns.lanes + row * lanes);
}

void lag_columns_get(const lag_sensitivities *s, size_t column, size_t row, size_t count, const double *blocks, size_t height, double *to)
{
    const size_t block = column / s->columns.lanes;
    const size_t lanes = lag_columns_lanes(s, block);
    lag_lane_get(lanes, column % s->columns.lanes, count, blocks + block * height * s->columns.lanes + row * lanes, to);
}

size_t lag_sensitivities_size(const lag_model *model, size_t count)
{
    return lag_padded(sizeof(lag_sensitivities)) + memory_for(model, count) * sizeof(double);
}

void lag_sensitivities_fault(const lag_sensitivities *s, lag_columns_fault *fault)
{
    *fault = s->fault;
}

/* Doubles in a register of the processor, as far as one of the functions knows. */
static size_t width_of(const lag_along *along)
{
    size_t width = 0;
    for (size_t i = 0; i < 3; ++i) {
        width = lag_larger(width, along[i].tangents != NULL ? along[i].tangents->width : 0);
    }
    return width;
}

lag_sensitivities *lag_sensitivities_of(const lag_run *run)
{
    return (lag_sensitivities *)(void *)lag_run_companion(run);
}

lag_sensitivities *lag_sensitivities_place(
    void *block, const lag_model *model, const lag_sensitivity_directions *of, const lag_sensitivity_rows *rows, const lag_along *along)
{
    lag_sensitivities *s = block;
    double *memory = (double *)(void *)((char *)block + lag_padded(sizeof(lag_sensitivities)));
    const size_t n = lag_motion_size(model);
    const size_t count = of->count;
    const size_t variables = lag_columns_variables(model);
    lag_columns *columns = &s->columns;
    s->companion = (lag_companion){lag_sensitivities_step, lag_columns_back, lag_sensitivities_instant, lag_sensitivities_after, lag_columns_row, lag_columns_note,
        lag_columns_keep_past};
    s->of = *of;
    s->results = *rows;
    s->along = (lag_sensitivity_functions){along[0], along[1], along[2], {0, 0, 0}};
    s->discretes = lag_places_of(model).contact;
    columns->lanes = lanes_for(count);
    columns->blocks = blocks_for(count);
    columns->last = lanes_for(count - (columns->blocks - 1) * columns->lanes);
    const size_t width = width_of(along);
    s->sums = lag_column_sums_of(width);
    s->of_blocks[0] = lag_column_sums_of(columns->lanes < width ? columns->lanes : width);
    s->of_blocks[1] = lag_column_sums_of(columns->last < width ? columns->last : width);
    const size_t all = columns->blocks * columns->lanes;
    columns->x = lag_take(&memory, all * variables);
    columns->w = lag_take(&memory, all * model->nw);
    columns->before = lag_take(&memory, all * n);
    columns->inside = lag_take(&memory, all * variables);
    columns->extent = lag_take(&memory, all);
    columns->p = lag_take(&memory, count * variables);
    columns->of_parameters = lag_take(&memory, count);
    place_entries(&columns->entries, columns, count * model->np, &memory);
    columns->t = columns->t_before = columns->t_dense = (double)NAN;
    columns->rejected = (double)INFINITY;
    s->work.known.t = (double)NAN;
    place_work(&s->work, model, count, columns, &memory);
    s->rosenbrock.matrix = lag_take(&memory, n * n);
    s->rosenbrock.pivots = lag_take(&memory, n);
    s->rosenbrock.right = lag_take(&memory, n);
    s->rosenbrock.k[0] = lag_take(&memory, n);
    s->rosenbrock.k[1] = lag_take(&memory, n);
    place_instant(&s->instant, model, count, &memory);
    s->instant.pending = 0;
    s->fault = (lag_columns_fault){.t = (double)INFINITY, .first = (double)INFINITY};
    lag_columns_past_place(&s->past, model, count, lag_take(&memory, lag_columns_past_memory(model, count)));
    s->scales = lag_take(&memory, model->np);
    s->chosen = lag_take_flags(&memory, n);
    lag_differences_place(&s->differences, model, most_values(model), memory);
    for (size_t k = 0; k < count; ++k) { /* directions of inputs and parameters stay */
        memcpy(s->work.one, s->of.u + k * model->nu, model->nu * sizeof(double));
        memcpy(s->work.one + model->nu, s->of.p + k * model->np, model->np * sizeof(double));
        lag_columns_put(s, k, n, model->nu + model->np, s->work.one, columns->x, variables);
    }
    return s;
}

/* The entries of the direction dp (np) of column k, behind those of the columns before. */
static void add_entries(lag_columns *columns, size_t k, size_t np, const double *dp)
{
    lag_parameter_entries *entries = &columns->entries;
    size_t *end = entries->first + k / columns->lanes + 1;
    entries->lead[k] = 0;
    entries->lead_part[k] = 0.0;
    *end = k % columns->lanes == 0 ? end[-1] : *end;
    for (size_t i = 0; i < np; ++i) {
        if (dp[i] != 0.0 && entries->lead_part[k] == 0.0) {
            entries->lead[k] = i;
            entries->lead_part[k] = dp[i];
        } else if (dp[i] != 0.0) {
            entries->number[*end] = i;
            entries->lane[*end] = k % columns->lanes;
            entries->part[(*end)++] = dp[i];
        }
    }
}

void lag_columns_follow_parameters(lag_sensitivities *s, const lag_model *model)
{
    const size_t inputs = lag_motion_size(model);
    const size_t first = inputs + model->nu;
    const size_t variables = lag_columns_variables(model);
    double *one = s->work.one;
    s->columns.moving = 0;
    s->columns.shifted = 0;
    s->work.known.t = (double)NAN;
    memset(s->along.prepared, 0, sizeof s->along.prepared);
    for (size_t k = 0; k < s->of.count; ++k) {
        lag_columns_get(s, k, 0, variables, s->columns.x, variables, one);
        add_entries(&s->columns, k, model->np, one + first);
        s->columns.shifted = s->columns.shifted || lag_any(model->nu, one + inputs);
        if (lag_any(model->np, one + first)) {
            s->columns.of_parameters[s->columns.moving++] = (double)k;
        }
    }
    s->work.motion.product.by_parameter = s->columns.moving > 0 ? s->work.motion.by_parameter : NULL;
    s->work.motion.product.by_input.width = s->columns.shifted ? model->nu : 0;
    lag_fill(s->columns.moving * variables, 0.0, s->columns.p);
    for (size_t k = 0; k < s->columns.moving; ++k) {
        lag_columns_get(s, (size_t)s->columns.of_parameters[k], 0, variables, s->columns.x, variables, one);
        for (size_t i = first; i < variables; ++i) {
            s->columns.p[i * s->columns.moving + k] = one[i];
        }
    }
}
