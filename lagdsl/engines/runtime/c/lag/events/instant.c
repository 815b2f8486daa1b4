#include "lag/events/instant.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "lag/linalg/arena.h"
#include "lag/linalg/order.h"

static void place_iteration(lag_instants *instants, const lag_model *model, lag_layout *layout)
{
    lag_clauses *clauses = &instants->clauses;
    lag_lay_all(layout, model->nw, (double **const[]){&instants->discretes.before, &instants->discretes.next, &instants->discretes.guilty,
        &instants->discretes.settled, &instants->instant.stood, NULL});
    lag_lay_all(layout, model->nreset, (double **const[]){&clauses->reset, &clauses->value, NULL});
    lag_lay_all(layout, model->ncollision, (double **const[]){&clauses->collision, &clauses->restitution, NULL});
    clauses->stop = lag_lay(layout, model->nstop);
    clauses->fail = lag_lay(layout, model->nfail);
    lag_lay_all(layout, lag_motion_size(model), (double **const[]){&clauses->held, &instants->trial.point, &instants->instant.from, NULL});
    instants->trial.states = lag_lay(layout, model->nz);
    lag_lay_all(layout, model->nindicator, (double **const[]){&instants->sides.now, &instants->sides.side, &instants->sides.before,
        &instants->sides.truth, NULL});
    instants->trial.gap = lag_lay(layout, model->ncontact);
    instants->leaving.flags = lag_lay(layout, model->ncontact + model->nfriction);
    instants->leaving.modes = lag_lay(layout, 2 * model->ncontact + model->nfriction + model->nslip);
    instants->instant.moment = 1e-9;
}

void lag_instants_place(lag_instants *instants, lag_motion *motion, lag_projection *projection, lag_clock *clocks, lag_layout *layout)
{
    const lag_model *model = motion->model;
    const double infinite = (double)INFINITY;
    *instants = (lag_instants){.motion = motion, .projection = projection, .clocks.each = clocks};
    lag_lay_all(layout, model->nclock, (double **const[]){&instants->clocks.first, &instants->clocks.period, NULL});
    lag_contacts_place(&instants->contacts, motion, layout);
    instants->contacts.limits = projection->limits;
    instants->contacts.impulse = &instants->impulse;
    instants->contacts.frictions = &instants->frictions;
    lag_frictions_place(&instants->frictions, motion, &instants->contacts, layout);
    lag_modes_place(&instants->modes, &instants->contacts, &instants->frictions, layout);
    lag_noise_place(&instants->noise, &instants->contacts, layout);
    lag_impulse_place(&instants->impulse, motion, layout);
    lag_timed_place(&instants->timed, motion, layout);
    lag_refraction_place(&instants->refraction, &instants->contacts, &instants->noise, layout);
    lag_position_maps_place(&instants->maps, motion, layout);
    place_iteration(instants, model, layout);
    instants->crowd = instants->resets = (lag_crowd){.last = -infinite, .interval = infinite, .first = infinite};
}

/* ---- clocks ---- */

static lag_status start_clocks(lag_instants *instants, double t)
{
    const lag_model *model = instants->motion->model;
    instants->motion->at.t = t;
    const lag_status status =
        model->nclock > 0 ? model->clock(&instants->motion->at, instants->clocks.first, instants->clocks.period) : LAG_OK;
    for (size_t i = 0; i < model->nclock && status == LAG_OK; ++i) {
        if (!(instants->clocks.period[i] > 0.0) || !isfinite(instants->clocks.first[i])) {
            return LAG_BAD_CLOCK;
        }
        instants->clocks.each[i] = lag_clock_of(instants->clocks.first[i], instants->clocks.period[i]);
        lag_clock_enter(&instants->clocks.each[i], t);
    }
    return status;
}

double lag_instants_next(const lag_instants *instants)
{
    const double next = lag_lower(lag_timed_next(&instants->timed), lag_contacts_end_of_bounces(&instants->contacts));
    return lag_lower(next, lag_clocks_next(instants->motion->model->nclock, instants->clocks.each));
}

/* True if a clock ticks, or bounces are over. */
static int is_reported(const lag_instants *instants, double t)
{
    const size_t count = instants->motion->model->nclock;
    return lag_clocks_due(count, instants->clocks.each, t) < count || lag_contacts_end_of_bounces(&instants->contacts) <= t;
}

int lag_instants_due(const lag_instants *instants, double t)
{
    const int jumps = lag_delays_next(&instants->motion->delays) <= lag_timed_behind(&instants->timed, t);
    return is_reported(instants, t) || jumps || instants->timed.next <= t;
}

double lag_instants_same(const lag_instants *instants, double t)
{
    return lag_clocks_same(instants->motion->model->nclock, instants->clocks.each, t);
}

/* Clocks that tick now, into w; they go on to their next tick. */
static lag_status tick_clocks(lag_instants *instants, double t, const double *x)
{
    lag_status status = LAG_OK;
    for (size_t i = 0; i < instants->motion->model->nclock && status == LAG_OK; ++i) {
        if (lag_clock_is_due(&instants->clocks.each[i], t)) {
            ++instants->clocks.each[i].next;
            instants->motion->w[instants->motion->places.clock + i] = 1.0;
            status = lag_instants_report(instants, t, x, LAG_TICK, i);
        }
    }
    return status;
}

/* Contacts whose bounces are over now have closed. */
static lag_status report_rest(lag_instants *instants, double t, const double *x)
{
    lag_contacts *contacts = &instants->contacts;
    lag_status status = LAG_OK;
    for (size_t i = 0; i < instants->motion->model->ncontact && status == LAG_OK; ++i) {
        if (contacts->until[i] <= t) {
            contacts->until[i] = (double)INFINITY;
            status = *lag_contacts_flag(contacts, i) != 0.0 ? lag_instants_report(instants, t, x, LAG_CLOSED, i) : LAG_OK;
        }
    }
    return status;
}

/* ---- instants ---- */

static lag_status run(lag_instants *instants, double t, double *x, const double *relations, const double *sides)
{
    lag_status status = lag_instants_run(instants, t, x, relations, sides);
    if (status == LAG_OK && instants->timed.next > t) {
        status = lag_timed_find_next(&instants->timed, t);
    }
    return status == LAG_OK && instants->clauses.stopped ? LAG_STOPPED : status;
}

/* The discretes and the state before an instant. */
static void remember(lag_instants *instants, const double *x)
{
    memcpy(instants->instant.from, x, lag_motion_size(instants->motion->model) * sizeof(double));
    memcpy(instants->instant.stood, instants->motion->w, instants->motion->model->nw * sizeof(double));
    instants->instant.acted = 0;
    instants->modes.jumped = 0;
}

/* Relations and conditions as they stand at the start; time goes on, so that conditions that it makes true at once act. */
static lag_status initialize(lag_instants *instants, double t, const double *x)
{
    const lag_places *places = &instants->motion->places;
    const size_t count = places->clock - places->condition;
    double *conditions = instants->motion->w + places->condition;
    lag_status status = lag_timed_set(&instants->timed, t);
    status = status == LAG_OK ? lag_instants_initialize(instants, t, x) : status;
    if (instants->motion->model->ntimed == 0 || status != LAG_OK) {
        return status;
    }
    memcpy(instants->instant.stood, conditions, count * sizeof(double));
    status = lag_timed_set_behind(&instants->timed, t);
    status = status == LAG_OK ? lag_instants_initialize(instants, t, x) : status;
    memcpy(conditions, instants->instant.stood, count * sizeof(double));
    return status;
}

lag_status lag_instants_begin(lag_instants *instants, double t, double *x)
{
    lag_motion *motion = instants->motion;
    const lag_model *model = motion->model;
    motion->at.t = t;
    lag_status status = model->discrete_start(&motion->at, motion->w);
    instants->timed.length = instants->contacts.length;
    instants->timed.shown = t;
    status = status == LAG_OK ? initialize(instants, t, x) : status;
    double *pierced = instants->discretes.guilty + instants->motion->places.contact;
    status = status == LAG_OK ? lag_contacts_begin(&instants->contacts, t, x, instants->contacts.blows.closing, pierced) : status;
    instants->modes.jumped = 1; /* nothing is known of them */
    status = status == LAG_OK ? lag_modes_find(&instants->modes, t, x, instants->contacts.blows.closing, NULL) : status;
    status = status == LAG_OK ? start_clocks(instants, t) : status;
    status = status == LAG_OK ? tick_clocks(instants, t, x) : status;
    if (status != LAG_OK) {
        return status;
    }
    if (instants->motion->places.initial < model->nw) {
        motion->w[instants->motion->places.initial] = 1.0;
    }
    remember(instants, x);
    instants->sides.begins = 1;
    status = run(instants, t, x, NULL, NULL);
    instants->sides.begins = 0;
    return status;
}

lag_status lag_instants_end(lag_instants *instants, double t, double *x)
{
    if (instants->motion->places.terminal == instants->motion->model->nw) {
        return LAG_OK;
    }
    remember(instants, x);
    instants->motion->w[instants->motion->places.terminal] = 1.0;
    return run(instants, t, x, NULL, NULL);
}

/* The momenta at x with other inputs u (nu). */
static lag_status keep_with(lag_instants *instants, double t, const double *x, const double *u)
{
    lag_motion *motion = instants->motion;
    lag_inputs *const inputs = motion->inputs;
    motion->inputs = NULL;
    motion->at.u = u;
    const lag_status status = lag_impulse_keep_momenta(&instants->impulse, t, x, motion->w);
    motion->at.u = motion->u;
    motion->inputs = inputs;
    lag_motion_set_state(motion, t, x);
    return status;
}

lag_status lag_instants_prescribe(lag_instants *instants, double t, double *x, const double *before, int blow)
{
    int jumped = 0;
    remember(instants, x);
    lag_status status = keep_with(instants, t, x, before);
    if (status == LAG_OK) {
        status = lag_impulse_balance(&instants->impulse, t, x, NULL, NULL, &jumped);
        instants->modes.jumped = 1;
    }
    if (status != LAG_OK || !blow || instants->motion->model->ncontact + instants->motion->model->nfriction == 0) {
        return status;
    }
    status = lag_contacts_open(&instants->contacts, t, x, 0);
    return status == LAG_OK ? run(instants, t, x, NULL, NULL) : status;
}

/* Carries out the changes with time that are due now, with their impulses. */
static lag_status change_with_time(lag_instants *instants, double t, double *x, int *jumped)
{
    lag_impulse *impulse = &instants->impulse;
    *jumped = 0;
    lag_status status = lag_impulse_keep_momenta(impulse, t, x, instants->motion->w);
    if (status == LAG_OK) {
        status = lag_timed_change(&instants->timed, t);
    }
    instants->modes.jumped = 1;
    return status == LAG_OK ? lag_impulse_balance(impulse, t, x, NULL, NULL, jumped) : status;
}

/* Tells changes with time, and relations that have turned so far. */
static lag_status report_turns(lag_instants *instants, double t, const double *x)
{
    const lag_model *model = instants->motion->model;
    const double *now = instants->motion->w + instants->motion->places.relation;
    const double *before = instants->instant.stood + instants->motion->places.relation;
    lag_status status = LAG_OK;
    for (size_t k = 0; k < model->ntimed + model->nindicator && status == LAG_OK; ++k) {
        const size_t i = k < model->ntimed ? model->nindicator + k : k - model->ntimed;
        const double told = i < model->nindicator ? 1.0 : instants->timed.told[i - model->nindicator];
        if (told != 0.0 && now[i] != before[i]) {
            status = lag_instants_report(instants, t, x, told != 1.0 ? LAG_JUMP : now[i] != 0.0 ? LAG_TRUE : LAG_FALSE, i);
        }
    }
    return status;
}

lag_status lag_instants_change_unreported(lag_instants *instants, double t, double *x, int *quiet)
{
    int jumped = 0;
    *quiet = 0;
    if (is_reported(instants, t)) {
        return LAG_OK;
    }
    remember(instants, x);
    lag_status status = change_with_time(instants, t, x, &jumped);
    *quiet = !jumped && !lag_timed_is_reported(&instants->timed) && lag_contacts_are_at_rest(&instants->contacts, t, x);
    if (!*quiet) {
        lag_instants_take_back(instants, x);
    }
    return status;
}

void lag_instants_take_back(const lag_instants *instants, double *x)
{
    const lag_model *model = instants->motion->model;
    memcpy(x, instants->instant.from, lag_motion_size(model) * sizeof(double));
    memcpy(instants->motion->w, instants->instant.stood, model->nw * sizeof(double));
    lag_delays_take_back(&instants->motion->delays);
}

/* Carries out all that is due before the clauses: changes with time, clocks, the end of bounces. */
static lag_status carry_out_due(lag_instants *instants, double t, double *x)
{
    int jumped = 0;
    const int due = lag_timed_due(&instants->timed, t);
    lag_status status = due ? change_with_time(instants, t, x, &jumped) : LAG_OK;
    status = status == LAG_OK ? report_rest(instants, t, x) : status;
    status = status == LAG_OK ? tick_clocks(instants, t, x) : status;
    instants->timed.next = due ? (double)INFINITY : instants->timed.next;
    return status;
}

lag_status lag_instants_carry_out(lag_instants *instants, double t, double *x, double *changed, int located, int ticks)
{
    const lag_model *model = instants->motion->model;
    const double *truth = instants->motion->w + instants->motion->places.relation;
    remember(instants, x);
    lag_status status = ticks ? carry_out_due(instants, t, x) : LAG_OK;
    status = ticks && status == LAG_OK ? lag_instants_find_turning(instants, t, x, changed) : status;
    const int any = lag_any(model->nindicator, changed);
    instants->sides.located = located ? changed : NULL;
    for (size_t i = 0; i < model->nindicator && status == LAG_OK; ++i) {
        if (changed[i] != 0.0 && truth[i] == instants->instant.stood[instants->motion->places.relation + i]) {
            status = lag_instants_turn(instants, t, x, i, &instants->instant.acted);
        }
    }
    instants->leaving.turned = any || ticks;
    status = status == LAG_OK ? report_turns(instants, t, x) : status;
    if (status == LAG_OK) {
        status = run(instants, t, x, changed, changed + model->nindicator);
    }
    instants->sides.located = NULL;
    lag_fill(model->ncontact, 0.0, instants->contacts.blows.met);
    status = status == LAG_OK ? lag_instants_check_positions(instants, t, x) : status;
    const int sunk = located && status == LAG_OK && any && lag_instants_accumulates(instants, t, x, changed);
    const int crowds = located && lag_crowds(&instants->crowd, t, instants->contacts.length, any);
    if (!(sunk || crowds) || (status != LAG_OK && status != LAG_STOPPED)) {
        return status;
    }
    memcpy(instants->discretes.guilty + instants->motion->places.relation, changed, model->nindicator * sizeof(double));
    memcpy(instants->discretes.guilty + instants->motion->places.contact, changed + model->nindicator, model->ncontact * sizeof(double));
    memcpy(instants->discretes.guilty + instants->motion->places.sticks, changed + model->nindicator + model->ncontact, model->nfriction * sizeof(double));
    return LAG_CHATTER;
}

void lag_instants_after(lag_instants *instants, double t, double h)
{
    instants->instant.moment = lag_instants_resolution(instants, t, h);
    instants->frictions.step = h;
}
