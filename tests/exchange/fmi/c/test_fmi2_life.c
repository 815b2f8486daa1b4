/* FMI 2: what importers do in order, against closed forms. */
#include "host2.h"

/* q'' = -4 q, q(0) = 1. */
static double exact(double t)
{
    return cos(2.0 * t);
}

static void versions(void)
{
    CHECK(strcmp(fmi2GetVersion(), "2.0") == 0 && strcmp(fmi2GetTypesPlatform(), "default") == 0);
}

/* Leapfrog by the importer: second order. */
static void model_exchange(void)
{
    fmi2Component c = made(fmi2ModelExchange);
    fmi2EventInfo info;
    fmi2Boolean events = 5, stop = 5;
    double x[2], xd[2], nominal[2], g;
    set_real(c, V_PERIOD, 0.5);
    CHECK(fmi2SetupExperiment(c, fmi2True, 1e-8, 0.0, fmi2True, 1.0) == fmi2OK);
    CHECK(fmi2EnterInitializationMode(c) == fmi2OK);
    CHECK(real_of(c, V_QDD) == -4.0);
    set_real(c, V_Q, 2.0);
    CHECK(real_of(c, V_QDD) == -8.0);
    set_real(c, V_Q, 1.0);
    CHECK(fmi2ExitInitializationMode(c) == fmi2OK);
    CHECK(fmi2NewDiscreteStates(c, &info) == fmi2OK);
    CHECK(!info.newDiscreteStatesNeeded && !info.terminateSimulation && info.nextEventTimeDefined && info.nextEventTime == 0.5);
    CHECK(fmi2EnterContinuousTimeMode(c) == fmi2OK);
    CHECK(fmi2GetContinuousStates(c, x, 2) == fmi2OK && fmi2GetNominalsOfContinuousStates(c, nominal, 2) == fmi2OK);
    CHECK(nominal[0] == 2.0 && nominal[1] == 3.0);
    for (int i = 1; i <= 1000; ++i) {
        CHECK(fmi2GetDerivatives(c, xd, 2) == fmi2OK);
        x[1] += 0.0005 * xd[1];
        x[0] += 0.001 * x[1];
        CHECK(fmi2SetTime(c, 0.001 * i) == fmi2OK && fmi2SetContinuousStates(c, x, 2) == fmi2OK && fmi2GetDerivatives(c, xd, 2) == fmi2OK);
        x[1] += 0.0005 * xd[1];
        CHECK(fmi2SetContinuousStates(c, x, 2) == fmi2OK);
        CHECK(fmi2CompletedIntegratorStep(c, fmi2True, &events, &stop) == fmi2OK && !events && !stop);
    }
    CHECK_NEAR(x[0], exact(1.0), 1e-6);
    CHECK(fmi2GetEventIndicators(c, &g, 1) == fmi2OK && g == x[0] - 0.5 && real_of(c, V_TIME) == 1.0);
    CHECK(fmi2SetContinuousStates(c, (const double[]){11.0, 0.0}, 2) == fmi2OK);
    CHECK(fmi2CompletedIntegratorStep(c, fmi2True, &events, &stop) == fmi2OK && events == fmi2True);
    CHECK(fmi2EnterEventMode(c) == fmi2OK);
    set_fault(c, FAULT_STATES);
    CHECK(fmi2NewDiscreteStates(c, &info) == fmi2OK && info.valuesOfContinuousStatesChanged);
    CHECK(fmi2Terminate(c) == fmi2OK);
    CHECK(real_of(c, V_Q) == 11.0);
    fmi2FreeInstance(c);
}

/* Steps of any lengths, a parameter that changes between them, another start time. */
static void co_simulation(void)
{
    fmi2Component c = made(fmi2CoSimulation);
    const fmi2ValueReference q = V_Q, qdd = V_QDD, known[] = {V_Q, V_K};
    const int first = 1;
    double t = 5.0, rate, slope;
    CHECK(fmi2SetupExperiment(c, fmi2False, 0.0, 5.0, fmi2False, 0.0) == fmi2OK);
    initialize(c);
    CHECK(real_of(c, V_TIME) == 5.0);
    for (int i = 0; i < 100; ++i) {
        const double h = 0.001 * (1 + i % 7);
        CHECK(fmi2DoStep(c, t, h, fmi2True) == fmi2OK);
        t += h;
        CHECK_NEAR(real_of(c, V_Q), exact(t - 5.0), 1e-12);
    }
    CHECK(fmi2GetRealOutputDerivatives(c, &q, 1, &first, &rate) == fmi2OK);
    CHECK_NEAR(rate, -2.0 * sin(2.0 * (t - 5.0)), 1e-12);
    CHECK(fmi2GetDirectionalDerivative(c, &qdd, 1, known, 2, (const double[]){1.0, 10.0}, &slope) == fmi2OK);
    CHECK_NEAR(slope, -4.0 - 10.0 * exact(t - 5.0), 1e-11);
    const double before = real_of(c, V_Q);
    set_real(c, V_K, 9.0);
    CHECK(fmi2DoStep(c, t, 0.1, fmi2True) == fmi2OK);
    CHECK_NEAR(real_of(c, V_Q), before * cos(0.3) + rate / 3.0 * sin(0.3), 1e-12);
    CHECK(fmi2GetRealStatus(c, fmi2LastSuccessfulTime, &rate) == fmi2OK && rate == t + 0.1);
    CHECK(fmi2Terminate(c) == fmi2OK);
    CHECK(fmi2Reset(c) == fmi2OK);
    initialize(c);
    CHECK(real_of(c, V_Q) == 1.0 && real_of(c, V_K) == 4.0 && real_of(c, V_TIME) == 0.0);
    fmi2FreeInstance(c);
}

/* A thousand steps of a tenth, as an importer adds them up: no step is refused, and the last one ends at the stop time. */
static void sums(void)
{
    fmi2Component c = made(fmi2CoSimulation);
    double t = 0.0;
    CHECK(fmi2SetupExperiment(c, fmi2False, 0.0, 0.0, fmi2True, 100.0) == fmi2OK);
    initialize(c);
    for (int i = 0; i < 1000; ++i, t += 0.1) {
        CHECK(fmi2DoStep(c, t, 0.1, fmi2True) == fmi2OK);
    }
    CHECK(t != 100.0);
    CHECK_NEAR(real_of(c, V_TIME), t, 4e-14);
    CHECK_NEAR(real_of(c, V_Q), exact(t), 1e-11);
    fmi2FreeInstance(c);
}

static void endings(void)
{
    double t;
    fmi2Boolean ended = 5;
    fmi2Component c = made(fmi2CoSimulation);
    set_fault(c, FAULT_STOP);
    initialize(c);
    CHECK(fmi2DoStep(c, 0.0, 0.3, fmi2True) == fmi2OK);
    CHECK(fmi2GetBooleanStatus(c, fmi2Terminated, &ended) == fmi2OK && !ended);
    CHECK(fmi2DoStep(c, 0.3, 0.3, fmi2True) == fmi2Discard);
    CHECK(fmi2GetBooleanStatus(c, fmi2Terminated, &ended) == fmi2OK && ended == fmi2True);
    CHECK(fmi2GetRealStatus(c, fmi2LastSuccessfulTime, &t) == fmi2OK && t == 0.35);
    CHECK_NEAR(real_of(c, V_Q), exact(0.35), 1e-14);
    CHECK(fmi2Terminate(c) == fmi2OK);
    fmi2FreeInstance(c);
    c = made(fmi2CoSimulation);
    set_fault(c, FAULT_STOP_AT_START);
    initialize(c);
    CHECK(fmi2DoStep(c, 0.0, 0.3, fmi2True) == fmi2Discard);
    CHECK(fmi2GetBooleanStatus(c, fmi2Terminated, &ended) == fmi2OK && ended == fmi2True);
    fmi2FreeInstance(c);
}

/* A discarded step can be done again from a state of before. */
static void discarded(void)
{
    fmi2Component c = brought(fmi2CoSimulation, 'S');
    fmi2FMUstate state = NULL;
    fmi2Boolean ended = 5;
    CHECK(fmi2DoStep(c, 0.0, 0.1, fmi2True) == fmi2OK && fmi2GetFMUstate(c, &state) == fmi2OK);
    set_fault(c, FAULT_STEP);
    CHECK(fmi2DoStep(c, 0.1, 0.2, fmi2False) == fmi2Discard && strstr(host.message, "fault 1"));
    CHECK(fmi2GetBooleanStatus(c, fmi2Terminated, &ended) == fmi2OK && !ended);
    CHECK(fmi2SetFMUstate(c, state) == fmi2OK);
    CHECK(fmi2DoStep(c, 0.1, 0.2, fmi2True) == fmi2OK);
    CHECK_NEAR(real_of(c, V_Q), exact(0.3), 1e-14);
    fmi2FreeInstance(c); /* with the state, which was not freed */
}

static void failures(void)
{
    fmi2EventInfo info;
    fmi2Component c = made(fmi2CoSimulation);
    set_fault(c, FAULT_START);
    CHECK(fmi2EnterInitializationMode(c) == fmi2OK);
    CHECK(fmi2GetReal(c, (const fmi2ValueReference[]){V_QDD}, 1, (double[]){0.0}) == fmi2Error);
    set_fault(c, FAULT_NONE); /* it may still be put right */
    CHECK(real_of(c, V_QDD) == -4.0);
    set_fault(c, FAULT_START);
    CHECK(fmi2ExitInitializationMode(c) == fmi2Error && strstr(host.message, "fault 5"));
    CHECK(fmi2DoStep(c, 0.0, 0.1, fmi2True) == fmi2Error && fmi2Reset(c) == fmi2OK);
    fmi2FreeInstance(c);
    c = brought(fmi2ModelExchange, 'E');
    CHECK(fmi2EnterEventMode(c) == fmi2OK && fmi2EnterContinuousTimeMode(c) == fmi2Error); /* nothing was updated */
    CHECK(fmi2NewDiscreteStates(c, &info) == fmi2OK && !info.newDiscreteStatesNeeded);
    set_fault(c, FAULT_FAILURE);
    CHECK(fmi2Terminate(c) == fmi2Error); /* what the model wants at the end does not hold */
    fmi2FreeInstance(c);
}

/* Taken back, also into another instance and through bytes: the same numbers to the last bit. */
static void states(void)
{
    fmi2Component c = brought(fmi2CoSimulation, 'S'), other = made(fmi2CoSimulation);
    fmi2FMUstate state = NULL, copy = NULL;
    char bytes[1024];
    size_t size;
    CHECK(fmi2DoStep(c, 0.0, 0.1, fmi2False) == fmi2OK && fmi2GetFMUstate(c, &state) == fmi2OK);
    CHECK(fmi2DoStep(c, 0.1, 0.2, fmi2False) == fmi2OK);
    const double once = real_of(c, V_Q);
    CHECK(fmi2SetFMUstate(c, state) == fmi2OK && real_of(c, V_TIME) == 0.1);
    CHECK(fmi2DoStep(c, 0.1, 0.2, fmi2False) == fmi2OK && real_of(c, V_Q) == once);
    CHECK(fmi2SerializedFMUstateSize(c, state, &size) == fmi2OK && size <= sizeof bytes);
    CHECK(fmi2SerializeFMUstate(c, state, bytes, size) == fmi2OK);
    CHECK(fmi2DeSerializeFMUstate(other, bytes, size, &copy) == fmi2OK && fmi2SetFMUstate(other, copy) == fmi2OK);
    CHECK(fmi2DoStep(other, 0.1, 0.2, fmi2False) == fmi2OK && real_of(other, V_Q) == once);
    /* a state is used again where there is one */
    const fmi2FMUstate same = state;
    const size_t living = host.living;
    CHECK(fmi2GetFMUstate(c, &state) == fmi2OK && state == same && host.living == living);
    CHECK(fmi2FreeFMUstate(c, &state) == fmi2OK && state == NULL && host.living == living - 1);
    fmi2FreeInstance(other);
    fmi2FreeInstance(c);
}

static void types(void)
{
    fmi2Component c = brought(fmi2CoSimulation, 'S');
    const fmi2ValueReference closed = V_CLOSED, count = V_COUNT, label = V_LABEL, fault = V_FAULT;
    fmi2Boolean flag = 5;
    fmi2Integer number = 5;
    fmi2String text = NULL;
    CHECK(fmi2GetBoolean(c, &closed, 1, &flag) == fmi2OK && flag == fmi2True);
    CHECK(fmi2GetInteger(c, &count, 1, &number) == fmi2OK && number == 0);
    CHECK(fmi2GetString(c, &label, 1, &text) == fmi2OK && strcmp(text, "50 % of #1") == 0);
    CHECK(fmi2SetInteger(c, &fault, 1, (const int[]){-7}) == fmi2OK && fmi2GetInteger(c, &fault, 1, &number) == fmi2OK && number == -7);
    fmi2FreeInstance(c);
}

int main(void)
{
    versions();
    model_exchange();
    co_simulation();
    sums();
    endings();
    discarded();
    failures();
    states();
    types();
    CHECK(host.living == 0);
    return 0;
}
