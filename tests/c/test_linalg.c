#include <string.h>

#include "check.h"
#include "lag/linalg/linalg.h"

enum { MOST = 12 };

/* a := B'B + shift, positive definite. */
static void draw_definite(size_t n, double *a, unsigned long long *seed)
{
    double b[MOST * MOST];
    for (size_t i = 0; i < n * n; ++i) {
        b[i] = draw(seed);
    }
    for (size_t i = 0; i < n; ++i) {
        for (size_t j = 0; j < n; ++j) {
            a[i * n + j] = i == j ? 0.1 : 0.0;
            for (size_t k = 0; k < n; ++k) {
                a[i * n + j] += b[k * n + i] * b[k * n + j];
            }
        }
    }
}

static void cholesky_solves(void)
{
    unsigned long long seed = 1;
    for (size_t n = 1; n <= MOST; ++n) {
        double a[MOST * MOST];
        double factor[MOST * MOST];
        double x[MOST];
        double b[MOST];
        draw_definite(n, a, &seed);
        memcpy(factor, a, sizeof a);
        for (size_t i = 0; i < n; ++i) {
            b[i] = x[i] = draw(&seed);
        }
        CHECK(lag_cholesky(n, factor, 0.0) == n);
        lag_cholesky_solve(n, factor, x);
        for (size_t i = 0; i < n; ++i) {
            double sum = 0.0;
            for (size_t j = 0; j < n; ++j) {
                sum += a[i * n + j] * x[j];
            }
            CHECK_NEAR(sum, b[i], 1e-12);
        }
    }
}

static void cholesky_stops_at_the_first_bad_pivot(void)
{
    double indefinite[9] = {4.0, 2.0, 0.0, 2.0, 1.0, 0.0, 0.0, 0.0, 1.0};
    double unknown[1] = {(double)NAN};
    CHECK(lag_cholesky(3, indefinite, 1e-14) == 1);
    CHECK(lag_cholesky(1, unknown, 0.0) == 0);
    CHECK(lag_cholesky(0, unknown, 0.0) == 0);
}

static void eigenvectors_diagonalize(void)
{
    unsigned long long seed = 2;
    for (size_t n = 1; n <= MOST; ++n) {
        double a[MOST * MOST];
        double kept[MOST * MOST];
        double v[MOST * MOST];
        double value[MOST];
        draw_definite(n, a, &seed);
        a[0] -= 3.0; /* indefinite as well */
        memcpy(kept, a, sizeof a);
        lag_symmetric_eigen(n, a, value, v);
        for (size_t k = 0; k < n; ++k) {
            double length = 0.0;
            for (size_t i = 0; i < n; ++i) {
                double sum = 0.0;
                length += v[i * n + k] * v[i * n + k];
                for (size_t j = 0; j < n; ++j) {
                    sum += kept[i * n + j] * v[j * n + k];
                }
                CHECK_NEAR(sum, value[k] * v[i * n + k], 1e-13 * (double)(n * n));
            }
            CHECK_NEAR(length, 1.0, 1e-13);
        }
    }
}

static void eigenvalues_of_a_known_matrix(void)
{
    /* second differences: 2 - 2 cos(k pi / (n + 1)) */
    double a[9] = {2.0, -1.0, 0.0, -1.0, 2.0, -1.0, 0.0, -1.0, 2.0};
    double value[3];
    double v[9];
    lag_symmetric_eigen(3, a, value, v);
    const double smallest = fmin(value[0], fmin(value[1], value[2]));
    const double largest = fmax(value[0], fmax(value[1], value[2]));
    CHECK_NEAR(smallest, 2.0 - sqrt(2.0), 5e-15);
    CHECK_NEAR(largest, 2.0 + sqrt(2.0), 5e-15);
}

/* Q R = A' P column by column. */
static void qr_gives_back(size_t m, size_t n)
{
    unsigned long long seed = 3 + 100 * m + n;
    double a[MOST * MOST];
    double kept[MOST * MOST];
    double tau[MOST];
    double diagonal[MOST];
    double pivot[MOST];
    for (size_t i = 0; i < m * n; ++i) {
        kept[i] = a[i] = draw(&seed);
    }
    const size_t rank = lag_qr(m, n, a, tau, diagonal, pivot, m, 1e-12);
    CHECK(rank == (m < n ? m : n));
    for (size_t i = 0; i < m; ++i) {
        double column[MOST] = {0.0};
        for (size_t j = 0; j < rank && j <= i; ++j) {
            column[j] = j == i ? diagonal[i] : a[i * n + j];
        }
        lag_qr_apply(rank, n, a, tau, column, 1);
        for (size_t j = 0; j < n; ++j) {
            CHECK_NEAR(column[j], kept[(size_t)pivot[i] * n + j], 1e-14 * (double)(m + n));
        }
        lag_qr_apply_transposed(rank, n, a, tau, column, 1);
        CHECK_NEAR(column[0], i == 0 ? diagonal[0] : a[i * n], 1e-14 * (double)(m + n));
    }
}

static void qr_finds_the_rank(void)
{
    double tau[3];
    double diagonal[3];
    double pivot[3];
    double dependent[9] = {1.0, 2.0, 3.0, 2.0, 4.0, 6.0, 0.0, 1.0, 0.0};
    CHECK(lag_qr(3, 3, dependent, tau, diagonal, pivot, 3, 1e-12) == 2);
    double zero[4] = {0.0, 0.0, 0.0, 0.0};
    CHECK(lag_qr(2, 2, zero, tau, diagonal, pivot, 2, 1e-12) == 0);
    double bounded[4] = {1.0, 0.0, 0.0, 2.0};
    CHECK(lag_qr(2, 2, bounded, tau, diagonal, pivot, 1, 1e-12) == 1);
    CHECK(pivot[0] > 0.5); /* the longer row came first */
}

int main(void)
{
    cholesky_solves();
    cholesky_stops_at_the_first_bad_pivot();
    eigenvectors_diagonalize();
    eigenvalues_of_a_known_matrix();
    for (size_t m = 1; m <= MOST; ++m) {
        for (size_t n = 1; n <= MOST; ++n) {
            qr_gives_back(m, n);
        }
    }
    qr_finds_the_rank();
    (void)printf("linalg: ok\n");
    return EXIT_SUCCESS;
}
