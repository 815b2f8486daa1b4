/*
 * Radau with the entries of the equations of a motion, in a band, against Radau with df/dx: a row of masses between stiff springs, at places that are
 * shuffled, whose inertia couples neighbours, with a state of first order behind each. Two of them are tied, by a row that is written twice; one more row
 * is zero, as that of an open contact.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "lag/factorization/lu.h"
#include "lag/methods/radau.h"

enum { N = 24, TIES = 3, ROWS = 2 * N + TIES, SIZE = 3 * N, COLUMNS = SIZE + N + TIES, SYSTEM = N + 1, MOST_ENTRIES = 24 * N };

/* Number of the mass at a place of the row; 7 and N have no common divisor. */
static size_t at(size_t place)
{
    return 7 * place % N;
}

/* Inertia between two neighbours, and its derivative by the first of them. */
static double coupling(double x, double y)
{
    return 1.0 + 0.3 * sin(x - y);
}

static double slope(double x, double y)
{
    return 0.3 * cos(x - y);
}

/* M (N, N) and f (N): 4 a + (couplings) a of neighbours = 1e4 (sin(x left) - 2 sin(x) + sin(x right)) - 300 v */
static void terms(const double *x, double *mass, double *force)
{
    memset(mass, 0, N * N * sizeof(double));
    for (size_t k = 0; k < N; ++k) {
        const size_t i = at(k);
        const double left = k > 0 ? sin(x[at(k - 1)]) : 0.0;
        const double right = k + 1 < N ? sin(x[at(k + 1)]) : 0.0;
        force[i] = 1e4 * (left - 2.0 * sin(x[i]) + right) - 300.0 * x[N + i];
        mass[i * N + i] = 4.0;
        if (k + 1 < N) {
            mass[i * N + at(k + 1)] = mass[at(k + 1) * N + i] = coupling(x[i], x[at(k + 1)]);
        }
    }
}

/* M a - J' lam = f, J a = 0 of the first tie alone: decomposed. */
static void decompose(const double *mass, double *system, double *pivot)
{
    memset(system, 0, SYSTEM * SYSTEM * sizeof(double));
    for (size_t i = 0; i < N; ++i) {
        memcpy(system + i * SYSTEM, mass + i * N, N * sizeof(double));
    }
    for (size_t k = 0; k < 2; ++k) {
        system[at(k) * SYSTEM + N] = -1.0;
        system[N * SYSTEM + at(k)] = 1.0;
    }
    CHECK(lag_lu(SYSTEM, system, pivot));
}

/* Accelerations, and the multiplier of the first tie behind them, with the system for others. */
static void solve(const double *x, double *a, double *system, double *pivot)
{
    static double mass[N * N];
    terms(x, mass, a);
    a[N] = 0.0;
    decompose(mass, system, pivot);
    lag_lu_solve(SYSTEM, system, pivot, a);
}

static lag_status rates(void *context, double t, const double *x, double *xd)
{
    static double system[SYSTEM * SYSTEM], pivot[SYSTEM], a[SYSTEM];
    (void)context;
    (void)t;
    solve(x, a, system, pivot);
    for (size_t i = 0; i < N; ++i) {
        xd[i] = x[N + i];
        xd[N + i] = a[i];
        xd[2 * N + i] = x[i] - 50.0 * x[2 * N + i];
    }
    return LAG_OK;
}

/* The equations with changed signs, -r, g - zd, -s, by (q, qd, z, qdd, lam) (ROWS, COLUMNS), at these accelerations. */
static void equations(const double *x, const double *a, double *to)
{
    static double mass[N * N], force[N];
    terms(x, mass, force);
    memset(to, 0, ROWS * COLUMNS * sizeof(double));
    for (size_t k = 0; k < N; ++k) {
        const size_t i = at(k);
        double *row = to + i * COLUMNS;
        row[i] = -2e4 * cos(x[i]);
        row[N + i] = -300.0;
        for (size_t side = 0; side < 2; ++side) {
            if (side == 0 ? k > 0 : k + 1 < N) {
                const size_t j = at(side == 0 ? k - 1 : k + 1);
                const double bend = side == 0 ? -slope(x[j], x[i]) : slope(x[i], x[j]); /* by x[i] */
                row[j] = 1e4 * cos(x[j]) + bend * a[j];
                row[i] -= bend * a[j];
            }
        }
        for (size_t j = 0; j < N; ++j) {
            row[SIZE + j] = -mass[i * N + j];
        }
        to[(N + i) * COLUMNS + i] = 1.0;
        to[(N + i) * COLUMNS + 2 * N + i] = -50.0;
    }
    for (size_t tie = 0; tie < 2; ++tie) {
        for (size_t k = 0; k < 2; ++k) {
            to[at(k) * COLUMNS + SIZE + N + tie] = 1.0 + (double)tie;
            to[(2 * N + tie) * COLUMNS + SIZE + at(k)] = -1.0 - (double)tie;
        }
    }
}

/* Their consequences for accelerations. */
static lag_status dense(void *context, double t, const double *x, double *jacobian)
{
    static double system[SYSTEM * SYSTEM], pivot[SYSTEM], a[SYSTEM], all[ROWS * COLUMNS];
    (void)context;
    (void)t;
    solve(x, a, system, pivot);
    equations(x, a, all);
    memset(jacobian, 0, SIZE * SIZE * sizeof(double));
    for (size_t j = 0; j < SIZE; ++j) {
        double change[SYSTEM] = {0.0};
        for (size_t i = 0; i < N; ++i) {
            change[i] = all[i * COLUMNS + j];
        }
        lag_lu_solve(SYSTEM, system, pivot, change);
        for (size_t i = 0; i < N; ++i) {
            jacobian[i * SIZE + j] = j == N + i ? 1.0 : 0.0;
            jacobian[(N + i) * SIZE + j] = change[i];
            jacobian[(2 * N + i) * SIZE + j] = all[(N + i) * COLUMNS + j];
        }
    }
    return LAG_OK;
}

/* The pattern of the equations, its rows in the order of the masses. */
typedef struct known {
    size_t row[MOST_ENTRIES], column[MOST_ENTRIES], first[ROWS + 1], place[ROWS];
    size_t group[SIZE], value_group[N + TIES]; /* a group for each column */
    lag_pattern pattern;
    lag_patterns patterns;
} known;

static lag_status linearize(void *context, double t, const double *x, double *entries)
{
    static double system[SYSTEM * SYSTEM], pivot[SYSTEM], a[SYSTEM], all[ROWS * COLUMNS];
    const known *one = context;
    (void)t;
    solve(x, a, system, pivot);
    equations(x, a, all);
    for (size_t k = 0; k < one->pattern.count; ++k) {
        entries[k] = all[one->row[k] * COLUMNS + one->column[k]];
    }
    return LAG_OK;
}

static void find_pattern(known *one)
{
    static double all[ROWS * COLUMNS];
    const double x[SIZE] = {0};
    const double a[N] = {0};
    size_t count = 0;
    size_t place = 0;
    equations(x, a, all);
    for (size_t i = 0; i < ROWS; ++i) {
        one->first[i] = count;
        for (size_t j = 0; j < COLUMNS; ++j) {
            if (all[i * COLUMNS + j] != 0.0) {
                CHECK(count < MOST_ENTRIES);
                one->row[count] = i;
                one->column[count++] = j;
            }
        }
    }
    one->first[ROWS] = count;
    for (size_t k = 0; k < N; ++k) {
        one->place[at(k)] = place++;
        one->place[N + at(k)] = place++;
        for (size_t tie = 0; tie < TIES && k == 0; ++tie) {
            one->place[2 * N + tie] = place++;
        }
    }
    one->pattern = (lag_pattern){ROWS, COLUMNS, count, one->row, one->column, one->first};
    for (size_t j = 0; j < SIZE; ++j) {
        one->group[j] = j;
    }
    for (size_t j = 0; j < N + TIES; ++j) {
        one->value_group[j] = j;
    }
    one->patterns = (lag_patterns){.equations = &one->pattern, .place = one->place, .group = one->group, .value_group = one->value_group};
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
    const lag_ode all = {.size = SIZE, .nq = N, .nc = TIES, .rates = rates, .jacobian = dense};
    const lag_ode few = {
        .size = SIZE, .nq = N, .nc = TIES, .context = &one, .rates = rates, .patterns = &one.patterns, .linearize = linearize};
    lag_radau_memo memo;
    lag_radau_keep_band(&memo, &few);
    CHECK(memo.lower == 5.0 && memo.upper == 5.0);
    CHECK(lag_stepper_memory(&few) < lag_stepper_memory(&all) / 2);
    const size_t steps = end_of(&all, with_all);
    const size_t with_few = end_of(&few, with_entries);
    CHECK(with_few + 2 >= steps && steps + 2 >= with_few);
    for (size_t i = 0; i < SIZE; ++i) {
        CHECK_NEAR(with_entries[i], with_all[i], 1e-8 * (1.0 + fabs(with_all[i])));
    }
    (void)printf("sparse: ok, %zu steps and %zu\n", with_few, steps);
    return EXIT_SUCCESS;
}
