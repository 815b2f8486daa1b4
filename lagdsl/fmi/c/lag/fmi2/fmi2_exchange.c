/* FMI 2.0 for model exchange. */
#include "lag/fmi2/fmi2.h"

#include <math.h>

#define EXCHANGE (LAG_MODE_EVENT | LAG_MODE_CONTINUOUS)
#define EVALUABLE (EXCHANGE | LAG_MODE_INITIALIZATION | LAG_MODE_TERMINATED | LAG_MODE_FAILED)

fmi2Status fmi2EnterEventMode(fmi2Component c)
{
    LAG_ENTER_EXCHANGE("EnterEventMode", EXCHANGE)
    return (fmi2Status)lag_shell_enter_events(shell);
}

fmi2Status fmi2NewDiscreteStates(fmi2Component c, fmi2EventInfo *eventInfo)
{
    LAG_ENTER_EXCHANGE("NewDiscreteStates", LAG_MODE_EVENT)
    LAG_NEEDS(eventInfo, "the event info")
    lag_update told;
    const lag_answer answer = lag_shell_update(shell, &told);
    if (answer == LAG_ANSWER_OK) {
        *eventInfo = (fmi2EventInfo){
            .newDiscreteStatesNeeded = told.again != 0,
            .terminateSimulation = told.terminate != 0,
            .nominalsOfContinuousStatesChanged = told.nominals_changed != 0,
            .valuesOfContinuousStatesChanged = told.states_changed != 0,
            .nextEventTimeDefined = isfinite(told.next) != 0,
            .nextEventTime = isfinite(told.next) ? told.next : 0.0,
        };
    }
    return (fmi2Status)answer;
}

fmi2Status fmi2EnterContinuousTimeMode(fmi2Component c)
{
    LAG_ENTER_EXCHANGE("EnterContinuousTimeMode", LAG_MODE_EVENT)
    return (fmi2Status)lag_shell_leave_events(shell, LAG_MODE_CONTINUOUS);
}

fmi2Status fmi2CompletedIntegratorStep(
    fmi2Component c, fmi2Boolean noSetFMUStatePriorToCurrentPoint, fmi2Boolean *enterEventMode, fmi2Boolean *terminateSimulation)
{
    LAG_ENTER_EXCHANGE("CompletedIntegratorStep", LAG_MODE_CONTINUOUS)
    (void)noSetFMUStatePriorToCurrentPoint;
    LAG_NEEDS(enterEventMode, "enterEventMode")
    LAG_NEEDS(terminateSimulation, "terminateSimulation")
    int events, terminate;
    const lag_answer answer = lag_shell_completed(shell, &events, &terminate);
    *enterEventMode = events ? fmi2True : fmi2False;
    *terminateSimulation = terminate ? fmi2True : fmi2False;
    return (fmi2Status)answer;
}

fmi2Status fmi2SetTime(fmi2Component c, fmi2Real time)
{
    LAG_ENTER_EXCHANGE("SetTime", EXCHANGE)
    return (fmi2Status)lag_shell_set_time(shell, time);
}

fmi2Status fmi2SetContinuousStates(fmi2Component c, const fmi2Real x[], size_t nx)
{
    LAG_ENTER_EXCHANGE("SetContinuousStates", LAG_MODE_CONTINUOUS)
    return (fmi2Status)lag_shell_set_states(shell, x, nx);
}

fmi2Status fmi2GetDerivatives(fmi2Component c, fmi2Real derivatives[], size_t nx)
{
    LAG_ENTER_EXCHANGE("GetDerivatives", EVALUABLE)
    return (fmi2Status)lag_shell_get_derivatives(shell, derivatives, nx);
}

fmi2Status fmi2GetEventIndicators(fmi2Component c, fmi2Real eventIndicators[], size_t ni)
{
    LAG_ENTER_EXCHANGE("GetEventIndicators", EVALUABLE)
    return (fmi2Status)lag_shell_get_indicators(shell, eventIndicators, ni);
}

fmi2Status fmi2GetContinuousStates(fmi2Component c, fmi2Real x[], size_t nx)
{
    LAG_ENTER_EXCHANGE("GetContinuousStates", EVALUABLE)
    return (fmi2Status)lag_shell_get_states(shell, x, nx);
}

fmi2Status fmi2GetNominalsOfContinuousStates(fmi2Component c, fmi2Real x_nominal[], size_t nx)
{
    LAG_ENTER_EXCHANGE("GetNominalsOfContinuousStates", EVALUABLE | LAG_MODE_INSTANTIATED)
    return (fmi2Status)lag_shell_get_nominals(shell, x_nominal, nx);
}
