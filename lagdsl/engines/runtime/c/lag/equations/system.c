#include <math.h>

#include "lag/dynamics.h"

#include "lag/linalg/linalg.h"
#include "lag/linalg/arena.h"

/* The same figures as in the NumPy modules: see their file `linear` for what they mean. */
static const double SINGULAR_TOLERANCE = 2e-15;
static const double LARGEST = 1e140;
enum { REFINEMENTS = 1 };

static size_t least(size_t x, size_t y)
{
    return x < y ? x : y;
}

size_t lag_system_memory(size_t n, size_t m)
{
    return 3 * n * n + m * n + m * m + 5 * n + 4 * m + 2 * least(n, m);
}

void lag_system_place(lag_system *s, size_t n, size_t m, const size_t *components, double *memory)
{
    s->n = n;
    s->m = m;
    s->components = components;
    s->rank = s->combinations = 0;
    s->indefinite = 0;
    s->mass = NULL;
    s->jacobian = NULL;
    s->choice = (lag_row_choice){NULL, NULL, NULL};
    s->column_scale = lag_take(&memory, n);
    s->row_scale = lag_take(&memory, m);
    s->rows = lag_take(&memory, m * n);
    s->tau = lag_take(&memory, least(n, m));
    s->diagonal = lag_take(&memory, least(n, m));
    s->pivot = lag_take(&memory, m);
    s->reduced = lag_take(&memory, n * n);
    s->factor = lag_take(&memory, n * n);
    s->eigenvalue = lag_take(&memory, n);
    s->work.copy = lag_take(&memory, n * n);
    s->excess = lag_take(&memory, m * m);
    s->work.y = lag_take(&memory, n);
    s->work.h = lag_take(&memory, n);
    s->work.rest = lag_take(&memory, n);
    s->work.l = lag_take(&memory, m);
    s->work.row_rest = lag_take(&memory, m);
}

static int usable(size_t count, const double *values)
{
    for (size_t i = 0; i < count; ++i) {
        if (!(fabs(values[i]) < LARGEST)) {
            return 0;
        }
    }
    return 1;
}

/* Q' M Q of the scaled M. */
static void reduce(lag_system *s)
{
    const size_t n = s->n;
    for (size_t i = 0; i < n; ++i) {
        for (size_t j = 0; j < n; ++j) {
            s->reduced[i * n + j] = s->mass[i * n + j] * s->column_scale[i] * s->column_scale[j];
        }
    }
    lag_qr_apply_to_columns(s->rank, n, s->rows, s->tau, n, s->reduced);
    lag_qr_apply_to_rows(s->rank, n, s->rows, s->tau, n, s->reduced);
}

/* Copies the part of the reduced M beyond the rank; returns its largest diagonal element. */
static double copy_free(const lag_system *s, double *to)
{
    const size_t free_count = s->n - s->rank;
    double largest = 0.0;
    for (size_t i = 0; i < free_count; ++i) {
        for (size_t j = 0; j < free_count; ++j) {
            to[i * free_count + j] = s->reduced[(s->rank + i) * s->n + s->rank + j];
        }
        largest = fmax(largest, fabs(to[i * free_count + i]));
    }
    return largest;
}

/* Index of the largest part of direction `which` of the eigenvectors; of equal parts the first: rounding must not choose. */
static size_t largest_part(lag_system *s, size_t which)
{
    const size_t n = s->n;
    const size_t free_count = n - s->rank;
    double largest = 0.0;
    for (size_t i = 0; i < n; ++i) {
        s->work.y[i] = i < s->rank ? 0.0 : s->factor[(i - s->rank) * free_count + which];
    }
    lag_qr_apply(s->rank, n, s->rows, s->tau, s->work.y, 1);
    for (size_t i = 0; i < n; ++i) {
        largest = fmax(largest, fabs(s->work.y[i]));
    }
    size_t index = 0;
    while (fabs(s->work.y[index]) < (1.0 - 1e-6) * largest) {
        ++index;
    }
    return index;
}

/* For M that is not positive definite: eigenvectors, which tell singular from indefinite. */
static lag_status factor_by_eigenvectors(lag_system *s, size_t *coordinate)
{
    const size_t free_count = s->n - s->rank;
    double largest = 0.0;
    size_t smallest = 0;
    copy_free(s, s->work.copy);
    lag_symmetric_eigen(free_count, s->work.copy, s->eigenvalue, s->factor);
    for (size_t i = 0; i < free_count; ++i) {
        largest = fmax(largest, fabs(s->eigenvalue[i]));
        if (fabs(s->eigenvalue[i]) < fabs(s->eigenvalue[smallest])) {
            smallest = i;
        }
    }
    s->indefinite = 1;
    if (fabs(s->eigenvalue[smallest]) <= (double)s->n * SINGULAR_TOLERANCE * largest) {
        if (coordinate != NULL) {
            *coordinate = largest_part(s, smallest);
        }
        return LAG_SINGULAR;
    }
    return LAG_OK;
}

/* Rows beyond the rank, each less the independent ones that give the same. Multipliers of rows that are zero stay zero by themselves. */
static void find_excess(lag_system *s)
{
    const size_t n = s->n;
    const size_t m = s->m;
    s->combinations = 0;
    for (size_t i = s->rank; i < m; ++i) {
        double *direction = s->excess + s->combinations * m;
        const size_t own = (size_t)s->pivot[i];
        if (!lag_any(n, s->jacobian + own * n)) {
            continue;
        }
        for (size_t j = 0; j < m; ++j) {
            direction[j] = 0.0;
        }
        for (size_t j = s->rank; j-- > 0;) {
            double sum = -s->rows[i * n + j];
            for (size_t k = j + 1; k < s->rank; ++k) {
                sum -= s->rows[k * n + j] * s->work.l[k];
            }
            s->work.l[j] = sum / s->diagonal[j];
        }
        for (size_t j = 0; j < s->rank; ++j) {
            const size_t row = (size_t)s->pivot[j];
            direction[row] = s->work.l[j] * s->row_scale[row];
        }
        direction[own] = s->row_scale[own] > 0.0 ? s->row_scale[own] : 1.0;
        lag_orthonormalize(s->combinations++, m, s->excess, direction);
    }
}

lag_status lag_system_factor(
    lag_system *s, const double *mass, const double *jacobian, size_t most, size_t *coordinate)
{
    s->mass = mass;
    s->jacobian = jacobian;
    s->rank = 0;
    s->indefinite = 0;
    if (!usable(s->n * s->n, mass) || !usable(s->m * s->n, jacobian)) {
        return LAG_NOT_FINITE;
    }
    lag_system_scale(s, most < s->m);
    s->rank = lag_qr(s->m, s->n, s->rows, s->tau, s->diagonal, s->pivot, most, LAG_REACHED);
    find_excess(s);
    reduce(s);
    const size_t free_count = s->n - s->rank;
    const double largest = copy_free(s, s->factor);
    if (lag_cholesky(free_count, s->factor, (double)s->n * SINGULAR_TOLERANCE * largest) == free_count) {
        return LAG_OK;
    }
    return factor_by_eigenvectors(s, coordinate);
}

/* x := (free part of the reduced M)^-1 x; `kept` has room for as many numbers. */
static void solve_free(const lag_system *s, double *x, double *kept)
{
    const size_t free_count = s->n - s->rank;
    if (!s->indefinite) {
        lag_cholesky_solve(free_count, s->factor, x);
        return;
    }
    for (size_t k = 0; k < free_count; ++k) {
        kept[k] = 0.0;
        for (size_t i = 0; i < free_count; ++i) {
            kept[k] += s->factor[i * free_count + k] * x[i];
        }
        kept[k] /= s->eigenvalue[k];
    }
    for (size_t i = 0; i < free_count; ++i) {
        x[i] = 0.0;
        for (size_t k = 0; k < free_count; ++k) {
            x[i] += s->factor[i * free_count + k] * kept[k];
        }
    }
}

/* The first components of y in the basis Q, from the scaled pivot rows for row_rest = gamma. */
static void solve_rows(lag_system *s)
{
    for (size_t i = 0; i < s->rank; ++i) {
        const size_t row = (size_t)s->pivot[i];
        double sum = s->row_scale[row] * s->work.row_rest[row];
        for (size_t j = 0; j < i; ++j) {
            sum -= s->rows[i * s->n + j] * s->work.y[j];
        }
        s->work.y[i] = sum / s->diagonal[i];
    }
}

/* y in the basis Q, and the multipliers of the scaled pivot rows in l, for h = Q' of the scaled force and row_rest = gamma. */
static void solve_reduced(lag_system *s)
{
    const size_t n = s->n;
    const size_t rank = s->rank;
    solve_rows(s);
    for (size_t i = rank; i < n; ++i) {
        s->work.y[i] = s->work.h[i];
        for (size_t j = 0; j < rank; ++j) {
            s->work.y[i] -= s->reduced[i * n + j] * s->work.y[j];
        }
    }
    solve_free(s, s->work.y + rank, s->work.copy);
    for (size_t j = rank; j-- > 0;) {
        double sum = -s->work.h[j];
        for (size_t k = 0; k < n; ++k) {
            sum += s->reduced[j * n + k] * s->work.y[k];
        }
        for (size_t i = j + 1; i < rank; ++i) {
            sum -= s->rows[i * n + j] * s->work.l[i];
        }
        s->work.l[j] = sum / s->diagonal[j];
    }
}

/* Adds to a and lam the solution for what `rest` and `row_rest` hold. */
static void correct(lag_system *s, double *a, double *lam)
{
    const size_t n = s->n;
    for (size_t i = 0; i < n; ++i) {
        s->work.h[i] = s->column_scale[i] * s->work.rest[i];
    }
    lag_qr_apply_transposed(s->rank, n, s->rows, s->tau, s->work.h, 1);
    solve_reduced(s);
    lag_qr_apply(s->rank, n, s->rows, s->tau, s->work.y, 1);
    for (size_t i = 0; i < n; ++i) {
        a[i] += s->column_scale[i] * s->work.y[i];
    }
    for (size_t i = 0; i < s->rank; ++i) {
        const size_t row = (size_t)s->pivot[i];
        lam[row] += s->row_scale[row] * s->work.l[i];
    }
    lag_remove_parts(s->combinations, s->m, s->excess, lam);
}

void lag_system_solve(lag_system *s, const double *force, const double *gamma, double *a, double *lam)
{
    const size_t n = s->n;
    const size_t m = s->m;
    for (size_t i = 0; i < n; ++i) {
        a[i] = 0.0;
    }
    for (size_t i = 0; i < m; ++i) {
        lam[i] = 0.0;
    }
    for (int step = 0; step <= REFINEMENTS; ++step) {
        for (size_t i = 0; i < n; ++i) {
            s->work.rest[i] = force[i];
            for (size_t j = 0; j < n; ++j) {
                s->work.rest[i] -= s->mass[i * n + j] * a[j];
            }
            for (size_t j = 0; j < m; ++j) {
                s->work.rest[i] += s->jacobian[j * n + i] * lam[j];
            }
        }
        for (size_t i = 0; i < m; ++i) {
            s->work.row_rest[i] = gamma[i];
            for (size_t j = 0; j < n; ++j) {
                s->work.row_rest[i] -= s->jacobian[i * n + j] * a[j];
            }
        }
        correct(s, a, lam);
    }
}

void lag_system_least(lag_system *s, const double *gamma, double *v)
{
    for (size_t i = 0; i < s->m; ++i) {
        s->work.row_rest[i] = gamma[i];
    }
    for (size_t i = s->rank; i < s->n; ++i) {
        s->work.y[i] = 0.0;
    }
    solve_rows(s);
    lag_qr_apply(s->rank, s->n, s->rows, s->tau, s->work.y, 1);
    for (size_t i = 0; i < s->n; ++i) {
        v[i] = s->column_scale[i] * s->work.y[i];
    }
}
