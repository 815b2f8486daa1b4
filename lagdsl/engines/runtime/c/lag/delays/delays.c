#include "lag/delays/delays.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "lag/factorization/lu.h"
#include "lag/linalg/arena.h"
#include "lag/linalg/vector.h"

/* Steps of Newton's method for expressions that read themselves. */
enum { MOST_STEPS = 20 };

size_t lag_delays_memory(const lag_model *model)
{
    const size_t n = model->ndelay;
    return n * (8 + n + 1) + lag_delay_pieces_memory(n);
}

void lag_delays_place(lag_delays *delays, const lag_model *const *model, const lag_arguments *at, double *value, double *rate, double *memory)
{
    const size_t n = (*model)->ndelay;
    memset(delays, 0, sizeof *delays);
    delays->model = model;
    delays->at = at;
    delays->value = value;
    delays->rate = rate;
    delays->jumps.from = lag_take(&memory, n);
    delays->jumps.ahead = lag_take(&memory, n);
    delays->jumps.clear = lag_take(&memory, n);
    delays->jumps.from_before = lag_take(&memory, n);
    delays->jumps.ahead_before = lag_take(&memory, n);
    delays->time = lag_take(&memory, n);
    delays->now = lag_take(&memory, n);
    delays->other = lag_take(&memory, n);
    delays->step = lag_take(&memory, n * (n + 1));
    lag_delay_pieces_place(&delays->pieces, n, memory);
}

void lag_delays_clear(lag_delays *delays)
{
    delays->pieces.first = delays->pieces.count = 0;
}

/* ---- what is read ---- */

lag_status lag_delays_evaluate(lag_delays *delays, double *values)
{
    return (*delays->model)->delayed(delays->at, values, delays->time, &delays->direct);
}

/* Distances of the expressions from the present values, into `apart` (ndelay). */
static lag_status compare(lag_delays *delays, double *apart)
{
    const lag_status status = lag_delays_evaluate(delays, apart);
    lag_axpy(delays->pieces.n, -1.0, delays->value, apart);
    return status;
}

/* Newton's method for expressions of which some read the others or themselves; slopes are from differences. */
static lag_status solve(lag_delays *delays)
{
    const size_t n = delays->pieces.n;
    double *w = delays->value;
    double *matrix = delays->step;
    lag_status status = compare(delays, delays->now);
    for (int k = 0; k < MOST_STEPS && status == LAG_OK && lag_any(n, delays->now); ++k) {
        for (size_t j = 0; j < n && status == LAG_OK; ++j) {
            const double here = w[j];
            const double by = sqrt(DBL_EPSILON) * fmax(1.0, fabs(here));
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
    const lag_status status = lag_delays_evaluate(delays, delays->now);
    if (status == LAG_OK && delays->direct != 0.0) {
        return solve(delays);
    }
    memcpy(delays->value, delays->now, delays->pieces.n * sizeof(double));
    return status;
}

void lag_delays_displace(lag_delays *delays, const double *along, double by)
{
    delays->along = along;
    delays->by = by;
}

size_t lag_delays_piece(const lag_delays *delays, const lag_delay_pieces *pieces, size_t i, double at)
{
    size_t k = lag_delay_piece(pieces, at);
    while (k > pieces->first && pieces->begin[k] >= delays->jumps.ahead[i]) {
        --k;
    }
    while (k + 1 < pieces->count && pieces->begin[k + 1] <= delays->jumps.from[i]) {
        ++k;
    }
    return k;
}

void lag_delays_set(lag_delays *delays, double t)
{
    const lag_delay_pieces *pieces = &delays->pieces;
    if (pieces->count == 0) {
        lag_fill(pieces->n, 0.0, delays->rate);
        if (settle(delays) != LAG_OK) {
            lag_fill(pieces->n, (double)NAN, delays->value);
        }
    }
    for (size_t i = 0; i < pieces->n && pieces->count > 0; ++i) {
        const double at = t - delays->time[i];
        const size_t k = lag_delays_piece(delays, pieces, i, at);
        delays->value[i] = lag_delay_value(pieces, k, i, at, &delays->rate[i]) + delays->change * pieces->size[i];
        if (delays->along != NULL) {
            delays->value[i] += delays->by * delays->along[i];
            delays->rate[i] += delays->by * delays->along[pieces->n + i];
        }
    }
}

lag_status lag_delays_begin(lag_delays *delays, double t)
{
    lag_delay_pieces *pieces = &delays->pieces;
    const size_t n = pieces->n;
    lag_delays_clear(delays);
    lag_delays_set(delays, t);
    pieces->length = 0.0;
    for (size_t i = 0; i < n; ++i) {
        if (!(delays->time[i] > 0.0) || !isfinite(delays->time[i])) {
            return LAG_BAD_DELAY;
        }
        if (!isfinite(delays->value[i])) {
            return LAG_NOT_FINITE;
        }
        pieces->length = fmax(pieces->length, delays->time[i]);
        delays->jumps.from[i] = delays->jumps.clear[i] = -(double)INFINITY;
        delays->jumps.ahead[i] = (double)INFINITY;
    }
    lag_fill(n, 0.0, pieces->size);
    for (size_t j = 0; j < LAG_DELAY_SAMPLES; ++j) {
        memcpy(pieces->sample + j * n, delays->value, n * sizeof(double));
    }
    pieces->begin[0] = t - 2.0 * pieces->length;
    pieces->level = LAG_DELAY_SMOOTH;
    (void)lag_delay_try(pieces, 0.0, t);
    const lag_status status = lag_delay_add(pieces);
    pieces->level = 1;
    return status;
}

void lag_delays_cut(lag_delays *delays, double t)
{
    lag_delay_pieces *pieces = &delays->pieces;
    lag_delay_cut(pieces, t);
    for (size_t i = 0; i < pieces->n; ++i) {
        const double end = lag_delay_end(pieces);
        delays->jumps.ahead[i] = delays->jumps.ahead[i] < end ? delays->jumps.ahead[i] : (double)INFINITY;
        delays->jumps.clear[i] = fmin(delays->jumps.clear[i], pieces->begin[pieces->count - 1]);
    }
}

/* ---- jumps ---- */

double lag_delays_shortest(const lag_delays *delays)
{
    double least = (double)INFINITY;
    for (size_t i = 0; i < delays->pieces.n && delays->pieces.count > 0; ++i) {
        least = fmin(least, delays->time[i]);
    }
    return least;
}

/* The first jump behind what is read as delay i, of those known. */
static void find_next_jump(lag_delays *delays, size_t i)
{
    const lag_delay_pieces *pieces = &delays->pieces;
    double *clear = &delays->jumps.clear[i];
    size_t k = lag_delay_piece(pieces, *clear);
    while (k < pieces->count && !(pieces->begin[k] > *clear && pieces->order[k] < LAG_DELAY_SMOOTH)) {
        ++k;
    }
    delays->jumps.ahead[i] = k < pieces->count ? pieces->begin[k] : (double)INFINITY;
    *clear = k < pieces->count ? *clear : pieces->begin[pieces->count - 1];
}

double lag_delays_next(lag_delays *delays)
{
    double next = (double)INFINITY;
    for (size_t i = 0; i < delays->pieces.n && delays->pieces.count > 0; ++i) {
        if (delays->jumps.ahead[i] == (double)INFINITY) {
            find_next_jump(delays, i);
        }
        next = fmin(next, delays->jumps.ahead[i] + delays->time[i]);
    }
    return next;
}

void lag_delays_change(lag_delays *delays, double t)
{
    lag_delay_pieces *pieces = &delays->pieces;
    lag_delay_jumps *jumps = &delays->jumps;
    memcpy(jumps->from_before, jumps->from, pieces->n * sizeof(double));
    memcpy(jumps->ahead_before, jumps->ahead, pieces->n * sizeof(double));
    jumps->any = 0;
    for (size_t i = 0; i < pieces->n; ++i) {
        while (jumps->ahead[i] + delays->time[i] <= t) {
            const size_t piece = lag_delay_piece(pieces, jumps->ahead[i]);
            const double level = pieces->order[piece];
            jumps->any = jumps->any || (level == 0.0 && lag_delay_is_jump(pieces, piece, i));
            pieces->level = (int)fmin(pieces->level, level + (delays->direct == 0.0 ? 1.0 : 0.0));
            jumps->from[i] = jumps->clear[i] = jumps->ahead[i];
            find_next_jump(delays, i);
        }
    }
}

void lag_delays_take_back(lag_delays *delays)
{
    memcpy(delays->jumps.from, delays->jumps.from_before, delays->pieces.n * sizeof(double));
    memcpy(delays->jumps.ahead, delays->jumps.ahead_before, delays->pieces.n * sizeof(double));
}
