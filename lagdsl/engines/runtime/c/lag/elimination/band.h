/*
 * Square matrices whose nonzero entries lie near the diagonal once rows and columns are put into another order: the order, and
 * Gaussian elimination with partial pivoting within the band, real and complex.
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

/* Doubles that lag_cuthill_mckee() works in. */
size_t lag_cuthill_mckee_memory(size_t n);

/*
 * The reverse order of Cuthill and McKee into `order` (n), row numbers as doubles, for the pattern of the nonzero entries of a (n, n) and
 * of its transpose. Every connected part begins at a row that is far from some other.
 *
 * Source: Cuthill and McKee, Reducing the bandwidth of sparse symmetric matrices, Proc. 24th Nat. Conf. ACM (1969) 157; reversed, and the
 * first row: George and Liu, Computer Solution of Large Sparse Positive Definite Systems (1981), sections 4.2 and 4.3.
 */
void lag_cuthill_mckee(size_t n, const double *a, double *order, double *memory);

/* The band of a (n, n) in this order; place (n): that of each row. */
lag_band lag_band_of(size_t n, const double *a, const double *order, double *place);

/* Multiplications of the elimination in a band; those of a dense matrix are n^3 / 3. */
double lag_band_operations(const lag_band *band);

/*
 * As lag_lu() and what follows it in lag/elimination/lu.h, in a band; of L only the row that moves is exchanged, and the diagonal of U is
 * inverted.
 */
int lag_band_lu(const lag_band *band, double *a, double *pivot);
void lag_band_solve(const lag_band *band, double *a, const double *pivot, double *x);
int lag_band_lu_complex(const lag_band *band, double *a, double *pivot);
void lag_band_solve_complex(const lag_band *band, double *a, const double *pivot, double *x);

#endif
