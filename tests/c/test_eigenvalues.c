/* Real parts of eigenvalues of matrices that were made with known ones. */
#include "check.h"
#include "lag/linalg/eigenvalues.h"

enum { MOST = 9 };

static double arena[400];

/* a = X D X^-1 by elementary row and column operations; D has the real `value`s, and where `turning` two of them are a pair with the first as real part. */
static void similar(size_t n, const double *value, int turning, unsigned long long *seed, double *a)
{
    for (size_t i = 0; i < n * n; ++i) {
        a[i] = 0.0;
    }
    for (size_t i = 0; i < n; ++i) {
        a[i * n + i] = value[i];
    }
    if (turning) {
        a[n + 1] = value[0];
        a[1] = 2.0;
        a[n] = -2.0;
    }
    for (size_t k = 0; k < 3 * n; ++k) {
        const size_t i = (size_t)((1.0 + draw(seed)) * 0.4999 * (double)n);
        const size_t j = (size_t)((1.0 + draw(seed)) * 0.4999 * (double)n);
        const double factor = draw(seed);
        for (size_t l = 0; l < n && i != j; ++l) {
            a[i * n + l] += factor * a[j * n + l];
        }
        for (size_t l = 0; l < n && i != j; ++l) {
            a[l * n + j] -= factor * a[l * n + i];
        }
    }
}

int main(void)
{
    unsigned long long seed = 11;
    double a[MOST * MOST];
    double value[MOST];
    const double turn[9] = {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0}; /* thirds of a turn: 1 and a pair at -1/2 */
    CHECK(lag_eigenvalues_memory(MOST) <= sizeof arena / sizeof *arena);
    CHECK(lag_least_real_part(0, a, arena) == (double)INFINITY);
    CHECK_NEAR(lag_least_real_part(3, turn, arena), -0.5, 1e-14);
    for (size_t n = 1; n <= MOST; ++n) {
        for (int k = 0; k < 40; ++k) {
            double least = (double)INFINITY;
            const int turning = k % 2 == 1 && n > 1;
            for (size_t i = 0; i < n; ++i) {
                value[i] = 3.0 * draw(&seed);
                least = turning && i == 1 ? least : fmin(least, value[i]);
            }
            similar(n, value, turning, &seed, a);
            CHECK_NEAR(lag_least_real_part(n, a, arena), least, 1e-8);
        }
    }
    (void)printf("eigenvalues: ok\n");
    return EXIT_SUCCESS;
}
