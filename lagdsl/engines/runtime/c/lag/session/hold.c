#include "lag/hold.h"

#include <math.h>
#include <string.h>

#include "lag/linalg/vector.h"

void lag_hold_tell(void *context, double t, int before, double *u)
{
    const lag_hold *hold = context;
    memcpy(u, before ? hold->before : hold->u, hold->count * sizeof *u);
    if (hold->signals != NULL) {
        lag_signals_tell((void *)hold->signals, t, before, u); /* which reads them only */
    }
    if (hold->inputs != NULL) {
        hold->inputs(hold->context, t, before, u);
    }
}

/* Number of the times of jumps up to t. */
static size_t passed(const lag_hold *hold, double t)
{
    size_t low = 0;
    size_t high = hold->breaks;
    while (low < high) {
        const size_t middle = low + (high - low) / 2;
        if (hold->at[middle] <= t) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return low;
}

/* True if a signal may jump now and has not done so. */
static int breaks_here(const lag_hold *hold, size_t next)
{
    const double t = hold->run->stepper.t;
    return next > 0 && hold->at[next - 1] == t && t > hold->run->counts.begun && !(hold->jumped == t);
}

static lag_status jump(lag_hold *hold)
{
    const lag_status status = lag_run_jump(hold->run);
    if (hold->count > 0) {
        memcpy(hold->before, hold->u, hold->count * sizeof *hold->u);
    }
    hold->jumped = hold->run->stepper.t;
    return status;
}

lag_status lag_hold_jump(lag_hold *hold)
{
    const int changed = !lag_same(hold->count, hold->before, hold->u);
    return changed || breaks_here(hold, passed(hold, hold->run->stepper.t)) ? jump(hold) : LAG_OK;
}

/* The end of a step, as a row where one is wanted. */
static lag_status end(lag_hold *hold)
{
    lag_run *run = hold->run;
    return hold->rows && run->options.results != NULL ? lag_results_at(run->options.results, run, run->stepper.t, run->stepper.x) : LAG_OK;
}

lag_status lag_hold_go(lag_hold *hold, size_t most_steps)
{
    lag_run *run = hold->run;
    size_t steps = 0;
    while (run->stepper.t < hold->goal) {
        const size_t next = passed(hold, run->stepper.t);
        const double stop = next < hold->breaks ? fmin(hold->at[next], hold->goal) : hold->goal;
        lag_status status = most_steps > 0 && steps >= most_steps ? LAG_TOO_LONG : lag_hold_jump(hold);
        if (status == LAG_OK) {
            status = lag_run_to(run, stop, most_steps > 0 ? most_steps - steps : 0);
            steps += run->counts.steps;
        }
        if (status != LAG_OK) {
            return status;
        }
    }
    return end(hold);
}

lag_status lag_hold_to(lag_hold *hold, double t, size_t most_steps)
{
    lag_results *results = hold->run->options.results;
    if (!hold->rows && results != NULL) {
        results->row = results->note = 0;
    }
    hold->goal = lag_instants_same(&hold->run->instants, t);
    return lag_hold_go(hold, most_steps);
}

lag_status lag_hold_step(lag_hold *hold, double h, size_t most_steps)
{
    return lag_hold_to(hold, lag_run_end_of_step(hold->run, h), most_steps);
}

/* ---- many ---- */

void lag_holds_step(lag_hold *const *holds, size_t count, double h, size_t most_steps, int *status)
{
    for (size_t i = 0; i < count; ++i) {
        status[i] = status[i] == LAG_OK ? (int)lag_hold_step(holds[i], h, most_steps) : status[i];
    }
}

void lag_holds_to(lag_hold *const *holds, size_t count, double t, size_t most_steps, int *status)
{
    for (size_t i = 0; i < count; ++i) {
        status[i] = status[i] == LAG_OK ? (int)lag_hold_to(holds[i], t, most_steps) : status[i];
    }
}

void lag_holds_go(lag_hold *const *holds, size_t count, size_t most_steps, int *status)
{
    for (size_t i = 0; i < count; ++i) {
        status[i] = status[i] == LAG_TOO_LONG ? (int)lag_hold_go(holds[i], most_steps) : status[i];
    }
}

void lag_holds_state(const lag_hold *const *holds, size_t count, double *states)
{
    for (size_t i = 0; i < count; ++i) {
        const lag_stepper *s = &holds[i]->run->stepper;
        double *state = states + i * (1 + s->ode->size);
        state[0] = s->t;
        memcpy(state + 1, s->x, s->ode->size * sizeof(double));
    }
}

void lag_holds_row(lag_hold *const *holds, size_t count, double *rows)
{
    for (size_t i = 0; i < count; ++i) {
        lag_run *run = holds[i]->run;
        const lag_results *told = run->options.results;
        lag_results one = {.most_rows = 1, .most_notes = 1, .rows = rows + i * lag_results_width(run->motion.model)};
        one.any = told != NULL && told->any;
        one.after = told != NULL ? told->after : (double)NAN;
        (void)lag_results_row(&one, run, run->stepper.t, run->stepper.x);
    }
}
