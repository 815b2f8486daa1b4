/* Impacts and accelerations: gaps and slips in the impulse problem (lag/impulses/impulse.h). */
#include <math.h>
#include <string.h>

#include "lag/impulses/friction_problem.h"
#include "lag/impulses/impulse.h"
#include "lag/linalg/arena.h"
#include "lag/linalg/vector.h"

/* The impulses of the rows at impulse->rates, from the momenta of now; each gap parts with this part of its approach at least. */
static lag_status solve_compression(lag_impulse *impulse, double t, double *x, lag_inequalities *rows, const double *rebound)
{
    const size_t n = impulse->motion->model->nq;
    memcpy(impulse->before, impulse->now, n * sizeof(double));
    memcpy(impulse->rates, x + n, n * sizeof(double));
    memcpy(rows->start, rows->speed, rows->size * sizeof(double));
    lag_fill(rows->frictions, 0.0, rows->limits);
    for (size_t i = 0; i < rows->normals && rebound != NULL; ++i) {
        rows->speed[i] += rebound[i] * rows->speed[i];
    }
    const lag_status status = lag_impulse_iterate(impulse, t, x, NULL, rows);
    memcpy(rows->speed, rows->start, rows->size * sizeof(double));
    return status;
}

/* Expansion: impulses of at least e times those of the compression, with their friction. Afterwards rows->force has all of the blow. */
static lag_status expand(lag_impulse *impulse, double t, double *x, lag_inequalities *rows)
{
    const size_t n = impulse->motion->model->nq;
    memcpy(rows->first, rows->force, rows->size * sizeof(double));
    memcpy(impulse->before, impulse->now, n * sizeof(double));
    for (size_t i = 0; i < rows->size; ++i) {
        rows->speed[i] = lag_impulse_speed_at(impulse, rows, i, x + n);
    }
    memcpy(impulse->rates, x + n, n * sizeof(double));
    for (size_t i = 0; i < rows->normals; ++i) {
        const double given = rows->restitution[i] * rows->first[i];
        rows->first[i] += given;
        lag_axpy(n, given, rows->rows + i * n, impulse->before);
        for (size_t k = 0; k < rows->frictions; ++k) {
            rows->limits[k] += rows->coefficients[k * rows->normals + i] * given;
        }
    }
    const lag_status status = lag_impulse_iterate(impulse, t, x, NULL, rows);
    lag_axpy(rows->size, 1.0, rows->first, rows->force);
    return status;
}

/* Work of the impulses of a blow, and the sum of its magnitudes: each with the mean of its speeds before and after, which is exact for a quadratic T. */
static double work_of(const lag_impulse *impulse, const lag_inequalities *rows, const double *qd, double *size)
{
    double work = 0.0;
    *size = 0.0;
    for (size_t i = 0; i < rows->size; ++i) {
        const double term = 0.5 * rows->force[i] * (rows->start[i] + lag_impulse_speed_at(impulse, rows, i, qd));
        work += term;
        *size += fabs(0.5 * rows->force[i] * rows->start[i]) + fabs(term);
    }
    return work;
}

/* The restitutions are not equal; all of them are the least then. */
static int equalize(lag_inequalities *rows)
{
    double least = 1.0;
    double most = 0.0;
    for (size_t i = 0; i < rows->normals; ++i) {
        least = fmin(least, rows->restitution[i]);
        most = fmax(most, rows->restitution[i]);
    }
    lag_fill(rows->normals, least, rows->restitution);
    return least < most;
}

/* Newton's law without friction, Poisson's with it. */
static lag_status solve_restitution(lag_impulse *impulse, double t, double *x, lag_inequalities *rows)
{
    if (rows->frictions == 0) {
        return solve_compression(impulse, t, x, rows, rows->restitution);
    }
    const lag_status status = solve_compression(impulse, t, x, rows, NULL);
    return status == LAG_OK && lag_any(rows->normals, rows->restitution) ? expand(impulse, t, x, rows) : status;
}

lag_status lag_impulse_impact(lag_impulse *impulse, double t, double *x, lag_inequalities *rows)
{
    const size_t n = impulse->motion->model->nq;
    double size = 0.0;
    lag_status status = lag_impulse_evaluate(impulse, t, x);
    memcpy(impulse->point, x + n, n * sizeof(double));
    status = status == LAG_OK ? solve_restitution(impulse, t, x, rows) : status;
    if (status == LAG_OK && work_of(impulse, rows, x + n, &size) > LAG_SOLVED * size && equalize(rows)) {
        memcpy(x + n, impulse->point, n * sizeof(double));
        memcpy(rows->speed, rows->start, rows->size * sizeof(double));
        status = lag_impulse_evaluate(impulse, t, x);
        status = status == LAG_OK ? solve_restitution(impulse, t, x, rows) : status;
    }
    return status;
}

/* ---- accelerations ---- */

lag_status lag_impulse_accelerate(lag_impulse *impulse, double t, const double *x, const double *w, lag_inequalities *rows)
{
    lag_motion *motion = impulse->motion;
    const lag_model *model = motion->model;
    lag_motion_set_state(motion, t, x);
    motion->at.w = w;
    lag_status status = model->dynamics(&motion->at, impulse->mass, impulse->before, impulse->jacobian, impulse->residual);
    motion->at.w = motion->w;
    for (size_t i = 0; i < model->nc; ++i) {
        impulse->residual[i] = -impulse->residual[i];
    }
    lag_fill(model->nq, 0.0, impulse->now);
    lag_fill(model->nq, 0.0, impulse->rates);
    return status == LAG_OK ? lag_impulse_step_find(impulse, NULL, rows, impulse->rates) : status;
}
