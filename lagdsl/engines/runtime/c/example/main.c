/*
 * Without arguments: the accelerations of the model at its start values. With a stop time and an interval: its motion, as
 * CSV, with two rows at each event, before and after. Events go to the error output as CSV, or to the file that a fourth
 * argument names. The third is the tolerance.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "lag/event_notice.h"
#include "lag/run.h"

/* Files of the rows and events, memory for the outputs, and the time of the last event. */
typedef struct tables {
    FILE *rows, *events;
    double *y;
    double event_time;
} tables;

static void print_name(FILE *file, const char *name)
{
    if (strpbrk(name, ",\"") == NULL) {
        (void)fputs(name, file);
        return;
    }
    (void)fputc('"', file);
    for (; *name != '\0'; ++name) {
        (void)fputs(*name == '"' ? "\"\"" : (char[2]){*name, '\0'}, file);
    }
    (void)fputc('"', file);
}

static void print_column(FILE *file, const char *before, const char *name, const char *after)
{
    char text[256];
    (void)snprintf(text, sizeof text, "%s%s%s", before, name, after);
    (void)fputc(',', file);
    print_name(file, text);
}

static int is_column(const lag_model *model, size_t i)
{
    return model->kinds[i] == LAG_KIND_VARIABLE;
}

static void print_header(FILE *file, const lag_model *model)
{
    (void)fputs("time", file);
    for (size_t i = 0; i < model->nq; ++i) {
        print_column(file, "", model->coordinates[i].name, "");
    }
    for (size_t i = 0; i < model->nq; ++i) {
        print_column(file, "der(", model->coordinates[i].name, ")");
    }
    for (size_t i = 0; i < model->nz; ++i) {
        print_column(file, "", model->states[i].name, "");
    }
    for (size_t i = 0; i < model->nw; ++i) {
        if (is_column(model, i)) {
            print_column(file, "", model->discretes[i].name, "");
        }
    }
    for (size_t i = 0; i < model->ny; ++i) {
        print_column(file, "", model->outputs[i].name, "");
    }
    (void)fputc('\n', file);
}

static lag_status print_row(const tables *to, lag_run *run, double t, const double *x)
{
    lag_motion *motion = &run->motion;
    const lag_model *model = motion->model;
    lag_status status = LAG_OK;
    (void)fprintf(to->rows, "%.17g", t);
    for (size_t i = 0; i < lag_motion_size(model); ++i) {
        (void)fprintf(to->rows, ",%.17g", x[i]);
    }
    for (size_t i = 0; i < model->nw; ++i) {
        if (is_column(model, i)) {
            (void)fprintf(to->rows, ",%.17g", motion->w[i]);
        }
    }
    if (model->ny > 0) {
        status = lag_run_count_turns(run, t, x);
    }
    if (model->ny > 0 && status == LAG_OK) {
        status = lag_motion_solve(motion, t, x);
    }
    if (model->ny > 0 && status == LAG_OK) {
        status = model->output(&motion->at, to->y);
    }
    if (status == LAG_OK) {
        lag_run_unwind(run, to->y);
    }
    for (size_t i = 0; i < model->ny; ++i) {
        (void)fprintf(to->rows, ",%.17g", to->y[i]);
    }
    (void)fputc('\n', to->rows);
    return status;
}

/* A row at a time that was asked for. */
static lag_status row(void *context, lag_run *run, double t, const double *x)
{
    const tables *to = context;
    return t == to->event_time ? LAG_OK : print_row(to, run, t, x); /* it is there already */
}

static lag_status tell(void *context, lag_run *run, const lag_event_notice *what)
{
    tables *to = context;
    if (what->what == LAG_BEFORE || what->what == LAG_AFTER) {
        to->event_time = what->t;
        return print_row(to, run, what->t, what->x);
    }
    (void)fprintf(to->events, "%.17g,%s,", what->t, lag_event_kind_name(what->what));
    print_name(to->events, lag_event_notice_name(run->motion.model, what));
    (void)fputc('\n', to->events);
    return LAG_OK;
}

static lag_status print_accelerations(lag_run *run)
{
    const lag_model *model = run->motion.model;
    lag_status status = lag_run_begin(run, START.t, START.x);
    if (status == LAG_OK) {
        status = lag_motion_solve(&run->motion, START.t, run->stepper.x);
    }
    for (size_t i = 0; i < model->nq && status == LAG_OK; ++i) {
        const lag_slot *slot = &model->coordinates[i];
        (void)printf("der(der(%s)) = %.17g (%s)/s2\n", slot->name, run->motion.qdd[i], slot->unit);
    }
    return status;
}

static lag_status print_motion(lag_run *run, const tables *to, double stop)
{
    print_header(to->rows, run->motion.model);
    if (run->motion.model->nw > 0) {
        (void)fputs("time,event,name\n", to->events);
    }
    lag_status status = lag_run_begin(run, START.t, START.x);
    if (status == LAG_OK) {
        status = lag_run_to(run, stop, 0);
    }
    return status == LAG_OK ? lag_run_end(run) : status;
}

static const char *reason(lag_status status)
{
    switch (status) {
    case LAG_SINGULAR:
        return "accelerations are not determined";
    case LAG_PROJECTION_FAILED:
        return "the constraints cannot be reached";
    case LAG_VIOLATED:
    case LAG_ASSERTION_FAILED:
        return "an assertion failed or an invariant left its tolerance";
    case LAG_CHATTER:
    case LAG_EVENT_ITERATION_FAILED:
        return "events follow each other without end";
    case LAG_CONFLICT:
        return "one quantity is reset to two values at once";
    case LAG_PENETRATION:
        return "a contact is pierced at the start";
    case LAG_POSITION_JUMP:
        return "a constraint that an event switches on does not hold at the positions there";
    case LAG_MOMENTUM_UNREACHABLE:
        return "no rates have the momentum or the energy that an event leaves";
    case LAG_WAY_JUMP:
        return "the position of a mass would jump";
    case LAG_NO_FORCES:
        return "no forces satisfy the law of friction";
    case LAG_BAD_CLOCK:
        return "a clock has no positive period";
    case LAG_BAD_DELAY:
        return "a delay is not positive";
    case LAG_LONG_PAST:
        return "the past of a delayed value has too many events";
    default:
        return "the motion cannot go on";
    }
}

/* Times, memory and files; then the run. Returns whether it came to an end that the model wants. */
static int simulate(const lag_model *model, lag_run_options *options, tables *to, double *times, double interval)
{
    const lag_clock clock = lag_clock_of(START.t, interval); /* 0.3, not 3 times what is nearly 0.1 */
    for (size_t i = 0; i < options->count; ++i) {
        times[i] = lag_clock_instant(&clock, i);
    }
    void *block = malloc(lag_run_size(model, options));
    if (block == NULL) {
        return 0;
    }
    lag_run *run = lag_run_place(block, model, options);
    const lag_status status = options->count > 0 ? print_motion(run, to, times[options->count - 1]) : print_accelerations(run);
    const int done = status == LAG_OK || status == LAG_STOPPED; /* by `terminate` */
    if (!done) {
        (void)fprintf(stderr, "t = %g s: %s (status %d)\n", run->stepper.t, reason(status), (int)status);
    }
    free(block);
    return done;
}

int main(int argc, char **argv)
{
    const lag_model *model = &MODEL;
    const double length = argc > 2 ? strtod(argv[1], NULL) - START.t : 0.0;
    const double interval = argc > 2 ? strtod(argv[2], NULL) : 1.0;
    const size_t count = length >= 0.0 && interval > 0.0 ? (size_t)(length / interval * (1.0 + 1e-12)) + 1 : 1;
    double *times = malloc(count * sizeof(double));
    tables to = {.rows = stdout, .events = argc > 4 ? fopen(argv[4], "w") : stderr, .event_time = START.t - 1.0};
    to.y = malloc((model->ny + 1) * sizeof(double));
    lag_run_options options = {.callbacks = {.output = row, .tell = tell, .context = &to}, .times = times, .start = &START};
    options.count = argc > 2 ? count : 0;
    options.tolerance = argc > 3 ? strtod(argv[3], NULL) : 1e-10;
    const int ready = times != NULL && to.y != NULL && to.events != NULL;
    const int done = ready && simulate(model, &options, &to, times, interval);
    if (argc > 4 && to.events != NULL) {
        (void)fclose(to.events);
    }
    free(to.y);
    free(times);
    return done ? EXIT_SUCCESS : EXIT_FAILURE;
}
