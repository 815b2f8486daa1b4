/* One step of Newton's method in the impulse problem: a linear system of M and the rows, and the complementarity of gaps that strike. */
#include "lag/impulses/impulse.h"

#include <math.h>
#include <string.h>

#include "lag/impulses/friction_problem.h"
#include "lag/linalg/arena.h"
#include "lag/linalg/vector.h"

/* Rows of the constraints, and behind them rates that are held. */
static size_t most_rows(const lag_model *model)
{
    return model->nc + (model->nreset < model->nq ? model->nreset : model->nq);
}

size_t lag_impulse_step_memory(const lag_model *model)
{
    const size_t n = model->nq;
    const size_t rows = most_rows(model);
    const size_t k = model->ngap + model->nslip;
    const size_t problem = k * n + k * k + 2 * k + model->nfriction * (model->ngap + 1);
    return rows * n + 2 * rows + n + lag_system_memory(n, rows) + problem + lag_friction_problem_memory(model->ngap, model->nfriction, k);
}

/* The system of one step, in the work of the problem. */
typedef struct step_system {
    lag_system system;
    size_t rows;            /* of the constraints, and rates that are held */
    double *jacobian;       /* (rows, nq) */
    double *right, *lam;    /* (rows) */
    double *force;          /* (nq) */
    double *work;           /* of the gaps */
} step_system;

/* Factors M and the rows, with those of rates that are held behind the constraints. */
static lag_status factor(lag_impulse *impulse, const double *held, step_system *s)
{
    const lag_model *model = impulse->motion->model;
    const size_t n = model->nq;
    double *memory = impulse->work;
    s->jacobian = lag_take(&memory, most_rows(model) * n);
    s->right = lag_take(&memory, most_rows(model));
    s->lam = lag_take(&memory, most_rows(model));
    s->force = lag_take(&memory, n);
    s->rows = model->nc;
    memcpy(s->jacobian, impulse->jacobian, model->nc * n * sizeof(double));
    for (size_t i = 0; i < model->nc; ++i) {
        s->right[i] = -impulse->residual[i];
    }
    for (size_t j = 0; j < n && held != NULL; ++j) {
        if (held[j] != 0.0) {
            double *row = s->jacobian + s->rows * n;
            lag_fill(n, 0.0, row);
            row[j] = 1.0;
            s->right[s->rows++] = 0.0;
        }
    }
    const size_t independent = (model->nc < model->rank ? model->nc : model->rank) + s->rows - model->nc;
    lag_system_place(&s->system, n, s->rows, model->components, lag_take(&memory, lag_system_memory(n, s->rows)));
    s->work = memory;
    return lag_system_factor(&s->system, impulse->mass, s->jacobian, independent, &impulse->motion->coordinate);
}

/* The change of the rates by impulses of the constraints, in the first order; 1: it satisfies the rows and what is held. */
static int change_by_constraints(lag_impulse *impulse, step_system *s)
{
    const size_t n = impulse->motion->model->nq;
    double size = 1e-300;
    int reached = 1;
    for (size_t j = 0; j < n; ++j) {
        s->force[j] = impulse->before[j] - impulse->now[j];
    }
    lag_system_solve(&s->system, s->force, s->right, impulse->change, s->lam);
    for (size_t i = 0; i < s->rows; ++i) {
        size = fmax(size, fabs(s->right[i]));
    }
    for (size_t i = 0; i < s->rows; ++i) {
        const double *row = s->jacobian + i * n;
        const double rest = lag_dot(n, row, impulse->change) - s->right[i];
        reached = reached && fabs(rest) <= LAG_REACHED * (size + lag_dot_size(n, row, impulse->change));
    }
    return reached;
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

/* Adds the change by impulses of the rows that push one way, or slip; the rates so far are qd. */
static lag_status change_by_inequalities(lag_impulse *impulse, step_system *s, lag_inequalities *rows, const double *qd)
{
    const size_t n = impulse->motion->model->nq;
    const size_t size = rows->size;
    double *memory = s->work;
    double *response = lag_take(&memory, size * n);
    lag_friction_problem problem = {.normals = rows->normals, .frictions = rows->frictions, .components = rows->components};
    problem.compliance = lag_take(&memory, size * size);
    problem.rates = lag_take(&memory, size);
    problem.limits = lag_take(&memory, rows->frictions);
    problem.coefficients = lag_take(&memory, rows->frictions * rows->normals);
    memcpy(problem.limits, rows->limits, rows->frictions * sizeof(double));
    memcpy(problem.coefficients, rows->coefficients, rows->frictions * rows->normals * sizeof(double));
    lag_fill(s->rows, 0.0, s->right);
    for (size_t i = 0; i < size; ++i) {
        lag_system_solve(&s->system, rows->columns + i * n, s->right, response + i * n, s->lam);
    }
    for (size_t i = 0; i < size; ++i) {
        const double *row = rows->rows + i * n;
        rows->after[i] = problem.rates[i] = lag_impulse_speed_at(impulse, rows, i, qd) + lag_dot(n, row, impulse->change);
        rows->scale[i] = fabs(rows->after[i]);
        for (size_t j = 0; j < size; ++j) {
            problem.compliance[i * size + j] = lag_dot(n, row, response + j * n);
        }
        rows->compliance[i] = problem.compliance[i * size + i];
    }
    const lag_status status = lag_friction_problem_solve(&problem, rows->force, memory);
    for (size_t i = 0; i < size; ++i) {
        lag_axpy(n, rows->force[i], response + i * n, impulse->change);
        for (size_t j = 0; j < size; ++j) {
            const double term = rows->force[j] * lag_dot(n, rows->rows + i * n, response + j * n);
            rows->after[i] += term;
            rows->scale[i] += fabs(term);
        }
    }
    return status;
}

lag_status lag_impulse_step_find(lag_impulse *impulse, const double *held, lag_inequalities *rows, const double *qd)
{
    step_system s;
    lag_status status = factor(impulse, held, &s);
    const int reached = status == LAG_OK && change_by_constraints(impulse, &s);
    if (held != NULL && !reached) {
        status = factor(impulse, NULL, &s);
        (void)(status == LAG_OK && change_by_constraints(impulse, &s));
    }
    return status == LAG_OK && rows != NULL ? change_by_inequalities(impulse, &s, rows, qd) : status;
}

lag_status lag_impulse_respond(lag_impulse *impulse, const double *row, double *change)
{
    step_system s;
    const lag_status status = factor(impulse, NULL, &s);
    lag_fill(s.rows, 0.0, s.right);
    if (status == LAG_OK) {
        lag_system_solve(&s.system, row, s.right, change, s.lam);
    }
    return status;
}
