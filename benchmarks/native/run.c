/*
 * A motion by the C runtime: run LIBRARY MODEL METHOD TOLERANCE STOP REPEATS ROWS [X...]
 *
 * METHOD: auto, dop853, radau. Prints status, right-hand sides, Jacobians, steps, least seconds of one run, then the states at so many
 * equidistant times, the last one at the end.
 */
#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "lag/run.h"

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

int main(int count, char **word)
{
    if (count < 8) {
        return 2;
    }
    void *library = dlopen(word[1], RTLD_NOW | RTLD_LOCAL);
    const lag_model *model = library == NULL ? NULL : dlsym(library, word[2]);
    if (model == NULL) {
        (void)fprintf(stderr, "%s\n", dlerror());
        return 1;
    }
    size_t (*size)(const lag_model *, const lag_run_options *) = dlsym(library, "lag_run_size");
    lag_run *(*place)(void *, const lag_model *, const lag_run_options *) = dlsym(library, "lag_run_place");
    lag_status (*begin)(lag_run *, double, const double *) = dlsym(library, "lag_run_begin");
    lag_status (*to)(lag_run *, double, size_t) = dlsym(library, "lag_run_to");
    void (*tell)(const lag_run *, lag_run_report *) = dlsym(library, "lag_run_tell");
    char name[64] = "lag_";
    lag_run_options options;
    memset(&options, 0, sizeof options);
    options.tolerance = atof(word[4]);
    options.method = strcmp(word[3], "auto") == 0 ? NULL : dlsym(library, strncat(name, word[3], 32));
    const double stop = atof(word[5]);
    const int repeats = atoi(word[6]);
    const size_t rows = (size_t)atoi(word[7]);
    const size_t size_of_state = 2 * model->nq + model->nz;
    double *times = malloc(rows * sizeof *times);
    options.rows = malloc(rows * size_of_state * sizeof *options.rows);
    options.times = times;
    options.count = rows;
    for (size_t k = 0; k < rows; ++k) {
        times[k] = k + 1 == rows ? stop : stop * (double)(k + 1) / (double)rows;
    }
    double *start = NULL;
    if (count > 8) {
        start = malloc((size_t)(count - 8) * sizeof *start);
        for (int i = 8; i < count; ++i) {
            start[i - 8] = atof(word[i]);
        }
    }
    void *block = malloc(size(model, &options));
    lag_run_report report;
    lag_status status = LAG_OK;
    double least = 1e300;
    for (int i = 0; i < repeats && status == LAG_OK; ++i) {
        const double from = now();
        lag_run *run = place(block, model, &options);
        status = begin(run, 0.0, start);
        status = status == LAG_OK ? to(run, stop, 0) : status;
        const double took = now() - from;
        least = took < least ? took : least;
        tell(run, &report);
    }
    (void)printf("%d %zu %zu %zu %.17g", (int)status, report.counts.evaluations, report.counts.jacobians, report.counts.steps, least);
    for (size_t i = 0; i < rows * size_of_state; ++i) {
        (void)printf(" %.17g", options.rows[i]);
    }
    (void)printf("\n");
    free(block);
    free(times);
    free(options.rows);
    free(start);
    return 0;
}
