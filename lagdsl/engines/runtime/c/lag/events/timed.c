#include "lag/events/timed.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "lag/linalg/arena.h"
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
/* until cubics are off by less than this part of what is seen. */
static const double OFF = 0.01;

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
    double value, rate;
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

/* A point of a distance. */
typedef struct point {
    double t, value, rate;
} point;

static point at(distance *one, double t)
{
    (void)value_of(one, t);
    return (point){t, one->value, one->rate};
}

/* Error of Hermite's cubic through a and b at the middle; not a number if there is no cubic. */
static double misfit(const point *a, const point *m, const point *b)
{
    const double h = b->t - a->t;
    const double value = 0.5 * (a->value + b->value) + 0.125 * h * (a->rate - b->rate);
    const double rate = 1.5 * (b->value - a->value) / h - 0.25 * (a->rate + b->rate);
    return fabs(m->value - value) + h * fabs(m->rate - rate);
}

/* The least value of Hermite's cubic between a and b, and where that is. */
static double least(const point *a, const point *b, double *t)
{
    const double h = b->t - a->t;
    const double bend = 3.0 * (b->value - a->value) - h * (2.0 * a->rate + b->rate);
    const double twist = 2.0 * (a->value - b->value) + h * (a->rate + b->rate);
    const double root = sqrt(bend * bend - 3.0 * twist * h * a->rate);
    /* the zero of the derivative with positive curvature, in the form that does not cancel */
    const double s = bend + root != 0.0 ? -h * a->rate / (bend + root) : -1.0;
    *t = a->value <= b->value ? a->t : b->t;
    double value = fmin(a->value, b->value);
    if (s > 0.0 && s < 1.0) {
        const double inside = a->value + s * (h * a->rate + s * (bend + s * twist));
        if (inside < value) {
            value = inside;
            *t = a->t + s * h;
        }
    }
    return value;
}

static int is_out(const point *p)
{
    return !(p->value > 0.0);
}

static int is_infinite(const point *p)
{
    return p->value == (double)INFINITY;
}

/* The zero between a, which is inside, and b, which is not. */
static double zero_between(distance *one, const point *a, const point *b)
{
    return lag_root(value_of, one, a->t, fmax(a->value, DBL_MIN), b->t, b->value, DBL_EPSILON * fabs(b->t));
}

/* The first zero between a and b, on which a cubic fits; infinite without; *unclear: it may touch zero, halve it. */
static double zero_in(distance *one, const point *a, const point *b, double off, int *unclear)
{
    double place = 0.0;
    const double lowest = least(a, b, &place);
    if (lowest > off) {
        return (double)INFINITY;
    }
    if (place > a->t && place < b->t) {
        const point p = at(one, place);
        if (is_out(&p)) {
            return zero_between(one, a, &p);
        }
    }
    if (is_out(b)) {
        return zero_between(one, a, b);
    }
    *unclear = lowest < off && place > a->t && place < b->t;
    return (double)INFINITY;
}

/* The first zero of a distance between times `from` and `to`, in steps of at most `part`. */
static double first_zero(distance *one, double from, double to, double part)
{
    const double shortest = ldexp(part, -HALVES);
    double h = part;
    point a = at(one, from);
    if (is_out(&a)) {
        if (a.rate <= 0.0) {
            return from;
        }
        a.value = 0.0; /* it has just come in */
    }
    while (a.t < to && one->status == LAG_OK) {
        const double end = fmin(a.t + h, to);
        const point m = at(one, a.t + 0.5 * (end - a.t));
        const point b = at(one, end);
        const double size = fmax(fmax(fabs(a.value), fabs(m.value)), fabs(b.value));
        const double off = misfit(&a, &m, &b);
        /* after a division by zero no cubic fits, however short the step: there is nothing to look for */
        const int infinite = is_infinite(&a) && is_infinite(&m) && is_infinite(&b);
        int unclear = !infinite && !(off <= OFF * size);
        if (!infinite && (!unclear || h <= shortest)) {
            double zero = zero_in(one, &a, &m, off, &unclear);
            zero = zero < (double)INFINITY ? zero : zero_in(one, &m, &b, off, &unclear);
            if (zero < (double)INFINITY) {
                return zero;
            }
        }
        if (unclear && h > shortest) {
            h *= 0.5;
            continue;
        }
        a = b;
        h = fmin(2.0 * h, part);
    }
    return (double)INFINITY;
}

/* The zero of an affine distance after time t. */
static double affine_zero(distance *one, double t)
{
    const point a = at(one, t);
    const double guess = t - a.value / a.rate;
    if (!(a.rate < 0.0) || guess == (double)INFINITY) {
        return (double)INFINITY;
    }
    if (!(guess > t)) {
        return t;
    }
    const double value = value_of(one, guess);
    return fmax(t, guess - value / a.rate);
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
        distance one = {timed, i, LAG_OK, 0.0, 0.0};
        timed->zero[i] = timed->affine[i] != 0.0 && isfinite(timed->rate[i]) ? affine_zero(&one, t) : (double)NAN;
        timed->next = fmin(timed->next, timed->zero[i]);
        status = one.status;
    }
    for (size_t i = 0; i < model->ndistance && status == LAG_OK; ++i) {
        distance one = {timed, i, LAG_OK, 0.0, 0.0};
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
