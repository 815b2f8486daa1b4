/* Singular values against what they are by construction, and the equations that define them. */
#include <string.h>

#include "check.h"
#include "lag/linalg/svd.h"

enum { MOST = 12 };

static double arena[4000];

static double product(size_t n, const double *a, const double *b)
{
    double sum = 0.0;
    for (size_t i = 0; i < n; ++i) {
        sum += a[i] * b[i];
    }
    return sum;
}

static void random_numbers(size_t count, unsigned long long *seed, double *x)
{
    for (size_t i = 0; i < count; ++i) {
        x[i] = draw(seed);
    }
}

/* Rows of u (k, m) and v (n, n) are orthonormal, and sum to A. */
static void takes_apart(size_t m, size_t n, const double *a, size_t rank)
{
    CHECK(lag_svd_memory(m, n) <= sizeof arena / sizeof *arena);
    arena[lag_svd_memory(m, n)] = 12345.0;
    const lag_svd svd = lag_svd_of(m, n, a, arena);
    CHECK(arena[lag_svd_memory(m, n)] == 12345.0);
    double size = 0.0;
    for (size_t i = 0; i < m * n; ++i) {
        size = fmax(size, fabs(a[i]));
    }
    for (size_t i = 0; i < n; ++i) {
        for (size_t j = 0; j < n; ++j) {
            CHECK_NEAR(product(n, svd.v + i * n, svd.v + j * n), i == j ? 1.0 : 0.0, 1e-14);
        }
    }
    CHECK(lag_svd_rank(&svd, 1e-10) == rank);
    for (size_t i = 0; i < rank; ++i) {
        CHECK(i == 0 || svd.value[i] <= svd.value[i - 1]);
        for (size_t j = 0; j < rank; ++j) {
            CHECK_NEAR(product(m, svd.u + i * m, svd.u + j * m), i == j ? 1.0 : 0.0, 1e-9);
        }
    }
    for (size_t i = 0; i < m; ++i) {
        for (size_t j = 0; j < n; ++j) {
            double sum = 0.0;
            for (size_t l = 0; l < svd.k; ++l) {
                sum += svd.value[l] * svd.u[l * m + i] * svd.v[l * n + j];
            }
            CHECK_NEAR(sum, a[i * n + j], 1e-14 * (1.0 + size) * (double)(m + n));
        }
    }
}

/* A = B C with B (m, r), C (r, n). */
static void of_rank(size_t m, size_t n, size_t r, unsigned long long *seed)
{
    double b[MOST * MOST];
    double c[MOST * MOST];
    double a[MOST * MOST];
    random_numbers(m * r, seed, b);
    random_numbers(r * n, seed, c);
    for (size_t i = 0; i < m; ++i) {
        for (size_t j = 0; j < n; ++j) {
            a[i * n + j] = 0.0;
            for (size_t l = 0; l < r; ++l) {
                a[i * n + j] += b[i * r + l] * c[l * n + j];
            }
        }
    }
    takes_apart(m, n, a, r);
    const lag_svd svd = lag_svd_of(m, n, a, arena);
    double wanted[MOST];
    double x[MOST];
    double right[MOST];
    random_numbers(n, seed, wanted);
    for (size_t i = 0; i < m; ++i) {
        right[i] = product(n, a + i * n, wanted);
    }
    lag_svd_solve(&svd, right, 1e-10, 0.0, x);
    for (size_t i = 0; i < m; ++i) {
        CHECK_NEAR(product(n, a + i * n, x), right[i], 1e-9);
    }
    for (size_t i = r; i < n; ++i) { /* nothing along what A makes zero */
        CHECK_NEAR(product(n, svd.v + i * n, x), 0.0, 1e-10);
        for (size_t j = 0; j < m; ++j) {
            CHECK_NEAR(product(n, a + j * n, svd.v + i * n), 0.0, 1e-12);
        }
    }
}

/* Values 3, 1 and 1e-6 in directions of three dimensions that are known. */
static void known_values(void)
{
    const double u[3][3] = {{0.6, 0.8, 0.0}, {-0.8, 0.6, 0.0}, {0.0, 0.0, 1.0}};
    const double v[3][3] = {{1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0}, {2.0 / 3.0, 1.0 / 3.0, -2.0 / 3.0}, {-2.0 / 3.0, 2.0 / 3.0, -1.0 / 3.0}};
    const double value[3] = {3.0, 1.0, 1e-6};
    const double right[3] = {0.3, -0.2, 1e-7};
    double a[9];
    double x[3];
    for (int i = 0; i < 9; ++i) {
        a[i] = 0.0;
        for (int l = 0; l < 3; ++l) {
            a[i] += value[l] * u[l][i / 3] * v[l][i % 3];
        }
    }
    const lag_svd svd = lag_svd_of(3, 3, a, arena);
    for (int i = 0; i < 3; ++i) {
        CHECK_NEAR(svd.value[i], value[i], 1e-15 * 3.0);
    }
    const double damping = 0.1;
    lag_svd_solve(&svd, right, 1e-3, damping, x);
    for (int j = 0; j < 3; ++j) {
        double wanted = 0.0;
        for (int l = 0; l < 2; ++l) {
            wanted += product(3, u[l], right) * value[l] / (value[l] * value[l] + 0.09) * v[l][j];
        }
        CHECK_NEAR(x[j], wanted, 1e-15);
    }
    lag_svd_solve_transposed(&svd, right, 1e-3, x);
    for (int j = 0; j < 3; ++j) {
        CHECK_NEAR(x[j], product(3, v[0], right) / 3.0 * u[0][j] + product(3, v[1], right) * u[1][j], 1e-15);
    }
}

int main(void)
{
    unsigned long long seed = 7;
    const double zero[6] = {0.0};
    known_values();
    takes_apart(2, 3, zero, 0);
    takes_apart(0, 3, zero, 0);
    takes_apart(3, 0, zero, 0);
    for (size_t m = 1; m <= 8; ++m) {
        for (size_t n = 1; n <= 8; ++n) {
            for (size_t r = 1; r <= (m < n ? m : n); ++r) {
                of_rank(m, n, r, &seed);
            }
        }
    }
    (void)printf("svd: ok\n");
    return EXIT_SUCCESS;
}
