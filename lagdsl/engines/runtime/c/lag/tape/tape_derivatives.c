/* The derivatives of the motion, from a tape. */
#include "lag/tape/tape_model.h"

static lag_status jacobian(
    const lag_arguments *at, double *qdd, double *lam, double *pivot, double *response, double *by_state, double *by_parameter)
{
    double *const results[] = {qdd, lam, pivot, response, by_state, by_parameter};
    const lag_tape *tape = at->context;
    const lag_tape_code code = {tape->words + tape->functions[2 * LAG_TAPE_JACOBIAN], tape->constants, tape->constant_count};
    lag_tape_run(&code, at, at->workspace, results);
    return LAG_OK;
}

void lag_tape_differentiated(lag_tape *tape, int has)
{
    tape->differentiated = (lag_tangents){.workspace = tape->row, .jacobian = has ? jacobian : NULL};
}

const lag_tangents *lag_tape_jacobian(const lag_model *model)
{
    const lag_tape *tape = model->context;
    return tape->differentiated.jacobian != NULL ? &tape->differentiated : NULL;
}
