/*
 * Does anything happen that the discretes w of a model do not know of yet? Relations that changed their truth, open contacts whose
 * gaps close further below zero, closed contacts that would pull. What follows from it is not said here.
 */
#ifndef LAG_ALERT_H
#define LAG_ALERT_H

#include "lag/motion.h"

/* Where in w and among the rows of constraints things stand: whole numbers, as doubles. */
typedef struct lag_alert_places {
    const double *truth;  /* (nindicator) entries of w */
    const double *strict; /* (nindicator) 1: the relation does not hold at zero */
    const double *closed; /* (ncontact) entries of w */
    const double *row;    /* (ncontact) rows of constraints */
} lag_alert_places;

typedef struct lag_alert {
    lag_motion *motion;
    lag_alert_places places;
    double *value, *speed, *jacobian, *laws; /* (most of nindicator and ngap) (ngap) (ngap, nq) (3 ncontact) */
} lag_alert;

/* Doubles for it. */
size_t lag_alert_memory(const lag_model *model);

void lag_alert_place(lag_alert *alert, lag_motion *motion, const lag_alert_places *places, double *memory);

/* LAG_HAPPENS if something happens at x at time t or happened before, with the discretes of `motion`. */
lag_status lag_alert_look(lag_alert *alert, double t, const double *x);

#endif
