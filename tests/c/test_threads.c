/* Runs of one model in several threads at the same time: each gets what it gets alone, to the bit. */
#include <pthread.h>
#include <string.h>

#include "check.h"
#include "lag/run.h"
#include "machine.h"

enum { THREADS = 8, RUNS = 8, SIZE = 5 };

typedef struct task {
    int runs;
    double stop;
    double end[SIZE];
} task;

static void *simulate(void *context)
{
    task *mine = context;
    const lag_run_options options = {.tolerance = 1e-9};
    for (int i = 0; i < mine->runs; ++i) {
        lag_run *run = lag_run_place(malloc(lag_run_size(&MACHINE, &options)), &MACHINE, &options);
        CHECK(lag_run_begin(run, 0.0, NULL) == LAG_OK);
        CHECK(lag_run_to(run, mine->stop, 0) == LAG_OK);
        memcpy(mine->end, run->stepper.x, sizeof mine->end);
        free(run);
    }
    return NULL;
}

int main(void)
{
    task alone[THREADS];
    task together[THREADS];
    pthread_t threads[THREADS];
    for (int i = 0; i < THREADS; ++i) {
        alone[i].stop = together[i].stop = 0.3 + 0.05 * i;
        alone[i].runs = 1;
        together[i].runs = RUNS;
        (void)simulate(&alone[i]);
    }
    for (int i = 0; i < THREADS; ++i) {
        CHECK(pthread_create(&threads[i], NULL, simulate, &together[i]) == 0);
    }
    for (int i = 0; i < THREADS; ++i) {
        CHECK(pthread_join(threads[i], NULL) == 0);
        CHECK(memcmp(alone[i].end, together[i].end, sizeof alone[i].end) == 0);
    }
    (void)printf("threads: ok\n");
    return EXIT_SUCCESS;
}
