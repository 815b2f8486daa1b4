/* The scan of the last step of a run: piece after piece, up to the first in which a guard leaves its mode. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "lag/linalg/minimum.h"
#include "lag/run.h"
#include "lag/run/scan.h"

enum { LAST = LAG_LAST_SAMPLE, AGAIN = 16 };
/* The first piece is this part of a step. */
static const double FIRST = 0.25;
/* A piece is no shorter than this part of its step. */
static const double SHORTEST = 0x1p-24;
/* Behind a change pieces are no longer than so many times the time since the last change of the same relation: samples do not step over two. */
static const double INTERVALS = 3.0;
/* Values below so many times their round-off have no shape. */
static const double SHAPELESS = 1e3;

typedef struct piece {
    double a, b;
    int samples; /* the last one */
} piece;

static double place_of(const piece *in, int k)
{
    return k == LAST ? in->b : in->a + (in->b - in->a) * LAG_SAMPLE_PLACES[k];
}

static size_t count_of(const lag_run *run)
{
    return lag_guards_count(&run->guards);
}

static void remember(lag_run *run, int k)
{
    for (size_t i = 0; i < count_of(run); ++i) {
        const double value = run->guards.value[i];
        lag_guards_seen(&run->guards, i)[k] = value;
        run->guards.top[i] = fmax(run->guards.top[i], value);
    }
}

/* ---- what comes and goes between samples ---- */

/* Number i near its minimum between samples k - 2 and k. */
typedef struct near_minimum {
    lag_run *run;
    const piece *in;
    int k;
    size_t i;
    double t;          /* of the last value, */
    lag_status status; /* and LAG_EVENT_PENDING if it has changed there */
} near_minimum;

static int value_near_minimum(void *context, double place, double *value)
{
    near_minimum *one = context;
    lag_run *run = one->run;
    one->t = one->in->a + place * (one->in->b - one->in->a);
    if (!(one->t > run->stepper.t_before) || !(one->t < place_of(one->in, one->k))) {
        return 1;
    }
    const lag_status status = lag_scan_detect(run, one->t);
    *value = run->guards.value[one->i];
    one->status = status == LAG_EVENT_PENDING && run->guards.changed[one->i] == 0.0 ? LAG_OK : status;
    return one->status != LAG_OK;
}

/* LAG_EVENT_PENDING: number i, known up to an error, has changed at the minimum, at *t, between samples k - 2 and k. */
static lag_status check_minimum(lag_run *run, const piece *in, int k, size_t i, double error, double *t)
{
    near_minimum one = {run, in, k, i, 0.0, LAG_OK};
    const int just = k == 2 && in->a == run->stepper.t_before;
    (void)lag_minimum_search(value_near_minimum, &one, LAG_SAMPLE_PLACES + k - 2, lag_guards_seen(&run->guards, i) + k - 2, error, just);
    *t = one.t;
    return one.status;
}

/* Finds a value that changes and changes back between two samples: LAG_EVENT_PENDING if it has changed at *b and not yet at *a. */
static lag_status check_minima(lag_run *run, const piece *in, double *a, double *b)
{
    double there = 0.0;
    for (int k = 2; k <= in->samples; ++k) {
        for (size_t i = 0; i < count_of(run); ++i) {
            const int changes = lag_guards_seen(&run->guards, i)[k] < 0.0;
            const lag_status status = changes ? LAG_OK : check_minimum(run, in, k, i, run->guards.pieces.found[i], &there);
            if (status != LAG_OK) {
                *a = there <= place_of(in, k - 1) ? place_of(in, k - 2) : place_of(in, k - 1);
                *b = there;
                return status;
            }
        }
    }
    return LAG_OK;
}

/* ---- one piece ---- */

static double largest_value(const lag_run *run, const piece *in, size_t i)
{
    double most = 0.0;
    for (int k = 0; k <= in->samples; ++k) {
        most = fmax(most, fabs(lag_guards_seen(&run->guards, i)[k]));
    }
    return most;
}

/* Round-off of value i, found where it is not known yet. */
static double noise_of(lag_run *run, size_t i)
{
    if (lag_guards_has_noise(&run->guards, i) && !(lag_guards_noise(&run->guards, i) > 0.0)) {
        lag_noise_find(run->guards.noise, run->stepper.t_before, run->stepper.x_before);
    }
    return lag_guards_noise(&run->guards, i);
}

/*
 * Error of value i, the difference of the polynomials, as a part of its largest value; zero where that is round-off. Writes the error of parabolas
 * through three samples into `found`.
 */
static double doubt_of(lag_run *run, const piece *in, size_t i)
{
    const double most = largest_value(run, in, i);
    run->guards.pieces.found[i] = LAG_KNOWN_PART * most;
    const double difference = in->samples == LAST ? lag_piece_error(lag_guards_seen(&run->guards, i), &run->guards.pieces.found[i]) : 0.0;
    if (!(difference > LAG_KNOWN_PART * most)) {
        return most > 0.0 ? difference / most : 0.0;
    }
    return most > SHAPELESS * noise_of(run, i) ? difference / most : 0.0;
}

static double largest_doubt(lag_run *run, const piece *in)
{
    double most = 0.0;
    for (size_t i = 0; i < count_of(run); ++i) {
        most = fmax(most, doubt_of(run, in, i));
    }
    return most;
}

/* Samples a piece, up to the first at which something has changed; LAG_EVENT_PENDING: at *b, and not yet at *a. */
static lag_status sample_piece(lag_run *run, piece *in, double *a, double *b)
{
    lag_status status = LAG_OK;
    for (int k = 1; k <= LAST && status == LAG_OK; ++k) {
        *a = place_of(in, k - 1);
        *b = place_of(in, k);
        status = lag_scan_detect(run, *b);
        remember(run, k);
        in->samples = k;
    }
    return status;
}

/* Pieces from a on; `reach` is the length of the next one. */
typedef struct scan {
    double a, reach, shortest, longest;
} scan;

/* 1: the piece is known as well as it can be; in `reach`, how long the next one is to be, or this one otherwise. */
static int accept(lag_run *run, scan *on, const piece *in, lag_status status)
{
    const double w = in->b - in->a;
    const double doubt = largest_doubt(run, in);
    if (doubt > LAG_KNOWN_PART && w > 1.5 * on->shortest) {
        on->reach = fmax(on->shortest, fmin(0.7 * w, lag_piece_length(w, doubt)));
        return 0;
    }
    if (in->samples == LAST && status == LAG_OK) {
        const double next = lag_piece_length(w, doubt);
        const int is_cut = in->b == run->stepper.t; /* it tells nothing of longer ones */
        on->reach = fmin(on->longest, is_cut ? fmin(on->reach, fmax(w, next)) : next);
    }
    return 1;
}

/*
 * The first change in a piece that was sampled with `status`. A change that is undone before another one that was found shows only in samples
 * at the part before that: values may have their minima between the same samples, and before the first sample there is none.
 */
static lag_status find_first(lag_run *run, piece *in, lag_status status, double *a, double *b)
{
    for (int again = 0; again < AGAIN; ++again) {
        const lag_status between = check_minima(run, in, a, b);
        status = between == LAG_OK ? status : between;
        if (status != LAG_EVENT_PENDING || (between == LAG_OK && (in->samples > 1 || again > 0))) {
            break;
        }
        in->b = *b;
        status = sample_piece(run, in, a, b);
        (void)largest_doubt(run, in);
    }
    return status;
}

/* A value that changes within round-off of time behind the end changes at the end. */
static lag_status find_zeros_at_end(lag_run *run, const piece *in)
{
    const double h = in->b - place_of(in, LAST - 1);
    const double soon = LAG_SCAN_TOGETHER * lag_scan_tolerance(run);
    int any = 0;
    for (size_t i = 0; i < count_of(run); ++i) {
        const double *seen = lag_guards_seen(&run->guards, i);
        const double value = seen[LAST];
        const double rate = (value - seen[LAST - 1]) / h;
        run->guards.changed[i] = rate < 0.0 && value <= -rate * soon && run->guards.top[i] > noise_of(run, i);
        any = any || run->guards.changed[i] != 0.0;
    }
    return any ? LAG_EVENT_PENDING : LAG_OK;
}

static lag_status scan_pieces(lag_run *run, scan *on, double *t)
{
    const lag_stepper *s = &run->stepper;
    piece in = {on->a, on->a, 0};
    remember(run, 0);
    while (in.a < s->t) {
        double a = 0.0;
        double b = 0.0;
        in.b = s->t - in.a > on->reach && in.a + on->reach > in.a ? in.a + on->reach : s->t;
        lag_status status = sample_piece(run, &in, &a, &b);
        const int accepted = (status == LAG_OK || status == LAG_EVENT_PENDING) && accept(run, on, &in, status);
        status = accepted ? find_first(run, &in, status, &a, &b) : status;
        if (status != LAG_OK && status != LAG_EVENT_PENDING) {
            return status;
        }
        if (accepted && status == LAG_EVENT_PENDING) {
            if (run->guards.time != b) {
                (void)lag_scan_detect(run, b);
            }
            *t = lag_scan_earliest(run, a, b);
            return status;
        }
        if (accepted && in.b == s->t && find_zeros_at_end(run, &in) == LAG_EVENT_PENDING) {
            *t = s->t;
            return LAG_EVENT_PENDING;
        }
        for (size_t i = 0; i < count_of(run) && accepted; ++i) {
            lag_guards_seen(&run->guards, i)[0] = lag_guards_seen(&run->guards, i)[LAST];
        }
        in.a = accepted ? in.b : in.a;
    }
    return LAG_OK;
}

/* Limits the next piece behind relations that were found to change at t: gaps stay negative until they are found. */
static void limit_behind(lag_run *run, double t)
{
    lag_guards *guards = &run->guards;
    for (size_t i = 0; i < run->motion.model->nindicator; ++i) {
        if (guards->changed[i] != 0.0) {
            guards->pieces.limit = fmin(guards->pieces.limit, INTERVALS * (t - guards->pieces.when[i]));
            guards->pieces.when[i] = t;
        }
    }
}

lag_status lag_run_happening(lag_run *run, double *t)
{
    const lag_stepper *s = &run->stepper;
    lag_guards *guards = &run->guards;
    const double h = s->t - s->t_before;
    if (count_of(run) == 0 || !(h > 0.0)) {
        return LAG_OK;
    }
    const double length = run->instants.contacts.length;
    scan on = {s->t_before, guards->pieces.reach > 0.0 ? guards->pieces.reach : FIRST * h, 0.0, (double)INFINITY};
    on.shortest = fmax(SHORTEST * h, 64.0 * lag_scan_tolerance(run));
    on.longest = length > 0.0 ? LAG_SCAN_LONGEST * length : (double)INFINITY;
    on.reach = fmin(fmax(on.reach, on.shortest), on.longest); /* the last step may have been as short as round-off */
    const double begun = on.reach;
    on.reach = fmin(begun, fmax(guards->pieces.limit, on.shortest));
    const double limited = on.reach;
    guards->pieces.limit = (double)INFINITY;
    lag_status status = lag_stepper_dense(&run->stepper, on.a, run->point);
    if (status == LAG_OK) {
        status = lag_guards_begin(guards, on.a, run->point);
    }
    if (status == LAG_OK) {
        status = scan_pieces(run, &on, t);
    }
    guards->pieces.reach = on.reach < limited ? on.reach : fmax(on.reach, begun);
    if (status == LAG_EVENT_PENDING) {
        limit_behind(run, *t);
    }
    if (status == LAG_EVENT_PENDING && s->t - *t <= LAG_SCAN_TOGETHER * lag_scan_tolerance(run)) {
        *t = s->t;
    }
    return status;
}
