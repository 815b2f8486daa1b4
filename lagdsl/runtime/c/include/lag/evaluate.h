/* Any function of a model by number, one state or many. */
#ifndef LAG_EVALUATE_H
#define LAG_EVALUATE_H

#include "lag/model.h"

/* In the order of the function pointers of lag_model. */
typedef enum lag_function {
    LAG_START,
    LAG_POSITION_CONSTRAINT,
    LAG_VELOCITY_CONSTRAINT,
    LAG_MASS_MATRIX,
    LAG_DYNAMICS,
    LAG_INVERSE_DYNAMICS,
    LAG_RESIDUAL,
    LAG_RESIDUAL_TANGENT,
    LAG_STATE_DERIVATIVE,
    LAG_STATE_DERIVATIVE_TANGENT,
    LAG_OUTPUT,
    LAG_OUTPUT_TANGENT,
    LAG_ENERGIES,
    LAG_MOMENTA,
    LAG_POWER,
    LAG_MONITOR,
    LAG_INITIAL_EQUATION,
    LAG_CONSTRAINT_TANGENT,
    LAG_ELIMINATION,
    LAG_MOMENTUM_TANGENT
} lag_function;

/* prepare() for the parameters and the workspace of `at`. */
lag_status lag_prepare(const lag_model *model, const lag_arguments *at);

/* Results are written one after the other into `results`, each in the order that lag/model.h tells. */
lag_status lag_evaluate(const lag_model *model, lag_function which, const lag_arguments *at, double *results);

/* Arrays of `count` states: array x of state i starts at x + i * its stride; stride 0 shares one array among all states. */
typedef struct lag_batch {
    size_t count;
    const double *t, *q, *qd, *z, *u, *w, *p, *qdd, *lam, *dq, *dqd, *dz, *du, *dp, *dqdd, *dlam;
    size_t t_stride, q_stride, qd_stride, z_stride, u_stride, w_stride, p_stride, qdd_stride, lam_stride, dq_stride,
        dqd_stride, dz_stride, du_stride, dp_stride, dqdd_stride, dlam_stride;
    double *workspace; /* of the model */
    double *memory;    /* lag_dynamics_memory() */
    double *lanes;     /* lag_batch_memory(), or null: one state after the other */
} lag_batch;

/* Doubles that a batch of several states at once needs beside; 0 where the model has none. */
size_t lag_batch_memory(const lag_model *model);

/* State i's results start at results + i * width. Calls prepare() itself. Returns the first status that is not LAG_OK. */
lag_status lag_batch_evaluate(
    const lag_model *model, lag_function which, const lag_batch *batch, double *results, size_t width);

/* qdd (count, nq), lam (count, nc). LAG_SINGULAR stops the loop; other failures leave their values and go on. */
lag_status lag_batch_forward_dynamics(
    const lag_model *model, const lag_batch *batch, double *qdd, double *lam, size_t *coordinate);

/* (count, 2 nq + nz, 2 nq + nz). */
lag_status lag_batch_state_jacobian(
    const lag_model *model, const lag_batch *batch, double *jacobian, size_t *coordinate);

#endif
