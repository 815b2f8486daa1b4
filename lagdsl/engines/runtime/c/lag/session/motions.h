/* Several motions of one model, each with its own time, state, parameters, inputs and discretes: their rates in lanes. */
#ifndef LAG_MOTIONS_H
#define LAG_MOTIONS_H

#include "lag/equations/motion.h"
#include "lag/methods/attempts.h"
#include "lag/run/conditions.h"

typedef struct lag_motions {
    const lag_model *model;
    const lag_states *states;
    lag_arguments at;                 /* of all lanes */
    double *u, *w, *p;                /* (nu, lanes) (nw, lanes) (np, lanes) */
    double *lam, *pivot;              /* (nc, lanes) (lanes) */
    double smallest;                  /* pivot */
    lag_known_conditions known;       /* in lanes, at ends of attempts */
    double *value, *scale, *held, *t; /* (ni, lanes) (ni, lanes) (na, lanes) (lanes) of them */
    double *start, *size, *drift;     /* (ni, lanes) of lanes that go on without their runs: lag_conditions */
    const double *tolerance;          /* (ni) */
    lag_motion *of[LAG_ATTEMPT_LANES]; /* null: the lane is free */
    int prepared;                     /* for the parameters of all of them */
} lag_motions;

/* True if motions of `model`, whose functions of several states are `states` (or null), can be in lanes: elimination is all of their equations. */
int lag_motions_can(const lag_model *model, const lag_states *states);

/* Doubles for `motions`, and its layout; memory on a multiple of 64 bytes is faster. */
size_t lag_motions_memory(const lag_model *model, const lag_states *states);
void lag_motions_place(lag_motions *motions, const lag_model *model, const lag_states *states, double *memory);

/* Lane k is that of `motion` from now on, with its parameters as they are now. */
void lag_motions_enter(lag_motions *motions, size_t k, lag_motion *motion);

/* Inputs and discretes of all lanes as they are now. LAG_OK: the rates are those of lag_motion.ode, to the bit. */
lag_status lag_motions_take(lag_motions *motions);
lag_rates_in_lanes lag_motions_rates;

/*
 * The conditions that must hold, at the states that had their rates last: `broken` is 1 where a run has to be told. `known` becomes those of lane k,
 * until others are found.
 */
lag_ends_in_lanes lag_motions_monitor;
void lag_motions_conditions(const lag_motions *motions, size_t k, lag_known_conditions *known);

/* Lane k goes on without its run, whose conditions these are; the states found last count in lanes that are `accepted`; the run of lane k catches up. */
void lag_motions_open(lag_motions *motions, size_t k, const lag_conditions *conditions);
void lag_motions_count(lag_motions *motions, const double *accepted);
void lag_motions_close(const lag_motions *motions, size_t k, lag_conditions *conditions);

#endif
