/*
 * A run with the derivatives of its motion by parameters, start values and constant shifts of inputs, which stand by their names as in `lag sensitivity`:
 *
 *     const char *const by[] = {"l", "theta.start"};
 *     lag_run_options options = {.tolerance = 1e-10, .start = &Pendulum_start};
 *     lag_run *run = lag_run_place(malloc(lag_run_size(&Pendulum_model, &options)), &Pendulum_model, &options);
 *     void *block = calloc(1, lag_run_sensitivities_size(&Pendulum_model, 2));
 *     lag_run_sensitivities *along = lag_run_sensitivities_place(block, &Pendulum_model, 2, by, NULL);
 *     lag_status status = lag_run_sensitivities_begin(along, run, 0.0, NULL, NULL);
 *     if (status == LAG_OK) status = lag_run_to(run, 10.0, 0);
 *     double dx[2][WIDTH];           lag_sensitivities_width(&Pendulum_model) numbers for each quantity
 *     if (status == LAG_OK) status = lag_run_sensitivities_get(along, run, run->stepper.t, run->stepper.x, dx[0]);
 *
 * lag_run_begin() is left out; everything else is as without them. lag/sensitivities/sensitivities.h has the mathematics. A run by a method of fixed step,
 * or of a model with delayed values, has none.
 */
#ifndef LAG_RUN_SENSITIVITIES_H
#define LAG_RUN_SENSITIVITIES_H

#include "lag/run.h"
#include "lag/sensitivities/sensitivities.h"

typedef struct lag_run_sensitivities {
    lag_sensitivities *columns;
    lag_results results; /* of a run that has none of its own */
    lag_note note;
    double *x;           /* (2 nq + nz) */
} lag_run_sensitivities;

/* Bytes of the block by so many quantities. */
size_t lag_run_sensitivities_size(const lag_model *model, size_t count);

/*
 * The layout of the block, which is zero and aligned as malloc does, by the quantities `by` (count): parameters, inputs, `theta.start`,
 * `der(theta).start`. Null: the model has none of such a name. `along` as in lag_sensitivities_place(); null: there are none.
 */
lag_run_sensitivities *lag_run_sensitivities_place(
    void *block, const lag_model *model, size_t count, const char *const *by, const lag_along *along);

/*
 * In place of lag_run_begin(run, t, NULL), with `set` and `values` (2 nq + nz; null: none) as lag_sensitivities_start() has them: start values that
 * count as written. LAG_NOT_SMOOTH: the start has no derivatives. LAG_PROJECTION_FAILED: there is no such state.
 */
lag_status lag_run_sensitivities_begin(
    lag_run_sensitivities *s, lag_run *run, double t, const unsigned char *set, const double *values);

/*
 * Derivatives (count, lag_sensitivities_width()) at a fixed time t of the coordinates, rates, states, discretes and outputs: at the present state of the
 * run, or at the state x at time t of which the functions `output` and `tell` of the run are told.
 */
lag_status lag_run_sensitivities_get(lag_run_sensitivities *s, lag_run *run, double t, const double *x, double *derivatives);

/* (count) derivatives of the time of the last instant: in `tell`, of what is told. */
const double *lag_run_sensitivities_of_time(const lag_run_sensitivities *s);

#endif
