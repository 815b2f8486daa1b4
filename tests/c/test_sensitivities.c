/*
 * Columns beside a run: of the spring q = q0 cos t + v0 sin t of spring.h by its start values, on rows inside of steps and at their ends. Tests
 * sensitivities.c, sensitivity_steps.c, sensitivity_rates.c, sensitivity_start.c and differences.c.
 */
#include <string.h>

#include "check.h"
#include "lag/run.h"
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

int main(void)
{
    columns_are_those_of_the_closed_form(&lag_dop853, 1e-4);
    columns_are_those_of_the_closed_form(&lag_dop853, 1e-10);
    columns_are_those_of_the_closed_form(&lag_radau, 1e-6);
    (void)printf("sensitivities: ok\n");
    return EXIT_SUCCESS;
}
