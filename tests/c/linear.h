/*
 * Mechanisms whose every part is linear: M qdd = f + J'lam, constraints B q = 0, gaps C q + d >= 0. Written by hand, one at a time: what
 * stands in `linear`. The discretes are variables, then those of contacts and of the rest, as lag/model.h wants them.
 */
#ifndef LINEAR_H
#define LINEAR_H

#include <string.h>

#include "lag/model.h"

enum { LINEAR_MOST = 8 };

static struct {
    size_t n, bars, contacts, gaps;
    double mass[LINEAR_MOST], force[LINEAR_MOST], q[LINEAR_MOST], qd[LINEAR_MOST];
    double bar[LINEAR_MOST][LINEAR_MOST], gap[LINEAR_MOST][LINEAR_MOST], rest[LINEAR_MOST], restitution[LINEAR_MOST];
    double brief; /* stick speed and rest time of every contact are this; zero: the defaults */
    size_t closed; /* first entry of w */
} linear;

static size_t linear_discretes; /* their number */

static lag_status linear_prepare(const lag_arguments *at)
{
    (void)at;
    return LAG_OK;
}

static lag_status linear_start(const lag_arguments *at, double *q, double *qd, double *z, double *u)
{
    (void)at;
    (void)z;
    (void)u;
    memcpy(q, linear.q, linear.n * sizeof(double));
    memcpy(qd, linear.qd, linear.n * sizeof(double));
    return LAG_OK;
}

static double linear_product(const double *row, const double *x)
{
    double sum = 0.0;
    for (size_t j = 0; j < linear.n; ++j) {
        sum += row[j] * x[j];
    }
    return sum;
}

static void linear_rows(const lag_arguments *at, const double *x, double with_rest, double *residual, double *jacobian)
{
    const size_t n = linear.n;
    for (size_t i = 0; i < linear.bars; ++i) {
        memcpy(jacobian + i * n, linear.bar[i], n * sizeof(double));
        residual[i] = linear_product(linear.bar[i], x);
    }
    for (size_t i = 0; i < linear.contacts; ++i) {
        const double closed = at->w[linear.closed + i];
        for (size_t j = 0; j < n; ++j) {
            jacobian[(linear.bars + i) * n + j] = closed * linear.gap[i][j];
        }
        residual[linear.bars + i] = closed * (linear_product(linear.gap[i], x) + with_rest * linear.rest[i]);
    }
}

static lag_status linear_position(const lag_arguments *at, double *phi, double *jacobian)
{
    linear_rows(at, at->q, 1.0, phi, jacobian);
    return LAG_OK;
}

static lag_status linear_velocity(const lag_arguments *at, double *residual, double *jacobian)
{
    linear_rows(at, at->qd, 0.0, residual, jacobian);
    return LAG_OK;
}

static lag_status linear_mass(const lag_arguments *at, double *mass)
{
    (void)at;
    memset(mass, 0, linear.n * linear.n * sizeof(double));
    for (size_t i = 0; i < linear.n; ++i) {
        mass[i * (linear.n + 1)] = linear.mass[i];
    }
    return LAG_OK;
}

static lag_status linear_dynamics(const lag_arguments *at, double *mass, double *force, double *jacobian, double *gamma)
{
    memcpy(force, linear.force, linear.n * sizeof(double));
    linear_rows(at, at->q, 0.0, gamma, jacobian);
    memset(gamma, 0, (linear.bars + linear.contacts) * sizeof(double));
    return linear_mass(at, mass);
}

static lag_status linear_inverse_dynamics(const lag_arguments *at, double *force)
{
    for (size_t i = 0; i < linear.n; ++i) {
        force[i] = linear.mass[i] * at->qdd[i] - linear.force[i];
    }
    return LAG_OK;
}

static lag_status linear_tangent(const lag_arguments *at, double *motion, double *rows)
{
    (void)at;
    memset(motion, 0, linear.n * sizeof(double));
    memset(rows, 0, (linear.bars + linear.contacts) * sizeof(double));
    return LAG_OK;
}

static lag_status linear_contact(
    const lag_arguments *at, double *gap, double *speed, double *jacobian, double *restitution, double *capture_speed, double *rest)
{
    for (size_t i = 0; i < linear.gaps; ++i) {
        gap[i] = linear_product(linear.gap[i], at->q) + linear.rest[i];
        speed[i] = linear_product(linear.gap[i], at->qd);
        memcpy(jacobian + i * linear.n, linear.gap[i], linear.n * sizeof(double));
    }
    for (size_t i = 0; i < linear.contacts; ++i) {
        restitution[i] = linear.restitution[i];
        capture_speed[i] = rest[i] = linear.brief > 0.0 ? linear.brief : -1.0;
    }
    return LAG_OK;
}

static lag_status linear_discrete_start(const lag_arguments *at, double *w)
{
    (void)at;
    memset(w, 0, linear_discretes * sizeof(double));
    return LAG_OK;
}

/* A pass over no clauses. */
static lag_status linear_event(const lag_arguments *at, double *next, double *reset, double *value, double *collision,
    double *restitution, double *stop, double *fail)
{
    (void)reset;
    (void)value;
    (void)collision;
    (void)restitution;
    (void)stop;
    (void)fail;
    memcpy(next, at->w, linear_discretes * sizeof(double));
    return LAG_OK;
}

/* The model of what stands in `linear` now, without clauses. */
static inline lag_model linear_model(void)
{
    static const double nothing[1];
    static const unsigned char flags[2 * LINEAR_MOST] = {1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1};
    static const unsigned char zeros[2 * LINEAR_MOST];
    static unsigned char kinds[2 * LINEAR_MOST];
    static size_t rows[LINEAR_MOST];
    static lag_slot slots[LINEAR_MOST];
    linear_discretes = 2 * linear.contacts;
    linear.closed = 0;
    for (size_t i = 0; i < LINEAR_MOST; ++i) {
        slots[i] = (lag_slot){"q", "m", NULL};
    }
    for (size_t i = 0; i < linear.contacts; ++i) {
        kinds[i] = LAG_KIND_CONTACT;
        kinds[linear.contacts + i] = LAG_KIND_IMPACTS;
        rows[i] = linear.bars + i;
    }
    return (lag_model){
        .version = LAG_MODEL_VERSION, .size = sizeof(lag_model), .name = "Linear",
        .nq = linear.n, .nw = linear_discretes, .nc = linear.bars + linear.contacts, .rank = linear.bars + linear.contacts,
        .workspace = 1, .coordinates = slots, .defaults = nothing, .position_level = flags, .redundant = zeros,
        .prepare = linear_prepare, .start = linear_start, .position_constraint = linear_position,
        .velocity_constraint = linear_velocity, .mass_matrix = linear_mass, .dynamics = linear_dynamics,
        .inverse_dynamics = linear_inverse_dynamics, .residual_tangent = linear_tangent,
        .ncontact = linear.contacts, .ngap = linear.gaps, .discrete_start = linear_discrete_start, .contact = linear_contact,
        .event = linear_event, .kinds = kinds, .contact_rows = rows,
    };
}

#endif
