/* Contacts at rest: what is closed at the start, what stays closed. */
#include "lag/contacts/contact.h"

#include <math.h>
#include <string.h>

#include "lag/linalg/arena.h"

/* A gap that is negative by this part of its size after a jump is pierced. */
static const double INSIDE = 1e-6;

/* An angle is as large as a radian: its sine and cosine enter. */
static int is_angle(const char *unit)
{
    return unit[0] == 'r' && unit[1] == 'a' && unit[2] == 'd' && unit[3] == '\0';
}

void lag_contacts_place(lag_contacts *contacts, lag_motion *motion, lag_layout *layout)
{
    const lag_model *model = motion->model;
    lag_blows *blows = &contacts->blows;
    *contacts = (lag_contacts){.motion = motion, .jacobian = motion->written.gaps};
    lag_lay_all(layout, model->ngap, (double **const[]){&contacts->gap, &contacts->speed, NULL});
    lag_inequalities_place(&blows->rows, model, layout);
    lag_lay_all(layout, model->ncontact, (double **const[]){&contacts->sizes.force, &contacts->sizes.blow, &contacts->restitution, &contacts->capture_speed,
        &contacts->zeno_time, &contacts->hidden, &blows->approach, &blows->closing, &blows->before, &blows->back, &blows->compliance, &blows->met, NULL});
    contacts->until = lag_lay_filled(layout, model->ncontact, (double)INFINITY);
    contacts->forces = lag_lay(layout, model->nq);
    contacts->work = lag_lay(layout, 4 * model->nq);
    contacts->sizes.peak = lag_lay(layout, lag_motion_size(model) + model->nu);
    contacts->sizes.least = lag_lay(layout, model->nq);
    for (size_t j = 0; j < model->nq && contacts->sizes.least != NULL; ++j) {
        contacts->sizes.least[j] = model->coordinates != NULL && is_angle(model->coordinates[j].unit) ? 1.0 : 0.0;
    }
}

lag_status lag_contacts_begin(lag_contacts *contacts, double t, const double *x, double *closing, double *pierced)
{
    const size_t count = contacts->motion->model->ncontact;
    const lag_status status = count > 0 ? lag_contacts_evaluate_at(contacts, t, x) : LAG_OK;
    for (size_t i = 0; i < count && status == LAG_OK; ++i) {
        const double band = lag_contacts_gap_band(contacts, i);
        closing[i] = fabs(contacts->gap[i]) <= band && fabs(contacts->speed[i]) <= lag_contacts_speed_band(contacts, i);
        pierced[i] = contacts->gap[i] < -band;
    }
    return status == LAG_OK && lag_any(count, pierced) ? LAG_PENETRATION : status;
}

double lag_contacts_end_of_bounces(const lag_contacts *contacts)
{
    double next = (double)INFINITY;
    for (size_t i = 0; i < contacts->motion->model->ncontact; ++i) {
        next = fmin(next, contacts->until[i]);
    }
    return next;
}

lag_status lag_contacts_check_gaps(
    lag_contacts *contacts, double t, const double *x, const double *was, const double *before, double *gap, double *pierced)
{
    const size_t count = contacts->motion->model->ncontact;
    if (count == 0) {
        return LAG_OK;
    }
    contacts->motion->at.w = before;
    lag_status status = lag_contacts_evaluate_at(contacts, t, was);
    contacts->motion->at.w = contacts->motion->w;
    memcpy(gap, contacts->gap, count * sizeof(double));
    status = status == LAG_OK ? lag_contacts_evaluate_at(contacts, t, x) : status;
    if (status != LAG_OK) {
        return status;
    }
    for (size_t i = 0; i < count; ++i) {
        const double inside = INSIDE * lag_contacts_scale(contacts, i);
        pierced[i] = contacts->gap[i] < -inside && gap[i] - contacts->gap[i] > inside;
        status = pierced[i] != 0.0 ? LAG_PENETRATION : status;
    }
    return status;
}
