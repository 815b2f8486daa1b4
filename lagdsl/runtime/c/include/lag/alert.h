/*
 * Does anything happen that the discretes w of a model do not know of yet? Relations that changed their truth, open contacts whose
 * gaps are negative and, if they were so before, close further, closed contacts that would pull. What follows from it is not said here.
 */
#ifndef LAG_ALERT_H
#define LAG_ALERT_H

#include "lag/discretes.h"
#include "lag/motion.h"

typedef struct lag_alert {
    lag_motion *motion;
    lag_places places;
    const double *slack; /* (2) a gap may be below zero by this part of 1 + the largest number of x, a force by this */
    double *g, *gap, *speed, *jacobian, *laws; /* (nindicator) (ngap) (ngap) (ngap, nq) (3 ncontact) */
    double *changed;                           /* (nindicator + ncontact) 1: this one, at the state looked at last */
    double *inside;                            /* (ncontact) 1: this gap was negative already when the step began */
    double *seen[3];                           /* (nindicator + ncontact) for those who look for the time */
    double *root, *found;                      /* the same */
} lag_alert;

/* Doubles for it. */
size_t lag_alert_memory(const lag_model *model);

void lag_alert_place(lag_alert *alert, lag_motion *motion, const double *slack, double *memory);

/* What passes zero, downward, when relation or contact number `which` changes; as it was looked at last. */
double lag_alert_value(const lag_alert *alert, size_t which);

/* A step begins at x at time t. */
lag_status lag_alert_begin(lag_alert *alert, double t, const double *x);

/* LAG_HAPPENS if something happens at x at time t or happened before, with the discretes of `motion`. */
lag_status lag_alert_look(lag_alert *alert, double t, const double *x);

#endif
