/* Elimination in a band against that of dense matrices. */
#include <math.h>
#include <stdlib.h>

#include "check.h"
#include "lag/factorization/band.h"
#include "lag/factorization/lu.h"

enum { MOST = 40 };

/* Columns of row i that are in the band. */
static size_t first_of(const lag_band *band, size_t i)
{
    return i > band->lower ? i - band->lower : 0;
}

static size_t end_of(const lag_band *band, size_t i)
{
    return i + band->upper + 1 < band->n ? i + band->upper + 1 : band->n;
}

/* Entry (i, j), of `parts` doubles, of a matrix in a band. */
static double *entry(const lag_band *band, double *a, size_t parts, size_t i, size_t j)
{
    return lag_band_column(band, parts, a, j) + parts * i;
}

/* Both eliminations give the solution that the right side was made of; small diagonals make rows change places. */
static void solutions_agree(size_t n, size_t lower, size_t upper, size_t parts, unsigned long long *seed)
{
    const lag_band band = {n, lower, upper};
    double *dense = calloc(parts * n * n, sizeof(double));
    double *narrow = calloc(lag_band_factors(&band, parts), sizeof(double));
    double *factors = calloc(lag_band_factors(&band, parts), sizeof(double));
    double right[2][2 * MOST];
    double pivot[3 * MOST + 1];
    for (size_t i = 0; i < n; ++i) {
        for (size_t j = first_of(&band, i); j < end_of(&band, i); ++j) {
            for (size_t part = 0; part < parts; ++part) {
                const double value = draw(seed) * (i == j ? 0.1 : 1.0);
                dense[parts * (i * n + j) + part] = value;
                entry(&band, narrow, parts, i, j)[part] = value;
            }
        }
        for (size_t part = 0; part < parts; ++part) {
            right[0][parts * i + part] = right[1][parts * i + part] = draw(seed);
        }
    }
    if (parts == 1) {
        CHECK(lag_lu(n, dense, pivot));
        lag_lu_solve(n, dense, pivot, right[0]);
        CHECK(lag_band_lu(&band, narrow, pivot, factors));
        lag_band_solve(&band, factors, pivot, right[1]);
    } else {
        CHECK(lag_lu_complex(n, dense, pivot));
        lag_lu_complex_solve(n, dense, pivot, right[0]);
        CHECK(lag_band_lu_complex(&band, narrow, pivot, factors));
        lag_band_solve_complex(&band, factors, pivot, right[1]);
    }
    double size = 0.0;
    for (size_t i = 0; i < parts * n; ++i) {
        size = fmax(size, fabs(right[0][i]));
    }
    for (size_t i = 0; i < parts * n; ++i) {
        CHECK(fabs(right[0][i] - right[1][i]) <= 1e-9 * size);
    }
    free(dense);
    free(narrow);
    free(factors);
}

static void a_singular_matrix_is_told(void)
{
    const lag_band band = {2, 1, 1};
    double a[8] = {0};
    double factors[16];
    double pivot[7];
    *entry(&band, a, 1, 0, 0) = *entry(&band, a, 1, 1, 0) = 1.0;
    *entry(&band, a, 1, 0, 1) = *entry(&band, a, 1, 1, 1) = 2.0;
    CHECK(!lag_band_lu(&band, a, pivot, factors));
    double pairs[16] = {0};
    *entry(&band, pairs, 2, 0, 0) = *entry(&band, pairs, 2, 1, 0) = 1.0;
    CHECK(!lag_band_lu_complex(&band, pairs, pivot, factors));
}

/* A number that is zero at the end of a column of the matrix, or before all of it, is no part of the factors; an exchange brings numbers of its row. */
static void only_exchanges_fill(void)
{
    const lag_band band = {6, 2, 1};
    for (size_t parts = 1; parts <= 2; ++parts) {
        double a[2 * 6 * 6] = {0};
        double factors[2 * 6 * 6];
        double pivot[19];
        for (size_t i = 0; i < band.n; ++i) {
            for (size_t j = first_of(&band, i); j < end_of(&band, i); ++j) {
                *entry(&band, a, parts, i, j) = i == j ? 8.0 : 1.0;
            }
        }
        *entry(&band, a, parts, 2, 0) = 0.0;
        *entry(&band, a, parts, 3, 2) = 100.0;
        CHECK(parts == 1 ? lag_band_lu(&band, a, pivot, factors) : lag_band_lu_complex(&band, a, pivot, factors));
        const double *below = pivot + band.n;
        const double *above = below + band.n;
        for (size_t k = 0; k <= 4; ++k) {
            CHECK(k > 2 || pivot[k] == (k == 2 ? 3.0 : (double)k));
            CHECK(above[k] == (double)(k == 0 ? 0 : k == 4 ? 2 : k - 1));
        }
        CHECK(below[0] == 2.0);
        CHECK(below[1] == 4.0);
    }
}

int main(void)
{
    unsigned long long seed = 1;
    for (size_t n = 4; n <= MOST; n += 3) {
        for (size_t lower = 1; lower < n; lower = 2 * lower + 1) {
            solutions_agree(n, lower, 1 + (3 * lower) % (n - 1), 1, &seed);
            solutions_agree(n, lower, 1 + (3 * lower) % (n - 1), 2, &seed);
        }
    }
    a_singular_matrix_is_told();
    only_exchanges_fill();
    (void)printf("band: ok\n");
    return 0;
}
