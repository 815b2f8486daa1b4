/* Clocks of the model as importers see them: they tick by themselves, at instants that are known ahead. */
#include "lag/instance/instance_internal.h"

#include <math.h>

/* The first instant of a clock from time t on, but for round-off. Its period stays as it was at the start. */
static lag_status seek(lag_instance *instance, size_t which, double t, double *period, double *instant)
{
    const lag_status status = lag_instance_ready(instance);
    if (status == LAG_OK) {
        lag_clock clock = instance->run->instants.clocks.each[which];
        lag_clock_seek(&clock, t - LAG_SAME_TICK * clock.period);
        *period = clock.period;
        *instant = lag_clock_instant(&clock, clock.next);
    }
    return status;
}

lag_status lag_instance_clock(lag_instance *instance, size_t which, double *period, double *shift)
{
    const double start = instance->held.start;
    const lag_status status = seek(instance, which, start, period, shift);
    *shift = fmax(0.0, *shift - start);
    return status;
}

lag_status lag_instance_tick(lag_instance *instance, size_t which)
{
    const double t = instance->held.t;
    double period = 0.0;
    double tick = t;
    const lag_status status = seek(instance, which, t, &period, &tick);
    if (status != LAG_OK || tick <= t + LAG_SAME_TICK * period) {
        return status;
    }
    return lag_instance_fail(instance, LAG_MISSING, "the clock does not tick at %.10g s, but at %.10g s", t, tick);
}
