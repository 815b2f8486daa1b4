/*
 * Changes that are undone within one step of an importer. An importer compares the signs of indicators at the ends of its steps. So the
 * instance remembers the last two states at which it was asked, looks along Hermite's cubic between them, and an indicator that passes zero
 * there keeps the sign behind zero until event mode: the importer searches the step for the first change, as for any other. Between a
 * state before that change and one behind it the cubic is as exact as the search is narrow. A change that only the cubic shows
 * disappears there; the importer then finds an event without effect at the end of its step. Errors of an importer bend the cubic of its first steps
 * behind such an event, too: bounces that are lower than its errors would cause events without end.
 */
#include "lag/instance/path_search.h"

#include <math.h>
#include <string.h>

/* Steps that are shorter than this part of the experiment show by themselves: bounces within them are rest. */
static const double SHORT = 1e-6;
/*
 * Behind a change of a contact that was shown and was none, the path is not looked along for so many times the step that has shown it. A relation
 * that was shown may still lie within its round-off at the event, and change behind it.
 */
static const double LONGER = 4.0;

size_t lag_instance_node(const lag_fmu *fmu)
{
    return 1 + 2 * lag_motion_size(fmu->model) + fmu->model->nu + lag_instance_watched(fmu);
}

size_t lag_instance_path_looks(const lag_fmu *fmu)
{
    return LAG_LOOKS * lag_instance_watched(fmu);
}

static lag_path_node node_at(const lag_instance *instance, double *memory)
{
    const size_t size = lag_instance_order(instance);
    const size_t nu = instance->fmu->model->nu;
    return (lag_path_node){memory, memory + 1, memory + 1 + size, memory + 1 + 2 * size, memory + 1 + 2 * size + nu};
}

/* The nodes that the present state leaves, in which it is the last one. */
static void advance(lag_path_step *in)
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
    for (size_t i = 0; i < lag_instance_watched(in->instance->fmu); ++i) {
        in->tip.passed[i] = held->nodes == 2 ? fmax(in->base.passed[i], 0.0) : 0.0;
    }
}

/* 1: an indicator shows a change by itself. */
static int shows(const lag_path_step *in)
{
    int any = 0;
    for (size_t i = 0; i < lag_instance_watched(in->instance->fmu); ++i) {
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
    lag_path_step in = {instance, node_at(instance, instance->base), node_at(instance, instance->tip), {NULL}, 0};
    for (int k = 0; k < LAG_LOOKS; ++k) {
        in.seen[k] = instance->looks + (size_t)k * lag_instance_watched(instance->fmu);
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
    lag_path_set_inputs(&in, 0.0, *in.tip.t - *in.base.t);
    const lag_status status = lag_path_search(&in);
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
