#include "lag/linalg/linalg.h"

#include <float.h>
#include <math.h>

/* Column of the first entry of row i of a lower triangle that is not zero; i where there is none. */
static size_t first_entry(const double *row, size_t i)
{
    size_t k = 0;
    while (k < i && row[k] == 0.0) {
        ++k;
    }
    return k;
}

size_t lag_cholesky(size_t n, double *a, double tolerance)
{
    for (size_t j = 0; j < n; ++j) {
        double *row = a + j * n;
        double pivot = row[j];
        const size_t first = first_entry(row, j); /* factors have no entries left of those of the matrix */
        for (size_t k = first; k < j; ++k) {
            pivot -= row[k] * row[k];
        }
        if (!(pivot > tolerance)) {
            return j;
        }
        row[j] = sqrt(pivot);
        for (size_t i = j + 1; i < n; ++i) {
            double sum = a[i * n + j];
            for (size_t k = first; k < j; ++k) {
                sum -= a[i * n + k] * row[k];
            }
            a[i * n + j] = sum / row[j];
        }
    }
    return n;
}

void lag_cholesky_solve(size_t n, const double *factor, double *x)
{
    for (size_t i = 0; i < n; ++i) {
        for (size_t k = 0; k < i; ++k) {
            x[i] -= factor[i * n + k] * x[k];
        }
        x[i] /= factor[i * n + i];
    }
    for (size_t i = n; i-- > 0;) {
        x[i] /= factor[i * n + i];
        for (size_t k = 0; k < i; ++k) {
            x[k] -= factor[i * n + k] * x[i];
        }
    }
}

/* The rotation that makes a[p][q] zero, applied to both sides of a and to the columns of v. */
static void rotate(size_t n, double *a, double *v, size_t p, size_t q)
{
    const double half = 0.5 * (a[q * n + q] - a[p * n + p]) / a[p * n + q];
    const double tangent = (half >= 0.0 ? 1.0 : -1.0) / (fabs(half) + hypot(1.0, half));
    const double c = 1.0 / hypot(1.0, tangent);
    const double s = c * tangent;
    for (size_t k = 0; k < n; ++k) {
        const double x = a[k * n + p];
        const double y = a[k * n + q];
        a[k * n + p] = c * x - s * y;
        a[k * n + q] = s * x + c * y;
    }
    for (size_t k = 0; k < n; ++k) {
        const double x = a[p * n + k];
        const double y = a[q * n + k];
        a[p * n + k] = c * x - s * y;
        a[q * n + k] = s * x + c * y;
    }
    for (size_t k = 0; k < n; ++k) {
        const double x = v[k * n + p];
        const double y = v[k * n + q];
        v[k * n + p] = c * x - s * y;
        v[k * n + q] = s * x + c * y;
    }
}

void lag_symmetric_eigen(size_t n, double *a, double *value, double *v)
{
    enum { MOST_SWEEPS = 60 };
    double size = 0.0;
    for (size_t i = 0; i < n * n; ++i) {
        v[i] = 0.0;
        size = fmax(size, fabs(a[i]));
    }
    for (size_t i = 0; i < n; ++i) {
        v[i * n + i] = 1.0;
    }
    for (int sweep = 0; sweep < MOST_SWEEPS; ++sweep) {
        int rotated = 0;
        for (size_t p = 0; p + 1 < n; ++p) {
            for (size_t q = p + 1; q < n; ++q) {
                if (fabs(a[p * n + q]) > 0.5 * DBL_EPSILON * size) {
                    rotate(n, a, v, p, q);
                    rotated = 1;
                }
            }
        }
        if (!rotated) {
            break;
        }
    }
    for (size_t i = 0; i < n; ++i) {
        value[i] = a[i * n + i];
    }
}

static double norm_from(size_t start, size_t n, const double *row)
{
    double sum = 0.0;
    for (size_t j = start; j < n; ++j) {
        sum += row[j] * row[j];
    }
    return sqrt(sum);
}

static void swap_rows(size_t n, double *first, double *second)
{
    for (size_t j = 0; j < n; ++j) {
        const double kept = first[j];
        first[j] = second[j];
        second[j] = kept;
    }
}

/* One behind the last entry of v from `start` to n that is not zero. */
static size_t end_of(size_t start, size_t n, const double *v)
{
    while (n > start && v[n - 1] == 0.0) {
        --n;
    }
    return n;
}

/* x := x - tau v (v' x), over entries `start` to n of x. */
static void reflect(size_t start, size_t n, const double *v, double tau, double *x, size_t stride)
{
    double sum = 0.0;
    for (size_t j = start; j < n; ++j) {
        sum += v[j] * x[j * stride];
    }
    sum *= tau;
    for (size_t j = start; j < n; ++j) {
        x[j * stride] -= sum * v[j];
    }
}

size_t lag_qr(size_t m, size_t n, double *a, double *tau, double *diagonal, double *pivot, size_t most, double tolerance)
{
    const size_t least = m < n ? m : n;
    const size_t count = most < least ? most : least;
    for (size_t i = 0; i < m; ++i) {
        pivot[i] = (double)i;
    }
    for (size_t k = 0; k < count; ++k) {
        size_t longest = k;
        double length = 0.0;
        for (size_t i = k; i < m; ++i) {
            const double own = norm_from(k, n, a + i * n);
            if (own > length) {
                length = own;
                longest = i;
            }
        }
        if (!(length > 0.0) || (k > 0 && length <= tolerance * fabs(diagonal[0]))) {
            return k;
        }
        double *row = a + k * n;
        if (longest != k) {
            swap_rows(n, row, a + longest * n);
            swap_rows(1, pivot + k, pivot + longest);
        }
        diagonal[k] = row[k] > 0.0 ? -length : length;
        row[k] -= diagonal[k];
        tau[k] = -1.0 / (diagonal[k] * row[k]);
        const size_t end = end_of(k, n, row);
        for (size_t i = k + 1; i < m; ++i) {
            reflect(k, end, row, tau[k], a + i * n, 1);
        }
    }
    return count;
}

void lag_qr_apply(size_t rank, size_t n, const double *a, const double *tau, double *x, size_t stride)
{
    for (size_t k = rank; k-- > 0;) {
        reflect(k, n, a + k * n, tau[k], x, stride);
    }
}

void lag_qr_apply_transposed(size_t rank, size_t n, const double *a, const double *tau, double *x, size_t stride)
{
    for (size_t k = 0; k < rank; ++k) {
        reflect(k, n, a + k * n, tau[k], x, stride);
    }
}

void lag_qr_apply_to_columns(size_t rank, size_t n, const double *a, const double *tau, size_t count, double *x)
{
    for (size_t k = 0; k < rank; ++k) {
        const double *v = a + k * n;
        const size_t end = end_of(k, n, v);
        for (size_t j = 0; j < count; ++j) {
            reflect(k, end, v, tau[k], x + j, count);
        }
    }
}

void lag_qr_apply_to_rows(size_t rank, size_t n, const double *a, const double *tau, size_t count, double *x)
{
    for (size_t k = 0; k < rank; ++k) {
        const double *v = a + k * n;
        const size_t end = end_of(k, n, v);
        for (size_t i = 0; i < count; ++i) {
            reflect(k, end, v, tau[k], x + i * n, 1);
        }
    }
}

void lag_remove_parts(size_t count, size_t m, const double *basis, double *x)
{
    for (size_t k = 0; k < count; ++k) {
        const double *direction = basis + k * m;
        double part = 0.0;
        for (size_t i = 0; i < m; ++i) {
            part += direction[i] * x[i];
        }
        for (size_t i = 0; i < m; ++i) {
            x[i] -= part * direction[i];
        }
    }
}

static void normalize(size_t m, double *x)
{
    const double length = norm_from(0, m, x);
    for (size_t i = 0; i < m; ++i) {
        x[i] /= length;
    }
}

void lag_orthonormalize(size_t count, size_t m, const double *basis, double *x)
{
    normalize(m, x);
    for (int again = 0; again < 2; ++again) {
        lag_remove_parts(count, m, basis, x);
        normalize(m, x);
    }
}
