#include "lag/linalg/singular_value.h"

#include <float.h>
#include <math.h>

#include "lag/linalg/arena.h"
#include "lag/linalg/vector.h"

size_t lag_singular_value_memory(size_t m, size_t n)
{
    const size_t k = m < n ? m : n;
    const size_t wide = m < n ? n : m;
    return k * wide + wide + 3 * k;
}

/* The vector v of a reflection that leaves of x (n) its first entry, returned; x becomes v, *factor what v v' is multiplied with. */
static double reflection(size_t n, double *x, double *factor)
{
    const double length = sqrt(lag_dot(n, x, x));
    *factor = 0.0;
    if (!(length > 0.0)) {
        return 0.0;
    }
    const double first = x[0] > 0.0 ? -length : length;
    x[0] -= first;
    *factor = -1.0 / (first * x[0]);
    return first;
}

/* Row i of a (k, n) loses what is right of its diagonal; the rows below are reflected, too. Returns what stands on the diagonal. */
static double clear_row(size_t k, size_t n, size_t i, double *a)
{
    double factor = 0.0;
    double *v = a + i * n + i;
    const double diagonal = reflection(n - i, v, &factor);
    for (size_t row = i + 1; row < k && factor != 0.0; ++row) {
        double *x = a + row * n + i;
        lag_axpy(n - i, -factor * lag_dot(n - i, v, x), v, x);
    }
    return diagonal;
}

/* Column i loses what is below the entry under its diagonal, which is returned. `line` has room for (k) and (n). */
static double clear_column(size_t k, size_t n, size_t i, double *a, double *line)
{
    const size_t first = i + 1;
    double *v = line;
    double *sum = line + k;
    double factor = 0.0;
    for (size_t row = first; row < k; ++row) {
        v[row - first] = a[row * n + i];
    }
    const double below = reflection(k - first, v, &factor);
    lag_fill(n - first, 0.0, sum);
    for (size_t row = first; row < k && factor != 0.0; ++row) {
        lag_axpy(n - first, v[row - first], a + row * n + first, sum);
    }
    for (size_t row = first; row < k && factor != 0.0; ++row) {
        lag_axpy(n - first, -factor * v[row - first], sum, a + row * n + first);
    }
    return below;
}

/* The two diagonals that are left of a (m, n), one entry of each in turn, into `chain` (2 k - 1). */
static void find_chain(size_t m, size_t n, const double *a, double *chain, double *memory)
{
    const size_t k = m < n ? m : n;
    const size_t wide = m < n ? n : m;
    double *work = lag_take(&memory, k * wide);
    for (size_t i = 0; i < m; ++i) {
        for (size_t j = 0; j < n; ++j) {
            work[m < n ? i * n + j : j * m + i] = a[i * n + j];
        }
    }
    for (size_t i = 0; i < k; ++i) {
        chain[2 * i] = clear_row(k, wide, i, work);
        if (i + 1 < k) {
            chain[2 * i + 1] = clear_column(k, wide, i, work, memory);
        }
    }
}

/*
 * Number of singular values above the positive `bound`. With zeros on its diagonal and the chain beside it, a matrix (2 k, 2 k) has them and
 * their negatives as eigenvalues; so many below -bound as pivots of its sum with bound I are negative.
 */
static size_t count_above(size_t k, const double *chain, double bound)
{
    size_t count = 0;
    double pivot = bound;
    for (size_t i = 0; i < 2 * k; ++i) {
        pivot = i > 0 ? bound - chain[i - 1] * (chain[i - 1] / pivot) : bound;
        pivot = pivot != 0.0 ? pivot : DBL_MIN;
        count += pivot < 0.0;
    }
    return count;
}

double lag_singular_value(size_t m, size_t n, const double *a, size_t larger, double *memory)
{
    const size_t k = m < n ? m : n;
    double *chain = lag_take(&memory, 2 * k);
    double low = 0.0;
    double high = 0.0;
    if (larger >= k) {
        return 0.0;
    }
    find_chain(m, n, a, chain, memory);
    for (size_t i = 0; i + 1 < 2 * k; ++i) {
        const double before = i > 0 ? fabs(chain[i - 1]) : 0.0;
        const double behind = i + 2 < 2 * k ? fabs(chain[i + 1]) : 0.0;
        high = fmax(high, fabs(chain[i]) + fmax(before, behind));
    }
    const double close = DBL_EPSILON * high;
    while (high - low > close) {
        const double middle = 0.5 * (low + high);
        if (count_above(k, chain, middle) > larger) {
            low = middle;
        } else {
            high = middle;
        }
    }
    return 0.5 * (low + high);
}

size_t lag_singular_values_above(size_t m, size_t n, const double *a, double bound, double *memory)
{
    const size_t k = m < n ? m : n;
    double *chain = lag_take(&memory, 2 * k);
    find_chain(m, n, a, chain, memory);
    return count_above(k, chain, bound);
}
