/* Minima over what is not negative, by the conditions that tell them. */
#include "check.h"
#include "lag/optimization/nnls.h"

enum { MOST = 12 };

/* A = R'R with R (rank, n), b = R'r: in the range of A. */
static void draw_problem(size_t n, size_t rank, unsigned long long *seed, double *a, double *b)
{
    double r[MOST * MOST];
    for (size_t i = 0; i < rank * n; ++i) {
        r[i] = draw(seed);
    }
    for (size_t i = 0; i < n; ++i) {
        b[i] = 0.0;
        for (size_t j = 0; j < n; ++j) {
            a[i * n + j] = 0.0;
            for (size_t k = 0; k < rank; ++k) {
                a[i * n + j] += r[k * n + i] * r[k * n + j];
            }
        }
    }
    for (size_t k = 0; k < rank; ++k) {
        const double right = draw(seed);
        for (size_t i = 0; i < n; ++i) {
            b[i] += right * r[k * n + i];
        }
    }
}

static void solve(size_t n, const double *a, const double *b, double *x)
{
    double *memory = malloc(lag_nnls_memory(n) * sizeof(double));
    CHECK(memory != NULL);
    lag_nnls(n, a, b, x, memory);
    free(memory);
}

/* x >= 0, A x + b >= 0, and one of the two zero, for each i. */
static void complementary(void)
{
    unsigned long long seed = 7;
    for (int trial = 0; trial < 3000; ++trial) {
        const size_t n = 1 + (size_t)trial % MOST;
        const size_t rank = trial % 3 == 0 && n > 2 ? n / 2 : n;
        double a[MOST * MOST];
        double b[MOST];
        double x[MOST];
        draw_problem(n, rank, &seed, a, b);
        solve(n, a, b, x);
        for (size_t i = 0; i < n; ++i) {
            double slope = b[i];
            for (size_t j = 0; j < n; ++j) {
                slope += a[i * n + j] * x[j];
            }
            CHECK(x[i] >= 0.0);
            CHECK(slope >= -1e-9);
            CHECK(fabs(slope * x[i]) <= 1e-8 * (1.0 + x[i]));
        }
    }
}

/* Units do not matter: unknowns that are a million times larger make equations that are as much smaller. */
static void units(void)
{
    const double a[4] = {2e12, 1e0, 1e0, 2e-12};
    const double b[2] = {-3e6, -3e-6};
    double x[2];
    solve(2, a, b, x);
    CHECK_NEAR(x[0], 1e-6, 1e-18);
    CHECK_NEAR(x[1], 1e6, 1e-6);
}

static void nothing_moves(void)
{
    const double a[4] = {0.0, 0.0, 0.0, 1.0};
    const double b[2] = {-1.0, -2.0};
    double x[2];
    solve(2, a, b, x);
    CHECK(x[0] == 0.0);
    CHECK_NEAR(x[1], 2.0, 1e-15);
}

int main(void)
{
    complementary();
    units();
    nothing_moves();
    (void)printf("nonnegative: ok\n");
    return EXIT_SUCCESS;
}
