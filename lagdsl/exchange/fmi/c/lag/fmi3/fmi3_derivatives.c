/* FMI 3.0: derivatives, and what depends on what. */
#include "lag/fmi3/fmi3.h"

#define LAG_DERIVATIVES_BY(NAME, ADJOINT)                                                                                   \
    fmi3Status fmi3##NAME(fmi3Instance instance, const fmi3ValueReference unknowns[], size_t nUnknowns,                     \
        const fmi3ValueReference knowns[], size_t nKnowns, const fmi3Float64 seed[], size_t nSeed, fmi3Float64 sensitivity[], \
        size_t nSensitivity)                                                                                                \
    {                                                                                                                       \
        LAG_ENTER(#NAME, LAG_MODES_KNOWN)                                                                                   \
        return (fmi3Status)lag_shell_slopes(                                                                                \
            shell, ADJOINT, unknowns, nUnknowns, knowns, nKnowns, seed, nSeed, sensitivity, nSensitivity);                  \
    }

LAG_DERIVATIVES_BY(GetDirectionalDerivative, 0)
LAG_DERIVATIVES_BY(GetAdjointDerivative, 1)

/* The dependencies of a variable; null, and told why, where there is no such variable or nothing is known. */
static const lag_dependency *dependencies_of(lag_shell *shell, fmi3ValueReference reference, size_t *count)
{
    const lag_fmu *fmu = shell->fmu;
    if (lag_shell_variable(shell, reference) == NULL) {
        return NULL;
    }
    if (fmu->dependencies.first == NULL || fmu->dependencies.entries == NULL) {
        (void)lag_shell_say(shell, LAG_ANSWER_ERROR, "only modelDescription.xml lists dependencies");
        return NULL;
    }
    *count = fmu->dependencies.first[reference + 1] - fmu->dependencies.first[reference];
    return fmu->dependencies.entries + fmu->dependencies.first[reference];
}

fmi3Status fmi3GetNumberOfVariableDependencies(fmi3Instance instance, fmi3ValueReference valueReference, size_t *nDependencies)
{
    LAG_ENTER("GetNumberOfVariableDependencies", LAG_MODES_LASTING)
    LAG_NEEDS(nDependencies, "nDependencies")
    return dependencies_of(shell, valueReference, nDependencies) != NULL ? fmi3OK : fmi3Error;
}

fmi3Status fmi3GetVariableDependencies(fmi3Instance instance, fmi3ValueReference dependent, size_t elementIndicesOfDependent[],
    fmi3ValueReference independents[], size_t elementIndicesOfIndependents[], fmi3DependencyKind dependencyKinds[],
    size_t nDependencies)
{
    LAG_ENTER("GetVariableDependencies", LAG_MODES_LASTING)
    size_t count = 0;
    const lag_dependency *dependencies = dependencies_of(shell, dependent, &count);
    if (dependencies == NULL) {
        return fmi3Error;
    }
    if (count != nDependencies) {
        return (fmi3Status)lag_shell_say(shell, LAG_ANSWER_ERROR, "room for %lu dependencies, where there are %lu",
            (unsigned long)nDependencies, (unsigned long)count);
    }
    if (count == 0) {
        return fmi3OK;
    }
    LAG_NEEDS(elementIndicesOfDependent, "elementIndicesOfDependent")
    LAG_NEEDS(independents, "independents")
    LAG_NEEDS(elementIndicesOfIndependents, "elementIndicesOfIndependents")
    LAG_NEEDS(dependencyKinds, "dependencyKinds")
    for (size_t i = 0; i < count; ++i) {
        elementIndicesOfDependent[i] = dependencies[i].element;
        independents[i] = (fmi3ValueReference)dependencies[i].other;
        elementIndicesOfIndependents[i] = dependencies[i].other_element;
        dependencyKinds[i] = (fmi3DependencyKind)dependencies[i].kind;
    }
    return fmi3OK;
}
