#include "lag/projection.h"

#include <math.h>
#include <string.h>

static const double ROUNDING = 1e-14;
/* So much larger than its limit a residual may stay where round-off or a singular position stops the convergence. */
static const double CLOSE = 1e3;

static size_t position_rows(const lag_model *model)
{
    size_t rows = 0;
    for (size_t i = 0; i < model->nc; ++i) {
        rows += model->position_level[i] != 0;
    }
    return rows;
}

size_t lag_projection_memory(const lag_model *model)
{
    const size_t n = model->nq;
    const size_t m = model->nc;
    return 4 * m + 4 * n + 2 * m * n + n * n + lag_system_memory(n, m);
}

void lag_projection_place(lag_projection *projection, lag_motion *motion, double *memory)
{
    const size_t n = motion->model->nq;
    const size_t m = motion->model->nc;
    memset(projection, 0, sizeof *projection);
    projection->motion = motion;
    projection->rows = position_rows(motion->model);
    projection->iterations = 12;
    projection->limits = memory;
    projection->sizes = projection->limits + m;
    projection->phi = projection->sizes + n;
    projection->jacobian = projection->phi + m;
    projection->mass = projection->jacobian + m * n;
    projection->chosen = projection->mass + n * n;
    projection->right = projection->chosen + m * n;
    projection->force = projection->right + m;
    projection->change = projection->force + n;
    projection->lam = projection->change + n;
    projection->point = projection->lam + m;
    projection->system = projection->point + n;
    for (size_t i = 0; i < n; ++i) {
        projection->sizes[i] = 1.0;
        projection->force[i] = 0.0;
    }
    for (size_t i = 0; i < m; ++i) {
        projection->limits[i] = 0.0;
    }
}

void lag_projection_limits(lag_projection *projection, double tolerance, const double *row_sizes)
{
    for (size_t i = 0; i < projection->motion->model->nc; ++i) {
        projection->limits[i] = fmax(tolerance * fmin(row_sizes[i], 1.0), ROUNDING * row_sizes[i]);
    }
}

/* The largest residual among rows of the level, in limits; `every`: of both levels. Not a number stays none. */
static double largest(const lag_projection *projection, int every)
{
    const lag_model *model = projection->motion->model;
    double most = 0.0;
    for (size_t i = 0; i < model->nc; ++i) {
        if (every || model->position_level[i]) {
            const double part = fabs(projection->phi[i]) / projection->limits[i];
            if (!(part <= most)) {
                most = part;
            }
        }
    }
    return most;
}

/* The change that makes the residuals vanish in the first order. */
static lag_status smallest(lag_projection *projection, int every)
{
    const lag_model *model = projection->motion->model;
    const size_t n = model->nq;
    size_t rows = 0;
    lag_system system;
    for (size_t i = 0; i < model->nc; ++i) {
        if (every || model->position_level[i]) {
            memcpy(projection->chosen + rows * n, projection->jacobian + i * n, n * sizeof(double));
            projection->right[rows++] = -projection->phi[i];
        }
    }
    lag_system_place(&system, n, rows, projection->system);
    const size_t most = rows < model->rank ? rows : model->rank;
    const lag_status status = lag_system_factor(&system, projection->mass, projection->chosen, most, NULL);
    if (status == LAG_OK) {
        lag_system_solve(&system, projection->force, projection->right, projection->change, projection->lam);
    }
    return status;
}

/* Newton's method from x; the result is in `point`. */
static lag_status positions(lag_projection *projection, double t, const double *x, int *moved)
{
    lag_motion *motion = projection->motion;
    const size_t n = motion->model->nq;
    double before = (double)INFINITY;
    memcpy(projection->point, x, n * sizeof(double));
    lag_motion_look(motion, t, x);
    motion->at.q = projection->point;
    for (unsigned k = 0; k < projection->iterations && projection->rows > 0; ++k) {
        lag_status status = motion->model->position_constraint(&motion->at, projection->phi, projection->jacobian);
        const double size = largest(projection, 0);
        if (status != LAG_OK || !(size < (double)INFINITY) || size > CLOSE * before) {
            return LAG_OFF;
        }
        if (size <= 1.0) {
            return LAG_OK;
        }
        before = size;
        if (!*moved) {
            status = motion->model->mass_matrix(&motion->at, projection->mass);
        }
        if (status != LAG_OK || smallest(projection, 0) != LAG_OK) {
            return LAG_OFF;
        }
        *moved = 1;
        for (size_t i = 0; i < n; ++i) {
            projection->point[i] += projection->change[i];
        }
    }
    return projection->rows == 0 || before <= CLOSE ? LAG_OK : LAG_OFF;
}

/* The rates at the positions `point`, into x. */
static lag_status velocities(lag_projection *projection, double *x, int *moved)
{
    lag_motion *motion = projection->motion;
    const size_t n = motion->model->nq;
    double pace = 1.0;
    lag_status status = motion->model->velocity_constraint(&motion->at, projection->phi, projection->jacobian);
    for (size_t i = 0; i < n; ++i) {
        pace = fmax(pace, fabs(x[n + i]) / projection->sizes[i]);
    }
    const double size = largest(projection, 1);
    if (status != LAG_OK || !(size < (double)INFINITY)) {
        return LAG_OFF;
    }
    if (size <= pace) {
        return LAG_OK;
    }
    status = motion->model->mass_matrix(&motion->at, projection->mass);
    if (status != LAG_OK || smallest(projection, 1) != LAG_OK) {
        return LAG_OFF;
    }
    *moved = 1;
    for (size_t i = 0; i < n; ++i) {
        x[n + i] += projection->change[i];
    }
    return LAG_OK;
}

lag_status lag_projection_apply(lag_projection *projection, double t, double *x, int *moved)
{
    const lag_model *model = projection->motion->model;
    *moved = 0;
    if (model->nc == 0) {
        return LAG_OK;
    }
    lag_status status = positions(projection, t, x, moved);
    if (status == LAG_OK) {
        status = velocities(projection, x, moved);
    }
    if (status == LAG_OK && *moved) {
        memcpy(x, projection->point, model->nq * sizeof(double));
        ++projection->count;
    }
    return status;
}
