/* One step of Newton's method in the impulse problem: a linear system of M and the rows, and the complementarity of gaps that strike. */
#include "lag/impulses/impulse_step.h"

#include <math.h>
#include <string.h>

#include "lag/impulses/friction_problem.h"
#include "lag/linalg/arena.h"
#include "lag/linalg/vector.h"

static size_t most_held(const lag_model *model)
{
    return model->nreset < model->nq ? model->nreset : model->nq;
}

size_t lag_impulse_step_memory(const lag_model *model)
{
    const size_t n = model->nq;
    const size_t rows = model->nc + most_held(model);
    const size_t k = model->ngap + model->nslip;
    const size_t problem = k * n + k * k + 2 * k + model->nfriction * (model->ngap + 1);
    return n * n + rows * n + 2 * rows + 3 * n + lag_system_memory(n, rows) + problem +
           lag_friction_problem_memory(model->ngap, model->nfriction, k);
}

void lag_impulse_choose(lag_impulse *impulse, const lag_inequalities *rows)
{
    const lag_model *model = impulse->motion->model;
    const size_t n = model->nq;
    double *moved = impulse->point; /* (nq + nz) by component */
    const int all = rows == NULL || model->components == NULL;
    lag_fill(n + model->nz, 0.0, moved);
    for (size_t i = 0; !all && i < rows->size * n; ++i) {
        if (rows->rows[i] != 0.0) {
            moved[model->components[i % n]] = 1.0;
        }
    }
    impulse->count = 0;
    for (size_t j = 0; j < n; ++j) {
        if (all || moved[model->components[j]] != 0.0) {
            impulse->chosen[impulse->count++] = (double)j;
        }
    }
    lag_fill(n, 0.0, impulse->change);
}

static void pick(const lag_impulse *impulse, const double *from, double *to)
{
    for (size_t k = 0; k < impulse->count; ++k) {
        to[k] = from[lag_impulse_place_of(impulse, k)];
    }
}

/* The system of one step, in the work of the problem. */
typedef struct step_system {
    lag_system system;
    size_t rows;                               /* of the constraints, and rates that are held */
    double *mass, *jacobian;                   /* of the chosen coordinates */
    double *right, *lam, *force, *change, *row; /* (rows) (rows) (count) (count) (count) */
    double *work;                              /* of the gaps */
} step_system;

/* Rows of the constraints that hold chosen coordinates, and rates that are held, into s->jacobian; so many of them are independent at most. */
static size_t take_rows(const lag_impulse *impulse, const double *held, step_system *s)
{
    const lag_model *model = impulse->motion->model;
    const size_t count = impulse->count;
    for (size_t i = 0; i < model->nc; ++i) {
        double *row = s->jacobian + s->rows * count;
        pick(impulse, impulse->jacobian + i * model->nq, row);
        if (count == model->nq || lag_any(count, row)) {
            s->right[s->rows++] = -impulse->residual[i];
        }
    }
    const size_t independent = s->rows < model->rank ? s->rows : model->rank;
    const size_t constraints = s->rows;
    for (size_t k = 0; k < count && held != NULL; ++k) {
        if (held[lag_impulse_place_of(impulse, k)] != 0.0) {
            double *row = s->jacobian + s->rows * count;
            lag_fill(count, 0.0, row);
            row[k] = 1.0;
            s->right[s->rows++] = 0.0;
        }
    }
    return independent + s->rows - constraints;
}

/* Factors M and the rows for the chosen coordinates. */
static lag_status factor(lag_impulse *impulse, const double *held, step_system *s)
{
    const lag_model *model = impulse->motion->model;
    const size_t count = impulse->count;
    const size_t most = model->nc + most_held(model);
    double *memory = impulse->work;
    size_t coordinate = 0;
    s->mass = lag_take(&memory, count * count);
    s->jacobian = lag_take(&memory, most * count);
    s->right = lag_take(&memory, most);
    s->lam = lag_take(&memory, most);
    lag_take_all(&memory, count, (double **const[]){&s->force, &s->change, &s->row, NULL});
    s->rows = 0;
    for (size_t k = 0; k < count; ++k) {
        pick(impulse, impulse->mass + lag_impulse_place_of(impulse, k) * model->nq, s->mass + k * count);
    }
    const size_t independent = take_rows(impulse, held, s);
    lag_system_place(&s->system, count, s->rows, count == model->nq ? model->components : NULL, lag_take(&memory, lag_system_memory(count, s->rows)));
    s->work = memory;
    const lag_status status = lag_system_factor(&s->system, s->mass, s->jacobian, independent, &coordinate);
    if (status == LAG_SINGULAR) {
        impulse->motion->coordinate = lag_impulse_place_of(impulse, coordinate);
    }
    return status;
}

/* The change of the rates by impulses of the constraints, in the first order; 1: it satisfies the rows and what is held. */
static int change_by_constraints(lag_impulse *impulse, step_system *s)
{
    const size_t count = impulse->count;
    double size = 1e-300;
    int reached = 1;
    for (size_t k = 0; k < count; ++k) {
        s->force[k] = impulse->before[lag_impulse_place_of(impulse, k)] - impulse->now[lag_impulse_place_of(impulse, k)];
    }
    lag_system_solve(&s->system, s->force, s->right, s->change, s->lam);
    for (size_t i = 0; i < s->rows; ++i) {
        size = fmax(size, fabs(s->right[i]));
    }
    for (size_t i = 0; i < s->rows; ++i) {
        double rest = -s->right[i];
        double along = size;
        for (size_t k = 0; k < count; ++k) {
            const double term = s->jacobian[i * count + k] * s->change[k];
            rest += term;
            along += fabs(term);
        }
        reached = reached && fabs(rest) <= LAG_REACHED * along;
    }
    return reached;
}

/* Adds the change by impulses of the rows that push one way, or slip; `rates` are those before it, qd those so far. */
static lag_status change_by_inequalities(const lag_impulse *impulse, step_system *s, lag_inequalities *rows, const double *rates, const double *qd)
{
    const size_t n = impulse->motion->model->nq;
    const size_t count = impulse->count;
    const size_t size = rows->size;
    double *memory = s->work;
    double *response = lag_take(&memory, size * count);
    lag_friction_problem problem = {.normals = rows->normals, .frictions = rows->frictions, .components = rows->components};
    problem.compliance = lag_take(&memory, size * size);
    problem.rates = lag_take(&memory, size);
    problem.limits = lag_take(&memory, rows->frictions);
    problem.coefficients = lag_take(&memory, rows->frictions * rows->normals);
    memcpy(problem.limits, rows->limits, rows->frictions * sizeof(double));
    memcpy(problem.coefficients, rows->coefficients, rows->frictions * rows->normals * sizeof(double));
    lag_fill(s->rows, 0.0, s->right);
    for (size_t i = 0; i < size; ++i) {
        pick(impulse, rows->columns + i * n, s->row);
        lag_system_solve(&s->system, s->row, s->right, response + i * count, s->lam);
    }
    for (size_t i = 0; i < size; ++i) {
        pick(impulse, rows->rows + i * n, s->row);
        problem.rates[i] = rows->speed[i] + lag_dot(count, s->row, s->change);
        for (size_t k = 0; k < count; ++k) {
            problem.rates[i] += s->row[k] * (qd[lag_impulse_place_of(impulse, k)] - rates[lag_impulse_place_of(impulse, k)]);
        }
        for (size_t j = 0; j < size; ++j) {
            problem.compliance[i * size + j] = lag_dot(count, s->row, response + j * count);
        }
    }
    memcpy(rows->after, problem.rates, size * sizeof(double));
    for (size_t i = 0; i < size; ++i) {
        rows->compliance[i] = problem.compliance[i * size + i];
    }
    const lag_status status = lag_friction_problem_solve(&problem, rows->force, memory);
    for (size_t i = 0; i < size; ++i) {
        rows->scale[i] = fabs(rows->after[i]);
        lag_axpy(count, rows->force[i], response + i * count, s->change);
    }
    for (size_t i = 0; i < size; ++i) {
        pick(impulse, rows->rows + i * n, s->row);
        for (size_t j = 0; j < size; ++j) {
            const double term = rows->force[j] * lag_dot(count, s->row, response + j * count);
            rows->after[i] += term;
            rows->scale[i] += fabs(term);
        }
    }
    return status;
}

lag_status lag_impulse_step_find(lag_impulse *impulse, const double *held, lag_inequalities *rows, const double *rates, const double *qd)
{
    step_system s;
    lag_status status = factor(impulse, held, &s);
    const int reached = status == LAG_OK && change_by_constraints(impulse, &s);
    if (held != NULL && !reached) {
        status = factor(impulse, NULL, &s);
        (void)(status == LAG_OK && change_by_constraints(impulse, &s));
    }
    if (status == LAG_OK && rows != NULL) {
        status = change_by_inequalities(impulse, &s, rows, rates, qd);
    }
    for (size_t k = 0; k < impulse->count && status == LAG_OK; ++k) {
        impulse->change[lag_impulse_place_of(impulse, k)] = s.change[k];
    }
    return status;
}

lag_status lag_impulse_respond(lag_impulse *impulse, const double *row, double *change)
{
    step_system s;
    lag_impulse_choose(impulse, NULL);
    const lag_status status = factor(impulse, NULL, &s);
    lag_fill(s.rows, 0.0, s.right);
    if (status == LAG_OK) {
        lag_system_solve(&s.system, row, s.right, change, s.lam);
    }
    return status;
}
