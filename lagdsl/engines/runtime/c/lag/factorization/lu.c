/* Source: Golub and Van Loan, Matrix Computations, 4th ed., algorithm 3.4.1 (outer products, partial pivoting). */
#include "lag/factorization/lu.h"

#include <math.h>
#include <string.h>

#include "lag/factorization/complex.h"

static void swap_rows(size_t width, double *a, size_t i, size_t j)
{
    for (size_t k = 0; k < width && i != j; ++k) {
        const double kept = a[i * width + k];
        a[i * width + k] = a[j * width + k];
        a[j * width + k] = kept;
    }
}

int lag_lu(size_t n, double *a, double *pivot)
{
    for (size_t k = 0; k < n; ++k) {
        size_t best = k;
        for (size_t i = k + 1; i < n; ++i) {
            best = fabs(a[i * n + k]) > fabs(a[best * n + k]) ? i : best;
        }
        swap_rows(n, a, k, best);
        pivot[k] = (double)best;
        if (!(fabs(a[k * n + k]) > 0.0)) {
            return 0;
        }
        for (size_t i = k + 1; i < n; ++i) {
            const double part = a[i * n + k] / a[k * n + k];
            a[i * n + k] = part;
            for (size_t j = k + 1; j < n && part != 0.0; ++j) {
                a[i * n + j] -= part * a[k * n + j];
            }
        }
    }
    return 1;
}

void lag_lu_solve(size_t n, const double *a, const double *pivot, double *x)
{
    for (size_t k = 0; k < n; ++k) {
        swap_rows(1, x, k, (size_t)pivot[k]);
    }
    for (size_t i = 0; i < n; ++i) {
        for (size_t j = 0; j < i; ++j) {
            x[i] -= a[i * n + j] * x[j];
        }
    }
    for (size_t i = n; i-- > 0;) {
        for (size_t j = i + 1; j < n; ++j) {
            x[i] -= a[i * n + j] * x[j];
        }
        x[i] /= a[i * n + i];
    }
}

int lag_lu_complex(size_t n, double *a, double *pivot)
{
    const size_t width = 2 * n;
    for (size_t k = 0; k < n; ++k) {
        size_t best = k;
        for (size_t i = k + 1; i < n; ++i) {
            best = lag_complex_size(a + i * width + 2 * k) > lag_complex_size(a + best * width + 2 * k) ? i : best;
        }
        swap_rows(width, a, k, best);
        pivot[k] = (double)best;
        const double *diagonal = a + k * width + 2 * k;
        if (!(lag_complex_size(diagonal) > 0.0)) {
            return 0;
        }
        for (size_t i = k + 1; i < n; ++i) {
            double *other = a + i * width;
            double part[2];
            lag_complex_divide(other + 2 * k, diagonal, part);
            memcpy(other + 2 * k, part, sizeof part);
            for (size_t j = lag_complex_size(part) != 0.0 ? k + 1 : n; j < n; ++j) {
                lag_complex_subtract_product(other + 2 * j, part, a + k * width + 2 * j);
            }
        }
    }
    return 1;
}

void lag_lu_complex_solve(size_t n, const double *a, const double *pivot, double *x)
{
    const size_t width = 2 * n;
    for (size_t k = 0; k < n; ++k) {
        swap_rows(2, x, k, (size_t)pivot[k]);
    }
    for (size_t i = 0; i < n; ++i) {
        for (size_t j = 0; j < i; ++j) {
            lag_complex_subtract_product(x + 2 * i, a + i * width + 2 * j, x + 2 * j);
        }
    }
    for (size_t i = n; i-- > 0;) {
        for (size_t j = i + 1; j < n; ++j) {
            lag_complex_subtract_product(x + 2 * i, a + i * width + 2 * j, x + 2 * j);
        }
        lag_complex_divide(x + 2 * i, a + i * width + 2 * i, x + 2 * i);
    }
}
