#include "lag/equations/delassus.h"

#include <math.h>

#include "lag/linalg/linalg.h"
#include "lag/linalg/arena.h"
#include "lag/linalg/vector.h"

/* The same figures as in the NumPy modules: see their file `delassus` for what they mean. */
static const double LEAST_PIVOT = 1e-6;
static const double LARGEST_EXCESS = 1e-10;
static const double SHORT_RESPONSE = 1e-3;

/* Column of entry k. */
static size_t column_of(const lag_delassus *s, size_t k)
{
    return s->pattern.entries != NULL ? s->pattern.entries->column[k] : k;
}

/* Row i of J times y (n). */
static double along(const lag_delassus *s, size_t i, const double *y)
{
    const double *row = s->jacobian + i * s->n;
    const size_t end = (size_t)s->pattern.end[i];
    double sum = 0.0;
    for (size_t k = (size_t)s->pattern.first[i]; k < end; ++k) {
        const size_t j = column_of(s, k);
        sum += row[j] * y[j];
    }
    return sum;
}

int lag_delassus_holds(const lag_delassus *s, size_t i)
{
    const size_t end = (size_t)s->pattern.end[i];
    size_t k = (size_t)s->pattern.first[i];
    while (k < end && s->jacobian[i * s->n + column_of(s, k)] == 0.0) {
        ++k;
    }
    return k < end;
}

/* Diagonal of S, and the squares of the factors that make it comparable: one, but for rows that are short. The largest one that is comparable. */
static double weigh(lag_delassus *s)
{
    double longest = 0.0;
    double first = -1.0;
    for (size_t i = 0; i < s->kept; ++i) {
        s->left[i] = along(s, i, s->response + i * s->n);
        longest = fmax(longest, s->left[i]);
    }
    for (size_t i = 0; i < s->kept; ++i) {
        const double part = fmin(1.0, s->left[i] / (SHORT_RESPONSE * SHORT_RESPONSE * longest));
        s->weight[i] = s->left[i] > 0.0 ? part / s->left[i] : 0.0;
        const double own = s->left[i] * s->weight[i];
        first = own > first ? own : first;
    }
    return first;
}

/* Among positions from k to the end: that of the row that has the longest rest. */
static size_t longest_rest(const lag_delassus *s, size_t k, size_t end)
{
    size_t best = k;
    double largest = -1.0;
    for (size_t i = k; i < end; ++i) {
        const size_t row = (size_t)s->chosen[i];
        const double own = s->left[row] * s->weight[row];
        if (own > largest) {
            largest = own;
            best = i;
        }
    }
    return best;
}

/* Column k of the factor, for the rows up to position `end` that are not chosen yet. */
static void append_column(lag_delassus *s, size_t k, size_t end)
{
    const size_t pivot = (size_t)s->chosen[k];
    double *own = s->factor + pivot * s->kept;
    const double root = sqrt(s->left[pivot]);
    const size_t from = (size_t)s->lead[pivot];
    own[k] = root;
    for (size_t i = k + 1; i < end; ++i) {
        const size_t row = (size_t)s->chosen[i];
        double *to = s->factor + row * s->kept;
        const double element = along(s, row, s->response + pivot * s->n);
        to[k] = (element - lag_dot(k - from, to + from, own + from)) / root;
        s->left[row] -= to[k] * to[k];
        s->lead[row] += (size_t)s->lead[row] == k && to[k] == 0.0 ? 1.0 : 0.0;
    }
}

/* The rows of the component that row i leads come to position `begin` and behind it; the end of them. */
static size_t gather(lag_delassus *s, size_t i, size_t begin)
{
    size_t k = begin;
    for (size_t row = i; row < s->kept; row = s->components.several ? (size_t)s->components.follower[row] : row + 1) {
        s->chosen[k] = (double)row;
        s->lead[row] = (double)begin;
        ++k;
    }
    return k;
}

/* x (rank) := L'^-1 x for the chosen rows. */
static void solve_upper(const lag_delassus *s, double *x)
{
    for (size_t i = s->rank; i-- > 0;) {
        const size_t row = (size_t)s->chosen[i];
        const double *own = s->factor + row * s->kept;
        x[i] /= own[i];
        for (size_t k = (size_t)s->lead[row]; k < i; ++k) {
            x[k] -= own[k] * x[i];
        }
    }
}

/* Adds to lam (m) what multipliers x (kept) of the kept rows are and add to the others. */
static void add_multipliers(const lag_delassus *s, const double *x, double *lam)
{
    const size_t others = s->kept < s->m ? s->m : 0;
    for (size_t i = 0; i < s->kept; ++i) {
        for (size_t j = 0; j < others; ++j) {
            lam[j] += s->lam_response[i * s->m + j] * x[i];
        }
        lam[s->row[i]] += x[i];
    }
}

/* Each row beyond the rank, less the independent ones that give the same. */
static void find_direction(lag_delassus *s, size_t own, double *direction)
{
    for (size_t k = 0; k < s->rank; ++k) {
        const int shared = (double)k >= s->lead[own] && (double)k < s->reach[own];
        s->work.rest[k] = shared ? s->factor[own * s->kept + k] : 0.0;
    }
    solve_upper(s, s->work.rest);
    lag_fill(s->kept, 0.0, s->work.x);
    for (size_t k = 0; k < s->rank; ++k) {
        s->work.x[(size_t)s->chosen[k]] = -s->work.rest[k];
    }
    s->work.x[own] = 1.0;
    lag_fill(s->m, 0.0, direction);
    add_multipliers(s, s->work.x, direction);
    const double length = sqrt(lag_dot(s->m, direction, direction));
    for (size_t j = 0; j < s->m; ++j) {
        direction[j] /= length;
    }
}

/* 1: the combinations of multipliers that change nothing, and the factor of their products, are there. */
static int find_excess(lag_delassus *s)
{
    const size_t count = s->dependent;
    for (size_t i = 0; i < count; ++i) {
        find_direction(s, (size_t)s->chosen[s->rank + i], s->excess + i * s->m);
        for (size_t j = 0; j <= i; ++j) {
            s->gram[i * count + j] = lag_dot(s->m, s->excess + i * s->m, s->excess + j * s->m);
        }
    }
    return lag_cholesky(count, s->gram, 0.0) == count;
}

/* Takes from lam (m) what changes nothing but its length. */
static void remove_excess(lag_delassus *s, double *lam)
{
    const size_t count = s->dependent;
    for (size_t i = 0; i < count; ++i) {
        s->work.part[i] = lag_dot(s->m, s->excess + i * s->m, lam);
    }
    lag_cholesky_solve(count, s->gram, s->work.part);
    for (size_t i = 0; i < count; ++i) {
        for (size_t j = 0; j < s->m; ++j) {
            lam[j] -= s->work.part[i] * s->excess[i * s->m + j];
        }
    }
}

/* True if a unit of kept multiplier i changes other multipliers. */
static int adds(const lag_delassus *s, size_t i)
{
    size_t j = s->kept < s->m ? 0 : s->m;
    while (j < s->m && s->lam_response[i * s->m + j] == 0.0) {
        ++j;
    }
    return j < s->m;
}

/* Of the rows that are not chosen, those that are zero and whose multipliers add to no others keep zero: open contacts. */
static void forget_zero_rows(lag_delassus *s)
{
    s->dependent = 0;
    for (size_t i = s->rank; i < s->kept; ++i) {
        const size_t own = (size_t)s->chosen[i];
        if (lag_delassus_holds(s, own) || adds(s, own)) {
            s->chosen[s->rank + s->dependent++] = (double)own;
        }
    }
}

/* S is round-off. Rows whose multipliers add to no others keep zero. */
static lag_status factor_nothing(lag_delassus *s)
{
    s->dependent = 0;
    for (size_t i = 0; i < s->kept; ++i) {
        if (adds(s, i)) {
            s->chosen[s->dependent++] = (double)i;
        }
    }
    return find_excess(s) ? LAG_OK : LAG_MISSING;
}

/*
 * Factors the rows at positions from *k to `end`, of one component; *k is the position behind the independent ones. LAG_MISSING: a rest is neither
 * long enough nor round-off beside `first`.
 */
static lag_status factor_rows(lag_delassus *s, size_t *k, size_t end, double first)
{
    for (; *k < end; ++*k) {
        const size_t best = longest_rest(s, *k, end);
        const double kept = s->chosen[*k];
        s->chosen[*k] = s->chosen[best];
        s->chosen[best] = kept;
        const size_t pivot = (size_t)s->chosen[*k];
        const double size = s->left[pivot] * s->weight[pivot];
        if (size <= LARGEST_EXCESS * first) {
            return LAG_OK;
        }
        if (!(size > LEAST_PIVOT * first) || !isfinite(s->left[pivot])) {
            return LAG_MISSING;
        }
        append_column(s, *k, end);
    }
    return LAG_OK;
}

lag_status lag_delassus_factor(lag_delassus *s, size_t rank)
{
    size_t k = 0;
    size_t others = 0;
    s->rank = rank;
    s->dependent = s->kept - rank;
    if (rank == 0) {
        return factor_nothing(s);
    }
    const double first = weigh(s);
    for (size_t i = 0; i < (s->components.several ? s->kept : 1); ++i) {
        if (s->components.several && s->components.leader[(size_t)s->components.component[i]] != (double)i) {
            continue;
        }
        const size_t end = gather(s, i, k);
        if (factor_rows(s, &k, end, first) != LAG_OK) {
            return LAG_MISSING;
        }
        for (size_t at = k; at < end; ++at) {
            s->reach[(size_t)s->chosen[at]] = (double)k;
            s->work.x[others++] = s->chosen[at];
        }
    }
    if (k != rank) {
        return LAG_MISSING;
    }
    for (size_t at = 0; at < others; ++at) {
        s->chosen[rank + at] = s->work.x[at];
    }
    forget_zero_rows(s);
    return find_excess(s) ? LAG_OK : LAG_MISSING;
}

/* Multipliers x (kept) that give what is missing to gamma; zero for rows that are not chosen. */
static void solve_rest(lag_delassus *s, const double *gamma, const double *a)
{
    for (size_t k = 0; k < s->rank; ++k) {
        const size_t row = (size_t)s->chosen[k];
        const double *own = s->factor + row * s->kept;
        const double missing = gamma[row] - along(s, row, a);
        const size_t from = (size_t)s->lead[row];
        s->work.rest[k] = (missing - lag_dot(k - from, own + from, s->work.rest + from)) / own[k];
    }
    solve_upper(s, s->work.rest);
    for (size_t k = 0; k < s->kept; ++k) {
        s->work.x[(size_t)s->chosen[k]] = k < s->rank ? s->work.rest[k] : 0.0;
    }
}

static void add_accelerations(const lag_delassus *s, double *a)
{
    for (size_t i = 0; i < s->kept; ++i) {
        if (s->work.x[i] == 0.0) {
            continue;
        }
        const double *response = s->response + i * s->n;
        size_t j = s->components.several ? (size_t)s->components.coordinate[(size_t)s->components.component[i]] : 0;
        while (j < s->n) {
            a[j] += response[j] * s->work.x[i];
            j = s->components.several ? (size_t)s->components.beside[j] : j + 1;
        }
    }
}

void lag_delassus_solve(lag_delassus *s, const double *gamma, double *a, double *lam)
{
    if (s->rank > 0) {
        solve_rest(s, gamma, a);
        add_multipliers(s, s->work.x, lam);
    }
    if (s->dependent > 0) {
        remove_excess(s, lam);
    }
    for (size_t i = 0; i < s->kept; ++i) {
        s->work.x[i] = lam[s->row[i]];
    }
    add_accelerations(s, a);
    if (s->rank > 0) {
        solve_rest(s, gamma, a);
        add_accelerations(s, a);
        add_multipliers(s, s->work.x, lam);
    }
}
