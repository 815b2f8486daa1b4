/* The start of the motion: where nothing was set it is the start that was found when the model was exported, elsewhere the nearest. */
#include "lag/parts.h"

#include <string.h>

/* Whether everything that the start depends on is as it was when the model was exported. */
static int as_exported(const lag_instance *instance)
{
    const lag_fmu *fmu = instance->fmu;
    const lag_model *model = fmu->model;
    const double *u = instance->run->motion.u;
    int same = fmu->start->x != NULL && fmu->start->t == instance->held.t;
    for (size_t i = 0; i < model->np && same; ++i) {
        same = instance->p[i] == model->defaults[i];
    }
    for (size_t i = 0; i < lag_motion_size(model) && same; ++i) {
        same = instance->given[i] == 0.0;
    }
    for (size_t i = 0; i < model->nu && same && model->nc + model->ne > 0; ++i) {
        same = instance->course[i] == u[i];
    }
    return same;
}

/* Start values of states, and of inputs, that were not set are those of the model; `motion->u` are its own. */
static lag_status gather(lag_instance *instance)
{
    const lag_model *model = instance->fmu->model;
    lag_motion *motion = &instance->run->motion;
    const lag_status status = lag_motion_start(motion, instance->held.t, instance->x);
    for (size_t i = 0; i < lag_motion_size(model); ++i) {
        instance->x[i] = instance->given[i] != 0.0 ? instance->begin[i] : instance->x[i];
    }
    for (size_t i = 0; i < model->nu; ++i) {
        instance->course[i] = instance->given_inputs[i] != 0.0 ? instance->course[i] : motion->u[i];
    }
    return status;
}

/* The state at which the motion begins, into x. */
static lag_status find(lag_instance *instance)
{
    int moved = 0;
    lag_status status = gather(instance);
    const int exported = status == LAG_OK && as_exported(instance);
    lag_instance_tell_inputs(instance);
    if (exported) {
        memcpy(instance->x, instance->fmu->start->x, lag_instance_order(instance) * sizeof(double));
    }
    if (status == LAG_OK) {
        status = lag_run_move(instance->run, instance->held.t, instance->x, 0.0);
    }
    if (status == LAG_OK && !exported) {
        status = lag_projection_exact(&instance->run->projection, instance->held.t, instance->run->stepper.x, &moved);
    }
    return status;
}

lag_status lag_instance_settle(lag_instance *instance)
{
    lag_held *held = &instance->held;
    lag_run *run = instance->run;
    lag_instance_renew(instance);
    held->initialized = held->prepared = 1;
    held->jumped = 1;
    held->stopped = 0;
    run->begun = held->t;
    lag_status status = lag_motion_parameters(&run->motion, instance->p);
    if (status == LAG_OK) {
        status = find(instance);
    }
    if (status == LAG_OK) {
        status = lag_run_enter(run);
    }
    memcpy(instance->x, run->stepper.x, lag_instance_order(instance) * sizeof(double));
    held->stopped = status == LAG_STOPPED;
    if (status == LAG_OK || status == LAG_STOPPED) {
        status = lag_instance_latch(instance, held->t, instance->x);
    }
    if (status == LAG_OK) {
        status = lag_instance_turn(instance, held->t, instance->x);
    }
    if (status != LAG_OK) {
        held->initialized = 0;
    }
    return lag_instance_judge(instance, status);
}

lag_status lag_instance_initialize(lag_instance *instance)
{
    return lag_instance_ready(instance);
}

lag_status lag_instance_begin(lag_instance *instance)
{
    lag_held *held = &instance->held;
    if (held->phase == LAG_PHASE_MOTION) {
        return LAG_OK;
    }
    const lag_status status = lag_instance_ready(instance);
    if (status == LAG_OK) {
        held->phase = LAG_PHASE_MOTION;
        held->last = held->t;
        held->span = 0.0;
    }
    return status;
}
