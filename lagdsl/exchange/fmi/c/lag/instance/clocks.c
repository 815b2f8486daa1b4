/* Clocks of the model as importers see them: they tick by themselves, at instants that are known ahead. */
#include "lag/instance/instance_internal.h"

#include <math.h>

/* The clock as it will be, or as it began: its period stays as it was at the start. */
static lag_status known(lag_instance *instance, size_t which, lag_clock *clock)
{
    const lag_model *model = instance->fmu->model;
    lag_instants *instants = &instance->run->instants;
    if (instance->held.phase == LAG_PHASE_MOTION) {
        *clock = instants->clock[which];
        return LAG_OK;
    }
    lag_status status = lag_instance_ready(instance);
    if (status == LAG_OK) {
        status = model->clock(&instance->run->motion.at, instants->first, instants->period);
    }
    if (status == LAG_OK && (!(instants->period[which] > 0.0) || !isfinite(instants->first[which]))) {
        status = LAG_BAD_CLOCK;
    }
    if (status == LAG_OK) {
        *clock = lag_clock_of(instants->first[which], instants->period[which]);
    }
    return lag_instance_judge(instance, status);
}

lag_status lag_instance_clock(lag_instance *instance, size_t which, double *period, double *shift)
{
    lag_clock clock = {0};
    const lag_status status = known(instance, which, &clock);
    if (status == LAG_OK) {
        lag_clock_seek(&clock, instance->held.start - LAG_SAME_TICK * clock.period);
        *period = clock.period;
        *shift = fmax(0.0, lag_clock_instant(&clock, clock.next) - instance->held.start);
    }
    return status;
}

lag_status lag_instance_tick(lag_instance *instance, size_t which)
{
    lag_clock clock = {0};
    const lag_status status = known(instance, which, &clock);
    if (status != LAG_OK) {
        return status;
    }
    const double t = instance->held.t;
    lag_clock_seek(&clock, t - LAG_SAME_TICK * clock.period);
    const double tick = lag_clock_instant(&clock, clock.next);
    if (tick <= t + LAG_SAME_TICK * clock.period) {
        return LAG_OK;
    }
    return lag_instance_fail(instance, LAG_MISSING, "the clock does not tick at %.10g s, but at %.10g s", t, tick);
}
