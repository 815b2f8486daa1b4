/* Impacts at contacts, and what is closed afterwards. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "lag/contacts/friction.h"
#include "lag/linalg/arena.h"

enum { MOST_IMPACTS = 10000 };
/* Bounces are too short to follow where what is left of them takes less than this part of the experiment, */
static const double REST = 1e-6;
/* or where the next one takes less than this part of that. */
static const double NEXT = 1e-3;
/* Steps of fixed length cannot tell bounces that take less than so many of them. */
static const double STEPS = 2.0;
/* A force below this part of the others is none. */
static const double NOTHING = 1e-9;
/* A rebound slower than this part of the approach is none. */
static const double REBOUND = 1e-12;

static double *flag(const lag_contacts *contacts, size_t i)
{
    return lag_contacts_flag(contacts, i);
}

/* Closed contacts that carry nothing are opened. */
static lag_status release(lag_contacts *contacts, double t, const double *x)
{
    const size_t count = contacts->motion->model->ncontact;
    const lag_status status = lag_contacts_weigh(contacts, t, x);
    const int any = lag_any(count, flag(contacts, 0));
    if (any) {
        lag_contacts_solve(contacts, t, x);
    }
    for (size_t i = 0; i < count && any; ++i) {
        if (lag_contacts_multiplier(contacts, i) <= NOTHING * contacts->force[i]) {
            *flag(contacts, i) = 0.0;
        }
    }
    return status;
}

static void add(lag_contacts *contacts, size_t i, double restitution)
{
    const size_t n = contacts->motion->model->nq;
    lag_inequalities_add_normal(&contacts->blow, n, contacts->jacobian + i * n, contacts->speed[i], restitution);
}

/* True if contact i touches: it was located so at this instant, or its gap is zero. */
static int touches(const lag_contacts *contacts, size_t i)
{
    return contacts->met[i] != 0.0 || contacts->gap[i] <= lag_contacts_touch(contacts, i);
}

/* Flags of open contacts that close; whether there are any. */
static int find_closing(lag_contacts *contacts)
{
    int any = 0;
    for (size_t i = 0; i < contacts->motion->model->ncontact; ++i) {
        const int closing = touches(contacts, i) && *flag(contacts, i) == 0.0 && contacts->speed[i] < -lag_contacts_creep(contacts, i);
        contacts->closing[i] = closing;
        any = any || closing;
    }
    return any;
}

/* True if contact i is closed and has an approach speed beyond round-off. */
static int is_driven(const lag_contacts *contacts, size_t i)
{
    return *flag(contacts, i) != 0.0 && contacts->speed[i] < -lag_contacts_creep(contacts, i);
}

static int any_driven(const lag_contacts *contacts)
{
    size_t i = 0;
    while (i < contacts->motion->model->ncontact && !is_driven(contacts, i)) {
        ++i;
    }
    return i < contacts->motion->model->ncontact;
}

/* The component of the mechanism that gap i belongs to. */
static size_t component_of(const lag_contacts *contacts, size_t i)
{
    const lag_model *model = contacts->motion->model;
    return lag_row_component(model, contacts->jacobian + i * model->nq);
}

/* Contacts that close. */
static void add_closing(lag_contacts *contacts)
{
    for (size_t i = 0; i < contacts->motion->model->ncontact; ++i) {
        if (contacts->closing[i] != 0.0) {
            contacts->part[contacts->blow.normals] = (double)i;
            add(contacts, i, contacts->restitution[i]);
            contacts->hit[component_of(contacts, i)] = 1.0;
            if (contacts->approach[i] == 0.0) {
                contacts->approach[i] = contacts->speed[i];
                contacts->order[contacts->struck++] = (double)i;
            }
        }
    }
}

/* The row of the constraints that participant i is while it is closed; nc for an impact of a clause. Gaps are as these rows are. */
static size_t row_of(const lag_contacts *contacts, size_t i)
{
    const lag_model *model = contacts->motion->model;
    const size_t contact = (size_t)contacts->part[i];
    return contact < model->ncontact ? model->contact_rows[contact] : model->nc;
}

/* Friction under the participants, by what it gains with their impulses. */
static lag_status add_frictions(lag_contacts *contacts)
{
    lag_frictions *frictions = contacts->frictions;
    lag_inequalities *blow = &contacts->blow;
    const lag_model *model = contacts->motion->model;
    const lag_status status = lag_frictions_look(frictions);
    for (size_t k = 0; k < model->nfriction && status == LAG_OK; ++k) {
        const double *gain = frictions->gain + k * model->nc;
        const size_t first = (size_t)frictions->first[k];
        int any = 0;
        for (size_t i = 0; i < blow->normals; ++i) {
            any = any || (row_of(contacts, i) < model->nc && gain[row_of(contacts, i)] != 0.0);
        }
        if (any) {
            const size_t number = lag_inequalities_add_friction(
                blow, model->nq, lag_frictions_components(frictions, k), frictions->jacobian + first * model->nq, frictions->slip + first);
            for (size_t i = 0; i < blow->normals; ++i) {
                blow->coefficients[number * blow->normals + i] = row_of(contacts, i) < model->nc ? gain[row_of(contacts, i)] : 0.0;
            }
        }
    }
    return status;
}

/*
 * Collects the participants: contacts that close, impacts of clauses, and closed contacts, which hold, of the components in which
 * something strikes or drives; friction under them.
 */
static lag_status gather(lag_contacts *contacts, const double *collision, const double *restitution)
{
    const lag_model *model = contacts->motion->model;
    memset(contacts->hit, 0, (model->nq + model->nz) * sizeof(double));
    lag_inequalities_clear(&contacts->blow);
    add_closing(contacts);
    for (size_t i = 0; collision != NULL && i < model->ncollision; ++i) {
        if (collision[i] != 0.0) {
            contacts->part[contacts->blow.normals] = (double)(model->ncontact + i);
            add(contacts, model->ncontact + i, restitution[i]);
            contacts->hit[component_of(contacts, model->ncontact + i)] = 1.0;
        }
    }
    for (size_t i = 0; i < model->ncontact; ++i) {
        if (is_driven(contacts, i)) {
            contacts->hit[component_of(contacts, i)] = 1.0;
        }
    }
    for (size_t i = 0; i < model->ncontact; ++i) {
        if (*flag(contacts, i) != 0.0 && contacts->closing[i] == 0.0 && contacts->hit[component_of(contacts, i)] != 0.0) {
            contacts->part[contacts->blow.normals] = (double)i;
            add(contacts, i, 0.0);
        }
    }
    return model->nfriction > 0 ? add_frictions(contacts) : LAG_OK;
}

/* Blows until nothing closes any more. */
static lag_status strike(lag_contacts *contacts, double t, double *x, const double *collision, const double *restitution)
{
    const size_t collisions = collision != NULL ? contacts->motion->model->ncollision : 0;
    for (int k = 0; k < MOST_IMPACTS; ++k) {
        const int struck = k == 0 && lag_any(collisions, collision);
        lag_status status = lag_contacts_look(contacts, t, x);
        if (status == LAG_OK && (find_closing(contacts) || struck) && contacts->struck == 0) {
            status = release(contacts, t, x);
        }
        if (status != LAG_OK) {
            return status;
        }
        if (!lag_any(contacts->motion->model->ncontact, contacts->closing) && !struck && !any_driven(contacts)) {
            return LAG_OK;
        }
        status = gather(contacts, struck ? collision : NULL, restitution);
        status = status == LAG_OK ? lag_impulse_strike(contacts->impulse, t, x, &contacts->blow) : status;
        if (status != LAG_OK) {
            return status;
        }
    }
    return LAG_EVENT_ITERATION_FAILED;
}

/* ---- what stays ---- */

/*
 * Accelerations of the gaps of contacts flagged in `closing`, while they are open: rows of the constraints that they would be, with the
 * accelerations that there are without them.
 */
static void fly(lag_contacts *contacts, double t, const double *x)
{
    lag_motion *motion = contacts->motion;
    lag_impulse *impulse = contacts->impulse;
    const lag_model *model = motion->model;
    lag_contacts_solve(contacts, t, x);
    memcpy(impulse->w, motion->w, model->nw * sizeof(double));
    for (size_t i = 0; i < model->ncontact; ++i) {
        double *opened = impulse->w + contacts->places.contact + i;
        *opened = contacts->closing[i] != 0.0 ? 1.0 : *opened;
    }
    motion->at.w = impulse->w;
    const lag_status status = model->dynamics(&motion->at, impulse->mass, impulse->size, impulse->jacobian, impulse->residual);
    motion->at.w = motion->w;
    for (size_t i = 0; i < model->ncontact; ++i) {
        const size_t row = model->contact_rows[i];
        double acceleration = -impulse->residual[row];
        for (size_t j = 0; j < model->nq; ++j) {
            acceleration += impulse->jacobian[row * model->nq + j] * motion->qdd[j];
        }
        contacts->back[i] = status == LAG_OK ? acceleration : 0.0;
    }
}

/* True if a contact that flies so long and begins with its present speed does not get clear of its gap's round-off, or of a step. */
static int is_lost(const lag_contacts *contacts, size_t i, double flight)
{
    return 0.125 * flight * contacts->speed[i] < lag_contacts_gap_noise(contacts, i) || flight < STEPS * contacts->flight;
}

int lag_contacts_are_brief(const lag_contacts *contacts, size_t i, double flight, double ratio)
{
    const double brief = contacts->zeno_time[i] >= 0.0 ? contacts->zeno_time[i] : REST * contacts->length;
    return (ratio < 1.0 && flight < brief * (1.0 - ratio)) || flight < NEXT * brief || flight < STEPS * contacts->flight;
}

/* True if a contact that struck stays closed; also sets the time at which it comes to rest. */
static int stays(lag_contacts *contacts, double t, size_t i)
{
    const double speed = contacts->speed[i];
    const double ratio = speed / -contacts->approach[i];
    contacts->until[i] = (double)INFINITY;
    if (speed <= fmax(lag_contacts_creep(contacts, i), REBOUND * -contacts->approach[i])) {
        return 1;
    }
    if (contacts->capture_speed[i] >= 0.0 && speed < contacts->capture_speed[i]) {
        return 1;
    }
    if (!(contacts->back[i] < 0.0)) {
        return 0;
    }
    const double flight = 2.0 * speed / -contacts->back[i];
    const double left = ratio < 1.0 ? flight / (1.0 - ratio) : (double)INFINITY;
    if (!is_lost(contacts, i, flight) && !lag_contacts_are_brief(contacts, i, flight, ratio)) {
        return 0;
    }
    const double rest = t + fmin(left, flight / NEXT);
    contacts->until[i] = contacts->flight > 0.0 || !(rest > t) ? (double)INFINITY : rest;
    return 1;
}

lag_status lag_contacts_part(lag_contacts *contacts, double t, const double *x)
{
    const size_t count = contacts->motion->model->ncontact;
    if (!lag_any(count, flag(contacts, 0))) {
        return LAG_OK;
    }
    const lag_status status = lag_contacts_look(contacts, t, x);
    for (size_t i = 0; i < count && status == LAG_OK; ++i) {
        if (!touches(contacts, i) || contacts->speed[i] > lag_contacts_creep(contacts, i)) {
            *flag(contacts, i) = 0.0;
        }
    }
    return status;
}

int lag_contacts_hold(lag_contacts *contacts, double t, const double *x)
{
    const size_t count = contacts->motion->model->ncontact;
    int hold = !lag_any(count, flag(contacts, 0)) || lag_contacts_look(contacts, t, x) == LAG_OK;
    for (size_t i = 0; i < count && hold; ++i) {
        hold = *flag(contacts, i) == 0.0 || fabs(contacts->speed[i]) <= lag_contacts_creep(contacts, i);
    }
    return hold;
}

/* Contacts that were closed and that blows at others open, as of a box that rocks, stay closed where their flights are lost. */
static lag_status keep(lag_contacts *contacts, double t, const double *x)
{
    const size_t count = contacts->motion->model->ncontact;
    for (size_t i = 0; i < count; ++i) {
        contacts->closing[i] = contacts->before[i] != 0.0 && *flag(contacts, i) == 0.0;
    }
    if (contacts->struck == 0 || !lag_any(count, contacts->closing)) {
        return LAG_OK;
    }
    const lag_status status = lag_contacts_look(contacts, t, x);
    fly(contacts, t, x);
    for (size_t i = 0; i < count && status == LAG_OK; ++i) {
        const int falls = contacts->closing[i] != 0.0 && contacts->speed[i] > 0.0 && contacts->back[i] < 0.0;
        *flag(contacts, i) = falls && touches(contacts, i) && is_lost(contacts, i, 2.0 * contacts->speed[i] / -contacts->back[i]) ? 1.0 : *flag(contacts, i);
    }
    return status;
}

/* Contacts closed after impacts: those that were closed and those that struck, if they stay. */
static lag_status conclude(lag_contacts *contacts, double t, const double *x)
{
    const size_t count = contacts->motion->model->ncontact;
    for (size_t i = 0; i < count; ++i) {
        *flag(contacts, i) = contacts->before[i] != 0.0 ? 1.0 : *flag(contacts, i);
    }
    lag_status status = lag_contacts_part(contacts, t, x);
    if (status == LAG_OK && contacts->struck > 0) {
        status = lag_contacts_look(contacts, t, x);
        lag_fill(count, 0.0, contacts->closing);
        for (size_t k = 0; k < contacts->struck; ++k) {
            contacts->closing[(size_t)contacts->order[k]] = 1.0;
        }
        fly(contacts, t, x);
    }
    for (size_t k = 0; k < contacts->struck && status == LAG_OK; ++k) {
        const size_t i = (size_t)contacts->order[k];
        contacts->motion->w[contacts->places.impacts + i] += 1.0;
        contacts->closing[i] = stays(contacts, t, i);
    }
    for (size_t k = 0; k < contacts->struck && status == LAG_OK; ++k) {
        const size_t i = (size_t)contacts->order[k];
        *flag(contacts, i) = contacts->closing[i] != 0.0 ? 1.0 : *flag(contacts, i);
    }
    return status == LAG_OK ? keep(contacts, t, x) : status;
}

lag_status lag_contacts_strike(
    lag_contacts *contacts, double t, double *x, const double *collision, const double *restitution)
{
    const size_t count = contacts->motion->model->ncontact;
    contacts->struck = 0;
    memset(contacts->approach, 0, count * sizeof(double));
    memcpy(contacts->before, flag(contacts, 0), count * sizeof(double));
    const lag_status status = strike(contacts, t, x, collision, restitution);
    return status == LAG_OK ? conclude(contacts, t, x) : status;
}
