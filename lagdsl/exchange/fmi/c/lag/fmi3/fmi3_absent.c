/* FMI 3.0: what these FMUs have none of: structural parameters that can be set, intervals of clocks that importers choose. */
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
static fmi3Status lag_settled(lag_shell *shell, size_t count)
{
    return count == 0 ? fmi3OK :
                        (fmi3Status)lag_shell_say(shell, LAG_ANSWER_ERROR,
                            "clocks tick at decimal intervals that the model determines: they cannot be set, and are no fractions");
}

#define LAG_SETTLED(NAME)                                                                                                     \
    fmi3Status fmi3##NAME(fmi3Instance instance, const fmi3ValueReference references[], size_t count, const fmi3Float64 a[]) \
    {                                                                                                                         \
        LAG_ENTER(#NAME, LAG_MODES_ALL)                                                                                       \
        (void)references;                                                                                                     \
        (void)a;                                                                                                              \
        return lag_settled(shell, count);                                                                                     \
    }

LAG_SETTLED(SetShiftDecimal)
LAG_SETTLED(SetIntervalDecimal)

#define LAG_NO_FRACTIONS(NAME, TYPE)                                                                                                \
    fmi3Status fmi3##NAME(fmi3Instance instance, const fmi3ValueReference references[], size_t count, TYPE counters[], TYPE parts[]) \
    {                                                                                                                               \
        LAG_ENTER(#NAME, LAG_MODES_ALL)                                                                                             \
        (void)references;                                                                                                           \
        (void)counters;                                                                                                             \
        (void)parts;                                                                                                                \
        return lag_settled(shell, count);                                                                                           \
    }

LAG_NO_FRACTIONS(GetShiftFraction, fmi3UInt64)
LAG_NO_FRACTIONS(SetIntervalFraction, const fmi3UInt64)
LAG_NO_FRACTIONS(SetShiftFraction, const fmi3UInt64)

fmi3Status fmi3GetIntervalFraction(fmi3Instance instance, const fmi3ValueReference valueReferences[], size_t nValueReferences,
    fmi3UInt64 counters[], fmi3UInt64 resolutions[], fmi3IntervalQualifier qualifiers[])
{
    LAG_ENTER("GetIntervalFraction", LAG_MODES_ALL)
    (void)valueReferences;
    (void)counters;
    (void)resolutions;
    (void)qualifiers;
    return lag_settled(shell, nValueReferences);
}
