#include "lag/equations/projection.h"

#include <math.h>
#include <string.h>

#include "lag/dynamics.h"
#include "lag/linalg/arena.h"
#include "lag/linalg/finite.h"
#include "lag/linalg/vector.h"

static const double LIGHT = 1e-6;

size_t lag_correction_memory(const lag_model *model)
{
    const size_t n = model->nq;
    const size_t m = model->nc;
    const size_t kept = model->nk;
    return n + 3 * m + kept * (2 * n + m + 2) + lag_delassus_memory(m, kept);
}

/* Adds the effect of the multipliers of the rows left to run time. */
static lag_status add_kept(const lag_model *model, const lag_arguments *at, const double *residual, double *memory, double *change, double *lam)
{
    double pivot = 0.0;
    double *qdd = lag_take(&memory, model->nq);
    double *own = lag_take(&memory, model->nc);
    const lag_left_rows left = lag_left_rows_place(model, at->kept, &memory);
    double *right = lag_take(&memory, model->nk);
    lag_delassus system;
    lag_status status = model->elimination(at, qdd, own, left.response, left.lam_response, left.jacobian, left.gamma, &pivot);
    if (status == LAG_OK) {
        status = lag_factor_eliminated(model, left.response, left.lam_response, left.jacobian, pivot, memory, &system);
    }
    for (size_t i = 0; i < model->nk; ++i) {
        right[i] = -residual[model->kept_rows[i]];
    }
    if (status == LAG_OK) {
        lag_delassus_solve(&system, right, change, lam);
    }
    return status;
}

/* Residuals that are left after the change, into `left` (nc). */
static void find_left(const lag_model *model, const double *residual, const double *jacobian, const double *change, double *left)
{
    const lag_pattern *entries = lag_jacobian_pattern(model);
    for (size_t i = 0; i < model->nc; ++i) {
        left[i] = residual[i] + (entries == NULL ? lag_dot(model->nq, jacobian + i * model->nq, change) : 0.0);
    }
    for (size_t k = 0; entries != NULL && k < entries->count; ++k) {
        left[entries->row[k]] += jacobian[entries->row[k] * model->nq + entries->column[k]] * change[entries->column[k]];
    }
}

/* True if the residuals vanish, except those of rows that follow from others. */
static int takes_away(const lag_model *model, const double *residual, const double *left, const double *sizes)
{
    double largest = 0.0;
    double most = 0.0;
    for (size_t i = 0; i < model->nc; ++i) {
        const double size = sizes[i] > 0.0 ? sizes[i] : 1.0;
        largest = fmax(largest, fabs(residual[i]) / size);
        if (!(model->redundant != NULL && model->redundant[i])) {
            most = fmax(most, fabs(left[i]) / size);
        }
    }
    return most <= LAG_REACHED * largest;
}

lag_status lag_correction(const lag_model *model, const lag_arguments *at, const double *residual, const double *jacobian,
    const double *sizes, double *memory, double *change)
{
    lag_arguments here = *at;
    double pivot = 0.0;
    if (model->correction == NULL || model->elimination == NULL) {
        return LAG_MISSING;
    }
    double *lam = lag_take(&memory, model->nc);
    double *left = lag_take(&memory, model->nc);
    here.lam = residual;
    lag_status status = model->correction(&here, change, lam, &pivot);
    if (status == LAG_OK && !(pivot > lag_smallest_pivot(model))) {
        status = LAG_MISSING;
    }
    if (status == LAG_OK && model->nk > 0) {
        status = add_kept(model, at, residual, memory, change, lam);
    }
    if (status != LAG_OK || !lag_finite(model->nq, change)) {
        return LAG_MISSING;
    }
    find_left(model, residual, jacobian, change, left);
    return takes_away(model, residual, left, sizes) ? LAG_OK : LAG_MISSING;
}

/* ---- by the dense system ---- */

/* A little inertia for what has none, as a part of the largest there is in its component, all in natural sizes. */
static void fill_mass(lag_projection *projection)
{
    const lag_model *model = projection->motion->model;
    const size_t n = model->nq;
    const double *sizes = projection->sizes;
    lag_fill(model->nq + model->nz, 0.0, projection->largest);
    for (size_t i = 0; i < n; ++i) {
        double *most = projection->largest + lag_component_of(model, i);
        *most = fmax(*most, projection->step.mass[i * n + i] * sizes[i] * sizes[i]);
    }
    for (size_t i = 0; i < n; ++i) {
        const double scale = projection->largest[lag_component_of(model, i)];
        projection->step.mass[i * n + i] += (scale > 0.0 ? LIGHT * scale : 1.0) / (sizes[i] * sizes[i]);
    }
}

/* M where it was not formed for this projection. */
static lag_status form_mass(lag_projection *projection)
{
    if (projection->step.formed) {
        return LAG_OK;
    }
    projection->step.formed = 1;
    return projection->motion->model->mass_matrix(&projection->motion->at, projection->step.mass);
}

/* The system of all rows, or of those of position level. */
static lag_status factor_projection(lag_projection *projection, int every)
{
    const lag_model *model = projection->motion->model;
    lag_projection_step *step = &projection->step;
    const size_t n = model->nq;
    size_t rows = 0;
    if (form_mass(projection) != LAG_OK) {
        return LAG_PROJECTION_FAILED;
    }
    for (size_t i = 0; i < model->nc; ++i) {
        if (every || model->position_level[i]) {
            memcpy(step->chosen + rows++ * n, projection->jacobian + i * n, n * sizeof(double));
        }
    }
    lag_system_place(&step->solver, n, rows, model->components, step->system);
    const size_t most = rows < model->rank ? rows : model->rank;
    lag_status status = lag_system_factor(&step->solver, step->mass, step->chosen, most, NULL);
    if (status == LAG_SINGULAR) {
        fill_mass(projection);
        status = lag_system_factor(&step->solver, step->mass, step->chosen, most, NULL);
    }
    step->factored = status == LAG_OK;
    return status;
}

lag_status lag_projection_smallest(lag_projection *projection, int every)
{
    const lag_model *model = projection->motion->model;
    lag_projection_step *step = &projection->step;
    size_t rows = 0;
    if ((every || projection->rows == model->nc) &&
        lag_correction(model, &projection->motion->at, projection->phi, projection->jacobian, projection->round_off, step->correction, step->change) ==
            LAG_OK) {
        return LAG_OK;
    }
    const lag_status status = step->factored ? LAG_OK : factor_projection(projection, every);
    for (size_t i = 0; i < model->nc; ++i) {
        if (every || model->position_level[i]) {
            step->right[rows++] = -projection->phi[i];
        }
    }
    if (status == LAG_OK) {
        lag_system_solve(&step->solver, step->force, step->right, step->change, step->lam);
    }
    return status;
}

lag_status lag_projection_response(lag_projection *projection, int every)
{
    const lag_model *model = projection->motion->model;
    lag_projection_step *step = &projection->step;
    const size_t n = model->nq;
    size_t row = 0;
    if (model->correction != NULL) {
        return LAG_MISSING;
    }
    const lag_status status = step->factored ? LAG_OK : factor_projection(projection, every);
    lag_fill(model->nc * n, 0.0, step->response);
    lag_fill(model->nc, 0.0, step->right);
    for (size_t i = 0; i < model->nc && status == LAG_OK; ++i) {
        if (every || model->position_level[i]) {
            step->right[row] = -1.0;
            lag_system_solve(&step->solver, step->force, step->right, step->response + i * n, step->lam);
            step->right[row++] = 0.0;
        }
    }
    return status;
}
