/* What happens at instants of a run: told before and after. */
#include <string.h>

#include "lag/run.h"

static int has_instants(const lag_run *run)
{
    return run->motion.model->event != NULL;
}

static lag_status tell(lag_run *run, lag_what what)
{
    return lag_passes_tell(&run->instants.passes, run->stepper.t, run->stepper.x, what, 0);
}

/* An event that came to a good end is told. */
static lag_status over(lag_run *run, lag_status status)
{
    if (status != LAG_OK && status != LAG_STOPPED) {
        return status;
    }
    const lag_status told = tell(run, LAG_AFTER);
    return told == LAG_OK ? status : told;
}

lag_status lag_run_enter(lag_run *run)
{
    return has_instants(run) ? lag_instants_begin(&run->instants, run->stepper.t, run->stepper.x) : LAG_OK;
}

static lag_status carry_out(lag_run *run, double h, const double *changed, int ticks)
{
    const lag_model *model = run->motion.model;
    double *x = run->stepper.x;
    lag_instants_after(&run->instants, run->stepper.t, h);
    if (changed == NULL) {
        return LAG_OK;
    }
    ++run->events;
    memmove(run->alert.changed, changed, (model->nindicator + model->ncontact) * sizeof(double));
    lag_status status = tell(run, LAG_BEFORE);
    if (status == LAG_OK) {
        status = over(run, lag_instants_carry_out(&run->instants, run->stepper.t, x, run->alert.changed, ticks));
    }
    return status;
}

lag_status lag_run_event(lag_run *run, double h, const double *changed)
{
    return carry_out(run, h, changed, 0);
}

lag_status lag_run_event_and_ticks(lag_run *run, double h, const double *changed)
{
    return carry_out(run, h, changed, 1);
}

int lag_run_due(const lag_run *run, double t)
{
    return has_instants(run) && lag_instants_due(&run->instants, t);
}

lag_status lag_run_ticks(lag_run *run)
{
    if (!lag_run_due(run, run->stepper.t)) {
        return LAG_OK;
    }
    ++run->events;
    const lag_status status = tell(run, LAG_BEFORE);
    return status == LAG_OK ? over(run, lag_instants_tick(&run->instants, run->stepper.t, run->stepper.x)) : status;
}

lag_status lag_run_end(lag_run *run)
{
    const lag_status status = lag_run_ticks(run);
    if (status != LAG_OK || !has_instants(run) || run->instants.places.terminal == run->motion.model->nw) {
        return status;
    }
    return over(run, lag_instants_end(&run->instants, run->stepper.t, run->stepper.x));
}

lag_status lag_run_back(lag_run *run, double t)
{
    lag_stepper *s = &run->stepper;
    int moved = 0;
    lag_status status = lag_run_rows(run, t, 0);
    if (status == LAG_OK) {
        status = lag_stepper_dense(s, t, run->point);
    }
    if (status == LAG_OK) {
        (void)lag_projection_exact(&run->projection, t, run->point, &moved); /* where it cannot, it is as the method found it */
        memcpy(s->x, run->point, s->ode->size * sizeof(double));
        s->t = t;
    }
    return status;
}
