#include "lag/events/refraction.h"

#include <math.h>
#include <string.h>

#include "lag/linalg/arena.h"
#include "lag/linalg/vector.h"

/* A jump of energy or momenta below this part of what they are made of is none. */
static const double JUMP = 1e-11;
/* So many round-offs of g are none. */
static const double FEW = 4.0;
/* A row is off by less than this part of its terms after projection. */
static const double LEFT = 1e-9;
/* Differences of rows are along the gradient, or the gradient along the rows, but for this part of their sizes. */
static const double ALONG = 1e-6;
/* The balance of energy is solved where the impulse that is left changes the rate of g by this part. */
static const double NEAR = 1e-9;
/* It has its least value where half of the square of the rate of g is this part of what the energy lacks. */
static const double FLAT = 1e-6;
enum { MOST_STEPS = 100 };

/* The side from which the motion comes. */
typedef struct lag_side {
    double energy; /* h there */
    double drift;  /* rate of g with time and states, the positions held */
    double sense;  /* 1: g grows in the motion that is looked for, -1: it falls */
} lag_side;

void lag_refraction_place(lag_refraction *r, lag_contacts *contacts, lag_noise *noise, lag_layout *layout)
{
    const lag_model *model = contacts->motion->model;
    *r = (lag_refraction){.motion = contacts->motion, .contacts = contacts, .impulse = contacts->impulse, .noise = noise};
    lag_lay_all(layout, model->nq, (double **const[]){&r->gradient, &r->along, &r->before, NULL});
    r->rate = lag_lay(layout, lag_motion_size(model));
    lag_lay_all(layout, model->nindicator, (double **const[]){&r->g, &r->own, &r->truth, NULL});
    r->rows = lag_lay(layout, model->nc * model->nq);
    r->speeds = lag_lay(layout, model->nc);
}

/* ---- both sides ---- */

/* The energy h at x, and the size of what it is made of. */
static lag_status evaluate_energy(const lag_refraction *r, double t, const double *x, double *h, double *size)
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

/* Energy, momenta and rows of constraints at x, with the relations of w. */
static lag_status evaluate_side(lag_refraction *r, double t, const double *x, double *h, double *size)
{
    const lag_status status = evaluate_energy(r, t, x, h, size);
    return status == LAG_OK ? lag_impulse_evaluate(r->impulse, t, x) : status;
}

/* Relation `which` turns, and those that jump to the other side with it; r->truth keeps what they were. */
static void turn_relation(lag_refraction *r, double t, const double *x, size_t which)
{
    lag_motion *motion = r->motion;
    const lag_model *model = motion->model;
    double *truth = motion->w + r->motion->places.relation;
    int turned = 1;
    memcpy(r->truth, truth, model->nindicator * sizeof(double));
    lag_motion_set_state(motion, t, x);
    (void)model->indicator(&motion->at, r->own);
    truth[which] = 1.0 - truth[which];
    for (size_t k = 0; k < model->nindicator && turned; ++k) {
        turned = 0;
        (void)model->indicator(&motion->at, r->g);
        for (size_t i = 0; i < model->nindicator; ++i) {
            const double holds = lag_relation_holds(model, i, r->g[i]);
            const int jumps = fabs(r->g[i] - r->own[i]) > ALONG * (fabs(r->g[i]) + fabs(r->own[i]));
            if (i != which && jumps && holds != truth[i]) {
                truth[i] = holds;
                turned = 1;
            }
        }
    }
}

/* Evaluates this side, then the other one, where relations stay, with its energy in *after, and the size of both energies. */
static lag_status compare_sides(lag_refraction *r, double t, const double *x, size_t which, lag_side *side, double *after, double *size)
{
    const lag_model *model = r->motion->model;
    const lag_impulse *impulse = r->impulse;
    double other = 0.0;
    lag_status status = evaluate_side(r, t, x, &side->energy, size);
    memcpy(r->rows, impulse->jacobian, model->nc * model->nq * sizeof(double));
    memcpy(r->speeds, impulse->residual, model->nc * sizeof(double));
    memcpy(r->before, impulse->now, model->nq * sizeof(double));
    turn_relation(r, t, x, which);
    status = status == LAG_OK ? evaluate_side(r, t, x, after, &other) : status;
    *size = fmax(*size, other);
    return status;
}

/* The coordinate on which g depends most. */
static size_t steepest(const lag_refraction *r, const double *x)
{
    size_t most = 0;
    for (size_t j = 1; j < r->motion->model->nq; ++j) {
        most = fabs(r->gradient[j]) * lag_noise_extent(r->noise, x, j) > fabs(r->gradient[most]) * lag_noise_extent(r->noise, x, most) ? j : most;
    }
    return most;
}

/*
 * 1: rows of constraints of the other side are not satisfied, and differ from those of this side along the gradient only, as where a constraint
 * that is continuous has a corner.
 */
static int rows_bend(const lag_refraction *r, const double *x, double drift)
{
    const size_t n = r->motion->model->nq;
    const lag_impulse *impulse = r->impulse;
    int off = 0;
    const size_t most_of_g = steepest(r, x);
    for (size_t i = 0; i < r->motion->model->nc; ++i) {
        const double *row = impulse->jacobian + i * n;
        const double *was = r->rows + i * n;
        const double part = (row[most_of_g] - was[most_of_g]) / r->gradient[most_of_g];
        const double speed = impulse->residual[i] - lag_dot(n, row, x + n);
        const double own = r->speeds[i] - lag_dot(n, was, x + n);
        double size = fabs(speed) + fabs(own) + fabs(part * drift);
        double most = 0.0;
        double aside = 0.0;
        for (size_t j = 0; j < n; ++j) {
            size += fabs(row[j] * x[n + j]);
            most = fmax(most, (fabs(row[j]) + fabs(was[j])) * lag_noise_extent(r->noise, x, j));
            aside = fmax(aside, fabs(row[j] - was[j] - part * r->gradient[j]) * lag_noise_extent(r->noise, x, j));
        }
        if (aside > ALONG * most || fabs(speed - own - part * drift) > ALONG * size) {
            return 0;
        }
        off = off || fabs(impulse->residual[i]) > LEFT * size;
    }
    return off;
}

/* ---- the impulse problem with the step ---- */

/* Closed contacts at x as rows of the impulse problem that push; a gap with a corner at the step meets the other side by the law of impact. */
static lag_status add_contacts(lag_refraction *r, double t, const double *x)
{
    lag_contacts *contacts = r->contacts;
    const lag_model *model = r->motion->model;
    lag_inequalities_clear(&contacts->blows.rows);
    if (!lag_any(model->ncontact, r->motion->w + r->motion->places.contact)) {
        return LAG_OK;
    }
    const lag_status status = lag_contacts_evaluate_at(contacts, t, x);
    for (size_t i = 0; i < model->ncontact && status == LAG_OK; ++i) {
        const int bends = fabs(contacts->speed[i]) > lag_contacts_speed_band(contacts, i);
        if (*lag_contacts_flag(contacts, i) != 0.0 && !bends) {
            lag_contacts_add_to_blow(contacts, i, 0.0);
        }
    }
    return status;
}

/*
 * The balance of energy for an impulse along the gradient, at rates that the impulse problem has balanced: h behind the place, less h before it and what
 * the place and the constraints that move add to it. Its slope is the rate of g. It is convex in the impulse, as M is positive definite.
 */
typedef struct lag_energy_balance {
    double rest;
    double speed; /* its slope: the rate of g, counted in the sense of the motion behind the place */
    double slope; /* of the speed, by the last two impulses; at first without contacts */
} lag_energy_balance;

/*
 * The same at x, mu being the impulse so far: -mu dg/dt - b' P is what the place and the constraints add, with b' P = -v+ J' P, as
 * J v+ + b = 0.
 */
static lag_status evaluate_balance(lag_refraction *r, double t, const double *x, const lag_side *side, double mu, lag_energy_balance *balance)
{
    const size_t n = r->motion->model->nq;
    const double *qd = x + n;
    double h = 0.0;
    double size = 0.0;
    const lag_status status = evaluate_energy(r, t, x, &h, &size);
    const double change = lag_dot(n, qd, r->impulse->now) - lag_dot(n, qd, r->before);
    const double along = lag_dot(n, r->gradient, qd) + side->drift;
    balance->rest = h - side->energy + mu * along - change;
    balance->speed = side->sense * along;
    return status;
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

/* Rates with an impulse `by` more along the gradient. */
static lag_status add_impulse(lag_refraction *r, double t, double *x, double by)
{
    lag_inequalities *rows = r->contacts->blows.rows.size > 0 ? &r->contacts->blows.rows : NULL;
    int jumped = 0;
    lag_axpy(r->motion->model->nq, by, r->gradient, r->impulse->before);
    return lag_impulse_balance(r->impulse, t, x, NULL, rows, &jumped);
}

/* 1: impulses of the constraints give any rate of g: the motion along the gradient is determined. */
static int is_determined(const lag_refraction *r, const double *x)
{
    const size_t n = r->motion->model->nq;
    double most = 0.0;
    double moved = 0.0;
    for (size_t i = 0; i < n; ++i) {
        const double size = lag_noise_extent(r->noise, x, i);
        most = fmax(most, fabs(r->gradient[i]) * size);
        moved = fmax(moved, fabs(lag_dot(n, r->impulse->mass + i * n, r->along)) * size);
    }
    return moved <= ALONG * most;
}

/*
 * Rates in r->rate that the balance of energy asks for; *found: 0, there are none on the side to which g moves. Newton's method, with the curvature, between
 * impulses that are known to be too small and too large. Where T is quadratic and no contact changes the first step is the last one.
 */
static lag_status find_rates(lag_refraction *r, double t, const double *x, const lag_side *side, int *found)
{
    const size_t n = r->motion->model->nq;
    double low = -(double)INFINITY;
    double high = (double)INFINITY;
    double u = 0.0; /* the impulse, counted in the sense of the motion */
    double by = 0.0;
    int suffices = 0; /* the energy does, at an impulse that was looked at */
    lag_energy_balance b = {0};
    *found = 0;
    memcpy(r->rate, x, lag_motion_size(r->motion->model) * sizeof(double));
    memcpy(r->impulse->before, r->before, n * sizeof(double));
    memcpy(r->impulse->rates, x + n, n * sizeof(double));
    lag_status status = add_contacts(r, t, x);
    status = status == LAG_OK ? add_impulse(r, t, r->rate, 0.0) : status;
    if (status != LAG_OK) {
        return status;
    }
    status = lag_impulse_respond(r->impulse, r->gradient, r->along);
    b.slope = lag_dot(n, r->gradient, r->along);
    if (status == LAG_OK && is_determined(r, x)) {
        *found = 1; /* the balance of momenta says it all */
        lag_contacts_keep_blow(r->contacts);
        return LAG_OK;
    }
    status = status == LAG_OK && !(b.slope > 0.0) ? LAG_SINGULAR : status;
    for (int k = 0; k < MOST_STEPS && status == LAG_OK; ++k) {
        const double speed = b.speed;
        status = evaluate_balance(r, t, r->rate, side, side->sense * u, &b);
        b.slope = k > 0 ? fmax((b.speed - speed) / by, 0.0) : b.slope; /* a contact that drives leaves no slope */
        if (status != LAG_OK || (!suffices && b.rest > 0.0 && b.speed * b.speed <= FLAT * b.rest * b.slope)) {
            return status;
        }
        suffices = suffices || (b.speed > 0.0 && b.rest <= 0.0);
        const int beyond = b.speed > 0.0 && b.rest >= 0.0;
        low = beyond ? low : u;
        high = beyond ? u : high;
        by = impulse_to_root(&b);
        const int last = by == 0.0 || (b.speed > 0.0 && fabs(by) * b.slope <= NEAR * b.speed);
        if (!last && !(u + by > low && u + by < high)) {
            by = 0.5 * (low + high) - u;
        }
        status = add_impulse(r, t, r->rate, side->sense * by);
        if (last) {
            *found = status == LAG_OK;
            lag_contacts_keep_blow(r->contacts);
            break;
        }
        u += by;
    }
    return (status == LAG_OK && !*found) || status == LAG_SINGULAR ? LAG_MOMENTUM_UNREACHABLE : status;
}

lag_status lag_refraction_cross(lag_refraction *r, double t, double *x, size_t which, double lookahead, int *refracted, int *back)
{
    lag_motion *motion = r->motion;
    const size_t n = motion->model->nq;
    const unsigned char *jumping = motion->model->jumping;
    double *truth = motion->w + r->motion->places.relation;
    lag_side side = {.sense = truth[which] == 0.0 ? 1.0 : -1.0};
    double after = 0.0;
    double size = 0.0;
    *refracted = *back = 0;
    if (motion->model->energies == NULL || (jumping != NULL && jumping[which] == 0)) { /* most relations are in forces only */
        return LAG_OK;
    }
    lag_noise_find(r->noise, t, x);
    const double g = r->noise->value[which];
    const lag_status moves = motion->ode.rates(motion, t, x, r->rate);
    if (moves != LAG_OK || !isfinite(g) || !lag_noise_differentiate(r->noise, t, x, which, r->gradient, &side.drift)) {
        return LAG_OK; /* where there are no accelerations, passes tell */
    }
    const double speed = lag_dot(n, r->gradient, x + n) + side.drift;
    const double pull = side.sense * lag_dot(n, r->gradient, r->rate + n);
    const double noise = FEW * r->noise->sigma[which];
    if (fabs(g) > fmax(fabs(speed) * lookahead, noise)) {
        return LAG_OK; /* it is not there */
    }
    lag_status status = compare_sides(r, t, x, which, &side, &after, &size);
    memcpy(r->impulse->before, r->before, n * sizeof(double));
    const int jumps = fabs(after - side.energy) > JUMP * size || lag_impulse_differs(r->impulse, x + n, JUMP) || rows_bend(r, x, side.drift);
    status = status == LAG_OK && jumps ? find_rates(r, t, x, &side, refracted) : status;
    truth[which] = r->truth[which];
    if (!*refracted) {
        memcpy(truth, r->truth, motion->model->nindicator * sizeof(double));
    }
    if (status == LAG_OK && jumps && !*refracted) {
        side.sense = -side.sense;
        status = find_rates(r, t, x, &side, back);
        *refracted = *back;
        if (status == LAG_OK && speed * speed <= 2.0 * pull * noise) {
            return LAG_CHATTER; /* it rests against the step: flights are lost in round-off */
        }
    }
    if (status == LAG_OK && *refracted) {
        memcpy(x + n, r->rate + n, n * sizeof(double));
    }
    return status;
}
