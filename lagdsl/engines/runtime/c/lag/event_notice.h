/* Notices of events: one call for each thing that happens at an event. */
#ifndef LAG_EVENT_NOTICE_H
#define LAG_EVENT_NOTICE_H

#include "lag/model.h"

typedef enum lag_event_kind {
    LAG_BEFORE,    /* an event begins: the state before it */
    LAG_TICK,      /* `which` is a clock, */
    LAG_TRUE,      /* a relation (entry of w from the first relation on) that brought the event about and holds now, */
    LAG_FALSE,     /* or holds no longer, */
    LAG_OPENED,    /* a contact, */
    LAG_CLOSED,    /* */
    LAG_IMPACT,    /* */
    LAG_REINIT,    /* a reset, */
    LAG_TERMINATE, /* a `terminate` */
    LAG_AFTER,     /* the event is over: the state after it */
    LAG_JUMP,      /* a whole number that time changes, of `floor` and its kind */
    LAG_SLIPS,     /* a friction: slip begins, */
    LAG_STICKS,    /* it ends, */
    LAG_REVERSES,  /* it changes its sense without rest */
    LAG_WARNING    /* an assertion of the level of warnings does not hold any more; behind all of the model, one of a clause */
} lag_event_kind;

typedef struct lag_event_notice {
    double t;
    lag_event_kind what;
    size_t which;
    size_t row;         /* number of the next row of a run */
    const double *x, *w; /* (2 nq + nz) (nw) the state now; of LAG_BEFORE and LAG_AFTER only it is a whole one */
} lag_event_notice;

/* The name of what something happened to: h <= 0, floor, der(h), a message; null for LAG_BEFORE and LAG_AFTER. */
const char *lag_event_notice_name(const lag_model *model, const lag_event_notice *notice);

/* Name of a kind of event. */
const char *lag_event_kind_name(lag_event_kind what);

#endif
