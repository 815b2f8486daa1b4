#include "lag/events/timed.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "lag/linalg/arena.h"
#include "lag/linalg/minimum.h"
#include "lag/linalg/order.h"
#include "lag/linalg/root.h"
#include "lag/linalg/vector.h"

/* Changes so many units in the last place apart are one, */
static const double ULPS = 16.0;
/* and a change that is lost in round-off there is looked for behind, in doubled distances. */
enum { FARTHER = 32 };
/* The experiment is looked over in so many parts for zeros of what is not affine, */
static const double PARTS = 64.0;
/* each of them halved at most so often, */
enum { HALVES = 20 };
/* at this part of it: places lie so that no periodic function seems to have none of its waves. */
static const double MIDDLE = 0.4583;

void lag_timed_place(lag_timed *timed, lag_motion *motion, lag_layout *layout)
{
    const lag_model *model = motion->model;
    *timed = (lag_timed){.motion = motion, .next = (double)INFINITY};
    lag_lay_all(layout, model->ntimed, (double **const[]){&timed->value, &timed->told, &timed->before, NULL});
    lag_lay_all(layout, model->ndistance, (double **const[]){&timed->distance, &timed->rate, &timed->affine, &timed->entry, &timed->zero, NULL});
}

static lag_status evaluate(lag_timed *timed, double t)
{
    lag_motion *motion = timed->motion;
    motion->at.t = t;
    return motion->model->time_event(
        &motion->at, timed->value, timed->told, timed->distance, timed->rate, timed->affine, timed->entry);
}

/* Times nearer to each other than this are one. */
static double resolution(const lag_timed *timed, double t)
{
    return ULPS * DBL_EPSILON * fmax(fabs(t), timed->length);
}

double lag_timed_behind(const lag_timed *timed, double t)
{
    return t + resolution(timed, t);
}

/* ---- zeros ---- */

typedef struct distance {
    lag_timed *timed;
    size_t which;
    lag_status status;
} distance;

/* A distance and its rate at a time. */
typedef struct place {
    double t, value, rate;
} place;

static place place_at(distance *one, double t)
{
    const lag_status status = evaluate(one->timed, t);
    one->status = one->status == LAG_OK ? status : one->status;
    return (place){t, one->timed->distance[one->which], one->timed->rate[one->which]};
}

static double value_of(void *context, double t)
{
    return place_at(context, t).value;
}

static double rate_of(void *context, double t)
{
    return place_at(context, t).rate;
}

/* The first zero between two places where the distance is a polynomial of degree three, about; infinite without. It has a minimum where its rate turns. */
static double zero_between(distance *one, place a, place b)
{
    const double tolerance = DBL_EPSILON * fabs(b.t);
    if (b.value > 0.0 && a.rate < 0.0 && b.rate > 0.0) {
        b = place_at(one, lag_root(rate_of, one, a.t, a.rate, b.t, b.rate, tolerance));
    }
    return b.value > 0.0 ? (double)INFINITY : lag_root(value_of, one, a.t, fmax(a.value, DBL_MIN), b.t, b.value, tolerance);
}

/* 1: values and rates at three places are those of one polynomial of degree three, to a part of the largest: there are no waves between them. */
static int is_known(place a, place m, place b)
{
    const double w = b.t - a.t;
    const double s = (m.t - a.t) / w;
    const double rise = b.value - a.value;
    const double value = a.value + s * s * (3.0 - 2.0 * s) * rise + w * s * (1.0 - s) * ((1.0 - s) * a.rate - s * b.rate);
    const double rate = 6.0 * s * (1.0 - s) * rise + w * ((1.0 - s) * (1.0 - 3.0 * s) * a.rate - s * (2.0 - 3.0 * s) * b.rate);
    const double most = fmax(fabs(a.value), fmax(fabs(m.value), fabs(b.value)));
    return !(fmax(fabs(m.value - value), fabs(w * m.rate - rate)) > LAG_KNOWN_PART * most);
}

/* The first zero between two places, which are halved, about, until their shape is known. */
static double first_zero(distance *one, place a, place b, int halves)
{
    const place m = place_at(one, a.t + MIDDLE * (b.t - a.t));
    const int known = halves == 0 || is_known(a, m, b);
    const double zero = known ? zero_between(one, a, m) : first_zero(one, a, m, halves - 1);
    if (zero < (double)INFINITY || one->status != LAG_OK) {
        return zero;
    }
    return known ? zero_between(one, m, b) : first_zero(one, m, b, halves - 1);
}

/* The first zero of a distance between times `from` and `to`, in parts at most this long. */
static double zero_in_parts(distance *one, double from, double to, double part)
{
    place a = place_at(one, from);
    double zero = !(a.value > 0.0) && a.rate <= 0.0 ? from : (double)INFINITY;
    while (a.t < to && zero == (double)INFINITY && one->status == LAG_OK) {
        const place b = place_at(one, fmin(a.t + part, to));
        zero = first_zero(one, a, b, HALVES);
        a = b;
    }
    return zero;
}

/* The zero of an affine distance after time t. */
static double affine_zero(distance *one, double t)
{
    const place now = place_at(one, t);
    const double guess = t - now.value / now.rate;
    if (!(now.rate < 0.0) || guess == (double)INFINITY) {
        return (double)INFINITY;
    }
    return guess > t ? fmax(t, guess - value_of(one, guess) / now.rate) : t;
}

double lag_timed_next(const lag_timed *timed)
{
    return lag_lower(timed->next, lag_delays_next(&timed->motion->delays));
}

int lag_timed_due(const lag_timed *timed, double t)
{
    return lag_timed_next(timed) <= lag_timed_behind(timed, t);
}

lag_status lag_timed_set(lag_timed *timed, double t)
{
    const size_t count = timed->motion->model->ntimed;
    if (count == 0) {
        return LAG_OK;
    }
    const lag_status status = evaluate(timed, t);
    memcpy(timed->motion->w + timed->motion->places.timed, timed->value, count * sizeof(double));
    return status;
}

lag_status lag_timed_set_behind(lag_timed *timed, double t)
{
    return lag_timed_set(timed, fmax(lag_timed_behind(timed, t), timed->shown));
}

lag_status lag_timed_find_next(lag_timed *timed, double t)
{
    const lag_model *model = timed->motion->model;
    const double later = lag_timed_behind(timed, t);
    const double length = timed->length > 0.0 ? timed->length : 1.0;
    timed->next = (double)INFINITY;
    if (model->ntimed == 0) {
        return LAG_OK;
    }
    lag_status status = evaluate(timed, t);
    for (size_t i = 0; i < model->ndistance && status == LAG_OK; ++i) {
        distance one = {timed, i, LAG_OK};
        timed->zero[i] = timed->affine[i] != 0.0 && isfinite(timed->rate[i]) ? affine_zero(&one, t) : (double)NAN;
        timed->next = fmin(timed->next, timed->zero[i]);
        status = one.status;
    }
    for (size_t i = 0; i < model->ndistance && status == LAG_OK; ++i) {
        distance one = {timed, i, LAG_OK};
        const double end = fmin(timed->next, t + length);
        if (isnan(timed->zero[i])) {
            timed->zero[i] = end > later ? zero_in_parts(&one, later, end, length / PARTS) : (double)INFINITY;
            timed->next = fmin(end, timed->zero[i]);
            status = one.status;
        }
    }
    return status;
}

/* True if a line has led a distance to zero, and the entry that it belongs to is what it was: the change is lost in round-off. */
static int is_lost(const lag_timed *timed, double later)
{
    const lag_model *model = timed->motion->model;
    const double *w = timed->motion->w + timed->motion->places.timed;
    for (size_t i = 0; i < model->ndistance; ++i) {
        const int known = timed->entry[i] >= 0.0 && timed->entry[i] < (double)model->ntimed;
        const int reached = timed->affine[i] != 0.0 && timed->zero[i] <= later;
        if (known && reached && w[(size_t)timed->entry[i]] == timed->before[(size_t)timed->entry[i]]) {
            return 1;
        }
    }
    return 0;
}

lag_status lag_timed_change(lag_timed *timed, double t)
{
    const double later = lag_timed_behind(timed, t);
    double by = later - t;
    lag_delays_change(&timed->motion->delays, later);
    if (timed->next <= later) {
        timed->motion->delays.pieces.level = 0;
    }
    lag_copy(timed->motion->model->ntimed, timed->motion->w + timed->motion->places.timed, timed->before);
    lag_status status = lag_timed_set(timed, later);
    int lost = status == LAG_OK && is_lost(timed, later);
    for (int k = 0; k < FARTHER && lost && status == LAG_OK; ++k) {
        by *= 2.0;
        status = lag_timed_set(timed, t + by);
        lost = status == LAG_OK && is_lost(timed, later);
    }
    timed->shown = lost ? later : t + by;
    return lost ? lag_timed_set(timed, later) : status; /* a tent at its top never changes */
}

int lag_timed_is_reported(const lag_timed *timed)
{
    const double *w = timed->motion->w + timed->motion->places.timed;
    int told = timed->motion->delays.jumps.any;
    for (size_t i = 0; i < timed->motion->model->ntimed; ++i) {
        told = told || (timed->told[i] != 0.0 && w[i] != timed->before[i]);
    }
    return told;
}
