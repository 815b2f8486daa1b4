/* Where in the last step of a run something happens that the discretes do not know of. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "lag/root.h"
#include "lag/run.h"

enum { NUDGES = 60, HALVES = 60 };
static const double ULPS = 4.0;

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
 * Number `which` has changed at *b: a time *a before it at which it has not and its value has the other sign, *b as near to that. What
 * begins at a zero, as a contact that has just struck, has no such sign at the beginning.
 */
static int bracket(change *one, double tolerance, double *a, double *fa, double *b, double *fb)
{
    for (int k = 0; k < HALVES && *b - *a > tolerance; ++k) {
        if (lag_root_sign(*fa) != lag_root_sign(*fb)) {
            return 1;
        }
        const double middle = *a + 0.5 * (*b - *a);
        const double value = value_of(one, middle);
        if (one->run->alert.changed[one->which] != 0.0) {
            *b = middle;
            *fb = value;
        } else {
            *a = middle;
            *fa = value;
        }
    }
    return lag_root_sign(*fa) != lag_root_sign(*fb);
}

/* The earliest zero of what had changed at b and not at a. */
static double earliest(lag_run *run, double a, double b, double tolerance)
{
    const size_t count = run->motion.model->nindicator + run->motion.model->ncontact;
    double first = b;
    memcpy(run->alert.seen, run->alert.changed, count * sizeof(double));
    for (size_t i = 0; i < count; ++i) {
        if (run->alert.seen[i] != 0.0) {
            change one = {run, i};
            double left = a;
            double right = first;
            double fa = value_of(&one, a);
            double fb = value_of(&one, first);
            if (run->alert.changed[i] == 0.0) {
                continue;
            }
            const int found = bracket(&one, tolerance, &left, &fa, &right, &fb);
            first = found ? lag_root(value_of, &one, left, fa, right, fb, tolerance) : right;
        }
    }
    return first;
}

lag_status lag_run_happening(lag_run *run, double *t)
{
    const lag_stepper *s = &run->stepper;
    const lag_model *model = run->motion.model;
    const double h = s->t - s->t_before;
    double tolerance = ULPS * DBL_EPSILON * fmax(fabs(s->t), h);
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
    status = look(run, *t);
    for (int k = 0; k < NUDGES && status == LAG_OK && *t < b; ++k) {
        *t = fmin(b, *t + tolerance);
        tolerance *= 2.0;
        status = look(run, *t);
    }
    return status;
}
