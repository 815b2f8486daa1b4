/* An importer of FMI 2 for the tests of its shell: it counts what it is told and what it gives. */
#ifndef HOST2_H
#define HOST2_H

#include "../../../c/check.h"
#include "fmi2Functions.h"
#include "stand_in.h"

#include <stdarg.h>

static struct {
    unsigned told;
    fmi2Status status;
    char category[64], message[1024];
    size_t living; /* blocks of memory */
} host;

static void hear(fmi2ComponentEnvironment environment, fmi2String name, fmi2Status status, fmi2String category, fmi2String message, ...)
{
    va_list arguments;
    CHECK(environment == &host && name != NULL);
    ++host.told;
    host.status = status;
    (void)snprintf(host.category, sizeof host.category, "%s", category);
    va_start(arguments, message);
    (void)vsnprintf(host.message, sizeof host.message, message, arguments);
    va_end(arguments);
}

static void *give(size_t count, size_t size)
{
    ++host.living;
    return calloc(count, size);
}

static void take(void *memory)
{
    --host.living;
    free(memory);
}

static const fmi2CallbackFunctions functions = {hear, give, take, NULL, &host};

static inline fmi2Component made(fmi2Type type)
{
    fmi2Component c = fmi2Instantiate("one", type, STAND_IN_TOKEN, NULL, &functions, fmi2False, fmi2False);
    CHECK(c != NULL);
    return c;
}

static inline void set_real(fmi2Component c, fmi2ValueReference reference, double value)
{
    CHECK(fmi2SetReal(c, &reference, 1, &value) == fmi2OK);
}

static inline double real_of(fmi2Component c, fmi2ValueReference reference)
{
    double value = 0.0;
    CHECK(fmi2GetReal(c, &reference, 1, &value) == fmi2OK);
    return value;
}

static inline void set_fault(fmi2Component c, int fault)
{
    const fmi2ValueReference reference = V_FAULT;
    CHECK(fmi2SetInteger(c, &reference, 1, &fault) == fmi2OK);
}

static inline void initialize(fmi2Component c)
{
    CHECK(fmi2EnterInitializationMode(c) == fmi2OK);
    CHECK(fmi2ExitInitializationMode(c) == fmi2OK);
}

/* The modes of the standard. */
static const char MODES_OF_EXCHANGE[] = "NIECTF";
static const char MODES_OF_STEPS[] = "NISDTF";

/* An instance in this mode. */
static inline fmi2Component brought(fmi2Type type, char mode)
{
    fmi2Component c = made(type);
    fmi2EventInfo info;
    fmi2Boolean flag, other;
    if (mode == 'N') {
        return c;
    }
    if (mode == 'I') {
        CHECK(fmi2EnterInitializationMode(c) == fmi2OK);
        return c;
    }
    initialize(c);
    if (type == fmi2ModelExchange) {
        CHECK(fmi2NewDiscreteStates(c, &info) == fmi2OK);
        if (mode == 'F') {
            set_fault(c, FAULT_FAILURE);
        }
        if (mode != 'E') {
            CHECK(fmi2EnterContinuousTimeMode(c) == fmi2OK);
        }
        if (mode == 'F') {
            CHECK(fmi2CompletedIntegratorStep(c, fmi2True, &flag, &other) == fmi2Error);
        }
    } else if (mode == 'D' || mode == 'F') {
        set_fault(c, mode == 'D' ? FAULT_STEP : FAULT_FAILURE);
        CHECK(fmi2DoStep(c, 0.0, 0.1, fmi2True) == (mode == 'D' ? fmi2Discard : fmi2Error));
    }
    if (mode == 'T') {
        CHECK(fmi2Terminate(c) == fmi2OK);
    }
    return c;
}

#endif
