/* Contacts in passes over clauses: impacts, and what opens or closes where it was found to change. */
#include <math.h>
#include <string.h>

#include "lag/events/instant.h"
#include "lag/linalg/arena.h"
#include "lag/linalg/vector.h"

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
    const lag_model *model = instants->motion->model;
    const size_t count = instants->motion->places.relation - instants->motion->places.contact;
    const int collides = collision != NULL && lag_any(model->ncollision, collision);
    const double *modes = instants->motion->w + instants->motion->places.contact;
    if (!collides && count == 0) {
        return LAG_OK;
    }
    memcpy(instants->leaving.modes, modes, count * sizeof(double));
    lag_status status = lag_contacts_impact(&instants->contacts, t, x, collision, instants->clauses.restitution);
    instants->modes.jumped = instants->modes.jumped || collides || lag_any(model->ncontact, instants->contacts.blows.approach);
    status = status == LAG_OK ? find_modes(instants, t, x) : status;
    const int any = !lag_same(count, instants->leaving.modes, modes); /* counts of impacts are among them */
    *acted = *acted || any || collides;
    return status == LAG_OK && any ? lag_projection_rates(instants->projection, t, x, NULL) : status;
}

lag_status lag_instants_change_contacts(lag_instants *instants, double t, double *x, const double *changed)
{
    const lag_model *model = instants->motion->model;
    const double *closed = instants->motion->w + instants->motion->places.contact;
    for (size_t i = 0; i < model->ncontact; ++i) {
        instants->contacts.blows.met[i] = changed[i] != 0.0 && closed[i] == 0.0;
    }
    for (size_t i = 0; i < model->ncontact + model->nfriction; ++i) {
        instants->leaving.flags[i] = changed[i] != 0.0 && (i >= model->ncontact || closed[i] != 0.0);
    }
    instants->leaving.left = instants->leaving.turned ? NULL : instants->leaving.flags;
    return lag_any(model->ncontact + model->nfriction, changed) ? lag_instants_impact(instants, t, x, NULL, &instants->instant.acted) : LAG_OK;
}
