/* Kinks of forces, energies and rates along the motion, here called corners: steps end there, and begin anew behind them. */
#include <math.h>
#include <stdint.h>
#include <string.h>

#include "lag/linalg/arena.h"
#include "lag/linalg/vector.h"
#include "lag/run.h"
#include "lag/run/scan.h"

enum { SAMPLES = LAG_LAST_SAMPLE, TURNS = 8, PATTERNS = 3 };
/* Times that differ by so many times the tolerance of roots are one here; a moment is as long. */
static const double TOGETHER = 4.0 * 8.0;

/* So many of them behind a corner it has been passed. */
static const double BEHIND = 6.0, PASSED = 4.0;

/* True if steps of this run end at corners. */
static int is_careful(const lag_run *run)
{
    const lag_method *method = run->stepper.method;
    return run->motion.model->ncorner > 0 && method->error_order > 0 && method != &lag_collocation;
}

static double probe_step(const lag_run *run)
{
    return TOGETHER * lag_scan_tolerance(run);
}

/* Distances at x at time t. */
static lag_status evaluate_distances(lag_run *run, double t, const double *x, double *far)
{
    lag_motion *motion = &run->motion;
    double solved = 0.0;
    lag_status status = LAG_OK;
    if (run->guards.corners.solved) {
        status = lag_motion_solve(motion, t, x);
    } else {
        lag_motion_set_state(motion, t, x);
    }
    status = status == LAG_OK ? motion->model->corner(&motion->at, far, &solved) : status;
    if (status == LAG_OK && solved != 0.0 && !run->guards.corners.solved) {
        run->guards.corners.solved = 1;
        return evaluate_distances(run, t, x, far);
    }
    return status;
}

/* The state at part s of the last step by Hermite's cubic, into run->point. */
static void between(lag_run *run, double s)
{
    const lag_stepper *step = &run->stepper;
    const double h = step->t - step->t_before;
    const double r = 1.0 - s;
    for (size_t i = 0; i < step->ode->size; ++i) {
        const double slopes = s * r * h * (r * step->f_before[i] - s * step->f[i]);
        run->point[i] = r * r * (1.0 + 2.0 * s) * step->x_before[i] + s * s * (3.0 - 2.0 * s) * step->x[i] + slopes;
    }
}

/* Distances at the beginning of the last step and at four other places of it, into `seen`. */
static lag_status sample(lag_run *run)
{
    const lag_stepper *s = &run->stepper;
    lag_status status = LAG_OK;
    for (int k = 0; k <= SAMPLES && status == LAG_OK; ++k) {
        const double place = LAG_SAMPLE_PLACES[k];
        const int inside = k > 0 && k < SAMPLES;
        if (inside) {
            between(run, place);
        }
        const double *x = inside ? run->point : k == 0 ? s->x_before : s->x;
        status = evaluate_distances(run, s->t_before + place * (s->t - s->t_before), x, run->guards.corners.far);
        for (size_t i = 0; i < run->motion.model->ncorner; ++i) {
            lag_guards_seen(&run->guards, i)[k] = run->guards.corners.far[i];
        }
    }
    return status;
}

/* True if the samples tell the shapes of all distances: a motion that turns round and round between them has not been followed up to such long steps. */
static int are_known(lag_run *run)
{
    const double h = run->stepper.t - run->stepper.t_before;
    double doubt = 0.0;
    for (size_t i = 0; i < run->motion.model->ncorner; ++i) {
        doubt = fmax(doubt, lag_piece_doubt(lag_guards_seen(&run->guards, i)));
    }
    const int known = h <= run->guards.corners.reach && doubt <= LAG_KNOWN_PART;
    run->guards.corners.reach = lag_piece_length(h, doubt);
    return known;
}

/* The smallest and the largest distance of a corner in a step. */
typedef struct lag_extent {
    double least, most;
} lag_extent;

static lag_extent extent_of(const lag_run *run, size_t i)
{
    const double *values = lag_guards_seen(&run->guards, i);
    lag_extent seen = {values[0], values[0]};
    for (int k = 1; k <= SAMPLES; ++k) {
        seen.least = fmin(seen.least, values[k]);
        seen.most = fmax(seen.most, values[k]);
    }
    return seen;
}

/* True if the distance of corner i passes zero, or changes by more than it is. A value that is not a number may be a corner, too. */
static int is_near(const lag_run *run, size_t i)
{
    const lag_extent seen = extent_of(run, i);
    return !(fmax(seen.least, -seen.most) >= seen.most - seen.least);
}

/*
 * Leaves out corners that change in the step by no more than the tolerances of the state permit: a value at rest cannot be
 * distinguished from zero.
 */
static lag_status leave_out(lag_run *run)
{
    const lag_stepper *s = &run->stepper;
    lag_guards *guards = &run->guards;
    lag_status status = LAG_OK;
    for (unsigned pattern = 0; pattern < PATTERNS; ++pattern) {
        for (size_t i = 0; i < s->ode->size; ++i) {
            const double by = (i >> pattern & 1u) != 0 ? -s->tolerance[i] : s->tolerance[i];
            run->point[i] = s->x_before[i] + (pattern + 1 < PATTERNS ? by : s->tolerance[i]);
        }
        status = status == LAG_OK ? evaluate_distances(run, s->t_before, run->point, guards->corners.far) : status;
        for (size_t i = 0; i < run->motion.model->ncorner && status == LAG_OK; ++i) {
            const lag_extent seen = extent_of(run, i);
            const int is_at_rest = seen.most - seen.least <= fabs(guards->corners.far[i] - lag_guards_seen(guards, i)[0]);
            guards->corners.side[i] = is_at_rest ? 0.0 : guards->corners.side[i];
        }
    }
    return status;
}

lag_status lag_run_face_corners(lag_run *run)
{
    const size_t count = run->motion.model->ncorner;
    run->guards.corners.count = 0;
    if (!is_careful(run)) {
        return LAG_OK;
    }
    lag_status status = sample(run);
    const int known = status == LAG_OK && are_known(run);
    for (size_t i = 0; i < count && status == LAG_OK; ++i) {
        const int is_sought = !known || is_near(run, i);
        run->guards.corners.side[i] = !is_sought ? 0.0 : lag_guards_seen(&run->guards, i)[0] < 0.0 ? -1.0 : 1.0;
    }
    if (status == LAG_OK && lag_any(count, run->guards.corners.side)) {
        status = leave_out(run);
        run->guards.corners.count = status == LAG_OK && lag_any(count, run->guards.corners.side) ? count : 0;
    }
    return status;
}

/* 1: nothing but corners was found to change. */
static int only_corners(const lag_run *run)
{
    return !lag_any(lag_guard_count(run->motion.model), run->guards.changed);
}

/* LAG_EVENT_PENDING: relations or contacts have changed at t, within the last step. */
static lag_status detect_jumps(lag_run *run, double t)
{
    const lag_status status = lag_scan_detect(run, t);
    return status == LAG_EVENT_PENDING && only_corners(run) ? LAG_OK : status;
}

/*
 * A corner at *own: what else changes there by a jump is what happens, the corner only where there is nothing. A relation that has a corner
 * itself, as `abs(x - a) < b`, may have changed before that without a sample that shows it; one that jumps there may have changed back.
 */
static lag_status with_relations(lag_run *run, double *own, double *corner)
{
    const double at = *own;
    const double before = at - probe_step(run);
    const double behind = fmin(run->stepper.t, at + BEHIND * probe_step(run));
    double last = behind;
    lag_status status = detect_jumps(run, last);
    if (status == LAG_OK) {
        last = before;
        status = detect_jumps(run, last);
    }
    *own = *corner = (double)INFINITY;
    if (status == LAG_EVENT_PENDING) {
        *own = lag_scan_earliest(run, run->stepper.t_before, last);
        status = LAG_OK;
    } else if (status == LAG_OK) {
        *corner = at;
    }
    if (*own < (double)INFINITY && *own >= before) {
        *own = behind;
        status = lag_scan_detect(run, behind);
    }
    return status == LAG_EVENT_PENDING ? LAG_OK : status;
}

lag_status lag_run_next_corner(lag_run *run, double *own, double *corner)
{
    const lag_model *model = run->motion.model;
    lag_guards *guards = &run->guards;
    const double *changed = guards->changed + lag_guard_count(model);
    lag_status status = LAG_OK;
    *corner = (double)INFINITY;
    for (int k = 0; k <= TURNS; ++k) {
        *own = (double)INFINITY;
        guards->corners.count = k < TURNS ? guards->corners.count : 0;
        status = lag_run_happening(run, own);
        if (status != LAG_EVENT_PENDING || !only_corners(run)) {
            break;
        }
        if (*own - run->stepper.t_before > probe_step(run)) {
            return with_relations(run, own, corner);
        }
        for (size_t i = 0; i < guards->corners.count; ++i) { /* it has just been passed */
            guards->corners.side[i] = changed[i] != 0.0 ? -guards->corners.side[i] : guards->corners.side[i];
        }
    }
    return status == LAG_EVENT_PENDING ? LAG_OK : status;
}

/* Before it by the probe step of the step that ends there, so that the run passes it (lag_run_pass_corner). */
double lag_run_before_corner(const lag_run *run, double corner)
{
    return corner - TOGETHER * lag_scan_tolerance_at(corner, corner - run->stepper.t_before);
}

int lag_run_is_at_end(const lag_run *run, double corner)
{
    return corner >= run->stepper.t - 2.0 * probe_step(run);
}

/* The state on a straight line some roundings of time behind the last step, into run->point; its time. */
static double state_past_step(lag_run *run)
{
    const lag_stepper *s = &run->stepper;
    const double after = PASSED * probe_step(run);
    memcpy(run->point, s->x, s->ode->size * sizeof(double));
    lag_axpy(s->ode->size, after, s->f, run->point);
    return s->t + after;
}

int lag_run_meets_corner(lag_run *run)
{
    const lag_stepper *s = &run->stepper;
    const lag_guards *guards = &run->guards;
    int meets = 0;
    if (!is_careful(run)) {
        return 0;
    }
    lag_status status = evaluate_distances(run, s->t, s->x, guards->pieces.root);
    const double t = state_past_step(run);
    status = status == LAG_OK ? evaluate_distances(run, t, run->point, guards->corners.far) : status;
    for (size_t i = 0; i < run->motion.model->ncorner && status == LAG_OK; ++i) {
        meets = meets || (guards->corners.far[i] < 0.0) != (guards->pieces.root[i] < 0.0);
    }
    return meets;
}

void lag_run_pass_corner(lag_run *run, double limit)
{
    lag_stepper *s = &run->stepper;
    const double t = state_past_step(run);
    run->guards.corners.count = 0;
    if (!(t < limit)) {
        return;
    }
    if (lag_guards_count(&run->guards) > 0 && lag_guards_detect(&run->guards, t, run->point) != LAG_OK) {
        return; /* something happens on the way */
    }
    memcpy(s->x, run->point, s->ode->size * sizeof(double));
    s->t = t;
}
