#include "lag/events/impact.h"

#include <string.h>

#include "lag/linalg/arena.h"
#include "lag/linalg/nnls.h"
#include "lag/linalg/vector.h"

size_t lag_impact_memory(const lag_model *model)
{
    const size_t n = model->nq;
    const size_t m = model->nc;
    const size_t k = model->ngap;
    return n * n + m * n + 3 * m + 3 * n + model->nz + model->nw + k * n + k * k + 2 * k + lag_system_memory(n, m) + lag_nnls_memory(k);
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
    impact->system = lag_take(&memory, lag_system_memory(n, m));
    impact->search = memory;
    memset(impact->gamma, 0, m * sizeof(double));
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

/* Responses (blow->count, impact->count) of rates and speeds to unit impulses. */
static void respond(lag_impact *impact, lag_system *system, const lag_blow *blow)
{
    const size_t n = impact->motion->model->nq;
    for (size_t i = 0; i < blow->count; ++i) {
        pick(impact, blow->rows + i * n, impact->force);
        lag_system_solve(system, impact->force, impact->gamma, impact->response + i * impact->count, impact->lam);
    }
    for (size_t i = 0; i < blow->count; ++i) {
        impact->wanted[i] = (1.0 + blow->factor[i]) * blow->speed[i];
        pick(impact, blow->rows + i * n, impact->force);
        for (size_t j = 0; j < blow->count; ++j) {
            impact->compliance[i * blow->count + j] = lag_dot(impact->count, impact->force, impact->response + j * impact->count);
        }
    }
}

lag_status lag_impact_strike(lag_impact *impact, double t, double *x, const lag_blow *blow)
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
    respond(impact, &system, blow);
    lag_nnls(blow->count, impact->compliance, impact->wanted, impact->impulse, impact->search);
    for (size_t i = 0; i < blow->count; ++i) {
        for (size_t j = 0; j < impact->count; ++j) {
            x[model->nq + (size_t)impact->chosen[j]] += impact->impulse[i] * impact->response[i * impact->count + j];
        }
    }
    return LAG_OK;
}
