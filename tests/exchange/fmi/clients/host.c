/*
 * Loads the library of an FMU and prints a co-simulation, exactly: host LIBRARY VERSION TOKEN RESOURCES STOP COUNT REFERENCE ...
 * Compiled for each platform whose binary is tried; nothing but the standard's headers.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifdef _WIN32
#include <windows.h>
static void *library(const char *path) { return (void *)LoadLibraryA(path); }
static void *function(void *from, const char *name) { return (void *)(size_t)GetProcAddress((HMODULE)from, name); }
#else
#include <dlfcn.h>
static void *library(const char *path)
{
    void *found = dlopen(path, RTLD_NOW | RTLD_LOCAL);
    if (found == NULL) fprintf(stderr, "%s\n", dlerror());
    return found;
}
static void *function(void *from, const char *name) { return dlsym(from, name); }
#endif

#include "fmi2Functions.h"
#include "fmi3Functions.h"

#define MOST 64

typedef struct course {
    const char *token, *resources;
    double stop;
    int steps, count;
    unsigned int references[MOST];
} course;

static void *needed(void *from, const char *name)
{
    void *found = function(from, name);
    if (found == NULL) {
        fprintf(stderr, "no %s\n", name);
        exit(2);
    }
    return found;
}

static void require(int status, const char *what)
{
    if (status != 0) {
        fprintf(stderr, "%s: status %d\n", what, status);
        exit(3);
    }
}

static void print(double t, const double *values, int count)
{
    printf("%a", t);
    for (int i = 0; i < count; i++) printf(" %a", values[i]);
    printf("\n");
}

static void tell2(fmi2ComponentEnvironment c, fmi2String name, fmi2Status status, fmi2String category, fmi2String text, ...)
{
    (void)c;
    fprintf(stderr, "%s %d %s: %s\n", name, (int)status, category, text);
}

static void tell3(fmi3InstanceEnvironment c, fmi3Status status, fmi3String category, fmi3String text)
{
    (void)c;
    fprintf(stderr, "%d %s: %s\n", (int)status, category, text);
}

#define GET(type, name) type *name = (type *)(size_t)needed(from, #name)

static void run2(void *from, const course *as)
{
    GET(fmi2InstantiateTYPE, fmi2Instantiate);
    GET(fmi2SetupExperimentTYPE, fmi2SetupExperiment);
    GET(fmi2EnterInitializationModeTYPE, fmi2EnterInitializationMode);
    GET(fmi2ExitInitializationModeTYPE, fmi2ExitInitializationMode);
    GET(fmi2GetRealTYPE, fmi2GetReal);
    GET(fmi2DoStepTYPE, fmi2DoStep);
    GET(fmi2TerminateTYPE, fmi2Terminate);
    GET(fmi2FreeInstanceTYPE, fmi2FreeInstance);
    fmi2CallbackFunctions callbacks = {tell2, calloc, free, NULL, NULL};
    fmi2Component one = fmi2Instantiate("one", fmi2CoSimulation, as->token, as->resources, &callbacks, fmi2False, fmi2False);
    if (one == NULL) exit(4);
    require(fmi2SetupExperiment(one, fmi2True, 1e-10, 0.0, fmi2True, as->stop), "setup");
    require(fmi2EnterInitializationMode(one), "initialization");
    require(fmi2ExitInitializationMode(one), "end of initialization");
    double values[MOST];
    for (int i = 0;; i++) {
        double t = as->stop * i / as->steps, next = as->stop * (i + 1) / as->steps;
        require(fmi2GetReal(one, as->references, (size_t)as->count, values), "values");
        print(t, values, as->count);
        if (i == as->steps) break;
        require(fmi2DoStep(one, t, next - t, fmi2True), "step");
    }
    require(fmi2Terminate(one), "end");
    fmi2FreeInstance(one);
}

static void run3(void *from, const course *as)
{
    GET(fmi3InstantiateCoSimulationTYPE, fmi3InstantiateCoSimulation);
    GET(fmi3EnterInitializationModeTYPE, fmi3EnterInitializationMode);
    GET(fmi3ExitInitializationModeTYPE, fmi3ExitInitializationMode);
    GET(fmi3GetFloat64TYPE, fmi3GetFloat64);
    GET(fmi3DoStepTYPE, fmi3DoStep);
    GET(fmi3TerminateTYPE, fmi3Terminate);
    GET(fmi3FreeInstanceTYPE, fmi3FreeInstance);
    fmi3Instance one = fmi3InstantiateCoSimulation(
        "one", as->token, as->resources, fmi3False, fmi3False, fmi3False, fmi3False, NULL, 0, NULL, tell3, NULL);
    if (one == NULL) exit(4);
    require(fmi3EnterInitializationMode(one, fmi3True, 1e-10, 0.0, fmi3True, as->stop), "initialization");
    require(fmi3ExitInitializationMode(one), "end of initialization");
    double values[MOST];
    for (int i = 0;; i++) {
        double t = as->stop * i / as->steps, next = as->stop * (i + 1) / as->steps, reached;
        bool event, end, early;
        require(fmi3GetFloat64(one, as->references, (size_t)as->count, values, (size_t)as->count), "values");
        print(t, values, as->count);
        if (i == as->steps) break;
        require(fmi3DoStep(one, t, next - t, fmi3True, &event, &end, &early, &reached), "step");
        require(early, "early return");
    }
    require(fmi3Terminate(one), "end");
    fmi3FreeInstance(one);
}

int main(int argc, char **argv)
{
    if (argc < 8 || argc - 7 > MOST) return 1;
    course as = {argv[3], argv[4], atof(argv[5]), atoi(argv[6]), argc - 7, {0}};
    for (int i = 0; i < as.count; i++) as.references[i] = (unsigned int)strtoul(argv[7 + i], NULL, 10);
    void *from = library(argv[1]);
    if (from == NULL) return 5;
    if (strcmp(argv[2], "2") == 0) run2(from, &as);
    else run3(from, &as);
    return 0;
}
