/* FMI 2: arguments that no importer should give. Each is answered by a status and a message, and changes nothing. */
#include "host2.h"

static void expect(fmi2Status answer, fmi2Status status, const char *words)
{
    if (answer != status || (words != NULL && strstr(host.message, words) == NULL)) {
        (void)fprintf(stderr, "status %d instead of %d, or not '%s' in: %s\n", (int)answer, (int)status, words, host.message);
        exit(EXIT_FAILURE);
    }
}

static void instances(void)
{
    fmi2CallbackFunctions silent = {NULL, NULL, NULL, NULL, NULL};
    fmi2CallbackFunctions half = {hear, give, NULL, NULL, &host};
    const unsigned told = host.told;
    CHECK(fmi2Instantiate("one", fmi2ModelExchange, STAND_IN_TOKEN, NULL, NULL, 0, 0) == NULL);
    CHECK(fmi2Instantiate("one", fmi2ModelExchange, "{another}", NULL, &functions, 0, 0) == NULL && strstr(host.message, "GUID"));
    CHECK(fmi2Instantiate("one", fmi2ModelExchange, NULL, NULL, &functions, 0, 0) == NULL);
    CHECK(fmi2Instantiate(NULL, fmi2ModelExchange, STAND_IN_TOKEN, NULL, &functions, 0, 0) == NULL && strstr(host.message, "name"));
    CHECK(fmi2Instantiate("", fmi2ModelExchange, STAND_IN_TOKEN, NULL, &functions, 0, 0) == NULL);
    CHECK(fmi2Instantiate("one", (fmi2Type)7, STAND_IN_TOKEN, NULL, &functions, 0, 0) == NULL && strstr(host.message, "only model exchange"));
    CHECK(fmi2Instantiate(NULL, fmi2ModelExchange, "{another}", NULL, &silent, 0, 0) == NULL);
    CHECK(host.told == told + 5 && host.living == 0);
    /* without callbacks, or with half of those for memory */
    fmi2Component c = fmi2Instantiate("one", fmi2CoSimulation, STAND_IN_TOKEN, NULL, &silent, 0, 1);
    CHECK(c != NULL && fmi2DoStep(c, 0.0, 1.0, 1) == fmi2Error);
    initialize(c);
    CHECK(fmi2DoStep(c, 0.0, 0.5, 1) == fmi2OK);
    fmi2FreeInstance(c);
    c = fmi2Instantiate("one", fmi2CoSimulation, STAND_IN_TOKEN, NULL, &half, 0, 1);
    CHECK(c != NULL && host.living == 0);
    fmi2FreeInstance(c);
    /* handles that are none */
    fmi2FreeInstance(NULL);
    double wrong[64] = {1.0};
    fmi2FreeInstance(wrong);
    fmi2FreeInstance((char *)wrong + 1);
    CHECK(fmi2Reset(NULL) == fmi2Error && fmi2Reset(wrong) == fmi2Error && fmi2Reset((char *)wrong + 1) == fmi2Error);
}

static void *starve(size_t count, size_t size)
{
    (void)count;
    (void)size;
    return NULL;
}

static void *shift(size_t count, size_t size)
{
    static double block[512];
    CHECK(count * size < sizeof block);
    return (char *)block + 1;
}

static void keep(void *memory)
{
    (void)memory;
}

static void memory(void)
{
    fmi2CallbackFunctions without = {hear, starve, keep, NULL, &host};
    CHECK(fmi2Instantiate("one", fmi2ModelExchange, STAND_IN_TOKEN, NULL, &without, 0, 0) == NULL && strstr(host.message, "memory"));
    without.allocateMemory = shift;
    CHECK(fmi2Instantiate("one", fmi2ModelExchange, STAND_IN_TOKEN, NULL, &without, 0, 0) == NULL && strstr(host.message, "aligned"));
}

static void values(void)
{
    fmi2Component c = brought(fmi2CoSimulation, 'S');
    const fmi2ValueReference q = V_Q, u = V_U, fault = V_FAULT, wide = V_BIG, label = V_LABEL, pair[] = {V_U, V_VARIABLES};
    double value[3] = {7.0, 8.0, 9.0};
    int number = 3;
    fmi2String text = NULL;
    expect(fmi2GetReal(c, NULL, 1, value), fmi2Error, "null");
    expect(fmi2GetReal(c, &q, 1, NULL), fmi2Error, "null");
    expect(fmi2GetReal(c, NULL, 0, NULL), fmi2OK, NULL);
    expect(fmi2SetReal(c, NULL, 0, NULL), fmi2OK, NULL);
    expect(fmi2GetReal(c, pair, 2, value), fmi2Error, "value reference 13");
    CHECK(value[0] == 7.0);
    expect(fmi2GetReal(c, (const fmi2ValueReference[]){4294967295u}, 1, value), fmi2Error, "4294967295");
    expect(fmi2GetReal(c, &fault, 1, value), fmi2Error, "an integer, not a real");
    expect(fmi2GetInteger(c, &q, 1, &number), fmi2Error, "a real number, not an integer");
    expect(fmi2GetBoolean(c, &q, 1, &number), fmi2Error, "not a Boolean");
    expect(fmi2GetString(c, &q, 1, &text), fmi2Error, "not a text");
    expect(fmi2GetReal(c, &wide, 1, value), fmi2Error, "room for 1");
    expect(fmi2SetReal(c, &q, 1, value), fmi2Error, "cannot be set now");
    expect(fmi2SetReal(c, (const fmi2ValueReference[]){V_TIME}, 1, value), fmi2Error, "cannot be set");
    expect(fmi2SetString(c, &label, 1, &text), fmi2Error, "constants");
    /* all or nothing */
    CHECK(real_of(c, V_U) == 0.0);
    expect(fmi2SetReal(c, pair, 2, value), fmi2Error, "13");
    expect(fmi2SetReal(c, (const fmi2ValueReference[]){V_U, V_K}, 2, (const double[]){1.0, (double)NAN}), fmi2Error, "not a number");
    expect(fmi2SetReal(c, &u, 1, (const double[]){(double)INFINITY}), fmi2Error, "infinite");
    CHECK(real_of(c, V_U) == 0.0);
    expect(fmi2SetRealInputDerivatives(c, &u, 1, (const int[]){0}, value), fmi2Error, "at least 1");
    expect(fmi2SetRealInputDerivatives(c, &u, 1, (const int[]){2}, value), fmi2Error, "fault");
    expect(fmi2SetRealInputDerivatives(c, &u, 1, (const int[]){1}, (const double[]){(double)NAN}), fmi2Error, "finite");
    expect(fmi2SetRealInputDerivatives(c, &q, 1, (const int[]){1}, value), fmi2Error, "not an input");
    expect(fmi2SetRealInputDerivatives(c, &u, 1, NULL, value), fmi2Error, "null");
    expect(fmi2GetRealOutputDerivatives(c, &q, 1, (const int[]){-1}, value), fmi2Error, "at least 1");
    expect(fmi2GetRealOutputDerivatives(c, &q, 1, (const int[]){2}, value), fmi2Error, "fault");
    expect(fmi2GetDirectionalDerivative(c, pair, 2, &q, 1, value, value), fmi2Error, "13");
    expect(fmi2GetDirectionalDerivative(c, &fault, 1, &q, 1, value, value), fmi2Error, "not a real number");
    expect(fmi2GetDirectionalDerivative(c, &q, 1, NULL, 1, value, value), fmi2Error, "null");
    expect(fmi2GetDirectionalDerivative(c, &q, 1, &q, 1, NULL, value), fmi2Error, "null");
    expect(fmi2GetDirectionalDerivative(c, &q, 0, &q, 0, NULL, NULL), fmi2OK, NULL);
    fmi2FreeInstance(c);
}

static void steps(void)
{
    fmi2Component c = made(fmi2CoSimulation);
    expect(fmi2SetupExperiment(c, 0, 0.0, (double)NAN, 0, 0.0), fmi2Error, "start time");
    expect(fmi2SetupExperiment(c, 0, 0.0, 2.0, 1, 1.0), fmi2Error, "not after the start time");
    expect(fmi2SetupExperiment(c, 0, 0.0, 0.0, 1, (double)NAN), fmi2Error, "stop time");
    expect(fmi2SetupExperiment(c, 1, 0.0, 0.0, 0, 0.0), fmi2Error, "tolerance");
    expect(fmi2SetupExperiment(c, 1, (double)INFINITY, 0.0, 0, 0.0), fmi2Error, "tolerance");
    CHECK(fmi2SetupExperiment(c, 0, -1.0, 0.0, 1, 1.0) == fmi2OK);
    initialize(c);
    expect(fmi2DoStep(c, 0.0, 0.0, 1), fmi2Error, "longer than zero");
    expect(fmi2DoStep(c, 0.0, -0.1, 1), fmi2Error, "longer than zero");
    expect(fmi2DoStep(c, 0.0, (double)NAN, 1), fmi2Error, "not a number");
    expect(fmi2DoStep(c, 0.0, 1e13, 1), fmi2Error, "round-off");
    expect(fmi2DoStep(c, 0.0, (double)INFINITY, 1), fmi2Error, "infinite");
    expect(fmi2DoStep(c, (double)NAN, 0.1, 1), fmi2Error, "not a number");
    expect(fmi2DoStep(c, 0.1, 0.1, 1), fmi2Error, "not where the last step ended");
    expect(fmi2DoStep(c, -0.1, 0.1, 1), fmi2Error, "not where the last step ended");
    expect(fmi2DoStep(c, 0.0, 1.1, 1), fmi2Error, "after the stop time");
    CHECK(fmi2DoStep(c, 0.0, 0.9, 1) == fmi2OK);
    expect(fmi2DoStep(c, 0.9, 1e-17, 1), fmi2Error, "round-off");
    CHECK(fmi2DoStep(c, 0.9, 0.1, 1) == fmi2OK);
    CHECK_NEAR(real_of(c, V_Q), cos(2.0), 1e-14);
    fmi2FreeInstance(c);
}

static void exchange(void)
{
    fmi2Component c = brought(fmi2ModelExchange, 'C');
    double value[4] = {0.0};
    expect(fmi2SetTime(c, (double)NAN), fmi2Error, "time");
    expect(fmi2SetContinuousStates(c, value, 1), fmi2Error, "room for 1 states, where there are 2");
    expect(fmi2SetContinuousStates(c, value, 4), fmi2Error, "room for 4");
    expect(fmi2SetContinuousStates(c, NULL, 2), fmi2Error, "null");
    expect(fmi2SetContinuousStates(c, (const double[]){0.0, (double)NAN}, 2), fmi2Error, "state 2");
    expect(fmi2GetContinuousStates(c, value, 3), fmi2Error, "room for 3");
    expect(fmi2GetDerivatives(c, NULL, 2), fmi2Error, "null");
    expect(fmi2GetDerivatives(c, value, 0), fmi2Error, "room for 0");
    expect(fmi2GetEventIndicators(c, value, 2), fmi2Error, "room for 2");
    expect(fmi2GetNominalsOfContinuousStates(c, value, 1), fmi2Error, "room for 1");
    expect(fmi2CompletedIntegratorStep(c, 1, NULL, NULL), fmi2Error, "null");
    CHECK(fmi2EnterEventMode(c) == fmi2OK);
    expect(fmi2EnterContinuousTimeMode(c), fmi2Error, "updated first");
    expect(fmi2NewDiscreteStates(c, NULL), fmi2Error, "null");
    fmi2FreeInstance(c);
}

static void states(void)
{
    fmi2Component c = brought(fmi2CoSimulation, 'S');
    fmi2Component other = brought(fmi2ModelExchange, 'C');
    fmi2FMUstate state = NULL, none = NULL;
    size_t size = 0;
    char bytes[1024], wrong[1024];
    double odd[64] = {2.0};
    expect(fmi2GetFMUstate(c, NULL), fmi2Error, "null");
    expect(fmi2SetFMUstate(c, NULL), fmi2Error, "null");
    expect(fmi2SetFMUstate(c, odd), fmi2Error, "not an FMU state");
    expect(fmi2SetFMUstate(c, c), fmi2Error, "not an FMU state");
    CHECK(fmi2FreeFMUstate(c, NULL) == fmi2OK && fmi2FreeFMUstate(c, &none) == fmi2OK);
    CHECK(fmi2GetFMUstate(c, &state) == fmi2OK && state != NULL);
    expect(fmi2SetFMUstate(other, state), fmi2Error, "another kind");
    expect(fmi2SerializedFMUstateSize(c, state, NULL), fmi2Error, "null");
    CHECK(fmi2SerializedFMUstateSize(c, state, &size) == fmi2OK && size < sizeof bytes);
    expect(fmi2SerializeFMUstate(c, state, bytes, size - 1), fmi2Error, "room for");
    expect(fmi2SerializeFMUstate(c, state, NULL, size), fmi2Error, "null");
    CHECK(fmi2SerializeFMUstate(c, state, bytes, size) == fmi2OK);
    expect(fmi2DeSerializeFMUstate(c, NULL, size, &none), fmi2Error, "null");
    expect(fmi2DeSerializeFMUstate(c, bytes, size, NULL), fmi2Error, "null");
    expect(fmi2DeSerializeFMUstate(c, bytes, size - 1, &none), fmi2Error, "too few or too many");
    expect(fmi2DeSerializeFMUstate(c, bytes, 0, &none), fmi2Error, "too few or too many");
    /* every single byte counts */
    for (size_t i = 0; i < size; ++i) {
        memcpy(wrong, bytes, size);
        wrong[i] = (char)(wrong[i] ^ 16);
        expect(fmi2DeSerializeFMUstate(c, wrong, size, &none), fmi2Error, "fmi2DeSerializeFMUstate");
        CHECK(none == NULL);
    }
    fmi2FreeInstance(c);
    fmi2FreeInstance(other);
}

static void logging(void)
{
    fmi2Component c = made(fmi2ModelExchange);
    const fmi2String none[] = {"logNothing"}, empty[] = {NULL}, events[] = {"logEvents"}, errors[] = {"logStatusError"};
    expect(fmi2SetDebugLogging(c, 1, 1, none), fmi2Error, "no log category logNothing");
    expect(fmi2SetDebugLogging(c, 1, 1, empty), fmi2Error, "no log category");
    expect(fmi2SetDebugLogging(c, 1, 1, NULL), fmi2Error, "null");
    initialize(c);
    unsigned told = host.told;
    CHECK(fmi2EnterEventMode(c) == fmi2OK && host.told == told);
    fmi2FreeInstance(c);
    c = brought(fmi2ModelExchange, 'C');
    CHECK(fmi2SetDebugLogging(c, 1, 1, events) == fmi2OK);
    told = host.told;
    CHECK(fmi2EnterEventMode(c) == fmi2OK && host.told == told + 1 && strcmp(host.category, "logEvents") == 0 && host.status == fmi2OK);
    /* off: events are not told, errors are, until they are switched off by name */
    CHECK(fmi2SetDebugLogging(c, 0, 0, NULL) == fmi2OK);
    told = host.told;
    CHECK(fmi2EnterEventMode(c) == fmi2OK && host.told == told);
    CHECK(fmi2SetTime(c, (double)NAN) == fmi2Error && host.told == told + 1);
    CHECK(fmi2SetDebugLogging(c, 0, 1, errors) == fmi2OK);
    CHECK(fmi2SetTime(c, (double)NAN) == fmi2Error && host.told == told + 1);
    CHECK(fmi2SetDebugLogging(c, 1, 0, NULL) == fmi2OK);
    CHECK(fmi2SetTime(c, (double)NAN) == fmi2Error && host.told == told + 2);
    fmi2FreeInstance(c);
    /* what is special to printf, and to importers that look for # */
    c = brought(fmi2ModelExchange, 'C');
    set_real(c, V_U, 1.0);
    CHECK(fmi2EnterEventMode(c) == fmi2OK);
    set_fault(c, FAULT_RATES);
    CHECK(fmi2GetReal(c, (const fmi2ValueReference[]){V_QDD}, 1, (double[]){0.0}) == fmi2Discard);
    CHECK(strstr(host.message, "fault 4, 100 % sure") != NULL && strcmp(host.category, "logStatusDiscard") == 0);
    CHECK(fmi2SetDebugLogging(c, 1, 1, (const fmi2String[]){"50 %s of #"}) == fmi2Error && strstr(host.message, "50 %s of ##") != NULL);
    fmi2FreeInstance(c);
}

/* A logger that calls back. */
static fmi2Component itself;

static void meddle(fmi2ComponentEnvironment environment, fmi2String name, fmi2Status status, fmi2String category, fmi2String message, ...)
{
    (void)environment;
    (void)name;
    (void)status;
    (void)category;
    (void)message;
    fmi2FreeInstance(itself);
    CHECK(itself == NULL || fmi2Reset(itself) == fmi2Error);
}

static void callbacks(void)
{
    const fmi2CallbackFunctions meddling = {meddle, NULL, NULL, NULL, NULL};
    itself = fmi2Instantiate("one", fmi2ModelExchange, STAND_IN_TOKEN, NULL, &meddling, 0, 0);
    CHECK(itself != NULL && fmi2ExitInitializationMode(itself) == fmi2Error);
    initialize(itself);
    fmi2FreeInstance(itself);
}

int main(void)
{
    instances();
    memory();
    values();
    steps();
    exchange();
    states();
    logging();
    callbacks();
    CHECK(host.living == 0);
    return 0;
}
