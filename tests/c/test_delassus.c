#include <math.h>
#include <string.h>

#include "check.h"
#include "lag/equations/delassus.h"
#include "lag/dynamics.h"
#include "lag/linalg/linalg.h"

enum { MOST = 10 };

typedef struct problem {
    size_t n, m;
    double mass[MOST * MOST], jacobian[MOST * MOST], force[MOST], gamma[MOST], a[MOST], lam[MOST];
} problem;

/* As elimination() does it: M^-1 of the force and of every row. */
static void eliminate(const problem *x, double *a, double *response)
{
    double factor[MOST * MOST];
    memcpy(factor, x->mass, x->n * x->n * sizeof(double));
    CHECK(lag_cholesky(x->n, factor, 0.0) == x->n);
    memcpy(a, x->force, x->n * sizeof(double));
    lag_cholesky_solve(x->n, factor, a);
    memcpy(response, x->jacobian, x->m * x->n * sizeof(double));
    for (size_t i = 0; i < x->m; ++i) {
        lag_cholesky_solve(x->n, factor, response + i * x->n);
    }
}

/* Solution by S of the rows `kept`, where `a` and `lam` hold that of the others. */
static lag_status solve_kept(
    problem *x, size_t kept, const size_t *row, size_t rank, const double *response, const double *lam_response)
{
    const size_t size = lag_delassus_memory(x->m, kept);
    double *memory = malloc((size + 1) * sizeof(double)); /* exactly what is declared: the sanitizer sees one step beyond */
    double jacobian[MOST * MOST], gamma[MOST];
    lag_delassus system;
    const lag_patterns patterns = {.jacobian = NULL};
    CHECK(memory != NULL);
    lag_delassus_place(&system, x->n, x->m, kept, row, &patterns, memory);
    for (size_t i = 0; i < kept; ++i) {
        memcpy(jacobian + i * x->n, x->jacobian + row[i] * x->n, x->n * sizeof(double));
        gamma[i] = x->gamma[row[i]];
    }
    system.response = response;
    system.lam_response = lam_response;
    system.jacobian = jacobian;
    (void)lag_delassus_weigh(&system, NULL);
    const lag_status status = lag_delassus_factor(&system, rank);
    if (status == LAG_OK) {
        lag_delassus_solve(&system, gamma, x->a, x->lam);
    }
    free(memory);
    return status;
}

static const size_t all[MOST] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9};
static const double nothing[MOST * MOST];

static lag_status solve(problem *x, size_t rank)
{
    double response[MOST * MOST];
    memset(x->lam, 0, sizeof(x->lam));
    eliminate(x, x->a, response);
    return solve_kept(x, x->m, all, rank, response, nothing);
}

static void solve_dense(problem *x, size_t rank)
{
    double *memory = malloc((lag_system_memory(x->n, x->m) + 1) * sizeof(double));
    lag_system system;
    CHECK(memory != NULL);
    lag_system_place(&system, x->n, x->m, NULL, memory);
    CHECK(lag_system_factor(&system, x->mass, x->jacobian, rank, NULL) == LAG_OK);
    lag_system_solve(&system, x->force, x->gamma, x->a, x->lam);
    free(memory);
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

/* M = 1/10 + B'B, in units that differ by `spread` from one coordinate to the next. */
static void draw_problem(problem *x, size_t n, size_t m, double spread, unsigned long long *seed)
{
    double b[MOST * MOST];
    x->n = n;
    x->m = m;
    for (size_t i = 0; i < n * n; ++i) {
        b[i] = draw(seed);
    }
    for (size_t i = 0; i < n; ++i) {
        for (size_t j = 0; j < n; ++j) {
            x->mass[i * n + j] = i == j ? 0.1 : 0.0;
            for (size_t k = 0; k < n; ++k) {
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

/* Row `to` becomes a combination of the first two. */
static void combine(problem *x, size_t to, double first, double second)
{
    for (size_t j = 0; j < x->n; ++j) {
        x->jacobian[to * x->n + j] = first * x->jacobian[j] + second * x->jacobian[x->n + j];
    }
    x->gamma[to] = first * x->gamma[0] + second * x->gamma[1];
}

static void compare(const problem *x, const problem *y, double tolerance)
{
    double size = 0.0;
    for (size_t i = 0; i < x->n; ++i) {
        size = fmax(size, fabs(y->a[i]));
    }
    for (size_t i = 0; i < x->n; ++i) {
        CHECK_NEAR(x->a[i], y->a[i], tolerance * size);
    }
    size = 0.0;
    for (size_t i = 0; i < x->m; ++i) {
        size = fmax(size, fabs(y->lam[i]));
    }
    for (size_t i = 0; i < x->m; ++i) {
        CHECK_NEAR(x->lam[i], y->lam[i], tolerance * size);
    }
}

static void independent_rows(void)
{
    static const double spreads[] = {1.0, 10.0, 0.1};
    unsigned long long seed = 21;
    problem x;
    for (int trial = 0; trial < 200; ++trial) {
        const size_t n = 2 + (size_t)trial % (MOST - 2);
        const size_t m = 1 + (size_t)trial % (n / 2);
        draw_problem(&x, n, m, spreads[trial % 3], &seed);
        CHECK(solve(&x, m) == LAG_OK);
        CHECK(rest(&x) < 1e-12);
    }
}

static void dependent_rows_share_as_in_the_dense_solution(void)
{
    unsigned long long seed = 22;
    problem x;
    for (int trial = 0; trial < 50; ++trial) {
        draw_problem(&x, 6, 5, 1.0, &seed);
        combine(&x, 2, 3.0, 0.0);
        combine(&x, 3, trial % 2 ? 0.0 : -1.0, trial % 2 ? 0.0 : 100.0); /* now and then a row of zeros */
        problem dense = x;
        CHECK(solve(&x, 3) == LAG_OK);
        CHECK(rest(&x) < 1e-12);
        solve_dense(&dense, 3);
        compare(&x, &dense, 1e-10);
    }
}

/* All but the rows `row` solved before: what is left is the system of these, with what their multipliers add to the others. */
static void solve_after_others(problem *x, size_t kept, const size_t *row, size_t rank)
{
    double response[MOST * MOST], lam_response[MOST * MOST] = {0};
    for (size_t i = 0; i <= kept; ++i) { /* the last one: the forces; else the accelerations that a row gives */
        problem part = *x;
        size_t solved[MOST];
        part.m = 0;
        for (size_t k = 0; k < x->m; ++k) {
            int left = 0;
            for (size_t j = 0; j < kept; ++j) {
                left = left || row[j] == k;
            }
            if (!left) {
                memcpy(part.jacobian + part.m * x->n, x->jacobian + k * x->n, x->n * sizeof(double));
                part.gamma[part.m] = i < kept ? 0.0 : x->gamma[k];
                solved[part.m++] = k;
            }
        }
        if (i < kept) {
            memcpy(part.force, x->jacobian + row[i] * x->n, x->n * sizeof(double));
        }
        solve_dense(&part, part.m);
        double *lam = i < kept ? lam_response + i * x->m : x->lam;
        memset(lam, 0, x->m * sizeof(double));
        memcpy(i < kept ? response + i * x->n : x->a, part.a, x->n * sizeof(double));
        for (size_t k = 0; k < part.m; ++k) {
            lam[solved[k]] = part.lam[k];
        }
    }
    CHECK(solve_kept(x, kept, row, rank, response, lam_response) == LAG_OK);
}

static void rows_that_were_solved_before(void)
{
    static const size_t some[] = {1, 2, 4}, last[] = {4}, three[] = {3, 4, 5};
    unsigned long long seed = 23;
    problem x;
    for (int trial = 0; trial < 50; ++trial) {
        draw_problem(&x, 8, 6, 1.0, &seed);
        combine(&x, 4, 2.0, -1.0);
        problem dense = x;
        solve_dense(&dense, 5);
        solve_after_others(&x, 3, some, 2);
        CHECK(rest(&x) < 1e-12);
        compare(&x, &dense, 1e-9);
        solve_after_others(&x, 1, last, 0);
        CHECK(rest(&x) < 1e-12);
        compare(&x, &dense, 1e-9);
        combine(&x, 3, 1.0, 50.0);
        combine(&x, 5, 0.0, 0.0);
        dense = x;
        solve_dense(&dense, 3);
        solve_after_others(&x, 3, three, 0);
        CHECK(rest(&x) < 1e-12);
        compare(&x, &dense, 1e-9);
        CHECK(x.lam[5] == 0.0);
    }
}

/* Two rows that differ by `step`: either solved well, or left to the dense system. */
static void nearly_dependent_rows(void)
{
    unsigned long long seed = 24;
    for (int trial = 0; trial < 40; ++trial) {
        problem x;
        draw_problem(&x, 6, 3, 1.0, &seed);
        const double step = pow(10.0, -1.0 - 0.25 * trial);
        for (size_t j = 0; j < 6; ++j) {
            x.jacobian[12 + j] = x.jacobian[j] + step * x.jacobian[12 + j];
        }
        problem dense = x;
        const lag_status status = solve(&x, 3);
        CHECK(status == (step > 1e-2 ? LAG_OK : step < 1e-5 ? LAG_MISSING : status));
        if (status == LAG_OK) {
            CHECK(rest(&x) < 1e-12);
            solve_dense(&dense, 3);
            compare(&x, &dense, 1e-12 / step);
        }
    }
}

static void rows_that_are_not_dependent_after_all(void)
{
    unsigned long long seed = 25;
    problem x;
    draw_problem(&x, 6, 3, 1.0, &seed);
    combine(&x, 2, 1.0, 1.0);
    CHECK(solve(&x, 2) == LAG_OK);
    x.jacobian[12] += 1e-3;
    CHECK(solve(&x, 2) == LAG_MISSING);
}

static void rows_of_zeros(void)
{
    problem x = {.n = 2, .m = 2, .mass = {2.0, 0.0, 0.0, 3.0}, .jacobian = {0.0, 0.0, 1.0, 1.0}, .force = {1.0, 5.0}};
    CHECK(solve(&x, 2) == LAG_MISSING);
    CHECK(solve(&x, 1) == LAG_OK);
    CHECK(x.lam[0] == 0.0 && !signbit(x.lam[0]));
    CHECK_NEAR(x.a[0], -0.8, 1e-15); /* (1 - 5) / (2 + 3) */
    CHECK_NEAR(x.lam[1], -2.6, 1e-15);
    problem zero = {.n = 2, .m = 2, .mass = {2.0, 0.0, 0.0, 3.0}, .force = {1.0, 6.0}};
    CHECK(solve(&zero, 1) == LAG_MISSING);
    CHECK(solve(&zero, 0) == LAG_OK);
    CHECK_NEAR(zero.a[0], 0.5, 1e-15);
    CHECK_NEAR(zero.a[1], 2.0, 1e-15);
    CHECK(zero.lam[0] == 0.0);
}

static void values_that_are_no_numbers(void)
{
    static const double odd[] = {(double)NAN, (double)INFINITY};
    unsigned long long seed = 26;
    for (int trial = 0; trial < 12; ++trial) {
        problem x;
        double a[MOST], response[MOST * MOST];
        draw_problem(&x, 4, 3, 1.0, &seed);
        eliminate(&x, a, response);
        response[trial] = odd[trial % 2];
        CHECK(solve_kept(&x, 3, all, 3, response, nothing) == LAG_MISSING);
    }
}

static void no_rows(void)
{
    problem x = {.n = 1, .m = 0, .mass = {2.0}, .force = {3.0}};
    CHECK(solve(&x, 0) == LAG_OK);
    CHECK_NEAR(x.a[0], 1.5, 1e-15);
}

/* ---- a chain ---- */

enum { LINKS = 300 };

/* Bodies of mass one, rows of the differences of neighbors: S is -1, 2, -1, and S x = 1 has the solution x_i = (i + 1)(n - i)/2. */
static void a_chain_has_as_many_entries_as_it_is_long(void)
{
    static double jacobian[LINKS * (LINKS + 1)], zero[LINKS * LINKS], gamma[LINKS], a[LINKS + 1], lam[LINKS];
    static size_t row[3 * LINKS], column[2 * LINKS], first[LINKS + 1], all_rows[LINKS];
    static size_t beside_row[3 * LINKS], beside[3 * LINKS], beside_first[LINKS + 1];
    size_t next = 0;
    double entries = 0.0;
    for (size_t i = 0; i < LINKS; ++i) {
        all_rows[i] = row[2 * i] = row[2 * i + 1] = i;
        first[i] = 2 * i;
        column[2 * i] = i;
        column[2 * i + 1] = i + 1;
        jacobian[i * (LINKS + 1) + i] = -1.0;
        jacobian[i * (LINKS + 1) + i + 1] = 1.0;
        gamma[i] = 1.0;
        beside_first[i] = next;
        for (size_t k = i > 0 ? i - 1 : 0; k < LINKS && k <= i + 1; ++k) {
            beside_row[next] = i;
            beside[next++] = k;
        }
    }
    first[LINKS] = 2 * LINKS;
    beside_first[LINKS] = next;
    const lag_pattern of_rows = {LINKS, LINKS + 1, 2 * LINKS, row, column, first};
    const lag_pattern couplings = {LINKS, LINKS, next, beside_row, beside, beside_first};
    const lag_patterns patterns = {.jacobian = &of_rows, .response = &of_rows, .coupling = &couplings};
    double *memory = malloc(lag_delassus_memory(LINKS, LINKS) * sizeof(double));
    lag_delassus system;
    CHECK(memory != NULL);
    lag_delassus_place(&system, LINKS + 1, LINKS, LINKS, all_rows, &patterns, memory);
    system.response = system.jacobian = jacobian;
    system.lam_response = zero;
    CHECK(lag_delassus_weigh(&system, NULL) == LINKS);
    CHECK(lag_delassus_factor(&system, LINKS) == LAG_OK);
    lag_delassus_solve(&system, gamma, a, lam);
    for (size_t i = 0; i < LINKS; ++i) {
        const double exact = 0.5 * (double)(i + 1) * (double)(LINKS - i);
        CHECK(fabs(lam[i] - exact) < 1e-10 * exact);
        CHECK(fabs(a[i + 1] - a[i] - 1.0) < 1e-9);
        entries += system.factor.count[i];
    }
    CHECK(entries <= 2.0 * LINKS);
    free(memory);
}

int main(void)
{
    independent_rows();
    dependent_rows_share_as_in_the_dense_solution();
    rows_that_were_solved_before();
    nearly_dependent_rows();
    rows_that_are_not_dependent_after_all();
    rows_of_zeros();
    values_that_are_no_numbers();
    no_rows();
    a_chain_has_as_many_entries_as_it_is_long();
    (void)printf("delassus: ok\n");
    return EXIT_SUCCESS;
}
