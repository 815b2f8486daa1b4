#include <string.h>

#include "check.h"
#include "lag/dynamics.h"

enum { MOST = 10 };

typedef struct problem {
    size_t n, m;
    double mass[MOST * MOST], jacobian[MOST * MOST], force[MOST], gamma[MOST], a[MOST], lam[MOST];
    size_t coordinate;
    const size_t *components;
} problem;

static lag_status solve(problem *x, size_t most)
{
    const size_t size = lag_system_memory(x->n, x->m);
    double *memory = malloc((size + 1) * sizeof(double)); /* exactly what is declared: the sanitizer sees one step beyond */
    lag_system system;
    CHECK(memory != NULL);
    lag_system_place(&system, x->n, x->m, x->components, memory);
    const lag_status status = lag_system_factor(&system, x->mass, x->jacobian, most, &x->coordinate);
    if (status == LAG_OK) {
        lag_system_solve(&system, x->force, x->gamma, x->a, x->lam);
    }
    free(memory);
    return status;
}

/* Residual that a and lam leave in both rows, as a part of the terms that stand there. */
static double rest(const problem *x)
{
    double worst = 0.0;
    for (size_t i = 0; i < x->n; ++i) {
        double sum = -x->force[i];
        double size = fabs(x->force[i]);
        for (size_t j = 0; j < x->n; ++j) {
            sum += x->mass[i * x->n + j] * x->a[j];
            size += fabs(x->mass[i * x->n + j] * x->a[j]);
        }
        for (size_t j = 0; j < x->m; ++j) {
            sum -= x->jacobian[j * x->n + i] * x->lam[j];
            size += fabs(x->jacobian[j * x->n + i] * x->lam[j]);
        }
        worst = fmax(worst, fabs(sum) / fmax(size, 1e-300));
    }
    for (size_t i = 0; i < x->m; ++i) {
        double sum = -x->gamma[i];
        double size = fabs(x->gamma[i]);
        for (size_t j = 0; j < x->n; ++j) {
            sum += x->jacobian[i * x->n + j] * x->a[j];
            size += fabs(x->jacobian[i * x->n + j] * x->a[j]);
        }
        worst = fmax(worst, fabs(sum) / fmax(size, 1e-300));
    }
    return worst;
}

/* M = B'B of rank `rank`, in units that differ by `spread` from one coordinate to the next. */
static void draw_problem(problem *x, size_t n, size_t m, size_t rank, double spread, unsigned long long *seed)
{
    double b[MOST * MOST];
    x->n = n;
    x->m = m;
    x->components = NULL;
    for (size_t i = 0; i < rank * n; ++i) {
        b[i] = draw(seed);
    }
    for (size_t i = 0; i < n; ++i) {
        for (size_t j = 0; j < n; ++j) {
            x->mass[i * n + j] = 0.0;
            for (size_t k = 0; k < rank; ++k) {
                x->mass[i * n + j] += b[k * n + i] * b[k * n + j];
            }
            x->mass[i * n + j] *= pow(spread, (double)i) * pow(spread, (double)j);
        }
        x->force[i] = draw(seed) * pow(spread, (double)i);
    }
    for (size_t i = 0; i < m; ++i) {
        for (size_t j = 0; j < n; ++j) {
            x->jacobian[i * n + j] = draw(seed) * pow(spread, (double)j);
        }
        x->gamma[i] = draw(seed);
    }
}

static void regular_and_singular_mass(void)
{
    static const double spreads[] = {1.0, 10.0, 0.1};
    unsigned long long seed = 11;
    problem x;
    for (int trial = 0; trial < 200; ++trial) {
        const size_t n = 2 + (size_t)trial % (MOST - 2);
        const size_t m = (size_t)trial % (n / 2 + 1);
        draw_problem(&x, n, m, trial % 2 ? n : n - m, spreads[trial % 3], &seed);
        CHECK(solve(&x, m) == LAG_OK);
        CHECK(rest(&x) < 1e-13);
    }
}

/* Rows stated again at another length: the same motion, multipliers of least norm. */
static void dependent_rows(void)
{
    unsigned long long seed = 12;
    problem x;
    for (int trial = 0; trial < 50; ++trial) {
        draw_problem(&x, 6, 2, 6, 1.0, &seed);
        CHECK(solve(&x, 2) == LAG_OK);
        problem more = x;
        more.m = 3;
        for (size_t j = 0; j < 6; ++j) {
            more.jacobian[12 + j] = 3.0 * more.jacobian[j];
        }
        more.gamma[2] = 3.0 * more.gamma[0];
        CHECK(solve(&more, 3) == LAG_OK);
        CHECK(rest(&more) < 1e-13);
        for (size_t j = 0; j < 6; ++j) {
            CHECK_NEAR(more.a[j], x.a[j], 1e-10 * (1.0 + fabs(x.a[j])));
        }
        /* lam0 (1, 3) is shared out along (1, 3): lam0 / 10 and 3 lam0 / 10 */
        const double scale = fabs(x.lam[0]) + fabs(x.lam[1]);
        CHECK_NEAR(more.lam[0], x.lam[0] / 10.0, 1e-11 * scale);
        CHECK_NEAR(more.lam[2], 0.3 * x.lam[0], 1e-11 * scale);
        CHECK_NEAR(more.lam[1], x.lam[1], 1e-11 * scale);
    }
}

/* Rows of a small and of a large part, which have no coordinate in common: each has its rank, however long the other's rows are. */
static void parts_of_two_sizes(void)
{
    static const size_t components[] = {0, 0, 2, 2};
    for (double ratio = 1e-30; ratio < 1e31; ratio *= 1e5) {
        problem x = {.n = 4, .m = 2, .mass = {1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0},
            .jacobian = {3.0, 4.0, 0.0, 0.0, 0.0, 0.0, 3.0 * ratio, 4.0 * ratio}, .gamma = {25.0, 50.0 * ratio}, .components = components};
        CHECK(solve(&x, 2) == LAG_OK);
        CHECK_NEAR(x.a[0], 3.0, 1e-14); /* the shortest one */
        CHECK_NEAR(x.a[1], 4.0, 1e-14);
        CHECK_NEAR(x.a[2], 6.0, 1e-14);
        CHECK_NEAR(x.a[3], 8.0, 1e-14);
    }
}

static void zero_row_has_zero_multiplier(void)
{
    problem x = {.n = 2, .m = 2, .mass = {2.0, 0.0, 0.0, 3.0}, .jacobian = {0.0, 0.0, 1.0, 1.0}, .force = {1.0, 5.0}};
    CHECK(solve(&x, 2) == LAG_OK);
    CHECK(x.lam[0] == 0.0 && !signbit(x.lam[0]));
    CHECK_NEAR(x.a[0], -0.8, 1e-15); /* (1 - 5) / (2 + 3) */
    CHECK_NEAR(x.lam[1], -2.6, 1e-15);
}

static void indefinite_mass(void)
{
    problem x = {.n = 2, .m = 0, .mass = {1.0, 2.0, 2.0, -3.0}, .force = {5.0, -4.0}};
    CHECK(solve(&x, 0) == LAG_OK);
    CHECK_NEAR(x.a[0], 1.0, 1e-15);
    CHECK_NEAR(x.a[1], 2.0, 1e-15);
}

static void undetermined_coordinate_is_named(void)
{
    problem x = {.n = 3, .m = 1, .mass = {1.0, 0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 0.0}, .jacobian = {1.0, 1.0, 0.0}};
    CHECK(solve(&x, 1) == LAG_SINGULAR);
    CHECK(x.coordinate == 2);
    problem nothing = {.n = 2, .m = 0};
    CHECK(solve(&nothing, 0) == LAG_SINGULAR);
    CHECK(nothing.coordinate == 0);
    problem coincident = {.n = 3, .m = 0, .mass = {3.0, 0.0, 3.0, 0.0, 1.0, 0.0, 3.0, 0.0, 3.0}};
    CHECK(solve(&coincident, 0) == LAG_SINGULAR);
    CHECK(coincident.coordinate == 0);
}

static void values_that_are_no_numbers(void)
{
    problem x = {.n = 1, .m = 0, .mass = {(double)NAN}, .force = {1.0}};
    CHECK(solve(&x, 0) == LAG_NOT_FINITE);
    problem y = {.n = 1, .m = 1, .mass = {1.0}, .jacobian = {(double)INFINITY}};
    CHECK(solve(&y, 1) == LAG_NOT_FINITE);
}

static void no_unknowns(void)
{
    problem x = {.n = 0, .m = 1, .gamma = {0.0}};
    CHECK(solve(&x, 1) == LAG_OK);
    CHECK(x.lam[0] == 0.0);
}

int main(void)
{
    regular_and_singular_mass();
    dependent_rows();
    parts_of_two_sizes();
    zero_row_has_zero_multiplier();
    indefinite_mass();
    undetermined_coordinate_is_named();
    values_that_are_no_numbers();
    no_unknowns();
    (void)printf("system: ok\n");
    return EXIT_SUCCESS;
}
