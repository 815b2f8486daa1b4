/*
 * Inputs in time: constants, or polynomials about the time at which they were set; in model exchange constants at each state of the importer.
 *
 * Inputs that jump: their values on the left of the present are those that the polynomials of the last communication point lead to; in model
 * exchange those at the end of the last step. Rates that inputs prescribe keep the momenta. Values whose derivatives are inputs, too, may not jump,
 * because no impulse moves a position: a time H after the last point
 *
 *     |u - left| <= 2 H |u' - left'| + 4 H^2 max |u''| + a negligible jump,
 *
 * which admits corners of u'. In model exchange H is zero.
 */
#include "lag/instance/instance_internal.h"

#include <math.h>
#include <string.h>

#include "lag/linalg/arena.h"
#include "lag/linalg/vector.h"

static const double OF_RATES = 2.0;
static const double OF_ACCELERATIONS = 4.0;
/* Of the value: decimals of a table. */
static const double NOTHING = 1e-6;

/* ---- polynomials ---- */

void lag_instance_inputs_at(const lag_instance *instance, size_t order, double t, double *u)
{
    const size_t nu = instance->fmu->model->nu;
    const double s = t - instance->held.about;
    for (size_t i = 0; i < nu; ++i) {
        const double *c = instance->inputs.course + i;
        double sum = 0.0;
        for (size_t k = LAG_INPUT_ORDER; k > order; --k) {
            sum = (sum + c[k * nu]) * s / (double)(k - order);
        }
        u[i] = c[order * nu] + sum;
    }
}

/* As lag_motion wants them. */
static void inputs_of(void *context, double t, int before, double *u)
{
    (void)before; /* a jump is an event */
    lag_instance_inputs_at(context, 0, t, u);
}

void lag_instance_set_run_inputs(lag_instance *instance)
{
    lag_motion *motion = &instance->run->motion;
    const size_t nu = instance->fmu->model->nu;
    motion->inputs = nu > 0 && lag_any(LAG_INPUT_ORDER * nu, instance->inputs.course + nu) ? inputs_of : NULL;
    motion->context = instance;
    lag_instance_inputs_at(instance, 0, instance->held.t, motion->u);
}

/* The course of the inputs about the present, so that their values can be set there. */
static void start_courses(lag_instance *instance)
{
    for (size_t order = 0; order < LAG_INPUT_ORDER; ++order) { /* none needs those of lower order */
        lag_instance_inputs_at(instance, order, instance->held.t, instance->inputs.course + order * instance->fmu->model->nu);
    }
    instance->held.about = instance->held.t;
}

void lag_instance_chain_inputs(lag_instance *instance)
{
    const size_t nu = instance->fmu->model->nu;
    const size_t *rates = instance->fmu->inputs.rates;
    if (rates == NULL) {
        return;
    }
    start_courses(instance);
    for (size_t k = 1; k <= LAG_INPUT_ORDER; ++k) {
        for (size_t i = 0; i < nu; ++i) {
            if (rates[i] < nu) {
                instance->inputs.course[k * nu + i] = instance->inputs.course[(k - 1) * nu + rates[i]];
            }
        }
    }
    lag_instance_set_run_inputs(instance);
}

lag_status lag_instance_set_input(lag_instance *instance, size_t variable, int order, const double *values)
{
    const lag_variable *which = &instance->fmu->variables[variable];
    lag_held *held = &instance->held;
    if (order > LAG_INPUT_ORDER) {
        return lag_instance_fail(instance, LAG_MISSING, "derivatives of inputs can be set up to order %d", LAG_INPUT_ORDER);
    }
    double *course = instance->inputs.course + (size_t)order * instance->fmu->model->nu + which->first;
    for (size_t i = 0; i < which->count && order == 0; ++i) {
        instance->inputs.given[which->first + i] = 1;
    }
    if (!held->exchanged && held->left_at != held->t) {
        lag_instance_leave_inputs(instance);
    }
    start_courses(instance);
    if (!lag_same(which->count, course, values)) {
        lag_copy(which->count, values, course);
        held->jumped = 1;
        held->initialized = 0;
        instance->values.known = 0;
        lag_instance_set_run_inputs(instance);
    }
    return LAG_OK;
}

/* ---- jumps ---- */

void lag_instance_leave_inputs(lag_instance *instance)
{
    if (instance->fmu->inputs.rates != NULL) {
        lag_instance_inputs_at(instance, 0, instance->held.t, instance->inputs.left);
        instance->held.left_for = instance->held.exchanged ? 0.0 : instance->held.t - instance->held.left_at;
        instance->held.left_at = instance->held.t;
    }
}

/* 0: the inputs are not known on the left of the present, or have not been set since. */
static int are_set(const lag_instance *instance)
{
    return instance->held.t == instance->held.left_at && instance->held.t > instance->run->counts.begun;
}

/* True if input i has a derivative among the inputs, and changes by more than that tells. */
static int jumps(const lag_instance *instance, size_t i)
{
    const size_t nu = instance->fmu->model->nu;
    const double *u = instance->run->motion.u;
    const double *left = instance->inputs.left;
    const double h = instance->held.left_for;
    const size_t rate = instance->fmu->inputs.rates[i];
    if (rate == nu) {
        return 0;
    }
    const size_t second = instance->fmu->inputs.rates[rate];
    const double acceleration = second < nu ? fmax(fabs(u[second]), fabs(left[second])) : 0.0;
    const double bend = OF_RATES * h * fabs(u[rate] - left[rate]) + OF_ACCELERATIONS * h * h * acceleration;
    return fabs(u[i] - left[i]) > bend + fmax(instance->held.tolerance, NOTHING) * fmax(fabs(u[i]), fabs(left[i]));
}

lag_status lag_instance_follow_inputs(lag_instance *instance)
{
    const unsigned char *follows = instance->fmu->inputs.continuous;
    const lag_slot *inputs = instance->fmu->model->inputs;
    const size_t count = follows != NULL && are_set(instance) ? instance->fmu->model->nu : 0;
    for (size_t i = 0; i < count; ++i) {
        if (follows[i] && jumps(instance, i)) {
            const size_t rate = instance->fmu->inputs.rates[i];
            return lag_instance_fail(instance, LAG_POSITION_JUMP,
                "t = %.10g s: the input %s moves by more than its derivatives say (%s is %.6g): set it and its derivatives from one smooth path, at "
                "more points if it is fast; let %s jump to make a blow",
                instance->held.t, inputs[i].name, inputs[rate].name, instance->run->motion.u[rate], inputs[rate].name);
        }
    }
    return LAG_OK;
}

lag_status lag_instance_balance_inputs(lag_instance *instance)
{
    lag_run *run = instance->run;
    const size_t nu = instance->fmu->model->nu;
    int blow = 0; /* of which contacts hear */
    if (!are_set(instance) || lag_same(nu, run->motion.u, instance->inputs.left)) {
        return LAG_OK;
    }
    for (size_t i = 0; i < nu; ++i) {
        blow = blow || jumps(instance, i);
    }
    const lag_status status = lag_instants_prescribe(&run->instants, instance->held.t, run->stepper.x, instance->inputs.left, blow);
    lag_instance_inputs_at(instance, 0, instance->held.t, instance->inputs.left);
    return status;
}
