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

lag_status lag_instance_start_slopes(lag_instance *instance)
{
    const lag_model *model = instance->fmu->model;
    lag_motion *motion = &instance->run->motion;
    const unsigned char *free = instance->fmu->start->free;
    const size_t size = lag_motion_size(model);
    double *direction = instance->derivatives.x;
    double *of_inputs = direction + size;
    double *of_parameters = of_inputs + model->nu;
    double *memory = instance->scratch.slopes;
    double *w = lag_take(&memory, model->nw);
    double *x = lag_take(&memory, size);
    double *p = lag_take(&memory, model->np);
    double *slope = lag_take(&memory, size + model->np);
    memcpy(w, motion->w, model->nw * sizeof(double));
    lag_fill(size + model->np, 0.0, slope);
    double most = fmax(most_of(1, &instance->derivatives.time, &instance->held.t, 1.0), most_of(size, direction, instance->x, SMALLEST));
    most = fmax(most, most_of(model->nu, of_inputs, instance->inputs.course, SMALLEST));
    most = fmax(most, most_of(model->np, of_parameters, instance->p, SMALLEST));
    const double h = LAG_DISTANCE / most;
    lag_status status = LAG_OK;
    for (size_t k = 0; k < LAG_POINTS && most > 0.0 && status == LAG_OK; ++k) {
        lag_initial told = {.p = p};
        memcpy(p, instance->p, model->np * sizeof(double));
        lag_axpy(model->np, LAG_POINT[k] * h, of_parameters, p);
        status = lag_instance_find_start(instance, LAG_POINT[k] * h, x, &told);
        lag_axpy(size, LAG_WEIGHT[k] / h, x, slope);
        lag_axpy(model->np, LAG_WEIGHT[k] / h, p, slope + size);
    }
    memcpy(motion->w, w, model->nw * sizeof(double));
    memcpy(direction, slope, size * sizeof(double));
    for (size_t i = 0; i < model->np && free != NULL; ++i) {
        of_parameters[i] = free[i] ? slope[size + i] : of_parameters[i];
    }
    lag_instance_set_run_inputs(instance);
    instance->values.known &= LAG_KNOWN_DERIVATIVES | LAG_KNOWN_PULLED;
    const lag_status restored = lag_motion_parameters(motion, instance->p);
    return status == LAG_OK ? restored : status;
}
