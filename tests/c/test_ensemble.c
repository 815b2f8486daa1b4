/* An ensemble: each of its runs is what it is alone, to the bit, whoever makes it and whatever happens in it. */
#include <pthread.h>
#include <string.h>

#include "check.h"
#include "lag/ensemble.h"
#include "lag/initial.h"
#include "machine.h"

enum { THREADS = 4, EACH = 6, RUNS = THREADS * EACH, SIZE = 5, TIMES = 11, WIDTH = 8 };

static double times[TIMES], natural[RUNS * SIZE], x[RUNS * SIZE], parameter[RUNS + 1];
static const unsigned char set[SIZE] = {1, 0, 0, 0, 0};
static const lag_start START = {0};
static double group[SIZE], cap[SIZE];
static double rows[RUNS * TIMES * WIDTH], ended[RUNS];
static size_t kept[RUNS];
static int status[RUNS];

static lag_run_options options(void)
{
    return (lag_run_options){
        .tolerance = 1e-9, .count = TIMES, .times = times, .sizes = {.group = group, .cap = cap}, .start = &START, .length = times[TIMES - 1]
    };
}

static lag_ensemble ensemble_of(const lag_run_options *told)
{
    return (lag_ensemble){
        .model = &MACHINE, .options = told, .stop = times[TIMES - 1], .first_piece = 1000, .piece = 1000, .most_steps = 100000, .equations = 1, .set = set,
        .p = parameter, .natural = natural, .x = x,
        .results = {.rows = rows, .kept = kept, .ended = ended, .status = status}
    };
}

typedef struct part {
    const lag_ensemble *ensemble;
    size_t first;
} part;

static void *make(void *context)
{
    const part *mine = context;
    void *block = malloc(lag_ensemble_size(mine->ensemble));
    CHECK(lag_ensemble_run(mine->ensemble, mine->first, mine->first + EACH, block) == mine->first + EACH);
    free(block);
    return NULL;
}

/* Run i by the functions of lag/run.h, its states at the times. */
static void make_alone(size_t i, double *states)
{
    static double row_sizes[2] = {1.0, 1.0};
    unsigned char dependent[2] = {0, 0};
    double start[SIZE];
    lag_run_options told = options();
    told.rows = states;
    told.sizes.natural = natural + i * SIZE;
    told.sizes.row_sizes = row_sizes;
    lag_run *run = lag_run_place(malloc(lag_run_size(&MACHINE, &told)), &MACHINE, &told);
    lag_initial found = {.dependent = dependent, .row_sizes = row_sizes};
    CHECK(lag_run_start(run, 0.0, start) == LAG_OK);
    start[0] = x[i * SIZE];
    CHECK(lag_run_find(run, 0.0, set, start, &found) == LAG_OK);
    CHECK(lag_run_begin(run, 0.0, start) == LAG_OK);
    CHECK(lag_run_to(run, times[TIMES - 1], 1000) == LAG_OK);
    CHECK(lag_run_end(run) == LAG_OK);
    free(run);
}

static void check_alone(void)
{
    double states[TIMES * SIZE];
    const size_t width = lag_ensemble_width(&MACHINE);
    for (size_t i = 0; i < RUNS; ++i) {
        make_alone(i, states);
        CHECK(status[i] == LAG_OK && kept[i] == TIMES && ended[i] == times[TIMES - 1]);
        for (size_t k = 0; k < TIMES; ++k) {
            CHECK(memcmp(rows + (i * TIMES + k) * width, states + k * SIZE, SIZE * sizeof(double)) == 0);
        }
    }
}

/* Whoever wants no more gets no more, and what is not made is told. */
static void check_stopped(const lag_ensemble *ensemble)
{
    static atomic_int stopped = 1;
    lag_ensemble ended_early = *ensemble;
    ended_early.stopped = &stopped;
    void *block = malloc(lag_ensemble_size(&ended_early));
    CHECK(lag_ensemble_run(&ended_early, 3, RUNS, block) == 3);
    free(block);
}

/* The last run of which a failure was told. */
typedef struct heard {
    size_t run, count;
    int status, begun;
    double t, height;
} heard;

static void hear(void *context, size_t i, lag_run *run, int failed, const double *starts, const double *at, const lag_initial *told)
{
    heard *own = context;
    lag_fault fault;
    lag_run_explain(run, (lag_status)failed, &fault);
    (void)at;
    *own = (heard){.run = i, .count = own->count + 1, .status = failed, .begun = told == NULL, .t = fault.t, .height = starts[0]};
}

/* A start that is no number, and too many steps, fail a run and no other; both are told while the run is there. */
static void check_failures(const lag_ensemble *ensemble)
{
    heard last = {.count = 0};
    double found[3] = {0.0};
    lag_ensemble told = *ensemble;
    told.failed = hear;
    told.context = &last;
    told.results.found = found;
    lag_ensemble few = told;
    void *block = malloc(lag_ensemble_size(ensemble));
    const double height = x[SIZE];
    x[SIZE] = (double)NAN;
    CHECK(lag_ensemble_run(&told, 0, 3, block) == 3);
    CHECK(last.count == 1 && last.run == 1 && last.status == LAG_NOT_FINITE && !last.begun && isnan(last.height));
    CHECK(status[0] == LAG_OK && status[1] == LAG_NOT_FINITE && status[2] == LAG_OK && kept[1] == 0 && isnan(ended[1]));
    x[SIZE] = height;
    few.most_steps = 3;
    CHECK(lag_ensemble_run(&few, 0, 1, block) == 1 && status[0] == LAG_TOO_LONG);
    CHECK(last.count == 2 && last.run == 0 && last.begun && last.t > 0.0 && last.height == x[0]);
    free(block);
}

int main(void)
{
    pthread_t threads[THREADS];
    part parts[THREADS];
    for (size_t k = 0; k < TIMES; ++k) {
        times[k] = 0.0371 * (double)k;
    }
    for (size_t k = 0; k < SIZE; ++k) {
        group[k] = (double)k;
        cap[k] = 1e3;
    }
    for (size_t i = 0; i < RUNS * SIZE; ++i) {
        natural[i] = 1.0 + 0.01 * (double)i;
        x[i] = 0.02 + 0.0005 * (double)i;
    }
    const lag_run_options told = options();
    const lag_ensemble ensemble = ensemble_of(&told);
    CHECK(lag_ensemble_width(&MACHINE) <= WIDTH);
    for (size_t i = 0; i < THREADS; ++i) {
        parts[i] = (part){&ensemble, i * EACH};
        CHECK(pthread_create(&threads[i], NULL, make, &parts[i]) == 0);
    }
    for (size_t i = 0; i < THREADS; ++i) {
        CHECK(pthread_join(threads[i], NULL) == 0);
    }
    check_alone();
    check_stopped(&ensemble);
    check_failures(&ensemble);
    (void)printf("ensemble: ok\n");
    return EXIT_SUCCESS;
}
