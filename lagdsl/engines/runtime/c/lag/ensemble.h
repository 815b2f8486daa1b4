/*
 * An ensemble: runs of one model that share everything but parameters, constant inputs and start values. Each is what it is alone, to
 * the bit: the start is found (lag/initial.h), the motion goes on to the stop with everything that happens, the end is told.
 *
 * Threads share an ensemble: each makes other runs of it, in memory of its own. Nothing is allocated per run.
 */
#ifndef LAG_ENSEMBLE_H
#define LAG_ENSEMBLE_H

#include <stdatomic.h>

#include "lag/initial.h"
#include "lag/parallel.h"
#include "lag/run.h"

/* Results of the runs, one after the other. */
typedef struct lag_ensemble_results {
    double *rows;  /* (runs, options.count, lag_ensemble_width()) at the times of options; of two rows at an event the one after it */
    size_t *kept;  /* (runs) how many rows there are */
    double *ended; /* (runs) the time of the last row, at whatever time */
    int *status;   /* (runs) a lag_status; LAG_STOPPED: a `terminate` acted. Others: the run failed, after these rows */
    double *found; /* (runs, np) parameters, with those that were found with the start; null: not wanted */
} lag_ensemble_results;

typedef struct lag_ensemble {
    const lag_model *model;
    const lag_states *states; /* of the model: runs go on together, to the same bits, where it permits that; null: one after the other */
    /* Of all runs, with a `start`; p, u, natural sizes, sizes of rows and results of it are not looked at. `times` are those of the rows. */
    const lag_run_options *options;
    double t, stop;
    size_t breaks;    /* so many times between them at which inputs may jump, */
    const double *at; /* (breaks) ascending */
    /* The method starts again after so many steps at first, then each time after so many, as lag_run_to() does; so many steps in all. */
    size_t first_piece, piece, most_steps;
    int equations;               /* 0: initial equations are left out */
    const unsigned char *set;    /* (2 nq + nz) 1: start values that are given, and count as written; null: none is */
    const atomic_int *stopped;   /* becomes 1 where no more runs are wanted; null: they are */

    /* Of every run, one after the other. */
    const double *p;       /* (runs, np) */
    const double *u;       /* (runs, nu) constant inputs, and the others until callbacks of options tell them; null: they tell all */
    const double *natural; /* (runs, 2 nq + nz) */
    const double *x;       /* (runs, 2 nq + nz) start values that are given */
    lag_ensemble_results results;

    /*
     * Told of run i that failed, by the thread that makes it, as long as the run is there: start values (2 nq + nz), where the search for a
     * start from them ended, and `told` of it, or null where there was a start and the motion failed. Null: nobody asks.
     */
    void (*failed)(void *context, size_t i, lag_run *run, int status, const double *starts, const double *x, const lag_initial *told);
    void *context;
} lag_ensemble;

/* Numbers of a row: x (2 nq + nz), the discrete variables, the outputs (ny). */
size_t lag_ensemble_width(const lag_model *model);

/* Bytes for one thread, on an address as malloc gives it. */
size_t lag_ensemble_size(const lag_ensemble *ensemble);

/* The runs from `first` to before `end`. The number of the first one that was not made: `end`, unless it was stopped. */
size_t lag_ensemble_run(const lag_ensemble *ensemble, size_t first, size_t end, void *block);

#endif
