#include "lag/events/noise.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "lag/linalg/arena.h"
#include "lag/linalg/vector.h"

/* Relative change of the numbers: so many roundings of each are round-off. A larger one could lead across a jump that is near. */
static const double CHANGE = 16.0 * DBL_EPSILON;
/* Rows hold a relation if they take all but this part of what it does at other rates. */
static const double HELD = 1e-9;
/* Places are changed by this part of themselves to look at them. */
static const double NUDGE = 1e-11;
/* Rates of inputs are differences over this part of the experiment, both ways: signals are polynomials in pieces. */
static const double APART = 1e-7;
/* Multiples of these are irregular. */
static const double IRRATIONAL[] = {0.6180339887498949, 0.4142135623730951};
enum { CHANGES = sizeof IRRATIONAL / sizeof IRRATIONAL[0] };

static size_t count_of(const lag_model *model)
{
    return model->nindicator + model->ncorner;
}

/* Values, and rates and accelerations of the indicators. */
static size_t all_of(const lag_model *model)
{
    return count_of(model) + 2 * model->nindicator;
}

void lag_noise_place(lag_noise *noise, lag_contacts *contacts, lag_layout *layout)
{
    lag_motion *motion = contacts->motion;
    const lag_model *model = motion->model;
    const size_t unknown = model->nu + model->nq + model->nc;
    *noise = (lag_noise){.motion = motion, .contacts = contacts, .peak = contacts->sizes.peak};
    if (count_of(model) == 0) {
        return;
    }
    noise->point = lag_lay(layout, lag_motion_size(model));
    noise->u = lag_lay(layout, model->nu);
    lag_lay_all(layout, all_of(model), (double **const[]){&noise->value, &noise->other, &noise->opposite, &noise->sigma, NULL});
    noise->largest = lag_lay(layout, 2 * model->nindicator);
    /* rates of inputs, accelerations and multipliers are not known here: derivatives that read them are no numbers */
    const double *none = lag_lay_filled(layout, unknown, (double)NAN);
    motion->at.du = motion->at.dqdd = motion->at.dlam = none;
    motion->at.dz = noise->dz = lag_lay(layout, model->nz);
}

/* An irregular part of number i in change k: 0.5 to 1, of either sign. */
static double part_of(size_t i, unsigned k)
{
    const double multiple = IRRATIONAL[k] * (double)(i + 1);
    const double fraction = multiple - (double)(size_t)multiple;
    return fraction < 0.5 ? fraction - 1.0 : fraction;
}

/* Indicators, distances of corners, rates and accelerations of indicators, with accelerations and multipliers of x at time t. */
static lag_status evaluate_all(lag_noise *noise, double t, const double *x, double *values)
{
    lag_motion *motion = noise->motion;
    const lag_model *model = motion->model;
    double *rates = values + count_of(model);
    double solved = 0.0;
    lag_status status = lag_motion_solve(motion, t, x);
    if (status == LAG_OK && model->nindicator > 0) {
        status = model->indicator(&motion->at, values);
    }
    status = status == LAG_OK && model->nz > 0 ? model->state_derivative(&motion->at, noise->dz) : status;
    if (status == LAG_OK && model->nindicator > 0) {
        status = model->indicator_rate(&motion->at, rates, rates + model->nindicator);
    }
    return status == LAG_OK && model->ncorner > 0 ? model->corner(&motion->at, values + model->nindicator, &solved) : status;
}

lag_status lag_noise_update(lag_noise *noise, double t, const double *x)
{
    const lag_model *model = noise->motion->model;
    const double *rates = noise->value + count_of(model);
    const lag_status status = evaluate_all(noise, t, x, noise->value);
    for (size_t i = 0; i < 2 * model->nindicator && status == LAG_OK; ++i) {
        noise->largest[i] = isfinite(rates[i]) ? fmax(noise->largest[i], fabs(rates[i])) : noise->largest[i];
    }
    return status;
}

/* Sigma is at least this. Rates are sums of terms that may cancel: their round-off is that of the largest ones so far. */
static double least_of(const lag_noise *noise, size_t i)
{
    const lag_model *model = noise->motion->model;
    return fmax(DBL_MIN, i >= count_of(model) ? CHANGE * noise->largest[i - count_of(model)] : 0.0);
}

/* Number i after change k, or after the opposite one (`sign` -1). */
static double changed(const lag_noise *noise, size_t i, double number, unsigned k, double sign)
{
    return number + 2.0 * sign * CHANGE * part_of(i, k) * noise->peak[i];
}

/* Changes the inputs, but for whole ones. */
static void change_inputs(lag_noise *noise, unsigned k, double sign)
{
    const lag_model *model = noise->motion->model;
    for (size_t i = 0; i < model->nu; ++i) {
        const int is_whole = model->whole_inputs != NULL && model->whole_inputs[i] != 0;
        const double given = noise->u[i];
        noise->motion->u[i] = is_whole ? given : changed(noise, lag_motion_size(model) + i, given, k, sign);
    }
}

/* The same after change k, or after the opposite one, into `values`. */
static lag_status change_at(lag_noise *noise, double t, const double *x, unsigned k, double sign, double *values)
{
    lag_motion *motion = noise->motion;
    lag_inputs *const inputs = motion->inputs;
    const double after = t - sign * CHANGE * fabs(t);
    for (size_t i = 0; i < lag_motion_size(motion->model); ++i) {
        noise->point[i] = changed(noise, i, x[i], k, sign);
    }
    lag_motion_set_state(motion, after, noise->point);
    memcpy(noise->u, motion->u, motion->model->nu * sizeof(double));
    motion->inputs = NULL;
    change_inputs(noise, k, sign);
    motion->delays.change = 2.0 * sign * CHANGE * part_of(0, k);
    const lag_status status = evaluate_all(noise, after, noise->point, values);
    motion->inputs = inputs;
    motion->delays.change = 0.0;
    memcpy(motion->u, noise->u, motion->model->nu * sizeof(double));
    return status;
}

lag_status lag_noise_find(lag_noise *noise, double t, const double *x)
{
    const lag_model *model = noise->motion->model;
    lag_contacts_follow(noise->contacts, x);
    const lag_status status = all_of(model) > 0 ? lag_noise_update(noise, t, x) : LAG_OK;
    if (all_of(model) == 0 || status != LAG_OK) {
        return status;
    }
    for (size_t i = 0; i < all_of(model); ++i) {
        noise->sigma[i] = least_of(noise, i);
    }
    for (unsigned k = 0; k < CHANGES; ++k) {
        if (change_at(noise, t, x, k, 1.0, noise->other) != LAG_OK || change_at(noise, t, x, k, -1.0, noise->opposite) != LAG_OK) {
            continue;
        }
        for (size_t i = 0; i < all_of(model); ++i) { /* a jump that is near lies on one side */
            const double by = fmin(fabs(noise->other[i] - noise->value[i]), fabs(noise->opposite[i] - noise->value[i]));
            noise->sigma[i] = by > noise->sigma[i] && isfinite(by) ? by : noise->sigma[i];
        }
    }
    return LAG_OK;
}

double lag_noise_known(const lag_noise *noise, size_t which)
{
    return noise->tolerance / CHANGE * noise->sigma[which];
}

double lag_noise_extent(const lag_noise *noise, const double *x, size_t j)
{
    const double own = fmax(noise->peak[j], fabs(x[j]));
    return own > 0.0 ? own : 1.0;
}

/* ---- relations that rows hold ---- */

/* A number that is only a small part of what it is without the rows, or of the largest one so far. */
static int vanishes(double with, double without, double largest)
{
    return fabs(with) <= HELD * fmax(fabs(without), largest);
}

/*
 * x with other rates and states, by about as much as they have been so far, each in its own way, and with slightly other places: at a corner of `abs` a
 * relation has no rate.
 */
static void perturb(const lag_noise *noise, const double *x, double *point)
{
    const lag_model *model = noise->motion->model;
    for (size_t j = 0; j < lag_motion_size(model); ++j) {
        point[j] = x[j] + (j < model->nq ? NUDGE : 1.0) * part_of(j, 0) * lag_noise_extent(noise, x, j);
    }
}

/* True if relation i may rest: it is zero and does not move, as far as the motion is known. */
static int may_be_held(const lag_noise *noise, size_t i)
{
    const double rate = noise->value[count_of(noise->motion->model) + i];
    const double near = fmax(LAG_CLEARLY * noise->sigma[i], lag_noise_known(noise, i));
    return (fabs(noise->value[i]) <= near || noise->sigma[i] == 0.0) && fabs(rate) <= HELD * noise->largest[i];
}

/*
 * True if relation i does not move at any rates that the rows admit, by its values, rates and accelerations at rates `without` and `with` the rows. One of
 * places needs its acceleration: its rate may vanish at one state only. One of rates is zero at all of them.
 */
static int is_held(const lag_noise *noise, size_t i, const double *without, const double *with)
{
    const size_t count = noise->motion->model->nindicator;
    const size_t rate = count_of(noise->motion->model) + i;
    const int of_rates = without[i] != with[i];
    const int is_zero = of_rates && vanishes(with[i], without[i], 0.0);
    const int is_straight = !of_rates && vanishes(with[rate + count], without[rate + count], noise->largest[count + i]);
    return vanishes(with[rate], without[rate], noise->largest[i]) && (is_zero || is_straight);
}

void lag_noise_hold(lag_noise *noise, lag_projection *projection, double t, const double *x, double *point, double *held)
{
    const size_t count = noise->motion->model->nindicator;
    lag_fill(count, 0.0, held);
    if (count == 0 || lag_noise_update(noise, t, x) != LAG_OK) {
        return;
    }
    for (size_t i = 0; i < count; ++i) {
        held[i] = may_be_held(noise, i);
    }
    if (!lag_any(count, held)) {
        return;
    }
    perturb(noise, x, point);
    lag_status status = evaluate_all(noise, t, point, noise->other);
    status = status == LAG_OK ? lag_projection_rates(projection, t, point, NULL) : status;
    status = status == LAG_OK ? evaluate_all(noise, t, point, noise->opposite) : status;
    for (size_t i = 0; i < count; ++i) {
        held[i] = held[i] != 0.0 && status == LAG_OK && is_held(noise, i, noise->other, noise->opposite);
    }
}

/* ---- gradients ---- */

/* Rates of the inputs at time t, into noise->u: by the signals that tell them; of inputs that are set, zero. */
static void find_input_rates(lag_noise *noise, double t, const double *x)
{
    lag_motion *motion = noise->motion;
    const double by = APART * fmax(fabs(t), noise->contacts->length);
    lag_motion_set_state(motion, t + by, x);
    memcpy(noise->u, motion->u, motion->model->nu * sizeof(double));
    lag_motion_set_state(motion, t - by, x);
    lag_axpy(motion->model->nu, -1.0, motion->u, noise->u);
    for (size_t i = 0; i < motion->model->nu; ++i) {
        noise->u[i] = by > 0.0 ? noise->u[i] / (2.0 * by) : 0.0;
    }
    lag_motion_set_state(motion, t, x);
}

int lag_noise_differentiate(lag_noise *noise, double t, const double *x, size_t which, double *gradient, double *drift)
{
    const lag_model *model = noise->motion->model;
    const size_t n = model->nq;
    double *direction = noise->point;
    double *rate = noise->other;
    double *second = noise->other + model->nindicator; /* of no use here */
    int by_place = 0;
    find_input_rates(noise, t, x);
    lag_arguments at = noise->motion->at;
    at.du = noise->u;
    at.qd = direction;
    at.qdd = at.dqdd; /* one that reads rates has no rate then */
    lag_fill(lag_motion_size(model), 0.0, direction);
    lag_status status = model->indicator_rate(&at, rate, second);
    *drift = rate[which];
    at.dz = direction + 2 * n;
    status = status == LAG_OK ? model->indicator_rate(&at, rate, second) : status;
    const double rest = rate[which];
    for (size_t j = 0; j < n && status == LAG_OK; ++j) {
        direction[j] = lag_noise_extent(noise, x, j);
        status = model->indicator_rate(&at, rate, second);
        gradient[j] = (rate[which] - rest) / direction[j];
        by_place = by_place || gradient[j] != 0.0;
        direction[j] = 0.0;
    }
    return status == LAG_OK && isfinite(*drift) && by_place;
}
