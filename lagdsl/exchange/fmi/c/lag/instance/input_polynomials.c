/* Inputs in time: constants, or polynomials about the time at which they were set. */
#include "lag/instance/instance_internal.h"

#include "lag/linalg/arena.h"
#include "lag/linalg/finite.h"

void lag_instance_inputs_at(const lag_instance *instance, double t, double *u)
{
    const size_t count = instance->fmu->model->nu;
    const double s = t - instance->held.about;
    for (size_t i = 0; i < count; ++i) {
        u[i] = instance->inputs.course[LAG_INPUT_ORDER * count + i];
    }
    for (size_t k = LAG_INPUT_ORDER; k > 0; --k) {
        for (size_t i = 0; i < count; ++i) {
            u[i] = instance->inputs.course[(k - 1) * count + i] + u[i] * s / (double)k;
        }
    }
}

/* As lag_motion wants them. */
static void inputs_of(void *context, double t, int before, double *u)
{
    (void)before; /* a jump is an event */
    const lag_instance *instance = context;
    lag_instance_inputs_at(instance, t, u);
}

void lag_instance_set_run_inputs(lag_instance *instance)
{
    lag_motion *motion = &instance->run->motion;
    const size_t count = instance->fmu->model->nu;
    motion->inputs = instance->held.polynomial ? inputs_of : NULL;
    motion->context = instance;
    if (count > 0) {
        lag_instance_inputs_at(instance, instance->held.t, motion->u);
    }
}

void lag_instance_inputs_about(lag_instance *instance, double t)
{
    const size_t count = instance->fmu->model->nu;
    const double s = t - instance->held.about;
    for (size_t i = 0; i < count && s != 0.0 && instance->held.polynomial; ++i) {
        double *c = instance->inputs.course + i;
        for (size_t low = 0; low < LAG_INPUT_ORDER; ++low) {
            double sum = 0.0;
            for (size_t k = LAG_INPUT_ORDER; k > low; --k) {
                sum = (sum + c[k * count]) * s / (double)(k - low);
            }
            c[low * count] += sum;
        }
    }
    instance->held.about = t;
}

static void find_polynomials(lag_instance *instance)
{
    const size_t nu = instance->fmu->model->nu;
    instance->held.polynomial = lag_any(LAG_INPUT_ORDER * nu, instance->inputs.course + nu);
}

void lag_instance_chain_inputs(lag_instance *instance)
{
    const size_t nu = instance->fmu->model->nu;
    const size_t *rates = instance->fmu->inputs.rates;
    if (rates == NULL) {
        return;
    }
    lag_instance_inputs_about(instance, instance->held.t);
    for (size_t k = 1; k <= LAG_INPUT_ORDER; ++k) {
        for (size_t i = 0; i < nu; ++i) {
            if (rates[i] < nu) {
                instance->inputs.course[k * nu + i] = instance->inputs.course[(k - 1) * nu + rates[i]];
            }
        }
    }
    find_polynomials(instance);
    lag_instance_set_run_inputs(instance);
}

/* Derivative number `order` of the inputs from `first` on, at the present. */
static void set(lag_instance *instance, size_t order, size_t first, size_t count, const double *values)
{
    lag_held *held = &instance->held;
    const size_t nu = instance->fmu->model->nu;
    int same = 1;
    if (!held->exchanged && held->left_at != held->t) {
        lag_instance_leave_inputs(instance);
    }
    lag_instance_inputs_about(instance, held->t);
    for (size_t i = 0; i < count; ++i) {
        double *value = instance->inputs.course + order * nu + first + i;
        same = same && *value == values[i];
        *value = values[i];
    }
    if (same) {
        return;
    }
    find_polynomials(instance);
    held->jumped = 1;
    held->initialized = 0;
    instance->values.known = 0;
    lag_instance_set_run_inputs(instance);
}

void lag_instance_set_inputs(lag_instance *instance, size_t first, size_t count, const double *values)
{
    for (size_t i = 0; i < count; ++i) {
        instance->inputs.given[first + i] = 1.0;
    }
    set(instance, 0, first, count, values);
}

lag_status lag_instance_set_input_derivative(lag_instance *instance, size_t variable, int order, const double *values)
{
    const lag_variable *which = &instance->fmu->variables[variable];
    if (which->role != LAG_ROLE_INPUT || order < 1 || order > LAG_INPUT_ORDER) {
        return lag_instance_fail(instance, LAG_MISSING, "derivatives of inputs can be set up to order %d", LAG_INPUT_ORDER);
    }
    if (!lag_finite(which->count, values)) {
        return lag_instance_fail(instance, LAG_NOT_FINITE, "the derivative of %s is infinite or not a number", which->name);
    }
    set(instance, (size_t)order, which->first, which->count, values);
    return LAG_OK;
}
