/* The guesses of a search, and which of the points that they lead to is the nearest. */
#include "lag/initial/nearest_configuration.h"

#include <math.h>
#include <string.h>

#include "lag/linalg/arena.h"
#include "lag/linalg/svd.h"

static const double PENALTIES[] = {1.0, 0.3, 0.1, 0.03, 0.01, 1e-3};
/* Distances that differ by less are the same; the point that is reached from the start then stays. */
static const double TIE = 1e-9;
static const double ROUNDED = 1e6;
enum { RELAXED = 20 };

size_t lag_nearest_configuration_memory(size_t m, size_t n)
{
    const size_t points = LAG_NEAREST_FOUND + LAG_NEAREST_REFINED + 1;
    return lag_levenberg_marquardt_memory(m, n) + lag_levenberg_marquardt_memory(m + n, n) + lag_parts_memory(m + n, n) + points * (n + 2 * (m + n)) + m +
           2 * m * n + 5 * n + 9 * (m + n) + m + n + 1 + 2 * n * n + m + n + m + 2 * n * n + n +
           lag_svd_memory(lag_larger(m, n), n);
}

static void place_found(lag_found *found, size_t m, size_t n, double **memory)
{
    found->point = lag_take(memory, n);
    found->sizes = lag_take(memory, m + n);
    found->distances = lag_take(memory, m + n);
}

/* The parts with a row more for each column. */
static lag_parts widened(const lag_parts *parts, double *memory)
{
    const size_t m = parts->m;
    const size_t n = parts->n;
    lag_parts wide = lag_parts_begin(m + n, n, memory);
    wide.count = parts->count;
    memcpy(wide.row_part, parts->row_part, m * sizeof(double));
    memcpy(wide.row_part + m, parts->column_part, n * sizeof(double));
    memcpy(wide.column_part, parts->column_part, n * sizeof(double));
    lag_parts_order(&wide);
    return wide;
}

/* The begin of the squares of the parts. */
static void find_squares(const lag_parts *parts, double *square)
{
    square[0] = 0.0;
    for (size_t which = 0; which < parts->count; ++which) {
        size_t first = 0;
        const size_t columns = lag_parts_columns(parts, which, &first);
        square[which + 1] = square[which] + (double)(columns * columns);
    }
}

void lag_nearest_configuration_place(lag_nearest_configuration *s, const lag_parts *parts, double *memory)
{
    const size_t m = parts->m;
    const size_t n = parts->n;
    double **const in_parts[] = {&s->moving, &s->path.moved, &s->path.ways, &s->path.also, &s->chosen, &s->lengths, &s->path.limits, &s->path.distances, &s->bend.widths};
    double **const points[] = {&s->bend.point, &s->path.steps, &s->path.shorter, &s->path.opposite, &s->path.trial};
    memset(s, 0, sizeof *s);
    s->parts = parts;
    s->relaxed.parts = widened(parts, lag_take(&memory, lag_parts_memory(m + n, n)));
    lag_levenberg_marquardt_place(&s->minimizer, parts, lag_take(&memory, lag_levenberg_marquardt_memory(m, n)));
    lag_levenberg_marquardt_place(&s->relaxed.minimizer, &s->relaxed.parts, lag_take(&memory, lag_levenberg_marquardt_memory(m + n, n)));
    for (size_t i = 0; i < LAG_NEAREST_FOUND; ++i) {
        place_found(&s->found[i], m, n, &memory);
    }
    for (size_t i = 0; i < LAG_NEAREST_REFINED; ++i) {
        place_found(&s->refined[i], m, n, &memory);
    }
    place_found(&s->best, m, n, &memory);
    s->residual = lag_take(&memory, m);
    s->jacobian = lag_take(&memory, lag_parts_entries(parts));
    s->bend.before = lag_take(&memory, lag_parts_entries(parts));
    for (size_t i = 0; i < sizeof points / sizeof *points; ++i) {
        *points[i] = lag_take(&memory, n);
    }
    for (size_t i = 0; i < sizeof in_parts / sizeof *in_parts; ++i) {
        *in_parts[i] = lag_take(&memory, m + n);
    }
    s->bend.square = lag_take(&memory, m + n + 1);
    find_squares(parts, s->bend.square);
    s->bend.directions = lag_take(&memory, (size_t)s->bend.square[parts->count]);
    s->bend.bends = lag_take(&memory, (size_t)s->bend.square[parts->count]);
    s->bend.weights = lag_take(&memory, m);
    s->part = lag_take(&memory, n);
    s->bend.weight = lag_take(&memory, m);
    s->bend.hessian = lag_take(&memory, n * n);
    s->bend.vectors = lag_take(&memory, n * n);
    s->bend.eigen = lag_take(&memory, n);
    s->svd = memory;
}

/* ---- points ---- */

/* `to` becomes `from` in the chosen parts. */
static void mix(const lag_nearest_configuration *s, const double *chosen, const lag_found *from, lag_found *to)
{
    lag_parts_mix(s->parts, chosen, from->point, to->point);
    for (size_t i = 0; i < s->parts->count; ++i) {
        to->sizes[i] = chosen[i] != 0.0 ? from->sizes[i] : to->sizes[i];
        to->distances[i] = chosen[i] != 0.0 ? from->distances[i] : to->distances[i];
    }
}

/* `to` becomes `from` in one part. */
static void take(const lag_nearest_configuration *s, size_t part, const lag_found *from, lag_found *to)
{
    size_t first = 0;
    const size_t columns = lag_parts_columns(s->parts, part, &first);
    for (size_t k = first; k < first + columns; ++k) {
        const size_t j = (size_t)s->parts->column[k];
        to->point[j] = from->point[j];
    }
    to->sizes[part] = from->sizes[part];
    to->distances[part] = from->distances[part];
}

static void copy(const lag_nearest_configuration *s, const lag_found *from, lag_found *to)
{
    memcpy(to->point, from->point, s->parts->n * sizeof(double));
    memcpy(to->sizes, from->sizes, s->parts->count * sizeof(double));
    memcpy(to->distances, from->distances, s->parts->count * sizeof(double));
}

/* Descends from `found->point` to a solution. */
static void descend(lag_nearest_configuration *s, lag_found *found)
{
    lag_descend(&s->minimizer, s->equations, s->parts, LAG_EXACT, LAG_DESCENTS, found->point);
    memcpy(found->sizes, s->minimizer.sizes, s->parts->count * sizeof(double));
    lag_parts_norms(s->parts, 0, found->point, found->distances);
}

/* The smaller residuals of both. */
static void improve(lag_nearest_configuration *s, const lag_found *other)
{
    for (size_t i = 0; i < s->parts->count; ++i) {
        s->chosen[i] = other->sizes[i] < s->best.sizes[i];
    }
    mix(s, s->chosen, other, &s->best);
}

/* ---- guesses ---- */

/* The rows of a part stand before those of its columns, in its block, too. */
static void relaxed(void *context, const lag_parts *wide, const double *y, double *residual, double *jacobian)
{
    const lag_nearest_configuration *s = context;
    lag_parts inner = *s->parts;
    inner.first_entry = wide->first_entry;
    s->equations->evaluate(s->equations->context, &inner, y, residual, jacobian);
    for (size_t j = 0; j < inner.n; ++j) {
        residual[inner.m + j] = s->relaxed.penalty * y[j];
    }
    for (size_t which = 0; which < inner.count; ++which) {
        size_t first = 0;
        const size_t rows = lag_parts_rows(&inner, which, &first);
        const size_t columns = lag_parts_columns(&inner, which, &first);
        double *square = lag_parts_block(wide, which, jacobian) + rows * columns;
        lag_fill(columns * columns, 0.0, square);
        for (size_t j = 0; j < columns; ++j) {
            square[j * columns + j] = s->relaxed.penalty;
        }
    }
}

/* Minima of e |y|^2 + |equations(y)|^2 for ever smaller e, each from the last, the first from the origin. */
static void follow(lag_nearest_configuration *s, double *point)
{
    const lag_equations wider = {relaxed, s};
    lag_fill(s->parts->n, 0.0, point);
    for (size_t i = 0; i < sizeof PENALTIES / sizeof *PENALTIES; ++i) {
        s->relaxed.penalty = PENALTIES[i];
        lag_descend(&s->relaxed.minimizer, &wider, &s->relaxed.parts, LAG_EXACT, RELAXED, point);
    }
}

/* ---- the nearest of them ---- */

/* Number `rank` of the points that are found in a part, the nearest first; those that do not satisfy the equations last. */
static size_t ranked(const lag_nearest_configuration *s, size_t part, size_t rank)
{
    for (size_t i = 0; i < s->count; ++i) {
        const double own = s->found[i].sizes[part] <= s->holds ? s->found[i].distances[part] : (double)INFINITY;
        size_t before = 0;
        for (size_t j = 0; j < s->count; ++j) {
            const double other = s->found[j].sizes[part] <= s->holds ? s->found[j].distances[part] : (double)INFINITY;
            before += other < own || (other == own && j < i);
        }
        if (before == rank) {
            return i;
        }
    }
    return 0;
}

/*
 * The nearest points number `rank` of each part in one; 0: there is none in any part. A part without one contributes its
 * nearest.
 */
static int collect(lag_nearest_configuration *s, size_t rank, lag_found *to)
{
    int any = 0;
    copy(s, &s->found[0], to);
    for (size_t part = 0; part < s->parts->count; ++part) {
        const lag_found *from = &s->found[ranked(s, part, rank)];
        const int feasible = from->sizes[part] <= s->holds && isfinite(from->distances[part]);
        take(s, part, feasible || rank == 0 ? from : &s->refined[0], to);
        any = any || feasible;
    }
    return any;
}

static void refine(lag_nearest_configuration *s, lag_found *found)
{
    for (size_t i = 0; i < s->parts->count; ++i) {
        s->path.limits[i] = fmax(1e-12, found->sizes[i]);
    }
    lag_nearest_configuration_along(s, found->point);
    s->equations->evaluate(s->equations->context, s->parts, found->point, s->residual, s->jacobian);
    lag_parts_norms(s->parts, 1, s->residual, found->sizes);
    lag_parts_norms(s->parts, 0, found->point, found->distances);
}

/* True if the coordinates x of a part, in units of its distance and rounded, come after y in lexical order. */
static int beyond(const lag_nearest_configuration *s, size_t part, double limit, const double *x, const double *y)
{
    size_t first = 0;
    const size_t columns = lag_parts_columns(s->parts, part, &first);
    const double unit = limit > 0.0 ? limit : 1.0;
    for (size_t j = first; j < first + columns; ++j) {
        const size_t column = (size_t)s->parts->column[j];
        const double a = floor(x[column] / unit * ROUNDED + 0.5);
        const double b = floor(y[column] / unit * ROUNDED + 0.5);
        if (a != b) {
            return a > b;
        }
    }
    return 0;
}

/*
 * For each part the nearest of `best`, if there is one, and the stationary points reached from those found that are nearest; of mirrored ones
 * that with the larger coordinates, so that the order in which they were found does not matter.
 */
static void choose(lag_nearest_configuration *s, int with_best, lag_found *result)
{
    size_t refined = 0;
    while (refined < LAG_NEAREST_REFINED && refined < s->count && collect(s, refined, &s->refined[refined])) {
        refine(s, &s->refined[refined]);
        ++refined;
    }
    copy(s, &s->refined[0], result);
    for (size_t part = 0; part < s->parts->count && refined > 0; ++part) {
        size_t winner = refined;
        double limit = with_best ? s->best.distances[part] : (double)INFINITY;
        for (size_t i = 0; i < refined; ++i) {
            limit = fmin(limit, s->refined[i].distances[part]);
        }
        limit *= 1.0 + TIE;
        for (size_t i = 0; i < refined; ++i) {
            if (s->refined[i].distances[part] <= limit &&
                (winner == refined || beyond(s, part, limit, s->refined[i].point, s->refined[winner].point))) {
                winner = i;
            }
        }
        if (with_best && s->best.distances[part] <= limit) {
            take(s, part, &s->best, result);
        } else if (winner < refined) {
            take(s, part, &s->refined[winner], result);
        }
    }
}

/* Nearer points of parts that bend. */
static void search_bent_parts(lag_nearest_configuration *s)
{
    const size_t n = s->parts->n;
    if (!lag_nearest_configuration_bends(s)) {
        return;
    }
    s->count = 0;
    for (size_t k = 0; k < LAG_NEAREST_GUESSES; ++k) {
        const double *guess = s->guesses + k * n;
        const double share = (double)(k + 1) / (double)LAG_NEAREST_GUESSES;
        lag_parts_norms(s->parts, 0, guess, s->lengths);
        for (int sign = 1; sign >= -1; sign -= 2) {
            lag_found *found = &s->found[s->count++];
            copy(s, &s->best, found);
            for (size_t j = 0; j < n; ++j) {
                const size_t part = (size_t)s->parts->column_part[j];
                const double length = s->lengths[part] > 0.0 ? s->lengths[part] : 1.0;
                if (s->moving[part] != 0.0) {
                    found->point[j] = sign * s->best.distances[part] * share / length * guess[j];
                }
            }
            descend(s, found);
        }
    }
    choose(s, 1, &s->found[0]);
    copy(s, &s->found[0], &s->best);
}

double lag_nearest_configuration_search(lag_nearest_configuration *s, const lag_equations *equations, const double *guesses, double holds)
{
    const lag_parts *parts = s->parts;
    const size_t n = parts->n;
    size_t feasible = 0;
    double worst = 0.0;
    s->equations = equations;
    s->guesses = guesses;
    s->holds = holds;
    s->count = 2;
    lag_fill(n, 0.0, s->found[0].point);
    descend(s, &s->found[0]);
    follow(s, s->found[1].point);
    descend(s, &s->found[1]);
    copy(s, &s->found[0], &s->best);
    improve(s, &s->found[1]);
    for (size_t k = 0; k < LAG_NEAREST_GUESSES; ++k) {
        lag_found *found = &s->found[s->count];
        int open = 0;
        for (size_t i = 0; i < parts->count; ++i) {
            s->chosen[i] = s->best.sizes[i] > holds;
            open = open || s->best.sizes[i] > holds;
        }
        if (!open) {
            break;
        }
        copy(s, &s->best, found);
        lag_parts_mix(parts, s->chosen, guesses + k * n, found->point);
        descend(s, found);
        ++s->count;
        improve(s, found);
    }
    for (size_t i = 0; i < parts->count; ++i) {
        feasible += s->best.sizes[i] <= holds;
    }
    if (feasible > 0) {
        lag_found *result = &s->found[LAG_NEAREST_FOUND - 1];
        choose(s, 0, result);
        for (size_t i = 0; i < parts->count; ++i) {
            s->chosen[i] = s->best.sizes[i] <= holds;
        }
        mix(s, s->chosen, result, &s->best);
    }
    if (feasible == parts->count) {
        search_bent_parts(s);
    }
    for (size_t i = 0; i < parts->count; ++i) {
        worst = fmax(worst, s->best.sizes[i]);
    }
    return worst;
}
