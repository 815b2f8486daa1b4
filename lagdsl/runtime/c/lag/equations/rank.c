#include "lag/equations/rank.h"

#include <math.h>
#include <string.h>

#include "lag/linalg/arena.h"

/*
 * With x' J1 J0' x above this part of x' J0 J0' x for all x, no combination of rows vanishes on the straight way from J0 to J1:
 * x' (J0 + s (J1 - J0)) J0' x > 0.
 */
static const double LEFT = 0.25;

static size_t entries_of(const lag_model *model)
{
    return model->jacobian_pattern != NULL ? model->jacobian_pattern->count : model->nc * model->nq;
}

size_t lag_look_memory(const lag_model *model)
{
    const size_t m = model->nc;
    return 2 * m * model->nq + (m + 1) + entries_of(model) + 4 * m + (m + 1) + m * (m + 1) / 2;
}

/* Columns of each row. */
static void list_columns(lag_look *look)
{
    const lag_pattern *pattern = look->model->jacobian_pattern;
    size_t next = 0;
    for (size_t i = 0; i < look->m; ++i) {
        look->first[i] = (double)next;
        for (size_t j = 0; pattern == NULL && j < look->n; ++j) {
            look->column[next++] = (double)j;
        }
        for (size_t k = 0; pattern != NULL && k < pattern->count; ++k) {
            if (pattern->row[k] == i) {
                look->column[next++] = (double)pattern->column[k];
            }
        }
    }
    look->first[look->m] = (double)next;
}

/* True if two rows share a coordinate; `marks` (n) are those of one of them. */
static int shares(const lag_look *look, size_t row, const double *marks)
{
    const size_t end = (size_t)look->first[row + 1];
    size_t k = (size_t)look->first[row];
    while (k < end && marks[(size_t)look->column[k]] == 0.0) {
        ++k;
    }
    return k < end;
}

static void mark(const lag_look *look, size_t row, double value, double *marks)
{
    for (size_t k = (size_t)look->first[row]; k < (size_t)look->first[row + 1]; ++k) {
        marks[(size_t)look->column[k]] = value;
    }
}

/* Rows next to each other, from the first one on: neighbors follow in turn, then what is not connected with them. */
static void put_in_order(lag_look *look)
{
    double *place = look->reach; /* 1 + where a row stands; 0: nowhere yet */
    double *marks = look->now;
    size_t count = 0;
    lag_fill(look->m, 0.0, place);
    lag_fill(look->n, 0.0, marks);
    for (size_t seed = 0; seed < look->m; ++seed) {
        size_t next = count;
        if (place[seed] == 0.0) {
            look->order[count++] = (double)seed;
            place[seed] = (double)count;
        }
        for (; next < count; ++next) {
            const size_t row = (size_t)look->order[next];
            mark(look, row, 1.0, marks);
            for (size_t other = 0; other < look->m; ++other) {
                if (place[other] == 0.0 && shares(look, other, marks)) {
                    look->order[count++] = (double)other;
                    place[other] = (double)count;
                }
            }
            mark(look, row, 0.0, marks);
        }
    }
}

static void find_reach(lag_look *look)
{
    double *marks = look->now;
    size_t next = 0;
    for (size_t i = 0; i < look->m; ++i) {
        size_t other = 0;
        mark(look, (size_t)look->order[i], 1.0, marks);
        while (other < i && !shares(look, (size_t)look->order[other], marks)) {
            ++other;
        }
        mark(look, (size_t)look->order[i], 0.0, marks);
        look->reach[i] = (double)other;
        look->start[i] = (double)next;
        next += i - other + 1;
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
    look->rows = lag_take(&memory, m * n);
    look->now = lag_take(&memory, m * n);
    look->first = lag_take(&memory, m + 1);
    look->column = lag_take(&memory, entries_of(model));
    look->order = lag_take(&memory, m);
    look->reach = lag_take(&memory, m);
    look->start = lag_take(&memory, m + 1);
    look->follows = lag_take(&memory, m);
    look->trial = lag_take(&memory, m);
    look->band = memory;
    if (m > 0) {
        list_columns(look);
        put_in_order(look);
        find_reach(look);
    }
    lag_fill(m, 0.0, look->follows);
    lag_fill(m, 0.0, look->trial);
    lag_fill(m * n, 0.0, look->rows);
    lag_fill(m * n, 0.0, look->now);
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

static double product(const lag_look *look, size_t row, const double *a, const double *b)
{
    double sum = 0.0;
    for (size_t k = (size_t)look->first[row]; k < (size_t)look->first[row + 1]; ++k) {
        sum += a[(size_t)look->column[k]] * b[(size_t)look->column[k]];
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
    const size_t n = look->n;
    for (size_t i = 0; i < look->m; ++i) {
        const size_t row = (size_t)look->order[i];
        const size_t reach = (size_t)look->reach[i];
        double *line = look->band + (size_t)look->start[i];
        for (size_t j = reach; j <= i; ++j) {
            const size_t other = (size_t)look->order[j];
            double sum = i == j ? 1.0 : 0.0;
            if (counts(look, row) && counts(look, other)) {
                sum = 0.5 * (product(look, row, a + row * n, b + other * n) + product(look, row, b + row * n, a + other * n));
                sum -= part > 0.0 ? part * product(look, row, b + row * n, b + other * n) : 0.0;
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
            look->now[i * n + j] = jacobian[i * n + j] * look->sizes[j] / look->row_sizes[i];
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
    memcpy(look->rows, look->now, look->m * look->n * sizeof(double));
    memcpy(look->follows, look->trial, look->m * sizeof(double));
    return look->margin > LAG_RANK_NEAR ? LAG_OK : LAG_ATTENTION;
}
