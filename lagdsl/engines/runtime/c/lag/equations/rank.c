#include "lag/equations/rank.h"

#include <math.h>
#include <string.h>

#include "lag/equations/entries.h"
#include "lag/linalg/arena.h"
#include "lag/linalg/vector.h"

/*
 * With x' J1 J0' x above this part of x' J0 J0' x for all x, no combination of rows vanishes on the straight way from J0 to J1:
 * x' (J0 + s (J1 - J0)) J0' x > 0.
 */
static const double LEFT = 0.25;
/* This part of what the rows may move until no more than LEFT remains is used: the rest is room for round-off. */
static const double USED = 0.5;

size_t lag_rank_estimate_memory(const lag_model *model)
{
    const size_t m = model->nc;
    return 6 * lag_entries_count(model) + 8 * m + 2 * (m + 1) + 2 * model->nq + 1 + m * (m + 1) / 2;
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

static size_t end_of(const lag_rank_estimate *estimate, size_t row)
{
    return lag_index(estimate->first[row + 1]);
}

/* Rows of each column, ascending, in the memory of the entries. */
static void list_rows(const lag_rank_estimate *estimate, double *first, double *row)
{
    lag_fill(estimate->n + 1, 0.0, first);
    for (size_t k = 0; k < end_of(estimate, estimate->m - 1); ++k) {
        first[lag_index(estimate->column[k])] += 1.0;
    }
    for (size_t j = 0; j < estimate->n; ++j) { /* where each ends; then, backwards, where it begins */
        first[j + 1] += first[j];
    }
    for (size_t i = estimate->m; i-- > 0;) {
        for (size_t k = end_of(estimate, i); k-- > lag_index(estimate->first[i]);) {
            row[lag_index(--first[lag_index(estimate->column[k])])] = (double)i;
        }
    }
}

/* Rows that share a column with a row, and stand nowhere yet, come behind the others, ascending. */
static void append_neighbors(lag_rank_estimate *estimate, size_t row, const double *first, const double *rows, double *place, size_t *count)
{
    const size_t begin = *count;
    for (size_t k = lag_index(estimate->first[row]); k < end_of(estimate, row) && *count < estimate->m; ++k) {
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

/* Rows next to each other, from the first one on: neighbors follow in turn, then what is not connected with them. */
static void put_in_order(lag_rank_estimate *estimate, const double *first, const double *rows)
{
    double *place = estimate->reach; /* 1 + where a row stands; 0: nowhere yet */
    size_t count = 0;
    lag_fill(estimate->m, 0.0, place);
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

/* The first row in the order that shares a column with each; `low` (n) is the first that has an entry in a column. */
static void find_profile(lag_rank_estimate *estimate, double *low)
{
    size_t next = 0;
    lag_fill(estimate->n, (double)estimate->m, low);
    for (size_t i = estimate->m; i-- > 0;) {
        const size_t row = lag_index(estimate->order[i]);
        for (size_t k = lag_index(estimate->first[row]); k < end_of(estimate, row); ++k) {
            low[lag_index(estimate->column[k])] = (double)i;
        }
    }
    for (size_t i = 0; i < estimate->m; ++i) {
        const size_t row = lag_index(estimate->order[i]);
        double reach = (double)i;
        for (size_t k = lag_index(estimate->first[row]); k < end_of(estimate, row); ++k) {
            reach = low[lag_index(estimate->column[k])] < reach ? low[lag_index(estimate->column[k])] : reach;
        }
        estimate->reach[i] = reach;
        estimate->matrix.start[i] = (double)next;
        next += i - lag_index(reach) + 1;
    }
    estimate->matrix.start[estimate->m] = (double)next;
}

/* Entries of each column, with the place of their rows in the order, ascending. */
static void list_entries(lag_rank_estimate *estimate)
{
    double *next = estimate->columns.first + 1; /* where a column ends so far, while it is filled */
    memmove(next, estimate->columns.first, estimate->n * sizeof(double));
    for (size_t i = 0; i < estimate->m; ++i) {
        const size_t row = lag_index(estimate->order[i]);
        for (size_t k = lag_index(estimate->first[row]); k < end_of(estimate, row); ++k) {
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
    double *low = lag_take(&memory, n);
    estimate->matrix.band = memory;
    if (m > 0) {
        list_columns(estimate);
        list_rows(estimate, estimate->columns.first, estimate->now);
        put_in_order(estimate, estimate->columns.first, estimate->now);
        list_entries(estimate);
        find_profile(estimate, low);
    }
    lag_fill(m, 0.0, estimate->follows);
    lag_fill(m, 0.0, estimate->trial);
}

/* Rows that come and go, or follow from others, say nothing. */
static int counts(const lag_rank_estimate *estimate, size_t row)
{
    const int redundant = estimate->model->redundant != NULL && estimate->model->redundant[row];
    return !redundant && estimate->follows[row] == 0.0 && (estimate->lasting == NULL || estimate->lasting[row] != 0.0);
}

/* So many of the rows that count follow from others, although nobody said which. */
static size_t redundant_rows(const lag_rank_estimate *estimate)
{
    size_t count = 0;
    for (size_t i = 0; i < estimate->m; ++i) {
        count += (size_t)counts(estimate, i);
    }
    return count > estimate->most ? count - estimate->most : 0;
}

/*
 * The row at place i with the rows up to there, from the first on with which it shares a column: `sums` of a with b, `others` of b with a,
 * `of_b` of b with b, in one walk over the entries of its columns.
 */
static void take_products(const lag_rank_estimate *estimate, size_t i, const double *a, const double *b, double *sums, double *others, double *of_b)
{
    const size_t row = lag_index(estimate->order[i]);
    const size_t reach = lag_index(estimate->reach[i]);
    lag_fill(i + 1 - reach, 0.0, sums + reach);
    lag_fill(i + 1 - reach, 0.0, others + reach);
    lag_fill(i + 1 - reach, 0.0, of_b + reach);
    for (size_t k = lag_index(estimate->first[row]); k < end_of(estimate, row); ++k) {
        const size_t column = lag_index(estimate->column[k]);
        const int some = a[k] != 0.0 || b[k] != 0.0; /* most of a dense row is zero */
        const size_t end = some ? lag_index(estimate->columns.first[column + 1]) : 0;
        for (size_t e = lag_index(estimate->columns.first[column]); e < end && estimate->columns.place[e] <= (double)i; ++e) {
            const size_t j = lag_index(estimate->columns.place[e]);
            const size_t other = lag_index(estimate->columns.entry[e]);
            sums[j] += a[k] * b[other];
            others[j] += b[k] * a[other];
            of_b[j] += b[k] * b[other];
        }
    }
}

/* Of the row at place i of a with rows of a. */
static void take_squares(const lag_rank_estimate *estimate, size_t i, const double *a, double *sums)
{
    const size_t row = lag_index(estimate->order[i]);
    const size_t reach = lag_index(estimate->reach[i]);
    lag_fill(i + 1 - reach, 0.0, sums + reach);
    for (size_t k = lag_index(estimate->first[row]); k < end_of(estimate, row); ++k) {
        const size_t column = lag_index(estimate->column[k]);
        const size_t end = a[k] != 0.0 ? lag_index(estimate->columns.first[column + 1]) : 0;
        for (size_t e = lag_index(estimate->columns.first[column]); e < end && estimate->columns.place[e] <= (double)i; ++e) {
            sums[lag_index(estimate->columns.place[e])] += a[k] * a[lag_index(estimate->columns.entry[e])];
        }
    }
}

/* x . y in sums of which none waits for another. */
static double dot(size_t count, const double *x, const double *y)
{
    double first = 0.0;
    double second = 0.0;
    double third = 0.0;
    double fourth = 0.0;
    size_t k = 0;
    for (; k + 4 <= count; k += 4) {
        first += x[k] * y[k];
        second += x[k + 1] * y[k + 1];
        third += x[k + 2] * y[k + 2];
        fourth += x[k + 3] * y[k + 3];
    }
    return (first + second) + (third + fourth) + lag_dot(count - k, x + k, y + k);
}

/*
 * Cholesky's method within the band, without up to `spare` rows that follow from others. Returns the smallest pivot; zero where the matrix is
 * not positive definite.
 */
static double least_pivot(lag_rank_estimate *estimate, size_t spare)
{
    double least = (double)INFINITY;
    for (size_t i = 0; i < estimate->m; ++i) {
        const size_t reach = lag_index(estimate->reach[i]);
        double *line = estimate->matrix.band + lag_index(estimate->matrix.start[i]);
        double pivot = line[i - reach];
        for (size_t j = reach; j < i; ++j) {
            const size_t other = lag_index(estimate->reach[j]);
            const double *above = estimate->matrix.band + lag_index(estimate->matrix.start[j]);
            const size_t both = other > reach ? other : reach;
            line[j - reach] = (line[j - reach] - dot(j - both, line + (both - reach), above + (both - other))) / above[j - other];
            pivot -= line[j - reach] * line[j - reach];
        }
        if (spare > 0 && pivot <= LAG_FOLLOWS * LAG_FOLLOWS) {
            --spare;
            estimate->follows[lag_index(estimate->order[i])] = 1.0;
            lag_fill(i - reach, 0.0, line);
            line[i - reach] = 1.0;
            continue;
        }
        if (!(pivot > 0.0)) {
            return 0.0;
        }
        least = pivot < least ? pivot : least;
        line[i - reach] = sqrt(pivot);
    }
    return least;
}

/* Products of rows in `sums`, up to place i, become its line of the matrix. Of each row that does not count with itself one. */
static void put_line(const lag_rank_estimate *estimate, size_t i, const double *sums, const double *counted)
{
    const size_t reach = lag_index(estimate->reach[i]);
    double *line = estimate->matrix.band + lag_index(estimate->matrix.start[i]);
    for (size_t j = reach; j <= i; ++j) {
        line[j - reach] = counted[i] != 0.0 && counted[j] != 0.0 ? sums[j] : i == j ? 1.0 : 0.0;
    }
}

/* The products of rows a with rows b, made symmetric, less this part of those of b. */
static void multiply(const lag_rank_estimate *estimate, const double *a, const double *b, double part)
{
    const size_t m = estimate->m;
    double *sums = estimate->columns.products, *others = sums + m, *of_b = others + m, *counted = of_b + m;
    for (size_t i = 0; i < m; ++i) {
        counted[i] = (double)counts(estimate, lag_index(estimate->order[i]));
        take_products(estimate, i, a, b, sums, others, of_b);
        for (size_t j = lag_index(estimate->reach[i]); j <= i; ++j) {
            sums[j] = 0.5 * (sums[j] + others[j]) - part * of_b[j];
        }
        put_line(estimate, i, sums, counted);
    }
}

/* Those of rows a. */
static void square(const lag_rank_estimate *estimate, const double *a)
{
    const size_t m = estimate->m;
    double *sums = estimate->columns.products, *counted = sums + m;
    for (size_t i = 0; i < m; ++i) {
        counted[i] = (double)counts(estimate, lag_index(estimate->order[i]));
        take_squares(estimate, i, a, sums);
        put_line(estimate, i, sums, counted);
    }
}

static void scale(lag_rank_estimate *estimate, const double *jacobian)
{
    const size_t n = estimate->n;
    for (size_t i = 0; i < estimate->m; ++i) {
        for (size_t k = lag_index(estimate->first[i]); k < lag_index(estimate->first[i + 1]); ++k) {
            const size_t j = lag_index(estimate->column[k]);
            estimate->now[k] = jacobian[i * n + j] * estimate->sizes[j] / estimate->row_sizes[i];
        }
    }
}

/* True if J is that of the last state. */
static int has_stayed(const lag_rank_estimate *estimate)
{
    return lag_same(lag_entries_count(estimate->model), estimate->now, estimate->rows);
}

int lag_rank_estimate_has_turned(lag_rank_estimate *estimate, const double *jacobian)
{
    scale(estimate, jacobian);
    multiply(estimate, estimate->now, estimate->rows, LEFT);
    return !(least_pivot(estimate, 0) > 0.0);
}

double lag_rank_estimate_margin(lag_rank_estimate *estimate, const double *jacobian)
{
    double *follows = estimate->follows;
    scale(estimate, jacobian);
    estimate->follows = estimate->trial;
    lag_fill(estimate->m, 0.0, estimate->follows);
    square(estimate, estimate->now);
    const double least = least_pivot(estimate, redundant_rows(estimate));
    estimate->follows = follows;
    return sqrt(least);
}

/*
 * A number below the least singular value of the triangle in the band: 1 / sqrt of the largest sums of rows and columns of the inverse of its
 * comparison matrix.
 */
static double least_value(lag_rank_estimate *estimate)
{
    double *of_row = estimate->columns.products, *of_column = of_row + estimate->m;
    double rows = 0.0;
    double columns = 0.0;
    lag_fill(estimate->m, 1.0, of_column);
    for (size_t i = 0; i < estimate->m; ++i) {
        const size_t reach = lag_index(estimate->reach[i]);
        const double *line = estimate->matrix.band + lag_index(estimate->matrix.start[i]);
        double sum = 1.0;
        for (size_t j = reach; j < i; ++j) {
            sum += fabs(line[j - reach]) * of_row[j];
        }
        of_row[i] = sum / line[i - reach];
        rows = fmax(rows, of_row[i]);
    }
    for (size_t i = estimate->m; i-- > 0;) {
        const size_t reach = lag_index(estimate->reach[i]);
        const double *line = estimate->matrix.band + lag_index(estimate->matrix.start[i]);
        of_column[i] /= line[i - reach];
        columns = fmax(columns, of_column[i]);
        for (size_t j = reach; j < i; ++j) {
            of_column[j] += fabs(line[j - reach]) * of_column[i];
        }
    }
    return 1.0 / sqrt(rows * columns);
}

/* Length of the difference of J and x, in the rows that count. */
static double distance(const lag_rank_estimate *estimate, const double *x)
{
    double sum = 0.0;
    for (size_t i = 0; i < estimate->m; ++i) {
        const size_t end = counts(estimate, i) ? end_of(estimate, i) : 0;
        for (size_t k = lag_index(estimate->first[i]); k < end; ++k) {
            const double by = estimate->now[k] - x[k];
            sum += by * by;
        }
    }
    return sqrt(sum);
}

/*
 * True if J is so near to where its pivots are known that they are above LAG_RANK_NEAR, and that it cannot have turned on the way from the last
 * state. With s the least singular value there and J moved by d from there, x J is at least (1 - d / s) as long as it was, for all x.
 */
static int is_near_known(lag_rank_estimate *estimate)
{
    if (!(estimate->known.least > 0.0)) {
        return 0;
    }
    const double moved = distance(estimate, estimate->known.rows);
    const double step = distance(estimate, estimate->rows);
    const double margin = (1.0 - moved / estimate->known.least) * estimate->known.margin;
    if (!(margin > LAG_RANK_NEAR && step <= USED * (1.0 - LEFT) * (estimate->known.least - moved - step))) {
        return 0;
    }
    estimate->margin = margin;
    return 1;
}

lag_status lag_rank_estimate_update(lag_rank_estimate *estimate, const double *jacobian)
{
    const size_t entries = lag_entries_count(estimate->model);
    scale(estimate, jacobian);
    if (estimate->rank > 0 && estimate->margin > LAG_RANK_NEAR && has_stayed(estimate)) { /* Kirchhoff's laws have constants only */
        return LAG_OK;
    }
    if (estimate->rank > 0 && is_near_known(estimate)) {
        memcpy(estimate->rows, estimate->now, entries * sizeof(double));
        return LAG_OK;
    }
    if (estimate->rank > 0 && lag_rank_estimate_has_turned(estimate, jacobian)) {
        return LAG_ATTENTION;
    }
    estimate->margin = lag_rank_estimate_margin(estimate, jacobian);
    estimate->rank = estimate->most;
    memcpy(estimate->rows, estimate->now, entries * sizeof(double));
    memcpy(estimate->follows, estimate->trial, estimate->m * sizeof(double));
    estimate->known.margin = estimate->margin;
    estimate->known.least = estimate->margin > LAG_RANK_NEAR && !lag_any(estimate->m, estimate->follows) ? least_value(estimate) : 0.0;
    memcpy(estimate->known.rows, estimate->now, entries * sizeof(double));
    return estimate->margin > LAG_RANK_NEAR ? LAG_OK : LAG_ATTENTION;
}
