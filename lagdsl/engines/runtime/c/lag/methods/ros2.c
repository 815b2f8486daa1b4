/*
 * The Rosenbrock method ROS2 with gamma = 1 - 1/sqrt(2): of order 2 with any matrix in place of the Jacobian, which is why the
 * derivative by time may be left out, and L-stable with the exact one.
 *
 * Source: Verwer, Spee, Blom and Hundsdorfer, SIAM J. Sci. Comput. 20 (1999) 1456, formula (2.1).
 */
#include "lag/fixed.h"
#include "lag/factorization/lu.h"

size_t lag_fixed_memory(size_t size)
{
    return size * size + 4 * size;
}

lag_status lag_ros2(const lag_ode *ode, double t, double h, double *x, double *memory)
{
    const size_t size = ode->size;
    double *matrix = memory;
    double *pivot = matrix + size * size;
    double *at = pivot + size;
    double *first = at + size;
    double *second = first + size;
    lag_status status = ode->jacobian(ode->context, t, x, matrix);
    if (status == LAG_OK) {
        status = ode->rates(ode->context, t, x, first);
    }
    if (status != LAG_OK) {
        return status;
    }
    for (size_t i = 0; i < size * size; ++i) {
        matrix[i] *= -lag_ros2_gamma() * h;
    }
    for (size_t i = 0; i < size; ++i) {
        matrix[i * size + i] += 1.0;
    }
    if (!lag_lu(size, matrix, pivot)) {
        return LAG_SINGULAR;
    }
    lag_lu_solve(size, matrix, pivot, first);
    for (size_t i = 0; i < size; ++i) {
        at[i] = x[i] + h * first[i];
    }
    status = ode->rates(ode->context, t + h, at, second);
    if (status != LAG_OK) {
        return status;
    }
    for (size_t i = 0; i < size; ++i) {
        second[i] -= 2.0 * first[i];
    }
    lag_lu_solve(size, matrix, pivot, second);
    for (size_t i = 0; i < size; ++i) {
        x[i] += h * (1.5 * first[i] + 0.5 * second[i]);
    }
    return LAG_OK;
}
