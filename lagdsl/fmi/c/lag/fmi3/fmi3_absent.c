/* FMI 3.0: what these FMUs have none of: structural parameters that can be set, and clocks. */
#include "lag/fmi3/fmi3.h"

fmi3Status fmi3EnterConfigurationMode(fmi3Instance instance)
{
    LAG_ENTER("EnterConfigurationMode", LAG_MODES_ALL)
    return (fmi3Status)lag_shell_say(shell, LAG_ANSWER_ERROR, "there are no structural parameters to configure");
}

fmi3Status fmi3ExitConfigurationMode(fmi3Instance instance)
{
    LAG_ENTER("ExitConfigurationMode", LAG_MODES_ALL)
    return (fmi3Status)lag_shell_say(shell, LAG_ANSWER_ERROR, "there are no structural parameters to configure");
}

/* All of them take references first; without any there is nothing to do. */
#define LAG_NO_CLOCKS(NAME, ...)                                                                                     \
    fmi3Status fmi3##NAME(fmi3Instance instance, const fmi3ValueReference references[], size_t count, __VA_ARGS__) \
    {                                                                                                                \
        LAG_ENTER(#NAME, LAG_MODES_ALL)                                                                              \
        (void)references;                                                                                            \
        (void)a;                                                                                                     \
        return (fmi3Status)lag_shell_none(shell, count, "Clock");                                                    \
    }

LAG_NO_CLOCKS(GetClock, fmi3Clock a[])
LAG_NO_CLOCKS(SetClock, const fmi3Clock a[])
LAG_NO_CLOCKS(GetShiftDecimal, fmi3Float64 a[])
LAG_NO_CLOCKS(SetShiftDecimal, const fmi3Float64 a[])
LAG_NO_CLOCKS(SetIntervalDecimal, const fmi3Float64 a[])

#define LAG_NO_CLOCKS_OF_TWO(NAME, FIRST, SECOND)                                                                       \
    fmi3Status fmi3##NAME(fmi3Instance instance, const fmi3ValueReference references[], size_t count, FIRST a[], SECOND b[]) \
    {                                                                                                                   \
        LAG_ENTER(#NAME, LAG_MODES_ALL)                                                                                 \
        (void)references;                                                                                               \
        (void)a;                                                                                                        \
        (void)b;                                                                                                        \
        return (fmi3Status)lag_shell_none(shell, count, "Clock");                                                       \
    }

LAG_NO_CLOCKS_OF_TWO(GetIntervalDecimal, fmi3Float64, fmi3IntervalQualifier)
LAG_NO_CLOCKS_OF_TWO(GetShiftFraction, fmi3UInt64, fmi3UInt64)
LAG_NO_CLOCKS_OF_TWO(SetIntervalFraction, const fmi3UInt64, const fmi3UInt64)
LAG_NO_CLOCKS_OF_TWO(SetShiftFraction, const fmi3UInt64, const fmi3UInt64)

fmi3Status fmi3GetIntervalFraction(fmi3Instance instance, const fmi3ValueReference valueReferences[], size_t nValueReferences,
    fmi3UInt64 counters[], fmi3UInt64 resolutions[], fmi3IntervalQualifier qualifiers[])
{
    LAG_ENTER("GetIntervalFraction", LAG_MODES_ALL)
    (void)valueReferences;
    (void)counters;
    (void)resolutions;
    (void)qualifiers;
    return (fmi3Status)lag_shell_none(shell, nValueReferences, "Clock");
}
