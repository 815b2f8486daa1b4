/*
 * Linear systems of the stage equations where the Jacobian changes along the step: GMRES, in the norm of the tolerances, with the
 * decomposed systems as preconditioner. No right-hand side is evaluated.
 *
 * Source: Saad and Schultz, SIAM J. Sci. Stat. Comput. 7 (1986) 856; the arithmetic as in Saad, Iterative Methods for Sparse Linear
 * Systems, 2nd ed., algorithm 6.9 and section 6.5.3.
 */
#include <float.h>
#include <math.h>
#include <string.h>

#include "lag/linalg/linalg.h"
#include "lag/methods/radau.h"

enum { MOST = LAG_RADAU_KRYLOV, STAGES = LAG_RADAU_STAGES };

/*
 * The iteration ends when this part of the residual is left. With a Jacobian that is continued, a tenth of the part is enough that an iteration of
 * Newton's method left before, up to the root of this.
 */
static const double SMALL = 1e-6;

/* The Hessenberg matrix, column by column as it grows, made triangular by rotations, and the rotated right-hand side. */
typedef struct least_squares {
    double column[MOST][MOST + 1];
    double cosine[MOST], sine[MOST], right[MOST + 1];
} least_squares;

/* out (stages, size) = sign * the change of the Jacobian, from the middle of the step to each stage, times what is there. */
static void change(const lag_ode *ode, const lag_radau_places *at, double sign, const lag_radau_stages *of, double *out)
{
    double linear[STAGES];
    double square[STAGES];
    for (size_t k = 0; k < of->count; ++k) {
        const double part = at->table->node[k] - 0.5;
        linear[k] = sign * part;
        square[k] = sign * part * part;
    }
    memset(out, 0, of->count * lag_radau_size(ode) * sizeof(double));
    lag_radau_product(ode, at->change, linear, of, out);
    lag_radau_product(ode, at->bend, square, of, out);
}

/* out = v - solution of the decomposed systems for (the change of the Jacobian up to the stages, from the middle on) v */
static void apply(const lag_ode *ode, const lag_radau_places *at, double h, const double *v, double *out)
{
    const lag_radau_table *table = at->table;
    const size_t size = lag_radau_size(ode);
    const size_t stages = table->stages;
    double *product = at->basis + (MOST + 1) * STAGES * size;
    double *rates = product + STAGES * size;
    lag_radau_transform(size, stages, table->transform, v, out);
    if (lag_radau_is_sparse(ode)) {
        lag_radau_transform(size, stages, table->slopes, out, rates);
    }
    for (size_t i = 0; i < stages * size && lag_radau_is_sparse(ode); ++i) {
        rates[i] /= h;
    }
    const lag_radau_stages of = {stages, size, out, out, rates};
    change(ode, at, 1.0, &of, product);
    lag_radau_transform(size, stages, table->inverse, product, out);
    lag_radau_decomposed(ode, at, out);
    for (size_t i = 0; i < stages * size; ++i) {
        out[i] = v[i] - out[i];
    }
}

void lag_radau_change_sides(const lag_ode *ode, const lag_radau_places *at, const double *residual, double *sides)
{
    const lag_radau_table *table = at->table;
    const size_t size = lag_radau_size(ode);
    const size_t stages = table->stages;
    double *product = at->basis;
    double *changed = product + STAGES * size;
    double *rates = changed + STAGES * size;
    lag_radau_transform(ode->size, stages, table->transform, residual, rates);
    const lag_radau_stages of = {.count = stages, .apart = ode->size, .accelerations = rates};
    change(ode, at, -1.0, &of, product);
    lag_radau_transform(size, stages, table->inverse, product, changed);
    for (size_t i = 0; i < stages * size; ++i) {
        sides[i] += changed[i];
    }
}

/* The next direction, orthogonal to all before it and of length 1; what it had of them, and its length, into `column`. */
static void grow(const lag_stepper *s, const lag_radau_places *at, double h, size_t m, double *column)
{
    const size_t apart = lag_radau_size(s->ode);
    const size_t size = at->table->stages * apart;
    double *next = at->basis + (m + 1) * size;
    apply(s->ode, at, h, at->basis + m * size, next);
    for (size_t k = 0; k <= m; ++k) {
        const double *before = at->basis + k * size;
        column[k] = lag_radau_inner(s, at->table->stages, apart, next, before);
        for (size_t i = 0; i < size; ++i) {
            next[i] -= column[k] * before[i];
        }
    }
    column[m + 1] = sqrt(lag_radau_inner(s, at->table->stages, apart, next, next));
    const double by = column[m + 1] > 0.0 ? 1.0 / column[m + 1] : 0.0;
    for (size_t i = 0; i < size; ++i) {
        next[i] *= by;
    }
}

/* Column m becomes one of a triangular matrix. 0: it depends on those before it. */
static int rotate(least_squares *system, size_t m)
{
    double *column = system->column[m];
    for (size_t k = 0; k < m; ++k) {
        const double kept = system->cosine[k] * column[k] + system->sine[k] * column[k + 1];
        column[k + 1] = system->cosine[k] * column[k + 1] - system->sine[k] * column[k];
        column[k] = kept;
    }
    const double length = hypot(column[m], column[m + 1]);
    if (!(length > 0.0) || !isfinite(length)) {
        return 0;
    }
    system->cosine[m] = column[m] / length;
    system->sine[m] = column[m + 1] / length;
    column[m] = length;
    system->right[m + 1] = -system->sine[m] * system->right[m];
    system->right[m] *= system->cosine[m];
    return 1;
}

/* x = the directions with the weights that the triangular system of m columns says. */
static void combine(size_t size, const lag_radau_places *at, least_squares *system, size_t m, double *x)
{
    memset(x, 0, size * sizeof(double));
    for (size_t k = m; k-- > 0;) {
        for (size_t j = k + 1; j < m; ++j) {
            system->right[k] -= system->column[j][k] * system->right[j];
        }
        system->right[k] /= system->column[k][k];
        for (size_t i = 0; i < size; ++i) {
            x[i] += system->right[k] * at->basis[k * size + i];
        }
    }
}

size_t lag_radau_gmres(const lag_stepper *s, const lag_radau_places *at, double h, double *x)
{
    const size_t apart = lag_radau_size(s->ode);
    const size_t size = at->table->stages * apart;
    const double start = sqrt(lag_radau_inner(s, at->table->stages, apart, x, x));
    least_squares system;
    size_t m = 0;
    if (!(start >= DBL_MIN) || !isfinite(start)) {
        return 0;
    }
    const double by = 1.0 / start;
    for (size_t i = 0; i < size; ++i) {
        at->basis[i] = x[i] * by;
    }
    system.right[0] = start;
    const double small = at->memo->served > 0.0 ? fmax(SMALL, fmin(0.1 * at->memo->trust, sqrt(SMALL))) : SMALL;
    while (m < MOST && fabs(system.right[m]) > small * start) {
        grow(s, at, h, m, system.column[m]);
        const int last = !(system.column[m][m + 1] > LAG_ROUNDING);
        if (!rotate(&system, m)) {
            break;
        }
        ++m;
        if (last) {
            break;
        }
    }
    if (m > 0) {
        combine(size, at, &system, m, x);
    }
    return m;
}
