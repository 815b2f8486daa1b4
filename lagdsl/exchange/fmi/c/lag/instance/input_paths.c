/*
 * Inputs that jump. Their values on the left of the present are those that the polynomials of the last communication point lead to; in model exchange
 * those at the end of the last step. Rates that inputs prescribe keep the momenta. Values whose derivatives are inputs, too, may not jump, because
 * no impulse moves a position: a time H after the last point
 *
 *     |u - left| <= 2 H |u' - left'| + 4 H^2 max |u''| + a negligible jump,
 *
 * which admits corners of u'. In model exchange H is zero.
 */
#include "lag/instance/instance_internal.h"

#include <math.h>
#include <string.h>

static const double OF_RATES = 2.0;
static const double OF_ACCELERATIONS = 4.0;
/* Of the value: decimals of a table. */
static const double NOTHING = 1e-6;

void lag_instance_leave_inputs(lag_instance *instance)
{
    if (instance->fmu->inputs.rates != NULL) {
        lag_instance_inputs_at(instance, instance->held.t, instance->inputs.left);
        instance->held.left_for = instance->held.exchanged ? 0.0 : instance->held.t - instance->held.left_at;
        instance->held.left_at = instance->held.t;
    }
}

/* The inputs at the present, into those of the run; 0: they are not known on the left of it, or have not been set since. */
static int read_inputs(lag_instance *instance)
{
    const double t = instance->held.t;
    const int known = t == instance->held.left_at && t > instance->run->counts.begun;
    if (known) {
        lag_instance_inputs_at(instance, t, instance->run->motion.u);
    }
    return known;
}

static double jump_of(const lag_instance *instance, size_t i)
{
    return i < instance->fmu->model->nu ? fabs(instance->run->motion.u[i] - instance->inputs.left[i]) : 0.0;
}

/* The larger magnitude of input i on both sides. */
static double size_of(const lag_instance *instance, size_t i)
{
    return i < instance->fmu->model->nu ? fmax(fabs(instance->run->motion.u[i]), fabs(instance->inputs.left[i])) : 0.0;
}

/* The input that is the derivative of input i; nu without. */
static size_t rate_of(const lag_instance *instance, size_t i)
{
    return i < instance->fmu->model->nu ? instance->fmu->inputs.rates[i] : i;
}

/* A jump of input i that counts as nothing. */
static double negligible_jump(const lag_instance *instance, size_t i)
{
    return fmax(instance->held.tolerance, NOTHING) * size_of(instance, i);
}

static lag_status refuse(lag_instance *instance, size_t i)
{
    const lag_slot *inputs = instance->fmu->model->inputs;
    const char *rate = inputs[rate_of(instance, i)].name;
    return lag_instance_fail(instance, LAG_POSITION_JUMP,
        "t = %.10g s: the input %s moves by more than its derivatives say (%s is %.6g): set it and its derivatives from one smooth path, at "
        "more points if it is fast; let %s jump to make a blow",
        instance->held.t, inputs[i].name, rate, instance->run->motion.u[rate_of(instance, i)], rate);
}

lag_status lag_instance_follow_inputs(lag_instance *instance)
{
    const unsigned char *follows = instance->fmu->inputs.continuous;
    const double h = instance->held.left_for;
    const size_t count = follows != NULL && read_inputs(instance) ? instance->fmu->model->nu : 0;
    for (size_t i = 0; i < count; ++i) {
        const size_t rate = rate_of(instance, i);
        const double bend = OF_RATES * h * jump_of(instance, rate) + OF_ACCELERATIONS * h * h * size_of(instance, rate_of(instance, rate));
        if (follows[i] != 0 && jump_of(instance, i) > negligible_jump(instance, i) + bend) {
            return refuse(instance, i);
        }
    }
    return LAG_OK;
}

/* True if a value jumps by more than its derivative makes it move from one communication point to the next: contacts hear of it. */
static int is_blow(const lag_instance *instance)
{
    int blow = 0;
    for (size_t i = 0; i < instance->fmu->model->nu; ++i) {
        const size_t rate = rate_of(instance, i);
        const double moves = OF_ACCELERATIONS * instance->held.left_for * size_of(instance, rate);
        blow = blow || (rate < instance->fmu->model->nu && jump_of(instance, i) > negligible_jump(instance, i) + moves);
    }
    return blow;
}

lag_status lag_instance_balance_inputs(lag_instance *instance)
{
    lag_run *run = instance->run;
    if (!read_inputs(instance) || memcmp(run->motion.u, instance->inputs.left, instance->fmu->model->nu * sizeof(double)) == 0) {
        return LAG_OK;
    }
    const lag_status status = lag_instants_prescribe(&run->instants, instance->held.t, run->stepper.x, instance->inputs.left, is_blow(instance));
    lag_instance_inputs_at(instance, instance->held.t, instance->inputs.left);
    return status;
}
