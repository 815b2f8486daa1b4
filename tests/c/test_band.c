/* Elimination in a band against that of dense matrices, and orders of graphs of which the least band is known. */
#include <math.h>
#include <stdlib.h>

#include "check.h"
#include "lag/elimination/band.h"
#include "lag/elimination/lu.h"

enum { MOST = 40 };

/* Numbers 0 to n - 1 in another order. */
static void shuffle(size_t n, size_t *name, unsigned long long *seed)
{
    for (size_t i = 0; i < n; ++i) {
        name[i] = i;
    }
    for (size_t i = n; i-- > 1;) {
        const size_t other = (size_t)fabs(draw(seed) * 1e6) % (i + 1);
        const size_t kept = name[i];
        name[i] = name[other];
        name[other] = kept;
    }
}

static lag_band ordered(size_t n, const double *a, double *order)
{
    static double memory[MOST * MOST + 2 * MOST + 1];
    double place[MOST];
    int seen[MOST] = {0};
    CHECK(lag_cuthill_mckee_memory(n) <= sizeof memory / sizeof *memory);
    lag_cuthill_mckee(n, a, order, memory);
    const lag_band band = lag_band_of(n, a, order, place);
    for (size_t k = 0; k < n; ++k) {
        CHECK(seen[(size_t)order[k]]++ == 0);
        CHECK((size_t)place[(size_t)order[k]] == k);
    }
    return band;
}

/* A ladder of two rails: its least band is 2. One triangle of the matrix tells the graph. */
static void a_ladder_has_its_least_band(void)
{
    enum { RUNGS = 20, N = 2 * RUNGS };
    unsigned long long seed = 3;
    double a[N * N] = {0};
    double order[N];
    size_t name[N];
    shuffle(N, name, &seed);
    for (size_t i = 0; i < RUNGS; ++i) {
        a[name[2 * i] * N + name[2 * i + 1]] = 1.0;
        for (size_t side = 0; side < 2 && i > 0; ++side) {
            a[name[2 * i + side] * N + name[2 * i - 2 + side]] = 1.0;
        }
    }
    const lag_band band = ordered(N, a, order);
    CHECK(band.lower <= 2 && band.upper <= 2 && band.lower + band.upper >= 2);
}

/* Chains that do not touch, and rows alone: the band is that of a chain. */
static void parts_are_ordered_by_themselves(void)
{
    enum { N = 24, CHAIN = 8 };
    unsigned long long seed = 5;
    double a[N * N] = {0};
    double order[N];
    size_t name[N];
    shuffle(N, name, &seed);
    for (size_t i = 1; i < N; ++i) {
        a[name[i] * N + name[i - 1]] = i % CHAIN != 0 && i < 2 * CHAIN ? 2.0 : 0.0;
    }
    const lag_band band = ordered(N, a, order);
    CHECK(band.lower <= 1 && band.upper <= 1);
}

/* Entry (i, j), of `parts` doubles, of a matrix in a band. */
static double *entry(const lag_band *band, double *a, size_t parts, size_t i, size_t j)
{
    return a + parts * (i * lag_band_width(band) + band->lower + j - i);
}

/* Both eliminations give the solution that the right side was made of; small diagonals make rows change places. */
static void solutions_agree(size_t n, size_t lower, size_t upper, size_t parts, unsigned long long *seed)
{
    const lag_band band = {n, lower, upper};
    double *dense = calloc(parts * n * n, sizeof(double));
    double *narrow = calloc(parts * n * lag_band_width(&band), sizeof(double));
    double right[2][2 * MOST];
    double pivot[MOST];
    for (size_t i = 0; i < n; ++i) {
        for (size_t j = lag_band_first(&band, i); j < lag_band_end(&band, i); ++j) {
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
        CHECK(lag_band_lu(&band, narrow, pivot));
        lag_band_solve(&band, narrow, pivot, right[1]);
    } else {
        CHECK(lag_lu_complex(n, dense, pivot));
        lag_lu_complex_solve(n, dense, pivot, right[0]);
        CHECK(lag_band_lu_complex(&band, narrow, pivot));
        lag_band_solve_complex(&band, narrow, pivot, right[1]);
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
}

static void a_singular_matrix_is_told(void)
{
    const lag_band band = {2, 1, 1};
    double a[8] = {0};
    double pivot[2];
    *entry(&band, a, 1, 0, 0) = *entry(&band, a, 1, 1, 0) = 1.0;
    *entry(&band, a, 1, 0, 1) = *entry(&band, a, 1, 1, 1) = 2.0;
    CHECK(!lag_band_lu(&band, a, pivot));
    double pairs[16] = {0};
    *entry(&band, pairs, 2, 0, 0) = *entry(&band, pairs, 2, 1, 0) = 1.0;
    CHECK(!lag_band_lu_complex(&band, pairs, pivot));
}

int main(void)
{
    unsigned long long seed = 1;
    a_ladder_has_its_least_band();
    parts_are_ordered_by_themselves();
    for (size_t n = 4; n <= MOST; n += 3) {
        for (size_t lower = 1; lower < n; lower = 2 * lower + 1) {
            solutions_agree(n, lower, 1 + (3 * lower) % (n - 1), 1, &seed);
            solutions_agree(n, lower, 1 + (3 * lower) % (n - 1), 2, &seed);
        }
    }
    a_singular_matrix_is_told();
    (void)printf("band: ok\n");
    return 0;
}
