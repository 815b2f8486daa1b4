/* Where in the last step of a run something happens that the discretes do not know of. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "lag/root.h"
#include "lag/run.h"

enum { NUDGES = 60 };
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

/* The earliest zero of what had changed at b and not at a. */
static double earliest(lag_run *run, double a, double b, double tolerance)
{
    const size_t count = run->motion.model->nindicator + run->motion.model->ncontact;
    double first = b;
    memcpy(run->alert.seen, run->alert.changed, count * sizeof(double));
    for (size_t i = 0; i < count; ++i) {
        if (run->alert.seen[i] != 0.0) {
            change one = {run, i};
            const double fa = value_of(&one, a);
            const double fb = value_of(&one, first);
            if (lag_root_sign(fa) != lag_root_sign(fb)) {
                first = lag_root(value_of, &one, a, fa, first, fb, tolerance);
            } else if (!(fa >= 0.0)) {
                first = fabs(fa) <= fabs(fb) ? a : first;
            }
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
    if (run->options.places.truth == NULL || model->nindicator + model->ncontact == 0) {
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
