/* Passes over the clauses of a model at one instant, until nothing changes: resets, impacts, contacts, ends. */
#ifndef LAG_EVENT_ITERATION_H
#define LAG_EVENT_ITERATION_H

#include "lag/events/clock.h"
#include "lag/contacts/modes.h"
#include "lag/event_notice.h"
#include "lag/events/noise.h"
#include "lag/impulses/impulse.h"
#include "lag/events/refraction.h"
#include "lag/equations/projection.h"
#include "lag/impulses/position_maps.h"
#include "lag/events/timed.h"

/* A relation moves clearly if it does so by this many round-offs. */
static const double LAG_MOVES_CLEARLY = 16.0;

/* Acts of the clauses of a model in one pass. */
typedef struct lag_clauses {
    double *reset, *value; /* (nreset) */
    double *collision, *restitution; /* (ncollision) */
    double *stop, *fail;   /* (nstop) (nfail) */
    double *held;          /* (2 nq + nz) 1: this number was reset */
    int stopped;           /* a `terminate` acted */
    size_t fault;          /* LAG_CONFLICT: a reset; LAG_ASSERTION_FAILED: an assertion */
} lag_clauses;

/* Discretes of the event iteration, (nw) each. */
typedef struct lag_iterates {
    double *before, *next; /* those of one pass */
    double *settled;       /* those with which the rates were moved onto the constraints last */
    double *guilty;        /* LAG_EVENT_ITERATION_FAILED: 1, this one still changed; zero otherwise */
} lag_iterates;

/* The instant. */
typedef struct lag_instant {
    const double *from;    /* (2 nq + nz) the state before it */
    const double *stood;   /* (nw) the discretes before it */
    double moment;         /* it is known to so much [s] */
    int acted;             /* rates or states jumped: by resets, impacts, steps of energy */
} lag_instant;

/* Sides of relations just behind it (event_sides.c), (nindicator) each. */
typedef struct lag_sides {
    double *now, *before;  /* their values now, and before the instant */
    double *side;          /* 1 or -1; 0: they do not show it */
    double *truth;         /* before a pass turns them */
    const double *located; /* flags: they were located at their zeros, wherever a projection moves them; null: none */
    int begins;            /* this is the start, from which no side was chosen yet */
} lag_sides;

/* States that are tried. */
typedef struct lag_trial {
    double *point;         /* (2 nq + nz) */
    double *states;        /* (nz) before the clauses of this pass set them */
} lag_trial;

/* Contacts and friction of which the modes are to be found. */
typedef struct lag_leaving {
    double *flags;         /* (ncontact + nfriction) */
    const double *left;    /* the same: their guards were located, until their modes are found; null: none */
    int turned;            /* relations, or what time changes, turn at this instant: forces are other ones behind it */
    double *frictions;     /* (nfriction + nslip) their modes before a pass finds them anew */
} lag_leaving;

/* The receiver of notices. */
typedef struct lag_listener {
    lag_status (*tell)(void *context, const lag_event_notice *notice); /* null: nobody */
    void *context;
} lag_listener;

typedef struct lag_event_iteration {
    lag_motion *motion;
    lag_contacts *contacts;
    lag_modes *modes;
    lag_impulse *impulse;
    lag_timed *timed;
    lag_projection *projection;
    lag_noise *noise;
    lag_refraction *refraction;
    lag_position_maps maps;
    lag_places places;
    lag_instant instant;
    lag_iterates discretes;
    lag_clauses clauses;
    lag_sides sides;
    lag_trial trial;
    lag_leaving leaving;
    lag_listener listener;
    double *closed, *pulling; /* (ncontact) */
} lag_event_iteration;

void lag_event_iteration_place(
    lag_event_iteration *iteration, lag_contacts *contacts, lag_impulse *impulse, lag_timed *timed, lag_projection *projection, lag_noise *noise,
    lag_layout *layout);

/* Relations and conditions as they stand, nothing carried out. */
lag_status lag_event_iteration_initialize(lag_event_iteration *iteration, double t, const double *x);

/* *changed: 1 if a condition, or a value that `pre` reads, is other than at the last evaluation, as after a change of inputs. */
lag_status lag_event_iteration_conditions(lag_event_iteration *iteration, double t, const double *x, int *changed);

/*
 * Carries out what is new in w; `relations`, turned in w already, and `sides`, contacts and behind them friction, were found to change (flags, or
 * null). Changes x and w, whose rates are on the constraints afterwards. Relations are left as they are a moment later.
 */
lag_status lag_event_iteration_run(lag_event_iteration *iteration, double t, double *x, const double *relations, const double *sides);

/* Closed contacts that rates of now move apart open. */
lag_status lag_event_iteration_open(lag_event_iteration *iteration, double t, const double *x);

/*
 * Relation `which` has turned: closed contacts whose gap has a corner there, as a valley has, open where it leads them apart, and meet the other
 * side by the law of impact where it does not.
 */
lag_status lag_event_iteration_turn_gaps(lag_event_iteration *iteration, double t, const double *x, size_t which);

/*
 * At an instant gaps do not become negative, and position maps are the same with the discretes and states of now:
 * LAG_PENETRATION or LAG_WAY_JUMP, and flags of what has changed, if not. The instant is known up to a `moment` [s].
 */
lag_status lag_event_iteration_check_positions(lag_event_iteration *iteration, double t, const double *x, double moment);

/* The rates are those that belong to the discretes of now, but for constraints that take hold. */
lag_status lag_event_iteration_balance(lag_event_iteration *iteration, double t, double *x);

/*
 * Relation `which` turns, with what an energy that jumps there does: 1 in *refracted, rates have changed; 1 in *back, the motion turns back, and the
 * relation stays.
 */
lag_status lag_event_iteration_cross(lag_event_iteration *iteration, double t, double *x, size_t which, int *refracted, int *back);

/*
 * Of the relations flagged in `turned`, which come to zero at an instant at which laws change with time, those are left that turn by the laws from
 * now on: one that stays at zero turns if it holds there, as `f >= 3 N` of a force that rises to 3 N.
 */
lag_status lag_event_iteration_keep_turning(lag_event_iteration *iteration, double t, const double *x, double *turned);

/*
 * Asked at each event of an importer: true if `resets` throw one of the relations flagged in `turned`, which has changed, back across its zero
 * for shorter and shorter times, and the next one is too short to come back from where this one was found. The relation would not change any more, and the
 * motion would go on behind it.
 */
int lag_event_iteration_accumulates(
    lag_event_iteration *iteration, double t, const double *x, const double *turned, lag_crowd *resets, double length);

/* Tells that something happened. */
lag_status lag_event_iteration_report(const lag_event_iteration *iteration, double t, const double *x, lag_event_kind what, size_t which);

/* For the parts of a pass. */

/* Accelerations and multipliers; no numbers where there are none. */
void lag_event_iteration_solve(lag_motion *motion, double t, const double *x);

/* Relations as they stand at a state, into w. */
lag_status lag_event_iteration_relations(lag_event_iteration *iteration, double t, const double *x);

/*
 * Relations as they stand; those that pass zero here are on the side to which the motion leads, those that stay at zero what they have turned to
 * (flags, or null).
 */
lag_status lag_event_iteration_sides(lag_event_iteration *iteration, double t, const double *x, const double *turned);

/* A contact has opened, or closed. A rest that was announced for later is canceled. */
lag_status lag_event_iteration_report_contact(const lag_event_iteration *iteration, double t, const double *x, lag_event_kind what, size_t i);

/* Impacts, those of clauses (ncollision flags, or null) first, and what they did; 1 in `acted` where there were any. */
lag_status lag_event_iteration_impact(lag_event_iteration *iteration, double t, double *x, const double *collision, int *acted);

/* Contacts that pull open; the others strike, or, if they meet without speed, close as far as they push. */
lag_status lag_event_iteration_change_contacts(lag_event_iteration *iteration, double t, double *x, const double *changed);

#endif
