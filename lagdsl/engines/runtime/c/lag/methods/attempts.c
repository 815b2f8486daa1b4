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

/* Neither the step nor its dense output reads the slopes between the first one and this. */
enum { FIRST_READ = 5 };

size_t lag_attempts_memory(size_t size, size_t lanes)
{
    return (LAG_DOP853_SLOPES + 5 + LAG_DOP853_TERMS) * size * lanes;
}

void lag_attempts_place(lag_attempts *attempts, size_t size, size_t lanes, int wide, lag_rates_in_lanes *rates, void *context, double *memory)
{
    const size_t count = size * lanes;
    memset(attempts, 0, sizeof *attempts);
    lag_fill(lag_attempts_memory(size, lanes), 0.0, memory);
    attempts->wide = wide;
    attempts->rates = rates;
    attempts->context = context;
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
    attempts->rates(attempts->context, t, x, xd, attempts->sound);
    return 1;
}

/* Lanes in which a slope from `first` to before `end` is no number lose their flag. */
LAG_ATTEMPT_INLINED void look(const lag_attempt_arrays *at, size_t first, size_t end, unsigned char *sound)
{
    const size_t count = at->size * at->lanes;
    double sum[LAG_ATTEMPT_LANES] = {0.0};
    lag_attempt_look((end - first) * count, at->lanes, at->slope + first * count, sum);
    for (size_t k = 0; k < at->lanes; ++k) {
        sound[k] = sound[k] && sum[k] == 0.0;
    }
}

/* The dense output of the attempts that are accepted; the last stage stays. */
LAG_ATTEMPT_INLINED void make_dense(lag_attempts *attempts, const double *t_new)
{
    unsigned char sound[LAG_ATTEMPT_LANES];
    lag_attempt_arrays at = attempts->at;
    at.stage = attempts->inside;
    for (size_t i = 0; i < LAG_ATTEMPT_LANES; ++i) {
        const size_t k = i & (at.lanes - 1);
        at.h[i] = t_new[k] - at.t[k]; /* as who comes afterwards sees it, rounded */
    }
    memcpy(sound, attempts->sound, sizeof sound);
    for (size_t i = LAG_DOP853_END + 1; i < LAG_DOP853_SLOPES; ++i) {
        (void)lag_attempt_stage(&at, i, rates_of_stage, attempts);
    }
    look(&at, LAG_DOP853_END + 1, LAG_DOP853_SLOPES, attempts->sound);
    lag_attempt_dense(&at, attempts->terms);
    memcpy(attempts->dense, attempts->sound, sizeof sound);
    memcpy(attempts->sound, sound, sizeof sound);
}

LAG_ATTEMPT_INLINED void make(lag_attempts *attempts, lag_stepper *const *s)
{
    const lag_attempt_arrays *at = &attempts->at;
    double t_new[LAG_ATTEMPT_LANES];
    int accepted = 0;
    int dense = 0;
    (void)lag_attempt_stages(at, rates_of_stage, attempts);
    look(at, 1, LAG_DOP853_STAGES, attempts->sound);
    lag_attempt_errors(at, attempts->error);
    for (size_t k = 0; k < at->lanes; ++k) {
        const int can = s[k] != NULL && attempts->error[k] <= 1.0;
        t_new[k] = can ? s[k]->attempt.t_new : at->t[k];
        accepted = accepted || can;
        dense = dense || (can && s[k]->attempt.dense);
    }
    if (accepted) {
        (void)rates_of_stage(attempts, LAG_DOP853_END, t_new, at->x_new, at->slope + LAG_DOP853_END * at->size * at->lanes);
        look(at, LAG_DOP853_END, LAG_DOP853_END + 1, attempts->sound);
    }
    if (dense) {
        make_dense(attempts, t_new);
    }
}

IN_WIDE static void make_wide(lag_attempts *attempts, lag_stepper *const *s)
{
    make(attempts, s);
}

/* Lane k becomes the attempt of s. */
static void enter(lag_attempts *attempts, const lag_stepper *s, size_t k)
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
    attempts->sound[k] = 1;
}

/* So many arrays of a lane to where its own attempt leaves them. */
static void deal(const lag_attempts *attempts, size_t arrays, const double *from, size_t k, double *to)
{
    const size_t lanes = attempts->at.lanes;
    for (size_t i = 0; i < arrays * attempts->at.size; ++i) {
        to[i] = from[i * lanes + k];
    }
}

/*
 * Of lane k to s, as its own attempt leaves it: the slopes of the end, the last stage, the new state; terms of the dense output, or the slopes
 * that it reads.
 */
static void leave(const lag_attempts *attempts, const lag_stepper *s, size_t k)
{
    const lag_attempt_arrays *at = &attempts->at;
    const size_t size = at->size;
    const size_t first = s->attempt.dense ? LAG_DOP853_STAGES - 1 : FIRST_READ;
    double *to = s->work;
    memcpy(to, s->f, size * sizeof(double));
    deal(attempts, LAG_DOP853_END + 1 - first, at->slope + first * size * at->lanes, k, to + first * size);
    to += LAG_DOP853_SLOPES * size;
    deal(attempts, 1, at->stage, k, to);
    deal(attempts, 1, at->x_new, k, to + size);
    if (s->attempt.dense) {
        deal(attempts, LAG_DOP853_TERMS, attempts->terms, k, to + 2 * size);
    }
}

/* Takes lane k to the attempt of s. Returns 0 where it is to be repeated; what no lane can find is left to an attempt alone. */
static int settle(const lag_attempts *attempts, lag_stepper *s, size_t k)
{
    lag_attempt *attempt = &s->attempt;
    if (!attempts->sound[k]) {
        return 1;
    }
    attempt->made = 1;
    attempt->error = attempts->error[k];
    attempt->evaluations += attempt->error > 1.0 ? LAG_DOP853_STAGES - 1 : LAG_DOP853_STAGES;
    attempt->dense = attempt->dense && attempts->dense[k];
    if (attempt->error <= 1.0) {
        leave(attempts, s, k);
    }
    return attempt->error <= 1.0 || attempt->h <= s->h_least || !lag_attempt_shorten(s);
}

void lag_attempts_make(lag_attempts *attempts, lag_stepper *const *s, unsigned char *done)
{
    const size_t lanes = attempts->at.lanes;
    for (size_t k = 0; k < lanes; ++k) {
        if (s[k] != NULL) {
            enter(attempts, s[k], k);
        }
    }
    if (attempts->wide) {
        make_wide(attempts, s);
    } else {
        make(attempts, s);
    }
    for (size_t k = 0; k < lanes; ++k) {
        done[k] = s[k] != NULL && settle(attempts, s[k], k);
    }
}
