/* The order in which a start is found, and its positions. */
#include "lag/initial.h"

#include <math.h>
#include <string.h>

#include "lag/initial/initialization.h"
#include "lag/linalg/arena.h"
#include "lag/linalg/svd.h"

/* Up to this residual, as a part of the rows' sizes, the start values are not moved. */
static const double THERE = 1e-15;
/* Up to this one, rows count as met while written start values are held: what is only nearly met there is met exactly elsewhere. */
static const double MET = 1e-11;

enum { SAMPLES = 3 };

/* ---- positions ---- */

typedef struct positions {
    lag_initialization *b;
    size_t count;  /* coordinates that are free */
    double *free;  /* (count) which they are */
    double *base;  /* (nq) where they begin */
    double *met;   /* (rows) 1: met while written start values were held */
} positions;

size_t lag_initialization_q_memory(const lag_model *model)
{
    const size_t m = lag_initialization_rows(model);
    const size_t n = model->nq;
    return 2 * n + m + m * n + n + LAG_NEAREST_OTHERS * n + lag_parts_memory(m, n) + lag_larger(lag_nearest_configuration_memory(m, n), m * n + lag_svd_memory(m, n));
}

/* True if initial equations determine coordinates of a row. */
static int is_joined(const lag_initialization *b, size_t row)
{
    const size_t n = b->motion->model->nq;
    size_t j = 0;
    while (b->joined != NULL && j < n && !(b->joined[j] && b->pattern[row * n + j] != 0.0)) {
        ++j;
    }
    return b->joined != NULL && j < n;
}

static void put(const positions *p, const double *y)
{
    lag_initialization *b = p->b;
    memcpy(b->q, p->base, b->motion->model->nq * sizeof(double));
    for (size_t k = 0; k < p->count; ++k) {
        const size_t j = (size_t)p->free[k];
        b->q[j] += b->widths[j] * y[k];
    }
}

static void at_positions(void *context, const double *y, double *residual, double *jacobian)
{
    const positions *p = context;
    lag_initialization *b = p->b;
    put(p, y);
    lag_initialization_positions(b);
    for (size_t i = 0; i < b->rows; ++i) {
        const size_t row = (size_t)b->row[i];
        residual[i] = is_joined(b, row) || p->met[i] != 0.0 ? 0.0 : b->phi[row] / b->row_sizes[row];
        for (size_t k = 0; k < p->count; ++k) {
            const size_t j = (size_t)p->free[k];
            jacobian[i * p->count + k] = b->jacobian[row * b->motion->model->nq + j] * b->widths[j] / b->row_sizes[row];
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
        lag_initialization_point(b, &seed, k, b->x, point);
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
static void tell(const positions *p, double *point, double *memory)
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
    return b->fixed[j] != 0.0 || (b->joined != NULL && b->joined[j]);
}

/* Coordinates that may move; written ones only if they need not be held. */
static void choose(positions *p, int hold)
{
    const lag_initialization *b = p->b;
    p->count = 0;
    for (size_t j = 0; j < b->motion->model->nq; ++j) {
        if (!is_given(b, j) && !(hold && b->written[j] != 0.0)) {
            p->free[p->count++] = (double)j;
        }
    }
}

/* Independent parts of the rows, by the coordinates that may move. */
static lag_parts find_parts(const positions *p, double *pattern, double *memory)
{
    const lag_initialization *b = p->b;
    for (size_t i = 0; i < b->rows; ++i) {
        for (size_t k = 0; k < p->count; ++k) {
            pattern[i * p->count + k] = b->pattern[(size_t)b->row[i] * b->motion->model->nq + (size_t)p->free[k]];
        }
    }
    return lag_parts_of(b->rows, p->count, pattern, memory);
}

/* The nearest point on the chosen coordinates into b->q. Returns what is left of the rows. */
static double search(positions *p, double *point, double *memory)
{
    lag_initialization *b = p->b;
    lag_nearest_configuration nearest;
    double *pattern = lag_take(&memory, b->rows * p->count);
    double *others = lag_take(&memory, LAG_NEAREST_OTHERS * p->count);
    unsigned long long seed = 20011;
    for (size_t k = 0; k < LAG_NEAREST_OTHERS; ++k) {
        lag_initialization_point(b, &seed, k, b->x, point);
        for (size_t i = 0; i < p->count; ++i) {
            const size_t j = (size_t)p->free[i];
            others[k * p->count + i] = (point[j] - b->x[j]) / b->widths[j];
        }
    }
    const lag_parts parts = find_parts(p, pattern, lag_take(&memory, lag_parts_memory(b->rows, p->count)));
    const lag_equations equations = {b->rows, p->count, at_positions, p};
    lag_nearest_configuration_place(&nearest, b->rows, p->count, memory);
    const double worst = lag_nearest_configuration_search(&nearest, &equations, &parts, others, LAG_HOLDS);
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
    choose(p, 0);
    double *pattern = lag_take(&memory, b->rows * p->count);
    const lag_parts parts = find_parts(p, pattern, memory);
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
    while (j < b->motion->model->nq && (is_given(b, j) || b->written[j] == 0.0)) {
        ++j;
    }
    return j < b->motion->model->nq;
}

void lag_initialization_find_q(lag_initialization *b, double *x)
{
    const size_t n = b->motion->model->nq;
    double *memory = b->memory;
    positions p = {b, 0, lag_take(&memory, n), lag_take(&memory, n), lag_take(&memory, b->rows)};
    double *point = lag_take(&memory, n);
    double worst = 0.0;
    for (size_t j = 0; j < n; ++j) {
        p.base[j] = b->joined != NULL && b->joined[j] ? x[j] : b->x[j];
    }
    lag_fill(b->rows, 0.0, p.met);
    if (b->rows == 0 || already_there(&p)) {
        return;
    }
    const int hold = any_written(b);
    choose(&p, hold);
    if (!hold || p.count > 0) {
        worst = search(&p, point, memory);
    }
    if (hold && open_parts(&p, memory)) {
        worst = search(&p, point, memory);
    }
    memcpy(x, b->q, n * sizeof(double));
    if (!(worst <= LAG_HOLDS)) {
        tell(&p, point, memory);
    }
}

/* ---- all of it ---- */

size_t lag_initial_memory(const lag_model *model)
{
    const size_t q = lag_larger(lag_initialization_q_memory(model), lag_initialization_qd_memory(model));
    const size_t all = model->ne > 0 ? lag_initialization_all_memory(model) : 0;
    const size_t ranks = lag_larger(lag_initialization_rank_memory(model), model->nc * model->nq + lag_svd_memory(model->nc, model->nq));
    const size_t sizes = lag_initialization_row_sizes_memory(model);
    return model->nc + model->ne == 0 ? 0 : lag_initialization_memory(model) + lag_larger(lag_larger(q, all), lag_larger(ranks, sizes));
}

static size_t first_wrong(size_t count, const double *x)
{
    size_t i = 0;
    while (i < count && isfinite(x[i])) {
        ++i;
    }
    return i;
}

/* A start value or a row there that is no number. */
static int find_no_number(lag_initialization *b)
{
    const lag_model *model = b->motion->model;
    const size_t size = lag_motion_size(model);
    size_t wrong = first_wrong(size, b->x);
    if (wrong == size && model->nc > 0) {
        lag_initialization_positions(b);
        const size_t row = first_wrong(model->nc, b->phi);
        lag_initialization_velocities(b);
        const size_t other = first_wrong(model->nc, b->phi);
        wrong += row < other ? row : other;
    }
    if (wrong == size + model->nc) {
        return 0;
    }
    b->told.fault = LAG_INITIAL_NUMBERS;
    b->told.which = wrong;
    return 1;
}

/* Ranks are those the model was compiled with where nothing is other than then. */
static int as_compiled(const lag_initialization *b, const unsigned char *set)
{
    int alike = lag_initialization_has_defaults(b);
    for (size_t i = 0; alike && set != NULL && i < lag_motion_size(b->motion->model); ++i) {
        alike = !set[i];
    }
    return alike;
}

static void find(lag_initialization *b, const unsigned char *set, double *x)
{
    const lag_model *model = b->motion->model;
    if (b->told.fault != LAG_INITIAL_NONE || find_no_number(b)) {
        return;
    }
    if (model->ne > 0 && !b->told.given) {
        double *memory = b->memory;
        lag_initialization_find_all(b, x);
        b->memory = memory;
    } else {
        lag_initialization_find_q(b, x);
        if (b->told.fault == LAG_INITIAL_NONE) {
            lag_initialization_find_qd(b, x);
        }
    }
    if (b->told.fault == LAG_INITIAL_NONE && model->nc > 0 && !as_compiled(b, set)) {
        lag_initialization_find_rank(b, x);
    }
}

/* Rates that the constraints leave free at x. */
static size_t find_freedom(lag_initialization *b, const unsigned char *set, const double *x)
{
    const lag_model *model = b->motion->model;
    const size_t n = model->nq;
    double *memory = b->memory;
    double *matrix = lag_take(&memory, model->nc * n);
    memcpy(b->q, x, n * sizeof(double));
    lag_initialization_velocities(b);
    if (as_compiled(b, set) && lag_initialization_is_regular(b, memory)) {
        return n - model->rank;
    }
    for (size_t i = 0; i < model->nc; ++i) {
        for (size_t j = 0; j < n; ++j) {
            matrix[i * n + j] = b->jacobian[i * n + j] * b->sizes[j] / b->row_sizes[i];
        }
    }
    return n - lag_initialization_rank(model->nc, n, matrix, memory);
}

static void copy(size_t count, const double *x, double *to)
{
    if (to != NULL) {
        memcpy(to, x, count * sizeof(double));
    }
}

static int differ(size_t count, const double *x, const double *y)
{
    size_t i = 0;
    while (i < count && x[i] == y[i]) {
        ++i;
    }
    return i < count;
}

/* A free parameter beyond its bounds. */
static void check_bounds(const lag_model *model, const lag_start *start, lag_initial *found)
{
    const int bounded = start != NULL && start->free != NULL && start->parameter_minimum != NULL && start->parameter_maximum != NULL;
    for (size_t i = 0; i < model->np && bounded && found->p != NULL && found->fault == LAG_INITIAL_NONE; ++i) {
        if (start->free[i] && !(found->p[i] >= start->parameter_minimum[i] && found->p[i] <= start->parameter_maximum[i])) {
            found->fault = LAG_INITIAL_BOUNDS;
            found->which = i;
            found->residual = found->p[i];
        }
    }
}

lag_status lag_initial_find(lag_motion *motion, const lag_start *start, const unsigned char *set, double t, double *x, double *memory,
    lag_initial *told)
{
    const lag_model *model = motion->model;
    lag_initialization b;
    lag_initial found = {.rank = model->rank, .freedom = model->nq};
    if (told != NULL) {
        found.given = told->given;
        found.dependent = told->dependent;
        found.row_sizes = told->row_sizes;
        found.pattern = told->pattern;
        found.p = told->p;
    }
    for (size_t i = 0; found.dependent != NULL && i < model->nc; ++i) {
        found.dependent[i] = model->redundant != NULL && model->redundant[i];
    }
    lag_status status = LAG_OK;
    if (start != NULL && start->free != NULL && found.p != NULL) { /* they are changed from here on */
        memmove(found.p, motion->at.p, model->np * sizeof(double));
        status = lag_motion_parameters(motion, found.p);
    }
    if (status == LAG_OK && model->nc + model->ne > 0) {
        lag_initialization_place(&b, motion, memory);
        b.told = found;
        status = lag_initialization_at(&b, start, set, t, x);
        if (status == LAG_OK) {
            find(&b, set, x);
            b.told.freedom = find_freedom(&b, set, x);
            copy(model->nc, b.row_sizes, found.row_sizes);
            copy(model->nc * model->nq, b.pattern, found.pattern);
            found = b.told;
            found.moved = differ(lag_motion_size(model), b.x, x);
            check_bounds(model, start, &found);
            status = found.fault == LAG_INITIAL_NONE ? LAG_OK : found.fault == LAG_INITIAL_NUMBERS ? LAG_NOT_FINITE : LAG_PROJECTION_FAILED;
        }
        lag_motion_look(motion, t, x);
    }
    if (told != NULL) {
        *told = found;
    }
    return status;
}
