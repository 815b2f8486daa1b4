/*
 * The classical Runge-Kutta method.
 *
 * Source: Kutta, Z. Math. Phys. 46 (1901) 435; Hairer, Norsett and Wanner, Solving Ordinary Differential Equations I, 2nd ed.,
 * table II.1.2.
 */
#include "lag/fixed.h"

lag_status lag_rk4(const lag_ode *ode, double t, double h, double *x, double *memory)
{
    static const double node[4] = {0.0, 0.5, 0.5, 1.0};
    static const double weight[4] = {1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0};
    const size_t size = ode->size;
    double *at = memory;
    double *slope = at + size;
    double *sum = slope + size;
    for (size_t i = 0; i < size; ++i) {
        sum[i] = slope[i] = 0.0;
    }
    for (size_t k = 0; k < 4; ++k) {
        for (size_t i = 0; i < size; ++i) {
            at[i] = x[i] + node[k] * h * slope[i];
        }
        const lag_status status = ode->rates(ode->context, t + node[k] * h, at, slope);
        if (status != LAG_OK) {
            return status;
        }
        for (size_t i = 0; i < size; ++i) {
            sum[i] += weight[k] * slope[i];
        }
    }
    for (size_t i = 0; i < size; ++i) {
        x[i] += h * sum[i];
    }
    return LAG_OK;
}
