#include "lag/impulses/position_maps.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "lag/impulses/impulse.h"
#include "lag/linalg/arena.h"
#include "lag/linalg/vector.h"
#include "lag/optimization/friction_problem.h"

/* A map is continuous at an instant if it is the same there to LAG_SOLVED, or to LAG_FEW round-offs of coordinates or changes of a moment. */

void lag_position_maps_place(lag_position_maps *maps, lag_motion *motion, lag_layout *layout)
{
    maps->motion = motion;
    maps->way = lag_lay(layout, 4 * motion->model->nway);
    maps->point = lag_lay(layout, lag_motion_size(motion->model));
}

/* Ways of masses with discretes w where the motion from x has come after a moment. */
static lag_status evaluate_maps(lag_position_maps *maps, double t, const double *x, const double *w, double moment, double *way)
{
    lag_motion *motion = maps->motion;
    memcpy(maps->point, x, lag_motion_size(motion->model) * sizeof(double));
    lag_axpy(motion->model->nq, moment, x + motion->model->nq, maps->point);
    lag_motion_set_state(motion, t + moment, maps->point);
    motion->at.w = w;
    const lag_status status = motion->model->way(&motion->at, way);
    motion->at.w = motion->w;
    return status;
}

lag_status lag_position_maps_continue(
    lag_position_maps *maps, double t, const double *x, const double *stood, const double *before, double moment, const double *peak)
{
    lag_motion *motion = maps->motion;
    const lag_model *model = motion->model;
    double *was = maps->way;
    double *now = was + model->nway;
    double *later = now + model->nway;
    double *behind = later + model->nway;
    double size = 0.0;
    for (size_t j = 0; j < model->nq; ++j) {
        size = fmax(size, fmax(peak[j], fabs(x[j])));
    }
    lag_status status = evaluate_maps(maps, t, stood, before, 0.0, was);
    status = status == LAG_OK ? evaluate_maps(maps, t, x, motion->w, 0.0, now) : status;
    status = status == LAG_OK ? evaluate_maps(maps, t, stood, before, moment, later) : status;
    status = status == LAG_OK ? evaluate_maps(maps, t, x, motion->w, moment, behind) : status;
    for (size_t i = 0; i < model->nway && status == LAG_OK; ++i) {
        const double own = LAG_SOLVED * (fabs(was[i]) + fabs(now[i]));
        const double noise = LAG_FEW * (DBL_EPSILON * size + fabs(later[i] - was[i]) + fabs(behind[i] - now[i]));
        status = fabs(now[i] - was[i]) > own + noise ? LAG_WAY_JUMP : LAG_OK;
    }
    return status;
}
