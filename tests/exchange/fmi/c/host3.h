/* An importer of FMI 3 for the tests of its shell: it counts what it is told. */
#ifndef HOST3_H
#define HOST3_H

#include "../../../c/check.h"
#include "fmi3Functions.h"
#include "stand_in.h"

static struct {
    unsigned told;
    fmi3Status status;
    char category[64], message[1024];
} host;

static void hear(fmi3InstanceEnvironment environment, fmi3Status status, fmi3String category, fmi3String message)
{
    CHECK(environment == &host);
    ++host.told;
    host.status = status;
    (void)snprintf(host.category, sizeof host.category, "%s", category);
    (void)snprintf(host.message, sizeof host.message, "%s", message);
}

typedef enum kind { EXCHANGE, STEPS, STEPS_WITH_EVENTS } kind;

static inline fmi3Instance made(kind which)
{
    fmi3Instance instance = which == EXCHANGE ?
        fmi3InstantiateModelExchange("one", STAND_IN_TOKEN, NULL, false, false, &host, hear) :
        fmi3InstantiateCoSimulation(
            "one", STAND_IN_TOKEN, NULL, false, false, which == STEPS_WITH_EVENTS, which == STEPS_WITH_EVENTS, NULL, 0, &host, hear, NULL);
    CHECK(instance != NULL);
    return instance;
}

static inline void set_float(fmi3Instance instance, fmi3ValueReference reference, double value)
{
    CHECK(fmi3SetFloat64(instance, &reference, 1, &value, 1) == fmi3OK);
}

static inline double float_of(fmi3Instance instance, fmi3ValueReference reference)
{
    double value = 0.0;
    CHECK(fmi3GetFloat64(instance, &reference, 1, &value, 1) == fmi3OK);
    return value;
}

static inline void set_fault(fmi3Instance instance, int fault)
{
    const fmi3ValueReference reference = V_FAULT;
    CHECK(fmi3SetInt32(instance, &reference, 1, &fault, 1) == fmi3OK);
}

static inline fmi3Status begin(fmi3Instance instance, double t)
{
    return fmi3EnterInitializationMode(instance, false, 0.0, t, false, 0.0);
}

static inline fmi3Status update(fmi3Instance instance)
{
    fmi3Boolean flags[5];
    double next;
    return fmi3UpdateDiscreteStates(instance, &flags[0], &flags[1], &flags[2], &flags[3], &flags[4], &next);
}

static inline void initialize(fmi3Instance instance)
{
    CHECK(begin(instance, 0.0) == fmi3OK);
    CHECK(fmi3ExitInitializationMode(instance) == fmi3OK);
}

/* Results of a step. */
static struct {
    fmi3Boolean event, terminate, early;
    double t;
} told;

static inline fmi3Status step(fmi3Instance instance, double t, double h)
{
    return fmi3DoStep(instance, t, h, true, &told.event, &told.terminate, &told.early, &told.t);
}

/* An instance in this mode: initial N, I; event, continuous or step mode E, C, S; a discarded step D; T; F. */
static inline fmi3Instance brought(kind which, char mode)
{
    fmi3Instance instance = made(which);
    fmi3Boolean flag, other;
    if (mode == 'N') {
        return instance;
    }
    if (mode == 'I') {
        CHECK(begin(instance, 0.0) == fmi3OK);
        return instance;
    }
    initialize(instance);
    if (which != STEPS) {
        CHECK(update(instance) == fmi3OK);
    }
    if (mode == 'D' || mode == 'F') {
        set_fault(instance, mode == 'D' ? FAULT_STEP : FAULT_FAILURE);
    }
    if (mode == 'E') {
        return instance;
    }
    if (which == EXCHANGE) {
        CHECK(fmi3EnterContinuousTimeMode(instance) == fmi3OK);
        if (mode == 'F') {
            CHECK(fmi3CompletedIntegratorStep(instance, true, &flag, &other) == fmi3Error);
        }
    } else {
        CHECK(which == STEPS || fmi3EnterStepMode(instance) == fmi3OK);
        if (mode == 'D' || mode == 'F') {
            CHECK(step(instance, 0.0, 0.1) == (mode == 'D' ? fmi3Discard : fmi3Error));
        }
    }
    if (mode == 'T') {
        CHECK(fmi3Terminate(instance) == fmi3OK);
    }
    return instance;
}

#endif
