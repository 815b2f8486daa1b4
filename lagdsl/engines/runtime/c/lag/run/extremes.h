/*
 * The lowest and the highest value of everything that rows hold, along the motion itself: at steps, at events, at rows, and of the state
 * and the outputs between steps, on the dense output. And how often numbers of the state turn around, which tells how many rows show
 * that.
 */
#ifndef LAG_EXTREMES_H
#define LAG_EXTREMES_H

#include "lag/model.h"
#include "lag/stepper.h"

struct lag_run;

typedef struct lag_extremes {
    size_t size, count;  /* numbers of the state; of it, of the discrete variables and of the outputs */
    double *low, *high;  /* (count) infinite where nothing was seen */
    double *turns;       /* (size) how often a number turned around by more than a part of its range */
    double *pivot, *way; /* (size) where it turned last, or has got to; 1 up, -1 down, 0 not known */
    double *sample;      /* (LAG_SAMPLES + 1, size) states within a step */
    double *outputs;     /* (LAG_SAMPLES + 2, ny) outputs within a step; those of one more state */
    double *passed;      /* (LAG_PASSED, ny) outputs of states that the method evaluates anyway */
    double *when;        /* (LAG_PASSED) their times; no number: not told */
    size_t searched;     /* states that were looked at for outputs that few of them do not show */
} lag_extremes;

enum { LAG_SAMPLES = 8 };

/* Doubles for it. */
size_t lag_extremes_memory(const lag_model *model);

void lag_extremes_place(lag_extremes *extremes, const lag_model *model, double *memory);

/* Values of a row: state, discrete variables, outputs. Values that are not numbers do not count. */
void lag_extremes_row(lag_extremes *extremes, const double *values);

/* The state that `run` evaluated last lies at this place of a step. */
void lag_extremes_pass(lag_extremes *extremes, struct lag_run *run, unsigned place, double t);

/* The last step of the run, as far as time t, up to which turns are counted. Outputs that are counted are seen at its end only. */
lag_status lag_extremes_step(lag_extremes *extremes, struct lag_run *run, double t);

/* For its own files: a value of number i was seen; outputs within the last step, as far as time t. */
void lag_extremes_include(lag_extremes *extremes, size_t i, double value);
void lag_extremes_outputs(lag_extremes *extremes, struct lag_run *run, double t);

#endif
