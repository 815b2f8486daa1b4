#include "lag/run/conditions.h"

#include <math.h>

#include "lag/run.h"

size_t lag_conditions_memory(const lag_model *model)
{
    return 2 * model->ni + 2 * model->na;
}

/* The scale of invariant i, with the present state. */
static double size_of(const lag_conditions *watch, size_t i)
{
    return lag_conditions_size(watch->start[i], watch->scale[i], watch->size[i]);
}

static int invariants_hold(const lag_conditions *watch)
{
    int within = 1;
    for (size_t i = 0; i < watch->motion->model->ni; ++i) {
        within = within && lag_conditions_drift(watch->value[i], watch->start[i]) <= watch->tolerance[i] * size_of(watch, i);
    }
    return within;
}

void lag_conditions_count(lag_conditions *watch)
{
    for (size_t i = 0; i < watch->motion->model->ni; ++i) {
        watch->size[i] = size_of(watch, i);
        watch->drift[i] = lag_higher(lag_conditions_drift(watch->value[i], watch->start[i]), watch->drift[i]);
    }
}

static void take(size_t count, size_t lanes, const double *from, double *to)
{
    for (size_t i = 0; i < count; ++i) {
        to[i] = from[i * lanes];
    }
}

/* True if all of it is known at this state, and taken. */
static int is_known(lag_conditions *watch, double t, const double *x)
{
    const lag_known_conditions *known = &watch->known;
    const lag_model *model = watch->motion->model;
    const size_t size = lag_motion_size(model);
    const double *from = known->x;
    size_t i = 0;
    if (from == NULL || *known->t != t) {
        return 0;
    }
    watch->known.x = NULL;
    while (i < size && x[i] == from[i * known->lanes]) {
        ++i;
    }
    if (i == size) {
        take(model->ni, known->lanes, known->value, watch->value);
        take(model->ni, known->lanes, known->scale, watch->scale);
        take(model->na, known->lanes, known->held, watch->held);
    }
    return i == size;
}

static lag_status evaluate(lag_conditions *watch, double t, const double *x, const double *xd)
{
    const lag_status status = lag_motion_know(watch->motion, t, x, xd);
    return status == LAG_OK ? watch->motion->model->monitor(&watch->motion->at, watch->value, watch->scale, watch->held) : status;
}

lag_status lag_conditions_assert(const lag_conditions *watch)
{
    lag_status status = LAG_OK;
    for (size_t i = 0; i < watch->motion->model->na && status == LAG_OK; ++i) {
        status = watch->held[i] == 0.0 ? LAG_VIOLATED : LAG_OK;
    }
    return status;
}

size_t lag_conditions_warning(lag_conditions *watch, size_t from)
{
    const size_t na = watch->motion->model->na;
    size_t i = from;
    for (int found = 0; i < na && !found; i += !found) {
        const double before = watch->warned[i];
        watch->warned[i] = watch->held[i] < 0.0 ? 1.0 : 0.0;
        found = watch->warned[i] > before;
    }
    return i;
}

lag_status lag_conditions_check(lag_conditions *watch, double t, const double *x, const double *xd)
{
    const lag_model *model = watch->motion->model;
    if (model->ni + model->na == 0 || watch->tolerance == NULL) {
        return LAG_OK;
    }
    lag_status status = is_known(watch, t, x) ? LAG_OK : evaluate(watch, t, x, xd);
    status = status == LAG_OK ? lag_conditions_assert(watch) : status;
    for (size_t i = 0; i < model->ni && !watch->begun; ++i) {
        watch->start[i] = watch->value[i];
    }
    watch->begun = 1;
    if (status == LAG_OK) {
        status = invariants_hold(watch) ? LAG_OK : LAG_VIOLATED;
    }
    if (status == LAG_OK) {
        lag_conditions_count(watch);
    }
    return status;
}

/* Tells each warning that begins at x at time t. */
static lag_status warn(lag_run *run, double t, const double *x)
{
    lag_conditions *watch = &run->conditions;
    const size_t na = watch->tolerance == NULL ? 0 : run->motion.model->na;
    lag_status status = LAG_OK;
    for (size_t i = 0; i < na && status == LAG_OK; ++i) {
        i = lag_conditions_warning(watch, i);
        status = i < na ? lag_instants_report(&run->instants, t, x, LAG_WARNING, i) : LAG_OK;
    }
    return status;
}

lag_status lag_run_watch(lag_run *run, double t, const double *x, const double *xd)
{
    const lag_status status = lag_conditions_check(&run->conditions, t, x, xd);
    if (status == LAG_VIOLATED) {
        lag_conditions_count(&run->conditions);
        lag_run_lose(run, t, x);
        if (run->options.results != NULL) {
            const lag_status told = lag_results_end(run->options.results, run, t, x);
            return told == LAG_OK ? status : told;
        }
    }
    return status == LAG_OK ? warn(run, t, x) : status;
}
