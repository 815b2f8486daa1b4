#include "lag/optimization/lemke.h"

#include <math.h>

#include "lag/linalg/arena.h"

/* An entry of the entering column below this part of the largest is no pivot. */
static const double PIVOT = 1e-10;
/* Ratios that differ by less than this, relatively, tie. */
static const double TIE = 1e-12;
/* So many pivots for each unknown, and in any case. */
enum { MOST_EACH = 50, MOST = 100 };

/* w - A z - e z0 = b: columns w (n), z (n), z0, b; one row for each basic variable. */
typedef struct tableau {
    size_t n;
    size_t width;   /* 2 n + 2 */
    double *rows;   /* (n, width) */
    double *basis;  /* (n) the column that each row is solved for */
    double *ratios; /* (n) those that still tie */
    double *tied;   /* (n) their rows */
} tableau;

size_t lag_lemke_memory(size_t n)
{
    return n * (2 * n + 2) + 3 * n;
}

static tableau place(size_t n, const double *a, const double *b, double *memory)
{
    tableau t = {.n = n, .width = 2 * n + 2};
    t.rows = lag_take(&memory, n * t.width);
    t.basis = lag_take(&memory, n);
    t.ratios = lag_take(&memory, n);
    t.tied = lag_take(&memory, n);
    lag_fill(n * t.width, 0.0, t.rows);
    for (size_t i = 0; i < n; ++i) {
        double *row = t.rows + i * t.width;
        row[i] = 1.0;
        for (size_t j = 0; j < n; ++j) {
            row[n + j] = -a[i * n + j];
        }
        row[2 * n] = -1.0;
        row[2 * n + 1] = b[i];
        t.basis[i] = (double)i;
    }
    return t;
}

/* Solves row r for a column; the column that it was solved for leaves. */
static size_t pivot(tableau *t, size_t r, size_t column)
{
    double *own = t->rows + r * t->width;
    const double factor = 1.0 / own[column];
    for (size_t k = 0; k < t->width; ++k) {
        own[k] *= factor;
    }
    for (size_t i = 0; i < t->n; ++i) {
        double *row = t->rows + i * t->width;
        const double part = row[column];
        if (i != r && part != 0.0) {
            for (size_t k = 0; k < t->width; ++k) {
                row[k] -= part * own[k];
            }
            row[column] = 0.0;
        }
    }
    const size_t left = (size_t)t->basis[r];
    t->basis[r] = (double)column;
    return left;
}

/* Keeps of the rows that tie those with the least ratio of `column` to the entering one; so many are left. */
static size_t least(tableau *t, size_t count, size_t column, size_t entering)
{
    double smallest = (double)INFINITY;
    size_t left = 0;
    for (size_t k = 0; k < count; ++k) {
        const double *row = t->rows + (size_t)t->tied[k] * t->width;
        t->ratios[k] = row[column] / row[entering];
        smallest = fmin(smallest, t->ratios[k]);
    }
    for (size_t k = 0; k < count; ++k) {
        if (t->ratios[k] <= smallest + TIE * fmax(1.0, fabs(smallest))) {
            t->tied[left++] = t->tied[k];
        }
    }
    return left;
}

/* Of the rows that tie the one of z0; n where it is not among them. */
static size_t row_of_z0(const tableau *t, size_t count)
{
    size_t k = 0;
    while (k < count && (size_t)t->basis[(size_t)t->tied[k]] != 2 * t->n) {
        ++k;
    }
    return k < count ? (size_t)t->tied[k] : t->n;
}

/* The row that leaves for the entering column: of least ratio, ties by the columns of the inverse of the basis. n: a ray. */
static size_t leaving(tableau *t, size_t entering)
{
    double most = 1.0;
    size_t count = 0;
    for (size_t i = 0; i < t->n; ++i) {
        most = fmax(most, fabs(t->rows[i * t->width + entering]));
    }
    for (size_t i = 0; i < t->n; ++i) {
        if (t->rows[i * t->width + entering] > PIVOT * most) {
            t->tied[count++] = (double)i;
        }
    }
    if (count == 0) {
        return t->n;
    }
    count = least(t, count, 2 * t->n + 1, entering);
    const size_t last = row_of_z0(t, count);
    for (size_t k = 0; k < t->n && count > 1 && last == t->n; ++k) {
        count = least(t, count, k, entering);
    }
    return last < t->n ? last : (size_t)t->tied[0];
}

/* The row of the most negative b, of equal ones the last; n where none is negative. */
static size_t first(const tableau *t)
{
    double most = 0.0;
    size_t worst = t->n;
    for (size_t i = 0; i < t->n; ++i) {
        const double b = t->rows[i * t->width + 2 * t->n + 1];
        if (b < 0.0 && b <= most) {
            most = b;
            worst = i;
        }
    }
    return worst;
}

int lag_lemke(size_t n, const double *a, const double *b, double *z, double *memory)
{
    tableau t = place(n, a, b, memory);
    size_t row = first(&t);
    size_t entering = 2 * n;
    lag_fill(n, 0.0, z);
    for (size_t k = 0; k < MOST_EACH * n + MOST && row < n; ++k) {
        const size_t left = pivot(&t, row, entering);
        if (left == 2 * n) {
            break;
        }
        entering = left < n ? left + n : left - n;
        row = leaving(&t, entering);
        if (row == n) {
            return 0;
        }
    }
    for (size_t i = 0; i < n; ++i) {
        const size_t column = (size_t)t.basis[i];
        if (column == 2 * n && t.rows[i * t.width + 2 * n + 1] > TIE) {
            lag_fill(n, 0.0, z);
            return 0;
        }
        if (column >= n && column < 2 * n) {
            z[column - n] = fmax(t.rows[i * t.width + 2 * n + 1], 0.0);
        }
    }
    return 1;
}
