/* Methods of fixed steps (lag/fixed.h) for those who want events and rows within their steps: ends are counted, not added up. */
#include <math.h>
#include <string.h>

#include "lag/fixed.h"
#include "lag/linalg/arena.h"
#include "lag/stepper.h"
#include "lag/linalg/vector.h"

/* Origin of the count of steps: start time, length of the first, number of steps of this length after it. */
typedef struct places {
    double *start, *first, *count;
    double *x, *f;    /* (size) */
    double *memory;
} places;

static places place(const lag_stepper *s)
{
    double *memory = s->work;
    places at;
    at.start = lag_take(&memory, 1);
    at.first = lag_take(&memory, 1);
    at.count = lag_take(&memory, 1);
    at.x = lag_take(&memory, s->ode->size);
    at.f = lag_take(&memory, s->ode->size);
    at.memory = memory;
    return at;
}

static size_t memory_of_fixed(const lag_ode *ode)
{
    return 3 + 2 * ode->size + lag_fixed_memory(ode->size);
}

static void begin_fixed(lag_stepper *s)
{
    const places at = place(s);
    *at.start = s->t;
    *at.first = s->h > 0.0 ? fmin(s->h, s->h_fixed) : s->h_fixed;
    *at.count = 0.0;
}

/* The system as the formulas see it: counted, and known at the present state. */
static lag_status rates_fixed(void *context, double t, const double *x, double *xd)
{
    lag_stepper *s = context;
    if (t == s->t && lag_same(s->ode->size, x, s->x)) {
        memcpy(xd, s->f, s->ode->size * sizeof(double));
        return LAG_OK;
    }
    return lag_stepper_rates(s, t, x, xd);
}

static lag_status jacobian_fixed(void *context, double t, const double *x, double *matrix)
{
    lag_stepper *s = context;
    ++s->counts.jacobians;
    const lag_status status = s->ode->jacobian(s->ode->context, t, x, matrix);
    if (status != LAG_OK) {
        s->trouble.status = status;
        s->trouble.time = t;
        memcpy(s->trouble.x, x, s->ode->size * sizeof(double));
    }
    return status;
}

static lag_status step_fixed(lag_stepper *s, double limit, lag_fixed_step *formula)
{
    const places at = place(s);
    const lag_ode ode = {.size = s->ode->size, .nq = s->ode->nq, .context = s, .rates = rates_fixed, .jacobian = jacobian_fixed};
    double end = *at.start + *at.first + *at.count * s->h_fixed;
    if (limit - s->t <= LAG_STRETCH * (end - s->t)) {
        end = limit;
    }
    memcpy(at.x, s->x, s->ode->size * sizeof(double));
    lag_status status = formula(&ode, s->t, end - s->t, at.x, at.memory);
    if (status == LAG_OK) {
        status = lag_stepper_rates(s, end, at.x, at.f);
    }
    if (status != LAG_OK) {
        return LAG_STEP_TOO_SMALL;
    }
    *at.count += 1.0;
    s->h = s->h_fixed;
    lag_stepper_accept(s, end, at.x, at.f);
    return LAG_OK;
}

static lag_status prepare_dense_fixed(lag_stepper *s)
{
    (void)s;
    return LAG_OK;
}

/* Cubic Hermite interpolation. */
static void dense_fixed(const lag_stepper *s, double t, double *x)
{
    const places at = place(s);
    const double h = s->t - s->t_before;
    const double part = (t - s->t_before) / h;
    for (size_t i = 0; i < s->ode->size; ++i) {
        const double change = at.x[i] - s->x_before[i];
        const double bend = (1.0 - 2.0 * part) * change + (part - 1.0) * h * s->f_before[i] + part * h * at.f[i];
        x[i] = s->x_before[i] + part * change + part * (part - 1.0) * bend;
    }
}

/* The method that takes its steps by lag_NAME. */
#define METHOD(NAME, ORDER, IMPLICIT)                                                                                                \
    static lag_status step_##NAME(lag_stepper *s, double limit)                                                                      \
    {                                                                                                                                \
        return step_fixed(s, limit, lag_##NAME);                                                                                     \
    }                                                                                                                                \
                                                                                                                                     \
    const lag_method lag_steps_##NAME = {                                                                                            \
        .name = #NAME,                                                                                                               \
        .order = ORDER,                                                                                                              \
        .highest_order = ORDER,                                                                                                      \
        .dense_order = 3,                                                                                                            \
        .implicit = IMPLICIT,                                                                                                        \
        .factor = 1.0,                                                                                                               \
        .error_order = 0,                                                                                                            \
        .memory = memory_of_fixed,                                                                                                   \
        .begin = begin_fixed,                                                                                                        \
        .step = step_##NAME,                                                                                                         \
        .prepare_dense = prepare_dense_fixed,                                                                                        \
        .dense = dense_fixed,                                                                                                        \
    };

METHOD(rk4, 4, 0)
METHOD(leapfrog, 2, 0)
METHOD(ros2, 2, 1)
