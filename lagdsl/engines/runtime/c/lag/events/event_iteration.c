#include "lag/events/event_iteration.h"

#include <math.h>
#include <string.h>

#include "lag/linalg/arena.h"
#include "lag/linalg/vector.h"

enum { MOST_PASSES = 100 };
/* Largest residual at which a constraint that discretes switch may become active, as a part of the size of its row. */
static const double TORN = 1e-6;

void lag_event_iteration_place(
    lag_event_iteration *iteration, lag_contacts *contacts, lag_impulse *impulse, lag_timed *timed, lag_projection *projection, lag_noise *noise,
    lag_layout *layout)
{
    const lag_model *model = contacts->motion->model;
    const size_t size = lag_motion_size(model);
    lag_clauses *clauses = &iteration->clauses;
    *iteration = (lag_event_iteration){.motion = contacts->motion, .contacts = contacts, .impulse = impulse, .timed = timed, .projection = projection,
        .noise = noise, .places = lag_places_of(model), .instant.moment = 1e-9};
    lag_lay_all(layout, model->nw, (double **const[]){&iteration->discretes.before, &iteration->discretes.next, &iteration->discretes.guilty,
        &iteration->discretes.settled, NULL});
    lag_lay_all(layout, model->nreset, (double **const[]){&clauses->reset, &clauses->value, NULL});
    lag_lay_all(layout, model->ncollision, (double **const[]){&clauses->collision, &clauses->restitution, NULL});
    clauses->stop = lag_lay(layout, model->nstop);
    clauses->fail = lag_lay(layout, model->nfail);
    lag_lay_all(layout, size, (double **const[]){&clauses->held, &iteration->trial.point, NULL});
    iteration->trial.states = lag_lay(layout, model->nz);
    lag_lay_all(layout, model->nindicator, (double **const[]){&iteration->sides.now, &iteration->sides.side, &iteration->sides.before,
        &iteration->sides.truth, NULL});
    lag_lay_all(layout, model->ncontact, (double **const[]){&iteration->closed, &iteration->pulling, NULL});
    iteration->leaving.flags = lag_lay(layout, model->ncontact + model->nfriction);
    iteration->leaving.frictions = lag_lay(layout, model->nfriction + model->nslip);
    lag_position_maps_place(&iteration->maps, iteration->motion, layout);
}

lag_status lag_event_iteration_report(const lag_event_iteration *iteration, double t, const double *x, lag_event_kind what, size_t which)
{
    const lag_event_notice notice = {.t = t, .what = what, .which = which, .x = x, .w = iteration->motion->w};
    return iteration->listener.tell != NULL ? iteration->listener.tell(iteration->listener.context, &notice) : LAG_OK;
}

/* ---- one pass ---- */

/* 1: no discretes changed since the pass began; loads follow the state. */
static int is_unchanged(const lag_event_iteration *iteration)
{
    return lag_same(iteration->places.load, iteration->discretes.before, iteration->motion->w);
}

void lag_event_iteration_solve(lag_motion *motion, double t, const double *x)
{
    const lag_model *model = motion->model;
    const lag_status status = lag_motion_solve(motion, t, x);
    for (size_t i = 0; i < model->nq && status != LAG_OK; ++i) {
        motion->qdd[i] = (double)NAN;
    }
    for (size_t i = 0; i < model->nc && status != LAG_OK; ++i) {
        motion->lam[i] = (double)NAN;
    }
}

static lag_status evaluate_clauses(lag_event_iteration *iteration, double t, const double *x)
{
    lag_motion *motion = iteration->motion;
    const lag_clauses *c = &iteration->clauses;
    lag_event_iteration_solve(motion, t, x);
    return motion->model->event(
        &motion->at, iteration->discretes.next, c->reset, c->value, c->collision, c->restitution, c->stop, c->fail);
}

lag_status lag_event_iteration_initialize(lag_event_iteration *iteration, double t, const double *x)
{
    const lag_model *model = iteration->motion->model;
    const lag_places *places = &iteration->places;
    double *w = iteration->motion->w;
    lag_status status = LAG_OK;
    for (int k = 0; k < MOST_PASSES && status == LAG_OK; ++k) {
        memcpy(iteration->discretes.before, w, model->nw * sizeof(double));
        status = lag_event_iteration_relations(iteration, t, x);
        if (status == LAG_OK) {
            status = evaluate_clauses(iteration, t, x);
        }
        for (size_t i = places->condition; i < places->clock; ++i) {
            w[i] = iteration->discretes.next[i];
        }
        if (is_unchanged(iteration)) {
            break;
        }
    }
    memcpy(iteration->discretes.settled, w, model->nw * sizeof(double));
    return status;
}

lag_status lag_event_iteration_conditions(lag_event_iteration *iteration, double t, const double *x, int *changed)
{
    const lag_places *places = &iteration->places;
    const size_t count = places->clock - places->condition;
    const lag_status status = count > 0 ? evaluate_clauses(iteration, t, x) : LAG_OK;
    *changed = status == LAG_OK && !lag_same(count, iteration->discretes.next + places->condition, iteration->motion->w + places->condition);
    return status;
}

/* ---- contacts ---- */

/* Impacts of clauses, and contacts that something drives in now. */
static lag_status solve_impacts(lag_event_iteration *iteration, double t, double *x, int *acted)
{
    const lag_model *model = iteration->motion->model;
    const int any = lag_any(model->ncollision, iteration->clauses.collision);
    if (!any && model->ncontact == 0 && model->nfriction == 0) {
        return LAG_OK;
    }
    *acted = *acted || any;
    return lag_event_iteration_impact(iteration, t, x, iteration->clauses.collision, acted);
}

/* ---- clauses ---- */

/* Resets of one pass into x; 1 in `held`: this one. */
static lag_status reset(lag_event_iteration *iteration, double t, double *x, int *any)
{
    const lag_model *model = iteration->motion->model;
    lag_status status = LAG_OK;
    int conflict = 0;
    memset(iteration->clauses.held, 0, lag_motion_size(model) * sizeof(double));
    for (size_t i = 0; i < model->nreset; ++i) {
        const size_t place = model->reset_places[i];
        if (iteration->clauses.reset[i] == 0.0) {
            continue;
        }
        *any = 1;
        if (iteration->clauses.held[place] == 0.0) {
            iteration->clauses.held[place] = 1.0;
            x[place] = iteration->clauses.value[i];
        } else if (x[place] != iteration->clauses.value[i]) {
            iteration->clauses.fault = i;
            conflict = 1;
        }
    }
    for (size_t i = 0; i < model->nreset && status == LAG_OK; ++i) {
        status = iteration->clauses.reset[i] != 0.0 ? lag_event_iteration_report(iteration, t, x, LAG_REINIT, i) : LAG_OK;
    }
    return status == LAG_OK && conflict ? LAG_CONFLICT : status;
}

lag_status lag_event_iteration_open(lag_event_iteration *iteration, double t, const double *x)
{
    const size_t count = iteration->motion->model->ncontact;
    const double *closed = iteration->motion->w + iteration->places.contact;
    memcpy(iteration->closed, closed, count * sizeof(double));
    lag_status status = lag_contacts_open(iteration->contacts, t, x);
    for (size_t i = 0; i < count && status == LAG_OK; ++i) {
        status = iteration->closed[i] != closed[i] ? lag_event_iteration_report_contact(iteration, t, x, LAG_OPENED, i) : LAG_OK;
    }
    return status;
}

/* Failures, ends and resets of one pass. */
static lag_status act(lag_event_iteration *iteration, double t, double *x, int *acted)
{
    const lag_model *model = iteration->motion->model;
    lag_status status = LAG_OK;
    for (size_t i = 0; i < model->nfail && status == LAG_OK; ++i) {
        if (iteration->clauses.fail[i] < 0.0) {
            status = lag_event_iteration_report(iteration, t, x, LAG_WARNING, model->na + i);
        } else if (iteration->clauses.fail[i] > 0.0) {
            iteration->clauses.fault = i;
            return LAG_ASSERTION_FAILED;
        }
    }
    for (size_t i = 0; i < model->nstop && status == LAG_OK; ++i) {
        if (iteration->clauses.stop[i] != 0.0) {
            iteration->clauses.stopped = 1;
            status = lag_event_iteration_report(iteration, t, x, LAG_TERMINATE, i);
        }
    }
    if (status == LAG_OK) {
        status = reset(iteration, t, x, acted);
    }
    if (*acted) {
        lag_modes_release_frictions(iteration->modes);
    }
    return status == LAG_OK && *acted ? lag_event_iteration_open(iteration, t, x) : status;
}

/* 1: other discretes than contacts are those with which the rates were moved onto the constraints last. */
static int is_balanced(const lag_event_iteration *iteration)
{
    const lag_places *places = &iteration->places;
    const size_t relations = iteration->motion->model->nindicator;
    const double *w = iteration->motion->w;
    return lag_same(places->contact, w, iteration->discretes.settled) && lag_same(relations, w + places->relation, iteration->discretes.settled + places->relation);
}

/* The discretes now, but for variables and relations as they were when the rates were moved onto the constraints last. */
static const double *balanced_discretes(lag_event_iteration *iteration)
{
    const lag_places *places = &iteration->places;
    const lag_model *model = iteration->motion->model;
    memcpy(iteration->discretes.next, iteration->discretes.before, model->nw * sizeof(double));
    memcpy(iteration->discretes.next, iteration->discretes.settled, places->contact * sizeof(double));
    memcpy(iteration->discretes.next + places->relation, iteration->discretes.settled + places->relation, model->nindicator * sizeof(double));
    return iteration->discretes.next;
}

/* x with other states z (nz), into `point`. */
static const double *with_states(lag_event_iteration *iteration, const double *x, const double *z)
{
    const lag_model *model = iteration->motion->model;
    memcpy(iteration->trial.point, x, 2 * model->nq * sizeof(double));
    memcpy(iteration->trial.point + 2 * model->nq, z, model->nz * sizeof(double));
    return iteration->trial.point;
}

/*
 * If discretes or states in constraints, masses or prescribed motions have changed, balances the momenta. Otherwise, after resets,
 * projects the rates onto the constraints. Rates that were reset keep their values where the constraints permit it; contacts
 * adapt, because they only push.
 */
static lag_status apply_constraints(lag_event_iteration *iteration, double t, double *x, int acted)
{
    const lag_model *model = iteration->motion->model;
    const double *held = acted ? iteration->clauses.held + model->nq : NULL;
    int jumped = 0;
    if (is_balanced(iteration) && lag_same(model->nz, x + 2 * model->nq, iteration->trial.states)) {
        return acted ? lag_projection_rates(iteration->projection, t, x, held) : LAG_OK;
    }
    iteration->modes->jumped = 1; /* slips may depend on what has changed */
    const double *was = with_states(iteration, x, iteration->trial.states);
    lag_status status = lag_impulse_keep_momenta(iteration->impulse, t, was, balanced_discretes(iteration));
    memcpy(iteration->discretes.settled, iteration->motion->w, iteration->motion->model->nw * sizeof(double));
    if (status == LAG_OK) {
        status = lag_impulse_balance(iteration->impulse, t, x, held, NULL, &jumped);
    }
    return status == LAG_OK && acted ? lag_projection_rates(iteration->projection, t, x, held) : status;
}

lag_status lag_event_iteration_balance(lag_event_iteration *iteration, double t, double *x)
{
    int jumped = 0;
    const lag_status status = lag_impulse_keep_momenta(iteration->impulse, t, x, iteration->motion->w);
    memcpy(iteration->discretes.settled, iteration->motion->w, iteration->motion->model->nw * sizeof(double));
    return status == LAG_OK ? lag_impulse_balance(iteration->impulse, t, x, NULL, NULL, &jumped) : status;
}

/*
 * Relations as they stand, or as they are a moment later: those that turn now, as at the start on a border or behind a blow, turn as at any event,
 * with what an energy that jumps there does.
 */
static lag_status turn(lag_event_iteration *iteration, double t, double *x, const double *turned, int *acted)
{
    const size_t count = iteration->motion->model->nindicator;
    double *truth = iteration->motion->w + iteration->places.relation;
    memcpy(iteration->sides.truth, truth, count * sizeof(double));
    lag_status status = lag_event_iteration_sides(iteration, t, x, turned);
    for (size_t i = 0; i < count && status == LAG_OK; ++i) {
        int refracted = 0;
        int back = 0;
        if (truth[i] != iteration->sides.truth[i]) {
            truth[i] = iteration->sides.truth[i];
            status = lag_event_iteration_cross(iteration, t, x, i, &refracted, &back);
            *acted = *acted || refracted;
        }
    }
    return status;
}

/* One pass; `acted`: it did more than to change w. */
static lag_status pass(lag_event_iteration *iteration, double t, double *x, const double *turned, int *acted)
{
    lag_motion *motion = iteration->motion;
    lag_status status = evaluate_clauses(iteration, t, x);
    if (status != LAG_OK) {
        return status;
    }
    memcpy(iteration->trial.states, x + 2 * motion->model->nq, motion->model->nz * sizeof(double));
    memcpy(motion->w, iteration->discretes.next, motion->model->nw * sizeof(double));
    lag_places_clear(&iteration->places, motion->w);
    if (!lag_same(iteration->places.contact, motion->w, iteration->discretes.before)) {
        status = lag_timed_set_behind(iteration->timed, t); /* corners of time may depend on discretes */
    }
    status = status == LAG_OK ? act(iteration, t, x, acted) : status;
    if (status == LAG_OK) {
        status = apply_constraints(iteration, t, x, *acted);
    }
    if (status == LAG_OK) {
        status = solve_impacts(iteration, t, x, acted);
    }
    status = status == LAG_OK ? turn(iteration, t, x, turned, acted) : status;
    iteration->instant.acted = iteration->instant.acted || *acted;
    return status;
}

/* 1: a constraint that discretes switch asks for other positions. */
static int positions_jump(const lag_event_iteration *iteration, double t, const double *x)
{
    const lag_model *model = iteration->motion->model;
    for (size_t i = 0; i < model->nswitched; ++i) {
        if (!(lag_projection_distance(iteration->projection, t, x, model->switched_rows[i]) <= TORN)) {
            return 1;
        }
    }
    return 0;
}

/* Friction that is in another mode than before the instant. One that was off, or is, tells nothing: its contact does. */
static lag_status report_frictions(lag_event_iteration *iteration, double t, const double *x)
{
    const lag_frictions *frictions = iteration->modes->frictions;
    const double *sticks = iteration->instant.stood + iteration->places.sticks;
    lag_status status = LAG_OK;
    for (size_t k = 0; k < iteration->motion->model->nfriction && status == LAG_OK; ++k) {
        const double *before = iteration->instant.stood + iteration->places.direction + (size_t)frictions->first[k];
        const double *now = lag_frictions_direction(frictions, k);
        const int stuck = *lag_frictions_sticks(frictions, k) != 0.0;
        const int reverses = lag_frictions_components(frictions, k) == 1 && before[0] * now[0] < 0.0;
        if (lag_frictions_acts(frictions, k) && (stuck != (sticks[k] != 0.0) || reverses)) {
            status = lag_event_iteration_report(iteration, t, x, stuck ? LAG_STICKS : reverses ? LAG_REVERSES : LAG_SLIPS, k);
        }
    }
    return status;
}

lag_status lag_event_iteration_run(lag_event_iteration *iteration, double t, double *x, const double *relations, const double *sides)
{
    const lag_model *model = iteration->motion->model;
    const double *w = iteration->motion->w;
    lag_status status = sides != NULL ? lag_event_iteration_change_contacts(iteration, t, x, sides) : LAG_OK;
    iteration->clauses.stopped = 0;
    for (int k = 0; k < MOST_PASSES && status == LAG_OK; ++k) {
        int acted = 0;
        memcpy(iteration->discretes.before, w, model->nw * sizeof(double));
        status = pass(iteration, t, x, relations, &acted);
        if (status == LAG_OK && !acted && is_unchanged(iteration)) {
            return positions_jump(iteration, t, x) ? LAG_POSITION_JUMP : report_frictions(iteration, t, x);
        }
    }
    if (status != LAG_OK) {
        return status; /* what is guilty of it is known */
    }
    for (size_t i = 0; i < model->nw; ++i) {
        iteration->discretes.guilty[i] = iteration->discretes.before[i] != w[i];
    }
    for (size_t i = 0; i < model->ncontact; ++i) { /* blows do not open what constraints close */
        iteration->discretes.guilty[iteration->places.contact + i] += iteration->contacts->blows.approach[i] != 0.0;
    }
    return LAG_EVENT_ITERATION_FAILED;
}

/* ---- what is continuous ---- */

lag_status lag_event_iteration_check_positions(lag_event_iteration *iteration, double t, const double *x, double moment)
{
    const lag_model *model = iteration->motion->model;
    const double *stood = iteration->instant.from + 2 * model->nq;
    const double *was = with_states(iteration, x, stood);
    double *pierced = iteration->discretes.guilty + iteration->places.contact;
    lag_status status = lag_contacts_check_gaps(iteration->contacts, t, x, was, iteration->instant.stood, iteration->pulling, pierced);
    if (status != LAG_OK || model->nway == 0) {
        return status;
    }
    status = lag_position_maps_continue(&iteration->maps, t, x, was, iteration->instant.stood, moment, iteration->noise->peak);
    for (size_t i = 0; i < model->nw && status == LAG_WAY_JUMP; ++i) {
        iteration->discretes.guilty[i] = iteration->motion->w[i] != iteration->instant.stood[i];
    }
    return status;
}
