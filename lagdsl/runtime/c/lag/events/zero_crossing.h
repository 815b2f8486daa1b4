/*
 * Detects changes that are not in the discretes w of a model yet: relations whose truth changes, open contacts with negative
 * gaps, closed contacts that would pull, friction that comes to rest or breaks loose. Each has a value that is positive while nothing changes; if it was negative already
 * when the step began, or is so by no more than round-off, it must fall further. lag/events/instant.h carries out the
 * changes. Corners are values of the same kind, on request only: the discretes do not contain them.
 */
#ifndef LAG_ZERO_CROSSING_H
#define LAG_ZERO_CROSSING_H

#include "lag/events/friction.h"
#include "lag/events/noise.h"
#include "lag/linalg/minimum.h"

typedef struct lag_zero_crossing {
    lag_motion *motion;
    lag_places places;
    lag_contacts *contacts;
    lag_frictions *frictions;
    lag_noise *noise;
    double *g, *gap, *speed, *jacobian, *laws; /* (nindicator) (ngap) (ngap) (ngap, nq) (3 ncontact) */
    double *far, *side;            /* (ncorner) distances of corners, 1 or -1: the side on which this one is positive, 0: not looked at */
    double *beside;                /* (ncorner) flags: the motion is just there */
    size_t corners;                /* ncorner where corners are looked at, else 0 */
    int solved;                    /* they read accelerations or multipliers */
    double *changed;               /* (nindicator + ncontact + nfriction + ncorner) 1: this one, at the state looked at last */
    double *depth;                 /* the same: how far below zero values were where they began, though nothing had changed */
    double *band;                  /* the same: how far below zero they may be: their depth, round-off, and the creep of what rests */
    double *start, *moved;         /* the same: values where they began, and their largest difference from that since */
    double *creep;                 /* (nindicator + ncorner) so fast they may creep at rest; zero: nobody has asked since the step began */
    double tolerance;              /* of the motion, relative */
    double *hovers;                /* (nindicator) flags: it has turned, and has been no farther from zero since than the motion is known */
    double *doubted;               /* (nindicator) first time at which it turned again while it hovered: by the method's error, perhaps; infinite: none */
    int locating;                  /* values change as soon as they leave their depth and round-off: what crept before they were seen does not count */
    double *seen[LAG_LOOKS];       /* the same: values, for those who look for the time */
    double *root, *found;          /* the same */
    double since;                  /* time at which the step began */
    double *when;                  /* (nindicator) time of the last change that was found */
    double span, reach;            /* values were known over so long a piece; the next one is as long as this [s]; 0: not yet */
    double limit;                  /* the first piece behind a change of a relation is no longer than this [s] */
} lag_zero_crossing;

/* So many guards of a model, without corners: relations, contacts, friction, in this order. */
static inline size_t lag_guards(const lag_model *model)
{
    return model->nindicator + model->ncontact + model->nfriction;
}

/* Doubles for it. */
size_t lag_zero_crossing_memory(const lag_model *model);

void lag_zero_crossing_place(lag_zero_crossing *crossings, lag_motion *motion, lag_frictions *frictions, lag_noise *noise, double *memory);

/* So many things are looked at: relations, contacts, corners. */
size_t lag_zero_crossing_count(const lag_zero_crossing *crossings);

/* Value that passes zero downward when relation, contact or corner number `which` changes; that of the last look. */
double lag_zero_crossing_value(const lag_zero_crossing *crossings, size_t which);

/* Round-off of that, as far as it is known. */
double lag_zero_crossing_noise(const lag_zero_crossing *crossings, size_t which);

/* True if lag/events/noise.h finds that round-off: contacts have bounds of their own. */
int lag_zero_crossing_has_noise(const lag_zero_crossing *crossings, size_t which);

/* So fast relations and corners at rest may creep, by what they do at x at time t in `span` [s]. */
void lag_zero_crossing_creep(lag_zero_crossing *crossings, double t, const double *x, double span);

/* True if a relation that hovers, or a corner, has rested at zero from where the step began to the last look, but for round-off and creep. */
int lag_zero_crossing_rests(const lag_zero_crossing *crossings, size_t which);

/* A value nearer to zero than this is zero, as far as the motion is known. */
double lag_zero_crossing_known(const lag_zero_crossing *crossings, size_t which);

/* A step begins at x at time t, or an event has ended there. */
lag_status lag_zero_crossing_begin(lag_zero_crossing *crossings, double t, const double *x);

/* LAG_EVENT_PENDING if something happens at x at time t or happened before, with the discretes of `motion`. */
lag_status lag_zero_crossing_look(lag_zero_crossing *crossings, double t, const double *x);

/*
 * Widens the bands of relations that the last look, at x at time t, saw change, so that a change within round-off counts as
 * none, but for values that are zero itself and were clearly not `from` (before, or null), as one that `limit` ends at its border.
 * Returns 1 if another look is needed.
 */
int lag_zero_crossing_widen(lag_zero_crossing *crossings, double t, const double *x, const double *from);

#endif
