/* From the experiment over initialization and events to the end. */
#include "lag/shell/shell.h"

#include <math.h>
#include <stddef.h>

/* Times beyond this are no simulation: neighbouring numbers are 0.1 ms apart. */
static const double LATEST = 1e12;

int lag_shell_is_time(lag_shell *shell, double t, const char *what)
{
    if (!isfinite(t)) {
        (void)lag_shell_say(shell, LAG_ANSWER_ERROR, "%s is infinite or not a number", what);
    } else if (fabs(t) > LATEST) {
        (void)lag_shell_say(shell, LAG_ANSWER_ERROR, "%s is %g s: beyond %g s round-off of time is too large", what, t, LATEST);
    }
    return fabs(t) <= LATEST;
}

lag_answer lag_shell_set_experiment(lag_shell *shell, int tolerance_defined, double tolerance, double start, int stop_defined, double stop)
{
    if (!lag_shell_is_time(shell, start, "the start time")) {
        return LAG_ANSWER_ERROR;
    }
    if (stop_defined && !(stop > start)) {
        return lag_shell_say(shell, LAG_ANSWER_ERROR, "the stop time %.17g is not after the start time %.17g", stop, start);
    }
    if (tolerance_defined && !(tolerance > 0.0 && isfinite(tolerance))) {
        return lag_shell_say(shell, LAG_ANSWER_ERROR, "the tolerance %.17g is not a positive number", tolerance);
    }
    shell->now.time = shell->now.reached = shell->now.start = start;
    shell->now.stop = stop_defined ? stop : (double)INFINITY;
    shell->now.tolerance = tolerance_defined ? tolerance : 0.0;
    return LAG_ANSWER_OK;
}

lag_answer lag_shell_enter_initialization(lag_shell *shell)
{
    const lag_course_of_calls *now = &shell->now;
    lag_instance_setup(shell->instance, (lag_kinds)now->kind, now->start, now->stop, now->tolerance);
    shell->now.mode = LAG_MODE_INITIALIZATION;
    return LAG_ANSWER_OK;
}

lag_answer lag_shell_exit_initialization(lag_shell *shell)
{
    const lag_answer answer = lag_shell_initialized(shell);
    if (answer != LAG_ANSWER_OK) {
        shell->now.mode = LAG_MODE_FAILED;
        return answer;
    }
    const lag_status status = lag_instance_begin(shell->instance);
    lag_shell_warn(shell);
    if (status != LAG_OK) {
        return lag_shell_failed(shell, status);
    }
    shell->now.mode = LAG_MODE_EVENT;
    shell->now.pending = 1;
    if (shell->now.kind != LAG_CO_SIMULATION || shell->now.event_mode) {
        return LAG_ANSWER_OK;
    }
    lag_update told;
    const lag_answer updated = lag_shell_update(shell, &told); /* what happens at the start */
    return updated == LAG_ANSWER_OK ? lag_shell_leave_events(shell, LAG_MODE_STEP) : updated;
}

lag_answer lag_shell_enter_events(lag_shell *shell)
{
    if (shell->now.kind == LAG_CO_SIMULATION && !shell->now.event_mode) {
        return lag_shell_say(shell, LAG_ANSWER_ERROR, "the instance was made without event mode");
    }
    if (shell->now.mode != LAG_MODE_EVENT) {
        lag_shell_note(shell, "event at %.17g s", shell->now.time);
    }
    shell->now.mode = LAG_MODE_EVENT;
    shell->now.pending = 1;
    shell->now.due = 0;
    return LAG_ANSWER_OK;
}

lag_answer lag_shell_update(lag_shell *shell, lag_update *told)
{
    *told = (lag_update){.next = (double)INFINITY};
    const lag_status status = lag_instance_update(shell->instance, told);
    lag_shell_warn(shell);
    if (status != LAG_OK) {
        return lag_shell_failed(shell, status);
    }
    shell->now.pending = 0;
    if (told->terminate) {
        shell->now.ended = 1;
        lag_shell_note(shell, "the model ends the simulation: %s", lag_instance_message(shell->instance));
    }
    return LAG_ANSWER_OK;
}

lag_answer lag_shell_leave_events(lag_shell *shell, lag_mode mode)
{
    if (mode != (shell->now.kind == LAG_CO_SIMULATION ? LAG_MODE_STEP : LAG_MODE_CONTINUOUS)) {
        return lag_shell_say(shell, LAG_ANSWER_ERROR, "there is no such mode in %s",
            shell->now.kind == LAG_CO_SIMULATION ? "co-simulation" : "model exchange");
    }
    if (shell->now.pending) {
        return lag_shell_say(shell, LAG_ANSWER_ERROR, "discrete states must be updated first, until they need no further update");
    }
    shell->now.mode = (uint32_t)mode;
    return LAG_ANSWER_OK;
}

lag_answer lag_shell_terminate(lag_shell *shell)
{
    const lag_status status = shell->now.mode == LAG_MODE_STEP_FAILED ? LAG_OK : lag_instance_terminate(shell->instance);
    if (status != LAG_OK) {
        return lag_shell_failed(shell, status);
    }
    shell->now.mode = LAG_MODE_TERMINATED;
    return LAG_ANSWER_OK;
}
