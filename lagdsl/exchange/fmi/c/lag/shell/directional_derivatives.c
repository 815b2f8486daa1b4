/* Directional and adjoint derivatives, and those in time: references become entries of variables. */
#include "lag/shell/shell.h"

static void spread(const lag_shell *shell, const uint32_t *references, size_t n, lag_known *known)
{
    for (size_t i = 0; i < n; ++i) {
        for (size_t k = 0; k < shell->fmu->variables[references[i]].count; ++k) {
            *known++ = (lag_known){.variable = references[i], .element = k};
        }
    }
}

/* Room that is kept: only the first calls allocate. */
static int reserve(lag_shell *shell, size_t count)
{
    if (count <= shell->capacity) {
        return 1;
    }
    lag_known *known = count < SIZE_MAX / sizeof *known ? lag_shell_allocate(shell, count * sizeof *known) : NULL;
    if (known == NULL) {
        (void)lag_shell_say(shell, LAG_ANSWER_ERROR, "no memory for %lu variables", (unsigned long)count);
        return 0;
    }
    lag_shell_release(shell, shell->known);
    shell->known = known;
    shell->capacity = count;
    return 1;
}

/* 0, and told why: there are no derivatives. */
static int has_derivatives(lag_shell *shell)
{
    const int has = shell->fmu->model->nload == 0;
    if (!has) {
        (void)lag_shell_say(shell, LAG_ANSWER_ERROR, "loads depend on the forces that they cause: there are no directional derivatives");
    }
    return has;
}

lag_answer lag_shell_slopes(lag_shell *shell, int adjoint, const uint32_t *unknowns, size_t nunknown, const uint32_t *knowns,
    size_t nknown, const double *seed, size_t nseed, double *sensitivity, size_t nsensitivity)
{
    size_t unknown = 0, known = 0;
    if (!has_derivatives(shell) || lag_shell_lacks(shell, nseed > 0 && seed == NULL, "the seed") ||
        lag_shell_lacks(shell, nsensitivity > 0 && sensitivity == NULL, "the array of sensitivities") ||
        !lag_shell_count(shell, LAG_TYPE_REAL, unknowns, nunknown, &unknown) || !lag_shell_count(shell, LAG_TYPE_REAL, knowns, nknown, &known)) {
        return LAG_ANSWER_ERROR;
    }
    if (nseed != (adjoint ? unknown : known) || nsensitivity != (adjoint ? known : unknown)) {
        return lag_shell_say(shell, LAG_ANSWER_ERROR, "%lu seeds and %lu sensitivities for %lu unknowns and %lu knowns",
            (unsigned long)nseed, (unsigned long)nsensitivity, (unsigned long)unknown, (unsigned long)known);
    }
    const lag_answer answer = lag_shell_initialized(shell);
    if (answer != LAG_ANSWER_OK || nsensitivity == 0) {
        return answer;
    }
    if (!reserve(shell, unknown + known)) {
        return LAG_ANSWER_ERROR;
    }
    spread(shell, unknowns, nunknown, shell->known);
    spread(shell, knowns, nknown, shell->known + unknown);
    return lag_shell_judge(shell, lag_instance_slopes(shell->instance, adjoint, shell->known, unknown, shell->known + unknown, known, seed, sensitivity));
}

lag_answer lag_shell_get_output_derivatives(
    lag_shell *shell, const uint32_t *references, size_t n, const int32_t *orders, double *values, size_t count)
{
    if (!has_derivatives(shell) || !lag_shell_consistent(shell, LAG_TYPE_REAL, references, n, values, count) ||
        lag_shell_lacks(shell, n > 0 && orders == NULL, "the array of orders")) {
        return LAG_ANSWER_ERROR;
    }
    size_t place = 0;
    for (size_t i = 0; i < n; ++i) {
        if (orders[i] < 1) {
            return lag_shell_say(shell, LAG_ANSWER_ERROR, "orders of derivatives are at least 1");
        }
        const lag_status status = lag_instance_get_output_derivative(shell->instance, references[i], orders[i], values + place);
        if (status != LAG_OK) {
            return lag_shell_judge(shell, status);
        }
        place += shell->fmu->variables[references[i]].count;
    }
    return LAG_ANSWER_OK;
}
