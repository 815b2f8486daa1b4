/*
 * Contacts behind the impacts of an instant. A contact that does not part is closed. Bounces that accumulate are held (docs/explanation/hybrid_model.md).
 *
 * Speeds of contacts are compared by the energies that would stop them, u^2/(2 W): a gap may be a length or an angle. A contact that parts at u and comes
 * back with the acceleration a flies for 2 u/a.
 *
 * Source: G. W. Housner, Bull. Seismol. Soc. Am. 53 (1963) 403 (a rocking block loses the same part of its rate in each blow); Pfeiffer, Glocker, Multibody
 * Dynamics with Unilateral Contacts (1996), chapter 8.
 */
#include <math.h>
#include <stdint.h>
#include <string.h>

#include "lag/contacts/friction.h"
#include "lag/linalg/arena.h"
#include "lag/linalg/vector.h"

/* Bounces are too short to follow where what is left of them takes less than this part of the experiment, */
static const double REST = 1e-6;
/* or where the next one takes less than this part of that. */
static const double NEXT = 1e-3;
/* Steps of fixed length cannot tell bounces that take less than so many of them. */
static const double STEPS = 2.0;

typedef struct series {
    size_t component;
    double approach, parting; /* the fastest */
    double left;              /* until the last of its flights [s] */
    int brief;                /* they are too short to follow */
} series;

static int parts(const lag_contacts *contacts, size_t i)
{
    const int is_captured = contacts->blows.approach[i] != 0.0 && contacts->speed[i] < contacts->capture_speed[i];
    return contacts->speed[i] > lag_contacts_speed_band(contacts, i) && !is_captured;
}

/* A speed of contact i as the square root of twice the energy that stops it. */
static double size_of(const lag_contacts *contacts, size_t i, double speed)
{
    return contacts->blows.compliance[i] > 0.0 ? fabs(speed) / sqrt(contacts->blows.compliance[i]) : 0.0;
}

/*
 * Accelerations of the gaps of contacts flagged in `closing`, while they are open: rows of the constraints that they would be, with the
 * accelerations that there are without them.
 */
static void find_return_accelerations(lag_contacts *contacts, double t, const double *x)
{
    lag_motion *motion = contacts->motion;
    lag_impulse *impulse = contacts->impulse;
    const lag_model *model = motion->model;
    lag_motion_try(contacts->motion, t, x);
    memcpy(impulse->w, motion->w, model->nw * sizeof(double));
    for (size_t i = 0; i < model->ncontact; ++i) {
        double *opened = impulse->w + contacts->motion->places.contact + i;
        *opened = contacts->blows.closing[i] != 0.0 ? 1.0 : *opened;
    }
    motion->at.w = impulse->w;
    const lag_status status = model->dynamics(&motion->at, impulse->mass, impulse->size, impulse->jacobian, impulse->residual);
    motion->at.w = motion->w;
    for (size_t i = 0; i < model->ncontact; ++i) {
        const size_t row = model->contact_rows[i];
        contacts->blows.back[i] = 0.0;
        if (status == LAG_OK && contacts->blows.closing[i] != 0.0) {
            contacts->blows.back[i] = lag_dot(model->nq, impulse->jacobian + row * model->nq, motion->qdd) - impulse->residual[row];
        }
    }
}

/* True if a flight does not get clear of what hides it, or of a step, or if what is left of them, each `ratio` of the one before, is brief. */
static int is_brief(const lag_contacts *contacts, size_t i, double flight, double ratio)
{
    const double brief = contacts->zeno_time[i] >= 0.0 ? contacts->zeno_time[i] : REST * contacts->length;
    const double hidden = fmax(lag_contacts_gap_noise(contacts, i), 0.5 * contacts->hidden[i]);
    return 0.125 * flight * contacts->speed[i] < hidden || flight < fmax(STEPS * contacts->flight, brief * fmax(1.0 - ratio, NEXT));
}

/* The series of the bounces in the component of a contact that parts. */
static series series_of(const lag_contacts *contacts, size_t component)
{
    const size_t count = contacts->motion->model->ncontact;
    series all = {.component = component, .brief = 1};
    for (size_t i = 0; i < count; ++i) {
        if ((contacts->blows.approach[i] != 0.0 || contacts->blows.closing[i] != 0.0) && lag_contacts_component(contacts, i) == component) {
            all.approach = fmax(all.approach, size_of(contacts, i, contacts->blows.approach[i]));
            all.parting = fmax(all.parting, contacts->blows.closing[i] != 0.0 ? size_of(contacts, i, contacts->speed[i]) : 0.0);
        }
    }
    const double ratio = all.approach > 0.0 ? all.parting / all.approach : 1.0;
    for (size_t i = 0; i < count && all.brief; ++i) {
        if (contacts->blows.closing[i] != 0.0 && lag_contacts_component(contacts, i) == component) {
            const double back = contacts->blows.back[i];
            const double flight = back < 0.0 ? 2.0 * contacts->speed[i] / -back : (double)INFINITY; /* it may not come back */
            all.brief = is_brief(contacts, i, flight, ratio);
            all.left = fmax(all.left, flight / fmax(1.0 - ratio, NEXT));
        }
    }
    return all;
}

/* Holds what parts with flights that are too short to follow; struck contacts are told to be closed at the limit of their series. */
static void hold_brief(lag_contacts *contacts, double t)
{
    series last = {.component = SIZE_MAX};
    for (size_t i = 0; i < contacts->motion->model->ncontact; ++i) {
        const int struck = contacts->blows.approach[i] != 0.0;
        if (!struck && contacts->blows.closing[i] == 0.0) {
            continue;
        }
        const size_t component = lag_contacts_component(contacts, i);
        last = component == last.component ? last : series_of(contacts, component);
        if (last.parting > 0.0 && last.brief) {
            const double rest = t + last.left;
            *lag_contacts_flag(contacts, i) = 1.0;
            contacts->until[i] = struck && !(contacts->flight > 0.0) && rest > t ? rest : (double)INFINITY;
        }
    }
}

lag_status lag_contacts_accumulate(lag_contacts *contacts, double t, const double *x)
{
    const size_t count = contacts->motion->model->ncontact;
    for (size_t i = 0; i < count; ++i) {
        *lag_contacts_flag(contacts, i) = contacts->blows.before[i] != 0.0 ? 1.0 : *lag_contacts_flag(contacts, i);
    }
    lag_status status = lag_contacts_open(contacts, t, x, 0);
    if (!lag_any(count, contacts->blows.approach) || status != LAG_OK) {
        return status;
    }
    status = lag_contacts_evaluate_at(contacts, t, x);
    for (size_t i = 0; i < count && status == LAG_OK; ++i) {
        const int struck = contacts->blows.approach[i] != 0.0;
        const int opened = contacts->blows.before[i] != 0.0 && *lag_contacts_flag(contacts, i) == 0.0 && lag_contacts_touches(contacts, i);
        contacts->blows.closing[i] = (struck || opened) && parts(contacts, i);
        contacts->until[i] = struck ? (double)INFINITY : contacts->until[i];
        contacts->motion->w[contacts->motion->places.impacts + i] += struck;
        *lag_contacts_flag(contacts, i) = struck && contacts->blows.closing[i] == 0.0 ? 1.0 : *lag_contacts_flag(contacts, i);
    }
    if (status == LAG_OK && lag_any(count, contacts->blows.closing)) {
        find_return_accelerations(contacts, t, x);
        hold_brief(contacts, t);
    }
    return status;
}
