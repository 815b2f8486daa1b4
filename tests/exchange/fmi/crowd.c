/*
 * Many instances of an FMU: crowd LIBRARY VERSION TOKEN RESOURCES STOP CYCLES REFERENCE ...
 *
 * Lives CYCLES times, from instantiation over one step to the end, and prints the bytes that the heap holds after a hundred of them
 * and after all. Then lets sixteen threads move an instance each, and prints how many came to other bits than one alone.
 */
#include <dlfcn.h>
#include <malloc.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fmi2Functions.h"
#include "fmi3Functions.h"

enum { MOST = 64, THREADS = 16, STEPS = 50, WARM = 100 };

typedef struct course {
    void *library;
    int version, count;
    const char *token, *resources;
    double stop;
    unsigned int references[MOST];
} course;

typedef struct life {
    const course *as;
    int steps;
    double values[MOST];
} life;

static void *needed(const course *as, const char *name)
{
    void *found = dlsym(as->library, name);
    if (found == NULL) {
        (void)fprintf(stderr, "no %s\n", name);
        exit(2);
    }
    return found;
}

static void require(int status, const char *what)
{
    if (status != 0) {
        (void)fprintf(stderr, "%s: status %d\n", what, status);
        exit(3);
    }
}

#define GET(type, name) type *name = (type *)needed(as, #name)

static void live2(const course *as, int steps, double *values)
{
    GET(fmi2InstantiateTYPE, fmi2Instantiate);
    GET(fmi2SetupExperimentTYPE, fmi2SetupExperiment);
    GET(fmi2EnterInitializationModeTYPE, fmi2EnterInitializationMode);
    GET(fmi2ExitInitializationModeTYPE, fmi2ExitInitializationMode);
    GET(fmi2GetRealTYPE, fmi2GetReal);
    GET(fmi2DoStepTYPE, fmi2DoStep);
    GET(fmi2TerminateTYPE, fmi2Terminate);
    GET(fmi2FreeInstanceTYPE, fmi2FreeInstance);
    const fmi2CallbackFunctions callbacks = {NULL, calloc, free, NULL, NULL};
    fmi2Component one = fmi2Instantiate("one", fmi2CoSimulation, as->token, as->resources, &callbacks, fmi2False, fmi2False);
    require(one == NULL, "instance");
    require(fmi2SetupExperiment(one, fmi2False, 0.0, 0.0, fmi2True, as->stop), "setup");
    require(fmi2EnterInitializationMode(one), "initialization");
    require(fmi2ExitInitializationMode(one), "end of initialization");
    for (int i = 0; i < steps; ++i) {
        const double t = as->stop * i / STEPS;
        require(fmi2DoStep(one, t, as->stop * (i + 1) / STEPS - t, fmi2True), "step");
    }
    require(fmi2GetReal(one, as->references, (size_t)as->count, values), "values");
    require(fmi2Terminate(one), "end");
    fmi2FreeInstance(one);
}

static void live3(const course *as, int steps, double *values)
{
    GET(fmi3InstantiateCoSimulationTYPE, fmi3InstantiateCoSimulation);
    GET(fmi3EnterInitializationModeTYPE, fmi3EnterInitializationMode);
    GET(fmi3ExitInitializationModeTYPE, fmi3ExitInitializationMode);
    GET(fmi3GetFloat64TYPE, fmi3GetFloat64);
    GET(fmi3DoStepTYPE, fmi3DoStep);
    GET(fmi3TerminateTYPE, fmi3Terminate);
    GET(fmi3FreeInstanceTYPE, fmi3FreeInstance);
    fmi3Instance one = fmi3InstantiateCoSimulation(
        "one", as->token, as->resources, fmi3False, fmi3False, fmi3False, fmi3False, NULL, 0, NULL, NULL, NULL);
    require(one == NULL, "instance");
    require(fmi3EnterInitializationMode(one, fmi3False, 0.0, 0.0, fmi3True, as->stop), "initialization");
    require(fmi3ExitInitializationMode(one), "end of initialization");
    for (int i = 0; i < steps; ++i) {
        const double t = as->stop * i / STEPS;
        bool event, end, early;
        double reached;
        require(fmi3DoStep(one, t, as->stop * (i + 1) / STEPS - t, fmi3True, &event, &end, &early, &reached), "step");
    }
    require(fmi3GetFloat64(one, as->references, (size_t)as->count, values, (size_t)as->count), "values");
    require(fmi3Terminate(one), "end");
    fmi3FreeInstance(one);
}

static void *run(void *of)
{
    life *one = of;
    (one->as->version == 2 ? live2 : live3)(one->as, one->steps, one->values);
    return NULL;
}

static size_t held(void)
{
    return mallinfo2().uordblks;
}

static int strangers(const course *as)
{
    pthread_t thread[THREADS];
    life alone = {as, STEPS, {0}};
    life together[THREADS];
    int count = 0;
    (void)run(&alone);
    for (int i = 0; i < THREADS; ++i) {
        together[i] = (life){as, STEPS, {0}};
        require(pthread_create(&thread[i], NULL, run, &together[i]), "thread");
    }
    for (int i = 0; i < THREADS; ++i) {
        require(pthread_join(thread[i], NULL), "thread");
        count += memcmp(alone.values, together[i].values, sizeof alone.values) != 0;
    }
    return count;
}

int main(int argc, char **argv)
{
    if (argc < 8 || argc - 7 > MOST) {
        return 1;
    }
    course as = {dlopen(argv[1], RTLD_NOW | RTLD_LOCAL), atoi(argv[2]), argc - 7, argv[3], argv[4], atof(argv[5]), {0}};
    require(as.library == NULL, "library");
    for (int i = 0; i < as.count; ++i) {
        as.references[i] = (unsigned int)strtoul(argv[7 + i], NULL, 10);
    }
    size_t early = 0;
    for (int i = 0; i < atoi(argv[6]); ++i) {
        life one = {&as, 1, {0}};
        (void)run(&one);
        early = i == WARM ? held() : early;
    }
    const size_t late = held();
    (void)printf("%zu %zu %d\n", early, late, strangers(&as));
    return 0;
}
