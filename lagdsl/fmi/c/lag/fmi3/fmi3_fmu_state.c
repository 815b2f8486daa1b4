/* FMI 3.0: states of FMUs as handles and as bytes. */
#include "lag/fmi3/fmi3.h"

fmi3Status fmi3GetFMUState(fmi3Instance instance, fmi3FMUState *FMUState)
{
    LAG_ENTER("GetFMUState", LAG_MODES_LASTING)
    return (fmi3Status)lag_shell_save(shell, FMUState);
}

fmi3Status fmi3SetFMUState(fmi3Instance instance, fmi3FMUState FMUState)
{
    LAG_ENTER("SetFMUState", LAG_MODES_LASTING)
    return (fmi3Status)lag_shell_load(shell, FMUState);
}

fmi3Status fmi3FreeFMUState(fmi3Instance instance, fmi3FMUState *FMUState)
{
    LAG_ENTER("FreeFMUState", LAG_MODES_LASTING)
    return (fmi3Status)lag_shell_forget(shell, FMUState);
}

fmi3Status fmi3SerializedFMUStateSize(fmi3Instance instance, fmi3FMUState FMUState, size_t *size)
{
    LAG_ENTER("SerializedFMUStateSize", LAG_MODES_LASTING)
    return (fmi3Status)lag_shell_serialized_size(shell, FMUState, size);
}

fmi3Status fmi3SerializeFMUState(fmi3Instance instance, fmi3FMUState FMUState, fmi3Byte serializedState[], size_t size)
{
    LAG_ENTER("SerializeFMUState", LAG_MODES_LASTING)
    return (fmi3Status)lag_shell_serialize(shell, FMUState, serializedState, size);
}

fmi3Status fmi3DeserializeFMUState(fmi3Instance instance, const fmi3Byte serializedState[], size_t size, fmi3FMUState *FMUState)
{
    LAG_ENTER("DeserializeFMUState", LAG_MODES_LASTING)
    return (fmi3Status)lag_shell_deserialize(shell, serializedState, size, FMUState);
}
