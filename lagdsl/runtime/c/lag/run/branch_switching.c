/* Motion that is fitted to the equations beyond a singular position. */
#include <math.h>
#include <string.h>

#include "lag/linalg/finite.h"
#include "lag/linalg/arena.h"
#include "lag/run.h"
#include "lag/linalg/fit_polynomial.h"

enum { NODES = LAG_FIT_NODES, HALVINGS = 4, ITERATIONS = 30, BETWEEN = 5 };

/*
 * Part of the time in which a coordinate moves by its natural size: long enough to leave the singular position, short enough for so many
 * points. Halved where the motion has shorter times of its own.
 */
static const double PART = 0.1;
static const double CONVERGED = 1e-11;
/* Changes that do not shrink any more are round-off, magnified by the nearness of the singular position. */
static const double SETTLED = 1e-4;
/* Estimated errors, as a part of the change of state: good enough at once, and not good enough at all. */
static const double ACCURATE = 1e-6;
static const double USELESS = 1e-4;
/*
 * A crossing, in distances to the singular position: how far (shorter where the motion bends, then longer where round-off is magnified), at
 * least how far, and where in between constraints are looked at; by how much, as a part of the sizes of the rows, they may be missed.
 */
static const double ACROSS[] = {8.0, 4.0, 32.0, 128.0};
static const double LEAST_ACROSS = 4.0;
/* The first point of a motion that begins beside a singular position has rows as independent as this; how long it is in such times. */
static const double CLEAR = 0.05;
static const double AWAY[] = {1.0, 0.5, 2.0, 4.0};
enum { DOUBLINGS = 30 };
static const double SOON = 1e-6;
static const double PLACES[BETWEEN] = {0.06, 0.125, 0.19, 0.25, 0.6};
static const double KEPT = 1e-9;
/* By how much branches that meet may miss each other. */
static const double MEETING = 1e-12;
/* A crossing is as smooth as this, in tolerances, within these bounds. */
static const double SMOOTH = 10.0;
static const double SMOOTHEST = 1e-9;
static const double ROUGHEST = 1e-7;

static size_t order_of(const lag_singular *s)
{
    return s->run->motion.model->nq;
}

/* nq + nz: rates and states of first order. */
static size_t width_of(const lag_singular *s)
{
    return order_of(s) + s->run->motion.model->nz;
}

static lag_status rates_at(lag_singular *s, double t, const double *x)
{
    const lag_ode *ode = &s->run->motion.ode;
    ++s->run->stepper.evaluations;
    const lag_status status = ode->rates(ode->context, t, x, s->rates);
    return status == LAG_OK && !lag_finite(ode->size, s->rates) ? LAG_NOT_FINITE : status;
}

/* Derivatives of rates and states at the nodes, into `fitted`, by fixed-point iteration; their polynomials into `coefficients`. */
static int collocate(lag_singular *s, double t, const double *x, double length)
{
    const size_t n = order_of(s);
    const size_t width = width_of(s);
    double change = (double)INFINITY;
    int moved = 0;
    if (rates_at(s, t, x) != LAG_OK) {
        return 0;
    }
    for (size_t i = 0; i < NODES; ++i) {
        memcpy(s->branch + i * width, s->rates + n, width * sizeof(double));
    }
    for (int k = 0; k < ITERATIONS; ++k) {
        const double previous = change;
        change = 0.0;
        memcpy(s->coefficients, s->branch, NODES * width * sizeof(double));
        lag_fit_interpolate(NODES, width, s->coefficients);
        for (size_t i = 0; i < NODES; ++i) {
            const double time = t + length * lag_fit_node(i);
            lag_fit_state_at(n, width, s->coefficients, x, length, lag_fit_node(i), s->state);
            if (lag_projection_exact(&s->run->projection, time, s->state, &moved) != LAG_OK || rates_at(s, time, s->state) != LAG_OK) {
                return 0;
            }
            for (size_t j = 0; j < width; ++j) {
                double *value = s->branch + i * width + j;
                change = fmax(change, fabs(s->rates[n + j] - *value) / (1.0 + fabs(s->rates[n + j])));
                *value = s->rates[n + j];
            }
        }
        if (change <= CONVERGED || (change <= SETTLED && change > 0.2 * previous)) {
            memcpy(s->coefficients, s->branch, NODES * width * sizeof(double));
            lag_fit_interpolate(NODES, width, s->coefficients);
            return 1;
        }
    }
    return 0;
}

/*
 * Error bound of number j, per second: the change that leaving out the first node makes, far above the error of all nodes.
 * *change: change of the number itself.
 */
static double doubt(const lag_singular *s, size_t j, double *change)
{
    const size_t width = width_of(s);
    double without = 0.0;
    *change = 0.0;
    for (size_t k = NODES; k-- > 0;) {
        *change += s->coefficients[k * width + j] / (double)(k + 1);
        without += k + 1 < NODES ? s->earlier[k * width + j] / (double)(k + 1) : 0.0;
    }
    return fabs(*change - without);
}

static void prepare_doubt(lag_singular *s)
{
    const size_t width = width_of(s);
    memcpy(s->earlier, s->branch + width, (NODES - 1) * width * sizeof(double));
    lag_fit_interpolate(NODES - 1, width, s->earlier);
}

/* ---- out of a singular position ---- */

/* The largest of these magnitudes (nq) in a component, in natural sizes. */
static double largest_in(const lag_singular *s, size_t component, const double *values)
{
    double most = 0.0;
    for (size_t j = 0; j < order_of(s); ++j) {
        most = lag_component_of(s->run->motion.model, j) == component ? fmax(most, fabs(values[j]) / s->run->natural[j]) : most;
    }
    return most;
}

/*
 * Time in which the accelerations move a coordinate of a component by its natural size; infinite where rates do that sooner, or without
 * acceleration.
 */
static double pace_of(lag_singular *s, double t, const double *x, size_t component)
{
    const size_t n = order_of(s);
    if (rates_at(s, t, x) != LAG_OK) {
        return (double)INFINITY;
    }
    const double urge = largest_in(s, component, s->rates + n);
    const double pace = urge > 0.0 ? sqrt(2.0 / urge) : (double)INFINITY;
    return largest_in(s, component, x + n) * pace < 1.0 ? pace : (double)INFINITY;
}

/*
 * The doubt about the change of the rates of a component, or of the states of first order where that is nq, as a part of the change or of
 * this part of the rates there are.
 */
static double error_in(const lag_singular *s, const double *x, double length, size_t component)
{
    const size_t n = order_of(s);
    double most = 0.0;
    double largest = 0.0;
    for (size_t j = 0; j < width_of(s); ++j) {
        double change = 0.0;
        if ((j < n ? lag_component_of(s->run->motion.model, j) : n) == component) {
            most = fmax(most, doubt(s, j, &change));
            largest = fmax(largest, fmax(fabs(change), ACCURATE * fabs(x[n + j]) / length));
        }
    }
    return most / (largest > 0.0 ? largest : 1.0);
}

static double error_of(lag_singular *s, const double *x, double length)
{
    double error = 0.0;
    prepare_doubt(s);
    for (size_t component = 0; component <= order_of(s); ++component) {
        error = fmax(error, error_in(s, x, length, component));
    }
    return error;
}

/* The best motion out of the position, from this length on downward. Nothing that moves beside a mechanism sets its pace. */
static int fit_from(lag_singular *s, double t, const double *x, double trial, double *length)
{
    const size_t n = order_of(s);
    const size_t width = width_of(s);
    double smallest = USELESS;
    int found = 0;
    int moved = 0;
    for (int k = 0; k < HALVINGS && trial < (double)INFINITY; ++k) {
        const int fits = collocate(s, t, x, trial);
        const double error = fits ? error_of(s, x, trial) : (double)INFINITY;
        if (fits && error < smallest) {
            lag_fit_state_at(n, width, s->coefficients, x, trial, 1.0, s->state);
            if (lag_projection_exact(&s->run->projection, t + trial, s->state, &moved) == LAG_OK) {
                memcpy(s->end, s->state, (n + width) * sizeof(double));
                memcpy(s->best, s->coefficients, NODES * width * sizeof(double));
                *length = trial;
                smallest = error;
                found = 1;
            }
        }
        if (smallest <= ACCURATE || (found && error > smallest)) {
            break;
        }
        trial *= 0.5;
    }
    return found;
}

int lag_fit_out(lag_singular *s, double t, const double *x, double limit, double *length)
{
    int found = 0;
    for (size_t component = 0; component < order_of(s) && !found; ++component) {
        if (lag_projection_holds(&s->run->projection, component)) {
            found = fit_from(s, t, x, fmin(PART * pace_of(s, t, x, component), 0.5 * (limit - t)), length);
        }
    }
    return found;
}

/* ---- across ---- */

/* Largest residual of a position row, as a part of its size. */
static double distance_of(lag_singular *s, double t, const double *x)
{
    lag_motion *motion = &s->run->motion;
    lag_projection *projection = &s->run->projection;
    double most = 0.0;
    lag_motion_look(motion, t, x);
    if (motion->model->position_constraint(&motion->at, projection->phi, projection->jacobian) != LAG_OK) {
        return (double)INFINITY;
    }
    for (size_t i = 0; i < motion->model->nc; ++i) {
        const double part = motion->model->position_level[i] ? fabs(projection->phi[i]) / s->run->row_sizes[i] : 0.0;
        most = part <= most ? most : part;
    }
    return most;
}

/* The largest doubt about the fitted motion, as a part of what is allowed; infinite where there is no number. */
static double roughness(lag_singular *s, double length)
{
    const size_t n = order_of(s);
    const lag_run *run = s->run;
    const double relative = fmin(fmax(SMOOTH * run->options.tolerance, SMOOTHEST), ROUGHEST);
    double most = 0.0;
    prepare_doubt(s);
    for (size_t j = 0; j < width_of(s); ++j) {
        double change = 0.0;
        const double part = length * doubt(s, j, &change) * run->accuracy.relative / (run->stepper.tolerance[n + j] * relative);
        if (!(part <= most)) {
            most = part > most ? part : (double)INFINITY;
        }
    }
    return most;
}

/* The constraints are kept all the way, and branches meet. */
static int keeps(lag_singular *s, double t, const double *x, double distance, double length)
{
    const size_t n = order_of(s);
    const size_t width = width_of(s);
    int moved = 0;
    for (size_t k = 0; k <= BETWEEN; ++k) {
        const double part = k < BETWEEN ? PLACES[k] : distance / length;
        lag_fit_state_at(n, width, s->coefficients, x, length, part, s->state);
        if (!(distance_of(s, t + length * part, s->state) <= KEPT)) {
            return 0;
        }
    }
    memcpy(s->end, s->state, (n + width) * sizeof(double));
    if (!(lag_branch_point_height(&s->saddle, s->general, t + distance, s->end) <= MEETING)) {
        return 0;
    }
    lag_fit_state_at(n, width, s->coefficients, x, length, 1.0, s->end);
    return lag_projection_exact(&s->run->projection, t + length, s->end, &moved) == LAG_OK;
}

/* The motion of this length that fits, into `best` and `end`; *rough: by how much it is too rough where that is above one. */
static int fits(lag_singular *s, double t, const double *x, double distance, double length, double *rough)
{
    *rough = collocate(s, t, x, length) ? roughness(s, length) : (double)INFINITY;
    const int found = *rough <= 1.0 && keeps(s, t, x, distance, length);
    if (found) {
        memcpy(s->best, s->coefficients, NODES * width_of(s) * sizeof(double));
    }
    return found;
}

int lag_fit_across(lag_singular *s, double t, const double *x, double distance, double limit, double *length)
{
    const double room = 0.999 * (limit - t);
    double longer = (double)INFINITY;
    double rough = longer;
    for (int beyond = 0; beyond <= 1; ++beyond) {
        for (size_t k = 0; k < sizeof ACROSS / sizeof *ACROSS; ++k, longer = rough) {
            *length = beyond ? ACROSS[k] * distance : fmin(ACROSS[k] * distance, room);
            if (beyond ? !(*length > room) : *length < LEAST_ACROSS * distance) {
                continue;
            }
            if (fits(s, t, x, distance, *length, &rough)) {
                return 1;
            }
            if (ACROSS[k] == LEAST_ACROSS && rough > 1.0 && rough < longer) { /* it bends: longer ones do so more */
                return 0;
            }
        }
    }
    return 0;
}

/* ---- from beside one ---- */

/* The time in which the rates of a component lead away to where rows are independent; infinite where they do not. */
static double time_to_clear(lag_singular *s, double t, const double *x, size_t component)
{
    const size_t n = order_of(s);
    const double speed = largest_in(s, component, x + n);
    memcpy(s->state, x, s->run->stepper.ode->size * sizeof(double));
    double time = SOON / speed;
    for (int k = 0; k < DOUBLINGS && speed > 0.0 && time * speed < 1.0; ++k, time *= 2.0) {
        for (size_t j = 0; j < n; ++j) {
            s->state[j] = x[j] + time * x[n + j];
        }
        if (lag_singular_margin(s, t + time, s->state, s->now) >= CLEAR) {
            return time;
        }
    }
    return (double)INFINITY;
}

int lag_fit_beside(lag_singular *s, double t, const double *x, double *length)
{
    double rough = 0.0;
    for (size_t component = 0; component < order_of(s); ++component) {
        const double clear = lag_projection_holds(&s->run->projection, component) ? time_to_clear(s, t, x, component) : (double)INFINITY;
        const double time = clear / lag_fit_node(0);
        for (size_t k = 0; k < sizeof AWAY / sizeof *AWAY && time < (double)INFINITY; ++k) {
            *length = AWAY[k] * time;
            if (fits(s, t, x, 0.0, *length, &rough)) {
                return 1;
            }
        }
    }
    return 0;
}

void lag_fit_state(const lag_singular *s, const double *x, double length, double part, double *state)
{
    lag_fit_state_at(order_of(s), width_of(s), s->best, x, length, part, state);
}

/* ---- as a step that was done ---- */

/* In the work of a stepper: nq, the length, then coefficients. */
static void begin(lag_stepper *s)
{
    (void)s;
}

static lag_status step(lag_stepper *s, double limit)
{
    (void)s;
    (void)limit;
    return LAG_STEP_TOO_SMALL;
}

static lag_status prepare_dense(lag_stepper *s)
{
    (void)s;
    return LAG_OK;
}

static void dense(const lag_stepper *s, double t, double *x)
{
    const size_t n = (size_t)s->work[0];
    const double part = (t - s->t_before) / s->work[1];
    lag_fit_state_at(n, s->ode->size - n, s->work + 2, s->x_before, s->work[1], part, x);
}

static size_t memory_of(size_t size)
{
    return 2 + NODES * size;
}

const lag_method lag_branch_switching = {.name = "fitted",
    .order = NODES,
    .highest_order = NODES,
    .dense_order = NODES,
    .factor = 1.0,
    .error_order = NODES,
    .memory = memory_of,
    .begin = begin,
    .step = step,
    .prepare_dense = prepare_dense,
    .dense = dense};
