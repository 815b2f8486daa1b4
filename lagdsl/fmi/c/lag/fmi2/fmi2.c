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
static void tell(const lag_shell *shell, lag_answer answer, const char *category, const char *message)
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
    lag_host host = {.environment = functions->componentEnvironment, .tell = tell, .logger = (void (*)(void))functions->logger};
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

void fmi2FreeInstance(fmi2Component c)
{
    lag_shell_free(c, "fmi2FreeInstance");
}

fmi2Status fmi2SetDebugLogging(fmi2Component c, fmi2Boolean loggingOn, size_t nCategories, const fmi2String categories[])
{
    LAG_ENTER("SetDebugLogging", LAG_MODES_ALL)
    return (fmi2Status)lag_shell_set_logging(shell, loggingOn != fmi2False, nCategories, categories);
}

fmi2Status fmi2SetupExperiment(fmi2Component c, fmi2Boolean toleranceDefined, fmi2Real tolerance, fmi2Real startTime,
    fmi2Boolean stopTimeDefined, fmi2Real stopTime)
{
    LAG_ENTER("SetupExperiment", LAG_MODE_INSTANTIATED)
    return (fmi2Status)lag_shell_set_experiment(
        shell, toleranceDefined != fmi2False, tolerance, startTime, stopTimeDefined != fmi2False, stopTime);
}

fmi2Status fmi2EnterInitializationMode(fmi2Component c)
{
    LAG_ENTER("EnterInitializationMode", LAG_MODE_INSTANTIATED)
    return (fmi2Status)lag_shell_enter_initialization(shell);
}

fmi2Status fmi2ExitInitializationMode(fmi2Component c)
{
    LAG_ENTER("ExitInitializationMode", LAG_MODE_INITIALIZATION)
    return (fmi2Status)lag_shell_exit_initialization(shell);
}

fmi2Status fmi2Terminate(fmi2Component c)
{
    LAG_ENTER("Terminate", LAG_MODE_EVENT | LAG_MODE_CONTINUOUS | LAG_MODE_STEP | LAG_MODE_STEP_FAILED)
    return (fmi2Status)lag_shell_terminate(shell);
}

fmi2Status fmi2Reset(fmi2Component c)
{
    LAG_ENTER("Reset", LAG_MODES_LASTING)
    return (fmi2Status)lag_shell_reset(shell);
}

fmi2Status fmi2GetFMUstate(fmi2Component c, fmi2FMUstate *FMUstate)
{
    LAG_ENTER("GetFMUstate", LAG_MODES_LASTING)
    return (fmi2Status)lag_shell_save(shell, FMUstate);
}

fmi2Status fmi2SetFMUstate(fmi2Component c, fmi2FMUstate FMUstate)
{
    LAG_ENTER("SetFMUstate", LAG_MODES_LASTING)
    return (fmi2Status)lag_shell_load(shell, FMUstate);
}

fmi2Status fmi2FreeFMUstate(fmi2Component c, fmi2FMUstate *FMUstate)
{
    LAG_ENTER("FreeFMUstate", LAG_MODES_LASTING)
    return (fmi2Status)lag_shell_forget(shell, FMUstate);
}

fmi2Status fmi2SerializedFMUstateSize(fmi2Component c, fmi2FMUstate FMUstate, size_t *size)
{
    LAG_ENTER("SerializedFMUstateSize", LAG_MODES_LASTING)
    return (fmi2Status)lag_shell_serialized_size(shell, FMUstate, size);
}

fmi2Status fmi2SerializeFMUstate(fmi2Component c, fmi2FMUstate FMUstate, fmi2Byte bytes[], size_t size)
{
    LAG_ENTER("SerializeFMUstate", LAG_MODES_LASTING)
    return (fmi2Status)lag_shell_serialize(shell, FMUstate, (unsigned char *)bytes, size);
}

fmi2Status fmi2DeSerializeFMUstate(fmi2Component c, const fmi2Byte serializedState[], size_t size, fmi2FMUstate *FMUstate)
{
    LAG_ENTER("DeSerializeFMUstate", LAG_MODES_LASTING)
    return (fmi2Status)lag_shell_deserialize(shell, (const unsigned char *)serializedState, size, FMUstate);
}

fmi2Status fmi2GetDirectionalDerivative(fmi2Component c, const fmi2ValueReference vUnknown_ref[], size_t nUnknown,
    const fmi2ValueReference vKnown_ref[], size_t nKnown, const fmi2Real dvKnown[], fmi2Real dvUnknown[])
{
    LAG_ENTER("GetDirectionalDerivative", LAG_MODES_KNOWN & LAG_MODES_LASTING)
    return (fmi2Status)lag_shell_slopes(shell, lag_instance_directional, vUnknown_ref, nUnknown, vKnown_ref, nKnown, dvKnown, nKnown,
        dvUnknown, nUnknown, 0);
}
