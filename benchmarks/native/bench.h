/* Nanoseconds per call over many short blocks, each of about 0.1 ms, so that most are not preempted; states from a file. */
#ifndef BENCH_H
#define BENCH_H

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

enum { STATES = 16, BLOCKS = 300 };

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static int compare(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double block(void (*call)(void *, int), void *context, long count)
{
    const double start = now();
    for (long i = 0; i < count; ++i) {
        call(context, (int)(i % STATES));
    }
    return now() - start;
}

/* Prints "T label least median". */
static void bench(const char *label, void (*call)(void *, int), void *context)
{
    static double times[BLOCKS];
    long count = STATES;
    while (block(call, context, count) < 100e-6) {
        count *= 2;
    }
    const double end = now() + 4.0;
    int blocks = 0;
    while (blocks < BLOCKS && (blocks < 7 || now() < end)) {
        times[blocks++] = block(call, context, count) / (double)count;
    }
    qsort(times, (size_t)blocks, sizeof *times, compare);
    printf("T %s %.3f %.3f\n", label, times[0] * 1e9, times[blocks / 2] * 1e9);
    fflush(stdout);
}

/* `rows` rows of `width` numbers. */
static double *read_states(const char *path, int rows, int width)
{
    FILE *file = fopen(path, "r");
    double *values = (double *)malloc(sizeof(double) * (size_t)rows * (size_t)width);
    for (int i = 0; file != NULL && i < rows * width; ++i) {
        if (fscanf(file, "%lf", values + i) != 1) {
            fprintf(stderr, "%s is too short\n", path);
            exit(2);
        }
    }
    if (file == NULL) {
        fprintf(stderr, "cannot read %s\n", path);
        exit(2);
    }
    fclose(file);
    return values;
}

/* The result for every state: "V label k values". */
static void show(const char *label, int k, const double *values, int count)
{
    printf("V %s %d", label, k);
    for (int i = 0; i < count; ++i) {
        printf(" %.17g", values[i]);
    }
    printf("\n");
}

#endif
