#include "lag/alert.h"

#include <math.h>

size_t lag_alert_memory(const lag_model *model)
{
    return 7 * model->nindicator + model->ngap * (2 + model->nq) + 10 * model->ncontact;
}

void lag_alert_place(lag_alert *alert, lag_motion *motion, const double *slack, double *memory)
{
    const lag_model *model = motion->model;
    const size_t count = model->nindicator + model->ncontact;
    alert->motion = motion;
    alert->places = lag_places_of(model);
    alert->slack = slack;
    alert->changed = memory;
    alert->root = alert->changed + count;
    for (size_t k = 0; k < 3; ++k) {
        alert->seen[k] = alert->root + (k + 1) * count;
    }
    alert->found = alert->root + 4 * count;
    alert->inside = alert->root + 5 * count;
    alert->g = alert->inside + model->ncontact;
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

/* Gaps, and what is none of them. */
static lag_status look_at_gaps(lag_alert *alert, const double *x, double *least)
{
    const lag_motion *motion = alert->motion;
    const lag_model *model = motion->model;
    double *laws = alert->laws;
    double size = 1.0;
    for (size_t i = 0; i < lag_motion_size(model); ++i) {
        size = fmax(size, 1.0 + fabs(x[i]));
    }
    *least = -alert->slack[0] * size;
    return model->contact(&motion->at, alert->gap, alert->speed, alert->jacobian, laws, laws + model->ncontact,
        laws + 2 * model->ncontact);
}

static int is_closed(const lag_alert *alert, size_t i)
{
    return alert->motion->w[alert->places.contact + i] != 0.0;
}

static lag_status contacts(lag_alert *alert, const double *x)
{
    const lag_model *model = alert->motion->model;
    double least = 0.0;
    const lag_status status = look_at_gaps(alert, x, &least);
    for (size_t i = 0; i < model->ncontact; ++i) {
        const int pulls = alert->motion->lam[model->contact_rows[i]] < -alert->slack[1];
        const int meets = alert->gap[i] < least && (alert->inside[i] == 0.0 || alert->speed[i] < 0.0);
        alert->changed[model->nindicator + i] = is_closed(alert, i) ? pulls : meets;
    }
    return status;
}

lag_status lag_alert_begin(lag_alert *alert, double t, const double *x)
{
    double least = 0.0;
    if (alert->motion->model->ncontact == 0) {
        return LAG_OK;
    }
    lag_motion_look(alert->motion, t, x);
    const lag_status status = look_at_gaps(alert, x, &least);
    for (size_t i = 0; i < alert->motion->model->ncontact; ++i) {
        alert->inside[i] = alert->gap[i] < least;
    }
    return status;
}

/* Whether accelerations or multipliers tell anything: relations may contain them, and closed contacts have them. */
static int needs_forces(const lag_alert *alert)
{
    const lag_model *model = alert->motion->model;
    int needs = model->nindicator > 0;
    for (size_t i = 0; i < model->ncontact && !needs; ++i) {
        needs = is_closed(alert, i);
    }
    return needs;
}

double lag_alert_value(const lag_alert *alert, size_t which)
{
    const lag_motion *motion = alert->motion;
    const size_t count = motion->model->nindicator;
    if (which < count) {
        const int holds = motion->w[alert->places.relation + which] != 0.0;
        return holds ? alert->g[which] : -alert->g[which];
    }
    return is_closed(alert, which - count) ? motion->lam[motion->model->contact_rows[which - count]] : alert->gap[which - count];
}

lag_status lag_alert_look(lag_alert *alert, double t, const double *x)
{
    const lag_model *model = alert->motion->model;
    lag_status status = LAG_OK;
    if (needs_forces(alert)) {
        status = lag_motion_solve(alert->motion, t, x);
    } else {
        lag_motion_look(alert->motion, t, x);
    }
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
