#include "lag/methods/attempts.h"

#include <string.h>

#include "lag/linalg/arena.h"

size_t lag_attempts_memory(size_t size, size_t lanes)
{
    return (LAG_DOP853_SLOPES + 5) * size * lanes;
}

void lag_attempts_place(lag_attempts *attempts, size_t size, size_t lanes, lag_rates_in_lanes *rates, void *context, double *memory)
{
    const size_t count = size * lanes;
    memset(attempts, 0, sizeof *attempts);
    attempts->rates = rates;
    attempts->context = context;
    attempts->at.size = size;
    attempts->at.lanes = lanes;
    attempts->at.stage = lag_take(&memory, count);
    attempts->at.slope = lag_take(&memory, LAG_DOP853_SLOPES * count);
    attempts->at.x_new = lag_take(&memory, count);
    attempts->at.x = attempts->x = lag_take(&memory, count);
    attempts->inside = lag_take(&memory, count);
    attempts->at.tolerance = attempts->tolerance = lag_take(&memory, count);
}

static int rates_of_stage(void *context, size_t i, const double *t, const double *x, double *xd)
{
    lag_attempts *attempts = context;
    (void)i;
    attempts->rates(attempts->context, t, x, xd, attempts->sound);
    return 1;
}

static int rates_of_dense(void *context, size_t i, const double *t, const double *x, double *xd)
{
    lag_attempts *attempts = context;
    (void)i;
    attempts->rates(attempts->context, t, x, xd, attempts->dense);
    return 1;
}

LAG_ATTEMPT_INLINED void make(lag_attempts *attempts, lag_stepper *const *s)
{
    const lag_attempt_arrays *at = &attempts->at;
    double t_new[LAG_ATTEMPT_LANES];
    int accepted = 0;
    int dense = 0;
    (void)lag_attempt_stages(at, rates_of_stage, attempts);
    lag_attempt_errors(at, attempts->error);
    for (size_t k = 0; k < at->lanes; ++k) {
        const int can = s[k] != NULL && attempts->error[k] <= 1.0;
        t_new[k] = can ? s[k]->attempt.t_new : at->t[k];
        accepted = accepted || can;
        dense = dense || (can && s[k]->attempt.dense);
    }
    if (accepted) {
        (void)rates_of_stage(attempts, LAG_DOP853_END, t_new, at->x_new, at->slope + LAG_DOP853_END * at->size * at->lanes);
    }
    lag_attempt_arrays inside = *at; /* the last stage stays */
    inside.stage = attempts->inside;
    for (size_t i = 0; i < LAG_ATTEMPT_LANES; ++i) {
        const size_t k = i & (at->lanes - 1);
        inside.h[i] = t_new[k] - at->t[k]; /* as who comes afterwards sees it, rounded */
    }
    memcpy(attempts->dense, attempts->sound, sizeof attempts->dense);
    for (size_t i = LAG_DOP853_END + 1; i < LAG_DOP853_SLOPES && dense; ++i) {
        (void)lag_attempt_stage(&inside, i, rates_of_dense, attempts);
    }
}

/* Wider registers where the processor has them, which is asked when it runs: the library is one for all of them. */
#if defined(__x86_64__) && defined(__GNUC__) && defined(__STDC_HOSTED__) && __STDC_HOSTED__ && !defined(__AVX2__)
__attribute__((target("avx2"))) static void make_wide(lag_attempts *attempts, lag_stepper *const *s)
{
    make(attempts, s);
}
#define WIDE __builtin_cpu_supports("avx2")
#else
#define make_wide make
#define WIDE 0
#endif

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

/* Neither the step nor its dense output reads the slopes between the first one and this. */
enum { FIRST_READ = 5 };

/* Of lane k to s, as its own attempt leaves it: slopes that the step and its dense output read, the last stage, the new state. */
static void leave(const lag_attempts *attempts, const lag_stepper *s, size_t k)
{
    const size_t size = attempts->at.size;
    const size_t lanes = attempts->at.lanes;
    const size_t slopes = s->attempt.dense ? LAG_DOP853_SLOPES : LAG_DOP853_END + 1;
    double *to = s->work;
    memcpy(to, s->f, size * sizeof(double));
    for (size_t j = FIRST_READ; j < slopes; ++j) {
        for (size_t i = 0; i < size; ++i) {
            to[j * size + i] = attempts->at.slope[(j * size + i) * lanes + k];
        }
    }
    to += LAG_DOP853_SLOPES * size;
    for (size_t i = 0; i < size; ++i) {
        to[i] = attempts->at.stage[i * lanes + k];
        to[size + i] = attempts->at.x_new[i * lanes + k];
    }
}

/* What became of the attempt of s in lane k. Returns 0 where it is to be repeated; what no lane can find is left to an attempt alone. */
static int settle(const lag_attempts *attempts, lag_stepper *s, size_t k)
{
    lag_attempt *attempt = &s->attempt;
    if (!attempts->sound[k]) {
        return 1;
    }
    attempt->made = 1;
    attempt->error = attempts->error[k];
    attempt->evaluations += LAG_DOP853_STAGES - (attempt->error > 1.0);
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
    if (WIDE) {
        make_wide(attempts, s);
    } else {
        make(attempts, s);
    }
    for (size_t k = 0; k < lanes; ++k) {
        done[k] = s[k] != NULL && settle(attempts, s[k], k);
    }
}
