#include "lag/columns.h"

static void clear(size_t count, double *x)
{
    for (size_t i = 0; i < count; ++i) {
        x[i] = 0.0;
    }
}

static void negate(size_t count, double *x)
{
    for (size_t i = 0; i < count; ++i) {
        x[i] = -x[i];
    }
}

/* Coordinates of each component, one behind another. */
typedef struct chains {
    double *place;  /* (nq) number of each coordinate within its component */
    double *before; /* (nq) the coordinate before it in the same, plus one; zero: there is none */
    double *last;   /* (nq) by component: its last coordinate, plus one; zero: it has none */
    size_t most;    /* the most that there are in one */
} chains;

/* Components have numbers below nq; coordinates of others share the first chain. */
static size_t chain_of(const lag_model *model, size_t coordinate)
{
    const size_t component = model->components != NULL ? model->components[coordinate] : 0;
    return component < model->nq ? component : 0;
}

static chains link(const lag_model *model, double *memory)
{
    const size_t n = model->nq;
    chains c = {.place = memory, .before = memory + n, .last = memory + 2 * n};
    clear(n, c.last);
    for (size_t i = 0; i < n; ++i) {
        double *last = c.last + chain_of(model, i);
        c.before[i] = *last;
        c.place[i] = *last > 0.0 ? c.place[(size_t)*last - 1] + 1.0 : 0.0;
        c.most = c.place[i] + 1.0 > (double)c.most ? (size_t)c.place[i] + 1 : c.most;
        *last = (double)(i + 1);
    }
    return c;
}

/* Row i of M, from the sum of rows of several components. */
static void take_own(const lag_model *model, const chains *c, size_t i, const double *sum, double *row)
{
    for (size_t j = (size_t)c->last[chain_of(model, i)]; j > 0; j = (size_t)c->before[j - 1]) {
        row[j - 1] = model->components == NULL || model->components[j - 1] == model->components[i] ? sum[j - 1] : 0.0;
    }
}

/* M is symmetric: columns are rows. Coordinates of two components share no entry, so that one product serves a coordinate of each. */
lag_status lag_mass_by_columns(const lag_model *model, const lag_arguments *at, double *memory, double *mass)
{
    const size_t n = model->nq;
    double *sum = memory + n;
    const chains c = link(model, memory + 2 * n);
    lag_arguments along = *at;
    lag_status status = LAG_OK;
    along.dqd = memory;
    for (size_t k = 0; k < c.most && status == LAG_OK; ++k) {
        for (size_t i = 0; i < n; ++i) {
            memory[i] = c.place[i] == (double)k ? 1.0 : 0.0;
        }
        status = model->momentum_tangent(&along, sum);
        for (size_t i = 0; i < n && status == LAG_OK; ++i) {
            if (memory[i] != 0.0) {
                clear(lag_is_kept(at, mass) ? 0 : n, mass + i * n);
                take_own(model, &c, i, sum, mass + i * n);
            }
        }
    }
    return status;
}

lag_status lag_dynamics_by_columns(
    const lag_model *model,
    const lag_arguments *at,
    double *memory,
    double *mass,
    double *force,
    double *jacobian,
    double *gamma)
{
    const size_t n = model->nq;
    lag_arguments still = *at;
    double *const unused = memory + n + model->nc; /* (nq) */
    lag_status status = lag_mass_by_columns(model, at, memory, mass);
    clear(n + model->nc, memory);
    still.qdd = memory;
    still.lam = memory + n;
    if (status == LAG_OK) {
        status = model->inverse_dynamics(&still, force);
    }
    if (status == LAG_OK) {
        status = model->velocity_constraint(at, gamma, jacobian);
    }
    if (status == LAG_OK) {
        status = model->residual(&still, unused, gamma);
    }
    if (status == LAG_OK) {
        negate(n, force);
        negate(model->nc, gamma);
    }
    return status;
}
