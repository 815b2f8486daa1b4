/* FMI 3.0 for model exchange. */
#include "lag/fmi3/fmi3.h"

#include "lag/shell/exchange_functions.h"

fmi3Status fmi3GetContinuousStateDerivatives(fmi3Instance instance, fmi3Float64 derivatives[], size_t nContinuousStates)
{
    LAG_ENTER_EXCHANGE("GetContinuousStateDerivatives", EVALUABLE)
    return (fmi3Status)lag_shell_get_vector(shell, LAG_ROLE_DERIVATIVE, derivatives, nContinuousStates);
}

fmi3Status fmi3GetNumberOfEventIndicators(fmi3Instance instance, size_t *nEventIndicators)
{
    LAG_ENTER_EXCHANGE("GetNumberOfEventIndicators", LAG_MODES_LASTING)
    LAG_NEEDS(nEventIndicators, "nEventIndicators")
    *nEventIndicators = shell->fmu->indicators.count;
    return fmi3OK;
}

fmi3Status fmi3GetNumberOfContinuousStates(fmi3Instance instance, size_t *nContinuousStates)
{
    LAG_ENTER_EXCHANGE("GetNumberOfContinuousStates", LAG_MODES_LASTING)
    LAG_NEEDS(nContinuousStates, "nContinuousStates")
    *nContinuousStates = shell->fmu->states.count;
    return fmi3OK;
}
