#include "lag/optimization/margins.h"

#include <math.h>
#include <string.h>

#include "lag/linalg/arena.h"
#include "lag/linalg/vector.h"
#include "lag/optimization/linear_program.h"

/* A load outside of a disc by less than this part of its size is in it. */
static const double OUTSIDE = 1e-13;
/* Tangents of a disc: four to begin with, and those that are added. */
enum { FIRST = 4, MORE = 12 };

/* Inequalities a x <= b of unknowns x = (y+, y-, s), with s from `least` on: the program has a solution to begin with. */
typedef struct program {
    size_t rows, unknowns;
    double least;
    double *a, *b, *c, *x;
    double *memory;
} program;

static size_t most_rows(size_t sides, size_t loaded)
{
    return sides + (FIRST + MORE) * loaded + 1;
}

size_t lag_margins_memory(size_t unknowns, size_t sides, size_t loaded)
{
    const size_t rows = most_rows(sides, loaded);
    const size_t all = 2 * unknowns + 1;
    const size_t own = 2 * sides + 3 * sides * (1 + unknowns) + unknowns;
    return own + rows * (all + 1) + 2 * all + lag_linear_program_memory(all, rows);
}

lag_margins lag_margins_of(size_t unknowns, size_t most, double *memory)
{
    lag_margins margins = {.unknowns = unknowns};
    margins.components = lag_take(&memory, most);
    margins.size = lag_take(&memory, most);
    margins.forms = lag_take(&memory, 3 * most * (1 + unknowns));
    margins.y = lag_take(&memory, unknowns);
    margins.memory = memory;
    lag_fill(unknowns, 0.0, margins.y);
    return margins;
}

static double *forms_of(const lag_margins *margins, size_t side)
{
    return margins->forms + 3 * side * (1 + margins->unknowns);
}

double *lag_margins_add(lag_margins *margins, size_t components, double size)
{
    double *forms = forms_of(margins, margins->sides);
    margins->components[margins->sides] = (double)components;
    margins->size[margins->sides++] = size;
    lag_fill(3 * (1 + margins->unknowns), 0.0, forms);
    return forms;
}

/* Limit and load of a side at y. */
static void values_of(const lag_margins *margins, size_t side, double *values)
{
    const size_t n = margins->unknowns;
    const double *forms = forms_of(margins, side);
    for (size_t k = 0; k < 3; ++k) {
        values[k] = forms[k * (1 + n)] + lag_dot(n, forms + k * (1 + n) + 1, margins->y);
    }
}

double lag_margin_of(const lag_margins *margins, size_t side)
{
    double values[3];
    values_of(margins, side, values);
    return values[0] - hypot(values[1], values[2]);
}

/* along . load + s size <= limit, with a unit vector. */
static void add_tangent(const lag_margins *margins, program *p, size_t side, double along, double aside)
{
    const size_t n = margins->unknowns;
    const double *limit = forms_of(margins, side);
    const double *load = limit + 1 + n;
    const double *other = load + 1 + n;
    double *inequality = p->a + p->rows * p->unknowns;
    for (size_t v = 0; v < n; ++v) {
        inequality[v] = along * load[1 + v] + aside * other[1 + v] - limit[1 + v];
        inequality[n + v] = -inequality[v];
    }
    inequality[2 * n] = margins->size[side];
    p->b[p->rows++] = fmax(limit[0] - along * load[0] - aside * other[0] - p->least * margins->size[side], 0.0);
}

/* A load of one component has one inequality in each sense, one of two four around what it is at y = 0. */
static void add_side(const lag_margins *margins, program *p, size_t side)
{
    const double *load = forms_of(margins, side) + 1 + margins->unknowns;
    const size_t count = (size_t)margins->components[side];
    const double other = load[1 + margins->unknowns];
    const double length = count > 1 ? hypot(load[0], other) : 0.0;
    const double along = length > 0.0 ? load[0] / length : 1.0;
    const double aside = length > 0.0 ? other / length : 0.0;
    const double ways[FIRST][2] = {{along, aside}, {-along, -aside}, {-aside, along}, {aside, -along}};
    for (size_t i = 0; i < (count > 0 ? 2 * count : 1); ++i) {
        add_tangent(margins, p, side, ways[i][0], ways[i][1]);
    }
}

static program begin(const lag_margins *margins)
{
    const size_t n = margins->unknowns;
    double *memory = margins->memory;
    size_t loaded = 0;
    program p = {.unknowns = 2 * n + 1, .least = 1.0};
    for (size_t side = 0; side < margins->sides; ++side) {
        loaded += margins->components[side] > 0.0;
        p.least = fmin(p.least, lag_margin_of(margins, side) / margins->size[side]);
    }
    p.a = lag_take(&memory, most_rows(margins->sides, loaded) * p.unknowns);
    p.b = lag_take(&memory, most_rows(margins->sides, loaded));
    p.c = lag_take(&memory, p.unknowns);
    p.x = lag_take(&memory, p.unknowns);
    p.memory = memory;
    lag_fill(p.unknowns, 0.0, p.c);
    lag_fill(p.unknowns, 0.0, p.a);
    p.a[2 * n] = p.c[2 * n] = 1.0;
    p.b[p.rows++] = 1.0 - p.least;
    for (size_t side = 0; side < margins->sides; ++side) {
        add_side(margins, &p, side);
    }
    return p;
}

/* Tangents where loads are beyond their discs, less the margin; 1: some were added. */
static int refine(const lag_margins *margins, program *p, double margin)
{
    const size_t before = p->rows;
    for (size_t side = 0; side < margins->sides; ++side) {
        if (margins->components[side] > 1.0 && lag_margin_of(margins, side) < (margin - OUTSIDE) * margins->size[side]) {
            double values[3];
            values_of(margins, side, values);
            const double length = hypot(values[1], values[2]);
            add_tangent(margins, p, side, values[1] / length, values[2] / length);
        }
    }
    return p->rows > before;
}

double lag_margins_solve(lag_margins *margins)
{
    const size_t n = margins->unknowns;
    program p = begin(margins);
    double margin = p.least;
    int again = 1;
    for (int k = 0; k <= MORE && again; ++k) {
        again = lag_linear_program(p.unknowns, p.rows, p.a, p.b, p.c, p.x, p.memory);
        for (size_t v = 0; v < n; ++v) {
            margins->y[v] = again ? p.x[v] - p.x[n + v] : 0.0;
        }
        margin = p.x[2 * n] + p.least;
        again = again && refine(margins, &p, margin);
    }
    return margin;
}
