/*
 * The linear systems of a Radau method: decomposed, and solved, as dense matrices or in the band that an order of the states leaves
 * (lag/elimination/band.h). The order is that of the entries that are not zero in the Jacobian at hand, so that nothing outside of the band
 * is left out.
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
/* Sweeps over all entries to find the order and to fill the band, as if they were multiplications. */
enum { SWEEPS = 2 };
/* True if elimination in the band is so much shorter. */
static int pays(const lag_band *band)
{
    const double m = (double)band->n;
    return lag_band_width(band) <= band->n && WORTH_A_BAND * (lag_band_operations(band) + SWEEPS * m * m) <= m * m * m / 3.0;
}

/* Entry i of the Jacobian that is decomposed: at the start of the step, or at its middle. */
static double entry(const lag_radau_places *at, size_t i)
{
    return at->memo->turning > 0.0 ? at->jacobian[i] + 0.5 * at->change[i] - 0.25 * at->bend[i] : at->jacobian[i];
}

/* True if the Jacobian, or one that changes along the step, has entry i. */
static int is_entry(const lag_radau_places *at, size_t i)
{
    return at->jacobian[i] != 0.0 || (at->memo->turning > 0.0 && (at->change[i] != 0.0 || at->bend[i] != 0.0));
}

/* 1 where the matrices may have an entry. */
static void find_pattern(const lag_ode *ode, const lag_radau_places *at, double *pattern)
{
    const size_t m = lag_radau_others(ode);
    size_t count = ode->nq;
    for (size_t i = 0; i < m; ++i) {
        const size_t row = (ode->nq + i) * ode->size;
        for (size_t j = 0; j < m; ++j) {
            const int of_rates = is_entry(at, row + ode->nq + j);
            const int of_coordinates = j < ode->nq && is_entry(at, row + j);
            pattern[i * m + j] = of_rates || of_coordinates ? 1.0 : 0.0;
            count += (size_t)of_rates + (size_t)of_coordinates;
        }
    }
    at->memo->entries = (double)count;
}

static void keep_band(const lag_band *band, const lag_radau_places *at)
{
    at->memo->lower = (double)band->lower;
    at->memo->upper = (double)band->upper;
    at->memo->banded = pays(band) ? 1.0 : 0.0;
}

/* The order for the Jacobian at hand: the one before, unless the band in it is wider than it was. */
static void find_order(const lag_ode *ode, const lag_radau_places *at)
{
    const size_t m = lag_radau_others(ode);
    lag_radau_memo *memo = at->memo;
    double *place = at->order + m;
    const lag_band diagonal = {m, 0, 0};
    const int first = memo->ordered == 0.0;
    memo->entries = (double)(ode->size * ode->size);
    if (pays(&diagonal)) {
        find_pattern(ode, at, at->real);
        lag_band band = first ? diagonal : lag_band_of(m, at->real, at->order, place);
        if (first || band.lower > (size_t)memo->lower || band.upper > (size_t)memo->upper) {
            lag_cuthill_mckee(m, at->real, at->order, at->complex);
            band = lag_band_of(m, at->real, at->order, place);
            keep_band(&band, at);
        }
        memo->ordered = 1.0;
    }
    for (size_t i = 0; i < m && memo->banded == 0.0; ++i) {
        at->order[i] = (double)i;
    }
}

/* A row of the matrices, by the Jacobian: [first] to before [end] of `rates`, and of `coordinates`. */
typedef struct band_row {
    size_t first, end, end_of_coordinates;
    double *rates, *coordinates;
} band_row;

static band_row row_of(const lag_ode *ode, const lag_radau_places *at, size_t i)
{
    const lag_band band = lag_radau_band(ode, at);
    const size_t m = band.n;
    const size_t span = band.lower + band.upper + 1;
    const size_t first = lag_band_first(&band, i);
    const size_t end = lag_band_end(&band, i);
    if (at->memo->banded == 0.0) {
        return (band_row){0, m, ode->nq, at->rows + i * m, at->rows + m * m + i * ode->nq};
    }
    double *rates = at->rows + band.lower + i * (span - 1);
    return (band_row){first, end, ode->nq > 0 ? end : first, rates, rates + m * span};
}

/* The Jacobian, in the order of the matrices. */
static void put_in_order(const lag_ode *ode, const lag_radau_places *at)
{
    for (size_t i = 0; i < lag_radau_others(ode); ++i) {
        const band_row to = row_of(ode, at, i);
        const size_t from = (ode->nq + (size_t)at->order[i]) * ode->size;
        for (size_t j = to.first; j < to.end; ++j) {
            to.rates[j] = entry(at, from + ode->nq + (size_t)at->order[j]);
        }
        for (size_t j = to.first; j < to.end_of_coordinates; ++j) {
            const size_t coordinate = (size_t)at->order[j];
            to.coordinates[j] = coordinate < ode->nq ? entry(at, from + coordinate) : 0.0;
        }
    }
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
        const band_row from = row_of(ode, at, i);
        const size_t begin = at->memo->banded != 0.0 ? band.lower + i * (lag_band_width(&band) - 1) : i * band.n;
        double *to = matrix + parts * begin;
        for (size_t j = from.first; j < from.end; ++j) {
            to[parts * j] = -from.rates[j];
        }
        for (size_t part = 0; part < parts; ++part) {
            for (size_t j = from.first; j < from.end_of_coordinates; ++j) {
                to[parts * j + part] -= inverse.value[part] * from.coordinates[j];
            }
            to[parts * i + part] += shift->value[part];
        }
    }
}

/* Doubles of a matrix of so many parts. */
static size_t numbers(const lag_ode *ode, const lag_radau_places *at, size_t parts)
{
    const lag_band band = lag_radau_band(ode, at);
    return parts * band.n * (at->memo->banded != 0.0 ? lag_band_width(&band) : band.n);
}

static double *matrix_of_pair(const lag_ode *ode, const lag_radau_places *at, size_t pair)
{
    return at->complex + 2 * ode->size * ode->size * pair;
}

static int decompose_real(const lag_ode *ode, const lag_radau_places *at, double h)
{
    const lag_band band = lag_radau_band(ode, at);
    const number shift = real_shift(at, h);
    memset(at->real, 0, numbers(ode, at, 1) * sizeof(double));
    fill(ode, at, &shift, at->real);
    return at->memo->banded != 0.0 ? lag_band_lu(&band, at->real, at->pivots) : lag_lu(band.n, at->real, at->pivots);
}

static int decompose_pair(const lag_ode *ode, const lag_radau_places *at, size_t pair, double h)
{
    const lag_band band = lag_radau_band(ode, at);
    const number shift = pair_shift(at, pair, h);
    double *matrix = matrix_of_pair(ode, at, pair);
    double *pivots = at->pivots + (1 + pair) * ode->size;
    memset(matrix, 0, numbers(ode, at, 2) * sizeof(double));
    fill(ode, at, &shift, matrix);
    return at->memo->banded != 0.0 ? lag_band_lu_complex(&band, matrix, pivots) : lag_lu_complex(band.n, matrix, pivots);
}

void lag_radau_order(const lag_ode *ode, const lag_radau_places *at)
{
    find_order(ode, at);
    put_in_order(ode, at);
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
        lag_radau_order(ode, at);
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

/* Coordinates of x (parts, n) give this to the right side; the other numbers of x are lost. */
static void add_coordinates(const lag_ode *ode, const lag_radau_places *at, const number *inverse, double *x, double *right)
{
    const size_t n = ode->size;
    const size_t m = lag_radau_others(ode);
    for (size_t k = 0; k < inverse->parts * m; ++k) {
        const size_t i = k % m;
        const size_t coordinate = (size_t)at->order[i];
        x[k / m * n + ode->nq + i] = coordinate < ode->nq ? x[k / m * n + coordinate] : 0.0;
    }
    multiply(m, n, inverse, x + ode->nq);
    for (size_t i = 0; i < m; ++i) {
        const band_row of = row_of(ode, at, i);
        for (size_t part = 0; part < inverse->parts; ++part) {
            const double *ordered = x + part * n + ode->nq;
            double sum = 0.0;
            for (size_t j = of.first; j < of.end_of_coordinates; ++j) {
                sum += of.coordinates[j] * ordered[j];
            }
            right[inverse->parts * i + part] += sum;
        }
    }
}

/* The right side of the equations without coordinates, `right` (others, parts), of x (parts, n), which keeps its coordinates only. */
static void eliminate(const lag_ode *ode, const lag_radau_places *at, const number *shift, double *x, double *right)
{
    const size_t parts = shift->parts;
    const size_t m = lag_radau_others(ode);
    for (size_t part = 0; part < parts; ++part) {
        const double *from = x + part * ode->size + ode->nq;
        for (size_t i = 0; i < m; ++i) {
            right[parts * i + part] = from[(size_t)at->order[i]];
        }
    }
    if (ode->nq > 0) {
        const number inverse = inverse_of(shift);
        add_coordinates(ode, at, &inverse, x, right);
    }
}

/* The solution of these equations into x, and the coordinates that follow. */
static void substitute(const lag_ode *ode, const lag_radau_places *at, const number *shift, const double *right, double *x)
{
    const size_t n = ode->size;
    const size_t parts = shift->parts;
    const size_t m = lag_radau_others(ode);
    for (size_t part = 0; part < parts; ++part) {
        double *coordinates = x + part * n;
        double *to = coordinates + ode->nq;
        for (size_t i = 0; i < m; ++i) {
            to[(size_t)at->order[i]] = right[parts * i + part];
        }
        for (size_t i = 0; i < ode->nq; ++i) {
            coordinates[i] += to[i];
        }
    }
    if (ode->nq > 0) {
        const number inverse = inverse_of(shift);
        multiply(ode->nq, n, &inverse, x);
    }
}

void lag_radau_solve_real(const lag_ode *ode, const lag_radau_places *at, double *x)
{
    const lag_band band = lag_radau_band(ode, at);
    const number shift = real_shift(at, at->memo->decomposed);
    double *right = at->order + 2 * ode->size;
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
    const lag_band band = lag_radau_band(ode, at);
    const int banded = at->memo->banded != 0.0;
    memset(out, 0, ode->nq * sizeof(double));
    for (size_t i = 0; i < band.n; ++i) {
        const size_t row = ode->nq + (banded ? (size_t)at->order[i] : i);
        const double *change = at->change + row * ode->size;
        const double *bend = at->bend + row * ode->size;
        double sum = 0.0;
        for (size_t j = 0; j < ode->size && !banded; ++j) {
            sum += (change[j] + part * bend[j]) * x[j];
        }
        for (size_t j = lag_band_first(&band, i); j < lag_band_end(&band, i) && banded; ++j) {
            const size_t column = (size_t)at->order[j];
            const size_t rate = ode->nq + column;
            sum += (change[rate] + part * bend[rate]) * x[rate];
            sum += column < ode->nq ? (change[column] + part * bend[column]) * x[column] : 0.0;
        }
        out[row] = part * sum;
    }
}
