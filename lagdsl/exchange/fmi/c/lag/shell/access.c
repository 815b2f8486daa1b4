/* Values of variables by their references, with every check before the first value moves. */
#include "lag/shell/shell.h"

#include <math.h>

static const char *type_name(lag_type type)
{
    static const char *const names[] = {"a real number", "an integer", "a Boolean", "a text", "an enumeration", "a clock"};
    return names[type];
}

const lag_variable *lag_shell_variable(lag_shell *shell, uint32_t reference)
{
    if (reference >= shell->fmu->nvariable) {
        (void)lag_shell_say(shell, LAG_ANSWER_ERROR, "there is no variable with value reference %lu", (unsigned long)reference);
        return NULL;
    }
    return &shell->fmu->variables[reference];
}

int lag_shell_count(lag_shell *shell, lag_type type, const uint32_t *references, size_t n, size_t *count)
{
    *count = 0;
    if (lag_shell_lacks(shell, n > 0 && references == NULL, "the array of value references")) {
        return 0;
    }
    for (size_t i = 0; i < n; ++i) {
        const lag_variable *variable = lag_shell_variable(shell, references[i]);
        if (variable == NULL) {
            return 0;
        }
        if (variable->type != (unsigned char)type) {
            (void)lag_shell_say(shell, LAG_ANSWER_ERROR, "%s is %s, not %s", variable->name, type_name((lag_type)variable->type),
                type_name(type));
            return 0;
        }
        *count += variable->count;
    }
    return 1;
}

int lag_shell_consistent(lag_shell *shell, lag_type type, const uint32_t *references, size_t n, const void *values, size_t count)
{
    size_t total = 0;
    if (!lag_shell_count(shell, type, references, n, &total) || lag_shell_lacks(shell, count > 0 && values == NULL, "the array of values")) {
        return 0;
    }
    if (total != count) {
        (void)lag_shell_say(shell, LAG_ANSWER_ERROR, "room for %lu values, where these variables have %lu", (unsigned long)count,
            (unsigned long)total);
        return 0;
    }
    return 1;
}

int lag_shell_clocks(lag_shell *shell, const uint32_t *references, size_t n, const void *values)
{
    return lag_shell_consistent(shell, LAG_TYPE_CLOCK, references, n, values, n);
}

int32_t lag_shell_integer(double value)
{
    return value > INT32_MAX ? INT32_MAX : value < INT32_MIN ? INT32_MIN : (int32_t)value;
}

/* True for roles whose values exist before initialization. */
static int plain(lag_role role)
{
    return role == LAG_ROLE_TIME || role == LAG_ROLE_PARAMETER || role == LAG_ROLE_CONSTANT || role == LAG_ROLE_INPUT || role == LAG_ROLE_OPTION;
}

lag_answer lag_shell_initialized(lag_shell *shell)
{
    return shell->now.mode != LAG_MODE_INITIALIZATION ? LAG_ANSWER_OK : lag_shell_refused(shell, lag_instance_ready(shell->instance));
}

static lag_answer ready(lag_shell *shell, uint32_t reference)
{
    const lag_variable *variable = &shell->fmu->variables[reference];
    const lag_role role = (lag_role)variable->role;
    if (shell->now.mode == LAG_MODE_INSTANTIATED && !plain(role) && role != LAG_ROLE_STATE && role != LAG_ROLE_DEPENDENT && role != LAG_ROLE_FREE) {
        return lag_shell_say(shell, LAG_ANSWER_ERROR, "the value of %s is known from initialization mode on", variable->name);
    }
    return plain(role) ? LAG_ANSWER_OK : lag_shell_initialized(shell);
}

lag_answer lag_shell_get(lag_shell *shell, lag_type type, const uint32_t *references, size_t n, void *values, size_t count, lag_store *store)
{
    if (!lag_shell_consistent(shell, type, references, n, values, count)) {
        return LAG_ANSWER_ERROR;
    }
    size_t place = 0;
    for (size_t i = 0; i < n; ++i) {
        lag_answer answer = ready(shell, references[i]);
        if (answer != LAG_ANSWER_OK) {
            return answer;
        }
        double *found = store == NULL ? (double *)values + place : shell->scratch;
        const lag_status status = lag_instance_get(shell->instance, references[i], found);
        answer = type == LAG_TYPE_REAL ? lag_shell_judge(shell, status) : lag_shell_refused(shell, status);
        if (answer != LAG_ANSWER_OK) {
            return answer;
        }
        const size_t width = shell->fmu->variables[references[i]].count;
        for (size_t k = 0; k < width && store != NULL; ++k) {
            store(values, place + k, found[k]);
        }
        place += width;
    }
    return LAG_ANSWER_OK;
}

/*
 * In model exchange more than the standards ask for: importers that look at a model as a function (CasADi) set states and tunable
 * parameters of instances that are long in continuous-time mode.
 */
static int settable(const lag_shell *shell, const lag_variable *variable)
{
    const int tunable = variable->setting == LAG_SET_TUNABLE || variable->setting == LAG_SET_ALWAYS;
    const int state = variable->role == LAG_ROLE_STATE && variable->setting != LAG_SET_NEVER;
    switch ((lag_mode)shell->now.mode) {
    case LAG_MODE_INSTANTIATED:
    case LAG_MODE_INITIALIZATION:
        return variable->setting != LAG_SET_NEVER;
    case LAG_MODE_EVENT:
        return tunable || (state && shell->now.kind == LAG_MODEL_EXCHANGE);
    case LAG_MODE_CONTINUOUS:
        return (tunable || state) && variable->type == LAG_TYPE_REAL;
    case LAG_MODE_STEP:
        return (variable->setting == LAG_SET_ALWAYS && variable->type == LAG_TYPE_REAL) || (tunable && !shell->now.event_mode);
    default:
        return 0;
    }
}

/* 1: these are the values that an input has, which importers set again and again; a value that is none is different. */
static int unchanged(lag_shell *shell, uint32_t reference, const void *values, size_t place, lag_fetch *fetch)
{
    const lag_variable *variable = &shell->fmu->variables[reference];
    if (variable->role != LAG_ROLE_INPUT || lag_instance_get(shell->instance, reference, shell->scratch) != LAG_OK) {
        return 0;
    }
    for (size_t k = 0; k < variable->count; ++k) {
        const double given = fetch != NULL ? fetch(values, place + k) : ((const double *)values)[place + k];
        if (!(shell->scratch[k] == given)) {
            return 0;
        }
    }
    return 1;
}

/*
 * True if an input keeps its value until the next event mode. Root functions of importers look beyond the next event, and set
 * inputs as they are there (FMPy): the equations must not change before it.
 */
static int waits(const lag_shell *shell, const lag_variable *variable)
{
    return shell->now.mode == LAG_MODE_CONTINUOUS && variable->role == LAG_ROLE_INPUT && variable->type != LAG_TYPE_REAL;
}

/* Told once. */
static lag_answer keep(lag_shell *shell, const lag_variable *variable)
{
    if (shell->kept) {
        return LAG_ANSWER_WARNING;
    }
    shell->kept = 1;
    return lag_shell_say(
        shell, LAG_ANSWER_WARNING, "%s keeps its value: it changes in event mode only, where it has to be set again", variable->name);
}

static lag_answer refuse(lag_shell *shell, const lag_variable *variable)
{
    const char *format = variable->setting == LAG_SET_NEVER  ? "%s cannot be set" :
                         variable->role == LAG_ROLE_INPUT ? "%s cannot change now: it is set at events" :
                                                               "%s cannot be set now";
    return lag_shell_say(shell, LAG_ANSWER_ERROR, format, variable->name);
}

/* 0, and told why: the value of entry `i` is infinite, no number, or beyond its range. */
static int within(lag_shell *shell, const lag_variable *variable, size_t i, double value)
{
    const lag_fmu *fmu = shell->fmu;
    const int is_input = variable->role == LAG_ROLE_INPUT;
    const lag_range *ranges = is_input ? fmu->inputs.range : variable->role == LAG_ROLE_PARAMETER || variable->role == LAG_ROLE_FREE ? fmu->parameter_range : NULL;
    const size_t entry = variable->first + i;
    if (!isfinite(value)) {
        (void)lag_shell_say(shell, LAG_ANSWER_ERROR, "the value for %s is infinite or not a number", variable->name);
    } else if (variable->role == LAG_ROLE_OPTION && value < 0.0) {
        (void)lag_shell_say(shell, LAG_ANSWER_ERROR, "the length of steps cannot be %g s", value);
    } else if (ranges != NULL && (value < ranges[entry].least || value > ranges[entry].most)) {
        const lag_slot *slots = is_input ? fmu->model->inputs : fmu->model->parameters;
        (void)lag_shell_say(shell, LAG_ANSWER_ERROR, "%s is from %g to %g, not %g", slots[entry].name, ranges[entry].least, ranges[entry].most, value);
    } else {
        return 1;
    }
    return 0;
}

static int acceptable(lag_shell *shell, const uint32_t *references, size_t n, const void *values, lag_fetch *fetch)
{
    size_t place = 0;
    for (size_t i = 0; i < n; ++i) {
        const lag_variable *variable = &shell->fmu->variables[references[i]];
        const int fine = settable(shell, variable) || waits(shell, variable) || unchanged(shell, references[i], values, place, fetch);
        if (!fine) {
            (void)refuse(shell, variable);
            return 0;
        }
        for (size_t k = 0; k < variable->count; ++k, ++place) {
            if (!within(shell, variable, k, fetch != NULL ? fetch(values, place) : ((const double *)values)[place])) {
                return 0;
            }
        }
    }
    return 1;
}

lag_answer lag_shell_set(
    lag_shell *shell, lag_type type, const uint32_t *references, size_t n, const void *values, size_t count, lag_fetch *fetch)
{
    if (!lag_shell_consistent(shell, type, references, n, values, count) || !acceptable(shell, references, n, values, fetch)) {
        return LAG_ANSWER_ERROR;
    }
    lag_answer answer = LAG_ANSWER_OK;
    size_t place = 0;
    for (size_t i = 0; i < n; ++i) {
        const lag_variable *variable = &shell->fmu->variables[references[i]];
        const size_t width = variable->count;
        if (waits(shell, variable)) {
            answer = unchanged(shell, references[i], values, place, fetch) ? answer : keep(shell, variable);
            place += width;
            continue;
        }
        const double *given = (const double *)values + (fetch == NULL ? place : 0);
        for (size_t k = 0; k < width && fetch != NULL; ++k) {
            shell->scratch[k] = fetch(values, place + k);
        }
        const lag_status status = lag_instance_set(shell->instance, references[i], fetch == NULL ? given : shell->scratch);
        if (status != LAG_OK) {
            return lag_shell_refused(shell, status);
        }
        place += width;
    }
    return answer;
}

lag_answer lag_shell_get_texts(lag_shell *shell, const uint32_t *references, size_t n, const char **values, size_t count)
{
    if (!lag_shell_consistent(shell, LAG_TYPE_STRING, references, n, values, count)) {
        return LAG_ANSWER_ERROR;
    }
    size_t place = 0;
    for (size_t i = 0; i < n; ++i) {
        const lag_variable *variable = &shell->fmu->variables[references[i]];
        for (size_t k = 0; k < variable->count; ++k) {
            values[place++] = shell->fmu->constants.texts[variable->first + k];
        }
    }
    return LAG_ANSWER_OK;
}

lag_answer lag_shell_none(lag_shell *shell, size_t n, const char *type)
{
    return n == 0 ? LAG_ANSWER_OK : lag_shell_say(shell, LAG_ANSWER_ERROR, "no variable of this FMU is of type %s", type);
}

lag_answer lag_shell_set_input_derivatives(lag_shell *shell, const uint32_t *references, size_t n, const int *orders, const double *values)
{
    if (!lag_shell_consistent(shell, LAG_TYPE_REAL, references, n, values, n) || lag_shell_lacks(shell, n > 0 && orders == NULL, "the array of orders")) {
        return LAG_ANSWER_ERROR;
    }
    for (size_t i = 0; i < n; ++i) {
        if (shell->fmu->variables[references[i]].role != LAG_ROLE_INPUT) {
            return lag_shell_say(shell, LAG_ANSWER_ERROR, "%s is not an input", shell->fmu->variables[references[i]].name);
        }
        if (orders[i] < 1 || !isfinite(values[i])) {
            return lag_shell_say(shell, LAG_ANSWER_ERROR, "derivatives of inputs are finite and their orders at least 1");
        }
    }
    for (size_t i = 0; i < n; ++i) {
        const lag_status status = lag_instance_set_input(shell->instance, references[i], orders[i], &values[i]);
        if (status != LAG_OK) {
            return lag_shell_refused(shell, status);
        }
    }
    return LAG_ANSWER_OK;
}
