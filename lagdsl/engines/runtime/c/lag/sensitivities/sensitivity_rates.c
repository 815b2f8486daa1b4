/* Rates and outputs along the columns at a state. */
#include <string.h>

#include "lag/dynamics.h"
#include "lag/equations/jacobian.h"
#include "lag/linalg/arena.h"
#include "lag/linalg/vector.h"
#include "lag/run.h"
#include "lag/sensitivities/sensitivities.h"

/* The rates and outputs of the run at x, into `to` (2 nq + nz + ny). */
static lag_status evaluate(lag_run *run, double t, const double *x, int outputs, double *to)
{
    const lag_model *model = run->motion.model;
    const lag_status status = run->motion.ode.rates(&run->motion, t, x, to);
    return status == LAG_OK && outputs ? model->output(&run->motion.at, to + lag_motion_size(model)) : status;
}

double lag_columns_step(lag_sensitivities *s, lag_run *run, const double *w)
{
    const lag_displacement along = {0.0, NULL, w, NULL, NULL, NULL};
    s->differences.run = run;
    const double extent = lag_differences_extent(&s->differences, &along);
    return extent > 0.0 ? lag_differences_step() / extent : 0.0;
}

/* Adds the sixth-order differences along the discretes of a column, which stand behind its direction in work.one, to the rates and outputs in `lane`. */
static lag_status add_discretes(lag_sensitivities *s, lag_run *run, size_t lanes, size_t lane, double t, const double *x, double *rates, double *y)
{
    lag_motion *motion = &run->motion;
    const lag_model *model = motion->model;
    const size_t n = lag_motion_size(model);
    const size_t height = n + (y != NULL ? model->ny : 0);
    const double *w = s->work.one + lag_columns_variables(model);
    double *sum = s->differences.sixth;
    const double h = lag_columns_step(s, run, w);
    lag_status status = LAG_OK;
    memcpy(s->work.w, motion->w, model->nw * sizeof(double));
    lag_fill(height, 0.0, sum);
    for (int k = -LAG_POINTS; k <= LAG_POINTS && status == LAG_OK; k += k == -1 ? 2 : 1) {
        lag_axpy(model->nw, k * h, w, motion->w);
        lag_delays_displace(&motion->delays, w + motion->places.delay, k * h);
        status = evaluate(run, t, x, y != NULL, s->differences.value[0][0]);
        lag_delays_displace(&motion->delays, NULL, 0.0);
        lag_axpy(height, (k > 0 ? lag_sixth[k - 1] : -lag_sixth[-k - 1]) / h, s->differences.value[0][0], sum);
        memcpy(motion->w, s->work.w, model->nw * sizeof(double));
    }
    for (size_t i = 0; i < height; ++i) {
        double *to = i < n ? rates + i * lanes : y + (i - n) * lanes;
        to[lane] += sum[i];
    }
    return status;
}

/* ---- by the derivatives of the motion ---- */

/* The state of the motion for the functions of `along`, prepared for its parameters. */
static lag_arguments here(const lag_along *along, int *prepared, const lag_motion *motion)
{
    lag_arguments at = motion->at;
    at.context = along->model->context;
    at.workspace = along->workspace;
    at.kept = NULL;
    if (!*prepared) {
        *prepared = along->model->prepare(&at) == LAG_OK;
    }
    return at;
}

/* Finds them at the present state. LAG_MISSING: there are none. */
static lag_status evaluate_derivatives(lag_sensitivities *s, lag_motion *motion)
{
    const lag_along *along = &s->along.motion;
    lag_motion_derivatives *found = &s->work.motion;
    double pivot = 0.0;
    if (along->tangents == NULL || along->tangents->jacobian == NULL) {
        return LAG_MISSING;
    }
    if (!s->along.prepared[2]) {
        found->at = here(along, &s->along.prepared[2], motion);
        found->at.kept = &found->kept;
    }
    found->at.t = motion->at.t;
    found->at.q = motion->at.q;
    found->at.qd = motion->at.qd;
    found->at.z = motion->at.z;
    found->at.u = motion->at.u;
    found->at.w = motion->at.w;
    found->at.p = motion->at.p;
    const lag_status status = along->tangents->jacobian(
        &found->at, found->qdd, found->lam, &pivot, found->response, found->by_state, found->by_parameter);
    return status == LAG_OK && !(pivot > lag_smallest_pivot(motion->model)) ? LAG_MISSING : status;
}

/* df/dx (n, n) where they are found. */
static void find_jacobian(const lag_motion_derivatives *found, const lag_ode *ode, double *jacobian)
{
    const lag_rows_of_columns *by_state = &found->product.by_state;
    for (size_t i = 0; i < lag_radau_others(ode); ++i) {
        for (size_t column = 0; column < ode->size; ++column) {
            const double *along = by_state->first + column;
            double sum = 0.0;
            for (size_t j = 0; j < by_state->height; ++j) {
                sum += found->response[i * by_state->height + j] * along[j * by_state->apart];
            }
            jacobian[(ode->nq + i) * ode->size + column] = sum;
        }
    }
}

/* df/dx (n, n), without the rows of coordinates, into rows (others, width). */
static void take_rows(const lag_ode *ode, const double *jacobian, size_t width, double *rows)
{
    lag_fill(lag_radau_others(ode) * width, 0.0, rows);
    for (size_t i = 0; i < lag_radau_others(ode); ++i) {
        memcpy(rows + i * width, jacobian + (ode->nq + i) * ode->size, ode->size * sizeof(double));
    }
}

/* For stage equations that are decomposed, of stage i. */
static lag_status jacobian_to_decompose(lag_sensitivities *s, lag_run *run, double t, const double *x, size_t i, int known)
{
    const lag_stage_equations *equations = &s->work.collocation.equations;
    const lag_ode *ode = run->stepper.ode;
    double *rows = equations->jacobian + i * lag_radau_others(ode) * equations->width;
    if (known) {
        const lag_motion_derivatives *found = &s->work.motion;
        s->sums->multiply(&found->product.response, equations->width, found->by_state, NULL, rows);
        return LAG_OK;
    }
    const lag_status status = ode->jacobian(ode->context, t, x, s->work.collocation.jacobian);
    if (status == LAG_OK) {
        take_rows(ode, s->work.collocation.jacobian, equations->width, rows);
    }
    return status;
}

lag_status lag_columns_jacobian(lag_sensitivities *s, lag_run *run, double t, const double *x, size_t i)
{
    const lag_ode *ode = run->stepper.ode;
    const int written = s->along.motion.tangents != NULL && s->along.motion.tangents->jacobian != NULL;
    const int decomposed = s->work.collocation.equations.matrix != NULL;
    double *entries = s->work.collocation.jacobian + (decomposed ? 0 : i * lag_radau_entries(ode));
    lag_status status = written ? lag_columns_set_state(s, run, t, x, 0) : LAG_OK;
    const int known = status == LAG_OK && s->work.motion.known;
    if (status != LAG_OK) {
        return status;
    }
    if (decomposed) {
        status = jacobian_to_decompose(s, run, t, x, i, known);
    } else if (known && !lag_radau_is_sparse(ode)) {
        find_jacobian(&s->work.motion, ode, entries);
    } else {
        status = lag_radau_jacobian(ode, t, x, entries);
    }
    return status == LAG_OK && !known ? lag_columns_set_state(s, run, t, x, 0) : status;
}

/* ---- by functions of several directions ---- */

/* True if the Jacobian by the state and the inputs serves all columns: there are more of these. */
static int takes_jacobian(const lag_sensitivities *s, const lag_model *model)
{
    return s->along.states.tangents != NULL && lag_motion_size(model) + model->nu <= s->of.count;
}

/* Rates along q, qd, z and u. */
static lag_status along_states(lag_sensitivities *s, lag_motion *motion, size_t block, const double *directions, double *rates, double *y)
{
    const lag_model *model = motion->model;
    const size_t n = lag_motion_size(model);
    const size_t lanes = lag_columns_lanes(s, block);
    const lag_column_sums *sums = lag_columns_sums(s, block);
    if (takes_jacobian(s, model)) {
        const lag_rows_of_columns by_state = {n, n + model->nu, n + model->nu, s->work.by_state};
        const lag_rows_of_columns outputs = {y != NULL ? model->ny : 0, n + model->nu, n + model->nu, s->work.outputs_by_state};
        sums->multiply(&by_state, lanes, directions, NULL, rates);
        sums->multiply(&outputs, lanes, directions, NULL, y);
        return LAG_OK;
    }
    const lag_along *along = &s->along.states;
    const lag_arguments at = here(along, &s->along.prepared[0], motion);
    return lag_jacobian_along(along->model, along->tangents, &at, lanes, directions, along->memory, rates, y, &motion->coordinate);
}

/* Rates along the parameters of all columns that have some. */
static lag_status evaluate_along_parameters(lag_sensitivities *s, lag_motion *motion, int outputs)
{
    const lag_along *along = &s->along.parameters;
    if (s->columns.moving == 0) {
        return LAG_OK;
    }
    const lag_arguments at = here(along, &s->along.prepared[1], motion);
    return lag_jacobian_along(along->model, along->tangents, &at, s->columns.moving, s->columns.p, along->memory, s->work.by_parameter,
        outputs ? s->work.outputs_by_parameter : NULL, &motion->coordinate);
}

/* Adds them to those of a block. */
static void add_parameters(const lag_sensitivities *s, const lag_model *model, size_t block, double *rates, double *y)
{
    const size_t n = lag_motion_size(model);
    const size_t lanes = lag_columns_lanes(s, block);
    const size_t moving = s->columns.moving;
    for (size_t k = 0; k < moving; ++k) {
        const size_t column = (size_t)s->columns.of_parameters[k];
        const size_t lane = column % s->columns.lanes;
        if (column / s->columns.lanes != block) {
            continue;
        }
        for (size_t i = 0; i < n; ++i) {
            rates[i * lanes + lane] += s->work.by_parameter[i * moving + k];
        }
        for (size_t i = 0; i < model->ny && y != NULL; ++i) {
            y[i * lanes + lane] += s->work.outputs_by_parameter[i * moving + k];
        }
    }
}

/* ---- all ---- */

lag_status lag_columns_set_state(lag_sensitivities *s, lag_run *run, double t, const double *x, int outputs)
{
    lag_motion *motion = &run->motion;
    const lag_model *model = motion->model;
    lag_columns_set_delays(s, run, t);
    if (model->nload > 0) { /* derivatives at fixed loads are not those of the motion */
        return lag_loads_along_set_state(&s->work.loads, motion, t, x);
    }
    lag_motion_set_state(motion, t, x);
    lag_status status = outputs ? LAG_MISSING : evaluate_derivatives(s, motion);
    s->work.motion.known = status == LAG_OK;
    if (status != LAG_MISSING) {
        return status;
    }
    status = s->along.states.tangents != NULL ? evaluate_along_parameters(s, motion, outputs) : LAG_OK;
    if (status != LAG_OK || !takes_jacobian(s, model)) {
        return status;
    }
    const lag_along *along = &s->along.states;
    const lag_arguments at = here(along, &s->along.prepared[0], motion);
    const lag_range variables = {0, lag_motion_size(model) + model->nu};
    return lag_jacobian(along->model, along->tangents, &at, variables, along->memory, s->work.by_state, outputs ? s->work.outputs_by_state : NULL,
        &motion->coordinate);
}

/* Rates in models with loads. */
static lag_status with_loads(lag_sensitivities *s, const lag_motion *motion, size_t lanes, const double *directions, double *rates, double *y)
{
    const lag_model *model = motion->model;
    const size_t n = lag_motion_size(model);
    double *found = s->work.one_rates;
    lag_status status = LAG_OK;
    for (size_t lane = 0; lane < lanes && status == LAG_OK; ++lane) {
        lag_lane_get(lanes, lane, lag_columns_variables(model), directions, s->work.one);
        status = lag_loads_along_rates(&s->work.loads, motion, s->work.one, found, y != NULL ? found + n : NULL);
        lag_lane_put(lanes, lane, n, found, rates);
        lag_lane_put(lanes, lane, y != NULL ? model->ny : 0, found + n, y);
    }
    return status;
}

lag_status lag_columns_rates(lag_sensitivities *s, lag_run *run, size_t block, double t, const double *x, const double *directions,
    double *rates, double *y)
{
    lag_motion *motion = &run->motion;
    const lag_model *model = motion->model;
    const size_t lanes = lag_columns_lanes(s, block);
    double *w = s->work.one + lag_columns_variables(model);
    lag_status status = LAG_OK;
    if (model->nload > 0) {
        status = with_loads(s, motion, lanes, directions, rates, y);
    } else if (s->work.motion.known) {
        const double *inputs = directions + lag_motion_size(model) * lanes;
        lag_columns_sums(s, block)->rates(&s->work.motion.product, &s->columns.entries, block, lanes, directions, inputs, rates);
    } else if (s->along.states.tangents != NULL) {
        status = along_states(s, motion, block, directions, rates, y);
        add_parameters(s, model, block, rates, y);
    } else {
        status = lag_jacobian_along(model, NULL, &motion->at, lanes, directions, motion->memory, rates, y, &motion->coordinate);
    }
    for (size_t lane = 0; lane < lanes && status == LAG_OK && model->nw > 0; ++lane) {
        lag_columns_get(s, block * s->columns.lanes + lane, 0, model->nw, s->columns.w, model->nw, w);
        if (lag_any(model->nw, w)) {
            status = add_discretes(s, run, lanes, lane, t, x, rates, y);
            lag_motion_set_state(motion, t, x);
        }
    }
    return status;
}
