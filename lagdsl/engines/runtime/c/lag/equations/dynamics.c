#include "lag/dynamics.h"

#include <math.h>

#include "lag/equations/delassus.h"
#include "lag/equations/feedback.h"
#include "lag/linalg/finite.h"
#include "lag/linalg/arena.h"

/* Arrays that the functions of this file work in. */
typedef struct places {
    double *mass, *force, *jacobian, *gamma; /* (nq, nq) (nq) (nc, nq) (nc) */
    lag_left_rows left;
    double *delassus;
    double *system;
} places;

/* `kept`: memory of lag_arguments.kept; null: there is none. */
static places place(const lag_model *model, const lag_kept *kept, double *memory)
{
    const size_t n = model->nq;
    const size_t m = model->nc;
    places at;
    at.mass = lag_take(&memory, n * n);
    at.force = lag_take(&memory, n);
    at.jacobian = lag_take(&memory, m * n);
    at.gamma = lag_take(&memory, m);
    at.left = lag_left_rows_place(model, kept, &memory);
    at.delassus = lag_take(&memory, lag_delassus_memory(m, model->nk));
    at.system = memory;
    return at;
}

size_t lag_dynamics_memory(const lag_model *model)
{
    const size_t n = model->nq;
    const size_t m = model->nc;
    const size_t kept = model->nk * (2 * n + m + 1) + lag_delassus_memory(m, model->nk);
    return n * n + n + m * n + m + kept + lag_system_memory(n, m) + lag_feedback_memory(model);
}

static inline int solved(const lag_model *model, const double *qdd, const double *lam)
{
    return lag_finite(model->nq, qdd) && lag_finite(model->nc, lam);
}

static lag_status solve_formed(
    const lag_model *model,
    const places *to,
    lag_system *system,
    double *qdd,
    double *lam,
    size_t *coordinate)
{
    lag_system_place(system, model->nq, model->nc, model->components, to->system);
    const lag_status status = lag_system_factor(system, to->mass, to->jacobian, model->rank, coordinate);
    if (status != LAG_OK) {
        lag_fill(model->nq, (double)NAN, qdd);
        lag_fill(model->nc, (double)NAN, lam);
        return status;
    }
    lag_system_solve(system, to->force, to->gamma, qdd, lam);
    return solved(model, qdd, lam) ? LAG_OK : LAG_NOT_FINITE;
}

/*
 * If elimination leaves less than this part of a pivot, the dense system decides whether the position is singular. Down to
 * this part, subtraction loses no more digits than the condition of the matrix costs the dense system, and the same ones at
 * neighboring states: a transformer of coupling 1 - 1e-7 is one whose leakage is off by 1e-9, where the dense system has a
 * noise that stops implicit methods. With rows left to run time, their multipliers cancel much of the accelerations without
 * them, and digits that these lost show in the difference.
 */
static const double smallest_pivot = 1e-8;
static const double smallest_pivot_with_rows_left = 1e-4;

double lag_smallest_pivot(const lag_model *model)
{
    return model->nk > 0 ? smallest_pivot_with_rows_left : smallest_pivot;
}

lag_status lag_factor_eliminated(
    const lag_model *model,
    const double *response,
    const double *lam_response,
    const double *jacobian,
    double pivot,
    double *memory,
    lag_delassus *system)
{
    lag_delassus_place(system, model->nq, model->nc, model->nk, model->kept_rows, model->patterns, memory);
    system->response = response;
    system->lam_response = lam_response;
    system->jacobian = jacobian;
    const size_t rank = lag_delassus_weigh(system, model->redundant);
    return pivot > lag_smallest_pivot(model) ? lag_delassus_factor(system, rank) : LAG_MISSING;
}

lag_status lag_solve_eliminated(
    const lag_model *model,
    const double *response,
    const double *lam_response,
    const double *jacobian,
    const double *gamma,
    double pivot,
    double *memory,
    double *qdd,
    double *lam)
{
    lag_delassus system;
    if (lag_factor_eliminated(model, response, lam_response, jacobian, pivot, memory, &system) != LAG_OK) {
        return LAG_MISSING;
    }
    lag_delassus_solve(&system, gamma, qdd, lam);
    return solved(model, qdd, lam) ? LAG_OK : LAG_MISSING;
}

static void pick(size_t count, const double *lanes, size_t stride, size_t lane, double *x)
{
    for (size_t i = 0; i < count; ++i) {
        x[i] = lanes[i * stride + lane];
    }
}

lag_status lag_forward_dynamics_of_lane(
    const lag_model *model,
    const lag_formed *formed,
    size_t lane,
    double *memory,
    double *qdd,
    double *lam,
    size_t *coordinate)
{
    const size_t n = model->nq;
    const size_t m = model->nc;
    const size_t kept = model->nk;
    const size_t lanes = formed->lanes;
    const places to = place(model, NULL, memory);
    lag_system system;
    if (formed->qdd != NULL) {
        pick(n, formed->qdd, lanes, lane, qdd);
        pick(m, formed->lam, lanes, lane, lam);
        pick(kept * n, formed->response, lanes, lane, to.left.response);
        pick(kept * m, formed->lam_response, lanes, lane, to.left.lam_response);
        pick(kept * n, formed->jacobian, lanes, lane, to.left.jacobian);
        pick(kept, formed->gamma, lanes, lane, to.left.gamma);
        return lag_solve_eliminated(
            model,
            to.left.response,
            to.left.lam_response,
            to.left.jacobian,
            to.left.gamma,
            formed->pivot[lane],
            to.delassus,
            qdd,
            lam);
    }
    pick(n * n, formed->mass, lanes, lane, to.mass);
    pick(n, formed->force, lanes, lane, to.force);
    pick(m * n, formed->jacobian, lanes, lane, to.jacobian);
    pick(m, formed->gamma, lanes, lane, to.gamma);
    return solve_formed(model, &to, &system, qdd, lam, coordinate);
}

/* ---- one state ---- */

/* The way in which the last state was solved, with its factors: other loads leave these as they are. */
typedef struct solver {
    const lag_model *model;
    places to;
    enum { BY_ELIMINATION, BY_SYSTEM } by;
    lag_delassus kept;
    lag_system system;
    size_t *coordinate;
} solver;

/* Elimination is the whole solution of a model without rows left to run time; else the kept rows complete it. */
static lag_status eliminate(solver *s, const lag_arguments *at, int again, double *qdd, double *lam)
{
    const lag_model *model = s->model;
    const places *to = &s->to;
    double pivot = 0.0;
    lag_status status = model->elimination(
        at, qdd, lam, to->left.response, to->left.lam_response, to->left.jacobian, to->left.gamma, &pivot);
    if (status == LAG_OK && model->nk > 0 && !again) {
        status = lag_factor_eliminated(model, to->left.response, to->left.lam_response, to->left.jacobian, pivot, to->delassus, &s->kept);
    }
    if (status == LAG_OK && model->nk > 0) {
        lag_delassus_solve(&s->kept, to->left.gamma, qdd, lam);
    }
    return status == LAG_OK && pivot > lag_smallest_pivot(model) && solved(model, qdd, lam) ? LAG_OK : LAG_MISSING;
}

static lag_status solve_system(solver *s, const lag_arguments *at, int again, double *qdd, double *lam)
{
    const places *to = &s->to;
    const lag_status status = s->model->dynamics(at, to->mass, to->force, to->jacobian, to->gamma);
    if (status != LAG_OK || !again) {
        return status == LAG_OK ? solve_formed(s->model, to, &s->system, qdd, lam, s->coordinate) : status;
    }
    lag_system_solve(&s->system, to->force, to->gamma, qdd, lam);
    return solved(s->model, qdd, lam) ? LAG_OK : LAG_NOT_FINITE;
}

static lag_status solve_with_loads(void *context, const lag_arguments *at, int again, double *qdd, double *lam)
{
    solver *s = context;
    const int by_elimination = again ? s->by != BY_SYSTEM : s->model->elimination != NULL;
    const int eliminated = by_elimination && eliminate(s, at, again, qdd, lam) == LAG_OK;
    if (eliminated) {
        s->by = BY_ELIMINATION;
        return LAG_OK;
    }
    const lag_status status = solve_system(s, at, again && s->by == BY_SYSTEM, qdd, lam);
    s->by = BY_SYSTEM;
    return status;
}

/* Elimination as the whole solution of a model without rows left to run time and without loads. */
static lag_status eliminate_all(const lag_model *model, const lag_arguments *at, double *qdd, double *lam)
{
    double none = 0.0;
    double pivot = 0.0;
    const lag_status status = model->elimination(at, qdd, lam, &none, &none, &none, &none, &pivot);
    return status == LAG_OK && pivot > lag_smallest_pivot(model) && solved(model, qdd, lam) ? LAG_OK : LAG_MISSING;
}

lag_status lag_forward_dynamics(
    const lag_model *model, const lag_arguments *at, double *memory, double *qdd, double *lam, size_t *coordinate)
{
    return lag_forward_dynamics_along(model, at, memory, NULL, qdd, lam, coordinate);
}

/* The solution where elimination is not the `whole` of it, or fails. */
static lag_status solve_rest(
    const lag_model *model, const lag_arguments *at, int whole, double *memory, double *chord, double *qdd, double *lam, size_t *coordinate)
{
    double *loads = lag_take(&memory, lag_feedback_memory(model));
    solver s; /* not set to zero: that takes as long as small systems do */
    s.model = model;
    s.to = place(model, at->kept, memory);
    s.coordinate = coordinate;
    if (model->nload > 0) {
        return lag_feedback_solve(model, at, solve_with_loads, &s, loads, chord, qdd, lam);
    }
    return whole ? solve_system(&s, at, 0, qdd, lam) : solve_with_loads(&s, at, 0, qdd, lam);
}

lag_status lag_forward_dynamics_along(
    const lag_model *model, const lag_arguments *at, double *memory, double *chord, double *qdd, double *lam, size_t *coordinate)
{
    const int whole = model->elimination != NULL && model->nk == 0 && model->nload == 0;
    const int done = whole && eliminate_all(model, at, qdd, lam) == LAG_OK;
    return done ? LAG_OK : solve_rest(model, at, whole, memory, chord, qdd, lam, coordinate);
}
