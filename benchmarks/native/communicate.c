/*
 * Communication steps of an FMU, as a program in C makes them: communicate LIBRARY TOKEN STOP REPEATS STEPS...
 *
 * Prints the least seconds of so many runs for each number of steps.
 */
#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "fmi2Functions.h"

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void say(fmi2ComponentEnvironment where, fmi2String name, fmi2Status status, fmi2String category, fmi2String text, ...)
{
    (void)where;
    (void)fprintf(stderr, "%s %d %s: %s\n", name, (int)status, category, text);
}

/* Seconds of the steps alone; negative where a call failed. */
static double run(void *library, fmi2Component one, double stop, long steps)
{
    fmi2ResetTYPE *reset = dlsym(library, "fmi2Reset");
    fmi2SetupExperimentTYPE *setup = dlsym(library, "fmi2SetupExperiment");
    fmi2EnterInitializationModeTYPE *enter = dlsym(library, "fmi2EnterInitializationMode");
    fmi2ExitInitializationModeTYPE *leave = dlsym(library, "fmi2ExitInitializationMode");
    fmi2DoStepTYPE *step = dlsym(library, "fmi2DoStep");
    int failed = reset(one) | setup(one, fmi2True, 1e-8, 0.0, fmi2True, stop) | enter(one) | leave(one);
    const double begun = now();
    for (long k = 0; k < steps && !failed; ++k) {
        const double t = stop * (double)k / (double)steps;
        failed = step(one, t, stop * (double)(k + 1) / (double)steps - t, fmi2True);
    }
    return failed ? -1.0 : now() - begun;
}

int main(int count, char **word)
{
    if (count < 6) {
        return 2;
    }
    void *library = dlopen(word[1], RTLD_NOW | RTLD_LOCAL);
    if (library == NULL) {
        (void)fprintf(stderr, "%s\n", dlerror());
        return 1;
    }
    fmi2InstantiateTYPE *instantiate = dlsym(library, "fmi2Instantiate");
    const fmi2CallbackFunctions callbacks = {say, calloc, free, NULL, NULL};
    fmi2Component one = instantiate("one", fmi2CoSimulation, word[2], "", &callbacks, fmi2False, fmi2False);
    const double stop = atof(word[3]);
    for (int i = 5; i < count && one != NULL; ++i) {
        double least = 1e9;
        for (int repeat = 0; repeat < atoi(word[4]); ++repeat) {
            const double seconds = run(library, one, stop, atol(word[i]));
            if (seconds < 0.0) {
                return 1;
            }
            least = seconds < least ? seconds : least;
        }
        (void)printf("%.9g\n", least);
    }
    return one == NULL;
}
