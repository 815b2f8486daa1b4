/*
 * The lowest and the highest value of everything that rows hold, along the motion itself: at steps, at events, at rows, and of the state
 * between steps, on the dense output. And how often numbers of the state turn around, which tells how many rows show that.
 */
#ifndef LAG_EXTREMES_H
#define LAG_EXTREMES_H

#include "lag/model.h"

struct lag_run;

typedef struct lag_extremes {
    size_t size, count;  /* numbers of the state; of it, of the discrete variables and of the outputs */
    double *low, *high;  /* (count) infinite where nothing was seen */
    double *turns;       /* (size) how often a number turned around by more than a part of its range */
    double *pivot, *way; /* (size) where it turned last, or has got to; 1 up, -1 down, 0 not known */
    double *sample;      /* (LAG_SAMPLES + 1, size) states within a step */
    double *outputs;     /* (ny) */
} lag_extremes;

enum { LAG_SAMPLES = 8 };

/* Doubles for it. */
size_t lag_extremes_memory(const lag_model *model);

void lag_extremes_place(lag_extremes *extremes, const lag_model *model, double *memory);

/* Values of a row: state, discrete variables, outputs. Values that are not numbers do not count. */
void lag_extremes_row(lag_extremes *extremes, const double *values);

/* The last step of the run, as far as time t. */
lag_status lag_extremes_step(lag_extremes *extremes, struct lag_run *run, double t);

/* Outputs (ny) at the end of a step. */
void lag_extremes_outputs(lag_extremes *extremes, size_t ny, const double *outputs);

#endif
