/* Rates of a start in a singular position. */
#include <math.h>
#include <string.h>

#include "lag/equations/entries.h"
#include "lag/initial/initial_rates.h"
#include "lag/linalg/arena.h"
#include "lag/linalg/vector.h"

/* The next row of a part from place *k on that acts; nc: there is none. */
static size_t next_acting(const lag_rates *r, size_t which, size_t *k)
{
    const size_t m = r->b->motion->model->nc;
    size_t first = 0;
    const size_t rows = lag_parts_rows(&r->parts, which, &first);
    while (*k < rows) {
        const size_t row = (size_t)r->parts.row[first + (*k)++];
        if (row < m && r->branch.acts[row] != 0.0) {
            return row;
        }
    }
    return m;
}

/* gamma of all rows at rates v: with no accelerations it is what the rows lack. */
static lag_status find_gamma(lag_rates *r, const double *v)
{
    lag_initialization *b = r->b;
    const size_t n = b->motion->model->nq;
    lag_arguments at = b->motion->at;
    for (size_t j = 0; j < n; ++j) {
        b->qd[j] = v[j] * b->sizes[j];
    }
    at.qdd = b->still;
    at.lam = b->still + n;
    const lag_status status = b->motion->model->residual(&at, r->force, r->branch.gamma);
    for (size_t i = 0; i < b->motion->model->nc; ++i) {
        r->branch.gamma[i] = status == LAG_OK ? -r->branch.gamma[i] / b->row_sizes[i] : (double)NAN;
    }
    return status;
}

/* n' gamma at rates v + along' y for every combination n of rows that vanishes: zero along a branch of the motion. */
static void bias(lag_rates *r, const double *y, double *result)
{
    const lag_directions *along = r->branch.along;
    memcpy(r->part, r->v, r->b->motion->model->nq * sizeof(double));
    for (size_t i = 0; i < along->count; ++i) {
        lag_rates_move(r, along, i, y[i], r->part);
    }
    const int exists = find_gamma(r, r->part) == LAG_OK;
    for (size_t i = 0; i < r->branch.lost; ++i) {
        const double *numbers = r->branch.numbers + (size_t)r->branch.first[i];
        const size_t which = (size_t)r->branch.part[i];
        size_t place = 0;
        size_t row = next_acting(r, which, &place);
        result[i] = exists ? 0.0 : (double)NAN;
        for (size_t k = 0; exists && row < r->b->motion->model->nc; ++k) {
            result[i] += numbers[k] * r->branch.gamma[row];
            row = next_acting(r, which, &place);
        }
    }
}

/* bias() where direction k of every part has moved from y. */
static void bias_beside(lag_rates *r, const lag_parts *parts, const double *y, size_t k, double by, double *result)
{
    memcpy(r->branch.moved, y, parts->n * sizeof(double));
    for (size_t which = 0; which < parts->count; ++which) {
        size_t first = 0;
        if (k < lag_parts_columns(parts, which, &first)) {
            r->branch.moved[(size_t)parts->column[first + k]] += by;
        }
    }
    bias(r, r->branch.moved, result);
}

/* Adds column k of every part's block, by these residuals. */
static void add_column(const lag_parts *parts, size_t k, double by, const double *residual, double *jacobian)
{
    for (size_t which = 0; which < parts->count; ++which) {
        size_t row = 0;
        size_t column = 0;
        const size_t rows = lag_parts_rows(parts, which, &row);
        const size_t columns = lag_parts_columns(parts, which, &column);
        double *block = lag_parts_block(parts, which, jacobian);
        for (size_t i = 0; i < rows && k < columns; ++i) {
            block[i * columns + k] += residual[(size_t)parts->row[row + i]] / by;
        }
    }
}

static void at_branches(void *context, const lag_parts *parts, const double *y, double *residual, double *jacobian)
{
    lag_rates *r = context;
    size_t widest = 0;
    size_t first = 0;
    for (size_t which = 0; which < parts->count; ++which) {
        widest = lag_larger(widest, lag_parts_columns(parts, which, &first));
    }
    lag_fill(lag_parts_entries(parts), 0.0, jacobian);
    for (size_t k = 0; k < widest; ++k) {
        bias_beside(r, parts, y, k, -LAG_DIFFERENCE, residual);
        add_column(parts, k, -2.0 * LAG_DIFFERENCE, residual, jacobian);
        bias_beside(r, parts, y, k, LAG_DIFFERENCE, residual);
        add_column(parts, k, 2.0 * LAG_DIFFERENCE, residual, jacobian);
    }
    bias(r, y, residual);
}

/* True if gamma of a part depends on its own rates only: that of a row for velocities may know all coordinates. */
static int is_closed(const lag_rates *r, size_t which)
{
    const lag_model *model = r->b->motion->model;
    size_t place = 0;
    size_t row = next_acting(r, which, &place);
    while (row < model->nc && model->position_level[row]) {
        row = next_acting(r, which, &place);
    }
    return row == model->nc;
}

/* Combinations that vanish, with the directions on which they depend. */
static lag_parts find_parts(const lag_rates *r, double *memory)
{
    const lag_directions *along = r->branch.along;
    lag_parts parts = lag_parts_begin(r->branch.lost, along->count, memory);
    for (size_t i = 0; i < r->branch.lost; ++i) {
        const int closed = is_closed(r, (size_t)r->branch.part[i]);
        for (size_t k = 0; k < along->count; ++k) {
            if (!closed || along->part[k] == r->branch.part[i]) {
                lag_parts_join(&parts, i, k);
            }
        }
    }
    lag_parts_end(&parts);
    return parts;
}

static int descend_along(lag_rates *r, const lag_directions *along)
{
    const size_t n = r->b->motion->model->nq;
    const size_t m = r->b->motion->model->nc;
    double *memory = r->branch.minimizer;
    const lag_equations equations = {at_branches, r};
    lag_levenberg_marquardt minimizer;
    r->branch.along = along;
    const lag_parts parts = find_parts(r, lag_take(&memory, lag_parts_memory(m, n)));
    lag_levenberg_marquardt_place(&minimizer, &parts, memory);
    lag_fill(along->count, 0.0, r->change);
    lag_descend(&minimizer, &equations, &parts, LAG_EXACT, LAG_DESCENTS, r->change);
    if (!(lag_levenberg_marquardt_size(&minimizer, &parts) <= LAG_HOLDS * fmax(1.0, lag_dot(n, r->v, r->v)))) {
        return 0;
    }
    for (size_t i = 0; i < along->count; ++i) {
        lag_rates_move(r, along, i, r->change[i], r->v);
    }
    return 1;
}

/* Rows that act: those of open contacts and of friction that slides are zero, and say nothing of branches. Returns so many. */
static size_t find_acting(lag_rates *r)
{
    const lag_initialization *b = r->b;
    const lag_model *model = b->motion->model;
    double *acts = r->branch.acts;
    size_t count = 0;
    lag_fill(model->nc, 1.0, acts);
    for (size_t i = 0; i < model->ncontact; ++i) {
        acts[model->contact_rows[i]] = 0.0;
    }
    for (size_t i = 0; i < model->nslip; ++i) {
        acts[model->friction_rows[i]] = 0.0;
    }
    for (size_t i = 0; i < model->nc; ++i) {
        const lag_entries entries = lag_entries_of(model, i);
        for (size_t k = entries.first; k < entries.end && acts[i] == 0.0; ++k) {
            acts[i] = b->jacobian[i * model->nq + lag_entry_column(&entries, k)] != 0.0;
        }
        count += acts[i] != 0.0;
    }
    return count;
}

/* Combinations of rows of a part that vanish, behind others; returns how many rows are independent. */
static size_t find_vanishing(lag_rates *r, size_t which, size_t *end)
{
    const lag_model *model = r->b->motion->model;
    size_t first = 0;
    size_t place = 0;
    size_t count = 0;
    const size_t columns = lag_parts_columns(&r->parts, which, &first);
    for (size_t row = next_acting(r, which, &place); row < model->nc; row = next_acting(r, which, &place)) {
        lag_fill(columns, 0.0, r->its.block + count * columns);
        lag_rates_row(r, row, r->its.block + count++ * columns);
    }
    for (size_t i = 0; i < count; ++i) {
        for (size_t j = 0; j < columns; ++j) {
            r->branch.turned[j * count + i] = r->its.block[i * columns + j];
        }
    }
    size_t rank = 0;
    if (columns == 0 && count > 0) { /* a row alone */
        r->branch.numbers[*end] = 1.0;
    } else if (count > 0) {
        const lag_svd svd = lag_svd_of(columns, count, r->branch.turned, r->svd);
        rank = lag_svd_rank(&svd, lag_initialization_least(&svd, LAG_ROUGH_RANK));
        memcpy(r->branch.numbers + *end, svd.v + rank * count, (count - rank) * count * sizeof(double));
    }
    for (size_t i = rank; i < count; ++i, *end += count) {
        r->branch.part[r->branch.lost] = (double)which;
        r->branch.first[r->branch.lost++] = (double)*end;
    }
    return rank;
}

void lag_initialization_branch(lag_rates *r)
{
    const size_t acting = find_acting(r);
    size_t rank = 0;
    size_t end = 0;
    for (size_t which = 0; which < r->parts.count; ++which) {
        rank += find_vanishing(r, which, &end);
    }
    if (rank >= r->b->motion->model->rank || rank == acting) {
        return;
    }
    if (!descend_along(r, &r->free)) {
        (void)descend_along(r, &r->unbound);
    }
}
