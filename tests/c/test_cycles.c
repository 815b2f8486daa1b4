/*
 * A thousand runs, or as many as the argument says, each created, run and destroyed, of equal results. The block has the
 * length that was asked for, so that the sanitizers and valgrind see what goes beyond it and what is not given back.
 */
#include <string.h>

#include "check.h"
#include "lag/fixed.h"
#include "lag/run.h"
#include "machine.h"

enum { ROWS = 5, SIZE = 5 };

static const double TIMES[ROWS] = {0.0, 0.025, 0.05, 0.075, 0.1};

static void one_cycle(const lag_method *method, double *end)
{
    double rows[ROWS * SIZE];
    const lag_run_options options = {.method = method, .tolerance = 1e-4, .count = ROWS, .times = TIMES, .rows = rows};
    lag_run *run = lag_run_place(malloc(lag_run_size(&MACHINE, &options)), &MACHINE, &options);
    CHECK(lag_run_begin(run, 0.0, NULL) == LAG_OK);
    CHECK(lag_run_to(run, 0.1, 0) == LAG_OK);
    CHECK(run->counts.row == ROWS);
    memcpy(end, rows + (ROWS - 1) * SIZE, SIZE * sizeof(double));
    free(run);
}

static void one_cycle_of_fixed_steps(double *end)
{
    const lag_run_options options = {0};
    double *memory = malloc(lag_fixed_memory(SIZE) * sizeof(double));
    lag_run *run = lag_run_place(malloc(lag_run_size(&MACHINE, &options)), &MACHINE, &options);
    CHECK(lag_run_begin(run, 0.0, NULL) == LAG_OK);
    for (int i = 0; i < 5; ++i) {
        CHECK(lag_run_fixed(run, 0.02, lag_ros2, memory) == LAG_OK);
    }
    CHECK(run->stepper.t == 0.1);
    memcpy(end, run->stepper.x, SIZE * sizeof(double));
    free(run);
    free(memory);
}

int main(int count, char **arguments)
{
    const int cycles = count > 1 ? atoi(arguments[1]) : 200;
    double first[3][SIZE];
    double end[SIZE];
    one_cycle(&lag_dop853, first[0]);
    one_cycle(&lag_radau, first[1]);
    one_cycle_of_fixed_steps(first[2]);
    for (int cycle = 0; cycle < cycles; ++cycle) {
        const int which = cycle % 8 == 0 ? 1 : cycle % 8 == 4 ? 2 : 0;
        if (which == 2) {
            one_cycle_of_fixed_steps(end);
        } else {
            one_cycle(which == 1 ? &lag_radau : &lag_dop853, end);
        }
        CHECK(memcmp(end, first[which], sizeof end) == 0);
    }
    (void)printf("cycles: %d ok\n", cycles);
    return EXIT_SUCCESS;
}
