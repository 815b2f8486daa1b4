#include "lag/events/zero_crossing.h"

#include <math.h>
#include <string.h>

#include "lag/linalg/arena.h"

/* A value beyond this many times its last known round-off is clear of round-off. */
static const double CLEARLY = 1e6;

size_t lag_zero_crossing_memory(const lag_model *model)
{
    const size_t count = model->nindicator + model->ncontact + model->ncorner;
    return 2 * model->nindicator + model->ngap * (2 + model->nq) + 3 * model->ncontact + 3 * model->ncorner + (4 + LAG_LOOKS) * count;
}

void lag_zero_crossing_place(lag_zero_crossing *crossings, lag_motion *motion, lag_contacts *contacts, lag_noise *noise, double *memory)
{
    const lag_model *model = motion->model;
    const size_t count = model->nindicator + model->ncontact + model->ncorner;
    crossings->motion = motion;
    crossings->places = lag_places_of(model);
    crossings->contacts = contacts;
    crossings->noise = noise;
    crossings->changed = lag_take(&memory, count);
    crossings->band = lag_take(&memory, count);
    crossings->root = lag_take(&memory, count);
    crossings->found = lag_take(&memory, count);
    crossings->when = lag_take(&memory, model->nindicator);
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
    memset(crossings->band, 0, count * sizeof(double));
    lag_fill(model->nindicator, -(double)INFINITY, crossings->when);
}

size_t lag_zero_crossing_count(const lag_zero_crossing *crossings)
{
    return crossings->motion->model->nindicator + crossings->motion->model->ncontact + crossings->corners;
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
    if (which >= count + motion->model->ncontact) {
        const size_t corner = which - count - motion->model->ncontact;
        return crossings->side[corner] * crossings->far[corner];
    }
    return is_closed(crossings, which - count) ? motion->lam[motion->model->contact_rows[which - count]] : crossings->gap[which - count];
}

double lag_zero_crossing_noise(const lag_zero_crossing *crossings, size_t which)
{
    const size_t count = crossings->motion->model->nindicator;
    const size_t contacts = crossings->motion->model->ncontact;
    if (which < count || which >= count + contacts) {
        return crossings->noise->sigma[which < count ? which : which - contacts];
    }
    return is_closed(crossings, which - count) ? lag_contacts_force_noise(crossings->contacts, which - count)
                                           : lag_contacts_gap_noise(crossings->contacts, which - count);
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
        crossings->changed[i] = differs && (!(crossings->band[i] > 0.0) || -lag_zero_crossing_value(crossings, i) > crossings->band[i]);
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

static lag_status corners(lag_zero_crossing *crossings)
{
    const size_t first = crossings->motion->model->nindicator + crossings->motion->model->ncontact;
    double solved = 0.0;
    const lag_status status = crossings->motion->model->corner(&crossings->motion->at, crossings->far, &solved);
    for (size_t i = first; i < first + crossings->corners; ++i) {
        crossings->changed[i] = -lag_zero_crossing_value(crossings, i) > crossings->band[i];
    }
    return status;
}

/* True if values depend on accelerations or multipliers: relations may contain them, and closed contacts have them. */
static int needs_forces(const lag_zero_crossing *crossings)
{
    const lag_model *model = crossings->motion->model;
    int needs = model->nindicator > 0 || (crossings->corners > 0 && crossings->solved);
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
    if (count == 0) {
        return LAG_OK;
    }
    lag_noise_follow(crossings->noise, x);
    lag_contacts_follow(crossings->contacts, x);
    const lag_status status = lag_zero_crossing_look(crossings, t, x);
    for (size_t i = 0; i < count && (status == LAG_OK || status == LAG_EVENT_PENDING); ++i) {
        const double value = lag_zero_crossing_value(crossings, i);
        const size_t contact = i - crossings->motion->model->nindicator;
        crossings->band[i] = value < 0.0 ? -value : 0.0;
        if (i >= crossings->motion->model->nindicator && contact < contacts && is_closed(crossings, contact) && isfinite(value)) {
            crossings->contacts->force[contact] = fmax(crossings->contacts->force[contact], fabs(value));
        }
    }
    return status == LAG_EVENT_PENDING ? LAG_OK : status;
}

int lag_zero_crossing_has_noise(const lag_zero_crossing *crossings, size_t which)
{
    const size_t relations = crossings->motion->model->nindicator;
    return which < relations || which >= relations + crossings->motion->model->ncontact;
}

/* True if a value comes to zero itself from where it was clearly not, as one that `limit` or `min` ends at its border. */
static int ends_at_zero(const lag_zero_crossing *crossings, size_t which, const double *from)
{
    const double noise = lag_zero_crossing_noise(crossings, which);
    return from != NULL && lag_zero_crossing_value(crossings, which) == 0.0 && from[which] > CLEARLY * noise;
}

int lag_zero_crossing_widen(lag_zero_crossing *crossings, double t, const double *x, const double *from)
{
    const size_t count = lag_zero_crossing_count(crossings);
    int unclear = 0;
    for (size_t i = 0; i < count; ++i) {
        const double sigma = lag_zero_crossing_has_noise(crossings, i) ? lag_zero_crossing_noise(crossings, i) : 0.0;
        const int clear = -lag_zero_crossing_value(crossings, i) > CLEARLY * sigma && sigma > 0.0;
        unclear = unclear || (lag_zero_crossing_has_noise(crossings, i) && crossings->changed[i] != 0.0 && !clear);
    }
    if (!unclear) {
        return 0;
    }
    lag_noise_find(crossings->noise, t, x);
    for (size_t i = 0; i < count; ++i) {
        const int is_round_off = -lag_zero_crossing_value(crossings, i) <= lag_zero_crossing_noise(crossings, i);
        const int has_changed = lag_zero_crossing_has_noise(crossings, i) && crossings->changed[i] != 0.0;
        if (has_changed && is_round_off && !ends_at_zero(crossings, i, from)) {
            crossings->band[i] = fmax(crossings->band[i], lag_zero_crossing_noise(crossings, i));
        }
    }
    return 1;
}
