/* States of instances as bytes: they go on to the bit, anywhere. Threads do not know of each other. */
#include <pthread.h>

#include "instances.h"
#include "machine_fmu.h"
#include "oscillator.h"

static unsigned char *saved(const lag_instance *one)
{
    unsigned char *bytes = malloc(lag_instance_saved_size(one) + 1);
    bytes[lag_instance_saved_size(one)] = 77;
    lag_instance_save(one, bytes);
    CHECK(bytes[lag_instance_saved_size(one)] == 77);
    return bytes;
}

/* Steps of 7 ms from where it is, with a jump of the input on the way; all states on the way. */
static void go_on(lag_instance *one, size_t size, int jumps, double *x)
{
    lag_progress told;
    for (int k = 0; k < 100; ++k) {
        if (jumps && k % 30 == 29) {
            set(one, OSC_U, 0.01 * k);
        }
        CHECK_OK(one, lag_instance_step(one, 0.007, 0, &told));
        CHECK_OK(one, lag_instance_vector(one, LAG_ROLE_STATE, x + (size_t)k * size));
    }
}

static void rollback(const lag_fmu *fmu, size_t size, int jumps)
{
    static double first[100 * MACH_SIZE], again[100 * MACH_SIZE];
    lag_progress told;
    lag_instance *one = begun(fmu, 0.0, 2.0, 0.0);
    for (int k = 0; k < 11; ++k) {
        unsigned char *bytes = saved(one);
        unsigned char *more = NULL;
        lag_instance *other = lag_instance_place(malloc(lag_instance_size(fmu)), fmu);
        go_on(one, size, jumps, first);
        CHECK_OK(other, lag_instance_load(other, bytes));
        more = saved(other);
        CHECK(memcmp(bytes, more, lag_instance_saved_size(one)) == 0);
        go_on(other, size, jumps, again);
        CHECK(memcmp(first, again, 100 * size * sizeof(double)) == 0);
        CHECK_OK(one, lag_instance_load(one, bytes));
        go_on(one, size, jumps, again);
        CHECK(memcmp(first, again, 100 * size * sizeof(double)) == 0);
        CHECK_OK(one, lag_instance_load(one, bytes));
        CHECK_OK(one, lag_instance_step(one, 0.031, 0, &told));
        free(other);
        free(more);
        free(bytes);
    }
    free(one);
}

/* In initialization, too: what was set, not yet what follows. */
static void before_the_start(void)
{
    lag_instance *one = placed(&OSC_FMU, 1.0, 2.0, 0.0);
    set(one, OSC_K, 2.0);
    set(one, OSC_QD, 3.0);
    unsigned char *bytes = saved(one);
    lag_instance *other = lag_instance_place(malloc(lag_instance_size(&OSC_FMU)), &OSC_FMU);
    CHECK_OK(other, lag_instance_load(other, bytes));
    begin(other);
    CHECK(get(other, OSC_TIME) == 1.0 && get(other, OSC_Q) == 2.0 && get(other, OSC_QD) == 3.0 && get(other, OSC_K) == 2.0);
    free(one);
    free(other);
    free(bytes);
}

/* ---- threads ---- */

enum { THREADS = 16 };

typedef struct task {
    int runs;
    double tolerance;
    double x[100 * MACH_SIZE];
} task;

static void *simulate(void *context)
{
    task *mine = context;
    for (int i = 0; i < mine->runs; ++i) {
        lag_instance *one = begun(&MACH_FMU, 0.0, 2.0, mine->tolerance);
        go_on(one, MACH_SIZE, 0, mine->x);
        free(one);
    }
    return NULL;
}

static void threads(void)
{
    static task alone[THREADS], together[THREADS];
    pthread_t thread[THREADS];
    for (int i = 0; i < THREADS; ++i) {
        alone[i].tolerance = together[i].tolerance = pow(10.0, -4.0 - 0.4 * i);
        alone[i].runs = 1;
        together[i].runs = 5;
        (void)simulate(&alone[i]);
    }
    for (int i = 0; i < THREADS; ++i) {
        CHECK(pthread_create(&thread[i], NULL, simulate, &together[i]) == 0);
    }
    for (int i = 0; i < THREADS; ++i) {
        CHECK(pthread_join(thread[i], NULL) == 0);
        CHECK(memcmp(alone[i].x, together[i].x, sizeof alone[i].x) == 0);
    }
}

int main(void)
{
    rollback(&MACH_FMU, MACH_SIZE, 0);
    rollback(&OSC_FMU, 3, 1);
    before_the_start();
    threads();
    (void)printf("instance_states: ok\n");
    return EXIT_SUCCESS;
}
