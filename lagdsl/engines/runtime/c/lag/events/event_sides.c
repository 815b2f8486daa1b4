/*
 * Sides of relations just behind an instant, by their values, rates and accelerations. The model has these as expressions. A relation shows no side where its
 * derivatives read rates that no equation gives, those of inputs, accelerations or multipliers.
 */
#include <math.h>
#include <string.h>

#include "lag/events/instant.h"
#include "lag/linalg/arena.h"
#include "lag/linalg/vector.h"

/* So many times between resets in a row, each shorter than the one before, are a series. */
enum { SERIES = 2 };
/* The top of a flight of time T that begins at speed v is v T/4. It is lost where the next event is about as deep as this one. */
static const double DEEP = 16.0;

static lag_status indicate(lag_instants *instants, double t, const double *x, double *g)
{
    lag_motion_try(instants->motion, t, x);
    return instants->motion->model->indicator(&instants->motion->at, g);
}

lag_status lag_instants_relations(lag_instants *instants, double t, const double *x)
{
    const lag_model *model = instants->motion->model;
    const lag_status status = model->nindicator > 0 ? indicate(instants, t, x, instants->sides.now) : LAG_OK;
    for (size_t i = 0; i < model->nindicator; ++i) {
        instants->motion->w[instants->motion->places.relation + i] = lag_relation_holds(model, i, instants->sides.now[i]);
    }
    return status;
}

/* ---- sides ---- */

/* A number that is clear of its round-off has a sign: 1 or -1, else 0. */
static double sign_of(double value, double error)
{
    return fabs(value) > error ? (value > 0.0 ? 1.0 : -1.0) : 0.0;
}

/* True if relation i has turned in this event: it was found to (flags, or null), or a pass has turned it. */
static int has_turned(const lag_instants *instants, const double *turned, size_t i)
{
    const size_t place = instants->motion->places.relation + i;
    return (turned != NULL && turned[i] != 0.0) || instants->motion->w[place] != instants->instant.stood[place];
}

/* True if this instant has moved the value of relation i. */
static int is_moved(const lag_instants *instants, size_t i)
{
    return fabs(instants->noise.value[i] - instants->sides.before[i]) > instants->noise.sigma[i];
}

/*
 * True if relation i lies at its border: its value is zero but for round-off, or as good as the instant is known; or it is near zero,
 * disagrees with the mode, and this instant has not moved it: a projection has.
 */
static int is_at_border(const lag_instants *instants, size_t i)
{
    const lag_noise *noise = &instants->noise;
    const size_t count = instants->motion->model->nindicator;
    const double g = noise->value[i];
    const double passed = instants->instant.moment * fabs(noise->value[count + instants->motion->model->ncorner + i]);
    const int disagrees = lag_relation_holds(instants->motion->model, i, g) != (instants->motion->w[instants->motion->places.relation + i] != 0.0);
    const int is_off = disagrees && fabs(g) <= lag_noise_known(noise, i) && !is_moved(instants, i);
    return is_off || !(fabs(g) > fmax(noise->sigma[i], isfinite(passed) ? passed : 0.0));
}

/* The side of relation i by its value, at its border by its rate, then by its acceleration; 0: they do not show it. */
static double side_of(const lag_instants *instants, size_t i)
{
    const lag_noise *noise = &instants->noise;
    const size_t count = instants->motion->model->nindicator;
    const size_t rate = count + instants->motion->model->ncorner + i;
    if (!is_at_border(instants, i)) {
        return sign_of(noise->value[i], 0.0);
    }
    const double side = sign_of(noise->value[rate], LAG_MOVES_CLEARLY * noise->sigma[rate]);
    return side != 0.0 ? side : sign_of(noise->value[rate + count], LAG_MOVES_CLEARLY * noise->sigma[rate + count]);
}

/* Values of the relations before the event, into `before`. */
static lag_status evaluate_before(lag_instants *instants, double t)
{
    instants->motion->at.w = instants->instant.stood;
    const lag_status status = indicate(instants, t, instants->instant.from, instants->sides.before);
    instants->motion->at.w = instants->motion->w;
    return status;
}

/* Sides of all relations just behind t into `side`: 1, -1, or 0 where there is none; their values into `now`, and those before the event. */
static lag_status find_sides(lag_instants *instants, double t, const double *x)
{
    const size_t count = instants->motion->model->nindicator;
    double *now = instants->sides.now;
    const int known = lag_noise_find(&instants->noise, t, x) == LAG_OK; /* there may be no accelerations */
    lag_copy(known ? count : 0, instants->noise.value, now);
    const lag_status status = known ? evaluate_before(instants, t) : indicate(instants, t, x, now);
    lag_copy(known ? 0 : count, now, instants->sides.before);
    for (size_t i = 0; i < count; ++i) {
        instants->sides.side[i] = known ? side_of(instants, i) : sign_of(now[i], 0.0);
    }
    return status;
}

lag_status lag_instants_sides(lag_instants *instants, double t, const double *x, const double *turned)
{
    const lag_model *model = instants->motion->model;
    const double *side = instants->sides.side;
    double *truth = instants->sides.truth;
    if (model->nindicator == 0) {
        return LAG_OK;
    }
    lag_copy(model->nindicator, instants->motion->w + instants->motion->places.relation, truth);
    const lag_status status = find_sides(instants, t, x);
    const int alone = instants->sides.begins && !instants->instant.acted && lag_same(instants->motion->places.relation, instants->instant.stood, instants->motion->w); /* relations turned */
    for (size_t i = 0; i < model->nindicator && status == LAG_OK; ++i) {
        const int returns = alone && truth[i] != instants->instant.stood[instants->motion->places.relation + i];
        if (side[i] != 0.0) {
            truth[i] = returns ? truth[i] : side[i] > 0.0; /* both sides of a corner may lead back to it */
        } else if (!has_turned(instants, turned, i) && fabs(instants->sides.before[i]) > lag_noise_known(&instants->noise, i)) {
            truth[i] = lag_relation_holds(model, i, 0.0); /* a clause has put it there: no projection moves a value so far */
        }
    }
    return status;
}

lag_status lag_instants_find_turning(lag_instants *instants, double t, const double *x, double *turned)
{
    const lag_model *model = instants->motion->model;
    const double *before = instants->motion->w + instants->motion->places.relation;
    const int any = lag_any(model->nindicator, turned);
    const lag_status status = any ? find_sides(instants, t, x) : lag_instants_sides(instants, t, x, NULL);
    for (size_t i = 0; i < model->nindicator && status == LAG_OK; ++i) {
        turned[i] = any ? turned[i] != 0.0 && lag_relation_holds(model, i, instants->sides.side[i]) != (before[i] != 0.0) : instants->sides.truth[i] != before[i];
    }
    return status;
}

/* ---- series of resets ---- */

/* True if a relation flagged in `turned`, which stands behind zero, comes back towards it too slowly: by less than some depths in a flight. */
static int returns_too_slowly(lag_instants *instants, double t, const double *x, const double *turned, double flight)
{
    const lag_model *model = instants->motion->model;
    const double *truth = instants->motion->w + instants->motion->places.relation;
    const double *stood = instants->instant.stood + instants->motion->places.relation;
    const double *g = instants->noise.value;
    const double *rate = g + model->nindicator + model->ncorner;
    int any = 0;
    const lag_status status = lag_noise_update(&instants->noise, t, x);
    for (size_t i = 0; i < model->nindicator && status == LAG_OK; ++i) {
        const double rise = truth[i] != 0.0 ? -rate[i] : rate[i];
        const int stands = turned[i] != 0.0 && truth[i] != stood[i] && lag_relation_holds(model, i, g[i]) == (truth[i] != 0.0);
        any = any || (stands && rise > 0.0 && rise * flight < DEEP * fabs(g[i]));
    }
    return any;
}

int lag_instants_accumulates(lag_instants *instants, double t, const double *x, const double *turned)
{
    lag_crowd *resets = &instants->resets;
    if (!instants->instant.acted) {
        return 0;
    }
    const int crowds = lag_crowds(resets, t, instants->contacts.length, 1);
    return crowds || (resets->shrinking >= SERIES && returns_too_slowly(instants, t, x, turned, resets->ratio * resets->interval));
}
