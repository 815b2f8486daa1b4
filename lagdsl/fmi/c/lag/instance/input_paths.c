/*
 * Inputs whose derivatives are inputs, too, and whose values may not jump: a position has no blow. From one communication point to the next,
 * the value has to move as its derivatives say, up to what they may do in between: for a value u with rates u', accelerations u''
 * over H,
 *
 *     |u(H) - u(0) - integral of u'| <= 2 H |u'(H) - u'(0)| + 4 H^2 max |u''| + what counts as nothing,
 *
 * the integral by Hermite's formula of fifth order (E. Hairer, G. Wanner, S. P. Norsett, Solving Ordinary Differential Equations I, II.13:
 * two points with two derivatives). The bound admits corners of u'. Importers that integrate may interpolate values and derivatives each for itself:
 * of theirs only jumps in event mode are judged.
 */
#include "lag/instance/instance_internal.h"

#include <math.h>
#include <string.h>

static const double OF_RATES = 2.0;
static const double OF_ACCELERATIONS = 4.0;
/* Of the value: decimals of a table. */
static const double NOTHING = 1e-6;

/* Input number i at the present, from motion->u. */
static lag_path present(const lag_instance *instance, size_t i)
{
    const size_t nu = instance->fmu->model->nu;
    const double *u = instance->run->motion.u;
    const size_t first = instance->fmu->input_rates[i];
    const size_t second = first < nu ? instance->fmu->input_rates[first] : nu;
    const double rate = first < nu ? u[first] : 0.0;
    const double acceleration = second < nu ? u[second] : 0.0;
    return (lag_path){u[i], rate, acceleration};
}

/* A change of a value that counts as nothing. */
static double small(const lag_instance *instance, double before, double after)
{
    return fmax(instance->held.tolerance, NOTHING) * fmax(fabs(before), fabs(after));
}

/* True if the value and its derivatives differ by more than they may, a time h behind the point before. */
static int is_off(const lag_instance *instance, const lag_path *path, const lag_path *now, double h)
{
    const double most = fmax(fabs(path->acceleration), fabs(now->acceleration));
    const double integral = 0.5 * h * (path->rate + now->rate) - h * h * (now->acceleration - path->acceleration) / 12.0;
    const double may = OF_RATES * h * fabs(now->rate - path->rate) + OF_ACCELERATIONS * h * h * most;
    return fabs(now->value - path->value - integral) > small(instance, path->value, now->value) + may;
}

static lag_status refuse(lag_instance *instance, size_t i)
{
    const lag_slot *inputs = instance->fmu->model->inputs;
    const char *rate = inputs[instance->fmu->input_rates[i]].name;
    return lag_instance_fail(instance, LAG_POSITION_JUMP,
        "t = %.10g s: the input %s moves by more than its derivatives say (%s is %.6g): set it and its derivatives from one smooth path, at "
        "more points if it is fast; let %s jump to make a blow",
        instance->held.t, inputs[i].name, rate, instance->run->motion.u[instance->fmu->input_rates[i]], rate);
}

void lag_instance_leave_inputs(lag_instance *instance)
{
    if (instance->fmu->input_rates != NULL) {
        lag_instance_inputs_at(instance, instance->held.t, instance->left);
        instance->held.left_for = instance->held.exchanged ? 0.0 : instance->held.t - instance->held.left_at;
        instance->held.left_at = instance->held.t;
    }
}

/* True if a value jumps by more than its derivative makes it move from one communication point to the next: contacts hear of it. */
static int is_blow(const lag_instance *instance)
{
    const size_t nu = instance->fmu->model->nu;
    const double *u = instance->run->motion.u;
    const double *left = instance->left;
    int blow = 0;
    for (size_t i = 0; i < nu; ++i) {
        const size_t rate = instance->fmu->input_rates[i];
        if (rate < nu) {
            const double most = fmax(fabs(u[rate]), fabs(left[rate]));
            blow = blow || fabs(u[i] - left[i]) > small(instance, u[i], left[i]) + OF_ACCELERATIONS * instance->held.left_for * most;
        }
    }
    return blow;
}

lag_status lag_instance_balance_inputs(lag_instance *instance)
{
    lag_run *run = instance->run;
    const size_t nu = instance->fmu->model->nu;
    const double t = instance->held.t;
    if (t != instance->held.left_at || t <= run->begun) {
        return LAG_OK;
    }
    lag_instance_inputs_at(instance, t, run->motion.u);
    if (memcmp(run->motion.u, instance->left, nu * sizeof(double)) == 0) {
        return LAG_OK;
    }
    const lag_status status = lag_instants_prescribe(&run->instants, t, run->stepper.x, instance->left, is_blow(instance));
    lag_instance_inputs_at(instance, t, instance->left);
    return status;
}

/* True if input number i jumps at an instant of an importer, from its value at the end of the step before. */
static int jumps(const lag_instance *instance, size_t i)
{
    const double value = instance->run->motion.u[i];
    const int known = instance->held.t > instance->run->begun && instance->held.left_at == instance->held.t;
    return known && fabs(value - instance->left[i]) > small(instance, instance->left[i], value);
}

lag_status lag_instance_follow_inputs(lag_instance *instance)
{
    lag_held *held = &instance->held;
    const unsigned char *follows = instance->fmu->continuous_inputs;
    const int known = held->following && held->t > instance->run->begun && held->t >= held->followed;
    if (follows == NULL) {
        return LAG_OK;
    }
    lag_instance_inputs_at(instance, held->t, instance->run->motion.u);
    for (size_t i = 0; i < instance->fmu->model->nu; ++i) {
        const lag_path now = present(instance, i);
        const int off = held->exchanged ? jumps(instance, i) : known && is_off(instance, &instance->paths[i], &now, held->t - held->followed);
        if (follows[i] != 0 && off) {
            return refuse(instance, i);
        }
        instance->paths[i] = now;
    }
    held->following = !held->exchanged;
    held->followed = held->t;
    return LAG_OK;
}
