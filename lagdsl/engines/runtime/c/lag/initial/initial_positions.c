/* Positions of a start: the nearest at which written start values hold, where that is possible. */
#include <math.h>
#include <string.h>

#include "lag/equations/entries.h"
#include "lag/initial/initial_scaling.h"
#include "lag/linalg/arena.h"
#include "lag/linalg/svd.h"

/* Up to this residual, as a part of the rows' sizes, the start values are not moved. */
static const double THERE = 1e-15;
/* Up to this one, rows count as met while written start values are held: what is only nearly met there is met exactly elsewhere. */
static const double MET = 1e-11;

enum { SAMPLES = 3 };

typedef struct positions {
    lag_initialization *b;
    size_t count;  /* coordinates that are free */
    double *free;  /* (count) which they are */
    double *number; /* (nq) for each coordinate its place among them, or -1 */
    double *base;  /* (nq) where they begin */
    double *met;   /* (rows) 1: met while written start values were held */
} positions;

size_t lag_initialization_q_memory(const lag_model *model)
{
    const size_t m = lag_initialization_rows(model);
    const size_t n = model->nq;
    return 3 * n + m + n + LAG_NEAREST_GUESSES * n + lag_parts_memory(m, n) + lag_larger(lag_nearest_configuration_memory(m, n), m * n + lag_svd_memory(m, n));
}

/* True if initial equations determine coordinates of a row. */
static int is_joined(const lag_initialization *b, size_t row)
{
    const lag_entries entries = lag_entries_of(b->motion->model, row);
    int joined = 0;
    for (size_t k = entries.first; k < entries.end && b->equations.joined != NULL; ++k) {
        joined = joined || b->equations.joined[lag_entry_column(&entries, k)];
    }
    return joined;
}

static void put(const positions *p, const double *y)
{
    lag_initialization *b = p->b;
    memcpy(b->q, p->base, b->motion->model->nq * sizeof(double));
    for (size_t k = 0; k < p->count; ++k) {
        const size_t j = (size_t)p->free[k];
        b->q[j] += b->starts.widths[j] * y[k];
    }
}

static void at_positions(void *context, const lag_parts *parts, const double *y, double *residual, double *jacobian)
{
    const positions *p = context;
    lag_initialization *b = p->b;
    put(p, y);
    lag_initialization_positions(b);
    for (size_t which = 0; which < parts->count; ++which) {
        size_t first = 0;
        size_t begin = 0;
        const size_t rows = lag_parts_rows(parts, which, &first);
        const size_t columns = lag_parts_columns(parts, which, &begin);
        double *block = lag_parts_block(parts, which, jacobian);
        for (size_t i = 0; i < rows; ++i) {
            const size_t place = (size_t)parts->row[first + i];
            const size_t row = (size_t)b->row[place];
            const double *its = b->jacobian + row * b->motion->model->nq;
            residual[place] = is_joined(b, row) || p->met[place] != 0.0 ? 0.0 : b->phi[row] / b->row_sizes[row];
            for (size_t k = 0; k < columns; ++k) {
                const size_t j = (size_t)p->free[(size_t)parts->column[begin + k]];
                block[i * columns + k] = its[j] * b->starts.widths[j] / b->row_sizes[row];
            }
        }
    }
}

static int already_there(const positions *p)
{
    lag_initialization *b = p->b;
    int there = 1;
    memcpy(b->q, p->base, b->motion->model->nq * sizeof(double));
    lag_initialization_positions(b);
    for (size_t i = 0; i < b->rows; ++i) {
        const size_t row = (size_t)b->row[i];
        there = there && (fabs(b->phi[row]) <= THERE * b->row_sizes[row] || is_joined(b, row));
    }
    return there;
}

/* J of the rows of position level at b->q, of the free coordinates only if so asked, in natural sizes. */
static void gather(const positions *p, int only_free, double *matrix)
{
    const lag_initialization *b = p->b;
    const size_t n = b->motion->model->nq;
    const size_t width = only_free ? p->count : n;
    for (size_t i = 0; i < b->rows; ++i) {
        const size_t row = (size_t)b->row[i];
        for (size_t k = 0; k < width; ++k) {
            const size_t j = only_free ? (size_t)p->free[k] : k;
            matrix[i * width + k] = b->jacobian[row * n + j] * b->sizes[j] / b->row_sizes[row];
        }
    }
}

/* So many fixed coordinates are too many: by ranks in general positions, since a search stalls where the mechanism is stretched out. */
static void count_excess(const positions *p, double *point, double *memory)
{
    lag_initialization *b = p->b;
    const size_t n = b->motion->model->nq;
    double *matrix = lag_take(&memory, b->rows * n);
    unsigned long long seed = 20011;
    size_t excess = n;
    size_t most = 0;
    for (size_t k = 0; k < SAMPLES; ++k) {
        lag_initialization_point(b, &seed, k, b->starts.x, point);
        memcpy(b->q, point, n * sizeof(double));
        lag_initialization_positions(b);
        gather(p, 0, matrix);
        const size_t whole = lag_initialization_rank(b->rows, n, matrix, memory);
        gather(p, 1, matrix);
        const size_t part = lag_initialization_rank(b->rows, p->count, matrix, memory);
        excess = whole - part < excess ? whole - part : excess;
        most = whole > most ? whole : most;
    }
    b->told.excess = excess;
    b->told.general = n - most;
}

/* The row that is farthest off is told. */
static void record_worst(const positions *p, double *point, double *memory)
{
    lag_initialization *b = p->b;
    double worst = -1.0;
    lag_initialization_positions(b);
    for (size_t i = 0; i < b->rows; ++i) {
        const size_t row = (size_t)b->row[i];
        const double size = isfinite(b->phi[row]) ? fabs(b->phi[row]) / b->row_sizes[row] : (double)INFINITY;
        if (size > worst && !is_joined(b, row)) {
            worst = size;
            b->told.which = row;
            b->told.residual = fabs(b->phi[row]);
        }
    }
    b->told.fault = LAG_INITIAL_POSITIONS;
    count_excess(p, point, memory);
}

/* True if initial equations decide this coordinate, or it is fixed. */
static int is_given(const lag_initialization *b, size_t j)
{
    return b->starts.fixed[j] != 0.0 || (b->equations.joined != NULL && b->equations.joined[j]);
}

/* Coordinates that may move; written ones only if they need not be held. */
static void choose_movable(positions *p, int hold)
{
    const lag_initialization *b = p->b;
    p->count = 0;
    for (size_t j = 0; j < b->motion->model->nq; ++j) {
        if (!is_given(b, j) && !(hold && b->starts.written[j] != 0.0)) {
            p->free[p->count++] = (double)j;
        }
    }
}

/* Independent parts of the rows, by the coordinates that may move. */
static lag_parts find_parts(const positions *p, double *memory)
{
    const lag_initialization *b = p->b;
    const lag_model *model = b->motion->model;
    lag_parts parts = lag_parts_begin(b->rows, p->count, memory);
    for (size_t j = 0; j < model->nq; ++j) {
        p->number[j] = -1.0;
    }
    for (size_t k = 0; k < p->count; ++k) {
        p->number[(size_t)p->free[k]] = (double)k;
    }
    for (size_t i = 0; i < b->rows; ++i) {
        const lag_entries entries = lag_entries_of(model, (size_t)b->row[i]);
        for (size_t k = entries.first; k < entries.end; ++k) {
            const double number = p->number[lag_entry_column(&entries, k)];
            if (number >= 0.0) {
                lag_parts_join(&parts, i, (size_t)number);
            }
        }
    }
    lag_parts_end(&parts);
    return parts;
}

/* The nearest point on the chosen coordinates into b->q. Returns what is left of the rows. */
static double search(positions *p, double *point, double *memory)
{
    lag_initialization *b = p->b;
    lag_nearest_configuration nearest;
    double *guesses = lag_take(&memory, LAG_NEAREST_GUESSES * p->count);
    unsigned long long seed = 20011;
    for (size_t k = 0; k < LAG_NEAREST_GUESSES; ++k) {
        lag_initialization_point(b, &seed, k, b->starts.x, point);
        for (size_t i = 0; i < p->count; ++i) {
            const size_t j = (size_t)p->free[i];
            guesses[k * p->count + i] = (point[j] - b->starts.x[j]) / b->starts.widths[j];
        }
    }
    const lag_parts parts = find_parts(p, lag_take(&memory, lag_parts_memory(b->rows, p->count)));
    const lag_equations equations = {at_positions, p};
    lag_nearest_configuration_place(&nearest, &parts, memory);
    const double worst = lag_nearest_configuration_search(&nearest, &equations, guesses, LAG_HOLDS);
    put(p, nearest.best.point);
    return worst;
}

/*
 * Written start values are held where the others can meet the rows: these parts begin, and end, at the point that was found, in b->q. In all other
 * parts written ones may move, too. Returns whether there are any.
 */
static int open_parts(positions *p, double *memory)
{
    lag_initialization *b = p->b;
    double *open = lag_take(&memory, b->rows + b->motion->model->nq);
    int any = 0;
    choose_movable(p, 0);
    const lag_parts parts = find_parts(p, memory);
    lag_fill(parts.count, 0.0, open);
    lag_initialization_positions(b);
    for (size_t i = 0; i < b->rows; ++i) {
        const size_t row = (size_t)b->row[i];
        const int met = is_joined(b, row) || fabs(b->phi[row]) <= MET * b->row_sizes[row];
        open[(size_t)parts.row_part[i]] += met ? 0.0 : 1.0;
    }
    for (size_t i = 0; i < b->rows; ++i) {
        p->met[i] = open[(size_t)parts.row_part[i]] == 0.0;
        any = any || p->met[i] == 0.0;
    }
    size_t count = 0;
    for (size_t k = 0; k < p->count; ++k) {
        const size_t j = (size_t)p->free[k];
        if (open[(size_t)parts.column_part[k]] != 0.0) {
            p->free[count++] = (double)j;
        } else {
            p->base[j] = b->q[j];
        }
    }
    p->count = count;
    return any;
}

static int any_written(const lag_initialization *b)
{
    size_t j = 0;
    while (j < b->motion->model->nq && (is_given(b, j) || b->starts.written[j] == 0.0)) {
        ++j;
    }
    return j < b->motion->model->nq;
}

void lag_initialization_find_q(lag_initialization *b, double *x)
{
    const size_t n = b->motion->model->nq;
    double *memory = b->memory;
    positions p = {b, 0, lag_take(&memory, n), lag_take(&memory, n), lag_take(&memory, n), lag_take(&memory, b->rows)};
    double *point = lag_take(&memory, n);
    double worst = 0.0;
    for (size_t j = 0; j < n; ++j) {
        p.base[j] = b->equations.joined != NULL && b->equations.joined[j] ? x[j] : b->starts.x[j];
    }
    lag_fill(b->rows, 0.0, p.met);
    if (b->rows == 0 || already_there(&p)) {
        return;
    }
    const int hold = any_written(b);
    choose_movable(&p, hold);
    if (!hold || p.count > 0) {
        worst = search(&p, point, memory);
    }
    if (hold && open_parts(&p, memory)) {
        worst = search(&p, point, memory);
    }
    memcpy(x, b->q, n * sizeof(double));
    if (!(worst <= LAG_HOLDS)) {
        record_worst(&p, point, memory);
    }
}
