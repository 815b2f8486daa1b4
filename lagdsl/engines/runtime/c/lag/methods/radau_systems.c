/*
 * The linear systems of a Radau method, decomposed and solved.
 *
 * Coordinates are eliminated first: their equations, shift q - v = a, need no matrix. With the Jacobian of the others by themselves, B, and by
 * coordinates, A, there remains (shift I - B - A / shift) v = b + A a / shift, of half as many numbers where all are coordinates and rates.
 *
 * B and A have the inverse of M in them, which is dense where M couples the coordinates of a long chain. A model that tells the entries of its equations
 * (lag_patterns) is solved by these: with r = M vd - f - J' lam and s = J vd - gamma at frozen vd and lam, and vd = shift v - b,
 *
 *     (shift M + r_v + r_q / shift) v - J' lam = M b - r_q a / shift ,   (shift J + s_v + s_q / shift) v = J b - s_q a / shift ,
 *
 * in a band (lag/elimination/band.h), rows and columns in the order that the model tells, multipliers among them. Rates of states, zd = g, join in.
 *
 * Source of that: Hairer and Wanner, Solving Ordinary Differential Equations II, 2nd ed., section IV.8, "second order systems".
 */
#include <math.h>
#include <string.h>

#include "lag/elimination/band.h"
#include "lag/elimination/lu.h"
#include "lag/linalg/linalg.h"
#include "lag/linalg/vector.h"
#include "lag/methods/radau.h"

/* Of the matrices, the row or column of this one of the unknowns: the rates, the states, the multipliers of equations. */
static size_t place_of(const lag_ode *ode, size_t i)
{
    return lag_radau_is_sparse(ode) ? ode->patterns->place[i] : i;
}

/* True for the column of an acceleration. */
static int is_acceleration(const lag_ode *ode, size_t column)
{
    return column >= ode->size && column < ode->size + ode->nq;
}

/* The unknown of a column of the Jacobian: coordinates and accelerations come under their rates, multipliers behind the others. */
static size_t unknown_of(const lag_ode *ode, size_t column)
{
    if (column < ode->size) {
        return column < ode->nq ? column : column - ode->nq;
    }
    return is_acceleration(ode, column) ? column - ode->size : column - 2 * ode->nq;
}

void lag_radau_keep_band(lag_radau_memo *memo, const lag_ode *ode)
{
    const size_t m = lag_radau_rows(ode);
    const lag_pattern *pattern = lag_ode_pattern(ode);
    memo->lower = memo->upper = pattern == NULL ? (double)m : 0.0;
    for (size_t k = 0; pattern != NULL && k < pattern->count; ++k) {
        const double offset = (double)place_of(ode, unknown_of(ode, pattern->column[k])) - (double)place_of(ode, pattern->row[k]);
        memo->lower = fmax(memo->lower, -offset);
        memo->upper = fmax(memo->upper, offset);
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

/* So that entry (row, j) of a matrix of numbers of so many parts is at parts * j. */
static double *row_of(const lag_ode *ode, const lag_radau_places *at, size_t row, size_t parts, double *matrix)
{
    const lag_band band = lag_radau_band(ode, at);
    return matrix + parts * (lag_radau_is_sparse(ode) ? band.lower + row * (lag_band_width(&band) - 1) : row * band.n);
}

/*
 * Rows of constraints that depend on others leave open how these share a force; the diagonal of multipliers is so small a part of what the forces of
 * their rows move the heaviest coordinate by, so that there is a solution. It is an error of the matrix only: iterations take it back. Rows that are
 * zero, those of open contacts, get any number.
 */
enum { OPEN = 100 }; /* roundings */

static void close_multipliers(const lag_ode *ode, const lag_radau_places *at, const number *shift, double *matrix)
{
    for (size_t i = lag_radau_others(ode); i < lag_radau_rows(ode); ++i) {
        const lag_radau_row row = lag_radau_row_of(ode, i);
        const size_t place = place_of(ode, i);
        double square = 0.0;
        double heaviest = 0.0;
        for (size_t k = row.first; k < row.end; ++k) {
            if (at->middle[k] != 0.0 && is_acceleration(ode, row.column[k])) {
                const size_t own = place_of(ode, unknown_of(ode, row.column[k]));
                const double *diagonal = row_of(ode, at, own, shift->parts, matrix) + shift->parts * own;
                heaviest = fmax(heaviest, hypot(diagonal[0], shift->parts == 2 ? diagonal[1] : 0.0));
                square += at->middle[k] * at->middle[k];
            }
        }
        const double moved = heaviest > 0.0 ? OPEN * LAG_ROUNDING * hypot(shift->value[0], shift->value[1]) * square / heaviest : 0.0;
        row_of(ode, at, place, shift->parts, matrix)[shift->parts * place] += square > 0.0 ? moved : 1.0;
    }
}

/* shift I - J, its coordinates eliminated, into `matrix`, which is zero: numbers of as many parts as the shift has. */
static void fill(const lag_ode *ode, const lag_radau_places *at, const number *shift, double *matrix)
{
    static const number one = {1, {1.0, 0.0}};
    const number inverse = inverse_of(shift);
    const size_t parts = shift->parts;
    for (size_t i = 0; i < lag_radau_rows(ode); ++i) {
        const lag_radau_row row = lag_radau_row_of(ode, i);
        const size_t place = place_of(ode, i);
        double *to = row_of(ode, at, place, parts, matrix);
        for (size_t k = row.first; k < row.end; ++k) {
            const size_t column = row.column != NULL ? row.column[k] : k - row.first;
            double *entry = to + parts * place_of(ode, unknown_of(ode, column));
            const number *factor = column < ode->nq ? &inverse : is_acceleration(ode, column) ? shift : &one;
            for (size_t part = 0; part < factor->parts; ++part) {
                entry[part] -= factor->value[part] * at->middle[k];
            }
        }
        for (size_t part = 0; part < parts && lag_radau_is_rate(ode, i); ++part) {
            to[parts * place + part] += shift->value[part];
        }
    }
    close_multipliers(ode, at, shift, matrix);
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
    return lag_radau_is_sparse(ode) ? lag_band_lu(&band, at->real, at->pivots) : lag_lu(band.n, at->real, at->pivots);
}

static int decompose_pair(const lag_ode *ode, const lag_radau_places *at, size_t pair, double h)
{
    const lag_band band = lag_radau_band(ode, at);
    const number shift = pair_shift(at, pair, h);
    double *matrix = matrix_of_pair(ode, at, pair);
    double *pivots = at->pivots + 2 * (1 + pair) * lag_radau_rows(ode);
    memset(matrix, 0, 2 * lag_radau_matrix(ode, at->memo) * sizeof(double));
    fill(ode, at, &shift, matrix);
    return lag_radau_is_sparse(ode) ? lag_band_lu_complex(&band, matrix, pivots) : lag_lu_complex(band.n, matrix, pivots);
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

/* The entries of a row in columns of coordinates times what is there: `sum` of as many parts, which are `size` apart in x. */
static void of_coordinates(const lag_ode *ode, const lag_radau_row *row, const double *entry, size_t parts, const double *x, double sum[2])
{
    const double *other = x + (parts - 1) * lag_radau_size(ode); /* of one part the same twice */
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

/* The right side of the equations without coordinates, at->reduced (m, parts), of x (parts, size), which keeps its coordinates only. */
static void eliminate(const lag_ode *ode, const lag_radau_places *at, const number *shift, double *x)
{
    const size_t size = lag_radau_size(ode);
    const size_t parts = shift->parts;
    const number inverse = inverse_of(shift);
    for (size_t part = 0; part < parts; ++part) {
        double *others = x + part * size + ode->nq;
        for (size_t i = 0; i < lag_radau_rows(ode); ++i) {
            at->reduced[parts * place_of(ode, i) + part] = others[i];
        }
        memcpy(others, x + part * size, ode->nq * sizeof(double));
    }
    multiply(ode->nq, size, &inverse, x + ode->nq);
    for (size_t i = 0; i < lag_radau_rows(ode) && ode->nq > 0; ++i) {
        const lag_radau_row row = lag_radau_row_of(ode, i);
        const size_t place = place_of(ode, i);
        double sum[2];
        of_coordinates(ode, &row, at->middle, parts, x + ode->nq, sum);
        for (size_t part = 0; part < parts; ++part) {
            at->reduced[parts * place + part] += sum[part];
        }
    }
}

/* The solution of these equations into x, and the coordinates that follow. */
static void substitute(const lag_ode *ode, const lag_radau_places *at, const number *shift, double *x)
{
    const size_t size = lag_radau_size(ode);
    const size_t parts = shift->parts;
    const number inverse = inverse_of(shift);
    for (size_t part = 0; part < parts; ++part) {
        double *coordinates = x + part * size;
        double *to = coordinates + ode->nq;
        for (size_t i = 0; i < lag_radau_rows(ode); ++i) {
            to[i] = at->reduced[parts * place_of(ode, i) + part];
        }
        for (size_t i = 0; i < ode->nq; ++i) {
            coordinates[i] += to[i];
        }
    }
    multiply(ode->nq, size, &inverse, x);
}

static void solve_real(const lag_ode *ode, const lag_radau_places *at, double *x)
{
    const lag_band band = lag_radau_band(ode, at);
    const number shift = real_shift(at, at->memo->decomposed);
    eliminate(ode, at, &shift, x);
    if (lag_radau_is_sparse(ode)) {
        lag_band_solve(&band, at->real, at->pivots, at->reduced);
    } else {
        lag_lu_solve(band.n, at->real, at->pivots, at->reduced);
    }
    substitute(ode, at, &shift, x);
}

/* Both parts of x (2, size). */
static void solve_pair(const lag_ode *ode, const lag_radau_places *at, size_t pair, double *x)
{
    const lag_band band = lag_radau_band(ode, at);
    const number shift = pair_shift(at, pair, at->memo->decomposed);
    double *matrix = matrix_of_pair(ode, at, pair);
    const double *pivots = at->pivots + 2 * (1 + pair) * lag_radau_rows(ode);
    eliminate(ode, at, &shift, x);
    if (lag_radau_is_sparse(ode)) {
        lag_band_solve_complex(&band, matrix, pivots, at->reduced);
    } else {
        lag_lu_complex_solve(band.n, matrix, pivots, at->reduced);
    }
    substitute(ode, at, &shift, x);
}

void lag_radau_decomposed(const lag_ode *ode, const lag_radau_places *at, double *sides)
{
    solve_real(ode, at, sides);
    for (size_t pair = 0; 2 * pair + 1 < at->table->stages; ++pair) {
        solve_pair(ode, at, pair, sides + (2 * pair + 1) * lag_radau_size(ode));
    }
}

/* The first entry of a row, whose columns ascend, that is in a column from `column` on. */
static size_t entry_from(const lag_radau_row *row, size_t column)
{
    size_t first = row->first;
    size_t end = row->end;
    while (first < end) {
        const size_t middle = first + (end - first) / 2;
        if (row->column[middle] < column) {
            first = middle + 1;
        } else {
            end = middle;
        }
    }
    return first;
}

/* The entries from k to before `end` of such a row times the numbers of x, which begin at the column `first`. Null: they are zero. */
static double of_entries(const lag_radau_row *row, const double *entries, size_t k, size_t end, const double *x, size_t first, double sum)
{
    for (; x != NULL && k < end; ++k) {
        sum += entries[k] * x[row->column[k] - first];
    }
    return sum;
}

/* All stages of a row while its entries are at hand. */
void lag_radau_product(const lag_ode *ode, const double *entries, const double *factor, const lag_radau_stages *of, double *out)
{
    const size_t n = ode->size;
    for (size_t i = 0; i < lag_radau_rows(ode); ++i) {
        const lag_radau_row row = lag_radau_row_of(ode, i);
        const size_t rates = row.column != NULL ? entry_from(&row, n) : row.end;
        const size_t multipliers = row.column != NULL ? entry_from(&row, n + ode->nq) : row.end;
        for (size_t k = 0; k < of->count; ++k) {
            const double *x = of->x != NULL ? of->x + k * of->apart : NULL;
            double sum = 0.0;
            if (row.column != NULL) {
                sum = of_entries(&row, entries, row.first, rates, x, 0, sum);
                sum = of_entries(&row, entries, rates, multipliers, of->rates != NULL ? of->rates + k * of->apart + ode->nq : NULL, n, sum);
                sum = of_entries(&row, entries, multipliers, row.end, x, ode->nq, sum);
            } else if (x != NULL) {
                sum = lag_dot(n, entries + row.first, x);
            }
            out[k * lag_radau_size(ode) + ode->nq + i] += factor[k] * sum;
        }
    }
}

void lag_radau_take_sides(const lag_ode *ode, const lag_radau_places *at, size_t stages, const double *x, double *sides)
{
    static const double minus[LAG_RADAU_STAGES] = {-1.0, -1.0, -1.0, -1.0, -1.0, -1.0, -1.0};
    for (size_t k = 0; k < stages; ++k) {
        const double *from = x + k * ode->size;
        double *to = sides + k * lag_radau_size(ode);
        memcpy(to, from, ode->nq * sizeof(double));
        for (size_t i = 0; i < lag_radau_rows(ode); ++i) {
            to[ode->nq + i] = lag_radau_is_rate(ode, i) ? from[ode->nq + i] : 0.0;
        }
    }
    if (lag_radau_is_sparse(ode)) {
        const lag_radau_stages of = {.count = stages, .apart = ode->size, .rates = x};
        lag_radau_product(ode, at->middle, minus, &of, sides);
    }
}

void lag_radau_solve_real(const lag_ode *ode, const lag_radau_places *at, double *x)
{
    lag_radau_take_sides(ode, at, 1, x, at->sides);
    solve_real(ode, at, at->sides);
    memcpy(x, at->sides, ode->size * sizeof(double));
}
