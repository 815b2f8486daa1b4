#include "lag/equations/rank.h"

#include <math.h>
#include <string.h>

#include "lag/equations/entries.h"
#include "lag/linalg/arena.h"

/*
 * With x' J1 J0' x above this part of x' J0 J0' x for all x, no combination of rows vanishes on the straight way from J0 to J1:
 * x' (J0 + s (J1 - J0)) J0' x > 0.
 */
static const double LEFT = 0.25;

size_t lag_look_memory(const lag_model *model)
{
    const size_t m = model->nc;
    return 3 * lag_entries_count(model) + 4 * m + 2 * (m + 1) + 2 * model->nq + 1 + m * (m + 1) / 2;
}

/* Columns of each row. */
static void list_columns(lag_look *look)
{
    size_t next = 0;
    for (size_t i = 0; i < look->m; ++i) {
        const lag_entries entries = lag_entries_of(look->model, i);
        look->first[i] = (double)next;
        for (size_t k = entries.first; k < entries.end; ++k) {
            look->column[next++] = (double)lag_entry_column(&entries, k);
        }
    }
    look->first[look->m] = (double)next;
}

static size_t end_of(const lag_look *look, size_t row)
{
    return (size_t)look->first[row + 1];
}

/* Rows of each column, ascending, in the memory of the entries. */
static void list_rows(const lag_look *look, double *first, double *row)
{
    lag_fill(look->n + 1, 0.0, first);
    for (size_t k = 0; k < end_of(look, look->m - 1); ++k) {
        first[(size_t)look->column[k]] += 1.0;
    }
    for (size_t j = 0; j < look->n; ++j) { /* where each ends; then, backwards, where it begins */
        first[j + 1] += first[j];
    }
    for (size_t i = look->m; i-- > 0;) {
        for (size_t k = end_of(look, i); k-- > (size_t)look->first[i];) {
            row[(size_t)--first[(size_t)look->column[k]]] = (double)i;
        }
    }
}

/* Rows that share a column with a row, and stand nowhere yet, come behind the others, ascending. */
static void append_neighbors(lag_look *look, size_t row, const double *first, const double *rows, double *place, size_t *count)
{
    const size_t begin = *count;
    for (size_t k = (size_t)look->first[row]; k < end_of(look, row) && *count < look->m; ++k) {
        const size_t column = (size_t)look->column[k];
        for (size_t e = (size_t)first[column]; e < (size_t)first[column + 1]; ++e) {
            size_t at = *count;
            if (place[(size_t)rows[e]] != 0.0) {
                continue;
            }
            for (; at > begin && look->order[at - 1] > rows[e]; --at) {
                look->order[at] = look->order[at - 1];
            }
            look->order[at] = rows[e];
            place[(size_t)rows[e]] = (double)++*count;
        }
    }
    for (size_t at = begin; at < *count; ++at) {
        place[(size_t)look->order[at]] = (double)(at + 1);
    }
}

/* Rows next to each other, from the first one on: neighbors follow in turn, then what is not connected with them. */
static void put_in_order(lag_look *look, const double *first, const double *rows)
{
    double *place = look->reach; /* 1 + where a row stands; 0: nowhere yet */
    size_t count = 0;
    lag_fill(look->m, 0.0, place);
    for (size_t seed = 0; seed < look->m; ++seed) {
        size_t next = count;
        if (place[seed] == 0.0) {
            look->order[count++] = (double)seed;
            place[seed] = (double)count;
        }
        for (; next < count; ++next) {
            append_neighbors(look, (size_t)look->order[next], first, rows, place, &count);
        }
    }
}

/* The first row in the order that shares a column with each; `low` (n) is the first that has an entry in a column. */
static void find_reach(lag_look *look, double *low)
{
    size_t next = 0;
    lag_fill(look->n, (double)look->m, low);
    for (size_t i = look->m; i-- > 0;) {
        const size_t row = (size_t)look->order[i];
        for (size_t k = (size_t)look->first[row]; k < end_of(look, row); ++k) {
            low[(size_t)look->column[k]] = (double)i;
        }
    }
    for (size_t i = 0; i < look->m; ++i) {
        const size_t row = (size_t)look->order[i];
        double reach = (double)i;
        for (size_t k = (size_t)look->first[row]; k < end_of(look, row); ++k) {
            reach = low[(size_t)look->column[k]] < reach ? low[(size_t)look->column[k]] : reach;
        }
        look->reach[i] = reach;
        look->start[i] = (double)next;
        next += i - (size_t)reach + 1;
    }
    look->start[look->m] = (double)next;
}

void lag_look_place(lag_look *look, const lag_model *model, const double *sizes, const double *row_sizes, double *memory)
{
    const size_t m = model->nc;
    const size_t n = model->nq;
    memset(look, 0, sizeof *look);
    look->model = model;
    look->m = m;
    look->n = n;
    look->most = model->rank;
    look->sizes = sizes;
    look->row_sizes = row_sizes;
    look->rows = lag_take(&memory, lag_entries_count(model));
    look->now = lag_take(&memory, lag_entries_count(model));
    look->first = lag_take(&memory, m + 1);
    look->column = lag_take(&memory, lag_entries_count(model));
    look->order = lag_take(&memory, m);
    look->reach = lag_take(&memory, m);
    look->start = lag_take(&memory, m + 1);
    look->follows = lag_take(&memory, m);
    look->trial = lag_take(&memory, m);
    double *low = lag_take(&memory, n);
    double *of_columns = lag_take(&memory, n + 1);
    look->band = memory;
    if (m > 0) {
        list_columns(look);
        list_rows(look, of_columns, look->now);
        put_in_order(look, of_columns, look->now);
        find_reach(look, low);
    }
    lag_fill(m, 0.0, look->follows);
    lag_fill(m, 0.0, look->trial);
}

/* Rows that come and go, or follow from others, say nothing. */
static int counts(const lag_look *look, size_t row)
{
    const int redundant = look->model->redundant != NULL && look->model->redundant[row];
    return !redundant && look->follows[row] == 0.0 && (look->lasting == NULL || look->lasting[row] != 0.0);
}

/* So many of the rows that count follow from others, although nobody said which. */
static size_t redundant_rows(const lag_look *look)
{
    size_t count = 0;
    for (size_t i = 0; i < look->m; ++i) {
        count += (size_t)counts(look, i);
    }
    return count > look->most ? count - look->most : 0;
}

/* Row i of a times row j of b, both by entries. */
static double product(const lag_look *look, size_t i, size_t j, const double *a, const double *b)
{
    const size_t end = end_of(look, i);
    const size_t others = end_of(look, j);
    size_t l = (size_t)look->first[j];
    double sum = 0.0;
    for (size_t k = (size_t)look->first[i]; k < end; ++k) {
        while (l < others && look->column[l] < look->column[k]) {
            ++l;
        }
        sum += l < others && look->column[l] == look->column[k] ? a[k] * b[l] : 0.0;
    }
    return sum;
}

/*
 * Cholesky's method within the band, without up to `spare` rows that follow from others. Returns the smallest pivot; zero where the matrix is
 * not positive definite.
 */
static double least_pivot(lag_look *look, size_t spare)
{
    double least = (double)INFINITY;
    for (size_t i = 0; i < look->m; ++i) {
        const size_t reach = (size_t)look->reach[i];
        double *line = look->band + (size_t)look->start[i];
        double pivot = line[i - reach];
        for (size_t j = reach; j < i; ++j) {
            const size_t other = (size_t)look->reach[j];
            const double *above = look->band + (size_t)look->start[j];
            double sum = line[j - reach];
            for (size_t k = other > reach ? other : reach; k < j; ++k) {
                sum -= line[k - reach] * above[k - other];
            }
            line[j - reach] = sum / above[j - other];
            pivot -= line[j - reach] * line[j - reach];
        }
        if (spare > 0 && pivot <= LAG_FOLLOWS * LAG_FOLLOWS) {
            --spare;
            look->follows[(size_t)look->order[i]] = 1.0;
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

/* The products of rows a with rows b, made symmetric, less a part of those of b; of each row that does not count with itself one. */
static void multiply(const lag_look *look, const double *a, const double *b, double part)
{
    for (size_t i = 0; i < look->m; ++i) {
        const size_t row = (size_t)look->order[i];
        const size_t reach = (size_t)look->reach[i];
        double *line = look->band + (size_t)look->start[i];
        for (size_t j = reach; j <= i; ++j) {
            const size_t other = (size_t)look->order[j];
            double sum = i == j ? 1.0 : 0.0;
            if (counts(look, row) && counts(look, other)) {
                sum = 0.5 * (product(look, row, other, a, b) + product(look, row, other, b, a));
                sum -= part > 0.0 ? part * product(look, row, other, b, b) : 0.0;
            }
            line[j - reach] = sum;
        }
    }
}

static void scale(lag_look *look, const double *jacobian)
{
    const size_t n = look->n;
    for (size_t i = 0; i < look->m; ++i) {
        for (size_t k = (size_t)look->first[i]; k < (size_t)look->first[i + 1]; ++k) {
            const size_t j = (size_t)look->column[k];
            look->now[k] = jacobian[i * n + j] * look->sizes[j] / look->row_sizes[i];
        }
    }
}

int lag_look_turned(lag_look *look, const double *jacobian)
{
    scale(look, jacobian);
    multiply(look, look->now, look->rows, LEFT);
    return !(least_pivot(look, 0) > 0.0);
}

double lag_look_margin(lag_look *look, const double *jacobian)
{
    double *follows = look->follows;
    scale(look, jacobian);
    look->follows = look->trial;
    lag_fill(look->m, 0.0, look->follows);
    multiply(look, look->now, look->now, 0.0);
    const double least = least_pivot(look, redundant_rows(look));
    look->follows = follows;
    return sqrt(least);
}

lag_status lag_look_at(lag_look *look, const double *jacobian)
{
    if (look->rank > 0 && lag_look_turned(look, jacobian)) {
        return LAG_ATTENTION;
    }
    look->margin = lag_look_margin(look, jacobian);
    look->rank = look->most;
    memcpy(look->rows, look->now, lag_entries_count(look->model) * sizeof(double));
    memcpy(look->follows, look->trial, look->m * sizeof(double));
    return look->margin > LAG_RANK_NEAR ? LAG_OK : LAG_ATTENTION;
}
