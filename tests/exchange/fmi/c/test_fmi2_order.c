/* FMI 2: which function may be called in which mode, by the tables of calling sequences of FMI 2.0.4, sections 3.2.3 and 4.2.4. */
#include "host2.h"

static fmi2ValueReference u = V_U, k = V_K, qdd = V_QDD, q = V_Q, fault_of = V_FAULT, closed = V_CLOSED, label = V_LABEL, period = V_PERIOD;
static double value[2];
static const double zeros[2] = {0.0, 0.0};
static int number;
static fmi2String text;
static fmi2EventInfo info;
static fmi2Boolean flag, other;
static const fmi2Integer first_order = 1;
static fmi2FMUstate kept;

static fmi2Status logging(fmi2Component c) { return fmi2SetDebugLogging(c, fmi2True, 0, NULL); }
static fmi2Status setup(fmi2Component c) { return fmi2SetupExperiment(c, fmi2False, 0.0, 0.0, fmi2False, 0.0); }
static fmi2Status get_real(fmi2Component c) { return fmi2GetReal(c, &qdd, 1, value); }
static fmi2Status get_integer(fmi2Component c) { return fmi2GetInteger(c, &fault_of, 1, &number); }
static fmi2Status get_boolean(fmi2Component c) { return fmi2GetBoolean(c, &closed, 1, &flag); }
static fmi2Status get_string(fmi2Component c) { return fmi2GetString(c, &label, 1, &text); }
static fmi2Status set_input(fmi2Component c) { return fmi2SetReal(c, &u, 1, zeros); }
static fmi2Status set_tunable(fmi2Component c) { return fmi2SetReal(c, &k, 1, (const double[]){5.0}); }
static fmi2Status set_state(fmi2Component c) { return fmi2SetReal(c, &q, 1, zeros); }
static fmi2Status set_fixed(fmi2Component c) { return fmi2SetReal(c, &period, 1, zeros); }
static fmi2Status set_integer(fmi2Component c) { return fmi2SetInteger(c, &fault_of, 1, &number); }
static fmi2Status slope(fmi2Component c) { return fmi2GetDirectionalDerivative(c, &qdd, 1, &q, 1, zeros, value); }
static fmi2Status update(fmi2Component c) { return fmi2NewDiscreteStates(c, &info); }
static fmi2Status completed(fmi2Component c) { return fmi2CompletedIntegratorStep(c, fmi2True, &flag, &other); }
static fmi2Status set_time(fmi2Component c) { return fmi2SetTime(c, 0.1); }
static fmi2Status set_states(fmi2Component c) { return fmi2SetContinuousStates(c, zeros, 2); }
static fmi2Status rates(fmi2Component c) { return fmi2GetDerivatives(c, value, 2); }
static fmi2Status indicators(fmi2Component c) { return fmi2GetEventIndicators(c, value, 1); }
static fmi2Status states(fmi2Component c) { return fmi2GetContinuousStates(c, value, 2); }
static fmi2Status nominals(fmi2Component c) { return fmi2GetNominalsOfContinuousStates(c, value, 2); }
static fmi2Status input_slope(fmi2Component c) { return fmi2SetRealInputDerivatives(c, &u, 1, &first_order, zeros); }
static fmi2Status output_slope(fmi2Component c) { return fmi2GetRealOutputDerivatives(c, &q, 1, &first_order, value); }
static fmi2Status step(fmi2Component c) { return fmi2DoStep(c, 0.0, 0.1, fmi2True); }
static fmi2Status status(fmi2Component c) { fmi2Status s; return fmi2GetStatus(c, fmi2DoStepStatus, &s); }
static fmi2Status real_status(fmi2Component c) { return fmi2GetRealStatus(c, fmi2LastSuccessfulTime, value); }
static fmi2Status integer_status(fmi2Component c) { return fmi2GetIntegerStatus(c, fmi2PendingStatus, &number); }
static fmi2Status boolean_status(fmi2Component c) { return fmi2GetBooleanStatus(c, fmi2Terminated, &flag); }
static fmi2Status string_status(fmi2Component c) { return fmi2GetStringStatus(c, fmi2PendingStatus, &text); }
static fmi2Status save(fmi2Component c) { return fmi2GetFMUstate(c, &kept); }

static const struct {
    const char *name;
    fmi2Status (*call)(fmi2Component);
    const char *exchange, *steps; /* modes in which it is allowed */
} CALLS[] = {
    {"fmi2SetDebugLogging", logging, "NIECTF", "NISDTF"},
    {"fmi2SetupExperiment", setup, "N", "N"},
    {"fmi2EnterInitializationMode", fmi2EnterInitializationMode, "N", "N"},
    {"fmi2ExitInitializationMode", fmi2ExitInitializationMode, "I", "I"},
    {"fmi2Terminate", fmi2Terminate, "EC", "SD"},
    {"fmi2Reset", fmi2Reset, "NIECTF", "NISDTF"},
    {"fmi2GetReal", get_real, "IECTF", "ISDTF"},
    {"fmi2GetInteger", get_integer, "NIECTF", "NISDTF"}, /* of a parameter: its value is there from the beginning */
    {"fmi2GetBoolean", get_boolean, "IECTF", "ISDTF"},
    {"fmi2GetString", get_string, "NIECTF", "NISDTF"},
    {"fmi2SetReal of an input", set_input, "NIEC", "NIS"},
    {"fmi2SetReal of a tunable parameter", set_tunable, "NIEC", "NIS"}, /* C: more than the standard, for importers that evaluate only */
    {"fmi2SetReal of a state", set_state, "NIEC", "NI"}, /* E, C: likewise */
    {"fmi2SetReal of a parameter that is not tunable", set_fixed, "NI", "NI"},
    {"fmi2SetInteger", set_integer, "NIE", "NIS"},
    {"fmi2GetDirectionalDerivative", slope, "IECTF", "ISDTF"},
    {"fmi2GetFMUstate", save, "NIECTF", "NISDTF"},
    {"fmi2EnterEventMode", fmi2EnterEventMode, "EC", ""},
    {"fmi2NewDiscreteStates", update, "E", ""},
    {"fmi2EnterContinuousTimeMode", fmi2EnterContinuousTimeMode, "E", ""},
    {"fmi2CompletedIntegratorStep", completed, "C", ""},
    {"fmi2SetTime", set_time, "EC", ""},
    {"fmi2SetContinuousStates", set_states, "C", ""},
    {"fmi2GetDerivatives", rates, "IECTF", ""},
    {"fmi2GetEventIndicators", indicators, "IECTF", ""},
    {"fmi2GetContinuousStates", states, "IECTF", ""},
    {"fmi2GetNominalsOfContinuousStates", nominals, "NIECTF", ""},
    {"fmi2SetRealInputDerivatives", input_slope, "", "NIS"},
    {"fmi2GetRealOutputDerivatives", output_slope, "", "SDTF"},
    {"fmi2DoStep", step, "", "S"},
    {"fmi2CancelStep", fmi2CancelStep, "", ""},
    {"fmi2GetStatus", status, "", "SDTF"},
    {"fmi2GetRealStatus", real_status, "", "SDTF"},
    {"fmi2GetIntegerStatus", integer_status, "", "SDTF"},
    {"fmi2GetBooleanStatus", boolean_status, "", "SDTF"},
    {"fmi2GetStringStatus", string_status, "", "SDTF"},
};

enum { CALL_COUNT = sizeof CALLS / sizeof CALLS[0], ROOM = 4096 };

static size_t write_down(fmi2Component c, char *bytes)
{
    size_t size = 0;
    fmi2FMUstate state = NULL;
    CHECK(fmi2GetFMUstate(c, &state) == fmi2OK);
    CHECK(fmi2SerializedFMUstateSize(c, state, &size) == fmi2OK && size <= ROOM);
    CHECK(fmi2SerializeFMUstate(c, state, bytes, size) == fmi2OK);
    CHECK(fmi2FreeFMUstate(c, &state) == fmi2OK && state == NULL);
    return size;
}

/* A function that is not allowed is refused, with a message, and leaves everything as it was. */
static void try(fmi2Type type, char mode, size_t i)
{
    static char before[ROOM], after[ROOM];
    fmi2Component c = brought(type, mode);
    const int allowed = strchr(type == fmi2ModelExchange ? CALLS[i].exchange : CALLS[i].steps, mode) != NULL;
    const size_t size = write_down(c, before);
    const unsigned told = host.told;
    kept = NULL;
    const fmi2Status answer = CALLS[i].call(c);
    if ((answer != fmi2Error) != allowed) {
        (void)fprintf(stderr, "%s in mode %c of type %d: status %d\n", CALLS[i].name, mode, (int)type, (int)answer);
        exit(EXIT_FAILURE);
    }
    CHECK(answer == fmi2OK || (host.told == told + 1 && host.status == answer));
    if (!allowed) {
        CHECK(write_down(c, after) == size && memcmp(before, after, size) == 0);
        CHECK(strcmp(host.category, "logStatusError") == 0 && strncmp(host.message, "fmi2", 4) == 0);
    }
    fmi2FreeInstance(c);
    CHECK(host.living == 0);
}

int main(void)
{
    for (size_t i = 0; i < CALL_COUNT; ++i) {
        for (const char *mode = MODES_OF_EXCHANGE; *mode != '\0'; ++mode) {
            try(fmi2ModelExchange, *mode, i);
        }
        for (const char *mode = MODES_OF_STEPS; *mode != '\0'; ++mode) {
            try(fmi2CoSimulation, *mode, i);
        }
    }
    return 0;
}
