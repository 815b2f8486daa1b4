/* Contacts at rest: what is closed at the start, what stays closed. */
#include "lag/contacts/contact.h"

#include <math.h>
#include <string.h>

#include "lag/linalg/arena.h"

/* A gap that is negative by this part of its size after a jump is pierced. */
static const double INSIDE = 1e-6;

size_t lag_contacts_memory(const lag_model *model)
{
    return 13 * model->ncontact + 3 * model->ngap + 9 * model->nq + model->nz + lag_inequalities_memory(model);
}

static void place_gaps(lag_contacts *contacts, const lag_model *model, double **memory)
{
    contacts->gap = lag_take(memory, model->ngap);
    contacts->speed = lag_take(memory, model->ngap);
    contacts->jacobian = contacts->motion->written.gaps;
    contacts->blows.part = lag_take(memory, model->ngap);
    lag_inequalities_place(&contacts->blows.rows, model, lag_take(memory, lag_inequalities_memory(model)));
}

static void place_each(lag_contacts *contacts, size_t count, double **memory)
{
    double **const arrays[] = {&contacts->sizes.force, &contacts->sizes.blow, &contacts->until, &contacts->restitution,
        &contacts->capture_speed, &contacts->zeno_time, &contacts->blows.approach, &contacts->blows.order, &contacts->blows.closing, &contacts->blows.before,
        &contacts->blows.back, &contacts->blows.compliance, &contacts->blows.met};
    for (size_t k = 0; k < sizeof arrays / sizeof arrays[0]; ++k) {
        *arrays[k] = lag_take(memory, count);
        memset(*arrays[k], 0, count * sizeof(double));
    }
    for (size_t i = 0; i < count; ++i) {
        contacts->until[i] = (double)INFINITY;
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
    contacts->blows.hit = lag_take(&memory, model->nq + model->nz);
    contacts->forces = lag_take(&memory, model->nq);
    contacts->work = lag_take(&memory, 4 * model->nq);
    contacts->sizes.peak = lag_take(&memory, 2 * model->nq);
    contacts->sizes.least = lag_take(&memory, model->nq);
    memset(contacts->sizes.peak, 0, 2 * model->nq * sizeof(double));
    for (size_t j = 0; j < model->nq; ++j) {
        contacts->sizes.least[j] = model->coordinates != NULL && is_angle(model->coordinates[j].unit) ? 1.0 : 0.0;
    }
}

int lag_contacts_penetrating(lag_contacts *contacts, double t, const double *x, double *flags)
{
    const size_t count = contacts->motion->model->ncontact;
    int any = 0;
    if (count == 0 || lag_contacts_evaluate_at(contacts, t, x) != LAG_OK) {
        return 0;
    }
    for (size_t i = 0; i < count; ++i) {
        flags[i] = contacts->gap[i] < -lag_contacts_gap_band(contacts, i);
        any = any || flags[i] != 0.0;
    }
    return any;
}

lag_status lag_contacts_touching(lag_contacts *contacts, double t, const double *x, double *closing)
{
    const size_t count = contacts->motion->model->ncontact;
    const lag_status status = count > 0 ? lag_contacts_evaluate_at(contacts, t, x) : LAG_OK;
    for (size_t i = 0; i < count && status == LAG_OK; ++i) {
        const int touches = fabs(contacts->gap[i]) <= lag_contacts_gap_band(contacts, i);
        closing[i] = touches && fabs(contacts->speed[i]) <= lag_contacts_speed_band(contacts, i);
    }
    return status;
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
