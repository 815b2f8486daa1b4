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
static const char *unsettled_discrete(const lag_instance *instance)
{
    const lag_model *model = instance->fmu->model;
    return name_of(model->nw, model->discretes, lag_first(model->nw, instance->run->instants.iteration.discretes.guilty));
}

/* Name of the state that has placed a mass elsewhere, as a clause has set it, else of the first discrete that has changed. */
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
    return unsettled_discrete(instance);
}

/* The first assertion that does not hold where the run looked last. */
static const char *broken(const lag_instance *instance)
{
    const lag_model *model = instance->fmu->model;
    size_t i = 0;
    while (i < model->na && instance->run->conditions.held[i] != 0.0) {
        ++i;
    }
    return i < model->na ? model->assertions[i] : "an invariant left its tolerance";
}

/* Faults of nothing that has a name; null: the others. */
static const char *const PLAIN[] = {
    [LAG_NOT_FINITE] = "a value is infinite or not a number",
    [LAG_MISSING] = "a function is missing",
    [LAG_EVENT_PENDING] = "an event is left",
    [LAG_BAD_STATE_DATA] = "these bytes are no state of this FMU",
    [LAG_STEP_TOO_SMALL] = "steps became as short as the round-off of time",
    [LAG_PROJECTION_FAILED] = "the constraints cannot be reached from here",
    [LAG_ATTENTION] = "the constraints are about to lose rank",
    [LAG_BRANCH_POINT] = "branches of the motion meet, and the equations do not determine the branch",
    [LAG_POSITION_JUMP] = "a constraint becomes active, but the current position violates it",
    [LAG_BAD_CLOCK] = "a clock has no positive period, or no first instant",
    [LAG_BAD_DELAY] = "a delay is not positive",
    [LAG_LONG_PAST] = "the past of a delayed value has too many events",
    [LAG_TOO_LONG] = "this takes too many steps",
};

/* A sentence about a fault, and in its middle the name of what is to blame. */
typedef struct words {
    const char *before, *name, *after;
} words;

/* The rows of friction, into `rows`. */
static const char *wedging(const lag_model *model, char *rows, size_t size)
{
    size_t length = 0;
    for (size_t k = 0; k < model->nslip && length < size; ++k) {
        const char *name = name_of(model->nc, model->constraints, model->friction_rows[k]);
        length += (size_t)snprintf(rows + length, size - length, "%s%s", k > 0 ? ", " : "", name);
    }
    return rows;
}

static words words_of(const lag_instance *instance, lag_status status, char *rows)
{
    const lag_model *model = instance->fmu->model;
    const lag_run *run = instance->run;
    const size_t fault = run->instants.iteration.clauses.fault;
    const char *coordinate = name_of(model->nq, model->coordinates, run->motion.coordinate);
    switch (status) {
    case LAG_SINGULAR:
        return (words){"the acceleration of ", coordinate, " is not determined"};
    case LAG_MOMENTUM_UNREACHABLE:
        return (words){"no rate of ", coordinate, " has the momentum or the energy that the event leaves"};
    case LAG_VIOLATED:
        return (words){"", broken(instance), ""};
    case LAG_CHATTER:
        return (words){"events of ", unsettled_discrete(instance), " accumulate"};
    case LAG_EVENT_ITERATION_FAILED:
        return (words){"event iteration did not converge; still changing: ", unsettled_discrete(instance), ""};
    case LAG_CONFLICT:
        return (words){"two clauses reset ", fault < model->nreset ? model->resets[fault] : "a state", " to different values"};
    case LAG_ASSERTION_FAILED:
        return (words){"", fault < model->nfail ? model->failures[fault] : "an assertion failed", ""};
    case LAG_PENETRATION:
        return (words){"the gap of ", unsettled_discrete(instance), " is negative"};
    case LAG_WAY_JUMP:
        return (words){"the position of a mass would jump with ", displacing(instance), ""};
    case LAG_NO_FORCES:
        return (words){"no forces satisfy the law of friction of ", wedging(model, rows, LAG_MESSAGE), ": it wedges"};
    default:
        return (words){PLAIN[status], "", ""};
    }
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
    char rows[LAG_MESSAGE] = "";
    if (status == LAG_OK || status == LAG_STOPPED) {
        return status;
    }
    const words told = words_of(instance, status, rows);
    return lag_instance_fail(instance, status, "t = %.10g s: %s%s%s", instance->held.t, told.before, told.name, told.after);
}

lag_status lag_instance_give_up(lag_instance *instance)
{
    return lag_instance_judge(instance, LAG_TOO_LONG);
}
