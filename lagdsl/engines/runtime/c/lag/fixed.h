/*
 * Steps of a length that the caller gives, at a cost that is known before: for control loops and simulation in real time.
 * No error is estimated. Two right-hand sides or four, and one Jacobian and one decomposition where it says so.
 */
#ifndef LAG_FIXED_H
#define LAG_FIXED_H

#include "lag/ode.h"

/* Doubles that any of these needs for states of `size` numbers. */
size_t lag_fixed_memory(size_t size);

/* x := x(t + h). Returns any status of the system that is not LAG_OK; x is then as before. */
typedef lag_status lag_fixed_step(const lag_ode *ode, double t, double h, double *x, double *memory);

/* The classical Runge-Kutta method of order 4: four right-hand sides. */
lag_fixed_step lag_rk4;

/* Order 2, for x = (q, qd, z); symplectic where forces depend on positions only and M is constant: two right-hand sides. */
lag_fixed_step lag_leapfrog;

/* Order 2, linearly implicit, L-stable: two right-hand sides, one Jacobian, one decomposition. */
lag_fixed_step lag_ros2;
static inline double lag_ros2_gamma(void)
{
    return 0.29289321881345254; /* 1 - 1/sqrt(2) */
}

#endif
