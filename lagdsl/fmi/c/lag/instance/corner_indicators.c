/*
 * Corners of the equations as event indicators. No discrete changes there and no state jumps, but a step of an importer that leads across a
 * corner is as inexact as it is long, and what is flat before it acts does not show in an error estimate at all.
 */
#include "lag/instance/instance_internal.h"

#include <float.h>
#include <math.h>

/*
 * The margin: so many times the round-off. An importer may pass in one step what lies behind a corner; it searches the margin on a path that
 * knows nothing of that, and what acts behind the corner is late by the margin.
 */
static const double ROUNDINGS = 4.0;
/* This part of what the tolerance lets the numbers do that enter is an error of the importer. */
static const double PART = 0.1;
/* Round-off as lag/events/noise.h finds it is so many units in the last place of these numbers. */
static const double UNITS = 16.0;
/* A corner that is so much of its margin behind zero has been passed. */
static const double CLEARLY = 0.6;
/* One that was never so many errors away from zero was passed by them: the next time the margin is so many errors. */
static const double NEAR = 16.0;
static const double FARTHER = 4.0;

static double round_off(const lag_instance *instance, size_t corner)
{
    return instance->run->instants.noise.sigma[instance->fmu->model->nindicator + corner];
}

/* The room of a corner that has just come to it. */
static double margin_of(const lag_instance *instance, size_t corner)
{
    return fmax(instance->latched[lag_instance_first_corner(instance) + corner], ROUNDINGS * round_off(instance, corner));
}

static double error_of_importer(const lag_instance *instance, size_t corner)
{
    return PART * instance->held.tolerance / (UNITS * DBL_EPSILON) * round_off(instance, corner);
}

/* Distances at x at time t, into `far`. */
static lag_status look(lag_instance *instance, double t, const double *x)
{
    lag_motion *motion = &instance->run->motion;
    const lag_model *model = motion->model;
    double solved = 0.0;
    lag_motion_look(motion, t, x);
    lag_status status = model->corner(&motion->at, instance->far, &solved);
    if (status == LAG_OK && solved != 0.0) {
        status = lag_motion_solve(motion, t, x);
        status = status == LAG_OK ? model->corner(&motion->at, instance->far, &solved) : status;
    }
    return status;
}

lag_status lag_instance_look_at_corners(lag_instance *instance, double t, const double *x, double *room)
{
    const size_t count = instance->fmu->model->ncorner;
    const lag_status status = count > 0 ? look(instance, t, x) : LAG_OK;
    for (size_t i = 0; i < count && status == LAG_OK; ++i) {
        room[lag_instance_first_corner(instance) + i] = (instance->side[i] < 0.0 ? -1.0 : 1.0) * instance->far[i] + margin_of(instance, i);
    }
    return status;
}

lag_status lag_instance_face_corners(lag_instance *instance, double t, const double *x)
{
    const size_t count = instance->fmu->model->ncorner;
    const lag_status status = count > 0 ? look(instance, t, x) : LAG_OK;
    double *largest = instance->largest;
    double *latched = instance->latched + lag_instance_first_corner(instance);
    for (size_t i = 0; i < count && status == LAG_OK; ++i) {
        const double behind = -instance->side[i] * instance->far[i];
        const double margin = margin_of(instance, i);
        largest[i] = fmax(largest[i], fabs(instance->far[i]));
        if (instance->side[i] == 0.0) {
            instance->side[i] = instance->far[i] < 0.0 ? -1.0 : 1.0;
        } else if (behind > CLEARLY * margin) {
            const double error = fmax(margin, error_of_importer(instance, i));
            latched[i] = largest[i] <= NEAR * error ? FARTHER * error : 0.0;
            largest[i] = 0.0;
            instance->side[i] = -instance->side[i];
        }
    }
    return status;
}

void lag_instance_pass_corners(lag_instance *instance)
{
    const size_t count = instance->fmu->model->ncorner;
    double *largest = instance->largest;
    for (size_t i = 0; i < count; ++i) {
        largest[i] = fmax(largest[i], fabs(instance->far[i]));
    }
}
