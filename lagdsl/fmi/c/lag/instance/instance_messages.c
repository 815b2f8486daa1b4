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

void lag_instance_note_stop(lag_instance *instance, lag_status status)
{
    const lag_model *model = instance->fmu->model;
    const size_t i = instance->held.ending;
    if (status != LAG_STOPPED) {
        return;
    }
    instance->held.stopped = 1;
    (void)lag_instance_fail(instance, status, "t = %.10g s: %s", instance->run->stepper.t,
        i < model->nstop ? model->stops[i] : "the model ends the simulation");
}

static const char *name_of(size_t count, const lag_slot *slots, size_t which)
{
    return which < count ? slots[which].name : "the model";
}

/* The first discrete that an event could not settle. */
static const char *guilty(const lag_instance *instance)
{
    const lag_model *model = instance->fmu->model;
    size_t i = 0;
    while (i < model->nw && instance->run->instants.iteration.guilty[i] == 0.0) {
        ++i;
    }
    return name_of(model->nw, model->discretes, i);
}

/* Name of the state that has placed a mass elsewhere, as a clause has set it, else of the first discrete that has changed. */
static const char *displacing(const lag_instance *instance)
{
    const lag_model *model = instance->fmu->model;
    const lag_run *run = instance->run;
    for (size_t i = 0; i < model->nreset; ++i) {
        const size_t place = model->reset_places[i];
        if (place >= 2 * model->nq && run->stepper.x[place] != run->instants.iteration.from[place]) {
            return model->resets[i];
        }
    }
    return guilty(instance);
}

/* The first assertion that does not hold where the run looked last. */
static const char *broken(const lag_instance *instance)
{
    const lag_model *model = instance->fmu->model;
    size_t i = 0;
    while (i < model->na && instance->run->watch.held[i] != 0.0) {
        ++i;
    }
    return i < model->na ? model->assertions[i] : "an invariant left its tolerance";
}

/* Words for a status that names nothing of the model; null for the others. */
static const char *plain_words(lag_status status)
{
    switch (status) {
    case LAG_NOT_FINITE:
        return "a value is infinite or not a number";
    case LAG_STEP_TOO_SMALL:
        return "steps became as short as the round-off of time";
    case LAG_PROJECTION_FAILED:
        return "the constraints cannot be reached from here";
    case LAG_ATTENTION:
        return "the constraints are about to lose rank";
    case LAG_BRANCH_POINT:
        return "branches of the motion meet, and the equations do not determine the branch";
    case LAG_POSITION_JUMP:
        return "a constraint becomes active, but the current position violates it";
    case LAG_BAD_CLOCK:
        return "a clock has no positive period, or no first instant";
    case LAG_TOO_LONG:
        return "this takes too many steps";
    default:
        return NULL;
    }
}

lag_status lag_instance_judge(lag_instance *instance, lag_status status)
{
    const lag_model *model = instance->fmu->model;
    const lag_run *run = instance->run;
    const double t = instance->held.t;
    switch (status) {
    case LAG_OK:
    case LAG_STOPPED:
        return status;
    case LAG_SINGULAR:
        return lag_instance_fail(instance, status, "t = %.10g s: the acceleration of %s is not determined", t,
            name_of(model->nq, model->coordinates, run->motion.coordinate));
    case LAG_MOMENTUM_UNREACHABLE:
        return lag_instance_fail(instance, status, "t = %.10g s: no rate of %s has the momentum or the energy that the event leaves", t,
            name_of(model->nq, model->coordinates, run->motion.coordinate));
    case LAG_VIOLATED:
        return lag_instance_fail(instance, status, "t = %.10g s: %s", t, broken(instance));
    case LAG_CHATTER:
        return lag_instance_fail(instance, status, "t = %.10g s: events of %s accumulate", t, guilty(instance));
    case LAG_EVENT_ITERATION_FAILED:
        return lag_instance_fail(instance, status, "t = %.10g s: event iteration did not converge; still changing: %s", t, guilty(instance));
    case LAG_CONFLICT:
        return lag_instance_fail(instance, status, "t = %.10g s: two clauses reset %s to different values", t,
            run->instants.iteration.fault < model->nreset ? model->resets[run->instants.iteration.fault] : "a state");
    case LAG_ASSERTION_FAILED:
        return lag_instance_fail(instance, status, "t = %.10g s: %s", t,
            run->instants.iteration.fault < model->nfail ? model->failures[run->instants.iteration.fault] : "an assertion failed");
    case LAG_PENETRATION:
        return lag_instance_fail(instance, status, "t = %.10g s: the gap of %s is negative", t, guilty(instance));
    case LAG_WAY_JUMP:
        return lag_instance_fail(instance, status, "t = %.10g s: the position of a mass would jump with %s", t, displacing(instance));
    default:
        break;
    }
    const char *words = plain_words(status);
    if (words != NULL) {
        return lag_instance_fail(instance, status, "t = %.10g s: %s", t, words);
    }
    return lag_instance_fail(instance, status, "t = %.10g s: status %d", t, (int)status);
}

lag_status lag_instance_give_up(lag_instance *instance)
{
    return lag_instance_judge(instance, LAG_TOO_LONG);
}
