/* Contacts in passes over clauses: impacts, and what opens or closes where it was found to change. */
#include <math.h>
#include <string.h>

#include "lag/events/event_iteration.h"
#include "lag/linalg/arena.h"
#include "lag/linalg/vector.h"

lag_status lag_event_iteration_report_contact(const lag_event_iteration *iteration, double t, const double *x, lag_event_kind what, size_t i)
{
    iteration->contacts->until[i] = (double)INFINITY;
    return lag_event_iteration_report(iteration, t, x, what, i);
}

/* Reports that a contact has opened or closed, if it has; one that is held for the rest of its bounces closes at their end. */
static lag_status report_mode(const lag_event_iteration *iteration, double t, const double *x, size_t i)
{
    const lag_contacts *contacts = iteration->contacts;
    const int before = contacts->blows.before[i] != 0.0;
    const int now = *lag_contacts_flag(contacts, i) != 0.0;
    const int bounces = now && contacts->until[i] < (double)INFINITY;
    return before == now || bounces ? LAG_OK : lag_event_iteration_report_contact(iteration, t, x, now ? LAG_CLOSED : LAG_OPENED, i);
}

/* Modes of contacts that are closed, or have met without approach speed, and of friction. */
static lag_status find_modes(lag_event_iteration *iteration, double t, const double *x)
{
    lag_contacts *contacts = iteration->contacts;
    for (size_t i = 0; i < iteration->motion->model->ncontact; ++i) {
        contacts->blows.closing[i] = contacts->blows.met[i] != 0.0 && contacts->blows.approach[i] == 0.0 && contacts->speed[i] <= lag_contacts_speed_band(contacts, i);
    }
    const lag_status status = lag_modes_find(iteration->modes, t, x, contacts->blows.closing, iteration->leaving.left);
    iteration->leaving.left = NULL;
    return status;
}

lag_status lag_event_iteration_impact(lag_event_iteration *iteration, double t, double *x, const double *collision, int *acted)
{
    const lag_contacts *contacts = iteration->contacts;
    const size_t frictions = iteration->motion->model->nfriction + iteration->motion->model->nslip;
    const double *modes = iteration->motion->w + iteration->places.sticks;
    memcpy(iteration->leaving.frictions, modes, frictions * sizeof(double));
    lag_status status = lag_contacts_impact(iteration->contacts, t, x, collision, iteration->clauses.restitution);
    iteration->modes->jumped = iteration->modes->jumped || contacts->blows.struck > 0 ||
        (collision != NULL && lag_any(iteration->motion->model->ncollision, collision));
    status = status == LAG_OK ? find_modes(iteration, t, x) : status;
    int any = contacts->blows.struck > 0 || !lag_same(frictions, iteration->leaving.frictions, modes);
    for (size_t k = 0; k < contacts->blows.struck && status == LAG_OK; ++k) {
        const size_t i = (size_t)contacts->blows.order[k];
        status = lag_event_iteration_report(iteration, t, x, LAG_IMPACT, i);
        status = status == LAG_OK ? report_mode(iteration, t, x, i) : status;
    }
    for (size_t i = 0; i < iteration->motion->model->ncontact && status == LAG_OK; ++i) {
        if (contacts->blows.approach[i] == 0.0) {
            any = any || (contacts->blows.before[i] != 0.0) != (*lag_contacts_flag(contacts, i) != 0.0);
            status = report_mode(iteration, t, x, i);
        }
    }
    *acted = *acted || any;
    iteration->instant.acted = iteration->instant.acted || any;
    return status == LAG_OK && any ? lag_projection_rates(iteration->projection, t, x, NULL) : status;
}

lag_status lag_event_iteration_turn_gaps(lag_event_iteration *iteration, double t, const double *x, size_t which)
{
    lag_contacts *contacts = iteration->contacts;
    const size_t count = iteration->motion->model->ncontact;
    double *closed = iteration->motion->w + iteration->places.contact;
    double *truth = iteration->motion->w + iteration->places.relation + which;
    int bends = 0;
    if (!lag_any(count, closed)) {
        return LAG_OK;
    }
    *truth = 1.0 - *truth;
    lag_status status = lag_contacts_evaluate_at(contacts, t, x);
    memcpy(iteration->pulling, contacts->speed, count * sizeof(double));
    *truth = 1.0 - *truth;
    status = status == LAG_OK ? lag_contacts_evaluate_at(contacts, t, x) : status;
    for (size_t i = 0; i < count && status == LAG_OK; ++i) {
        const double speed_band = lag_contacts_speed_band(contacts, i);
        if (closed[i] != 0.0 && fabs(contacts->speed[i] - iteration->pulling[i]) > speed_band) {
            bends = 1;
            closed[i] = contacts->speed[i] >= -speed_band;
        }
    }
    return status == LAG_OK && bends ? lag_event_iteration_open(iteration, t, x) : status;
}

lag_status lag_event_iteration_change_contacts(lag_event_iteration *iteration, double t, double *x, const double *changed)
{
    const lag_model *model = iteration->motion->model;
    const double *closed = iteration->motion->w + iteration->places.contact;
    int acted = 0;
    for (size_t i = 0; i < model->ncontact; ++i) {
        iteration->contacts->blows.met[i] = changed[i] != 0.0 && closed[i] == 0.0;
    }
    memcpy(iteration->leaving.flags, changed, (model->ncontact + model->nfriction) * sizeof(double));
    for (size_t i = 0; i < model->ncontact; ++i) {
        iteration->leaving.flags[i] = changed[i] != 0.0 && closed[i] != 0.0;
    }
    iteration->leaving.left = iteration->leaving.turned ? NULL : iteration->leaving.flags;
    return lag_any(model->ncontact + model->nfriction, changed) ? lag_event_iteration_impact(iteration, t, x, NULL, &acted) : LAG_OK;
}

/* ---- steps of energy in place ---- */

lag_status lag_event_iteration_cross(lag_event_iteration *iteration, double t, double *x, size_t which, int *refracted, int *back)
{
    double *truth = iteration->motion->w + iteration->places.relation;
    const int located = iteration->sides.located != NULL && iteration->sides.located[which] != 0.0;
    const double moment = located ? (double)INFINITY : iteration->instant.moment;
    const lag_status status = lag_refraction_cross(iteration->refraction, t, x, which, moment, refracted, back);
    truth[which] = *back ? truth[which] : 1.0 - truth[which];
    if (status == LAG_CHATTER) {
        iteration->discretes.guilty[iteration->places.relation + which] = 1.0;
    }
    return status == LAG_OK && *refracted ? lag_event_iteration_balance(iteration, t, x) : status;
}
