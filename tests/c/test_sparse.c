/*
 * Radau with the entries of the Jacobian that can be nonzero, in a band, against Radau with all of them: a row of masses between stiff springs, at
 * places that are shuffled, and a state of first order behind each.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "lag/methods/radau.h"

enum { N = 24, ROWS = 2 * N, SIZE = 3 * N, MOST_ENTRIES = 8 * N };

/* Number of the mass at a place of the row; 7 and N have no common divisor. */
static size_t at(size_t place)
{
    return 7 * place % N;
}

/* x'' = 1e4 (sin(x left) - 2 sin(x) + sin(x right)) - 300 x', z' = x - 50 z */
static lag_status rates(void *context, double t, const double *x, double *xd)
{
    (void)context;
    (void)t;
    for (size_t k = 0; k < N; ++k) {
        const size_t i = at(k);
        const double left = k > 0 ? sin(x[at(k - 1)]) : 0.0;
        const double right = k + 1 < N ? sin(x[at(k + 1)]) : 0.0;
        xd[i] = x[N + i];
        xd[N + i] = 1e4 * (left - 2.0 * sin(x[i]) + right) - 300.0 * x[N + i];
        xd[2 * N + i] = x[i] - 50.0 * x[2 * N + i];
    }
    return LAG_OK;
}

static lag_status dense(void *context, double t, const double *x, double *jacobian)
{
    (void)context;
    (void)t;
    memset(jacobian, 0, SIZE * SIZE * sizeof(double));
    for (size_t k = 0; k < N; ++k) {
        const size_t i = at(k);
        double *row = jacobian + (N + i) * SIZE;
        jacobian[i * SIZE + N + i] = 1.0;
        row[i] = -2e4 * cos(x[i]);
        row[N + i] = -300.0;
        if (k > 0) {
            row[at(k - 1)] = 1e4 * cos(x[at(k - 1)]);
        }
        if (k + 1 < N) {
            row[at(k + 1)] = 1e4 * cos(x[at(k + 1)]);
        }
        jacobian[(2 * N + i) * SIZE + i] = 1.0;
        jacobian[(2 * N + i) * SIZE + 2 * N + i] = -50.0;
    }
    return LAG_OK;
}

/* The pattern of that, its rows in the order of the masses. */
typedef struct known {
    size_t row[MOST_ENTRIES], column[MOST_ENTRIES], first[ROWS + 1], place[ROWS], group[SIZE];
    lag_pattern pattern;
    lag_patterns patterns;
} known;

static lag_status entries(void *context, double t, const double *x, double *values)
{
    static double all[SIZE * SIZE];
    const known *one = context;
    const lag_status status = dense(context, t, x, all);
    for (size_t k = 0; k < one->pattern.count; ++k) {
        values[k] = all[(N + one->row[k]) * SIZE + one->column[k]];
    }
    return status;
}

static void find_pattern(known *one)
{
    static double all[SIZE * SIZE];
    const double x[SIZE] = {0};
    size_t count = 0;
    CHECK(dense(NULL, 0.0, x, all) == LAG_OK);
    for (size_t i = 0; i < ROWS; ++i) {
        one->first[i] = count;
        for (size_t j = 0; j < SIZE; ++j) {
            if (all[(N + i) * SIZE + j] != 0.0) {
                CHECK(count < MOST_ENTRIES);
                one->row[count] = i;
                one->column[count++] = j;
            }
        }
    }
    one->first[ROWS] = count;
    for (size_t k = 0; k < N; ++k) {
        one->place[at(k)] = 2 * k;
        one->place[N + at(k)] = 2 * k + 1;
    }
    one->pattern = (lag_pattern){ROWS, SIZE, count, one->row, one->column, one->first};
    one->patterns = (lag_patterns){.rates = &one->pattern, .place = one->place, .group = one->group};
}

/* The state at the end, of a motion from a bend. */
static size_t end_of(const lag_ode *ode, double *x)
{
    double *memory = calloc(lag_stepper_memory(ode), sizeof(double));
    lag_stepper s;
    lag_stepper_place(&s, ode, memory);
    for (size_t k = 0; k < N; ++k) {
        s.x[at(k)] = sin(0.2 * (double)k);
    }
    for (size_t i = 0; i < SIZE; ++i) {
        s.tolerance[i] = 1e-8;
    }
    s.h_least = 1e-14;
    lag_status status = lag_stepper_begin(&s, &lag_radau, 1.0);
    while (status == LAG_OK && s.t < 1.0) {
        status = lag_stepper_step(&s, 1.0);
    }
    CHECK(status == LAG_OK);
    memcpy(x, s.x, SIZE * sizeof(double));
    const size_t steps = s.counts.steps;
    free(memory);
    return steps;
}

int main(void)
{
    static known one;
    static double with_all[SIZE], with_entries[SIZE];
    find_pattern(&one);
    const lag_ode all = {.size = SIZE, .nq = N, .rates = rates, .jacobian = dense};
    const lag_ode few = {.size = SIZE, .nq = N, .context = &one, .rates = rates, .patterns = &one.patterns, .entries = entries};
    const lag_band band = lag_radau_band_of(&few);
    CHECK(band.n == ROWS && band.lower == 2 && band.upper == 2);
    CHECK(lag_radau_band_of(&all).lower == ROWS);
    CHECK(lag_stepper_memory(&few) < lag_stepper_memory(&all) / 2);
    CHECK(end_of(&few, with_entries) == end_of(&all, with_all));
    for (size_t i = 0; i < SIZE; ++i) {
        CHECK_NEAR(with_entries[i], with_all[i], 1e-12 * (1.0 + fabs(with_all[i])));
    }
    (void)printf("sparse: ok\n");
    return EXIT_SUCCESS;
}
