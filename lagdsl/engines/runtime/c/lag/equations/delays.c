#include "lag/equations/delays.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "lag/elimination/lu.h"
#include "lag/equations/discretes.h"
#include "lag/equations/motion.h"
#include "lag/linalg/arena.h"
#include "lag/linalg/vector.h"

/* Times nearer to each other than so many units in the last place are one. */
static const double ULPS = 16.0;
/* No piece is more exact than this part of its value. */
static const double ROUNDING = 8.0 * DBL_EPSILON;
/* Of the pieces, the part that has to be free after joining. */
enum { FREE = LAG_DELAY_PIECES / 8 };
/* For expressions that read themselves: steps of Newton's method, and the part by which numbers change for a slope. */
enum { MOST_STEPS = 20 };
static const double DIFFERENCE = 1e-7;

/* cos(pi k/8) for k = 0 .. 8. */
const double lag_delay_nodes[LAG_DELAY_TERMS] = {
    1.0, 0.92387953251128676, 0.70710678118654752, 0.38268343236508977, 0.0,
    -0.38268343236508977, -0.70710678118654752, -0.92387953251128676, -1.0};

size_t lag_delays_memory(const lag_model *model)
{
    const size_t n = model->ndelay;
    return n == 0 ? 0 : n * (10 + n + 1) + LAG_DELAY_TERMS * n + 2 * (LAG_DELAY_PIECES + 1) + LAG_DELAY_PIECES * n * LAG_DELAY_TERMS;
}

void lag_delays_place(lag_delays *delays, lag_motion *motion, double *memory)
{
    const size_t n = motion->model->ndelay;
    const lag_places places = lag_places_of(motion->model);
    memset(delays, 0, sizeof *delays);
    delays->motion = motion;
    delays->value = places.delay;
    delays->rate = places.delay_rate;
    double **const arrays[] = {
        &delays->time, &delays->from, &delays->ahead, &delays->clear, &delays->from_before, &delays->ahead_before, &delays->size,
        &delays->limit, &delays->now, &delays->other};
    for (size_t k = 0; k < sizeof arrays / sizeof *arrays; ++k) {
        *arrays[k] = lag_take(&memory, n);
    }
    delays->step = lag_take(&memory, n * (n + 1));
    delays->sample = lag_take(&memory, LAG_DELAY_TERMS * n);
    delays->begin = lag_take(&memory, LAG_DELAY_PIECES + 1);
    delays->order = lag_take(&memory, LAG_DELAY_PIECES + 1);
    delays->terms = memory;
}

void lag_delays_clear(lag_delays *delays)
{
    delays->first = delays->count = 0;
}

/* ---- polynomials ---- */

static double *terms_of(const lag_delays *delays, size_t piece, size_t i)
{
    return delays->terms + (piece * delays->motion->model->ndelay + i) * LAG_DELAY_TERMS;
}

/* Value and derivative by x of a sum of Chebyshev's polynomials (Clenshaw). */
static double sum_of(const double *terms, double x, double *slope)
{
    double b[2] = {0.0, 0.0};
    double d[2] = {0.0, 0.0};
    for (size_t k = LAG_DELAY_DEGREE; k > 0; --k) {
        const double db = 2.0 * b[0] + 2.0 * x * d[0] - d[1];
        const double next = 2.0 * x * b[0] - b[1] + terms[k];
        d[1] = d[0];
        d[0] = db;
        b[1] = b[0];
        b[0] = next;
    }
    *slope = b[0] + x * d[0] - d[1];
    return x * b[0] - b[1] + terms[0];
}

/* The coefficients of what has these values (LAG_DELAY_TERMS, a `stride` apart) at the nodes. */
static void find_terms(const double *values, size_t stride, double *terms)
{
    for (size_t k = 0; k < LAG_DELAY_TERMS; ++k) {
        double sum = 0.0;
        for (size_t j = 0; j < LAG_DELAY_TERMS; ++j) {
            const size_t turn = j * k % (2 * LAG_DELAY_DEGREE);
            const double cosine = lag_delay_nodes[turn <= LAG_DELAY_DEGREE ? turn : 2 * LAG_DELAY_DEGREE - turn];
            sum += (j == 0 || j == LAG_DELAY_DEGREE ? 0.5 : 1.0) * (values[j * stride] - values[0]) * cosine;
        }
        terms[k] = sum * (k == 0 || k == LAG_DELAY_DEGREE ? 1.0 : 2.0) / LAG_DELAY_DEGREE;
    }
    terms[0] += values[0]; /* so that constants are exact */
}

/* Expression i in a piece, at time t. */
static double value_in(const lag_delays *delays, size_t piece, size_t i, double t, double *rate)
{
    const double a = delays->begin[piece];
    const double half = 0.5 * (delays->begin[piece + 1] - a);
    const double x = fmax(-1.0, fmin(1.0, (t - a) / half - 1.0));
    const double value = sum_of(terms_of(delays, piece, i), x, rate);
    *rate /= half;
    return value;
}

/* ---- pieces ---- */

/* The last piece that begins at time t or before; the first one where none does. */
static size_t piece_at(const lag_delays *delays, double t)
{
    size_t low = delays->first;
    size_t high = delays->count;
    while (high - low > 1) {
        const size_t middle = low + (high - low) / 2;
        if (delays->begin[middle] <= t) {
            low = middle;
        } else {
            high = middle;
        }
    }
    return low;
}

static double longest(const lag_delays *delays)
{
    double most = 0.0;
    for (size_t i = 0; i < delays->motion->model->ndelay; ++i) {
        most = fmax(most, delays->time[i]);
    }
    return most;
}

static void copy_piece(lag_delays *delays, size_t from, size_t to)
{
    const size_t width = delays->motion->model->ndelay * LAG_DELAY_TERMS;
    delays->begin[to] = delays->begin[from];
    delays->order[to] = delays->order[from];
    memmove(delays->terms + to * width, delays->terms + from * width, width * sizeof(double));
}

/* Pieces k and k + 1 as one, into the place behind the last one; 0: it is not as exact. */
static int joins(lag_delays *delays, size_t k)
{
    const size_t n = delays->motion->model->ndelay;
    const double *begin = delays->begin;
    const double half = 0.5 * (begin[k + 2] - begin[k]);
    double joined[LAG_DELAY_TERMS];
    double values[LAG_DELAY_TERMS];
    double rate = 0.0;
    double *const sample = delays->sample;
    for (size_t i = 0; i < n; ++i) {
        for (size_t j = 0; j < LAG_DELAY_TERMS; ++j) {
            const double t = begin[k] + half * (1.0 + lag_delay_nodes[j]);
            values[j] = value_in(delays, t < begin[k + 1] ? k : k + 1, i, t, &rate);
        }
        find_terms(values, 1, joined);
        for (size_t j = 0; j < 2 * LAG_DELAY_TERMS; ++j) {
            const size_t of = k + j / LAG_DELAY_TERMS;
            const double t = begin[of] + 0.5 * (begin[of + 1] - begin[of]) * (1.0 + lag_delay_nodes[j % LAG_DELAY_TERMS]);
            if (fabs(sum_of(joined, (t - begin[k]) / half - 1.0, &rate) - value_in(delays, of, i, t, &rate)) > delays->limit[i]) {
                return 0;
            }
        }
        memcpy(sample + i * LAG_DELAY_TERMS, joined, sizeof joined);
    }
    return 1;
}

/* Makes room: pieces that nobody reads any more go, then neighbours become one, in one pass. */
static lag_status make_room(lag_delays *delays)
{
    const size_t width = delays->motion->model->ndelay * LAG_DELAY_TERMS;
    const double end = delays->begin[delays->count];
    delays->first = piece_at(delays, end - longest(delays));
    const int crowded = delays->first < FREE;
    size_t to = 0;
    for (size_t k = delays->first; k < delays->count; ++k) {
        if (crowded && k + 1 < delays->count && delays->order[k + 1] >= LAG_DELAY_SMOOTH && joins(delays, k)) {
            delays->begin[to] = delays->begin[k];
            delays->order[to] = delays->order[k];
            memcpy(delays->terms + to * width, delays->sample, width * sizeof(double));
            ++k;
        } else {
            copy_piece(delays, k, to);
        }
        ++to;
    }
    delays->first = 0;
    delays->count = to;
    delays->begin[to] = end;
    return to + FREE <= LAG_DELAY_PIECES ? LAG_OK : LAG_LONG_PAST;
}

void lag_delays_try(lag_delays *delays, double tolerance, double end)
{
    const size_t n = delays->motion->model->ndelay;
    delays->begin[delays->count + 1] = end;
    for (size_t i = 0; i < n; ++i) {
        for (size_t j = 0; j < LAG_DELAY_TERMS; ++j) {
            delays->size[i] = fmax(delays->size[i], fabs(delays->sample[j * n + i]));
        }
        delays->limit[i] = fmax(fmax(tolerance, ROUNDING) * delays->size[i], DBL_MIN);
        find_terms(delays->sample + i, n, terms_of(delays, delays->count, i));
    }
}

double lag_delays_misfit(const lag_delays *delays, size_t which, double x, double known)
{
    const double *terms = terms_of(delays, delays->count, which);
    double slope = 0.0;
    return fmax(fabs(terms[LAG_DELAY_DEGREE]), fabs(sum_of(terms, x, &slope) - known)) / delays->limit[which];
}

/* True if expression i jumps where piece k begins. */
static int jumps_before(const lag_delays *delays, size_t k, size_t i)
{
    double rate = 0.0;
    const double before = value_in(delays, k - 1, i, delays->begin[k], &rate);
    return fabs(value_in(delays, k, i, delays->begin[k], &rate) - before) > delays->limit[i];
}

lag_status lag_delays_add(lag_delays *delays, double end)
{
    const size_t n = delays->motion->model->ndelay;
    const size_t k = delays->count;
    int jumps = 0;
    delays->begin[k + 1] = end;
    for (size_t i = 0; i < n && delays->level == 0 && k > delays->first; ++i) {
        jumps = jumps || jumps_before(delays, k, i);
    }
    delays->order[k] = delays->level == 0 && !jumps ? 1.0 : (double)delays->level;
    delays->level = LAG_DELAY_SMOOTH;
    delays->count = k + 1;
    return delays->count + 1 < LAG_DELAY_PIECES ? LAG_OK : make_room(delays);
}

void lag_delays_cut(lag_delays *delays, double t)
{
    while (delays->count > delays->first + 1 && delays->begin[delays->count - 1] >= t) {
        --delays->count;
        delays->level = (int)fmin(delays->level, delays->order[delays->count]);
        for (size_t i = 0; i < delays->motion->model->ndelay; ++i) {
            const int known = delays->ahead[i] < delays->begin[delays->count];
            delays->ahead[i] = known ? delays->ahead[i] : (double)INFINITY;
            delays->clear[i] = fmin(delays->clear[i], delays->begin[delays->count - 1]);
        }
    }
}

/* ---- what is read ---- */

/* How far the expressions are from the present values, into `apart` (ndelay). */
static lag_status compare(lag_delays *delays, double *apart)
{
    const lag_model *model = delays->motion->model;
    const lag_status status = model->delayed(&delays->motion->at, apart, delays->time, &delays->direct);
    lag_axpy(model->ndelay, -1.0, delays->motion->w + delays->value, apart);
    return status;
}

/* Newton's method for expressions of which some read the others or themselves; slopes are from differences. */
static lag_status solve(lag_delays *delays)
{
    const size_t n = delays->motion->model->ndelay;
    double *w = delays->motion->w + delays->value;
    double *matrix = delays->step;
    lag_status status = compare(delays, delays->now);
    for (int k = 0; k < MOST_STEPS && status == LAG_OK && lag_any(n, delays->now); ++k) {
        for (size_t j = 0; j < n && status == LAG_OK; ++j) {
            const double here = w[j];
            const double by = DIFFERENCE * fmax(1.0, fabs(here));
            w[j] = here + by;
            status = compare(delays, delays->other);
            w[j] = here;
            for (size_t i = 0; i < n; ++i) {
                matrix[i * n + j] = (delays->now[i] - delays->other[i]) / by;
            }
        }
        if (status != LAG_OK || !lag_lu(n, matrix, matrix + n * n)) {
            return LAG_NOT_FINITE;
        }
        lag_lu_solve(n, matrix, matrix + n * n, delays->now);
        lag_axpy(n, 1.0, delays->now, w);
        status = compare(delays, delays->now);
    }
    return status;
}

/* Values where nothing has ever changed: those of the expressions. */
static lag_status settle(lag_delays *delays)
{
    lag_motion *motion = delays->motion;
    const size_t n = motion->model->ndelay;
    const lag_status status = motion->model->delayed(&motion->at, delays->now, delays->time, &delays->direct);
    if (status == LAG_OK && delays->direct != 0.0) {
        return solve(delays);
    }
    memcpy(motion->w + delays->value, delays->now, n * sizeof(double));
    return status;
}

void lag_delays_set(lag_delays *delays, double t)
{
    const size_t n = delays->motion->model->ndelay;
    double *value = delays->motion->w + delays->value;
    double *rate = delays->motion->w + delays->rate;
    if (delays->count == 0) {
        lag_fill(n, 0.0, rate);
        if (settle(delays) != LAG_OK) {
            lag_fill(n, (double)NAN, value);
        }
    }
    for (size_t i = 0; i < n && delays->count > 0; ++i) {
        const double at = t - delays->time[i];
        size_t k = piece_at(delays, at);
        while (k > delays->first && delays->begin[k] >= delays->ahead[i]) {
            --k;
        }
        while (k + 1 < delays->count && delays->begin[k + 1] <= delays->from[i]) {
            ++k;
        }
        value[i] = value_in(delays, k, i, at, &rate[i]) + delays->change * delays->size[i];
    }
}

lag_status lag_delays_begin(lag_delays *delays, double t)
{
    const size_t n = delays->motion->model->ndelay;
    const double *value = delays->motion->w + delays->value;
    lag_delays_clear(delays);
    lag_delays_set(delays, t);
    for (size_t i = 0; i < n; ++i) {
        if (!(delays->time[i] > 0.0) || !isfinite(delays->time[i])) {
            return LAG_BAD_DELAY;
        }
        if (!isfinite(value[i])) {
            return LAG_NOT_FINITE;
        }
        delays->from[i] = delays->clear[i] = -(double)INFINITY;
        delays->ahead[i] = (double)INFINITY;
        delays->size[i] = 0.0;
        for (size_t j = 0; j < LAG_DELAY_TERMS; ++j) {
            delays->sample[j * n + i] = value[i];
        }
    }
    delays->begin[0] = t - 2.0 * longest(delays);
    lag_delays_try(delays, 0.0, t);
    delays->level = LAG_DELAY_SMOOTH;
    const lag_status status = lag_delays_add(delays, t);
    delays->level = 1;
    return status;
}

/* ---- jumps ---- */

double lag_delays_shortest(const lag_delays *delays)
{
    double least = (double)INFINITY;
    for (size_t i = 0; i < delays->motion->model->ndelay && delays->count > 0; ++i) {
        least = fmin(least, delays->time[i]);
    }
    return least;
}

/* The first jump behind what is read as delay i, of those known. */
static void look_ahead(lag_delays *delays, size_t i)
{
    size_t k = piece_at(delays, delays->clear[i]);
    while (k < delays->count && !(delays->begin[k] > delays->clear[i] && delays->order[k] < LAG_DELAY_SMOOTH)) {
        ++k;
    }
    delays->ahead[i] = k < delays->count ? delays->begin[k] : (double)INFINITY;
    delays->clear[i] = k < delays->count ? delays->clear[i] : delays->begin[delays->count - 1];
}

double lag_delays_next(lag_delays *delays)
{
    double next = (double)INFINITY;
    for (size_t i = 0; i < delays->motion->model->ndelay && delays->count > 0; ++i) {
        if (delays->ahead[i] == (double)INFINITY) {
            look_ahead(delays, i);
        }
        next = fmin(next, delays->ahead[i] + delays->time[i]);
    }
    return next;
}

void lag_delays_change(lag_delays *delays, double t)
{
    const size_t n = delays->motion->model->ndelay;
    const double reach = t + ULPS * DBL_EPSILON * fmax(fabs(t), longest(delays));
    memcpy(delays->from_before, delays->from, n * sizeof(double));
    memcpy(delays->ahead_before, delays->ahead, n * sizeof(double));
    delays->jumped = 0;
    for (size_t i = 0; i < n; ++i) {
        while (delays->ahead[i] + delays->time[i] <= reach) {
            const size_t piece = piece_at(delays, delays->ahead[i]);
            const int level = (int)delays->order[piece];
            delays->jumped = delays->jumped || (level == 0 && jumps_before(delays, piece, i));
            delays->level = (int)fmin(delays->level, level + (delays->direct == 0.0));
            delays->from[i] = delays->clear[i] = delays->ahead[i];
            look_ahead(delays, i);
        }
    }
}

void lag_delays_take_back(lag_delays *delays)
{
    const size_t n = delays->motion->model->ndelay;
    memcpy(delays->from, delays->from_before, n * sizeof(double));
    memcpy(delays->ahead, delays->ahead_before, n * sizeof(double));
}
