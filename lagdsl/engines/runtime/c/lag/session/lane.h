/* One of the runs of an ensemble that are under way together in a thread, with its rows. */
#ifndef LAG_LANE_H
#define LAG_LANE_H

#include "lag/ensemble.h"

/* Rows and notes of a run before they are sorted. */
enum { LAG_LANE_ROWS = 16, LAG_LANE_NOTES = 64 };

/* The rows of one run that are kept. */
typedef struct lag_keeper {
    const lag_ensemble *ensemble;
    size_t width, next, kept; /* numbers of a row of the run; place of the time that is waited for; rows so far */
    double *rows;             /* (count, lag_ensemble_width()) */
} lag_keeper;

typedef struct lag_lane {
    lag_run_options options;
    lag_results results;
    lag_keeper kept;
    lag_note notes[LAG_LANE_NOTES];
    lag_initial told;
    lag_run *run;        /* null: there is none */
    size_t number;       /* of the run */
    int started;         /* it has a start */
    size_t breaks;       /* so many are behind it */
    double goal;         /* the next one, or the stop */
    size_t steps, left;  /* so far, and of the present piece */
    double *rows, *row_sizes, *starts, *x;
    unsigned char *dependent;
    void *block;         /* of the run */
} lag_lane;

/* Bytes of a lane beside the structure, and its layout there. */
size_t lag_lane_size(const lag_ensemble *ensemble);
void lag_lane_place(lag_lane *own, const lag_ensemble *ensemble, void *bytes);

/* Run i begins; *ended: no step follows. */
lag_status lag_lane_begin(lag_lane *own, const lag_ensemble *ensemble, size_t i, int *ended);
/* One step, and on to where the next one begins; *ended: there is none. LAG_TOO_LONG: as many steps as allowed. */
lag_status lag_lane_step(lag_lane *own, const lag_ensemble *ensemble, int *ended);
/* The run has ended, or failed. */
void lag_lane_end(lag_lane *own, const lag_ensemble *ensemble, lag_status status);

#endif
