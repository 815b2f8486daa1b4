/* Where in the last step of a run something happens that the discretes do not know of. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "lag/root.h"
#include "lag/run.h"

/* So often an interval is halved before nothing is left of it. */
enum { HALVES = 60 };
static const double ULPS = 4.0;
/* At least this part of the other is no round-off. */
static const double ALIKE = 1e-6;
/*
 * What comes and goes between looks shows as a parabola whose vertex is this much nearer to zero than what was seen. So near to the
 * beginning of the step, as a part of it, there are no vertices: there it is what has just happened.
 */
static const double NEARER = 0.3;
static const double BEGINNING = 0.01;
/* Roots that differ by so many tolerances are one. */
static const double TOGETHER = 8.0;

static lag_status look(lag_run *run, double t)
{
    const lag_status status = lag_stepper_dense(&run->stepper, t, run->point);
    return status == LAG_OK ? lag_alert_look(&run->alert, t, run->point) : status;
}

typedef struct change {
    lag_run *run;
    size_t which;
} change;

static double value_of(void *context, double t)
{
    const change *one = context;
    const lag_status status = look(one->run, t);
    return status == LAG_OK || status == LAG_HAPPENS ? lag_alert_value(&one->run->alert, one->which) : (double)NAN;
}

/*
 * A root is told from the side on which things have changed; what is left of the way there is as good as straight. Where the value jumps
 * the time is some roundings behind the jump, so that the state, moved onto the constraints, is behind it, too.
 */
static double refine(change *one, double a, double fa, double b, double root, double tolerance)
{
    const double value = value_of(one, root);
    const double better = root - value * (root - a) / (value - fa);
    if (fabs(value) > ALIKE * fabs(fa)) {
        return fmin(b, root + TOGETHER * tolerance);
    }
    return fabs(better - root) <= tolerance ? better : root;
}

/*
 * Where number `which`, which has changed at b, does so. A value that is zero but for round-off at a, as after an impact, tells nothing:
 * the interval is halved until its ends have different signs and alike sizes.
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
        if (one->run->alert.changed[one->which] != 0.0) {
            b = middle;
            fb = value;
        } else {
            a = middle;
            fa = value;
        }
    }
    return b;
}

/* The first root of what has changed at b, and not at a; with it changes what does so at the same time but for round-off. */
static double earliest(lag_run *run, double a, double b, double tolerance)
{
    const size_t count = run->motion.model->nindicator + run->motion.model->ncontact;
    double *root = run->alert.root;
    double first = b;
    memcpy(root, run->alert.changed, count * sizeof(double));
    for (size_t i = 0; i < count; ++i) {
        change one = {run, i};
        const double last = fmin(b, first + TOGETHER * tolerance);
        const int may_be = root[i] != 0.0;
        root[i] = (double)INFINITY;
        if (may_be) {
            (void)value_of(&one, last);
            if (run->alert.changed[i] != 0.0) {
                root[i] = root_of(&one, a, last, tolerance);
                first = fmin(first, root[i]);
            }
        }
    }
    for (size_t i = 0; i < count; ++i) {
        run->alert.changed[i] = root[i] <= first + TOGETHER * tolerance;
    }
    return first;
}

/* ---- looks ---- */

static void remember(lag_run *run, size_t which)
{
    const size_t count = run->motion.model->nindicator + run->motion.model->ncontact;
    for (size_t i = 0; i < count; ++i) {
        run->alert.seen[which][i] = lag_alert_value(&run->alert, i);
    }
}

static void move_on(lag_run *run)
{
    double *first = run->alert.seen[0];
    run->alert.seen[0] = run->alert.seen[1];
    run->alert.seen[1] = run->alert.seen[2];
    run->alert.seen[2] = first;
}

/* The vertex of a parabola through a, b, c at -1, 0, 1; 1: it is nearer to zero than what was seen, or beyond. */
static int vertex_of(double a, double b, double c, double *part)
{
    *part = 0.5 * (a - c) / (a - 2.0 * b + c);
    const double height = b - 0.25 * (a - c) * *part;
    const double least = fmin(fabs(a), fmin(fabs(b), fabs(c)));
    const int alike = a * b > 0.0 && b * c > 0.0;
    return alike && fabs(*part) < 1.0 && (fabs(height) < NEARER * least || height * b < 0.0);
}

/* Something that comes and goes between looks h apart, the last of them at t: where it is there. */
static lag_status find_vertex(lag_run *run, double t, double h, double first, double *there)
{
    const lag_model *model = run->motion.model;
    lag_status status = LAG_OK;
    *there = (double)INFINITY;
    for (size_t i = 0; i < model->nindicator + model->ncontact && (status == LAG_OK || status == LAG_HAPPENS); ++i) {
        double *const *seen = run->alert.seen;
        double part = 0.0;
        if (vertex_of(seen[0][i], seen[1][i], seen[2][i], &part)) {
            const double time = t - h + part * h;
            status = time > first && time < t ? look(run, time) : LAG_OK;
            if (status == LAG_HAPPENS && run->alert.changed[i] != 0.0) {
                *there = time;
                return status;
            }
        }
    }
    return status == LAG_HAPPENS ? LAG_OK : status;
}

/* A part of the last step in which something is looked for at `looks` places, equidistant from its beginning on. */
typedef struct interval {
    double first, last;
    unsigned looks; /* beside that at the beginning; the last may be the end */
} interval;

static double place_of(const lag_run *run, const interval *in, unsigned k)
{
    return k == run->options.looks ? in->last : in->first + (in->last - in->first) * (double)k / (double)run->options.looks;
}

/* Look number k; LAG_HAPPENS: something has changed at *b, and not yet at *a. */
static lag_status next_look(lag_run *run, const interval *in, unsigned k, double *a, double *b)
{
    const double part = (in->last - in->first) / (double)run->options.looks;
    const double time = place_of(run, in, k);
    double vertex = (double)INFINITY;
    const lag_status now = look(run, time);
    if (now != LAG_OK && now != LAG_HAPPENS) {
        return now;
    }
    remember(run, k < 2 ? k : 2);
    const double first = in->first + BEGINNING * (in->last - in->first);
    const lag_status before = k < 2 ? LAG_OK : find_vertex(run, time, part, first, &vertex);
    if (before != LAG_OK) {
        *a = vertex <= time - part ? time - 2.0 * part : time - part;
        *b = vertex;
        return before;
    }
    if (k >= 2) {
        move_on(run);
    }
    *a = time - part;
    *b = time;
    return now == LAG_HAPPENS && k > 0 ? look(run, time) : LAG_OK;
}

/* LAG_HAPPENS: the first change that shows at one of the places, or between them, is at *t. */
static lag_status scan(lag_run *run, const interval *in, double *t)
{
    const lag_stepper *s = &run->stepper;
    const double tolerance = ULPS * DBL_EPSILON * fmax(fabs(s->t), s->t - s->t_before);
    double a = in->first;
    double b = a;
    lag_status status = LAG_OK;
    for (unsigned k = 0; k <= in->looks && status == LAG_OK; ++k) {
        status = next_look(run, in, k, &a, &b);
    }
    if (status == LAG_HAPPENS) {
        *t = earliest(run, a, b, tolerance);
    }
    return status;
}

lag_status lag_run_happening(lag_run *run, double *t)
{
    const lag_stepper *s = &run->stepper;
    const lag_model *model = run->motion.model;
    const size_t count = model->nindicator + model->ncontact;
    interval in = {s->t_before, s->t, run->options.looks};
    int any = 0;
    if (count == 0) {
        return LAG_OK;
    }
    lag_status status = lag_stepper_dense(&run->stepper, in.first, run->point);
    if (status == LAG_OK) {
        status = lag_alert_begin(&run->alert, in.first, run->point);
    }
    if (status == LAG_OK) {
        status = scan(run, &in, t);
    }
    while (status == LAG_HAPPENS) {
        any = 1;
        memcpy(run->alert.found, run->alert.changed, count * sizeof(double));
        if (!(*t - in.first > BEGINNING * (s->t - in.first))) {
            break;
        }
        in.last = *t; /* what changed before that, and changed back at the place */
        in.looks = run->options.looks - 1;
        status = scan(run, &in, t);
    }
    if (any && (status == LAG_OK || status == LAG_HAPPENS)) {
        memcpy(run->alert.changed, run->alert.found, count * sizeof(double));
        return LAG_HAPPENS;
    }
    return status;
}
