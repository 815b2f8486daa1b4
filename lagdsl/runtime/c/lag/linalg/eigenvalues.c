#include "lag/linalg/eigenvalues.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "lag/linalg/arena.h"

enum { MOST_STEPS = 40, UNUSUAL = 10 };

typedef struct number {
    double re, im;
} number;

/* The matrix, real and imaginary part, and the rotations of one step. */
typedef struct work {
    size_t n;
    double *re, *im;                  /* (n, n) */
    double *c_re, *c_im, *s_re, *s_im; /* (n) */
} work;

size_t lag_eigenvalues_memory(size_t n)
{
    return 2 * n * n + 4 * n;
}

static number at(const work *w, size_t i, size_t j)
{
    return (number){w->re[i * w->n + j], w->im[i * w->n + j]};
}

static void put(const work *w, size_t i, size_t j, number x)
{
    w->re[i * w->n + j] = x.re;
    w->im[i * w->n + j] = x.im;
}

static number times(number a, number b)
{
    return (number){a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}

static number conjugate(number a)
{
    return (number){a.re, -a.im};
}

static number sum(number a, number b, double sign)
{
    return (number){a.re + sign * b.re, a.im + sign * b.im};
}

static double size_of(number a)
{
    return hypot(a.re, a.im);
}

static number root_of(number a)
{
    const double size = size_of(a);
    const double re = sqrt(0.5 * (size + fabs(a.re)));
    if (!(re > 0.0)) {
        return (number){0.0, 0.0};
    }
    const double im = 0.5 * a.im / re;
    return a.re >= 0.0 ? (number){re, im} : (number){fabs(im), a.im >= 0.0 ? re : -re};
}

/* Below the diagonal next to the main one nothing is left, by elimination with pivots. */
static void to_hessenberg(size_t n, double *a)
{
    for (size_t k = 1; k + 1 < n; ++k) {
        size_t pivot = k;
        for (size_t i = k + 1; i < n; ++i) {
            pivot = fabs(a[i * n + k - 1]) > fabs(a[pivot * n + k - 1]) ? i : pivot;
        }
        for (size_t j = 0; j < n && pivot != k; ++j) {
            const double kept = a[pivot * n + j];
            a[pivot * n + j] = a[k * n + j];
            a[k * n + j] = kept;
        }
        for (size_t i = 0; i < n && pivot != k; ++i) {
            const double kept = a[i * n + pivot];
            a[i * n + pivot] = a[i * n + k];
            a[i * n + k] = kept;
        }
        for (size_t i = k + 1; i < n && a[k * n + k - 1] != 0.0; ++i) {
            const double factor = a[i * n + k - 1] / a[k * n + k - 1];
            for (size_t j = k - 1; j < n; ++j) {
                a[i * n + j] -= factor * a[k * n + j];
            }
            for (size_t j = 0; j < n; ++j) {
                a[j * n + k] += factor * a[j * n + i];
            }
        }
    }
}

/* The eigenvalue of the last two rows that is nearer to the last entry. */
static number shift_of(const work *w, size_t last)
{
    const number a = at(w, last - 1, last - 1);
    const number d = at(w, last, last);
    const number half = {0.5 * (a.re - d.re), 0.5 * (a.im - d.im)};
    const number product = times(at(w, last - 1, last), at(w, last, last - 1));
    const number root = root_of(sum(times(half, half), product, 1.0));
    const number one = sum(half, root, 1.0);
    const number other = sum(half, root, -1.0);
    return sum(d, size_of(one) < size_of(other) ? one : other, 1.0);
}

/* One QR step with a shift on rows and columns `first` to `last`. */
static void step(const work *w, size_t first, size_t last, number shift)
{
    for (size_t i = first; i <= last; ++i) {
        put(w, i, i, sum(at(w, i, i), shift, -1.0));
    }
    for (size_t k = first; k < last; ++k) {
        const number a = at(w, k, k);
        const number b = at(w, k + 1, k);
        const double length = hypot(size_of(a), size_of(b));
        const number c = length > 0.0 ? (number){a.re / length, a.im / length} : (number){1.0, 0.0};
        const number s = length > 0.0 ? (number){b.re / length, b.im / length} : (number){0.0, 0.0};
        w->c_re[k] = c.re;
        w->c_im[k] = c.im;
        w->s_re[k] = s.re;
        w->s_im[k] = s.im;
        for (size_t j = k; j <= last; ++j) {
            const number x = at(w, k, j);
            const number y = at(w, k + 1, j);
            put(w, k, j, sum(times(conjugate(c), x), times(conjugate(s), y), 1.0));
            put(w, k + 1, j, sum(times(c, y), times(s, x), -1.0));
        }
    }
    for (size_t k = first; k < last; ++k) {
        const number c = {w->c_re[k], w->c_im[k]};
        const number s = {w->s_re[k], w->s_im[k]};
        for (size_t i = first; i <= k + 1; ++i) {
            const number x = at(w, i, k);
            const number y = at(w, i, k + 1);
            put(w, i, k, sum(times(c, x), times(s, y), 1.0));
            put(w, i, k + 1, sum(times(conjugate(c), y), times(conjugate(s), x), -1.0));
        }
    }
    for (size_t i = first; i <= last; ++i) {
        put(w, i, i, sum(at(w, i, i), shift, 1.0));
    }
}

/* First row of the block that ends in row `last`. */
static size_t block_of(const work *w, size_t last)
{
    size_t first = last;
    while (first > 0) {
        const double beside = size_of(at(w, first, first)) + size_of(at(w, first - 1, first - 1));
        if (size_of(at(w, first, first - 1)) <= DBL_EPSILON * beside) {
            break;
        }
        --first;
    }
    return first;
}

double lag_least_real_part(size_t n, const double *a, double *memory)
{
    double least = (double)INFINITY;
    work w = {.n = n};
    w.re = lag_take(&memory, n * n);
    w.im = lag_take(&memory, n * n);
    w.c_re = lag_take(&memory, n);
    w.c_im = lag_take(&memory, n);
    w.s_re = lag_take(&memory, n);
    w.s_im = memory;
    memcpy(w.re, a, n * n * sizeof(double));
    lag_fill(n * n, 0.0, w.im);
    to_hessenberg(n, w.re);
    for (size_t left = n; left > 0; --left) {
        const size_t last = left - 1;
        unsigned steps = 0;
        for (size_t first = block_of(&w, last); first < last; first = block_of(&w, last)) {
            if (++steps > MOST_STEPS) {
                return (double)NAN;
            }
            const number unusual = {size_of(at(&w, last, last - 1)) + at(&w, last, last).re, 0.0};
            step(&w, first, last, steps % UNUSUAL == 0 ? unusual : shift_of(&w, last));
        }
        least = fmin(least, at(&w, last, last).re);
    }
    return least;
}
