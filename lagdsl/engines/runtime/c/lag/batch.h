/* Functions of a model at many states. */
#ifndef LAG_BATCH_H
#define LAG_BATCH_H

#include "lag/evaluate.h"
#include "lag/equations/jacobian.h"
#include "lag/parallel.h"

/* The same array of many states: that of state i starts at first + i * stride; stride 0 shares one among all states. */
typedef struct lag_strided {
    const double *first;
    size_t stride;
} lag_strided;

/* Arguments of `count` states. */
typedef struct lag_batch {
    size_t count;
    lag_strided t, q, qd, z, u, w, p, qdd, lam, dq, dqd, dz, du, dp, dqdd, dlam;
    double *workspace; /* lag_jacobian_workspace() for Jacobians, else that of the model */
    double *memory;    /* lag_jacobian_memory() for Jacobians, else lag_dynamics_memory() */
    double *lanes;     /* lag_batch_memory() for several states at once */
} lag_batch;

/* State i's results start at results + i * width. Calls prepare() itself. Returns the first status that is not LAG_OK. */
lag_status lag_batch_evaluate(
    const lag_model *model, lag_function which, const lag_batch *batch, double *results, size_t width);

/* Doubles that several states at once need. */
size_t lag_batch_memory(const lag_model *model, const lag_states *states);

/*
 * qdd (count, nq), lam (count, nc); with `states` null, one state after the other, to the same bits. LAG_SINGULAR stops the
 * loop; other failures leave their values and go on.
 */
lag_status lag_batch_forward_dynamics(
    const lag_model *model,
    const lag_states *states,
    const lag_batch *batch,
    double *qdd,
    double *lam,
    size_t *coordinate);

/* lag_jacobian() at every state: rates (count, 2 nq + nz, x.count) and outputs (count, ny, x.count). */
lag_status lag_batch_jacobian(
    const lag_model *model,
    const lag_tangents *tangents,
    const lag_batch *batch,
    lag_range x,
    double *rates,
    double *outputs,
    size_t *coordinate);

#endif
