/* FMI 3.0: instances, the order of their modes, states. */
#include "lag/fmi3/fmi3.h"

#include <math.h>

const char *fmi3GetVersion(void)
{
    return fmi3Version;
}

static void log_message(const lag_shell *shell, lag_answer answer, const char *category, const char *message)
{
    const fmi3LogMessageCallback logger = (fmi3LogMessageCallback)shell->host.logger;
    if (logger != NULL) {
        logger(shell->host.environment, (fmi3Status)answer, category, message);
    }
}

fmi3Instance fmi3InstantiateModelExchange(fmi3String instanceName, fmi3String instantiationToken, fmi3String resourcePath,
    fmi3Boolean visible, fmi3Boolean loggingOn, fmi3InstanceEnvironment instanceEnvironment, fmi3LogMessageCallback logMessage)
{
    (void)resourcePath;
    (void)visible;
    const lag_birth birth = {
        .name = instanceName,
        .token = instantiationToken,
        .kind = LAG_MODEL_EXCHANGE,
        .logging = loggingOn,
        .event_mode = 1,
        .host = {.environment = instanceEnvironment, .tell = log_message, .logger = (void (*)(void))logMessage},
    };
    return lag_shell_create("fmi3InstantiateModelExchange", &birth);
}

fmi3Instance fmi3InstantiateCoSimulation(fmi3String instanceName, fmi3String instantiationToken, fmi3String resourcePath,
    fmi3Boolean visible, fmi3Boolean loggingOn, fmi3Boolean eventModeUsed, fmi3Boolean earlyReturnAllowed,
    const fmi3ValueReference requiredIntermediateVariables[], size_t nRequiredIntermediateVariables,
    fmi3InstanceEnvironment instanceEnvironment, fmi3LogMessageCallback logMessage, fmi3IntermediateUpdateCallback intermediateUpdate)
{
    (void)resourcePath;
    (void)visible;
    const lag_birth birth = {
        .name = instanceName,
        .token = instantiationToken,
        .kind = LAG_CO_SIMULATION,
        .logging = loggingOn,
        .event_mode = eventModeUsed,
        .early_return = earlyReturnAllowed,
        .host = {.environment = instanceEnvironment,
            .tell = log_message,
            .logger = (void (*)(void))logMessage,
            .update = (void (*)(void))intermediateUpdate},
    };
    lag_shell *shell = lag_shell_create("fmi3InstantiateCoSimulation", &birth);
    if (shell == NULL) {
        return NULL;
    }
    /* all variables are there in an intermediate update: the list is only looked at for names of nothing */
    int known = !lag_shell_lacks(shell, nRequiredIntermediateVariables > 0 && requiredIntermediateVariables == NULL,
        "the array of required intermediate variables");
    for (size_t i = 0; known && i < nRequiredIntermediateVariables; ++i) {
        known = lag_shell_variable(shell, requiredIntermediateVariables[i]) != NULL;
    }
    if (!known) {
        lag_shell_free(shell, "fmi3InstantiateCoSimulation");
        return NULL;
    }
    return shell;
}

fmi3Instance fmi3InstantiateScheduledExecution(fmi3String instanceName, fmi3String instantiationToken, fmi3String resourcePath,
    fmi3Boolean visible, fmi3Boolean loggingOn, fmi3InstanceEnvironment instanceEnvironment, fmi3LogMessageCallback logMessage,
    fmi3ClockUpdateCallback clockUpdate, fmi3LockPreemptionCallback lockPreemption, fmi3UnlockPreemptionCallback unlockPreemption)
{
    (void)resourcePath;
    (void)visible;
    (void)clockUpdate;
    (void)lockPreemption;
    (void)unlockPreemption;
    const lag_birth birth = {
        .name = instanceName,
        .token = instantiationToken,
        .kind = LAG_NO_KIND,
        .logging = loggingOn,
        .host = {.environment = instanceEnvironment, .tell = log_message, .logger = (void (*)(void))logMessage},
    };
    return lag_shell_create("fmi3InstantiateScheduledExecution", &birth);
}

fmi3Status fmi3EnterInitializationMode(fmi3Instance instance, fmi3Boolean toleranceDefined, fmi3Float64 tolerance,
    fmi3Float64 startTime, fmi3Boolean stopTimeDefined, fmi3Float64 stopTime)
{
    LAG_ENTER("EnterInitializationMode", LAG_MODE_INSTANTIATED)
    const lag_answer answer = lag_shell_set_experiment(shell, toleranceDefined, tolerance, startTime, stopTimeDefined, stopTime);
    return (fmi3Status)(answer == LAG_ANSWER_OK ? lag_shell_enter_initialization(shell) : answer);
}

fmi3Status fmi3EnterEventMode(fmi3Instance instance)
{
    LAG_ENTER("EnterEventMode", LAG_MODE_EVENT | LAG_MODE_CONTINUOUS | LAG_MODE_STEP)
    return (fmi3Status)lag_shell_enter_events(shell);
}

fmi3Status fmi3EvaluateDiscreteStates(fmi3Instance instance)
{
    LAG_ENTER("EvaluateDiscreteStates", LAG_MODE_INITIALIZATION | LAG_MODE_EVENT)
    return (fmi3Status)lag_shell_say(shell, LAG_ANSWER_ERROR, "discrete states are not evaluated without a transition (fmi3UpdateDiscreteStates)");
}

fmi3Status fmi3UpdateDiscreteStates(fmi3Instance instance, fmi3Boolean *discreteStatesNeedUpdate, fmi3Boolean *terminateSimulation,
    fmi3Boolean *nominalsOfContinuousStatesChanged, fmi3Boolean *valuesOfContinuousStatesChanged, fmi3Boolean *nextEventTimeDefined,
    fmi3Float64 *nextEventTime)
{
    LAG_ENTER("UpdateDiscreteStates", LAG_MODE_EVENT)
    LAG_NEEDS(discreteStatesNeedUpdate, "discreteStatesNeedUpdate")
    LAG_NEEDS(terminateSimulation, "terminateSimulation")
    LAG_NEEDS(nominalsOfContinuousStatesChanged, "nominalsOfContinuousStatesChanged")
    LAG_NEEDS(valuesOfContinuousStatesChanged, "valuesOfContinuousStatesChanged")
    LAG_NEEDS(nextEventTimeDefined, "nextEventTimeDefined")
    LAG_NEEDS(nextEventTime, "nextEventTime")
    lag_update told;
    const lag_answer answer = lag_shell_update(shell, &told);
    if (answer == LAG_ANSWER_OK) {
        *discreteStatesNeedUpdate = fmi3False;
        *terminateSimulation = told.terminate != 0;
        *nominalsOfContinuousStatesChanged = fmi3False;
        *valuesOfContinuousStatesChanged = told.states_changed != 0;
        *nextEventTimeDefined = isfinite(told.next) != 0;
        *nextEventTime = isfinite(told.next) ? told.next : 0.0;
    }
    return (fmi3Status)answer;
}

#include "lag/shell/life_functions.h"
