/*
 * Events of one run of a model with discretes: the start and the end, ticks of its clocks, changes of relations and
 * contacts. lag/events/guards.h detects these changes.
 */
#ifndef LAG_INSTANT_H
#define LAG_INSTANT_H

#include "lag/events/clock.h"
#include "lag/events/event_iteration.h"
#include "lag/events/refraction.h"
#include "lag/events/timed.h"

typedef struct lag_instants {
    lag_motion *motion;
    lag_places places;
    lag_contacts contacts;
    lag_frictions frictions;
    lag_modes modes;
    lag_noise noise;
    lag_event_iteration iteration;
    lag_impulse impulse;
    lag_timed timed;
    lag_refraction refraction;
    double *x_before, *w_before; /* (2 nq + nz) (nw) */
    lag_clock *clock; /* (nclock) */
    double *first, *period; /* (nclock) */
    lag_crowd crowd, resets; /* all events; those that change the state */
    double late;             /* an event may be carried out so long after its zero, as an importer finds it [s]; the run's own: 0 */
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

/* The ticks of now, if there are any. */
lag_status lag_instants_tick(lag_instants *instants, double t, double *x);

/* 1: lag_instants_tick would do something. */
int lag_instants_due(const lag_instants *instants, double t);

/* The instant of a tick before t that differs from t by round-off only; else t. */
double lag_instants_same(const lag_instants *instants, double t);

/*
 * Carries out the changes at t: `changed` are flags of relations, then of contacts (nindicator + ncontact); `located`: at zeros that the motion
 * passes, not by a jump of inputs. With `ticks`, also the ticks at t; flags of relations that do not turn then are cleared. LAG_CHATTER: events crowd.
 */
lag_status lag_instants_carry_out(lag_instants *instants, double t, double *x, double *changed, int located, int ticks);

/* Events at t follow on a step of length h. */
void lag_instants_after(lag_instants *instants, double t, double h);

#endif
