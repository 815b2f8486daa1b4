#include "lag/events/momentum.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "lag/linalg/arena.h"
#include "lag/linalg/vector.h"

/* Newton's method for rates: one step where T is quadratic in them. A step that overshoots is halved so often. */
enum { MOST_STEPS = 60, MOST_HALVES = 300 };
/* The iteration ends when the residual of the momenta is this part of their size. */
static const double ROUNDING = 1e-13;
/* A residual of a row below this part of its terms is no jump: projection leaves more. Momenta that are off by more are not reached. */
static const double LEFT = 1e-9;
/* A step overshoots where the momenta behind it are beyond their aim by this part of what they were short of it. */
static const double BEYOND = 0.5;
/* Less than this part of a step changes no rate. */
static const double NOTHING = 1e-60;
/* A way changes by less than this part of its size at an instant, or by so many round-offs of coordinates, or changes of a moment. */
static const double CONTINUOUS = 1e-9;
static const double FEW = 16.0;

static size_t most_held(const lag_model *model)
{
    return model->nreset < model->nq ? model->nreset : model->nq;
}

size_t lag_momentum_memory(const lag_model *model)
{
    const size_t n = model->nq;
    const size_t rows = model->nc + most_held(model);
    return 6 * n + n * n + model->nc * n + model->nc + model->nw + model->ncontact + rows * n + 2 * rows + 4 * model->nway + lag_motion_size(model) +
           lag_system_memory(n, rows);
}

void lag_momentum_place(lag_momentum *momentum, lag_motion *motion, double *memory)
{
    const lag_model *model = motion->model;
    const size_t n = model->nq;
    const size_t rows = model->nc + most_held(model);
    memset(momentum, 0, sizeof *momentum);
    momentum->motion = motion;
    momentum->places = lag_places_of(model);
    momentum->before = lag_take(&memory, n);
    momentum->now = lag_take(&memory, n);
    momentum->from = lag_take(&memory, n);
    momentum->mass = lag_take(&memory, n * n);
    momentum->jacobian = lag_take(&memory, model->nc * n);
    momentum->rows = lag_take(&memory, model->nc);
    momentum->open = lag_take(&memory, model->nw);
    momentum->holding = lag_take(&memory, model->ncontact);
    memset(momentum->holding, 0, model->ncontact * sizeof(double));
    momentum->size = lag_take(&memory, n);
    momentum->chosen = lag_take(&memory, rows * n);
    momentum->right = lag_take(&memory, rows);
    momentum->force = lag_take(&memory, n);
    momentum->change = lag_take(&memory, n);
    momentum->lam = lag_take(&memory, rows);
    momentum->way = lag_take(&memory, 4 * model->nway);
    momentum->point = lag_take(&memory, lag_motion_size(model));
    momentum->system = memory;
}

/* dL/dqd; zero where the model does not tell them: then impulses are those of constraints only. */
static lag_status momenta(const lag_motion *motion, double *momentum)
{
    lag_fill(motion->model->nq, 0.0, momentum);
    return motion->model->momenta != NULL ? motion->model->momenta(&motion->at, momentum) : LAG_OK;
}

lag_status lag_momentum_keep(lag_momentum *momentum, double t, const double *x, const double *w)
{
    lag_motion *motion = momentum->motion;
    lag_motion_look(motion, t, x);
    motion->at.w = w;
    const lag_status status = momenta(motion, momentum->before);
    motion->at.w = motion->w;
    return status;
}

lag_status lag_momentum_look(lag_momentum *momentum, double t, const double *x)
{
    lag_motion *motion = momentum->motion;
    const lag_model *model = motion->model;
    memcpy(momentum->open, motion->w, model->nw * sizeof(double));
    memcpy(momentum->open + momentum->places.contact, momentum->holding, model->ncontact * sizeof(double));
    lag_motion_look(motion, t, x);
    motion->at.w = momentum->open;
    lag_status status = momenta(motion, momentum->now);
    if (status == LAG_OK) {
        status = model->mass_matrix(&motion->at, momentum->mass);
    }
    if (status == LAG_OK && model->nc > 0) {
        status = model->velocity_constraint(&motion->at, momentum->rows, momentum->jacobian);
    }
    motion->at.w = motion->w;
    return status;
}

/* Sizes of the terms of the momenta: below a part of these, a momentum is round-off. */
static void find_sizes(lag_momentum *momentum, const double *qd)
{
    const size_t n = momentum->motion->model->nq;
    for (size_t i = 0; i < n; ++i) {
        double size = fabs(momentum->before[i]) + fabs(momentum->now[i]);
        for (size_t j = 0; j < n; ++j) {
            size += fabs(momentum->mass[i * n + j] * qd[j]);
        }
        momentum->size[i] = size;
    }
}

/* 1: momenta differ from those that were kept by more than `part` of their sizes. */
static int differs(const lag_momentum *momentum, double part)
{
    int off = 0;
    for (size_t i = 0; i < momentum->motion->model->nq; ++i) {
        off = off || fabs(momentum->before[i] - momentum->now[i]) > part * momentum->size[i];
    }
    return off;
}

/* 1: momenta or rows are off by more than `part` of what enters them. */
static int is_off(const lag_momentum *momentum, const double *qd, double part, double rows)
{
    const lag_model *model = momentum->motion->model;
    const size_t n = model->nq;
    int off = differs(momentum, part);
    for (size_t i = 0; i < model->nc; ++i) {
        double size = 0.0;
        double along = 0.0;
        for (size_t j = 0; j < n; ++j) {
            const double term = momentum->jacobian[i * n + j] * qd[j];
            size += fabs(term);
            along += term;
        }
        size += fabs(momentum->rows[i] - along);
        off = off || fabs(momentum->rows[i]) > rows * size;
    }
    return off;
}

int lag_momentum_differs(lag_momentum *momentum, const double *qd, double part)
{
    find_sizes(momentum, qd);
    return differs(momentum, part);
}

/* The change of the rates, in the first order; *reached: it satisfies the rows and what is held. */
static lag_status solve(lag_momentum *momentum, const double *held, int *reached)
{
    const lag_model *model = momentum->motion->model;
    const size_t n = model->nq;
    size_t rows = model->nc;
    double size = 1e-300;
    lag_system system;
    *reached = 1;
    memcpy(momentum->chosen, momentum->jacobian, rows * n * sizeof(double));
    for (size_t i = 0; i < n; ++i) {
        momentum->force[i] = momentum->before[i] - momentum->now[i];
    }
    for (size_t i = 0; i < rows; ++i) {
        momentum->right[i] = -momentum->rows[i];
        size = fmax(size, fabs(momentum->rows[i]));
    }
    for (size_t j = 0; j < n && held != NULL; ++j) {
        if (held[j] != 0.0) {
            memset(momentum->chosen + rows * n, 0, n * sizeof(double));
            momentum->chosen[rows * n + j] = 1.0;
            momentum->right[rows++] = 0.0;
        }
    }
    lag_system_place(&system, n, rows, model->components, momentum->system);
    const lag_status status =
        lag_system_factor(&system, momentum->mass, momentum->chosen, model->rank + (rows - model->nc), &momentum->motion->coordinate);
    if (status != LAG_OK) {
        *reached = 0;
        return status;
    }
    lag_system_solve(&system, momentum->force, momentum->right, momentum->change, momentum->lam);
    for (size_t i = 0; i < rows; ++i) {
        double rest = -momentum->right[i];
        double along = size;
        for (size_t j = 0; j < n; ++j) {
            rest += momentum->chosen[i * n + j] * momentum->change[j];
            along += fabs(momentum->chosen[i * n + j] * momentum->change[j]);
        }
        *reached = *reached && fabs(rest) <= 1e-8 * along;
    }
    return LAG_OK;
}

int lag_momentum_overshoots(size_t count, const double *step, const double *from, const double *now, const double *aim)
{
    double start = 0.0;
    double rest = 0.0;
    for (size_t i = 0; i < count; ++i) {
        start += step[i] * (aim[i] - from[i]);
        rest += step[i] * (aim[i] - now[i]);
    }
    return !isfinite(rest) || (start > 0.0 && rest < -BEYOND * start);
}

/* Momenta that impulses along the constraints gave are no residuals of the next step. */
static void settle(lag_momentum *momentum)
{
    const lag_model *model = momentum->motion->model;
    const size_t n = model->nq;
    for (size_t i = 0; i < n; ++i) {
        double moved = 0.0;
        for (size_t j = 0; j < n; ++j) {
            moved += momentum->mass[i * n + j] * momentum->change[j];
        }
        momentum->before[i] = momentum->now[i] + moved;
    }
}

/* qd'M qd, twice the kinetic energy where T is quadratic. */
static double find_action(const lag_momentum *momentum, const double *qd)
{
    const size_t n = momentum->motion->model->nq;
    double action = 0.0;
    for (size_t i = 0; i < n; ++i) {
        for (size_t j = 0; j < n; ++j) {
            action += qd[i] * momentum->mass[i * n + j] * qd[j];
        }
    }
    return fabs(action);
}

/*
 * LAG_MOMENTUM_UNREACHABLE if the momenta are not those that the balance asks for, with the coordinate that is farthest from its own. A rate that is
 * zero but for the round-off of the others has a momentum of its round-off: sqrt(M_ii qd'M qd) is the momentum that all the energy would give.
 */
static lag_status judge(const lag_momentum *momentum, const double *qd)
{
    const size_t n = momentum->motion->model->nq;
    const double action = find_action(momentum, qd);
    double most = LEFT;
    lag_status status = LAG_OK;
    for (size_t i = 0; i < n; ++i) {
        const double noise = FEW * DBL_EPSILON * sqrt(fabs(momentum->mass[i * n + i]) * action);
        const double off = fabs(momentum->before[i] - momentum->now[i]);
        const double part = off <= noise ? 0.0 : off / fmax(momentum->size[i], DBL_MIN);
        if (!(part <= most)) {
            most = isfinite(part) ? part : (double)INFINITY;
            momentum->motion->coordinate = i;
            status = LAG_MOMENTUM_UNREACHABLE;
        }
    }
    return status;
}

/* Adds the change to the rates, or as much of it as does not overshoot, and looks at what is there. */
static lag_status step(lag_momentum *momentum, double t, double *x)
{
    const size_t n = momentum->motion->model->nq;
    double *part = &momentum->part;
    *part = 1.0;
    memcpy(momentum->from, momentum->now, n * sizeof(double));
    settle(momentum);
    lag_axpy(n, *part, momentum->change, x + n);
    lag_status status = lag_momentum_look(momentum, t, x);
    for (int k = 0; k < MOST_HALVES && status == LAG_OK &&
         lag_momentum_overshoots(n, momentum->change, momentum->from, momentum->now, momentum->before); ++k) {
        *part *= 0.5;
        lag_axpy(n, -*part, momentum->change, x + n);
        status = lag_momentum_look(momentum, t, x);
        if (status == LAG_OK && k + 1 == MOST_HALVES) {
            status = judge(momentum, x + n);
        }
    }
    return status;
}

/* From rates at which momenta do not grow with the rates, a quarter of the last step back. */
static lag_status retreat(lag_momentum *momentum, double t, double *x)
{
    const size_t n = momentum->motion->model->nq;
    lag_axpy(n, -0.25 * momentum->part, momentum->change, x + n);
    momentum->part *= 0.75;
    return lag_momentum_look(momentum, t, x);
}

static int are_finite(const lag_momentum *momentum)
{
    size_t i = 0;
    while (i < momentum->motion->model->nq && isfinite(momentum->now[i])) {
        ++i;
    }
    return i == momentum->motion->model->nq;
}

/* Looks at x. If there are no momenta at the rates there, as beyond the speed of light on a carriage that starts, at smaller ones. */
static lag_status begin(lag_momentum *momentum, double t, double *x)
{
    const size_t n = momentum->motion->model->nq;
    double *qd = x + n;
    lag_status status = lag_momentum_look(momentum, t, x);
    if (status != LAG_OK || are_finite(momentum)) {
        return status;
    }
    memcpy(momentum->point, qd, n * sizeof(double));
    for (int k = 0; k < MOST_STEPS && status == LAG_OK && !are_finite(momentum); ++k) {
        for (size_t i = 0; i < n; ++i) {
            qd[i] *= 0.5;
        }
        status = lag_momentum_look(momentum, t, x);
    }
    if (status == LAG_OK && !are_finite(momentum)) { /* the rates are not to blame */
        memcpy(qd, momentum->point, n * sizeof(double));
    }
    return status;
}

lag_status lag_momentum_balance(lag_momentum *momentum, double t, double *x, const double *held, int *jumped)
{
    const double *qd = x + momentum->motion->model->nq;
    lag_status status = begin(momentum, t, x);
    *jumped = 0;
    if (status != LAG_OK) {
        return status;
    }
    find_sizes(momentum, qd);
    if (!is_off(momentum, qd, ROUNDING, LEFT)) {
        return LAG_OK;
    }
    for (int k = 0; k < MOST_STEPS; ++k) {
        int reached = 0;
        status = held != NULL ? solve(momentum, held, &reached) : LAG_OK;
        if (!reached) {
            status = solve(momentum, NULL, &reached);
        }
        status = status == LAG_SINGULAR && k > 0 ? retreat(momentum, t, x) : status == LAG_OK ? step(momentum, t, x) : status;
        if (status != LAG_OK) {
            return status;
        }
        *jumped = 1;
        find_sizes(momentum, qd);
        if (momentum->part < NOTHING || !is_off(momentum, qd, 1e2 * ROUNDING, 1e-12)) {
            return LAG_OK;
        }
    }
    return judge(momentum, qd);
}

/* Ways of masses at x with discretes w. */
static lag_status look_at_ways(lag_motion *motion, double t, const double *x, const double *w, double *way)
{
    lag_motion_look(motion, t, x);
    motion->at.w = w;
    const lag_status status = motion->model->way(&motion->at, way);
    motion->at.w = motion->w;
    return status;
}

/* The same where the motion from x has come after a moment. */
static lag_status look_later(lag_momentum *momentum, double t, const double *x, const double *w, double moment, double *way)
{
    const size_t n = momentum->motion->model->nq;
    memcpy(momentum->point, x, lag_motion_size(momentum->motion->model) * sizeof(double));
    lag_axpy(n, moment, x + n, momentum->point);
    return look_at_ways(momentum->motion, t + moment, momentum->point, w, way);
}

lag_status lag_momentum_ways(
    lag_momentum *momentum, double t, const double *x, const double *stood, const double *before, double moment, const double *peak)
{
    lag_motion *motion = momentum->motion;
    const lag_model *model = motion->model;
    double *was = momentum->way;
    double *now = was + model->nway;
    double *later = now + model->nway;
    double *behind = later + model->nway;
    double size = 0.0;
    for (size_t j = 0; j < model->nq; ++j) {
        size = fmax(size, fmax(peak[j], fabs(x[j])));
    }
    lag_status status = look_at_ways(motion, t, stood, before, was);
    status = status == LAG_OK ? look_at_ways(motion, t, x, motion->w, now) : status;
    status = status == LAG_OK ? look_later(momentum, t, stood, before, moment, later) : status;
    status = status == LAG_OK ? look_later(momentum, t, x, motion->w, moment, behind) : status;
    for (size_t i = 0; i < model->nway && status == LAG_OK; ++i) {
        const double own = CONTINUOUS * (fabs(was[i]) + fabs(now[i]));
        const double noise = FEW * (DBL_EPSILON * size + fabs(later[i] - was[i]) + fabs(behind[i] - now[i]));
        status = fabs(now[i] - was[i]) > own + noise ? LAG_WAY_JUMP : LAG_OK;
    }
    return status;
}
