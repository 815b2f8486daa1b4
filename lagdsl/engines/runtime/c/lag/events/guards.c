#include "lag/events/guards.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "lag/linalg/arena.h"

/* ---- guards: relations, contacts, frictions, corners ---- */

size_t lag_guards_count(const lag_guards *guards)
{
    return lag_guard_count(guards->motion->model) + guards->corners.count;
}

static int is_closed(const lag_guards *guards, size_t k)
{
    return guards->motion->w[guards->motion->places.contact + k] != 0.0;
}

/* Finds the terms of all values, where `motion` is; not `with_forces` those of gaps, and of corners of places and rates. */
static lag_status evaluate_terms(lag_guards *guards, int with_forces)
{
    const lag_motion *motion = guards->motion;
    const lag_model *model = motion->model;
    const int with_friction = with_forces && model->nfriction > 0;
    double solved = 0.0;
    lag_status status = with_forces && model->nindicator > 0 ? model->indicator(&motion->at, guards->g) : LAG_OK;
    status = status == LAG_OK && model->ncontact > 0 ? lag_contacts_evaluate(guards->contacts) : status;
    status = status == LAG_OK && with_friction ? lag_frictions_evaluate(guards->frictions) : status;
    status = status == LAG_OK && with_friction ? lag_reserve_evaluate(guards->reserve) : status;
    return status == LAG_OK && guards->corners.count > 0 ? model->corner(&motion->at, guards->corners.far, &solved) : status;
}

static double relation(const lag_guards *guards, size_t k)
{
    const int holds = guards->motion->w[guards->motion->places.relation + k] != 0.0;
    return guards->held[k] != 0.0 ? 1.0 : holds ? guards->g[k] : -guards->g[k];
}

static double contact(const lag_guards *guards, size_t k)
{
    const lag_motion *motion = guards->motion;
    if (!is_closed(guards, k)) {
        return lag_contacts_is_one_way(guards->contacts, k) ? guards->contacts->speed[k] : guards->contacts->gap[k];
    }
    const int shares = !isnan(guards->frictions->reserve[k]); /* friction of its group is watched */
    return shares ? (double)INFINITY : motion->lam[motion->model->contact_rows[k]];
}

static void take_values(lag_guards *guards)
{
    const lag_model *model = guards->motion->model;
    double *value = guards->value;
    for (size_t k = 0; k < model->nindicator; ++k) {
        *value++ = relation(guards, k);
    }
    for (size_t k = 0; k < model->ncontact; ++k) {
        *value++ = contact(guards, k);
    }
    for (size_t k = 0; k < model->nfriction; ++k) {
        *value++ = lag_frictions_guard(guards->frictions, k);
    }
    for (size_t k = 0; k < guards->corners.count; ++k) {
        *value++ = guards->corners.side[k] * guards->corners.far[k];
    }
}

int lag_guards_has_noise(const lag_guards *guards, size_t which)
{
    const lag_model *model = guards->motion->model;
    return which < model->nindicator || which >= lag_guard_count(model);
}

double lag_guards_noise(const lag_guards *guards, size_t which)
{
    const lag_model *model = guards->motion->model;
    const size_t k = which - model->nindicator;
    if (lag_guards_has_noise(guards, which)) {
        return guards->noise->sigma[which < model->nindicator ? which : k - model->ncontact - model->nfriction + model->nindicator];
    }
    if (k >= model->ncontact) {
        return lag_frictions_dead_band(guards->frictions, k - model->ncontact);
    }
    return is_closed(guards, k) ? lag_contacts_force_noise(guards->contacts, k) : lag_contacts_gap_noise(guards->contacts, k);
}

int lag_guards_touches(const lag_guards *guards, size_t which)
{
    const lag_model *model = guards->motion->model;
    const size_t k = which - model->nindicator - model->ncontact; /* large for others */
    return k < model->nfriction && lag_frictions_components(guards->frictions, k) > 1 && *lag_frictions_sticks(guards->frictions, k) == 0.0;
}

/* The size of the numbers that enter the guard of a contact or of friction. */
static double size_of(const lag_guards *guards, size_t which)
{
    const lag_contacts *contacts = guards->contacts;
    const size_t i = which - guards->motion->model->nindicator;
    if (i >= guards->motion->model->ncontact) {
        return lag_frictions_size(guards->frictions, i - guards->motion->model->ncontact);
    }
    return is_closed(guards, i) ? contacts->sizes.force[i] : lag_contacts_is_one_way(contacts, i) ? lag_contacts_pace(contacts, i) : lag_contacts_scale(contacts, i);
}

double lag_guards_known(const lag_guards *guards, size_t which)
{
    return !lag_guards_has_noise(guards, which) ? guards->noise->tolerance * size_of(guards, which) :
        lag_noise_known(guards->noise, which);
}

/* ---- memory ---- */

void lag_guards_place(lag_guards *guards, lag_motion *motion, lag_reserve *reserve, lag_noise *noise, lag_layout *layout)
{
    const lag_model *model = motion->model;
    const size_t count = lag_guard_count(model) + model->ncorner;
    *guards = (lag_guards){.motion = motion, .contacts = reserve->frictions->contacts, .frictions = reserve->frictions,
        .reserve = reserve, .noise = noise, .time = (double)NAN};
    lag_lay_all(layout, count, (double **const[]){&guards->value, &guards->changed, &guards->depth, &guards->band, &guards->top, &guards->pieces.root,
        &guards->pieces.found, &guards->pieces.sought, NULL});
    guards->pieces.seen = lag_lay(layout, count * LAG_PIECE_SAMPLES);
    guards->pieces.when = lag_lay_filled(layout, model->nindicator, -(double)INFINITY);
    guards->swing = lag_lay_filled(layout, model->nindicator, (double)INFINITY);
    guards->doubted = lag_lay_filled(layout, model->nindicator, (double)INFINITY);
    lag_lay_all(layout, model->nindicator, (double **const[]){&guards->held, &guards->g, NULL});
    lag_lay_all(layout, model->ncorner, (double **const[]){&guards->corners.far, &guards->corners.side, NULL});
    guards->pieces.limit = (double)INFINITY;
}

/* ---- looks ---- */

static int is_sought(const lag_guards *guards, size_t i)
{
    return guards->sought == NULL || guards->sought[i] != 0.0;
}

/* True if guard i may depend on accelerations or multipliers: those of open contacts do not. */
static int may_need_forces(const lag_guards *guards, size_t i)
{
    const lag_model *model = guards->motion->model;
    const size_t k = i - model->nindicator; /* large for relations */
    return (k >= model->ncontact || is_closed(guards, k)) && (i < lag_guard_count(model) || guards->corners.solved);
}

static lag_status evaluate(lag_guards *guards, double t, const double *x)
{
    const size_t count = lag_guards_count(guards);
    size_t i = 0;
    while (i < count && !(is_sought(guards, i) && may_need_forces(guards, i))) {
        ++i;
    }
    if (i == count) {
        lag_motion_set_state(guards->motion, t, x);
    }
    lag_status status = i < count ? lag_motion_solve(guards->motion, t, x) : LAG_OK;
    status = status == LAG_OK ? evaluate_terms(guards, i < count) : status;
    if (status == LAG_OK) {
        take_values(guards);
    }
    return status;
}

/* True if relation i is zero and does not hold there: one that `limit` or `min` ends at zero changes there, though it does not pass it. */
static int ends_at_zero(const lag_guards *guards, size_t i)
{
    const lag_model *model = guards->motion->model;
    return i < model->nindicator && guards->value[i] == 0.0 &&
        (guards->motion->w[guards->motion->places.relation + i] != 0.0) != lag_relation_holds(model, i, 0.0);
}

/* True if guard i has left its mode, but for its rounding error. */
static int may_have_left(const lag_guards *guards, size_t i)
{
    const double value = guards->value[i];
    return is_sought(guards, i) && value <= 0.0 && (-value > guards->depth[i] || ends_at_zero(guards, i));
}

/* True if guard i has left its mode: it is below its dead band. */
static int has_left(const lag_guards *guards, size_t i)
{
    const double noise = lag_guards_has_noise(guards, i) ? guards->band[i] : lag_guards_noise(guards, i);
    return -guards->value[i] > guards->depth[i] + noise || (ends_at_zero(guards, i) && guards->top[i] > LAG_CLEARLY * noise);
}

/* Finds the dead bands of guards that may have left at x at time t, where they are not known. */
static lag_status find_dead_bands(lag_guards *guards, double t, const double *x)
{
    int found = 0;
    for (size_t i = 0; i < lag_guards_count(guards); ++i) {
        if (guards->changed[i] != 0.0 && guards->band[i] == 0.0 && lag_guards_has_noise(guards, i)) {
            if (!found) {
                lag_noise_find(guards->noise, t, x);
            }
            found = 1;
            guards->band[i] = fmax(DBL_MIN, lag_guards_noise(guards, i));
        }
    }
    return found ? evaluate(guards, t, x) : LAG_OK;
}

lag_status lag_guards_detect(lag_guards *guards, double t, const double *x)
{
    const size_t count = lag_guards_count(guards);
    guards->time = t;
    lag_status status = evaluate(guards, t, x);
    for (size_t i = 0; i < count && status == LAG_OK; ++i) {
        guards->changed[i] = may_have_left(guards, i);
    }
    status = status == LAG_OK ? find_dead_bands(guards, t, x) : status;
    for (size_t i = 0; i < count && status == LAG_OK; ++i) {
        guards->changed[i] = guards->changed[i] != 0.0 && has_left(guards, i);
    }
    return status == LAG_OK && lag_any(count, guards->changed) ? LAG_EVENT_PENDING : status;
}

lag_status lag_guards_begin(lag_guards *guards, double t, const double *x)
{
    const lag_model *model = guards->motion->model;
    const size_t count = lag_guards_count(guards);
    if (count == 0) {
        return LAG_OK;
    }
    lag_contacts_follow(guards->contacts, x);
    guards->time = (double)NAN;
    const lag_status status = evaluate(guards, t, x);
    if (model->nfriction > 0 && status == LAG_OK) {
        lag_frictions_begin(guards->frictions); /* guards of slips in a plane begin with it */
    }
    for (size_t i = 0; i < count && status == LAG_OK; ++i) {
        const double value = guards->value[i];
        guards->depth[i] = fmax(-value, 0.0);
        guards->band[i] = 0.0;
        guards->top[i] = value;
    }
    for (size_t i = 0; i < model->nindicator && status == LAG_OK; ++i) {
        guards->swing[i] = fmax(guards->swing[i], fabs(guards->g[i]));
    }
    for (size_t k = 0; k < model->ncontact && status == LAG_OK; ++k) {
        const double force = is_closed(guards, k) ? fabs(contact(guards, k)) : 0.0;
        guards->contacts->sizes.force[k] = isfinite(force) ? fmax(guards->contacts->sizes.force[k], force) : guards->contacts->sizes.force[k];
    }
    return status;
}
