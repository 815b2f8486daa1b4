/*
 * Guards between instants: relations, gaps of open contacts, forces of closed ones, friction that comes to rest or breaks loose. Each has a value that is
 * positive while its mode lasts. It leaves its mode below its dead band: its rounding error, below where it was when the step began if that was below zero.
 * A relation that the rows of its mode hold does not move, and is not watched. lag/events/instant.h carries out the changes. Corners are guards on request
 * only: the discretes do not contain them.
 */
#ifndef LAG_GUARDS_H
#define LAG_GUARDS_H

#include "lag/contacts/reserve.h"
#include "lag/equations/projection.h"
#include "lag/events/noise.h"
#include "lag/linalg/minimum.h"

/* Corners, where they are looked at (run_corners.c). */
typedef struct lag_corners {
    size_t count;                  /* ncorner, or 0 */
    double *far;                   /* (ncorner) distances */
    double *side;                  /* (ncorner) 1 or -1: the side on which this one is positive, 0: not looked at */
    int solved;                    /* they read accelerations or multipliers */
    double reach;                  /* samples of a step that is no longer tell the shape of distances [s]; 0: not yet */
} lag_corners;

/* Values on pieces of a step, for those who look for the time of a change (run_scan.c). */
typedef struct lag_pieces {
    double *seen;                  /* (nindicator + ncontact + nfriction + ncorner, LAG_PIECE_SAMPLES) values */
    double *root, *found, *sought; /* (nindicator + ncontact + nfriction + ncorner) */
    double *when;                  /* (nindicator) time of the last change that was found */
    double reach;                  /* the next piece is as long as this [s]; 0: not known yet */
    double limit;                  /* the first piece behind a change of a relation is no longer than this [s] */
} lag_pieces;

typedef struct lag_guards {
    lag_motion *motion;
    lag_contacts *contacts;
    lag_frictions *frictions;
    lag_reserve *reserve;
    lag_noise *noise;
    double *g;                     /* (nindicator) */
    lag_corners corners;
    lag_pieces pieces;
    double *value;                 /* (nindicator + ncontact + nfriction + ncorner) of guards at the state evaluated last; 1 where one is held */
    double *changed;               /* the same: 1: this one has left its mode there */
    double time;                   /* of which `changed` tells; nan: of none */
    double *depth;                 /* the same: how far below zero values were where the step began */
    double *band;                  /* the same: dead bands, as they were found when they were needed first since then; zero: not yet */
    double *top;                   /* the same: the largest values since then */
    const double *sought;          /* the same: flags of those of which `value` and `changed` tell; null: of all */
    double *held;                  /* (nindicator) flags: the rows of the mode hold it */
    double *swing;                 /* (nindicator) largest magnitude since it turned last; infinite: it has not turned */
    double *doubted;               /* (nindicator) first time at which it turned by the method's error, perhaps; infinite: none */
} lag_guards;

/* So many guards of a model, without corners: relations, contacts, friction, in this order. */
static inline size_t lag_guard_count(const lag_model *model)
{
    return model->nindicator + model->ncontact + model->nfriction;
}

/* Values of one of them at the places of a piece. */
static inline double *lag_guards_seen(const lag_guards *guards, size_t which)
{
    return guards->pieces.seen + which * LAG_PIECE_SAMPLES;
}

/* Lays them out; arrays of a new layout are zero. */
void lag_guards_place(lag_guards *guards, lag_motion *motion, lag_reserve *reserve, lag_noise *noise, lag_layout *layout);

/* So many guards are watched: relations, contacts, friction, corners. */
size_t lag_guards_count(const lag_guards *guards);

/* True if that value hardly gets behind zero, as that of a slip in a plane, which turns round there. */
int lag_guards_touches(const lag_guards *guards, size_t which);

/* Rounding error of that, as far as it is known. */
double lag_guards_noise(const lag_guards *guards, size_t which);

/* True if lag/events/noise.h finds it: contacts and friction have bounds of their own. */
int lag_guards_has_noise(const lag_guards *guards, size_t which);

/* A guard nearer to zero than this is zero, as far as the tolerance lets the motion be known. */
double lag_guards_known(const lag_guards *guards, size_t which);

/* A step begins at x at time t, or an event has ended there. */
lag_status lag_guards_begin(lag_guards *guards, double t, const double *x);

/* LAG_EVENT_PENDING if a guard has left its mode at x at time t, with the discretes of `motion`. */
lag_status lag_guards_detect(lag_guards *guards, double t, const double *x);

#endif
