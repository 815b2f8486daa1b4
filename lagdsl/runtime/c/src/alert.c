#include "lag/alert.h"

#include <math.h>

size_t lag_alert_memory(const lag_model *model)
{
    return 3 * model->nindicator + model->ngap * (2 + model->nq) + 5 * model->ncontact;
}

void lag_alert_place(lag_alert *alert, lag_motion *motion, const double *slack, double *memory)
{
    const lag_model *model = motion->model;
    alert->motion = motion;
    alert->places = lag_places_of(model);
    alert->slack = slack;
    alert->changed = memory;
    alert->seen = alert->changed + model->nindicator + model->ncontact;
    alert->g = alert->seen + model->nindicator + model->ncontact;
    alert->gap = alert->g + model->nindicator;
    alert->speed = alert->gap + model->ngap;
    alert->jacobian = alert->speed + model->ngap;
    alert->laws = alert->jacobian + model->ngap * model->nq;
}

static lag_status relations(lag_alert *alert)
{
    const lag_model *model = alert->motion->model;
    const lag_status status = model->indicator(&alert->motion->at, alert->g);
    for (size_t i = 0; i < model->nindicator; ++i) {
        const double g = alert->g[i];
        const int truth = g > 0.0 || (g == 0.0 && model->strict[i] == 0);
        alert->changed[i] = truth != (alert->motion->w[alert->places.relation + i] != 0.0);
    }
    return status;
}

static lag_status contacts(lag_alert *alert, const double *x)
{
    const lag_motion *motion = alert->motion;
    const lag_model *model = motion->model;
    double *laws = alert->laws;
    const lag_status status = model->contact(&motion->at, alert->gap, alert->speed, alert->jacobian, laws, laws + model->ncontact,
        laws + 2 * model->ncontact);
    double size = 1.0;
    for (size_t i = 0; i < lag_motion_size(model); ++i) {
        size = fmax(size, 1.0 + fabs(x[i]));
    }
    const double slack = alert->slack[0] * size;
    const double force = alert->slack[1];
    for (size_t i = 0; i < model->ncontact; ++i) {
        const int closed = motion->w[alert->places.contact + i] != 0.0;
        const int pulls = closed && motion->lam[model->contact_rows[i]] < -force;
        const int meets = !closed && alert->gap[i] < -slack && alert->speed[i] < 0.0;
        alert->changed[model->nindicator + i] = pulls || meets;
    }
    return status;
}

double lag_alert_value(const lag_alert *alert, size_t which)
{
    const lag_motion *motion = alert->motion;
    const size_t count = motion->model->nindicator;
    if (which < count) {
        const int holds = motion->w[alert->places.relation + which] != 0.0;
        return holds ? alert->g[which] : -alert->g[which];
    }
    const int closed = motion->w[alert->places.contact + which - count] != 0.0;
    return closed ? motion->lam[motion->model->contact_rows[which - count]] : alert->gap[which - count];
}

lag_status lag_alert_look(lag_alert *alert, double t, const double *x)
{
    const lag_model *model = alert->motion->model;
    lag_status status = lag_motion_solve(alert->motion, t, x);
    if (status == LAG_OK && model->nindicator > 0) {
        status = relations(alert);
    }
    if (status == LAG_OK && model->ncontact > 0) {
        status = contacts(alert, x);
    }
    for (size_t i = 0; i < model->nindicator + model->ncontact && status == LAG_OK; ++i) {
        status = alert->changed[i] != 0.0 ? LAG_HAPPENS : LAG_OK;
    }
    return status;
}
