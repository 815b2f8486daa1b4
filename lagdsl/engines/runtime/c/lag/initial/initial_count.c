/* Independent rows of J at one state. */
#include "lag/equations/entries.h"
#include "lag/equations/rank.h"
#include "lag/initial/initial_scaling.h"

#include <math.h>

#include "lag/linalg/arena.h"
#include "lag/linalg/finite.h"
#include "lag/linalg/svd.h"

double lag_initialization_least(const lag_svd *svd, double least)
{
    return least * fmax(1.0, LAG_CONTENT / svd->value[0]);
}

size_t lag_initialization_rank(size_t count, size_t width, const double *matrix, double *memory)
{
    if (count == 0 || width == 0 || !lag_finite(count * width, matrix)) {
        return 0;
    }
    const lag_svd svd = lag_svd_of(count, width, matrix, memory);
    return lag_svd_rank(&svd, LAG_RANK);
}

size_t lag_initialization_count_memory(const lag_model *model)
{
    const size_t m = model->nc;
    const size_t n = model->nq;
    return m + lag_larger(lag_rank_estimate_memory(model), lag_parts_memory(m, n) + m * n + lag_svd_memory(m, n));
}

int lag_initialization_is_regular(lag_initialization *b, double *memory)
{
    const lag_model *model = b->motion->model;
    double *lasting = lag_take(&memory, model->nc);
    lag_rank_estimate estimate;
    lag_fill(model->nc, 1.0, lasting);
    for (size_t i = 0; i < model->ncontact; ++i) {
        lasting[model->contact_rows[i]] = 0.0;
    }
    for (size_t i = 0; i < model->nslip; ++i) {
        lasting[model->friction_rows[i]] = 0.0;
    }
    lag_rank_estimate_place(&estimate, model, b->sizes, b->row_sizes, memory);
    estimate.lasting = lasting;
    return lag_rank_estimate_update(&estimate, b->jacobian) == LAG_OK;
}

/* Flags (nc) of rows of J that are not zero. Returns how many of these are independent in general; nc + 1: some may depend on those that are zero. */
static size_t find_rows(const lag_initialization *b, double *there)
{
    const lag_model *model = b->motion->model;
    size_t count = 0;
    size_t zero = 0;
    size_t redundant = 0;
    for (size_t i = 0; i < model->nc; ++i) {
        const lag_entries entries = lag_entries_of(model, i);
        const int depends = model->redundant != NULL && model->redundant[i];
        there[i] = 0.0;
        for (size_t k = entries.first; k < entries.end; ++k) {
            there[i] = b->jacobian[i * model->nq + lag_entry_column(&entries, k)] != 0.0 ? 1.0 : there[i];
        }
        zero += there[i] == 0.0;
        redundant += there[i] != 0.0 && depends;
        count += there[i] != 0.0 && !depends;
    }
    return zero > 0 && redundant > 0 ? model->nc + 1 : count;
}

void lag_initialization_gather(const lag_initialization *b, const lag_parts *parts, size_t which, const double *row, double *block)
{
    size_t first = 0;
    size_t begin = 0;
    const size_t rows = lag_parts_rows(parts, which, &first);
    const size_t columns = lag_parts_columns(parts, which, &begin);
    for (size_t i = 0; i < rows; ++i) {
        const size_t place = (size_t)parts->row[first + i];
        const size_t its = row != NULL ? (size_t)row[place] : place;
        const double *line = b->jacobian + its * b->motion->model->nq;
        for (size_t k = 0; k < columns; ++k) {
            const size_t j = (size_t)parts->column[begin + k];
            block[i * columns + k] = line[j] * b->sizes[j] / b->row_sizes[its];
        }
    }
}

/* Independent rows of J as it was evaluated last, in natural sizes, each part as if it were alone. */
static size_t count_by_parts(const lag_initialization *b, double *memory)
{
    const lag_model *model = b->motion->model;
    const size_t n = model->nq;
    lag_parts parts = lag_parts_begin(model->nc, n, lag_take(&memory, lag_parts_memory(model->nc, n)));
    size_t rank = 0;
    for (size_t i = 0; i < model->nc; ++i) {
        const lag_entries entries = lag_entries_of(model, i);
        for (size_t k = entries.first; k < entries.end; ++k) {
            if (b->jacobian[i * n + lag_entry_column(&entries, k)] != 0.0) {
                lag_parts_join(&parts, i, lag_entry_column(&entries, k));
            }
        }
    }
    lag_parts_end(&parts);
    double *block = lag_take(&memory, lag_parts_entries(&parts));
    for (size_t which = 0; which < parts.count; ++which) {
        size_t row = 0;
        size_t column = 0;
        const size_t rows = lag_parts_rows(&parts, which, &row);
        const size_t columns = lag_parts_columns(&parts, which, &column);
        if (rows > 0 && columns > 0) {
            lag_initialization_gather(b, &parts, which, NULL, block);
            const lag_svd svd = lag_svd_of(rows, columns, block, memory);
            rank += lag_svd_rank(&svd, lag_initialization_least(&svd, LAG_RANK));
        }
    }
    return rank;
}

size_t lag_initialization_count(lag_initialization *b, int as_compiled, double *memory)
{
    const lag_model *model = b->motion->model;
    double *there = lag_take(&memory, model->nc);
    const size_t count = find_rows(b, there);
    lag_rank_estimate estimate;
    if (count == 0 || (as_compiled && count <= model->nc)) {
        lag_rank_estimate_place(&estimate, model, b->sizes, b->row_sizes, memory);
        estimate.lasting = there;
        estimate.most = count;
        if (lag_rank_estimate_update(&estimate, b->jacobian) == LAG_OK) {
            return count;
        }
    }
    return lag_entries_finite(model, b->jacobian) ? count_by_parts(b, memory) : 0;
}
