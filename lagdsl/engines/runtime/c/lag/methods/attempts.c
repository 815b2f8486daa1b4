#include "lag/methods/attempts_make.h"

#include <string.h>

#include "lag/linalg/arena.h"

size_t lag_attempts_memory(size_t size, size_t lanes)
{
    return (LAG_DOP853_SLOPES + 5 + LAG_DOP853_TERMS) * size * lanes;
}

void lag_attempts_place(lag_attempts *attempts, size_t size, size_t lanes, size_t width, double *memory)
{
    const size_t count = size * lanes;
    memset(attempts, 0, sizeof *attempts);
    lag_fill(lag_attempts_memory(size, lanes), 0.0, memory);
    attempts->width = width;
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

static void make(lag_attempts *groups, size_t count, lag_stepper *const *s)
{
    lag_attempts_make_inlined(groups, count, s);
}

/* The library is one for all processors: wider registers are used where there are some. */
void lag_attempts_make(lag_attempts *groups, size_t count, lag_stepper *const *s)
{
    switch (groups->width) {
#if LAG_ATTEMPTS_WIDE
    case 8: lag_attempts_make_widest(groups, count, s); break;
    case 4: lag_attempts_make_wide(groups, count, s); break;
#endif
    default: make(groups, count, s); break;
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

/* A lane that failed is left to an attempt alone. */
int lag_attempts_settle(const lag_attempts *attempts, lag_stepper *s, size_t k)
{
    lag_attempt *attempt = &s->attempt;
    if (attempts->step_fault[k] != 0.0) {
        return 1;
    }
    attempt->made = attempt->bare = 1;
    attempt->error = attempts->error[k];
    attempt->urge = attempts->urge[k];
    attempt->evaluations += attempt->error > 1.0 ? LAG_DOP853_STAGES - 1 : LAG_DOP853_STAGES;
    attempt->dense = attempt->dense && attempts->fault[k] == 0.0;
    if (attempt->error <= 1.0) {
        leave(attempts, s, k);
    }
    return attempt->error <= 1.0 || attempt->h <= s->h_least || !lag_attempt_shorten(s);
}
