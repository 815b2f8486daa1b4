/*
 * Stoermer and Verlet's method, kick, drift, kick; the second kick takes the rates that the first acceleration predicts, and
 * states z go by Heun's method.
 *
 * Source: Hairer, Lubich and Wanner, Geometric Numerical Integration, 2nd ed., section I.1.4.
 */
#include "lag/fixed.h"

lag_status lag_leapfrog(const lag_ode *ode, double t, double h, double *x, double *memory)
{
    const size_t size = ode->size;
    const size_t nq = ode->nq;
    double *at = memory;
    double *first = at + size;
    double *last = first + size;
    lag_status status = ode->rates(ode->context, t, x, first);
    if (status != LAG_OK) {
        return status;
    }
    for (size_t i = 0; i < nq; ++i) {
        at[i] = x[i] + h * (x[nq + i] + 0.5 * h * first[nq + i]);
    }
    for (size_t i = nq; i < size; ++i) {
        at[i] = x[i] + h * first[i];
    }
    status = ode->rates(ode->context, t + h, at, last);
    if (status != LAG_OK) {
        return status;
    }
    for (size_t i = 0; i < nq; ++i) {
        x[i] = at[i];
    }
    for (size_t i = nq; i < size; ++i) {
        x[i] += 0.5 * h * (first[i] + last[i]);
    }
    return LAG_OK;
}
