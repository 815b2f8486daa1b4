/* Relations in passes over clauses: as they stand, and what they are a moment later where they pass zero. */
#include <math.h>

#include "lag/passes.h"

/* A relation that passes zero within this part of the moment does so at the event. */
static const double PASSING = 1e-2;

void lag_passes_solve(lag_motion *motion, double t, const double *x)
{
    const lag_model *model = motion->model;
    const lag_status status = lag_motion_solve(motion, t, x);
    for (size_t i = 0; i < model->nq && status != LAG_OK; ++i) {
        motion->qdd[i] = (double)NAN;
    }
    for (size_t i = 0; i < model->nc && status != LAG_OK; ++i) {
        motion->lam[i] = (double)NAN;
    }
}

static lag_status indicate(lag_passes *passes, double t, const double *x, double *g)
{
    lag_passes_solve(passes->motion, t, x);
    return passes->motion->model->indicator(&passes->motion->at, g);
}

static int holds(const lag_model *model, size_t i, double g)
{
    return g > 0.0 || (g == 0.0 && model->strict[i] == 0);
}

lag_status lag_passes_stand(lag_passes *passes, double t, const double *x)
{
    const lag_model *model = passes->motion->model;
    const lag_status status = model->nindicator > 0 ? indicate(passes, t, x, passes->now) : LAG_OK;
    for (size_t i = 0; i < model->nindicator; ++i) {
        passes->motion->w[passes->places.relation + i] = holds(model, i, passes->now[i]);
    }
    return status;
}

void lag_passes_move_on(lag_passes *passes, double t, const double *x)
{
    lag_motion *motion = passes->motion;
    const int moves = motion->ode.rates(motion, t, x, passes->rate) == LAG_OK;
    for (size_t i = 0; i < lag_motion_size(motion->model); ++i) {
        passes->later[i] = moves ? x[i] + passes->moment * passes->rate[i] : x[i];
    }
}

/* Whether relation i passes zero here, as it was looked at now and a moment later. */
static int passing(const lag_passes *passes, size_t i)
{
    return fabs(passes->now[i]) <= PASSING * fabs(passes->then[i] - passes->now[i]);
}

/* Round-off of the relations, where one of those that have turned may be zero but for that. */
static void weigh(lag_passes *passes, double t, const double *x, const double *turned)
{
    int any = 0;
    for (size_t i = 0; i < passes->motion->model->nindicator && turned != NULL; ++i) {
        any = any || (turned[i] != 0.0 && !passing(passes, i));
    }
    if (any) {
        lag_noise_find(passes->noise, t, x);
    }
}

lag_status lag_passes_ahead(lag_passes *passes, double t, const double *x, const double *turned)
{
    lag_motion *motion = passes->motion;
    const lag_model *model = motion->model;
    if (model->nindicator == 0) {
        return LAG_OK;
    }
    lag_passes_move_on(passes, t, x);
    lag_status status = indicate(passes, t, x, passes->now);
    if (status == LAG_OK) {
        status = indicate(passes, t + passes->moment, passes->later, passes->then);
    }
    if (status == LAG_OK) {
        weigh(passes, t, x, turned);
    }
    for (size_t i = 0; i < model->nindicator; ++i) {
        const int passes_zero = passing(passes, i);
        const int stays = turned != NULL && turned[i] != 0.0 && !passes_zero && fabs(passes->now[i]) <= passes->noise->sigma[i];
        if (!stays) {
            motion->w[passes->places.relation + i] = holds(model, i, passes_zero ? passes->then[i] : passes->now[i]);
        }
    }
    return status;
}

lag_status lag_passes_turn(lag_passes *passes, double t, const double *x)
{
    return lag_passes_ahead(passes, t, x, NULL);
}
