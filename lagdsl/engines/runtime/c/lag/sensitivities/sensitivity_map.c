/* An instant as a map from the state before it to the one behind it. */
#include <math.h>
#include <string.h>

#include "lag/run.h"
#include "lag/sensitivities/sensitivities.h"

/* Adds a notice to a sum that tells which ones there were, in whatever order. Source: Steele, Lea, Flood, OOPSLA 2014 (SplitMix). */
static lag_status add_notice(void *context, const lag_event_notice *notice)
{
    uint64_t *sum = context;
    uint64_t mixed = ((uint64_t)notice->what << 32) + (uint64_t)notice->which;
    mixed = (mixed ^ (mixed >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    mixed = (mixed ^ (mixed >> 27)) * UINT64_C(0x94d049bb133111eb);
    *sum += mixed ^ (mixed >> 31);
    return LAG_OK;
}

lag_status lag_instant_map_carry(const lag_instant_map *map, uint64_t *events)
{
    *events = 0;
    map->run->instants.listener = (lag_listener){add_notice, events};
    return lag_run_carry(map->run, map->cause);
}

int lag_is_mode(unsigned char kind)
{
    return kind == LAG_KIND_CONTACT || kind == LAG_KIND_IMPACTS || kind == LAG_KIND_STICKS || kind == LAG_KIND_RELATION ||
        kind == LAG_KIND_TIMED;
}

lag_status lag_instant_map_behind(void *context, double *values)
{
    const lag_instant_map *map = context;
    lag_run *run = map->run;
    const lag_model *model = run->motion.model;
    const size_t n = lag_motion_size(model);
    uint64_t events;
    const lag_status status = lag_instant_map_carry(map, &events);
    if (status != LAG_OK && status != LAG_STOPPED) {
        return status;
    }
    if (events != map->events) {
        return LAG_ATTENTION;
    }
    memcpy(values, run->stepper.x, n * sizeof(double));
    memcpy(values + n, run->motion.w, model->nw * sizeof(double));
    for (size_t i = 0; i < model->nw; ++i) {
        if (lag_is_mode(model->kinds[i]) && run->motion.w[i] != map->s->instant.w_after[i]) {
            return LAG_ATTENTION;
        }
    }
    for (size_t i = 0; i < model->ncontact; ++i) {
        const double until = run->instants.contacts.until[i];
        const int waits = isfinite(until);
        if (waits != isfinite(map->s->instant.until_after[i])) {
            return LAG_ATTENTION;
        }
        values[n + model->nw + i] = waits ? until : 0.0;
    }
    return LAG_OK;
}
