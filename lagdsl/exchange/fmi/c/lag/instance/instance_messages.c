/* Messages of an instance about failures and the end of a simulation. */
#include "lag/instance/instance_internal.h"

#include <stdarg.h>
#include <stdio.h>

#include "lag/words.h"

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

/* Of this list of names what is to blame; `room` (LAG_MESSAGE) is for several. */
static const char *name_of(const lag_instance *instance, lag_status status, char *room)
{
    const lag_model *model = instance->fmu->model;
    lag_fault fault = {.which = 0};
    if (LAG_WORDS[status].blamed != LAG_BLAMED_NOTHING) {
        lag_run_explain(instance->run, status, &fault);
    }
    const size_t reset = fault.which - model->nw;
    switch (LAG_WORDS[status].blamed) {
    case LAG_BLAMED_COORDINATES:
        return fault.which < model->nq ? model->coordinates[fault.which].name : "the model";
    case LAG_BLAMED_ROWS:
        return fault.which < model->nc ? model->constraints[fault.which].name : "the model";
    case LAG_BLAMED_ENTRIES:
        return fault.which < model->nw ? model->discretes[fault.which].name : reset < model->nreset ? model->resets[reset] : "the model";
    case LAG_BLAMED_RESETS:
        return model->resets[fault.which];
    case LAG_BLAMED_CHECKS:
        return model->failures[fault.which];
    case LAG_BLAMED_CONDITIONS:
        return fault.which < model->na ? model->assertions[fault.which] : model->invariants[fault.which - model->na].name;
    case LAG_BLAMED_FRICTIONS:
        return frictions(model, room);
    case LAG_BLAMED_NOTHING:
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
    (void)snprintf(told, sizeof told, LAG_WORDS[status].words, name_of(instance, status, room));
    return lag_instance_fail(instance, status, "t = %.10g s: %s", instance->held.t, told);
}
