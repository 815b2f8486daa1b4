/*
 * Shells that list the handles which live (LAG_DEBUG_HANDLES): freed ones, invented ones and nonsense are refused without looking into
 * the memory where they point; the address sanitizer would tell.
 */
#include <pthread.h>

#include "host2.h"

static void expect_dead(fmi2Component c)
{
    const fmi2ValueReference q = V_Q;
    double value[2] = {7.0, 7.0};
    fmi2FMUstate state = NULL;
    fmi2EventInfo info;
    size_t size = 0;
    const unsigned told = host.told;
    CHECK(fmi2GetReal(c, &q, 1, value) == fmi2Error && value[0] == 7.0);
    CHECK(fmi2SetReal(c, &q, 1, value) == fmi2Error && fmi2DoStep(c, 0.0, 0.1, 1) == fmi2Error && fmi2Reset(c) == fmi2Error);
    CHECK(fmi2EnterInitializationMode(c) == fmi2Error && fmi2Terminate(c) == fmi2Error && fmi2NewDiscreteStates(c, &info) == fmi2Error);
    CHECK(fmi2GetDerivatives(c, value, 2) == fmi2Error && fmi2GetContinuousStates(c, value, 2) == fmi2Error);
    CHECK(fmi2GetFMUstate(c, &state) == fmi2Error && state == NULL && fmi2SerializedFMUstateSize(c, state, &size) == fmi2Error);
    fmi2FreeInstance(c);
    CHECK(host.told == told); /* there is nobody to tell */
}

static void instances(void)
{
    double nonsense[32] = {1.0};
    fmi2Component c = brought(fmi2CoSimulation, 'S');
    fmi2FreeInstance(c);
    expect_dead(c);
    expect_dead((fmi2Component)16);
    expect_dead(nonsense);
    /* others live on */
    fmi2Component one = brought(fmi2CoSimulation, 'S'), two = brought(fmi2CoSimulation, 'S'), three = brought(fmi2CoSimulation, 'S');
    fmi2FreeInstance(two);
    expect_dead(two);
    CHECK(fmi2DoStep(one, 0.0, 0.1, 1) == fmi2OK && fmi2DoStep(three, 0.0, 0.1, 1) == fmi2OK);
    fmi2FreeInstance(three);
    fmi2FreeInstance(one);
    expect_dead(one);
    expect_dead(three);
}

static void states(void)
{
    fmi2Component one = brought(fmi2CoSimulation, 'S'), two = brought(fmi2CoSimulation, 'S');
    fmi2FMUstate state = NULL, copy, theirs = NULL;
    size_t size;
    CHECK(fmi2GetFMUstate(one, &state) == fmi2OK);
    copy = state;
    CHECK(fmi2FreeFMUstate(one, &state) == fmi2OK);
    CHECK(fmi2SetFMUstate(one, copy) == fmi2Error && strstr(host.message, "not an FMU state"));
    CHECK(fmi2FreeFMUstate(one, &copy) == fmi2Error && fmi2GetFMUstate(one, &copy) == fmi2Error);
    CHECK(fmi2SerializedFMUstateSize(one, copy, &size) == fmi2Error);
    CHECK(fmi2SetFMUstate(one, two) == fmi2Error && fmi2SetFMUstate(one, (fmi2FMUstate)16) == fmi2Error);
    /* states go with their instance */
    CHECK(fmi2GetFMUstate(two, &theirs) == fmi2OK && fmi2SetFMUstate(one, theirs) == fmi2OK);
    fmi2FreeInstance(two);
    CHECK(fmi2SetFMUstate(one, theirs) == fmi2Error && fmi2FreeFMUstate(one, &theirs) == fmi2Error);
    fmi2FreeInstance(one);
}

static void *live(void *unused)
{
    static const fmi2CallbackFunctions silent = {NULL, NULL, NULL, NULL, NULL};
    for (int i = 0; i < 200; ++i) {
        fmi2Component c = fmi2Instantiate("one", fmi2CoSimulation, STAND_IN_TOKEN, NULL, &silent, 0, 0);
        fmi2FMUstate state = NULL;
        CHECK(c != NULL && fmi2EnterInitializationMode(c) == fmi2OK && fmi2ExitInitializationMode(c) == fmi2OK);
        CHECK(fmi2GetFMUstate(c, &state) == fmi2OK && fmi2DoStep(c, 0.0, 0.1, 1) == fmi2OK && fmi2SetFMUstate(c, state) == fmi2OK);
        fmi2FreeInstance(c);
    }
    return unused;
}

int main(void)
{
    pthread_t threads[4];
    instances();
    states();
    CHECK(host.living == 0);
    for (int i = 0; i < 4; ++i) {
        CHECK(pthread_create(&threads[i], NULL, live, NULL) == 0);
    }
    for (int i = 0; i < 4; ++i) {
        CHECK(pthread_join(threads[i], NULL) == 0);
    }
    return 0;
}
