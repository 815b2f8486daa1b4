#include "lag/contacts/friction.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "lag/linalg/arena.h"
#include "lag/linalg/vector.h"

/* A slip is zero below this part of its largest terms, */
static const double SLOW = 1e-12;
/* in a plane, where it passes zero beside it, below this one. */
static const double SLOW_IN_PLANE = 1e-8;
/* It has ended where less than this part is left of what it was when the step began. */
static const double ENDED = 0.05;
/* Round-off of accelerations that add up. */
static const double ROUNDING = 64.0 * DBL_EPSILON;
/* A reserve is zero below this part of the force. */
static const double NO_FORCE = 1e-12;
static const double NO_SHARED_FORCE = 1e-10;

void lag_frictions_place(lag_frictions *frictions, lag_motion *motion, lag_contacts *contacts, lag_layout *layout)
{
    const lag_model *model = motion->model;
    *frictions = (lag_frictions){.motion = motion, .contacts = contacts};
    lag_lay_all(layout, model->nfriction, (double **const[]){&frictions->first, &frictions->limit, &frictions->sticking, &frictions->force, NULL});
    lag_lay_all(layout, model->nfriction * model->nc, (double **const[]){&frictions->gain, &frictions->sticking_gain, NULL});
    lag_lay_all(layout, model->nslip, (double **const[]){&frictions->slip, &frictions->reference, &frictions->fast, NULL});
    frictions->push = lag_lay(layout, model->nq + model->nz);
    frictions->compliance = lag_lay(layout, model->ncontact + model->nfriction);
    frictions->reserve = lag_lay_filled(layout, model->ncontact + model->nfriction, (double)NAN);
    frictions->jacobian = lag_lay(layout, model->nslip * model->nq);
    size_t next = 0;
    for (size_t k = 0; k < model->nfriction && frictions->first != NULL; ++k) {
        frictions->first[k] = (double)next;
        next += model->friction_slips[k];
    }
}

static const double *row_of(const lag_frictions *frictions, size_t k)
{
    return frictions->jacobian + (size_t)frictions->first[k] * frictions->motion->model->nq;
}

/* The force of one side, a contact or behind them a friction, pushes at its component. */
static void include_push(lag_frictions *frictions, size_t side, const double *row, double force)
{
    const double push = frictions->compliance[side] * fabs(force);
    double *most = frictions->push + lag_row_component(frictions->motion->model, row);
    *most = isfinite(push) ? fmax(*most, push) : *most;
}

lag_status lag_frictions_evaluate(lag_frictions *frictions)
{
    const lag_motion *motion = frictions->motion;
    const lag_model *model = motion->model;
    const size_t n = model->nq;
    const double *peak = frictions->contacts->sizes.peak + n;
    if (model->nfriction == 0) {
        return LAG_OK;
    }
    const lag_status status = model->friction(
        &motion->at, frictions->slip, frictions->jacobian, frictions->limit, frictions->sticking, frictions->gain, frictions->sticking_gain);
    for (size_t i = 0; i < model->nslip; ++i) {
        const double *row = frictions->jacobian + i * n;
        double terms = fabs(frictions->slip[i] - lag_dot(n, row, motion->at.qd));
        for (size_t j = 0; j < n; ++j) {
            terms += fabs(row[j]) * peak[j];
        }
        frictions->fast[i] = fmax(frictions->fast[i], terms);
    }
    for (size_t k = 0; k < model->nfriction; ++k) {
        const double limit = fabs(frictions->limit[k]);
        include_push(frictions, model->ncontact + k, row_of(frictions, k), lag_frictions_force(frictions, k));
        frictions->force[k] = isfinite(limit) ? fmax(frictions->force[k], limit) : frictions->force[k];
    }
    for (size_t i = 0; i < model->ncontact; ++i) {
        include_push(frictions, i, frictions->contacts->jacobian + i * n, motion->lam[model->contact_rows[i]]);
    }
    return status;
}

void lag_frictions_add(const lag_frictions *frictions, lag_inequalities *rows, size_t k, const double *jacobian, const double *slip, const double *gain)
{
    const lag_model *model = frictions->motion->model;
    double *coefficients = rows->coefficients + rows->frictions * rows->normals;
    lag_inequalities_add_friction(rows, model->nq, k, lag_frictions_components(frictions, k), jacobian, slip);
    for (size_t i = 0; i < rows->normals; ++i) { /* nothing rubs under the blow of a clause */
        const size_t contact = lag_gap_of(rows, i);
        coefficients[i] = contact < model->ncontact ? gain[model->contact_rows[contact]] : 0.0;
    }
}

int lag_frictions_acts(const lag_frictions *frictions, size_t k)
{
    const lag_model *model = frictions->motion->model;
    const size_t contact = model->friction_contacts[k];
    return contact >= model->ncontact || *lag_contacts_flag(frictions->contacts, contact) != 0.0;
}

double lag_frictions_length(const lag_frictions *frictions, const double *array, size_t k)
{
    return lag_slip_length(lag_frictions_components(frictions, k), array + (size_t)frictions->first[k]);
}

double lag_frictions_speed(const lag_frictions *frictions, size_t k)
{
    return lag_frictions_length(frictions, frictions->slip, k);
}

double lag_frictions_speed_band(const lag_frictions *frictions, size_t k)
{
    const double crept = ROUNDING * frictions->push[lag_row_component(frictions->motion->model, row_of(frictions, k))] * frictions->step;
    return SLOW * lag_frictions_length(frictions, frictions->fast, k) + crept;
}

double lag_frictions_force(const lag_frictions *frictions, size_t k)
{
    const size_t row = frictions->motion->model->friction_rows[(size_t)frictions->first[k]];
    return lag_slip_length(lag_frictions_components(frictions, k), frictions->motion->lam + row);
}

void lag_frictions_begin(lag_frictions *frictions)
{
    const lag_model *model = frictions->motion->model;
    for (size_t k = 0; k < model->nfriction; ++k) {
        const size_t first = (size_t)frictions->first[k];
        const int moves = lag_frictions_speed(frictions, k) > lag_frictions_speed_band(frictions, k);
        const double *from = moves ? frictions->slip + first : lag_frictions_direction(frictions, k);
        memcpy(frictions->reference + first, from, lag_frictions_components(frictions, k) * sizeof(double));
    }
}

/* The length of a slip in a plane at which it ends in any case. */
static double speed_band_in_plane(const lag_frictions *frictions, size_t k)
{
    return SLOW_IN_PLANE * lag_frictions_length(frictions, frictions->fast, k) + lag_frictions_speed_band(frictions, k);
}

/* The part of a slip along that of the beginning of the step. */
static double along_reference(const lag_frictions *frictions, size_t k)
{
    const size_t first = (size_t)frictions->first[k];
    const double length = lag_frictions_length(frictions, frictions->reference, k);
    const double along = lag_dot(lag_frictions_components(frictions, k), frictions->reference + first, frictions->slip + first);
    return length > 0.0 ? along / length : lag_frictions_speed(frictions, k);
}

int lag_frictions_turns(const lag_frictions *frictions, size_t k)
{
    const double speed = lag_frictions_speed(frictions, k);
    return lag_frictions_components(frictions, k) > 1 && speed > 2.0 * speed_band_in_plane(frictions, k) &&
           speed > ENDED * lag_frictions_length(frictions, frictions->reference, k);
}

double lag_frictions_guard(const lag_frictions *frictions, size_t k)
{
    const int plane = lag_frictions_components(frictions, k) > 1;
    if (!lag_frictions_acts(frictions, k)) {
        return (double)INFINITY;
    }
    if (*lag_frictions_sticks(frictions, k) != 0.0) {
        const double shared = frictions->reserve[frictions->motion->model->ncontact + k];
        return isnan(shared) ? frictions->sticking[k] - lag_frictions_force(frictions, k) : shared;
    }
    if (plane) {
        return along_reference(frictions, k) - speed_band_in_plane(frictions, k);
    }
    return *lag_frictions_direction(frictions, k) * frictions->slip[(size_t)frictions->first[k]];
}

double lag_frictions_size(const lag_frictions *frictions, size_t k)
{
    return *lag_frictions_sticks(frictions, k) != 0.0 ? frictions->force[k] : lag_frictions_length(frictions, frictions->fast, k);
}

double lag_frictions_dead_band(const lag_frictions *frictions, size_t k)
{
    const double part = isnan(frictions->reserve[frictions->motion->model->ncontact + k]) ? NO_FORCE : NO_SHARED_FORCE;
    return *lag_frictions_sticks(frictions, k) != 0.0 ? part * lag_frictions_size(frictions, k) : lag_frictions_speed_band(frictions, k);
}
