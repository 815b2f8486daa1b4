/*
 * An instance of which the tests of the shells know everything: an oscillator by its closed form, with faults on demand. It takes the
 * place of the real one, which is left out of the archive then.
 */
#ifndef STAND_IN_H
#define STAND_IN_H

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "lag/instance/instance.h"

/* Value references. */
enum { V_TIME, V_Q, V_QD, V_QDD, V_K, V_FAULT, V_PERIOD, V_U, V_COUNT, V_CLOSED, V_LABEL, V_KIND, V_BIG, V_VARIABLES };

/* Faults, and their times. */
enum {
    FAULT_NONE,
    FAULT_STEP,        /* a step cannot be done */
    FAULT_FAILURE,     /* an assertion fails in a step */
    FAULT_STOP,        /* the model stops at 0.35 s */
    FAULT_RATES,       /* derivatives are not finite */
    FAULT_START,       /* there is no start */
    FAULT_STATES,      /* an update changes the states */
    FAULT_STOP_AT_START
};

/* All zeros means that p, w and so on are the entries of `held`. */
typedef struct lag_held_values {
    double t, x[2], p[3], u, w[2], kind, big[3];
    double from; /* time of the last event */
    int begun, entered, stopped;
} lag_held_values;

struct lag_instance {
    const lag_fmu *fmu;
    lag_held_values held;
    unsigned initialized; /* how often */
    char message[64];
};

static const lag_model stand_in_model = {.version = LAG_MODEL_VERSION, .size = sizeof(lag_model), .name = "StandIn", .nq = 1, .nu = 1, .np = 3, .nw = 2};
static const lag_variable stand_in_variables[V_VARIABLES] = {
    {LAG_ROLE_TIME, LAG_TYPE_REAL, LAG_SET_NEVER, 0, 1, "time"},
    {LAG_ROLE_STATE, LAG_TYPE_REAL, LAG_SET_START, 0, 1, "q"},
    {LAG_ROLE_STATE, LAG_TYPE_REAL, LAG_SET_START, 1, 1, "qd"},
    {LAG_ROLE_DERIVATIVE, LAG_TYPE_REAL, LAG_SET_NEVER, 1, 1, "qdd"},
    {LAG_ROLE_PARAMETER, LAG_TYPE_REAL, LAG_SET_TUNABLE, 0, 1, "k"},
    {LAG_ROLE_PARAMETER, LAG_TYPE_INTEGER, LAG_SET_TUNABLE, 1, 1, "fault"},
    {LAG_ROLE_PARAMETER, LAG_TYPE_REAL, LAG_SET_START, 2, 1, "period"},
    {LAG_ROLE_INPUT, LAG_TYPE_REAL, LAG_SET_ALWAYS, 0, 1, "u"},
    {LAG_ROLE_DISCRETE, LAG_TYPE_INTEGER, LAG_SET_NEVER, 0, 1, "count"},
    {LAG_ROLE_DISCRETE, LAG_TYPE_BOOLEAN, LAG_SET_NEVER, 1, 1, "closed"},
    {LAG_ROLE_CONSTANT, LAG_TYPE_STRING, LAG_SET_NEVER, 0, 1, "label"},
    {LAG_ROLE_PARAMETER, LAG_TYPE_ENUMERATION, LAG_SET_START, 3, 1, "kind"},
    {LAG_ROLE_PARAMETER, LAG_TYPE_REAL, LAG_SET_START, 4, 3, "big"},
};
static const char *const stand_in_texts[] = {"50 % of #1"};
static const double stand_in_nominal[2] = {2.0, 3.0};
static const size_t stand_in_entries[2] = {0, 1};
static const size_t stand_in_first[V_VARIABLES + 1] = {0, 0, 0, 0, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3};
static const lag_dependency stand_in_dependencies[3] = {
    {1, V_Q, 1, LAG_DEPENDENCE_FIXED},
    {1, V_K, 1, LAG_DEPENDENCE_DEPENDENT},
    {1, V_U, 1, LAG_DEPENDENCE_CONSTANT},
};
#ifndef STAND_IN_KINDS
#define STAND_IN_KINDS (LAG_MODEL_EXCHANGE | LAG_CO_SIMULATION)
#endif
#define STAND_IN_TOKEN "{stand-in}"
const lag_fmu lag_exported = {
    .model = &stand_in_model,
    .token = STAND_IN_TOKEN,
    .nvariable = V_VARIABLES,
    .variables = stand_in_variables,
    .nominal = stand_in_nominal,
    .experiment = {.stop = 1.0, .tolerance = 1e-6},
    .constants.texts = stand_in_texts,
    .kinds = STAND_IN_KINDS,
    .indicators = {1, stand_in_entries},
    .states = {2, stand_in_entries},
    .dependencies = {stand_in_first, stand_in_dependencies},
};

static lag_status stand_in_fail(lag_instance *instance, lag_status status)
{
    (void)snprintf(instance->message, sizeof instance->message, "fault %g, 100 %% sure", instance->held.p[1]);
    return status;
}

static int stand_in_fault(const lag_instance *instance, int fault)
{
    return instance->held.p[1] == (double)fault;
}

size_t lag_instance_size(const lag_fmu *fmu)
{
    (void)fmu;
    return sizeof(lag_instance);
}

lag_instance *lag_instance_place(void *block, const lag_fmu *fmu)
{
    lag_instance *instance = block;
    memset(instance, 0, sizeof *instance);
    instance->fmu = fmu;
    instance->held.x[0] = 1.0;
    instance->held.p[0] = 4.0;
    instance->held.w[1] = 1.0;
    instance->held.kind = 2.0;
    return instance;
}

const char *lag_instance_message(const lag_instance *instance)
{
    return instance->message;
}

const char *lag_instance_warning(lag_instance *instance)
{
    (void)instance;
    return NULL;
}

static double *stand_in_place(lag_instance *instance, size_t variable)
{
    lag_held_values *held = &instance->held;
    double *const places[V_VARIABLES] = {
        &held->t, &held->x[0], &held->x[1], NULL, &held->p[0], &held->p[1], &held->p[2], &held->u, &held->w[0], &held->w[1], NULL, &held->kind, held->big};
    return places[variable];
}

static double stand_in_acceleration(const lag_instance *instance)
{
    return instance->held.u - instance->held.p[0] * instance->held.x[0];
}

lag_status lag_instance_get(lag_instance *instance, size_t variable, double *values)
{
    if (variable == V_QDD) {
        *values = stand_in_fault(instance, FAULT_RATES) ? (double)NAN : stand_in_acceleration(instance);
        return isfinite(*values) ? LAG_OK : stand_in_fail(instance, LAG_NOT_FINITE);
    }
    memcpy(values, stand_in_place(instance, variable), instance->fmu->variables[variable].count * sizeof(double));
    return LAG_OK;
}

lag_status lag_instance_set(lag_instance *instance, size_t variable, const double *values)
{
    memcpy(stand_in_place(instance, variable), values, instance->fmu->variables[variable].count * sizeof(double));
    return LAG_OK;
}

lag_status lag_instance_set_input(lag_instance *instance, size_t variable, int order, const double *values)
{
    (void)variable;
    (void)values;
    return order <= 1 ? LAG_OK : stand_in_fail(instance, LAG_MISSING);
}

lag_status lag_instance_get_output_derivative(lag_instance *instance, size_t variable, int order, double *values)
{
    if (order > 1 || variable != V_Q) {
        return stand_in_fail(instance, LAG_MISSING);
    }
    *values = instance->held.x[1];
    return LAG_OK;
}

void lag_instance_setup(lag_instance *instance, lag_kinds kind, double start, double stop, double tolerance)
{
    (void)kind;
    (void)stop;
    (void)tolerance;
    instance->held.t = start;
}

lag_status lag_instance_ready(lag_instance *instance)
{
    ++instance->initialized;
    return stand_in_fault(instance, FAULT_START) ? stand_in_fail(instance, LAG_PROJECTION_FAILED) : LAG_OK;
}

lag_status lag_instance_begin(lag_instance *instance)
{
    instance->held.begun = 1;
    instance->held.stopped = stand_in_fault(instance, FAULT_STOP_AT_START);
    return LAG_OK;
}

lag_status lag_instance_terminate(lag_instance *instance)
{
    return stand_in_fault(instance, FAULT_FAILURE) ? stand_in_fail(instance, LAG_ASSERTION_FAILED) : LAG_OK;
}

void lag_instance_set_time(lag_instance *instance, double t)
{
    instance->held.t = t;
}

void lag_instance_set_states(lag_instance *instance, const double *x)
{
    memcpy(instance->held.x, x, sizeof instance->held.x);
}

lag_status lag_instance_vector(lag_instance *instance, lag_role role, double *values)
{
    const double *x = instance->held.x;
    values[0] = role == LAG_ROLE_INDICATOR ? x[0] - 0.5 : role == LAG_ROLE_STATE ? x[0] : x[1];
    if (role == LAG_ROLE_STATE) {
        values[1] = x[1];
    }
    return role == LAG_ROLE_DERIVATIVE ? lag_instance_get(instance, V_QDD, &values[1]) : LAG_OK;
}

lag_status lag_instance_update(lag_instance *instance, lag_update *told)
{
    lag_held_values *held = &instance->held;
    *told = (lag_update){.next = held->p[2] > 0.0 ? held->from + held->p[2] : (double)INFINITY};
    told->terminate = held->stopped;
    told->states_changed = stand_in_fault(instance, FAULT_STATES);
    held->w[0] += held->entered; /* the first one is that of the start */
    held->entered = 1;
    return LAG_OK;
}

lag_status lag_instance_completed(lag_instance *instance, int *events)
{
    *events = fabs(instance->held.x[0]) > 10.0;
    return stand_in_fault(instance, FAULT_FAILURE) ? stand_in_fail(instance, LAG_VIOLATED) : LAG_OK;
}

/* Exact: q - u / k turns at the rate sqrt(k). */
static void stand_in_move(lag_instance *instance, double t)
{
    lag_held_values *held = &instance->held;
    const double rate = sqrt(held->p[0]);
    const double middle = held->u / held->p[0];
    const double angle = rate * (t - held->t);
    const double q = held->x[0] - middle;
    const double qd = held->x[1] / rate;
    held->x[0] = middle + q * cos(angle) + qd * sin(angle);
    held->x[1] = rate * (qd * cos(angle) - q * sin(angle));
    held->t = t;
}

lag_status lag_instance_judge(lag_instance *instance, lag_status status)
{
    return stand_in_fail(instance, status);
}

lag_status lag_instance_step(lag_instance *instance, double h, int stops, lag_progress *told)
{
    lag_held_values *held = &instance->held;
    const double end = held->t + h;
    double t = end;
    *told = (lag_progress){.t = held->t};
    if (stand_in_fault(instance, FAULT_STEP) || stand_in_fault(instance, FAULT_FAILURE)) {
        return stand_in_fail(instance, stand_in_fault(instance, FAULT_STEP) ? LAG_STEP_TOO_SMALL : LAG_ASSERTION_FAILED);
    }
    if (stand_in_fault(instance, FAULT_STOP)) {
        t = fmin(t, 0.35);
        held->stopped = t == 0.35;
    }
    const double happens = held->p[2] > 0.0 ? held->from + held->p[2] : (double)INFINITY;
    if ((stops & LAG_STOP_EVENTS) != 0) {
        t = fmin(t, happens);
    }
    if ((stops & LAG_STOP_STEPS) != 0) {
        t = fmin(t, held->t + 0.03);
    }
    stand_in_move(instance, t);
    told->event = (stops & LAG_STOP_EVENTS) != 0 && t == happens;
    held->from = t >= happens ? t : held->from;
    *told = (lag_progress){.t = t, .event = told->event, .terminate = held->stopped, .early = t < end};
    return LAG_OK;
}

/* d qdd = du - k dq - dk q; of all others: themselves. */
static double stand_in_slope(const lag_instance *instance, size_t unknown, size_t known)
{
    if (unknown == V_QDD) {
        return known == V_U ? 1.0 : known == V_Q ? -instance->held.p[0] : known == V_K ? -instance->held.x[0] : 0.0;
    }
    return unknown == known ? 1.0 : 0.0;
}

lag_status lag_instance_slopes(lag_instance *instance, int adjoint, const lag_known *unknown, size_t unknowns, const lag_known *known,
    size_t knowns, const double *seed, double *sensitivity)
{
    for (size_t i = 0; i < (adjoint ? knowns : unknowns); ++i) {
        sensitivity[i] = 0.0;
    }
    for (size_t i = 0; i < unknowns; ++i) {
        for (size_t k = 0; k < knowns; ++k) {
            const int same = unknown[i].variable != known[k].variable || unknown[i].element == known[k].element;
            const double slope = same ? stand_in_slope(instance, unknown[i].variable, known[k].variable) : 0.0;
            sensitivity[adjoint ? k : i] += slope * seed[adjoint ? i : k];
        }
    }
    return LAG_OK;
}

size_t lag_instance_saved_size(const lag_instance *instance)
{
    (void)instance;
    return sizeof(lag_held_values);
}

void lag_instance_save(const lag_instance *instance, unsigned char *bytes)
{
    memcpy(bytes, &instance->held, sizeof instance->held);
}

lag_status lag_instance_load(lag_instance *instance, const unsigned char *bytes)
{
    memcpy(&instance->held, bytes, sizeof instance->held);
    return LAG_OK;
}

/* There are no clocks: the shells refuse all others before they ask. */
lag_status lag_instance_clock(lag_instance *instance, size_t which, double t, double *period, double *tick)
{
    (void)which;
    *period = *tick = t;
    return stand_in_fail(instance, LAG_MISSING);
}

#endif
