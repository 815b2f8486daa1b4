/* Scales of the coordinates and rows of a system, by which its ranks are judged. */
#include <math.h>

#include "lag/dynamics.h"
#include "lag/linalg/linalg.h"

/* The same figures as in the NumPy modules: see their file `linear` for what they mean. */
static const double SHORT_ROW = 1e-3;
static const double LIGHTEST = 1e3;
/*
 * Off the constraints rows that depend on each other contradict each other a little, and the ones that are taken enlarge that by the inverse of
 * what is left of them. Rows that are to be taken last are so much shorter: others are taken where they leave less.
 */
static const double LATE = 0.3;
/* Such rows are not stretched where they are shorter than this part of their natural size; none of them becomes shorter than SHORT_ROW. */
static const double SHORT_PART = 0.3;

/* The largest inertia of the coordinates that M ties to number i, itself included. */
static double largest_tied(const lag_system *s, size_t i)
{
    double largest = 0.0;
    for (size_t j = 0; j < s->n; ++j) {
        const double other = fabs(s->mass[j * s->n + j]);
        largest = s->mass[i * s->n + j] != 0.0 && other > largest ? other : largest;
    }
    return largest;
}

/* Inertia is judged beside that of the coordinates it is tied to; where there is none, the largest of all is as good as any. */
static void scale_coordinates(lag_system *s)
{
    const size_t n = s->n;
    double largest = 0.0;
    for (size_t i = 0; i < n; ++i) {
        largest = fmax(largest, fabs(s->mass[i * n + i]));
    }
    if (!(largest > 0.0)) {
        largest = 1.0;
    }
    for (size_t i = 0; i < n; ++i) {
        const double own = fabs(s->mass[i * n + i]);
        const int counts = own > 0.0 && own > LAG_ROUNDING * LAG_ROUNDING * largest_tied(s, i);
        s->column_scale[i] = 1.0 / sqrt(counts ? own : largest);
    }
}

/* The length that row i is given: one, but for rows that are short; `part` is that beside the longest row. */
static double length_of_row(const lag_system *s, size_t i, double part, int dependent)
{
    double sum = 0.0;
    if (!dependent || s->choice.row_sizes == NULL) {
        return part;
    }
    for (size_t j = 0; j < s->n; ++j) {
        const double entry = s->jacobian[i * s->n + j] * s->choice.sizes[j] / s->choice.row_sizes[i];
        sum += entry * entry;
    }
    const double natural = fmin(1.0, sqrt(sum) / SHORT_PART);
    return fmax(natural < part ? natural : part, fmin(SHORT_ROW, part));
}

static size_t component(const lag_system *s, size_t coordinate)
{
    return s->components != NULL ? s->components[coordinate] : 0;
}

/* Components of rows, into `l`; a row that is zero may count to any. */
static void find_components(lag_system *s)
{
    for (size_t i = 0; i < s->m; ++i) {
        size_t j = 0;
        while (j + 1 < s->n && s->jacobian[i * s->n + j] == 0.0) {
            ++j;
        }
        s->work.l[i] = s->n > 0 ? (double)component(s, j) : 0.0;
    }
}

/* Lengths of rows, as they are judged, into `row_scale`: light coordinates count beside the heaviest one of their component. */
static void judge_rows(lag_system *s)
{
    const size_t n = s->n;
    for (size_t i = 0; i < s->m; ++i) {
        double least = (double)INFINITY;
        double sum = 0.0;
        for (size_t j = 0; j < n; ++j) {
            least = (double)component(s, j) == s->work.l[i] ? fmin(least, s->column_scale[j]) : least;
        }
        for (size_t j = 0; j < n; ++j) {
            const double judged = s->jacobian[i * n + j] * fmin(s->column_scale[j], LIGHTEST * least);
            sum += judged * judged;
        }
        s->row_scale[i] = sqrt(sum);
    }
    for (size_t i = 0; i < s->m; ++i) {
        s->work.row_rest[i] = 0.0;
        for (size_t k = 0; k < s->m; ++k) {
            s->work.row_rest[i] = s->work.l[k] == s->work.l[i] ? fmax(s->work.row_rest[i], s->row_scale[k]) : s->work.row_rest[i];
        }
    }
}

/* Rows of several components have no coordinate in common: each is judged beside the longest one of its own. */
static void scale_rows(lag_system *s, int dependent)
{
    const size_t n = s->n;
    find_components(s);
    judge_rows(s);
    for (size_t i = 0; i < s->m; ++i) {
        const double judged = s->row_scale[i];
        const double longest = s->work.row_rest[i];
        double sum = 0.0;
        for (size_t j = 0; j < n; ++j) {
            s->rows[i * n + j] = s->jacobian[i * n + j] * s->column_scale[j];
            sum += s->rows[i * n + j] * s->rows[i * n + j];
        }
        const double part = fmin(1.0, judged / (SHORT_ROW * longest));
        s->row_scale[i] = judged > LAG_ROUNDING * longest ? length_of_row(s, i, part, dependent) / sqrt(sum) : 0.0;
        s->row_scale[i] *= s->choice.late != NULL && s->choice.late[i] ? LATE : 1.0;
        for (size_t j = 0; j < n; ++j) {
            s->rows[i * n + j] *= s->row_scale[i];
        }
    }
}

void lag_system_scale(lag_system *s, int dependent)
{
    scale_coordinates(s);
    scale_rows(s, dependent);
}
