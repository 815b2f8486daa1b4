/* The past of what is delayed: after each step it is known up to the end of that step. */
#include <float.h>
#include <math.h>

#include "lag/run.h"

/* Pieces are at least so many units in the last place of time, and this part of a step: there may be a corner that nobody told. */
static const double ULPS = 64.0;
static const double LEAST = 1e-6;
/* A piece is looked at beside its nodes, here. */
static const double BESIDE = 0.55;

/* The expressions at time t in the last step, into `values` (ndelay). */
static lag_status sample(lag_run *run, double t, double *values)
{
    lag_stepper *s = &run->stepper;
    lag_delays *delays = &run->delays;
    lag_motion *motion = &run->motion;
    const lag_status status = lag_stepper_dense(s, fmin(fmax(t, s->t_before), s->t), run->point);
    if (status != LAG_OK) {
        return status;
    }
    lag_motion_set_state(motion, t, run->point);
    return motion->model->delayed(&motion->at, values, delays->time, &delays->direct);
}

/* The next piece, up to time b, tried: its largest error in parts of what is admitted. */
static lag_status try_piece(lag_run *run, double b, double *error)
{
    lag_delays *delays = &run->delays;
    const size_t n = run->motion.model->ndelay;
    const double a = delays->begin[delays->count];
    const double half = 0.5 * (b - a);
    lag_status status = LAG_OK;
    for (size_t j = 0; j < LAG_DELAY_TERMS && status == LAG_OK; ++j) {
        status = sample(run, j == 0 ? b : a + half * (1.0 + lag_delay_nodes[j]), delays->sample + j * n);
    }
    status = status == LAG_OK ? sample(run, a + half * (1.0 + BESIDE), delays->other) : status;
    lag_delays_try(delays, run->accuracy.relative, b);
    *error = 0.0;
    for (size_t i = 0; i < n; ++i) {
        *error = fmax(*error, lag_delays_misfit(delays, i, BESIDE, delays->other[i]));
    }
    return status;
}

lag_status lag_run_keep_past(lag_run *run, double t)
{
    lag_delays *delays = &run->delays;
    lag_status status = LAG_OK;
    if (delays->count == 0) {
        return LAG_OK;
    }
    lag_delays_cut(delays, run->stepper.t_before);
    double h = t - delays->begin[delays->count];
    const double least = fmax(LEAST * h, ULPS * DBL_EPSILON * fabs(t));
    while (status == LAG_OK && delays->begin[delays->count] < t) {
        const double a = delays->begin[delays->count];
        const double b = a + h * (1.0 + LEAST) < t ? a + h : t;
        double error = 0.0;
        status = try_piece(run, b, &error);
        if (status == LAG_OK && error > 1.0 && b - a > least) {
            h = 0.5 * (b - a);
        } else if (status == LAG_OK) {
            status = lag_delays_add(delays, b);
            h *= 2.0;
        }
    }
    return status;
}
