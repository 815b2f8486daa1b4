/* Rows of a run and the lowest and highest values of its motion, against q = cos t. */
#include <string.h>

#include "check.h"
#include "lag/run/extremes.h"
#include "lag/run.h"
#include "lag/serialization.h"
#include "spring.h"

enum { ROWS = 41, ROOM = 7, WIDTH = 9, COUNT = 5, SIZE = 3 };

/* The file that the buffers are emptied to. */
typedef struct shelf {
    size_t rows, calls;
    double row[ROWS][WIDTH];
    lag_status answer;
} shelf;

static lag_status put_away(void *context, lag_results *results)
{
    shelf *own = context;
    CHECK(own->rows + results->row <= ROWS);
    memcpy(own->row[own->rows], results->rows, results->row * sizeof own->row[0]);
    own->rows += results->row;
    ++own->calls;
    return own->answer;
}

static lag_run *place(const lag_run_options *options)
{
    void *block = malloc(lag_run_size(&SPRING, options));
    CHECK(block != NULL);
    return lag_run_place(block, &SPRING, options);
}

/* Every column of every row, though there is room for few of them at a time. */
static void rows_are_those_of_the_motion(void)
{
    shelf own = {.answer = LAG_OK};
    double times[ROWS];
    double room[ROOM][WIDTH];
    lag_note notes[1];
    lag_results results = {
        .most_rows = ROOM, .most_notes = 1, .rows = room[0], .notes = notes, .full = put_away, .context = &own};
    for (int i = 0; i < ROWS; ++i) {
        times[i] = 0.25 * i;
    }
    const lag_run_options options = {.tolerance = 1e-10, .count = ROWS, .times = times, .results = &results};
    lag_run *run = place(&options);
    CHECK(lag_results_width(&SPRING) == WIDTH);
    CHECK(lag_run_begin(run, 0.0, NULL) == LAG_OK);
    CHECK(lag_run_to(run, 10.0, 0) == LAG_OK);
    CHECK(own.calls == (ROWS - 1) / ROOM);
    CHECK(put_away(&own, &results) == LAG_OK);
    CHECK(own.rows == ROWS);
    for (int i = 0; i < ROWS; ++i) {
        const double *row = own.row[i];
        const double t = times[i];
        const double exact[WIDTH] = {t, cos(t), -sin(t), 3.0 * t, cos(t), 3.0 * t, 0.5, 0.0, 0.0};
        CHECK(row[0] == t);
        for (int k = 1; k < WIDTH; ++k) {
            CHECK_NEAR(row[k], exact[k], 1e-7);
        }
    }
    free(run);
}

/* Nobody takes the rows: that ends the run with what is said of it. */
static void full_buffers_end_the_run(void)
{
    shelf own = {.answer = LAG_STOPPED};
    double times[ROWS];
    double room[ROOM][WIDTH];
    lag_note notes[1];
    lag_results results = {
        .most_rows = ROOM, .most_notes = 1, .rows = room[0], .notes = notes, .full = put_away, .context = &own};
    for (int i = 0; i < ROWS; ++i) {
        times[i] = 0.25 * i;
    }
    const lag_run_options options = {.count = ROWS, .times = times, .results = &results};
    lag_run *run = place(&options);
    CHECK(lag_run_begin(run, 0.0, NULL) == LAG_OK);
    CHECK(lag_run_to(run, 10.0, 0) == LAG_STOPPED);
    CHECK(own.rows == ROOM && results.row == 0);
    free(run);
}

/* The amplitude is found though no row and no step hits it; every half turn is counted. */
static void extremes_are_those_of_the_motion(const lag_method *method)
{
    shelf own = {.answer = LAG_OK};
    const double times[2] = {0.3, 20.3};
    double room[2][WIDTH];
    lag_note notes[1];
    const double start[SIZE] = {cos(0.3), -sin(0.3), 0.0};
    lag_extremes extremes;
    double *memory = malloc(lag_extremes_memory(&SPRING) * sizeof(double));
    CHECK(memory != NULL);
    lag_extremes_place(&extremes, &SPRING, memory);
    CHECK(extremes.count == COUNT && extremes.size == SIZE);
    CHECK(extremes.low[0] > 0.0 && isinf(extremes.low[0]) && isinf(extremes.high[0])); /* nothing was seen */
    lag_results results = {
        .most_rows = 2, .most_notes = 1, .rows = room[0], .notes = notes, .full = put_away, .context = &own,
        .extremes = &extremes};
    const lag_run_options options = {.method = method, .tolerance = 1e-8, .count = 2, .times = times, .results = &results};
    lag_run *run = place(&options);
    CHECK(lag_run_begin(run, 0.3, start) == LAG_OK);
    CHECK(lag_run_to(run, 20.3, 0) == LAG_OK);
    (void)printf("%s: extremes off by %.1e, %zu steps\n", run->stepper.method->name,
        fmax(fabs(extremes.low[0] + 1.0), fabs(extremes.high[0] - 1.0)), run->stepper.counts.steps);
    for (int i = 0; i < 2; ++i) {
        CHECK_NEAR(extremes.low[i], -1.0, 1e-6);
        CHECK_NEAR(extremes.high[i], 1.0, 1e-6);
    }
    CHECK(extremes.low[2] == 0.0);
    CHECK_NEAR(extremes.high[2], 60.0, 1e-5);
    CHECK_NEAR(extremes.low[3], -1.0, 1e-6); /* the outputs: q, and the angle, whole turns of which are not counted */
    CHECK_NEAR(extremes.high[3], 1.0, 1e-6);
    CHECK(extremes.turns[0] == 6.0); /* at pi, 2 pi, ..., 6 pi */
    CHECK(extremes.turns[1] == 6.0); /* at pi / 2, 3 pi / 2, ..., 11 pi / 2 */
    CHECK(extremes.turns[2] == 0.0);
    free(run);
    free(memory);
}

static void extremes_take_values_that_are_numbers(void)
{
    lag_extremes extremes;
    double *memory = malloc(lag_extremes_memory(&SPRING) * sizeof(double));
    const double rows[3][COUNT] = {{1.0, -2.0, (double)NAN, 4.0, 5.0}, {-1.0, (double)NAN, 3.0, 0.0, 6.0}, {0.0, 0.0, 1.0, 2.0, 5.5}};
    CHECK(memory != NULL);
    lag_extremes_place(&extremes, &SPRING, memory);
    for (int k = 0; k < 3; ++k) {
        lag_extremes_row(&extremes, rows[k]);
    }
    const double low[COUNT] = {-1.0, -2.0, 1.0, 0.0, 5.0};
    const double high[COUNT] = {1.0, 0.0, 3.0, 4.0, 6.0};
    for (int i = 0; i < COUNT; ++i) {
        CHECK(extremes.low[i] == low[i] && extremes.high[i] == high[i]);
    }
    free(memory);
}

/* Turns are counted without rows, and by a run that goes on from saved bytes. */
static void turns_are_counted_and_saved(void)
{
    const lag_run_options options = {.tolerance = 1e-10};
    double outputs[2];
    lag_run *run = place(&options);
    lag_run *other = place(&options);
    unsigned char *bytes = malloc(lag_run_saved_size(&SPRING, &options));
    CHECK(bytes != NULL);
    CHECK(lag_run_begin(run, 0.0, NULL) == LAG_OK);
    CHECK(lag_run_to(run, 5.0, 0) == LAG_OK);
    lag_run_save(run, bytes);
    CHECK(lag_run_begin(other, 0.0, NULL) == LAG_OK);
    CHECK(lag_run_load(other, bytes) == LAG_OK);
    CHECK(lag_run_to(other, 10.0, 0) == LAG_OK);
    lag_motion_set_state(&other->motion, 10.0, other->stepper.x);
    CHECK(SPRING.output(&other->motion.at, outputs) == LAG_OK);
    lag_run_unwind(other, outputs);
    CHECK_NEAR(outputs[1], 30.0, 1e-7);
    free(bytes);
    free(other);
    free(run);
}

int main(void)
{
    turns_are_counted_and_saved();
    rows_are_those_of_the_motion();
    full_buffers_end_the_run();
    extremes_are_those_of_the_motion(&lag_dop853);
    extremes_are_those_of_the_motion(&lag_radau);
    extremes_take_values_that_are_numbers();
    (void)printf("results: ok\n");
    return EXIT_SUCCESS;
}
