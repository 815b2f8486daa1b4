/* Conditions on the rates of a start, entry by entry. */
#include <math.h>

#include "lag/equations/entries.h"
#include "lag/initial/initial_rates.h"
#include "lag/linalg/arena.h"

/* Entry (i, j) of J, in natural sizes. */
static double entry_of(const lag_rates *r, size_t i, size_t j)
{
    const lag_initialization *b = r->b;
    return b->jacobian[i * b->motion->model->nq + j] * b->sizes[j] / b->row_sizes[i];
}

int lag_rates_are_satisfied(const lag_rates *r)
{
    const lag_initialization *b = r->b;
    const lag_model *model = b->motion->model;
    const size_t n = model->nq;
    int alike = b->equations.slopes == NULL;
    for (size_t i = 0; i < model->nc && alike; ++i) {
        const lag_entries entries = lag_entries_of(model, i);
        const double right = -b->phi[i] / b->row_sizes[i];
        double sum = 0.0;
        for (size_t k = entries.first; k < entries.end; ++k) {
            const size_t j = lag_entry_column(&entries, k);
            sum += entry_of(r, i, j) * (b->starts.x[n + j] / b->sizes[j]);
        }
        alike = fabs(sum - right) <= LAG_EXACT * (1.0 + fabs(right));
    }
    return alike;
}

size_t lag_rates_equations(const lag_rates *r)
{
    return r->b->equations.slopes != NULL ? r->b->motion->model->ne : 0;
}

void lag_rates_state_conditions(lag_rates *r, const double *x)
{
    const lag_initialization *b = r->b;
    const size_t n = b->motion->model->nq;
    const size_t m = b->motion->model->nc;
    size_t count = m + lag_rates_equations(r);
    for (size_t i = 0; i < m; ++i) {
        r->right[i] = -b->phi[i] / b->row_sizes[i];
    }
    for (size_t i = m; i < count; ++i) {
        r->right[i] = 0.0;
        for (size_t j = 0; j < n; ++j) {
            r->right[i] += b->equations.slopes[(i - m) * n + j] * x[n + j] / b->sizes[j];
        }
    }
    for (size_t j = 0; j < n; ++j) {
        r->wanted[j] = r->v[j] = b->starts.x[n + j] / b->sizes[j];
        if (b->starts.fixed[n + j] != 0.0) {
            r->fixed[count - m - lag_rates_equations(r)] = (double)j;
            r->right[count++] = r->wanted[j];
        }
    }
    r->conditions = count;
}

void lag_rates_find_parts(lag_rates *r)
{
    const lag_initialization *b = r->b;
    const lag_model *model = b->motion->model;
    const size_t n = model->nq;
    const size_t m = model->nc;
    const size_t rows = m + lag_rates_equations(r);
    r->parts = lag_parts_begin(r->conditions, n, r->parts.row_part);
    for (size_t i = 0; i < m; ++i) {
        const lag_entries entries = lag_entries_of(model, i);
        for (size_t k = entries.first; k < entries.end; ++k) {
            lag_parts_join(&r->parts, i, lag_entry_column(&entries, k));
        }
    }
    for (size_t i = m; i < rows; ++i) {
        for (size_t j = 0; j < n; ++j) {
            if (b->equations.slopes[(i - m) * n + j] != 0.0) {
                lag_parts_join(&r->parts, i, j);
            }
        }
    }
    for (size_t i = rows; i < r->conditions; ++i) {
        lag_parts_join(&r->parts, i, (size_t)r->fixed[i - rows]);
    }
    lag_parts_end(&r->parts);
    for (size_t k = 0; k < n; ++k) {
        const size_t j = (size_t)r->parts.column[k];
        r->place[j] = (double)k - r->parts.first_column[(size_t)r->parts.column_part[j]];
    }
}

void lag_rates_row(const lag_rates *r, size_t row, double *line)
{
    const lag_entries entries = lag_entries_of(r->b->motion->model, row);
    for (size_t k = entries.first; k < entries.end; ++k) {
        const size_t j = lag_entry_column(&entries, k);
        const double entry = entry_of(r, row, j);
        if (entry != 0.0) { /* others are of other parts, perhaps */
            line[(size_t)r->place[j]] = entry;
        }
    }
}

void lag_rates_gather(const lag_rates *r, size_t which, double *block)
{
    const lag_initialization *b = r->b;
    const size_t n = b->motion->model->nq;
    const size_t m = b->motion->model->nc;
    size_t row = 0;
    size_t column = 0;
    const size_t rows = lag_parts_rows(&r->parts, which, &row);
    const size_t columns = lag_parts_columns(&r->parts, which, &column);
    lag_fill(rows * columns, 0.0, block);
    for (size_t i = 0; i < rows; ++i) {
        const size_t its = (size_t)r->parts.row[row + i];
        if (its < m) {
            lag_rates_row(r, its, block + i * columns);
        } else if (its < m + lag_rates_equations(r)) {
            for (size_t k = 0; k < columns; ++k) {
                block[i * columns + k] = b->equations.slopes[(its - m) * n + (size_t)r->parts.column[column + k]];
            }
        } else {
            block[i * columns + (size_t)r->place[(size_t)r->fixed[its - m - lag_rates_equations(r)]]] = 1.0;
        }
    }
}
