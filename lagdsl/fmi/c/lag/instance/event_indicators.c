/*
 * Event indicators. An indicator is what passes zero when a relation or a contact changes (lag/events/zero_crossing.h), with a
 * dead band, the margin: it changes its sign a little late, so that it is clearly of one sign or the other after every event, wherever an importer
 * has located it. The margin is round-off, until events without effect tell that the importer is less exact. A value that an event leaves behind zero
 * is latched there: it is no event until it goes further by the margin, or comes back. A relation that changes at zero itself, as
 * `limit(u, -1, 1) >= 1` does, may never get behind it: its indicator changes a little early. An importer compares signs at its steps: what changes and
 * changes back between them is not seen.
 */
#include "lag/instance/instance_internal.h"

#include "lag/linalg/arena.h"
#include "lag/linalg/vector.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* A margin becomes so many times larger after an event without effect: a factor, not an error, holds for a gap and for a force. */
static const double WIDER = 4.0;
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

double lag_instance_margin(const lag_instance *instance, size_t i)
{
    return fmax(1.0, instance->widened[i]) * lag_instance_round_off(instance, i);
}

void lag_instance_widen(lag_instance *instance, size_t i)
{
    instance->widened[i] = WIDER * fmax(1.0, instance->widened[i]);
}

int lag_instance_changes_at_zero(const lag_instance *instance, size_t i)
{
    const lag_model *model = instance->fmu->model;
    const int holds = i < model->nindicator && instance->run->motion.w[instance->run->crossings.places.relation + i] != 0.0;
    return i < model->nindicator && holds == (model->strict[i] != 0);
}

double lag_instance_room(const lag_instance *instance, size_t i)
{
    const double margin = lag_instance_margin(instance, i);
    return lag_instance_crossing_value(instance, i) + (lag_instance_changes_at_zero(instance, i) ? -EARLY * margin : margin);
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

/* Room of everything at the present state, as far as it is not latched. */
static lag_status look(lag_instance *instance, double *room)
{
    const double t = instance->held.t;
    const double *x = instance->x;
    const size_t count = lag_instance_crossing_count(instance);
    const lag_status status = lag_instance_look_at_crossings(instance, t, x);
    for (size_t i = 0; i < count && status == LAG_OK; ++i) {
        room[i] = lag_instance_is_held(instance, i) ? 1.0 : lag_instance_room(instance, i) + instance->latched[i];
    }
    return status == LAG_OK ? lag_instance_look_at_corners(instance, t, x, room) : status;
}

lag_status lag_instance_find_indicators(lag_instance *instance)
{
    double *g = instance->g;
    const lag_status status = look(instance, instance->room);
    for (size_t i = 0; i < lag_instance_watched(instance->fmu) && status == LAG_OK; ++i) {
        if (!lag_instance_is_held(instance, i)) {
            *g++ = lag_instance_side(instance, i) * instance->room[i];
        }
    }
    if (status == LAG_OK) {
        lag_instance_pass_corners(instance);
    }
    return status;
}

lag_status lag_instance_indicators(lag_instance *instance, double *g)
{
    const lag_status status = lag_instance_know(instance, LAG_KNOWN_INDICATORS);
    if (status == LAG_OK) {
        memcpy(g, instance->g, lag_instance_indicator_count(instance->fmu) * sizeof(double));
    }
    return status;
}

static double resting(const lag_instance *instance, size_t which)
{
    return which < instance->fmu->model->nindicator ? instance->resting[which] : 0.0;
}

/* Relations that rows hold at zero are shown to change when they leave that, as far as the motion is known. */
static void find_resting(lag_instance *instance)
{
    const lag_zero_crossing *crossings = &instance->run->crossings;
    for (size_t i = 0; i < instance->fmu->model->nindicator; ++i) {
        instance->resting[i] = crossings->held[i] != 0.0 ? lag_zero_crossing_known(crossings, i) : 0.0;
    }
}

lag_status lag_instance_latch(lag_instance *instance, double t, const double *x)
{
    const size_t count = lag_instance_crossing_count(instance);
    if (instance->fmu->model->nindicator + instance->fmu->model->ncorner > 0) {
        lag_noise_find(&instance->run->instants.noise, t, x);
    }
    lag_contacts_follow(&instance->run->instants.contacts, x);
    find_resting(instance);
    const lag_status status = lag_instance_look_at_crossings(instance, t, x);
    instance->known = 0;
    instance->held.latched_at = t;
    for (size_t i = 0; i < count && status == LAG_OK; ++i) {
        const double behind = fmax(0.0, lag_instance_margin(instance, i) - lag_instance_room(instance, i));
        instance->latched[i] = behind + resting(instance, i);
    }
    return status == LAG_OK ? lag_instance_face_corners(instance, t, x) : status;
}

lag_status lag_instance_release(lag_instance *instance)
{
    const size_t count = lag_instance_watched(instance->fmu);
    const lag_status status = count > 0 ? lag_instance_know(instance, LAG_KNOWN_INDICATORS) : LAG_OK;
    for (size_t i = 0; i < lag_instance_crossing_count(instance) && status == LAG_OK; ++i) {
        if (lag_instance_room(instance, i) > 2.0 * lag_instance_margin(instance, i) + resting(instance, i)) {
            instance->latched[i] = 0.0;
        }
    }
    if (status == LAG_OK && instance->fmu->model->ncorner > 0) {
        lag_noise_follow(&instance->run->instants.noise, instance->x);
    }
    return status;
}
