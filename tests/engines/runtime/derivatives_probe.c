/* Everything of lag/derivatives.h at one state and along one direction, for a test in another language. */
#include <stdlib.h>
#include <string.h>

#include "lag/derivatives.h"

/*
 * state: q qd z u w p; direction: q qd z u p and time. values: qdd, lam; changes: rates, y, d, energies, phi, J qd + b, lam. rows: as many
 * of the rows of J as are independent, and which.
 */
int probe(const lag_model *model, double rate, double t, const double *state, const double *direction, double *values, double *changes,
    size_t *rank, double *rows)
{
    const size_t n = model->nq, m = model->nc;
    const size_t order = 2 * n + model->nz + model->nu + model->np;
    double *workspace = calloc(model->workspace + 1, sizeof(double));
    double *memory = calloc(lag_derivatives_memory(model) + 1, sizeof(double));
    lag_derivatives d;
    lag_arguments at = {.t = t, .workspace = workspace, .context = model->context};
    at.q = state;
    at.qd = at.q + n;
    at.z = at.qd + n;
    at.u = at.z + model->nz;
    at.w = at.u + model->nu;
    at.p = at.w + model->nw;
    size_t coordinate = 0;
    int status = model->prepare(&at);
    lag_derivatives_place(&d, model, memory);
    status = status ? status : (int)lag_derivatives_factor(&d, &at, rate, &coordinate);
    memcpy(d.x, direction, order * sizeof(double));
    d.time = direction[order];
    status = status ? status : (int)lag_derivatives_along(&d);
    memcpy(values, d.qdd, n * sizeof(double));
    memcpy(values + n, d.lam, m * sizeof(double));
    status = status ? status : (int)lag_derivatives_rates(&d, changes);
    changes += 2 * n + model->nz;
    status = status ? status : (int)lag_derivatives_outputs(&d, changes);
    changes += model->ny;
    status = status ? status : (int)lag_derivatives_definitions(&d, changes);
    changes += model->nd;
    status = status ? status : (int)lag_derivatives_energies(&d, changes);
    changes += 3;
    status = status ? status : (int)lag_derivatives_residuals(&d, changes, changes + m);
    memcpy(changes + 2 * m, d.dlam, m * sizeof(double));
    *rank = d.system.rank;
    memcpy(rows, d.system.pivot, m * sizeof(double));
    free(memory);
    free(workspace);
    return status;
}
