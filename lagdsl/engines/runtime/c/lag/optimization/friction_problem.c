#include "lag/optimization/friction_problem.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "lag/linalg/arena.h"
#include "lag/linalg/svd.h"
#include "lag/linalg/vector.h"
#include "lag/optimization/lemke.h"
#include "lag/optimization/nnls.h"

/* Sweeps of Gauss-Seidel's method, and those between two trials of Newton's, which takes so many steps to a solution. */
enum { MOST_SWEEPS = 4000, SWEEPS = 10, MOST_STEPS = 20 };
/* Newton's method goes on down to this part. */
static const double ROUNDING = 1e-15;

/* The problem with rows scaled to a unit diagonal of G. */
typedef struct scaled {
    const lag_friction_problem *p;
    size_t size;
    double largest;           /* of c */
    double *scale;            /* (size) */
    double *at;               /* (frictions) the first row of each */
    double *lam, *best, *kept; /* (size) */
    double *gamma;            /* (size) */
    double *rest;             /* (size) lam - proj(lam - gamma) */
    double *change;           /* (size) */
    double *slope;            /* (size, size) of `rest` */
    double *work;             /* of Lemke's method, or of a decomposition */
} scaled;

size_t lag_friction_problem_memory(size_t normals, size_t frictions, size_t size)
{
    const size_t all = normals + 3 * frictions;
    const size_t work = lag_larger(all * all + 2 * all + lag_lemke_memory(all), lag_svd_memory(size, size));
    return lag_larger(lag_nnls_memory(normals), 7 * size + frictions + size * size + work);
}

/* A row without compliance has no scale: nothing moves it. */
static double scale_of(double diagonal)
{
    return diagonal > 0.0 ? 1.0 / sqrt(diagonal) : 1.0;
}

/* The two components of a slip have one scale: the disc stays a disc. */
static void find_scales(scaled *s)
{
    const double *g = s->p->compliance;
    const size_t n = s->size;
    for (size_t i = 0; i < s->p->normals; ++i) {
        s->scale[i] = scale_of(g[i * n + i]);
    }
    for (size_t k = 0; k < s->p->frictions; ++k) {
        const size_t i = (size_t)s->at[k];
        const size_t last = i + (size_t)s->p->components[k] - 1;
        s->scale[i] = s->scale[last] = scale_of(fmax(g[i * n + i], g[last * n + last]));
    }
}

static scaled begin(const lag_friction_problem *p, double *memory)
{
    scaled s = {.p = p, .size = p->normals};
    for (size_t k = 0; k < p->frictions; ++k) {
        s.size += (size_t)p->components[k];
    }
    const size_t n = s.size;
    s.scale = lag_take(&memory, n);
    s.at = lag_take(&memory, p->frictions);
    lag_take_all(&memory, n, (double **const[]){&s.lam, &s.best, &s.kept, &s.gamma, &s.rest, &s.change, NULL});
    s.slope = lag_take(&memory, n * n);
    s.work = memory;
    size_t next = p->normals;
    for (size_t k = 0; k < p->frictions; ++k) {
        s.at[k] = (double)next;
        next += (size_t)p->components[k];
    }
    find_scales(&s);
    for (size_t i = 0; i < n; ++i) {
        p->rates[i] *= s.scale[i];
        s.largest = fmax(s.largest, fabs(p->rates[i]));
        for (size_t j = 0; j < n; ++j) {
            p->compliance[i * n + j] *= s.scale[i] * s.scale[j];
        }
    }
    for (size_t k = 0; k < p->frictions; ++k) {
        const double own = s.scale[(size_t)s.at[k]];
        p->limits[k] /= own;
        for (size_t i = 0; i < p->normals; ++i) {
            p->coefficients[k * p->normals + i] *= s.scale[i] / own;
        }
    }
    lag_fill(n, 0.0, s.lam);
    return s;
}

static double limit_of(const scaled *s, size_t k)
{
    return fmax(s->p->limits[k] + lag_dot(s->p->normals, s->p->coefficients + k * s->p->normals, s->lam), 0.0);
}

static double rate_of(const scaled *s, size_t i)
{
    return s->p->rates[i] + lag_dot(s->size, s->p->compliance + i * s->size, s->lam);
}

/* The force of friction k that takes this part of its slip away, wherever its limit is; its length. */
static double find_force(const scaled *s, size_t k, double part, double *y)
{
    const size_t first = (size_t)s->at[k];
    const size_t last = first + (size_t)s->p->components[k] - 1;
    y[0] = s->lam[first] - part * rate_of(s, first);
    y[1] = last > first ? s->lam[last] - part * rate_of(s, last) : 0.0;
    return hypot(y[0], y[1]);
}

/* ---- scalar slips ---- */

/* Unknowns: normal forces, forces of friction in either sense, speeds of slips; c has a size of one. 1: a solution was found. */
static int solve_scalar(scaled *s)
{
    const lag_friction_problem *p = s->p;
    const size_t n = s->size;
    const size_t normals = p->normals;
    const size_t slips = p->frictions;
    const size_t all = normals + 3 * slips;
    const double size = s->largest > 0.0 ? s->largest : 1.0;
    double *memory = s->work;
    double *a = lag_take(&memory, all * all);
    double *b = lag_take(&memory, all);
    double *z = lag_take(&memory, all);
    lag_fill(all * all, 0.0, a);
    for (size_t i = 0; i < n; ++i) {
        double *row = a + i * all;
        for (size_t j = 0; j < n; ++j) {
            row[j] = p->compliance[i * n + j];
            row[j + slips] = j >= normals ? -p->compliance[i * n + j] : row[j + slips];
        }
        b[i] = p->rates[i] / size;
    }
    for (size_t k = 0; k < slips; ++k) {
        const double *row = a + (normals + k) * all;
        double *other = a + (normals + slips + k) * all;
        double *limit = a + (normals + 2 * slips + k) * all;
        for (size_t j = 0; j < normals + 2 * slips; ++j) {
            other[j] = -row[j];
        }
        b[normals + slips + k] = -b[normals + k];
        a[(normals + k) * all + normals + 2 * slips + k] = other[normals + 2 * slips + k] = 1.0;
        memcpy(limit, p->coefficients + k * normals, normals * sizeof(double));
        limit[normals + k] = limit[normals + slips + k] = -1.0;
        b[normals + 2 * slips + k] = fmax(p->limits[k], 0.0) / size;
    }
    const int found = lag_lemke(all, a, b, z, memory);
    for (size_t i = 0; i < n; ++i) {
        s->lam[i] = size * (i < normals ? z[i] : z[i] - z[i + slips]);
    }
    return found;
}

/* ---- Newton's method, and the residual of the law ---- */

/* The slope of `rest` at slip k, which slips: its force is the limit along y, of this length. */
static void find_slope(scaled *s, size_t k, const double *y, double length, double radius)
{
    const lag_friction_problem *p = s->p;
    const size_t n = s->size;
    const size_t first = (size_t)s->at[k];
    const size_t count = (size_t)p->components[k];
    for (size_t a = 0; a < count; ++a) {
        const double along = length > 0.0 ? y[a] / length : 0.0;
        const double part = length > 0.0 && count > 1 ? radius / length : 0.0; /* the direction of a scalar slip does not turn */
        double *row = s->slope + (first + a) * n;
        lag_fill(n, 0.0, row);
        for (size_t b = 0; b < count && part > 0.0; ++b) {
            const double turns = (a == b ? 1.0 : 0.0) - along * y[b] / length;
            lag_axpy(n, part * turns, p->compliance + (first + b) * n, row);
            row[first + b] -= part * turns;
        }
        row[first + a] += 1.0;
        if (radius > 0.0) {
            lag_axpy(p->normals, -along, p->coefficients + k * p->normals, row);
        }
    }
}

static void evaluate_slip(scaled *s, size_t k)
{
    const size_t first = (size_t)s->at[k];
    const size_t count = (size_t)s->p->components[k];
    const double radius = limit_of(s, k);
    double y[2];
    const double length = find_force(s, k, 1.0, y);
    const int slips = !(length < radius);
    for (size_t a = 0; a < count; ++a) {
        s->rest[first + a] = slips ? s->lam[first + a] - (length > 0.0 ? radius * y[a] / length : 0.0) : s->gamma[first + a];
    }
    if (slips) {
        find_slope(s, k, y, length, radius);
    }
}

/* lam - proj(lam - gamma) and its slope; its largest entry. Rows of what acts or sticks are those of gamma. */
static double evaluate_projection(scaled *s)
{
    const lag_friction_problem *p = s->p;
    const size_t n = s->size;
    double most = 0.0;
    memcpy(s->slope, p->compliance, n * n * sizeof(double));
    for (size_t i = 0; i < n; ++i) {
        s->gamma[i] = rate_of(s, i);
    }
    for (size_t i = 0; i < p->normals; ++i) {
        const int acts = s->lam[i] - s->gamma[i] > 0.0;
        s->rest[i] = acts ? s->gamma[i] : s->lam[i];
        if (!acts) {
            lag_fill(n, 0.0, s->slope + i * n);
            s->slope[i * n + i] = 1.0;
        }
    }
    for (size_t k = 0; k < p->frictions; ++k) {
        evaluate_slip(s, k);
    }
    for (size_t i = 0; i < n; ++i) {
        most = fmax(most, fabs(s->rest[i]));
    }
    return isfinite(most) ? most : (double)INFINITY;
}

static double size_of(const scaled *s)
{
    double most = s->largest;
    for (size_t i = 0; i < s->size; ++i) {
        most = fmax(most, fabs(s->lam[i]));
    }
    return most > 0.0 ? most : 1.0;
}

/*
 * From s->lam, which is the best that was found afterwards; its residual, as a part of its size. A solution is improved until two steps in a row do not:
 * the first one may change what slips, and the second one then leads to the solution of that.
 */
static double improve(scaled *s)
{
    const size_t n = s->size;
    double least = evaluate_projection(s) / size_of(s);
    int vain = 0;
    memcpy(s->best, s->lam, n * sizeof(double));
    for (int k = 0; (k < MOST_STEPS || least < LAG_SOLVED) && least > ROUNDING; ++k) {
        const lag_svd svd = lag_svd_of(n, n, s->slope, s->work);
        lag_svd_solve(&svd, s->rest, LAG_KNOWN_ROWS, 0.0, s->change);
        lag_axpy(n, -1.0, s->change, s->lam);
        const double left = evaluate_projection(s) / size_of(s);
        vain = left < least ? 0 : vain + 1;
        if (vain == 0) {
            least = left;
            memcpy(s->best, s->lam, n * sizeof(double));
        } else if (!(left < (double)INFINITY) || (vain > 1 && least < LAG_SOLVED)) {
            break;
        }
    }
    memcpy(s->lam, s->best, n * sizeof(double));
    return least;
}

/* ---- Gauss-Seidel's method ---- */

static void sweep(scaled *s)
{
    const lag_friction_problem *p = s->p;
    for (size_t i = 0; i < p->normals; ++i) {
        s->lam[i] = p->compliance[i * (s->size + 1)] > 0.0 ? fmax(0.0, s->lam[i] - rate_of(s, i)) : 0.0;
    }
    for (size_t k = 0; k < p->frictions; ++k) {
        const size_t first = (size_t)s->at[k];
        const size_t count = (size_t)p->components[k];
        const double radius = limit_of(s, k);
        double y[2];
        const double length = find_force(s, k, 1.0 / (double)count, y);
        for (size_t a = 0; a < count; ++a) {
            s->lam[first + a] = length > radius ? radius * y[a] / length : y[a];
        }
    }
}

/* Gauss-Seidel's method until Newton's ends from where it led. */
static double iterate(scaled *s)
{
    double left = improve(s);
    for (int k = 0; k < MOST_SWEEPS && left > LAG_SOLVED; k += SWEEPS) {
        for (int i = 0; i < SWEEPS; ++i) {
            sweep(s);
        }
        memcpy(s->kept, s->lam, s->size * sizeof(double));
        left = improve(s);
        if (left > LAG_SOLVED) {
            memcpy(s->lam, s->kept, s->size * sizeof(double));
        }
    }
    return left;
}

/* 1: G is symmetric but for round-off, as it is where nothing slips. */
static int is_symmetric(const lag_friction_problem *problem, size_t size)
{
    const double *g = problem->compliance;
    int symmetric = 1;
    for (size_t i = 0; i < size; ++i) {
        for (size_t j = 0; j < i; ++j) {
            const double largest = sqrt(fabs(g[i * size + i] * g[j * size + j]));
            symmetric = symmetric && fabs(g[i * size + j] - g[j * size + i]) <= LAG_KNOWN_ROWS * largest;
        }
    }
    return symmetric;
}

int lag_friction_problem_solve(lag_friction_problem *problem, double *lam, double *memory)
{
    if (problem->frictions == 0 && is_symmetric(problem, problem->normals)) {
        lag_nnls(problem->normals, problem->compliance, problem->rates, lam, memory);
        return 1;
    }
    scaled s = begin(problem, memory);
    int scalar = 1;
    for (size_t k = 0; k < problem->frictions; ++k) {
        scalar = scalar && problem->components[k] == 1.0;
    }
    const double left = scalar && solve_scalar(&s) ? improve(&s) : iterate(&s);
    for (size_t i = 0; i < s.size; ++i) {
        lam[i] = left <= LAG_SOLVED ? s.lam[i] * s.scale[i] : 0.0;
    }
    return left <= LAG_SOLVED;
}
