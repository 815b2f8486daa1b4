/* FMI 3: arguments that no importer should give. Each is answered by a status and a message, and changes nothing. */
#include "host3.h"

static void expect(fmi3Status answer, fmi3Status status, const char *words)
{
    if (answer != status || (words != NULL && strstr(host.message, words) == NULL)) {
        (void)fprintf(stderr, "status %d instead of %d, or not '%s' in: %s\n", (int)answer, (int)status, words, host.message);
        exit(EXIT_FAILURE);
    }
}

static fmi3Instance stepping(const char *name, const char *token, const fmi3ValueReference *required, size_t count)
{
    return fmi3InstantiateCoSimulation(name, token, NULL, false, false, false, false, required, count, &host, hear, NULL);
}

static void instances(void)
{
    const unsigned before = host.told;
    CHECK(fmi3InstantiateModelExchange("one", "{another}", NULL, 0, 0, &host, hear) == NULL && strstr(host.message, "token"));
    CHECK(fmi3InstantiateModelExchange("one", NULL, NULL, 0, 0, &host, hear) == NULL);
    CHECK(fmi3InstantiateModelExchange(NULL, STAND_IN_TOKEN, NULL, 0, 0, &host, hear) == NULL && strstr(host.message, "name"));
    CHECK(fmi3InstantiateModelExchange("", STAND_IN_TOKEN, NULL, 0, 0, NULL, NULL) == NULL);
    CHECK(stepping("one", "{another}", NULL, 0) == NULL);
    CHECK(stepping("one", STAND_IN_TOKEN, NULL, 1) == NULL && strstr(host.message, "null"));
    CHECK(stepping("one", STAND_IN_TOKEN, (const fmi3ValueReference[]){V_Q, 99}, 2) == NULL && strstr(host.message, "99"));
    CHECK(fmi3InstantiateScheduledExecution("one", STAND_IN_TOKEN, NULL, 0, 0, &host, hear, NULL, NULL, NULL) == NULL);
    CHECK(strstr(host.message, "only model exchange") != NULL);
    CHECK(host.told == before + 7);
    /* an importer that wants to hear nothing */
    fmi3Instance instance = fmi3InstantiateModelExchange("one", STAND_IN_TOKEN, NULL, 0, 1, NULL, NULL);
    CHECK(instance != NULL && fmi3Terminate(instance) == fmi3Error);
    fmi3FreeInstance(instance);
    fmi3FreeInstance(NULL);
    double wrong[64] = {1.0};
    fmi3FreeInstance(wrong);
    fmi3FreeInstance((char *)wrong + 1);
    CHECK(fmi3Reset(NULL) == fmi3Error && fmi3Reset(wrong) == fmi3Error && fmi3Reset((char *)wrong + 1) == fmi3Error);
}

static void values(void)
{
    fmi3Instance i = brought(STEPS, 'S');
    const fmi3ValueReference q = V_Q, u = V_U, fault = V_FAULT, wide = V_BIG, closed = V_CLOSED, pair[] = {V_U, V_VARIABLES};
    double value[4] = {7.0, 8.0, 9.0, 10.0};
    fmi3Int32 number = 3;
    fmi3Int64 choice = 3;
    fmi3String text = NULL;
    fmi3Boolean flag = true;
    expect(fmi3GetFloat64(i, NULL, 1, value, 1), fmi3Error, "null");
    expect(fmi3GetFloat64(i, &q, 1, NULL, 1), fmi3Error, "null");
    expect(fmi3GetFloat64(i, NULL, 0, NULL, 0), fmi3OK, NULL);
    expect(fmi3GetFloat64(i, &q, 1, value, 2), fmi3Error, "room for 2 values, where these variables have 1");
    expect(fmi3GetFloat64(i, &wide, 1, value, 2), fmi3Error, "room for 2 values, where these variables have 3");
    expect(fmi3GetFloat64(i, &q, 1, value, 0), fmi3Error, "room for 0");
    expect(fmi3GetFloat64(i, pair, 2, value, 2), fmi3Error, "value reference 13");
    CHECK(value[0] == 7.0);
    expect(fmi3GetFloat64(i, &fault, 1, value, 1), fmi3Error, "an integer, not a real");
    expect(fmi3GetInt32(i, &q, 1, &number, 1), fmi3Error, "a real number, not an integer");
    expect(fmi3GetInt64(i, &fault, 1, &choice, 1), fmi3Error, "not an enumeration");
    expect(fmi3GetBoolean(i, &q, 1, &flag, 1), fmi3Error, "not a Boolean");
    expect(fmi3GetString(i, &q, 1, &text, 1), fmi3Error, "not a text");
    expect(fmi3SetFloat64(i, &q, 1, value, 1), fmi3Error, "cannot be set now");
    expect(fmi3SetBoolean(i, &closed, 1, &flag, 1), fmi3Error, "cannot be set");
    expect(fmi3SetString(i, &q, 1, &text, 1), fmi3Error, "constants");
    expect(fmi3SetFloat64(i, pair, 2, value, 2), fmi3Error, "13");
    expect(fmi3SetFloat64(i, (const fmi3ValueReference[]){V_U, V_K}, 2, (const double[]){1.0, (double)NAN}, 2), fmi3Error, "not a number");
    CHECK(float_of(i, V_U) == 0.0);
    expect(fmi3SetFloat64(i, &u, 1, (const double[]){(double)INFINITY}, 1), fmi3Error, "infinite");
    expect(fmi3GetOutputDerivatives(i, &q, 1, (const fmi3Int32[]){0}, value, 1), fmi3Error, "at least 1");
    expect(fmi3GetOutputDerivatives(i, &q, 1, (const fmi3Int32[]){2}, value, 1), fmi3Error, "fault");
    expect(fmi3GetOutputDerivatives(i, &q, 1, (const fmi3Int32[]){1}, value, 2), fmi3Error, "room for 2");
    expect(fmi3GetDirectionalDerivative(i, &wide, 1, &q, 1, value, 1, value, 1), fmi3Error, "1 seeds and 1 sensitivities for 3 unknowns");
    expect(fmi3GetAdjointDerivative(i, &wide, 1, &q, 1, value, 1, value, 1), fmi3Error, "for 3 unknowns and 1 knowns");
    expect(fmi3GetAdjointDerivative(i, &q, 1, pair, 2, value, 1, value, 2), fmi3Error, "13");
    expect(fmi3GetAdjointDerivative(i, &q, 1, &q, 1, value, 1, NULL, 1), fmi3Error, "null");
    fmi3FreeInstance(i);
}

/* No variable is of these types: with none of them nothing is to be done, with one it is an error. */
static void types(void)
{
    fmi3Instance i = brought(STEPS, 'S');
    const fmi3ValueReference q = V_Q;
    union {
        fmi3Float32 f;
        fmi3Int8 i8;
        fmi3UInt8 u8;
        fmi3Int16 i16;
        fmi3UInt16 u16;
        fmi3UInt32 u32;
        fmi3UInt64 u64;
    } x = {.u64 = 0};
    size_t size = 0;
    fmi3Binary bytes = NULL;
    fmi3Float64 shift;
    fmi3UInt64 counter;
    fmi3IntervalQualifier qualifier;
#define NONE(TYPE, MEMBER)                                                                                                \
    expect(fmi3Get##TYPE(i, &q, 1, &x.MEMBER, 1), fmi3Error, #TYPE);                                                      \
    expect(fmi3Set##TYPE(i, &q, 1, &x.MEMBER, 1), fmi3Error, #TYPE);                                                      \
    expect(fmi3Set##TYPE(i, NULL, 0, NULL, 1), fmi3Error, #TYPE);                                                         \
    CHECK(fmi3Get##TYPE(i, NULL, 0, NULL, 0) == fmi3OK && fmi3Set##TYPE(i, NULL, 0, NULL, 0) == fmi3OK);
    NONE(Float32, f)
    NONE(Int8, i8)
    NONE(UInt8, u8)
    NONE(Int16, i16)
    NONE(UInt16, u16)
    NONE(UInt32, u32)
    NONE(UInt64, u64)
    expect(fmi3GetBinary(i, &q, 1, &size, &bytes, 1), fmi3Error, "Binary");
    expect(fmi3SetBinary(i, &q, 1, &size, &bytes, 1), fmi3Error, "Binary");
    CHECK(fmi3GetBinary(i, NULL, 0, NULL, NULL, 0) == fmi3OK && fmi3SetBinary(i, NULL, 0, NULL, NULL, 0) == fmi3OK);
    expect(fmi3SetClock(i, &q, 1, &(fmi3Boolean){true}), fmi3Error, "not allowed in step mode");
    expect(fmi3GetShiftDecimal(i, &q, 1, &shift), fmi3Error, "not allowed in step mode");
    expect(fmi3SetShiftDecimal(i, &q, 1, &(fmi3Float64){0.0}), fmi3Error, "clock");
    expect(fmi3SetIntervalDecimal(i, &q, 1, &(fmi3Float64){0.0}), fmi3Error, "clock");
    expect(fmi3GetShiftFraction(i, &q, 1, &counter, &counter), fmi3Error, "clock");
    expect(fmi3SetShiftFraction(i, &q, 1, &(fmi3UInt64){0}, &(fmi3UInt64){0}), fmi3Error, "clock");
    expect(fmi3SetIntervalFraction(i, &q, 1, &(fmi3UInt64){0}, &(fmi3UInt64){0}), fmi3Error, "clock");
    expect(fmi3GetIntervalFraction(i, &q, 1, &counter, &counter, &qualifier), fmi3Error, "clock");
    CHECK(fmi3GetClock(i, NULL, 0, NULL) == fmi3OK && fmi3SetIntervalDecimal(i, NULL, 0, NULL) == fmi3OK);
    fmi3FreeInstance(i);
}

static void steps(void)
{
    fmi3Instance i = made(STEPS);
    fmi3Boolean flag;
    double t;
    expect(begin(i, (double)NAN), fmi3Error, "start time");
    expect(fmi3EnterInitializationMode(i, false, 0.0, 2.0, true, 1.0), fmi3Error, "not after the start time");
    expect(fmi3EnterInitializationMode(i, true, -1.0, 0.0, false, 0.0), fmi3Error, "tolerance");
    CHECK(fmi3EnterInitializationMode(i, true, 1e-6, 0.0, true, 1.0) == fmi3OK && fmi3ExitInitializationMode(i) == fmi3OK);
    expect(step(i, 0.0, 0.0), fmi3Error, "longer than zero");
    expect(step(i, 0.0, -1.0), fmi3Error, "longer than zero");
    expect(step(i, 0.0, (double)NAN), fmi3Error, "not a number");
    expect(step(i, 0.5, 0.1), fmi3Error, "not where the last step ended");
    expect(step(i, 0.0, 1.5), fmi3Error, "after the stop time");
    CHECK(told.t == 0.0 && !told.event && !told.terminate && !told.early);
    expect(fmi3DoStep(i, 0.0, 0.1, true, NULL, &flag, &flag, &t), fmi3Error, "eventHandlingNeeded");
    expect(fmi3DoStep(i, 0.0, 0.1, true, &flag, NULL, &flag, &t), fmi3Error, "terminateSimulation");
    expect(fmi3DoStep(i, 0.0, 0.1, true, &flag, &flag, NULL, &t), fmi3Error, "earlyReturn");
    expect(fmi3DoStep(i, 0.0, 0.1, true, &flag, &flag, &flag, NULL), fmi3Error, "lastSuccessfulTime");
    expect(fmi3EnterEventMode(i), fmi3Error, "without event mode");
    CHECK(float_of(i, V_TIME) == 0.0 && step(i, 0.0, 1.0) == fmi3OK);
    fmi3FreeInstance(i);
}

static void exchange(void)
{
    fmi3Instance i = brought(EXCHANGE, 'C');
    double value[4] = {0.0};
    size_t count = 0, places[3];
    fmi3Boolean flag;
    fmi3ValueReference others[3];
    fmi3DependencyKind kinds[3];
    expect(fmi3SetTime(i, (double)INFINITY), fmi3Error, "time");
    expect(fmi3SetContinuousStates(i, value, 3), fmi3Error, "room for 3 states");
    expect(fmi3SetContinuousStates(i, (const double[]){(double)NAN, 0.0}, 2), fmi3Error, "state 1");
    expect(fmi3GetContinuousStates(i, NULL, 2), fmi3Error, "null");
    expect(fmi3GetContinuousStateDerivatives(i, value, 1), fmi3Error, "room for 1");
    expect(fmi3GetEventIndicators(i, NULL, 1), fmi3Error, "null");
    expect(fmi3GetNominalsOfContinuousStates(i, value, 4), fmi3Error, "room for 4");
    expect(fmi3GetNumberOfContinuousStates(i, NULL), fmi3Error, "null");
    expect(fmi3GetNumberOfEventIndicators(i, NULL), fmi3Error, "null");
    expect(fmi3CompletedIntegratorStep(i, true, NULL, &flag), fmi3Error, "null");
    expect(fmi3GetNumberOfVariableDependencies(i, V_QDD, NULL), fmi3Error, "null");
    expect(fmi3GetNumberOfVariableDependencies(i, 99, &count), fmi3Error, "99");
    expect(fmi3GetVariableDependencies(i, V_QDD, places, others, places, kinds, 2), fmi3Error, "room for 2 dependencies, where there are 3");
    expect(fmi3GetVariableDependencies(i, V_QDD, places, NULL, places, kinds, 3), fmi3Error, "null");
    CHECK(fmi3GetVariableDependencies(i, V_K, NULL, NULL, NULL, NULL, 0) == fmi3OK);
    CHECK(fmi3EnterEventMode(i) == fmi3OK);
    expect(fmi3EnterContinuousTimeMode(i), fmi3Error, "updated first");
    expect(fmi3UpdateDiscreteStates(i, NULL, &flag, &flag, &flag, &flag, value), fmi3Error, "null");
    expect(fmi3UpdateDiscreteStates(i, &flag, &flag, &flag, &flag, &flag, NULL), fmi3Error, "nextEventTime");
    fmi3FreeInstance(i);
}

static void states(void)
{
    fmi3Instance i = brought(STEPS, 'S'), other = brought(STEPS_WITH_EVENTS, 'S');
    fmi3FMUState state = NULL, none = NULL;
    fmi3Byte bytes[1024];
    size_t size = 0;
    double odd[64] = {2.0};
    expect(fmi3GetFMUState(i, NULL), fmi3Error, "null");
    expect(fmi3SetFMUState(i, NULL), fmi3Error, "null");
    expect(fmi3SetFMUState(i, odd), fmi3Error, "not an FMU state");
    CHECK(fmi3FreeFMUState(i, NULL) == fmi3OK && fmi3FreeFMUState(i, &none) == fmi3OK);
    CHECK(fmi3GetFMUState(i, &state) == fmi3OK);
    expect(fmi3SetFMUState(other, state), fmi3Error, "another kind");
    CHECK(fmi3SerializedFMUStateSize(i, state, &size) == fmi3OK && size < sizeof bytes);
    expect(fmi3SerializeFMUState(i, state, bytes, size + 1), fmi3Error, "room for");
    CHECK(fmi3SerializeFMUState(i, state, bytes, size) == fmi3OK);
    expect(fmi3DeserializeFMUState(i, bytes, size - 8, &none), fmi3Error, "too few");
    bytes[size - 1] ^= 1;
    expect(fmi3DeserializeFMUState(i, bytes, size, &none), fmi3Error, "have been changed");
    fmi3FreeInstance(i);
    fmi3FreeInstance(other);
}

int main(void)
{
    instances();
    values();
    types();
    steps();
    exchange();
    states();
    return 0;
}
