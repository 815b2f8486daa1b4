#include "lag/derivatives.h"

#include <math.h>
#include <string.h>

#include "lag/equations/feedback.h"
#include "lag/linalg/finite.h"
#include "lag/linalg/arena.h"

static size_t variables(const lag_model *model)
{
    return 2 * model->nq + model->nz + model->nu + model->np;
}

/* Entries of what time_tangent() tells. */
static size_t timed(const lag_model *model)
{
    return model->nq + 3 * model->nc + model->nz + model->ny + 4 + model->nd;
}

size_t lag_derivatives_memory(const lag_model *model)
{
    const size_t n = model->nq;
    const size_t m = model->nc;
    return variables(model) + timed(model) + n * n + 2 * m * n + 5 * n + 7 * m + lag_system_memory(n, m);
}

/* Memory that the accelerations alone need; with lag_feedback_memory() less than lag_jacobian_memory(). */
static void place_system(lag_derivatives *d, const lag_model *model, double **memory)
{
    const size_t n = model->nq;
    const size_t m = model->nc;
    memset(d, 0, sizeof *d);
    d->model = model;
    d->terms.mass = lag_take(memory, n * n);
    d->terms.force = lag_take(memory, n);
    d->terms.jacobian = lag_take(memory, m * n);
    d->terms.gamma = lag_take(memory, m);
    d->terms.phi = lag_take(memory, m);
    d->terms.residual = lag_take(memory, m);
    d->work.unused = lag_take(memory, m * n);
    lag_system_place(&d->system, n, m, model->components, lag_take(memory, lag_system_memory(n, m)));
    d->system.choice.late = model->redundant; /* off the constraints it matters which row is taken, and must not change with a bit */
}

void lag_derivatives_size(lag_derivatives *d, const double *sizes, const double *row_sizes)
{
    d->system.choice.sizes = sizes;
    d->system.choice.row_sizes = row_sizes;
}

void lag_derivatives_place(lag_derivatives *d, const lag_model *model, double *memory)
{
    const size_t n = model->nq;
    const size_t m = model->nc;
    place_system(d, model, &memory);
    d->x = lag_take(&memory, variables(model));
    d->alone = lag_take(&memory, timed(model));
    d->qdd = lag_take(&memory, n);
    d->lam = lag_take(&memory, m);
    d->dqdd = lag_take(&memory, n);
    d->dlam = lag_take(&memory, m);
    d->work.motion = lag_take(&memory, n);
    d->work.rows = lag_take(&memory, m);
    d->least = lag_take(&memory, n);
    d->work.pulled = lag_take(&memory, m);
    lag_fill(variables(model), 0.0, d->x);
}

/* Adds factor * (2 rate residual + rate^2 phi) to the rows. */
static void stabilize(const lag_model *model, double rate, double factor, const double *phi, const double *residual, double *rows)
{
    for (size_t i = 0; i < model->nc; ++i) {
        const double pull = model->position_level[i] ? 2.0 * rate * residual[i] + rate * rate * phi[i] : rate * residual[i];
        rows[i] += factor * pull;
    }
}

/* M, f, J and gamma at a state, with the pull towards the constraints. */
static lag_status form(lag_derivatives *d)
{
    const lag_model *model = d->model;
    if (model->dynamics == NULL || model->position_constraint == NULL || model->velocity_constraint == NULL) {
        return LAG_MISSING;
    }
    lag_status status = model->dynamics(&d->at, d->terms.mass, d->terms.force, d->terms.jacobian, d->terms.gamma);
    if (status == LAG_OK && d->rate > 0.0 && model->nc > 0) {
        status = model->position_constraint(&d->at, d->terms.phi, d->work.unused);
        if (status == LAG_OK) {
            status = model->velocity_constraint(&d->at, d->terms.residual, d->work.unused);
        }
        if (status == LAG_OK) {
            stabilize(model, d->rate, -1.0, d->terms.phi, d->terms.residual, d->terms.gamma);
        }
    }
    return status;
}

/* Independent rows: those of open contacts and of slips are zero, and another one that depends on the rest must not take their place. */
static size_t independent(const lag_derivatives *d)
{
    const lag_model *model = d->model;
    size_t count = model->rank;
    for (size_t i = 0; i < model->ncontact; ++i) {
        count -= count > 0 && !lag_any(model->nq, d->terms.jacobian + model->contact_rows[i] * model->nq);
    }
    for (size_t i = 0; i < model->nslip; ++i) {
        count -= count > 0 && !lag_any(model->nq, d->terms.jacobian + model->friction_rows[i] * model->nq);
    }
    return count;
}

static lag_status solve(lag_derivatives *d, double *qdd, double *lam, size_t *coordinate)
{
    const lag_model *model = d->model;
    lag_status status = form(d);
    if (status == LAG_OK) {
        status = lag_system_factor(&d->system, d->terms.mass, d->terms.jacobian, independent(d), coordinate);
    }
    if (status != LAG_OK) {
        return status;
    }
    lag_system_solve(&d->system, d->terms.force, d->terms.gamma, qdd, lam);
    return lag_finite(model->nq, qdd) && lag_finite(model->nc, lam) ? LAG_OK : LAG_NOT_FINITE;
}

static void point_at_direction(lag_derivatives *d)
{
    const lag_model *model = d->model;
    d->at.dq = d->x;
    d->at.dqd = d->at.dq + model->nq;
    d->at.dz = d->at.dqd + model->nq;
    d->at.du = d->at.dz + model->nz;
    d->at.dp = d->at.du + model->nu;
    d->at.dqdd = d->dqdd;
    d->at.dlam = d->dlam;
}

lag_status lag_derivatives_factor(lag_derivatives *d, const lag_arguments *at, double rate, size_t *coordinate)
{
    d->rate = rate;
    d->at = *at;
    d->at.qdd = d->qdd;
    d->at.lam = d->lam;
    d->timed = 0;
    point_at_direction(d);
    const lag_status status = solve(d, d->qdd, d->lam, coordinate);
    if (status == LAG_OK) {
        lag_system_least(&d->system, d->lam, d->least);
    }
    return status;
}

/* The system with other loads; at the last one the coordinate that is not determined. */
typedef struct pulled {
    lag_derivatives d;
    size_t *coordinate;
} pulled;

static lag_status solve_with_loads(void *context, const lag_arguments *at, int again, double *qdd, double *lam)
{
    pulled *one = context;
    (void)again;
    one->d.at = *at;
    return solve(&one->d, qdd, lam, one->coordinate);
}

lag_status lag_motion_pulled(lag_motion *motion, double rate, double t, const double *x, double *qdd, double *lam)
{
    const lag_model *model = motion->model;
    pulled one = {.coordinate = &motion->coordinate};
    double *memory = motion->memory;
    lag_motion_set_state(motion, t, x);
    place_system(&one.d, model, &memory);
    lag_derivatives_size(&one.d, motion->sizes, motion->row_sizes);
    one.d.rate = rate;
    if (model->nload == 0 || rate > 0.0) {
        return solve_with_loads(&one, &motion->at, 0, qdd, lam);
    }
    lag_arguments at = motion->at;
    at.qdd = qdd;
    at.lam = lam;
    const lag_status status = lag_feedback_solve(model, &motion->at, solve_with_loads, &one, memory, NULL, qdd, lam);
    return status == LAG_OK ? lag_motion_take_loads(motion, &at) : status;
}

/* `alone`, in the order of lag/model.h; filled once for a state. */
static lag_status in_time(lag_derivatives *d)
{
    const lag_model *model = d->model;
    const size_t m = model->nc;
    double *rows = d->alone + model->nq;
    double *rates = rows + 3 * m;
    double *y = rates + model->nz;
    double *energies = y + model->ny;
    if (d->timed) {
        return LAG_OK;
    }
    if (model->time_tangent == NULL) {
        return LAG_MISSING;
    }
    d->timed = 1;
    return model->time_tangent(&d->at, d->alone, rows, rows + m, rows + 2 * m, rates, y, energies, energies + 1, energies + 2,
        energies + 3, energies + 4);
}

/* Adds what changes with time alone, from entry `first` of it on. */
static lag_status add_time(lag_derivatives *d, size_t first, size_t count, double *to)
{
    if (d->time == 0.0 || count == 0) {
        return LAG_OK;
    }
    const lag_status status = in_time(d);
    for (size_t i = 0; i < count && status == LAG_OK; ++i) {
        to[i] += d->time * d->alone[first + i];
    }
    return status;
}

/* Derivatives of the constraint residuals along the direction. */
lag_status lag_derivatives_residuals(lag_derivatives *d, double *phi, double *residual)
{
    const size_t first = d->model->nq + d->model->nc;
    if (d->model->constraint_tangent == NULL) {
        return LAG_MISSING;
    }
    lag_status status = d->model->constraint_tangent(&d->at, phi, residual);
    if (status == LAG_OK) {
        status = add_time(d, first, d->model->nc, phi);
    }
    return status == LAG_OK ? add_time(d, first + d->model->nc, d->model->nc, residual) : status;
}

/* The largest magnitude. */
static double size(size_t count, const double *x)
{
    double most = 0.0;
    for (size_t i = 0; i < count; ++i) {
        most = fmax(most, fabs(x[i]));
    }
    return most;
}

/*
 * Rows E beyond the rank have no effect, J' E = 0, and E lam = 0. Differentiated, with lam = J v: E dlam = E dJ v. That is added to dlam,
 * which has no such parts yet. dJ v is what s = J qdd - gamma changes by more where the accelerations are more by v; v is taken as large as
 * they are, so that the difference keeps its digits.
 */
static lag_status turn_multipliers(lag_derivatives *d)
{
    const lag_model *model = d->model;
    const size_t n = model->nq;
    const size_t m = model->nc;
    const lag_system *system = &d->system;
    const double length = size(n, d->least);
    const double more_by = fmax(size(n, d->qdd), 1.0);
    if (system->rank == m || !(length > 0.0)) {
        return LAG_OK;
    }
    lag_arguments more = d->at;
    more.qdd = d->work.motion;
    for (size_t i = 0; i < n; ++i) {
        d->work.motion[i] = d->qdd[i] + more_by / length * d->least[i];
    }
    lag_status status = model->residual_tangent(&more, d->terms.force, d->work.pulled);
    if (status == LAG_OK) {
        status = model->residual_tangent(&d->at, d->terms.force, d->work.rows);
    }
    for (size_t i = 0; i < m; ++i) {
        d->work.pulled[i] = (d->work.pulled[i] - d->work.rows[i]) * length / more_by;
    }
    for (size_t k = system->rank; k < m; ++k) { /* rows that are zero are combinations by themselves */
        const size_t own = (size_t)system->pivot[k];
        d->dlam[own] += lag_any(n, system->jacobian + own * n) ? 0.0 : d->work.pulled[own];
    }
    for (size_t k = 0; k < system->combinations; ++k) {
        const double *direction = system->excess + k * m;
        double part = 0.0;
        for (size_t i = 0; i < m; ++i) {
            part += direction[i] * d->work.pulled[i];
        }
        for (size_t i = 0; i < m; ++i) {
            d->dlam[i] += part * direction[i];
        }
    }
    return status;
}

lag_status lag_derivatives_along(lag_derivatives *d)
{
    const lag_model *model = d->model;
    const size_t n = model->nq;
    const size_t m = model->nc;
    if (model->residual_tangent == NULL) {
        return LAG_MISSING;
    }
    lag_status status = model->residual_tangent(&d->at, d->work.motion, d->work.rows);
    if (status == LAG_OK) {
        status = add_time(d, 0, n, d->work.motion);
    }
    if (status == LAG_OK) {
        status = add_time(d, n, m, d->work.rows);
    }
    if (status == LAG_OK && d->rate > 0.0 && m > 0) {
        status = lag_derivatives_residuals(d, d->terms.phi, d->terms.residual);
        stabilize(model, d->rate, 1.0, d->terms.phi, d->terms.residual, d->work.rows);
    }
    if (status != LAG_OK) {
        return status;
    }
    for (size_t i = 0; i < n; ++i) {
        d->terms.force[i] = -d->work.motion[i];
    }
    for (size_t i = 0; i < m; ++i) {
        d->terms.gamma[i] = -d->work.rows[i];
    }
    lag_system_solve(&d->system, d->terms.force, d->terms.gamma, d->dqdd, d->dlam);
    status = turn_multipliers(d);
    return status == LAG_OK && !(lag_finite(n, d->dqdd) && lag_finite(m, d->dlam)) ? LAG_NOT_FINITE : status;
}

lag_status lag_derivatives_rates(lag_derivatives *d, double *rates)
{
    const lag_model *model = d->model;
    const size_t n = model->nq;
    if (model->nz > 0 && model->state_derivative_tangent == NULL) {
        return LAG_MISSING;
    }
    memcpy(rates, d->at.dqd, n * sizeof(double));
    memcpy(rates + n, d->dqdd, n * sizeof(double));
    const lag_status status = model->nz > 0 ? model->state_derivative_tangent(&d->at, rates + 2 * n) : LAG_OK;
    return status == LAG_OK ? add_time(d, n + 3 * model->nc, model->nz, rates + 2 * n) : status;
}

lag_status lag_derivatives_outputs(lag_derivatives *d, double *y)
{
    const lag_model *model = d->model;
    if (model->ny > 0 && model->output_tangent == NULL) {
        return LAG_MISSING;
    }
    const lag_status status = model->ny > 0 ? model->output_tangent(&d->at, y) : LAG_OK;
    return status == LAG_OK ? add_time(d, model->nq + 3 * model->nc + model->nz, model->ny, y) : status;
}

lag_status lag_derivatives_definitions(lag_derivatives *d, double *values)
{
    const lag_model *model = d->model;
    if (model->definition_tangent == NULL) {
        return LAG_MISSING;
    }
    const lag_status status = model->nd > 0 ? model->definition_tangent(&d->at, values) : LAG_OK;
    return status == LAG_OK ? add_time(d, timed(model) - model->nd, model->nd, values) : status;
}

lag_status lag_derivatives_energies(lag_derivatives *d, double *energies)
{
    const lag_model *model = d->model;
    double jacobi = 0.0;
    if (model->energies_tangent == NULL) {
        return LAG_MISSING;
    }
    const lag_status status = model->energies_tangent(&d->at, &energies[0], &energies[1], &energies[2], &jacobi);
    return status == LAG_OK ? add_time(d, timed(model) - model->nd - 4, 3, energies) : status;
}
