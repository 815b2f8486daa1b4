#include "lag/alert.h"

#include <math.h>
#include <string.h>

#include "lag/memory.h"

/* What is so many times its round-off as it was found last is none. */
static const double CLEARLY = 1e6;

size_t lag_alert_memory(const lag_model *model)
{
    const size_t count = model->nindicator + model->ncontact;
    return model->nindicator + model->ngap * (2 + model->nq) + 3 * model->ncontact + (4 + LAG_ALERT_LOOKS) * count;
}

void lag_alert_place(lag_alert *alert, lag_motion *motion, lag_contacts *contacts, lag_noise *noise, double *memory)
{
    const lag_model *model = motion->model;
    const size_t count = model->nindicator + model->ncontact;
    alert->motion = motion;
    alert->places = lag_places_of(model);
    alert->contacts = contacts;
    alert->noise = noise;
    alert->changed = lag_take(&memory, count);
    alert->band = lag_take(&memory, count);
    alert->root = lag_take(&memory, count);
    alert->found = lag_take(&memory, count);
    for (size_t k = 0; k < LAG_ALERT_LOOKS; ++k) {
        alert->seen[k] = lag_take(&memory, count);
    }
    alert->g = lag_take(&memory, model->nindicator);
    alert->gap = lag_take(&memory, model->ngap);
    alert->speed = lag_take(&memory, model->ngap);
    alert->jacobian = lag_take(&memory, model->ngap * model->nq);
    alert->laws = memory;
    alert->span = alert->reach = 0.0;
    memset(alert->band, 0, count * sizeof(double));
}

static int is_closed(const lag_alert *alert, size_t i)
{
    return alert->motion->w[alert->places.contact + i] != 0.0;
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

double lag_alert_noise(const lag_alert *alert, size_t which)
{
    const size_t count = alert->motion->model->nindicator;
    if (which < count) {
        return alert->noise->sigma[which];
    }
    return is_closed(alert, which - count) ? lag_contacts_force_noise(alert->contacts, which - count)
                                           : lag_contacts_gap_noise(alert->contacts, which - count);
}

/* A relation that stood at zero when it was looked at first changes as soon as its truth does, others where they leave their bands. */
static lag_status relations(lag_alert *alert)
{
    const lag_model *model = alert->motion->model;
    const lag_status status = model->indicator(&alert->motion->at, alert->g);
    for (size_t i = 0; i < model->nindicator; ++i) {
        const double g = alert->g[i];
        const int truth = g > 0.0 || (g == 0.0 && model->strict[i] == 0);
        const int differs = truth != (alert->motion->w[alert->places.relation + i] != 0.0);
        alert->changed[i] = differs && (!(alert->band[i] > 0.0) || -lag_alert_value(alert, i) > alert->band[i]);
    }
    return status;
}

static lag_status look_at_gaps(lag_alert *alert)
{
    const lag_model *model = alert->motion->model;
    double *laws = alert->laws;
    const lag_status status = model->contact(&alert->motion->at, alert->gap, alert->speed, alert->jacobian, laws,
        laws + model->ncontact, laws + 2 * model->ncontact);
    if (status == LAG_OK) {
        lag_contacts_scale(alert->contacts, alert->jacobian);
    }
    return status;
}

static lag_status contacts(lag_alert *alert)
{
    const lag_model *model = alert->motion->model;
    const lag_status status = look_at_gaps(alert);
    for (size_t i = model->nindicator; i < model->nindicator + model->ncontact; ++i) {
        const double least = fmax(alert->band[i], lag_alert_noise(alert, i));
        alert->changed[i] = -lag_alert_value(alert, i) > least;
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
        status = contacts(alert);
    }
    for (size_t i = 0; i < model->nindicator + model->ncontact && status == LAG_OK; ++i) {
        status = alert->changed[i] != 0.0 ? LAG_HAPPENS : LAG_OK;
    }
    return status;
}

lag_status lag_alert_begin(lag_alert *alert, double t, const double *x)
{
    const size_t count = alert->motion->model->nindicator + alert->motion->model->ncontact;
    if (count == 0) {
        return LAG_OK;
    }
    lag_noise_follow(alert->noise, x);
    lag_contacts_follow(alert->contacts, x);
    const lag_status status = lag_alert_look(alert, t, x);
    for (size_t i = 0; i < count && (status == LAG_OK || status == LAG_HAPPENS); ++i) {
        const double value = lag_alert_value(alert, i);
        const size_t contact = i - alert->motion->model->nindicator;
        alert->band[i] = value < 0.0 ? -value : 0.0;
        if (i >= alert->motion->model->nindicator && is_closed(alert, contact) && isfinite(value)) {
            alert->contacts->force[contact] = fmax(alert->contacts->force[contact], fabs(value));
        }
    }
    return status == LAG_HAPPENS ? LAG_OK : status;
}

int lag_alert_widen(lag_alert *alert, double t, const double *x)
{
    const size_t count = alert->motion->model->nindicator;
    const double *sigma = alert->noise->sigma;
    int unclear = 0;
    for (size_t i = 0; i < count; ++i) {
        unclear = unclear || (alert->changed[i] != 0.0 && !(-lag_alert_value(alert, i) > CLEARLY * sigma[i] && sigma[i] > 0.0));
    }
    if (!unclear) {
        return 0;
    }
    lag_noise_find(alert->noise, t, x);
    for (size_t i = 0; i < count; ++i) {
        if (alert->changed[i] != 0.0 && -lag_alert_value(alert, i) <= sigma[i]) {
            alert->band[i] = fmax(alert->band[i], sigma[i]);
        }
    }
    return 1;
}
