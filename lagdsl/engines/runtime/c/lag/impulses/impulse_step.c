/*
 * One step of Newton's method in the impulse problem: a linear system of M and the rows, and the complementarity of gaps that strike, in the blocks of
 * lag/equations/blocks.h. Columns of inequalities, which may bring loads along, and limits of friction tie coordinates, too.
 */
#include "lag/impulses/impulse.h"

#include <math.h>
#include <string.h>

#include "lag/equations/blocks.h"
#include "lag/linalg/arena.h"
#include "lag/linalg/disjoint_sets.h"
#include "lag/linalg/vector.h"
#include "lag/optimization/friction_problem.h"

/* Inequalities of one block. */
typedef struct members {
    size_t normals, frictions, size;
    double *number, *friction; /* (size) (frictions) which of all they are */
    double *place;             /* (all) a coordinate at which each acts */
    double *memory;
} members;

size_t lag_impulse_step_memory(const lag_model *model)
{
    const size_t k = model->ngap + model->nslip;
    const size_t problem = 2 * k * model->nq + k * k + 2 * k + model->nfriction * (model->ngap + 2);
    return lag_blocks_memory(model) + 2 * k + model->nfriction + problem + lag_friction_problem_memory(model->ngap, model->nfriction, k);
}

/* Ties coordinates by inequalities. A row that is zero may count to any. */
static members tie(double *tied, const lag_model *model, const lag_inequalities *rows, double *memory)
{
    const size_t nq = model->nq;
    members m = {.memory = memory};
    m.place = lag_take(&m.memory, rows->size);
    m.number = lag_take(&m.memory, rows->size);
    m.friction = lag_take(&m.memory, rows->frictions);
    for (size_t i = 0; i < rows->size; ++i) {
        m.place[i] = (double)(lag_first(nq, rows->rows + i * nq) % nq);
        lag_join_entries(tied, nq, rows->rows + i * nq, (size_t)m.place[i]);
        lag_join_entries(tied, nq, rows->columns + i * nq, (size_t)m.place[i]);
    }
    for (size_t k = 0; k < rows->frictions; ++k) {
        const size_t slip = (size_t)rows->slip[k];
        for (size_t i = 0; i < rows->normals; ++i) {
            if (rows->coefficients[k * rows->normals + i] != 0.0) {
                lag_join(tied, (size_t)m.place[slip], (size_t)m.place[i]);
            }
        }
        lag_join(tied, (size_t)m.place[slip], (size_t)m.place[slip + (size_t)rows->components[k] - 1]);
    }
    return m;
}

/* Lists the inequalities of the block of this number. */
static void list(members *m, const double *tied, const lag_inequalities *rows, size_t which)
{
    m->frictions = m->size = 0;
    for (size_t i = 0; i < rows->normals; ++i) {
        if (lag_set_of(tied, (size_t)m->place[i]) == which) {
            m->number[m->size++] = (double)i;
        }
    }
    m->normals = m->size;
    for (size_t k = 0; k < rows->frictions; ++k) {
        if (lag_set_of(tied, (size_t)m->place[(size_t)rows->slip[k]]) == which) {
            for (size_t a = 0; a < (size_t)rows->components[k]; ++a) {
                m->number[m->size++] = rows->slip[k] + (double)a;
            }
            m->friction[m->frictions++] = (double)k;
        }
    }
}

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
static lag_friction_problem begin_problem(const members *m, const lag_inequalities *rows, double **memory)
{
    lag_friction_problem p = {.normals = m->normals, .frictions = m->frictions};
    double *components = lag_take(memory, m->frictions);
    p.components = components;
    p.compliance = lag_take(memory, m->size * m->size);
    p.rates = lag_take(memory, m->size);
    p.limits = lag_take(memory, m->frictions);
    p.coefficients = lag_take(memory, m->frictions * m->normals);
    for (size_t k = 0; k < m->frictions; ++k) {
        const size_t from = (size_t)m->friction[k];
        components[k] = rows->components[from];
        p.limits[k] = rows->limits[from];
        for (size_t i = 0; i < m->normals; ++i) {
            p.coefficients[k * m->normals + i] = rows->coefficients[from * rows->normals + (size_t)m->number[i]];
        }
    }
    return p;
}

/* Adds the change by impulses of the rows that push one way, or slip; the rates so far are qd. */
static lag_status change_by_inequalities(lag_blocks *b, const members *m, const lag_impulse *impulse, lag_inequalities *rows, const double *qd)
{
    const size_t nq = impulse->motion->model->nq;
    const size_t n = b->n;
    double *memory = m->memory;
    double *own = lag_take(&memory, m->size * n);
    double *response = lag_take(&memory, m->size * n);
    double *force = lag_take(&memory, m->size);
    lag_friction_problem problem = begin_problem(m, rows, &memory);
    lag_fill(b->rows, 0.0, b->right);
    for (size_t k = 0; k < m->size; ++k) {
        lag_blocks_gather(b, rows->columns + (size_t)m->number[k] * nq, b->force);
        lag_blocks_gather(b, rows->rows + (size_t)m->number[k] * nq, own + k * n);
        lag_system_solve(&b->system, b->force, b->right, response + k * n, b->lam);
    }
    for (size_t k = 0; k < m->size; ++k) {
        const size_t i = (size_t)m->number[k];
        rows->after[i] = problem.rates[k] = lag_impulse_speed_at(impulse, rows, i, qd) + lag_dot(n, own + k * n, b->change);
        rows->scale[i] = fabs(rows->after[i]);
        for (size_t j = 0; j < m->size; ++j) {
            problem.compliance[k * m->size + j] = lag_dot(n, own + k * n, response + j * n);
        }
        rows->compliance[i] = problem.compliance[k * (m->size + 1)];
    }
    const int found = lag_friction_problem_solve(&problem, force, memory);
    for (size_t k = 0; k < m->size; ++k) {
        const size_t i = (size_t)m->number[k];
        rows->force[i] = force[k];
        lag_axpy(n, force[k], response + k * n, b->change);
        for (size_t j = 0; j < m->size; ++j) {
            const double term = force[j] * lag_dot(n, own + k * n, response + j * n);
            rows->after[i] += term;
            rows->scale[i] += fabs(term);
        }
    }
    return found ? LAG_OK : LAG_NO_FORCES;
}

lag_status lag_impulse_step_find(lag_impulse *impulse, const double *held, lag_inequalities *rows, const double *qd)
{
    lag_motion *motion = impulse->motion;
    const lag_model *model = motion->model;
    lag_inequalities none = {0};
    lag_inequalities *all = rows != NULL ? rows : &none;
    lag_blocks b = lag_blocks_of(model, impulse->mass, impulse->jacobian, impulse->work);
    members m = tie(b.tied, model, all, impulse->work + lag_blocks_memory(model));
    lag_status status = LAG_OK;
    for (size_t j = 0; j < model->nq; ++j) {
        impulse->from[j] = impulse->before[j] - impulse->now[j];
    }
    for (size_t which = 0; which < model->nq && status == LAG_OK; ++which) {
        if (lag_blocks_take(&b, which)) {
            list(&m, b.tied, all, which);
            status = lag_blocks_solve(&b, impulse->from, impulse->residual, held, &motion->coordinate);
            status = status == LAG_OK && m.size > 0 ? change_by_inequalities(&b, &m, impulse, rows, qd) : status;
            lag_blocks_scatter(&b, b.change, impulse->change);
        }
    }
    return status;
}

lag_status lag_impulse_respond(lag_impulse *impulse, const double *row, double *change)
{
    lag_blocks b = lag_blocks_of(impulse->motion->model, impulse->mass, impulse->jacobian, impulse->work);
    lag_status status = LAG_OK;
    for (size_t which = 0; which < impulse->motion->model->nq && status == LAG_OK; ++which) {
        if (lag_blocks_take(&b, which)) {
            status = lag_blocks_solve(&b, row, NULL, NULL, &impulse->motion->coordinate);
            lag_blocks_scatter(&b, b.change, change);
        }
    }
    return status;
}
