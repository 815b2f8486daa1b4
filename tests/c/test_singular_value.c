/* Single singular values against those of lag/linalg/svd.h, which shares nothing with them, and against exact ones. */
#include "check.h"
#include "lag/linalg/singular_value.h"
#include "lag/linalg/svd.h"

enum { MOST = 12 };

static double memory[4000];
static double own[400];

/* A matrix whose last rows depend on the others where `rank` is below m. */
static void draw_matrix(size_t m, size_t n, size_t rank, unsigned long long *seed, double *a)
{
    for (size_t i = 0; i < m; ++i) {
        for (size_t j = 0; j < n; ++j) {
            a[i * n + j] = i < rank ? draw(seed) : a[(i - rank) * n + j] - 2.0 * a[(i % rank) * n + j];
        }
    }
}

static void agrees(size_t m, size_t n, const double *a)
{
    const size_t size = lag_singular_value_memory(m, n);
    CHECK(size < sizeof own / sizeof *own && lag_svd_memory(m, n) <= sizeof memory / sizeof *memory);
    const lag_svd svd = lag_svd_of(m, n, a, memory);
    own[size] = 12345.0;
    for (size_t i = 0; i < svd.k; ++i) {
        CHECK_NEAR(lag_singular_value(m, n, a, i, own), svd.value[i], 1e-14 * (1.0 + svd.value[0]));
    }
    CHECK(lag_singular_value(m, n, a, svd.k, own) == 0.0);
    CHECK(lag_singular_values_above(m, n, a, 1e-10, own) == lag_svd_rank(&svd, 1e-10 / svd.value[0]));
    CHECK(own[size] == 12345.0);
}

int main(void)
{
    unsigned long long seed = 5;
    double a[MOST * MOST];
    const double known[6] = {3.0, 0.0, 0.0, 0.0, -1e-9, 0.0};
    const double nothing[6] = {0.0};
    CHECK_NEAR(lag_singular_value(2, 3, known, 1, own), 1e-9, 1e-15);
    CHECK_NEAR(lag_singular_value(3, 2, known, 0, own), 3.0, 1e-14);
    CHECK(lag_singular_values_above(2, 3, known, 1e-10, own) == 2 && lag_singular_values_above(2, 3, known, 1e-8, own) == 1);
    CHECK(lag_singular_value(2, 3, nothing, 0, own) == 0.0 && lag_singular_values_above(2, 3, nothing, 1e-10, own) == 0);
    CHECK(lag_singular_value(0, 3, nothing, 0, own) == 0.0 && lag_singular_values_above(0, 3, nothing, 1e-10, own) == 0);
    for (size_t m = 1; m <= MOST; ++m) {
        for (size_t n = 1; n <= MOST; ++n) {
            const size_t least = m < n ? m : n;
            draw_matrix(m, n, m, &seed, a);
            agrees(m, n, a);
            draw_matrix(m, n, (least + 1) / 2, &seed, a);
            agrees(m, n, a);
        }
    }
    (void)printf("singular values: ok\n");
    return EXIT_SUCCESS;
}
