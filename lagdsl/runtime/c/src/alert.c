#include "lag/alert.h"

#include <math.h>
#include <string.h>

#include "lag/memory.h"

/* What is so many times its round-off as it was found last is none. */
static const double CLEARLY = 1e6;

size_t lag_alert_memory(const lag_model *model)
{
    const size_t count = model->nindicator + model->ncontact + model->ncorner;
    return model->nindicator + model->ngap * (2 + model->nq) + 3 * model->ncontact + 2 * model->ncorner + (4 + LAG_ALERT_LOOKS) * count;
}

void lag_alert_place(lag_alert *alert, lag_motion *motion, lag_contacts *contacts, lag_noise *noise, double *memory)
{
    const lag_model *model = motion->model;
    const size_t count = model->nindicator + model->ncontact + model->ncorner;
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
    alert->far = lag_take(&memory, model->ncorner);
    alert->side = lag_take(&memory, model->ncorner);
    alert->laws = memory;
    alert->span = alert->reach = 0.0;
    memset(alert->band, 0, count * sizeof(double));
}

size_t lag_alert_count(const lag_alert *alert)
{
    return alert->motion->model->nindicator + alert->motion->model->ncontact + alert->corners;
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
    if (which >= count + motion->model->ncontact) {
        const size_t corner = which - count - motion->model->ncontact;
        return alert->side[corner] * alert->far[corner];
    }
    return is_closed(alert, which - count) ? motion->lam[motion->model->contact_rows[which - count]] : alert->gap[which - count];
}

double lag_alert_noise(const lag_alert *alert, size_t which)
{
    const size_t count = alert->motion->model->nindicator;
    const size_t contacts = alert->motion->model->ncontact;
    if (which < count || which >= count + contacts) {
        return alert->noise->sigma[which < count ? which : which - contacts];
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

static lag_status corners(lag_alert *alert)
{
    const size_t first = alert->motion->model->nindicator + alert->motion->model->ncontact;
    double solved = 0.0;
    const lag_status status = alert->motion->model->corner(&alert->motion->at, alert->far, &solved);
    for (size_t i = first; i < first + alert->corners; ++i) {
        alert->changed[i] = -lag_alert_value(alert, i) > alert->band[i];
    }
    return status;
}

/* Whether accelerations or multipliers tell anything: relations may contain them, and closed contacts have them. */
static int needs_forces(const lag_alert *alert)
{
    const lag_model *model = alert->motion->model;
    int needs = model->nindicator > 0 || (alert->corners > 0 && alert->solved);
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
    if (status == LAG_OK && alert->corners > 0) {
        status = corners(alert);
    }
    for (size_t i = 0; i < lag_alert_count(alert) && status == LAG_OK; ++i) {
        status = alert->changed[i] != 0.0 ? LAG_HAPPENS : LAG_OK;
    }
    return status;
}

lag_status lag_alert_begin(lag_alert *alert, double t, const double *x)
{
    const size_t count = lag_alert_count(alert);
    const size_t contacts = alert->motion->model->ncontact;
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
        if (i >= alert->motion->model->nindicator && contact < contacts && is_closed(alert, contact) && isfinite(value)) {
            alert->contacts->force[contact] = fmax(alert->contacts->force[contact], fabs(value));
        }
    }
    return status == LAG_HAPPENS ? LAG_OK : status;
}

int lag_alert_has_noise(const lag_alert *alert, size_t which)
{
    const size_t relations = alert->motion->model->nindicator;
    return which < relations || which >= relations + alert->motion->model->ncontact;
}

int lag_alert_widen(lag_alert *alert, double t, const double *x)
{
    const size_t count = lag_alert_count(alert);
    int unclear = 0;
    for (size_t i = 0; i < count; ++i) {
        const double sigma = lag_alert_has_noise(alert, i) ? lag_alert_noise(alert, i) : 0.0;
        const int clear = -lag_alert_value(alert, i) > CLEARLY * sigma && sigma > 0.0;
        unclear = unclear || (lag_alert_has_noise(alert, i) && alert->changed[i] != 0.0 && !clear);
    }
    if (!unclear) {
        return 0;
    }
    lag_noise_find(alert->noise, t, x);
    for (size_t i = 0; i < count; ++i) {
        if (lag_alert_has_noise(alert, i) && alert->changed[i] != 0.0 && -lag_alert_value(alert, i) <= lag_alert_noise(alert, i)) {
            alert->band[i] = fmax(alert->band[i], lag_alert_noise(alert, i));
        }
    }
    return 1;
}
