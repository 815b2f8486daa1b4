/* FMI 3: which function may be called in which mode, by the state machines of FMI 3.0, sections 2.3, 3.2 and 4.2. */
#include "host3.h"

static const fmi3ValueReference u = V_U, k = V_K, qdd = V_QDD, q = V_Q, fault_of = V_FAULT, closed = V_CLOSED, label = V_LABEL, choice = V_KIND, period = V_PERIOD;
static double value[3];
static const double zeros[3] = {0.0, 0.0, 0.0};
static fmi3Int32 number;
static fmi3Int64 chosen;
static fmi3String text;
static fmi3Boolean flag, other;
static size_t size, places[8];
static fmi3ValueReference references[8];
static fmi3DependencyKind kinds[8];
static const fmi3Int32 first_order = 1;
static fmi3FMUState kept;

static fmi3Status logging(fmi3Instance i) { return fmi3SetDebugLogging(i, true, 0, NULL); }
static fmi3Status enter(fmi3Instance i) { return begin(i, 0.0); }
static fmi3Status get_float(fmi3Instance i) { return fmi3GetFloat64(i, &qdd, 1, value, 1); }
static fmi3Status get_integer(fmi3Instance i) { return fmi3GetInt32(i, &fault_of, 1, &number, 1); }
static fmi3Status get_choice(fmi3Instance i) { return fmi3GetInt64(i, &choice, 1, &chosen, 1); }
static fmi3Status get_boolean(fmi3Instance i) { return fmi3GetBoolean(i, &closed, 1, &flag, 1); }
static fmi3Status get_string(fmi3Instance i) { return fmi3GetString(i, &label, 1, &text, 1); }
static fmi3Status set_input(fmi3Instance i) { return fmi3SetFloat64(i, &u, 1, zeros, 1); }
static fmi3Status set_tunable(fmi3Instance i) { return fmi3SetFloat64(i, &k, 1, (const double[]){5.0}, 1); }
static fmi3Status set_state(fmi3Instance i) { return fmi3SetFloat64(i, &q, 1, zeros, 1); }
static fmi3Status set_fixed(fmi3Instance i) { return fmi3SetFloat64(i, &period, 1, zeros, 1); }
static fmi3Status set_integer(fmi3Instance i) { return fmi3SetInt32(i, &fault_of, 1, &number, 1); }
static fmi3Status set_choice(fmi3Instance i) { return fmi3SetInt64(i, &choice, 1, &chosen, 1); }
static fmi3Status directional(fmi3Instance i) { return fmi3GetDirectionalDerivative(i, &qdd, 1, &q, 1, zeros, 1, value, 1); }
static fmi3Status adjoint(fmi3Instance i) { return fmi3GetAdjointDerivative(i, &qdd, 1, &q, 1, zeros, 1, value, 1); }
static fmi3Status completed(fmi3Instance i) { return fmi3CompletedIntegratorStep(i, true, &flag, &other); }
static fmi3Status set_time(fmi3Instance i) { return fmi3SetTime(i, 0.1); }
static fmi3Status set_states(fmi3Instance i) { return fmi3SetContinuousStates(i, zeros, 2); }
static fmi3Status rates(fmi3Instance i) { return fmi3GetContinuousStateDerivatives(i, value, 2); }
static fmi3Status indicators(fmi3Instance i) { return fmi3GetEventIndicators(i, value, 1); }
static fmi3Status states(fmi3Instance i) { return fmi3GetContinuousStates(i, value, 2); }
static fmi3Status nominals(fmi3Instance i) { return fmi3GetNominalsOfContinuousStates(i, value, 2); }
static fmi3Status count_states(fmi3Instance i) { return fmi3GetNumberOfContinuousStates(i, &size); }
static fmi3Status count_indicators(fmi3Instance i) { return fmi3GetNumberOfEventIndicators(i, &size); }
static fmi3Status output_slope(fmi3Instance i) { return fmi3GetOutputDerivatives(i, &q, 1, &first_order, value, 1); }
static fmi3Status do_step(fmi3Instance i) { return step(i, 0.0, 0.1); }
static fmi3Status count_dependencies(fmi3Instance i) { return fmi3GetNumberOfVariableDependencies(i, V_QDD, &size); }
static fmi3Status dependencies(fmi3Instance i) { return fmi3GetVariableDependencies(i, V_QDD, places, references, places, kinds, 3); }
static fmi3Status save(fmi3Instance i) { return fmi3GetFMUState(i, &kept); }
static fmi3Status partition(fmi3Instance i) { return fmi3ActivateModelPartition(i, 0, 0.0); }
static fmi3Status intervals(fmi3Instance i) { return fmi3GetIntervalDecimal(i, &u, 1, value, NULL); }
static fmi3Status clocks(fmi3Instance i) { return fmi3GetClock(i, &u, 1, &flag); }

static const struct {
    const char *name;
    fmi3Status (*call)(fmi3Instance);
    const char *allowed[3]; /* modes: model exchange, co-simulation, co-simulation with event mode */
} CALLS[] = {
    {"fmi3SetDebugLogging", logging, {"NIECTF", "NISDTF", "NIESDTF"}},
    {"fmi3EnterInitializationMode", enter, {"N", "N", "N"}},
    {"fmi3ExitInitializationMode", fmi3ExitInitializationMode, {"I", "I", "I"}},
    {"fmi3EnterEventMode", fmi3EnterEventMode, {"EC", "", "ES"}},
    {"fmi3UpdateDiscreteStates", update, {"E", "", "E"}},
    {"fmi3EvaluateDiscreteStates", fmi3EvaluateDiscreteStates, {"", "", ""}},
    {"fmi3EnterContinuousTimeMode", fmi3EnterContinuousTimeMode, {"E", "", ""}},
    {"fmi3EnterStepMode", fmi3EnterStepMode, {"", "", "E"}},
    {"fmi3Terminate", fmi3Terminate, {"EC", "SD", "ESD"}},
    {"fmi3Reset", fmi3Reset, {"NIECTF", "NISDTF", "NIESDTF"}},
    {"fmi3GetFloat64", get_float, {"IECTF", "ISDTF", "IESDTF"}},
    {"fmi3GetInt32", get_integer, {"NIECTF", "NISDTF", "NIESDTF"}}, /* of a parameter: its value is there from the beginning */
    {"fmi3GetInt64", get_choice, {"NIECTF", "NISDTF", "NIESDTF"}},
    {"fmi3GetBoolean", get_boolean, {"IECTF", "ISDTF", "IESDTF"}},
    {"fmi3GetString", get_string, {"NIECTF", "NISDTF", "NIESDTF"}},
    {"fmi3SetFloat64 of an input", set_input, {"NIEC", "NIS", "NIES"}},
    {"fmi3SetFloat64 of a tunable parameter", set_tunable, {"NIEC", "NIS", "NIE"}}, /* C: more than the standard, for importers that evaluate only */
    {"fmi3SetFloat64 of a state", set_state, {"NIEC", "NI", "NI"}}, /* E, C: likewise */
    {"fmi3SetFloat64 of a parameter that is not tunable", set_fixed, {"NI", "NI", "NI"}},
    {"fmi3SetInt32", set_integer, {"NIE", "NIS", "NIE"}},
    {"fmi3SetInt64", set_choice, {"NI", "NI", "NI"}},
    {"fmi3GetDirectionalDerivative", directional, {"IECTF", "ISDTF", "IESDTF"}},
    {"fmi3GetAdjointDerivative", adjoint, {"IECTF", "ISDTF", "IESDTF"}},
    {"fmi3GetFMUState", save, {"NIECTF", "NISDTF", "NIESDTF"}},
    {"fmi3CompletedIntegratorStep", completed, {"C", "", ""}},
    {"fmi3SetTime", set_time, {"EC", "", ""}},
    {"fmi3SetContinuousStates", set_states, {"C", "", ""}},
    {"fmi3GetContinuousStateDerivatives", rates, {"IECTF", "", ""}},
    {"fmi3GetEventIndicators", indicators, {"IECTF", "", ""}},
    {"fmi3GetContinuousStates", states, {"IECTF", "", ""}},
    {"fmi3GetNominalsOfContinuousStates", nominals, {"NIECTF", "", ""}},
    {"fmi3GetNumberOfContinuousStates", count_states, {"NIECTF", "", ""}},
    {"fmi3GetNumberOfEventIndicators", count_indicators, {"NIECTF", "", ""}},
    {"fmi3GetOutputDerivatives", output_slope, {"", "SDTF", "SDTF"}},
    {"fmi3DoStep", do_step, {"", "S", "S"}},
    {"fmi3GetNumberOfVariableDependencies", count_dependencies, {"NIECTF", "NISDTF", "NIESDTF"}},
    {"fmi3GetVariableDependencies", dependencies, {"NIECTF", "NISDTF", "NIESDTF"}},
    {"fmi3EnterConfigurationMode", fmi3EnterConfigurationMode, {"", "", ""}},
    {"fmi3ExitConfigurationMode", fmi3ExitConfigurationMode, {"", "", ""}},
    {"fmi3ActivateModelPartition", partition, {"", "", ""}},
    {"fmi3GetIntervalDecimal", intervals, {"", "", ""}},
    {"fmi3GetClock", clocks, {"", "", ""}},
};

enum { CALL_COUNT = sizeof CALLS / sizeof CALLS[0], ROOM = 4096 };

static size_t write_down(fmi3Instance instance, fmi3Byte *bytes)
{
    size_t count = 0;
    fmi3FMUState state = NULL;
    CHECK(fmi3GetFMUState(instance, &state) == fmi3OK);
    CHECK(fmi3SerializedFMUStateSize(instance, state, &count) == fmi3OK && count <= ROOM);
    CHECK(fmi3SerializeFMUState(instance, state, bytes, count) == fmi3OK);
    CHECK(fmi3FreeFMUState(instance, &state) == fmi3OK && state == NULL);
    return count;
}

/* A function that is not allowed is refused, with a message, and leaves everything as it was. */
static void try(kind which, char mode, size_t i)
{
    static fmi3Byte before[ROOM], after[ROOM];
    fmi3Instance instance = brought(which, mode);
    const int allowed = strchr(CALLS[i].allowed[which], mode) != NULL;
    const size_t count = write_down(instance, before);
    const unsigned messages = host.told;
    kept = NULL;
    const fmi3Status answer = CALLS[i].call(instance);
    if ((answer != fmi3Error) != allowed) {
        (void)fprintf(stderr, "%s in mode %c of kind %d: status %d\n", CALLS[i].name, mode, (int)which, (int)answer);
        exit(EXIT_FAILURE);
    }
    CHECK(answer == fmi3OK || (host.told == messages + 1 && host.status == answer));
    if (!allowed) {
        CHECK(write_down(instance, after) == count && memcmp(before, after, count) == 0);
        CHECK(strcmp(host.category, "logStatusError") == 0 && strncmp(host.message, "fmi3", 4) == 0);
    }
    fmi3FreeInstance(instance);
}

int main(void)
{
    static const char *const modes[] = {"NIECTF", "NISDTF", "NIESDTF"};
    for (size_t i = 0; i < CALL_COUNT; ++i) {
        for (int which = EXCHANGE; which <= STEPS_WITH_EVENTS; ++which) {
            for (const char *mode = modes[which]; *mode != '\0'; ++mode) {
                try((kind)which, *mode, i);
            }
        }
    }
    return 0;
}
