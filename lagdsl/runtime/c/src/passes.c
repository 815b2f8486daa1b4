#include "lag/passes.h"

#include <math.h>
#include <string.h>

#include "lag/memory.h"

enum { MOST_PASSES = 100 };
/* What a constraint that discretes switch may be off the positions, as a part of the size of its row. */
static const double TORN = 1e-6;

size_t lag_passes_memory(const lag_model *model)
{
    return 4 * model->nw + 2 * model->nreset + 2 * model->ncollision + model->nstop + model->nfail +
           3 * lag_motion_size(model) + 2 * model->nindicator + 3 * model->ncontact;
}

void lag_passes_place(
    lag_passes *passes, lag_contacts *contacts, lag_momentum *momentum, lag_timed *timed, lag_projection *projection, lag_noise *noise,
    double *memory)
{
    const lag_model *model = contacts->motion->model;
    const size_t size = lag_motion_size(model);
    memset(passes, 0, sizeof *passes);
    passes->motion = contacts->motion;
    passes->contacts = contacts;
    passes->momentum = momentum;
    passes->timed = timed;
    passes->projection = projection;
    passes->noise = noise;
    passes->places = lag_places_of(model);
    passes->moment = 1e-9;
    passes->before = lag_take(&memory, model->nw);
    passes->next = lag_take(&memory, model->nw);
    passes->guilty = lag_take(&memory, model->nw);
    passes->settled = lag_take(&memory, model->nw);
    memset(passes->settled, 0, model->nw * sizeof(double));
    passes->reset = lag_take(&memory, model->nreset);
    passes->value = lag_take(&memory, model->nreset);
    passes->collision = lag_take(&memory, model->ncollision);
    passes->restitution = lag_take(&memory, model->ncollision);
    passes->stop = lag_take(&memory, model->nstop);
    passes->fail = lag_take(&memory, model->nfail);
    passes->held = lag_take(&memory, size);
    passes->rate = lag_take(&memory, size);
    passes->later = lag_take(&memory, size);
    passes->now = lag_take(&memory, model->nindicator);
    passes->then = lag_take(&memory, model->nindicator);
    passes->closed = lag_take(&memory, model->ncontact);
    passes->meeting = lag_take(&memory, model->ncontact);
    passes->pulling = memory;
}

lag_status lag_passes_tell(const lag_passes *passes, double t, const double *x, lag_what what, size_t which)
{
    const lag_happening happening = {.t = t, .what = what, .which = which, .x = x, .w = passes->motion->w};
    return passes->tell != NULL ? passes->tell(passes->context, &happening) : LAG_OK;
}

static int same(size_t count, const double *a, const double *b)
{
    size_t i = 0;
    while (i < count && a[i] == b[i]) {
        ++i;
    }
    return i == count;
}

/* ---- one pass ---- */

static lag_status look(lag_passes *passes, double t, const double *x)
{
    const lag_model *model = passes->motion->model;
    lag_passes_solve(passes->motion, t, x);
    return model->event(&passes->motion->at, passes->next, passes->reset, passes->value, passes->collision, passes->restitution,
        passes->stop, passes->fail);
}

lag_status lag_passes_settle(lag_passes *passes, double t, const double *x)
{
    const lag_model *model = passes->motion->model;
    const lag_places *places = &passes->places;
    double *w = passes->motion->w;
    lag_status status = LAG_OK;
    for (int k = 0; k < MOST_PASSES && status == LAG_OK; ++k) {
        memcpy(passes->before, w, model->nw * sizeof(double));
        status = lag_passes_stand(passes, t, x);
        if (status == LAG_OK) {
            status = look(passes, t, x);
        }
        for (size_t i = places->condition; i < places->clock; ++i) {
            w[i] = passes->next[i];
        }
        if (same(model->nw, passes->before, w)) {
            break;
        }
    }
    memcpy(passes->settled, w, model->nw * sizeof(double));
    return status;
}

/* ---- contacts ---- */

/* A contact has opened, or closed. What was told of it for later does not come. */
static lag_status tell_state(const lag_passes *passes, double t, const double *x, lag_what what, size_t i)
{
    passes->contacts->until[i] = (double)INFINITY;
    return lag_passes_tell(passes, t, x, what, i);
}

/* What a contact that struck or changed did. One that is held for the rest of its bounces has struck. */
static lag_status tell_contact(const lag_passes *passes, double t, const double *x, int before, size_t i)
{
    const int now = passes->motion->w[passes->places.contact + i] != 0.0;
    const int bounces = now && passes->contacts->until[i] < (double)INFINITY;
    return before == now || bounces ? lag_passes_tell(passes, t, x, LAG_IMPACT, i)
                                    : tell_state(passes, t, x, now ? LAG_CLOSED : LAG_OPENED, i);
}

/* Impacts, and what they did. */
static lag_status collide(lag_passes *passes, double t, double *x, const double *collision, int *acted)
{
    const lag_contacts *contacts = passes->contacts;
    const double *closed = passes->motion->w + passes->places.contact;
    lag_status status = lag_contacts_strike(passes->contacts, t, x, collision, passes->restitution);
    int any = contacts->struck > 0;
    for (size_t k = 0; k < contacts->struck && status == LAG_OK; ++k) {
        const size_t i = (size_t)contacts->order[k];
        status = tell_contact(passes, t, x, contacts->before[i] != 0.0, i);
    }
    for (size_t i = 0; i < passes->motion->model->ncontact && status == LAG_OK; ++i) {
        if (contacts->approach[i] == 0.0 && (contacts->before[i] != 0.0) != (closed[i] != 0.0)) {
            any = 1;
            status = tell_contact(passes, t, x, contacts->before[i] != 0.0, i);
        }
    }
    *acted = *acted || any;
    return status == LAG_OK && any ? lag_projection_rates(passes->projection, t, x, NULL) : status;
}

/* Clears the flags of contacts that do not pull a moment later: relations that turned with them may have taken the pull away. */
static void keep_pulling(lag_passes *passes, double t, const double *x, double *pulling)
{
    lag_motion *motion = passes->motion;
    lag_passes_move_on(passes, t, x);
    lag_passes_solve(motion, t + passes->moment, passes->later);
    for (size_t i = 0; i < motion->model->ncontact; ++i) {
        const double force = motion->lam[motion->model->contact_rows[i]];
        pulling[i] = pulling[i] != 0.0 && force < -lag_contacts_force_noise(passes->contacts, i);
    }
}

/* Contacts that pull open; the others strike, or, if they meet without speed, close as far as they push. */
static lag_status change_contacts(lag_passes *passes, double t, double *x, const double *relations, const double *changed)
{
    const lag_model *model = passes->motion->model;
    const size_t count = model->ncontact;
    double *closed = passes->motion->w + passes->places.contact;
    double *meeting = passes->meeting;
    double *pulling = passes->pulling;
    lag_status status = LAG_OK;
    int acted = 0;
    for (size_t i = 0; i < count; ++i) {
        meeting[i] = changed[i] != 0.0 && closed[i] == 0.0;
        pulling[i] = changed[i] != 0.0 && closed[i] != 0.0;
    }
    if (relations != NULL && lag_any(model->nindicator, relations) && lag_any(count, pulling)) {
        keep_pulling(passes, t, x, pulling);
    }
    for (size_t i = 0; i < count; ++i) {
        closed[i] = pulling[i] != 0.0 ? 0.0 : closed[i];
    }
    for (size_t i = 0; i < count && status == LAG_OK; ++i) {
        status = pulling[i] != 0.0 ? tell_state(passes, t, x, LAG_OPENED, i) : LAG_OK;
    }
    const int any = lag_any(count, meeting) || lag_any(count, pulling);
    if (any && status == LAG_OK) {
        status = collide(passes, t, x, NULL, &acted);
    }
    if (!any || acted || status != LAG_OK) {
        return status;
    }
    lag_contacts_press(passes->contacts, t, x, meeting);
    for (size_t i = 0; i < count && status == LAG_OK; ++i) {
        status = meeting[i] != 0.0 && closed[i] != 0.0 ? tell_state(passes, t, x, LAG_CLOSED, i) : LAG_OK;
    }
    return status;
}

/* Impacts of clauses, and contacts that something drives in now. */
static lag_status strike(lag_passes *passes, double t, double *x, int *acted)
{
    const lag_model *model = passes->motion->model;
    const int any = lag_any(model->ncollision, passes->collision);
    if (!any && model->ncontact == 0) {
        return LAG_OK;
    }
    *acted = *acted || any;
    return collide(passes, t, x, passes->collision, acted);
}

/* ---- clauses ---- */

/* Resets of one pass into x; 1 in `held`: this one. */
static lag_status reset(lag_passes *passes, double t, double *x, int *any)
{
    const lag_model *model = passes->motion->model;
    lag_status status = LAG_OK;
    int conflict = 0;
    memset(passes->held, 0, lag_motion_size(model) * sizeof(double));
    for (size_t i = 0; i < model->nreset; ++i) {
        const size_t place = model->reset_places[i];
        if (passes->reset[i] == 0.0) {
            continue;
        }
        *any = 1;
        if (passes->held[place] == 0.0) {
            passes->held[place] = 1.0;
            x[place] = passes->value[i];
        } else if (x[place] != passes->value[i]) {
            passes->fault = i;
            conflict = 1;
        }
    }
    for (size_t i = 0; i < model->nreset && status == LAG_OK; ++i) {
        status = passes->reset[i] != 0.0 ? lag_passes_tell(passes, t, x, LAG_REINIT, i) : LAG_OK;
    }
    return status == LAG_OK && conflict ? LAG_CONFLICT : status;
}

/* Closed contacts that a reset moves apart open. */
static lag_status part(lag_passes *passes, double t, const double *x)
{
    const size_t count = passes->motion->model->ncontact;
    const double *closed = passes->motion->w + passes->places.contact;
    memcpy(passes->closed, closed, count * sizeof(double));
    lag_status status = lag_contacts_part(passes->contacts, t, x);
    for (size_t i = 0; i < count && status == LAG_OK; ++i) {
        status = passes->closed[i] != closed[i] ? tell_state(passes, t, x, LAG_OPENED, i) : LAG_OK;
    }
    return status;
}

/* Failures, ends and resets of one pass. */
static lag_status act(lag_passes *passes, double t, double *x, int *acted)
{
    const lag_model *model = passes->motion->model;
    lag_status status = LAG_OK;
    for (size_t i = 0; i < model->nfail; ++i) {
        if (passes->fail[i] != 0.0) {
            passes->fault = i;
            return LAG_REFUSED;
        }
    }
    for (size_t i = 0; i < model->nstop && status == LAG_OK; ++i) {
        if (passes->stop[i] != 0.0) {
            passes->stopped = 1;
            status = lag_passes_tell(passes, t, x, LAG_TERMINATE, i);
        }
    }
    if (status == LAG_OK) {
        status = reset(passes, t, x, acted);
    }
    return status == LAG_OK && *acted ? part(passes, t, x) : status;
}

/* 1: other discretes than contacts are those with which the rates were moved onto the constraints last. */
static int is_settled(const lag_passes *passes)
{
    const lag_places *places = &passes->places;
    const size_t relations = passes->motion->model->nindicator;
    const double *w = passes->motion->w;
    return same(places->contact, w, passes->settled) && same(relations, w + places->relation, passes->settled + places->relation);
}

/* The discretes now, but for variables and relations as they were when the rates were moved onto the constraints last. */
static const double *settled_before(lag_passes *passes)
{
    const lag_places *places = &passes->places;
    const lag_model *model = passes->motion->model;
    memcpy(passes->next, passes->before, model->nw * sizeof(double));
    memcpy(passes->next, passes->settled, places->contact * sizeof(double));
    memcpy(passes->next + places->relation, passes->settled + places->relation, model->nindicator * sizeof(double));
    return passes->next;
}

/*
 * Discretes that stand in constraints, masses or prescribed motions may have changed, whoever changed them: momenta are balanced. Else, after
 * resets, rates go onto the constraints. Those that were reset stay as far as that can be; contacts follow, they only push.
 */
static lag_status take_hold(lag_passes *passes, double t, double *x, int acted)
{
    const double *held = acted ? passes->held + passes->motion->model->nq : NULL;
    int jumped = 0;
    if (is_settled(passes)) {
        return acted ? lag_projection_rates(passes->projection, t, x, held) : LAG_OK;
    }
    const lag_status status = lag_momentum_keep(passes->momentum, t, x, settled_before(passes));
    memcpy(passes->settled, passes->motion->w, passes->motion->model->nw * sizeof(double));
    return status == LAG_OK ? lag_momentum_balance(passes->momentum, t, x, held, &jumped) : status;
}

lag_status lag_passes_settled(lag_passes *passes, double t, double *x)
{
    int jumped = 0;
    const lag_status status = lag_momentum_keep(passes->momentum, t, x, passes->motion->w);
    memcpy(passes->settled, passes->motion->w, passes->motion->model->nw * sizeof(double));
    return status == LAG_OK ? lag_momentum_balance(passes->momentum, t, x, NULL, &jumped) : status;
}

/* One pass; `acted`: it did more than to change w. */
static lag_status pass(lag_passes *passes, double t, double *x, const double *turned, int *acted)
{
    lag_motion *motion = passes->motion;
    lag_status status = look(passes, t, x);
    if (status != LAG_OK) {
        return status;
    }
    memcpy(motion->w, passes->next, motion->model->nw * sizeof(double));
    lag_places_clear(motion->model, &passes->places, motion->w);
    if (!same(passes->places.contact, motion->w, passes->before)) {
        status = lag_timed_enter(passes->timed, t); /* corners of time may depend on discretes */
    }
    status = status == LAG_OK ? act(passes, t, x, acted) : status;
    if (status == LAG_OK) {
        status = take_hold(passes, t, x, *acted);
    }
    if (status == LAG_OK) {
        status = strike(passes, t, x, acted);
    }
    return status == LAG_OK ? lag_passes_ahead(passes, t, x, turned) : status;
}

/* 1: a constraint that discretes switch asks for other positions. */
static int torn(const lag_passes *passes, double t, const double *x)
{
    const lag_model *model = passes->motion->model;
    for (size_t i = 0; i < model->nswitched; ++i) {
        if (!(lag_projection_distance(passes->projection, t, x, model->switched_rows[i]) <= TORN)) {
            return 1;
        }
    }
    return 0;
}

lag_status lag_passes_run(lag_passes *passes, double t, double *x, const double *relations, const double *contacts)
{
    const lag_model *model = passes->motion->model;
    const double *w = passes->motion->w;
    lag_status status = contacts != NULL ? change_contacts(passes, t, x, relations, contacts) : LAG_OK;
    passes->stopped = 0;
    for (int k = 0; k < MOST_PASSES && status == LAG_OK; ++k) {
        int acted = 0;
        memcpy(passes->before, w, model->nw * sizeof(double));
        status = pass(passes, t, x, relations, &acted);
        if (status == LAG_OK && !acted && same(model->nw, passes->before, w)) {
            return torn(passes, t, x) ? LAG_TORN : LAG_OK;
        }
    }
    for (size_t i = 0; i < model->nw; ++i) {
        passes->guilty[i] = passes->before[i] != w[i];
    }
    return status == LAG_OK ? LAG_UNSETTLED : status;
}
