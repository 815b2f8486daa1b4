/*
 * One motion of a model for callers that know numbers and addresses only: a web page over WebAssembly, another language.
 *
 *     lag_status status = lag_tape_check(bytes, count, &memory);              (lag/tape.h; or a model of compiled C)
 *     const lag_model *model = lag_tape_model(bytes, count, memory_for_it);
 *     lag_session *session = lag_session_place(block, model, lag_tape_start(model), 1e-6, 10.0);
 *     status = lag_session_begin(session, 0.0);
 *     status = lag_session_to(session, 0.02, 1000); ... lag_session_row(session)
 *
 * Everything lies in the one block that the caller gives.
 */
#ifndef LAG_SESSION_H
#define LAG_SESSION_H

#include "lag/run.h"

typedef struct lag_session lag_session;

/* Bytes of the block, on an address that is a multiple of 16. `start` may be null, as in lag/run.h. */
size_t lag_session_size(const lag_model *model, const lag_start *start);

/* `tolerance` and `length` [s] as in lag_run_options. Parameters and inputs are the defaults. */
lag_session *lag_session_place(void *block, const lag_model *model, const lag_start *start, double tolerance, double length);

/* (np) to be changed before lag_session_begin(), which may be called again. */
double *lag_session_parameters(lag_session *session);

/* (nu) to be changed before lag_session_begin(). */
double *lag_session_inputs(lag_session *session);

/*
 * (nc) to be changed before lag_session_begin(): 0 for rows of constraints that come and go. Rows of contacts are 0 already;
 * the model does not tell rows of velocity level that discretes switch.
 */
double *lag_session_lasting(lag_session *session);

/* From the start of the model at time t [s]; LAG_PROJECTION_FAILED: there is no such state. */
lag_status lag_session_begin(lag_session *session, double t);

/* On to time t, in at most so many steps (0: without bound), as lag_run_to(). */
lag_status lag_session_to(lag_session *session, double t, size_t most_steps);

/* The present state as a row of lag/run/results.h: time, coordinates, rates, states, discrete variables, outputs, energy, residuals. */
const double *lag_session_row(lag_session *session);

/*
 * Things that happened during the last lag_session_begin() or _to(): their number, then t, lag_event_kind and `which` of the first
 * LAG_SESSION_EVENTS of them, as in lag/event_notice.h.
 */
#define LAG_SESSION_EVENTS 64
const double *lag_session_events(const lag_session *session);

/*
 * Why a call ended with `status`: `which` of lag_fault. Where events are to blame, -1, and lag_session_guilty() flags the discrete
 * variables (nw) whose changes led there.
 */
int lag_session_fault(lag_session *session, lag_status status);
const double *lag_session_guilty(const lag_session *session);

/* Numbers of a row. */
size_t lag_session_width(const lag_session *session);

/*
 * The motion is differentiated from the next lag_session_begin() on, by parameters and, behind them, inputs of these numbers (count), which must stay:
 * in a block of so many bytes, on an address that is a multiple of 16 (lag/sensitivities/run_sensitivities.h). lag_session_begin() and lag_session_to()
 * return LAG_GRAZING and LAG_NOT_SMOOTH, too.
 */
size_t lag_session_sensitivities_size(const lag_model *model, size_t count);
void lag_session_differentiate(lag_session *session, void *block, size_t count, const unsigned *which);

/* Derivatives (count, width) of the present row at a fixed time, in the block; there, time, energy and residuals are 0. Null: there are none. */
const double *lag_session_derivatives(lag_session *session);

#endif
