/*
 * Dry friction of one run. Each friction is in one of three modes: it sticks, its slip is held at zero by rows of the constraints; it slides, with its
 * limit against its slip; it is off, as the contact under which it acts is open. `sticks` and `direction` in w tell them: 1 and 0; 0 and the sense of
 * the slip; 0 and 0. The direction of a slip in a plane is that of the slip itself; `direction` is a speed too small to count, which tells where the
 * slip leads as long as it is zero.
 *
 * Source: Glocker, Set-Valued Force Laws (2001), chapter 5.
 */
#ifndef LAG_FRICTION_H
#define LAG_FRICTION_H

#include "lag/contacts/contact.h"

typedef struct lag_frictions {
    lag_motion *motion;
    lag_contacts *contacts;    /* the largest rates so far are theirs */
    double *first;             /* (nfriction) the first component of the slip of each */
    double *slip, *jacobian;   /* (nslip) (nslip, nq) at the state evaluated last, */
    double *reference;         /* (nslip) slips where the step began: a slip in a plane ends where it has no part along them, */
    double *fast;              /* (nslip) the largest terms of each slip so far, */
    double *compliance;        /* (ncontact + nfriction) the acceleration of each gap and slip for a unit force of its own, */
    double *push;              /* (nq + nz) by component: the largest by forces that balanced others, whose round-off adds up in a step */
    double step;               /* of this length [s]; */
    double *limit, *sticking;  /* (nfriction) what friction bears while it slides, and while it sticks, */
    double *gain, *sticking_gain; /* (nfriction, nc) and how that changes with multipliers */
    double *force;             /* (nfriction) the largest limit so far */
    double *reserve;           /* (ncontact + nfriction) what lag/contacts/reserve.h finds where forces are undetermined; else no numbers */
} lag_frictions;

void lag_frictions_place(lag_frictions *frictions, lag_motion *motion, lag_contacts *contacts, lag_layout *layout);

/* Slips and limits at the state at which `motion` was evaluated last, with its accelerations and multipliers. */
lag_status lag_frictions_evaluate(lag_frictions *frictions);

/* Adds friction k to a problem of rates or accelerations, as `slip` (components) with its rows (components, nq); `gain` (nc): its limit by multipliers. */
void lag_frictions_add(const lag_frictions *frictions, lag_inequalities *rows, size_t k, const double *jacobian, const double *slip, const double *gain);

/* A step begins at the state that was evaluated last. */
void lag_frictions_begin(lag_frictions *frictions);

/* 1: the slip of friction k in a plane has turned away from where it led, but not ended. */
int lag_frictions_turns(const lag_frictions *frictions, size_t k);

/* 1: it acts; 0: it is off, as its contact is open. */
int lag_frictions_acts(const lag_frictions *frictions, size_t k);

/*
 * Guard of friction k, positive while its mode lasts: what it bears beyond its force while it sticks; its slip, in the sense of its direction, while it
 * slides; infinite while it is off. Its dead band, and the size of the numbers that enter it.
 */
double lag_frictions_guard(const lag_frictions *frictions, size_t k);
double lag_frictions_dead_band(const lag_frictions *frictions, size_t k);
double lag_frictions_size(const lag_frictions *frictions, size_t k);

/* The length of slip k, and below which it is zero. */
double lag_frictions_speed(const lag_frictions *frictions, size_t k);
double lag_frictions_speed_band(const lag_frictions *frictions, size_t k);

static inline double *lag_frictions_sticks(const lag_frictions *frictions, size_t k)
{
    return frictions->motion->w + frictions->motion->places.sticks + k;
}

/* The components of its direction in w. */
static inline double *lag_frictions_direction(const lag_frictions *frictions, size_t k)
{
    return frictions->motion->w + frictions->motion->places.direction + (size_t)frictions->first[k];
}

static inline size_t lag_frictions_components(const lag_frictions *frictions, size_t k)
{
    return frictions->motion->model->friction_slips[k];
}

/* The length of the components of an array (nslip) that belong to friction k. */
double lag_frictions_length(const lag_frictions *frictions, const double *array, size_t k);

/* The length of its force while it sticks. */
double lag_frictions_force(const lag_frictions *frictions, size_t k);

#endif
