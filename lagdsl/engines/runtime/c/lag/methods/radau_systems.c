/*
 * The linear systems of a Radau method: decomposed, and solved, as dense matrices or in the band that an order of the states leaves
 * (lag/elimination/band.h). The order is that of the entries that are not zero in the Jacobian at hand, so that nothing outside of the band
 * is left out.
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
/* Multiplications that an evaluation of the rates takes for each entry of its Jacobian, and directions that are followed at once. */
enum { AN_ENTRY = 4, AT_ONCE = 4 };
/* Decompositions of the first steps, while their length grows. */
enum { FEW = 5 };

static lag_band band_of(size_t n, const lag_radau_places *at)
{
    return (lag_band){n, (size_t)at->memo->lower, (size_t)at->memo->upper};
}

/* True if elimination in the band is so much shorter. */
static int pays(const lag_band *band)
{
    const double n = (double)band->n;
    return lag_band_width(band) <= band->n && WORTH_A_BAND * (lag_band_operations(band) + SWEEPS * n * n) <= n * n * n / 3.0;
}

/* 1 where the Jacobian, or one that changes along the step, has an entry. */
static void find_pattern(size_t n, const lag_radau_places *at, double *pattern)
{
    const int turns = at->memo->turning > 0.0;
    at->memo->entries = 0.0;
    for (size_t i = 0; i < n * n; ++i) {
        pattern[i] = at->jacobian[i] != 0.0 || (turns && (at->change[i] != 0.0 || at->bend[i] != 0.0)) ? 1.0 : 0.0;
        at->memo->entries += pattern[i];
    }
}

static void keep_band(const lag_band *band, const lag_radau_places *at)
{
    at->memo->lower = (double)band->lower;
    at->memo->upper = (double)band->upper;
    at->memo->banded = pays(band) ? 1.0 : 0.0;
}

/* The order of the states for the Jacobian at hand: the one before, unless the band in it is wider than it was. */
static void find_order(size_t n, const lag_radau_places *at)
{
    lag_radau_memo *memo = at->memo;
    double *place = at->order + n;
    const lag_band diagonal = {n, 0, 0};
    const int first = memo->ordered == 0.0;
    memo->entries = (double)(n * n);
    if (!pays(&diagonal)) {
        return;
    }
    find_pattern(n, at, at->real);
    lag_band band = diagonal;
    if (!first) {
        band = lag_band_of(n, at->real, at->order, place);
    }
    if (first || band.lower > (size_t)memo->lower || band.upper > (size_t)memo->upper) {
        lag_cuthill_mckee(n, at->real, at->order, at->complex);
        band = lag_band_of(n, at->real, at->order, place);
        keep_band(&band, at);
    }
    memo->ordered = 1.0;
}

/* Entry i of the Jacobian that is decomposed: at the start of the step, or at its middle. */
static double entry(const lag_radau_places *at, size_t i)
{
    return at->memo->turning > 0.0 ? at->jacobian[i] + 0.5 * at->change[i] - 0.25 * at->bend[i] : at->jacobian[i];
}

/* shift I - J, in the band; of numbers of `parts` doubles. */
static void fill_band(const lag_band *band, const lag_radau_places *at, size_t parts, const double *shift, double *matrix)
{
    memset(matrix, 0, parts * band->n * lag_band_width(band) * sizeof(double));
    for (size_t i = 0; i < band->n; ++i) {
        const size_t row = (size_t)at->order[i] * band->n;
        double *to = matrix + parts * (band->lower + i * (lag_band_width(band) - 1));
        for (size_t j = lag_band_first(band, i); j < lag_band_end(band, i); ++j) {
            to[parts * j] = -entry(at, row + (size_t)at->order[j]);
        }
        for (size_t part = 0; part < parts; ++part) {
            to[parts * i + part] += shift[part];
        }
    }
}

/* The same, dense. */
static void fill(size_t n, const lag_radau_places *at, size_t parts, const double *shift, double *matrix)
{
    for (size_t i = 0; i < n * n; ++i) {
        matrix[parts * i] = -entry(at, i);
        for (size_t part = 1; part < parts; ++part) {
            matrix[parts * i + part] = 0.0;
        }
    }
    for (size_t i = 0; i < n; ++i) {
        for (size_t part = 0; part < parts; ++part) {
            matrix[parts * (i * n + i) + part] += shift[part];
        }
    }
}

/* (mu/h) I - J */
static int decompose_real(size_t n, const lag_radau_places *at, double h)
{
    const lag_band band = band_of(n, at);
    const double shift = at->table->mu / h;
    if (at->memo->banded != 0.0) {
        fill_band(&band, at, 1, &shift, at->real);
        return lag_band_lu(&band, at->real, at->pivots);
    }
    fill(n, at, 1, &shift, at->real);
    return lag_lu(n, at->real, at->pivots);
}

/* ((alpha - i beta)/h) I - J */
static int decompose_pair(size_t n, const lag_radau_places *at, size_t pair, double h)
{
    const lag_band band = band_of(n, at);
    const double shift[2] = {at->table->alpha[pair] / h, -at->table->beta[pair] / h};
    double *matrix = at->complex + 2 * n * n * pair;
    double *pivots = at->pivots + (1 + pair) * n;
    if (at->memo->banded != 0.0) {
        fill_band(&band, at, 2, shift, matrix);
        return lag_band_lu_complex(&band, matrix, pivots);
    }
    fill(n, at, 2, shift, matrix);
    return lag_lu_complex(n, matrix, pivots);
}

lag_status lag_radau_decompose(lag_stepper *s, const lag_radau_places *at, double h)
{
    const size_t n = s->ode->size;
    if (at->memo->decomposed == h) {
        return LAG_OK;
    }
    ++s->counts.decompositions;
    if (at->memo->placed == 0.0) {
        find_order(n, at);
        at->memo->placed = 1.0;
    }
    int regular = decompose_real(n, at, h);
    for (size_t pair = 0; 2 * pair + 1 < at->table->stages && regular; ++pair) {
        regular = decompose_pair(n, at, pair, h);
    }
    at->memo->decomposed = regular ? h : 0.0;
    return regular ? LAG_OK : LAG_SINGULAR;
}

double lag_radau_effort(const lag_stepper *s, const lag_step_counts *done)
{
    const lag_radau_places at = lag_radau_place(s);
    const double n = (double)s->ode->size;
    const double stages = (double)at.table->stages;
    const double matrices = 1.0 + 2.0 * (stages - 1.0); /* a product of complex numbers is four */
    const double evaluation = AN_ENTRY * fmax(at.memo->entries, 1.0);
    const lag_band band = band_of(s->ode->size, &at);
    const int banded = at.memo->banded != 0.0;
    const double decomposition = banded ? lag_band_operations(&band) : n * n * n / 3.0;
    const double solution = banded ? n * (double)lag_band_width(&band) : n * n;
    return (double)done->evaluations * (1.0 + matrices * solution / (stages * evaluation)) +
        (double)done->decompositions * matrices * decomposition / evaluation + (double)done->jacobians * n / AT_ONCE;
}

double lag_radau_trial(lag_stepper *s)
{
    const size_t n = s->ode->size;
    const lag_band diagonal = {n, 0, 0};
    const lag_step_counts few = {.jacobians = 1, .decompositions = FEW};
    *lag_radau_remembered(s) = (lag_radau_memo){.entries = (double)(n * n)};
    const lag_radau_places at = lag_radau_place(s);
    if (pays(&diagonal)) {
        ++s->counts.jacobians;
        if (s->ode->jacobian(s->ode->context, s->t, s->x, at.jacobian) != LAG_OK) {
            return (double)INFINITY;
        }
        find_order(n, &at);
    }
    return lag_radau_effort(s, &few);
}

void lag_radau_solve_real(size_t n, const lag_radau_places *at, double *x)
{
    const lag_band band = band_of(n, at);
    double *ordered = at->order + 2 * n;
    if (at->memo->banded == 0.0) {
        lag_lu_solve(n, at->real, at->pivots, x);
        return;
    }
    for (size_t i = 0; i < n; ++i) {
        ordered[i] = x[(size_t)at->order[i]];
    }
    lag_band_solve(&band, at->real, at->pivots, ordered);
    for (size_t i = 0; i < n; ++i) {
        x[(size_t)at->order[i]] = ordered[i];
    }
}

/* Both parts of x (2, n). */
static void solve_pair(size_t n, const lag_radau_places *at, size_t pair, double *x)
{
    const lag_band band = band_of(n, at);
    const int banded = at->memo->banded != 0.0;
    double *matrix = at->complex + 2 * n * n * pair;
    const double *pivots = at->pivots + (1 + pair) * n;
    for (size_t i = 0; i < n; ++i) {
        const size_t state = banded ? (size_t)at->order[i] : i;
        at->right[2 * i] = x[state];
        at->right[2 * i + 1] = x[n + state];
    }
    if (banded) {
        lag_band_solve_complex(&band, matrix, pivots, at->right);
    } else {
        lag_lu_complex_solve(n, matrix, pivots, at->right);
    }
    for (size_t i = 0; i < n; ++i) {
        const size_t state = banded ? (size_t)at->order[i] : i;
        x[state] = at->right[2 * i];
        x[n + state] = at->right[2 * i + 1];
    }
}

void lag_radau_decomposed(size_t n, const lag_radau_places *at, double *x)
{
    lag_radau_solve_real(n, at, x);
    for (size_t pair = 0; 2 * pair + 1 < at->table->stages; ++pair) {
        solve_pair(n, at, pair, x + (2 * pair + 1) * n);
    }
}

void lag_radau_changed(size_t n, const lag_radau_places *at, double part, const double *x, double *out)
{
    const lag_band band = band_of(n, at);
    const int banded = at->memo->banded != 0.0;
    for (size_t i = 0; i < n; ++i) {
        const size_t row = banded ? (size_t)at->order[i] : i;
        const size_t end = banded ? lag_band_end(&band, i) : n;
        double sum = 0.0;
        for (size_t j = banded ? lag_band_first(&band, i) : 0; j < end; ++j) {
            const size_t column = banded ? (size_t)at->order[j] : j;
            sum += (at->change[row * n + column] + part * at->bend[row * n + column]) * x[column];
        }
        out[row] = part * sum;
    }
}
