/* The balance of energy across a step in place, and the impulse that satisfies it. */
#include <math.h>
#include <string.h>

#include "lag/events/refraction.h"
#include "lag/linalg/arena.h"
#include "lag/linalg/vector.h"

/* The balance of energy is solved where the impulse that is left changes the rate of g by this part. */
static const double NEAR = 1e-9;
/* It has its least value where half of the square of the rate of g is this part of what the energy lacks. */
static const double FLAT = 1e-6;
enum { MOST_STEPS = 100, MOST_HALVES = 60 };

lag_status lag_refraction_energy(const lag_refraction *r, double t, const double *x, double *h, double *size)
{
    lag_motion *motion = r->motion;
    double total = 0.0;
    double kinetic = 0.0;
    double potential = 0.0;
    lag_motion_set_state(motion, t, x);
    const lag_status status = motion->model->energies(&motion->at, &total, &kinetic, &potential, h);
    *size = fabs(kinetic) + fabs(potential) + fabs(*h);
    return status;
}

/* The balance of energy for an impulse along the gradient. */
typedef struct lag_energy_balance {
    double rest;  /* h behind the place, less h before it and what the place and the constraints that move add to it, */
    double speed; /* its slope: the rate of g, counted in the sense of the motion behind the place */
    double slope; /* of the speed */
} lag_energy_balance;

/*
 * The balance at rates that the impulse problem has balanced, mu being the impulse so far: -mu dg/dt - b' P is what the place and the constraints add,
 * with b' P = -v+ J' P, as J v+ + b = 0.
 */
static lag_status evaluate_balance(lag_refraction *r, double t, const double *x, const lag_side *side, double mu, lag_energy_balance *balance)
{
    const size_t n = r->motion->model->nq;
    const double *qd = x + n;
    double h = 0.0;
    double size = 0.0;
    lag_status status = lag_refraction_energy(r, t, x, &h, &size);
    status = status == LAG_OK ? lag_impulse_respond(r->impulse, r->gradient, r->along) : status;
    const double change = lag_dot(n, qd, r->impulse->now) - lag_dot(n, qd, r->before);
    const double along = lag_dot(n, r->gradient, qd) + side->drift;
    *balance = (lag_energy_balance){
        .rest = h - side->energy + mu * along - change,
        .speed = side->sense * along,
        .slope = lag_dot(n, r->gradient, r->along),
    };
    return status == LAG_SINGULAR || (status == LAG_OK && !(balance->slope > 0.0)) ? LAG_MOMENTUM_UNREACHABLE : status;
}

/* The impulse to the place where a parabola through the balance ends: its root on the side to which g moves, or its least value. */
static double impulse_to_root(const lag_energy_balance *b)
{
    const double under = b->speed * b->speed - 2.0 * b->rest * b->slope;
    if (under <= 0.0) {
        return -b->speed / b->slope;
    }
    return b->speed > 0.0 ? -2.0 * b->rest / (b->speed + sqrt(under)) : (sqrt(under) - b->speed) / b->slope;
}

/* Rates with an impulse `by` more along the gradient, or a part of it where there are no rates for all of it; *by: as much as that. */
static lag_status add_impulse(lag_refraction *r, double t, double *x, double sense, double *by)
{
    const size_t n = r->motion->model->nq;
    const size_t size = lag_motion_size(r->motion->model);
    lag_status status = LAG_MOMENTUM_UNREACHABLE;
    int jumped = 0;
    memcpy(r->point, x, size * sizeof(double));
    memcpy(r->aim, r->impulse->before, n * sizeof(double));
    for (int k = 0; k < MOST_HALVES && status == LAG_MOMENTUM_UNREACHABLE; ++k) {
        *by *= k > 0 ? 0.5 : 1.0;
        memcpy(x, r->point, size * sizeof(double));
        memcpy(r->impulse->before, r->aim, n * sizeof(double));
        lag_axpy(n, sense * *by, r->gradient, r->impulse->before);
        status = lag_impulse_balance(r->impulse, t, x, NULL, &jumped);
    }
    return status;
}

lag_status lag_refraction_find(lag_refraction *r, double t, double *x, const lag_side *side, int *found)
{
    double low = -(double)INFINITY;
    double high = (double)INFINITY;
    double u = 0.0; /* the impulse, counted in the sense of the motion */
    int suffices = 0; /* the energy does, at an impulse that was looked at */
    lag_energy_balance b;
    *found = 0;
    for (int k = 0; k < MOST_STEPS; ++k) {
        lag_status status = evaluate_balance(r, t, x, side, side->sense * u, &b);
        if (status != LAG_OK || (!suffices && b.rest > 0.0 && b.speed * b.speed <= FLAT * b.rest * b.slope)) {
            return status;
        }
        suffices = suffices || (b.speed > 0.0 && b.rest <= 0.0);
        const int beyond = b.speed > 0.0 && b.rest >= 0.0;
        low = beyond ? low : u;
        high = beyond ? u : high;
        double by = impulse_to_root(&b);
        const int last = by == 0.0 || (b.speed > 0.0 && fabs(by) * b.slope <= NEAR * b.speed);
        if (!last && !(u + by > low && u + by < high)) {
            by = 0.5 * (low + high) - u;
        }
        status = add_impulse(r, t, x, side->sense, &by);
        if (status != LAG_OK || last) {
            *found = status == LAG_OK;
            return status;
        }
        u += by;
    }
    return LAG_MOMENTUM_UNREACHABLE;
}
