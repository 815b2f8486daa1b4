/* FMI 3.0: states of FMUs as handles and as bytes. */
#include "lag/fmi3/fmi3.h"

#include "lag/shell/state_functions.h"

fmi3Status fmi3DeserializeFMUState(fmi3Instance instance, const fmi3Byte serializedState[], size_t size, fmi3FMUState *FMUState)
{
    LAG_ENTER("DeserializeFMUState", LAG_MODES_LASTING)
    return (fmi3Status)lag_shell_deserialize(shell, serializedState, size, FMUState);
}
