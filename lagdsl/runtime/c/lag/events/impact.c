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
    return n * n + m * n + 3 * m + n + model->nw + k * n + k * k + 2 * k + lag_system_memory(n, m) + lag_nnls_memory(k);
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

/* Responses of rates and speeds to unit impulses. */
static void respond(lag_impact *impact, lag_system *system, const lag_blow *blow)
{
    const size_t n = impact->motion->model->nq;
    for (size_t i = 0; i < blow->count; ++i) {
        memcpy(impact->force, blow->rows + i * n, n * sizeof(double));
        lag_system_solve(system, impact->force, impact->gamma, impact->response + i * n, impact->lam);
    }
    for (size_t i = 0; i < blow->count; ++i) {
        impact->wanted[i] = (1.0 + blow->factor[i]) * blow->speed[i];
        for (size_t j = 0; j < blow->count; ++j) {
            impact->compliance[i * blow->count + j] = lag_dot(n, blow->rows + i * n, impact->response + j * n);
        }
    }
}

lag_status lag_impact_strike(lag_impact *impact, double t, double *x, const lag_blow *blow)
{
    const lag_model *model = impact->motion->model;
    const size_t n = model->nq;
    lag_system system;
    lag_status status = look(impact, t, x);
    if (status == LAG_OK) {
        lag_system_place(&system, n, model->nc, impact->system);
        status = lag_system_factor(&system, impact->mass, impact->jacobian, model->rank, &impact->motion->coordinate);
    }
    if (status != LAG_OK) {
        return status;
    }
    respond(impact, &system, blow);
    lag_nnls(blow->count, impact->compliance, impact->wanted, impact->impulse, impact->search);
    for (size_t i = 0; i < blow->count; ++i) {
        for (size_t j = 0; j < n; ++j) {
            x[n + j] += impact->impulse[i] * impact->response[i * n + j];
        }
    }
    return LAG_OK;
}
