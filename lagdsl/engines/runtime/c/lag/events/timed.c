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
/* each of them halved at most so often. */
enum { HALVES = 20 };

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
    double t, value, rate; /* of the last look */
} distance;

static double value_of(void *context, double t)
{
    distance *one = context;
    const lag_status status = evaluate(one->timed, t);
    one->status = one->status == LAG_OK ? status : one->status;
    one->value = one->timed->distance[one->which];
    one->rate = one->timed->rate[one->which];
    return one->value;
}

static double zero_between(distance *one, double a, double before, double b, double behind)
{
    return lag_root(value_of, one, a, fmax(before, DBL_MIN), b, behind, DBL_EPSILON * fabs(b));
}

static int look_at(void *context, double t, double *value)
{
    distance *one = context;
    *value = value_of(one, t);
    one->t = t;
    return !(*value > 0.0);
}

/* The first zero in a piece, of which the samples are known; infinite without. */
static double zero_in(distance *one, const double *t, const double *values, int just)
{
    double error = 0.0;
    (void)lag_piece_error(values, &error);
    for (int k = 1; k < LAG_PIECE_SAMPLES; ++k) {
        if (!(values[k] > 0.0)) {
            return zero_between(one, t[k - 1], values[k - 1], t[k], values[k]);
        }
        if (k > 1 && lag_minimum_search(look_at, one, t + k - 2, values + k - 2, error, just && k == 2)) {
            const int before = one->t <= t[k - 1] ? k - 2 : k - 1;
            return zero_between(one, t[before], values[before], one->t, one->value);
        }
    }
    return (double)INFINITY;
}

/* Doubt about the shape of a piece by its samples, as a part of the largest of them. Waves between samples show in rates that do not lead from one to the next. */
static double doubt_of(const double *t, const double *values, const double *rates)
{
    double most = 0.0;
    double off = 0.0;
    for (int k = 1; k < LAG_PIECE_SAMPLES; ++k) {
        most = fmax(most, fmax(fabs(values[k - 1]), fabs(values[k])));
        off = fmax(off, fabs(values[k] - values[k - 1] - 0.5 * (t[k] - t[k - 1]) * (rates[k - 1] + rates[k])));
    }
    return most > 0.0 ? fmax(off / most, lag_piece_doubt(values)) : 0.0;
}

/* The first zero of a distance between times `from` and `to`, in pieces that samples tell the shape of, at most as long as `part`. */
static double first_zero(distance *one, double from, double to, double part)
{
    const double shortest = ldexp(part, -HALVES);
    double a = from;
    double reach = part;
    if (!(value_of(one, from) > 0.0) && one->rate <= 0.0) {
        return from;
    }
    while (a < to && one->status == LAG_OK) {
        double t[LAG_PIECE_SAMPLES];
        double values[LAG_PIECE_SAMPLES];
        double rates[LAG_PIECE_SAMPLES];
        const double w = fmin(reach, to - a);
        for (int k = 0; k < LAG_PIECE_SAMPLES; ++k) {
            t[k] = k < LAG_LAST_SAMPLE ? a + w * LAG_SAMPLE_PLACES[k] : w < reach ? to : a + w;
            values[k] = value_of(one, t[k]);
            rates[k] = one->rate;
        }
        const double doubt = doubt_of(t, values, rates);
        const int known = !(doubt > LAG_KNOWN_PART) || w <= shortest;
        const double zero = known ? zero_in(one, t, values, a == from) : (double)INFINITY;
        if (zero < (double)INFINITY) {
            return zero;
        }
        a = known ? t[LAG_LAST_SAMPLE] : a;
        reach = known ? fmin(part, lag_piece_length(w, doubt)) : fmax(shortest, 0.5 * w);
    }
    return (double)INFINITY;
}

/* The zero of an affine distance after time t. */
static double affine_zero(distance *one, double t)
{
    const double value = value_of(one, t);
    const double rate = one->rate;
    const double guess = t - value / rate;
    if (!(rate < 0.0) || guess == (double)INFINITY) {
        return (double)INFINITY;
    }
    return guess > t ? fmax(t, guess - value_of(one, guess) / rate) : t;
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
        distance one = {timed, i, LAG_OK, t, 0.0, 0.0};
        timed->zero[i] = timed->affine[i] != 0.0 && isfinite(timed->rate[i]) ? affine_zero(&one, t) : (double)NAN;
        timed->next = fmin(timed->next, timed->zero[i]);
        status = one.status;
    }
    for (size_t i = 0; i < model->ndistance && status == LAG_OK; ++i) {
        distance one = {timed, i, LAG_OK, t, 0.0, 0.0};
        const double end = fmin(timed->next, t + length);
        if (isnan(timed->zero[i])) {
            timed->zero[i] = end > later ? first_zero(&one, later, end, length / PARTS) : (double)INFINITY;
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
