#include "lag/optimization/nnls.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "lag/linalg/linalg.h"
#include "lag/linalg/arena.h"

typedef struct problem {
    size_t n;
    size_t count;            /* unknowns that are free */
    double *a, *b;           /* (n, n) (n) scaled */
    double *scale;           /* (n) */
    double *x, *trial;       /* (n) */
    double *factor;          /* (n, n) */
    double *free, *barred;   /* (n) indices of the free ones, in the order in which they came; 1: not to be tried now */
} problem;

size_t lag_nnls_memory(size_t n)
{
    return 3 * n * n + 5 * n;
}

/* A with a unit diagonal, b to it. */
static void scale(problem *p, const double *a, const double *b)
{
    const size_t n = p->n;
    for (size_t i = 0; i < n; ++i) {
        p->scale[i] = a[i * n + i] > 0.0 ? 1.0 / sqrt(a[i * n + i]) : 0.0;
        p->b[i] = p->scale[i] * b[i];
        p->x[i] = 0.0;
    }
    for (size_t i = 0; i < n; ++i) {
        for (size_t j = 0; j < n; ++j) {
            p->a[i * n + j] = p->scale[i] * p->scale[j] * 0.5 * (a[i * n + j] + a[j * n + i]);
        }
    }
}

/* Takes from b what is outside of the range of A. */
static void into_range(problem *p, double *copy, double *vectors)
{
    const size_t n = p->n;
    double most = 0.0;
    memcpy(copy, p->a, n * n * sizeof(double));
    lag_symmetric_eigen(n, copy, p->trial, vectors);
    for (size_t k = 0; k < n; ++k) {
        most = fmax(most, p->trial[k]);
    }
    for (size_t k = 0; k < n; ++k) {
        double part = 0.0;
        for (size_t i = 0; i < n && p->trial[k] <= LAG_EXACT * most; ++i) {
            part += vectors[i * n + k] * p->b[i];
        }
        for (size_t i = 0; i < n && part != 0.0; ++i) {
            p->b[i] -= part * vectors[i * n + k];
        }
    }
}

static int is_free(const problem *p, size_t i)
{
    for (size_t k = 0; k < p->count; ++k) {
        if ((size_t)p->free[k] == i) {
            return 1;
        }
    }
    return 0;
}

static void drop(problem *p, size_t which)
{
    --p->count;
    memmove(p->free + which, p->free + which + 1, (p->count - which) * sizeof(double));
}

/* The unknown along which the function falls most; n: none. */
static size_t steepest(problem *p)
{
    const size_t n = p->n;
    double largest = 0.0;
    size_t found = n;
    for (size_t i = 0; i < n; ++i) {
        largest = fmax(largest, fabs(p->b[i]));
    }
    double most = LAG_ROUNDING * (double)n * largest;
    for (size_t i = 0; i < n; ++i) {
        double slope = p->b[i];
        for (size_t j = 0; j < n; ++j) {
            slope += p->a[i * n + j] * p->x[j];
        }
        if (-slope > most && p->scale[i] > 0.0 && p->barred[i] == 0.0 && !is_free(p, i)) {
            most = -slope;
            found = i;
        }
    }
    return found;
}

/* The free unknowns at which the function is flat, into `trial`. 0: the one that came last depends on the others. */
static int solve(problem *p)
{
    const size_t k = p->count;
    for (size_t i = 0; i < k; ++i) {
        const size_t row = (size_t)p->free[i];
        p->trial[i] = -p->b[row];
        for (size_t j = 0; j < k; ++j) {
            p->factor[i * k + j] = p->a[row * p->n + (size_t)p->free[j]];
        }
    }
    if (lag_cholesky(k, p->factor, LAG_EXACT) < k) {
        return 0;
    }
    lag_cholesky_solve(k, p->factor, p->trial);
    return 1;
}

/* Towards `trial` as far as nothing becomes negative; what became zero is free no longer. 0: all the way. */
static int move(problem *p)
{
    double part = 1.0;
    for (size_t i = 0; i < p->count; ++i) {
        const double x = p->x[(size_t)p->free[i]];
        if (!(p->trial[i] > 0.0)) {
            part = fmin(part, x > 0.0 ? x / (x - p->trial[i]) : 0.0);
        }
    }
    for (size_t i = 0; i < p->count; ++i) {
        double *x = p->x + (size_t)p->free[i];
        const int gone = !(p->trial[i] > 0.0) && *x + part * (p->trial[i] - *x) <= 4.0 * DBL_EPSILON * *x;
        *x = gone ? 0.0 : *x + part * (p->trial[i] - *x);
    }
    const size_t before = p->count;
    for (size_t i = p->count; i-- > 0;) {
        if (p->x[(size_t)p->free[i]] == 0.0) {
            drop(p, i);
        }
    }
    return p->count < before;
}

void lag_nnls(size_t n, const double *a, const double *b, double *x, double *memory)
{
    problem p = {.n = n, .x = x};
    p.a = lag_take(&memory, n * n);
    p.b = lag_take(&memory, n);
    p.scale = lag_take(&memory, n);
    p.trial = lag_take(&memory, n);
    p.free = lag_take(&memory, n);
    p.barred = lag_take(&memory, n);
    p.factor = lag_take(&memory, n * n);
    scale(&p, a, b);
    memset(p.barred, 0, n * sizeof(double));
    into_range(&p, p.factor, memory);
    for (size_t k = 0; k < 30 * n; ++k) {
        const size_t found = steepest(&p);
        if (found == n) {
            break;
        }
        p.free[p.count++] = (double)found;
        if (!solve(&p) || !(p.trial[p.count - 1] > 0.0)) {
            drop(&p, p.count - 1);
            p.barred[found] = 1.0;
            continue;
        }
        memset(p.barred, 0, n * sizeof(double));
        while (move(&p) && p.count > 0 && solve(&p)) {
        }
    }
    for (size_t i = 0; i < n; ++i) {
        x[i] *= p.scale[i];
    }
}
