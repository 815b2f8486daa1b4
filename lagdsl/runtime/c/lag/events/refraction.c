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
/* A row is off by less than this part of its terms after projection. */
static const double LEFT = 1e-9;
/* Differences of rows are along the gradient, or the gradient along the rows, but for this part of their sizes. */
static const double ALONG = 1e-6;

size_t lag_refraction_memory(const lag_model *model)
{
    return 3 * model->nq + 2 * lag_motion_size(model) + 3 * model->nindicator + model->nc * (model->nq + 1);
}

void lag_refraction_place(lag_refraction *refraction, lag_motion *motion, lag_momentum *momentum, lag_noise *noise, double *memory)
{
    const lag_model *model = motion->model;
    *refraction = (lag_refraction){.motion = motion, .momentum = momentum, .noise = noise, .places = lag_places_of(model)};
    refraction->gradient = lag_take(&memory, model->nq);
    refraction->along = lag_take(&memory, model->nq);
    refraction->before = lag_take(&memory, model->nq);
    refraction->rows = lag_take(&memory, model->nc * model->nq);
    refraction->speeds = lag_take(&memory, model->nc);
    refraction->point = lag_take(&memory, lag_motion_size(model));
    refraction->rate = lag_take(&memory, lag_motion_size(model));
    refraction->g = lag_take(&memory, model->nindicator);
    refraction->own = lag_take(&memory, model->nindicator);
    refraction->truth = memory;
}

/* The indicator at the point, with accelerations and multipliers as they are; not a number where there is none. */
static double indicator(lag_refraction *r, double t, size_t which)
{
    lag_motion_look(r->motion, t, r->point);
    const lag_status status = r->motion->model->indicator(&r->motion->at, r->g);
    return status == LAG_OK ? r->g[which] : (double)NAN;
}

/* The size of coordinate j, or of rate j - nq. */
static double extent(const lag_refraction *r, const double *x, size_t j)
{
    const double own = fmax(r->noise->peak[j], fabs(x[j]));
    return own > 0.0 ? own : 1.0;
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
        const double by = CHANGE * extent(r, x, j);
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
    lag_system_place(system, model->nq, model->nc, model->components, momentum->system);
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

/* 1: impulses of the constraints give any rate of g: the motion along the gradient is determined. */
static int is_determined(const lag_refraction *r, const double *x)
{
    const size_t n = r->motion->model->nq;
    double most = 0.0;
    double moved = 0.0;
    for (size_t i = 0; i < n; ++i) {
        const double size = extent(r, x, i);
        most = fmax(most, fabs(r->gradient[i]) * size);
        moved = fmax(moved, fabs(lag_dot(n, r->momentum->mass + i * n, r->along)) * size);
    }
    return moved <= ALONG * most;
}

/*
 * h behind the place for the impulse mu along the gradient, less h before it and what the place and the constraints that move add to it:
 * -mu dg/dt - b' P with b' P = -v+ J' P, as J v+ + b = 0.
 */
static int balance(lag_refraction *r, double t, double before, double drift, double mu, double *rest)
{
    const size_t n = r->motion->model->nq;
    const double *qd = r->point + n;
    double h = 0.0;
    double size = 0.0;
    if (energy(r, t, r->point, &h, &size) != LAG_OK || lag_momentum_keep(r->momentum, t, r->point, r->motion->w) != LAG_OK) {
        return 0;
    }
    const double change = lag_dot(n, qd, r->momentum->before) - lag_dot(n, qd, r->before);
    *rest = h - before + mu * (drift + lag_dot(n, r->gradient, qd)) - change;
    return 1;
}

/*
 * With w of the other side and mu along the gradient the balance of energy is a parabola: its coefficients, from three places one of which is
 * that at which the rate of g vanishes. The root on the side to which g moves; 0: there is none.
 */
static int root(lag_refraction *r, double t, double *x, double before, double speed, double drift, double *mu)
{
    const size_t n = r->motion->model->nq;
    const double slope = lag_dot(n, r->gradient, r->along);
    const double middle = -(lag_dot(n, r->gradient, x + n) + drift) / slope;
    const double width = fmax(fabs(speed) / slope, DBL_MIN);
    double h[3] = {0.0, 0.0, 0.0};
    for (int k = 0; k < 3; ++k) {
        const double at = middle + (k - 1) * width;
        memcpy(r->point, x, lag_motion_size(r->motion->model) * sizeof(double));
        move(r, r->point + n, at);
        if (!balance(r, t, before, drift, at, &h[k])) {
            return 0;
        }
    }
    const double a = 0.5 * (h[0] + h[2]) - h[1];
    const double b = 0.5 * (h[2] - h[0]);
    const double under = b * b - 4.0 * a * h[1];
    if (!(a > 0.0) || !(under >= 0.0)) {
        return 0;
    }
    const double s = (-b + (speed > 0.0 ? 1.0 : -1.0) * sqrt(under)) / (2.0 * a);
    *mu = middle + s * width;
    return s * speed > 0.0;
}

/*
 * 1: rows of constraints of the other side are not satisfied, and differ from those of this side along the gradient only, as where a constraint
 * that is continuous has a corner.
 */
static int rows_bend(const lag_refraction *r, const double *x, double drift)
{
    const size_t n = r->motion->model->nq;
    const lag_momentum *momentum = r->momentum;
    int off = 0;
    size_t steepest = 0;
    for (size_t j = 1; j < n; ++j) {
        steepest = fabs(r->gradient[j]) * extent(r, x, j) > fabs(r->gradient[steepest]) * extent(r, x, steepest) ? j : steepest;
    }
    for (size_t i = 0; i < r->motion->model->nc; ++i) {
        const double *row = momentum->jacobian + i * n;
        const double *was = r->rows + i * n;
        const double part = (row[steepest] - was[steepest]) / r->gradient[steepest];
        const double speed = momentum->rows[i] - lag_dot(n, row, x + n);
        const double own = r->speeds[i] - lag_dot(n, was, x + n);
        double size = fabs(speed) + fabs(own) + fabs(part * drift);
        double most = 0.0;
        double aside = 0.0;
        for (size_t j = 0; j < n; ++j) {
            size += fabs(row[j] * x[n + j]);
            most = fmax(most, (fabs(row[j]) + fabs(was[j])) * extent(r, x, j));
            aside = fmax(aside, fabs(row[j] - was[j] - part * r->gradient[j]) * extent(r, x, j));
        }
        if (aside > ALONG * most || fabs(speed - own - part * drift) > ALONG * size) {
            return 0;
        }
        off = off || fabs(momentum->rows[i]) > LEFT * size;
    }
    return off;
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

/* Momenta, energy h and its size on this side of relation `which` into r->before, and rows of constraints. */
static lag_status keep(lag_refraction *r, double t, const double *x, double *h, double *size)
{
    const lag_model *model = r->motion->model;
    lag_status status = lag_momentum_look(r->momentum, t, x);
    memcpy(r->rows, r->momentum->jacobian, model->nc * model->nq * sizeof(double));
    memcpy(r->speeds, r->momentum->rows, model->nc * sizeof(double));
    status = status == LAG_OK ? lag_momentum_keep(r->momentum, t, x, r->motion->w) : status;
    memcpy(r->before, r->momentum->before, model->nq * sizeof(double));
    return status == LAG_OK ? energy(r, t, x, h, size) : status;
}

/* Rates behind the place in r->rate; *refracted stays 0 where they are not there. */
static lag_status cross(lag_refraction *r, double t, const double *x, double before, double speed, double drift, int *refracted)
{
    const size_t n = r->motion->model->nq;
    lag_system system;
    double mu = 0.0;
    int jumped = 0;
    memcpy(r->rate, x, lag_motion_size(r->motion->model) * sizeof(double));
    lag_status status = lag_momentum_balance(r->momentum, t, r->rate, NULL, &jumped);
    status = status == LAG_OK ? respond(r, &system) : status;
    if (status == LAG_OK && is_determined(r, x)) {
        *refracted = 1; /* the balance of momenta says it all */
    } else if (status == LAG_OK && root(r, t, r->rate, before, speed, drift, &mu)) {
        move(r, r->rate + n, mu);
        *refracted = 1;
    }
    return status;
}

/* Relation `which` turns, and those that jump to the other side with it; r->truth keeps what they were. */
static void turn(lag_refraction *r, double t, const double *x, size_t which)
{
    const lag_model *model = r->motion->model;
    double *truth = r->motion->w + r->places.relation;
    int turned = 1;
    memcpy(r->truth, truth, model->nindicator * sizeof(double));
    memcpy(r->point, x, lag_motion_size(model) * sizeof(double));
    (void)indicator(r, t, which);
    memcpy(r->own, r->g, model->nindicator * sizeof(double));
    truth[which] = 1.0 - truth[which];
    for (size_t k = 0; k < model->nindicator && turned; ++k) {
        turned = 0;
        (void)indicator(r, t, which);
        for (size_t i = 0; i < model->nindicator; ++i) {
            const double holds = r->g[i] > 0.0 || (r->g[i] == 0.0 && model->strict[i] == 0);
            const int jumps = fabs(r->g[i] - r->own[i]) > ALONG * (fabs(r->g[i]) + fabs(r->own[i]));
            if (i != which && jumps && holds != truth[i]) {
                truth[i] = holds;
                turned = 1;
            }
        }
    }
}

lag_status lag_refraction_cross(
    lag_refraction *r, double t, double *x, size_t which, double lookahead, int *refracted, int *back)
{
    lag_motion *motion = r->motion;
    const size_t n = motion->model->nq;
    double *truth = motion->w + r->places.relation;
    double g = 0.0;
    double drift = 0.0;
    double before = 0.0;
    double after = 0.0;
    double size = 0.0;
    double other = 0.0;
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
    status = keep(r, t, x, &before, &size);
    turn(r, t, x, which);
    status = status == LAG_OK ? energy(r, t, x, &after, &other) : status;
    status = status == LAG_OK ? lag_momentum_look(r->momentum, t, x) : status;
    const int jumps = fabs(after - before) > JUMP * fmax(size, other) || momenta_jump(r->momentum, x + n) || rows_bend(r, x, drift);
    if (status != LAG_OK || !jumps || !(fabs(g) <= fabs(speed) * lookahead)) {
        memcpy(truth, r->truth, motion->model->nindicator * sizeof(double));
        return status;
    }
    status = cross(r, t, x, before, speed, drift, refracted);
    truth[which] = r->truth[which];
    if (status == LAG_OK && !*refracted) {
        memcpy(truth, r->truth, motion->model->nindicator * sizeof(double));
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
