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

size_t lag_refraction_memory(const lag_model *model)
{
    return 4 * model->nq + 2 * lag_motion_size(model) + 3 * model->nindicator + model->nc * (model->nq + 1);
}

void lag_refraction_place(lag_refraction *refraction, lag_motion *motion, lag_impulse *impulse, lag_noise *noise, double *memory)
{
    const lag_model *model = motion->model;
    *refraction = (lag_refraction){.motion = motion, .impulse = impulse, .noise = noise, .places = lag_places_of(model)};
    lag_take_all(&memory, model->nq, (double **const[]){&refraction->gradient, &refraction->along, &refraction->before, &refraction->aim, NULL});
    refraction->rows = lag_take(&memory, model->nc * model->nq);
    refraction->speeds = lag_take(&memory, model->nc);
    refraction->point = lag_take(&memory, lag_motion_size(model));
    refraction->rate = lag_take(&memory, lag_motion_size(model));
    refraction->g = lag_take(&memory, model->nindicator);
    refraction->own = lag_take(&memory, model->nindicator);
    refraction->truth = memory;
}

/* The indicator at the point, with accelerations and multipliers as they are; not a number where there is none. */
static double indicator_at(lag_refraction *r, double t, size_t which)
{
    lag_motion_set_state(r->motion, t, r->point);
    const lag_status status = r->motion->model->indicator(&r->motion->at, r->g);
    return status == LAG_OK ? r->g[which] : (double)NAN;
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

/* Momenta, energy h and its size on this side of relation `which` into r->before, and rows of constraints. */
static lag_status keep(lag_refraction *r, double t, const double *x, double *h, double *size)
{
    const lag_model *model = r->motion->model;
    lag_status status = lag_impulse_evaluate(r->impulse, t, x);
    memcpy(r->rows, r->impulse->jacobian, model->nc * model->nq * sizeof(double));
    memcpy(r->speeds, r->impulse->residual, model->nc * sizeof(double));
    status = status == LAG_OK ? lag_impulse_keep_momenta(r->impulse, t, x, r->motion->w) : status;
    memcpy(r->before, r->impulse->before, model->nq * sizeof(double));
    return status == LAG_OK ? lag_refraction_energy(r, t, x, h, size) : status;
}

/* Rates behind the place in r->rate; *refracted stays 0 where they are not there. */
static lag_status cross(lag_refraction *r, double t, const double *x, const lag_side *side, int *refracted)
{
    int jumped = 0;
    memcpy(r->rate, x, lag_motion_size(r->motion->model) * sizeof(double));
    memcpy(r->impulse->before, r->before, r->motion->model->nq * sizeof(double));
    lag_status status = lag_impulse_balance(r->impulse, t, r->rate, NULL, &jumped);
    status = status == LAG_OK ? lag_impulse_respond(r->impulse, r->gradient, r->along) : status;
    if (status == LAG_OK && is_determined(r, x)) {
        *refracted = 1; /* the balance of momenta says it all */
        return LAG_OK;
    }
    return status == LAG_OK ? lag_refraction_find(r, t, r->rate, side, refracted) : status;
}

/* Rates with which the motion turns back on this side, in r->rate. */
static lag_status turn_back(lag_refraction *r, double t, const double *x, const lag_side *side, int *back)
{
    const lag_side own = {.energy = side->energy, .drift = side->drift, .sense = -side->sense};
    memcpy(r->rate, x, lag_motion_size(r->motion->model) * sizeof(double));
    memcpy(r->impulse->before, r->before, r->motion->model->nq * sizeof(double));
    const lag_status status = lag_impulse_evaluate(r->impulse, t, r->rate);
    return status == LAG_OK ? lag_refraction_find(r, t, r->rate, &own, back) : status;
}

/* Relation `which` turns, and those that jump to the other side with it; r->truth keeps what they were. */
static void turn_relation(lag_refraction *r, double t, const double *x, size_t which)
{
    const lag_model *model = r->motion->model;
    double *truth = r->motion->w + r->places.relation;
    int turned = 1;
    memcpy(r->truth, truth, model->nindicator * sizeof(double));
    memcpy(r->point, x, lag_motion_size(model) * sizeof(double));
    (void)indicator_at(r, t, which);
    memcpy(r->own, r->g, model->nindicator * sizeof(double));
    truth[which] = 1.0 - truth[which];
    for (size_t k = 0; k < model->nindicator && turned; ++k) {
        turned = 0;
        (void)indicator_at(r, t, which);
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

/* Momenta, rows of constraints and the energy h at x. */
static lag_status evaluate_side(lag_refraction *r, double t, const double *x, double *momenta, double *rows, double *speeds, double *h)
{
    lag_motion *motion = r->motion;
    const lag_model *model = motion->model;
    double size = 0.0;
    lag_fill(model->nq, 0.0, momenta);
    lag_status status = lag_refraction_energy(r, t, x, h, &size);
    if (status == LAG_OK && model->momenta != NULL) {
        status = model->momenta(&motion->at, momenta);
    }
    return status == LAG_OK && model->nc > 0 ? model->velocity_constraint(&motion->at, speeds, rows) : status;
}

/* 1: a relation is in the Lagrangian or in a constraint: what follows from it is not the same. Most are in forces only. */
static int changes_balance(lag_refraction *r, double t, const double *x, size_t which)
{
    const lag_model *model = r->motion->model;
    double *truth = r->motion->w + r->places.relation;
    double before = 0.0;
    double after = 0.0;
    lag_status status = evaluate_side(r, t, x, r->before, r->rows, r->speeds, &before);
    turn_relation(r, t, x, which);
    status = status == LAG_OK ? evaluate_side(r, t, x, r->along, r->impulse->jacobian, r->impulse->residual, &after) : status;
    memcpy(truth, r->truth, model->nindicator * sizeof(double));
    return status != LAG_OK || before != after || !lag_same(model->nq, r->before, r->along) ||
           !lag_same(model->nc, r->speeds, r->impulse->residual) || !lag_same(model->nc * model->nq, r->rows, r->impulse->jacobian);
}

lag_status lag_refraction_cross(
    lag_refraction *r, double t, double *x, size_t which, double lookahead, int *refracted, int *back)
{
    lag_motion *motion = r->motion;
    const size_t n = motion->model->nq;
    double *truth = motion->w + r->places.relation;
    lag_side side = {0};
    double after = 0.0;
    double size = 0.0;
    double other = 0.0;
    *refracted = *back = 0;
    if (motion->model->energies == NULL || !changes_balance(r, t, x, which)) { /* without it nothing is known of an energy that jumps */
        return LAG_OK;
    }
    lag_noise_find(r->noise, t, x);
    const double g = r->noise->value[which];
    lag_status status = motion->ode.rates(motion, t, x, r->rate);
    if (status != LAG_OK || !isfinite(g) || !lag_noise_differentiate(r->noise, t, x, which, r->rate, r->length, r->gradient, &side.drift)) {
        return LAG_OK; /* where there are no accelerations, passes tell */
    }
    const double speed = lag_dot(n, r->gradient, x + n) + side.drift;
    side.sense = truth[which] == 0.0 ? 1.0 : -1.0;
    const double pull = side.sense * lag_dot(n, r->gradient, r->rate + n);
    const double noise = FEW * r->noise->sigma[which];
    const int is_there = fabs(g) <= fmax(fabs(speed) * lookahead, noise);
    status = keep(r, t, x, &side.energy, &size);
    turn_relation(r, t, x, which);
    status = status == LAG_OK ? lag_refraction_energy(r, t, x, &after, &other) : status;
    status = status == LAG_OK ? lag_impulse_evaluate(r->impulse, t, x) : status;
    const int jumps = fabs(after - side.energy) > JUMP * fmax(size, other) || lag_impulse_differs(r->impulse, x + n, JUMP) || rows_bend(r, x, side.drift);
    if (status != LAG_OK || !jumps || !is_there) {
        memcpy(truth, r->truth, motion->model->nindicator * sizeof(double));
        return status;
    }
    status = cross(r, t, x, &side, refracted);
    truth[which] = r->truth[which];
    if (status == LAG_OK && !*refracted) {
        memcpy(truth, r->truth, motion->model->nindicator * sizeof(double));
        status = turn_back(r, t, x, &side, back);
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
