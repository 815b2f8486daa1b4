/* M and the linear system of a model that does not write them out: M column by column, from momentum_tangent(). */
#ifndef LAG_COLUMNS_H
#define LAG_COLUMNS_H

#include "lag/model.h"

/* M (nq, nq); `memory` has room for 5 nq numbers (tapes and generated C reserve them). */
lag_status lag_mass_by_columns(const lag_model *model, const lag_arguments *at, double *memory, double *mass);

/* M (nq, nq), f (nq), J (nc, nq), gamma (nc); `memory` has room for 5 nq + nc numbers. */
lag_status lag_dynamics_by_columns(
    const lag_model *model,
    const lag_arguments *at,
    double *memory,
    double *mass,
    double *force,
    double *jacobian,
    double *gamma);

#endif
