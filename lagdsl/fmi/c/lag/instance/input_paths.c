/*
 * Inputs whose derivatives are inputs, too, and whose values may not jump: a position has no blow. From one point of the path to the next,
 * the value has to move as its derivatives say, up to what they may do in between: for a value u with rates u', accelerations u''
 * over H,
 *
 *     |u(H) - u(0) - integral of u'| <= 2 H (largest u' - least u') + 4 H^2 max |u''| + what counts as nothing,
 *
 * the integral by Hermite's formula of fifth order (E. Hairer, G. Wanner, S. P. Norsett, Solving Ordinary Differential Equations I, II.13:
 * two points with two derivatives). The bound admits corners of u', and values on straight lines between rows some steps apart.
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
    return (lag_path){.value = u[i], .rate = rate, .acceleration = acceleration, .since = instance->held.t, .low = rate, .high = rate,
        .most = fabs(acceleration)};
}

static double small(const lag_instance *instance, const lag_path *path, double value)
{
    return fmax(instance->held.tolerance, NOTHING) * fmax(fabs(path->value), fabs(value));
}

/* By how much more than they may the value and its derivatives differ; the path goes on to the point `now`. */
static double excess(const lag_instance *instance, lag_path *path, const lag_path *now)
{
    const double h = now->since - instance->held.followed;
    const double span = now->since - path->since;
    const double moved = now->value - path->value;
    const double least = small(instance, path, now->value);
    if (h == 0.0) { /* a jump at an instant */
        path->value = now->value;
        return fabs(moved) - least;
    }
    path->debt += moved - 0.5 * h * (path->rate + now->rate) + h * h * (now->acceleration - path->acceleration) / 12.0;
    path->value = now->value;
    path->rate = now->rate;
    path->acceleration = now->acceleration;
    path->low = fmin(path->low, now->rate);
    path->high = fmax(path->high, now->rate);
    path->most = fmax(path->most, now->most);
    return fabs(path->debt) - least - OF_RATES * span * (path->high - path->low) - OF_ACCELERATIONS * span * span * path->most;
}

/* The value and its derivatives agree: what follows is judged from here on. */
static void agree(lag_path *path, const lag_path *now, int patient)
{
    const double most = path->most;
    *path = *now;
    path->most = patient ? most : now->most;
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
            const double least = fmax(instance->held.tolerance, NOTHING) * fmax(fabs(u[i]), fabs(left[i]));
            blow = blow || fabs(u[i] - left[i]) > least + OF_ACCELERATIONS * instance->held.left_for * most;
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

lag_status lag_instance_follow_inputs(lag_instance *instance, double patience)
{
    lag_held *held = &instance->held;
    const unsigned char *follows = instance->fmu->continuous_inputs;
    const size_t nu = instance->fmu->model->nu;
    const int fresh = !held->following || held->t <= instance->run->begun || held->t < held->followed;
    lag_status status = LAG_OK;
    if (follows == NULL) {
        return LAG_OK;
    }
    lag_instance_inputs_at(instance, held->t, instance->run->motion.u);
    for (size_t i = 0; i < nu && status == LAG_OK; ++i) {
        if (follows[i] == 0) {
            continue;
        }
        lag_path *path = &instance->paths[i];
        const lag_path now = present(instance, i);
        if (fresh) {
            *path = now;
        } else if (excess(instance, path, &now) <= 0.0) {
            agree(path, &now, patience > 0.0);
        } else if (held->t == held->followed || held->t - path->since > patience) {
            status = refuse(instance, i);
        }
    }
    held->following = 1;
    held->followed = held->t;
    return status;
}
