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
 * in a band (lag/factorization/band.h), rows and columns in the order that the model tells, multipliers among them. Rates of states, zd = g, join in.
 *
 * Source of that: Hairer and Wanner, Solving Ordinary Differential Equations II, 2nd ed., section IV.8, "second order systems".
 */
#include <math.h>
#include <string.h>

#include "lag/factorization/band.h"
#include "lag/factorization/lu.h"
#include "lag/linalg/linalg.h"
#include "lag/linalg/vector.h"
#include "lag/methods/radau.h"

static size_t least(size_t a, size_t b)
{
    return a < b ? a : b;
}

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

/* The real system is the first, with the first stage; each pair has two. */
static size_t stage_of(size_t system)
{
    return system == 0 ? 0 : 2 * system - 1;
}

static size_t systems_of(const lag_radau_table *table)
{
    return (table->stages + 1) / 2;
}

static number shift_of(const lag_radau_table *table, size_t system, double h)
{
    return system == 0 ? (number){1, {table->mu / h, 0.0}} : (number){2, {table->alpha[system - 1] / h, -table->beta[system - 1] / h}};
}

static number inverse_of(const number *a)
{
    const double square = a->value[0] * a->value[0] + a->value[1] * a->value[1];
    return (number){a->parts, {a->value[0] / square, -a->value[1] / square}};
}

/* A matrix of numbers of so many parts: its first entry, and how far apart the entries of a column and of a row are. */
typedef struct storage {
    size_t parts;
    double *first;
    size_t rows, columns;
} storage;

static storage storage_of(const lag_ode *ode, const lag_radau_places *at, size_t parts, double *matrix)
{
    const lag_band band = lag_radau_band(ode, at);
    return lag_radau_is_sparse(ode) ? (storage){parts, lag_band_column(&band, parts, matrix, 0), 1, lag_band_height(&band) - 1}
                                    : (storage){parts, matrix, band.n, 1};
}

static double *entry_of(const storage *of, size_t row, size_t column)
{
    return of->first + of->parts * (row * of->rows + column * of->columns);
}

/*
 * Rows of constraints that depend on others leave open how these share a force; the diagonal of multipliers is so small a part of what the forces of
 * their rows move the heaviest coordinate by, so that there is a solution. It is an error of the matrix only: iterations take it back. Rows that are
 * zero, those of open contacts, get any number.
 */
enum { OPEN = 100 }; /* roundings */

static void close_multipliers(const lag_ode *ode, const lag_radau_places *at, const number *shift, const storage *matrix)
{
    for (size_t i = lag_radau_others(ode); i < lag_radau_rows(ode); ++i) {
        const lag_radau_row row = lag_radau_row_of(ode, i);
        const size_t place = place_of(ode, i);
        double square = 0.0;
        double heaviest = 0.0;
        for (size_t k = row.first; k < row.end; ++k) {
            if (at->middle[k] != 0.0 && is_acceleration(ode, row.column[k])) {
                const size_t own = place_of(ode, unknown_of(ode, row.column[k]));
                const double *diagonal = entry_of(matrix, own, own);
                heaviest = fmax(heaviest, hypot(diagonal[0], shift->parts == 2 ? diagonal[1] : 0.0));
                square += at->middle[k] * at->middle[k];
            }
        }
        const double moved = heaviest > 0.0 ? OPEN * LAG_ROUNDING * hypot(shift->value[0], shift->value[1]) * square / heaviest : 0.0;
        *entry_of(matrix, place, place) += square > 0.0 ? moved : 1.0;
    }
}

/* shift I - J, its coordinates eliminated, into a matrix of numbers of as many parts as the shift has. */
static void fill(const lag_ode *ode, const lag_radau_places *at, const number *shift, double *matrix)
{
    static const number one = {1, {1.0, 0.0}};
    const number inverse = inverse_of(shift);
    const size_t parts = shift->parts;
    const storage to = storage_of(ode, at, parts, matrix);
    memset(matrix, 0, parts * lag_radau_matrix(ode, at->memo) * sizeof(double));
    for (size_t i = 0; i < lag_radau_rows(ode); ++i) {
        const lag_radau_row row = lag_radau_row_of(ode, i);
        const size_t place = place_of(ode, i);
        for (size_t k = row.first; k < row.end; ++k) {
            const size_t column = row.column != NULL ? row.column[k] : k - row.first;
            double *entry = entry_of(&to, place, place_of(ode, unknown_of(ode, column)));
            const number *factor = column < ode->nq ? &inverse : is_acceleration(ode, column) ? shift : &one;
            for (size_t part = 0; part < factor->parts; ++part) {
                entry[part] -= factor->value[part] * at->middle[k];
            }
        }
        for (size_t part = 0; part < parts && lag_radau_is_rate(ode, i); ++part) {
            entry_of(&to, place, place)[part] += shift->value[part];
        }
    }
    close_multipliers(ode, at, shift, &to);
}

static double *factors_of(const lag_ode *ode, const lag_radau_places *at, size_t system)
{
    return at->factors + stage_of(system) * lag_radau_matrix(ode, at->memo);
}

static double *pivots_of(const lag_ode *ode, const lag_radau_places *at, size_t system)
{
    return at->pivots + system * lag_radau_pivots(ode);
}

static int decompose(const lag_ode *ode, const lag_radau_places *at, size_t system, double h)
{
    const lag_band band = lag_radau_band(ode, at);
    const number shift = shift_of(at->table, system, h);
    double *factors = factors_of(ode, at, system);
    double *pivots = pivots_of(ode, at, system);
    if (!lag_radau_is_sparse(ode)) {
        fill(ode, at, &shift, factors);
        return (shift.parts == 1 ? lag_lu : lag_lu_complex)(band.n, factors, pivots);
    }
    fill(ode, at, &shift, at->matrix);
    return (shift.parts == 1 ? lag_band_lu : lag_band_lu_complex)(&band, at->matrix, pivots, factors);
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
    int regular = 1;
    for (size_t system = 0; system < systems_of(at->table) && regular; ++system) {
        regular = decompose(ode, at, system, h);
    }
    at->memo->decomposed = regular ? h : 0.0;
    return regular ? LAG_OK : LAG_SINGULAR;
}

/* Stages whose products are summed at once: each sum waits for itself only. */
enum { AT_ONCE = 4 };

/* sum (AT_ONCE) += the entries from k to before `end` times the numbers of x, of stages `apart`, that are `before` places before their columns. */
static void add_entries(
    const lag_radau_row *row, const double *entries, size_t k, size_t end, const double *x, size_t before, const size_t apart[AT_ONCE], double *sum)
{
    double own[AT_ONCE] = {sum[0], sum[1], sum[2], sum[3]};
    for (; k < end; ++k) {
        const double *at = x + (row->column[k] - before);
        own[0] += entries[k] * at[apart[0]];
        own[1] += entries[k] * at[apart[1]];
        own[2] += entries[k] * at[apart[2]];
        own[3] += entries[k] * at[apart[3]];
    }
    memcpy(sum, own, sizeof own);
}

/* Columns of coordinates, of the others of the state, of accelerations, of multipliers. */
enum { KINDS = 4 };

/* The first entry of each kind, in a row; behind the last kind the end of the row. */
static void kinds_of(const lag_ode *ode, const lag_radau_row *row, size_t first[KINDS + 1])
{
    first[0] = first[1] = first[2] = first[3] = row->first;
    for (size_t k = row->first; k < row->end; ++k) {
        first[1] += row->column[k] < ode->nq;
        first[2] += row->column[k] < ode->size;
        first[3] += row->column[k] < ode->size + ode->nq;
    }
    first[4] = row->end;
}

/* The same of df/dx. */
static void dense_product(const lag_ode *ode, const double *entries, const double *factor, const lag_radau_stages *of, double *out)
{
    for (size_t k = 0; k < of->count; ++k) {
        for (size_t i = ode->nq; i < ode->size; ++i) {
            const double *row = entries + i * ode->size;
            const double moved = of->coordinates != NULL ? lag_dot(ode->nq, row, of->coordinates + k * of->apart) : 0.0;
            const double *others = of->others != NULL ? of->others + k * of->apart + ode->nq : NULL;
            out[k * ode->size + i] += factor[k] * (others != NULL ? moved + lag_dot(ode->size - ode->nq, row + ode->nq, others) : moved);
        }
    }
}

void lag_radau_product(const lag_ode *ode, const double *entries, const double *factor, const lag_radau_stages *of, double *out)
{
    if (!lag_radau_is_sparse(ode)) {
        dense_product(ode, entries, factor, of, out);
        return;
    }
    const double *numbers[KINDS] = {of->coordinates, of->others, of->accelerations, of->others};
    const size_t before[KINDS] = {0, 0, ode->size - ode->nq, ode->nq};
    for (size_t i = 0; i < lag_radau_rows(ode); ++i) {
        const lag_radau_row row = lag_radau_row_of(ode, i);
        size_t first[KINDS + 1];
        kinds_of(ode, &row, first);
        for (size_t stage = 0; stage < of->count; stage += AT_ONCE) {
            const size_t rest = least(of->count - stage, AT_ONCE);
            double sum[AT_ONCE] = {0.0};
            size_t apart[AT_ONCE]; /* those that are too many are found twice */
            for (size_t k = 0; k < AT_ONCE; ++k) {
                apart[k] = (stage + least(k, rest - 1)) * of->apart;
            }
            for (size_t kind = 0; kind < KINDS; ++kind) {
                if (numbers[kind] != NULL) {
                    add_entries(&row, entries, first[kind], first[kind + 1], numbers[kind], before[kind], apart, sum);
                }
            }
            for (size_t k = 0; k < rest; ++k) {
                out[(stage + k) * lag_radau_size(ode) + ode->nq + i] += factor[stage + k] * sum[k];
            }
        }
    }
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

/* Right sides x (stages, size) of so many systems become those of the equations without coordinates. */
static void eliminate(const lag_ode *ode, const lag_radau_places *at, size_t systems, double *x)
{
    static const double one[LAG_RADAU_STAGES] = {1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0};
    const size_t nq = ode->nq;
    const size_t size = lag_radau_size(ode);
    const size_t stages = stage_of(systems);
    for (size_t k = 0; k < stages; ++k) {
        memcpy(at->reduced + k * nq, x + k * size, nq * sizeof(double));
    }
    for (size_t system = 0; system < systems; ++system) {
        const number shift = shift_of(at->table, system, at->memo->decomposed);
        const number inverse = inverse_of(&shift);
        multiply(nq, nq, &inverse, at->reduced + stage_of(system) * nq);
    }
    const lag_radau_stages of = {.count = stages, .apart = nq, .coordinates = at->reduced};
    lag_radau_product(ode, at->middle, one, &of, x);
}

/* The solution at->reduced (m, parts) of one of these systems into x (parts, size), and the coordinates that follow. */
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

/* One of these systems, in the order of its matrix: x (parts, size). */
static void solve(const lag_ode *ode, const lag_radau_places *at, size_t system, double *x)
{
    const lag_band band = lag_radau_band(ode, at);
    const number shift = shift_of(at->table, system, at->memo->decomposed);
    const double *pivots = pivots_of(ode, at, system);
    const double *factors = factors_of(ode, at, system);
    for (size_t part = 0; part < shift.parts; ++part) {
        for (size_t i = 0; i < lag_radau_rows(ode); ++i) {
            at->reduced[shift.parts * place_of(ode, i) + part] = x[part * lag_radau_size(ode) + ode->nq + i];
        }
    }
    if (lag_radau_is_sparse(ode)) {
        (shift.parts == 1 ? lag_band_solve : lag_band_solve_complex)(&band, factors, pivots, at->reduced);
    } else {
        (shift.parts == 1 ? lag_lu_solve : lag_lu_complex_solve)(band.n, factors, pivots, at->reduced);
    }
    substitute(ode, at, &shift, x);
}

/* The first so many systems. */
static void solve_systems(const lag_ode *ode, const lag_radau_places *at, size_t systems, double *x)
{
    eliminate(ode, at, systems, x);
    for (size_t system = 0; system < systems; ++system) {
        solve(ode, at, system, x + stage_of(system) * lag_radau_size(ode));
    }
}

void lag_radau_decomposed(const lag_ode *ode, const lag_radau_places *at, double *sides)
{
    solve_systems(ode, at, systems_of(at->table), sides);
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
        const lag_radau_stages of = {.count = stages, .apart = ode->size, .accelerations = x};
        lag_radau_product(ode, at->middle, minus, &of, sides);
    }
}

void lag_radau_solve_real(const lag_ode *ode, const lag_radau_places *at, double *x)
{
    lag_radau_take_sides(ode, at, 1, x, at->sides);
    solve_systems(ode, at, 1, at->sides);
    memcpy(x, at->sides, ode->size * sizeof(double));
}
