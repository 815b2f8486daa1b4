/* Steps of a run: each is projected onto the constraints, ends at the first event in it, and keeps invariants and assertions. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "lag/linalg/arena.h"
#include "lag/linalg/order.h"
#include "lag/linalg/vector.h"
#include "lag/run.h"
#include "lag/run/scan.h"

/* Steps are at least so many units in the last place of time. */
static const double ULPS = 16.0;
/* A step from which the constraints are out of reach is tried again with this part of its length. */
static const double SHORTER = 0.25;
/* So often a step is cut where a corner is found in it. */
enum { MOST_CUTS = 10 };

static double least_length(const lag_run *run, double stop)
{
    return ULPS * DBL_EPSILON * fmax(fmax(fabs(run->stepper.t), fabs(stop)), DBL_MIN);
}

/* The method starts (again) at the present state; h is what the stepper proposes. */
static lag_status restart(lag_run *run, const lag_method *method, double span)
{
    lag_stepper *s = &run->stepper;
    if (method == &lag_collocation) {
        method = run->ranks.behind;
    }
    run->accuracy.relative = method->factor * run->options.tolerance;
    lag_accuracy_after(&run->accuracy, s->x, s->tolerance);
    return lag_stepper_begin(s, method, span);
}

/* Back onto the constraints after a step, exactly where they may hold a relation at its zero. LAG_PROJECTION_FAILED: it was too long. */
static lag_status project(lag_run *run)
{
    lag_stepper *s = &run->stepper;
    int moved = 0;
    const int holds = lag_any(run->motion.model->nindicator, run->guards.held);
    lag_status status = holds ? lag_projection_exact(&run->projection, s->t, s->x, &moved) : LAG_PROJECTION_FAILED;
    if (status != LAG_OK) { /* to round-off it may not be possible */
        status = lag_projection_apply(&run->projection, s->t, s->x, &moved);
    }
    if (status == LAG_OK && moved) {
        status = lag_stepper_correct(s);
    }
    return status == LAG_OK ? LAG_OK : LAG_PROJECTION_FAILED;
}

/* The present state is what the next one is compared with. */
static lag_status set_rank_estimate(lag_run *run)
{
    run->ranks.estimate.rank = 0;
    lag_motion_set_state(&run->motion, run->stepper.t, run->stepper.x);
    const lag_status status = lag_projection_evaluate(&run->projection, 1);
    return status == LAG_OK ? lag_rank_estimate_update(&run->ranks.estimate, run->projection.jacobian) : status;
}

/* Rank after a step that ended on the constraints. LAG_TOO_LONG: it is to be tried with the length *shorter. */
static lag_status check_rank(lag_run *run, double *shorter)
{
    lag_stepper *s = &run->stepper;
    lag_status status = lag_rank_estimate_update(&run->ranks.estimate, run->projection.jacobian);
    if (status != LAG_ATTENTION) {
        return status;
    }
    status = lag_singular_after(&run->ranks.singular, shorter);
    if (status == LAG_ATTENTION && *shorter > s->h_least) {
        lag_stepper_undo(s, *shorter);
        status = LAG_TOO_LONG;
    } else if (status == LAG_ATTENTION) {
        status = LAG_STEP_TOO_SMALL;
    }
    const lag_status seen = set_rank_estimate(run);
    return status == LAG_OK && seen != LAG_ATTENTION ? seen : status;
}

/* Handles a known singular position ahead before the step. */
static lag_status cross_singular(lag_run *run, double limit, int *done)
{
    lag_stepper *s = &run->stepper;
    lag_status status = s->method == &lag_collocation ? restart(run, run->ranks.behind, limit - s->t) : LAG_OK;
    if (status == LAG_OK) {
        status = lag_singular_ahead(&run->ranks.singular, limit, done);
    }
    if (status == LAG_OK && *done) {
        status = set_rank_estimate(run);
        status = status == LAG_ATTENTION ? LAG_OK : status;
    }
    return status;
}

/* One step that ends on the constraints; where that looks dangerous it is taken back. Across singular positions the motion is fitted. */
static lag_status step_once(lag_run *run, double limit)
{
    lag_stepper *s = &run->stepper;
    for (;;) {
        const int crosses = lag_run_crosses(run->motion.model, &run->options);
        double shorter = 0.0;
        int done = 0;
        lag_status status = crosses ? cross_singular(run, limit, &done) : LAG_OK;
        if (status == LAG_OK && done && lag_run_companion(run) != NULL) {
            return lag_run_companion(run)->step(run);
        }
        if (status != LAG_OK || done) {
            return status;
        }
        status = lag_stepper_step(s, limit);
        if (status != LAG_OK) {
            return status == LAG_STEP_TOO_SMALL && s->trouble.status != LAG_OK && s->trouble.time >= s->t ? s->trouble.status : status;
        }
        const double h = s->t - s->t_before;
        status = project(run);
        if (status == LAG_PROJECTION_FAILED && SHORTER * h > s->h_least) {
            lag_stepper_undo(s, SHORTER * h);
            continue;
        }
        if (status == LAG_PROJECTION_FAILED) {
            lag_run_lose(run, s->t, s->x);
        }
        if (status == LAG_OK && crosses) {
            status = check_rank(run, &shorter);
        }
        if (status == LAG_OK && lag_run_companion(run) != NULL) {
            status = lag_run_companion(run)->step(run);
        }
        if (status == LAG_TOO_LONG) {
            continue;
        }
        return status;
    }
}

/* The same; nothing is left of a step that failed. */
static lag_status advance(lag_run *run, double limit)
{
    lag_stepper *s = &run->stepper;
    const double t = s->t;
    const lag_status status = step_once(run, limit);
    if (status != LAG_OK && s->t > t) {
        lag_stepper_undo(s, s->t - s->t_before);
    }
    return status;
}

/* After a step without event: the tolerances follow the motion, the method may change. */
static lag_status follow(lag_run *run, double stop)
{
    lag_stepper *s = &run->stepper;
    if (s->method == &lag_collocation && s->t < stop) {
        return restart(run, run->ranks.behind, stop - s->t);
    }
    const lag_method *method = run->options.method == NULL && s->method != &lag_collocation ? lag_stiffness_method(&run->methods.stiffness, s, stop) : s->method;
    if (method == s->method || s->t >= stop) {
        lag_accuracy_after(&run->accuracy, s->x, s->tolerance);
        return LAG_OK;
    }
    if (run->methods.changes < LAG_CHANGES) {
        run->methods.change[run->methods.changes] = (lag_change){s->t, method->implicit};
    }
    ++run->methods.changes;
    return restart(run, method, stop - s->t);
}

/* A step from time t that cannot be made use of is taken back, if there was one. */
static lag_status undo_step(lag_run *run, double t, lag_status status)
{
    if (run->stepper.t > t) {
        lag_stepper_undo(&run->stepper, 0.5 * (run->stepper.t - t));
    }
    return status;
}

/* One step. Where a rate jumps by more than the tolerance in the shortest step, that step leads over the corner. */
static lag_status advance_over_corners(lag_run *run, double limit)
{
    lag_stepper *s = &run->stepper;
    const double t = s->t;
    lag_status status = advance(run, limit);
    if (status == LAG_STEP_TOO_SMALL && lag_run_meets_corner(run)) {
        lag_run_pass_corner(run, limit);
        s->h = 0.0; /* the length in front of the corner tells nothing */
        status = s->t > t ? restart(run, s->method, limit - s->t) : status;
        status = status == LAG_OK ? advance(run, limit) : status;
    }
    return status;
}

/*
 * A guard that was located at the end of a step that was done again up to there changes there, if it was clear of its border in the step and is not so
 * at the end, on the new polynomial; or if it lies clearly below where it began.
 */
static lag_status change_at_end(lag_run *run, const double *located, double *own)
{
    lag_guards *guards = &run->guards;
    const lag_model *model = run->motion.model;
    const lag_stepper *s = &run->stepper;
    lag_noise_find(guards->noise, s->t, s->x);
    const lag_status status = lag_guards_detect(guards, s->t, s->x);
    for (size_t i = 0; i < lag_guard_count(model) && (status == LAG_OK || status == LAG_EVENT_PENDING); ++i) {
        const double noise = lag_guards_noise(guards, i);
        const double value = guards->value[i];
        const int comes = guards->top[i] > noise && value <= noise;
        const int leaves = -value >= guards->depth[i] + 0.5 * noise;
        guards->changed[i] = located[i] != 0.0 && (comes || leaves);
        *own = guards->changed[i] != 0.0 ? s->t : *own;
    }
    return status == LAG_EVENT_PENDING ? LAG_OK : status;
}

/*
 * One step that ends at a corner, if there is one in it, and what happens then. Where corners are near and something else happens first, the step is
 * done again up to there: its polynomial may not be that of the equations, as it may have led across a corner behind what happens. So it is by
 * implicit methods: what is stiff is in its equilibrium at the ends of their steps, and would return to it behind the event.
 */
static lag_status advance_to_corner(lag_run *run, double limit, double *own)
{
    lag_stepper *s = &run->stepper;
    lag_half *half = &run->half;
    double corner = (double)INFINITY;
    double end = corner;
    int at_event = 0;
    *own = (double)INFINITY;
    lag_status status = advance_over_corners(run, limit);
    half->next = s->h;
    half->corner = 0;
    for (int k = 0; k < MOST_CUTS && status == LAG_OK; ++k) {
        status = lag_run_face_corners(run);
        run->guards.corners.count = k + 1 < MOST_CUTS ? run->guards.corners.count : 0;
        const int watched = run->guards.corners.count > 0 || s->method->implicit;
        status = status == LAG_OK ? lag_run_next_corner(run, own, &corner) : status;
        if (at_event && status == LAG_OK && !(fmin(*own, corner) < (double)INFINITY)) {
            status = change_at_end(run, run->half.pending, own);
        }
        const int found = corner < (double)INFINITY;
        const int inside = found && !lag_run_is_at_end(run, corner);
        const double event = *own;
        const int before = watched && !at_event && !lag_run_is_at_end(run, event) && lag_run_before_corner(run, event) > s->t_before;
        half->corner = found || (s->t == end && run->motion.model->ncorner > 0 && !(event < (double)INFINITY));
        if (status != LAG_OK || !(inside || before)) {
            return status;
        }
        half->corner = 0;
        at_event = !inside;
        memcpy(run->half.pending, run->guards.changed, lag_guard_count(run->motion.model) * sizeof(double));
        end = inside ? lag_run_before_corner(run, corner) : event;
        lag_stepper_undo(s, end - s->t_before);
        status = advance(run, end);
    }
    return status;
}

/* The time scale of what happens at the end of a step: one that was cut short does not tell it. */
static double scale_of(const lag_run *run, const lag_half *half)
{
    const double reach = run->guards.pieces.reach;
    return reach > 0.0 ? fmin(reach, fmax(half->length, half->next)) : half->length;
}

/* Relations that pass zero with a tick do so in the event of the tick, which at `stop` is left to the next call. */
static int left_to_ticks(const lag_run *run, double stop)
{
    const lag_model *model = run->motion.model;
    return run->stepper.t >= stop && lag_run_due(run, run->stepper.t) && !lag_any(model->ncontact, run->half.pending + model->nindicator);
}

/* Carries out the events at the end of a step, and clocks before `stop`. */
static lag_status carry_out(lag_run *run, double stop, const lag_half *half, int *happened)
{
    const double t = run->stepper.t;
    const double h = scale_of(run, half);
    const int due = t < stop && lag_run_due(run, t);
    const int left = half->own && left_to_ticks(run, stop);
    const int own = half->own && !left;
    if (left) {
        memcpy(run->half.waiting, run->half.pending, lag_guard_count(run->motion.model) * sizeof(double));
        run->half.left = h;
    }
    *happened = own || due;
    lag_instants_after(&run->instants, t, h);
    const lag_cause cause = {due ? LAG_CAUSE_TIME : LAG_CAUSE_GUARDS, h, own ? run->half.pending : NULL};
    const lag_status status = own || due ? lag_run_instant(run, &cause) : LAG_OK;
    return status == LAG_OK && *happened ? lag_run_watch(run, run->stepper.t, run->stepper.x, NULL) : status;
}

lag_status lag_run_step(lag_run *run, double stop)
{
    lag_stepper *s = &run->stepper;
    lag_half *half = &run->half;
    const double t = s->t;
    double own = (double)INFINITY;
    lag_status status = advance_to_corner(run, lag_run_limit(run, stop), &own);
    half->left = 0.0;
    lag_copy(lag_guard_count(run->motion.model), run->guards.changed, run->half.pending);
    half->length = s->t - t;
    half->t = lag_lower(own, s->t);
    if (status == LAG_OK) {
        status = lag_run_rows(run, half->t, 0);
    }
    if (status == LAG_OK && run->options.results != NULL) {
        status = lag_run_count_step(run);
        status = status == LAG_OK ? lag_results_step(run->options.results, run, half->t) : status;
    }
    if (status == LAG_OK && half->t == s->t) { /* what is behind an event does not come true */
        status = lag_run_watch(run, s->t, s->x, s->f);
    }
    if (status != LAG_OK) {
        return undo_step(run, t, status);
    }
    half->own = own < (double)INFINITY;
    half->open = 1;
    return LAG_OK;
}

lag_status lag_run_finish(lag_run *run, double stop)
{
    lag_stepper *s = &run->stepper;
    lag_half *half = &run->half;
    int happened = 0;
    if (!half->open) {
        return LAG_OK;
    }
    half->open = 0;
    lag_status status = lag_run_count_step(run);
    if (status == LAG_OK) {
        status = half->own ? lag_run_back(run, half->t) : lag_run_keep_past(run, half->t);
    }
    if (status != LAG_OK) {
        return undo_step(run, s->t_before, status);
    }
    status = carry_out(run, stop, half, &happened);
    if (status == LAG_OK && happened) {
        s->h = fmin(half->next, s->h_most);
        run->ranks.estimate.rank = 0;
        status = s->t < stop ? restart(run, s->method, stop - s->t) : LAG_OK;
    } else if (status == LAG_OK && half->corner) {
        status = lag_run_rows(run, s->t, 1);
        run->motion.delays.pieces.level = 0;
        lag_run_pass_corner(run, lag_run_limit(run, stop));
        s->h = fmin(fmax(s->h, half->next), s->h_most);
        status = status == LAG_OK && s->t < stop ? restart(run, s->method, stop - s->t) : status;
    } else if (status == LAG_OK) {
        status = follow(run, stop);
    }
    return status == LAG_OK ? lag_run_rows(run, s->t, 1) : status;
}

lag_status lag_run_restart(lag_run *run, double stop)
{
    lag_stepper *s = &run->stepper;
    run->motion.until = stop;
    s->h_least = least_length(run, stop);
    if (!(run->options.length > 0.0) && run->options.count < 2) {
        run->instants.contacts.length = fmax(run->instants.contacts.length, stop - run->counts.begun);
    }
    s->h_most = run->options.h_most > 0.0 ? run->options.h_most : (double)INFINITY;
    run->half.open = 0;
    run->instants.timed.length = run->instants.contacts.length;
    lag_status status = lag_run_ticks(run);
    if (status == LAG_OK && lag_instants_next(&run->instants) > s->t) {
        status = lag_timed_find_next(&run->instants.timed, s->t);
    }
    if (status == LAG_OK) {
        status = restart(run, s->method, stop - s->t);
    }
    if (status == LAG_OK && lag_run_crosses(run->motion.model, &run->options)) {
        status = set_rank_estimate(run);
        if (status == LAG_OK || status == LAG_ATTENTION) {
            lag_singular_begin(&run->ranks.singular, status == LAG_ATTENTION);
            status = LAG_OK;
        }
    }
    return status;
}

lag_status lag_run_to(lag_run *run, double stop, size_t most_steps)
{
    run->counts.steps = 0;
    if (!(stop > run->stepper.t)) {
        return LAG_OK;
    }
    lag_status status = lag_run_restart(run, stop);
    while (status == LAG_OK && run->stepper.t < stop) {
        if (most_steps > 0 && run->counts.steps >= most_steps) {
            return LAG_TOO_LONG;
        }
        ++run->counts.steps;
        status = lag_run_step(run, stop);
        if (status == LAG_OK) {
            status = lag_run_finish(run, stop);
        }
    }
    return status;
}
