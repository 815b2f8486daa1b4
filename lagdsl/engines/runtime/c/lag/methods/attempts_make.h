/*
 * lag_attempts_make() for one width of registers: of files that are compiled for processors with these. LAG_ATTEMPT_WIDTH is the number of
 * doubles in one.
 */
#ifndef LAG_ATTEMPTS_MAKE_H
#define LAG_ATTEMPTS_MAKE_H

#include <string.h>

#include "lag/linalg/arena.h"
#include "lag/methods/attempts.h"
#include "lag/methods/step_control.h"

#if LAG_ATTEMPTS_WIDE
void lag_attempts_make_wide(lag_attempts *groups, size_t count);
void lag_attempts_make_widest(lag_attempts *groups, size_t count);
#endif

static int rates_of_stage(void *context, size_t i, const double *t, const double *x, double *xd)
{
    lag_attempts *attempts = context;
    (void)i;
    attempts->rates(attempts->context, t, x, xd, attempts->found.fault);
    return 1;
}

/* Lanes in which a slope from `first` to before `end` is no number fail. */
LAG_ATTEMPT_INLINED void check_slopes(const lag_attempt_arrays *at, size_t first, size_t end, double *fault)
{
    const size_t count = at->size * at->lanes;
    lag_attempt_check((end - first) * count, at->lanes, at->slope + first * count, fault);
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

/* Lengths of what follows the attempts, as who is alone finds them (lag_attempt_shorten()): nothing waits for them yet. */
LAG_ATTEMPT_INLINED void plan(lag_attempts *attempts)
{
    const lag_lane_steps *step = &attempts->step;
    const lag_wide none = {0.0};
    for (size_t k = 0; k < attempts->at.lanes; k += LAG_WIDTH) {
        const lag_wide h = lag_wide_at(attempts->at.h + k);
        const lag_wide error = lag_wide_at(attempts->found.error + k);
        const lag_wide proposed = lag_wide_lower(lag_wide_at(step->next + k), lag_wide_at(step->h_most + k));
        const lag_wide part = lag_wide_higher(none + LAG_DOP853_SHRINK, lag_wide_part(error));
        lag_wide_to(attempts->found.behind + k, lag_wide_next(h, proposed, error, lag_wide_at(step->before + k), lag_wide_at(step->rejections + k)));
        lag_wide_to(attempts->found.again + k, lag_wide_higher(h * part, lag_wide_at(step->h_least + k)));
    }
}

/* Errors of the attempts; with those that are accepted the rates at their ends, and what else is found there. */
LAG_ATTEMPT_INLINED void judge(lag_attempts *attempts)
{
    const lag_attempt_arrays *at = &attempts->at;
    const lag_lane_steps *step = &attempts->step;
    const size_t count = at->size * at->lanes;
    const lag_wide none = {0.0};
    double found[LAG_ATTEMPT_LANES];
    double accepted = 0.0;
    double dense = 0.0;
    lag_combine(count, &lag_dop853_stages[LAG_DOP853_END], at->h, at->slope, at->x, at->x_new);
    check_slopes(at, 1, LAG_DOP853_STAGES, attempts->found.fault);
    lag_attempt_errors(at, attempts->found.error);
    plan(attempts);
    for (size_t k = 0; k < at->lanes; k += LAG_WIDTH) {
        const lag_wide_truth can = (lag_wide_at(step->used + k) != none) & (lag_wide_at(attempts->found.error + k) <= none + 1.0);
        lag_wide_to(attempts->found.t_new + k, lag_wide_chosen(can, lag_wide_at(step->t_new + k), lag_wide_at(at->t + k)));
        lag_wide_to(found + k, lag_wide_chosen(can, none + 1.0, none));
    }
    for (size_t k = 0; k < at->lanes; ++k) {
        accepted += found[k];
        dense += found[k] * step->dense[k];
    }
    attempts->dense = dense > 0.0;
    if (accepted > 0.0) {
        (void)rates_of_stage(attempts, LAG_DOP853_END, attempts->found.t_new, at->x_new, at->slope + LAG_DOP853_END * count);
        check_slopes(at, LAG_DOP853_END, LAG_DOP853_END + 1, attempts->found.fault);
        lag_attempt_urges(at, attempts->found.urge);
    }
    if (accepted > 0.0 && attempts->ends != NULL) {
        attempts->ends(attempts->context, attempts->found.t_new, at->x_new, attempts->found.broken);
    }
    memcpy(attempts->found.step_fault, attempts->found.fault, sizeof attempts->found.fault);
}

/* Open lanes whose attempts are steps with which nothing else happens, and those that go on with a shorter one. */
LAG_ATTEMPT_INLINED void decide(lag_attempts *attempts)
{
    lag_lane_steps *step = &attempts->step;
    const lag_wide none = {0.0};
    const lag_wide one = none + 1.0;
    for (size_t k = 0; k < attempts->at.lanes; k += LAG_WIDTH) {
        const lag_wide error = lag_wide_at(attempts->found.error + k);
        const lag_wide t_new = lag_wide_at(step->t_new + k);
        const lag_wide row = lag_wide_at(step->row + k);
        const lag_wide fault = lag_wide_at(attempts->found.fault + k) + 0.0 * error; /* infinite errors, too */
        const lag_wide open = lag_wide_at(step->open + k) * lag_wide_at(step->used + k);
        const lag_wide_truth goes_on = (open != none) & (fault == none);
        const lag_wide_truth is_inside = (t_new < lag_wide_at(step->limit + k)) & (t_new != row) & (lag_wide_at(step->left + k) > one);
        const lag_wide_truth is_calm = (lag_wide_at(attempts->found.urge + k) <= lag_wide_at(step->border + k)) & (lag_wide_at(attempts->found.broken + k) == none);
        const lag_wide_truth longer = lag_wide_at(attempts->at.h + k) > lag_wide_at(step->h_least + k);
        lag_wide_to(step->accepted + k, lag_wide_chosen(goes_on & is_inside & is_calm & (error <= one), one, none));
        lag_wide_to(step->refused + k, lag_wide_chosen(goes_on & longer & (error > one), one, none));
    }
}

/* The number in these lanes becomes another one. */
LAG_ATTEMPT_INLINED void put_chosen(lag_wide_truth truth, lag_wide value, double *x)
{
    lag_wide_to(x, lag_wide_chosen(truth, value, lag_wide_at(x)));
}

/* The tolerances follow the states of these lanes: lag_accuracy_after(). */
LAG_ATTEMPT_INLINED void follow(lag_attempts *attempts, size_t k, lag_wide_truth accepted)
{
    const lag_lane_accuracy *own = &attempts->accuracy;
    const size_t lanes = attempts->at.lanes;
    for (size_t i = 0; i < attempts->at.size; ++i) {
        double *largest = own->largest + lag_index(own->group[i]) * lanes + k;
        put_chosen(accepted, lag_wide_higher(lag_wide_at(largest), lag_wide_size(lag_wide_at(attempts->x + i * lanes + k))), largest);
    }
    for (size_t i = 0; i < attempts->at.size; ++i) {
        const size_t place = i * lanes + k;
        const lag_wide largest = lag_wide_at(own->largest + lag_index(own->group[i]) * lanes + k);
        const lag_wide tolerance = LAG_ACCURACY_TOLERANCE(lag_wide_lower, lag_wide_higher, own->relative, largest, lag_wide_at(own->floor + place),
            lag_wide_at(own->most + place), lag_wide_at(own->least + place), lag_wide_size(lag_wide_at(attempts->x + place)));
        put_chosen(accepted, tolerance, attempts->tolerance + place);
    }
}

/* The attempts of these lanes become their steps. */
LAG_ATTEMPT_INLINED void accept(lag_attempts *attempts, size_t k, lag_wide_truth accepted)
{
    const lag_attempt_arrays *at = &attempts->at;
    const size_t count = at->size * at->lanes;
    for (size_t i = 0; i < at->size; ++i) {
        const size_t place = i * at->lanes + k;
        put_chosen(accepted, lag_wide_at(at->x_new + place), attempts->x + place);
        put_chosen(accepted, lag_wide_at(at->slope + LAG_DOP853_END * count + place), at->slope + place);
    }
    follow(attempts, k, accepted);
}

/* The next attempts in lanes that go on, as who is alone begins them (lag_attempt_begin()). */
LAG_ATTEMPT_INLINED void go_on(lag_attempts *attempts, size_t k)
{
    lag_lane_steps *step = &attempts->step;
    lag_attempt_arrays *at = &attempts->at;
    const lag_wide none = {0.0};
    const lag_wide_truth accepted = lag_wide_at(step->accepted + k) != none;
    const lag_wide_truth refused = lag_wide_at(step->refused + k) != none;
    const lag_wide error = lag_wide_at(attempts->found.error + k);
    const lag_wide rejections = lag_wide_at(step->rejections + k);
    const lag_wide most = lag_wide_at(step->h_most + k);
    const lag_wide limit = lag_wide_at(step->limit + k);
    const lag_wide next = lag_wide_chosen(accepted, lag_wide_at(attempts->found.behind + k), lag_wide_at(attempts->found.again + k));
    const lag_wide t = lag_wide_chosen(accepted, lag_wide_at(step->t_new + k), lag_wide_at(at->t + k));
    const lag_wide length = lag_wide_length(lag_wide_lower(next, most), limit - t);
    const lag_wide t_new = lag_wide_end(t, length, limit);
    put_chosen(accepted, next, step->first + k);
    put_chosen(accepted, lag_wide_before(error), step->before + k);
    put_chosen(accepted, lag_wide_at(step->left + k) - 1.0, step->left + k);
    put_chosen(accepted, lag_wide_at(step->steps + k) + 1.0, step->steps + k);
    put_chosen(accepted, lag_wide_at(step->rejected + k) + rejections, step->rejected + k);
    put_chosen(accepted, lag_wide_at(step->evaluations + k) + (LAG_DOP853_STAGES + (LAG_DOP853_STAGES - 1.0) * rejections), step->evaluations + k);
    put_chosen(refused | accepted, lag_wide_chosen(accepted, none, rejections + 1.0), step->rejections + k);
    put_chosen(refused | accepted, next, step->next + k);
    put_chosen(refused | accepted, t, at->t + k);
    put_chosen(refused | accepted, length, at->h + k);
    put_chosen(refused | accepted, t_new, step->t_new + k);
    put_chosen(refused | accepted, lag_wide_chosen(lag_wide_at(step->row + k) < t_new, none + 1.0, none), step->dense + k);
    accept(attempts, k, accepted);
}

/* Lanes go on, and look forward to their next attempts. */
LAG_ATTEMPT_INLINED void prepare(lag_attempts *attempts)
{
    lag_lane_steps *step = &attempts->step;
    lag_attempt_arrays *at = &attempts->at;
    double used = 0.0;
    double moved = 0.0;
    memset(attempts->found.fault, 0, sizeof attempts->found.fault);
    memset(attempts->found.broken, 0, sizeof attempts->found.broken);
    for (size_t k = 0; k < at->lanes; ++k) {
        used += step->used[k];
        moved += step->accepted[k] + step->refused[k];
    }
    attempts->used = used > 0.0;
    attempts->dense = 0;
    for (size_t k = 0; k < at->lanes && moved > 0.0; k += LAG_WIDTH) {
        go_on(attempts, k);
    }
    for (size_t k = at->lanes; k < LAG_ATTEMPT_LANES; ++k) {
        at->h[k] = at->h[k & (at->lanes - 1)];
    }
}

/* The arrays of the further stages; the last stage of the step stays. */
LAG_ATTEMPT_INLINED void go_further(lag_attempts *attempts)
{
    lag_attempt_arrays *at = &attempts->further;
    *at = attempts->at;
    at->stage = attempts->inside;
    for (size_t i = 0; i < LAG_ATTEMPT_LANES; ++i) {
        const size_t k = i & (at->lanes - 1);
        at->h[i] = attempts->found.t_new[k] - at->t[k]; /* as who comes afterwards sees it, rounded */
    }
}

LAG_ATTEMPT_INLINED void lag_attempts_make_inlined(lag_attempts *groups, size_t count)
{
    for (size_t g = 0; g < count; ++g) {
        prepare(groups + g);
    }
    make_stages(groups, count, 1, LAG_DOP853_STAGES);
    for (size_t g = 0; g < count; ++g) {
        if (groups[g].used) {
            judge(groups + g);
            go_further(groups + g);
        }
    }
    make_stages(groups, count, LAG_DOP853_END + 1, LAG_DOP853_SLOPES);
    for (size_t g = 0; g < count; ++g) {
        if (groups[g].dense) {
            check_slopes(&groups[g].further, LAG_DOP853_END + 1, LAG_DOP853_SLOPES, groups[g].found.fault);
            lag_attempt_dense(&groups[g].further, groups[g].terms);
        }
        if (groups[g].used) {
            decide(groups + g);
        }
    }
}

#endif
