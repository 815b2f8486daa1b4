/* The derivative of a projection: directions of the state onto the linearized constraints, by the same change of least inertia. */
#include <string.h>

#include "lag/linalg/arena.h"
#include "lag/linalg/vector.h"
#include "lag/run.h"
#include "lag/sensitivities/sensitivities.h"

/* Derivative of the residuals along discretes (nw), by differences of step h, into step.lam; w is put back. */
static lag_status along_discretes(lag_projection *projection, int rates, const double *dw, double h)
{
    lag_motion *motion = projection->motion;
    const lag_model *model = motion->model;
    lag_status status = LAG_OK;
    lag_fill(model->nc, 0.0, projection->step.lam);
    for (int k = -LAG_POINTS; k <= LAG_POINTS && status == LAG_OK && h > 0.0; k += k == -1 ? 2 : 1) {
        lag_axpy(model->nw, k * h, dw, motion->w);
        lag_delays_displace(&motion->delays, dw + lag_places_of(model).delay, k * h);
        status = lag_projection_look(projection, rates);
        lag_delays_displace(&motion->delays, NULL, 0.0);
        lag_axpy(model->nc, (k > 0 ? lag_sixth[k - 1] : -lag_sixth[-k - 1]) / h, projection->phi, projection->step.lam);
        lag_axpy(model->nw, -k * h, dw, motion->w);
    }
    return status;
}

/* The change of least inertia of `to` (nq) that takes the residuals away that the direction leaves, of positions or of rates. */
static lag_status correct(lag_projection *projection, lag_arguments *at, int rates, const double *dw, double h, double *to)
{
    const lag_model *model = projection->motion->model;
    double *other = projection->step.right; /* the residuals that are not looked at */
    lag_status status = along_discretes(projection, rates, dw, h);
    status = status == LAG_OK ? lag_projection_look(projection, rates) : status;
    if (status == LAG_OK) {
        status = model->constraint_tangent(at, rates ? other : projection->phi, rates ? projection->phi : other);
    }
    lag_axpy(model->nc, 1.0, projection->step.lam, projection->phi);
    if (status == LAG_OK && lag_projection_smallest(projection, rates) != LAG_OK) {
        status = LAG_PROJECTION_FAILED;
    }
    if (status == LAG_OK) {
        lag_axpy(model->nq, 1.0, projection->step.change, to);
    }
    return status;
}

lag_status lag_projection_tangent(lag_projection *projection, double t, const double *x, const double *dw, double h, double *direction)
{
    lag_motion *motion = projection->motion;
    const size_t n = motion->model->nq;
    lag_motion_set_state(motion, t, x);
    lag_arguments at = motion->at;
    at.dq = direction;
    at.dqd = direction + n;
    at.dz = direction + 2 * n;
    at.du = at.dz + motion->model->nz;
    at.dp = at.du + motion->model->nu;
    projection->step.formed = 0;
    lag_status status = projection->rows > 0 ? correct(projection, &at, 0, dw, h, direction) : LAG_OK;
    projection->step.formed = 0;
    return status == LAG_OK ? correct(projection, &at, 1, dw, h, direction + n) : status;
}
