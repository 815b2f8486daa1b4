/* Relations in passes over clauses: as they stand, and what they are a moment later where they pass zero. */
#include <math.h>

#include "lag/events/event_iteration.h"

/* A relation that passes zero within this part of the moment does so at the event. */
static const double PASSING = 1e-2;

void lag_event_iteration_solve(lag_motion *motion, double t, const double *x)
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

static lag_status indicate(lag_event_iteration *iteration, double t, const double *x, double *g)
{
    lag_event_iteration_solve(iteration->motion, t, x);
    return iteration->motion->model->indicator(&iteration->motion->at, g);
}

static int holds(const lag_model *model, size_t i, double g)
{
    return g > 0.0 || (g == 0.0 && model->strict[i] == 0);
}

lag_status lag_event_iteration_stand(lag_event_iteration *iteration, double t, const double *x)
{
    const lag_model *model = iteration->motion->model;
    const lag_status status = model->nindicator > 0 ? indicate(iteration, t, x, iteration->now) : LAG_OK;
    for (size_t i = 0; i < model->nindicator; ++i) {
        iteration->motion->w[iteration->places.relation + i] = holds(model, i, iteration->now[i]);
    }
    return status;
}

void lag_event_iteration_move_on(lag_event_iteration *iteration, double t, const double *x)
{
    lag_motion *motion = iteration->motion;
    const int moves = motion->ode.rates(motion, t, x, iteration->rate) == LAG_OK;
    for (size_t i = 0; i < lag_motion_size(motion->model); ++i) {
        iteration->later[i] = moves ? x[i] + iteration->lookahead * iteration->rate[i] : x[i];
    }
}

/* True if relation i passes zero here, by its values now and after `lookahead`. */
static int passing(const lag_event_iteration *iteration, size_t i)
{
    return fabs(iteration->now[i]) <= PASSING * fabs(iteration->then[i] - iteration->now[i]);
}

/* Round-off of the relations, where one of those that have turned may be zero but for that. */
static void weigh(lag_event_iteration *iteration, double t, const double *x, const double *turned)
{
    int any = 0;
    for (size_t i = 0; i < iteration->motion->model->nindicator && turned != NULL; ++i) {
        any = any || (turned[i] != 0.0 && !passing(iteration, i));
    }
    if (any) {
        lag_noise_find(iteration->noise, t, x);
    }
}

lag_status lag_event_iteration_ahead(lag_event_iteration *iteration, double t, const double *x, const double *turned)
{
    lag_motion *motion = iteration->motion;
    const lag_model *model = motion->model;
    if (model->nindicator == 0) {
        return LAG_OK;
    }
    lag_event_iteration_move_on(iteration, t, x);
    lag_status status = indicate(iteration, t, x, iteration->now);
    if (status == LAG_OK) {
        status = indicate(iteration, t + iteration->lookahead, iteration->later, iteration->then);
    }
    if (status == LAG_OK) {
        weigh(iteration, t, x, turned);
    }
    for (size_t i = 0; i < model->nindicator; ++i) {
        const int passes_zero = passing(iteration, i);
        const int stays = turned != NULL && turned[i] != 0.0 && !passes_zero && fabs(iteration->now[i]) <= iteration->noise->sigma[i];
        if (!stays) {
            motion->w[iteration->places.relation + i] = holds(model, i, passes_zero ? iteration->then[i] : iteration->now[i]);
        }
    }
    return status;
}

lag_status lag_event_iteration_turn(lag_event_iteration *iteration, double t, const double *x)
{
    return lag_event_iteration_ahead(iteration, t, x, NULL);
}
