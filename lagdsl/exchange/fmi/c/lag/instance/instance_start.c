/* The start of the motion: where nothing was set it is the start that was found when the model was exported, elsewhere the nearest. */
#include "lag/instance/instance_internal.h"

#include <math.h>
#include <string.h>

#include "lag/initial.h"
#include "lag/linalg/arena.h"
#include "lag/linalg/vector.h"

/* Central differences at two distances, extrapolated: so many points, parts of a distance, and weights. */
enum { POINTS = 4 };
static const double POINT[POINTS] = {1.0, -1.0, 0.5, -0.5};
static const double WEIGHT[POINTS] = {-1.0 / 6.0, 1.0 / 6.0, 4.0 / 3.0, -4.0 / 3.0};
/* The larger distance, as a part of a value; smaller values than this have this size. */
static const double DISTANCE = 1e-3;
static const double SMALLEST = 1e-2;

/* True if every value that the start depends on is as it was at export, where x was found; `own`: inputs are. Free parameters are searched anew. */
static int is_exported(const lag_instance *instance, int own, double *x)
{
    const lag_start *start = instance->fmu->start;
    const lag_model *model = instance->fmu->model;
    int same = start->x != NULL && start->free == NULL && start->t == instance->held.t && (own || model->nc + model->ne == 0);
    same = same && lag_same(model->np, instance->p, model->defaults);
    for (size_t i = 0; i < lag_motion_size(model) && same; ++i) {
        same = !instance->starts.given[i] || instance->starts.values[i] == start->x[i];
    }
    lag_copy(same ? lag_motion_size(model) : 0, start->x, x);
    return same;
}

/*
 * Start values into x, and inputs of the run, so far `along` the direction in `derivatives`: those that were not set are those of the model. *own: all
 * inputs are.
 */
static lag_status gather(lag_instance *instance, double along, double *x, int *own)
{
    const lag_model *model = instance->fmu->model;
    const lag_derivatives *d = &instance->derivatives;
    const size_t size = lag_motion_size(model);
    double *u = instance->run->motion.u;
    const lag_status status = lag_motion_start(&instance->run->motion, instance->held.t + along * d->time, x);
    for (size_t i = 0; i < size; ++i) {
        x[i] = (instance->starts.given[i] ? instance->starts.values[i] : x[i]) + along * d->x[i];
    }
    for (size_t i = 0; i < model->nu; ++i) {
        const double value = instance->inputs.given[i] ? instance->inputs.course[i] + along * d->x[size + i] : u[i];
        *own = *own && value == u[i];
        u[i] = value;
    }
    return status;
}

/* The entry of the start that is to blame. */
static const char *blamed(const lag_model *model, const lag_initial *told)
{
    const size_t states = told->fault == LAG_INITIAL_NUMBERS ? lag_motion_size(model) : 0;
    const size_t i = told->which;
    const size_t row = i - states;
    if (told->fault == LAG_INITIAL_PARAMETERS || told->fault == LAG_INITIAL_BOUNDS) {
        return model->parameters[i].name;
    }
    if (i < states) {
        return i < 2 * model->nq ? model->coordinates[i % model->nq].name : model->states[i - 2 * model->nq].name;
    }
    if (row < model->nc) {
        return model->constraints[row].name;
    }
    return told->fault == LAG_INITIAL_RATES ? model->coordinates[row - model->nc].name : "an initial equation";
}

/* Reasons why there is no start, with the name and the number that are told. */
static const char *const FAULTS[] = {
    [LAG_INITIAL_NUMBERS] = "start: %s is no number with these start values and parameters",
    [LAG_INITIAL_POSITIONS] = "start: %s cannot be satisfied with these start values and parameters (%g is left)",
    [LAG_INITIAL_RATES] = "start: the rate of %s cannot be what it has to be (%g is left)",
    [LAG_INITIAL_EQUATIONS] = "start: %s cannot be satisfied (%g is left)",
    [LAG_INITIAL_RANK] = "start: with these parameters more constraints are independent than when it was exported",
    [LAG_INITIAL_SIZES] = "start: with these parameters the equations of %s are %.0e times as large as those beside them; export it with these parameters",
    [LAG_INITIAL_PARAMETERS] = "start: no initial equation decides the parameter %s",
    [LAG_INITIAL_BOUNDS] = "start: %s would be %g, which is beyond its bounds",
};

/* The start into x (2 nq + nz), so far `along` the direction, from the parameters told->p (np); inputs of the run are those there. */
static lag_status find_start(lag_instance *instance, double along, double *x, lag_initial *told)
{
    const lag_model *model = instance->fmu->model;
    lag_run *run = instance->run;
    int own = 1;
    run->motion.inputs = NULL; /* they are constant here */
    lag_status status = lag_motion_parameters(&run->motion, told->p);
    status = status == LAG_OK ? gather(instance, along, x, &own) : status;
    if (status != LAG_OK) {
        return lag_instance_judge(instance, status);
    }
    if (!(along == 0.0 && is_exported(instance, own, x)) && model->nc + model->ne > 0) {
        status = lag_run_find(run, instance->held.t + along * instance->derivatives.time, instance->starts.given, x, told);
    }
    if (told->fault == LAG_INITIAL_NONE) {
        return lag_instance_judge(instance, status);
    }
    return lag_instance_fail(instance, status, FAULTS[told->fault], blamed(model, told), told->residual);
}

/* The state that follows from what was set, with what happens there. */
static lag_status start(lag_instance *instance)
{
    lag_held *held = &instance->held;
    lag_run *run = instance->run;
    const lag_model *model = instance->fmu->model;
    lag_instance_renew(instance);
    held->jumped = held->prepared = 1;
    held->stopped = 0;
    held->left_at = held->t;
    held->left_for = 0.0;
    held->implicit = -1;
    lag_initial told = {.dependent = run->ranks.dependent, .p = instance->p};
    lag_copy(model->np, instance->starts.parameters, instance->p); /* free ones are searched from there */
    lag_status status = find_start(instance, 0.0, instance->x, &told);
    memcpy(instance->inputs.course, run->motion.u, model->nu * sizeof(double));
    lag_instance_set_run_inputs(instance);
    if (status != LAG_OK) {
        return status;
    }
    status = lag_instance_leave_event(instance, lag_run_begin(run, held->t, instance->x));
    held->initialized = status == LAG_OK;
    return lag_instance_judge(instance, status);
}

lag_status lag_instance_ready(lag_instance *instance)
{
    lag_held *held = &instance->held;
    if (!held->moving && !held->initialized) {
        return start(instance);
    }
    if (!held->prepared) {
        held->prepared = 1;
        return lag_instance_judge(instance, lag_motion_parameters(&instance->run->motion, instance->p));
    }
    return LAG_OK;
}

lag_status lag_instance_begin(lag_instance *instance)
{
    const lag_status status = lag_instance_ready(instance);
    instance->held.moving = instance->held.moving || status == LAG_OK;
    return status;
}

/*
 * ---- derivatives ----
 *
 * The start is the result of a search, so the search is repeated beside the present values, for differences.
 */

/* The largest entry of a direction, in sizes of the values. */
static double most_of(size_t count, const double *direction, const double *values, double smallest)
{
    double most = 0.0;
    for (size_t i = 0; i < count; ++i) {
        most = fmax(most, fabs(direction[i]) / fmax(fabs(values[i]), smallest));
    }
    return most;
}

lag_status lag_instance_start_slopes(lag_instance *instance)
{
    const lag_model *model = instance->fmu->model;
    lag_motion *motion = &instance->run->motion;
    const unsigned char *free = instance->fmu->start->free;
    const size_t size = lag_motion_size(model);
    double *direction = instance->derivatives.x;
    double *of_inputs = direction + size;
    double *of_parameters = of_inputs + model->nu;
    double *memory = instance->scratch;
    double *w = lag_take(&memory, model->nw);
    double *x = lag_take(&memory, size);
    double *p = lag_take(&memory, model->np);
    double *slope = lag_take(&memory, size + model->np);
    memcpy(w, motion->w, model->nw * sizeof(double));
    lag_fill(size + model->np, 0.0, slope);
    double most = fmax(most_of(1, &instance->derivatives.time, &instance->held.t, 1.0), most_of(size, direction, instance->x, SMALLEST));
    most = fmax(most, most_of(model->nu, of_inputs, instance->inputs.course, SMALLEST));
    most = fmax(most, most_of(model->np, of_parameters, instance->p, SMALLEST));
    const double h = DISTANCE / most;
    lag_status status = LAG_OK;
    for (size_t k = 0; k < POINTS && most > 0.0 && status == LAG_OK; ++k) {
        lag_initial told = {.p = p};
        memcpy(p, instance->p, model->np * sizeof(double));
        lag_axpy(model->np, POINT[k] * h, of_parameters, p);
        status = find_start(instance, POINT[k] * h, x, &told);
        lag_axpy(size, WEIGHT[k] / h, x, slope);
        lag_axpy(model->np, WEIGHT[k] / h, p, slope + size);
    }
    memcpy(motion->w, w, model->nw * sizeof(double));
    memcpy(direction, slope, size * sizeof(double));
    for (size_t i = 0; i < model->np && free != NULL; ++i) {
        of_parameters[i] = free[i] ? slope[size + i] : of_parameters[i];
    }
    lag_instance_set_run_inputs(instance);
    instance->values.known &= ~((1U << LAG_ROLES) - 1); /* derivatives stay */
    const lag_status restored = lag_motion_parameters(motion, instance->p);
    return status == LAG_OK ? restored : status;
}
