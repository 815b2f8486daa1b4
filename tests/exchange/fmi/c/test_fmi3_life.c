/* FMI 3: what importers do in order, against closed forms; event mode, early return, intermediate update. */
#include "host3.h"

/* q'' = -4 q, q(0) = 1. */
static double exact(double t)
{
    return cos(2.0 * t);
}

static void model_exchange(void)
{
    fmi3Instance i = made(EXCHANGE);
    fmi3Boolean again = true, stop = true, nominals = true, moved = true, defined = false;
    double next = 0.0, x[2], xd[2];
    size_t count = 0;
    CHECK(strcmp(fmi3GetVersion(), "3.0") == 0);
    CHECK(fmi3GetNumberOfContinuousStates(i, &count) == fmi3OK && count == 2);
    CHECK(fmi3GetNumberOfEventIndicators(i, &count) == fmi3OK && count == 1);
    set_float(i, V_PERIOD, 0.5);
    CHECK(begin(i, 0.0) == fmi3OK);
    set_float(i, V_Q, 2.0);
    CHECK(float_of(i, V_QDD) == -8.0);
    set_float(i, V_Q, 1.0);
    CHECK(fmi3ExitInitializationMode(i) == fmi3OK);
    CHECK(fmi3UpdateDiscreteStates(i, &again, &stop, &nominals, &moved, &defined, &next) == fmi3OK);
    CHECK(!again && !stop && !nominals && !moved && defined && next == 0.5);
    CHECK(fmi3EnterContinuousTimeMode(i) == fmi3OK && fmi3GetContinuousStates(i, x, 2) == fmi3OK);
    for (int k = 1; k <= 1000; ++k) {
        CHECK(fmi3GetContinuousStateDerivatives(i, xd, 2) == fmi3OK);
        x[1] += 0.0005 * xd[1];
        x[0] += 0.001 * x[1];
        CHECK(fmi3SetTime(i, 0.001 * k) == fmi3OK && fmi3SetContinuousStates(i, x, 2) == fmi3OK);
        CHECK(fmi3GetContinuousStateDerivatives(i, xd, 2) == fmi3OK);
        x[1] += 0.0005 * xd[1];
        CHECK(fmi3SetContinuousStates(i, x, 2) == fmi3OK && fmi3CompletedIntegratorStep(i, true, &again, &stop) == fmi3OK);
        CHECK(!again && !stop);
    }
    CHECK_NEAR(x[0], exact(1.0), 1e-6);
    CHECK(fmi3EnterEventMode(i) == fmi3OK);
    set_fault(i, FAULT_STATES);
    CHECK(fmi3UpdateDiscreteStates(i, &again, &stop, &nominals, &moved, &defined, &next) == fmi3OK && moved);
    CHECK(fmi3Terminate(i) == fmi3OK);
    fmi3FreeInstance(i);
}

static void arrays_and_types(void)
{
    fmi3Instance i = made(STEPS);
    const fmi3ValueReference both[] = {V_K, V_BIG}, kind_of = V_KIND, closed = V_CLOSED, label = V_LABEL, fault = V_FAULT;
    double value[4] = {0.0};
    fmi3Int64 chosen = 0;
    fmi3Int32 number = 0;
    fmi3Boolean flag = false;
    fmi3String text = NULL;
    CHECK(fmi3SetFloat64(i, both, 2, (const double[]){9.0, 1.0, 2.0, 3.0}, 4) == fmi3OK);
    CHECK(fmi3SetInt64(i, &kind_of, 1, (const fmi3Int64[]){3}, 1) == fmi3OK);
    initialize(i);
    CHECK(fmi3GetFloat64(i, both, 2, value, 4) == fmi3OK);
    CHECK(value[0] == 9.0 && value[1] == 1.0 && value[2] == 2.0 && value[3] == 3.0);
    CHECK(fmi3GetInt64(i, &kind_of, 1, &chosen, 1) == fmi3OK && chosen == 3);
    CHECK(fmi3GetBoolean(i, &closed, 1, &flag, 1) == fmi3OK && flag);
    CHECK(fmi3GetString(i, &label, 1, &text, 1) == fmi3OK && strcmp(text, "50 % of #1") == 0);
    CHECK(fmi3SetInt32(i, &fault, 1, (const fmi3Int32[]){-7}, 1) == fmi3OK && fmi3GetInt32(i, &fault, 1, &number, 1) == fmi3OK && number == -7);
    fmi3FreeInstance(i);
}

static void slopes(void)
{
    fmi3Instance i = brought(EXCHANGE, 'C');
    const fmi3ValueReference unknowns[] = {V_QDD, V_BIG}, knowns[] = {V_BIG, V_Q, V_K};
    const double seed[] = {1.0, 2.0, 3.0, 10.0, 100.0}, weights[] = {2.0, 5.0, 6.0, 7.0};
    double found[4] = {0.0}, back[5] = {0.0};
    /* d qdd = -k dq - q dk */
    CHECK(fmi3GetDirectionalDerivative(i, unknowns, 2, knowns, 3, seed, 5, found, 4) == fmi3OK);
    CHECK(found[0] == -4.0 * 10.0 - 100.0 && found[1] == 1.0 && found[2] == 2.0 && found[3] == 3.0);
    CHECK(fmi3GetAdjointDerivative(i, unknowns, 2, knowns, 3, weights, 4, back, 5) == fmi3OK);
    CHECK(back[0] == 5.0 && back[1] == 6.0 && back[2] == 7.0 && back[3] == -8.0 && back[4] == -2.0);
    fmi3FreeInstance(i);
}

static void dependencies(void)
{
    fmi3Instance i = made(EXCHANGE);
    size_t count = 0, own[3], theirs[3];
    fmi3ValueReference others[3];
    fmi3DependencyKind kinds[3];
    CHECK(fmi3GetNumberOfVariableDependencies(i, V_QDD, &count) == fmi3OK && count == 3);
    CHECK(fmi3GetVariableDependencies(i, V_QDD, own, others, theirs, kinds, 3) == fmi3OK);
    CHECK(others[0] == V_Q && kinds[0] == fmi3Fixed && own[0] == 1 && theirs[0] == 1);
    CHECK(others[1] == V_K && kinds[1] == fmi3Dependent && others[2] == V_U && kinds[2] == fmi3Constant);
    CHECK(fmi3GetNumberOfVariableDependencies(i, V_U, &count) == fmi3OK && count == 0);
    fmi3FreeInstance(i);
}

/* Steps end at events of the model, at 0.25 s and so on; event mode carries them out. */
static void event_mode(void)
{
    const fmi3ValueReference count_of = V_COUNT;
    fmi3Instance i = made(STEPS_WITH_EVENTS);
    fmi3Int32 count = 0;
    double t = 0.0;
    set_float(i, V_PERIOD, 0.25);
    initialize(i);
    CHECK(update(i) == fmi3OK && fmi3EnterStepMode(i) == fmi3OK);
    for (int events = 1; events <= 3; ++events) {
        CHECK(step(i, t, 1.0 - t) == fmi3OK);
        CHECK(told.event && told.early && !told.terminate && told.t == 0.25 * events);
        t = told.t;
        CHECK_NEAR(float_of(i, V_Q), exact(t), 1e-14);
        CHECK(step(i, t, 0.1) == fmi3Error && strstr(host.message, "event mode must be entered"));
        CHECK(fmi3EnterEventMode(i) == fmi3OK && update(i) == fmi3OK && fmi3EnterStepMode(i) == fmi3OK);
        CHECK(fmi3GetInt32(i, &count_of, 1, &count, 1) == fmi3OK && count == events);
    }
    /* an event at the end of a step is no early return */
    CHECK(step(i, 0.75, 0.25) == fmi3OK && told.event && !told.early && told.t == 1.0);
    fmi3FreeInstance(i);
    /* who does not use event mode, or wants no early return, gets whole steps */
    i = made(STEPS);
    set_float(i, V_PERIOD, 0.25);
    initialize(i);
    CHECK(step(i, 0.0, 1.0) == fmi3OK && !told.event && !told.early && told.t == 1.0);
    fmi3FreeInstance(i);
    i = fmi3InstantiateCoSimulation("one", STAND_IN_TOKEN, NULL, 0, 0, true, false, NULL, 0, &host, hear, NULL);
    set_float(i, V_PERIOD, 0.25);
    initialize(i);
    CHECK(update(i) == fmi3OK && fmi3EnterStepMode(i) == fmi3OK);
    CHECK(step(i, 0.0, 1.0) == fmi3OK && !told.event && !told.early && told.t == 1.0);
    fmi3FreeInstance(i);
}

/* ---- intermediate update ---- */

static struct {
    fmi3Instance instance;
    unsigned calls;
    double last, stop_at, wanted; /* when the importer wants to return, and where */
    int allowed;
} visitor;

static void visit(fmi3InstanceEnvironment environment, fmi3Float64 time, fmi3Boolean setting, fmi3Boolean getting, fmi3Boolean finished,
    fmi3Boolean may_return, fmi3Boolean *wanted, fmi3Float64 *until)
{
    const fmi3ValueReference u = V_U;
    CHECK(environment == &host && !setting && getting && finished && time > visitor.last);
    ++visitor.calls;
    visitor.last = time;
    visitor.allowed = may_return;
    CHECK(float_of(visitor.instance, V_TIME) == time);
    CHECK_NEAR(float_of(visitor.instance, V_Q), exact(time), 1e-13);
    /* what an importer may not do here */
    CHECK(step(visitor.instance, time, 0.1) == fmi3Error && fmi3Reset(visitor.instance) == fmi3Error);
    CHECK(fmi3SetFloat64(visitor.instance, &u, 1, &time, 1) == fmi3Error && fmi3Terminate(visitor.instance) == fmi3Error);
    fmi3FreeInstance(visitor.instance);
    *wanted = time >= visitor.stop_at;
    *until = visitor.wanted;
}

static fmi3Instance visited(int early_return)
{
    fmi3Instance i = fmi3InstantiateCoSimulation(
        "one", STAND_IN_TOKEN, NULL, 0, 0, false, early_return, (const fmi3ValueReference[]){V_Q}, 1, &host, hear, visit);
    visitor.instance = i;
    visitor.calls = 0;
    visitor.last = 0.0;
    visitor.stop_at = (double)INFINITY;
    initialize(i);
    return i;
}

static void intermediate_update(void)
{
    fmi3Boolean event, terminate, early;
    double t;
    fmi3Instance i = visited(1);
    /* steps of 0.03 s inside, and the end */
    CHECK(fmi3DoStep(i, 0.0, 0.1, true, &event, &terminate, &early, &t) == fmi3OK && t == 0.1 && !early && visitor.calls == 4 && !visitor.allowed);
    /* back at once, where a step inside ended */
    visitor.stop_at = 0.12;
    visitor.wanted = 0.0;
    CHECK(fmi3DoStep(i, 0.1, 0.1, true, &event, &terminate, &early, &t) == fmi3OK && early && t == visitor.last && t < 0.15);
    /* back at a time to come, between steps inside */
    const double from = t;
    visitor.stop_at = from;
    visitor.wanted = from + 0.05;
    CHECK(fmi3DoStep(i, from, 0.2, true, &event, &terminate, &early, &t) == fmi3OK && early && t == from + 0.05);
    CHECK_NEAR(float_of(i, V_Q), exact(t), 1e-13);
    visitor.stop_at = (double)INFINITY;
    CHECK(fmi3DoStep(i, t, 0.2, true, &event, &terminate, &early, &t) == fmi3OK && !early && t == from + 0.05 + 0.2);
    fmi3FreeInstance(i);
    /* who may not return early does not */
    i = visited(0);
    visitor.stop_at = 0.0;
    visitor.wanted = 0.0;
    CHECK(fmi3DoStep(i, 0.0, 0.1, true, &event, &terminate, &early, &t) == fmi3OK && !early && t == 0.1 && !visitor.allowed);
    fmi3FreeInstance(i);
}

/* An importer that allows no early return is told of none, neither by an end of the simulation nor by a failure. */
static void endings(int early_return)
{
    fmi3Instance i = fmi3InstantiateCoSimulation("one", STAND_IN_TOKEN, NULL, 0, 0, false, early_return, NULL, 0, &host, hear, NULL);
    set_fault(i, FAULT_STOP);
    initialize(i);
    CHECK(step(i, 0.0, 0.5) == fmi3OK && told.terminate && told.early == early_return && told.t == 0.35);
    CHECK_NEAR(float_of(i, V_Q), exact(0.35), 1e-14);
    CHECK(step(i, 0.35, 0.1) == fmi3OK && told.terminate && told.early == early_return && told.t == 0.35);
    CHECK(fmi3Terminate(i) == fmi3OK && fmi3Reset(i) == fmi3OK);
    set_fault(i, FAULT_STEP);
    initialize(i);
    CHECK(step(i, 0.0, 0.5) == fmi3Discard && !told.early && told.t == 0.0 && strstr(host.message, "fault 1"));
    CHECK(fmi3Reset(i) == fmi3OK);
    set_fault(i, FAULT_FAILURE);
    initialize(i);
    CHECK(step(i, 0.0, 0.5) == fmi3Error && !told.early && step(i, 0.0, 0.5) == fmi3Error);
    fmi3FreeInstance(i);
}

static void states(void)
{
    fmi3Instance i = made(STEPS), other = made(STEPS);
    fmi3FMUState state = NULL, copy = NULL;
    fmi3Byte bytes[1024];
    size_t size = 0;
    initialize(i);
    CHECK(step(i, 0.0, 0.1) == fmi3OK && fmi3GetFMUState(i, &state) == fmi3OK && step(i, 0.1, 0.2) == fmi3OK);
    const double once = float_of(i, V_Q);
    CHECK(fmi3SetFMUState(i, state) == fmi3OK && step(i, 0.1, 0.2) == fmi3OK && float_of(i, V_Q) == once);
    CHECK(fmi3SerializedFMUStateSize(i, state, &size) == fmi3OK && size <= sizeof bytes);
    CHECK(fmi3SerializeFMUState(i, state, bytes, size) == fmi3OK);
    CHECK(fmi3DeserializeFMUState(other, bytes, size, &copy) == fmi3OK && fmi3SetFMUState(other, copy) == fmi3OK);
    CHECK(step(other, 0.1, 0.2) == fmi3OK && float_of(other, V_Q) == once);
    CHECK(fmi3FreeFMUState(i, &state) == fmi3OK && state == NULL);
    fmi3FreeInstance(i);
    fmi3FreeInstance(other);
}

int main(void)
{
    model_exchange();
    arrays_and_types();
    slopes();
    dependencies();
    event_mode();
    intermediate_update();
    endings(0);
    endings(1);
    states();
    return 0;
}
