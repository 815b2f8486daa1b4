#include "lag/delays/pieces.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "lag/linalg/arena.h"

/* Of the pieces, so many are free after joining. */
enum { FREE = LAG_DELAY_PIECES / 8 };

/* cos(pi k/8) for k = 0 .. 8, and one between. */
const double lag_delay_places[LAG_DELAY_SAMPLES] = {
    1.0, 0.92387953251128676, 0.70710678118654752, 0.38268343236508977, 0.0,
    -0.38268343236508977, -0.70710678118654752, -0.92387953251128676, -1.0, 0.55};

size_t lag_delay_pieces_memory(size_t n)
{
    return n == 0 ? 0 : 2 * (LAG_DELAY_PIECES + 1) + (LAG_DELAY_PIECES * LAG_DELAY_TERMS + 2 + LAG_DELAY_SAMPLES) * n;
}

void lag_delay_pieces_place(lag_delay_pieces *pieces, size_t n, double *memory)
{
    *pieces = (lag_delay_pieces){.n = n};
    pieces->begin = lag_take(&memory, LAG_DELAY_PIECES + 1);
    pieces->order = lag_take(&memory, LAG_DELAY_PIECES + 1);
    pieces->size = lag_take(&memory, n);
    pieces->limit = lag_take(&memory, n);
    pieces->sample = lag_take(&memory, LAG_DELAY_SAMPLES * n);
    pieces->terms = memory;
}

static double *terms_of(const lag_delay_pieces *pieces, size_t piece, size_t i)
{
    return pieces->terms + (piece * pieces->n + i) * LAG_DELAY_TERMS;
}

/* Value and derivative by x of a sum of Chebyshev's polynomials (Clenshaw). */
static double sum_of(const double *terms, double x, double *slope)
{
    double b[2] = {0.0, 0.0};
    double d[2] = {0.0, 0.0};
    for (size_t k = LAG_DELAY_DEGREE; k > 0; --k) {
        const double rate = 2.0 * b[0] + 2.0 * x * d[0] - d[1];
        const double value = 2.0 * x * b[0] - b[1] + terms[k];
        d[1] = d[0];
        d[0] = rate;
        b[1] = b[0];
        b[0] = value;
    }
    *slope = b[0] + x * d[0] - d[1];
    return x * b[0] - b[1] + terms[0];
}

/* The coefficients of what has these values at the nodes, `stride` apart. */
static void find_terms(const double *values, size_t stride, double *terms)
{
    for (size_t k = 0; k < LAG_DELAY_TERMS; ++k) {
        double sum = 0.0;
        for (size_t j = 0; j < LAG_DELAY_TERMS; ++j) {
            const size_t turn = j * k % (2 * LAG_DELAY_DEGREE);
            const double cosine = lag_delay_places[turn <= LAG_DELAY_DEGREE ? turn : 2 * LAG_DELAY_DEGREE - turn];
            sum += (j == 0 || j == LAG_DELAY_DEGREE ? 0.5 : 1.0) * (values[j * stride] - values[0]) * cosine;
        }
        terms[k] = sum * (k == 0 || k == LAG_DELAY_DEGREE ? 1.0 : 2.0) / LAG_DELAY_DEGREE;
    }
    terms[0] += values[0]; /* so that constants are exact */
}

size_t lag_delay_piece(const lag_delay_pieces *pieces, double t)
{
    size_t low = pieces->first;
    size_t high = pieces->count;
    while (high - low > 1) {
        const size_t middle = low + (high - low) / 2;
        if (pieces->begin[middle] <= t) {
            low = middle;
        } else {
            high = middle;
        }
    }
    return low;
}

double lag_delay_value(const lag_delay_pieces *pieces, size_t piece, size_t i, double t, double *rate)
{
    const double a = pieces->begin[piece];
    const double half = 0.5 * (pieces->begin[piece + 1] - a);
    const double value = sum_of(terms_of(pieces, piece, i), fmax(-1.0, fmin(1.0, (t - a) / half - 1.0)), rate);
    *rate /= half;
    return value;
}

double lag_delay_bend(const lag_delay_pieces *pieces, size_t piece, size_t i, double t)
{
    const double a = pieces->begin[piece];
    const double half = 0.5 * (pieces->begin[piece + 1] - a);
    double terms[2][LAG_DELAY_TERMS + 2] = {{0.0}};
    double slope = 0.0;
    memcpy(terms[0], terms_of(pieces, piece, i), LAG_DELAY_TERMS * sizeof(double));
    for (int order = 0; order < 2; ++order) { /* the coefficients of the derivative: c'(k - 1) = c'(k + 1) + 2 k c(k) */
        const double *c = terms[order % 2];
        double *d = terms[1 - order % 2];
        for (size_t k = LAG_DELAY_TERMS + 2; k-- > 0;) {
            d[k] = k + 2 < LAG_DELAY_TERMS + 2 && k + 1 < LAG_DELAY_TERMS ? d[k + 2] + 2.0 * (double)(k + 1) * c[k + 1] : 0.0;
        }
        d[0] *= 0.5;
    }
    return sum_of(terms[0], fmax(-1.0, fmin(1.0, (t - a) / half - 1.0)), &slope) / (half * half);
}

int lag_delay_is_jump(const lag_delay_pieces *pieces, size_t piece, size_t i)
{
    double rate = 0.0;
    const double t = pieces->begin[piece];
    return piece > pieces->first &&
        fabs(lag_delay_value(pieces, piece, i, t, &rate) - lag_delay_value(pieces, piece - 1, i, t, &rate)) > pieces->limit[i];
}

double lag_delay_try(lag_delay_pieces *pieces, double tolerance, double end)
{
    const size_t n = pieces->n;
    const double *beside = pieces->sample + LAG_DELAY_TERMS * n;
    double slope = 0.0;
    double most = 0.0;
    pieces->begin[pieces->count + 1] = end;
    for (size_t i = 0; i < n; ++i) {
        double *terms = terms_of(pieces, pieces->count, i);
        find_terms(pieces->sample + i, n, terms);
        for (size_t j = 0; j < LAG_DELAY_TERMS; ++j) {
            pieces->size[i] = fmax(pieces->size[i], fabs(pieces->sample[j * n + i]));
        }
        pieces->limit[i] = fmax(fmax(tolerance, 8.0 * DBL_EPSILON) * pieces->size[i], DBL_MIN); /* round-off is no error of the piece */
        const double off = fabs(sum_of(terms, lag_delay_places[LAG_DELAY_TERMS], &slope) - beside[i]);
        most = fmax(most, fmax(fabs(terms[LAG_DELAY_DEGREE]), off) / pieces->limit[i]);
    }
    return most;
}

/* ---- room ---- */

/* Pieces k and k + 1 as one, for expression i; 0: it is not as exact. */
static int join(const lag_delay_pieces *pieces, size_t k, size_t i, double *joined)
{
    const double *begin = pieces->begin;
    const double half = 0.5 * (begin[k + 2] - begin[k]);
    double values[LAG_DELAY_TERMS];
    double rate = 0.0;
    for (size_t j = 0; j < LAG_DELAY_TERMS; ++j) {
        const double t = begin[k] + half * (1.0 + lag_delay_places[j]);
        values[j] = lag_delay_value(pieces, t < begin[k + 1] ? k : k + 1, i, t, &rate);
    }
    find_terms(values, 1, joined);
    for (size_t j = 0; j < 2 * LAG_DELAY_TERMS; ++j) {
        const size_t of = k + j / LAG_DELAY_TERMS;
        const double t = begin[of] + 0.5 * (begin[of + 1] - begin[of]) * (1.0 + lag_delay_places[j % LAG_DELAY_TERMS]);
        const double off = sum_of(joined, (t - begin[k]) / half - 1.0, &rate) - lag_delay_value(pieces, of, i, t, &rate);
        if (!(fabs(off) <= pieces->limit[i])) {
            return 0;
        }
    }
    return 1;
}

/* The same for all expressions, into `sample`. */
static int join_all(const lag_delay_pieces *pieces, size_t k)
{
    size_t i = 0;
    while (i < pieces->n && join(pieces, k, i, pieces->sample + i * LAG_DELAY_TERMS)) {
        ++i;
    }
    return i == pieces->n;
}

/* Pieces that nobody reads any more go; if that is not enough, neighbours become one where nothing jumps between them. */
static lag_status make_room(lag_delay_pieces *pieces)
{
    const size_t width = pieces->n * LAG_DELAY_TERMS;
    const double end = lag_delay_end(pieces);
    pieces->first = lag_delay_piece(pieces, end - pieces->length);
    const int crowded = pieces->first < FREE;
    size_t to = 0;
    for (size_t k = pieces->first; k < pieces->count; ++k, ++to) {
        const int joins = crowded && k + 1 < pieces->count && pieces->order[k + 1] >= LAG_DELAY_SMOOTH && join_all(pieces, k);
        const double *terms = joins ? pieces->sample : pieces->terms + k * width;
        pieces->begin[to] = pieces->begin[k];
        pieces->order[to] = pieces->order[k];
        memmove(pieces->terms + to * width, terms, width * sizeof(double));
        k += (size_t)joins;
    }
    pieces->first = 0;
    pieces->count = to;
    pieces->begin[to] = end;
    return to + FREE <= LAG_DELAY_PIECES ? LAG_OK : LAG_LONG_PAST;
}

lag_status lag_delay_add(lag_delay_pieces *pieces)
{
    int jumps = 0;
    for (size_t i = 0; i < pieces->n && pieces->level == 0; ++i) {
        jumps = jumps || lag_delay_is_jump(pieces, pieces->count, i);
    }
    pieces->order[pieces->count] = pieces->level == 0 && !jumps ? 1.0 : (double)pieces->level;
    pieces->level = LAG_DELAY_SMOOTH;
    ++pieces->count;
    return pieces->count + 1 < LAG_DELAY_PIECES ? LAG_OK : make_room(pieces);
}

void lag_delay_cut(lag_delay_pieces *pieces, double t)
{
    while (pieces->count > pieces->first + 1 && pieces->begin[pieces->count - 1] >= t) {
        --pieces->count;
        pieces->level = (int)fmin(pieces->level, pieces->order[pieces->count]);
    }
}
