/*
 * Contacts of one run: open, impacting, closed. A contact closes when it rebounds slowly, or when what is left of a series of impacts is
 * short: with the last interval dt between impacts and the ratio r of rebound speeds the rest of a geometric series is dt r/(1 - r).
 */
#ifndef LAG_CONTACT_H
#define LAG_CONTACT_H

#include "lag/impact.h"

typedef struct lag_contacts {
    lag_motion *motion;      /* its w tells which contacts are closed */
    lag_places places;
    lag_impact impact;
    double length;           /* of the experiment [s] */
    double flight;           /* bounces that take less than this are none: steps of fixed length cannot tell them [s] */
    double force;            /* the largest that a contact had to carry, about */
    double slack[2];         /* what is round-off: of gaps, as a part of 1 + the largest number of x, and of forces */
    double *fastest, *last;  /* (ncontact) approach speed so far, time of the last impact */
    double *gap, *speed, *jacobian;       /* (ngap) (ngap) (ngap, nq) at the state looked at last */
    double *restitution, *stick, *rest;   /* (ncontact) */
    double *approach;        /* (ncontact) of lag_contacts_strike: speed at the first impact, zero without, */
    double *order;           /* (ncontact) those that struck, in the order in which they did, */
    size_t struck;           /* so many, */
    double *before;          /* (ncontact) which contacts were closed before it */
    double *closing;         /* (ncontact) */
    double *slow;            /* (ncontact) speeds below which they stay together */
    double *part, *rows, *speeds, *factor; /* (ngap) (ngap, nq) (ngap) (ngap) of one impact */
    double *tau, *zero;      /* (nq) (nq) */
} lag_contacts;

/* Doubles for them. */
size_t lag_contacts_memory(const lag_model *model);

void lag_contacts_place(lag_contacts *contacts, lag_motion *motion, double *memory);

/* Size of a state: gaps and their rates are told from zero against it. */
double lag_contacts_size(const lag_motion *motion, const double *x);

/* Whether any gap is negative; flags (ncontact) of those that are. */
int lag_contacts_pierced(lag_contacts *contacts, double t, const double *x, double *flags);

/* At the start: contacts that touch and do not move apart are closed unless they pull. */
lag_status lag_contacts_settle(lag_contacts *contacts, double t, const double *x);

/* Closes those of the candidates (ncontact flags) that do not pull: the one that pulls most opens until none does. */
void lag_contacts_press(lag_contacts *contacts, double t, const double *x, const double *candidates);

/* Opens closed contacts that do not touch or do not stay. */
lag_status lag_contacts_part(lag_contacts *contacts, double t, const double *x);

/*
 * Impacts until nothing closes any more, first with those of clauses: `collision` (ncollision flags, or null) with their `restitution`.
 * Closed contacts that are driven in take part without restitution, those that move apart afterwards, or would pull, open. Changes the rates in x and,
 * in w, contacts and their counts. LAG_UNSETTLED: impacts without end.
 */
lag_status lag_contacts_strike(
    lag_contacts *contacts, double t, double *x, const double *collision, const double *restitution);

#endif
