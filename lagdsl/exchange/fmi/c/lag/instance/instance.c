/* One instance: its block, its experiment. */
#include "lag/instance/instance_internal.h"

#include <math.h>
#include <string.h>

#include "lag/fixed.h"
#include "lag/initial.h"
#include "lag/linalg/arena.h"
#include "lag/linalg/linalg.h"

static const double MOST_TOLERANCE = 0.1;
/* Integrators of our own keep this part of a tolerance: it is that of values at communication points, long after the errors of the steps. */
static const double INTEGRATION = 0.01;
/* Of an experiment of which nothing is known [s]. */
static const double LENGTH = 1.0;
/* Residuals of constraints die out within this part of the experiment: fast against it, and no stiffness. */
static const double RATE = 50.0;
/* Invariants may depart by so many tolerances where the model does not say. */
static const double INVARIANT = 1e3;

/* Entries of the longest variable. */
static size_t longest(const lag_fmu *fmu)
{
    size_t count = 0;
    for (size_t i = 0; i < fmu->nvariable; ++i) {
        count = fmu->variables[i].count > count ? fmu->variables[i].count : count;
    }
    return count;
}

size_t lag_instance_kept(const lag_fmu *fmu)
{
    const lag_model *model = fmu->model;
    return 3 * lag_motion_size(model) + 2 * model->np + (LAG_INPUT_ORDER + 3) * model->nu + 2 * lag_guard_count(fmu->model) +
           fmu->dependents.count;
}

static size_t doubles(const lag_fmu *fmu)
{
    const size_t size = lag_motion_size(fmu->model);
    return lag_instance_kept(fmu) + 4 * size + longest(fmu) + lag_instance_indicator_count(fmu) +
           fmu->model->ny + fmu->model->nd + fmu->model->nc + fmu->model->ni + fmu->model->na + fmu->model->nfail +
           lag_initial_memory(fmu->model) + lag_fixed_memory(size) + lag_instance_slopes(fmu->model) + lag_derivatives_memory(fmu->model) + 1;
}

/* Remembers which `terminate` acted, and warnings. */
static lag_status record_event(void *context, lag_run *run, const lag_event_notice *notice)
{
    lag_instance *instance = context;
    (void)run;
    if (notice->what == LAG_TERMINATE) {
        instance->held.ending = notice->which;
    } else if (notice->what == LAG_WARNING) {
        instance->warnings[notice->which] = 1.0;
    }
    return LAG_OK;
}

static lag_run_options options_of(lag_instance *instance)
{
    const lag_fmu *fmu = instance->fmu;
    const lag_held *held = &instance->held;
    const double stop = held->stop < (double)INFINITY ? held->stop : fmu->experiment.stop;
    const double length = stop - held->start;
    lag_run_options options = lag_instance_plan();
    options.tolerance = held->integration;
    options.p = instance->p;
    options.callbacks = (lag_run_callbacks){.context = instance, .tell = record_event};
    options.sizes = fmu->sizes;
    options.lasting = fmu->lasting;
    options.length = length > 0.0 && length < (double)INFINITY ? length : LENGTH;
    options.invariants.tolerance = instance->invariant_limits;
    return options;
}

size_t lag_instance_size(const lag_fmu *fmu)
{
    const lag_run_options options = lag_instance_plan();
    return lag_padded(sizeof(lag_instance)) + lag_padded(doubles(fmu) * sizeof(double)) + lag_run_size(fmu->model, &options);
}

static void lay_out(lag_instance *instance, double *memory)
{
    const lag_fmu *fmu = instance->fmu;
    const lag_model *model = fmu->model;
    const size_t size = lag_motion_size(model);
    instance->kept = memory;
    instance->x = lag_take(&memory, size);
    instance->p = lag_take(&memory, model->np);
    instance->starts.parameters = lag_take(&memory, model->np);
    instance->starts.values = lag_take(&memory, size);
    instance->starts.given = lag_take(&memory, size);
    instance->inputs.course = lag_take(&memory, (LAG_INPUT_ORDER + 1) * model->nu);
    instance->inputs.given = lag_take(&memory, model->nu);
    instance->inputs.left = lag_take(&memory, model->nu);
    instance->guards.latched = lag_take(&memory, lag_guard_count(fmu->model));
    instance->guards.armed = lag_take(&memory, lag_guard_count(fmu->model));
    instance->offsets = lag_take(&memory, fmu->dependents.count);
    instance->kept_count = (size_t)(memory - instance->kept);
    instance->values.g = lag_take(&memory, lag_instance_indicator_count(fmu));
    instance->values.xd = lag_take(&memory, size);
    instance->values.y = lag_take(&memory, model->ny);
    instance->values.local = lag_take(&memory, fmu->model->nd);
    instance->values.unasked = lag_take(&memory, model->nc);
    instance->scratch.point = lag_take(&memory, size);
    instance->scratch.tangent = lag_take(&memory, size);
    instance->scratch.entry = lag_take(&memory, longest(fmu));
    instance->invariant_limits = lag_take(&memory, model->ni);
    instance->warnings = lag_take(&memory, model->na + model->nfail);
    instance->starts.written = (unsigned char *)lag_take(&memory, size);
    instance->scratch.initial = lag_take(&memory, lag_initial_memory(model));
    instance->scratch.fixed = lag_take(&memory, lag_fixed_memory(size));
    instance->scratch.slopes = lag_take(&memory, lag_instance_slopes(model));
    lag_derivatives_place(&instance->derivatives, model, memory);
}

lag_instance *lag_instance_place(void *block, const lag_fmu *fmu)
{
    const lag_model *model = fmu->model;
    char *bytes = block;
    lag_instance *instance = block;
    memset(block, 0, lag_padded(sizeof(lag_instance)) + lag_padded(doubles(fmu) * sizeof(double)));
    instance->fmu = fmu;
    lay_out(instance, (double *)(void *)(bytes + lag_padded(sizeof(lag_instance))));
    instance->run = (lag_run *)(void *)(bytes + lag_padded(sizeof(lag_instance)) + lag_padded(doubles(fmu) * sizeof(double)));
    instance->held.start = instance->held.t = fmu->experiment.start;
    instance->held.stop = (double)INFINITY;
    instance->held.tolerance = instance->held.integration = fmu->experiment.tolerance;
    if (model->np > 0) {
        memcpy(instance->p, model->defaults, model->np * sizeof(double));
        memcpy(instance->starts.parameters, model->defaults, model->np * sizeof(double));
    }
    lag_instance_renew(instance);
    return instance;
}

double lag_instance_rate(const lag_instance *instance)
{
    const double length = instance->fmu->experiment.stop - instance->fmu->experiment.start;
    return RATE / (length > 0.0 && length < (double)INFINITY ? length : LENGTH);
}

void lag_instance_renew(lag_instance *instance)
{
    const lag_run_options options = options_of(instance);
    const double *limits = instance->fmu->invariant_limits;
    for (size_t i = 0; i < instance->fmu->model->ni; ++i) {
        instance->invariant_limits[i] = limits != NULL && limits[i] > 0.0 ? limits[i] : INVARIANT * instance->held.tolerance;
    }
    instance->run = lag_run_place(instance->run, instance->fmu->model, &options);
    instance->run->motion.at.p = instance->p;
    lag_derivatives_size(&instance->derivatives, instance->run->sizes.natural, instance->run->sizes.rows);
    instance->held.prepared = instance->held.initialized = 0;
    instance->values.known = 0;
    lag_instance_set_run_inputs(instance);
}

/* That of the experiment is one for `lag run`, which is the tolerance of the steps. */
static double integration_tolerance(const lag_instance *instance, lag_kinds kind)
{
    const double given = instance->held.tolerance;
    return kind == LAG_CO_SIMULATION ? fmin(given, fmax(INTEGRATION * given, instance->fmu->experiment.tolerance)) : given;
}

lag_status lag_instance_setup(lag_instance *instance, lag_kinds kind, double start, double stop, double tolerance)
{
    lag_held *held = &instance->held;
    if (!isfinite(start) || !(stop > start)) {
        return lag_instance_fail(instance, LAG_NOT_FINITE, "the simulation cannot go from %g s to %g s", start, stop);
    }
    if (!(tolerance >= 0.0) || !isfinite(tolerance)) {
        return lag_instance_fail(instance, LAG_NOT_FINITE, "the tolerance %g is no positive number", tolerance);
    }
    held->start = held->t = start;
    held->stop = stop;
    held->tolerance = tolerance > 0.0 ? fmin(fmax(tolerance, LAG_EXACT), MOST_TOLERANCE) : instance->fmu->experiment.tolerance;
    held->integration = integration_tolerance(instance, kind);
    lag_instance_inputs_about(instance, start);
    lag_instance_renew(instance);
    return LAG_OK;
}
