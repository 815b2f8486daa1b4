/*
 * FMI 3.0: clocks. They are periodic clocks based on time (FMI 3.0, section 2.2.10): importers that know them set them in event mode. The model
 * ticks by itself at the same instants, also for importers that know no clocks.
 */
#include "lag/fmi3/fmi3.h"

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
    for (size_t i = 0; i < nValueReferences; ++i) {
        const size_t which = shell->fmu->variables[valueReferences[i]].first;
        const lag_status status = values[i] ? lag_instance_tick(shell->instance, which) : LAG_OK;
        if (status != LAG_OK) {
            return (fmi3Status)lag_shell_refused(shell, status);
        }
    }
    return fmi3OK;
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
    for (size_t i = 0; i < nValueReferences; ++i) {
        double shift = 0.0;
        const lag_status status =
            lag_instance_clock(shell->instance, shell->fmu->variables[valueReferences[i]].first, &intervals[i], &shift);
        if (status != LAG_OK) {
            return (fmi3Status)lag_shell_refused(shell, status);
        }
        const int constant = shell->fmu->variables[valueReferences[i]].setting == LAG_SET_NEVER;
        qualifiers[i] = settled || constant ? fmi3IntervalUnchanged : fmi3IntervalChanged;
    }
    return fmi3OK;
}

fmi3Status fmi3GetShiftDecimal(fmi3Instance instance, const fmi3ValueReference valueReferences[], size_t nValueReferences, fmi3Float64 shifts[])
{
    LAG_ENTER("GetShiftDecimal", LAG_MODE_INITIALIZATION | LAG_MODE_EVENT)
    if (!lag_shell_clocks(shell, valueReferences, nValueReferences, shifts)) {
        return fmi3Error;
    }
    for (size_t i = 0; i < nValueReferences; ++i) {
        double period = 0.0;
        const lag_status status =
            lag_instance_clock(shell->instance, shell->fmu->variables[valueReferences[i]].first, &period, &shifts[i]);
        if (status != LAG_OK) {
            return (fmi3Status)lag_shell_refused(shell, status);
        }
    }
    return fmi3OK;
}
