/* FMI 2.0: values of variables. Every variable is one number. */
#include "lag/fmi2/fmi2.h"

#define READABLE LAG_MODES_ALL
#define WRITABLE (LAG_MODE_INSTANTIATED | LAG_MODE_INITIALIZATION | LAG_MODE_EVENT | LAG_MODE_CONTINUOUS | LAG_MODE_STEP)

static void store_integer(void *values, size_t index, double value)
{
    ((fmi2Integer *)values)[index] = lag_shell_integer(value);
}

static double fetch_integer(const void *values, size_t index)
{
    return (double)((const fmi2Integer *)values)[index];
}

static void store_boolean(void *values, size_t index, double value)
{
    ((fmi2Boolean *)values)[index] = value != 0.0 ? fmi2True : fmi2False;
}

static double fetch_boolean(const void *values, size_t index)
{
    return ((const fmi2Boolean *)values)[index] != fmi2False ? 1.0 : 0.0;
}

fmi2Status fmi2GetReal(fmi2Component instance, const fmi2ValueReference vr[], size_t nvr, fmi2Real value[])
{
    LAG_ENTER("GetReal", READABLE)
    return (fmi2Status)lag_shell_get(shell, LAG_TYPE_REAL, vr, nvr, value, nvr, NULL);
}

fmi2Status fmi2GetInteger(fmi2Component instance, const fmi2ValueReference vr[], size_t nvr, fmi2Integer value[])
{
    LAG_ENTER("GetInteger", READABLE)
    return (fmi2Status)lag_shell_get(shell, LAG_TYPE_INTEGER, vr, nvr, value, nvr, store_integer);
}

fmi2Status fmi2GetBoolean(fmi2Component instance, const fmi2ValueReference vr[], size_t nvr, fmi2Boolean value[])
{
    LAG_ENTER("GetBoolean", READABLE)
    return (fmi2Status)lag_shell_get(shell, LAG_TYPE_BOOLEAN, vr, nvr, value, nvr, store_boolean);
}

fmi2Status fmi2GetString(fmi2Component instance, const fmi2ValueReference vr[], size_t nvr, fmi2String value[])
{
    LAG_ENTER("GetString", READABLE)
    return (fmi2Status)lag_shell_get_texts(shell, vr, nvr, value, nvr);
}

fmi2Status fmi2SetReal(fmi2Component instance, const fmi2ValueReference vr[], size_t nvr, const fmi2Real value[])
{
    LAG_ENTER("SetReal", WRITABLE)
    return (fmi2Status)lag_shell_set(shell, LAG_TYPE_REAL, vr, nvr, value, nvr, NULL);
}

fmi2Status fmi2SetInteger(fmi2Component instance, const fmi2ValueReference vr[], size_t nvr, const fmi2Integer value[])
{
    LAG_ENTER("SetInteger", WRITABLE)
    return (fmi2Status)lag_shell_set(shell, LAG_TYPE_INTEGER, vr, nvr, value, nvr, fetch_integer);
}

fmi2Status fmi2SetBoolean(fmi2Component instance, const fmi2ValueReference vr[], size_t nvr, const fmi2Boolean value[])
{
    LAG_ENTER("SetBoolean", WRITABLE)
    return (fmi2Status)lag_shell_set(shell, LAG_TYPE_BOOLEAN, vr, nvr, value, nvr, fetch_boolean);
}

fmi2Status fmi2SetString(fmi2Component instance, const fmi2ValueReference vr[], size_t nvr, const fmi2String value[])
{
    LAG_ENTER("SetString", WRITABLE)
    (void)vr;
    (void)value;
    return nvr == 0 ? fmi2OK : (fmi2Status)lag_shell_say(shell, LAG_ANSWER_ERROR, "texts are constants of this FMU and cannot be set");
}
