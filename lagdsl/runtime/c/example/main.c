/*
 * Without arguments: the accelerations of the model at its start values. With a stop time, an interval and, if you like, a
 * tolerance: its motion, as CSV.
 */
#include <stdio.h>
#include <stdlib.h>

#include "lag/run.h"

static void print_names(const lag_model *model)
{
    (void)printf("time");
    for (size_t i = 0; i < model->nq; ++i) {
        (void)printf(",%s", model->coordinates[i].name);
    }
    for (size_t i = 0; i < model->nq; ++i) {
        (void)printf(",der(%s)", model->coordinates[i].name);
    }
    for (size_t i = 0; i < model->nz; ++i) {
        (void)printf(",%s", model->states[i].name);
    }
    (void)printf("\n");
}

static lag_status print_row(void *context, lag_run *run, double t, const double *x)
{
    (void)context;
    (void)printf("%.17g", t);
    for (size_t i = 0; i < lag_motion_size(run->motion.model); ++i) {
        (void)printf(",%.17g", x[i]);
    }
    (void)printf("\n");
    return LAG_OK;
}

static lag_status print_accelerations(lag_run *run)
{
    const lag_model *model = run->motion.model;
    lag_status status = lag_run_begin(run, 0.0, NULL);
    if (status == LAG_OK) {
        status = lag_motion_solve(&run->motion, 0.0, run->stepper.x);
    }
    for (size_t i = 0; i < model->nq && status == LAG_OK; ++i) {
        const lag_slot *slot = &model->coordinates[i];
        (void)printf("der(der(%s)) = %.17g (%s)/s2\n", slot->name, run->motion.qdd[i], slot->unit);
    }
    return status;
}

static lag_status print_motion(lag_run *run, double stop)
{
    print_names(run->motion.model);
    const lag_status status = lag_run_begin(run, 0.0, NULL);
    return status == LAG_OK ? lag_run_to(run, stop, 0) : status;
}

static void explain(const lag_run *run, lag_status status)
{
    const char *name = status == LAG_SINGULAR ? run->motion.model->coordinates[run->motion.coordinate].name : "the motion";
    (void)fprintf(stderr, "t = %g: %s cannot go on (status %d)\n", run->stepper.t, name, (int)status);
}

int main(int argc, char **argv)
{
    const lag_model *model = &MODEL;
    const double stop = argc > 2 ? strtod(argv[1], NULL) : 0.0;
    const double interval = argc > 2 ? strtod(argv[2], NULL) : 1.0;
    const size_t count = stop >= 0.0 && interval > 0.0 ? (size_t)(stop / interval * (1.0 + 1e-12)) + 1 : 1;
    double *times = malloc(count * sizeof(double));
    for (size_t i = 0; i < count && times != NULL; ++i) {
        times[i] = (double)i * interval;
    }
    lag_run_options options = {.output = print_row, .times = times, .count = argc > 2 ? count : 0};
    options.tolerance = argc > 3 ? strtod(argv[3], NULL) : 1e-10;
    void *block = malloc(lag_run_size(model, &options));
    if (times == NULL || block == NULL) {
        return EXIT_FAILURE;
    }
    lag_run *run = lag_run_place(block, model, &options);
    const lag_status status = argc > 2 ? print_motion(run, times[count - 1]) : print_accelerations(run);
    if (status != LAG_OK) {
        explain(run, status);
    }
    free(block);
    free(times);
    return status == LAG_OK ? EXIT_SUCCESS : EXIT_FAILURE;
}
