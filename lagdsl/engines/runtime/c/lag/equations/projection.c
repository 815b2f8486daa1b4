#include "lag/equations/projection.h"

#include <math.h>
#include <string.h>

#include "lag/equations/blocks.h"
#include "lag/equations/entries.h"
#include "lag/linalg/arena.h"
#include "lag/linalg/linalg.h"
#include "lag/linalg/vector.h"

/* So much larger than its limit a residual may stay where round-off or a singular position stops the convergence. */
static const double CLOSE = 1e3;

static size_t position_rows(const lag_model *model)
{
    size_t rows = 0;
    for (size_t i = 0; i < model->nc; ++i) {
        rows += model->position_level[i] != 0;
    }
    return rows;
}

size_t lag_projection_memory(const lag_model *model)
{
    const size_t n = model->nq;
    const size_t m = model->nc;
    return 6 * m + 5 * n + model->nz + 2 * m * n + n * n + lag_correction_memory(model) +
           lag_larger(lag_system_memory(n, m), lag_blocks_memory(model));
}

/* All belong together where nobody tells what the rows hold. */
size_t lag_component_of(const lag_model *model, size_t coordinate)
{
    return model->components != NULL && lag_jacobian_pattern(model) != NULL ? model->components[coordinate] : 0;
}

/* Rows hold coordinates of one component; those that hold none may count to any. */
static void find_components(lag_projection *projection)
{
    const lag_model *model = projection->motion->model;
    const lag_pattern *entries = lag_jacobian_pattern(model);
    lag_fill(model->nc, 0.0, projection->component);
    for (size_t k = 0; entries != NULL && k < entries->count; ++k) {
        projection->component[entries->row[k]] = (double)lag_component_of(model, entries->column[k]);
    }
}

static void clear_largest(lag_projection *projection, double value)
{
    const lag_model *model = projection->motion->model;
    lag_fill(model->nq + model->nz, value, projection->largest);
}

static void enlarge(lag_projection *projection, size_t component, double value)
{
    projection->largest[component] = fmax(projection->largest[component], value);
}

static double largest_beside(const lag_projection *projection, size_t row)
{
    return projection->largest[(size_t)projection->component[row]];
}

void lag_projection_place(lag_projection *projection, lag_motion *motion, double *memory)
{
    const size_t n = motion->model->nq;
    const size_t m = motion->model->nc;
    memset(projection, 0, sizeof *projection);
    projection->motion = motion;
    projection->rows = position_rows(motion->model);
    projection->lost = m;
    projection->iterations = 12;
    projection->limits = memory;
    projection->round_off = projection->limits + m;
    projection->least = projection->limits;
    projection->sizes = projection->round_off + m;
    projection->phi = projection->sizes + n;
    projection->jacobian = motion->written.rows[1];
    projection->step.mass = projection->phi + m;
    projection->step.chosen = projection->step.mass + n * n;
    projection->step.right = projection->step.chosen + m * n;
    projection->step.force = projection->step.right + m;
    projection->step.change = projection->step.force + n;
    projection->step.lam = projection->step.change + n;
    projection->step.response = projection->step.lam + m;
    projection->point = projection->step.response + m * n;
    projection->component = projection->point + n;
    projection->largest = projection->component + m;
    projection->step.correction = projection->largest + n + motion->model->nz;
    projection->step.system = projection->step.correction + lag_correction_memory(motion->model);
    lag_fill(n, 1.0, projection->sizes);
    lag_fill(n, 0.0, projection->step.force);
    lag_fill(2 * m, 0.0, projection->limits); /* and round-off, which lies behind */
    find_components(projection);
}

void lag_projection_limits(lag_projection *projection, double tolerance, const double *row_sizes)
{
    for (size_t i = 0; i < projection->motion->model->nc; ++i) {
        projection->round_off[i] = LAG_ROUNDING * row_sizes[i];
        projection->limits[i] = fmax(tolerance * fmin(row_sizes[i], 1.0), projection->round_off[i]);
    }
}

lag_status lag_projection_evaluate(lag_projection *projection, int velocities)
{
    lag_motion *motion = projection->motion;
    const lag_model *model = motion->model;
    projection->jacobian = motion->written.rows[velocities];
    projection->step.factored = 0;
    return (velocities ? model->velocity_constraint : model->position_constraint)(&motion->at, projection->phi, projection->jacobian);
}

/* The largest residual among rows of position level, in limits. Not a number stays none. */
static double largest(const lag_projection *projection)
{
    const lag_model *model = projection->motion->model;
    double most = 0.0;
    for (size_t i = 0; i < model->nc; ++i) {
        const double part = fabs(projection->phi[i]) / projection->least[i];
        if (model->position_level[i] && !(part <= most)) {
            most = part;
        }
    }
    return most;
}

/* Newton's method from x; the result is in `point`. */
static lag_status positions(lag_projection *projection, double t, const double *x, int *moved)
{
    lag_motion *motion = projection->motion;
    const size_t n = motion->model->nq;
    double before = (double)INFINITY;
    memcpy(projection->point, x, n * sizeof(double));
    lag_motion_set_state(motion, t, x);
    motion->at.q = projection->point;
    projection->step.formed = 0;
    for (unsigned k = 0; k < projection->iterations && projection->rows > 0; ++k) {
        const lag_status status = lag_projection_evaluate(projection, 0);
        const double size = largest(projection);
        if (status != LAG_OK || !(size < (double)INFINITY) || size > CLOSE * before) {
            return LAG_PROJECTION_FAILED;
        }
        if (size <= 1.0) {
            return LAG_OK;
        }
        before = size;
        if (lag_projection_smallest(projection, 0) != LAG_OK) {
            return LAG_PROJECTION_FAILED;
        }
        *moved = 1;
        lag_axpy(n, 1.0, projection->step.change, projection->point);
    }
    return projection->rows == 0 || before <= CLOSE ? LAG_OK : LAG_PROJECTION_FAILED;
}

void lag_projection_measure(lag_projection *projection, const double *rates)
{
    const lag_model *model = projection->motion->model;
    clear_largest(projection, 1.0);
    for (size_t i = 0; i < model->nq; ++i) {
        enlarge(projection, lag_component_of(model, i), fabs(rates[i]) / projection->sizes[i]);
    }
}

double lag_projection_pace(const lag_projection *projection, size_t row)
{
    return largest_beside(projection, row);
}

/* The largest residual of the rates in limits, which grow with the rates of the row's component. Not a number stays none. */
static double largest_of_rates(lag_projection *projection, const double *rates)
{
    const lag_model *model = projection->motion->model;
    double most = 0.0;
    lag_projection_measure(projection, rates);
    for (size_t i = 0; i < model->nc; ++i) {
        const double part = fabs(projection->phi[i]) / (projection->least[i] * largest_beside(projection, i));
        if (!(part <= most)) {
            most = part;
        }
    }
    return most;
}

/* True if the change satisfies the conditions on rates, also those left out of the solution as redundant or as round-off; `size` is as above. */
static int satisfies(lag_projection *projection, double size)
{
    const lag_model *model = projection->motion->model;
    for (size_t i = 0; i < model->nc; ++i) {
        const lag_entries entries = lag_entries_of(model, i);
        const double left = projection->phi[i] + lag_entries_dot(&entries, projection->jacobian + i * model->nq, projection->step.change);
        const double part = fabs(left) / (projection->least[i] * largest_beside(projection, i));
        if (!model->position_level[i] && !(part <= fmax(CLOSE, LAG_REACHED * size))) {
            projection->lost = i;
        }
    }
    return projection->lost == model->nc;
}

/* The rates at the positions `point`, into x. */
static lag_status velocities(lag_projection *projection, double *x, int *moved)
{
    lag_motion *motion = projection->motion;
    const size_t n = motion->model->nq;
    const lag_status status = lag_projection_evaluate(projection, 1);
    const double size = status == LAG_OK ? largest_of_rates(projection, x + n) : (double)INFINITY;
    if (!(size < (double)INFINITY)) {
        return LAG_PROJECTION_FAILED;
    }
    if (size <= 1.0) {
        return LAG_OK;
    }
    projection->step.formed = 0;
    if (lag_projection_smallest(projection, 1) != LAG_OK || !satisfies(projection, size)) {
        return LAG_PROJECTION_FAILED;
    }
    *moved = 1;
    lag_axpy(n, 1.0, projection->step.change, x + n);
    return LAG_OK;
}

lag_status lag_projection_apply(lag_projection *projection, double t, double *x, int *moved)
{
    const lag_model *model = projection->motion->model;
    *moved = 0;
    projection->lost = model->nc;
    if (model->nc == 0) {
        return LAG_OK;
    }
    const lag_status status =
        positions(projection, t, x, moved) == LAG_OK ? velocities(projection, x, moved) : LAG_PROJECTION_FAILED;
    if (status == LAG_OK && *moved) {
        memcpy(x, projection->point, model->nq * sizeof(double));
        ++projection->count;
    }
    return status;
}

lag_status lag_projection_exact(lag_projection *projection, double t, double *x, int *moved)
{
    projection->least = projection->round_off;
    const lag_status status = lag_projection_apply(projection, t, x, moved);
    projection->least = projection->limits;
    return status;
}

/* Adds the change of the rates x that makes the residuals vanish, and leaves what is held. */
static lag_status change_rates(lag_projection *projection, const double *held, double *x)
{
    const lag_model *model = projection->motion->model;
    lag_blocks blocks = lag_blocks_of(model, projection->step.mass, projection->jacobian, projection->step.system);
    lag_status status = LAG_OK;
    for (size_t which = 0; which < model->nq && status == LAG_OK; ++which) {
        if (lag_blocks_take(&blocks, which)) {
            status = lag_blocks_solve(&blocks, projection->step.force, projection->phi, held, NULL);
            lag_blocks_scatter(&blocks, blocks.change, projection->step.change);
        }
    }
    lag_axpy(status == LAG_OK ? model->nq : 0, 1.0, projection->step.change, x + model->nq);
    return status;
}

lag_status lag_projection_rates(lag_projection *projection, double t, double *x, const double *held)
{
    lag_motion *motion = projection->motion;
    const lag_model *model = motion->model;
    if (model->nc == 0) {
        return LAG_OK;
    }
    lag_motion_set_state(motion, t, x);
    lag_status status = lag_projection_evaluate(projection, 1);
    if (status != LAG_OK || !lag_any(model->nc, projection->phi)) {
        return status;
    }
    if (held == NULL && lag_correction(model, &motion->at, projection->phi, projection->jacobian, projection->round_off,
                            projection->step.correction, projection->step.change) == LAG_OK) {
        lag_axpy(model->nq, 1.0, projection->step.change, x + model->nq);
        return LAG_OK;
    }
    status = model->mass_matrix(&motion->at, projection->step.mass);
    return status == LAG_OK ? change_rates(projection, held, x) : status;
}

double lag_projection_distance(lag_projection *projection, double t, const double *x, size_t row)
{
    lag_motion *motion = projection->motion;
    const double size = projection->round_off[row] > 0.0 ? projection->round_off[row] / LAG_ROUNDING : 1.0;
    lag_motion_set_state(motion, t, x);
    const lag_status status = lag_projection_evaluate(projection, 0);
    return status == LAG_OK ? fabs(projection->phi[row]) / size : (double)NAN;
}
