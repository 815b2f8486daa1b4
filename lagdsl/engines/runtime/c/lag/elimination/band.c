/* Source: Golub and Van Loan, Matrix Computations, 4th ed., section 4.3.3 (band Gaussian elimination with partial pivoting). */
#include "lag/elimination/band.h"

#include <math.h>
#include <string.h>

#include "lag/elimination/complex.h"

double lag_band_operations(const lag_band *band)
{
    return (double)band->n * (double)band->lower * (double)(band->lower + band->upper + 1);
}

static size_t least(size_t a, size_t b)
{
    return a < b ? a : b;
}

/* Behind the last row that elimination of column k reaches. */
static size_t rows_end(const lag_band *band, size_t k)
{
    return least(k + band->lower + 1, band->n);
}

/* Behind the last column of U that is filled, once the row `best` was chosen: only exchanges fill what is beyond the band (LAPACK's dgbtf2). */
static size_t columns_end(const lag_band *band, size_t end, size_t best)
{
    const size_t own = lag_band_end(band, best);
    return own > end ? own : end;
}

static void exchange(double *a, double *b, size_t first, size_t end)
{
    for (size_t j = first; j < end && a != b; ++j) {
        const double kept = a[j];
        a[j] = b[j];
        b[j] = kept;
    }
}

int lag_band_lu(const lag_band *band, double *a, double *pivot)
{
    size_t end = 0;
    for (size_t k = 0; k < band->n; ++k) {
        double *row = lag_band_row(band, a, k);
        double largest = fabs(row[k]);
        size_t best = k;
        for (size_t i = k + 1; i < rows_end(band, k); ++i) {
            const double size = fabs(lag_band_row(band, a, i)[k]);
            best = size > largest ? i : best;
            largest = size > largest ? size : largest;
        }
        end = columns_end(band, end, best);
        exchange(row, lag_band_row(band, a, best), k, end);
        pivot[k] = (double)best;
        pivot[band->n + k] = (double)end;
        row[k] = 1.0 / row[k];
        if (!isfinite(row[k])) {
            return 0;
        }
        for (size_t i = k + 1; i < rows_end(band, k); ++i) {
            double *other = lag_band_row(band, a, i);
            const double part = other[k] * row[k];
            other[k] = part;
            for (size_t j = k + 1; j < end && part != 0.0; ++j) {
                other[j] -= part * row[j];
            }
        }
    }
    return 1;
}

void lag_band_solve(const lag_band *band, double *a, const double *pivot, double *x)
{
    for (size_t k = 0; k < band->n; ++k) {
        exchange(x + k, x + (size_t)pivot[k], 0, 1);
        const double part = x[k];
        for (size_t i = k + 1; i < rows_end(band, k); ++i) {
            x[i] -= lag_band_row(band, a, i)[k] * part;
        }
    }
    for (size_t i = band->n; i-- > 0;) {
        const double *row = lag_band_row(band, a, i);
        double rest = x[i];
        const size_t end = (size_t)pivot[band->n + i];
        for (size_t j = i + 1; j < end; ++j) {
            rest -= row[j] * x[j];
        }
        x[i] = rest * row[i];
    }
}

/* Row i of numbers of two doubles each, so that entry (i, j) is at 2 j. */
static double *row_of_pairs(const lag_band *band, double *a, size_t i)
{
    return a + 2 * (band->lower + i * (lag_band_width(band) - 1));
}

int lag_band_lu_complex(const lag_band *band, double *a, double *pivot)
{
    static const double one[2] = {1.0, 0.0};
    size_t end = 0;
    for (size_t k = 0; k < band->n; ++k) {
        double *row = row_of_pairs(band, a, k);
        double largest = lag_complex_size(row + 2 * k);
        size_t best = k;
        for (size_t i = k + 1; i < rows_end(band, k); ++i) {
            const double size = lag_complex_size(row_of_pairs(band, a, i) + 2 * k);
            best = size > largest ? i : best;
            largest = size > largest ? size : largest;
        }
        end = columns_end(band, end, best);
        exchange(row, row_of_pairs(band, a, best), 2 * k, 2 * end);
        pivot[k] = (double)best;
        pivot[band->n + k] = (double)end;
        lag_complex_divide(one, row + 2 * k, row + 2 * k);
        if (!isfinite(lag_complex_size(row + 2 * k))) {
            return 0;
        }
        for (size_t i = k + 1; i < rows_end(band, k); ++i) {
            double *other = row_of_pairs(band, a, i);
            double part[2];
            lag_complex_multiply(other + 2 * k, row + 2 * k, part);
            memcpy(other + 2 * k, part, sizeof part);
            for (size_t j = lag_complex_size(part) != 0.0 ? k + 1 : end; j < end; ++j) {
                lag_complex_subtract_product(other + 2 * j, part, row + 2 * j);
            }
        }
    }
    return 1;
}

void lag_band_solve_complex(const lag_band *band, double *a, const double *pivot, double *x)
{
    for (size_t k = 0; k < band->n; ++k) {
        exchange(x + 2 * k, x + 2 * (size_t)pivot[k], 0, 2);
        const double part[2] = {x[2 * k], x[2 * k + 1]};
        for (size_t i = k + 1; i < rows_end(band, k); ++i) {
            lag_complex_subtract_product(x + 2 * i, row_of_pairs(band, a, i) + 2 * k, part);
        }
    }
    for (size_t i = band->n; i-- > 0;) {
        const double *row = row_of_pairs(band, a, i);
        double rest[2] = {x[2 * i], x[2 * i + 1]};
        const size_t end = (size_t)pivot[band->n + i];
        for (size_t j = i + 1; j < end; ++j) {
            lag_complex_subtract_product(rest, row + 2 * j, x + 2 * j);
        }
        lag_complex_multiply(rest, row + 2 * i, x + 2 * i);
    }
}
