/*
 * Derivatives of the motion, exact: M dqdd - J'dlam = -dr and J dqdd = -ds with the directional derivatives of the residuals
 * at the accelerations that solve them, for many directions at once: those of single variables, or any.
 */
#ifndef LAG_JACOBIAN_H
#define LAG_JACOBIAN_H

#include "lag/parallel.h"

/* `count` of the variables q, qd, z, u, p in a row, from number `first` on. */
typedef struct lag_range {
    size_t first, count;
} lag_range;

/* Doubles that the workspace needs. `tangents` may be null in all functions of this file: one direction after the other. */
size_t lag_jacobian_workspace(const lag_model *model, const lag_tangents *tangents);

/* Doubles that are needed beside the workspace, also by lag_motion_linearize(). */
size_t lag_jacobian_memory(const lag_model *model, const lag_tangents *tangents);
/* Of these, what the equations along all groups of columns take, in so many lanes. */
size_t lag_linearization_memory(const lag_model *model, size_t lanes);

/*
 * d(qd, qdd, zd)/dx (2 nq + nz, count) and, unless null, dy/dx (ny, count) at t q qd z u w p, after prepare(). LAG_SINGULAR and
 * LAG_NOT_FINITE as lag_forward_dynamics(); all values are nan then, or what came out.
 */
lag_status lag_jacobian(
    const lag_model *model,
    const lag_tangents *tangents,
    const lag_arguments *at,
    lag_range x,
    double *memory,
    double *rates,
    double *outputs,
    size_t *coordinate);

/*
 * The same along `count` directions of q, qd, z, u, p in a row: directions (2 nq + nz + nu + np, count), rates (2 nq + nz, count), outputs
 * (ny, count).
 */
lag_status lag_jacobian_along(
    const lag_model *model,
    const lag_tangents *tangents,
    const lag_arguments *at,
    size_t count,
    const double *directions,
    double *memory,
    double *rates,
    double *outputs,
    size_t *coordinate);

#endif
