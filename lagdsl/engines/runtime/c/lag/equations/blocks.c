#include "lag/equations/blocks.h"

#include <math.h>

#include "lag/linalg/arena.h"
#include "lag/linalg/disjoint_sets.h"
#include "lag/linalg/vector.h"

static size_t most_rows(const lag_model *model)
{
    return model->nc + (model->nreset < model->nq ? model->nreset : model->nq);
}

size_t lag_blocks_memory(const lag_model *model)
{
    const size_t n = model->nq;
    const size_t rows = most_rows(model);
    return (n + rows + 4) * n + model->nc + 2 * rows + lag_system_memory(n, rows);
}

lag_blocks lag_blocks_of(const lag_model *model, const double *mass, const double *jacobian, double *memory)
{
    const size_t n = model->nq;
    lag_blocks b = {.model = model, .mass = mass, .jacobian = jacobian, .memory = memory};
    lag_take_all(&b.memory, n, (double **const[]){&b.tied, &b.coordinate, &b.force, &b.change, NULL});
    lag_take_all(&b.memory, most_rows(model), (double **const[]){&b.right, &b.lam, NULL});
    b.place = lag_take(&b.memory, model->nc);
    b.own_mass = lag_take(&b.memory, n * n);
    b.own_rows = lag_take(&b.memory, most_rows(model) * n);
    lag_separate(n, b.tied);
    for (size_t i = 0; i < n; ++i) {
        lag_join_entries(b.tied, n, mass + i * n, i);
    }
    for (size_t i = 0; i < model->nc; ++i) {
        b.place[i] = (double)lag_first(n, jacobian + i * n);
        lag_join_entries(b.tied, n, jacobian + i * n, (size_t)b.place[i]);
    }
    return b;
}

int lag_blocks_take(lag_blocks *b, size_t which)
{
    b->n = 0;
    for (size_t j = which; j < b->model->nq && b->tied[which] == (double)which; ++j) {
        if (lag_set_of(b->tied, j) == which) {
            b->coordinate[b->n++] = (double)j;
        }
    }
    return b->n > 0;
}

void lag_blocks_gather(const lag_blocks *b, const double *x, double *own)
{
    for (size_t i = 0; i < b->n; ++i) {
        own[i] = x[(size_t)b->coordinate[i]];
    }
}

void lag_blocks_scatter(const lag_blocks *b, const double *own, double *x)
{
    for (size_t i = 0; i < b->n; ++i) {
        x[(size_t)b->coordinate[i]] = own[i];
    }
}

/* The rows of the block, and behind them those of what is held; so many of them are independent. */
static size_t gather_rows(lag_blocks *b, const double *residual, const double *held)
{
    const lag_model *model = b->model;
    size_t independent = 0;
    b->rows = 0;
    for (size_t i = 0; i < model->nc; ++i) {
        if (b->place[i] < (double)model->nq && (double)lag_set_of(b->tied, (size_t)b->place[i]) == b->coordinate[0]) {
            lag_blocks_gather(b, b->jacobian + i * model->nq, b->own_rows + b->rows * b->n);
            b->right[b->rows++] = residual != NULL ? -residual[i] : 0.0;
            independent += model->redundant == NULL || model->redundant[i] == 0;
        }
    }
    independent = independent < model->rank ? independent : model->rank;
    for (size_t j = 0; j < b->n && held != NULL; ++j) {
        if (held[(size_t)b->coordinate[j]] != 0.0) {
            lag_fill(b->n, 0.0, b->own_rows + b->rows * b->n);
            b->own_rows[b->rows * b->n + j] = 1.0;
            b->right[b->rows++] = 0.0;
            ++independent;
        }
    }
    return independent;
}

/* 1: the solution satisfies the rows and what is held. */
static int is_reached(const lag_blocks *b)
{
    double size = 1e-300;
    int reached = 1;
    for (size_t i = 0; i < b->rows; ++i) {
        size = fmax(size, fabs(b->right[i]));
    }
    for (size_t i = 0; i < b->rows; ++i) {
        const double *row = b->own_rows + i * b->n;
        const double rest = lag_dot(b->n, row, b->change) - b->right[i];
        reached = reached && fabs(rest) <= LAG_REACHED * (size + lag_dot_size(b->n, row, b->change));
    }
    return reached;
}

lag_status lag_blocks_solve(lag_blocks *b, const double *f, const double *residual, const double *held, size_t *coordinate)
{
    const size_t independent = gather_rows(b, residual, held);
    size_t own = 0;
    for (size_t i = 0; i < b->n; ++i) {
        lag_blocks_gather(b, b->mass + (size_t)b->coordinate[i] * b->model->nq, b->own_mass + i * b->n);
    }
    lag_blocks_gather(b, f, b->force);
    lag_system_place(&b->system, b->n, b->rows, NULL, b->memory);
    const lag_status status = lag_system_factor(&b->system, b->own_mass, b->own_rows, independent, &own);
    if (status == LAG_OK) {
        lag_system_solve(&b->system, b->force, b->right, b->change, b->lam);
    }
    if (held != NULL && (status != LAG_OK || !is_reached(b))) {
        return lag_blocks_solve(b, f, residual, NULL, coordinate);
    }
    if (status == LAG_SINGULAR && coordinate != NULL) {
        *coordinate = (size_t)b->coordinate[own];
    }
    return status;
}
