/*
 * FMI 3.0: clocks. They are periodic clocks based on time (FMI 3.0, section 2.2.10): importers that know them set them in event mode. The model
 * ticks by itself at the same instants, also for importers that know no clocks.
 */
#include "lag/fmi3/fmi3.h"

#include "lag/events/clock.h"

/* Period of a clock, and its first tick from time t on. */
static fmi3Status lag_find_tick(lag_shell *shell, fmi3ValueReference reference, double t, double *period, double *tick)
{
    const lag_status status = lag_instance_clock(shell->instance, shell->fmu->variables[reference].first, t, period, tick);
    return (fmi3Status)lag_shell_refused(shell, status);
}

fmi3Status fmi3GetClock(fmi3Instance instance, const fmi3ValueReference valueReferences[], size_t nValueReferences, fmi3Clock values[])
{
    LAG_ENTER("GetClock", LAG_MODES_ALL)
    if (!lag_shell_clocks(shell, valueReferences, nValueReferences, values)) {
        return fmi3Error;
    }
    for (size_t i = 0; i < nValueReferences; ++i) {
        values[i] = fmi3ClockInactive; /* what importers activate is over when the call ends */
    }
    return fmi3OK;
}

fmi3Status fmi3SetClock(fmi3Instance instance, const fmi3ValueReference valueReferences[], size_t nValueReferences, const fmi3Clock values[])
{
    LAG_ENTER("SetClock", LAG_MODE_EVENT)
    if (!lag_shell_clocks(shell, valueReferences, nValueReferences, values)) {
        return fmi3Error;
    }
    const double t = shell->now.reached;
    fmi3Status answer = fmi3OK;
    for (size_t i = 0; i < nValueReferences && answer == fmi3OK; ++i) {
        double period = 0.0;
        double tick = t;
        answer = values[i] ? lag_find_tick(shell, valueReferences[i], t, &period, &tick) : fmi3OK;
        if (answer == fmi3OK && tick > t + LAG_SAME_TICK * period) {
            (void)lag_shell_say(shell, LAG_ANSWER_ERROR, "the clock does not tick at %.10g s, but at %.10g s", t, tick);
            answer = fmi3Error;
        }
    }
    return answer;
}

fmi3Status fmi3GetIntervalDecimal(fmi3Instance instance, const fmi3ValueReference valueReferences[], size_t nValueReferences,
    fmi3Float64 intervals[], fmi3IntervalQualifier qualifiers[])
{
    LAG_ENTER("GetIntervalDecimal", LAG_MODE_INITIALIZATION | LAG_MODE_EVENT)
    if (!lag_shell_clocks(shell, valueReferences, nValueReferences, intervals) ||
        lag_shell_lacks(shell, nValueReferences > 0 && qualifiers == NULL, "the array of qualifiers")) {
        return fmi3Error;
    }
    const int settled = shell->now.mode != LAG_MODE_INITIALIZATION;
    fmi3Status answer = fmi3OK;
    for (size_t i = 0; i < nValueReferences && answer == fmi3OK; ++i) {
        double tick = 0.0;
        const int constant = shell->fmu->variables[valueReferences[i]].setting == LAG_SET_NEVER;
        answer = lag_find_tick(shell, valueReferences[i], shell->now.start, &intervals[i], &tick);
        qualifiers[i] = settled || constant ? fmi3IntervalUnchanged : fmi3IntervalChanged;
    }
    return answer;
}

fmi3Status fmi3GetShiftDecimal(fmi3Instance instance, const fmi3ValueReference valueReferences[], size_t nValueReferences, fmi3Float64 shifts[])
{
    LAG_ENTER("GetShiftDecimal", LAG_MODE_INITIALIZATION | LAG_MODE_EVENT)
    if (!lag_shell_clocks(shell, valueReferences, nValueReferences, shifts)) {
        return fmi3Error;
    }
    fmi3Status answer = fmi3OK;
    for (size_t i = 0; i < nValueReferences && answer == fmi3OK; ++i) {
        double period = 0.0;
        double tick = shell->now.start;
        answer = lag_find_tick(shell, valueReferences[i], shell->now.start, &period, &tick);
        shifts[i] = tick > shell->now.start ? tick - shell->now.start : 0.0; /* round-off may lie before the start */
    }
    return answer;
}
