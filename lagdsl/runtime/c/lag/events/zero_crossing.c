#include "lag/events/zero_crossing.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "lag/linalg/arena.h"

/* A value beyond this many times its last known round-off is clear of round-off. */
static const double CLEARLY = 1e6;
/* The round-off of accelerations adds up in rates to this part of the largest ones, though constraints hold them. */
static const double CREEPING = 1e-12;

size_t lag_zero_crossing_memory(const lag_model *model)
{
    const size_t count = lag_guards(model) + model->ncorner;
    return 5 * model->nindicator + model->ngap * (2 + model->nq) + 3 * model->ncontact + 4 * model->ncorner + (7 + LAG_LOOKS) * count;
}

void lag_zero_crossing_place(lag_zero_crossing *crossings, lag_motion *motion, lag_frictions *frictions, lag_noise *noise, double *memory)
{
    const lag_model *model = motion->model;
    const size_t count = lag_guards(model) + model->ncorner;
    crossings->motion = motion;
    crossings->places = lag_places_of(model);
    crossings->contacts = frictions->contacts;
    crossings->frictions = frictions;
    crossings->noise = noise;
    crossings->changed = lag_take(&memory, count);
    crossings->depth = lag_take(&memory, count);
    crossings->band = lag_take(&memory, count);
    crossings->start = lag_take(&memory, count);
    crossings->moved = lag_take(&memory, count);
    crossings->creep = lag_take(&memory, model->nindicator + model->ncorner);
    crossings->root = lag_take(&memory, count);
    crossings->found = lag_take(&memory, count);
    crossings->when = lag_take(&memory, model->nindicator);
    crossings->hovers = lag_take(&memory, model->nindicator);
    crossings->doubted = lag_take(&memory, model->nindicator);
    for (size_t k = 0; k < LAG_LOOKS; ++k) {
        crossings->seen[k] = lag_take(&memory, count);
    }
    crossings->g = lag_take(&memory, model->nindicator);
    crossings->gap = lag_take(&memory, model->ngap);
    crossings->speed = lag_take(&memory, model->ngap);
    crossings->jacobian = lag_take(&memory, model->ngap * model->nq);
    crossings->far = lag_take(&memory, model->ncorner);
    crossings->side = lag_take(&memory, model->ncorner);
    crossings->beside = lag_take(&memory, model->ncorner);
    crossings->laws = memory;
    crossings->span = crossings->reach = 0.0;
    crossings->limit = (double)INFINITY;
    crossings->locating = 0;
    crossings->since = crossings->tolerance = 0.0;
    memset(crossings->depth, 0, count * sizeof(double));
    memset(crossings->band, 0, count * sizeof(double));
    memset(crossings->hovers, 0, model->nindicator * sizeof(double));
    memset(crossings->start, 0, count * sizeof(double));
    memset(crossings->moved, 0, count * sizeof(double));
    lag_fill(model->nindicator, -(double)INFINITY, crossings->when);
    lag_fill(model->nindicator, (double)INFINITY, crossings->doubted);
}

size_t lag_zero_crossing_count(const lag_zero_crossing *crossings)
{
    return lag_guards(crossings->motion->model) + crossings->corners;
}

static int is_closed(const lag_zero_crossing *crossings, size_t i)
{
    return crossings->motion->w[crossings->places.contact + i] != 0.0;
}

double lag_zero_crossing_value(const lag_zero_crossing *crossings, size_t which)
{
    const lag_motion *motion = crossings->motion;
    const size_t count = motion->model->nindicator;
    if (which < count) {
        const int holds = motion->w[crossings->places.relation + which] != 0.0;
        return holds ? crossings->g[which] : -crossings->g[which];
    }
    if (which >= lag_guards(motion->model)) {
        const size_t corner = which - lag_guards(motion->model);
        return crossings->side[corner] * crossings->far[corner];
    }
    if (which >= count + motion->model->ncontact) {
        return lag_frictions_guard(crossings->frictions, which - count - motion->model->ncontact);
    }
    const size_t contact = which - count;
    const double *open = lag_contacts_is_one_way(crossings->contacts, contact) ? crossings->speed : crossings->gap;
    return is_closed(crossings, contact) ? motion->lam[motion->model->contact_rows[contact]] : open[contact];
}

/* The place of a relation or corner in lag_noise. */
static size_t place_of(const lag_zero_crossing *crossings, size_t which)
{
    const lag_model *model = crossings->motion->model;
    return which < model->nindicator ? which : which - model->ncontact - model->nfriction;
}

double lag_zero_crossing_noise(const lag_zero_crossing *crossings, size_t which)
{
    const size_t count = crossings->motion->model->nindicator;
    if (lag_zero_crossing_has_noise(crossings, which)) {
        return crossings->noise->sigma[place_of(crossings, which)];
    }
    if (which >= count + crossings->motion->model->ncontact) {
        return lag_frictions_band(crossings->frictions, which - count - crossings->motion->model->ncontact);
    }
    return is_closed(crossings, which - count) ? lag_contacts_force_noise(crossings->contacts, which - count)
                                           : lag_contacts_gap_noise(crossings->contacts, which - count);
}

double lag_zero_crossing_known(const lag_zero_crossing *crossings, size_t which)
{
    return lag_noise_known(crossings->noise, place_of(crossings, which), crossings->tolerance);
}

/* So far below zero value `which` may be. */
static double least_of(const lag_zero_crossing *crossings, size_t which)
{
    const double depth = crossings->depth[which];
    if (!crossings->locating) {
        return crossings->band[which];
    }
    return depth > 0.0 ? depth : fmin(crossings->band[which], lag_zero_crossing_noise(crossings, which));
}

/* A relation that stood at zero when it was looked at first changes as soon as its truth does, others where they leave their bands. */
static lag_status relations(lag_zero_crossing *crossings)
{
    const lag_model *model = crossings->motion->model;
    const lag_status status = model->indicator(&crossings->motion->at, crossings->g);
    for (size_t i = 0; i < model->nindicator; ++i) {
        const double g = crossings->g[i];
        const int truth = g > 0.0 || (g == 0.0 && model->strict[i] == 0);
        const int differs = truth != (crossings->motion->w[crossings->places.relation + i] != 0.0);
        crossings->changed[i] = differs && (!(crossings->band[i] > 0.0) || -lag_zero_crossing_value(crossings, i) > least_of(crossings, i));
    }
    return status;
}

static lag_status look_at_gaps(lag_zero_crossing *crossings)
{
    const lag_model *model = crossings->motion->model;
    double *laws = crossings->laws;
    const lag_status status = model->contact(&crossings->motion->at, crossings->gap, crossings->speed, crossings->jacobian, laws,
        laws + model->ncontact, laws + 2 * model->ncontact);
    if (status == LAG_OK) {
        lag_contacts_scale(crossings->contacts, crossings->jacobian);
    }
    return status;
}

static lag_status contacts(lag_zero_crossing *crossings)
{
    const lag_model *model = crossings->motion->model;
    const lag_status status = look_at_gaps(crossings);
    for (size_t i = model->nindicator; i < model->nindicator + model->ncontact; ++i) {
        const double least = fmax(crossings->band[i], lag_zero_crossing_noise(crossings, i));
        crossings->changed[i] = -lag_zero_crossing_value(crossings, i) > least;
    }
    return status;
}

static lag_status frictions(lag_zero_crossing *crossings)
{
    const lag_model *model = crossings->motion->model;
    const size_t first = model->nindicator + model->ncontact;
    const lag_status status = lag_frictions_look(crossings->frictions);
    for (size_t i = first; i < first + model->nfriction; ++i) {
        const double least = fmax(crossings->band[i], lag_zero_crossing_noise(crossings, i));
        crossings->changed[i] = -lag_zero_crossing_value(crossings, i) > least;
    }
    return status;
}

static lag_status corners(lag_zero_crossing *crossings)
{
    const size_t first = lag_guards(crossings->motion->model);
    double solved = 0.0;
    const lag_status status = crossings->motion->model->corner(&crossings->motion->at, crossings->far, &solved);
    for (size_t i = first; i < first + crossings->corners; ++i) {
        crossings->changed[i] = -lag_zero_crossing_value(crossings, i) > least_of(crossings, i);
    }
    return status;
}

/* True if values depend on accelerations or multipliers: relations may contain them, and closed contacts have them. */
static int needs_forces(const lag_zero_crossing *crossings)
{
    const lag_model *model = crossings->motion->model;
    int needs = model->nindicator > 0 || model->nfriction > 0 || (crossings->corners > 0 && crossings->solved);
    for (size_t i = 0; i < model->ncontact && !needs; ++i) {
        needs = is_closed(crossings, i);
    }
    return needs;
}

lag_status lag_zero_crossing_look(lag_zero_crossing *crossings, double t, const double *x)
{
    const lag_model *model = crossings->motion->model;
    lag_status status = LAG_OK;
    if (needs_forces(crossings)) {
        status = lag_motion_solve(crossings->motion, t, x);
    } else {
        lag_motion_look(crossings->motion, t, x);
    }
    if (status == LAG_OK && model->nindicator > 0) {
        status = relations(crossings);
    }
    if (status == LAG_OK && model->ncontact > 0) {
        status = contacts(crossings);
    }
    if (status == LAG_OK && model->nfriction > 0) {
        status = frictions(crossings);
    }
    if (status == LAG_OK && crossings->corners > 0) {
        status = corners(crossings);
    }
    for (size_t i = 0; i < lag_zero_crossing_count(crossings) && status == LAG_OK; ++i) {
        status = crossings->changed[i] != 0.0 ? LAG_EVENT_PENDING : LAG_OK;
    }
    return status;
}

lag_status lag_zero_crossing_begin(lag_zero_crossing *crossings, double t, const double *x)
{
    const size_t count = lag_zero_crossing_count(crossings);
    const size_t contacts = crossings->motion->model->ncontact;
    const size_t frictions = crossings->motion->model->nfriction;
    if (count == 0) {
        return LAG_OK;
    }
    crossings->since = t;
    memset(crossings->band, 0, count * sizeof(double));
    memset(crossings->creep, 0, (count - contacts - frictions) * sizeof(double));
    lag_noise_follow(crossings->noise, x);
    lag_contacts_follow(crossings->contacts, x);
    const lag_status status = lag_zero_crossing_look(crossings, t, x);
    for (size_t i = 0; i < count && (status == LAG_OK || status == LAG_EVENT_PENDING); ++i) {
        const double value = lag_zero_crossing_value(crossings, i);
        const size_t contact = i - crossings->motion->model->nindicator;
        crossings->depth[i] = crossings->band[i] = fmax(-value, crossings->changed[i] != 0.0 ? DBL_MIN : 0.0);
        crossings->start[i] = value;
        crossings->moved[i] = 0.0;
        if (i < crossings->motion->model->nindicator && !(fabs(value) <= lag_zero_crossing_known(crossings, i))) {
            crossings->hovers[i] = 0.0;
        }
        if (i >= crossings->motion->model->nindicator && contact < contacts && is_closed(crossings, contact) && isfinite(value)) {
            crossings->contacts->force[contact] = fmax(crossings->contacts->force[contact], fabs(value));
        }
    }
    return status == LAG_EVENT_PENDING ? LAG_OK : status;
}

int lag_zero_crossing_has_noise(const lag_zero_crossing *crossings, size_t which)
{
    const size_t relations = crossings->motion->model->nindicator;
    return which < relations || which >= lag_guards(crossings->motion->model);
}

/* True if a value comes to zero itself from where it was clearly not, as one that `limit` or `min` ends at its border. */
static int ends_at_zero(const lag_zero_crossing *crossings, size_t which, const double *from)
{
    const double noise = lag_zero_crossing_noise(crossings, which);
    return from != NULL && lag_zero_crossing_value(crossings, which) == 0.0 && from[which] > CLEARLY * noise;
}

/* True if a relation or corner has changed, by what may be round-off or creep. */
static int is_unclear(const lag_zero_crossing *crossings, size_t which)
{
    const double sigma = lag_zero_crossing_noise(crossings, which);
    const double most = fmax(CLEARLY * sigma, lag_zero_crossing_known(crossings, which));
    const int is_clear = -lag_zero_crossing_value(crossings, which) > crossings->depth[which] + most && sigma > 0.0;
    return crossings->changed[which] != 0.0 && !is_clear;
}

void lag_zero_crossing_creep(lag_zero_crossing *crossings, double t, const double *x, double span)
{
    lag_noise_creep(crossings->noise, t, x, CREEPING, crossings->tolerance, span, crossings->creep);
}

/* So far a relation or corner at rest may have crept since the step began. */
static double crept(const lag_zero_crossing *crossings, size_t which)
{
    return crossings->creep[place_of(crossings, which)] * (crossings->motion->at.t - crossings->since);
}

static int may_rest(const lag_zero_crossing *crossings, size_t which)
{
    return which >= crossings->motion->model->nindicator || crossings->hovers[which] != 0.0;
}

int lag_zero_crossing_rests(const lag_zero_crossing *crossings, size_t which)
{
    const double value = lag_zero_crossing_value(crossings, which);
    const double moved = fmax(crossings->moved[which], fabs(value - crossings->start[which]));
    return may_rest(crossings, which) && moved <= crept(crossings, which) + lag_zero_crossing_noise(crossings, which) &&
        fabs(crossings->start[which]) <= lag_zero_crossing_known(crossings, which);
}

/* So far below zero a value is round-off, or, if it rests at zero, its creep, as far as the motion is known. */
static double most_of(const lag_zero_crossing *crossings, size_t which)
{
    const double depth = crossings->depth[which];
    const double known = lag_zero_crossing_known(crossings, which);
    const double rest = lag_zero_crossing_rests(crossings, which) ? fmin(known, depth + crept(crossings, which)) : 0.0;
    return fmax(depth + lag_zero_crossing_noise(crossings, which), rest);
}

int lag_zero_crossing_widen(lag_zero_crossing *crossings, double t, const double *x, const double *from)
{
    const size_t count = lag_zero_crossing_count(crossings);
    int unclear = 0;
    int resting = 0;
    for (size_t i = 0; i < count; ++i) {
        const int is_one = lag_zero_crossing_has_noise(crossings, i) && is_unclear(crossings, i);
        unclear = unclear || is_one;
        resting = resting || (is_one && may_rest(crossings, i));
    }
    if (!unclear) {
        return 0;
    }
    lag_noise_find(crossings->noise, t, x);
    if (resting) {
        lag_zero_crossing_creep(crossings, t, x, t - crossings->since);
    }
    for (size_t i = 0; i < count; ++i) {
        const int has_changed = lag_zero_crossing_has_noise(crossings, i) && crossings->changed[i] != 0.0;
        const double most = has_changed ? most_of(crossings, i) : 0.0;
        if (has_changed && -lag_zero_crossing_value(crossings, i) <= most && !ends_at_zero(crossings, i, from)) {
            crossings->band[i] = fmax(crossings->band[i], most);
        }
    }
    return 1;
}
