/* FMI 2.0 for model exchange. */
#include "lag/fmi2/fmi2.h"

#include <math.h>

#include "lag/shell/exchange_functions.h"

fmi2Status fmi2EnterEventMode(fmi2Component instance)
{
    LAG_ENTER_EXCHANGE("EnterEventMode", EXCHANGE)
    return (fmi2Status)lag_shell_enter_events(shell);
}

fmi2Status fmi2NewDiscreteStates(fmi2Component instance, fmi2EventInfo *eventInfo)
{
    LAG_ENTER_EXCHANGE("NewDiscreteStates", LAG_MODE_EVENT)
    LAG_NEEDS(eventInfo, "the event info")
    lag_update told;
    const lag_answer answer = lag_shell_update(shell, &told);
    if (answer == LAG_ANSWER_OK) {
        *eventInfo = (fmi2EventInfo){
            .newDiscreteStatesNeeded = fmi2False,
            .terminateSimulation = told.terminate != 0,
            .nominalsOfContinuousStatesChanged = fmi2False,
            .valuesOfContinuousStatesChanged = told.states_changed != 0,
            .nextEventTimeDefined = isfinite(told.next) != 0,
            .nextEventTime = isfinite(told.next) ? told.next : 0.0,
        };
    }
    return (fmi2Status)answer;
}

fmi2Status fmi2GetDerivatives(fmi2Component instance, fmi2Real derivatives[], size_t nx)
{
    LAG_ENTER_EXCHANGE("GetDerivatives", EVALUABLE)
    return (fmi2Status)lag_shell_get_vector(shell, LAG_ROLE_DERIVATIVE, derivatives, nx);
}
