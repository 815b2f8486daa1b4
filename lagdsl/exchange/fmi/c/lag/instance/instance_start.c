/* The start of the motion: where nothing was set it is the start that was found when the model was exported, elsewhere the nearest. */
#include "lag/instance/instance_internal.h"

#include <math.h>
#include <string.h>

#include "lag/initial.h"
#include "lag/linalg/arena.h"

int lag_instance_is_free(const lag_instance *instance, const lag_variable *variable)
{
    const unsigned char *free = instance->fmu->start->free;
    return variable->role == LAG_ROLE_PARAMETER && free != NULL && free[variable->first] != 0;
}

/* True if every value that the start depends on is as it was at export. Free parameters are searched anew. */
static int as_exported(const lag_instance *instance)
{
    const lag_fmu *fmu = instance->fmu;
    const lag_model *model = fmu->model;
    const double *u = instance->run->motion.u;
    int same = fmu->start->x != NULL && fmu->start->free == NULL && fmu->start->t == instance->held.t;
    for (size_t i = 0; i < model->np && same; ++i) {
        same = instance->p[i] == model->defaults[i];
    }
    for (size_t i = 0; i < lag_motion_size(model) && same; ++i) {
        same = instance->starts.given[i] == 0.0 || instance->starts.values[i] == fmu->start->x[i];
    }
    for (size_t i = 0; i < model->nu && same && model->nc + model->ne > 0; ++i) {
        same = instance->inputs.course[i] == u[i];
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
        instance->x[i] = instance->starts.given[i] != 0.0 ? instance->starts.values[i] : instance->x[i];
    }
    for (size_t i = 0; i < model->nu; ++i) {
        instance->inputs.course[i] = instance->inputs.given[i] != 0.0 ? instance->inputs.course[i] : motion->u[i];
    }
    return status;
}

/* Why there is no start. */
static lag_status explain(lag_instance *instance, lag_status status, const lag_initial *told)
{
    const lag_model *model = instance->fmu->model;
    const size_t states = 2 * model->nq + model->nz;
    const size_t i = told->which;
    switch (told->fault) {
    case LAG_INITIAL_NUMBERS:
        return lag_instance_fail(instance, status, "start: %s is no number with these start values and parameters",
            i < model->nq ? model->coordinates[i].name
                : i < 2 * model->nq ? model->coordinates[i - model->nq].name
                : i < states ? model->states[i - 2 * model->nq].name
                : i - states < model->nc ? model->constraints[i - states].name : "a constraint");
    case LAG_INITIAL_POSITIONS:
        return lag_instance_fail(instance, status, "start: %s cannot be satisfied with these start values and parameters (%g is left)",
            i < model->nc ? model->constraints[i].name : "a constraint", told->residual);
    case LAG_INITIAL_RATES:
        return lag_instance_fail(instance, status, "start: the rate of %s cannot be what it has to be (%g is left)",
            i < model->nc ? model->constraints[i].name : model->coordinates[i - model->nc].name, told->residual);
    case LAG_INITIAL_EQUATIONS:
        return lag_instance_fail(instance, status, "start: %s cannot be satisfied (%g is left)",
            i < model->nc ? model->constraints[i].name : "an initial equation", told->residual);
    case LAG_INITIAL_RANK:
        return lag_instance_fail(instance, status, "start: with these parameters more constraints are independent than when it was exported");
    case LAG_INITIAL_SIZES:
        return lag_instance_fail(instance, status, "start: with these parameters the equations of %s are %.0e times as large as those beside them; export it with these parameters",
            model->constraints[i].name, told->residual);
    case LAG_INITIAL_PARAMETERS:
        return lag_instance_fail(instance, status, "start: no initial equation decides the parameter %s", model->parameters[i].name);
    case LAG_INITIAL_BOUNDS:
        return lag_instance_fail(instance, status, "start: %s would be %g, which is beyond its bounds", model->parameters[i].name, told->residual);
    case LAG_INITIAL_NONE:
        break;
    }
    return lag_instance_judge(instance, status);
}

/* The nearest state that the model allows, into x; without constraints and equations the start values are. */
static lag_status nearest(lag_instance *instance)
{
    const lag_model *model = instance->fmu->model;
    lag_run *run = instance->run;
    lag_initial told = {.dependent = run->ranks.dependent, .p = instance->p};
    if (model->nc + model->ne == 0) {
        return LAG_OK;
    }
    for (size_t i = 0; i < lag_instance_order(instance); ++i) {
        instance->starts.written[i] = instance->starts.given[i] != 0.0;
    }
    const lag_status status = lag_initial_find(
        &run->motion, instance->fmu->start, instance->starts.written, instance->held.t, instance->x, instance->scratch.initial, &told);
    lag_run_depend(run, run->ranks.dependent);
    return status == LAG_OK ? status : explain(instance, status, &told);
}

/* The state at which the motion begins, into x. */
static lag_status find(lag_instance *instance)
{
    lag_run *run = instance->run;
    const unsigned char *free = instance->fmu->start->free;
    for (size_t i = 0; i < instance->fmu->model->np && free != NULL; ++i) {
        instance->p[i] = instance->starts.parameters[i];
    }
    lag_status status = lag_motion_parameters(&run->motion, instance->p);
    if (status == LAG_OK) {
        status = gather(instance);
    }
    const int exported = status == LAG_OK && as_exported(instance);
    lag_instance_set_run_inputs(instance);
    if (status != LAG_OK) {
        return lag_instance_judge(instance, status);
    }
    if (exported) {
        memcpy(instance->x, instance->fmu->start->x, lag_instance_order(instance) * sizeof(double));
    } else {
        status = nearest(instance);
    }
    return status == LAG_OK ? lag_instance_judge(instance, lag_run_move(run, instance->held.t, instance->x, 0.0)) : status;
}

lag_status lag_instance_begin_at(lag_instance *instance)
{
    lag_held *held = &instance->held;
    lag_run *run = instance->run;
    lag_instance_renew(instance);
    held->jumped = held->prepared = 1;
    lag_turns_clear(&run->turns);
    held->stopped = held->tied = 0;
    held->left_at = held->t;
    held->left_for = 0.0;
    held->implicit = -1;
    run->counts.begun = held->t;
    lag_status status = find(instance);
    if (status != LAG_OK) {
        return status;
    }
    status = lag_run_enter(run);
    memcpy(instance->x, run->stepper.x, lag_instance_order(instance) * sizeof(double));
    lag_instance_note_stop(instance, status);
    lag_fill(lag_guard_count(instance->fmu->model), 0.0, instance->guards.latched);
    lag_fill(lag_guard_count(instance->fmu->model), (double)INFINITY, instance->guards.armed);
    if (status == LAG_OK || status == LAG_STOPPED) {
        status = lag_instance_arm(instance);
    }
    if (status == LAG_OK) {
        status = lag_run_count_turns(instance->run, held->t, instance->x);
    }
    if (status == LAG_OK) {
        status = lag_instance_assert(instance, held->t, instance->x);
    }
    held->initialized = status == LAG_OK;
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
    }
    return status;
}
