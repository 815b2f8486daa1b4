/*
 * Square matrices whose nonzero entries lie near the diagonal: Gaussian elimination with partial pivoting within the band, real and
 * complex.
 *
 * Column j of a matrix in a band holds the rows j - lower - upper to j + lower: exchanges of rows fill the first `lower` of them, which
 * are zero at first. Decomposition and solution go along columns, whose numbers stand side by side.
 */
#ifndef LAG_BAND_H
#define LAG_BAND_H

#include <stddef.h>

typedef struct lag_band {
    size_t n, lower, upper;
} lag_band;

/* Numbers of a column. */
static inline size_t lag_band_height(const lag_band *band)
{
    return 2 * band->lower + band->upper + 1;
}

/* Column j of `a` (n, height), of numbers of so many parts, so that entry (i, j) is at parts * i. */
static inline double *lag_band_column(const lag_band *band, size_t parts, double *a, size_t j)
{
    return a + parts * (band->lower + band->upper + j * (lag_band_height(band) - 1));
}

/* Multiplications of the elimination in a band, at most; those of a dense matrix are n^3 / 3. */
double lag_band_operations(const lag_band *band);

/* Doubles of U, of numbers of so many parts, with room for what exchanges fill; behind it those of L, and so of both. */
static inline size_t lag_band_upper(const lag_band *band, size_t parts)
{
    return parts * band->n * (band->lower + band->upper + 1);
}

static inline size_t lag_band_factors(const lag_band *band, size_t parts)
{
    return parts * band->n * lag_band_height(band);
}

/*
 * As lag_lu() and what follows it in lag/factorization/lu.h, in a band; `a` is written over, and the diagonal of U inverted.
 *
 * `pivot` (3 n + 1) has the rows; of each column of L the place behind its last number that is not zero; of each column of U the place of its first;
 * the doubles of U. `factors` has the columns of U and of L without what lies beyond, one behind the other: solutions read them as they lie in memory.
 */
int lag_band_lu(const lag_band *band, double *a, double *pivot, double *factors);
void lag_band_solve(const lag_band *band, const double *factors, const double *pivot, double *x);
int lag_band_lu_complex(const lag_band *band, double *a, double *pivot, double *factors);
void lag_band_solve_complex(const lag_band *band, const double *factors, const double *pivot, double *x);

#endif
