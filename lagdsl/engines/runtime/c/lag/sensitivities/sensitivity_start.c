/* Columns at the start: the search for it is a map, differentiated as a whole (differences.c). */
#include <math.h>
#include <string.h>

#include "lag/initial.h"
#include "lag/linalg/arena.h"
#include "lag/run.h"
#include "lag/sensitivities/sensitivities.h"

typedef struct start_map {
    lag_sensitivities *s;
    lag_run *run;
    double t;
    const unsigned char *set;
    const double *values;  /* start values that are given */
    unsigned char *chosen; /* the same flags, and those of start values that move */
} start_map;

/* The state that is found, and parameters that are found with it. run->stepper.x is displaced from zero along the direction of start values. */
static lag_status start_values(void *context, double *values)
{
    const start_map *map = context;
    lag_run *run = map->run;
    const lag_model *model = run->motion.model;
    const size_t n = lag_motion_size(model);
    double *x = run->point;
    int moved = 0;
    memcpy(map->s->work.u, run->motion.u, model->nu * sizeof(double));
    lag_status status = lag_motion_start(&run->motion, map->t, x);
    memcpy(run->motion.u, map->s->work.u, model->nu * sizeof(double));
    for (size_t i = 0; i < n; ++i) {
        x[i] = (map->set != NULL && map->set[i] ? map->values[i] : x[i]) + run->stepper.x[i];
    }
    lag_initial told = {.dependent = run->ranks.dependent};
    if (status == LAG_OK) {
        status = run->options.start != NULL ? lag_run_find(run, map->t, map->chosen, x, &told) : lag_projection_apply(&run->projection, map->t, x, &moved);
    }
    memcpy(values, x, n * sizeof(double));
    for (size_t i = 0; i < model->np; ++i) {
        values[n + i] = run->motion.at.p[i];
    }
    return status;
}

lag_status lag_sensitivities_start(lag_sensitivities *s, lag_run *run, double t, const unsigned char *set, const double *values)
{
    const lag_model *model = run->motion.model;
    const size_t n = lag_motion_size(model);
    const size_t variables = lag_columns_variables(model);
    start_map map = {s, run, t, set, values, s->chosen};
    double *found = s->instant.behind;
    double error = 0.0;
    lag_status status = LAG_OK;
    for (size_t i = 0; i < model->np; ++i) {
        s->scales[i] = run->motion.at.p[i] != 0.0 ? fabs(run->motion.at.p[i]) : 1.0;
    }
    memcpy(s->instant.sizes, run->sizes.found ? run->sizes.natural : run->options.sizes.natural, n * sizeof(double));
    memcpy(s->instant.sizes + n, s->scales, model->np * sizeof(double));
    lag_fill(n, 0.0, run->stepper.x);
    lag_differences_begin(&s->differences, run, s->scales, LAG_FINEST_STEP_OF_SEARCH);
    for (size_t k = 0; k < s->of.count && status == LAG_OK; ++k) {
        const lag_displacement along = {0.0, s->of.start + k * n, NULL, s->of.u + k * model->nu, s->of.p + k * model->np, NULL};
        for (size_t i = 0; i < n; ++i) {
            s->chosen[i] = (set != NULL && set[i]) || along.x[i] != 0.0;
        }
        s->columns.extent[k] = lag_differences_extent(&s->differences, &along);
        status = lag_differences_along(&s->differences, &along, n + model->np, s->instant.sizes, start_values, &map, found, &error);
        if (status == LAG_NOT_SMOOTH) {
            s->fault.t = t;
            s->fault.guard = k;
        }
        lag_columns_put(s, k, 0, n, found, s->columns.x, variables);
        lag_columns_put(s, k, n + model->nu, model->np, found + n, s->columns.x, variables);
    }
    lag_differences_end(&s->differences);
    lag_columns_follow_parameters(s, model);
    s->columns.t = s->columns.t_before = t;
    return status;
}
