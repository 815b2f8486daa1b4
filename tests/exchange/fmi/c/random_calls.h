/*
 * Importers that call anything in any order with any arguments, on a real instance of the model that `lag_exported` is. They always
 * get a status; values of the motion that come with a good one are finite; and the sanitizers find nothing.
 */
#ifndef RANDOM_CALLS_H
#define RANDOM_CALLS_H

#include <string.h>

#include "../../../c/check.h"
#include "fmi2Functions.h"
#include "fmi3Functions.h"
#include "lag/shell/shell.h"

enum { ROOM = 64, SNAPSHOTS = 3, BYTES = 1 << 22 };

typedef struct lag_visit {
    unsigned long long seed;
    unsigned told;           /* messages in this call */
    unsigned calls, good;    /* all, and those that were answered with OK */
    void *instance;
    void *states[SNAPSHOTS];
    unsigned char bytes[BYTES];
    size_t size;             /* of what is in `bytes` */
    double t, h;             /* where the importer thinks to be */
    uint32_t references[ROOM];
    double values[ROOM], more[ROOM];
    size_t count;            /* of these arrays that are meant */
} lag_visit;

static unsigned pick(lag_visit *visit, unsigned count)
{
    return (unsigned)((draw(&visit->seed) + 1.0) * 0.5 * count) % count;
}

/* Mostly plain numbers. */
static double number(lag_visit *visit)
{
    static const double strange[] = {0.0, -0.0, 1.0, -1.0, 1e-300, 1e300, -1e300, 1e-9, 1e3, (double)INFINITY, -(double)INFINITY, (double)NAN};
    return pick(visit, 4) > 0 ? 2.0 * draw(&visit->seed) : strange[pick(visit, sizeof strange / sizeof strange[0])];
}

/* Of the experiment, at most a second: what moves fast has a short one. */
static double length(void)
{
    const double whole = lag_exported.experiment.stop - lag_exported.experiment.start;
    return whole > 0.0 ? fmin(whole, 1.0) : 1.0;
}

/* Mostly one variable that exists, and room that fits. */
static void draw_arguments(lag_visit *visit)
{
    visit->count = pick(visit, 4) > 0 ? 1 : pick(visit, 6);
    for (size_t i = 0; i < ROOM; ++i) {
        const uint32_t odd = pick(visit, 2) > 0 ? UINT32_MAX : (uint32_t)lag_exported.nvariable;
        visit->references[i] = pick(visit, 12) > 0 ? pick(visit, (unsigned)lag_exported.nvariable) : odd;
        visit->values[i] = visit->more[i] = number(visit);
    }
    const double odd = number(visit);
    visit->h = pick(visit, 6) > 0 ? 0.05 * length() * (1.0 + draw(&visit->seed)) : isfinite(odd) ? fmin(odd, 0.5 * length()) : odd;
}

static int rarely(lag_visit *visit)
{
    return pick(visit, 40) == 0;
}

/* An argument, or sometimes null. */
#define MAYBE(POINTER) (rarely(visit) ? NULL : (POINTER))

static int finite(const double *values, size_t count)
{
    for (size_t i = 0; i < count; ++i) {
        if (!isfinite(values[i])) {
            return 0;
        }
    }
    return 1;
}

/* Outputs may be infinite where the motion is not. */
static int is_motion(uint32_t reference)
{
    const unsigned role = lag_exported.variables[reference].role;
    return role == LAG_ROLE_TIME || role == LAG_ROLE_STATE || role == LAG_ROLE_DERIVATIVE || role == LAG_ROLE_INPUT || role == LAG_ROLE_MULTIPLIER;
}

/* Of what was got, everything that is motion. */
static int finite_motion(const lag_visit *visit)
{
    const double *values = visit->values;
    int all = 1;
    for (size_t i = 0; i < visit->count; ++i) {
        const size_t count = lag_exported.variables[visit->references[i]].count;
        all = all && (!is_motion(visit->references[i]) || finite(values, count));
        values += count;
    }
    return all;
}

/* Values of these variables together. */
static size_t width(const lag_visit *visit)
{
    size_t total = 0;
    for (size_t i = 0; i < visit->count; ++i) {
        total += visit->references[i] < lag_exported.nvariable ? lag_exported.variables[visit->references[i]].count : 1;
    }
    return total;
}

static size_t order_of_model(void)
{
    return 2 * lag_exported.model->nq + lag_exported.model->nz;
}

/* ---- FMI 2 ---- */

static void hear2(fmi2ComponentEnvironment environment, fmi2String name, fmi2Status status, fmi2String category, fmi2String message, ...)
{
    lag_visit *visit = environment;
    CHECK(name != NULL && category != NULL && message != NULL && (unsigned)status <= fmi2Fatal);
    ++visit->told;
}

static fmi2Status call2(lag_visit *visit)
{
    const size_t n = visit->count, order = pick(visit, 8) > 0 ? order_of_model() : pick(visit, ROOM);
    fmi2Component c = visit->instance;
    fmi2Integer whole[ROOM] = {0};
    fmi2String texts[ROOM] = {NULL};
    fmi2EventInfo info;
    fmi2Boolean flag = 0, other = 0;
    fmi2Status status = fmi2OK;
    void **state = &visit->states[pick(visit, SNAPSHOTS)];
    for (size_t i = 0; i < ROOM; ++i) {
        whole[i] = (fmi2Integer)pick(visit, 4) - 1;
    }
    switch (pick(visit, 34)) {
    case 0:
        return fmi2SetupExperiment(c, whole[0], visit->values[0], rarely(visit) ? visit->values[1] : 0.0, rarely(visit), 5.0);
    case 1:
    case 2:
        return fmi2EnterInitializationMode(c);
    case 3:
    case 4:
        return fmi2ExitInitializationMode(c);
    case 5:
        return rarely(visit) ? fmi2Terminate(c) : fmi2OK;
    case 6:
        return fmi2SetDebugLogging(c, whole[0] > 0, n, (const fmi2String[ROOM]){"logAll", "logEvents", NULL});
    case 7:
    case 8:
        status = fmi2GetReal(c, MAYBE(visit->references), n, MAYBE(visit->values));
        CHECK(status != fmi2OK || finite_motion(visit));
        return status;
    case 9:
        return fmi2GetInteger(c, visit->references, n, MAYBE(whole));
    case 10:
        return fmi2GetBoolean(c, visit->references, n, MAYBE(whole));
    case 11:
        return fmi2GetString(c, visit->references, n, MAYBE(texts));
    case 12:
        return fmi2SetReal(c, MAYBE(visit->references), n, MAYBE(visit->values));
    case 13:
        return fmi2SetInteger(c, visit->references, n, MAYBE(whole));
    case 14:
        return fmi2SetBoolean(c, visit->references, n, MAYBE(whole));
    case 15:
        return fmi2GetFMUstate(c, MAYBE(state));
    case 16:
        return fmi2SetFMUstate(c, *state);
    case 17:
        return fmi2FreeFMUstate(c, MAYBE(state));
    case 18:
        status = fmi2SerializedFMUstateSize(c, *state, &visit->size);
        CHECK(visit->size < BYTES);
        return status == fmi2OK ? fmi2SerializeFMUstate(c, *state, (fmi2Byte *)visit->bytes, visit->size) : status;
    case 19:
        visit->bytes[pick(visit, (unsigned)visit->size + 1)] ^= (unsigned char)rarely(visit);
        return fmi2DeSerializeFMUstate(c, (const fmi2Byte *)visit->bytes, visit->size, MAYBE(state));
    case 20:
        return fmi2GetDirectionalDerivative(c, visit->references, n, visit->references + 8, n, MAYBE(visit->values), MAYBE(visit->more));
    case 21:
        return fmi2EnterEventMode(c);
    case 22:
    case 23:
        return fmi2NewDiscreteStates(c, MAYBE(&info));
    case 24:
    case 25:
        return fmi2EnterContinuousTimeMode(c);
    case 26:
        return fmi2CompletedIntegratorStep(c, fmi2True, MAYBE(&flag), &other);
    case 27:
        visit->t += visit->h > 0.0 && isfinite(visit->h) ? visit->h : 0.0;
        return fmi2SetTime(c, rarely(visit) ? visit->values[0] : visit->t);
    case 28:
        return fmi2SetContinuousStates(c, MAYBE(visit->values), order);
    case 29:
        status = fmi2GetDerivatives(c, MAYBE(visit->values), order);
        CHECK(status != fmi2OK || finite(visit->values, order));
        return status;
    case 30:
        return fmi2GetEventIndicators(c, visit->values, pick(visit, 4));
    case 31:
        return pick(visit, 2) > 0 ? fmi2SetRealInputDerivatives(c, visit->references, n, whole, visit->values) :
                                    fmi2GetRealOutputDerivatives(c, visit->references, n, whole, visit->values);
    default:
        status = fmi2DoStep(c, rarely(visit) ? visit->values[0] : visit->t, visit->h, fmi2True);
        visit->t += status == fmi2OK ? visit->h : 0.0;
        return status;
    }
}

static void begin2(lag_visit *visit)
{
    const fmi2CallbackFunctions functions = {hear2, NULL, NULL, NULL, visit};
    visit->instance = fmi2Instantiate("one", pick(visit, 2) > 0 ? fmi2ModelExchange : fmi2CoSimulation, lag_exported.token, NULL, &functions, 0, 1);
}

/* ---- FMI 3 ---- */

static void hear3(fmi3InstanceEnvironment environment, fmi3Status status, fmi3String category, fmi3String message)
{
    lag_visit *visit = environment;
    CHECK(category != NULL && message != NULL && (unsigned)status <= fmi3Fatal);
    ++visit->told;
}

static void look_in(fmi3InstanceEnvironment environment, fmi3Float64 t, fmi3Boolean setting, fmi3Boolean getting, fmi3Boolean finished,
    fmi3Boolean may_return, fmi3Boolean *wanted, fmi3Float64 *until)
{
    lag_visit *visit = environment;
    double value = 0.0;
    (void)setting;
    (void)finished;
    (void)may_return;
    CHECK(isfinite(t) && getting);
    const uint32_t reference = pick(visit, (unsigned)lag_exported.nvariable);
    const fmi3Status status = fmi3GetFloat64(visit->instance, &reference, 1, &value, 1);
    CHECK(status != fmi3OK || isfinite(value) || !is_motion(reference));
    fmi3FreeInstance(visit->instance);
    *wanted = rarely(visit);
    *until = number(visit);
}

static fmi3Status step3(lag_visit *visit)
{
    fmi3Boolean event = false, terminate = false, early = false;
    const double from = rarely(visit) ? visit->values[0] : visit->t;
    double t = visit->t;
    const fmi3Status status =
        fmi3DoStep(visit->instance, from, visit->h, true, MAYBE(&event), &terminate, &early, MAYBE(&t));
    CHECK(isfinite(t) && (status != fmi3OK || early || terminate || fabs(t - from - visit->h) <= 1e-6));
    visit->t = t;
    return status;
}

static fmi3Status call3(lag_visit *visit)
{
    const size_t n = visit->count, order = pick(visit, 8) > 0 ? order_of_model() : pick(visit, ROOM);
    const size_t wide = pick(visit, 8) > 0 ? width(visit) : pick(visit, ROOM);
    fmi3Instance i = visit->instance;
    fmi3Int32 whole[ROOM] = {0};
    fmi3Int64 choices[ROOM] = {0};
    fmi3Boolean flags[ROOM] = {false};
    fmi3String texts[ROOM] = {NULL};
    double next = 0.0;
    size_t places[ROOM];
    fmi3DependencyKind kinds[ROOM];
    fmi3Status status = fmi3OK;
    void **state = &visit->states[pick(visit, SNAPSHOTS)];
    for (size_t k = 0; k < ROOM; ++k) {
        whole[k] = (fmi3Int32)pick(visit, 4) - 1;
    }
    switch (pick(visit, 38)) {
    case 0:
    case 1:
        return fmi3EnterInitializationMode(i, whole[0] > 0, visit->values[0], rarely(visit) ? visit->values[1] : 0.0, rarely(visit), 5.0);
    case 2:
    case 3:
        return fmi3ExitInitializationMode(i);
    case 4:
        return rarely(visit) ? fmi3Terminate(i) : fmi3OK;
    case 5:
    case 6:
        status = fmi3GetFloat64(i, MAYBE(visit->references), n, MAYBE(visit->values), wide);
        CHECK(status != fmi3OK || finite_motion(visit));
        return status;
    case 7:
        return fmi3GetInt32(i, visit->references, n, MAYBE(whole), wide);
    case 8:
        return fmi3GetBoolean(i, visit->references, n, MAYBE(flags), wide);
    case 9:
        return fmi3GetString(i, visit->references, n, MAYBE(texts), wide);
    case 10:
        return fmi3GetInt64(i, visit->references, n, MAYBE(choices), wide);
    case 11:
        return fmi3SetFloat64(i, MAYBE(visit->references), n, MAYBE(visit->values), wide);
    case 12:
        return fmi3SetInt32(i, visit->references, n, MAYBE(whole), wide);
    case 13:
        memset(flags, (int)pick(visit, 256), sizeof flags);
        return fmi3SetBoolean(i, visit->references, n, MAYBE(flags), wide);
    case 14:
        return fmi3GetFMUState(i, MAYBE(state));
    case 15:
        return fmi3SetFMUState(i, *state);
    case 16:
        return fmi3FreeFMUState(i, MAYBE(state));
    case 17:
        status = fmi3SerializedFMUStateSize(i, *state, &visit->size);
        CHECK(visit->size < BYTES);
        return status == fmi3OK ? fmi3SerializeFMUState(i, *state, visit->bytes, visit->size) : status;
    case 18:
        visit->bytes[pick(visit, (unsigned)visit->size + 1)] ^= (unsigned char)rarely(visit);
        return fmi3DeserializeFMUState(i, visit->bytes, visit->size, MAYBE(state));
    case 19:
        return fmi3GetDirectionalDerivative(i, visit->references, n, visit->references + 8, n, MAYBE(visit->values), wide, visit->more, wide);
    case 20:
        return fmi3GetAdjointDerivative(i, visit->references, n, visit->references + 8, n, visit->values, wide, MAYBE(visit->more), wide);
    case 21:
        return fmi3EnterEventMode(i);
    case 22:
    case 23:
        return fmi3UpdateDiscreteStates(i, MAYBE(flags), flags + 1, flags + 2, flags + 3, flags + 4, &next);
    case 24:
        return fmi3EnterContinuousTimeMode(i);
    case 25:
        return fmi3EnterStepMode(i);
    case 26:
        return fmi3CompletedIntegratorStep(i, true, MAYBE(flags), flags + 1);
    case 27:
        visit->t += visit->h > 0.0 && isfinite(visit->h) ? visit->h : 0.0;
        return fmi3SetTime(i, rarely(visit) ? visit->values[0] : visit->t);
    case 28:
        return fmi3SetContinuousStates(i, MAYBE(visit->values), order);
    case 29:
        status = fmi3GetContinuousStateDerivatives(i, MAYBE(visit->values), order);
        CHECK(status != fmi3OK || finite(visit->values, order));
        return status;
    case 30:
        return fmi3GetEventIndicators(i, visit->values, pick(visit, 4));
    case 31:
        return fmi3GetOutputDerivatives(i, visit->references, n, whole, visit->values, wide);
    case 32:
        return fmi3GetVariableDependencies(i, visit->references[0], places, visit->references + 8, places, kinds, pick(visit, 4));
    case 33:
        return fmi3SetDebugLogging(i, whole[0] > 0, n, (const fmi3String[ROOM]){"logAll", "logEvents", NULL});
    default:
        return step3(visit);
    }
}

static void begin3(lag_visit *visit)
{
    visit->instance = pick(visit, 2) > 0 ?
        fmi3InstantiateModelExchange("one", lag_exported.token, NULL, false, true, visit, hear3) :
        fmi3InstantiateCoSimulation("one", lag_exported.token, NULL, false, true, pick(visit, 2) > 0, pick(visit, 2) > 0, NULL, 0, visit, hear3,
            pick(visit, 2) > 0 ? look_in : NULL);
}

/* ---- both ---- */

/* Lives of some hundred calls each; how many calls were good. */
static unsigned visit_at_random(unsigned long long seed, unsigned lives, int version)
{
    static lag_visit all;
    lag_visit *visit = &all;
    memset(visit, 0, sizeof *visit);
    visit->seed = seed;
    for (unsigned life = 0; life < lives; ++life) {
        visit->t = 0.0;
        (version == 2 ? begin2 : begin3)(visit);
        CHECK(visit->instance != NULL);
        for (unsigned k = 0; k < 400; ++k) {
            draw_arguments(visit);
            visit->told = 0;
            const unsigned status = version == 2 ? (unsigned)call2(visit) : (unsigned)call3(visit);
            CHECK(status <= 4);
            ++visit->calls;
            visit->good += status == 0;
        }
        if (version == 2) {
            fmi2FreeInstance(visit->instance);
        } else {
            fmi3FreeInstance(visit->instance);
        }
        memset(visit->states, 0, sizeof visit->states); /* they went with the instance */
    }
    return visit->good;
}

#endif
