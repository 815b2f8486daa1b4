/*
 * A run in the hands of its caller: it goes on by steps, and between two of them inputs change. Over a step an input is held, so it jumps where
 * the next step begins; other inputs follow time, as tables or the caller tell them.
 *
 *     lag_hold hold = {.count = model->nu, .u = u, .before = before};
 *     lag_run_options options = {.callbacks = {.inputs = lag_hold_tell, .context = &hold}};
 *     hold.run = lag_run_place(block, model, &options);
 *     status = lag_run_begin(hold.run, 0.0, NULL);
 *     u[0] = 1.0; status = lag_hold_step(&hold, 0.01, 0); ...
 */
#ifndef LAG_HOLD_H
#define LAG_HOLD_H

#include "lag/run.h"
#include "lag/signals.h"

typedef struct lag_hold {
    lag_run *run;
    double *u, *before;         /* (count) inputs from the next step on, which the caller changes; up to then. Equal where the run begins */
    const lag_signals *signals; /* tables of those that follow time; null: none does */
    void *context;              /* of `inputs` */
    const double *at;           /* (breaks) ascending: the times at which these may jump */
    size_t count, breaks;
    lag_inputs *inputs;         /* tells the caller's functions of time and leaves all others as they are; null: there are none */
    int rows;                   /* 1: the results of the run get a row at the end of every step; 0: they are those of one step, empty as it begins */
    double goal;                /* [s] the end of the last step, */
    double jumped;              /* and the last time at which an input jumped; not a number before the first one */
} lag_hold;

/* A lag_inputs; its context is a lag_hold. */
void lag_hold_tell(void *context, double t, int before, double *u);

/*
 * Changes by inputs that jump now (lag_run_jump), if any has changed. The functions below call it where a step begins; it is for callers who
 * make steps by lag_run_to().
 */
lag_status lag_hold_jump(lag_hold *hold);

/*
 * One step of length h, or to time t, in at most so many steps of the method (0: without bound). Ends of steps of one length are counted, so
 * that nothing adds up, and one that is a tick but for round-off is that tick. After LAG_TOO_LONG lag_hold_go() makes the rest of the step.
 */
lag_status lag_hold_step(lag_hold *hold, double h, size_t most_steps);
lag_status lag_hold_to(lag_hold *hold, double t, size_t most_steps);
lag_status lag_hold_go(lag_hold *hold, size_t most_steps);

/*
 * The same of many, one after the other, to `status` (count). A run stays where it is if its status is not LAG_OK, or, of lag_holds_go(),
 * not LAG_TOO_LONG. Threads share them: each takes others.
 */
void lag_holds_step(lag_hold *const *holds, size_t count, double h, size_t most_steps, int *status);
void lag_holds_to(lag_hold *const *holds, size_t count, double t, size_t most_steps, int *status);
void lag_holds_go(lag_hold *const *holds, size_t count, size_t most_steps, int *status);

/* The present time and state x (2 nq + nz) of each, into `states` (count, 1 + 2 nq + nz). */
void lag_holds_state(const lag_hold *const *holds, size_t count, double *states);

/* The present state of each as a row of lag/run/results.h, into `rows` (count, lag_results_width()). */
void lag_holds_row(lag_hold *const *holds, size_t count, double *rows);

#endif
