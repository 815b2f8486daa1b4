#include "lag/optimization/levenberg_marquardt.h"

#include <math.h>
#include <string.h>

#include "lag/linalg/finite.h"
#include "lag/linalg/arena.h"
#include "lag/linalg/svd.h"

static const double SMALLEST_DAMPING = 1e-3;
static const double LARGEST_DAMPING = 1e8;

/* ---- parts ---- */

size_t lag_parts_memory(size_t m, size_t n)
{
    return 5 * (m + n) + 3;
}

/* Rows, then columns, as entries of `leader`, which leads to the first of its part. */
static size_t leader_of(double *leader, size_t x)
{
    while ((size_t)leader[x] != x) {
        leader[x] = leader[(size_t)leader[x]];
        x = (size_t)leader[x];
    }
    return x;
}

static void join_leaders(double *leader, size_t a, size_t b)
{
    a = leader_of(leader, a);
    b = leader_of(leader, b);
    leader[a > b ? a : b] = (double)(a < b ? a : b);
}

/* Sorts rows or columns by their part; keeps the order inside a part. */
static void order(size_t count, const double *part, size_t parts, double *ordered, double *first)
{
    for (size_t which = 0; which <= parts; ++which) {
        first[which] = 0.0;
    }
    for (size_t i = 0; i < count; ++i) {
        first[(size_t)part[i]] += 1.0;
    }
    for (size_t which = 0; which < parts; ++which) { /* where each ends; then, backwards, where it begins */
        first[which + 1] += first[which];
    }
    for (size_t i = count; i-- > 0;) {
        first[(size_t)part[i]] -= 1.0;
        ordered[(size_t)first[(size_t)part[i]]] = (double)i;
    }
}

void lag_parts_order(lag_parts *parts)
{
    order(parts->m, parts->row_part, parts->count, parts->row, parts->first_row);
    order(parts->n, parts->column_part, parts->count, parts->column, parts->first_column);
    parts->first_entry[0] = 0.0;
    for (size_t which = 0; which < parts->count; ++which) {
        size_t first = 0;
        const size_t entries = lag_parts_rows(parts, which, &first) * lag_parts_columns(parts, which, &first);
        parts->first_entry[which + 1] = parts->first_entry[which] + (double)entries;
    }
}

lag_parts lag_parts_begin(size_t m, size_t n, double *memory)
{
    lag_parts parts = {.m = m, .n = n};
    parts.row_part = lag_take(&memory, m);
    parts.column_part = lag_take(&memory, n);
    parts.row = lag_take(&memory, m);
    parts.column = lag_take(&memory, n);
    parts.first_row = lag_take(&memory, m + n + 1);
    parts.first_column = lag_take(&memory, m + n + 1);
    parts.first_entry = lag_take(&memory, m + n + 1);
    for (size_t i = 0; i < m + n; ++i) {
        parts.first_row[i] = (double)i;
    }
    return parts;
}

void lag_parts_join(lag_parts *parts, size_t row, size_t column)
{
    join_leaders(parts->first_row, row, parts->m + column);
}

void lag_parts_end(lag_parts *parts)
{
    double *leader = parts->first_row;
    double *name = parts->first_column;
    for (size_t i = 0; i < parts->m + parts->n; ++i) {
        const size_t its = leader_of(leader, i);
        name[i] = its == i ? (double)parts->count++ : name[its];
    }
    memcpy(parts->row_part, name, parts->m * sizeof(double));
    memcpy(parts->column_part, name + parts->m, parts->n * sizeof(double));
    lag_parts_order(parts);
}

lag_parts lag_parts_of(size_t m, size_t n, const double *pattern, double *memory)
{
    lag_parts parts = lag_parts_begin(m, n, memory);
    for (size_t i = 0; pattern == NULL && i < m + n; ++i) {
        parts.first_row[i] = 0.0;
    }
    for (size_t i = 0; pattern != NULL && i < m; ++i) {
        for (size_t j = 0; j < n; ++j) {
            if (pattern[i * n + j] != 0.0) {
                lag_parts_join(&parts, i, j);
            }
        }
    }
    lag_parts_end(&parts);
    return parts;
}

void lag_parts_mix(const lag_parts *parts, const double *chosen, const double *point, double *x)
{
    for (size_t j = 0; j < parts->n; ++j) {
        x[j] = chosen[(size_t)parts->column_part[j]] != 0.0 ? point[j] : x[j];
    }
}

int lag_parts_gather(const lag_parts *parts, size_t which, size_t width, const double *matrix, double *block)
{
    size_t row = 0;
    size_t column = 0;
    const size_t rows = lag_parts_rows(parts, which, &row);
    const size_t columns = lag_parts_columns(parts, which, &column);
    for (size_t i = 0; i < rows; ++i) {
        for (size_t j = 0; j < columns; ++j) {
            block[i * columns + j] = matrix[(size_t)parts->row[row + i] * width + (size_t)parts->column[column + j]];
        }
    }
    return lag_finite(rows * columns, block);
}

void lag_parts_norms(const lag_parts *parts, int of_rows, const double *x, double *norms)
{
    const double *part = of_rows ? parts->row_part : parts->column_part;
    const size_t count = of_rows ? parts->m : parts->n;
    lag_fill(parts->count, 0.0, norms);
    for (size_t i = 0; i < count; ++i) {
        norms[(size_t)part[i]] += x[i] * x[i];
    }
    for (size_t i = 0; i < parts->count; ++i) {
        norms[i] = isfinite(norms[i]) ? sqrt(norms[i]) : (double)INFINITY;
    }
}

/* ---- descent ---- */

size_t lag_levenberg_marquardt_memory(size_t m, size_t n)
{
    return 2 * m * n + 3 * m + 2 * n + 4 * (m + n) + lag_svd_memory(m, n);
}

void lag_levenberg_marquardt_place(lag_levenberg_marquardt *minimizer, const lag_parts *parts, double *memory)
{
    const size_t m = parts->m;
    const size_t n = parts->n;
    minimizer->residual = lag_take(&memory, m);
    minimizer->jacobian = lag_take(&memory, lag_parts_entries(parts));
    minimizer->sizes = lag_take(&memory, m + n);
    minimizer->other = lag_take(&memory, m);
    minimizer->others_jacobian = lag_take(&memory, lag_parts_entries(parts));
    minimizer->other_sizes = lag_take(&memory, m + n);
    minimizer->trial = lag_take(&memory, n);
    minimizer->damping = lag_take(&memory, m + n);
    minimizer->active = lag_take(&memory, m + n);
    minimizer->right = lag_take(&memory, m);
    minimizer->part = lag_take(&memory, n);
    minimizer->svd = memory;
}

/* Next trial point of the active parts; a part whose Jacobian is not finite becomes inactive. */
static void try_next(lag_levenberg_marquardt *d, const lag_parts *parts, const double *point)
{
    memcpy(d->trial, point, parts->n * sizeof(double));
    for (size_t which = 0; which < parts->count; ++which) {
        size_t row = 0;
        size_t column = 0;
        const size_t rows = lag_parts_rows(parts, which, &row);
        const size_t columns = lag_parts_columns(parts, which, &column);
        if (d->active[which] == 0.0) {
            continue;
        }
        const double *block = lag_parts_block(parts, which, d->jacobian);
        if (!lag_finite(rows * columns, block)) {
            d->active[which] = 0.0;
            continue;
        }
        for (size_t i = 0; i < rows; ++i) {
            d->right[i] = d->residual[(size_t)parts->row[row + i]];
        }
        const lag_svd svd = lag_svd_of(rows, columns, block, d->svd);
        lag_svd_solve(&svd, d->right, LAG_RANK, d->damping[which], d->part);
        for (size_t j = 0; j < columns; ++j) {
            d->trial[(size_t)parts->column[column + j]] -= d->part[j];
        }
    }
}

/* Judges a trial: a part with smaller residuals accepts it. Adapts the damping; true if the part continues. */
static int judge(lag_levenberg_marquardt *d, size_t which, double target)
{
    const double size = d->sizes[which];
    const double other = d->other_sizes[which];
    const double damping = d->damping[which];
    const int better = d->active[which] != 0.0 && other < size;
    const int settled = size <= target && other > 0.5 * size;
    const int stalled = damping == 0.0 && other > (1.0 - 1e-9) * size;
    const int hopeless = !better && (size <= target || damping > LARGEST_DAMPING);
    if (hopeless || (better && (settled || stalled))) {
        d->active[which] = 0.0;
    }
    if (better) {
        d->sizes[which] = other;
        d->damping[which] = damping > SMALLEST_DAMPING ? damping / 3.0 : 0.0;
    } else {
        d->damping[which] = fmax(4.0 * damping, SMALLEST_DAMPING);
    }
    return better;
}

static void take(lag_levenberg_marquardt *d, const lag_parts *parts, size_t which, double *point)
{
    size_t first = 0;
    size_t begin = 0;
    const size_t rows = lag_parts_rows(parts, which, &first);
    const size_t columns = lag_parts_columns(parts, which, &begin);
    for (size_t i = 0; i < rows; ++i) {
        const size_t row = (size_t)parts->row[first + i];
        d->residual[row] = d->other[row];
    }
    memcpy(lag_parts_block(parts, which, d->jacobian), lag_parts_block(parts, which, d->others_jacobian), rows * columns * sizeof(double));
    for (size_t j = begin; j < begin + columns; ++j) {
        const size_t column = (size_t)parts->column[j];
        point[column] = d->trial[column];
    }
}

void lag_descend(lag_levenberg_marquardt *d, const lag_equations *equations, const lag_parts *parts, double target, unsigned iterations,
    double *point)
{
    equations->evaluate(equations->context, parts, point, d->residual, d->jacobian);
    lag_parts_norms(parts, 1, d->residual, d->sizes);
    for (size_t which = 0; which < parts->count; ++which) {
        size_t first = 0;
        d->damping[which] = 0.0;
        d->active[which] = lag_parts_rows(parts, which, &first) > 0 && lag_parts_columns(parts, which, &first) > 0;
    }
    for (unsigned k = 0; k < iterations; ++k) {
        for (size_t which = 0; which < parts->count; ++which) {
            d->active[which] *= d->sizes[which] > 0.0 && isfinite(d->sizes[which]);
        }
        try_next(d, parts, point);
        if (!lag_any(parts->count, d->active)) {
            break;
        }
        equations->evaluate(equations->context, parts, d->trial, d->other, d->others_jacobian);
        lag_parts_norms(parts, 1, d->other, d->other_sizes);
        for (size_t which = 0; which < parts->count; ++which) {
            if (judge(d, which, target)) {
                take(d, parts, which, point);
            }
        }
    }
}

double lag_levenberg_marquardt_size(const lag_levenberg_marquardt *d, const lag_parts *parts)
{
    double sum = 0.0;
    for (size_t i = 0; i < parts->m; ++i) {
        sum += d->residual[i] * d->residual[i];
    }
    return isfinite(sum) ? sqrt(sum) : (double)INFINITY;
}
