/* Scales of the quantities of a contact: from the numbers that enter its own gap, and no others. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "lag/contacts/contact.h"
#include "lag/equations/entries.h"
#include "lag/linalg/arena.h"
#include "lag/linalg/order.h"

/* A gap is zero where an event is looked at below this part of its length, a rate below this part of its speed. */
static const double TOUCHING = 1e-12;
/* A coordinate is as good as zero below this part of its unit. */
static const double LEAST = 1e-12;
/* Below these parts of its length and of its force, a value is round-off and no event. */
static const double ROUNDING = 16.0 * DBL_EPSILON;
static const double NO_FORCE = 1e-13;
/* Constraints satisfied to their limits let gaps be so many limits off. */
static const double LIMITS = 4.0;
/* Positions are moved by this part of their magnitudes to see how large forces are. */
static const double CHANGE = 1e-4;

void lag_contacts_follow(lag_contacts *contacts, const double *x)
{
    const lag_motion *motion = contacts->motion;
    const size_t size = lag_motion_size(motion->model);
    for (size_t i = 0; i < size + motion->model->nu; ++i) {
        const double magnitude = fabs(i < size ? x[i] : motion->u[i - size]);
        contacts->sizes.peak[i] = magnitude > contacts->sizes.peak[i] ? magnitude : contacts->sizes.peak[i];
    }
}

/* Gradients of gaps have the entries of the rows that their contacts are while they are closed. */
static lag_entries entries_of(const lag_contacts *contacts, size_t i)
{
    return lag_entries_of(contacts->motion->model, contacts->motion->model->contact_rows[i]);
}

double lag_contacts_scale(const lag_contacts *contacts, size_t i)
{
    const lag_entries entries = entries_of(contacts, i);
    const double *row = contacts->jacobian + i * contacts->motion->model->nq;
    double length = 0.0;
    double slopes = 0.0;
    for (size_t k = entries.first; k < entries.end; ++k) {
        const size_t j = lag_entry_column(&entries, k);
        length += fabs(row[j]) * lag_higher(contacts->sizes.peak[j], contacts->sizes.least[j]);
        slopes += fabs(row[j]);
    }
    return length > 0.0 ? lag_higher(length, LEAST * slopes) : slopes;
}

double lag_contacts_pace(const lag_contacts *contacts, size_t i)
{
    const size_t n = contacts->motion->model->nq;
    const lag_entries entries = entries_of(contacts, i);
    double speed = 0.0;
    for (size_t k = entries.first; k < entries.end; ++k) {
        const size_t j = lag_entry_column(&entries, k);
        speed += fabs(contacts->jacobian[i * n + j]) * contacts->sizes.peak[n + j];
    }
    return speed;
}

double lag_contacts_gap_noise(const lag_contacts *contacts, size_t i)
{
    return lag_contacts_is_one_way(contacts, i) ? lag_contacts_speed_band(contacts, i) : ROUNDING * lag_contacts_scale(contacts, i);
}

double lag_contacts_force_noise(const lag_contacts *contacts, size_t i)
{
    return NO_FORCE * contacts->sizes.force[i];
}

double lag_contacts_gap_band(const lag_contacts *contacts, size_t i)
{
    const double off = contacts->limits != NULL ? LIMITS * contacts->limits[contacts->motion->model->contact_rows[i]] : 0.0;
    const double closed = *lag_contacts_flag(contacts, i) != 0.0 ? off : 0.0;
    return lag_higher(TOUCHING * lag_contacts_scale(contacts, i), closed);
}

double lag_contacts_speed_band(const lag_contacts *contacts, size_t i)
{
    const double drift = contacts->length > 0.0 ? TOUCHING * lag_contacts_scale(contacts, i) / contacts->length : 0.0;
    return lag_higher(TOUCHING * lag_higher(lag_contacts_pace(contacts, i), contacts->sizes.blow[i]), drift);
}

lag_status lag_contacts_evaluate(lag_contacts *contacts)
{
    const lag_motion *motion = contacts->motion;
    return motion->model->contact(
        &motion->at, contacts->gap, contacts->speed, contacts->jacobian, contacts->restitution, contacts->capture_speed, contacts->zeno_time);
}

lag_status lag_contacts_evaluate_at(lag_contacts *contacts, double t, const double *x)
{
    lag_motion *motion = contacts->motion;
    lag_motion_set_state(motion, t, x);
    lag_contacts_follow(contacts, x);
    return lag_contacts_evaluate(contacts);
}

/* The multiplier of one contact that would cancel the accelerations that the forces give its coordinates, each by itself. */
static double force_of(const lag_contacts *contacts, size_t i)
{
    const lag_entries entries = entries_of(contacts, i);
    const size_t n = contacts->motion->model->nq;
    const double *row = contacts->jacobian + i * n;
    double acceleration = 0.0;
    double compliance = 0.0;
    for (size_t k = entries.first; k < entries.end; ++k) {
        const size_t j = lag_entry_column(&entries, k);
        const double mass = contacts->impulse->mass[j * n + j];
        if (mass > 0.0) {
            acceleration += fabs(row[j]) * contacts->forces[j] / mass;
            compliance += row[j] * row[j] / mass;
        }
    }
    return compliance > 0.0 ? acceleration / compliance : 0.0;
}

/* Generalized forces (nq) that act where the positions are moved by this part of their magnitudes: all up, or every other one down. */
static lag_status loads_at(lag_contacts *contacts, const double *x, double part, int alternate, double *force)
{
    lag_motion *motion = contacts->motion;
    double *memory = contacts->work;
    double *moved = lag_take(&memory, motion->model->nq);
    double *zero = lag_take(&memory, motion->model->nq);
    lag_fill(motion->model->nq, 0.0, zero);
    for (size_t j = 0; j < motion->model->nq; ++j) {
        const double by = part * fmax(contacts->sizes.peak[j], contacts->sizes.least[j]);
        moved[j] = alternate && j % 2 != 0 ? x[j] - by : x[j] + by;
    }
    motion->at.q = moved;
    motion->at.qdd = zero;
    const lag_status status = motion->model->inverse_dynamics(&motion->at, force);
    motion->at.qdd = motion->qdd;
    motion->at.q = x;
    return status;
}

/* Magnitudes of the generalized forces: those that act, and those that would where positions change by as much as they are. */
static lag_status find_load_sizes(lag_contacts *contacts, const double *x)
{
    const size_t n = contacts->motion->model->nq;
    double *tau = contacts->work + 2 * n;
    double *other = contacts->work + 3 * n;
    const lag_status status = loads_at(contacts, x, 0.0, 0, tau);
    for (size_t j = 0; j < n; ++j) {
        contacts->forces[j] = fabs(tau[j]);
    }
    for (int k = 0; k < 2 && status == LAG_OK; ++k) {
        if (loads_at(contacts, x, CHANGE, k, other) == LAG_OK) {
            for (size_t j = 0; j < n; ++j) {
                const double by = fabs(other[j] - tau[j]) / CHANGE;
                contacts->forces[j] = isfinite(by) ? fmax(contacts->forces[j], by) : contacts->forces[j];
            }
        }
    }
    return status;
}

lag_status lag_contacts_find_forces(lag_contacts *contacts, double t, const double *x)
{
    lag_motion *motion = contacts->motion;
    const lag_model *model = motion->model;
    lag_motion_set_state(motion, t, x);
    lag_status status = find_load_sizes(contacts, x);
    if (status == LAG_OK) {
        status = model->mass_matrix(&motion->at, contacts->impulse->mass);
    }
    for (size_t i = 0; i < model->ncontact && status == LAG_OK; ++i) {
        contacts->sizes.force[i] = fmax(contacts->sizes.force[i], force_of(contacts, i));
    }
    return status;
}
