/* Events of a run: signs of indicators, their crossings located on the dense output, clocks, and what happens then. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "lag/linalg/root.h"
#include "lag/run.h"

/* So often an event may be its own cause, and so many events may follow each other while no time passes. */
enum { PASSES = 100, IDLE = 1000 };
static const double ULPS = 4.0;
/* Crossings so many tolerances behind the first are the same event. */
static const double TOGETHER = 8.0;

/* Values at a time within the last step, into run->value. */
static lag_status values_at(lag_run *run, double t)
{
    const lag_run_options *options = &run->options;
    const lag_status status = lag_run_inside(run, t, run->point);
    return status == LAG_OK ? options->indicate(options->context, run, t, run->point, run->value) : status;
}

lag_status lag_run_signs(lag_run *run)
{
    const lag_run_options *options = &run->options;
    if (options->indicators == 0) {
        return LAG_OK;
    }
    const lag_status status = options->indicate(options->context, run, run->stepper.t, run->stepper.x, run->value);
    for (size_t i = 0; i < options->indicators; ++i) {
        run->sign[i] = lag_root_sign(run->value[i]);
    }
    return status;
}

static int any_change(const lag_run *run)
{
    for (size_t i = 0; i < run->options.indicators; ++i) {
        if (lag_root_sign(run->value[i]) != (int)run->sign[i]) {
            return 1;
        }
    }
    return 0;
}

typedef struct indicator {
    lag_run *run;
    size_t which;
    lag_status status;
} indicator;

static double value_of(void *context, double t)
{
    indicator *one = context;
    if (one->status == LAG_OK) {
        one->status = values_at(one->run, t);
    }
    return one->run->value[one->which];
}

/* Between a and b, where values are `other` and run->value, at least one sign changes: the earliest time. */
static lag_status locate(lag_run *run, double a, double b, double tolerance, double *t)
{
    lag_status status = LAG_OK;
    *t = b;
    for (size_t i = 0; i < run->options.indicators && status == LAG_OK; ++i) {
        status = values_at(run, *t);
        const double at_end = run->value[i];
        if (status == LAG_OK && lag_root_sign(at_end) != (int)run->sign[i]) {
            indicator one = {run, i, LAG_OK};
            *t = lag_root(value_of, &one, a, run->other[i], *t, at_end, tolerance);
            status = one.status;
        }
    }
    return status;
}

/* Finds the signs that have changed at t or just behind it; moves *t there. */
static lag_status gather(lag_run *run, double b, double tolerance, double *t)
{
    const double behind = fmin(b, *t + TOGETHER * tolerance);
    lag_status status = values_at(run, behind);
    for (size_t i = 0; i < run->options.indicators; ++i) {
        const int sign = lag_root_sign(run->value[i]);
        run->crossed[i] = sign != (int)run->sign[i] ? sign : 0.0;
    }
    if (status == LAG_OK) {
        status = values_at(run, *t);
    }
    for (size_t i = 0; i < run->options.indicators; ++i) {
        const int sign = lag_root_sign(run->value[i]);
        if (run->crossed[i] != 0.0 && sign == (int)run->sign[i]) {
            *t = behind;
        }
    }
    return status;
}

lag_status lag_run_crossing(lag_run *run, double *t)
{
    lag_stepper *s = &run->stepper;
    const double h = s->t - s->t_before;
    const double given = run->options.time_tolerance;
    const double tolerance = fmax(given, ULPS * DBL_EPSILON * fmax(fabs(s->t), fabs(h)));
    double a = s->t_before;
    *t = (double)INFINITY;
    lag_status status = values_at(run, a);
    memcpy(run->other, run->value, run->options.indicators * sizeof(double));
    for (unsigned k = 1; k <= run->options.looks && status == LAG_OK; ++k) {
        const double b = k == run->options.looks ? s->t : s->t_before + h * (double)k / (double)run->options.looks;
        status = values_at(run, b);
        if (status == LAG_OK && any_change(run)) {
            status = locate(run, a, b, tolerance, t);
            return status == LAG_OK ? gather(run, b, tolerance, t) : status;
        }
        a = b;
        memcpy(run->other, run->value, run->options.indicators * sizeof(double));
    }
    return status;
}

double lag_run_instant(const lag_run *run)
{
    double first = lag_instants_next(&run->instants);
    for (size_t i = 0; i < run->options.clocks; ++i) {
        first = fmin(first, lag_clock_instant(&run->clock[i], run->clock[i].next));
    }
    return first;
}

/* Clocks that strike now go on to their next instant. */
static int strike(lag_run *run)
{
    int any = 0;
    for (size_t i = 0; i < run->options.clocks; ++i) {
        run->ticked[i] = lag_clock_instant(&run->clock[i], run->clock[i].next) == run->stepper.t;
        if (run->ticked[i] != 0.0) {
            ++run->clock[i].next;
            any = 1;
        }
    }
    return any;
}

/* Evaluates the signs again after a pass; crossings are the signs that the pass changed. */
static lag_status look_again(lag_run *run, int *any)
{
    const size_t count = run->options.indicators;
    *any = 0;
    memcpy(run->other, run->sign, count * sizeof(double));
    const lag_status status = lag_run_signs(run);
    for (size_t i = 0; i < count; ++i) {
        run->crossed[i] = run->sign[i] != run->other[i] ? run->sign[i] : 0.0;
        *any = *any || run->crossed[i] != 0.0;
    }
    return status;
}

/* Events between which time stands still. */
static int chatters(lag_run *run)
{
    const double passed = run->stepper.t - run->event_time;
    const double least = fmax(run->options.time_tolerance, ULPS * ULPS * DBL_EPSILON * fabs(run->stepper.t));
    run->idle = passed <= least ? run->idle + 1 : 0;
    run->event_time = run->stepper.t;
    return run->idle > IDLE;
}

lag_status lag_run_fire(lag_run *run, int crossing, int *happened)
{
    lag_stepper *s = &run->stepper;
    int any = strike(run) || crossing;
    int moved = 0;
    *happened = any;
    if (!any) {
        return LAG_OK;
    }
    for (size_t i = 0; i < run->options.indicators; ++i) {
        run->crossed[i] = crossing ? run->crossed[i] : 0.0;
        run->sign[i] = run->crossed[i] != 0.0 ? run->crossed[i] : run->sign[i];
    }
    ++run->events;
    if (chatters(run)) {
        return LAG_CHATTER;
    }
    for (unsigned pass = 0; any; ++pass) {
        const lag_event event = {s->t, run->crossed, run->ticked, pass};
        if (pass == PASSES) {
            return LAG_CHATTER;
        }
        lag_status status = run->options.event != NULL ? run->options.event(run->options.context, run, &event) : LAG_OK;
        if (status == LAG_OK) {
            status = lag_projection_apply(&run->projection, s->t, s->x, &moved);
        }
        if (status == LAG_OK) {
            status = look_again(run, &any);
        }
        if (status != LAG_OK) {
            return status;
        }
        for (size_t i = 0; i < run->options.clocks; ++i) {
            run->ticked[i] = 0.0;
        }
    }
    return LAG_OK;
}
