/*
 * Event indicators. A guard is a relation, a contact or dry friction; its value passes zero downward when it changes (lag/events/guards.h). Importers
 * compare the signs of indicators at their steps, so an indicator is clearly of one sign behind every event:
 *
 * - An armed guard leaves a round-off behind zero; one that changes at zero itself, as `limit(u, -1, 1) >= 1` does, a part of that before zero,
 *   because its value may never get behind.
 * - One that an event leaves within its dead band, or behind zero, is not armed: it leaves so far behind zero as the event left it, and the band more.
 *   The band is what the tolerance lets the value do. Importers may be less exact than they have told, or tell nothing: a guard that leaves
 *   without having been armed gets a band that is larger by a factor.
 * - It is armed once an importer has asked where it is farther before zero than that.
 */
#include "lag/instance/instance_internal.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* A guard that changes at zero leaves so early, as a part of its round-off. */
static const double EARLY = 0.5;
/* In event mode guards leave together that are nearer to the zeros of their indicators than so many round-offs; behind an event none is. */
static const double TOGETHER = 4.0;
/* The band of a guard that has left without having been armed becomes so many times larger. */
static const double WIDER = 4.0;

/* True for a relation that the motion does not change. */
static int is_held(const lag_fmu *fmu, size_t i)
{
    return fmu->held_relations != NULL && i < fmu->model->nindicator && fmu->held_relations[i];
}

size_t lag_instance_indicator_count(const lag_fmu *fmu)
{
    size_t count = 0;
    for (size_t i = 0; i < lag_guard_count(fmu->model); ++i) {
        count += !is_held(fmu, i);
    }
    return count;
}

/* True for a relation that does not hold now. */
static int is_false(const lag_instance *instance, size_t i)
{
    const lag_run *run = instance->run;
    return i < instance->fmu->model->nindicator && run->motion.w[run->guards.places.relation + i] == 0.0;
}

/* True for `>=` and `<=` that do not hold, `>` and `<` that do. */
static int changes_at_zero(const lag_instance *instance, size_t i)
{
    const lag_model *model = instance->fmu->model;
    return i < model->nindicator && is_false(instance, i) != (model->strict[i] != 0);
}

/* Guards that are off are infinite; FMI wants numbers. */
static double value_of(const lag_instance *instance, size_t i)
{
    const double value = instance->run->guards.value[i];
    return isinf(value) ? 1.0 : value;
}

/* FMI wants no indicator to be zero after an event; where no force acts, the force of a contact is zero, and so is its round-off. */
static double round_off(const lag_instance *instance, size_t i)
{
    return fmax(DBL_MIN, lag_guards_noise(&instance->run->guards, i));
}

static double dead_band(const lag_instance *instance, size_t i)
{
    return fmax(round_off(instance, i), lag_guards_known(&instance->run->guards, i));
}

int lag_instance_is_armed(const lag_instance *instance, size_t i)
{
    return instance->held.t > instance->guards.armed[i];
}

/* The way of guard i until it leaves; negative: it has left. */
static double distance_to_leave(const lag_instance *instance, size_t i)
{
    const double sigma = round_off(instance, i);
    const double before = lag_guards_touches(&instance->run->guards, i) ? dead_band(instance, i) : 0.0;
    const double behind = lag_instance_is_armed(instance, i) ? -before : instance->guards.latched[i];
    return value_of(instance, i) + behind + (changes_at_zero(instance, i) ? -EARLY * sigma : sigma);
}

int lag_instance_leaves(lag_instance *instance, size_t i)
{
    const double near = TOGETHER * (round_off(instance, i) - DBL_MIN); /* the force of an open contact is zero without round-off: no `<` */
    const int leaves = distance_to_leave(instance, i) < near;
    instance->run->guards.pieces.seen[0][i] = value_of(instance, i);
    instance->guards.latched[i] *= leaves && !lag_instance_is_armed(instance, i) ? WIDER : 1.0;
    return leaves;
}

lag_status lag_instance_find_indicators(lag_instance *instance)
{
    double *g = instance->values.g;
    const size_t count = lag_guard_count(instance->fmu->model);
    lag_status status = count > 0 ? lag_guards_detect(&instance->run->guards, instance->held.t, instance->x) : LAG_OK;
    status = status == LAG_EVENT_PENDING ? LAG_OK : status;
    for (size_t i = 0; i < count && status == LAG_OK; ++i) {
        if (!is_held(instance->fmu, i)) {
            *g++ = is_false(instance, i) ? -distance_to_leave(instance, i) : distance_to_leave(instance, i);
        }
        if (value_of(instance, i) > instance->guards.latched[i]) {
            instance->guards.armed[i] = fmin(instance->guards.armed[i], instance->held.t);
        }
    }
    return status;
}

lag_status lag_instance_indicators(lag_instance *instance, double *g)
{
    const lag_status status = lag_instance_evaluate(instance, LAG_KNOWN_INDICATORS);
    if (status == LAG_OK) {
        memcpy(g, instance->values.g, lag_instance_indicator_count(instance->fmu) * sizeof(double));
    }
    return status;
}

/* True if guard i was armed, and the event has not changed its value. */
static int stays_armed(const lag_instance *instance, size_t i)
{
    const double sigma = round_off(instance, i);
    const double value = value_of(instance, i);
    return lag_instance_is_armed(instance, i) && value > TOGETHER * sigma && fabs(value - instance->run->guards.pieces.seen[0][i]) <= sigma;
}

lag_status lag_instance_arm(lag_instance *instance)
{
    lag_run *run = instance->run;
    const double t = instance->held.t;
    instance->values.known = 0;
    if (instance->fmu->model->nindicator > 0) {
        lag_noise_find(&run->instants.noise, t, instance->x);
    }
    const lag_status status = lag_guards_begin(&run->guards, t, instance->x);
    for (size_t i = 0; i < lag_guard_count(instance->fmu->model) && status == LAG_OK; ++i) {
        if (stays_armed(instance, i)) {
            continue;
        }
        const double behind = fmax(0.0, -value_of(instance, i)) + dead_band(instance, i);
        instance->guards.latched[i] = lag_instance_is_armed(instance, i) ? behind : fmax(behind, instance->guards.latched[i]);
        instance->guards.armed[i] = value_of(instance, i) > instance->guards.latched[i] ? t : (double)INFINITY;
    }
    return status;
}
