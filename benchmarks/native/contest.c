/*
 * All contestants in one process, in turns: contest STATES ROUNDS [-- LABEL LIBRARY ARGUMENTS...]...
 *
 * Prints "V label kind state results" for every state, then "T label kind least median": nanoseconds of one evaluation over
 * ROUNDS blocks. A block takes about 0.1 ms, so that most are not preempted; before it, a shorter one that is not timed
 * brings the contestant's code and data back into the caches.
 */
#include "contest.h"

#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { MOST = 64, CYCLE = 16 };
static const double BLOCK = 100e-6, PATIENCE = 60.0; /* s */

static contestant all[MOST];
static const char *labels[MOST];
static long counts[MOST];
static int next[MOST];
static int entered;
static const char *current;

static void add(contestant one)
{
    if (entered < MOST) {
        labels[entered] = current;
        all[entered++] = one;
    }
}

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

static double block(int i, long count, int cycle)
{
    int k = next[i];
    const double start = now();
    for (long j = 0; j < count; ++j) {
        all[i].call(all[i].context, k);
        k = k + 1 < cycle ? k + 1 : 0;
    }
    const double end = now();
    next[i] = k;
    return end - start;
}

static double *read_states(const char *path, int *rows, int *n)
{
    FILE *file = fopen(path, "r");
    if (file == NULL || fscanf(file, "%d %d", rows, n) != 2) {
        fprintf(stderr, "cannot read %s\n", path);
        exit(2);
    }
    const size_t total = 2 * (size_t)*rows * (size_t)*n;
    double *values = malloc(sizeof(double) * total);
    for (size_t i = 0; i < total; ++i) {
        if (fscanf(file, "%lf", values + i) != 1) {
            fprintf(stderr, "%s is too short\n", path);
            exit(2);
        }
    }
    fclose(file);
    return values;
}

static int invite(const field *of, int count, char **arguments)
{
    void *library = dlopen(arguments[1], RTLD_NOW | RTLD_LOCAL);
    int (*call)(const field *, int, char **) = NULL;
    if (library != NULL) {
        *(void **)&call = dlsym(library, "enter");
    }
    if (call == NULL) {
        fprintf(stderr, "%s\n", dlerror());
        return 1;
    }
    current = arguments[0];
    return call(of, count - 2, arguments + 2);
}

static void show(int i, int rows)
{
    double *results = calloc((size_t)all[i].count + 1, sizeof *results);
    for (int k = 0; k < rows; ++k) {
        all[i].call(all[i].context, k);
        all[i].fetch(all[i].context, k, results);
        printf("V %s%s %s %d", labels[i], all[i].variant, all[i].kind, k);
        for (int j = 0; j < all[i].count; ++j) {
            printf(" %.17g", results[j]);
        }
        printf("\n");
    }
    free(results);
}

int main(int count, char **arguments)
{
    if (count < 3) {
        return 2;
    }
    field of = {.add = add};
    of.states = read_states(arguments[1], &of.rows, &of.n);
    const int rounds = atoi(arguments[2]), cycle = of.rows < CYCLE ? of.rows : CYCLE;
    for (int first = 4, end; first < count; first = end + 1) {
        for (end = first; end < count && strcmp(arguments[end], "--") != 0; ++end) {
        }
        if (end < first + 2 || invite(&of, end - first, arguments + first) != 0) {
            return 1;
        }
    }
    double *times = malloc(sizeof(double) * (size_t)rounds * (size_t)entered + 1);
    for (int i = 0; i < entered; ++i) {
        show(i, of.rows);
        for (counts[i] = 1; rounds > 0 && block(i, counts[i], cycle) < BLOCK; counts[i] *= 2) {
        }
    }
    const double end = now() + PATIENCE;
    int round = 0;
    for (; round < rounds && (round < 5 || now() < end); ++round) {
        for (int i = 0; i < entered; ++i) {
            block(i, counts[i] / 4 + 1, cycle);
            times[i * rounds + round] = block(i, counts[i], cycle) / ((double)counts[i] * all[i].each);
        }
    }
    for (int i = 0; i < entered && round > 0; ++i) {
        double *own = times + i * rounds;
        qsort(own, (size_t)round, sizeof *own, compare);
        printf("T %s%s %s %.4f %.4f\n", labels[i], all[i].variant, all[i].kind, own[0] * 1e9, own[round / 2] * 1e9);
    }
    return 0;
}
