/* One instance: its block, its experiment, its state as bytes without pointers. */
#include "lag/instance/instance_internal.h"

#include <math.h>
#include <string.h>

#include "lag/fixed.h"
#include "lag/initial.h"
#include "lag/linalg/arena.h"
#include "lag/linalg/linalg.h"
#include "lag/linalg/vector.h"
#include "lag/serialization.h"

static const double MOST_TOLERANCE = 0.1;
/* Integrators of our own keep this part of a tolerance: it is that of values at communication points, long after the errors of the steps. */
static const double INTEGRATION = 0.01;
/* Of an experiment of which nothing is known [s]. */
static const double LENGTH = 1.0;
/* Residuals of constraints die out within this part of the experiment: fast against it, and no stiffness. */
static const double RATE = 50.0;
/* Invariants may depart by so many tolerances where the model does not say. */
static const double INVARIANT = 1e3;

static void lay_out(lag_instance *instance, lag_layout *layout)
{
    const lag_fmu *fmu = instance->fmu;
    const lag_model *model = fmu->model;
    const size_t size = lag_motion_size(model);
    lag_values *values = &instance->values;
    instance->kept = layout->memory;
    lag_lay_all(layout, size, (double **const[]){&instance->x, &instance->starts.values, NULL});
    lag_lay_all(layout, model->np, (double **const[]){&instance->p, &instance->starts.parameters, NULL});
    instance->starts.given = (unsigned char *)lag_lay(layout, size);
    instance->inputs.course = lag_lay(layout, (LAG_INPUT_ORDER + 1) * model->nu);
    instance->inputs.left = lag_lay(layout, model->nu);
    instance->inputs.given = (unsigned char *)lag_lay(layout, model->nu);
    lag_lay_all(layout, lag_guard_count(model), (double **const[]){&instance->latched, &instance->armed, NULL});
    instance->offsets = lag_lay(layout, fmu->dependents.count);
    instance->invariant_limits = lag_lay(layout, model->ni);
    instance->kept_count = layout->count;
    values->of[LAG_ROLE_TIME] = &instance->held.t;
    values->of[LAG_ROLE_PARAMETER] = values->of[LAG_ROLE_FREE] = instance->p;
    values->of[LAG_ROLE_STATE] = values->of[LAG_ROLE_DEPENDENT] = instance->x;
    values->of[LAG_ROLE_DERIVATIVE] = lag_lay(layout, size);
    values->of[LAG_ROLE_OUTPUT] = lag_lay(layout, model->ny);
    values->of[LAG_ROLE_LOCAL] = lag_lay(layout, model->nd);
    values->of[LAG_ROLE_INDICATOR] = lag_lay(layout, fmu->indicators.count);
    values->of[LAG_ROLE_ENERGY] = values->energy;
    values->of[LAG_ROLE_RESIDUAL] = values->residual;
    values->of[LAG_ROLE_OPTION] = &instance->held.step;
    values->unasked = lag_lay(layout, model->nc);
    instance->scratch = lag_lay(layout, lag_fixed_memory(size) + 3 * size + 2 * model->np + model->nu + model->nw + model->ny + model->nd + 3);
    instance->warnings = lag_lay(layout, model->na + model->nfail);
}

/* Bytes up to those of the run. */
static size_t own_size(const lag_fmu *fmu)
{
    lag_instance none = {.fmu = fmu};
    lag_layout layout = {NULL, lag_derivatives_memory(fmu->model)};
    lay_out(&none, &layout);
    return lag_padded(sizeof(lag_instance)) + lag_padded(layout.count * sizeof(double));
}

/* The words of a `terminate` are the message of the end; warnings are kept. */
static lag_status record_event(void *context, lag_run *run, const lag_event_notice *notice)
{
    lag_instance *instance = context;
    if (notice->what == LAG_TERMINATE) {
        (void)lag_instance_fail(instance, LAG_STOPPED, "t = %.10g s: %s", notice->t, run->motion.model->stops[notice->which]);
    } else if (notice->what == LAG_WARNING) {
        instance->warnings[notice->which] = 1.0;
    }
    return LAG_OK;
}

static double length_of(double start, double stop)
{
    return stop - start > 0.0 && stop - start < (double)INFINITY ? stop - start : LENGTH;
}

static lag_run_options options_of(lag_instance *instance)
{
    const lag_fmu *fmu = instance->fmu;
    const lag_held *held = &instance->held;
    return (lag_run_options){
        .careful = 1,
        .start = fmu->start,
        .tolerance = held->integration,
        .p = instance->p,
        .callbacks = {.context = instance, .tell = record_event},
        .sizes = fmu->sizes,
        .lasting = fmu->lasting,
        .length = length_of(held->start, held->stop < (double)INFINITY ? held->stop : fmu->experiment.stop),
        .invariants.tolerance = instance->invariant_limits,
    };
}

size_t lag_instance_size(const lag_fmu *fmu)
{
    const lag_run_options options = options_of(&(lag_instance){.fmu = fmu});
    return own_size(fmu) + lag_run_size(fmu->model, &options);
}

lag_instance *lag_instance_place(void *block, const lag_fmu *fmu)
{
    const lag_model *model = fmu->model;
    char *bytes = block;
    lag_instance *instance = block;
    const size_t size = own_size(fmu);
    lag_layout layout = {(double *)(void *)(bytes + lag_padded(sizeof(lag_instance))), 0};
    memset(block, 0, size);
    instance->fmu = fmu;
    lay_out(instance, &layout);
    lag_derivatives_place(&instance->derivatives, model, lag_lay(&layout, lag_derivatives_memory(model)));
    instance->run = (lag_run *)(void *)(bytes + size);
    lag_copy(model->np, model->defaults, instance->p);
    lag_copy(model->np, model->defaults, instance->starts.parameters);
    lag_instance_setup(instance, LAG_NO_KIND, fmu->experiment.start, (double)INFINITY, 0.0);
    instance->values.of[LAG_ROLE_INPUT] = instance->run->motion.u;
    instance->values.of[LAG_ROLE_DISCRETE] = instance->run->motion.w;
    instance->values.of[LAG_ROLE_MULTIPLIER] = instance->run->motion.lam;
    return instance;
}

double lag_instance_rate(const lag_instance *instance)
{
    return RATE / length_of(instance->fmu->experiment.start, instance->fmu->experiment.stop);
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

void lag_instance_setup(lag_instance *instance, lag_kinds kind, double start, double stop, double tolerance)
{
    lag_held *held = &instance->held;
    const double own = instance->fmu->experiment.tolerance;
    held->start = held->t = start;
    held->stop = stop;
    held->tolerance = held->integration = tolerance > 0.0 ? fmin(fmax(tolerance, LAG_EXACT), MOST_TOLERANCE) : own;
    if (kind == LAG_CO_SIMULATION) { /* that of the experiment is one for `lag run`, which is the tolerance of the steps */
        held->integration = fmin(held->tolerance, fmax(INTEGRATION * held->tolerance, own));
    }
    held->about = start;
    lag_instance_renew(instance);
}

/* ---- state ---- */

/* Everything, with the settings of the run; `instance` is changed only where the record is read from. */
static void walk(lag_instance *instance, lag_record *record)
{
    lag_run_options *options = &instance->run->options;
    lag_record_bytes(record, &instance->held, sizeof instance->held);
    lag_record_doubles(record, instance->kept_count, instance->kept);
    lag_record_doubles(record, 1, &options->tolerance);
    lag_record_doubles(record, 1, &options->length);
    lag_run_record(instance->run, record);
}

size_t lag_instance_saved_size(const lag_instance *instance)
{
    lag_record counted = {NULL, NULL, 0};
    walk((lag_instance *)instance, &counted);
    return counted.count;
}

void lag_instance_save(const lag_instance *instance, unsigned char *bytes)
{
    walk((lag_instance *)instance, &(lag_record){bytes, NULL, 0});
}

lag_status lag_instance_load(lag_instance *instance, const unsigned char *bytes)
{
    walk(instance, &(lag_record){NULL, bytes, 0});
    instance->values.known = 0;
    lag_instance_set_run_inputs(instance);
    return lag_instance_judge(instance, lag_motion_prepare(&instance->run->motion));
}
