/* Rates of a start: fixed ones, then written ones as far as the constraints leave them free, then least kinetic energy of the change. */
#include <math.h>
#include <string.h>

#include "lag/beginning.h"
#include "lag/memory.h"
#include "lag/svd.h"

static const double RANK = 1e-9;
/* A rate that the remaining freedom moves by less than this part is decided by the others (dead centers). */
static const double INDEPENDENT = 1e-6;
static const double CONSISTENT = 1e-9;
/* What was met exactly is handed on exactly, not to within round-off. */
static const double EXACT = 1e-13;
/* In a singular position singular values of J are below this part of the largest. */
static const double LOST = 1e-7;
static const double DIFFERENCE = 1e-6;
static const double TARGET = 1e-13;
enum { DESCENTS = 100 };

typedef struct rates {
    lag_beginning *b;
    double *rows;              /* (nc, nq) J, natural sizes */
    double *conditions, *right; /* (nc + nq, nq) (nc + nq) with the fixed rates */
    double *v, *wanted;        /* (nq) rates in natural sizes */
    double *free, *unbound;    /* (nq, nq) rows: what is free still, and what constraints and fixed rates leave */
    size_t width, unbound_width;
    double *other, *mass, *inner; /* (nq, nq) */
    double *part, *change;     /* (nq) */
    double *force, *gamma;     /* (nq) (nc) */
    double *turned, *vanishing; /* (nq, nc) (nc, nc) */
    size_t lost;               /* combinations of rows that vanish */
    const double *along;       /* free or unbound, */
    size_t along_width;        /* with so many rows */
    double *descent, *svd;
} rates;

size_t lag_beginning_qd_memory(const lag_model *model)
{
    const size_t n = model->nq;
    const size_t m = model->nc;
    return 2 * m * n + (m + n) * n + m + n + 2 * n + 5 * n * n + 2 * n + n + m + m * m + lag_descent_memory(m, n) +
           lag_parts_memory(m, n) + lag_svd_memory(m + n, n) + lag_svd_memory(n, m);
}

static void place(rates *r, lag_beginning *b)
{
    const size_t n = b->motion->model->nq;
    const size_t m = b->motion->model->nc;
    double *memory = b->memory;
    memset(r, 0, sizeof *r);
    r->b = b;
    r->rows = lag_take(&memory, m * n);
    r->conditions = lag_take(&memory, (m + n) * n);
    r->right = lag_take(&memory, m + n);
    r->v = lag_take(&memory, n);
    r->wanted = lag_take(&memory, n);
    r->free = lag_take(&memory, n * n);
    r->unbound = lag_take(&memory, n * n);
    r->other = lag_take(&memory, n * n);
    r->mass = lag_take(&memory, n * n);
    r->inner = lag_take(&memory, n * n);
    r->part = lag_take(&memory, n);
    r->change = lag_take(&memory, n);
    r->force = lag_take(&memory, n);
    r->gamma = lag_take(&memory, m);
    r->turned = lag_take(&memory, n * m);
    r->vanishing = lag_take(&memory, m * m);
    r->descent = lag_take(&memory, lag_descent_memory(m, n) + lag_parts_memory(m, n));
    r->svd = memory;
}

static double product(size_t n, const double *a, const double *b)
{
    double sum = 0.0;
    for (size_t i = 0; i < n; ++i) {
        sum += a[i] * b[i];
    }
    return sum;
}

static void add(size_t n, double factor, const double *a, double *x)
{
    for (size_t i = 0; i < n; ++i) {
        x[i] += factor * a[i];
    }
}

/* J v + b = 0 and the fixed rates, as `conditions` v = `right`. Returns their number. */
static size_t state_conditions(rates *r)
{
    lag_beginning *b = r->b;
    const size_t n = b->motion->model->nq;
    const size_t m = b->motion->model->nc;
    size_t count = m;
    lag_fill(n, 0.0, b->qd);
    lag_beginning_velocities(b);
    for (size_t i = 0; i < m; ++i) {
        for (size_t j = 0; j < n; ++j) {
            r->rows[i * n + j] = b->jacobian[i * n + j] * b->sizes[j] / b->row_sizes[i];
        }
        r->right[i] = -b->phi[i] / b->row_sizes[i];
    }
    memcpy(r->conditions, r->rows, m * n * sizeof(double));
    for (size_t j = 0; j < n; ++j) {
        r->wanted[j] = b->x[n + j] / b->sizes[j];
        if (b->fixed[n + j] != 0.0) {
            lag_fill(n, 0.0, r->conditions + count * n);
            r->conditions[count * n + j] = 1.0;
            r->right[count++] = r->wanted[j];
        }
    }
    return count;
}

/* v of minimum norm, and what it leaves free; 0: the conditions contradict each other, which is told. */
static int satisfy(rates *r, size_t count)
{
    lag_beginning *b = r->b;
    const size_t n = b->motion->model->nq;
    const size_t m = b->motion->model->nc;
    const lag_svd svd = lag_svd_of(count, n, r->conditions, r->svd);
    const size_t rank = lag_svd_rank(&svd, RANK);
    double largest = 0.0;
    double worst = 0.0;
    size_t which = 0;
    lag_svd_solve(&svd, r->right, RANK, 0.0, r->v);
    for (size_t i = 0; i < count; ++i) {
        const double left = fabs(product(n, r->conditions + i * n, r->v) - r->right[i]);
        largest = fmax(largest, fabs(r->right[i]));
        if (left > worst) {
            worst = left;
            which = i;
        }
    }
    r->width = r->unbound_width = n - rank;
    memcpy(r->free, svd.v + rank * n, (n - rank) * n * sizeof(double));
    memcpy(r->unbound, r->free, (n - rank) * n * sizeof(double));
    if (worst <= CONSISTENT * (1.0 + largest)) {
        return 1;
    }
    b->told.fault = LAG_INITIAL_RATES;
    b->told.which = which;
    for (size_t j = 0, number = m; which >= m && j < n; ++j) {
        if (b->fixed[n + j] != 0.0 && number++ == which) {
            b->told.which = m + j;
            worst *= b->sizes[j];
        }
    }
    b->told.residual = which < m ? worst * b->row_sizes[which] : worst;
    return 0;
}

/* Written rates in turn, each if it is independent of the constraints and those before it. */
static void impose(rates *r)
{
    const lag_beginning *b = r->b;
    const size_t n = b->motion->model->nq;
    for (size_t j = 0; j < n; ++j) {
        double length = 0.0;
        if (b->written[n + j] == 0.0 || b->fixed[n + j] != 0.0) {
            continue;
        }
        for (size_t i = 0; i < r->width; ++i) {
            r->part[i] = r->free[i * n + j];
            length += r->part[i] * r->part[i];
        }
        if (!(sqrt(length) > INDEPENDENT)) {
            continue;
        }
        const double missing = (r->wanted[j] - r->v[j]) / length;
        for (size_t i = 0; i < r->width; ++i) {
            add(n, r->part[i] * missing, r->free + i * n, r->v);
        }
        const lag_svd svd = lag_svd_of(1, r->width, r->part, r->svd);
        for (size_t i = 0; i + 1 < r->width; ++i) {
            lag_fill(n, 0.0, r->other + i * n);
            for (size_t k = 0; k < r->width; ++k) {
                add(n, svd.v[(i + 1) * r->width + k], r->free + k * n, r->other + i * n);
            }
        }
        --r->width;
        memcpy(r->free, r->other, r->width * n * sizeof(double));
    }
}

/* The rest: nearest to the start values, then with the least kinetic energy of the change. */
static void complete(rates *r)
{
    lag_beginning *b = r->b;
    const lag_model *model = b->motion->model;
    const size_t n = model->nq;
    for (size_t j = 0; j < n; ++j) {
        r->change[j] = r->wanted[j] - r->v[j];
    }
    for (size_t i = 0; i < r->width; ++i) {
        add(n, product(n, r->free + i * n, r->change), r->free + i * n, r->v);
    }
    for (size_t j = 0; j < n; ++j) {
        b->qd[j] = r->v[j] * b->sizes[j];
        r->change[j] = r->wanted[j] - r->v[j];
    }
    if (r->width == 0 || model->mass_matrix(&b->motion->at, r->mass) != LAG_OK) {
        return;
    }
    for (size_t i = 0; i < r->width; ++i) { /* free' M, then free' M free and free' M (wanted - v) */
        for (size_t j = 0; j < n; ++j) {
            double sum = 0.0;
            for (size_t k = 0; k < n; ++k) {
                sum += r->free[i * n + k] * r->mass[k * n + j] * b->sizes[k] * b->sizes[j];
            }
            r->other[i * n + j] = sum;
        }
    }
    for (size_t i = 0; i < r->width; ++i) {
        for (size_t k = 0; k < r->width; ++k) {
            r->inner[i * r->width + k] = product(n, r->other + i * n, r->free + k * n);
        }
        r->part[i] = product(n, r->other + i * n, r->change);
    }
    const lag_svd svd = lag_svd_of(r->width, r->width, r->inner, r->svd);
    lag_svd_solve(&svd, r->part, RANK, 0.0, r->force);
    for (size_t i = 0; i < r->width; ++i) {
        add(n, r->force[i], r->free + i * n, r->v);
    }
}

/* ---- branches ---- */

/* n' gamma at rates v + along' y for every combination n of rows that vanishes: zero along a branch of the motion. */
static void bias(rates *r, const double *y, size_t moved, double by, double *result)
{
    lag_beginning *b = r->b;
    const lag_model *model = b->motion->model;
    const size_t n = model->nq;
    memcpy(r->part, r->v, n * sizeof(double));
    for (size_t i = 0; i < r->along_width; ++i) {
        add(n, y[i] + (i == moved ? by : 0.0), r->along + i * n, r->part);
    }
    for (size_t j = 0; j < n; ++j) {
        b->qd[j] = r->part[j] * b->sizes[j];
    }
    const lag_status status = model->dynamics(&b->motion->at, r->mass, r->force, r->turned, r->gamma);
    for (size_t i = 0; i < r->lost; ++i) {
        result[i] = status == LAG_OK ? 0.0 : (double)NAN;
        for (size_t k = 0; k < model->nc; ++k) {
            result[i] += r->vanishing[i * model->nc + k] * r->gamma[k] / b->row_sizes[k];
        }
    }
}

static void at_branches(void *context, const double *y, double *residual, double *jacobian)
{
    rates *r = context;
    for (size_t k = 0; k < r->along_width; ++k) {
        bias(r, y, k, -DIFFERENCE, residual);
        for (size_t i = 0; i < r->lost; ++i) {
            jacobian[i * r->along_width + k] = -residual[i];
        }
        bias(r, y, k, DIFFERENCE, residual);
        for (size_t i = 0; i < r->lost; ++i) {
            jacobian[i * r->along_width + k] = (jacobian[i * r->along_width + k] + residual[i]) / (2.0 * DIFFERENCE);
        }
    }
    bias(r, y, r->along_width, 0.0, residual);
}

static int descend_along(rates *r, const double *along, size_t width)
{
    const size_t n = r->b->motion->model->nq;
    const size_t m = r->b->motion->model->nc;
    double *memory = r->descent;
    const lag_equations equations = {r->lost, width, at_branches, r};
    lag_descent descent;
    r->along = along;
    r->along_width = width;
    const lag_parts parts = lag_parts_of(r->lost, width, NULL, lag_take(&memory, lag_parts_memory(m, n)));
    lag_descent_place(&descent, r->lost, width, memory);
    lag_fill(width, 0.0, r->change);
    lag_descend(&descent, &equations, &parts, TARGET, DESCENTS, r->change);
    if (!(lag_descent_size(&descent, &equations) <= LAG_HOLDS * fmax(1.0, product(n, r->v, r->v)))) {
        return 0;
    }
    for (size_t i = 0; i < width; ++i) {
        add(n, r->change[i], along + i * n, r->v);
    }
    return 1;
}

/*
 * In a singular position J leaves rates free that lead off the constraints at once: not along any branch of the motion. The nearest that
 * do not are taken; written ones are kept if that is possible.
 */
static void branch(rates *r)
{
    const lag_model *model = r->b->motion->model;
    const size_t n = model->nq;
    const size_t m = model->nc;
    for (size_t i = 0; i < m; ++i) {
        for (size_t j = 0; j < n; ++j) {
            r->turned[j * m + i] = r->rows[i * n + j];
        }
    }
    const lag_svd svd = lag_svd_of(n, m, r->turned, r->svd);
    const size_t rank = lag_svd_rank(&svd, LOST);
    if (rank >= model->rank) {
        return;
    }
    r->lost = m - rank;
    memcpy(r->vanishing, svd.v + rank * m, r->lost * m * sizeof(double));
    if (!descend_along(r, r->free, r->width)) {
        (void)descend_along(r, r->unbound, r->unbound_width);
    }
}

void lag_beginning_find_qd(lag_beginning *b, double *x)
{
    const size_t n = b->motion->model->nq;
    rates r;
    memcpy(b->q, x, n * sizeof(double));
    if (b->motion->model->nc == 0) {
        return;
    }
    place(&r, b);
    const int possible = satisfy(&r, state_conditions(&r));
    if (possible) {
        impose(&r);
        complete(&r);
        branch(&r);
    }
    for (size_t j = 0; j < n; ++j) {
        const double rate = r.v[j] * b->sizes[j];
        const double wanted = b->x[n + j];
        x[n + j] = possible && fabs(rate - wanted) <= EXACT * fmax(fabs(wanted), b->sizes[j]) ? wanted : rate;
    }
}
