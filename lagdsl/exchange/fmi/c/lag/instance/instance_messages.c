/* Messages of an instance about failures and the end of a simulation. */
#include "lag/instance/instance_internal.h"

#include <stdarg.h>
#include <stdio.h>

const char *lag_instance_message(const lag_instance *instance)
{
    return instance->message;
}

lag_status lag_instance_fail(lag_instance *instance, lag_status status, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    (void)vsnprintf(instance->message, LAG_MESSAGE, format, arguments);
    va_end(arguments);
    return status;
}

/* Name of the state that has placed a mass elsewhere, as a clause has set it; null: no clause has. */
static const char *displacing(const lag_instance *instance)
{
    const lag_model *model = instance->fmu->model;
    const lag_run *run = instance->run;
    for (size_t i = 0; i < model->nreset; ++i) {
        const size_t place = model->reset_places[i];
        if (place >= 2 * model->nq && run->stepper.x[place] != run->instants.iteration.instant.from[place]) {
            return model->resets[i];
        }
    }
    return NULL;
}

/* The rows of friction, into `names`. */
static const char *frictions(const lag_model *model, char *names)
{
    size_t length = 0;
    for (size_t k = 0; k < model->nslip && length < LAG_MESSAGE; ++k) {
        const char *name = model->constraints[model->friction_rows[k]].name;
        length += (size_t)snprintf(names + length, LAG_MESSAGE - length, "%s%s", k > 0 ? ", " : "", name);
    }
    return names;
}

typedef enum blamed { NOBODY, COORDINATE, DISCRETE, DISPLACING, RESET, FAILURE, ASSERTION, FRICTIONS } blamed;

static const struct {
    blamed who;
    const char *words; /* with the name in them */
} FAULTS[] = {
    [LAG_SINGULAR] = {COORDINATE, "the acceleration of %s is not determined"},
    [LAG_NOT_FINITE] = {NOBODY, "a value is infinite or not a number"},
    [LAG_MISSING] = {NOBODY, "a function is missing"},
    [LAG_STEP_TOO_SMALL] = {NOBODY, "steps became as short as the round-off of time"},
    [LAG_TOO_LONG] = {NOBODY, "this takes too many steps"},
    [LAG_PROJECTION_FAILED] = {NOBODY, "the constraints cannot be reached from here"},
    [LAG_ATTENTION] = {NOBODY, "the constraints are about to lose rank"},
    [LAG_VIOLATED] = {ASSERTION, "%s"},
    [LAG_CHATTER] = {DISCRETE, "events of %s accumulate"},
    [LAG_EVENT_PENDING] = {NOBODY, "an event is left"},
    [LAG_EVENT_ITERATION_FAILED] = {DISCRETE, "event iteration did not converge; still changing: %s"},
    [LAG_CONFLICT] = {RESET, "two clauses reset %s to different values"},
    [LAG_ASSERTION_FAILED] = {FAILURE, "%s"},
    [LAG_PENETRATION] = {DISCRETE, "the gap of %s is negative"},
    [LAG_POSITION_JUMP] = {NOBODY, "a constraint becomes active, but the current position violates it"},
    [LAG_BRANCH_POINT] = {NOBODY, "branches of the motion meet, and the equations do not determine the branch"},
    [LAG_BAD_STATE_DATA] = {NOBODY, "these bytes are no state of this FMU"},
    [LAG_BAD_CLOCK] = {NOBODY, "a clock has no positive period, or no first instant"},
    [LAG_WAY_JUMP] = {DISPLACING, "the position of a mass would jump with %s"},
    [LAG_MOMENTUM_UNREACHABLE] = {COORDINATE, "no rate of %s has the momentum or the energy that the event leaves"},
    [LAG_NO_FORCES] = {FRICTIONS, "no forces satisfy the law of friction of %s: it wedges"},
    [LAG_BAD_DELAY] = {NOBODY, "a delay is not positive"},
    [LAG_LONG_PAST] = {NOBODY, "the past of a delayed value has too many events"},
};

/* `room` (LAG_MESSAGE) is for a list of names. Discretes are those that an event could not settle. */
static const char *name_of(const lag_instance *instance, lag_status status, char *room)
{
    const lag_model *model = instance->fmu->model;
    const size_t discrete = lag_first(model->nw, instance->run->instants.iteration.discretes.guilty);
    const char *displaced = FAULTS[status].who == DISPLACING ? displacing(instance) : NULL;
    lag_fault fault = {.which = 0};
    if (FAULTS[status].who != NOBODY) {
        lag_run_explain(instance->run, status, &fault);
    }
    switch (FAULTS[status].who) {
    case COORDINATE:
        return fault.which < model->nq ? model->coordinates[fault.which].name : "the model";
    case DISPLACING:
    case DISCRETE:
        return displaced != NULL ? displaced : discrete < model->nw ? model->discretes[discrete].name : "the model";
    case RESET:
        return model->resets[fault.which];
    case FAILURE:
        return model->failures[fault.which];
    case ASSERTION:
        return fault.which < model->na ? model->assertions[fault.which] : "an invariant left its tolerance";
    case FRICTIONS:
        return frictions(model, room);
    case NOBODY:
        break;
    }
    return "";
}

const char *lag_instance_warning(lag_instance *instance)
{
    const lag_model *model = instance->fmu->model;
    const size_t i = lag_first(model->na + model->nfail, instance->warnings);
    if (i == model->na + model->nfail) {
        return NULL;
    }
    instance->warnings[i] = 0.0;
    return i < model->na ? model->assertions[i] : model->failures[i - model->na];
}

lag_status lag_instance_judge(lag_instance *instance, lag_status status)
{
    char room[LAG_MESSAGE] = "";
    char told[LAG_MESSAGE];
    if (status == LAG_OK || status == LAG_STOPPED) {
        return status;
    }
    (void)snprintf(told, sizeof told, FAULTS[status].words, name_of(instance, status, room));
    return lag_instance_fail(instance, status, "t = %.10g s: %s", instance->held.t, told);
}

lag_status lag_instance_give_up(lag_instance *instance)
{
    return lag_instance_judge(instance, LAG_TOO_LONG);
}
