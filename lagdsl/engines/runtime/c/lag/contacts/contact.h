/*
 * Contacts of one run: open, impacting, closed.
 *
 * Each contact is judged by what enters its own gap. Its length is sum |dgap/dq_j| |q_j|, with the largest magnitudes so far: gaps are
 * zero to round-off of that; its speed is sum |dgap/dq_j| |qd_j|; its force is the one that would cancel the accelerations that the forces give
 * its own coordinates, with forces that act and those that would where positions change by as much as they are. So what does not enter a gap changes nothing, in whatever units and sizes.
 */
#ifndef LAG_CONTACT_H
#define LAG_CONTACT_H

#include "lag/impulses/impulse.h"

struct lag_frictions;

/* Sizes of the numbers that enter each contact (contact_scale.c). */
typedef struct lag_contact_sizes {
    double *peak, *least;    /* (2 nq + nz + nu) largest magnitudes of states and inputs so far; (nq) none is taken to be smaller: angles */
    double *force;           /* (ncontact) the largest that each had to carry, about */
    double *blow;            /* (ncontact) the largest terms of its rate in a blow so far */
} lag_contact_sizes;

/* Blows of one instant, and what they leave (contact_impacts.c, accumulation.c). */
typedef struct lag_blows {
    lag_inequalities rows;   /* of one of them */
    double *met;             /* (ncontact) contacts that were located as closing at this instant: they touch, wherever a projection moves their gaps */
    double *closing;         /* (ncontact) */
    double *approach;        /* (ncontact) speed at the first impact, zero without */
    double *before;          /* (ncontact) which contacts were closed before them */
    double *compliance;      /* (ncontact) what a unit impulse of each adds to its own speed, of the last blow in which it took part */
    double *back;            /* (ncontact) accelerations of gaps while they are open */
} lag_blows;

typedef struct lag_contacts {
    lag_motion *motion;      /* its w tells which contacts are closed */
    lag_impulse *impulse;    /* its arrays are used */
    struct lag_frictions *frictions; /* under them */
    lag_contact_sizes sizes;
    lag_blows blows;
    double length;           /* of the experiment [s] */
    double flight;           /* bounces that take less than two of these are none: steps of this length cannot tell them [s] */
    const double *limits;    /* (nc) constraints are satisfied to these; null: exactly */
    double *until;           /* (ncontact) bounces that were too short to follow last up to then; infinite: there are none */
    double *gap, *speed, *jacobian;       /* (ngap) (ngap) (ngap, nq) at the state evaluated last */
    double *restitution, *capture_speed, *zeno_time, *hidden; /* (ncontact) flights no higher than `hidden` are none */
    double *forces;          /* (nq) magnitudes of generalized forces */
    double *work;            /* (4 nq) */
} lag_contacts;

void lag_contacts_place(lag_contacts *contacts, lag_motion *motion, lag_layout *layout);

/* The motion passed through x, with the inputs that it has: magnitudes. */
void lag_contacts_follow(lag_contacts *contacts, const double *x);

/* Length and speed of a contact, at the state evaluated last. */
double lag_contacts_scale(const lag_contacts *contacts, size_t i);
double lag_contacts_pace(const lag_contacts *contacts, size_t i);

/* Round-off of a gap, and of a force, with these lengths and forces. */
double lag_contacts_gap_noise(const lag_contacts *contacts, size_t i);
double lag_contacts_force_noise(const lag_contacts *contacts, size_t i);

/* The start: flags (ncontact) in `closing` of contacts that touch and do not move apart. LAG_PENETRATION: gaps of those flagged in `pierced` are negative. */
lag_status lag_contacts_begin(lag_contacts *contacts, double t, const double *x, double *closing, double *pierced);

/* Opens closed contacts that do not touch or do not stay; at a `corner` of gaps, as in a valley, those driven in, too: they strike the other side. */
lag_status lag_contacts_open(lag_contacts *contacts, double t, const double *x, int corner);

/* 1: gaps of closed contacts have no rate beyond round-off. */
int lag_contacts_are_at_rest(lag_contacts *contacts, double t, const double *x);

/*
 * Impacts until nothing closes any more, first with those of contacts flagged in `met` and those of clauses: `collision` (ncollision flags, or null) with their `restitution`.
 * Closed contacts that are driven in take part without restitution, those that move apart afterwards open. Changes the rates in x and,
 * in w, contacts that are closed unless they pull, and their counts. LAG_EVENT_ITERATION_FAILED: impacts without end. LAG_NO_FORCES: no impulses satisfy the
 * law of friction.
 */
lag_status lag_contacts_impact(
    lag_contacts *contacts, double t, double *x, const double *collision, const double *restitution);

/* Sets the contacts that are closed behind these impacts, and those that are held, as their bounces accumulate. */
lag_status lag_contacts_accumulate(lag_contacts *contacts, double t, const double *x);

/* The gap of contact i, or behind them of a collision, as a row of a blow; compliances and terms of rates of one that was solved. */
void lag_contacts_add_to_blow(lag_contacts *contacts, size_t i, double restitution);
void lag_contacts_keep_blow(lag_contacts *contacts);

/* The first time up to which bounces last that were too short to follow; infinite without. */
double lag_contacts_end_of_bounces(const lag_contacts *contacts);

/*
 * LAG_PENETRATION, and flags in `pierced` (ncontact), if what has changed since the discretes were `before` (nw) and the state `was` makes a
 * gap negative, as the side of a step does. `gap` (ncontact) is for its use.
 */
lag_status lag_contacts_check_gaps(
    lag_contacts *contacts, double t, const double *x, const double *was, const double *before, double *gap, double *pierced);

/* Gaps where `motion` is. */
lag_status lag_contacts_evaluate(lag_contacts *contacts);

/* For the parts of it: the same at a state, forces by which pulls are told from round-off. */
lag_status lag_contacts_evaluate_at(lag_contacts *contacts, double t, const double *x);
lag_status lag_contacts_find_forces(lag_contacts *contacts, double t, const double *x);
/* A gap below this touches; a rate below this is round-off. */
double lag_contacts_gap_band(const lag_contacts *contacts, size_t i);
double lag_contacts_speed_band(const lag_contacts *contacts, size_t i);

static inline double *lag_contacts_flag(const lag_contacts *contacts, size_t i)
{
    return contacts->motion->w + contacts->motion->places.contact + i;
}

/* 1: contact i holds a rate on one side, as a freewheel does; its gap is zero. */
static inline int lag_contacts_is_one_way(const lag_contacts *contacts, size_t i)
{
    const unsigned char *one_way = contacts->motion->model->one_way;
    return one_way != NULL && one_way[i] != 0;
}

/* The component of the mechanism that gap i belongs to. */
static inline size_t lag_contacts_component(const lag_contacts *contacts, size_t i)
{
    const lag_model *model = contacts->motion->model;
    return lag_row_component(model, contacts->jacobian + i * model->nq);
}

/* 1: contact i was located as closing at this instant, or its gap is zero. */
static inline int lag_contacts_touches(const lag_contacts *contacts, size_t i)
{
    return contacts->blows.met[i] != 0.0 || contacts->gap[i] <= lag_contacts_gap_band(contacts, i);
}

static inline double lag_contacts_multiplier(const lag_contacts *contacts, size_t i)
{
    return contacts->motion->lam[contacts->motion->model->contact_rows[i]];
}

#endif
