/* The search of a step for what changes in it: by polynomials through looks, at minima, corners and jumps. */
#include "lag/instance/path_search.h"

#include <math.h>
#include <string.h>

#include "lag/linalg/root.h"

enum { AGAIN = 8 };
/* The shortest piece, as a part of the step. */
static const double SHORTEST = 0x1p-8;
/* A jump is located to this part of the step. */
static const double LOCATED = 0x1p-44;
/* Values below so many times their round-off have no shape. */
static const double SHAPELESS = 1e3;

static size_t count_of(const lag_path_step *in)
{
    return lag_instance_watched(in->instance->fmu);
}

/* Hermite's cubic of a number at part s of a step of length h. */
static double cubic(double s, double h, double x, double f, double x_after, double f_after)
{
    const double r = 1.0 - s;
    return r * r * (1.0 + 2.0 * s) * x + s * s * (3.0 - 2.0 * s) * x_after + s * r * h * (r * f - s * f_after);
}

void lag_path_set_inputs(const lag_path_step *in, double s, double h)
{
    const lag_instance *instance = in->instance;
    const size_t nu = instance->fmu->model->nu;
    const size_t *rates = instance->fmu->input_rates;
    double *u = instance->run->motion.u;
    for (size_t i = 0; i < nu; ++i) {
        const size_t k = rates != NULL ? rates[i] : nu;
        u[i] = k < nu ? cubic(s, h, in->base.u[i], in->base.u[k], in->tip.u[i], in->tip.u[k]) : (1.0 - s) * in->base.u[i] + s * in->tip.u[i];
    }
}

static double time_at(const lag_path_step *in, double s)
{
    return *in->base.t + s * (*in->tip.t - *in->base.t);
}

/* Room at part s of the step, into `room`; *passed: 1 if something has changed there. */
static lag_status look(const lag_path_step *in, double s, double *room, int *passed)
{
    lag_instance *instance = in->instance;
    const double h = *in->tip.t - *in->base.t;
    for (size_t i = 0; i < lag_instance_order(instance); ++i) {
        instance->point[i] = cubic(s, h, in->base.x[i], in->base.f[i], in->tip.x[i], in->tip.f[i]);
    }
    lag_path_set_inputs(in, s, h);
    const lag_status status = lag_instance_look(instance, time_at(in, s), instance->point, room);
    for (size_t i = 0; i < count_of(in) && status == LAG_OK; ++i) {
        const int changes = room[i] < 0.0 && in->base.passed[i] == 0.0;
        in->tip.passed[i] = changes ? 1.0 : in->tip.passed[i];
        *passed = *passed || changes;
    }
    return status;
}

/* Room of number i at the looks of a piece; the largest magnitude of it. */
static double values_of(const lag_path_step *in, size_t i, double *values)
{
    double most = 0.0;
    for (int k = 0; k < LAG_LOOKS; ++k) {
        values[k] = in->seen[k][i];
        most = fmax(most, fabs(values[k]));
    }
    return most;
}

/* Error of the polynomials of number i in the piece as a part of its values. */
static double doubt_of(const lag_path_step *in, size_t i)
{
    double values[LAG_LOOKS];
    double parabola = 0.0;
    const double most = values_of(in, i, values);
    const double error = lag_look_error(values, &parabola);
    const int shape = in->base.passed[i] == 0.0 && most > SHAPELESS * lag_instance_round_off(in->instance, i);
    return shape ? error / most : 0.0;
}

static double largest_doubt(const lag_path_step *in)
{
    double doubt = 0.0;
    for (size_t i = 0; i < count_of(in); ++i) {
        doubt = fmax(doubt, doubt_of(in, i));
    }
    return doubt;
}

/* The first of the two looks between which number i changes most. */
static int place_of_jump(const lag_path_step *in, size_t i)
{
    double most = 0.0;
    int place = 0;
    for (int k = 1; k < LAG_LOOKS; ++k) {
        const double change = fabs(in->seen[k][i] - in->seen[k - 1][i]);
        place = change > most ? k - 1 : place;
        most = fmax(most, change);
    }
    return place;
}

/* Looks at both sides of a jump of number i in the piece of length w behind a, as near as the time can be told. */
static lag_status look_at_jump(const lag_path_step *in, size_t i, double a, double w, int *passed)
{
    const int place = place_of_jump(in, i);
    double low = a + w * LAG_LOOK_PLACES[place];
    double high = a + w * LAG_LOOK_PLACES[place + 1];
    double before = in->seen[place][i];
    double after = in->seen[place + 1][i];
    lag_status status = LAG_OK;
    while (high - low > LOCATED && status == LAG_OK && !*passed) {
        const double middle = low + (high - low) / 2.0;
        status = look(in, middle, in->instance->room, passed);
        const double value = in->instance->room[i];
        if (fabs(after - value) > fabs(value - before)) {
            low = middle;
            before = value;
        } else {
            high = middle;
            after = value;
        }
    }
    return status;
}

/* Numbers whose shape the looks at the shortest piece do not show may jump. */
static lag_status look_at_jumps(const lag_path_step *in, double a, double w, int *passed)
{
    lag_status status = LAG_OK;
    for (size_t i = 0; i < count_of(in) && status == LAG_OK && !*passed; ++i) {
        status = doubt_of(in, i) > LAG_KNOWN_PART ? look_at_jump(in, i, a, w, passed) : LAG_OK;
    }
    return status;
}

/* True if number i is a relation that may have changed at the last look: only its margin keeps it from that. */
static int is_within_margin(const lag_path_step *in, size_t i)
{
    const lag_instance *instance = in->instance;
    const int has_margin = i < instance->fmu->model->nindicator && !lag_instance_changes_at_zero(instance, i);
    return has_margin && instance->room[i] < 2.0 * lag_instance_round_off(instance, i);
}

/* Looks for a minimum of number i below zero between looks k - 2 and k of the piece of length w behind a. */
static lag_status look_at_minimum(const lag_path_step *in, size_t i, int k, double a, double w, int *passed)
{
    lag_triple at;
    double values[LAG_LOOKS];
    double error = 0.0;
    double u = 0.0;
    double height = 0.0;
    lag_status status = LAG_OK;
    const int just = k == 2 && a == 0.0 && *in->base.t == in->instance->held.latched_at;
    (void)values_of(in, i, values);
    (void)lag_look_error(values, &error);
    for (int j = 0; j < 3; ++j) {
        lag_triple_put(&at, j, LAG_LOOK_PLACES[k - 2 + j], values[k - 2 + j]);
    }
    for (int again = 0; again < AGAIN && status == LAG_OK && !*passed && lag_minimum_of(&at, error, just, &u, &height); ++again) {
        status = look(in, a + u * w, in->instance->room, passed);
        if (status == LAG_OK && !*passed && is_within_margin(in, i)) {
            lag_noise_reduce(&in->instance->run->instants.noise, time_at(in, a + u * w), in->instance->point, i);
            status = look(in, a + u * w, in->instance->room, passed);
        }
        const double value = in->instance->room[i];
        error = fmax(fabs(value - height), LAG_CLEARER * error);
        lag_minimum_narrow(&at, u, value);
    }
    return status;
}

static lag_status look_at_minima(const lag_path_step *in, double a, double w, int *passed)
{
    lag_status status = LAG_OK;
    for (int k = 2; k < LAG_LOOKS; ++k) {
        for (size_t i = 0; i < count_of(in) && status == LAG_OK && !*passed; ++i) {
            status = in->base.passed[i] == 0.0 ? look_at_minimum(in, i, k, a, w, passed) : LAG_OK;
        }
    }
    return status;
}

/* A corner that the step comes to. */
typedef struct approach {
    const lag_path_step *in;
    size_t which;
    double margin;
    lag_status status;
    int passed;
} approach;

/* Distance of the corner at part s of the step; where something has changed, the search ends. */
static double distance_at(void *context, double s)
{
    approach *to = context;
    if (to->status == LAG_OK && !to->passed) {
        to->status = look(to->in, s, to->in->instance->room, &to->passed);
    }
    return to->in->instance->room[to->which] - to->margin;
}

/* Looks where the piece of length w behind a comes to corner number i: a relation may be true just there. */
static lag_status look_at_corner(const lag_path_step *in, size_t i, double a, double w, int *passed)
{
    const size_t which = lag_instance_first_corner(in->instance) + i;
    approach to = {in, which, lag_instance_corner_margin(in->instance, i), LAG_OK, 0};
    for (int k = 1; k < LAG_LOOKS && in->base.passed[which] == 0.0 && to.status == LAG_OK && !to.passed; ++k) {
        const double before = in->seen[k - 1][which] - to.margin;
        const double after = in->seen[k][which] - to.margin;
        if (before > 0.0 && after < 0.0) {
            (void)lag_root(distance_at, &to, a + w * LAG_LOOK_PLACES[k - 1], before, a + w * LAG_LOOK_PLACES[k], after, LOCATED);
        }
    }
    *passed = to.passed;
    return to.status;
}

static lag_status look_at_corners(const lag_path_step *in, double a, double w, int *passed)
{
    lag_status status = LAG_OK;
    for (size_t i = 0; i < in->instance->fmu->model->ncorner && status == LAG_OK && !*passed; ++i) {
        status = look_at_corner(in, i, a, w, passed);
    }
    return status;
}

/* Looks along the step, up to the first change. Pieces are as long as they were in the step before, so that fast ones are not skipped. */
lag_status lag_path_search(const lag_path_step *in)
{
    const double h = *in->tip.t - *in->base.t;
    double *reach = &in->instance->held.reach;
    double a = 0.0;
    int passed = 0;
    lag_status status = lag_instance_look(in->instance, *in->base.t, in->base.x, in->seen[0]);
    for (size_t i = 0; i < count_of(in); ++i) {
        in->base.passed[i] = in->base.passed[i] == 0.0 && in->seen[0][i] < 0.0 ? -1.0 : in->base.passed[i];
    }
    *reach = *reach > 0.0 ? *reach : h;
    while (a < 1.0 && status == LAG_OK && !passed) {
        const double w = fmin(fmax(SHORTEST, *reach / h), 1.0 - a);
        for (int k = 1; k < LAG_LOOKS && status == LAG_OK && !passed; ++k) {
            status = look(in, a + w * LAG_LOOK_PLACES[k], in->seen[k], &passed);
        }
        const double doubt = status == LAG_OK && !passed ? largest_doubt(in) : 0.0;
        if (doubt > LAG_KNOWN_PART && w > SHORTEST) {
            *reach = lag_look_length(w, doubt) * h;
            continue;
        }
        status = status == LAG_OK && !passed ? look_at_minima(in, a, w, &passed) : status;
        status = status == LAG_OK && !passed ? look_at_corners(in, a, w, &passed) : status;
        status = status == LAG_OK && !passed && doubt > LAG_KNOWN_PART ? look_at_jumps(in, a, w, &passed) : status;
        const double next = lag_look_length(w, doubt) * h;
        *reach = passed ? *reach : in->searched ? fmin(*reach, next) : next;
        a += w;
        memcpy(in->seen[0], in->seen[LAG_LAST_LOOK], count_of(in) * sizeof(double));
    }
    return status;
}

