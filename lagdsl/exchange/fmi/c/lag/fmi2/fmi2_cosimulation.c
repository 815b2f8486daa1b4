/* FMI 2.0 for co-simulation. */
#include "lag/fmi2/fmi2.h"

/* Its status is asked for after a step, be it discarded or the last one. */
#define ASKABLE (LAG_MODE_STEP | LAG_MODE_STEP_FAILED | LAG_MODE_TERMINATED | LAG_MODE_FAILED)

fmi2Status fmi2SetRealInputDerivatives(
    fmi2Component instance, const fmi2ValueReference vr[], size_t nvr, const fmi2Integer order[], const fmi2Real value[])
{
    LAG_ENTER_STEPS("SetRealInputDerivatives", LAG_MODE_INSTANTIATED | LAG_MODE_INITIALIZATION | LAG_MODE_STEP)
    return (fmi2Status)lag_shell_set_input_derivatives(shell, vr, nvr, order, value);
}

fmi2Status fmi2GetRealOutputDerivatives(
    fmi2Component instance, const fmi2ValueReference vr[], size_t nvr, const fmi2Integer order[], fmi2Real value[])
{
    LAG_ENTER_STEPS("GetRealOutputDerivatives", ASKABLE)
    return (fmi2Status)lag_shell_get_output_derivatives(shell, vr, nvr, order, value, nvr);
}

fmi2Status fmi2DoStep(fmi2Component instance, fmi2Real currentCommunicationPoint, fmi2Real communicationStepSize,
    fmi2Boolean noSetFMUStatePriorToCurrentPoint)
{
    LAG_ENTER_STEPS("DoStep", LAG_MODE_STEP)
    (void)noSetFMUStatePriorToCurrentPoint;
    lag_progress outcome;
    const lag_answer answer = lag_shell_step(shell, currentCommunicationPoint, communicationStepSize, NULL, &outcome);
    if (answer == LAG_ANSWER_OK && outcome.terminate) {
        shell->now.mode = LAG_MODE_STEP_FAILED;
        return (fmi2Status)lag_shell_say(shell, LAG_ANSWER_DISCARD, "the model has ended the simulation at %.17g s", outcome.t);
    }
    return (fmi2Status)answer;
}

fmi2Status fmi2CancelStep(fmi2Component instance)
{
    LAG_ENTER_STEPS("CancelStep", LAG_MODES_ALL)
    return (fmi2Status)lag_shell_say(shell, LAG_ANSWER_ERROR, "steps are not asynchronous: there is none to cancel");
}

/* Steps are never pending. */
static fmi2Status unknown(lag_shell *shell, const void *value)
{
    LAG_NEEDS(value, "the place for the status")
    return (fmi2Status)lag_shell_say(shell, LAG_ANSWER_DISCARD, "there is no such status: steps are not asynchronous");
}

fmi2Status fmi2GetRealStatus(fmi2Component instance, const fmi2StatusKind s, fmi2Real *value)
{
    LAG_ENTER_STEPS("GetRealStatus", ASKABLE)
    if (s != fmi2LastSuccessfulTime) {
        return unknown(shell, value);
    }
    LAG_NEEDS(value, "the place for the status")
    *value = shell->now.time;
    return fmi2OK;
}

fmi2Status fmi2GetBooleanStatus(fmi2Component instance, const fmi2StatusKind s, fmi2Boolean *value)
{
    LAG_ENTER_STEPS("GetBooleanStatus", ASKABLE)
    if (s != fmi2Terminated) {
        return unknown(shell, value);
    }
    LAG_NEEDS(value, "the place for the status")
    *value = shell->now.ended ? fmi2True : fmi2False;
    return fmi2OK;
}

#define LAG_NO_STATUS(NAME, TYPE)                                                          \
    fmi2Status fmi2##NAME(fmi2Component instance, const fmi2StatusKind s, TYPE *value) \
    {                                                                                      \
        LAG_ENTER_STEPS(#NAME, ASKABLE)                                                    \
        (void)s;                                                                           \
        return unknown(shell, value);                                                      \
    }

LAG_NO_STATUS(GetStatus, fmi2Status)
LAG_NO_STATUS(GetIntegerStatus, fmi2Integer)
LAG_NO_STATUS(GetStringStatus, fmi2String)
