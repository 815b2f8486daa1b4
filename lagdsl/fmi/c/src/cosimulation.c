/* Co-simulation: the integrators of the runtime, from one communication point to the next. */
#include "lag/parts.h"

#include <math.h>
#include <string.h>

lag_status lag_instance_step(lag_instance *instance, double h, int stops, lag_progress *told)
{
    lag_held *held = &instance->held;
    lag_run *run = instance->run;
    const double end = held->t + h;
    int happened = 0;
    (void)stops;
    *told = (lag_progress){.t = held->t};
    lag_status status = lag_instance_begin(instance);
    if (status == LAG_OK) {
        status = lag_instance_ready(instance);
    }
    if (status == LAG_OK && held->jumped) {
        status = lag_instance_carry_out(instance, &happened);
        held->jumped = 0;
    }
    if (status == LAG_OK && !held->stopped) {
        status = lag_run_to(run, end, 0);
        memcpy(instance->x, run->stepper.x, lag_instance_order(instance) * sizeof(double));
        held->t = run->stepper.t;
        held->stopped = status == LAG_STOPPED;
        status = held->stopped ? LAG_OK : status;
        instance->known = 0;
    }
    told->t = held->t;
    told->terminate = held->stopped;
    told->early = held->t < end;
    return lag_instance_judge(instance, status);
}
