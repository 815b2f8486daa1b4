/*
 * lag_attempts_make() for one width of registers: of files that are compiled for processors with these. LAG_ATTEMPT_WIDTH is the number of
 * doubles in one.
 */
#ifndef LAG_ATTEMPTS_MAKE_H
#define LAG_ATTEMPTS_MAKE_H

#include <string.h>

#include "lag/methods/attempts.h"

#if LAG_ATTEMPTS_WIDE
void lag_attempts_make_wide(lag_attempts *groups, size_t count, lag_stepper *const *s);
void lag_attempts_make_widest(lag_attempts *groups, size_t count, lag_stepper *const *s);
#endif

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

/* Stages from `first` to before `end` of all groups that have them: while rates of one group wait for each other, those of the next begin. */
LAG_ATTEMPT_INLINED void make_stages(lag_attempts *groups, size_t count, size_t first, size_t end)
{
    for (size_t i = first; i < end; ++i) {
        for (size_t g = 0; g < count; ++g) {
            lag_attempts *own = groups + g;
            if (first < LAG_DOP853_END ? own->used : own->dense) {
                (void)lag_attempt_stage(first < LAG_DOP853_END ? &own->at : &own->further, i, rates_of_stage, own);
            }
        }
    }
}

/* Errors of the attempts; with those that are accepted the rates at their ends, and what else is found there. */
LAG_ATTEMPT_INLINED void judge(lag_attempts *attempts, lag_stepper *const *s)
{
    const lag_attempt_arrays *at = &attempts->at;
    const size_t count = at->size * at->lanes;
    int accepted = 0;
    lag_combine(count, &lag_dop853_stages[LAG_DOP853_END], at->h, at->slope, at->x, at->x_new);
    look(at, 1, LAG_DOP853_STAGES, attempts->fault);
    lag_attempt_errors(at, attempts->error);
    for (size_t k = 0; k < at->lanes; ++k) {
        const int can = s[k] != NULL && attempts->error[k] <= 1.0;
        attempts->t_new[k] = can ? s[k]->attempt.t_new : at->t[k];
        accepted = accepted || can;
        attempts->dense = attempts->dense || (can && s[k]->attempt.dense);
    }
    if (accepted) {
        (void)rates_of_stage(attempts, LAG_DOP853_END, attempts->t_new, at->x_new, at->slope + LAG_DOP853_END * count);
        look(at, LAG_DOP853_END, LAG_DOP853_END + 1, attempts->fault);
        lag_attempt_urges(at, attempts->urge);
    }
    if (accepted && attempts->ends != NULL) {
        attempts->ends(attempts->context, attempts->t_new, at->x_new);
    }
    memcpy(attempts->step_fault, attempts->fault, sizeof attempts->fault);
}

/* The arrays of the further stages; the last stage of the step stays. */
LAG_ATTEMPT_INLINED void go_further(lag_attempts *attempts)
{
    lag_attempt_arrays *at = &attempts->further;
    *at = attempts->at;
    at->stage = attempts->inside;
    for (size_t i = 0; i < LAG_ATTEMPT_LANES; ++i) {
        const size_t k = i & (at->lanes - 1);
        at->h[i] = attempts->t_new[k] - at->t[k]; /* as who comes afterwards sees it, rounded */
    }
}

LAG_ATTEMPT_INLINED void lag_attempts_make_inlined(lag_attempts *groups, size_t count, lag_stepper *const *s)
{
    const size_t lanes = groups->at.lanes;
    for (size_t g = 0; g < count; ++g) {
        memset(groups[g].fault, 0, sizeof groups[g].fault);
        groups[g].used = groups[g].dense = 0;
        for (size_t k = 0; k < lanes; ++k) {
            groups[g].used = groups[g].used || s[g * lanes + k] != NULL;
        }
    }
    make_stages(groups, count, 1, LAG_DOP853_STAGES);
    for (size_t g = 0; g < count; ++g) {
        if (groups[g].used) {
            judge(groups + g, s + g * lanes);
            go_further(groups + g);
        }
    }
    make_stages(groups, count, LAG_DOP853_END + 1, LAG_DOP853_SLOPES);
    for (size_t g = 0; g < count; ++g) {
        if (groups[g].dense) {
            look(&groups[g].further, LAG_DOP853_END + 1, LAG_DOP853_SLOPES, groups[g].fault);
            lag_attempt_dense(&groups[g].further, groups[g].terms);
        }
    }
}

#endif
