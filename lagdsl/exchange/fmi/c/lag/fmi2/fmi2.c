/* FMI 2.0: instances, the order of their modes, states, directional derivatives. */
#include "lag/fmi2/fmi2.h"

const char *fmi2GetTypesPlatform(void)
{
    return fmi2TypesPlatform;
}

const char *fmi2GetVersion(void)
{
    return fmi2Version;
}

/* In messages of FMI 2, # begins a reference to a variable; the text itself is an argument, so that % is nothing special. */
static void log_message(const lag_shell *shell, lag_answer answer, const char *category, const char *message)
{
    const fmi2CallbackLogger logger = (fmi2CallbackLogger)shell->host.logger;
    if (logger == NULL) {
        return;
    }
    char text[1024];
    size_t length = 0;
    for (; *message != '\0' && length + 3 < sizeof text; ++message) {
        text[length++] = *message;
        if (*message == '#') {
            text[length++] = '#';
        }
    }
    text[length] = '\0';
    logger(shell->host.environment, shell->name, (fmi2Status)answer, category, "%s", text);
}

static lag_host host_of(const fmi2CallbackFunctions *functions)
{
    lag_host host = {.environment = functions->componentEnvironment, .tell = log_message, .logger = (void (*)(void))functions->logger};
    if (functions->allocateMemory != NULL && functions->freeMemory != NULL) {
        host.allocate = functions->allocateMemory;
        host.release = functions->freeMemory;
    }
    return host;
}

fmi2Component fmi2Instantiate(fmi2String instanceName, fmi2Type fmuType, fmi2String fmuGUID, fmi2String fmuResourceLocation,
    const fmi2CallbackFunctions *functions, fmi2Boolean visible, fmi2Boolean loggingOn)
{
    (void)fmuResourceLocation;
    (void)visible;
    if (functions == NULL) {
        return NULL;
    }
    const lag_kinds other = fmuType == fmi2CoSimulation ? LAG_CO_SIMULATION : LAG_NO_KIND;
    const lag_birth birth = {
        .name = instanceName,
        .token = fmuGUID,
        .kind = fmuType == fmi2ModelExchange ? LAG_MODEL_EXCHANGE : other,
        .logging = loggingOn != fmi2False,
        .early_return = 0,
        .host = host_of(functions),
    };
    return lag_shell_create("fmi2Instantiate", &birth);
}

fmi2Status fmi2SetupExperiment(fmi2Component instance, fmi2Boolean toleranceDefined, fmi2Real tolerance, fmi2Real startTime,
    fmi2Boolean stopTimeDefined, fmi2Real stopTime)
{
    LAG_ENTER("SetupExperiment", LAG_MODE_INSTANTIATED)
    return (fmi2Status)lag_shell_set_experiment(
        shell, toleranceDefined != fmi2False, tolerance, startTime, stopTimeDefined != fmi2False, stopTime);
}

fmi2Status fmi2EnterInitializationMode(fmi2Component instance)
{
    LAG_ENTER("EnterInitializationMode", LAG_MODE_INSTANTIATED)
    return (fmi2Status)lag_shell_enter_initialization(shell);
}

#include "lag/shell/life_functions.h"
#include "lag/shell/state_functions.h"

fmi2Status fmi2DeSerializeFMUstate(fmi2Component instance, const fmi2Byte serializedState[], size_t size, fmi2FMUstate *FMUstate)
{
    LAG_ENTER("DeSerializeFMUstate", LAG_MODES_LASTING)
    return (fmi2Status)lag_shell_deserialize(shell, (const unsigned char *)serializedState, size, FMUstate);
}

fmi2Status fmi2GetDirectionalDerivative(fmi2Component instance, const fmi2ValueReference vUnknown_ref[], size_t nUnknown,
    const fmi2ValueReference vKnown_ref[], size_t nKnown, const fmi2Real dvKnown[], fmi2Real dvUnknown[])
{
    LAG_ENTER("GetDirectionalDerivative", LAG_MODES_KNOWN & LAG_MODES_LASTING)
    return (fmi2Status)lag_shell_slopes(shell, 0, vUnknown_ref, nUnknown, vKnown_ref, nKnown, dvKnown, nKnown,
        dvUnknown, nUnknown);
}
