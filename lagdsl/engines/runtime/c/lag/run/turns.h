/*
 * Outputs that the model knows up to whole turns (lag_model.turn()), counted along the motion: at every step of the method, and within a
 * step as often as it takes for the rates to tell the turns. A unit quaternion, which is known up to its sign, is followed in the same way.
 */
#ifndef LAG_TURNS_H
#define LAG_TURNS_H

#include "lag/model.h"

struct lag_run;

typedef struct lag_turns {
    double *at;           /* (1) the time up to which they are counted; no number before the first one */
    double *value, *rate; /* (nturn) there */
    double *now, *pace;   /* (nturn) at another time */
    double *size, *entry; /* (nturn) turns; the outputs that they are */
    double *counted;      /* (ny) flags of these outputs; null where there are none */
    double *inside;       /* (2 nq + nz) a state within the step */
} lag_turns;

size_t lag_turns_memory(const lag_model *model);
void lag_turns_place(lag_turns *turns, const lag_model *model, double *memory);

/* Forgets what was counted: outputs begin near their start values. */
void lag_turns_clear(lag_turns *turns);

/* Counts from where they are counted up to the state x at time t, which is a later one or the present one after an event. */
lag_status lag_run_count_turns(struct lag_run *run, double t, const double *x);

/* The same up to what happens first in the last step. */
lag_status lag_run_count_step(struct lag_run *run);

/* Of all values that outputs (ny) may have, those nearest to what was counted last; what is no number stays so. */
void lag_run_unwind(const struct lag_run *run, double *outputs);

#endif
