/* FMI 3.0: values of variables: Float64, Int32, Int64 of enumerations, Boolean, constant String; of other types there are none. */
#include "lag/fmi3/fmi3.h"

#define LAG_FMI_ROOM , size_t room
#define LAG_FMI_COUNT room

_Static_assert(sizeof(fmi3Boolean) == 1, "a Boolean of FMI 3 is one byte");
typedef unsigned char lag_fmi_boolean_bits;

#include "lag/shell/value_functions.h"

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

static void store_choice(void *values, size_t index, double value)
{
    ((fmi3Int64 *)values)[index] = lag_shell_integer(value);
}

static double fetch_choice(const void *values, size_t index)
{
    return (double)((const fmi3Int64 *)values)[index];
}

LAG_VALUES(Float64, LAG_TYPE_REAL, NULL, NULL)
LAG_VALUES(Int32, LAG_TYPE_INTEGER, store_integer, fetch_integer)
LAG_VALUES(Int64, LAG_TYPE_ENUMERATION, store_choice, fetch_choice)

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
