#include "lag/session/motions.h"

#include <string.h>

#include "lag/linalg/arena.h"
#include "lag/linalg/order.h"
#include "lag/linalg/vector.h"

int lag_motions_can(const lag_model *model, const lag_states *states)
{
    return states != NULL && states->lanes > 1 && states->lanes <= LAG_ATTEMPT_LANES && states->elimination != NULL &&
        model->nk == 0 && model->nload == 0 && model->ndelay == 0 && (model->nz == 0 || states->state_derivative != NULL);
}

size_t lag_motions_memory(const lag_model *model, const lag_states *states)
{
    return states->lanes * (model->nu + model->nw + model->np + model->nc + 5 * model->ni + model->na + 3) + states->workspace;
}

void lag_motions_place(lag_motions *motions, const lag_model *model, const lag_states *states, double *memory)
{
    const size_t lanes = states->lanes;
    memset(motions, 0, sizeof *motions);
    lag_fill(lag_motions_memory(model, states), 0.0, memory); /* lanes that are free are computed, too */
    motions->model = model;
    motions->states = states;
    motions->at.context = model->context;
    motions->at.workspace = lag_take(&memory, states->workspace);
    motions->at.u = motions->u = lag_take(&memory, lanes * model->nu);
    motions->at.w = motions->w = lag_take(&memory, lanes * model->nw);
    motions->at.p = motions->p = lag_take(&memory, lanes * model->np);
    motions->pivot = lag_take(&memory, lanes);
    motions->lam = lag_take(&memory, lanes * (model->nc + 1));
    motions->value = lag_take(&memory, lanes * model->ni);
    motions->scale = lag_take(&memory, lanes * model->ni);
    motions->held = lag_take(&memory, lanes * model->na);
    motions->t = lag_take(&memory, lanes);
    motions->start = lag_take(&memory, lanes * model->ni);
    motions->size = lag_take(&memory, lanes * model->ni);
    motions->drift = lag_take(&memory, lanes * model->ni);
    motions->known = (lag_known_conditions){
        .lanes = lanes, .t = motions->t, .value = motions->value, .scale = motions->scale, .held = motions->held
    };
    motions->smallest = lag_smallest_pivot(model);
}

void lag_motions_enter(lag_motions *motions, size_t k, lag_motion *motion)
{
    motions->of[k] = motion;
    motions->prepared = 0;
    lag_lane_put(motions->states->lanes, k, motions->model->np, motion->at.p, motions->p);
}

lag_status lag_motions_take(lag_motions *motions)
{
    const lag_model *model = motions->model;
    const size_t lanes = motions->states->lanes;
    for (size_t k = 0; k < lanes && model->nu + model->nw > 0; ++k) {
        if (motions->of[k] != NULL) {
            lag_lane_put(lanes, k, model->nu, motions->of[k]->u, motions->u);
            lag_lane_put(lanes, k, model->nw, motions->of[k]->w, motions->w);
        }
    }
    motions->known.x = NULL;
    const lag_status status = motions->prepared ? LAG_OK : motions->states->prepare(&motions->at);
    motions->prepared = status == LAG_OK;
    return status;
}

/* Inputs that change with time, at the time of each lane. */
static void take_inputs(lag_motions *motions, const double *t)
{
    const size_t lanes = motions->states->lanes;
    for (size_t k = 0; k < lanes && motions->model->nu > 0; ++k) {
        lag_motion *motion = motions->of[k];
        if (motion != NULL && motion->inputs != NULL) {
            motion->inputs(motion->context, t[k], t[k] >= motion->until, motion->u);
            lag_lane_put(lanes, k, motions->model->nu, motion->u, motions->u);
        }
    }
}

void lag_motions_rates(void *context, const double *t, const double *x, double *xd, double *fault)
{
    lag_motions *motions = context;
    const lag_model *model = motions->model;
    const lag_states *states = motions->states;
    const size_t n = model->nq * states->lanes;
    double none[LAG_ATTEMPT_LANES];
    lag_arguments *at = &motions->at;
    take_inputs(motions, t);
    at->times = t;
    at->q = x;
    at->qd = x + n;
    at->z = x + 2 * n;
    at->qdd = xd + n;
    at->lam = motions->lam;
    memcpy(xd, at->qd, n * sizeof(double));
    lag_status status = states->elimination(at, xd + n, motions->lam, none, none, none, none, motions->pivot);
    if (status == LAG_OK && model->nz > 0) {
        status = states->state_derivative(at, xd + 2 * n);
    }
    lag_attempt_check(model->nc * states->lanes, states->lanes, motions->lam, fault);
    lag_attempt_compare(states->lanes, motions->pivot, status == LAG_OK ? motions->smallest : (double)INFINITY, fault);
}

void lag_motions_monitor(void *context, const double *t, const double *x, double *broken)
{
    lag_motions *motions = context;
    const lag_states *states = motions->states;
    const size_t lanes = states->lanes;
    const int found = states->monitor != NULL && states->monitor(&motions->at, motions->value, motions->scale, motions->held) == LAG_OK;
    motions->known.x = found ? x : NULL;
    memcpy(motions->t, t, lanes * sizeof(double));
    for (size_t i = 0; i < motions->model->ni && motions->tolerance != NULL; ++i) {
        for (size_t k = 0; k < lanes; ++k) {
            const size_t place = i * lanes + k;
            const double drift = lag_conditions_drift(motions->value[place], motions->start[place]);
            const double size = lag_conditions_size(motions->start[place], motions->scale[place], motions->size[place]);
            broken[k] = drift <= motions->tolerance[i] * size ? broken[k] : 1.0;
        }
    }
    for (size_t i = 0; i < motions->model->na * lanes; ++i) { /* warnings are told, too */
        broken[i & (lanes - 1)] = motions->held[i] > 0.0 ? broken[i & (lanes - 1)] : 1.0;
    }
    for (size_t k = 0; k < lanes && !found; ++k) {
        broken[k] = 1.0;
    }
}

void lag_motions_conditions(const lag_motions *motions, size_t k, lag_known_conditions *known)
{
    const lag_known_conditions *all = &motions->known;
    known->lanes = all->lanes;
    known->t = all->t + k;
    known->x = all->x == NULL ? NULL : all->x + k;
    known->value = all->value + k;
    known->scale = all->scale + k;
    known->held = all->held + k;
}

void lag_motions_open(lag_motions *motions, size_t k, const lag_conditions *conditions)
{
    const size_t lanes = motions->states->lanes;
    motions->tolerance = conditions->tolerance;
    lag_lane_put(lanes, k, motions->model->ni, conditions->start, motions->start);
    lag_lane_put(lanes, k, motions->model->ni, conditions->size, motions->size);
    lag_lane_put(lanes, k, motions->model->ni, conditions->drift, motions->drift);
}

void lag_motions_count(lag_motions *motions, const double *accepted)
{
    const size_t lanes = motions->states->lanes;
    for (size_t i = 0; i < motions->model->ni * lanes && motions->known.x != NULL; ++i) {
        const int counts = accepted[i & (lanes - 1)] != 0.0;
        const double drift = lag_conditions_drift(motions->value[i], motions->start[i]);
        const double size = lag_conditions_size(motions->start[i], motions->scale[i], motions->size[i]);
        motions->size[i] = counts ? size : motions->size[i];
        motions->drift[i] = counts ? lag_higher(drift, motions->drift[i]) : motions->drift[i];
    }
}

void lag_motions_close(const lag_motions *motions, size_t k, lag_conditions *conditions)
{
    const size_t lanes = motions->states->lanes;
    lag_lane_get(lanes, k, motions->model->ni, motions->size, conditions->size);
    lag_lane_get(lanes, k, motions->model->ni, motions->drift, conditions->drift);
}
