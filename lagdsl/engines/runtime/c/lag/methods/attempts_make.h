/*
 * lag_attempts_make() for one width of registers: of files that are compiled for processors with these. LAG_ATTEMPT_WIDTH is the number of
 * doubles in one.
 */
#ifndef LAG_ATTEMPTS_MAKE_H
#define LAG_ATTEMPTS_MAKE_H

#include <string.h>

#include "lag/methods/attempts.h"

/* 1: there are files for other widths than that of the library. */
#if defined(__x86_64__) && defined(__GNUC__) && defined(__STDC_HOSTED__) && __STDC_HOSTED__
#define LAG_ATTEMPTS_WIDE 1
void lag_attempts_make_wide(lag_attempts *attempts, lag_stepper *const *s);
void lag_attempts_make_widest(lag_attempts *attempts, lag_stepper *const *s);
#else
#define LAG_ATTEMPTS_WIDE 0
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

LAG_ATTEMPT_INLINED void lag_attempts_make_inlined(lag_attempts *attempts, lag_stepper *const *s)
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

#endif
