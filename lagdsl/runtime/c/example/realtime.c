/*
 * A loop for real time: steps of fixed length and bounded cost, one after the other as fast as the machine can, and how long the
 * longest took. Arguments: a stop time, the length of a step and, if you like, one of rk4, leapfrog and ros2.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "lag/fixed.h"
#include "lag/run.h"

static double now(void)
{
    struct timespec at;
    (void)timespec_get(&at, TIME_UTC);
    return (double)at.tv_sec + 1e-9 * (double)at.tv_nsec;
}

static lag_fixed_step *method(const char *name)
{
    return strcmp(name, "leapfrog") == 0 ? lag_leapfrog : strcmp(name, "ros2") == 0 ? lag_ros2 : lag_rk4;
}

int main(int argc, char **argv)
{
    const lag_model *model = &MODEL;
    const double stop = argc > 2 ? strtod(argv[1], NULL) : 1.0;
    const double h = argc > 2 ? strtod(argv[2], NULL) : 1e-3;
    lag_fixed_step *const step = method(argc > 3 ? argv[3] : "rk4");
    const lag_run_options options = {0};
    /* All memory there is: after this nothing is allocated. */
    void *block = malloc(lag_run_size(model, &options));
    double *memory = malloc((lag_fixed_memory(lag_motion_size(model)) + 1) * sizeof(double));
    if (block == NULL || memory == NULL || !(h > 0.0)) {
        return EXIT_FAILURE;
    }
    lag_run *run = lag_run_place(block, model, &options);
    lag_status status = lag_run_begin(run, 0.0, NULL);
    double longest = 0.0;
    const double start = now();
    size_t steps = 0;
    while (status == LAG_OK && (double)(steps + 1) * h <= stop * (1.0 + 1e-12)) {
        const double before = now();
        status = lag_run_fixed(run, h, step, memory); /* a controller would set run->motion.u here */
        const double took = now() - before;
        longest = took > longest ? took : longest;
        ++steps;
    }
    (void)printf("%zu steps of %g s: mean %.3g us, longest %.3g us\n", steps, h, 1e6 * (now() - start) / (double)(steps + !steps),
        1e6 * longest);
    for (size_t i = 0; i < model->nq && status == LAG_OK; ++i) {
        (void)printf("%s = %.9g %s\n", model->coordinates[i].name, run->stepper.x[i], model->coordinates[i].unit);
    }
    free(block);
    free(memory);
    return status == LAG_OK ? EXIT_SUCCESS : EXIT_FAILURE;
}
