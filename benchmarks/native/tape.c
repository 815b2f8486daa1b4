/* Duration of one call in nanoseconds of CPU time: the mean of so many calls. */
#define _POSIX_C_SOURCE 199309L
#include <time.h>

#include "lag/parallel.h"

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return 1e9 * (double)t.tv_sec + (double)t.tv_nsec;
}

/* elimination() of one state; `results` (7) are arrays of its results. */
double time_elimination(const lag_model *model, const lag_arguments *at, double *const *r, int calls)
{
    const double start = now();
    for (int i = 0; i < calls; ++i) {
        model->elimination(at, r[0], r[1], r[2], r[3], r[4], r[5], r[6]);
    }
    return (now() - start) / calls;
}

/* The same of several states at once, for each of them. */
double time_lanes(const lag_states *states, const lag_arguments *at, double *const *r, int calls)
{
    const double start = now();
    for (int i = 0; i < calls; ++i) {
        states->elimination(at, r[0], r[1], r[2], r[3], r[4], r[5], r[6]);
    }
    return (now() - start) / calls / (double)states->lanes;
}

/* One multiplication and addition of doubles in memory, each of which waits for the one before. */
double time_chain(const void *unused, const void *neither, double *const *r, int calls)
{
    volatile double *x = r[0];
    const double start = now();
    (void)unused;
    (void)neither;
    *x = 1.0;
    for (int i = 0; i < calls; ++i) {
        *x = *x * 0.999 + 0.001;
    }
    return (now() - start) / calls;
}
