/* Rates of change of variables along the motion: differences along the tangent. The remaining curvature is even in the distance and cancels. */
#include "lag/instance/instance_internal.h"

#include <math.h>
#include <string.h>

/* Of what the integrator would step over next. */
static double distance(const lag_instance *instance)
{
    const lag_run *run = instance->run;
    const double h = run->stepper.h > 0.0 ? LAG_DISTANCE * run->stepper.h : LAG_SHORT_TIME * run->instants.contacts.length;
    const double t = fabs(instance->held.t);
    return t + h > t ? (t + h) - t : h; /* a distance that the time has */
}

/* Values at a distance along the tangent. */
static lag_status values_at(lag_instance *instance, size_t variable, double t, const double *x, const double *xd, double s, double *values)
{
    for (size_t i = 0; i < lag_instance_order(instance); ++i) {
        instance->x[i] = x[i] + s * xd[i];
    }
    instance->held.t = t + s;
    instance->values.known = 0;
    return lag_instance_get(instance, variable, values);
}

lag_status lag_instance_get_output_derivative(lag_instance *instance, size_t variable, int order, double *values)
{
    const size_t size = lag_instance_order(instance);
    const double t = instance->held.t;
    const double s = distance(instance);
    const size_t count = instance->fmu->variables[variable].count;
    if (order != 1) {
        return lag_instance_fail(instance, LAG_MISSING, "derivatives of outputs are known up to order 1");
    }
    lag_status status = lag_instance_evaluate(instance, LAG_KNOWN_RATES);
    memcpy(instance->scratch.point, instance->x, size * sizeof(double));
    memcpy(instance->scratch.tangent, instance->values.xd, size * sizeof(double));
    memset(values, 0, count * sizeof(double));
    for (size_t k = 0; k < LAG_POINTS && status == LAG_OK; ++k) {
        status = values_at(instance, variable, t, instance->scratch.point, instance->scratch.tangent, LAG_POINT[k] * s, instance->scratch.entry);
        for (size_t i = 0; i < count && status == LAG_OK; ++i) {
            values[i] += LAG_WEIGHT[k] * instance->scratch.entry[i] / s;
        }
    }
    memcpy(instance->x, instance->scratch.point, size * sizeof(double));
    instance->held.t = t;
    instance->values.known = 0;
    return status;
}
