/* Locates the zero of a guard inside a piece of the last step. */
#include <math.h>
#include <string.h>

#include "lag/linalg/arena.h"
#include "lag/linalg/root.h"
#include "lag/run.h"
#include "lag/run/scan.h"

/* So often an interval is halved before nothing is left of it. */
enum { HALVES = 60 };
/* So often the time of a change is corrected where the state is moved onto the constraints, */
enum { CORRECTIONS = 6 };
/* along a secant over this part of the way from the beginning of the step. */
static const double SECANT = 1e-3;
/* At least this part of the other is no round-off. */
static const double ALIKE = 1e-6;
/* A value that is so many times as far from zero just before its root as on a straight line jumps there. */
static const double STEEP = 16.0;

lag_status lag_scan_detect(lag_run *run, double t)
{
    const lag_status status = lag_stepper_dense(&run->stepper, t, run->point);
    return status == LAG_OK ? lag_guards_detect(&run->guards, t, run->point) : status;
}

typedef struct change {
    lag_run *run;
    size_t which;
} change;

static double value_of(void *context, double t)
{
    const change *one = context;
    const lag_status status = lag_scan_detect(one->run, t);
    return status == LAG_OK || status == LAG_EVENT_PENDING ? one->run->guards.value[one->which] : (double)NAN;
}

/*
 * A root is reported from the side on which the value has changed; the rest of the way is nearly straight. At a jump of the
 * value, the time is some roundings behind the jump, so that the state, projected onto the constraints, is behind it, too.
 */
static double refine(change *one, double a, double fa, double b, double root, double tolerance)
{
    const double before = value_of(one, fmax(a, root - tolerance));
    const double value = value_of(one, root);
    const double better = root - value * (root - a) / (value - fa);
    const int is_steep = fabs(before) * (root - a) > STEEP * fabs(fa) * tolerance;
    const int jumps = fabs(value) > ALIKE * fabs(fa) || fabs(better - root) > tolerance || is_steep;
    return jumps ? fmin(b, root + LAG_SCAN_TOGETHER * tolerance) : better;
}

/*
 * Time at which number `which`, which has changed at b, does so. A value that is zero but for round-off at a, as after an
 * impact, tells nothing: the interval is halved until its ends have different signs and alike sizes.
 */
static double root_of(change *one, double a, double b, double tolerance)
{
    double fa = value_of(one, a);
    double fb = value_of(one, b);
    for (int k = 0; k < HALVES; ++k) {
        const double middle = a + 0.5 * (b - a);
        if (lag_root_sign(fa) != lag_root_sign(fb) && fabs(fa) >= ALIKE * fabs(fb)) {
            return refine(one, a, fa, b, lag_root(value_of, one, a, fa, b, fb, tolerance), tolerance);
        }
        if (!(middle > a && middle < b)) {
            break;
        }
        const double value = value_of(one, middle);
        if (one->run->guards.changed[one->which] != 0.0) {
            b = middle;
            fb = value;
        } else {
            a = middle;
            fa = value;
        }
    }
    return b;
}

double lag_scan_earliest(lag_run *run, double a, double b)
{
    const size_t count = lag_guards_count(&run->guards);
    const double tolerance = lag_scan_tolerance(run);
    double *root = run->guards.pieces.root;
    double first = b;
    run->guards.locating = 1;
    memcpy(root, run->guards.changed, count * sizeof(double));
    for (size_t i = 0; i < count; ++i) {
        change one = {run, i};
        const double last = fmin(b, first + LAG_SCAN_TOGETHER * tolerance);
        const int may_be = root[i] != 0.0;
        root[i] = (double)INFINITY;
        if (may_be) {
            (void)value_of(&one, last);
            if (run->guards.changed[i] != 0.0) {
                root[i] = root_of(&one, a, last, tolerance);
                first = fmin(first, root[i]);
            }
        }
    }
    run->guards.locating = 0;
    for (size_t i = 0; i < count; ++i) {
        run->guards.changed[i] = root[i] <= first + LAG_SCAN_TOGETHER * tolerance;
    }
    return first;
}

/* The same value with the state on the constraints, which is the state that the event will see. */
static double value_on_constraints(change *one, double t)
{
    lag_run *run = one->run;
    int moved = 0;
    lag_status status = lag_stepper_dense(&run->stepper, t, run->point);
    status = status == LAG_OK ? lag_projection_exact(&run->projection, t, run->point, &moved) : status;
    status = status == LAG_OK ? lag_guards_detect(&run->guards, t, run->point) : status;
    return status == LAG_OK || status == LAG_EVENT_PENDING ? run->guards.value[one->which] : (double)NAN;
}

/* The located value that constraints move away from its zero at t; the number of all where none is. */
static size_t find_moved(lag_run *run, const double *located, size_t count, double t)
{
    size_t which = count;
    int moved = 0;
    const lag_status status = lag_stepper_dense(&run->stepper, t, run->point);
    if (status != LAG_OK || lag_projection_exact(&run->projection, t, run->point, &moved) != LAG_OK || !moved) {
        return count;
    }
    for (size_t i = 0; i < count && which == count; ++i) {
        change one = {run, i};
        if (located[i] != 0.0) {
            const double off = fabs(value_of(&one, t));
            which = fabs(value_on_constraints(&one, t)) > 2.0 * off ? i : count;
        }
    }
    return which;
}

double lag_scan_on_constraints(lag_run *run, const double *located, double t)
{
    const lag_model *model = run->motion.model;
    const lag_stepper *s = &run->stepper;
    const size_t count = lag_guard_count(model);
    change one = {run, model->nc > 0 ? find_moved(run, located, count, t) : count};
    double before = t - SECANT * (t - s->t_before);
    if (one.which == count || !(before < t)) {
        return t;
    }
    double value_before = value_on_constraints(&one, before);
    double value = value_on_constraints(&one, t);
    for (int k = 0; k < CORRECTIONS; ++k) {
        const double next = fmin(t - value * (t - before) / (value - value_before), s->t);
        const double there = next > s->t_before && next != t ? value_on_constraints(&one, next) : (double)NAN;
        if (!(fabs(there) < fabs(value))) {
            break;
        }
        before = t;
        value_before = value;
        t = next;
        value = there;
    }
    return t;
}
