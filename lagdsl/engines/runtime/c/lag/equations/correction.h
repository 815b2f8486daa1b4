/*
 * The change of least inertia that takes residuals of the constraints away to first order, M change - J' lam = 0 and
 * J change = -residual, by the function correction() of a model: solved as elimination() solves the equations of motion, without forming M.
 */
#ifndef LAG_CORRECTION_H
#define LAG_CORRECTION_H

#include "lag/model.h"

/* Doubles that it needs beside the workspace of the model. */
size_t lag_correction_memory(const lag_model *model);

/*
 * change (nq) for residuals (nc) at t q qd z u w p. `jacobian` (nc, nq) is J there, `sizes` (nc) what residuals are measured in.
 * LAG_MISSING: the model has no such function, or it keeps too few digits here; the dense system tells.
 */
lag_status lag_correction(const lag_model *model, const lag_arguments *at, const double *residual, const double *jacobian,
    const double *sizes, double *memory, double *change);

#endif
