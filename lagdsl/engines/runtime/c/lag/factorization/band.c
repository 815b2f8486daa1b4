/*
 * Numbers are real, of one part, or complex, of two.
 *
 * Source: Golub and Van Loan, Matrix Computations, 4th ed., section 4.3.3 (band Gaussian elimination with partial pivoting); only exchanges
 * fill columns beyond the band (LAPACK's dgbtf2).
 */
#include "lag/factorization/band.h"

#include <math.h>
#include <string.h>

#include "lag/factorization/complex.h"

double lag_band_operations(const lag_band *band)
{
    return (double)band->n * (double)band->lower * (double)(band->lower + band->upper + 1);
}

static size_t least(size_t a, size_t b)
{
    return a < b ? a : b;
}

static inline double size_of(size_t parts, const double *z)
{
    return parts == 1 ? fabs(z[0]) : lag_complex_size(z);
}

static inline void exchange(size_t parts, double *a, double *b)
{
    for (size_t part = 0; part < parts; ++part) {
        const double kept = a[part];
        a[part] = b[part];
        b[part] = kept;
    }
}

static inline void invert(size_t parts, double *z)
{
    static const double one[2] = {1.0, 0.0};
    if (parts == 1) {
        z[0] = 1.0 / z[0];
    } else {
        lag_complex_divide(one, z, z);
    }
}

/* z *= factor */
static inline void multiply(size_t parts, double *z, const double *factor)
{
    double product[2] = {z[0] * factor[0], 0.0};
    if (parts == 2) {
        lag_complex_multiply(z, factor, product);
    }
    memcpy(z, product, parts * sizeof(double));
}

/* x -= column * factor, of so many rows. */
static inline void subtract(size_t parts, size_t rows, const double *restrict column, const double *factor, double *restrict x)
{
    const double by[2] = {factor[0], factor[parts - 1]};
    for (size_t i = 0; i < rows && parts == 1; ++i) {
        x[i] -= column[i] * by[0];
    }
    for (size_t i = 0; i < rows && parts == 2; ++i) {
        lag_complex_subtract_product(x + 2 * i, column + 2 * i, by);
    }
}

/* The row of the largest number of column k among those that elimination reaches, before `end`. */
static inline size_t largest_of(size_t parts, const double *column, size_t k, size_t end)
{
    size_t best = k;
    double largest = size_of(parts, column + parts * k);
    for (size_t i = k + 1; i < end; ++i) {
        const double size = size_of(parts, column + parts * i);
        best = size > largest ? i : best;
        largest = size > largest ? size : largest;
    }
    return best;
}

/* Column k becomes one of L, with the inverse of its diagonal. Returns the place behind its last number that is not zero; 0: there is no inverse. */
static inline size_t scale(size_t parts, double *column, size_t k, size_t end)
{
    double *diagonal = column + parts * k;
    size_t last = k + 1;
    invert(parts, diagonal);
    for (size_t i = k + 1; i < end; ++i) {
        multiply(parts, column + parts * i, diagonal);
        last = size_of(parts, column + parts * i) != 0.0 ? i + 1 : last;
    }
    return isfinite(size_of(parts, diagonal)) ? last : 0;
}

/* The numbers of column k become one of U, of which the numbers from `first` on count, and one of L. */
static inline void keep(size_t parts, const double *column, size_t first, size_t k, size_t last, double **upper, double **lower)
{
    const size_t above = parts * (k + 1 - first);
    const size_t below = parts * (last - k - 1);
    memcpy(*upper, column + parts * first, above * sizeof(double));
    memcpy(*lower, column + parts * (k + 1), below * sizeof(double));
    *upper += above;
    *lower += below;
}

static inline int lu(const lag_band *band, size_t parts, double *a, double *pivot, double *factors)
{
    double *below = pivot + band->n;
    double *above = below + band->n;
    double *upper = factors;
    double *lower = factors + lag_band_upper(band, parts);
    size_t end = 0;
    for (size_t k = 0; k < band->n; ++k) {
        above[k] = (double)k;
    }
    for (size_t k = 0; k < band->n; ++k) {
        double *column = lag_band_column(band, parts, a, k);
        const size_t rows = least(k + band->lower + 1, band->n);
        const size_t best = largest_of(parts, column, k, rows);
        const size_t own = least(best + band->upper + 1, band->n);
        end = own > end ? own : end;
        pivot[k] = (double)best;
        exchange(parts, column + parts * k, column + parts * best);
        const size_t last = scale(parts, column, k, rows);
        if (last == 0) {
            return 0;
        }
        below[k] = (double)last;
        for (size_t j = k + 1; j < end; ++j) {
            double *other = lag_band_column(band, parts, a, j);
            exchange(parts, other + parts * k, other + parts * best);
            if (size_of(parts, other + parts * k) != 0.0) {
                above[j] = fmin(above[j], (double)k);
                subtract(parts, last - k - 1, column + parts * (k + 1), other + parts * k, other + parts * (k + 1));
            }
        }
        keep(parts, column, (size_t)above[k], k, last, &upper, &lower);
    }
    pivot[3 * band->n] = (double)(upper - factors);
    return 1;
}

static inline void solve(const lag_band *band, size_t parts, const double *factors, const double *pivot, double *x)
{
    const double *below = pivot + band->n;
    const double *above = below + band->n;
    const double *lower = factors + lag_band_upper(band, parts);
    const double *upper = factors + (size_t)above[band->n];
    for (size_t k = 0; k < band->n; ++k) {
        const size_t count = (size_t)below[k] - k - 1;
        exchange(parts, x + parts * k, x + parts * (size_t)pivot[k]);
        subtract(parts, count, lower, x + parts * k, x + parts * (k + 1));
        lower += parts * count;
    }
    for (size_t k = band->n; k-- > 0;) {
        const size_t first = (size_t)above[k];
        upper -= parts * (k + 1 - first);
        multiply(parts, x + parts * k, upper + parts * (k - first));
        subtract(parts, k - first, upper, x + parts * k, x + parts * first);
    }
}

int lag_band_lu(const lag_band *band, double *a, double *pivot, double *factors)
{
    return lu(band, 1, a, pivot, factors);
}

void lag_band_solve(const lag_band *band, const double *factors, const double *pivot, double *x)
{
    solve(band, 1, factors, pivot, x);
}

int lag_band_lu_complex(const lag_band *band, double *a, double *pivot, double *factors)
{
    return lu(band, 2, a, pivot, factors);
}

void lag_band_solve_complex(const lag_band *band, const double *factors, const double *pivot, double *x)
{
    solve(band, 2, factors, pivot, x);
}
