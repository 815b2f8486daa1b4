/*
 * Instants of one run of a model with discretes: the start and the end, ticks of its clocks, changes of relations and
 * contacts, in passes over the clauses until nothing changes. lag/events/guards.h detects these changes.
 */
#ifndef LAG_INSTANT_H
#define LAG_INSTANT_H

#include "lag/contacts/modes.h"
#include "lag/equations/projection.h"
#include "lag/event_notice.h"
#include "lag/events/clock.h"
#include "lag/events/noise.h"
#include "lag/events/refraction.h"
#include "lag/events/timed.h"
#include "lag/impulses/impulse.h"
#include "lag/impulses/position_maps.h"

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
    double *from;          /* (2 nq + nz) the state before it */
    double *stood;         /* (nw) the discretes before it */
    double moment;         /* it is known to so much [s] */
    double late;           /* it may be carried out so long after its zero, as an importer finds it [s]; the run's own: 0 */
    int acted;             /* rates or states jumped: by resets, impacts, steps of energy */
} lag_instant;

/* Sides of relations just behind it (event_sides.c), (nindicator) each. */
typedef struct lag_sides {
    double *now, *before;  /* their values now, and before the instant */
    double *side;          /* 1 or -1; 0: they do not show it */
    double *truth;         /* 1: it holds there */
    const double *located; /* flags: they were located at their zeros, wherever a projection moves them; null: none */
    int begins;            /* this is the start, from which no side was chosen yet */
} lag_sides;

/* States that are tried. */
typedef struct lag_trial {
    double *point;         /* (2 nq + nz) */
    double *states;        /* (nz) before the clauses of this pass set them */
    double *gap;           /* (ncontact) */
} lag_trial;

/* Contacts and friction of which the modes are to be found. */
typedef struct lag_leaving {
    double *flags;         /* (ncontact + nfriction) */
    const double *left;    /* the same: their guards were located, until their modes are found; null: none */
    int turned;            /* relations, or what time changes, turn at this instant: forces are other ones behind it */
    double *modes;         /* (2 ncontact + nfriction + nslip) their entries of w before a pass finds them anew */
} lag_leaving;

/* The receiver of notices. */
typedef struct lag_listener {
    lag_status (*tell)(void *context, const lag_event_notice *notice); /* null: nobody */
    void *context;
} lag_listener;

/* Clocks of the model. */
typedef struct lag_clocks {
    lag_clock *each;        /* (nclock) */
    double *first, *period; /* (nclock) */
} lag_clocks;

typedef struct lag_instants {
    lag_motion *motion;
    lag_projection *projection;
    lag_contacts contacts;
    lag_frictions frictions;
    lag_modes modes;
    lag_noise noise;
    lag_impulse impulse;
    lag_timed timed;
    lag_refraction refraction;
    lag_position_maps maps;
    lag_instant instant;
    lag_iterates discretes;
    lag_clauses clauses;
    lag_sides sides;
    lag_trial trial;
    lag_leaving leaving;
    lag_listener listener;
    lag_clocks clocks;
    lag_crowd crowd, resets; /* all events; those that change the state */
} lag_instants;

/* Lays them out, beside nclock clocks; arrays of a new layout are zero. */
void lag_instants_place(lag_instants *instants, lag_motion *motion, lag_projection *projection, lag_clock *clock, lag_layout *layout);

/*
 * The start at x = (q, qd, z): discretes, relations as they stand, contacts that carry, and what is to be done there. LAG_PENETRATION:
 * flags in passes.guilty. This and all below change x and the w of the motion; LAG_STOPPED: a `terminate` acted.
 */
lag_status lag_instants_begin(lag_instants *instants, double t, double *x);

/* The end. */
lag_status lag_instants_end(lag_instants *instants, double t, double *x);

/* Time of the next tick, of what time alone changes, or of the end of bounces too short to follow; infinite without. */
double lag_instants_next(const lag_instants *instants);

/* Changes with time where nobody needs to hear of them, as no rate jumps: 1 in *quiet, and it is done, but for the search for the next ones. */
lag_status lag_instants_change_unreported(lag_instants *instants, double t, double *x, int *quiet);

/* The state and the discretes before what was done quietly. */
void lag_instants_take_back(const lag_instants *instants, double *x);

/*
 * Inputs jump at t from `before` (nu) to the present ones: rates follow the momenta that inputs prescribe. If it is a `blow`, contacts open
 * and strike.
 */
lag_status lag_instants_prescribe(lag_instants *instants, double t, double *x, const double *before, int blow);

/* 1: something ticks, or time changes something. */
int lag_instants_due(const lag_instants *instants, double t);

/* The instant of a tick before t that differs from t by round-off only; else t. */
double lag_instants_same(const lag_instants *instants, double t);

/*
 * Carries out the changes at t: `changed` are flags of relations, then of contacts and friction; `located`: at zeros that the motion passes, not by a
 * jump of inputs. With `ticks`, also the ticks at t; then those relations are flagged that turn by the laws from then on. LAG_CHATTER: events crowd.
 */
lag_status lag_instants_carry_out(lag_instants *instants, double t, double *x, double *changed, int located, int ticks);

/* Instants at t, in an experiment or behind a step of length h, are known to so much [s]. */
double lag_instants_resolution(const lag_instants *instants, double t, double h);

/* Events at t follow on a step of length h. */
void lag_instants_after(lag_instants *instants, double t, double h);

/* ---- parts of an instant ---- */

/* Relations and conditions as they stand, nothing carried out. */
lag_status lag_instants_initialize(lag_instants *instants, double t, const double *x);

/* *changed: 1 if a condition, or a value that `pre` reads, is other than at the last evaluation, as after a change of inputs. */
lag_status lag_instants_conditions(lag_instants *instants, double t, const double *x, int *changed);

/*
 * Carries out what is new in w; `relations`, turned in w already, and `sides`, contacts and behind them friction, were found to change (flags, or
 * null). Changes x and w, whose rates are on the constraints afterwards. Relations are left as they are a moment later.
 */
lag_status lag_instants_run(lag_instants *instants, double t, double *x, const double *relations, const double *sides);

/*
 * At an instant gaps do not become negative, and position maps are the same with the discretes and states of now:
 * LAG_PENETRATION or LAG_WAY_JUMP, and flags of what has changed, if not.
 */
lag_status lag_instants_check_positions(lag_instants *instants, double t, const double *x);

/*
 * Relation `which` turns, with what an energy that jumps there does: 1 in *acted, rates have changed. Where that turns the motion back the relation
 * stays.
 */
lag_status lag_instants_turn(lag_instants *instants, double t, double *x, size_t which, int *acted);

/*
 * Of the relations flagged in `turned`, which come to zero at an instant at which laws change with time, those are left that turn by the laws from
 * now on: one that stays at zero turns if it holds there, as `f >= 3 N` of a force that rises to 3 N. If there are none, all that turn are flagged.
 */
lag_status lag_instants_find_turning(lag_instants *instants, double t, const double *x, double *turned);

/*
 * True if resets throw one of the relations flagged in `turned`, which has changed, back across its zero for shorter and shorter times, and the next one is
 * too short to come back from where this one was found. The relation would not change any more, and the motion would go on behind it.
 */
int lag_instants_accumulates(lag_instants *instants, double t, const double *x, const double *turned);

/* Tells that something happened. */
lag_status lag_instants_report(const lag_instants *instants, double t, const double *x, lag_event_kind what, size_t which);

/* Relations as they stand at a state, into w. */
lag_status lag_instants_relations(lag_instants *instants, double t, const double *x);

/*
 * Relations as they stand, into instants->sides.truth; those that pass zero here are on the side to which the motion leads, those that stay at zero
 * what they have turned to (flags, or null).
 */
lag_status lag_instants_sides(lag_instants *instants, double t, const double *x, const double *turned);

/* Impacts, those of clauses (ncollision flags, or null) first, and what they did; 1 in `acted` where there were any. */
lag_status lag_instants_impact(lag_instants *instants, double t, double *x, const double *collision, int *acted);

/* Contacts that pull open; the others strike, or, if they meet without speed, close as far as they push. */
lag_status lag_instants_change_contacts(lag_instants *instants, double t, double *x, const double *changed);

#endif
