#include "lag/run/conditions.h"

#include <math.h>

size_t lag_conditions_memory(const lag_model *model)
{
    return 2 * model->ni + model->na;
}

/* True if all invariants are within their tolerances; with `count`, also records their departures and scales. */
static int invariants(lag_conditions *watch, int count)
{
    int within = 1;
    for (size_t i = 0; i < watch->motion->model->ni; ++i) {
        const double drift = fabs(watch->value[i] - watch->start[i]);
        const double size = fmax(watch->size[i], fmax(fabs(watch->start[i]), watch->scale[i]));
        within = within && drift <= watch->tolerance[i] * size;
        if (count) {
            watch->size[i] = size;
            watch->drift[i] = fmax(watch->drift[i], drift);
        }
    }
    return within;
}

void lag_conditions_count(lag_conditions *watch)
{
    (void)invariants(watch, 1);
}

lag_status lag_conditions_check(lag_conditions *watch, double t, const double *x)
{
    const lag_model *model = watch->motion->model;
    if (model->ni + model->na == 0 || watch->tolerance == NULL) {
        return LAG_OK;
    }
    lag_status status = lag_motion_solve(watch->motion, t, x);
    if (status == LAG_OK) {
        status = model->monitor(&watch->motion->at, watch->value, watch->scale, watch->held);
    }
    for (size_t i = 0; i < model->na && status == LAG_OK; ++i) {
        status = watch->held[i] == 0.0 ? LAG_VIOLATED : LAG_OK;
    }
    for (size_t i = 0; i < model->ni && !watch->begun; ++i) {
        watch->start[i] = watch->value[i];
    }
    watch->begun = 1;
    if (status == LAG_OK) {
        status = invariants(watch, 0) ? LAG_OK : LAG_VIOLATED;
    }
    if (status == LAG_OK) {
        (void)invariants(watch, 1);
    }
    return status;
}
