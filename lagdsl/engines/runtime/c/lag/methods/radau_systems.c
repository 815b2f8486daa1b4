/*
 * The linear systems of a Radau method: decomposed, and solved, as dense matrices or in the band that an order of the states leaves
 * (lag/elimination/band.h). The order is that of the entries that can be nonzero, which the model tells.
 *
 * Coordinates are eliminated first: their equations, shift q - v = a, need no matrix. With the Jacobian of the others by themselves, B, and by
 * coordinates, A, there remains (shift I - B - A / shift) v = b + A a / shift, of half as many numbers where all are coordinates and rates.
 *
 * Source of that: Hairer and Wanner, Solving Ordinary Differential Equations II, 2nd ed., section IV.8, "second order systems".
 */
#include <math.h>
#include <string.h>

#include "lag/elimination/band.h"
#include "lag/elimination/lu.h"
#include "lag/methods/radau.h"

/* A band has to save so much of the multiplications of a dense elimination: its inner loops are short. */
enum { WORTH_A_BAND = 4 };

/* True if elimination in the band is so much shorter. */
static int pays(const lag_band *band)
{
    const double m = (double)band->n;
    return lag_band_width(band) <= band->n && WORTH_A_BAND * lag_band_operations(band) <= m * m * m / 3.0;
}

/* Of the matrices, the row or column of this one of the rates and states, */
static size_t place_of(const lag_ode *ode, const lag_radau_memo *memo, size_t i)
{
    return memo->banded != 0.0 ? ode->patterns->place[i] : i;
}

/* and that of a column of the Jacobian: columns of coordinates come under those of their rates. */
static size_t column_of(const lag_ode *ode, size_t column)
{
    return column < ode->nq ? column : column - ode->nq;
}

lag_band lag_radau_band_of(const lag_ode *ode)
{
    const size_t m = lag_radau_others(ode);
    const lag_pattern *pattern = lag_ode_pattern(ode);
    lag_band band = {m, 0, 0};
    for (size_t i = 0; i < m && pattern != NULL; ++i) {
        const size_t row = ode->patterns->place[i];
        for (size_t k = pattern->first[i]; k < pattern->first[i + 1]; ++k) {
            const size_t column = ode->patterns->place[column_of(ode, pattern->column[k])];
            const size_t below = row > column ? row - column : 0;
            const size_t above = column > row ? column - row : 0;
            band.lower = below > band.lower ? below : band.lower;
            band.upper = above > band.upper ? above : band.upper;
        }
    }
    return pattern != NULL && pays(&band) ? band : (lag_band){m, m, m};
}

void lag_radau_keep_band(lag_radau_memo *memo, const lag_ode *ode)
{
    const lag_band band = lag_radau_band_of(ode);
    memo->lower = (double)band.lower;
    memo->upper = (double)band.upper;
    memo->banded = band.lower < band.n ? 1.0 : 0.0;
}

/* A number of one or two parts. */
typedef struct number {
    size_t parts;
    double value[2];
} number;

/* The shift of the real system, or of a pair. */
static number real_shift(const lag_radau_places *at, double h)
{
    return (number){1, {at->table->mu / h, 0.0}};
}

static number pair_shift(const lag_radau_places *at, size_t pair, double h)
{
    return (number){2, {at->table->alpha[pair] / h, -at->table->beta[pair] / h}};
}

static number inverse_of(const number *a)
{
    const double square = a->value[0] * a->value[0] + a->value[1] * a->value[1];
    return (number){a->parts, {a->value[0] / square, -a->value[1] / square}};
}

/* shift I - J, its coordinates eliminated, into `matrix`, which is zero: numbers of as many parts as the shift has. */
static void fill(const lag_ode *ode, const lag_radau_places *at, const number *shift, double *matrix)
{
    const lag_band band = lag_radau_band(ode, at);
    const number inverse = inverse_of(shift);
    const size_t parts = shift->parts;
    for (size_t i = 0; i < band.n; ++i) {
        const lag_radau_row row = lag_radau_row_of(ode, i);
        const size_t place = place_of(ode, at->memo, i);
        const size_t begin = at->memo->banded != 0.0 ? band.lower + place * (lag_band_width(&band) - 1) : place * band.n;
        double *to = matrix + parts * begin;
        for (size_t k = row.first; k < row.end; ++k) {
            const size_t column = row.column != NULL ? row.column[k] : k - row.first;
            double *entry = to + parts * place_of(ode, at->memo, column_of(ode, column));
            const int is_rate = column >= ode->nq;
            entry[0] -= is_rate ? at->middle[k] : inverse.value[0] * at->middle[k];
            if (parts == 2 && !is_rate) {
                entry[1] -= inverse.value[1] * at->middle[k];
            }
        }
        for (size_t part = 0; part < parts; ++part) {
            to[parts * place + part] += shift->value[part];
        }
    }
}

static double *matrix_of_pair(const lag_ode *ode, const lag_radau_places *at, size_t pair)
{
    return at->complex + 2 * lag_radau_matrix(ode, at->memo) * pair;
}

static int decompose_real(const lag_ode *ode, const lag_radau_places *at, double h)
{
    const lag_band band = lag_radau_band(ode, at);
    const number shift = real_shift(at, h);
    memset(at->real, 0, lag_radau_matrix(ode, at->memo) * sizeof(double));
    fill(ode, at, &shift, at->real);
    return at->memo->banded != 0.0 ? lag_band_lu(&band, at->real, at->pivots) : lag_lu(band.n, at->real, at->pivots);
}

static int decompose_pair(const lag_ode *ode, const lag_radau_places *at, size_t pair, double h)
{
    const lag_band band = lag_radau_band(ode, at);
    const number shift = pair_shift(at, pair, h);
    double *matrix = matrix_of_pair(ode, at, pair);
    double *pivots = at->pivots + (1 + pair) * ode->size;
    memset(matrix, 0, 2 * lag_radau_matrix(ode, at->memo) * sizeof(double));
    fill(ode, at, &shift, matrix);
    return at->memo->banded != 0.0 ? lag_band_lu_complex(&band, matrix, pivots) : lag_lu_complex(band.n, matrix, pivots);
}

/* The Jacobian that is decomposed: at the start of the step, or at its middle. */
static void find_middle(const lag_ode *ode, const lag_radau_places *at)
{
    const size_t count = lag_radau_entries(ode);
    memcpy(at->middle, at->jacobian, count * sizeof(double));
    for (size_t k = 0; k < count && at->memo->turning > 0.0; ++k) {
        at->middle[k] += 0.5 * at->change[k] - 0.25 * at->bend[k];
    }
    at->memo->placed = 1.0;
}

lag_status lag_radau_decompose(lag_stepper *s, const lag_radau_places *at, double h)
{
    const lag_ode *ode = s->ode;
    if (at->memo->decomposed == h) {
        return LAG_OK;
    }
    ++s->counts.decompositions;
    if (at->memo->placed == 0.0) {
        find_middle(ode, at);
    }
    int regular = decompose_real(ode, at, h);
    for (size_t pair = 0; 2 * pair + 1 < at->table->stages && regular; ++pair) {
        regular = decompose_pair(ode, at, pair, h);
    }
    at->memo->decomposed = regular ? h : 0.0;
    return regular ? LAG_OK : LAG_SINGULAR;
}

/* x by a, of arrays of `count` numbers, whose parts are `apart`. */
static void multiply(size_t count, size_t apart, const number *a, double *x)
{
    for (size_t i = 0; i < count && a->parts == 1; ++i) {
        x[i] *= a->value[0];
    }
    for (size_t i = 0; i < count && a->parts == 2; ++i) {
        const double re = a->value[0] * x[i] - a->value[1] * x[apart + i];
        x[apart + i] = a->value[0] * x[apart + i] + a->value[1] * x[i];
        x[i] = re;
    }
}

/* The entries of a row in columns of coordinates times what is there: `sum` of as many parts, which are n apart in x. */
static void of_coordinates(const lag_ode *ode, const lag_radau_row *row, const double *entry, size_t parts, const double *x, double sum[2])
{
    const double *other = x + (parts - 1) * ode->size; /* of one part the same twice */
    sum[0] = sum[1] = 0.0;
    for (size_t j = 0; j < ode->nq && row->column == NULL; ++j) {
        sum[0] += entry[row->first + j] * x[j];
        sum[1] += entry[row->first + j] * other[j];
    }
    for (size_t k = row->first; row->column != NULL && k < row->end && row->column[k] < ode->nq; ++k) {
        sum[0] += entry[k] * x[row->column[k]];
        sum[1] += entry[k] * other[row->column[k]];
    }
}

/* The right side of the equations without coordinates, `right` (others, parts), of x (parts, n), which keeps its coordinates only. */
static void eliminate(const lag_ode *ode, const lag_radau_places *at, const number *shift, double *x, double *right)
{
    const size_t n = ode->size;
    const size_t parts = shift->parts;
    const number inverse = inverse_of(shift);
    for (size_t part = 0; part < parts; ++part) {
        double *others = x + part * n + ode->nq;
        for (size_t i = 0; i < lag_radau_others(ode); ++i) {
            right[parts * place_of(ode, at->memo, i) + part] = others[i];
        }
        memcpy(others, x + part * n, ode->nq * sizeof(double));
    }
    multiply(ode->nq, n, &inverse, x + ode->nq);
    for (size_t i = 0; i < lag_radau_others(ode) && ode->nq > 0; ++i) {
        const lag_radau_row row = lag_radau_row_of(ode, i);
        const size_t place = place_of(ode, at->memo, i);
        double sum[2];
        of_coordinates(ode, &row, at->middle, parts, x + ode->nq, sum);
        for (size_t part = 0; part < parts; ++part) {
            right[parts * place + part] += sum[part];
        }
    }
}

/* The solution of these equations into x, and the coordinates that follow. */
static void substitute(const lag_ode *ode, const lag_radau_places *at, const number *shift, const double *right, double *x)
{
    const size_t n = ode->size;
    const size_t parts = shift->parts;
    const number inverse = inverse_of(shift);
    for (size_t part = 0; part < parts; ++part) {
        double *coordinates = x + part * n;
        double *to = coordinates + ode->nq;
        for (size_t i = 0; i < lag_radau_others(ode); ++i) {
            to[i] = right[parts * place_of(ode, at->memo, i) + part];
        }
        for (size_t i = 0; i < ode->nq; ++i) {
            coordinates[i] += to[i];
        }
    }
    multiply(ode->nq, n, &inverse, x);
}

void lag_radau_solve_real(const lag_ode *ode, const lag_radau_places *at, double *x)
{
    const lag_band band = lag_radau_band(ode, at);
    const number shift = real_shift(at, at->memo->decomposed);
    double *right = at->reduced;
    eliminate(ode, at, &shift, x, right);
    if (at->memo->banded != 0.0) {
        lag_band_solve(&band, at->real, at->pivots, right);
    } else {
        lag_lu_solve(band.n, at->real, at->pivots, right);
    }
    substitute(ode, at, &shift, right, x);
}

/* Both parts of x (2, n). */
static void solve_pair(const lag_ode *ode, const lag_radau_places *at, size_t pair, double *x)
{
    const lag_band band = lag_radau_band(ode, at);
    const number shift = pair_shift(at, pair, at->memo->decomposed);
    double *matrix = matrix_of_pair(ode, at, pair);
    const double *pivots = at->pivots + (1 + pair) * ode->size;
    eliminate(ode, at, &shift, x, at->right);
    if (at->memo->banded != 0.0) {
        lag_band_solve_complex(&band, matrix, pivots, at->right);
    } else {
        lag_lu_complex_solve(band.n, matrix, pivots, at->right);
    }
    substitute(ode, at, &shift, at->right, x);
}

void lag_radau_decomposed(const lag_ode *ode, const lag_radau_places *at, double *x)
{
    lag_radau_solve_real(ode, at, x);
    for (size_t pair = 0; 2 * pair + 1 < at->table->stages; ++pair) {
        solve_pair(ode, at, pair, x + (2 * pair + 1) * ode->size);
    }
}

void lag_radau_changed(const lag_ode *ode, const lag_radau_places *at, double part, const double *x, double *out)
{
    memset(out, 0, ode->nq * sizeof(double));
    for (size_t i = 0; i < lag_radau_others(ode); ++i) {
        const lag_radau_row row = lag_radau_row_of(ode, i);
        double sum = 0.0;
        for (size_t k = row.first; k < row.end; ++k) {
            sum += (at->change[k] + part * at->bend[k]) * x[row.column == NULL ? k - row.first : row.column[k]];
        }
        out[ode->nq + i] = part * sum;
    }
}
