/*
 * A loop for real time: steps of fixed length and bounded cost, one after the other as fast as the machine can, and how long the
 * longest took. Arguments: a stop time, the length of a step and, if you like, one of rk4, leapfrog and ros2.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "lag/fixed.h"
#include "lag/event_notice.h"
#include "lag/run.h"

/* Durations of steps [s]: of steps without events, of steps with events. */
typedef struct record {
    size_t steps, late;
    double sum, longest;
} record;

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

static lag_status count_events(void *context, lag_run *run, const lag_event_notice *what)
{
    size_t *events = context;
    (void)run;
    *events += what->what == LAG_BEFORE;
    return LAG_OK;
}

static void add(record *to, double took, double h)
{
    ++to->steps;
    to->late += took > h;
    to->sum += took;
    to->longest = took > to->longest ? took : to->longest;
}

static void print(const record *of, const char *which, double h)
{
    if (of->steps > 0) {
        (void)printf("%zu steps of %g s%s: mean %.3g us, longest %.3g us, %zu longer than the step itself\n", of->steps, h, which,
            1e6 * of->sum / (double)of->steps, 1e6 * of->longest, of->late);
    }
}

int main(int argc, char **argv)
{
    const lag_model *model = &MODEL;
    const double length = argc > 2 ? strtod(argv[1], NULL) - START.t : 1.0;
    const double h = argc > 2 ? strtod(argv[2], NULL) : 1e-3;
    lag_fixed_step *const step = method(argc > 3 ? argv[3] : "rk4");
    size_t events = 0;
    const lag_run_options options = {.callbacks = {.tell = count_events, .context = &events}};
    /* All memory there is: after this nothing is allocated. */
    void *block = malloc(lag_run_size(model, &options));
    double *memory = malloc((lag_fixed_memory(lag_motion_size(model)) + 1) * sizeof(double));
    if (block == NULL || memory == NULL || !(h > 0.0)) {
        return EXIT_FAILURE;
    }
    lag_run *run = lag_run_place(block, model, &options);
    lag_status status = lag_run_begin(run, START.t, START.x);
    record quiet = {0};
    record eventful = {0};
    for (size_t i = 1; status == LAG_OK && (double)i * h <= length * (1.0 + 1e-12); ++i) {
        const size_t so_far = events;
        const double before = now();
        status = lag_run_fixed(run, h, step, memory); /* a controller would set run->motion.u here */
        add(events > so_far ? &eventful : &quiet, now() - before, h);
    }
    print(&quiet, "", h);
    print(&eventful, " with events", h);
    for (size_t i = 0; i < model->nq && (status == LAG_OK || status == LAG_STOPPED); ++i) {
        (void)printf("%s = %.9g %s\n", model->coordinates[i].name, run->stepper.x[i], model->coordinates[i].unit);
    }
    free(block);
    free(memory);
    return status == LAG_OK || status == LAG_STOPPED ? EXIT_SUCCESS : EXIT_FAILURE;
}
