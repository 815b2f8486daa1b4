/*
 * Columns beside a run: of the spring q = q0 cos t + v0 sin t of spring.h by its start values, on rows inside of steps and at their ends. Tests
 * sensitivities.c, sensitivity_steps.c, sensitivity_rates.c, sensitivity_start.c, differences.c and, where they stand by their names, run_sensitivities.c.
 */
#include <string.h>

#include "check.h"
#include "lag/run.h"
#include "lag/sensitivities/run_sensitivities.h"
#include "lag/sensitivities/sensitivities.h"
#include "spring.h"

enum { ROWS = 41, SIZE = 3, COLUMNS = 2, WIDTH = 9 };

static lag_status keep_all(void *context, lag_results *results)
{
    (void)context;
    return results->row < ROWS ? LAG_OK : LAG_TOO_LONG;
}

static void columns_are_those_of_the_closed_form(const lag_method *method, double tolerance)
{
    static double rows[ROWS][WIDTH];
    static double derivatives[ROWS][COLUMNS][SIZE + 2];
    const double start[COLUMNS][SIZE] = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}};
    const double sizes[SIZE] = {1.0, 1.0, 1.0};
    const double nothing[1] = {0.0};
    const lag_sensitivity_directions of = {COLUMNS, nothing, nothing, start[0]};
    const lag_sensitivity_rows to = {derivatives[0][0], (double[COLUMNS]){0.0}};
    const lag_along along[3] = {{0}, {0}};
    double times[ROWS];
    lag_note note;
    lag_results results = {.most_rows = ROWS, .most_notes = 1, .rows = rows[0], .notes = &note, .full = keep_all};
    for (int i = 0; i < ROWS; ++i) {
        times[i] = 0.25 * i;
    }
    const lag_run_options options = {.tolerance = tolerance, .method = method, .count = ROWS, .times = times, .results = &results,
        .sizes = {.group = sizes, .natural = sizes, .cap = sizes}};
    lag_run *run = lag_run_place(malloc(lag_run_size(&SPRING, &options)), &SPRING, &options);
    lag_sensitivities *s = lag_sensitivities_place(calloc(1, lag_sensitivities_size(&SPRING, COLUMNS)), &SPRING, &of, &to, along);
    double x[SIZE];
    CHECK(lag_sensitivities_width(&SPRING) == SIZE + 2);
    CHECK(lag_run_start(run, 0.0, x) == LAG_OK);
    CHECK(lag_sensitivities_start(s, run, 0.0, NULL, NULL) == LAG_OK);
    run->options.results->companion = &s->companion;
    CHECK(lag_run_begin(run, 0.0, x) == LAG_OK);
    CHECK(lag_run_to(run, 10.0, 0) == LAG_OK);
    CHECK(results.row == ROWS);
    for (int i = 0; i < ROWS; ++i) {
        const double t = times[i];
        const double exact[COLUMNS][2] = {{cos(t), -sin(t)}, {sin(t), cos(t)}};
        for (int k = 0; k < COLUMNS; ++k) {
            CHECK_NEAR(derivatives[i][k][0], exact[k][0], 30.0 * tolerance);
            CHECK_NEAR(derivatives[i][k][1], exact[k][1], 30.0 * tolerance);
            CHECK_NEAR(derivatives[i][k][SIZE], exact[k][0], 30.0 * tolerance); /* the output is q */
        }
    }
    free(s);
    free(run);
}

static lag_run_sensitivities *place(size_t count, const char *const *by)
{
    return lag_run_sensitivities_place(calloc(1, lag_run_sensitivities_size(&SPRING, count)), &SPRING, count, by, NULL);
}

/* A row inside of a step: derivatives of what is told are those of the closed form. */
static lag_status check_row(void *context, lag_run *run, double t, const double *x)
{
    double derivatives[3][SIZE + 2];
    CHECK(lag_run_sensitivities_get(*(lag_run_sensitivities **)context, run, t, x, derivatives[0]) == LAG_OK);
    CHECK_NEAR(derivatives[0][0], cos(t), 1e-8);
    CHECK_NEAR(derivatives[1][0], sin(t), 1e-8);
    CHECK_NEAR(derivatives[2][2], 1.0, 1e-8);
    CHECK_NEAR(derivatives[2][0], 0.0, 1e-8);
    return LAG_OK;
}

static void quantities_stand_by_their_names(void)
{
    static const char *const by[3] = {"x.start", "der(x).start", "turned.start"};
    const double times[3] = {0.1, 2.0, 4.5};
    const unsigned char set[SIZE] = {1, 0, 0};
    const double values[SIZE] = {2.0, 0.0, 0.0};
    double derivatives[3][SIZE + 2];
    lag_run_sensitivities *s = place(3, by);
    const lag_run_options options = {.tolerance = 1e-10, .count = 3, .times = times, .callbacks = {.output = check_row, .context = &s}};
    lag_run *run = lag_run_place(malloc(lag_run_size(&SPRING, &options)), &SPRING, &options);
    CHECK(lag_run_sensitivities_begin(s, run, 0.0, set, values) == LAG_OK);
    CHECK(lag_run_to(run, 5.0, 0) == LAG_OK);
    CHECK_NEAR(run->stepper.x[0], 2.0 * cos(5.0), 1e-8);
    CHECK(lag_run_sensitivities_get(s, run, 5.0, run->stepper.x, derivatives[0]) == LAG_OK);
    CHECK_NEAR(derivatives[0][1], -sin(5.0), 1e-8);
    CHECK_NEAR(derivatives[1][1], cos(5.0), 1e-8);
    CHECK_NEAR(derivatives[1][SIZE], sin(5.0), 1e-8);
    free(run);
    free(s);
}

static void other_names_have_no_direction(void)
{
    static const char *const strangers[] = {"x", "start", ".start", "y.start", "der(x.start", "der(y).start", "der().start", "x.starts"};
    for (size_t i = 0; i < sizeof strangers / sizeof *strangers; ++i) {
        void *block = calloc(1, lag_run_sensitivities_size(&SPRING, 1));
        CHECK(lag_run_sensitivities_place(block, &SPRING, 1, &strangers[i], NULL) == NULL);
        free(block);
    }
}

int main(void)
{
    quantities_stand_by_their_names();
    other_names_have_no_direction();
    columns_are_those_of_the_closed_form(&lag_dop853, 1e-4);
    columns_are_those_of_the_closed_form(&lag_dop853, 1e-10);
    columns_are_those_of_the_closed_form(&lag_radau, 1e-6);
    (void)printf("sensitivities: ok\n");
    return EXIT_SUCCESS;
}
