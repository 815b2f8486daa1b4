/*
 * The derivative of a projection: columns onto the linearized constraints, by the same change of least inertia, which is factored once for
 * all columns.
 */
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
    for (int k = -LAG_POINTS; k <= LAG_POINTS && status == LAG_OK && h > 0.0; k += k == -1 ? 2 : 1) {
        lag_axpy(model->nw, k * h, dw, motion->w);
        lag_delays_displace(&motion->delays, dw + motion->places.delay, k * h);
        status = lag_projection_evaluate(projection, rates);
        lag_delays_displace(&motion->delays, NULL, 0.0);
        lag_axpy(model->nc, (k > 0 ? lag_sixth[k - 1] : -lag_sixth[-k - 1]) / h, projection->phi, projection->step.lam);
        lag_axpy(model->nw, -k * h, dw, motion->w);
    }
    return status == LAG_OK ? lag_projection_evaluate(projection, rates) : status;
}

/* Into `phi` what is left of the conditions on positions, or on rates, along a direction and along discretes dw (nw); their Jacobian stays at hand. */
static lag_status find_residuals(lag_sensitivities *s, lag_run *run, int rates, const lag_arguments *along, const double *dw)
{
    lag_projection *projection = &run->projection;
    const lag_model *model = run->motion.model;
    double *other = projection->step.right; /* the residuals that are not looked at */
    lag_status status = LAG_OK;
    lag_fill(model->nc, 0.0, projection->step.lam);
    if (lag_any(model->nw, dw)) {
        status = along_discretes(projection, rates, dw, lag_columns_step(s, run, dw));
    }
    if (status == LAG_OK) {
        status = model->constraint_tangent(along, rates ? other : projection->phi, rates ? projection->phi : other);
    }
    lag_axpy(model->nc, 1.0, projection->step.lam, projection->phi);
    return status;
}

/* Adds to `to` (nq) the change of least inertia that takes them away, by the response where there is one. */
static lag_status correct(lag_projection *projection, int rates, int responds, double *to)
{
    const lag_model *model = projection->motion->model;
    for (size_t i = 0; i < model->nc && responds; ++i) {
        lag_axpy(model->nq, projection->phi[i], projection->step.response + i * model->nq, to);
    }
    if (!responds && lag_projection_smallest(projection, rates) != LAG_OK) {
        return LAG_PROJECTION_FAILED;
    }
    if (!responds) {
        lag_axpy(model->nq, 1.0, projection->step.change, to);
    }
    return LAG_OK;
}

/* The Jacobian of the conditions, and the response to residuals, which is that of positions where all rows are of position level; *responds: there is one. */
static lag_status prepare(lag_projection *projection, int rates, int *responds)
{
    if (rates && *responds && projection->rows == projection->motion->model->nc) {
        return LAG_OK;
    }
    projection->step.formed = 0;
    lag_status status = lag_projection_evaluate(projection, rates);
    if (status != LAG_OK) {
        return status;
    }
    status = lag_projection_response(projection, rates);
    *responds = status == LAG_OK;
    return status == LAG_OK || status == LAG_MISSING ? LAG_OK : LAG_PROJECTION_FAILED;
}

/* All columns onto the linearized conditions on positions, or on rates. */
static lag_status project(lag_sensitivities *s, lag_run *run, int rates, int *responds, double *directions)
{
    const lag_model *model = run->motion.model;
    const size_t n = model->nq;
    const size_t variables = lag_columns_variables(model);
    double *one = s->work.one;
    double *w = one + variables;
    double *to = one + (rates ? n : 0);
    lag_arguments along = run->motion.at;
    along.dq = one;
    along.dqd = one + n;
    along.dz = one + 2 * n;
    along.du = along.dz + model->nz;
    along.dp = along.du + model->nu;
    lag_status status = prepare(&run->projection, rates, responds);
    for (size_t k = 0; k < s->of.count && status == LAG_OK; ++k) {
        lag_columns_get(s, k, 0, variables, directions, variables, one);
        lag_columns_get(s, k, 0, model->nw, s->columns.w, model->nw, w);
        if (lag_any(variables + model->nw, one)) {
            status = find_residuals(s, run, rates, &along, w);
            status = status == LAG_OK ? correct(&run->projection, rates, *responds, to) : status;
            lag_columns_put(s, k, rates ? n : 0, n, to, directions, variables);
        }
    }
    return status;
}

lag_status lag_columns_project(lag_sensitivities *s, lag_run *run, double t, const double *x, double *directions)
{
    if (run->motion.model->nc == 0) {
        return LAG_OK;
    }
    lag_columns_set_delays(s, run, t);
    lag_motion_set_state(&run->motion, t, x);
    int responds = 0;
    const lag_status status = run->projection.rows > 0 ? project(s, run, 0, &responds, directions) : LAG_OK;
    return status == LAG_OK ? project(s, run, 1, &responds, directions) : status;
}
