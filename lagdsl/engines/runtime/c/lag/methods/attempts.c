/* The library is one for all processors: wider registers are used where there are some. */
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__AVX__)
#define LAG_ATTEMPT_WIDTH 4
#define IN_WIDE __attribute__((target("avx")))
#else
#define IN_WIDE
#endif

#include "lag/methods/attempts.h"

#include <string.h>

#include "lag/linalg/arena.h"

size_t lag_attempts_memory(size_t size, size_t lanes)
{
    return (LAG_DOP853_SLOPES + 5 + LAG_DOP853_TERMS) * size * lanes;
}

void lag_attempts_place(lag_attempts *attempts, size_t size, size_t lanes, int wide, double *memory)
{
    const size_t count = size * lanes;
    memset(attempts, 0, sizeof *attempts);
    lag_fill(lag_attempts_memory(size, lanes), 0.0, memory);
    attempts->wide = wide;
    attempts->at.size = size;
    attempts->at.lanes = lanes;
    attempts->at.stage = lag_take(&memory, count);
    attempts->at.slope = lag_take(&memory, LAG_DOP853_SLOPES * count);
    attempts->at.x_new = lag_take(&memory, count);
    attempts->at.x = attempts->x = lag_take(&memory, count);
    attempts->inside = lag_take(&memory, count);
    attempts->terms = lag_take(&memory, LAG_DOP853_TERMS * count);
    attempts->at.tolerance = attempts->tolerance = lag_take(&memory, count);
}

static int rates_of_stage(void *context, size_t i, const double *t, const double *x, double *xd)
{
    lag_attempts *attempts = context;
    (void)i;
    attempts->rates(attempts->context, t, x, xd, attempts->fault);
    return 1;
}

/* Lanes in which a slope from `first` to before `end` is no number fail. */
LAG_ATTEMPT_INLINED void look(const lag_attempt_arrays *at, size_t first, size_t end, double *fault)
{
    const size_t count = at->size * at->lanes;
    lag_attempt_look((end - first) * count, at->lanes, at->slope + first * count, fault);
}

/* The dense output of the attempts that are accepted; the last stage stays. */
LAG_ATTEMPT_INLINED void make_dense(lag_attempts *attempts, const double *t_new)
{
    double fault[LAG_ATTEMPT_LANES];
    lag_attempt_arrays at = attempts->at;
    at.stage = attempts->inside;
    for (size_t i = 0; i < LAG_ATTEMPT_LANES; ++i) {
        const size_t k = i & (at.lanes - 1);
        at.h[i] = t_new[k] - at.t[k]; /* as who comes afterwards sees it, rounded */
    }
    memcpy(fault, attempts->fault, sizeof fault);
    for (size_t i = LAG_DOP853_END + 1; i < LAG_DOP853_SLOPES; ++i) {
        (void)lag_attempt_stage(&at, i, rates_of_stage, attempts);
    }
    look(&at, LAG_DOP853_END + 1, LAG_DOP853_SLOPES, attempts->fault);
    lag_attempt_dense(&at, attempts->terms);
    memcpy(attempts->dense_fault, attempts->fault, sizeof fault);
    memcpy(attempts->fault, fault, sizeof fault);
}

/* Rates at the ends of the attempts that are accepted, and what else is found there. */
LAG_ATTEMPT_INLINED void make_ends(lag_attempts *attempts, const double *t_new)
{
    const lag_attempt_arrays *at = &attempts->at;
    (void)rates_of_stage(attempts, LAG_DOP853_END, t_new, at->x_new, at->slope + LAG_DOP853_END * at->size * at->lanes);
    look(at, LAG_DOP853_END, LAG_DOP853_END + 1, attempts->fault);
    lag_attempt_urges(at, attempts->urge);
    if (attempts->ends != NULL) {
        attempts->ends(attempts->context, t_new, at->x_new);
    }
}

LAG_ATTEMPT_INLINED void make(lag_attempts *attempts, lag_stepper *const *s)
{
    const lag_attempt_arrays *at = &attempts->at;
    double t_new[LAG_ATTEMPT_LANES];
    int accepted = 0;
    int dense = 0;
    memset(attempts->fault, 0, sizeof attempts->fault);
    (void)lag_attempt_stages(at, rates_of_stage, attempts);
    look(at, 1, LAG_DOP853_STAGES, attempts->fault);
    lag_attempt_errors(at, attempts->error);
    for (size_t k = 0; k < at->lanes; ++k) {
        const int can = s[k] != NULL && attempts->error[k] <= 1.0;
        t_new[k] = can ? s[k]->attempt.t_new : at->t[k];
        accepted = accepted || can;
        dense = dense || (can && s[k]->attempt.dense);
    }
    if (accepted) {
        make_ends(attempts, t_new);
    }
    if (dense) {
        make_dense(attempts, t_new);
    }
}

IN_WIDE static void make_wide(lag_attempts *attempts, lag_stepper *const *s)
{
    make(attempts, s);
}

void lag_attempts_make(lag_attempts *attempts, lag_stepper *const *s)
{
    if (attempts->wide) {
        make_wide(attempts, s);
    } else {
        make(attempts, s);
    }
}

void lag_attempts_enter(lag_attempts *attempts, const lag_stepper *s, size_t k)
{
    const size_t lanes = attempts->at.lanes;
    attempts->at.t[k] = s->t;
    for (size_t i = k; i < LAG_ATTEMPT_LANES; i += lanes) {
        attempts->at.h[i] = s->attempt.h;
    }
    for (size_t i = 0; i < attempts->at.size; ++i) {
        attempts->x[i * lanes + k] = s->x[i];
        attempts->at.slope[i * lanes + k] = s->f[i];
        attempts->tolerance[i * lanes + k] = s->tolerance[i];
    }
}

/* So many arrays of a lane to where its own attempt leaves them. */
static void deal(const lag_attempts *attempts, size_t arrays, const double *from, size_t k, double *to)
{
    const size_t lanes = attempts->at.lanes;
    for (size_t i = 0; i < arrays * attempts->at.size; ++i) {
        to[i] = from[i * lanes + k];
    }
}

/* Of lane k to s: the new state and the slope there, and the terms of the dense output. */
static void leave(const lag_attempts *attempts, const lag_stepper *s, size_t k)
{
    const lag_attempt_arrays *at = &attempts->at;
    const size_t size = at->size;
    double *to = s->work;
    deal(attempts, 1, at->slope + LAG_DOP853_END * size * at->lanes, k, to + LAG_DOP853_END * size);
    to += (LAG_DOP853_SLOPES + 1) * size;
    deal(attempts, 1, at->x_new, k, to);
    if (s->attempt.dense) {
        deal(attempts, LAG_DOP853_TERMS, attempts->terms, k, to + size);
    }
}

/* What no lane can find is left to an attempt alone. */
int lag_attempts_settle(const lag_attempts *attempts, lag_stepper *s, size_t k)
{
    lag_attempt *attempt = &s->attempt;
    if (attempts->fault[k] != 0.0) {
        return 1;
    }
    attempt->made = attempt->bare = 1;
    attempt->error = attempts->error[k];
    attempt->urge = attempts->urge[k];
    attempt->evaluations += attempt->error > 1.0 ? LAG_DOP853_STAGES - 1 : LAG_DOP853_STAGES;
    attempt->dense = attempt->dense && attempts->dense_fault[k] == 0.0;
    if (attempt->error <= 1.0) {
        leave(attempts, s, k);
    }
    return attempt->error <= 1.0 || attempt->h <= s->h_least || !lag_attempt_shorten(s);
}
