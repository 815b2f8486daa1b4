/* Locates the zero of a guard inside a piece of the last step. */
#include <math.h>
#include <string.h>

#include "lag/linalg/arena.h"
#include "lag/linalg/root.h"
#include "lag/run.h"
#include "lag/run/scan.h"

/* So often an interval is halved before nothing is left of it. */
enum { HALVES = 60 };
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

/* With the state on the constraints, which is the state that the event will see. */
static double value_of(void *context, double t)
{
    const change *one = context;
    lag_run *run = one->run;
    int moved = 0;
    lag_status status = lag_stepper_dense(&run->stepper, t, run->point);
    status = status == LAG_OK && run->motion.model->nc > 0 ? lag_projection_exact(&run->projection, t, run->point, &moved) : status;
    status = status == LAG_OK ? lag_guards_detect(&run->guards, t, run->point) : status;
    return status == LAG_OK || status == LAG_EVENT_PENDING ? run->guards.value[one->which] : (double)NAN;
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

/* A place at most the length of the interval before a where the value is positive, beside *fa, its value there; a where the step has none. */
static double before_zero(change *one, double a, double *fa, double b)
{
    const double earlier = fmax(one->run->stepper.t_before, a - (b - a));
    const double value = earlier < a ? value_of(one, earlier) : *fa;
    const int is_clear = value > fabs(*fa);
    *fa = is_clear ? value : *fa;
    return is_clear ? earlier : a;
}

/*
 * Time at which number `which`, which is fa at a and fb at b, where it has changed, does so. A value that is zero but for round-off at a tells nothing: the
 * interval begins earlier or, as after an impact, is halved until its ends have different signs and alike sizes.
 */
static double root_of(change *one, double a, double fa, double b, double fb, double tolerance)
{
    if (fabs(fa) < ALIKE * fabs(fb)) {
        a = before_zero(one, a, &fa, b);
    }
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

/*
 * Of the guards that are sought, relations, slips and corners in their order, as these may jump or turn back; then the contact that a straight line from
 * its value `before` leads to zero first. The number of all where none is.
 */
static size_t find_nearest(const lag_guards *guards, const double *before)
{
    const size_t count = lag_guards_count(guards);
    size_t which = count;
    double least = (double)INFINITY;
    for (size_t i = 0; i < count; ++i) {
        const int is_contact = i - guards->motion->model->nindicator < guards->motion->model->ncontact;
        const double part = is_contact ? before[i] / (before[i] - guards->value[i]) : 0.0;
        if (guards->sought[i] != 0.0 && (which == count || part < least)) {
            which = i;
            least = part;
        }
    }
    return which;
}

/* Roots are sought one after the other; what has not changed just behind the first so far changes later. */
double lag_scan_earliest(lag_run *run, double a, double b)
{
    lag_guards *guards = &run->guards;
    const size_t count = lag_guards_count(guards);
    const double together = LAG_SCAN_TOGETHER * lag_scan_tolerance(run);
    double *root = guards->pieces.root;
    double *before = guards->pieces.found;
    double *sought = guards->pieces.sought;
    double first = b;
    lag_fill(count, (double)INFINITY, root);
    memcpy(sought, guards->changed, count * sizeof(double));
    guards->sought = sought;
    (void)lag_scan_detect(run, a);
    memcpy(before, guards->value, count * sizeof(double));
    while (lag_any(count, sought)) {
        const double last = fmin(b, first + together);
        (void)lag_scan_detect(run, last);
        for (size_t i = 0; i < count; ++i) {
            sought[i] = sought[i] != 0.0 && guards->changed[i] != 0.0;
        }
        const size_t which = find_nearest(guards, before);
        if (which < count) {
            change one = {run, which};
            root[which] = root_of(&one, a, before[which], last, guards->value[which], lag_scan_tolerance(run));
            first = fmin(first, root[which]);
            sought[which] = 0.0;
        }
    }
    guards->sought = NULL;
    for (size_t i = 0; i < count; ++i) {
        guards->changed[i] = root[i] <= first + together;
    }
    return first;
}
