#include "lag/linalg/svd.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "lag/linalg/linalg.h"
#include "lag/linalg/arena.h"

enum { MOST_SWEEPS = 60 };

static size_t smaller(size_t a, size_t b)
{
    return a < b ? a : b;
}

size_t lag_svd_memory(size_t m, size_t n)
{
    const size_t k = smaller(m, n);
    return 3 * k + k * m + n * n + m * n + m + k * k;
}

/* Four sums wait for each other less than one. */
static double product(size_t n, const double *a, const double *b)
{
    double w = 0.0, x = 0.0, y = 0.0, z = 0.0;
    size_t i = 0;
    for (; i + 3 < n; i += 4) {
        w += a[i] * b[i];
        x += a[i + 1] * b[i + 1];
        y += a[i + 2] * b[i + 2];
        z += a[i + 3] * b[i + 3];
    }
    for (; i < n; ++i) {
        w += a[i] * b[i];
    }
    return (w + x) + (y + z);
}

static void turn(size_t n, double c, double s, double *a, double *b)
{
    for (size_t i = 0; i < n; ++i) {
        const double x = a[i];
        const double y = b[i];
        a[i] = c * x - s * y;
        b[i] = s * x + c * y;
    }
}

/* Rows of `u` (k, m) become orthogonal by rotations, which `turned` (k, k) goes through, too; `square` (k): of their lengths. */
static void orthogonalize(size_t k, size_t m, double *u, double *turned, double *square)
{
    int rotated = 1;
    for (size_t p = 0; p < k; ++p) {
        square[p] = product(m, u + p * m, u + p * m);
    }
    for (int sweep = 0; sweep < MOST_SWEEPS && rotated; ++sweep) {
        rotated = 0;
        for (size_t p = 0; p + 1 < k; ++p) {
            for (size_t q = p + 1; q < k; ++q) {
                const double a = square[p];
                const double b = square[q];
                const double both = product(m, u + p * m, u + q * m);
                if (!(fabs(both) > DBL_EPSILON * sqrt(a) * sqrt(b)) || !(fabs(both) > DBL_MIN)) {
                    continue;
                }
                const double half = 0.5 * (b - a) / both;
                const double tangent = (half >= 0.0 ? 1.0 : -1.0) / (fabs(half) + hypot(1.0, half));
                const double c = 1.0 / hypot(1.0, tangent);
                turn(m, c, c * tangent, u + p * m, u + q * m);
                turn(k, c, c * tangent, turned + p * k, turned + q * k);
                square[p] = product(m, u + p * m, u + p * m);
                square[q] = product(m, u + q * m, u + q * m);
                rotated = 1;
            }
        }
    }
}

static void swap(size_t n, double *a, double *b)
{
    for (size_t i = 0; i < n && a != b; ++i) {
        const double kept = a[i];
        a[i] = b[i];
        b[i] = kept;
    }
}

/* Lengths of the rows of u become values, in descending order. */
static void sort(lag_svd *svd)
{
    const size_t k = svd->k;
    for (size_t i = 0; i < k; ++i) {
        double *u = svd->u + i * svd->m;
        svd->value[i] = sqrt(product(svd->m, u, u));
        for (size_t j = 0; j < svd->m; ++j) {
            u[j] = svd->value[i] > 0.0 ? u[j] / svd->value[i] : 0.0;
        }
    }
    for (size_t i = 0; i < k; ++i) {
        size_t most = i;
        for (size_t j = i + 1; j < k; ++j) {
            most = svd->value[j] > svd->value[most] ? j : most;
        }
        swap(1, svd->value + i, svd->value + most);
        swap(svd->m, svd->u + i * svd->m, svd->u + most * svd->m);
        swap(k, svd->turned + i * k, svd->turned + most * k);
    }
}

/* Row i of v is Q times the rotated unit vector; beyond k the unit vector itself. */
static void right_vectors(lag_svd *svd, size_t rank)
{
    const size_t n = svd->n;
    const size_t k = svd->k;
    for (size_t i = 0; i < n; ++i) {
        double *v = svd->v + i * n;
        memset(v, 0, n * sizeof(double));
        if (i < k) {
            memcpy(v, svd->turned + i * k, k * sizeof(double));
        } else {
            v[i] = 1.0;
        }
        lag_qr_apply(rank, n, svd->factors, svd->tau, v, 1);
    }
}

lag_svd lag_svd_of(size_t m, size_t n, const double *a, double *memory)
{
    lag_svd svd;
    const size_t k = smaller(m, n);
    svd.m = m;
    svd.n = n;
    svd.k = k;
    svd.value = lag_take(&memory, k);
    svd.u = lag_take(&memory, k * m);
    svd.v = lag_take(&memory, n * n);
    svd.factors = lag_take(&memory, m * n);
    svd.tau = lag_take(&memory, k);
    svd.diagonal = lag_take(&memory, k);
    svd.pivot = lag_take(&memory, m);
    svd.turned = memory;
    if (m * n > 0) {
        memcpy(svd.factors, a, m * n * sizeof(double));
    }
    const size_t rank = lag_qr(m, n, svd.factors, svd.tau, svd.diagonal, svd.pivot, k, 0.0);
    lag_fill(k * m, 0.0, svd.u);
    lag_fill(k * k, 0.0, svd.turned);
    for (size_t i = 0; i < k; ++i) {
        svd.turned[i * k + i] = 1.0;
    }
    for (size_t i = 0; i < m; ++i) { /* what came from row pivot[i] of A is column i of R */
        const size_t row = (size_t)svd.pivot[i];
        for (size_t j = 0; j < rank && j <= i; ++j) {
            svd.u[j * m + row] = j == i ? svd.diagonal[i] : svd.factors[i * n + j];
        }
    }
    orthogonalize(k, m, svd.u, svd.turned, svd.value);
    sort(&svd);
    right_vectors(&svd, rank);
    return svd;
}

size_t lag_svd_rank(const lag_svd *svd, double tolerance)
{
    size_t rank = 0;
    while (rank < svd->k && svd->value[rank] > 0.0 && svd->value[rank] > tolerance * svd->value[0]) {
        ++rank;
    }
    return rank;
}

void lag_svd_solve(const lag_svd *svd, const double *right, double tolerance, double damping, double *x)
{
    const size_t rank = lag_svd_rank(svd, tolerance);
    lag_fill(svd->n, 0.0, x);
    for (size_t i = 0; i < rank; ++i) {
        const double shift = damping * svd->value[0];
        const double part = product(svd->m, svd->u + i * svd->m, right) * svd->value[i] / (svd->value[i] * svd->value[i] + shift * shift);
        for (size_t j = 0; j < svd->n; ++j) {
            x[j] += part * svd->v[i * svd->n + j];
        }
    }
}

void lag_svd_solve_transposed(const lag_svd *svd, const double *right, double tolerance, double *x)
{
    const size_t rank = lag_svd_rank(svd, tolerance);
    lag_fill(svd->m, 0.0, x);
    for (size_t i = 0; i < rank; ++i) {
        const double part = product(svd->n, svd->v + i * svd->n, right) / svd->value[i];
        for (size_t j = 0; j < svd->m; ++j) {
            x[j] += part * svd->u[i * svd->m + j];
        }
    }
}
