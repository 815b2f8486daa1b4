#include "lag/alert.h"

static size_t larger(size_t a, size_t b)
{
    return a > b ? a : b;
}

size_t lag_alert_memory(const lag_model *model)
{
    return larger(model->nindicator, model->ngap) + model->ngap * (1 + model->nq) + 3 * model->ncontact;
}

void lag_alert_place(lag_alert *alert, lag_motion *motion, const lag_alert_places *places, double *memory)
{
    const lag_model *model = motion->model;
    alert->motion = motion;
    alert->places = *places;
    alert->value = memory;
    alert->speed = alert->value + larger(model->nindicator, model->ngap);
    alert->jacobian = alert->speed + model->ngap;
    alert->laws = alert->jacobian + model->ngap * model->nq;
}

static lag_status relations(lag_alert *alert)
{
    const lag_model *model = alert->motion->model;
    const lag_status status = model->indicator(&alert->motion->at, alert->value);
    if (status != LAG_OK) {
        return status;
    }
    for (size_t i = 0; i < model->nindicator; ++i) {
        const double g = alert->value[i];
        const int truth = g > 0.0 || (g == 0.0 && alert->places.strict[i] == 0.0);
        if (truth != (alert->motion->w[(size_t)alert->places.truth[i]] != 0.0)) {
            return LAG_HAPPENS;
        }
    }
    return LAG_OK;
}

static lag_status contacts(lag_alert *alert)
{
    const lag_motion *motion = alert->motion;
    const lag_model *model = motion->model;
    double *laws = alert->laws;
    const lag_status status = model->contact(&motion->at, alert->value, alert->speed, alert->jacobian, laws,
        laws + model->ncontact, laws + 2 * model->ncontact);
    if (status != LAG_OK) {
        return status;
    }
    for (size_t i = 0; i < model->ncontact; ++i) {
        const int closed = motion->w[(size_t)alert->places.closed[i]] != 0.0;
        const int pulls = closed && motion->lam[(size_t)alert->places.row[i]] < 0.0;
        if (pulls || (!closed && alert->value[i] < 0.0 && alert->speed[i] < 0.0)) {
            return LAG_HAPPENS;
        }
    }
    return LAG_OK;
}

lag_status lag_alert_look(lag_alert *alert, double t, const double *x)
{
    const lag_model *model = alert->motion->model;
    lag_status status = lag_motion_solve(alert->motion, t, x);
    if (status == LAG_OK && model->nindicator > 0) {
        status = relations(alert);
    }
    if (status == LAG_OK && model->ncontact > 0) {
        status = contacts(alert);
    }
    return status;
}
