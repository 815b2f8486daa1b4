#include "lag/equations/projection.h"

#include <math.h>

#include "lag/dynamics.h"
#include "lag/linalg/arena.h"
#include "lag/linalg/finite.h"
#include "lag/linalg/vector.h"

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
