/* Prints a generated lag_fmu, whose model is not there: counts of what it lacks are given. */
#include "lag/fmu.h"

#include <stdio.h>

extern const lag_fmu lag_exported;
extern const size_t sizes[6]; /* states, rows, inputs, outputs, invariants, parameters */

static void doubles(const char *name, const double *values, size_t count)
{
    printf("%s", name);
    for (size_t i = 0; i < count; i++) {
        if (values == NULL) printf(" -");
        else printf(" %a", values[i]);
    }
    printf("\n");
}

int main(void)
{
    const lag_fmu *fmu = &lag_exported;
    printf("token %s\n", fmu->token);
    for (size_t i = 0; i < fmu->nvariable; i++) {
        const lag_variable *v = &fmu->variables[i];
        printf("variable %d %d %d %zu %zu", v->role, v->type, v->setting, v->first, v->count);
        if (v->role == LAG_ROLE_CONSTANT && v->type == LAG_TYPE_STRING) printf(" %s", fmu->constants.texts[v->first]);
        else if (v->role == LAG_ROLE_CONSTANT) {
            for (size_t k = 0; k < v->count; k++) printf(" %a", fmu->constants.numbers[v->first + k]);
        }
        printf("\n");
    }
    doubles("nominal", fmu->nominal, sizes[0]);
    doubles("group", fmu->sizes.group, sizes[0]);
    doubles("natural", fmu->sizes.natural, sizes[0]);
    doubles("cap", fmu->sizes.cap, sizes[0]);
    doubles("row_sizes", fmu->sizes.row_sizes, sizes[1]);
    doubles("lasting", fmu->lasting.rows, sizes[1]);
    doubles("invariant_limits", fmu->invariant_limits, sizes[4]);
    for (size_t i = 0; i < sizes[5] && fmu->parameter_range != NULL; i++) {
        printf("range %a %a\n", fmu->parameter_range[i].least, fmu->parameter_range[i].most);
    }
    printf("input_rates");
    for (size_t i = 0; i < sizes[2] && fmu->inputs.rates != NULL; i++) printf(" %zu", fmu->inputs.rates[i]);
    printf("\nexperiment %a %a %a\ngeneral %zu\nkinds %d\n", fmu->experiment.start, fmu->experiment.stop, fmu->experiment.tolerance, fmu->lasting.general, fmu->kinds);
    return 0;
}
