/* FMI 3.0 for co-simulation. */
#include "lag/fmi3/fmi3.h"

fmi3Status fmi3EnterStepMode(fmi3Instance instance)
{
    LAG_ENTER_STEPS("EnterStepMode", LAG_MODE_EVENT)
    return (fmi3Status)lag_shell_leave_events(shell, LAG_MODE_STEP);
}

fmi3Status fmi3GetOutputDerivatives(fmi3Instance instance, const fmi3ValueReference valueReferences[], size_t nValueReferences,
    const fmi3Int32 orders[], fmi3Float64 values[], size_t nValues)
{
    LAG_ENTER_STEPS("GetOutputDerivatives",
        LAG_MODE_STEP | LAG_MODE_INTERMEDIATE | LAG_MODE_STEP_FAILED | LAG_MODE_TERMINATED | LAG_MODE_FAILED)
    return (fmi3Status)lag_shell_get_output_derivatives(shell, valueReferences, nValueReferences, orders, values, nValues);
}

/* Every accepted step inside is told; inputs are not asked for there. */
static int between(lag_shell *shell, double t, int may_return, double *until)
{
    const fmi3IntermediateUpdateCallback update = (fmi3IntermediateUpdateCallback)shell->host.update;
    fmi3Boolean wanted = fmi3False;
    fmi3Float64 time = t;
    update(shell->host.environment, t, fmi3False, fmi3True, fmi3True, may_return != 0, &wanted, &time);
    if (!wanted || !may_return) {
        return 1;
    }
    *until = time < *until ? time : *until;
    return time > t;
}

fmi3Status fmi3DoStep(fmi3Instance instance, fmi3Float64 currentCommunicationPoint, fmi3Float64 communicationStepSize,
    fmi3Boolean noSetFMUStatePriorToCurrentPoint, fmi3Boolean *eventHandlingNeeded, fmi3Boolean *terminateSimulation,
    fmi3Boolean *earlyReturn, fmi3Float64 *lastSuccessfulTime)
{
    LAG_ENTER_STEPS("DoStep", LAG_MODE_STEP)
    (void)noSetFMUStatePriorToCurrentPoint;
    LAG_NEEDS(eventHandlingNeeded, "eventHandlingNeeded")
    LAG_NEEDS(terminateSimulation, "terminateSimulation")
    LAG_NEEDS(earlyReturn, "earlyReturn")
    LAG_NEEDS(lastSuccessfulTime, "lastSuccessfulTime")
    lag_progress outcome;
    const lag_answer answer =
        lag_shell_step(shell, currentCommunicationPoint, communicationStepSize, shell->host.update != NULL ? between : NULL, &outcome);
    *eventHandlingNeeded = outcome.event != 0;
    *terminateSimulation = outcome.terminate != 0;
    *earlyReturn = outcome.early != 0;
    *lastSuccessfulTime = outcome.t;
    return (fmi3Status)answer;
}

fmi3Status fmi3ActivateModelPartition(fmi3Instance instance, fmi3ValueReference clockReference, fmi3Float64 activationTime)
{
    LAG_ENTER("ActivateModelPartition", LAG_MODES_ALL)
    (void)clockReference;
    (void)activationTime;
    return (fmi3Status)lag_shell_say(shell, LAG_ANSWER_ERROR, "there is no scheduled execution");
}
