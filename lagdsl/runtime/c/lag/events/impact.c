#include "lag/events/impact.h"

#include <math.h>
#include <string.h>

#include "lag/events/momentum.h"
#include "lag/linalg/arena.h"
#include "lag/linalg/nnls.h"
#include "lag/linalg/vector.h"

/* Newton's method where T is not quadratic in the rates; a step that overshoots is halved so often. */
enum { MOST_STEPS = 60, MOST_HALVES = 300 };
/* It ends when the residual of the momenta is this part of their size. */
static const double ROUNDING = 1e-12;

size_t lag_impact_memory(const lag_model *model)
{
    const size_t n = model->nq;
    const size_t m = model->nc;
    const size_t k = model->ngap;
    return n * n + m * n + 3 * m + 9 * n + model->nz + model->nw + k * n + k * k + 2 * k + lag_system_memory(n, m) + lag_nnls_memory(k);
}

void lag_impact_place(lag_impact *impact, lag_motion *motion, double *memory)
{
    const lag_model *model = motion->model;
    const size_t n = model->nq;
    const size_t m = model->nc;
    const size_t k = model->ngap;
    memset(impact, 0, sizeof *impact);
    impact->motion = motion;
    impact->places = lag_places_of(model);
    impact->chosen = lag_take(&memory, n);
    impact->struck = lag_take(&memory, n + model->nz);
    impact->mass = lag_take(&memory, n * n);
    impact->jacobian = lag_take(&memory, m * n);
    impact->residual = lag_take(&memory, m);
    impact->gamma = lag_take(&memory, m);
    impact->lam = lag_take(&memory, m);
    impact->force = lag_take(&memory, n);
    impact->opened = lag_take(&memory, model->nw);
    impact->response = lag_take(&memory, k * n);
    impact->compliance = lag_take(&memory, k * k);
    impact->wanted = lag_take(&memory, k);
    impact->impulse = lag_take(&memory, k);
    impact->rates = lag_take(&memory, n);
    impact->step = lag_take(&memory, n);
    impact->from = lag_take(&memory, n);
    impact->now = lag_take(&memory, n);
    impact->kept = lag_take(&memory, n);
    impact->reached = lag_take(&memory, n);
    impact->system = lag_take(&memory, lag_system_memory(n, m));
    impact->search = memory;
    memset(impact->gamma, 0, m * sizeof(double));
}

/* Momenta dL/dqd. */
static lag_status look_at_momenta(lag_impact *impact, double t, const double *x, double *momenta)
{
    lag_motion *motion = impact->motion;
    lag_fill(motion->model->nq, 0.0, momenta);
    lag_motion_look(motion, t, x);
    return motion->model->momenta != NULL ? motion->model->momenta(&motion->at, momenta) : LAG_OK;
}

/* M and the rows of the lasting constraints. */
static lag_status look(lag_impact *impact, double t, const double *x)
{
    lag_motion *motion = impact->motion;
    const lag_model *model = motion->model;
    memcpy(impact->opened, motion->w, model->nw * sizeof(double));
    memset(impact->opened + impact->places.contact, 0, model->ncontact * sizeof(double));
    lag_motion_look(motion, t, x);
    motion->at.w = impact->opened;
    lag_status status = model->mass_matrix(&motion->at, impact->mass);
    if (status == LAG_OK && model->nc > 0) {
        status = model->velocity_constraint(&motion->at, impact->residual, impact->jacobian);
    }
    motion->at.w = motion->w;
    return status;
}

/* Coordinates of the components in which the blow has a gap: what is beside them does not move. */
static void choose(lag_impact *impact, const lag_blow *blow)
{
    const lag_model *model = impact->motion->model;
    const size_t n = model->nq;
    double *struck = impact->struck;
    lag_fill(n + model->nz, model->components == NULL ? 1.0 : 0.0, struck);
    for (size_t i = 0; i < blow->count * n && model->components != NULL; ++i) {
        if (blow->rows[i] != 0.0) {
            struck[model->components[i % n]] = 1.0;
        }
    }
    impact->count = 0;
    for (size_t j = 0; j < n; ++j) {
        if (struck[model->components != NULL ? model->components[j] : j] != 0.0) {
            impact->chosen[impact->count++] = (double)j;
        }
    }
}

static void pick(const lag_impact *impact, const double *from, double *to)
{
    for (size_t j = 0; j < impact->count; ++j) {
        to[j] = from[(size_t)impact->chosen[j]];
    }
}

/* M and J, in place, for the chosen coordinates and the rows that hold them; returns the number of these. */
static size_t cut_down(lag_impact *impact)
{
    const size_t n = impact->motion->model->nq;
    size_t rows = 0;
    for (size_t i = 0; i < impact->count; ++i) {
        pick(impact, impact->mass + (size_t)impact->chosen[i] * n, impact->mass + i * impact->count);
    }
    for (size_t i = 0; i < impact->motion->model->nc; ++i) {
        double *to = impact->jacobian + rows * impact->count;
        pick(impact, impact->jacobian + i * n, to);
        rows += lag_any(impact->count, to) ? 1 : 0;
    }
    return rows;
}

/*
 * The change of the rates without impulses of gaps that leaves the momenta as they were before the blow; none in the first step. It needs
 * rates at which constraints are satisfied.
 */
static void go_free(lag_impact *impact, lag_system *system)
{
    for (size_t j = 0; j < impact->count; ++j) {
        const size_t of = (size_t)impact->chosen[j];
        impact->force[j] = impact->kept[of] - impact->reached[of];
    }
    lag_system_solve(system, impact->force, impact->gamma, impact->step, impact->lam);
}

/* Responses (blow->count, impact->count) of rates and speeds to unit impulses; speeds that are wanted, in the rates `qd` and the step so far. */
static void respond(lag_impact *impact, lag_system *system, const lag_blow *blow, const double *qd)
{
    const size_t n = impact->motion->model->nq;
    for (size_t i = 0; i < blow->count; ++i) {
        pick(impact, blow->rows + i * n, impact->force);
        lag_system_solve(system, impact->force, impact->gamma, impact->response + i * impact->count, impact->lam);
    }
    for (size_t i = 0; i < blow->count; ++i) {
        pick(impact, blow->rows + i * n, impact->force);
        impact->wanted[i] = (1.0 + blow->factor[i]) * blow->speed[i];
        for (size_t j = 0; j < impact->count; ++j) {
            const size_t of = (size_t)impact->chosen[j];
            impact->wanted[i] += impact->force[j] * (qd[of] - impact->rates[of] + impact->step[j]);
        }
        for (size_t j = 0; j < blow->count; ++j) {
            impact->compliance[i * blow->count + j] = lag_dot(impact->count, impact->force, impact->response + j * impact->count);
        }
    }
}

/* One step, by the M and the momenta at x, into impact->step. */
static lag_status find_step(lag_impact *impact, double t, const double *x, const lag_blow *blow)
{
    const lag_model *model = impact->motion->model;
    lag_system system;
    size_t coordinate = 0;
    lag_status status = look(impact, t, x);
    if (status == LAG_OK) {
        choose(impact, blow);
        const size_t rows = cut_down(impact);
        lag_system_place(&system, impact->count, rows, NULL, impact->system);
        status = lag_system_factor(&system, impact->mass, impact->jacobian, rows < model->rank ? rows : model->rank, &coordinate);
    }
    if (status == LAG_SINGULAR) {
        impact->motion->coordinate = (size_t)impact->chosen[coordinate];
    }
    if (status != LAG_OK) {
        return status;
    }
    go_free(impact, &system);
    respond(impact, &system, blow, x + model->nq);
    lag_nnls(blow->count, impact->compliance, impact->wanted, impact->impulse, impact->search);
    for (size_t i = 0; i < blow->count; ++i) {
        for (size_t j = 0; j < impact->count; ++j) {
            impact->step[j] += impact->impulse[i] * impact->response[i * impact->count + j];
        }
    }
    return LAG_OK;
}

/* Adds this part of the step to the rates. */
static void add_step(const lag_impact *impact, double part, double *qd)
{
    for (size_t j = 0; j < impact->count; ++j) {
        qd[(size_t)impact->chosen[j]] += part * impact->step[j];
    }
}

/* 1: the momenta at rates `qd` are those that the whole of the step leads to in the first order, which are in impact->force. */
static int is_reached(const lag_impact *impact, const double *qd)
{
    int reached = 1;
    for (size_t i = 0; i < impact->count; ++i) {
        const double now = impact->reached[(size_t)impact->chosen[i]];
        double size = fabs(now) + fabs(impact->force[i]);
        for (size_t j = 0; j < impact->count; ++j) {
            size += fabs(impact->mass[i * impact->count + j] * qd[(size_t)impact->chosen[j]]);
        }
        reached = reached && fabs(now - impact->force[i]) <= ROUNDING * size;
    }
    return reached;
}

/* 1: the step so far overshoots the momenta in impact->force, as seen from those in impact->from. */
static int overshoots(const lag_impact *impact)
{
    pick(impact, impact->reached, impact->now);
    return lag_momentum_overshoots(impact->count, impact->step, impact->from, impact->now, impact->force);
}

/* Takes the step, or as much of it as does not overshoot; *done: momenta are those that the whole of it leads to in the first order. */
static lag_status go(lag_impact *impact, double t, double *x, int *done)
{
    const size_t n = impact->count;
    double *qd = x + impact->motion->model->nq;
    double part = 1.0;
    pick(impact, impact->reached, impact->from);
    for (size_t i = 0; i < n; ++i) {
        impact->force[i] = impact->from[i] + lag_dot(n, impact->mass + i * n, impact->step);
    }
    add_step(impact, part, qd);
    lag_status status = look_at_momenta(impact, t, x, impact->reached);
    *done = is_reached(impact, qd);
    for (int k = 0; k < MOST_HALVES && status == LAG_OK && !*done && overshoots(impact); ++k) {
        part *= 0.5;
        add_step(impact, -part, qd);
        status = look_at_momenta(impact, t, x, impact->reached);
    }
    return status;
}

lag_status lag_impact_strike(lag_impact *impact, double t, double *x, const lag_blow *blow)
{
    const size_t n = impact->motion->model->nq;
    int done = 0;
    lag_status status = look_at_momenta(impact, t, x, impact->kept);
    memcpy(impact->rates, x + n, n * sizeof(double));
    memcpy(impact->reached, impact->kept, n * sizeof(double));
    for (int k = 0; k < MOST_STEPS && status == LAG_OK && !done; ++k) {
        status = find_step(impact, t, x, blow);
        status = status == LAG_OK ? go(impact, t, x, &done) : status;
    }
    return status == LAG_OK && !done ? LAG_MOMENTUM_UNREACHABLE : status;
}
