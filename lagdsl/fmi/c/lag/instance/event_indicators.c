/*
 * Event indicators. An indicator is what passes zero when a relation or a contact changes (lag/events/zero_crossing.h), with a
 * margin: it changes its sign a little late, so that it is clearly of one sign or the other after every event, wherever an importer
 * has located it. A relation that changes at zero itself, as `limit(u, -1, 1) >= 1` does, may never get behind it: its indicator changes a
 * little early.
 */
#include "lag/instance/instance_internal.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* A relation that changes at zero does so early by this part of its round-off. */
static const double EARLY = 0.5;

size_t lag_instance_crossing_count(const lag_instance *instance)
{
    return instance->fmu->model->nindicator + instance->fmu->model->ncontact;
}

size_t lag_instance_indicator_count(const lag_fmu *fmu)
{
    size_t count = lag_instance_watched(fmu);
    for (size_t i = 0; i < fmu->model->nindicator && fmu->held_relations != NULL; ++i) {
        count -= fmu->held_relations[i];
    }
    return count;
}

int lag_instance_is_held(const lag_instance *instance, size_t i)
{
    return instance->fmu->held_relations != NULL && i < instance->fmu->model->nindicator && instance->fmu->held_relations[i];
}

double lag_instance_crossing_value(const lag_instance *instance, size_t i)
{
    return lag_zero_crossing_value(&instance->run->crossings, i);
}

/* FMI wants no indicator to be zero after an event; where no force acts, the force of a contact is zero, and so is its round-off. */
double lag_instance_round_off(const lag_instance *instance, size_t i)
{
    return fmax(DBL_MIN, lag_zero_crossing_noise(&instance->run->crossings, i));
}

int lag_instance_changes_at_zero(const lag_instance *instance, size_t i)
{
    const lag_model *model = instance->fmu->model;
    const int holds = i < model->nindicator && instance->run->motion.w[instance->run->crossings.places.relation + i] != 0.0;
    return i < model->nindicator && holds == (model->strict[i] != 0);
}

double lag_instance_room(const lag_instance *instance, size_t i)
{
    const double noise = lag_instance_round_off(instance, i);
    return lag_instance_crossing_value(instance, i) + (lag_instance_changes_at_zero(instance, i) ? -EARLY * noise : noise);
}

double lag_instance_side(const lag_instance *instance, size_t i)
{
    const lag_run *run = instance->run;
    const size_t corner = lag_instance_first_corner(instance);
    const int relation = i < instance->fmu->model->nindicator;
    const int below = i >= corner && instance->side[i - corner] < 0.0;
    return below || (relation && run->motion.w[run->crossings.places.relation + i] == 0.0) ? -1.0 : 1.0;
}

lag_status lag_instance_look_at_crossings(lag_instance *instance, double t, const double *x)
{
    const lag_status status = lag_instance_crossing_count(instance) > 0 ? lag_zero_crossing_look(&instance->run->crossings, t, x) : LAG_OK;
    return status == LAG_EVENT_PENDING ? LAG_OK : status;
}

lag_status lag_instance_look(lag_instance *instance, double t, const double *x, double *room)
{
    const size_t count = lag_instance_crossing_count(instance);
    const lag_status status = lag_instance_look_at_crossings(instance, t, x);
    for (size_t i = 0; i < count && status == LAG_OK; ++i) {
        room[i] = lag_instance_is_held(instance, i) ? 1.0 : lag_instance_room(instance, i) + instance->latched[i];
    }
    return status == LAG_OK ? lag_instance_look_at_corners(instance, t, x, room) : status;
}

lag_status lag_instance_indicators(lag_instance *instance, double *g)
{
    const lag_status status = lag_instance_know(instance, LAG_KNOWN_INDICATORS);
    if (status == LAG_OK) {
        memcpy(g, instance->g, lag_instance_indicator_count(instance->fmu) * sizeof(double));
    }
    return status;
}

lag_status lag_instance_latch(lag_instance *instance, double t, const double *x)
{
    const size_t count = lag_instance_crossing_count(instance);
    if (instance->fmu->model->nindicator + instance->fmu->model->ncorner > 0) {
        lag_noise_find(&instance->run->instants.noise, t, x);
    }
    lag_contacts_follow(&instance->run->instants.contacts, x);
    const lag_status status = lag_instance_look_at_crossings(instance, t, x);
    instance->known = 0;
    lag_instance_forget_path(instance);
    instance->held.latched_at = t;
    for (size_t i = 0; i < count && status == LAG_OK; ++i) {
        instance->latched[i] = fmax(0.0, lag_instance_round_off(instance, i) - lag_instance_room(instance, i)) + instance->errors[i];
    }
    return status == LAG_OK ? lag_instance_face_corners(instance, t, x) : status;
}

lag_status lag_instance_release(lag_instance *instance)
{
    const size_t count = lag_instance_watched(instance->fmu);
    const lag_status status = count > 0 ? lag_instance_know(instance, LAG_KNOWN_INDICATORS) : LAG_OK;
    for (size_t i = 0; i < lag_instance_crossing_count(instance) && status == LAG_OK; ++i) {
        if (lag_instance_room(instance, i) > 2.0 * lag_instance_round_off(instance, i) + instance->errors[i]) {
            instance->latched[i] = instance->errors[i] = 0.0;
        }
    }
    if (status == LAG_OK && instance->fmu->model->ncorner > 0) {
        lag_noise_follow(&instance->run->instants.noise, instance->x);
    }
    return status;
}
