/*
 * One step of Newton's method in the impulse problem: a linear system of M and the rows, and the complementarity of gaps that strike. It is solved block by
 * block: coordinates that here no entry of M, of rows, of loads or of limits of friction ties to each other do not move each other.
 */
#include "lag/impulses/impulse.h"

#include <math.h>
#include <string.h>

#include "lag/impulses/friction_problem.h"
#include "lag/linalg/arena.h"
#include "lag/linalg/disjoint_sets.h"
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

/* Coordinates that inequalities tie. A row that is zero may count to any. */
static void tie_inequalities(block *b, size_t nq, const lag_inequalities *rows)
{
    for (size_t i = 0; i < rows->size; ++i) {
        b->inequality[i] = (double)(lag_first(nq, rows->rows + i * nq) % nq);
        lag_join_entries(b->tied, nq, rows->rows + i * nq, (size_t)b->inequality[i]);
        lag_join_entries(b->tied, nq, rows->columns + i * nq, (size_t)b->inequality[i]);
    }
    for (size_t k = 0; k < rows->frictions; ++k) {
        const size_t slip = (size_t)rows->slip[k];
        for (size_t i = 0; i < rows->normals; ++i) {
            if (rows->coefficients[k * rows->normals + i] != 0.0) {
                lag_join(b->tied, (size_t)b->inequality[slip], (size_t)b->inequality[i]);
            }
        }
        lag_join(b->tied, (size_t)b->inequality[slip], (size_t)b->inequality[slip + (size_t)rows->components[k] - 1]);
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
    lag_separate(n, b.tied);
    for (size_t i = 0; i < n; ++i) {
        lag_join_entries(b.tied, n, impulse->mass + i * n, i);
    }
    for (size_t i = 0; i < model->nc; ++i) {
        b.row[i] = (double)lag_first(n, impulse->jacobian + i * n);
        lag_join_entries(b.tied, n, impulse->jacobian + i * n, (size_t)b.row[i]);
    }
    tie_inequalities(&b, n, rows);
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
    b->n = b->normals = b->frictions = b->size = 0;
    for (size_t j = which; j < nq; ++j) {
        if (lag_set_of(b->tied, j) == which) {
            b->coordinate[b->n++] = (double)j;
        }
    }
    for (size_t i = 0; i < b->n; ++i) {
        gather(b, impulse->mass + (size_t)b->coordinate[i] * nq, b->mass + i * b->n);
    }
    for (size_t i = 0; i < rows->normals; ++i) {
        if (lag_set_of(b->tied, (size_t)b->inequality[i]) == which) {
            b->number[b->size++] = (double)i;
        }
    }
    b->normals = b->size;
    for (size_t k = 0; k < rows->frictions; ++k) {
        const int is_own = lag_set_of(b->tied, (size_t)b->inequality[(size_t)rows->slip[k]]) == which;
        for (size_t a = 0; a < (size_t)rows->components[k] && is_own; ++a) {
            b->number[b->size++] = rows->slip[k] + (double)a;
        }
        b->friction[b->frictions] = (double)k;
        b->frictions += (size_t)is_own;
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
        if (b->row[i] < (double)model->nq && lag_set_of(b->tied, (size_t)b->row[i]) == which) {
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

/* The change of the rates by momenta and impulses of the constraints, in the first order; 1: it satisfies the rows and what is held. */
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

/* The change of the rates in the block of this number by momenta (nq), and the residuals (nc; null: none) of the constraints. */
static lag_status solve_block(
    block *b, lag_impulse *impulse, size_t which, const double *momenta, const double *residual, const double *held, lag_inequalities *rows, const double *qd)
{
    take_block(b, impulse, rows, which);
    gather(b, momenta, b->force);
    lag_status status = factor(b, impulse, held, residual, which);
    const int reached = status == LAG_OK && change_by_constraints(b);
    if (held != NULL && !reached) {
        status = factor(b, impulse, NULL, residual, which);
        (void)(status == LAG_OK && change_by_constraints(b));
    }
    return status == LAG_OK && b->size > 0 ? change_by_inequalities(b, impulse, rows, qd) : status;
}

static lag_status solve(
    lag_impulse *impulse, const double *momenta, const double *residual, const double *held, lag_inequalities *rows, const double *qd, double *change)
{
    lag_inequalities none = {0};
    lag_inequalities *all = rows != NULL ? rows : &none;
    block b = find_blocks(impulse, all);
    lag_status status = LAG_OK;
    for (size_t which = 0; which < impulse->motion->model->nq && status == LAG_OK; ++which) {
        if (lag_set_of(b.tied, which) == which) {
            status = solve_block(&b, impulse, which, momenta, residual, held, all, qd);
            for (size_t i = 0; i < b.n; ++i) {
                change[(size_t)b.coordinate[i]] = b.change[i];
            }
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
