/* Impacts at contacts. */
#include <math.h>
#include <string.h>

#include "lag/contacts/friction.h"
#include "lag/linalg/arena.h"

enum { MOST_IMPACTS = 10000 };
/* A force below this part of the others is none. */
static const double NOTHING = 1e-9;

/* Closed contacts that carry nothing are opened. */
static lag_status release(lag_contacts *contacts, double t, const double *x)
{
    const size_t count = contacts->motion->model->ncontact;
    const lag_status status = lag_contacts_find_forces(contacts, t, x);
    const int any = lag_any(count, lag_contacts_flag(contacts, 0));
    if (any) {
        lag_motion_try(contacts->motion, t, x);
    }
    for (size_t i = 0; i < count && any; ++i) {
        if (lag_contacts_multiplier(contacts, i) <= NOTHING * contacts->sizes.force[i]) {
            *lag_contacts_flag(contacts, i) = 0.0;
        }
    }
    return status;
}

void lag_contacts_add_to_blow(lag_contacts *contacts, size_t i, double restitution)
{
    const size_t n = contacts->motion->model->nq;
    lag_inequalities_add_normal(&contacts->blows.rows, n, i, contacts->jacobian + i * n, contacts->speed[i], restitution);
}

/* True if contact i has an approach speed beyond round-off, and is closed, or not. */
static int is_driven(const lag_contacts *contacts, size_t i, int closed)
{
    return (*lag_contacts_flag(contacts, i) != 0.0) == closed && contacts->speed[i] < -lag_contacts_speed_band(contacts, i);
}

/* Flags of open contacts that close; whether there are any. *driven: closed ones are driven in. */
static int find_closing(lag_contacts *contacts, int *driven)
{
    *driven = 0;
    for (size_t i = 0; i < contacts->motion->model->ncontact; ++i) {
        contacts->blows.closing[i] = is_driven(contacts, i, 0) && lag_contacts_touches(contacts, i);
        *driven = *driven || is_driven(contacts, i, 1);
    }
    return lag_any(contacts->motion->model->ncontact, contacts->blows.closing);
}

/* Friction under the participants, by what it gains with their impulses. */
static lag_status add_frictions(lag_contacts *contacts)
{
    lag_frictions *frictions = contacts->frictions;
    lag_inequalities *blow = &contacts->blows.rows;
    const lag_model *model = contacts->motion->model;
    const lag_status status = lag_frictions_evaluate(frictions);
    for (size_t k = 0; k < model->nfriction && status == LAG_OK; ++k) {
        const size_t first = (size_t)frictions->first[k];
        const lag_inequalities without = *blow;
        lag_frictions_add(frictions, blow, k, frictions->jacobian + first * model->nq, frictions->slip + first, frictions->gain + k * model->nc);
        if (!lag_any(blow->normals, blow->coefficients + without.frictions * blow->normals)) {
            *blow = without; /* it lets go */
        }
    }
    return status;
}

/* 1: something strikes or drives in the component of contact i. */
static int is_hit(const lag_contacts *contacts, size_t i)
{
    const lag_model *model = contacts->motion->model;
    const lag_inequalities *rows = &contacts->blows.rows;
    size_t k = 0;
    while (k < rows->normals && lag_row_component(model, rows->rows + k * model->nq) != lag_contacts_component(contacts, i)) {
        ++k;
    }
    return k < rows->normals;
}

/* Collects the participants: contacts that close or are driven in, impacts of clauses, and closed contacts, which hold, of their components; friction under them. */
static lag_status gather(lag_contacts *contacts, const double *collision, const double *restitution)
{
    const lag_model *model = contacts->motion->model;
    lag_blows *blows = &contacts->blows;
    lag_inequalities_clear(&blows->rows);
    for (size_t i = 0; i < model->ncontact; ++i) {
        if (blows->closing[i] != 0.0 || is_driven(contacts, i, 1)) {
            lag_contacts_add_to_blow(contacts, i, blows->closing[i] != 0.0 ? contacts->restitution[i] : 0.0);
        }
        if (blows->closing[i] != 0.0 && blows->approach[i] == 0.0) {
            blows->approach[i] = contacts->speed[i];
        }
    }
    for (size_t i = 0; collision != NULL && i < model->ncollision; ++i) {
        if (collision[i] != 0.0) {
            lag_contacts_add_to_blow(contacts, model->ncontact + i, restitution[i]);
        }
    }
    for (size_t i = 0; i < model->ncontact; ++i) {
        if (*lag_contacts_flag(contacts, i) != 0.0 && !is_driven(contacts, i, 1) && is_hit(contacts, i)) {
            lag_contacts_add_to_blow(contacts, i, 0.0);
        }
    }
    return model->nfriction > 0 ? add_frictions(contacts) : LAG_OK;
}

void lag_contacts_keep_blow(lag_contacts *contacts)
{
    for (size_t i = 0; i < contacts->blows.rows.normals; ++i) {
        const size_t contact = lag_gap_of(&contacts->blows.rows, i);
        if (contact < contacts->motion->model->ncontact) {
            contacts->blows.compliance[contact] = contacts->blows.rows.compliance[i];
            contacts->sizes.blow[contact] = fmax(contacts->sizes.blow[contact], contacts->blows.rows.scale[i]);
        }
    }
}

/* Impacts until nothing closes any more. */
static lag_status solve_impacts(lag_contacts *contacts, double t, double *x, const double *collision, const double *restitution)
{
    const size_t collisions = collision != NULL ? contacts->motion->model->ncollision : 0;
    for (int k = 0; k < MOST_IMPACTS; ++k) {
        const int struck = k == 0 && lag_any(collisions, collision);
        int driven = 0;
        lag_status status = lag_contacts_evaluate_at(contacts, t, x);
        const int strikes = status == LAG_OK && (find_closing(contacts, &driven) || struck);
        if (status != LAG_OK || (!strikes && !driven)) {
            return status;
        }
        status = strikes && !lag_any(contacts->motion->model->ncontact, contacts->blows.approach) ? release(contacts, t, x) : LAG_OK;
        status = status == LAG_OK ? gather(contacts, struck ? collision : NULL, restitution) : status;
        status = status == LAG_OK ? lag_impulse_impact(contacts->impulse, t, x, &contacts->blows.rows) : status;
        if (status != LAG_OK) {
            return status;
        }
        lag_contacts_keep_blow(contacts);
    }
    return LAG_EVENT_ITERATION_FAILED;
}

lag_status lag_contacts_open(lag_contacts *contacts, double t, const double *x, int corner)
{
    const size_t count = contacts->motion->model->ncontact;
    if (!lag_any(count, lag_contacts_flag(contacts, 0))) {
        return LAG_OK;
    }
    const lag_status status = lag_contacts_evaluate_at(contacts, t, x);
    for (size_t i = 0; i < count && status == LAG_OK; ++i) {
        const double parting = corner ? fabs(contacts->speed[i]) : contacts->speed[i];
        if (!lag_contacts_touches(contacts, i) || parting > lag_contacts_speed_band(contacts, i)) {
            *lag_contacts_flag(contacts, i) = 0.0;
        }
    }
    return status;
}

int lag_contacts_are_at_rest(lag_contacts *contacts, double t, const double *x)
{
    const size_t count = contacts->motion->model->ncontact;
    int hold = !lag_any(count, lag_contacts_flag(contacts, 0)) || lag_contacts_evaluate_at(contacts, t, x) == LAG_OK;
    for (size_t i = 0; i < count && hold; ++i) {
        hold = *lag_contacts_flag(contacts, i) == 0.0 || fabs(contacts->speed[i]) <= lag_contacts_speed_band(contacts, i);
    }
    return hold;
}

lag_status lag_contacts_impact(
    lag_contacts *contacts, double t, double *x, const double *collision, const double *restitution)
{
    const size_t count = contacts->motion->model->ncontact;
    memset(contacts->blows.approach, 0, count * sizeof(double));
    memcpy(contacts->blows.before, lag_contacts_flag(contacts, 0), count * sizeof(double));
    const lag_status status = solve_impacts(contacts, t, x, collision, restitution);
    return status == LAG_OK ? lag_contacts_accumulate(contacts, t, x) : status;
}
