/* FMI 3.0: values of variables: Float64, Int32, Int64 of enumerations, Boolean, constant String; of other types there are none. */
#include "lag/fmi3/fmi3.h"

#define READABLE LAG_MODES_ALL
#define WRITABLE (LAG_MODE_INSTANTIATED | LAG_MODE_INITIALIZATION | LAG_MODE_EVENT | LAG_MODE_CONTINUOUS | LAG_MODE_STEP)

#define LAG_NO_VARIABLES(TYPE)                                                                                                       \
    fmi3Status fmi3Get##TYPE(fmi3Instance instance, const fmi3ValueReference valueReferences[], size_t nValueReferences,             \
        fmi3##TYPE values[], size_t nValues)                                                                                         \
    {                                                                                                                                \
        LAG_ENTER("Get" #TYPE, READABLE)                                                                                             \
        (void)valueReferences;                                                                                                       \
        (void)values;                                                                                                                \
        return (fmi3Status)lag_shell_none(shell, nValueReferences > nValues ? nValueReferences : nValues, #TYPE);                    \
    }                                                                                                                                \
                                                                                                                                     \
    fmi3Status fmi3Set##TYPE(fmi3Instance instance, const fmi3ValueReference valueReferences[], size_t nValueReferences,             \
        const fmi3##TYPE values[], size_t nValues)                                                                                   \
    {                                                                                                                                \
        LAG_ENTER("Set" #TYPE, WRITABLE)                                                                                             \
        (void)valueReferences;                                                                                                       \
        (void)values;                                                                                                                \
        return (fmi3Status)lag_shell_none(shell, nValueReferences > nValues ? nValueReferences : nValues, #TYPE);                    \
    }

LAG_NO_VARIABLES(Float32)
LAG_NO_VARIABLES(Int8)
LAG_NO_VARIABLES(UInt8)
LAG_NO_VARIABLES(Int16)
LAG_NO_VARIABLES(UInt16)
LAG_NO_VARIABLES(UInt32)
LAG_NO_VARIABLES(UInt64)

static void store_integer(void *values, size_t index, double value)
{
    ((fmi3Int32 *)values)[index] = lag_shell_integer(value);
}

static double fetch_integer(const void *values, size_t index)
{
    return (double)((const fmi3Int32 *)values)[index];
}

static void store_choice(void *values, size_t index, double value)
{
    ((fmi3Int64 *)values)[index] = lag_shell_integer(value);
}

static double fetch_choice(const void *values, size_t index)
{
    return (double)((const fmi3Int64 *)values)[index];
}

static void store_boolean(void *values, size_t index, double value)
{
    ((fmi3Boolean *)values)[index] = value != 0.0;
}

_Static_assert(sizeof(fmi3Boolean) == 1, "a Boolean of FMI 3 is one byte");

/* As bytes: what importers hand over need not be 0 or 1. */
static double fetch_boolean(const void *values, size_t index)
{
    return ((const unsigned char *)values)[index] != 0 ? 1.0 : 0.0;
}

#define LAG_VARIABLES(NAME, TYPE, STORE, FETCH)                                                                                      \
    fmi3Status fmi3Get##NAME(fmi3Instance instance, const fmi3ValueReference valueReferences[], size_t nValueReferences,             \
        fmi3##NAME values[], size_t nValues)                                                                                         \
    {                                                                                                                                \
        LAG_ENTER("Get" #NAME, READABLE)                                                                                             \
        return (fmi3Status)lag_shell_get(shell, TYPE, valueReferences, nValueReferences, values, nValues, STORE);                    \
    }                                                                                                                                \
                                                                                                                                     \
    fmi3Status fmi3Set##NAME(fmi3Instance instance, const fmi3ValueReference valueReferences[], size_t nValueReferences,             \
        const fmi3##NAME values[], size_t nValues)                                                                                   \
    {                                                                                                                                \
        LAG_ENTER("Set" #NAME, WRITABLE)                                                                                             \
        return (fmi3Status)lag_shell_set(shell, TYPE, valueReferences, nValueReferences, values, nValues, FETCH);                    \
    }

LAG_VARIABLES(Float64, LAG_TYPE_REAL, NULL, NULL)
LAG_VARIABLES(Int32, LAG_TYPE_INTEGER, store_integer, fetch_integer)
LAG_VARIABLES(Int64, LAG_TYPE_ENUMERATION, store_choice, fetch_choice)
LAG_VARIABLES(Boolean, LAG_TYPE_BOOLEAN, store_boolean, fetch_boolean)

fmi3Status fmi3GetString(
    fmi3Instance instance, const fmi3ValueReference valueReferences[], size_t nValueReferences, fmi3String values[], size_t nValues)
{
    LAG_ENTER("GetString", READABLE)
    return (fmi3Status)lag_shell_get_texts(shell, valueReferences, nValueReferences, values, nValues);
}

fmi3Status fmi3SetString(
    fmi3Instance instance, const fmi3ValueReference valueReferences[], size_t nValueReferences, const fmi3String values[], size_t nValues)
{
    LAG_ENTER("SetString", WRITABLE)
    (void)valueReferences;
    (void)values;
    return nValueReferences == 0 && nValues == 0 ?
        fmi3OK :
        (fmi3Status)lag_shell_say(shell, LAG_ANSWER_ERROR, "texts are constants of this FMU and cannot be set");
}

fmi3Status fmi3GetBinary(fmi3Instance instance, const fmi3ValueReference valueReferences[], size_t nValueReferences,
    size_t valueSizes[], fmi3Binary values[], size_t nValues)
{
    LAG_ENTER("GetBinary", READABLE)
    (void)valueReferences;
    (void)valueSizes;
    (void)values;
    return (fmi3Status)lag_shell_none(shell, nValueReferences > nValues ? nValueReferences : nValues, "Binary");
}

fmi3Status fmi3SetBinary(fmi3Instance instance, const fmi3ValueReference valueReferences[], size_t nValueReferences,
    const size_t valueSizes[], const fmi3Binary values[], size_t nValues)
{
    LAG_ENTER("SetBinary", WRITABLE)
    (void)valueReferences;
    (void)valueSizes;
    (void)values;
    return (fmi3Status)lag_shell_none(shell, nValueReferences > nValues ? nValueReferences : nValues, "Binary");
}
