/*
 * Rows and events of a run, in buffers of the caller: a row at every requested time, two rows at an event (before it and after it; one of
 * them alone where the other one is there already), and a note of each event.
 *
 * A row is t, x (2 nq + nz), the discrete variables, the outputs (ny), energy() [J], and the largest residuals of the constraints of
 * position level and of velocity level, in the units of their rows; the last three are not written where rows are `bare`. Outputs that are known up to whole turns are as the run counts them (lag/run/turns.h).
 */
#ifndef LAG_RESULTS_H
#define LAG_RESULTS_H

#include "lag/event_notice.h"

struct lag_run;
struct lag_cause;

/*
 * A companion goes with a motion along its way, as its sensitivities do. It is told of each step, which it may take back for a shorter one
 * (LAG_TOO_LONG); of a time within the step to which the run goes back; of instants, which it carries out itself by lag_run_carry(), and of their
 * ends; of the numbers of rows and notes in their buffers; of the time up to which the last step becomes the past of delayed values. Any other status than LAG_OK ends the run.
 */
typedef struct lag_companion {
    lag_status (*step)(struct lag_run *run);
    lag_status (*back)(struct lag_run *run, double t);
    lag_status (*instant)(struct lag_run *run, const struct lag_cause *cause);
    void (*after)(struct lag_companion *companion);
    lag_status (*row)(struct lag_run *run, size_t row, double t, const double *x);
    void (*note)(struct lag_companion *companion, size_t note);
    lag_status (*past)(struct lag_run *run, double t);
} lag_companion;

typedef struct lag_note {
    double t;
    lag_event_kind what;
    size_t which;
} lag_note;

typedef struct lag_results {
    size_t most_rows, most_notes; /* room, at least one of each */
    double *rows;                 /* (most_rows, lag_results_width()) */
    lag_note *notes;              /* (most_notes) */
    /* Called when one of both is full: empties them. Any status that it returns but LAG_OK ends the run. */
    lag_status (*full)(void *context, struct lag_results *results);
    void *context;
    size_t row, note;             /* how many of them are filled */
    int any;                      /* 1: there was a row, */
    double last, after;           /* the times of the last row and of the last one after an event */
    int bare;
    lag_companion *companion; /* null: there is none */
    struct lag_extremes *extremes; /* lowest and highest values of everything, of the motion itself; null: not wanted */
} lag_results;

/* Numbers of a row. */
size_t lag_results_width(const lag_model *model);

/* A row of the state x at time t, with the present discretes; outputs that do not exist are no numbers. */
lag_status lag_results_row(lag_results *results, struct lag_run *run, double t, const double *x);

/* The same, unless there is a row of this time. */
lag_status lag_results_at(lag_results *results, struct lag_run *run, double t, const double *x);

/* The last state of a run that fails there: only behind a first row, and not twice. */
lag_status lag_results_end(lag_results *results, struct lag_run *run, double t, const double *x);

/* A step of the run was accepted, up to time t. */
lag_status lag_results_step(lag_results *results, struct lag_run *run, double t);

/* Records an event: a row or a note. */
lag_status lag_results_record_event(lag_results *results, struct lag_run *run, const lag_event_notice *notice);

#endif
