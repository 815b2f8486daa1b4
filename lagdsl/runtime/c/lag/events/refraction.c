#include "lag/events/refraction.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "lag/linalg/arena.h"
#include "lag/linalg/vector.h"

/* Numbers are changed by this part of their sizes for differences. */
static const double CHANGE = 6e-6;
/* A jump of energy or momenta below this part of what they are made of is none. */
static const double JUMP = 1e-11;
/* g is zero where it is less than what it changes by in a moment; it does not depend on rates where it changes less than this part. */
static const double STILL = 1e-9;

size_t lag_refraction_memory(const lag_model *model)
{
    return 2 * model->nq + 2 * lag_motion_size(model) + model->nindicator;
}

void lag_refraction_place(lag_refraction *refraction, lag_motion *motion, lag_momentum *momentum, lag_noise *noise, double *memory)
{
    const lag_model *model = motion->model;
    *refraction = (lag_refraction){.motion = motion, .momentum = momentum, .noise = noise, .places = lag_places_of(model)};
    refraction->gradient = lag_take(&memory, model->nq);
    refraction->along = lag_take(&memory, model->nq);
    refraction->point = lag_take(&memory, lag_motion_size(model));
    refraction->rate = lag_take(&memory, lag_motion_size(model));
    refraction->g = memory;
}

/* The indicator at the point, with accelerations and multipliers as they are; not a number where there is none. */
static double indicator(lag_refraction *r, double t, size_t which)
{
    lag_motion_look(r->motion, t, r->point);
    const lag_status status = r->motion->model->indicator(&r->motion->at, r->g);
    return status == LAG_OK ? r->g[which] : (double)NAN;
}

/* g and its gradient by q; *drift: its rate with time and states, the positions held; 0: it depends on rates, or not on positions. */
static int differentiate(lag_refraction *r, double t, const double *x, size_t which, double *g, double *drift)
{
    const lag_model *model = r->motion->model;
    const size_t n = model->nq;
    const size_t size = lag_motion_size(model);
    const double dt = CHANGE * fmax(fabs(t), r->length);
    double most = 0.0;
    double by_rates = 0.0;
    memcpy(r->point, x, size * sizeof(double));
    *g = indicator(r, t, which);
    for (size_t j = 0; j < 2 * n; ++j) {
        const double own = fmax(r->noise->peak[j], fabs(x[j]));
        const double by = CHANGE * (own > 0.0 ? own : 1.0);
        r->point[j] = x[j] + by;
        const double after = indicator(r, t, which);
        r->point[j] = x[j] - by;
        const double change = after - indicator(r, t, which);
        r->point[j] = x[j];
        if (j < n) {
            r->gradient[j] = change / (2.0 * by);
            most = fmax(most, fabs(change));
        } else {
            by_rates = fmax(by_rates, fabs(change));
        }
    }
    for (int sign = -1; sign <= 1; sign += 2) {
        for (size_t j = 2 * n; j < size; ++j) {
            r->point[j] = x[j] + sign * dt * r->rate[j];
        }
        *drift = sign < 0 ? indicator(r, t - dt, which) : (indicator(r, t + dt, which) - *drift) / (2.0 * dt);
    }
    return isfinite(*g) && isfinite(*drift) && most > 0.0 && by_rates <= STILL * most;
}

/* The energy h, and its size. */
static lag_status energy(const lag_refraction *r, double t, const double *x, double *h, double *size)
{
    lag_motion *motion = r->motion;
    double total = 0.0;
    double kinetic = 0.0;
    double potential = 0.0;
    lag_motion_look(motion, t, x);
    const lag_status status = motion->model->energies(&motion->at, &total, &kinetic, &potential, h);
    *size = fabs(kinetic) + fabs(potential) + fabs(*h);
    return status;
}

/* The change of rates for an impulse along the gradient; the factors are those of the momentum's system. */
static lag_status respond(lag_refraction *r, lag_system *system)
{
    const lag_model *model = r->motion->model;
    lag_momentum *momentum = r->momentum;
    lag_system_place(system, model->nq, model->nc, momentum->system);
    const lag_status status = lag_system_factor(system, momentum->mass, momentum->jacobian, model->rank, &r->motion->coordinate);
    lag_fill(model->nc, 0.0, momentum->right);
    if (status == LAG_OK) {
        lag_system_solve(system, r->gradient, momentum->right, r->along, momentum->lam);
    }
    return status;
}

static void move(lag_refraction *r, double *rates, double mu)
{
    for (size_t i = 0; i < r->motion->model->nq; ++i) {
        rates[i] += mu * r->along[i];
    }
}

/*
 * With w and momenta p of the other side and mu along the gradient h is a parabola: its coefficients, from three places one of which is that at
 * which the rate of g vanishes. The root on the side to which g moves; 0: there is none.
 */
static int root(lag_refraction *r, double t, double *x, double before, double speed, double drift, double *mu)
{
    const size_t n = r->motion->model->nq;
    const double slope = lag_dot(n, r->gradient, r->along);
    const double middle = -(lag_dot(n, r->gradient, x + n) + drift) / slope;
    const double width = fmax(fabs(speed) / slope, DBL_MIN);
    double h[3] = {0.0, 0.0, 0.0};
    double size = 0.0;
    for (int k = 0; k < 3; ++k) {
        const double at = middle + (k - 1) * width;
        memcpy(r->point, x, lag_motion_size(r->motion->model) * sizeof(double));
        move(r, r->point + n, at);
        if (energy(r, t, r->point, &h[k], &size) != LAG_OK) {
            return 0;
        }
        h[k] += at * drift;
    }
    const double a = 0.5 * (h[0] + h[2]) - h[1];
    const double b = 0.5 * (h[2] - h[0]);
    const double c = h[1] - before;
    const double under = b * b - 4.0 * a * c;
    if (!(a > 0.0) || !(under >= 0.0)) {
        return 0;
    }
    const double s = (-b + (speed > 0.0 ? 1.0 : -1.0) * sqrt(under)) / (2.0 * a);
    *mu = middle + s * width;
    return s * speed > 0.0;
}

/* 1: momenta that were kept are not those of now. */
static int momenta_jump(const lag_momentum *momentum, const double *qd)
{
    const size_t n = momentum->motion->model->nq;
    int jump = 0;
    for (size_t i = 0; i < n; ++i) {
        double size = fabs(momentum->before[i]) + fabs(momentum->now[i]);
        for (size_t j = 0; j < n; ++j) {
            size += fabs(momentum->mass[i * n + j] * qd[j]);
        }
        jump = jump || fabs(momentum->before[i] - momentum->now[i]) > JUMP * size;
    }
    return jump;
}

lag_status lag_refraction_cross(
    lag_refraction *r, double t, double *x, size_t which, double lookahead, int *refracted, int *back)
{
    lag_motion *motion = r->motion;
    const size_t n = motion->model->nq;
    double *truth = motion->w + r->places.relation + which;
    const double was = *truth;
    double g = 0.0;
    double drift = 0.0;
    double before = 0.0;
    double after = 0.0;
    double size = 0.0;
    double other = 0.0;
    double mu = 0.0;
    lag_system system;
    *refracted = *back = 0;
    if (motion->model->energies == NULL) { /* nothing is known of an energy that jumps */
        return LAG_OK;
    }
    lag_status status = motion->ode.rates(motion, t, x, r->rate);
    if (status != LAG_OK || !differentiate(r, t, x, which, &g, &drift)) {
        return LAG_OK; /* where there are no accelerations, passes tell */
    }
    const double speed = lag_dot(n, r->gradient, x + n) + drift;
    status = lag_momentum_keep(r->momentum, t, x, motion->w);
    status = status == LAG_OK ? energy(r, t, x, &before, &size) : status;
    *truth = 1.0 - was;
    status = status == LAG_OK ? energy(r, t, x, &after, &other) : status;
    status = status == LAG_OK ? lag_momentum_look(r->momentum, t, x) : status;
    const int jumps = fabs(after - before) > JUMP * fmax(size, other) || momenta_jump(r->momentum, x + n);
    if (status != LAG_OK || !jumps || !(fabs(g) <= fabs(speed) * lookahead)) {
        *truth = was;
        return status;
    }
    memcpy(r->rate, x, lag_motion_size(motion->model) * sizeof(double));
    int jumped = 0;
    status = lag_momentum_balance(r->momentum, t, r->rate, NULL, &jumped);
    status = status == LAG_OK ? respond(r, &system) : status;
    if (status == LAG_OK && root(r, t, r->rate, before, speed, drift, &mu)) {
        move(r, r->rate + n, mu);
        *refracted = 1;
    }
    *truth = was;
    if (status == LAG_OK && !*refracted) {
        memcpy(r->rate, x, lag_motion_size(motion->model) * sizeof(double));
        status = lag_momentum_look(r->momentum, t, x);
        status = status == LAG_OK ? respond(r, &system) : status;
        move(r, r->rate + n, status == LAG_OK ? -2.0 * speed / lag_dot(n, r->gradient, r->along) : 0.0);
        *refracted = *back = status == LAG_OK;
    }
    if (status == LAG_OK) {
        memcpy(x + n, r->rate + n, n * sizeof(double));
    }
    return status;
}
