#include "lag/contact.h"

#include <math.h>
#include <string.h>

#include "lag/memory.h"

enum { MOST_IMPACTS = 10000 };
/* Parts of the largest approach speed so far and of the length of the experiment. */
static const double STICK = 1e-3;
static const double REST = 1e-6;
/* A gap, or its rate, is zero where an event is looked at below this part of the size of the state. */
static const double TOUCHING = 1e-9;
/* What is below this part of the size of the state, or of the forces, is round-off and no event. */
static const double ROUNDING = 1e-13;
/* A force below this part of the others is none: what only touches hands a blow on, what carries takes part as it is. */
static const double NOTHING = 1e-9;

size_t lag_contacts_memory(const lag_model *model)
{
    return 10 * model->ncontact + (5 + 2 * model->nq) * model->ngap + 2 * model->nq + lag_impact_memory(model);
}

static void place_gaps(lag_contacts *contacts, const lag_model *model, double **memory)
{
    contacts->gap = lag_take(memory, model->ngap);
    contacts->speed = lag_take(memory, model->ngap);
    contacts->jacobian = lag_take(memory, model->ngap * model->nq);
    contacts->part = lag_take(memory, model->ngap);
    contacts->rows = lag_take(memory, model->ngap * model->nq);
    contacts->speeds = lag_take(memory, model->ngap);
    contacts->factor = lag_take(memory, model->ngap);
}

void lag_contacts_place(lag_contacts *contacts, lag_motion *motion, double *memory)
{
    const lag_model *model = motion->model;
    const size_t count = model->ncontact;
    memset(contacts, 0, sizeof *contacts);
    contacts->motion = motion;
    contacts->places = lag_places_of(model);
    contacts->slack[0] = ROUNDING;
    place_gaps(contacts, model, &memory);
    contacts->fastest = lag_take(&memory, count);
    contacts->last = lag_take(&memory, count);
    contacts->restitution = lag_take(&memory, count);
    contacts->stick = lag_take(&memory, count);
    contacts->rest = lag_take(&memory, count);
    contacts->approach = lag_take(&memory, count);
    contacts->order = lag_take(&memory, count);
    contacts->closing = lag_take(&memory, count);
    contacts->before = lag_take(&memory, count);
    contacts->slow = lag_take(&memory, count);
    contacts->tau = lag_take(&memory, model->nq);
    contacts->zero = lag_take(&memory, model->nq);
    for (size_t i = 0; i < count; ++i) {
        contacts->fastest[i] = 0.0;
        contacts->last[i] = -(double)INFINITY;
    }
    memset(contacts->zero, 0, model->nq * sizeof(double));
    lag_impact_place(&contacts->impact, motion, memory);
}

double lag_contacts_size(const lag_motion *motion, const double *x)
{
    double most = 0.0;
    for (size_t i = 0; i < lag_motion_size(motion->model); ++i) {
        most = fmax(most, fabs(x[i]));
    }
    return 1.0 + most;
}

/* ---- what holds at a state ---- */

static double *flag(const lag_contacts *contacts, size_t i)
{
    return contacts->motion->w + contacts->places.contact + i;
}

static lag_status look(lag_contacts *contacts, double t, const double *x)
{
    lag_motion *motion = contacts->motion;
    lag_motion_look(motion, t, x);
    return motion->model->contact(&motion->at, contacts->gap, contacts->speed, contacts->jacobian, contacts->restitution,
        contacts->stick, contacts->rest);
}

static double multiplier(const lag_contacts *contacts, size_t i)
{
    return contacts->motion->lam[contacts->motion->model->contact_rows[i]];
}

/* What is no number pulls. */
static double push(const lag_contacts *contacts, size_t i)
{
    const double force = multiplier(contacts, i);
    return force == force ? force : -(double)INFINITY;
}

static double largest(size_t count, const double *x)
{
    double most = 0.0;
    for (size_t i = 0; i < count; ++i) {
        most = fmax(most, fabs(x[i]));
    }
    return most;
}

/* The multipliers; no numbers where there are none. */
static void solve(lag_contacts *contacts, double t, const double *x)
{
    lag_motion *motion = contacts->motion;
    if (lag_motion_solve(motion, t, x) != LAG_OK) {
        for (size_t i = 0; i < motion->model->nc; ++i) {
            motion->lam[i] = (double)NAN;
        }
    }
}

/* The largest multiplier that what acts now would give a contact by itself; gaps have been looked at. */
static lag_status weigh(lag_contacts *contacts, double t, const double *x, double *force)
{
    lag_motion *motion = contacts->motion;
    const lag_model *model = motion->model;
    lag_motion_look(motion, t, x);
    motion->at.qdd = contacts->zero;
    const lag_status status = model->inverse_dynamics(&motion->at, contacts->tau);
    motion->at.qdd = motion->qdd;
    *force = largest(model->nq, contacts->tau) / fmax(largest(model->ngap * model->nq, contacts->jacobian), 1e-300);
    return status;
}

static void set_force(lag_contacts *contacts, double force)
{
    contacts->force = force;
    contacts->slack[1] = ROUNDING * force;
}

/* ---- at rest ---- */

int lag_contacts_pierced(lag_contacts *contacts, double t, const double *x, double *flags)
{
    const size_t count = contacts->motion->model->ncontact;
    const double least = -TOUCHING * lag_contacts_size(contacts->motion, x);
    int any = 0;
    if (count == 0 || look(contacts, t, x) != LAG_OK) {
        return 0;
    }
    for (size_t i = 0; i < count; ++i) {
        flags[i] = contacts->gap[i] < least;
        any = any || flags[i] != 0.0;
    }
    return any;
}

lag_status lag_contacts_settle(lag_contacts *contacts, double t, const double *x)
{
    const size_t count = contacts->motion->model->ncontact;
    const double least = TOUCHING * lag_contacts_size(contacts->motion, x);
    double force = 0.0;
    lag_status status = count > 0 ? look(contacts, t, x) : LAG_OK;
    if (status != LAG_OK || count == 0) {
        return status;
    }
    status = weigh(contacts, t, x, &force);
    set_force(contacts, force);
    for (size_t i = 0; i < count; ++i) {
        contacts->closing[i] = fabs(contacts->gap[i]) <= least && fabs(contacts->speed[i]) <= least;
    }
    if (status == LAG_OK) {
        lag_contacts_press(contacts, t, x, contacts->closing);
    }
    return status;
}

void lag_contacts_press(lag_contacts *contacts, double t, const double *x, const double *candidates)
{
    const size_t count = contacts->motion->model->ncontact;
    size_t closed = 0;
    for (size_t i = 0; i < count; ++i) {
        if (candidates[i] != 0.0) {
            contacts->part[closed++] = (double)i;
            *flag(contacts, i) = 1.0;
        }
    }
    while (closed > 0) {
        size_t weakest = 0;
        solve(contacts, t, x);
        for (size_t k = 1; k < closed; ++k) {
            if (push(contacts, (size_t)contacts->part[k]) < push(contacts, (size_t)contacts->part[weakest])) {
                weakest = k;
            }
        }
        if (!(multiplier(contacts, (size_t)contacts->part[weakest]) < -NOTHING * contacts->force)) {
            break;
        }
        *flag(contacts, (size_t)contacts->part[weakest]) = 0.0;
        --closed;
        memmove(contacts->part + weakest, contacts->part + weakest + 1, (closed - weakest) * sizeof(double));
    }
}

/* ---- impacts ---- */

/* Closed contacts that carry nothing are opened. */
static lag_status release(lag_contacts *contacts, double t, const double *x)
{
    const size_t count = contacts->motion->model->ncontact;
    double force = 0.0;
    int any = 0;
    const lag_status status = weigh(contacts, t, x, &force);
    set_force(contacts, fmax(contacts->force, force));
    for (size_t i = 0; i < count; ++i) {
        any = any || *flag(contacts, i) != 0.0;
    }
    if (any) {
        solve(contacts, t, x);
    }
    for (size_t i = 0; i < count && any; ++i) {
        if (multiplier(contacts, i) <= NOTHING * contacts->force) {
            *flag(contacts, i) = 0.0;
        }
    }
    return status;
}

static void add(lag_contacts *contacts, lag_blow *blow, size_t i, double factor)
{
    const size_t n = contacts->motion->model->nq;
    memcpy(contacts->rows + blow->count * n, contacts->jacobian + i * n, n * sizeof(double));
    contacts->speeds[blow->count] = contacts->speed[i];
    contacts->factor[blow->count] = factor;
    ++blow->count;
}

/* Flags of open contacts that close; whether there are any. */
static int find_closing(lag_contacts *contacts, double size)
{
    int any = 0;
    for (size_t i = 0; i < contacts->motion->model->ncontact; ++i) {
        const int touching = contacts->gap[i] <= TOUCHING * size;
        const int closing = touching && *flag(contacts, i) == 0.0 && contacts->speed[i] < -TOUCHING * size;
        contacts->closing[i] = closing;
        any = any || closing;
    }
    return any;
}

/* Whether closed contacts are driven in. */
static int any_driven(const lag_contacts *contacts, double size)
{
    int any = 0;
    for (size_t i = 0; i < contacts->motion->model->ncontact; ++i) {
        any = any || (*flag(contacts, i) != 0.0 && contacts->speed[i] < -TOUCHING * size);
    }
    return any;
}

/* What takes part: contacts that close, blows of clauses, and, held, what is closed. */
static lag_blow gather(lag_contacts *contacts, const double *collision, const double *restitution)
{
    const lag_model *model = contacts->motion->model;
    lag_blow blow = {0, contacts->rows, contacts->speeds, contacts->factor};
    for (size_t i = 0; i < model->ncontact; ++i) {
        if (contacts->closing[i] != 0.0) {
            add(contacts, &blow, i, contacts->restitution[i]);
            if (contacts->approach[i] == 0.0) {
                contacts->approach[i] = contacts->speed[i];
                contacts->order[contacts->struck++] = (double)i;
            }
        }
    }
    for (size_t i = 0; collision != NULL && i < model->ncollision; ++i) {
        if (collision[i] != 0.0) {
            add(contacts, &blow, model->ncontact + i, restitution[i]);
        }
    }
    for (size_t i = 0; i < model->ncontact; ++i) {
        if (*flag(contacts, i) != 0.0 && contacts->closing[i] == 0.0) {
            add(contacts, &blow, i, 0.0);
        }
    }
    return blow;
}

/* Blows until nothing closes any more. */
static lag_status strike(lag_contacts *contacts, double t, double *x, const double *collision, const double *restitution)
{
    const size_t collisions = collision != NULL ? contacts->motion->model->ncollision : 0;
    for (int k = 0; k < MOST_IMPACTS; ++k) {
        const double size = lag_contacts_size(contacts->motion, x);
        const int struck = k == 0 && lag_any(collisions, collision);
        lag_status status = look(contacts, t, x);
        if (status == LAG_OK && (find_closing(contacts, size) || struck) && contacts->struck == 0) {
            status = release(contacts, t, x);
        }
        if (status != LAG_OK) {
            return status;
        }
        if (!lag_any(contacts->motion->model->ncontact, contacts->closing) && !struck && !any_driven(contacts, size)) {
            return LAG_OK;
        }
        const lag_blow blow = gather(contacts, struck ? collision : NULL, restitution);
        status = lag_impact_strike(&contacts->impact, t, x, &blow);
        if (status != LAG_OK) {
            return status;
        }
    }
    return LAG_UNSETTLED;
}

/* Speeds below which contacts stay together, now that some were approached. */
static void find_slow(lag_contacts *contacts, double size)
{
    for (size_t i = 0; i < contacts->motion->model->ncontact; ++i) {
        contacts->fastest[i] = fmax(contacts->fastest[i], -contacts->approach[i]);
        const double slow = contacts->stick[i] >= 0.0 ? contacts->stick[i] : STICK * contacts->fastest[i];
        contacts->slow[i] = fmax(slow, TOUCHING * size);
    }
}

/* Whether a contact that struck stays; remembers the impact. */
static int stays(lag_contacts *contacts, double t, size_t i)
{
    const double speed = contacts->speed[i];
    const double ratio = speed / -contacts->approach[i];
    const double interval = t - contacts->last[i];
    contacts->last[i] = t;
    const double brief = contacts->rest[i] >= 0.0 ? contacts->rest[i] : REST * contacts->length;
    const int over = ratio < 1.0 && (interval * ratio / (1.0 - ratio) < brief || interval * ratio < contacts->flight);
    return fabs(speed) < contacts->slow[i] || over;
}

/* Opens closed contacts that do not touch, or move apart faster than `slow` (null: at all). */
static lag_status part(lag_contacts *contacts, double t, const double *x, const double *slow)
{
    const size_t count = contacts->motion->model->ncontact;
    const double least = TOUCHING * lag_contacts_size(contacts->motion, x);
    if (!lag_any(count, flag(contacts, 0))) {
        return LAG_OK;
    }
    const lag_status status = look(contacts, t, x);
    for (size_t i = 0; i < count && status == LAG_OK; ++i) {
        if (contacts->gap[i] > least || contacts->speed[i] > fmax(least, slow != NULL ? slow[i] : 0.0)) {
            *flag(contacts, i) = 0.0;
        }
    }
    return status;
}

lag_status lag_contacts_part(lag_contacts *contacts, double t, const double *x)
{
    return part(contacts, t, x, NULL);
}

/* What is closed after blows: what was and stays, what struck and stays, as far as it does not pull. */
static lag_status conclude(lag_contacts *contacts, double t, const double *x)
{
    const size_t count = contacts->motion->model->ncontact;
    find_slow(contacts, lag_contacts_size(contacts->motion, x));
    for (size_t i = 0; i < count; ++i) {
        *flag(contacts, i) = contacts->before[i] != 0.0 ? 1.0 : *flag(contacts, i);
    }
    lag_status status = part(contacts, t, x, contacts->slow);
    if (status == LAG_OK && contacts->struck > 0) {
        status = look(contacts, t, x);
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
    if (status == LAG_OK) {
        lag_contacts_press(contacts, t, x, flag(contacts, 0));
    }
    return status;
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
