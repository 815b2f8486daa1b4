/* FMI 3.0 for model exchange. */
#include "lag/fmi3/fmi3.h"

#define EXCHANGE (LAG_MODE_EVENT | LAG_MODE_CONTINUOUS)
#define EVALUABLE (EXCHANGE | LAG_MODE_INITIALIZATION | LAG_MODE_TERMINATED | LAG_MODE_FAILED)

fmi3Status fmi3EnterContinuousTimeMode(fmi3Instance instance)
{
    LAG_ENTER_EXCHANGE("EnterContinuousTimeMode", LAG_MODE_EVENT)
    return (fmi3Status)lag_shell_leave_events(shell, LAG_MODE_CONTINUOUS);
}

fmi3Status fmi3CompletedIntegratorStep(
    fmi3Instance instance, fmi3Boolean noSetFMUStatePriorToCurrentPoint, fmi3Boolean *enterEventMode, fmi3Boolean *terminateSimulation)
{
    LAG_ENTER_EXCHANGE("CompletedIntegratorStep", LAG_MODE_CONTINUOUS)
    (void)noSetFMUStatePriorToCurrentPoint;
    LAG_NEEDS(enterEventMode, "enterEventMode")
    LAG_NEEDS(terminateSimulation, "terminateSimulation")
    int events, terminate;
    const lag_answer answer = lag_shell_completed(shell, &events, &terminate);
    *enterEventMode = events != 0;
    *terminateSimulation = terminate != 0;
    return (fmi3Status)answer;
}

fmi3Status fmi3SetTime(fmi3Instance instance, fmi3Float64 time)
{
    LAG_ENTER_EXCHANGE("SetTime", EXCHANGE)
    return (fmi3Status)lag_shell_set_time(shell, time);
}

fmi3Status fmi3SetContinuousStates(fmi3Instance instance, const fmi3Float64 continuousStates[], size_t nContinuousStates)
{
    LAG_ENTER_EXCHANGE("SetContinuousStates", LAG_MODE_CONTINUOUS)
    return (fmi3Status)lag_shell_set_states(shell, continuousStates, nContinuousStates);
}

fmi3Status fmi3GetContinuousStateDerivatives(fmi3Instance instance, fmi3Float64 derivatives[], size_t nContinuousStates)
{
    LAG_ENTER_EXCHANGE("GetContinuousStateDerivatives", EVALUABLE)
    return (fmi3Status)lag_shell_get_derivatives(shell, derivatives, nContinuousStates);
}

fmi3Status fmi3GetEventIndicators(fmi3Instance instance, fmi3Float64 eventIndicators[], size_t nEventIndicators)
{
    LAG_ENTER_EXCHANGE("GetEventIndicators", EVALUABLE)
    return (fmi3Status)lag_shell_get_indicators(shell, eventIndicators, nEventIndicators);
}

fmi3Status fmi3GetContinuousStates(fmi3Instance instance, fmi3Float64 continuousStates[], size_t nContinuousStates)
{
    LAG_ENTER_EXCHANGE("GetContinuousStates", EVALUABLE)
    return (fmi3Status)lag_shell_get_states(shell, continuousStates, nContinuousStates);
}

fmi3Status fmi3GetNominalsOfContinuousStates(fmi3Instance instance, fmi3Float64 nominals[], size_t nContinuousStates)
{
    LAG_ENTER_EXCHANGE("GetNominalsOfContinuousStates", EVALUABLE | LAG_MODE_INSTANTIATED)
    return (fmi3Status)lag_shell_get_nominals(shell, nominals, nContinuousStates);
}

fmi3Status fmi3GetNumberOfEventIndicators(fmi3Instance instance, size_t *nEventIndicators)
{
    LAG_ENTER_EXCHANGE("GetNumberOfEventIndicators", LAG_MODES_LASTING)
    LAG_NEEDS(nEventIndicators, "nEventIndicators")
    *nEventIndicators = lag_instance_indicator_count(shell->fmu);
    return fmi3OK;
}

fmi3Status fmi3GetNumberOfContinuousStates(fmi3Instance instance, size_t *nContinuousStates)
{
    LAG_ENTER_EXCHANGE("GetNumberOfContinuousStates", LAG_MODES_LASTING)
    LAG_NEEDS(nContinuousStates, "nContinuousStates")
    *nContinuousStates = lag_shell_order(shell);
    return fmi3OK;
}
