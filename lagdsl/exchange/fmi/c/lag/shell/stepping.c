/* Co-simulation: communication steps. */
#include "lag/shell/shell.h"

#include <math.h>
#include <stddef.h>

/* Times of importers are sums of steps: they may be off by this part of a step, or of the time. */
static const double ROUND_OFF = 1e-6;
static const double ROUND_OFF_OF_TIME = 1e-12;

static int beyond(double t, double bound, double h)
{
    return t > bound + ROUND_OFF * h + ROUND_OFF_OF_TIME * fabs(bound);
}

static int acceptable(lag_shell *shell, double t, double h)
{
    const lag_course_of_calls *now = &shell->now;
    if (!lag_shell_is_time(shell, t, "the communication point") || !lag_shell_is_time(shell, t + h, "the end of the step")) {
        return 0;
    }
    if (!(h > 0.0)) {
        (void)lag_shell_say(shell, LAG_ANSWER_ERROR, "the step is %.17g s, and must be longer than zero", h);
    } else if (beyond(t, now->time, h) || beyond(now->time, t, h)) {
        (void)lag_shell_say(shell, LAG_ANSWER_ERROR, "the communication point %.17g s is not where the last step ended, at %.17g s", t, now->time);
    } else if (beyond(t + h, now->stop, h)) {
        (void)lag_shell_say(shell, LAG_ANSWER_ERROR, "the step ends at %.17g s, after the stop time %.17g s", t + h, now->stop);
    } else if (!(t + h > now->time)) {
        (void)lag_shell_say(shell, LAG_ANSWER_ERROR, "the step of %.17g s is lost in the round-off of the time %.17g s", h, t);
    } else if (now->due) {
        (void)lag_shell_say(shell, LAG_ANSWER_ERROR, "event mode must be entered first: the last step said so");
    } else {
        return 1;
    }
    return 0;
}

/* True if the importer lets the step continue from here; `early`: the step may end here. */
static int may_continue(lag_shell *shell, lag_between *between, int early, double *until)
{
    const char *call = shell->call;
    shell->now.mode = LAG_MODE_INTERMEDIATE;
    const int on = between(shell, shell->now.time, early, until);
    if (shell->now.mode == LAG_MODE_INTERMEDIATE) {
        shell->now.mode = LAG_MODE_STEP;
    }
    shell->call = call;
    return (on || !early) && shell->now.mode == LAG_MODE_STEP;
}

static lag_status proceed(lag_shell *shell, double end, lag_between *between, lag_progress *told)
{
    const int stops = (shell->now.event_mode && shell->now.early_return ? LAG_STOP_EVENTS : 0) | (between != NULL ? LAG_STOP_STEPS : 0);
    double until = end;
    for (double k = 0.0; k < LAG_MOST_STEPS; k += 1.0) {
        const lag_status status = lag_instance_step(shell->instance, until - shell->now.reached, stops, told);
        const int there = !told->early && !told->event && !told->terminate;
        shell->now.reached = told->t;
        shell->now.time = told->t = status == LAG_OK && there ? until : told->t;
        told->early = status == LAG_OK && shell->now.early_return && told->t < end;
        if (status != LAG_OK || told->event || told->terminate || between == NULL) {
            return status;
        }
        if (!may_continue(shell, between, told->early, &until) || !(until > shell->now.time)) {
            return LAG_OK;
        }
        until = fmin(until, end);
    }
    return lag_instance_judge(shell->instance, LAG_TOO_LONG);
}

lag_answer lag_shell_step(lag_shell *shell, double t, double h, lag_between *between, lag_progress *told)
{
    *told = (lag_progress){.t = shell->now.time};
    if (!acceptable(shell, t, h)) {
        return LAG_ANSWER_ERROR;
    }
    if (shell->now.ended) {
        told->terminate = 1;
        told->early = shell->now.early_return != 0;
        return LAG_ANSWER_OK;
    }
    const lag_status status = proceed(shell, t + h, between, told);
    lag_shell_warn(shell);
    if (status != LAG_OK) {
        const lag_answer answer = lag_shell_judge(shell, status);
        shell->now.mode = answer == LAG_ANSWER_DISCARD ? LAG_MODE_STEP_FAILED : LAG_MODE_FAILED;
        return answer;
    }
    if (shell->now.mode != LAG_MODE_STEP) {
        return LAG_ANSWER_ERROR; /* an evaluation in a callback failed, and that was told */
    }
    shell->now.due = told->event != 0;
    if (told->terminate) {
        shell->now.ended = 1;
        lag_shell_note(shell, "the model ends the simulation at %.17g s", told->t);
    }
    return LAG_ANSWER_OK;
}
