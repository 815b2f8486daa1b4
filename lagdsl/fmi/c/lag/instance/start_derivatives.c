/*
 * Derivatives of a start that constraints or initial equations determine, and of free parameters. The start is the result of a
 * search, so the search is repeated beside the present values: central differences of tenth order.
 */
#include "lag/instance/instance_internal.h"

#include <math.h>
#include <string.h>

#include "lag/initial.h"
#include "lag/linalg/arena.h"

enum { PAIRS = 5 };
static const double WEIGHT[PAIRS] = {5.0 / 6.0, -5.0 / 21.0, 5.0 / 84.0, -5.0 / 504.0, 1.0 / 1260.0};
/* The largest change of a value in a step, as a part of its size. */
static const double PART = 1e-2;
/* Values smaller than this have this size. */
static const double SMALLEST = 1e-2;

typedef struct search {
    lag_instance *instance;
    double *p, *u, *w;  /* (np) moved, (nu) (nw) as they were */
    double *x, *sum;    /* (2 nq + nz) */
    double *found;      /* (np) sums of the free parameters */
    double *direction;  /* (2 nq + nz + nu + np) of starts, inputs and parameters */
} search;

size_t lag_instance_start_slopes_memory(const lag_model *model)
{
    const size_t size = lag_motion_size(model);
    return 3 * size + 3 * model->np + 2 * model->nu + model->nw;
}

/* A length of steps that moves no value by more than a part of its size. */
static double length_of(const search *s)
{
    const lag_instance *instance = s->instance;
    const lag_model *model = instance->fmu->model;
    const size_t size = lag_motion_size(model);
    const double *values[3] = {instance->x, s->u, instance->p};
    const size_t counts[3] = {size, model->nu, model->np};
    const double *seed = s->direction;
    double most = fabs(instance->derivatives.time) / fmax(fabs(instance->held.t), 1.0);
    for (size_t group = 0; group < 3; ++group) {
        for (size_t i = 0; i < counts[group]; ++i) {
            most = fmax(most, fabs(*seed++) / fmax(fabs(values[group][i]), SMALLEST));
        }
    }
    return PART / most;
}

/* The start so far along the direction, added to the sum with a weight. */
static lag_status add(search *s, double along, double weight)
{
    lag_instance *instance = s->instance;
    const lag_model *model = instance->fmu->model;
    lag_motion *motion = &instance->run->motion;
    const size_t size = lag_motion_size(model);
    const double t = instance->held.t + along * instance->derivatives.time;
    for (size_t i = 0; i < model->np; ++i) {
        s->p[i] = instance->p[i] + along * s->direction[size + model->nu + i];
    }
    lag_status status = lag_motion_parameters(motion, s->p);
    if (status == LAG_OK) {
        status = lag_motion_start(motion, t, s->x);
    }
    for (size_t i = 0; i < size; ++i) {
        s->x[i] = (instance->given[i] != 0.0 ? instance->begin[i] : s->x[i]) + along * s->direction[i];
    }
    for (size_t i = 0; i < model->nu; ++i) {
        motion->u[i] = s->u[i] + along * s->direction[size + i];
    }
    if (status == LAG_OK && model->nc + model->ne > 0) {
        lag_initial told = {.p = s->p};
        status = lag_initial_find(motion, instance->fmu->start, instance->written, t, s->x, instance->initial_memory, &told);
    }
    for (size_t i = 0; i < model->np; ++i) {
        s->found[i] += weight * s->p[i];
    }
    for (size_t i = 0; i < size; ++i) {
        s->sum[i] += weight * s->x[i];
    }
    return status;
}

lag_status lag_instance_start_slopes(lag_instance *instance)
{
    const lag_model *model = instance->fmu->model;
    lag_motion *motion = &instance->run->motion;
    lag_inputs *const inputs = motion->inputs;
    const size_t size = lag_motion_size(model);
    double *memory = instance->slopes;
    search s = {.instance = instance};
    s.p = lag_take(&memory, model->np);
    s.u = lag_take(&memory, model->nu);
    s.w = lag_take(&memory, model->nw);
    s.x = lag_take(&memory, size);
    s.sum = lag_take(&memory, size);
    s.found = lag_take(&memory, model->np);
    s.direction = lag_take(&memory, size + model->nu + model->np);
    memcpy(s.u, motion->u, model->nu * sizeof(double));
    memcpy(s.w, motion->w, model->nw * sizeof(double));
    memcpy(s.direction, instance->derivatives.x, (size + model->nu + model->np) * sizeof(double));
    lag_fill(size, 0.0, s.sum);
    lag_fill(model->np, 0.0, s.found);
    for (size_t i = 0; i < size; ++i) {
        instance->written[i] = instance->given[i] != 0.0;
    }
    const double h = length_of(&s);
    lag_status status = LAG_OK;
    motion->inputs = NULL;
    for (size_t k = 0; k < PAIRS && h < (double)INFINITY && status == LAG_OK; ++k) {
        status = add(&s, (double)(k + 1) * h, WEIGHT[k] / h);
        if (status == LAG_OK) {
            status = add(&s, -(double)(k + 1) * h, -WEIGHT[k] / h);
        }
    }
    motion->inputs = inputs;
    memcpy(motion->u, s.u, model->nu * sizeof(double));
    memcpy(motion->w, s.w, model->nw * sizeof(double));
    memcpy(instance->derivatives.x, s.sum, size * sizeof(double));
    const unsigned char *free = instance->fmu->start->free;
    for (size_t i = 0; i < model->np && free != NULL; ++i) {
        double *slope = instance->derivatives.x + size + model->nu + i;
        *slope = free[i] ? s.found[i] : *slope;
    }
    instance->known &= LAG_KNOWN_DERIVATIVES | LAG_KNOWN_PULLED;
    const lag_status restored = lag_motion_parameters(motion, instance->p);
    return status == LAG_OK ? restored : status;
}
