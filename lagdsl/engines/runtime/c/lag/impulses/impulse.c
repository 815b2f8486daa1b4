#include "lag/impulses/impulse.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "lag/linalg/arena.h"
#include "lag/linalg/finite.h"
#include "lag/linalg/linalg.h"
#include "lag/linalg/vector.h"
#include "lag/optimization/friction_problem.h"

/* Newton's method for rates: one step where T is quadratic in them. A step that overshoots is halved so often. */
enum { MOST_STEPS = 60, MOST_HALVES = 300 };
/* The iteration ends when the residual of the momenta is this part of their size, that of the rows LAG_KNOWN_ROWS of their terms. */
static const double ROUNDING = 1e-11;
/* A step overshoots where the momenta behind it are beyond their aim by this part of what they were short of it. */
static const double BEYOND = 0.5;
/* Less than this part of a step changes no rate. */
static const double NOTHING = 1e-60;

void lag_impulse_place(lag_impulse *impulse, lag_motion *motion, lag_layout *layout)
{
    const lag_model *model = motion->model;
    *impulse = (lag_impulse){.motion = motion, .mass = motion->written.mass, .jacobian = motion->written.rows[1]};
    lag_lay_all(layout, model->nq, (double **const[]){&impulse->before, &impulse->now, &impulse->aim, &impulse->from, &impulse->size, &impulse->change,
        &impulse->rates, NULL});
    impulse->residual = lag_lay(layout, model->nc);
    impulse->w = lag_lay(layout, model->nw);
    impulse->point = lag_lay(layout, lag_motion_size(model));
    impulse->work = lag_lay(layout, lag_impulse_step_memory(model));
}

/* ---- momenta and rows ---- */

/* dL/dqd, which is M qd where the model does not tell it, but for what no instant changes. */
static lag_status momenta(lag_impulse *impulse, const double *w, const double *qd, double *momentum)
{
    lag_motion *motion = impulse->motion;
    const lag_model *model = motion->model;
    const size_t n = model->nq;
    motion->at.w = w;
    const lag_status status = model->momenta != NULL ? model->momenta(&motion->at, momentum) : model->mass_matrix(&motion->at, impulse->mass);
    for (size_t i = 0; i < n && model->momenta == NULL; ++i) {
        momentum[i] = lag_dot(n, impulse->mass + i * n, qd);
    }
    motion->at.w = motion->w;
    return status;
}

lag_status lag_impulse_keep_momenta(lag_impulse *impulse, double t, const double *x, const double *w)
{
    lag_motion_set_state(impulse->motion, t, x);
    return momenta(impulse, w, x + impulse->motion->model->nq, impulse->before);
}

lag_status lag_impulse_evaluate(lag_impulse *impulse, double t, const double *x)
{
    lag_motion *motion = impulse->motion;
    const lag_model *model = motion->model;
    memcpy(impulse->w, motion->w, model->nw * sizeof(double));
    lag_fill(model->ncontact, 0.0, impulse->w + impulse->motion->places.contact);
    lag_fill(model->nfriction + model->nslip, 0.0, impulse->w + impulse->motion->places.sticks);
    lag_motion_set_state(motion, t, x);
    lag_status status = momenta(impulse, impulse->w, x + model->nq, impulse->now);
    motion->at.w = impulse->w;
    status = status == LAG_OK ? model->mass_matrix(&motion->at, impulse->mass) : status;
    if (status == LAG_OK && model->nc > 0) {
        status = model->velocity_constraint(&motion->at, impulse->residual, impulse->jacobian);
    }
    motion->at.w = motion->w;
    return status;
}

/* Row i of M times the rates or their change (nq). */
static double times_mass(const lag_impulse *impulse, size_t i, const double *rates)
{
    const size_t n = impulse->motion->model->nq;
    return lag_dot(n, impulse->mass + i * n, rates);
}

/* Sizes of the terms of the momenta: below a part of these, a momentum is round-off. */
static void find_sizes(lag_impulse *impulse, const double *qd)
{
    const size_t n = impulse->motion->model->nq;
    for (size_t i = 0; i < n; ++i) {
        impulse->size[i] = fabs(impulse->aim[i]) + fabs(impulse->now[i]) + lag_dot_size(n, impulse->mass + i * n, qd);
    }
}

/* 1: momenta differ from those that they are to be by more than `part` of their sizes. */
static int differs(const lag_impulse *impulse, double part)
{
    int off = 0;
    for (size_t i = 0; i < impulse->motion->model->nq; ++i) {
        off = off || fabs(impulse->aim[i] - impulse->now[i]) > part * impulse->size[i];
    }
    return off;
}

/* 1: momenta or rows are off by more than `part` of what enters them. */
static int is_off(const lag_impulse *impulse, const double *qd, double part, double rows)
{
    const size_t n = impulse->motion->model->nq;
    int off = differs(impulse, part);
    for (size_t i = 0; i < impulse->motion->model->nc; ++i) {
        const double *row = impulse->jacobian + i * n;
        const double size = lag_dot_size(n, row, qd) + fabs(impulse->residual[i] - lag_dot(n, row, qd));
        off = off || fabs(impulse->residual[i]) > rows * size;
    }
    return off;
}

int lag_impulse_differs(lag_impulse *impulse, const double *qd, double part)
{
    memcpy(impulse->aim, impulse->before, impulse->motion->model->nq * sizeof(double));
    find_sizes(impulse, qd);
    return differs(impulse, part);
}

/* ---- one step of Newton's method ---- */

/*
 * 1: the part of the step that was taken, to rates qd, overshoots: momenta behind it are no numbers, or far beyond the aim as seen from where the
 * step began, by more than round-off. A convex T has no rates that a whole step of Newton's method must miss twice as far, so half of it is nearer.
 */
static int overshoots(lag_impulse *impulse, const double *qd)
{
    double start = 0.0;
    double rest = 0.0;
    for (size_t i = 0; i < impulse->motion->model->nq; ++i) {
        start += impulse->change[i] * (impulse->aim[i] - impulse->from[i]);
        rest += impulse->change[i] * (impulse->aim[i] - impulse->now[i]);
    }
    if (isfinite(rest) && !(start > 0.0 && rest < -BEYOND * start)) {
        return 0;
    }
    find_sizes(impulse, qd);
    return !isfinite(rest) || differs(impulse, ROUNDING);
}

/*
 * LAG_MOMENTUM_UNREACHABLE if the momenta are not those that the balance asks for, with the coordinate that is farthest from its own. A rate that is
 * zero but for the round-off of the others has a momentum of its round-off: sqrt(M_ii qd'M qd) is the momentum that all the energy would give.
 */
static lag_status judge(const lag_impulse *impulse, const double *qd)
{
    const size_t n = impulse->motion->model->nq;
    double action = 0.0;
    double most = LAG_SOLVED;
    lag_status status = LAG_OK;
    for (size_t i = 0; i < n; ++i) {
        action += qd[i] * times_mass(impulse, i, qd);
    }
    for (size_t i = 0; i < n; ++i) {
        const double noise = LAG_FEW * DBL_EPSILON * sqrt(fabs(impulse->mass[i * n + i]) * fabs(action));
        const double off = fabs(impulse->aim[i] - impulse->now[i]);
        const double part = off <= noise ? 0.0 : off / fmax(impulse->size[i], DBL_MIN);
        if (!(part <= most)) {
            most = isfinite(part) ? part : (double)INFINITY;
            impulse->motion->coordinate = i;
            status = LAG_MOMENTUM_UNREACHABLE;
        }
    }
    return status;
}

/* Adds the change to the rates, or as much of it as does not overshoot the momenta that it leads to in the first order. */
static lag_status step(lag_impulse *impulse, double t, double *x)
{
    const size_t n = impulse->motion->model->nq;
    impulse->part = 1.0;
    memcpy(impulse->from, impulse->now, n * sizeof(double));
    for (size_t i = 0; i < n; ++i) {
        impulse->aim[i] = impulse->now[i] + times_mass(impulse, i, impulse->change);
    }
    lag_axpy(n, impulse->part, impulse->change, x + n);
    lag_status status = lag_impulse_evaluate(impulse, t, x);
    for (int k = 0; k < MOST_HALVES && status == LAG_OK && overshoots(impulse, x + n); ++k) {
        impulse->part *= 0.5;
        lag_axpy(n, -impulse->part, impulse->change, x + n);
        status = lag_impulse_evaluate(impulse, t, x);
        if (status == LAG_OK && k + 1 == MOST_HALVES) {
            status = judge(impulse, x + n);
        }
    }
    return status;
}

/* From rates at which momenta do not grow with the rates, a quarter of the last step back. */
static lag_status retreat(lag_impulse *impulse, double t, double *x)
{
    const size_t n = impulse->motion->model->nq;
    lag_axpy(n, -0.25 * impulse->part, impulse->change, x + n);
    impulse->part *= 0.75;
    return lag_impulse_evaluate(impulse, t, x);
}

/* ---- the problem ---- */

/* Newton's method from rates at which all was evaluated; speeds of `rows` (or null) are those at impulse->rates. */
static lag_status iterate(lag_impulse *impulse, double t, double *x, const double *held, lag_inequalities *rows)
{
    const double *qd = x + impulse->motion->model->nq;
    for (int k = 0; k < MOST_STEPS; ++k) {
        lag_status status = lag_impulse_step_find(impulse, held, rows, qd);
        status = status == LAG_SINGULAR && k > 0 ? retreat(impulse, t, x) : status == LAG_OK ? step(impulse, t, x) : status;
        if (status != LAG_OK) {
            return status;
        }
        find_sizes(impulse, qd);
        if (impulse->part < NOTHING || !is_off(impulse, qd, ROUNDING, LAG_KNOWN_ROWS)) {
            return LAG_OK;
        }
    }
    return judge(impulse, qd);
}

/* Looks at x. If there are no momenta at the rates there, as beyond the speed of light on a carriage that starts, at smaller ones. */
static lag_status begin(lag_impulse *impulse, double t, double *x)
{
    const size_t n = impulse->motion->model->nq;
    lag_status status = lag_impulse_evaluate(impulse, t, x);
    for (int k = 0; k < MOST_STEPS && status == LAG_OK && !lag_finite(n, impulse->now); ++k) {
        lag_axpy(n, -0.5, x + n, x + n); /* half of them */
        status = lag_impulse_evaluate(impulse, t, x);
    }
    return status;
}

lag_status lag_impulse_balance(lag_impulse *impulse, double t, double *x, const double *held, lag_inequalities *rows, int *jumped)
{
    const double *qd = x + impulse->motion->model->nq;
    const lag_status status = begin(impulse, t, x);
    *jumped = 0;
    if (status != LAG_OK) {
        return status;
    }
    memcpy(impulse->aim, impulse->before, impulse->motion->model->nq * sizeof(double));
    find_sizes(impulse, qd);
    *jumped = is_off(impulse, qd, LAG_EXACT, LAG_SOLVED) || rows != NULL;
    return *jumped ? iterate(impulse, t, x, held, rows) : LAG_OK;
}

/* ---- impacts ---- */

/* The impulses of the rows at impulse->rates, from the momenta of now; each gap parts with this part of its approach at least. */
static lag_status solve_compression(lag_impulse *impulse, double t, double *x, lag_inequalities *rows, const double *rebound)
{
    const size_t n = impulse->motion->model->nq;
    memcpy(impulse->before, impulse->now, n * sizeof(double));
    memcpy(impulse->rates, x + n, n * sizeof(double));
    memcpy(rows->start, rows->speed, rows->size * sizeof(double));
    lag_fill(rows->frictions, 0.0, rows->limits);
    for (size_t i = 0; i < rows->normals && rebound != NULL; ++i) {
        rows->speed[i] += rebound[i] * rows->speed[i];
    }
    const lag_status status = iterate(impulse, t, x, NULL, rows);
    memcpy(rows->speed, rows->start, rows->size * sizeof(double));
    return status;
}

/* Expansion: impulses of at least e times those of the compression, with their friction. Afterwards rows->force has all of the blow. */
static lag_status expand(lag_impulse *impulse, double t, double *x, lag_inequalities *rows)
{
    const size_t n = impulse->motion->model->nq;
    memcpy(rows->first, rows->force, rows->size * sizeof(double));
    memcpy(impulse->before, impulse->now, n * sizeof(double));
    for (size_t i = 0; i < rows->size; ++i) {
        rows->speed[i] = lag_impulse_speed_at(impulse, rows, i, x + n);
    }
    memcpy(impulse->rates, x + n, n * sizeof(double));
    for (size_t i = 0; i < rows->normals; ++i) {
        const double given = rows->restitution[i] * rows->first[i];
        rows->first[i] += given;
        lag_axpy(n, given, rows->rows + i * n, impulse->before);
        for (size_t k = 0; k < rows->frictions; ++k) {
            rows->limits[k] += rows->coefficients[k * rows->normals + i] * given;
        }
    }
    const lag_status status = iterate(impulse, t, x, NULL, rows);
    lag_axpy(rows->size, 1.0, rows->first, rows->force);
    return status;
}

/* Work of the impulses of a blow, and the sum of its magnitudes: each with the mean of its speeds before and after, which is exact for a quadratic T. */
static double work_of(const lag_impulse *impulse, const lag_inequalities *rows, const double *qd, double *size)
{
    double work = 0.0;
    *size = 0.0;
    for (size_t i = 0; i < rows->size; ++i) {
        const double term = 0.5 * rows->force[i] * (rows->start[i] + lag_impulse_speed_at(impulse, rows, i, qd));
        work += term;
        *size += fabs(0.5 * rows->force[i] * rows->start[i]) + fabs(term);
    }
    return work;
}

/* The restitutions are not equal; all of them are the least then. */
static int equalize(lag_inequalities *rows)
{
    double least = 1.0;
    double most = 0.0;
    for (size_t i = 0; i < rows->normals; ++i) {
        least = fmin(least, rows->restitution[i]);
        most = fmax(most, rows->restitution[i]);
    }
    lag_fill(rows->normals, least, rows->restitution);
    return least < most;
}

/* Newton's law without friction, Poisson's with it. */
static lag_status solve_restitution(lag_impulse *impulse, double t, double *x, lag_inequalities *rows)
{
    if (rows->frictions == 0) {
        return solve_compression(impulse, t, x, rows, rows->restitution);
    }
    const lag_status status = solve_compression(impulse, t, x, rows, NULL);
    return status == LAG_OK && lag_any(rows->normals, rows->restitution) ? expand(impulse, t, x, rows) : status;
}

lag_status lag_impulse_impact(lag_impulse *impulse, double t, double *x, lag_inequalities *rows)
{
    const size_t n = impulse->motion->model->nq;
    double size = 0.0;
    lag_status status = lag_impulse_evaluate(impulse, t, x);
    memcpy(impulse->point, x + n, n * sizeof(double));
    status = status == LAG_OK ? solve_restitution(impulse, t, x, rows) : status;
    if (status == LAG_OK && work_of(impulse, rows, x + n, &size) > LAG_SOLVED * size && equalize(rows)) {
        memcpy(x + n, impulse->point, n * sizeof(double));
        memcpy(rows->speed, rows->start, rows->size * sizeof(double));
        status = lag_impulse_evaluate(impulse, t, x);
        status = status == LAG_OK ? solve_restitution(impulse, t, x, rows) : status;
    }
    return status;
}

/* ---- accelerations ---- */

lag_status lag_impulse_accelerate(lag_impulse *impulse, double t, const double *x, const double *w, lag_inequalities *rows)
{
    lag_motion *motion = impulse->motion;
    const lag_model *model = motion->model;
    lag_motion_set_state(motion, t, x);
    motion->at.w = w;
    lag_status status = model->dynamics(&motion->at, impulse->mass, impulse->before, impulse->jacobian, impulse->residual);
    motion->at.w = motion->w;
    for (size_t i = 0; i < model->nc; ++i) {
        impulse->residual[i] = -impulse->residual[i];
    }
    lag_fill(model->nq, 0.0, impulse->now);
    lag_fill(model->nq, 0.0, impulse->rates);
    return status == LAG_OK ? lag_impulse_step_find(impulse, NULL, rows, impulse->rates) : status;
}
