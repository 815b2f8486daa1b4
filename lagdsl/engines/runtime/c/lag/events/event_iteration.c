#include "lag/events/instant.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "lag/linalg/arena.h"
#include "lag/linalg/vector.h"

enum { MOST_PASSES = 100 };
/* Largest residual at which a constraint that discretes switch may become active, as a part of the size of its row. */
static const double TORN = 1e-6;
/* An instant is known to so many roundings of the last step. */
static const double ULPS = 4096.0;

lag_status lag_instants_report(const lag_instants *instants, double t, const double *x, lag_event_kind what, size_t which)
{
    const lag_event_notice notice = {.t = t, .what = what, .which = which, .x = x, .w = instants->motion->w};
    return instants->listener.tell != NULL ? instants->listener.tell(instants->listener.context, &notice) : LAG_OK;
}

/* ---- one pass ---- */

/* 1: no discretes changed since the pass began; loads follow the state. */
static int is_unchanged(const lag_instants *instants)
{
    return lag_same(instants->motion->places.load, instants->discretes.before, instants->motion->w);
}

static lag_status evaluate_clauses(lag_instants *instants, double t, const double *x)
{
    lag_motion *motion = instants->motion;
    const lag_clauses *c = &instants->clauses;
    lag_motion_try(motion, t, x);
    return motion->model->event(
        &motion->at, instants->discretes.next, c->reset, c->value, c->collision, c->restitution, c->stop, c->fail);
}

lag_status lag_instants_initialize(lag_instants *instants, double t, const double *x)
{
    const lag_model *model = instants->motion->model;
    const lag_places *places = &instants->motion->places;
    double *w = instants->motion->w;
    lag_status status = LAG_OK;
    for (int k = 0; k < MOST_PASSES && status == LAG_OK; ++k) {
        memcpy(instants->discretes.before, w, model->nw * sizeof(double));
        status = lag_instants_relations(instants, t, x);
        if (status == LAG_OK) {
            status = evaluate_clauses(instants, t, x);
        }
        for (size_t i = places->condition; i < places->clock; ++i) {
            w[i] = instants->discretes.next[i];
        }
        if (is_unchanged(instants)) {
            break;
        }
    }
    memcpy(instants->discretes.settled, w, model->nw * sizeof(double));
    return status;
}

lag_status lag_instants_conditions(lag_instants *instants, double t, const double *x, int *changed)
{
    const lag_places *places = &instants->motion->places;
    const size_t count = places->clock - places->condition;
    const lag_status status = count > 0 ? evaluate_clauses(instants, t, x) : LAG_OK;
    *changed = status == LAG_OK && !lag_same(count, instants->discretes.next + places->condition, instants->motion->w + places->condition);
    return status;
}

/* ---- clauses ---- */

/* Resets of one pass into x; 1 in `held`: this one. */
static lag_status reset(lag_instants *instants, double t, double *x, int *any)
{
    const lag_model *model = instants->motion->model;
    lag_status status = LAG_OK;
    int conflict = 0;
    memset(instants->clauses.held, 0, lag_motion_size(model) * sizeof(double));
    for (size_t i = 0; i < model->nreset; ++i) {
        const size_t place = model->reset_places[i];
        if (instants->clauses.reset[i] == 0.0) {
            continue;
        }
        *any = 1;
        if (instants->clauses.held[place] == 0.0) {
            instants->clauses.held[place] = 1.0;
            x[place] = instants->clauses.value[i];
        } else if (x[place] != instants->clauses.value[i]) {
            instants->clauses.fault = i;
            conflict = 1;
        }
    }
    for (size_t i = 0; i < model->nreset && status == LAG_OK; ++i) {
        status = instants->clauses.reset[i] != 0.0 ? lag_instants_report(instants, t, x, LAG_REINIT, i) : LAG_OK;
    }
    return status == LAG_OK && conflict ? LAG_CONFLICT : status;
}

/* Failures, ends and resets of one pass. */
static lag_status act(lag_instants *instants, double t, double *x, int *acted)
{
    const lag_model *model = instants->motion->model;
    lag_status status = LAG_OK;
    for (size_t i = 0; i < model->nfail && status == LAG_OK; ++i) {
        if (instants->clauses.fail[i] < 0.0) {
            status = lag_instants_report(instants, t, x, LAG_WARNING, model->na + i);
        } else if (instants->clauses.fail[i] > 0.0) {
            instants->clauses.fault = i;
            return LAG_ASSERTION_FAILED;
        }
    }
    for (size_t i = 0; i < model->nstop && status == LAG_OK; ++i) {
        if (instants->clauses.stop[i] != 0.0) {
            instants->clauses.stopped = 1;
            status = lag_instants_report(instants, t, x, LAG_TERMINATE, i);
        }
    }
    if (status == LAG_OK) {
        status = reset(instants, t, x, acted);
    }
    if (*acted) {
        lag_modes_release_frictions(&instants->modes);
    }
    return status == LAG_OK && *acted ? lag_contacts_open(&instants->contacts, t, x, 0) : status;
}

/* 1: other discretes than contacts are those with which the rates were moved onto the constraints last. */
static int is_balanced(const lag_instants *instants)
{
    const lag_places *places = &instants->motion->places;
    const size_t relations = instants->motion->model->nindicator;
    const double *w = instants->motion->w;
    return lag_same(places->contact, w, instants->discretes.settled) && lag_same(relations, w + places->relation, instants->discretes.settled + places->relation);
}

/* The discretes now, but for variables and relations as they were when the rates were moved onto the constraints last. */
static const double *balanced_discretes(lag_instants *instants)
{
    const lag_places *places = &instants->motion->places;
    const lag_model *model = instants->motion->model;
    memcpy(instants->discretes.next, instants->discretes.before, model->nw * sizeof(double));
    memcpy(instants->discretes.next, instants->discretes.settled, places->contact * sizeof(double));
    memcpy(instants->discretes.next + places->relation, instants->discretes.settled + places->relation, model->nindicator * sizeof(double));
    return instants->discretes.next;
}

/* x with other states z (nz), into `point`. */
static const double *with_states(lag_instants *instants, const double *x, const double *z)
{
    const lag_model *model = instants->motion->model;
    memcpy(instants->trial.point, x, 2 * model->nq * sizeof(double));
    memcpy(instants->trial.point + 2 * model->nq, z, model->nz * sizeof(double));
    return instants->trial.point;
}

/* Rates with the discretes of now and the momenta of `was` with discretes w, but for constraints that take hold. */
static lag_status balance(lag_instants *instants, double t, double *x, const double *was, const double *w, const double *held)
{
    int jumped = 0;
    const lag_status status = lag_impulse_keep_momenta(&instants->impulse, t, was, w);
    memcpy(instants->discretes.settled, instants->motion->w, instants->motion->model->nw * sizeof(double));
    return status == LAG_OK ? lag_impulse_balance(&instants->impulse, t, x, held, NULL, &jumped) : status;
}

/*
 * If discretes or states in constraints, masses or prescribed motions have changed, balances the momenta. Otherwise, after resets,
 * projects the rates onto the constraints. Rates that were reset keep their values where the constraints permit it; contacts
 * adapt, because they only push.
 */
static lag_status apply_constraints(lag_instants *instants, double t, double *x, int acted)
{
    const lag_model *model = instants->motion->model;
    const double *held = acted ? instants->clauses.held + model->nq : NULL;
    lag_status status = LAG_OK;
    if (!is_balanced(instants) || !lag_same(model->nz, x + 2 * model->nq, instants->trial.states)) {
        instants->modes.jumped = 1; /* slips may depend on what has changed */
        const double *was = with_states(instants, x, instants->trial.states);
        status = balance(instants, t, x, was, balanced_discretes(instants), held);
    }
    return status == LAG_OK && acted ? lag_projection_rates(instants->projection, t, x, held) : status;
}

lag_status lag_instants_turn(lag_instants *instants, double t, double *x, size_t which, int *acted)
{
    double *truth = instants->motion->w + instants->motion->places.relation;
    const int located = instants->sides.located != NULL && instants->sides.located[which] != 0.0;
    int refracted = 0;
    int back = 0;
    lag_status status = lag_refraction_cross(&instants->refraction, t, x, which, located ? (double)INFINITY : instants->instant.moment, &refracted, &back);
    truth[which] = back ? truth[which] : 1.0 - truth[which];
    instants->modes.jumped = 1;
    *acted = *acted || refracted;
    if (status == LAG_CHATTER) {
        instants->discretes.guilty[instants->motion->places.relation + which] = 1.0;
    }
    status = status == LAG_OK && refracted ? balance(instants, t, x, x, instants->motion->w, NULL) : status;
    return status == LAG_OK && !back ? lag_contacts_open(&instants->contacts, t, x, 1) : status;
}

/*
 * Relations as they stand, or as they are a moment later: those that turn now, as at the start on a border or behind a blow, turn as at any event,
 * with what an energy that jumps there does.
 */
static lag_status turn(lag_instants *instants, double t, double *x, const double *turned, int *acted)
{
    const double *truth = instants->motion->w + instants->motion->places.relation;
    lag_status status = lag_instants_sides(instants, t, x, turned);
    for (size_t i = 0; i < instants->motion->model->nindicator && status == LAG_OK; ++i) {
        status = truth[i] != instants->sides.truth[i] ? lag_instants_turn(instants, t, x, i, acted) : LAG_OK;
    }
    return status;
}

/* One pass; `acted`: it did more than to change w. */
static lag_status pass(lag_instants *instants, double t, double *x, const double *turned, int *acted)
{
    lag_motion *motion = instants->motion;
    lag_status status = evaluate_clauses(instants, t, x);
    if (status != LAG_OK) {
        return status;
    }
    memcpy(instants->trial.states, x + 2 * motion->model->nq, motion->model->nz * sizeof(double));
    memcpy(motion->w, instants->discretes.next, motion->model->nw * sizeof(double));
    lag_places_clear(&instants->motion->places, motion->w);
    if (!lag_same(instants->motion->places.contact, motion->w, instants->discretes.before)) {
        status = lag_timed_set_behind(&instants->timed, t); /* corners of time may depend on discretes */
    }
    status = status == LAG_OK ? act(instants, t, x, acted) : status;
    if (status == LAG_OK) {
        status = apply_constraints(instants, t, x, *acted);
    }
    if (status == LAG_OK) {
        status = lag_instants_impact(instants, t, x, instants->clauses.collision, acted);
    }
    status = status == LAG_OK ? turn(instants, t, x, turned, acted) : status;
    instants->instant.acted = instants->instant.acted || *acted;
    return status;
}

/* 1: a constraint that discretes switch asks for other positions. */
static int positions_jump(const lag_instants *instants, double t, const double *x)
{
    const lag_model *model = instants->motion->model;
    for (size_t i = 0; i < model->nswitched; ++i) {
        if (!(lag_projection_distance(instants->projection, t, x, model->switched_rows[i]) <= TORN)) {
            return 1;
        }
    }
    return 0;
}

/* Contacts that struck, or are in another mode than before the instant. One that is held for the rest of its bounces closes at their end. */
static lag_status report_contacts(lag_instants *instants, double t, const double *x)
{
    const lag_places *places = &instants->motion->places;
    const double *stood = instants->instant.stood;
    const double *w = instants->motion->w;
    lag_status status = LAG_OK;
    for (size_t i = 0; i < instants->motion->model->ncontact && status == LAG_OK; ++i) {
        double *until = &instants->contacts.until[i];
        const int closed = w[places->contact + i] != 0.0;
        const int changes = closed != (stood[places->contact + i] != 0.0);
        *until = closed ? *until : (double)INFINITY;
        status = w[places->impacts + i] != stood[places->impacts + i] ? lag_instants_report(instants, t, x, LAG_IMPACT, i) : LAG_OK;
        if (status == LAG_OK && changes && *until == (double)INFINITY) {
            status = lag_instants_report(instants, t, x, closed ? LAG_CLOSED : LAG_OPENED, i);
        }
    }
    return status;
}

/* Friction that is in another mode than before the instant. One that was off, or is, tells nothing: its contact does. */
static lag_status report_frictions(lag_instants *instants, double t, const double *x)
{
    const lag_frictions *frictions = instants->modes.frictions;
    const double *sticks = instants->instant.stood + instants->motion->places.sticks;
    lag_status status = LAG_OK;
    for (size_t k = 0; k < instants->motion->model->nfriction && status == LAG_OK; ++k) {
        const double *before = instants->instant.stood + instants->motion->places.direction + (size_t)frictions->first[k];
        const double *now = lag_frictions_direction(frictions, k);
        const int stuck = *lag_frictions_sticks(frictions, k) != 0.0;
        const int reverses = lag_frictions_components(frictions, k) == 1 && before[0] * now[0] < 0.0;
        if (lag_frictions_acts(frictions, k) && (stuck != (sticks[k] != 0.0) || reverses)) {
            status = lag_instants_report(instants, t, x, stuck ? LAG_STICKS : reverses ? LAG_REVERSES : LAG_SLIPS, k);
        }
    }
    return status;
}

lag_status lag_instants_run(lag_instants *instants, double t, double *x, const double *relations, const double *sides)
{
    const lag_model *model = instants->motion->model;
    const double *w = instants->motion->w;
    lag_status status = sides != NULL ? lag_instants_change_contacts(instants, t, x, sides) : LAG_OK;
    instants->clauses.stopped = 0;
    for (int k = 0; k < MOST_PASSES && status == LAG_OK; ++k) {
        int acted = 0;
        memcpy(instants->discretes.before, w, model->nw * sizeof(double));
        status = pass(instants, t, x, relations, &acted);
        if (status == LAG_OK && !acted && is_unchanged(instants)) {
            status = positions_jump(instants, t, x) ? LAG_POSITION_JUMP : report_contacts(instants, t, x);
            return status == LAG_OK ? report_frictions(instants, t, x) : status;
        }
    }
    if (status != LAG_OK) {
        return status; /* what is guilty of it is known */
    }
    for (size_t i = 0; i < model->nw; ++i) {
        instants->discretes.guilty[i] = instants->discretes.before[i] != w[i];
    }
    for (size_t i = 0; i < model->ncontact; ++i) { /* blows do not open what constraints close */
        instants->discretes.guilty[instants->motion->places.contact + i] += instants->contacts.blows.approach[i] != 0.0;
    }
    return LAG_EVENT_ITERATION_FAILED;
}

/* ---- what is continuous ---- */

double lag_instants_resolution(const lag_instants *instants, double t, double h)
{
    return fmax(instants->instant.late, ULPS * DBL_EPSILON * fmax(fabs(t), h));
}

lag_status lag_instants_check_positions(lag_instants *instants, double t, const double *x)
{
    const double moment = lag_instants_resolution(instants, t, instants->contacts.length);
    const lag_model *model = instants->motion->model;
    const double *stood = instants->instant.from + 2 * model->nq;
    const double *was = with_states(instants, x, stood);
    double *pierced = instants->discretes.guilty + instants->motion->places.contact;
    lag_status status = lag_contacts_check_gaps(&instants->contacts, t, x, was, instants->instant.stood, instants->trial.gap, pierced);
    if (status != LAG_OK || model->nway == 0) {
        return status;
    }
    status = lag_position_maps_continue(&instants->maps, t, x, was, instants->instant.stood, moment, instants->noise.peak);
    for (size_t i = 0; i < model->nw && status == LAG_WAY_JUMP; ++i) {
        instants->discretes.guilty[i] = instants->motion->w[i] != instants->instant.stood[i];
    }
    return status;
}
