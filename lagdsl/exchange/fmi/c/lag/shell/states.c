/* Model exchange: time, states, derivatives, indicators. */
#include "lag/shell/shell.h"

#include <math.h>
#include <string.h>

/* True if an array of the importer has `expected` numbers. */
static int fits(lag_shell *shell, const double *values, size_t n, size_t expected, const char *what)
{
    if (n != expected) {
        (void)lag_shell_say(shell, LAG_ANSWER_ERROR, "room for %lu %s, where there are %lu", (unsigned long)n, what, (unsigned long)expected);
        return 0;
    }
    return !lag_shell_lacks(shell, n > 0 && values == NULL, what);
}

lag_answer lag_shell_set_time(lag_shell *shell, double time)
{
    if (!lag_shell_is_time(shell, time, "the time")) {
        return LAG_ANSWER_ERROR;
    }
    lag_instance_set_time(shell->instance, time);
    shell->now.time = shell->now.reached = time;
    return LAG_ANSWER_OK;
}

lag_answer lag_shell_set_states(lag_shell *shell, const double *x, size_t n)
{
    if (!fits(shell, x, n, shell->fmu->states.count, "states")) {
        return LAG_ANSWER_ERROR;
    }
    for (size_t i = 0; i < n; ++i) {
        if (!isfinite(x[i])) {
            return lag_shell_say(shell, LAG_ANSWER_ERROR, "state %lu is infinite or not a number", (unsigned long)(i + 1));
        }
    }
    lag_instance_set_states(shell->instance, x);
    return LAG_ANSWER_OK;
}

lag_answer lag_shell_get_vector(lag_shell *shell, lag_role role, double *values, size_t n)
{
    const lag_fmu *fmu = shell->fmu;
    const size_t expected = role == LAG_ROLE_INDICATOR ? fmu->indicators.count : fmu->states.count;
    const char *what = role == LAG_ROLE_INDICATOR ? "event indicators" : role == LAG_ROLE_STATE ? "states" : "derivatives";
    if (!fits(shell, values, n, expected, what)) {
        return LAG_ANSWER_ERROR;
    }
    const lag_answer answer = lag_shell_initialized(shell);
    return answer != LAG_ANSWER_OK || n == 0 ? answer : lag_shell_judge(shell, lag_instance_vector(shell->instance, role, values));
}

lag_answer lag_shell_get_nominals(lag_shell *shell, double *nominal, size_t n)
{
    if (!fits(shell, nominal, n, shell->fmu->states.count, "nominal values")) {
        return LAG_ANSWER_ERROR;
    }
    for (size_t i = 0; i < n; ++i) {
        nominal[i] = shell->fmu->nominal[shell->fmu->states.entries[i]];
    }
    return LAG_ANSWER_OK;
}

lag_answer lag_shell_completed(lag_shell *shell, int *events)
{
    const lag_status status = lag_instance_completed(shell->instance, events);
    lag_shell_warn(shell);
    return lag_shell_failed(shell, status);
}
