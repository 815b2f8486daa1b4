/* Along a constraint set to where it is nearest: Newton's method on it. */
#include <math.h>
#include <string.h>

#include "lag/linalg/finite.h"
#include "lag/linalg/linalg.h"
#include "lag/linalg/arena.h"
#include "lag/initial/nearest_configuration.h"
#include "lag/linalg/svd.h"
#include "lag/linalg/vector.h"

static const double STATIONARY = 1e-11;
/* The Hessian counts as at least so curved: steps stay within reach. */
static const double LEAST_CURVED = 0.05;
/* A saddle bends down by more than this; so far the way from it leads, as a part of the size of the point. */
static const double SADDLE = 1e-6;
static const double AWAY = 0.1;
static const double BENT = 0.5;
enum { ITERATIONS = 60, HALVINGS = 20 };

static void gather(const lag_parts *parts, size_t which, const double *x, double *part)
{
    size_t first = 0;
    const size_t columns = lag_parts_columns(parts, which, &first);
    for (size_t j = 0; j < columns; ++j) {
        part[j] = x[(size_t)parts->column[first + j]];
    }
}

/* Weights of the rows whose combination of gradients is opposite to the point, as well as that can be. */
static void weigh(lag_nearest_configuration *s, size_t which, const double *point, const lag_svd *svd)
{
    size_t first = 0;
    const size_t rows = lag_parts_rows(s->parts, which, &first);
    gather(s->parts, which, point, s->part);
    lag_svd_solve_transposed(svd, s->part, LAG_RANK, s->bend.weight);
    for (size_t i = 0; i < rows; ++i) {
        s->bend.weights[(size_t)s->parts->row[first + i]] = -s->bend.weight[i];
    }
}

/* One step of size LAG_DIFFERENCE along direction number `index` of all parts that have so many, added to or taken from `point`. */
static void displace(const lag_nearest_configuration *s, size_t index, double sign, const double *point, double *x)
{
    memcpy(x, point, s->parts->n * sizeof(double));
    for (size_t which = 0; which < s->parts->count; ++which) {
        size_t first = 0;
        const size_t columns = lag_parts_columns(s->parts, which, &first);
        const double *direction = s->bend.directions + (size_t)s->bend.square[which] + index * columns;
        for (size_t j = 0; j < columns && (double)index < s->bend.widths[which]; ++j) {
            x[(size_t)s->parts->column[first + j]] += sign * LAG_DIFFERENCE * direction[j];
        }
    }
}

/* Second derivatives of weights.equations along the directions of each part: by central differences of the Jacobian, one direction of all at once. */
static void bend(lag_nearest_configuration *s, const double *point)
{
    const lag_equations *e = s->equations;
    const lag_parts *parts = s->parts;
    double widest = 0.0;
    for (size_t which = 0; which < parts->count; ++which) {
        widest = fmax(widest, s->bend.widths[which]);
    }
    for (size_t index = 0; (double)index < widest; ++index) {
        displace(s, index, -1.0, point, s->path.trial);
        e->evaluate(e->context, parts, s->path.trial, s->residual, s->bend.before);
        displace(s, index, 1.0, point, s->path.trial);
        e->evaluate(e->context, parts, s->path.trial, s->residual, s->jacobian);
        for (size_t which = 0; which < parts->count; ++which) {
            size_t row = 0;
            size_t column = 0;
            const size_t rows = lag_parts_rows(parts, which, &row);
            const size_t columns = lag_parts_columns(parts, which, &column);
            const double *before = lag_parts_block(parts, which, s->bend.before);
            const double *after = lag_parts_block(parts, which, s->jacobian);
            double *its = s->bend.bends + (size_t)s->bend.square[which] + index * columns;
            for (size_t j = 0; j < columns && (double)index < s->bend.widths[which]; ++j) {
                double sum = 0.0;
                for (size_t i = 0; i < rows; ++i) {
                    sum += s->bend.weights[(size_t)parts->row[row + i]] * (after[i * columns + j] - before[i * columns + j]);
                }
                its[j] = sum / (2.0 * LAG_DIFFERENCE);
            }
        }
    }
}

/* The directions that the equations leave free in the moving parts. */
static void find_tangents(lag_nearest_configuration *s, const double *point)
{
    const lag_parts *parts = s->parts;
    s->equations->evaluate(s->equations->context, parts, point, s->residual, s->jacobian);
    for (size_t which = 0; which < parts->count; ++which) {
        size_t first = 0;
        const size_t rows = lag_parts_rows(parts, which, &first);
        const size_t columns = lag_parts_columns(parts, which, &first);
        const double *block = lag_parts_block(parts, which, s->jacobian);
        s->bend.widths[which] = 0.0;
        if (s->moving[which] != 0.0 && lag_finite(rows * columns, block)) {
            const lag_svd svd = lag_svd_of(rows, columns, block, s->svd);
            const size_t rank = lag_svd_rank(&svd, LAG_RANK);
            s->bend.widths[which] = (double)(columns - rank);
            memcpy(s->bend.directions + (size_t)s->bend.square[which], svd.v + rank * columns, (columns - rank) * columns * sizeof(double));
            weigh(s, which, point, &svd);
        }
    }
}

/* I + free' bends, symmetric, and its eigenvalues and eigenvectors. Returns the number of the smallest. */
static size_t curve(lag_nearest_configuration *s, size_t width, size_t columns, const double *directions, const double *bends)
{
    size_t least = 0;
    for (size_t i = 0; i < width; ++i) {
        for (size_t j = 0; j < width; ++j) {
            const double one = lag_dot(columns, directions + i * columns, bends + j * columns);
            const double other = lag_dot(columns, directions + j * columns, bends + i * columns);
            s->bend.hessian[i * width + j] = 0.5 * (one + other) + (i == j ? 1.0 : 0.0);
        }
    }
    lag_symmetric_eigen(width, s->bend.hessian, s->bend.eigen, s->bend.vectors);
    for (size_t i = 1; i < width; ++i) {
        least = s->bend.eigen[i] < s->bend.eigen[least] ? i : least;
    }
    return least;
}

/* The step of a part along its set; one that leaves a saddle is flagged in `ways`, a part that is stationary becomes still. */
static void step_of(lag_nearest_configuration *s, size_t which, const double *point, double length)
{
    size_t first = 0;
    const size_t columns = lag_parts_columns(s->parts, which, &first);
    const size_t place = (size_t)s->bend.square[which];
    const size_t width = (size_t)s->bend.widths[which];
    const double *directions = s->bend.directions + place;
    const size_t least = curve(s, width, columns, directions, s->bend.bends + place);
    double slope = 0.0;
    gather(s->parts, which, point, s->part);
    for (size_t i = 0; i < width; ++i) {
        const double along = lag_dot(columns, directions + i * columns, s->part);
        slope += along * along;
    }
    const int sloping = sqrt(slope) > STATIONARY * length;
    if (!sloping && !(width > 0 && s->bend.eigen[least] < -SADDLE)) {
        s->moving[which] = 0.0;
        return;
    }
    s->path.ways[which] = !sloping;
    for (size_t k = 0; k < width; ++k) {
        double along = 0.0;
        for (size_t i = 0; i < width; ++i) {
            along += s->bend.vectors[i * width + k] * lag_dot(columns, directions + i * columns, s->part);
        }
        const double part = sloping ? -along / fmax(fabs(s->bend.eigen[k]), LEAST_CURVED) : k == least ? AWAY * length : 0.0;
        for (size_t i = 0; i < width; ++i) {
            for (size_t j = 0; j < columns; ++j) {
                s->path.steps[(size_t)s->parts->column[first + j]] += part * s->bend.vectors[i * width + k] * directions[i * columns + j];
            }
        }
    }
}

static void find_steps(lag_nearest_configuration *s, const double *point)
{
    find_tangents(s, point);
    bend(s, point);
    lag_fill(s->parts->n, 0.0, s->path.steps);
    lag_fill(s->parts->count, 0.0, s->path.ways);
    lag_parts_norms(s->parts, 0, point, s->lengths);
    for (size_t which = 0; which < s->parts->count; ++which) {
        if (s->moving[which] != 0.0) {
            step_of(s, which, point, 1.0 + s->lengths[which]);
        }
    }
}

/* Points of the set on the way along the steps that are closer to the origin, into `result`; `done`: those of the `moving` parts that got there. */
static void shorten(lag_nearest_configuration *s, const double *point, double sign, const double *moving, double *result, double *done)
{
    const lag_parts *parts = s->parts;
    const size_t count = parts->count;
    int left = lag_any(count, moving);
    memcpy(result, point, parts->n * sizeof(double));
    lag_fill(count, 0.0, done);
    lag_parts_norms(parts, 0, point, s->lengths);
    double factor = 1.0;
    for (int k = 0; k < HALVINGS && left; ++k, factor *= 0.5) {
        for (size_t j = 0; j < parts->n; ++j) {
            const size_t which = (size_t)parts->column_part[j];
            const int tried = moving[which] != 0.0 && done[which] == 0.0;
            s->path.trial[j] = tried ? point[j] + sign * factor * s->path.steps[j] : result[j];
        }
        lag_descend(&s->minimizer, s->equations, parts, LAG_EXACT, LAG_DESCENTS, s->path.trial);
        lag_parts_norms(parts, 0, s->path.trial, s->path.distances);
        left = 0;
        for (size_t which = 0; which < count; ++which) {
            const int tried = moving[which] != 0.0 && done[which] == 0.0;
            s->chosen[which] = tried && s->minimizer.sizes[which] <= s->path.limits[which] && s->path.distances[which] < s->lengths[which];
            done[which] = s->chosen[which] != 0.0 ? 1.0 : done[which];
            left = left || (tried && s->chosen[which] == 0.0);
        }
        lag_parts_mix(parts, s->chosen, s->path.trial, result);
    }
}

/* From a saddle down on the other side, where that is nearer. */
static void other_side(lag_nearest_configuration *s, const double *point)
{
    const lag_parts *parts = s->parts;
    shorten(s, point, -1.0, s->path.ways, s->path.opposite, s->path.also);
    lag_parts_norms(parts, 0, s->path.opposite, s->path.distances);
    lag_parts_norms(parts, 0, s->path.shorter, s->lengths);
    for (size_t which = 0; which < parts->count; ++which) {
        s->chosen[which] = s->path.also[which] != 0.0 && (s->path.moved[which] == 0.0 || s->path.distances[which] < s->lengths[which]);
        s->path.moved[which] = s->path.moved[which] != 0.0 || s->path.also[which] != 0.0;
    }
    lag_parts_mix(parts, s->chosen, s->path.opposite, s->path.shorter);
}

static void every_part_moves(lag_nearest_configuration *s)
{
    for (size_t which = 0; which < s->parts->count; ++which) {
        size_t first = 0;
        s->moving[which] = lag_parts_rows(s->parts, which, &first) > 0 && lag_parts_columns(s->parts, which, &first) > 0;
    }
}

void lag_nearest_configuration_along(lag_nearest_configuration *s, double *point)
{
    const size_t n = s->parts->n;
    every_part_moves(s);
    for (size_t j = 0; j < n; ++j) { /* what nothing restricts stays at the origin */
        point[j] = s->moving[(size_t)s->parts->column_part[j]] != 0.0 ? point[j] : 0.0;
    }
    for (unsigned k = 0; k < ITERATIONS && lag_any(s->parts->count, s->moving); ++k) {
        find_steps(s, point);
        shorten(s, point, 1.0, s->moving, s->path.shorter, s->path.moved);
        if (lag_any(s->parts->count, s->path.ways)) {
            other_side(s, point);
        }
        memcpy(point, s->path.shorter, n * sizeof(double));
        memcpy(s->moving, s->path.moved, s->parts->count * sizeof(double));
    }
}

/* Flags in `also` the parts that bend by much at a place, with the weights there are. */
static void find_bent_parts(lag_nearest_configuration *s, const double *place)
{
    bend(s, place);
    for (size_t which = 0; which < s->parts->count; ++which) {
        size_t first = 0;
        const size_t columns = lag_parts_columns(s->parts, which, &first);
        if (s->bend.widths[which] > 0.0 && s->path.also[which] == 0.0) {
            const double *bends = s->bend.bends + (size_t)s->bend.square[which];
            s->path.also[which] = !lag_finite(columns * columns, bends) || lag_svd_of(columns, columns, bends, s->svd).value[0] > BENT;
        }
    }
}

int lag_nearest_configuration_bends(lag_nearest_configuration *s)
{
    const lag_parts *parts = s->parts;
    every_part_moves(s);
    s->equations->evaluate(s->equations->context, parts, s->best.point, s->residual, s->jacobian);
    for (size_t which = 0; which < parts->count; ++which) {
        size_t first = 0;
        const size_t rows = lag_parts_rows(parts, which, &first);
        const size_t columns = lag_parts_columns(parts, which, &first);
        const double *block = lag_parts_block(parts, which, s->jacobian);
        double *directions = s->bend.directions + (size_t)s->bend.square[which];
        s->path.also[which] = s->bend.widths[which] = 0.0;
        if (s->moving[which] != 0.0 && lag_finite(rows * columns, block)) {
            const lag_svd svd = lag_svd_of(rows, columns, block, s->svd);
            weigh(s, which, s->best.point, &svd);
            s->bend.widths[which] = (double)columns;
            lag_fill(columns * columns, 0.0, directions);
            for (size_t j = 0; j < columns; ++j) {
                directions[j * columns + j] = 1.0;
            }
        }
    }
    lag_fill(parts->n, 0.0, s->bend.point);
    find_bent_parts(s, s->bend.point);
    find_bent_parts(s, s->best.point);
    for (size_t which = 0; which < parts->count; ++which) {
        s->moving[which] = s->path.also[which] != 0.0 && s->best.distances[which] > 0.0;
    }
    return lag_any(parts->count, s->moving);
}
