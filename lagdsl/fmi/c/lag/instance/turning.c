/* Angles that are known up to whole turns, followed from one accepted state to the next. */
#include "lag/instance/instance_internal.h"

#include <math.h>
#include <string.h>

static const double TURN = 6.283185307179586476925;

void lag_instance_unwind(const lag_instance *instance, double *y)
{
    for (size_t i = 0; i < instance->fmu->model->ny; ++i) {
        if (instance->fmu->turning[i] != 0 && isfinite(y[i]) && isfinite(instance->turned[i])) {
            y[i] += TURN * nearbyint((instance->turned[i] - y[i]) / TURN);
        }
    }
}

lag_status lag_instance_turn(lag_instance *instance, double t, const double *x)
{
    const lag_model *model = instance->fmu->model;
    lag_motion *motion = &instance->run->motion;
    if (!instance->turning) {
        return LAG_OK;
    }
    instance->known = 0;
    lag_status status = lag_motion_solve(motion, t, x);
    if (status == LAG_OK) {
        status = model->output(&motion->at, instance->y);
    }
    if (status == LAG_OK) {
        lag_instance_unwind(instance, instance->y);
        memcpy(instance->turned, instance->y, model->ny * sizeof(double));
    }
    return status;
}
