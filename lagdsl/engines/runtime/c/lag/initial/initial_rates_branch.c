/* Rates of a start in a singular position. */
#include <math.h>
#include <string.h>

#include "lag/initial/initial_rates.h"
#include "lag/linalg/arena.h"
#include "lag/linalg/svd.h"
#include "lag/linalg/vector.h"

/* n' gamma at rates v + along' y for every combination n of rows that vanishes: zero along a branch of the motion. */
static void bias(lag_rates *r, const double *y, size_t moved, double by, double *result)
{
    lag_initialization *b = r->b;
    const lag_model *model = b->motion->model;
    const size_t n = model->nq;
    memcpy(r->part, r->v, n * sizeof(double));
    for (size_t i = 0; i < r->branch.width; ++i) {
        lag_axpy(n, y[i] + (i == moved ? by : 0.0), r->branch.along + i * n, r->part);
    }
    for (size_t j = 0; j < n; ++j) {
        b->qd[j] = r->part[j] * b->sizes[j];
    }
    const lag_status status = model->dynamics(&b->motion->at, r->inner, r->force, r->branch.turned, r->branch.gamma);
    for (size_t i = 0; i < r->branch.lost; ++i) {
        result[i] = status == LAG_OK ? 0.0 : (double)NAN;
        for (size_t k = 0; k < r->branch.acting; ++k) {
            const size_t row = (size_t)r->branch.act[k];
            result[i] += r->branch.vanishing[i * r->branch.acting + k] * r->branch.gamma[row] / b->row_sizes[row];
        }
    }
}

/* All is one part. */
static void at_branches(void *context, const lag_parts *parts, const double *y, double *residual, double *jacobian)
{
    lag_rates *r = context;
    (void)parts;
    for (size_t k = 0; k < r->branch.width; ++k) {
        bias(r, y, k, -LAG_DIFFERENCE, residual);
        for (size_t i = 0; i < r->branch.lost; ++i) {
            jacobian[i * r->branch.width + k] = -residual[i];
        }
        bias(r, y, k, LAG_DIFFERENCE, residual);
        for (size_t i = 0; i < r->branch.lost; ++i) {
            jacobian[i * r->branch.width + k] = (jacobian[i * r->branch.width + k] + residual[i]) / (2.0 * LAG_DIFFERENCE);
        }
    }
    bias(r, y, r->branch.width, 0.0, residual);
}

static int descend_along(lag_rates *r, const double *along, size_t width)
{
    const size_t n = r->b->motion->model->nq;
    const size_t m = r->b->motion->model->nc;
    double *memory = r->branch.minimizer;
    const lag_equations equations = {at_branches, r};
    lag_levenberg_marquardt minimizer;
    r->branch.along = along;
    r->branch.width = width;
    const lag_parts parts = lag_parts_of(r->branch.lost, width, NULL, lag_take(&memory, lag_parts_memory(m, n)));
    lag_levenberg_marquardt_place(&minimizer, &parts, memory);
    lag_fill(width, 0.0, r->change);
    lag_descend(&minimizer, &equations, &parts, LAG_EXACT, LAG_DESCENTS, r->change);
    if (!(lag_levenberg_marquardt_size(&minimizer, &parts) <= LAG_HOLDS * fmax(1.0, lag_dot(n, r->v, r->v)))) {
        return 0;
    }
    for (size_t i = 0; i < width; ++i) {
        lag_axpy(n, r->change[i], along + i * n, r->v);
    }
    return 1;
}

/* Rows that act: those of open contacts and of friction that slides are zero, and say nothing of branches. */
static void find_acting(lag_rates *r)
{
    const lag_model *model = r->b->motion->model;
    double *lasts = r->branch.act; /* read ahead of what is written */
    lag_fill(model->nc, 1.0, lasts);
    for (size_t i = 0; i < model->ncontact; ++i) {
        lasts[model->contact_rows[i]] = 0.0;
    }
    for (size_t i = 0; i < model->nslip; ++i) {
        lasts[model->friction_rows[i]] = 0.0;
    }
    r->branch.acting = 0;
    for (size_t i = 0; i < model->nc; ++i) {
        if (lasts[i] != 0.0 || lag_any(model->nq, r->rows + i * model->nq)) {
            r->branch.act[r->branch.acting++] = (double)i;
        }
    }
}

void lag_initialization_branch(lag_rates *r)
{
    const lag_model *model = r->b->motion->model;
    const size_t n = model->nq;
    find_acting(r);
    const size_t m = r->branch.acting;
    for (size_t i = 0; i < m; ++i) {
        for (size_t j = 0; j < n; ++j) {
            r->branch.turned[j * m + i] = r->rows[(size_t)r->branch.act[i] * n + j];
        }
    }
    const lag_svd svd = lag_svd_of(n, m, r->branch.turned, r->svd);
    const size_t rank = lag_svd_rank(&svd, LAG_ROUGH_RANK);
    if (rank >= model->rank || rank == m) {
        return;
    }
    r->branch.lost = m - rank;
    memcpy(r->branch.vanishing, svd.v + rank * m, r->branch.lost * m * sizeof(double));
    if (!descend_along(r, r->free, r->width)) {
        (void)descend_along(r, r->unbound, r->unbound_width);
    }
}
