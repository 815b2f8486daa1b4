#include "lag/stepper.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "lag/linalg/finite.h"
#include "lag/linalg/order.h"
#include "lag/linalg/vector.h"
#include "lag/methods/step_control.h"

size_t lag_stepper_memory(const lag_ode *ode)
{
    const size_t explicit_work = lag_dop853.memory(ode);
    const size_t implicit_work = lag_radau.memory(ode);
    const size_t fixed_work = lag_steps_rk4.memory(ode);
    const size_t work = explicit_work > implicit_work ? explicit_work : implicit_work;
    return 6 * ode->size + (work > fixed_work ? work : fixed_work);
}

void lag_stepper_place(lag_stepper *s, const lag_ode *ode, double *memory)
{
    const size_t size = ode->size;
    memset(s, 0, sizeof *s);
    s->ode = ode;
    s->x = memory;
    s->f = s->x + size;
    s->x_before = s->f + size;
    s->f_before = s->x_before + size;
    s->tolerance = s->f_before + size;
    s->trouble.x = s->tolerance + size;
    s->work = s->trouble.x + size;
    s->h_most = (double)INFINITY;
}

lag_status lag_stepper_rates(lag_stepper *s, double t, const double *x, double *xd)
{
    ++s->counts.evaluations;
    lag_status status = s->ode->rates(s->ode->context, t, x, xd);
    if (status == LAG_OK && !lag_finite(s->ode->size, xd)) {
        status = LAG_NOT_FINITE;
    }
    if (status != LAG_OK) {
        s->trouble.status = status;
        s->trouble.time = t;
        memcpy(s->trouble.x, x, s->ode->size * sizeof(double));
    }
    return status;
}

void lag_stepper_pass(const lag_stepper *s, unsigned place, double t)
{
    if (s->passing.pass != NULL) {
        s->passing.pass(s->passing.context, place, t);
    }
}

double lag_stepper_norm(const lag_stepper *s, const double *error)
{
    double sum = 0.0;
    for (size_t i = 0; i < s->ode->size; ++i) {
        const double part = error[i] / s->tolerance[i];
        sum += part * part;
    }
    return isfinite(sum) ? sqrt(sum / (double)(s->ode->size > 0 ? s->ode->size : 1)) : (double)INFINITY;
}

/*
 * Derivatives of the motion that starts at the present state, as parts of the tolerances: the second and the third by differences of the rates there,
 * at h/2 and at h, where the midpoint rule leads. Returns 0 where there are no rates.
 */
static int probe(lag_stepper *s, double h, double *second, double *third)
{
    const size_t size = s->ode->size;
    double *point = s->x_before;
    double *middle = s->f_before;
    double *end = s->work;
    for (size_t i = 0; i < size; ++i) {
        point[i] = s->x[i] + 0.5 * h * s->f[i];
    }
    if (lag_stepper_rates(s, s->t + 0.5 * h, point, middle) != LAG_OK) {
        return 0;
    }
    for (size_t i = 0; i < size; ++i) {
        point[i] = s->x[i] + h * middle[i];
    }
    if (lag_stepper_rates(s, s->t + h, point, end) != LAG_OK) {
        return 0;
    }
    for (size_t i = 0; i < size; ++i) {
        point[i] = end[i] - s->f[i];
        middle[i] = (end[i] - middle[i]) - (middle[i] - s->f[i]);
    }
    *second = lag_stepper_norm(s, point) / h;
    *third = lag_stepper_norm(s, middle) / (0.5 * h * h);
    return 1;
}

/*
 * Length of a step whose error is a part in a hundred of the tolerance, and whose round-off is no larger. Derivatives of higher order are expected to grow
 * as the known ones do, of which one may be small by accident; over h nothing is seen that grows faster than 1/h. Without a third derivative nothing tells
 * how others grow: the length is a hundred times h.
 */
static double length_by_derivatives(const lag_stepper *s, double h, double first, double second, double third)
{
    const double growth = fmin(fmin(sqrt(third / first), third / second), 1.0 / h);
    const double order = (double)s->method->error_order;
    const double h1 = third > 0.0 ? pow(0.01 / (third * pow(growth, order - 2.0)), 1.0 / (order + 1.0)) : 100.0 * h;
    return fmin(h1, 0.01 / (DBL_EPSILON * first));
}

/*
 * Length of the first step. The first probe changes the state by a part in a hundred; where the length by what is seen there is more than a hundred
 * times as long, a probe so much longer looks again, up to a tenth of the span.
 *
 * Sources: Hairer, Norsett and Wanner, Solving Ordinary Differential Equations I, 2nd ed., section II.4, "Starting step size", for the first probe, the
 * part of the tolerance and the hundred; Hindmarsh and others, ACM Trans. Math. Softw. 31 (2005) 363 (CVODE), for more than one probe and the tenth.
 */
static double first_length(lag_stepper *s, double span)
{
    const double d0 = lag_stepper_norm(s, s->x);
    const double d1 = lag_stepper_norm(s, s->f);
    double h = fmin(d0 < 1e-5 || d1 < 1e-5 ? 1e-6 : 0.01 * d0 / d1, fmin(span, s->h_most));
    for (;;) {
        const double most = fmin(100.0 * h, fmin(span, s->h_most));
        const double farther = fmin(most, 0.1 * span);
        double d2 = 0.0;
        double d3 = 0.0;
        if (!(h > 0.0) || !probe(s, h, &d2, &d3)) {
            return fmax(1e-3 * h, s->h_least);
        }
        const double found = length_by_derivatives(s, h, d1, d2, d3);
        if (found <= most || farther <= h) {
            return fmin(found, most);
        }
        h = farther;
    }
}

lag_status lag_stepper_begin(lag_stepper *s, const lag_method *method, double span)
{
    s->method = method;
    s->last = (lag_last_step){0.0, 0.0, 0.0, 0};
    s->attempt.begun = s->attempt.bare = s->attempt.dense = 0;
    const lag_status status = lag_stepper_rates(s, s->t, s->x, s->f);
    if (status != LAG_OK) {
        return status;
    }
    lag_stepper_pass(s, LAG_PASSED_BEGIN, s->t);
    if (!(s->h > 0.0)) {
        s->h = method->error_order > 0 ? first_length(s, span) : s->h_fixed;
    }
    memcpy(s->x_before, s->x, s->ode->size * sizeof(double));
    memcpy(s->f_before, s->f, s->ode->size * sizeof(double));
    s->t_before = s->t;
    method->begin(s);
    s->looked = 0;
    return LAG_OK;
}

lag_status lag_stepper_step(lag_stepper *s, double limit)
{
    s->last.dense_ready = s->looked = 0;
    const lag_status status = s->method->step(s, limit);
    s->counts.steps += status == LAG_OK;
    return status;
}

lag_status lag_stepper_correct(lag_stepper *s)
{
    const lag_status status = lag_stepper_rates(s, s->t, s->x, s->f);
    if (status == LAG_OK) {
        lag_stepper_pass(s, LAG_PASSED_END, s->t);
    }
    return status;
}

void lag_stepper_undo(lag_stepper *s, double h)
{
    s->t = s->t_before;
    memcpy(s->x, s->x_before, s->ode->size * sizeof(double));
    memcpy(s->f, s->f_before, s->ode->size * sizeof(double));
    s->h = h;
    s->last.error = s->last.h = 0.0;
    s->last.dense_ready = 0;
    s->attempt.begun = s->attempt.bare = s->looked = 0;
    s->method->begin(s);
}

lag_status lag_stepper_dense(lag_stepper *s, double t, double *x)
{
    if (!s->last.dense_ready) {
        const lag_status status = s->method->prepare_dense(s);
        if (status != LAG_OK) {
            return status;
        }
        s->last.dense_ready = 1;
    }
    s->method->dense(s, t, x);
    return LAG_OK;
}

double lag_stepper_length(const lag_stepper *s, double h, double limit)
{
    return lag_control_length(lag_lower(h, s->h_most), limit - s->t);
}

double lag_stepper_end(const lag_stepper *s, double h, double limit)
{
    return lag_control_end(s->t, h, limit);
}

void lag_stepper_accept(lag_stepper *s, double t_new, const double *x_new, const double *f_new)
{
    const size_t size = s->ode->size;
    lag_copy(size, s->x, s->x_before);
    lag_copy(size, s->f, s->f_before);
    lag_copy(size, x_new, s->x);
    lag_copy(size, f_new, s->f);
    s->t_before = s->t;
    s->t = t_new;
}
