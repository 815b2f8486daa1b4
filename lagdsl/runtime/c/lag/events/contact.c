/* Contacts at rest: what is closed at the start, what stays closed. */
#include "lag/events/contact.h"

#include <math.h>
#include <string.h>

#include "lag/linalg/arena.h"

/* A gap that is negative by this part of its size after a jump is pierced. */
static const double INSIDE = 1e-6;

/* A force below this part of the others is none: what only touches hands a blow on, what carries takes part as it is. */
static const double NOTHING = 1e-9;

size_t lag_contacts_memory(const lag_model *model)
{
    return 15 * model->ncontact + (5 + 2 * model->nq) * model->ngap + 9 * model->nq + model->nz;
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

static void place_each(lag_contacts *contacts, size_t count, double **memory)
{
    double **const arrays[] = {&contacts->scale, &contacts->pace, &contacts->force, &contacts->until, &contacts->restitution,
        &contacts->capture_speed, &contacts->zeno_time, &contacts->approach, &contacts->order, &contacts->closing, &contacts->before,
        &contacts->back, &contacts->first, &contacts->entries, &contacts->met};
    for (size_t k = 0; k < sizeof arrays / sizeof arrays[0]; ++k) {
        *arrays[k] = lag_take(memory, count);
        memset(*arrays[k], 0, count * sizeof(double));
    }
    for (size_t i = 0; i < count; ++i) {
        contacts->until[i] = (double)INFINITY;
    }
}

/* Gradients of gaps have the entries of the rows that their contacts are while they are closed; all, where nobody tells these. */
static void find_entries(lag_contacts *contacts, const lag_model *model)
{
    const lag_pattern *pattern = model->jacobian_pattern;
    for (size_t i = 0; i < model->ncontact; ++i) {
        size_t k = 0;
        while (pattern != NULL && k < pattern->count && pattern->row[k] < model->contact_rows[i]) {
            ++k;
        }
        contacts->first[i] = (double)k;
        while (pattern != NULL && k < pattern->count && pattern->row[k] == model->contact_rows[i]) {
            ++k;
        }
        contacts->entries[i] = pattern != NULL ? (double)k - contacts->first[i] : (double)model->nq;
    }
}

/* An angle is as large as a radian: its sine and cosine enter. */
static int is_angle(const char *unit)
{
    return unit[0] == 'r' && unit[1] == 'a' && unit[2] == 'd' && unit[3] == '\0';
}

void lag_contacts_place(lag_contacts *contacts, lag_motion *motion, double *memory)
{
    const lag_model *model = motion->model;
    memset(contacts, 0, sizeof *contacts);
    contacts->motion = motion;
    contacts->places = lag_places_of(model);
    place_gaps(contacts, model, &memory);
    place_each(contacts, model->ncontact, &memory);
    find_entries(contacts, model);
    contacts->hit = lag_take(&memory, model->nq + model->nz);
    contacts->tau = lag_take(&memory, model->nq);
    contacts->zero = lag_take(&memory, model->nq);
    contacts->moved = lag_take(&memory, model->nq);
    contacts->other = lag_take(&memory, model->nq);
    contacts->forces = lag_take(&memory, model->nq);
    contacts->peak = lag_take(&memory, 2 * model->nq);
    contacts->least = lag_take(&memory, model->nq);
    memset(contacts->zero, 0, model->nq * sizeof(double));
    memset(contacts->peak, 0, 2 * model->nq * sizeof(double));
    for (size_t j = 0; j < model->nq; ++j) {
        contacts->least[j] = model->coordinates != NULL && is_angle(model->coordinates[j].unit) ? 1.0 : 0.0;
    }
}

/* Force that pushes, positive; a force that is not a number counts as one that pulls. */
static double push(const lag_contacts *contacts, size_t i)
{
    const double force = lag_contacts_multiplier(contacts, i);
    return force == force ? force : -(double)INFINITY;
}

int lag_contacts_pierced(lag_contacts *contacts, double t, const double *x, double *flags)
{
    const size_t count = contacts->motion->model->ncontact;
    int any = 0;
    if (count == 0 || lag_contacts_look(contacts, t, x) != LAG_OK) {
        return 0;
    }
    for (size_t i = 0; i < count; ++i) {
        flags[i] = contacts->gap[i] < -lag_contacts_touch(contacts, i);
        any = any || flags[i] != 0.0;
    }
    return any;
}

lag_status lag_contacts_settle(lag_contacts *contacts, double t, const double *x)
{
    const size_t count = contacts->motion->model->ncontact;
    lag_status status = count > 0 ? lag_contacts_look(contacts, t, x) : LAG_OK;
    if (status != LAG_OK || count == 0) {
        return status;
    }
    status = lag_contacts_weigh(contacts, t, x);
    for (size_t i = 0; i < count; ++i) {
        const int touches = fabs(contacts->gap[i]) <= lag_contacts_touch(contacts, i);
        contacts->closing[i] = touches && fabs(contacts->speed[i]) <= lag_contacts_creep(contacts, i);
    }
    if (status == LAG_OK) {
        lag_contacts_press(contacts, t, x, contacts->closing);
    }
    return status;
}

static int pulls(const lag_contacts *contacts, size_t i)
{
    return -push(contacts, i) > NOTHING * fmax(contacts->force[i], 1e-300);
}

/* The closed contact, of those listed in `part`, that pulls most by its own measure; `closed` where none does. */
static size_t find_pulling(const lag_contacts *contacts, size_t closed)
{
    size_t worst = closed;
    double most = NOTHING;
    for (size_t k = 0; k < closed; ++k) {
        const size_t i = (size_t)contacts->part[k];
        const double pull = -push(contacts, i);
        const double measure = fmax(contacts->force[i], 1e-300);
        if (pull > most * measure) {
            most = pull / measure;
            worst = k;
        }
    }
    return worst;
}

/*
 * Takes the worst out of the closed contacts in `part` until none pulls; so many are left. Candidates that opened come
 * behind them.
 */
static size_t open_those_that_pull(lag_contacts *contacts, double t, const double *x, size_t closed)
{
    int weighed = 0;
    while (closed > 0) {
        lag_contacts_solve(contacts, t, x);
        size_t worst = find_pulling(contacts, closed);
        if (worst < closed && !weighed) { /* forces may have begun to act since its measure was taken */
            weighed = 1;
            if (lag_contacts_weigh(contacts, t, x) == LAG_OK) {
                lag_contacts_solve(contacts, t, x);
                worst = find_pulling(contacts, closed);
            }
        }
        if (worst == closed) {
            break;
        }
        const double opened = contacts->part[worst];
        *lag_contacts_flag(contacts, (size_t)opened) = 0.0;
        --closed;
        memmove(contacts->part + worst, contacts->part + worst + 1, (closed - worst) * sizeof(double));
        contacts->part[closed] = opened;
    }
    return closed;
}

void lag_contacts_press(lag_contacts *contacts, double t, const double *x, const double *candidates)
{
    const size_t count = contacts->motion->model->ncontact;
    size_t all = 0;
    for (size_t i = 0; i < count; ++i) {
        if (candidates[i] != 0.0) {
            contacts->part[all++] = (double)i;
            *lag_contacts_flag(contacts, i) = 1.0;
        }
    }
    const size_t closed = open_those_that_pull(contacts, t, x, all);
    for (size_t k = closed; k < all && all - closed > 1; ++k) { /* without the others it may not pull */
        const size_t i = (size_t)contacts->part[k];
        *lag_contacts_flag(contacts, i) = 1.0;
        lag_contacts_solve(contacts, t, x);
        *lag_contacts_flag(contacts, i) = pulls(contacts, i) ? 0.0 : 1.0;
    }
}

double lag_contacts_next(const lag_contacts *contacts)
{
    double next = (double)INFINITY;
    for (size_t i = 0; i < contacts->motion->model->ncontact; ++i) {
        next = fmin(next, contacts->until[i]);
    }
    return next;
}

lag_status lag_contacts_apart(
    lag_contacts *contacts, double t, const double *x, const double *was, const double *before, double *gap, double *pierced)
{
    const size_t count = contacts->motion->model->ncontact;
    if (count == 0) {
        return LAG_OK;
    }
    contacts->motion->at.w = before;
    lag_status status = lag_contacts_look(contacts, t, was);
    contacts->motion->at.w = contacts->motion->w;
    memcpy(gap, contacts->gap, count * sizeof(double));
    status = status == LAG_OK ? lag_contacts_look(contacts, t, x) : status;
    if (status != LAG_OK) {
        return status;
    }
    for (size_t i = 0; i < count; ++i) {
        const double inside = INSIDE * contacts->scale[i];
        pierced[i] = contacts->gap[i] < -inside && gap[i] - contacts->gap[i] > inside;
        status = pierced[i] != 0.0 ? LAG_PENETRATION : status;
    }
    return status;
}
