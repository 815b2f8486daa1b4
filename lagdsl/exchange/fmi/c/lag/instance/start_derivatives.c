/*
 * Derivatives of a start that constraints or initial equations determine, and of free parameters. The start is the result of a
 * search, so the search is repeated beside the present values, for differences.
 */
#include "lag/instance/instance_internal.h"

#include <math.h>
#include <string.h>

#include "lag/initial.h"
#include "lag/linalg/arena.h"
#include "lag/linalg/vector.h"

/* Smaller values than this have this size. */
static const double SMALLEST = 1e-2;

size_t lag_instance_start_slopes_memory(const lag_model *model)
{
    return 2 * lag_motion_size(model) + 2 * model->np + model->nu + model->nw;
}

/* The largest entry of a direction, in sizes of the values. */
static double most_of(size_t count, const double *direction, const double *values, double smallest)
{
    double most = 0.0;
    for (size_t i = 0; i < count; ++i) {
        most = fmax(most, fabs(direction[i]) / fmax(fabs(values[i]), smallest));
    }
    return most;
}

/* The start (2 nq + nz) so far along the direction, with the inputs u (nu) there, and the parameters (np). */
static lag_status search(lag_instance *instance, double along, const double *u, double *x, double *p)
{
    const lag_model *model = instance->fmu->model;
    const lag_derivatives *d = &instance->derivatives;
    lag_motion *motion = &instance->run->motion;
    const size_t size = lag_motion_size(model);
    const double t = instance->held.t + along * d->time;
    lag_initial told = {.p = p};
    memcpy(p, instance->p, model->np * sizeof(double));
    lag_axpy(model->np, along, d->x + size + model->nu, p);
    lag_status status = lag_motion_parameters(motion, p);
    if (status == LAG_OK) {
        status = lag_motion_start(motion, t, x);
    }
    for (size_t i = 0; i < size; ++i) {
        x[i] = (instance->starts.given[i] != 0.0 ? instance->starts.values[i] : x[i]) + along * d->x[i];
    }
    memcpy(motion->u, u, model->nu * sizeof(double));
    lag_axpy(model->nu, along, d->x + size, motion->u);
    const int searched = status == LAG_OK && model->nc + model->ne > 0;
    return searched ? lag_initial_find(motion, instance->fmu->start, instance->starts.written, t, x, instance->scratch.initial, &told) : status;
}

lag_status lag_instance_start_slopes(lag_instance *instance)
{
    const lag_model *model = instance->fmu->model;
    lag_motion *motion = &instance->run->motion;
    lag_inputs *const inputs = motion->inputs;
    double *direction = instance->derivatives.x;
    const size_t size = lag_motion_size(model);
    double *memory = instance->scratch.slopes;
    double *u = lag_take(&memory, model->nu);
    double *w = lag_take(&memory, model->nw);
    double *x = lag_take(&memory, size);
    double *p = lag_take(&memory, model->np);
    double *slope = lag_take(&memory, size + model->np);
    memcpy(u, motion->u, model->nu * sizeof(double));
    memcpy(w, motion->w, model->nw * sizeof(double));
    lag_fill(size + model->np, 0.0, slope);
    for (size_t i = 0; i < size; ++i) {
        instance->starts.written[i] = instance->starts.given[i] != 0.0;
    }
    const double time = most_of(1, &instance->derivatives.time, &instance->held.t, 1.0);
    const double states = fmax(time, most_of(size, direction, instance->x, SMALLEST));
    const double set = fmax(most_of(model->nu, direction + size, u, SMALLEST), most_of(model->np, direction + size + model->nu, instance->p, SMALLEST));
    const double h = LAG_DISTANCE / fmax(states, set);
    lag_status status = LAG_OK;
    motion->inputs = NULL;
    for (size_t k = 0; k < LAG_POINTS && h < (double)INFINITY && status == LAG_OK; ++k) {
        status = search(instance, LAG_POINT[k] * h, u, x, p);
        lag_axpy(size, LAG_WEIGHT[k] / h, x, slope);
        lag_axpy(model->np, LAG_WEIGHT[k] / h, p, slope + size);
    }
    motion->inputs = inputs;
    memcpy(motion->u, u, model->nu * sizeof(double));
    memcpy(motion->w, w, model->nw * sizeof(double));
    memcpy(direction, slope, size * sizeof(double));
    for (size_t i = 0; i < model->np && instance->fmu->start->free != NULL; ++i) {
        double *of_parameter = direction + size + model->nu + i;
        *of_parameter = instance->fmu->start->free[i] ? slope[size + i] : *of_parameter;
    }
    instance->values.known &= LAG_KNOWN_DERIVATIVES | LAG_KNOWN_PULLED;
    const lag_status restored = lag_motion_parameters(motion, instance->p);
    return status == LAG_OK ? restored : status;
}
