/* Initial equations: positions, rates, states and accelerations solved together. */
#include <math.h>
#include <string.h>

#include "lag/beginning.h"
#include "lag/memory.h"
#include "lag/svd.h"

static const double TARGET = 1e-11;
static const double DIFFERENCE = 1e-6;
enum { TRIES = 12, DESCENTS = 100 };

typedef struct joint {
    lag_beginning *b;
    size_t rows, count;         /* of the equations; unknowns */
    double *free;               /* (count) which they are, of (q, qd, z) */
    double *scale;              /* (rows) */
    double *one, *other;        /* (rows) */
    double *y;                  /* (count) */
    double *x;                  /* (2 nq + nz) */
    double *qdd, *lam;          /* (nq) (nc) */
} joint;

static size_t count_rows(const lag_model *model)
{
    size_t rows = model->nc + model->ne;
    for (size_t i = 0; i < model->nc; ++i) {
        rows += model->position_level[i] != 0;
    }
    return rows;
}

size_t lag_beginning_all_memory(const lag_model *model)
{
    const size_t size = lag_motion_size(model);
    const size_t rows = count_rows(model);
    const size_t search = lag_parts_memory(rows, size) + lag_descent_memory(rows, size);
    const size_t ranks = rows * size + size + lag_svd_memory(rows, size);
    return 6 * size + 3 * rows + 2 * model->nq + model->nc + (search > ranks ? search : ranks);
}

static void put(const joint *all, const double *y)
{
    lag_beginning *b = all->b;
    const size_t n = b->motion->model->nq;
    memcpy(all->x, b->x, lag_motion_size(b->motion->model) * sizeof(double));
    for (size_t k = 0; k < all->count; ++k) {
        const size_t i = (size_t)all->free[k];
        all->x[i] += b->widths[i] * y[k];
    }
    memcpy(b->q, all->x, n * sizeof(double));
    memcpy(b->qd, all->x + n, n * sizeof(double));
    memcpy(b->z, all->x + 2 * n, b->motion->model->nz * sizeof(double));
}

/* Constraints of both levels, relative to their rows' sizes, then the initial equations in their own units. */
static void evaluate(const joint *all, const double *y, double *residual)
{
    lag_beginning *b = all->b;
    lag_motion *motion = b->motion;
    const lag_model *model = motion->model;
    put(all, y);
    if (model->nc > 0) {
        lag_beginning_positions(b);
        for (size_t i = 0; i < b->rows; ++i) {
            residual[i] = b->phi[(size_t)b->row[i]] / b->row_sizes[(size_t)b->row[i]];
        }
        lag_beginning_velocities(b);
        for (size_t i = 0; i < model->nc; ++i) {
            residual[b->rows + i] = b->phi[i] / b->row_sizes[i];
        }
    }
    motion->at.q = b->q;
    motion->at.qd = b->qd;
    motion->at.z = b->z;
    lag_status status = lag_forward_dynamics(model, &motion->at, motion->memory, all->qdd, all->lam, &motion->coordinate);
    lag_arguments at = motion->at;
    at.qdd = all->qdd;
    at.lam = all->lam;
    if (status == LAG_OK) {
        status = model->initial_equation(&at, residual + b->rows + model->nc);
    }
    if (status != LAG_OK) {
        lag_fill(model->ne, (double)NAN, residual + b->rows + model->nc);
    }
}

/* By central differences: rows of the initial equations hold accelerations, whose derivatives nobody else needs. */
static void differentiate(const joint *all, const double *y, double *jacobian)
{
    memcpy(all->y, y, all->count * sizeof(double));
    for (size_t k = 0; k < all->count; ++k) {
        all->y[k] = y[k] + DIFFERENCE;
        evaluate(all, all->y, all->one);
        all->y[k] = y[k] - DIFFERENCE;
        evaluate(all, all->y, all->other);
        all->y[k] = y[k];
        for (size_t i = 0; i < all->rows; ++i) {
            jacobian[i * all->count + k] = (all->one[i] - all->other[i]) / (2.0 * DIFFERENCE * all->scale[i]);
        }
    }
}

static void scaled(void *context, const double *y, double *residual, double *jacobian)
{
    const joint *all = context;
    differentiate(all, y, jacobian);
    evaluate(all, y, residual);
    for (size_t i = 0; i < all->rows; ++i) {
        residual[i] /= all->scale[i];
    }
}

/* Rows get the length one, at the start and with fixed values as unknowns, too. */
static void find_scale(joint *all, double *jacobian)
{
    const size_t size = lag_motion_size(all->b->motion->model);
    for (size_t i = 0; i < all->rows; ++i) {
        all->scale[i] = 1.0;
    }
    for (size_t k = 0; k < size; ++k) {
        all->free[k] = (double)k;
    }
    all->count = size;
    lag_fill(size, 0.0, all->x);
    double *zero = all->y + size;
    lag_fill(size, 0.0, zero);
    differentiate(all, zero, jacobian);
    for (size_t i = 0; i < all->rows; ++i) {
        double sum = 0.0;
        for (size_t k = 0; k < size; ++k) {
            sum += jacobian[i * size + k] * jacobian[i * size + k];
        }
        all->scale[i] = isfinite(sum) && sum > 0.0 ? sqrt(sum) : 1.0;
    }
    all->count = 0;
    for (size_t k = 0; k < size; ++k) {
        if (all->b->fixed[k] == 0.0) {
            all->free[all->count++] = (double)k;
        }
    }
}

static void tell(lag_beginning *b, const joint *all, const double *residual)
{
    double worst = -1.0;
    b->told.fault = LAG_INITIAL_EQUATIONS;
    for (size_t i = 0; i < all->rows; ++i) {
        const double size = isfinite(residual[i]) ? fabs(residual[i] * all->scale[i]) : (double)INFINITY;
        if (size > worst) {
            worst = size;
            b->told.which = i < b->rows ? (size_t)b->row[i] : i - b->rows;
            b->told.residual = size;
        }
    }
}

/* So many fixed values are too many, by ranks at the state that was found. */
static void count_excess(joint *all, const double *best, double *memory)
{
    lag_beginning *b = all->b;
    const size_t size = lag_motion_size(b->motion->model);
    double *matrix = lag_take(&memory, all->rows * size);
    double *point = lag_take(&memory, size);
    lag_fill(size, 0.0, point);
    for (size_t k = 0; k < all->count; ++k) {
        point[(size_t)all->free[k]] = best[k];
    }
    differentiate(all, best, matrix);
    const size_t part = lag_beginning_rank(all->rows, all->count, matrix, memory);
    for (size_t k = 0; k < size; ++k) {
        all->free[k] = (double)k;
    }
    all->count = size;
    differentiate(all, point, matrix);
    const size_t whole = lag_beginning_rank(all->rows, size, matrix, memory);
    b->told.excess = whole > part ? whole - part : 0;
    b->told.general = size - whole;
}

static double length_of(size_t count, const double *y)
{
    double sum = 0.0;
    for (size_t i = 0; i < count; ++i) {
        sum += y[i] * y[i];
    }
    return sqrt(sum);
}

void lag_beginning_find_all(lag_beginning *b, double *x)
{
    const lag_model *model = b->motion->model;
    const size_t size = lag_motion_size(model);
    const size_t rows = b->rows + model->nc + model->ne;
    double *memory = b->memory;
    joint all = {.b = b, .rows = rows};
    lag_descent descent;
    all.free = lag_take(&memory, size);
    all.scale = lag_take(&memory, rows);
    all.one = lag_take(&memory, rows);
    all.other = lag_take(&memory, rows);
    all.y = lag_take(&memory, 2 * size);
    all.x = lag_take(&memory, size);
    all.qdd = lag_take(&memory, model->nq);
    all.lam = lag_take(&memory, model->nc);
    double *best = lag_take(&memory, size);
    double *trial = lag_take(&memory, size);
    double *point = lag_take(&memory, model->nq);
    double *for_parts = lag_take(&memory, lag_parts_memory(rows, size));
    lag_descent_place(&descent, rows, size, memory);
    find_scale(&all, descent.jacobian);
    const lag_parts parts = lag_parts_of(rows, all.count, NULL, for_parts);
    const lag_equations equations = {rows, all.count, scaled, &all};
    unsigned long long seed = 20011;
    lag_fill(all.count, 0.0, best);
    lag_descend(&descent, &equations, &parts, TARGET, DESCENTS, best);
    double smallest = lag_descent_size(&descent, &equations);
    double nearest = (double)INFINITY;
    const size_t tries = smallest <= LAG_HOLDS ? 0 : TRIES; /* of which the nearest is taken */
    for (size_t k = 0; k < tries; ++k) {
        lag_beginning_point(b, &seed, k, b->x, point);
        for (size_t i = 0; i < all.count; ++i) {
            const size_t j = (size_t)all.free[i];
            trial[i] = j < model->nq ? (point[j] - b->x[j]) / b->widths[j] : 0.0;
        }
        lag_descend(&descent, &equations, &parts, TARGET, DESCENTS, trial);
        const double left = lag_descent_size(&descent, &equations);
        const double distance = length_of(all.count, trial);
        if (fmax(left, LAG_HOLDS) < fmax(smallest, LAG_HOLDS) || (left <= LAG_HOLDS && distance < nearest)) {
            smallest = left;
            nearest = distance;
            memcpy(best, trial, all.count * sizeof(double));
        }
    }
    put(&all, best);
    memcpy(x, all.x, size * sizeof(double));
    if (!(smallest <= LAG_HOLDS)) {
        evaluate(&all, best, all.one);
        for (size_t i = 0; i < rows; ++i) {
            all.one[i] /= all.scale[i];
        }
        tell(b, &all, all.one);
        count_excess(&all, best, for_parts);
    }
}
