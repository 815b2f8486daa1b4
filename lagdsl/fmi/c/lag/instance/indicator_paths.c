/*
 * Changes that are undone within one step of an importer. An importer compares the signs of indicators at the ends of its steps. So the
 * instance remembers the last two states at which it was asked, looks along Hermite's cubic between them, and an indicator that passes zero
 * there keeps the sign behind zero until event mode: the importer searches the step for the first change, as for any other. Between a
 * state before that change and one behind it the cubic is as exact as the search is narrow. A change that only the cubic shows
 * disappears there; the importer then finds an event without effect at the end of its step. Errors of an importer bend the cubic of its first steps
 * behind such an event, too: bounces that are lower than its errors would cause events without end.
 */
#include "lag/instance/instance_internal.h"

#include <math.h>
#include <string.h>

#include "lag/linalg/minimum.h"

enum { AGAIN = 8 };
/* The shortest piece, as a part of the step. */
static const double SHORTEST = 0x1p-8;
/* Values below so many times their round-off have no shape. */
static const double SHAPELESS = 1e3;
/* Steps that are shorter than this part of the experiment show by themselves: bounces within them are rest. */
static const double SHORT = 1e-6;
/*
 * Behind a change of a contact that was shown and was none, the path is not looked along for so many times the step that has shown it. A relation
 * that was shown may still lie within its round-off at the event, and change behind it.
 */
static const double LONGER = 4.0;

typedef struct node {
    double *t, *x, *f, *u, *passed; /* (1) (size) (size) (nu) (watched) 1: this one has changed on the way here; -1: it shows so */
} node;

/* The step that ends at the present state. */
typedef struct step {
    lag_instance *instance;
    node base, tip;
    double *seen[LAG_LOOKS]; /* (watched) room, at the looks of a piece */
    int searched;            /* the importer asks again before a change that was shown: pieces become no longer, and none is too short */
} step;

size_t lag_instance_node(const lag_fmu *fmu)
{
    return 1 + 2 * lag_motion_size(fmu->model) + fmu->model->nu + lag_instance_watched(fmu);
}

size_t lag_instance_path_looks(const lag_fmu *fmu)
{
    return LAG_LOOKS * lag_instance_watched(fmu);
}

static size_t count_of(const step *in)
{
    return lag_instance_watched(in->instance->fmu);
}

static node node_at(const lag_instance *instance, double *memory)
{
    const size_t size = lag_instance_order(instance);
    const size_t nu = instance->fmu->model->nu;
    return (node){memory, memory + 1, memory + 1 + size, memory + 1 + 2 * size, memory + 1 + 2 * size + nu};
}

/* Hermite's cubic of a number at part s of a step of length h. */
static double cubic(double s, double h, double x, double f, double x_after, double f_after)
{
    const double r = 1.0 - s;
    return r * r * (1.0 + 2.0 * s) * x + s * s * (3.0 - 2.0 * s) * x_after + s * r * h * (r * f - s * f_after);
}

/* Inputs at part s: by their rates where these are inputs, too, else in a straight line. */
static void set_inputs(const step *in, double s, double h)
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

/* Room at part s of the step, into `room`; *passed: 1 if something has changed there. */
static lag_status look(const step *in, double s, double *room, int *passed)
{
    lag_instance *instance = in->instance;
    const double h = *in->tip.t - *in->base.t;
    for (size_t i = 0; i < lag_instance_order(instance); ++i) {
        instance->point[i] = cubic(s, h, in->base.x[i], in->base.f[i], in->tip.x[i], in->tip.f[i]);
    }
    set_inputs(in, s, h);
    const lag_status status = lag_instance_look(instance, *in->base.t + s * h, instance->point, room);
    for (size_t i = 0; i < count_of(in) && status == LAG_OK; ++i) {
        const int changes = room[i] < 0.0 && in->base.passed[i] == 0.0;
        in->tip.passed[i] = changes ? 1.0 : in->tip.passed[i];
        *passed = *passed || changes;
    }
    return status;
}

/* Room of number i at the looks of a piece; the largest magnitude of it. */
static double values_of(const step *in, size_t i, double *values)
{
    double most = 0.0;
    for (int k = 0; k < LAG_LOOKS; ++k) {
        values[k] = in->seen[k][i];
        most = fmax(most, fabs(values[k]));
    }
    return most;
}

/* Error of the polynomials in the piece as a part of the values, that of the worst. */
static double largest_doubt(const step *in)
{
    double doubt = 0.0;
    for (size_t i = 0; i < count_of(in); ++i) {
        double values[LAG_LOOKS];
        double parabola = 0.0;
        const double most = values_of(in, i, values);
        const double error = lag_look_error(values, &parabola);
        const int shape = in->base.passed[i] == 0.0 && most > SHAPELESS * lag_instance_round_off(in->instance, i);
        doubt = shape ? fmax(doubt, error / most) : doubt;
    }
    return doubt;
}

/* Looks for a minimum of number i below zero between looks k - 2 and k of the piece of length w behind a. */
static lag_status look_at_minimum(const step *in, size_t i, int k, double a, double w, int *passed)
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
        const double value = in->instance->room[i];
        error = fmax(fabs(value - height), LAG_CLEARER * error);
        lag_minimum_narrow(&at, u, value);
    }
    return status;
}

static lag_status look_at_minima(const step *in, double a, double w, int *passed)
{
    lag_status status = LAG_OK;
    for (int k = 2; k < LAG_LOOKS; ++k) {
        for (size_t i = 0; i < count_of(in) && status == LAG_OK && !*passed; ++i) {
            status = in->base.passed[i] == 0.0 ? look_at_minimum(in, i, k, a, w, passed) : LAG_OK;
        }
    }
    return status;
}

/* Looks along the step, up to the first change. Pieces are as long as they were in the step before, so that fast ones are not skipped. */
static lag_status search(const step *in)
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
        const double next = lag_look_length(w, doubt) * h;
        *reach = passed ? *reach : in->searched ? fmin(*reach, next) : next;
        a += w;
        memcpy(in->seen[0], in->seen[LAG_LAST_LOOK], count_of(in) * sizeof(double));
    }
    return status;
}

/* The nodes that the present state leaves, in which it is the last one. */
static void advance(step *in)
{
    lag_held *held = &in->instance->held;
    const size_t bytes = lag_instance_node(in->instance->fmu) * sizeof(double);
    if (held->nodes > 0 && held->t > *in->tip.t) {
        memcpy(in->base.t, in->tip.t, bytes);
        held->nodes = 2;
    } else if (held->nodes < 2 || !(held->t > *in->base.t)) {
        held->nodes = 1;
    }
    *in->tip.t = held->t;
    memcpy(in->tip.x, in->instance->x, lag_instance_order(in->instance) * sizeof(double));
    memcpy(in->tip.f, in->instance->xd, lag_instance_order(in->instance) * sizeof(double));
    if (in->instance->fmu->model->nu > 0) {
        lag_instance_inputs_at(in->instance, held->t, in->tip.u);
    }
    for (size_t i = 0; i < count_of(in); ++i) {
        in->tip.passed[i] = held->nodes == 2 ? fmax(in->base.passed[i], 0.0) : 0.0;
    }
}

/* 1: an indicator shows a change by itself. */
static int shows(const step *in)
{
    int any = 0;
    for (size_t i = 0; i < count_of(in); ++i) {
        any = any || (in->instance->room[i] < 0.0 && in->tip.passed[i] == 0.0);
    }
    return any;
}

/* The importer asks again before a change that was shown. */
static int was_shown_behind(const lag_instance *instance)
{
    int any = 0;
    for (size_t i = 0; i < lag_instance_watched(instance->fmu); ++i) {
        any = any || instance->held.t < instance->shown[i];
    }
    return any;
}

static lag_status look_along(lag_instance *instance)
{
    lag_motion *motion = &instance->run->motion;
    step in = {instance, node_at(instance, instance->base), node_at(instance, instance->tip), {NULL}, 0};
    for (int k = 0; k < LAG_LOOKS; ++k) {
        in.seen[k] = instance->looks + (size_t)k * count_of(&in);
    }
    in.searched = instance->held.nodes > 0 && was_shown_behind(instance);
    advance(&in);
    const double length = *in.tip.t - *in.base.t;
    const int is_short = !(length > SHORT * instance->run->options.length) && !in.searched;
    const int is_blind = *in.tip.t < instance->held.latched_at + instance->held.blind;
    if (instance->held.nodes < 2 || is_short || is_blind || shows(&in)) {
        return LAG_OK;
    }
    motion->inputs = NULL;
    set_inputs(&in, 0.0, *in.tip.t - *in.base.t);
    const lag_status status = search(&in);
    lag_instance_tell_inputs(instance);
    instance->known &= ~(unsigned)(LAG_KNOWN_DERIVATIVES | LAG_KNOWN_PULLED);
    return status == LAG_OK ? lag_instance_look(instance, instance->held.t, instance->x, instance->room) : status;
}

lag_status lag_instance_follow_path(lag_instance *instance)
{
    const lag_held *held = &instance->held;
    const size_t count = lag_instance_watched(instance->fmu);
    double *g = instance->g;
    lag_status status = lag_instance_look(instance, held->t, instance->x, instance->room);
    if (status == LAG_OK && count > 0 && held->exchanged && held->phase == LAG_PHASE_MOTION) {
        status = look_along(instance);
    }
    if (status == LAG_OK) {
        lag_instance_pass_corners(instance);
    }
    const double *passed = node_at(instance, instance->tip).passed;
    for (size_t i = 0; i < count && status == LAG_OK; ++i) {
        const double behind = -fabs(instance->room[i]) - lag_instance_round_off(instance, i); /* no zero for a search to end at */
        const double room = held->nodes > 0 && passed[i] != 0.0 ? behind : instance->room[i];
        instance->shown[i] = room < 0.0 ? fmax(instance->shown[i], held->t) : instance->shown[i];
        if (!lag_instance_is_held(instance, i)) {
            *g++ = lag_instance_side(instance, i) * room;
        }
    }
    return status;
}

void lag_instance_end_path(lag_instance *instance, int any)
{
    lag_held *held = &instance->held;
    const lag_model *model = instance->fmu->model;
    int shown = 0;
    for (size_t i = model->nindicator; i < model->nindicator + model->ncontact; ++i) {
        shown = shown || instance->shown[i] >= held->t;
    }
    if (any || shown || held->t > held->latched_at) {
        held->blind = shown && !any ? LONGER * held->span : 0.0;
    }
}

void lag_instance_forget_path(lag_instance *instance)
{
    instance->held.nodes = 0;
    for (size_t i = 0; i < lag_instance_watched(instance->fmu); ++i) {
        instance->shown[i] = -(double)INFINITY;
    }
}
