/* Contacts in passes over clauses: impacts, and what opens or closes where it was found to change. */
#include <math.h>
#include <string.h>

#include "lag/events/instant.h"
#include "lag/linalg/arena.h"
#include "lag/linalg/vector.h"

lag_status lag_instants_report_contact(const lag_instants *instants, double t, const double *x, lag_event_kind what, size_t i)
{
    instants->contacts.until[i] = (double)INFINITY;
    return lag_instants_report(instants, t, x, what, i);
}

/* Reports that a contact has opened or closed, if it has; one that is held for the rest of its bounces closes at their end. */
static lag_status report_mode(const lag_instants *instants, double t, const double *x, size_t i)
{
    const lag_contacts *contacts = &instants->contacts;
    const int before = contacts->blows.before[i] != 0.0;
    const int now = *lag_contacts_flag(contacts, i) != 0.0;
    const int bounces = now && contacts->until[i] < (double)INFINITY;
    return before == now || bounces ? LAG_OK : lag_instants_report_contact(instants, t, x, now ? LAG_CLOSED : LAG_OPENED, i);
}

/* Modes of contacts that are closed, or have met without approach speed, and of friction. */
static lag_status find_modes(lag_instants *instants, double t, const double *x)
{
    lag_contacts *contacts = &instants->contacts;
    for (size_t i = 0; i < instants->motion->model->ncontact; ++i) {
        contacts->blows.closing[i] = contacts->blows.met[i] != 0.0 && contacts->blows.approach[i] == 0.0 && contacts->speed[i] <= lag_contacts_speed_band(contacts, i);
    }
    const lag_status status = lag_modes_find(&instants->modes, t, x, contacts->blows.closing, instants->leaving.left);
    instants->leaving.left = NULL;
    return status;
}

lag_status lag_instants_impact(lag_instants *instants, double t, double *x, const double *collision, int *acted)
{
    const lag_contacts *contacts = &instants->contacts;
    const size_t frictions = instants->motion->model->nfriction + instants->motion->model->nslip;
    const double *modes = instants->motion->w + instants->motion->places.sticks;
    memcpy(instants->leaving.frictions, modes, frictions * sizeof(double));
    lag_status status = lag_contacts_impact(&instants->contacts, t, x, collision, instants->clauses.restitution);
    instants->modes.jumped = instants->modes.jumped || contacts->blows.struck > 0 ||
        (collision != NULL && lag_any(instants->motion->model->ncollision, collision));
    status = status == LAG_OK ? find_modes(instants, t, x) : status;
    int any = contacts->blows.struck > 0 || !lag_same(frictions, instants->leaving.frictions, modes);
    for (size_t k = 0; k < contacts->blows.struck && status == LAG_OK; ++k) {
        const size_t i = (size_t)contacts->blows.order[k];
        status = lag_instants_report(instants, t, x, LAG_IMPACT, i);
        status = status == LAG_OK ? report_mode(instants, t, x, i) : status;
    }
    for (size_t i = 0; i < instants->motion->model->ncontact && status == LAG_OK; ++i) {
        if (contacts->blows.approach[i] == 0.0) {
            any = any || (contacts->blows.before[i] != 0.0) != (*lag_contacts_flag(contacts, i) != 0.0);
            status = report_mode(instants, t, x, i);
        }
    }
    *acted = *acted || any;
    instants->instant.acted = instants->instant.acted || any;
    return status == LAG_OK && any ? lag_projection_rates(instants->projection, t, x, NULL) : status;
}

lag_status lag_instants_turn_gaps(lag_instants *instants, double t, const double *x)
{
    lag_contacts *contacts = &instants->contacts;
    const size_t count = instants->motion->model->ncontact;
    double *closed = instants->motion->w + instants->motion->places.contact;
    lag_status status = lag_any(count, closed) ? lag_contacts_evaluate_at(contacts, t, x) : LAG_OK;
    for (size_t i = 0; i < count && status == LAG_OK; ++i) {
        closed[i] *= contacts->speed[i] >= -lag_contacts_speed_band(contacts, i);
    }
    return status == LAG_OK ? lag_instants_open(instants, t, x) : status;
}

lag_status lag_instants_change_contacts(lag_instants *instants, double t, double *x, const double *changed)
{
    const lag_model *model = instants->motion->model;
    const double *closed = instants->motion->w + instants->motion->places.contact;
    int acted = 0;
    for (size_t i = 0; i < model->ncontact; ++i) {
        instants->contacts.blows.met[i] = changed[i] != 0.0 && closed[i] == 0.0;
    }
    memcpy(instants->leaving.flags, changed, (model->ncontact + model->nfriction) * sizeof(double));
    for (size_t i = 0; i < model->ncontact; ++i) {
        instants->leaving.flags[i] = changed[i] != 0.0 && closed[i] != 0.0;
    }
    instants->leaving.left = instants->leaving.turned ? NULL : instants->leaving.flags;
    return lag_any(model->ncontact + model->nfriction, changed) ? lag_instants_impact(instants, t, x, NULL, &acted) : LAG_OK;
}
