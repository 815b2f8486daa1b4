#include "lag/events/zero_crossing.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "lag/linalg/arena.h"

/* ---- kinds of guards ---- */

/* Guards of one kind: how they are evaluated where `motion` is, and the value and the rounding error of the k-th. */
typedef struct kind {
    lag_status (*evaluate)(lag_zero_crossing *crossings);
    double (*value)(const lag_zero_crossing *crossings, size_t k);
    double (*noise)(const lag_zero_crossing *crossings, size_t k);
} kind;

static lag_status evaluate_relations(lag_zero_crossing *crossings)
{
    return crossings->motion->model->indicator(&crossings->motion->at, crossings->g);
}

static double relation(const lag_zero_crossing *crossings, size_t k)
{
    const int holds = crossings->motion->w[crossings->places.relation + k] != 0.0;
    return crossings->held[k] != 0.0 ? 1.0 : holds ? crossings->g[k] : -crossings->g[k];
}

static double relation_noise(const lag_zero_crossing *crossings, size_t k)
{
    return crossings->noise->sigma[k];
}

static int is_closed(const lag_zero_crossing *crossings, size_t k)
{
    return crossings->motion->w[crossings->places.contact + k] != 0.0;
}

static lag_status evaluate_contacts(lag_zero_crossing *crossings)
{
    return lag_contacts_evaluate(crossings->contacts);
}

static double contact(const lag_zero_crossing *crossings, size_t k)
{
    const lag_motion *motion = crossings->motion;
    if (!is_closed(crossings, k)) {
        return lag_contacts_is_one_way(crossings->contacts, k) ? crossings->contacts->speed[k] : crossings->contacts->gap[k];
    }
    const int shares = !isnan(crossings->frictions->reserve[k]); /* friction of its group is watched */
    return shares ? (double)INFINITY : motion->lam[motion->model->contact_rows[k]];
}

static double contact_noise(const lag_zero_crossing *crossings, size_t k)
{
    return is_closed(crossings, k) ? lag_contacts_force_noise(crossings->contacts, k) : lag_contacts_gap_noise(crossings->contacts, k);
}

static lag_status evaluate_frictions(lag_zero_crossing *crossings)
{
    const lag_status status = lag_frictions_evaluate(crossings->frictions);
    return status == LAG_OK ? lag_reserve_evaluate(crossings->reserve) : status;
}

static double friction(const lag_zero_crossing *crossings, size_t k)
{
    return lag_frictions_guard(crossings->frictions, k);
}

static double friction_noise(const lag_zero_crossing *crossings, size_t k)
{
    return lag_frictions_dead_band(crossings->frictions, k);
}

static lag_status evaluate_corners(lag_zero_crossing *crossings)
{
    double solved = 0.0;
    return crossings->motion->model->corner(&crossings->motion->at, crossings->corners.far, &solved);
}

static double corner(const lag_zero_crossing *crossings, size_t k)
{
    return crossings->corners.side[k] * crossings->corners.far[k];
}

static double corner_noise(const lag_zero_crossing *crossings, size_t k)
{
    return crossings->noise->sigma[crossings->motion->model->nindicator + k];
}

enum { RELATIONS, CONTACTS, FRICTIONS, CORNERS, KINDS };

static const kind KIND[KINDS] = {
    [RELATIONS] = {evaluate_relations, relation, relation_noise},
    [CONTACTS] = {evaluate_contacts, contact, contact_noise},
    [FRICTIONS] = {evaluate_frictions, friction, friction_noise},
    [CORNERS] = {evaluate_corners, corner, corner_noise},
};

/* The number of guards of kind k. Every evaluation asks this for every guard: no calls. */
static inline size_t count_of(const lag_zero_crossing *crossings, int k)
{
    const lag_model *model = crossings->motion->model;
    return k == RELATIONS ? model->nindicator : k == CONTACTS ? model->ncontact : k == FRICTIONS ? model->nfriction : crossings->corners.count;
}

/* The kind of guard *which; its number among those of its kind instead. */
static int kind_of(const lag_zero_crossing *crossings, size_t *which)
{
    int k = 0;
    while (k < KINDS - 1 && *which >= count_of(crossings, k)) {
        *which -= count_of(crossings, k);
        ++k;
    }
    return k;
}

size_t lag_zero_crossing_count(const lag_zero_crossing *crossings)
{
    return lag_guards(crossings->motion->model) + crossings->corners.count;
}

double lag_zero_crossing_noise(const lag_zero_crossing *crossings, size_t which)
{
    const int k = kind_of(crossings, &which);
    return KIND[k].noise(crossings, which);
}

int lag_zero_crossing_has_noise(const lag_zero_crossing *crossings, size_t which)
{
    const int k = kind_of(crossings, &which);
    return k == RELATIONS || k == CORNERS;
}

int lag_zero_crossing_touches(const lag_zero_crossing *crossings, size_t which)
{
    const lag_model *model = crossings->motion->model;
    const size_t k = which - model->nindicator - model->ncontact; /* large for others */
    return k < model->nfriction && lag_frictions_components(crossings->frictions, k) > 1 && *lag_frictions_sticks(crossings->frictions, k) == 0.0;
}

/* The size of the numbers that enter the guard of a contact or of friction. */
static double size_of(const lag_zero_crossing *crossings, size_t which)
{
    const lag_contacts *contacts = crossings->contacts;
    const size_t i = which - crossings->motion->model->nindicator;
    if (i >= crossings->motion->model->ncontact) {
        return lag_frictions_size(crossings->frictions, i - crossings->motion->model->ncontact);
    }
    return is_closed(crossings, i) ? contacts->sizes.force[i] : lag_contacts_is_one_way(contacts, i) ? contacts->sizes.pace[i] : contacts->sizes.scale[i];
}

double lag_zero_crossing_known(const lag_zero_crossing *crossings, size_t which)
{
    return !lag_zero_crossing_has_noise(crossings, which) ? crossings->noise->tolerance * size_of(crossings, which) :
        lag_noise_known(crossings->noise, which);
}

/* ---- memory ---- */

size_t lag_zero_crossing_memory(const lag_model *model)
{
    const size_t count = lag_guards(model) + model->ncorner;
    return 5 * model->nindicator + 2 * model->ncorner + (7 + LAG_PIECE_SAMPLES) * count;
}

void lag_zero_crossing_place(lag_zero_crossing *crossings, lag_motion *motion, lag_reserve *reserve, lag_noise *noise, double *memory)
{
    const lag_model *model = motion->model;
    const size_t count = lag_guards(model) + model->ncorner;
    crossings->motion = motion;
    crossings->places = lag_places_of(model);
    crossings->contacts = reserve->frictions->contacts;
    crossings->frictions = reserve->frictions;
    crossings->reserve = reserve;
    crossings->noise = noise;
    crossings->value = lag_take(&memory, count);
    crossings->changed = lag_take(&memory, count);
    crossings->depth = lag_take(&memory, count);
    crossings->band = lag_take(&memory, count);
    crossings->top = lag_take(&memory, count);
    crossings->pieces.root = lag_take(&memory, count);
    crossings->pieces.found = lag_take(&memory, count);
    for (size_t k = 0; k < LAG_PIECE_SAMPLES; ++k) {
        crossings->pieces.seen[k] = lag_take(&memory, count);
    }
    crossings->pieces.when = lag_take(&memory, model->nindicator);
    crossings->held = lag_take(&memory, model->nindicator);
    crossings->swing = lag_take(&memory, model->nindicator);
    crossings->doubted = lag_take(&memory, model->nindicator);
    crossings->g = lag_take(&memory, model->nindicator);
    crossings->corners.far = lag_take(&memory, model->ncorner);
    crossings->corners.side = memory;
    crossings->pieces.span = crossings->pieces.reach = 0.0;
    crossings->pieces.limit = (double)INFINITY;
    crossings->locating = 0;
    lag_fill(count, 0.0, crossings->depth);
    lag_fill(count, 0.0, crossings->band);
    lag_fill(count, 0.0, crossings->top);
    lag_fill(model->nindicator, 0.0, crossings->held);
    lag_fill(model->nindicator, -(double)INFINITY, crossings->pieces.when);
    lag_fill(model->nindicator, (double)INFINITY, crossings->swing);
    lag_fill(model->nindicator, (double)INFINITY, crossings->doubted);
}

/* ---- looks ---- */

/* True if values depend on accelerations or multipliers: relations may contain them, and closed contacts have them. */
static int needs_forces(const lag_zero_crossing *crossings)
{
    const lag_model *model = crossings->motion->model;
    int needs = model->nindicator > 0 || model->nfriction > 0 || (crossings->corners.count > 0 && crossings->corners.solved);
    for (size_t i = 0; i < model->ncontact && !needs; ++i) {
        needs = is_closed(crossings, i);
    }
    return needs;
}

static lag_status evaluate(lag_zero_crossing *crossings, double t, const double *x)
{
    lag_status status = LAG_OK;
    if (needs_forces(crossings)) {
        status = lag_motion_solve(crossings->motion, t, x);
    } else {
        lag_motion_set_state(crossings->motion, t, x);
    }
    double *value = crossings->value;
    for (int k = 0; k < KINDS && status == LAG_OK; ++k) {
        const size_t count = count_of(crossings, k);
        status = count > 0 ? KIND[k].evaluate(crossings) : LAG_OK;
        for (size_t i = 0; i < count && status == LAG_OK; ++i) {
            *value++ = KIND[k].value(crossings, i);
        }
    }
    return status;
}

/* True if relation i is zero and does not hold there: one that `limit` or `min` ends at zero changes there, though it does not pass it. */
static int ends_at_zero(const lag_zero_crossing *crossings, size_t i)
{
    const lag_model *model = crossings->motion->model;
    return i < model->nindicator && crossings->value[i] == 0.0 &&
        (crossings->motion->w[crossings->places.relation + i] != 0.0) == (model->strict[i] != 0);
}

/* True if guard i may have left its mode: its rounding error here is not known. */
static int is_unclear(const lag_zero_crossing *crossings, size_t i)
{
    if (crossings->band[i] != 0.0 || !lag_zero_crossing_has_noise(crossings, i)) {
        return 0;
    }
    const double value = crossings->value[i];
    if (value > 0.0) {
        return 0;
    }
    return -value > crossings->depth[i] || ends_at_zero(crossings, i);
}

/* Finds the rounding errors of guards that may have left their modes at x at time t; 0: there are none. */
static int find_dead_bands(lag_zero_crossing *crossings, double t, const double *x)
{
    const size_t count = lag_zero_crossing_count(crossings);
    size_t i = 0;
    while (i < count && !is_unclear(crossings, i)) {
        ++i;
    }
    if (i == count) {
        return 0;
    }
    for (size_t k = 0; k < count; ++k) {
        crossings->changed[k] = is_unclear(crossings, k);
    }
    lag_noise_find(crossings->noise, t, x);
    for (size_t k = 0; k < count; ++k) {
        crossings->band[k] = crossings->changed[k] != 0.0 ? fmax(DBL_MIN, lag_zero_crossing_noise(crossings, k)) : crossings->band[k];
    }
    return 1;
}

/* True if guard i has left its mode: it is below its dead band. One that began below zero and has left did so where it fell below its beginning. */
static int has_left(const lag_zero_crossing *crossings, size_t i)
{
    const double value = crossings->value[i];
    if (value > 0.0) {
        return 0;
    }
    const int has_begun_below = crossings->locating && crossings->depth[i] > 0.0;
    const double noise = lag_zero_crossing_has_noise(crossings, i) ? crossings->band[i] : lag_zero_crossing_noise(crossings, i);
    const double band = has_begun_below ? 0.0 : noise;
    const int ends = ends_at_zero(crossings, i) && crossings->top[i] > LAG_CLEARLY * noise;
    return -value > crossings->depth[i] + band || ends;
}

lag_status lag_zero_crossing_detect(lag_zero_crossing *crossings, double t, const double *x)
{
    const size_t count = lag_zero_crossing_count(crossings);
    lag_status status = evaluate(crossings, t, x);
    if (status == LAG_OK && find_dead_bands(crossings, t, x)) {
        status = evaluate(crossings, t, x);
    }
    int any = 0;
    for (size_t i = 0; i < count && status == LAG_OK; ++i) {
        crossings->changed[i] = has_left(crossings, i);
        any = any || crossings->changed[i] != 0.0;
    }
    return any ? LAG_EVENT_PENDING : status;
}

lag_status lag_zero_crossing_begin(lag_zero_crossing *crossings, double t, const double *x)
{
    const lag_model *model = crossings->motion->model;
    const size_t count = lag_zero_crossing_count(crossings);
    if (count == 0) {
        return LAG_OK;
    }
    lag_noise_follow(crossings->noise, x);
    lag_contacts_follow(crossings->contacts, x);
    const lag_status status = evaluate(crossings, t, x);
    if (model->nfriction > 0 && status == LAG_OK) {
        lag_frictions_begin(crossings->frictions); /* guards of slips in a plane begin with it */
    }
    for (size_t i = 0; i < count && status == LAG_OK; ++i) {
        const double value = crossings->value[i];
        crossings->depth[i] = fmax(-value, 0.0);
        crossings->band[i] = 0.0;
        crossings->top[i] = value;
    }
    for (size_t i = 0; i < model->nindicator && status == LAG_OK; ++i) {
        crossings->swing[i] = fmax(crossings->swing[i], fabs(crossings->g[i]));
    }
    for (size_t k = 0; k < model->ncontact && status == LAG_OK; ++k) {
        const double force = is_closed(crossings, k) ? fabs(contact(crossings, k)) : 0.0;
        crossings->contacts->sizes.force[k] = isfinite(force) ? fmax(crossings->contacts->sizes.force[k], force) : crossings->contacts->sizes.force[k];
    }
    return status;
}

void lag_zero_crossing_hold(lag_zero_crossing *crossings, lag_projection *projection, double t, const double *x, double *point)
{
    lag_noise_hold(crossings->noise, projection, t, x, point, crossings->held);
}
