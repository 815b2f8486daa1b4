#include "lag/methods/attempts_make.h"

#include <string.h>

#include "lag/linalg/arena.h"
#include "lag/linalg/vector.h"
#include "lag/methods/step_control.h"

size_t lag_attempts_memory(size_t size, size_t lanes)
{
    return (LAG_DOP853_SLOPES + 9 + LAG_DOP853_TERMS) * size * lanes;
}

void lag_attempts_place(lag_attempts *attempts, size_t size, size_t lanes, size_t width, double *memory)
{
    const size_t count = size * lanes;
    memset(attempts, 0, sizeof *attempts);
    lag_fill(lag_attempts_memory(size, lanes), 0.0, memory);
    attempts->width = width < lanes ? width : lanes;
    attempts->at.size = size;
    attempts->at.lanes = lanes;
    attempts->at.stage = lag_take(&memory, count);
    attempts->at.slope = lag_take(&memory, LAG_DOP853_SLOPES * count);
    attempts->at.x_new = lag_take(&memory, count);
    attempts->at.x = attempts->x = lag_take(&memory, count);
    attempts->inside = lag_take(&memory, count);
    attempts->terms = lag_take(&memory, LAG_DOP853_TERMS * count);
    attempts->at.tolerance = attempts->tolerance = lag_take(&memory, count);
    attempts->accuracy.largest = lag_take(&memory, count);
    attempts->accuracy.floor = lag_take(&memory, count);
    attempts->accuracy.most = lag_take(&memory, count);
    attempts->accuracy.least = lag_take(&memory, count);
}

static void make(lag_attempts *groups, size_t count)
{
    lag_attempts_make_inlined(groups, count);
}

/* The library is one for all processors: wider registers are used where there are some. */
void lag_attempts_make(lag_attempts *groups, size_t count)
{
    switch (groups->width) {
#if LAG_ATTEMPTS_WIDE
    case 8: lag_attempts_make_widest(groups, count); break;
    case 4: lag_attempts_make_wide(groups, count); break;
#endif
    default: make(groups, count); break;
    }
}

void lag_attempts_enter(lag_attempts *attempts, const lag_stepper *s, size_t k)
{
    lag_lane_steps *step = &attempts->step;
    const size_t size = attempts->at.size;
    const size_t lanes = attempts->at.lanes;
    attempts->at.t[k] = s->t;
    for (size_t i = k; i < LAG_ATTEMPT_LANES; i += lanes) {
        attempts->at.h[i] = s->attempt.h;
    }
    step->used[k] = 1.0;
    step->open[k] = step->accepted[k] = step->refused[k] = 0.0;
    step->dense[k] = (double)s->attempt.dense;
    step->t_new[k] = s->attempt.t_new;
    step->first[k] = s->attempt.first;
    step->next[k] = s->attempt.next;
    step->limit[k] = s->attempt.limit;
    step->h_least[k] = s->h_least;
    step->h_most[k] = s->h_most;
    step->before[k] = lag_control_before(s->last.error);
    step->rejections[k] = (double)s->attempt.rejections;
    lag_lane_put(lanes, k, size, s->x, attempts->x);
    lag_lane_put(lanes, k, size, s->f, attempts->at.slope);
    lag_lane_put(lanes, k, size, s->tolerance, attempts->tolerance);
}

void lag_attempts_open(lag_attempts *attempts, size_t k, const lag_accuracy *accuracy)
{
    lag_lane_steps *step = &attempts->step;
    lag_lane_accuracy *own = &attempts->accuracy;
    const size_t size = attempts->at.size;
    const size_t lanes = attempts->at.lanes;
    step->open[k] = 1.0;
    step->steps[k] = step->rejected[k] = step->evaluations[k] = 0.0;
    own->group = accuracy->group;
    own->relative = accuracy->relative;
    lag_lane_put(lanes, k, size, accuracy->largest, own->largest);
    for (size_t i = 0; i < size; ++i) {
        own->floor[i * lanes + k] = lag_accuracy_floor(accuracy, i);
        own->most[i * lanes + k] = lag_accuracy_most(accuracy, i);
        own->least[i * lanes + k] = lag_accuracy_least(accuracy, i);
    }
}

size_t lag_attempts_close(lag_attempts *attempts, size_t k, lag_stepper *s, lag_accuracy *accuracy)
{
    lag_lane_steps *step = &attempts->step;
    lag_attempt *attempt = &s->attempt;
    const size_t size = attempts->at.size;
    const size_t lanes = attempts->at.lanes;
    const size_t steps = (size_t)step->steps[k];
    step->open[k] = step->accepted[k] = step->refused[k] = 0.0;
    s->counts.evaluations += (size_t)step->evaluations[k];
    if (steps > 0) {
        s->t = attempts->at.t[k];
        s->h = step->first[k];
        s->last.error = step->before[k];
        s->counts.steps += steps;
        s->counts.rejections += (size_t)step->rejected[k];
        lag_lane_get(lanes, k, size, attempts->x, s->x);
        lag_lane_get(lanes, k, size, attempts->at.slope, s->f);
        lag_lane_get(lanes, k, size, attempts->tolerance, s->tolerance);
        lag_lane_get(lanes, k, size, attempts->accuracy.largest, accuracy->largest);
        lag_attempt_begin(s, step->limit[k]);
    }
    attempt->next = step->next[k];
    attempt->h = attempts->at.h[k];
    attempt->t_new = step->t_new[k];
    attempt->dense = step->dense[k] != 0.0;
    attempt->evaluations += (LAG_DOP853_STAGES - 1) * ((size_t)step->rejections[k] - attempt->rejections);
    attempt->rejections = (size_t)step->rejections[k];
    return steps;
}

void lag_attempts_inside(const lag_attempts *attempts, size_t k, double t, double *x)
{
    const lag_attempt_arrays *at = &attempts->at;
    lag_dop853_inside(at->size, at->lanes, attempts->terms + k, at->x + k, (t - at->t[k]) / (attempts->found.t_new[k] - at->t[k]), x);
}

/* Of lane k to s: the new state and the slope there, and the terms of the dense output. */
static void leave(const lag_attempts *attempts, const lag_stepper *s, size_t k)
{
    const lag_attempt_arrays *at = &attempts->at;
    const size_t size = at->size;
    double *to = s->work;
    lag_lane_get(at->lanes, k, size, at->slope + LAG_DOP853_END * size * at->lanes, to + LAG_DOP853_END * size);
    to += (LAG_DOP853_SLOPES + 1) * size;
    lag_lane_get(at->lanes, k, size, at->x_new, to);
    if (s->attempt.dense) {
        lag_lane_get(at->lanes, k, LAG_DOP853_TERMS * size, attempts->terms, to + size);
    }
}

/* A lane that failed is left to an attempt alone. */
int lag_attempts_settle(lag_attempts *attempts, lag_stepper *s, size_t k)
{
    lag_attempt *attempt = &s->attempt;
    attempts->step.used[k] = 0.0;
    if (attempts->found.step_fault[k] != 0.0) {
        return 1;
    }
    attempt->made = attempt->bare = 1;
    attempt->error = attempts->found.error[k];
    attempt->urge = attempts->found.urge[k];
    attempt->evaluations += attempt->error > 1.0 ? LAG_DOP853_STAGES - 1 : LAG_DOP853_STAGES;
    attempt->dense = attempt->dense && attempts->found.fault[k] == 0.0;
    if (attempt->error <= 1.0) {
        leave(attempts, s, k);
    }
    return attempt->error <= 1.0 || attempt->h <= s->h_least || !lag_attempt_shorten(s);
}
