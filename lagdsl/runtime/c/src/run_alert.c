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
            return lag_root(value_of, one, a, fa, b, fb, tolerance);
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
    double *root = run->alert.seen;
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

lag_status lag_run_happening(lag_run *run, double *t)
{
    const lag_stepper *s = &run->stepper;
    const lag_model *model = run->motion.model;
    const double h = s->t - s->t_before;
    const double tolerance = ULPS * DBL_EPSILON * fmax(fabs(s->t), h);
    double a = s->t_before;
    double b = a;
    lag_status status = LAG_OK;
    if (model->nindicator + model->ncontact == 0) {
        return LAG_OK;
    }
    for (unsigned k = 1; k <= run->options.looks && status == LAG_OK; ++k) {
        a = b;
        b = k == run->options.looks ? s->t : s->t_before + h * (double)k / (double)run->options.looks;
        status = look(run, b);
    }
    if (status != LAG_HAPPENS) {
        return status;
    }
    *t = earliest(run, a, b, tolerance);
    return LAG_HAPPENS;
}
