/* Places of the rows of an estimate: their order, the border, and the band of their products. */
#include "lag/equations/rank.h"

#include <math.h>
#include <string.h>

#include "lag/equations/entries.h"
#include "lag/linalg/arena.h"

size_t lag_rank_estimate_memory(const lag_model *model)
{
    const size_t m = model->nc;
    return 6 * lag_entries_count(model) + 8 * m + 2 * (m + 1) + 2 * (model->nq + 1) + m * (m + 1) / 2;
}

/* Columns of each row. */
static void list_columns(lag_rank_estimate *estimate)
{
    size_t next = 0;
    for (size_t i = 0; i < estimate->m; ++i) {
        const lag_entries entries = lag_entries_of(estimate->model, i);
        estimate->first[i] = (double)next;
        for (size_t k = entries.first; k < entries.end; ++k) {
            estimate->column[next++] = (double)lag_entry_column(&entries, k);
        }
    }
    estimate->first[estimate->m] = (double)next;
}

/* Rows of each column, ascending, in the memory of the entries. */
static void list_rows(const lag_rank_estimate *estimate, double *first, double *row)
{
    lag_fill(estimate->n + 1, 0.0, first);
    for (size_t k = 0; k < lag_rank_end_of(estimate, estimate->m - 1); ++k) {
        first[lag_index(estimate->column[k])] += 1.0;
    }
    for (size_t j = 0; j < estimate->n; ++j) { /* where each ends; then, backwards, where it begins */
        first[j + 1] += first[j];
    }
    for (size_t i = estimate->m; i-- > 0;) {
        for (size_t k = lag_rank_end_of(estimate, i); k-- > lag_index(estimate->first[i]);) {
            row[lag_index(--first[lag_index(estimate->column[k])])] = (double)i;
        }
    }
}

/* Rows that share a column with a row, and stand nowhere yet, come behind the others, ascending. */
static void append_neighbors(lag_rank_estimate *estimate, size_t row, const double *first, const double *rows, double *place, size_t *count)
{
    const size_t begin = *count;
    for (size_t k = lag_index(estimate->first[row]); k < lag_rank_end_of(estimate, row) && *count < estimate->m - estimate->matrix.border; ++k) {
        const size_t column = lag_index(estimate->column[k]);
        for (size_t e = lag_index(first[column]); e < lag_index(first[column + 1]); ++e) {
            size_t at = *count;
            if (place[lag_index(rows[e])] != 0.0) {
                continue;
            }
            for (; at > begin && estimate->order[at - 1] > rows[e]; --at) {
                estimate->order[at] = estimate->order[at - 1];
            }
            estimate->order[at] = rows[e];
            place[lag_index(rows[e])] = (double)++*count;
        }
    }
    for (size_t at = begin; at < *count; ++at) {
        place[lag_index(estimate->order[at])] = (double)(at + 1);
    }
}

/* Rows by the number of their entries, most first; `count` (n + 1) are how many rows have so many. */
static void sort_by_entries(const lag_rank_estimate *estimate, double *by_entries, double *count)
{
    double next = 0.0;
    lag_fill(estimate->n + 1, 0.0, count);
    for (size_t i = 0; i < estimate->m; ++i) {
        count[lag_rank_end_of(estimate, i) - lag_index(estimate->first[i])] += 1.0;
    }
    for (size_t entries = estimate->n + 1; entries-- > 0;) { /* where those with so many begin */
        const double before = next;
        next += count[entries];
        count[entries] = before;
    }
    for (size_t i = 0; i < estimate->m; ++i) {
        by_entries[lag_index(count[lag_rank_end_of(estimate, i) - lag_index(estimate->first[i])]++)] = (double)i;
    }
}

/*
 * Rows next to each other, from the first one on: neighbors follow in turn, then what is not connected with them. The rows of the border, the
 * first of those by entries, come last.
 */
static void put_in_order(lag_rank_estimate *estimate, const double *first, const double *rows, const double *by_entries)
{
    const size_t begin = estimate->m - estimate->matrix.border;
    double *place = estimate->reach; /* 1 + where a row stands; 0: nowhere yet */
    size_t count = 0;
    lag_fill(estimate->m, 0.0, place);
    for (size_t i = begin; i < estimate->m; ++i) {
        estimate->order[i] = by_entries[i - begin];
        place[lag_index(estimate->order[i])] = (double)(i + 1);
    }
    for (size_t seed = 0; seed < estimate->m; ++seed) {
        size_t next = count;
        if (place[seed] == 0.0) {
            estimate->order[count++] = (double)seed;
            place[seed] = (double)count;
        }
        for (; next < count; ++next) {
            append_neighbors(estimate, lag_index(estimate->order[next]), first, rows, place, &count);
        }
    }
}

/* The first row in the order that shares a column with each, or the first of the border; `low` (n) is the first that has an entry in a column. */
static void find_profile(lag_rank_estimate *estimate, double *low)
{
    const size_t begin = estimate->m - estimate->matrix.border;
    size_t next = 0;
    lag_fill(estimate->n, (double)estimate->m, low);
    for (size_t i = estimate->m; i-- > 0;) {
        const size_t row = lag_index(estimate->order[i]);
        for (size_t k = lag_index(estimate->first[row]); k < lag_rank_end_of(estimate, row); ++k) {
            low[lag_index(estimate->column[k])] = (double)i;
        }
    }
    for (size_t i = 0; i < estimate->m; ++i) {
        const size_t row = lag_index(estimate->order[i]);
        double reach = (double)(i < begin ? i : begin);
        for (size_t k = lag_index(estimate->first[row]); k < lag_rank_end_of(estimate, row); ++k) {
            reach = low[lag_index(estimate->column[k])] < reach ? low[lag_index(estimate->column[k])] : reach;
        }
        estimate->reach[i] = reach;
        estimate->matrix.start[i] = (double)next;
        next += i - lag_index(reach) + 1;
    }
    estimate->matrix.start[estimate->m] = (double)next;
}

/* Products that the border adds to Cholesky's method, whose other rows have `inner` entries beside their pivots in all. */
static double products_of_border(const lag_rank_estimate *estimate, double border, double inner)
{
    return border * inner + 1.5 * border * border * ((double)estimate->m - border) + border * border * border / 6.0;
}

/* Products of Cholesky's method in this order. */
static double products(const lag_rank_estimate *estimate)
{
    double count = 0.0;
    double inner = 0.0;
    for (size_t i = 0; i < estimate->m - estimate->matrix.border; ++i) {
        const double entries = (double)i - estimate->reach[i];
        count += 0.5 * entries * entries;
        inner += entries;
    }
    return count + products_of_border(estimate, (double)estimate->matrix.border, inner);
}

/* The order, with the border that makes the fewest products. Twice as many rows each time: all borders are looked at soon. */
static void arrange(lag_rank_estimate *estimate, double *low)
{
    const double *first = estimate->columns.first, *rows = estimate->now;
    double *by_entries = estimate->trial;
    double least = (double)INFINITY;
    size_t best = 0;
    size_t border = 0;
    sort_by_entries(estimate, by_entries, low);
    for (; border < estimate->m && products_of_border(estimate, (double)border, 0.0) < least; border = border > 0 ? 2 * border : 1) {
        estimate->matrix.border = border;
        put_in_order(estimate, first, rows, by_entries);
        find_profile(estimate, low);
        const double count = products(estimate);
        best = count < least ? border : best;
        least = count < least ? count : least;
    }
    if (estimate->matrix.border != best) {
        estimate->matrix.border = best;
        put_in_order(estimate, first, rows, by_entries);
        find_profile(estimate, low);
    }
}

/* Entries of each column, with the place of their rows in the order, ascending. */
static void list_entries(lag_rank_estimate *estimate)
{
    double *next = estimate->columns.first + 1; /* where a column ends so far, while it is filled */
    memmove(next, estimate->columns.first, estimate->n * sizeof(double));
    for (size_t i = 0; i < estimate->m; ++i) {
        const size_t row = lag_index(estimate->order[i]);
        for (size_t k = lag_index(estimate->first[row]); k < lag_rank_end_of(estimate, row); ++k) {
            const size_t e = lag_index(next[lag_index(estimate->column[k])]++);
            estimate->columns.place[e] = (double)i;
            estimate->columns.entry[e] = (double)k;
        }
    }
}

void lag_rank_estimate_place(lag_rank_estimate *estimate, const lag_model *model, const double *sizes, const double *row_sizes, double *memory)
{
    const size_t m = model->nc;
    const size_t n = model->nq;
    memset(estimate, 0, sizeof *estimate);
    estimate->model = model;
    estimate->m = m;
    estimate->n = n;
    estimate->most = model->rank;
    estimate->sizes = sizes;
    estimate->row_sizes = row_sizes;
    estimate->rows = lag_take(&memory, lag_entries_count(model));
    estimate->now = lag_take(&memory, lag_entries_count(model));
    estimate->known.rows = lag_take(&memory, lag_entries_count(model));
    estimate->first = lag_take(&memory, m + 1);
    estimate->column = lag_take(&memory, lag_entries_count(model));
    estimate->order = lag_take(&memory, m);
    estimate->reach = lag_take(&memory, m);
    estimate->matrix.start = lag_take(&memory, m + 1);
    estimate->follows = lag_take(&memory, m);
    estimate->trial = lag_take(&memory, m);
    estimate->columns.first = lag_take(&memory, n + 1);
    estimate->columns.place = lag_take(&memory, lag_entries_count(model));
    estimate->columns.entry = lag_take(&memory, lag_entries_count(model));
    estimate->columns.products = lag_take(&memory, 4 * m);
    double *low = lag_take(&memory, n + 1);
    estimate->matrix.band = memory;
    if (m > 0) {
        list_columns(estimate);
        list_rows(estimate, estimate->columns.first, estimate->now);
        arrange(estimate, low);
        list_entries(estimate);
    }
    lag_fill(m, 0.0, estimate->follows);
    lag_fill(m, 0.0, estimate->trial);
}

void lag_rank_estimate_clear(lag_rank_estimate *estimate)
{
    const size_t m = estimate->m;
    lag_fill(lag_entries_count(estimate->model), 0.0, estimate->now);
    lag_fill(m, 0.0, estimate->trial);
    lag_fill(4 * m, 0.0, estimate->columns.products);
    lag_fill(m > 0 ? lag_index(estimate->matrix.start[m]) : 0, 0.0, estimate->matrix.band);
}
