/*
 * One step of Newton's method in the impulse problem: a linear system of M and the rows, and the complementarity of gaps that strike. It is solved block by
 * block: coordinates that here no entry of M, of rows, of loads or of limits of friction ties to each other do not move each other.
 */
#include "lag/impulses/impulse.h"

#include <math.h>
#include <string.h>

#include "lag/impulses/friction_problem.h"
#include "lag/linalg/arena.h"
#include "lag/linalg/vector.h"

/* One block, of the coordinates that have this number. */
typedef struct block {
    double *tied;               /* (nq) a coordinate of the block of each; of the first one itself */
    double *row, *inequality;   /* (nc) (inequalities) a coordinate at which each has an entry; of a row that is zero nq */
    double *coordinate;         /* (n) */
    size_t n, rows, normals, frictions, size;
    double *mass, *jacobian;    /* (n, n) (rows, n) of the constraints, and behind them rates that are held */
    double *right, *lam;        /* (rows) */
    double *force, *change;     /* (n) */
    double *number;             /* (size) which inequality each is, */
    double *friction;           /* (frictions) which friction */
    lag_system system;
    double *memory;
} block;

static size_t most_rows(const lag_model *model)
{
    return model->nc + (model->nreset < model->nq ? model->nreset : model->nq);
}

size_t lag_impulse_step_memory(const lag_model *model)
{
    const size_t n = model->nq;
    const size_t rows = most_rows(model);
    const size_t k = model->ngap + model->nslip;
    const size_t problem = 2 * k * n + k * k + 2 * k + model->nfriction * (model->ngap + 2);
    return (n + rows + 4) * n + model->nc + 2 * rows + 2 * k + model->nfriction + lag_system_memory(n, rows) + problem +
        lag_friction_problem_memory(model->ngap, model->nfriction, k);
}

/* ---- blocks ---- */

static size_t block_of(const block *b, double at)
{
    size_t i = (size_t)at;
    while ((size_t)b->tied[i] != i) {
        i = (size_t)b->tied[i];
    }
    return i;
}

/* The coordinates at which a row (nq) has entries are of the block of coordinate `with`. */
static void tie(block *b, size_t nq, const double *row, double with)
{
    for (size_t j = 0; j < nq; ++j) {
        if (row[j] != 0.0) {
            const size_t one = block_of(b, with);
            const size_t other = block_of(b, (double)j);
            b->tied[one > other ? one : other] = (double)(one < other ? one : other);
        }
    }
}

/* A row that is zero may count to any block. */
static void tie_inequalities(block *b, size_t nq, const lag_inequalities *rows)
{
    size_t slip = rows->normals;
    for (size_t i = 0; i < rows->size; ++i) {
        b->inequality[i] = (double)(lag_first(nq, rows->rows + i * nq) % nq);
        tie(b, nq, rows->rows + i * nq, b->inequality[i]);
        tie(b, nq, rows->columns + i * nq, b->inequality[i]);
    }
    for (size_t k = 0; k < rows->frictions; ++k) {
        for (size_t i = 0; i < rows->normals; ++i) {
            if (rows->coefficients[k * rows->normals + i] != 0.0) {
                tie(b, nq, rows->rows + i * nq, b->inequality[slip]);
            }
        }
        slip += (size_t)rows->components[k];
        tie(b, nq, rows->rows + (slip - 1) * nq, b->inequality[slip - (size_t)rows->components[k]]);
    }
}

/* All blocks, none of which is taken. */
static block find_blocks(lag_impulse *impulse, const lag_inequalities *rows)
{
    const lag_model *model = impulse->motion->model;
    const size_t n = model->nq;
    block b = {.memory = impulse->work};
    lag_take_all(&b.memory, n, (double **const[]){&b.tied, &b.coordinate, &b.force, &b.change, NULL});
    lag_take_all(&b.memory, model->ngap + model->nslip, (double **const[]){&b.inequality, &b.number, NULL});
    b.friction = lag_take(&b.memory, model->nfriction);
    b.row = lag_take(&b.memory, model->nc);
    b.mass = lag_take(&b.memory, n * n);
    b.jacobian = lag_take(&b.memory, most_rows(model) * n);
    lag_take_all(&b.memory, most_rows(model), (double **const[]){&b.right, &b.lam, NULL});
    for (size_t i = 0; i < n; ++i) {
        b.tied[i] = (double)i;
    }
    for (size_t i = 0; i < n; ++i) {
        tie(&b, n, impulse->mass + i * n, (double)i);
    }
    for (size_t i = 0; i < model->nc; ++i) {
        b.row[i] = (double)lag_first(n, impulse->jacobian + i * n);
        tie(&b, n, impulse->jacobian + i * n, b.row[i]);
    }
    if (rows != NULL) {
        tie_inequalities(&b, n, rows);
    }
    return b;
}

/* The entries of a row (nq) in the block, into `own` (n). */
static void gather(const block *b, const double *row, double *own)
{
    for (size_t i = 0; i < b->n; ++i) {
        own[i] = row[(size_t)b->coordinate[i]];
    }
}

/* The coordinates of the block of this number, M, and the inequalities. */
static void take_block(block *b, const lag_impulse *impulse, const lag_inequalities *rows, size_t which)
{
    const size_t nq = impulse->motion->model->nq;
    size_t slip = rows != NULL ? rows->normals : 0;
    b->n = b->normals = b->frictions = b->size = 0;
    for (size_t j = which; j < nq; ++j) {
        if (block_of(b, (double)j) == which) {
            b->coordinate[b->n++] = (double)j;
        }
    }
    for (size_t i = 0; i < b->n; ++i) {
        gather(b, impulse->mass + (size_t)b->coordinate[i] * nq, b->mass + i * b->n);
    }
    for (size_t i = 0; rows != NULL && i < rows->normals; ++i) {
        if (block_of(b, b->inequality[i]) == which) {
            b->number[b->size++] = (double)i;
        }
    }
    b->normals = b->size;
    for (size_t k = 0; rows != NULL && k < rows->frictions; ++k) {
        const int is_own = block_of(b, b->inequality[slip]) == which;
        for (size_t a = 0; a < (size_t)rows->components[k] && is_own; ++a) {
            b->number[b->size++] = (double)(slip + a);
        }
        b->friction[b->frictions] = (double)k;
        b->frictions += (size_t)is_own;
        slip += (size_t)rows->components[k];
    }
}

/* ---- constraints ---- */

/* Factors M and the rows, with those of rates that are held behind the constraints, which ask for the residuals to vanish, if they do. */
static lag_status factor(block *b, lag_impulse *impulse, const double *held, const double *residual, size_t which)
{
    const lag_model *model = impulse->motion->model;
    size_t most = 0;
    double *memory = b->memory;
    b->rows = 0;
    for (size_t i = 0; i < model->nc; ++i) {
        if (b->row[i] < (double)model->nq && block_of(b, b->row[i]) == which) {
            gather(b, impulse->jacobian + i * model->nq, b->jacobian + b->rows * b->n);
            b->right[b->rows++] = residual != NULL ? -residual[i] : 0.0;
            most += model->redundant == NULL || model->redundant[i] == 0;
        }
    }
    most = most < model->rank ? most : model->rank;
    for (size_t j = 0; j < b->n && held != NULL; ++j) {
        if (held[(size_t)b->coordinate[j]] != 0.0) {
            lag_fill(b->n, 0.0, b->jacobian + b->rows * b->n);
            b->jacobian[b->rows * b->n + j] = 1.0;
            b->right[b->rows++] = 0.0;
            ++most;
        }
    }
    lag_system_place(&b->system, b->n, b->rows, NULL, lag_take(&memory, lag_system_memory(b->n, b->rows)));
    const lag_status status = lag_system_factor(&b->system, b->mass, b->jacobian, most, &impulse->motion->coordinate);
    impulse->motion->coordinate = status == LAG_SINGULAR ? (size_t)b->coordinate[impulse->motion->coordinate] : impulse->motion->coordinate;
    return status;
}

/* The change of the rates by impulses of the constraints, in the first order; 1: it satisfies the rows and what is held. */
static int change_by_constraints(block *b)
{
    double size = 1e-300;
    int reached = 1;
    lag_system_solve(&b->system, b->force, b->right, b->change, b->lam);
    for (size_t i = 0; i < b->rows; ++i) {
        size = fmax(size, fabs(b->right[i]));
    }
    for (size_t i = 0; i < b->rows; ++i) {
        const double *row = b->jacobian + i * b->n;
        const double rest = lag_dot(b->n, row, b->change) - b->right[i];
        reached = reached && fabs(rest) <= LAG_REACHED * (size + lag_dot_size(b->n, row, b->change));
    }
    return reached;
}

/* ---- inequalities ---- */

double lag_impulse_speed_at(const lag_impulse *impulse, const lag_inequalities *rows, size_t i, const double *qd)
{
    const size_t n = impulse->motion->model->nq;
    double speed = rows->speed[i];
    for (size_t j = 0; j < n; ++j) {
        speed += rows->rows[i * n + j] * (qd[j] - impulse->rates[j]);
    }
    return speed;
}

/* The problem of the rows of the block, less its matrix and its rates. */
static lag_friction_problem begin_problem(const block *b, const lag_inequalities *rows, double **memory)
{
    lag_friction_problem p = {.normals = b->normals, .frictions = b->frictions};
    double *components = lag_take(memory, b->frictions);
    p.components = components;
    p.compliance = lag_take(memory, b->size * b->size);
    p.rates = lag_take(memory, b->size);
    p.limits = lag_take(memory, b->frictions);
    p.coefficients = lag_take(memory, b->frictions * b->normals);
    for (size_t k = 0; k < b->frictions; ++k) {
        const size_t from = (size_t)b->friction[k];
        components[k] = rows->components[from];
        p.limits[k] = rows->limits[from];
        for (size_t i = 0; i < b->normals; ++i) {
            p.coefficients[k * b->normals + i] = rows->coefficients[from * rows->normals + (size_t)b->number[i]];
        }
    }
    return p;
}

/* Adds the change by impulses of the rows that push one way, or slip; the rates so far are qd. */
static lag_status change_by_inequalities(block *b, const lag_impulse *impulse, lag_inequalities *rows, const double *qd)
{
    const size_t nq = impulse->motion->model->nq;
    const size_t n = b->n;
    double *memory = b->memory + lag_system_memory(n, b->rows);
    double *own = lag_take(&memory, b->size * n);
    double *response = lag_take(&memory, b->size * n);
    double *force = lag_take(&memory, b->size);
    lag_friction_problem problem = begin_problem(b, rows, &memory);
    lag_fill(b->rows, 0.0, b->right);
    for (size_t k = 0; k < b->size; ++k) {
        gather(b, rows->columns + (size_t)b->number[k] * nq, b->force);
        gather(b, rows->rows + (size_t)b->number[k] * nq, own + k * n);
        lag_system_solve(&b->system, b->force, b->right, response + k * n, b->lam);
    }
    for (size_t k = 0; k < b->size; ++k) {
        const size_t i = (size_t)b->number[k];
        rows->after[i] = problem.rates[k] = lag_impulse_speed_at(impulse, rows, i, qd) + lag_dot(n, own + k * n, b->change);
        rows->scale[i] = fabs(rows->after[i]);
        for (size_t j = 0; j < b->size; ++j) {
            problem.compliance[k * b->size + j] = lag_dot(n, own + k * n, response + j * n);
        }
        rows->compliance[i] = problem.compliance[k * (b->size + 1)];
    }
    const lag_status status = lag_friction_problem_solve(&problem, force, memory);
    for (size_t k = 0; k < b->size; ++k) {
        const size_t i = (size_t)b->number[k];
        rows->force[i] = force[k];
        lag_axpy(n, force[k], response + k * n, b->change);
        for (size_t j = 0; j < b->size; ++j) {
            const double term = force[j] * lag_dot(n, own + k * n, response + j * n);
            rows->after[i] += term;
            rows->scale[i] += fabs(term);
        }
    }
    return status;
}

/* ---- the step ---- */

/* The change (nq) of the rates by momenta `force` (nq), block by block; those that nothing moves stay. */
static lag_status solve(lag_impulse *impulse, const double *force, const double *residual, const double *held, lag_inequalities *rows, const double *qd, double *change)
{
    block b = find_blocks(impulse, rows);
    lag_status status = LAG_OK;
    for (size_t which = 0; which < impulse->motion->model->nq && status == LAG_OK; ++which) {
        if (block_of(&b, (double)which) != which) {
            continue;
        }
        take_block(&b, impulse, rows, which);
        gather(&b, force, b.force);
        status = factor(&b, impulse, held, residual, which);
        const int reached = status == LAG_OK && change_by_constraints(&b);
        if (held != NULL && !reached) {
            status = factor(&b, impulse, NULL, residual, which);
            (void)(status == LAG_OK && change_by_constraints(&b));
        }
        status = status == LAG_OK && b.size > 0 ? change_by_inequalities(&b, impulse, rows, qd) : status;
        for (size_t i = 0; i < b.n; ++i) {
            change[(size_t)b.coordinate[i]] = b.change[i];
        }
    }
    return status;
}

lag_status lag_impulse_step_find(lag_impulse *impulse, const double *held, lag_inequalities *rows, const double *qd)
{
    for (size_t j = 0; j < impulse->motion->model->nq; ++j) {
        impulse->from[j] = impulse->before[j] - impulse->now[j];
    }
    return solve(impulse, impulse->from, impulse->residual, held, rows, qd, impulse->change);
}

lag_status lag_impulse_respond(lag_impulse *impulse, const double *row, double *change)
{
    return solve(impulse, row, NULL, NULL, NULL, NULL, change);
}
