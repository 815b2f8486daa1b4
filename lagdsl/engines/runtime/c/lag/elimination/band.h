/*
 * Square matrices whose nonzero entries lie near the diagonal: Gaussian elimination with partial pivoting within the band, real and
 * complex.
 *
 * Row i of a matrix in a band holds the columns i - lower to i + lower + upper: exchanges of rows fill the last `lower` of them, which
 * are zero at first.
 */
#ifndef LAG_BAND_H
#define LAG_BAND_H

#include <stddef.h>

typedef struct lag_band {
    size_t n, lower, upper;
} lag_band;

/* Numbers of a row. */
static inline size_t lag_band_width(const lag_band *band)
{
    return 2 * band->lower + band->upper + 1;
}

/* Row i of `a` (n, width), so that entry (i, j) is [j]. */
static inline double *lag_band_row(const lag_band *band, double *a, size_t i)
{
    return a + band->lower + i * (lag_band_width(band) - 1);
}

static inline size_t lag_band_first(const lag_band *band, size_t i)
{
    return i > band->lower ? i - band->lower : 0;
}

/* Behind the last column of row i. */
static inline size_t lag_band_end(const lag_band *band, size_t i)
{
    return i + band->upper + 1 < band->n ? i + band->upper + 1 : band->n;
}

/* Multiplications of the elimination in a band, at most; those of a dense matrix are n^3 / 3. */
double lag_band_operations(const lag_band *band);

/*
 * As lag_lu() and what follows it in lag/elimination/lu.h, in a band; of L only the row that moves is exchanged, and the diagonal of U is
 * inverted. `pivot` (2 n) has the rows, then of each row of U the place behind its last column: nothing beyond is read.
 */
int lag_band_lu(const lag_band *band, double *a, double *pivot);
void lag_band_solve(const lag_band *band, double *a, const double *pivot, double *x);
int lag_band_lu_complex(const lag_band *band, double *a, double *pivot);
void lag_band_solve_complex(const lag_band *band, double *a, const double *pivot, double *x);

#endif
