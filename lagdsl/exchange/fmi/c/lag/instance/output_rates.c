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

lag_status lag_instance_get_output_derivative(lag_instance *instance, size_t variable, int order, double *values)
{
    const lag_variable *which = &instance->fmu->variables[variable];
    const size_t size = lag_instance_order(instance);
    const double t = instance->held.t;
    const double s = distance(instance);
    double *x = instance->scratch.point;
    double *xd = instance->scratch.tangent;
    if (order != 1) {
        return lag_instance_fail(instance, LAG_MISSING, "derivatives of outputs are known up to order 1");
    }
    lag_status status = lag_instance_evaluate(instance, LAG_KNOWN_RATES);
    memcpy(x, instance->x, size * sizeof(double));
    memcpy(xd, instance->values.xd, size * sizeof(double));
    memset(values, 0, which->count * sizeof(double));
    for (size_t k = 0; k < LAG_POINTS && status == LAG_OK; ++k) {
        for (size_t i = 0; i < size; ++i) {
            instance->x[i] = x[i] + LAG_POINT[k] * s * xd[i];
        }
        instance->held.t = t + LAG_POINT[k] * s;
        instance->values.known = 0;
        status = lag_instance_look(instance, which);
        for (size_t i = 0; i < which->count; ++i) {
            values[i] += LAG_WEIGHT[k] / s * lag_instance_value(instance, which, i);
        }
    }
    memcpy(instance->x, x, size * sizeof(double));
    instance->held.t = t;
    instance->values.known = 0;
    return status;
}
