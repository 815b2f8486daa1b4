#include "lag/equations/delassus.h"

#include <math.h>

#include "lag/linalg/linalg.h"
#include "lag/linalg/arena.h"
#include "lag/linalg/vector.h"

/* The same figures as in the NumPy modules: see their file `delassus` for what they mean. */
static const double LEAST_PIVOT = 1e-6;
static const double LARGEST_EXCESS = 1e-10;
static const double SHORT_RESPONSE = 1e-3;

size_t lag_delassus_memory(size_t m, size_t kept)
{
    return 2 * kept * kept + kept * m + 10 * kept;
}

/* Column of entry k. */
static size_t column_of(const lag_delassus *s, size_t k)
{
    return s->entries != NULL ? s->entries->column[k] : k;
}

/* Row i of J times y (n). */
static double along(const lag_delassus *s, size_t i, const double *y)
{
    const double *row = s->jacobian + i * s->n;
    const size_t end = (size_t)s->end[i];
    double sum = 0.0;
    for (size_t k = (size_t)s->first[i]; k < end; ++k) {
        const size_t j = column_of(s, k);
        sum += row[j] * y[j];
    }
    return sum;
}

/* Where the entries of rows begin and end, and of which component they are. */
static void find_entries(lag_delassus *s, const lag_pattern *entries, const size_t *components)
{
    size_t k = 0;
    for (size_t i = 0; i < s->kept; ++i) { /* entries are listed row by row, and kept rows ascend */
        while (k < entries->count && entries->row[k] < s->row[i]) {
            ++k;
        }
        const size_t first = k;
        while (k < entries->count && entries->row[k] == s->row[i]) {
            ++k;
        }
        s->first[i] = (double)first;
        s->end[i] = (double)k;
        s->component[i] = components != NULL && k > first ? (double)components[entries->column[first]] : 0.0;
    }
}

void lag_delassus_place(lag_delassus *s, size_t n, size_t m, size_t kept, const size_t *row, const lag_pattern *entries,
    const size_t *components, double *memory)
{
    s->n = n;
    s->m = m;
    s->kept = kept;
    s->rank = 0;
    s->dependent = 0;
    s->row = row;
    s->response = NULL;
    s->lam_response = NULL;
    s->jacobian = NULL;
    s->entries = entries;
    s->factor = lag_take(&memory, kept * kept);
    s->left = lag_take(&memory, kept);
    s->weight = lag_take(&memory, kept);
    s->chosen = lag_take(&memory, kept);
    s->excess = lag_take(&memory, kept * m);
    s->gram = lag_take(&memory, kept * kept);
    s->part = lag_take(&memory, kept);
    s->x = lag_take(&memory, kept);
    s->rest = lag_take(&memory, kept);
    s->first = lag_take(&memory, kept);
    s->end = lag_take(&memory, kept);
    s->component = lag_take(&memory, kept);
    s->lead = lag_take(&memory, kept);
    if (entries != NULL) {
        find_entries(s, entries, components);
    } else {
        lag_fill(kept, 0.0, s->first);
        lag_fill(kept, (double)n, s->end);
        lag_fill(kept, 0.0, s->component);
    }
}

int lag_delassus_holds(const lag_delassus *s, size_t i)
{
    const size_t end = (size_t)s->end[i];
    size_t k = (size_t)s->first[i];
    while (k < end && s->jacobian[i * s->n + column_of(s, k)] == 0.0) {
        ++k;
    }
    return k < end;
}

/* Diagonal of S, and the squares of the factors that make it comparable: one, but for rows that are short. */
static void weigh(lag_delassus *s)
{
    double longest = 0.0;
    for (size_t i = 0; i < s->kept; ++i) {
        s->left[i] = along(s, i, s->response + i * s->n);
        longest = fmax(longest, s->left[i]);
    }
    for (size_t i = 0; i < s->kept; ++i) {
        const double part = fmin(1.0, s->left[i] / (SHORT_RESPONSE * SHORT_RESPONSE * longest));
        s->weight[i] = s->left[i] > 0.0 ? part / s->left[i] : 0.0;
        s->chosen[i] = (double)i;
        s->lead[i] = 0.0;
    }
}

/* Position, from k on, of the row that has the longest rest. */
static size_t longest_rest(const lag_delassus *s, size_t k)
{
    size_t best = k;
    double largest = -1.0;
    for (size_t i = k; i < s->kept; ++i) {
        const size_t row = (size_t)s->chosen[i];
        const double own = s->left[row] * s->weight[row];
        if (own > largest) {
            largest = own;
            best = i;
        }
    }
    return best;
}

/* Column k of the factor, for the rows that are not chosen yet. Rows of other components have zeros there. */
static void append_column(lag_delassus *s, size_t k)
{
    const size_t pivot = (size_t)s->chosen[k];
    double *own = s->factor + pivot * s->kept;
    const double root = sqrt(s->left[pivot]);
    const size_t from = (size_t)s->lead[pivot];
    own[k] = root;
    for (size_t i = k + 1; i < s->kept; ++i) {
        const size_t row = (size_t)s->chosen[i];
        double *to = s->factor + row * s->kept;
        to[k] = 0.0;
        if (s->component[row] == s->component[pivot]) {
            const double element = along(s, row, s->response + pivot * s->n);
            to[k] = (element - lag_dot(k - from, to + from, own + from)) / root;
            s->left[row] -= to[k] * to[k];
        }
        s->lead[row] += (size_t)s->lead[row] == k && to[k] == 0.0 ? 1.0 : 0.0;
    }
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
        s->rest[k] = s->factor[own * s->kept + k];
    }
    solve_upper(s, s->rest);
    lag_fill(s->kept, 0.0, s->x);
    for (size_t k = 0; k < s->rank; ++k) {
        s->x[(size_t)s->chosen[k]] = -s->rest[k];
    }
    s->x[own] = 1.0;
    lag_fill(s->m, 0.0, direction);
    add_multipliers(s, s->x, direction);
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
        s->part[i] = lag_dot(s->m, s->excess + i * s->m, lam);
    }
    lag_cholesky_solve(count, s->gram, s->part);
    for (size_t i = 0; i < count; ++i) {
        for (size_t j = 0; j < s->m; ++j) {
            lam[j] -= s->part[i] * s->excess[i * s->m + j];
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

lag_status lag_delassus_factor(lag_delassus *s, size_t rank)
{
    double first = 0.0;
    s->rank = rank;
    s->dependent = s->kept - rank;
    if (rank == 0) {
        return factor_nothing(s);
    }
    weigh(s);
    for (size_t k = 0; k < s->kept; ++k) {
        const size_t best = longest_rest(s, k);
        const double kept = s->chosen[k];
        s->chosen[k] = s->chosen[best];
        s->chosen[best] = kept;
        const size_t pivot = (size_t)s->chosen[k];
        const double size = s->left[pivot] * s->weight[pivot];
        first = k == 0 ? size : first;
        if (k == rank) {
            if (size <= LARGEST_EXCESS * first) {
                break;
            }
            return LAG_MISSING;
        }
        if (!(size > LEAST_PIVOT * first) || !isfinite(s->left[pivot])) {
            return LAG_MISSING;
        }
        append_column(s, k);
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
        s->rest[k] = (missing - lag_dot(k - from, own + from, s->rest + from)) / own[k];
    }
    solve_upper(s, s->rest);
    for (size_t k = 0; k < s->kept; ++k) {
        s->x[(size_t)s->chosen[k]] = k < s->rank ? s->rest[k] : 0.0;
    }
}

static void add_accelerations(const lag_delassus *s, double *a)
{
    for (size_t i = 0; i < s->kept; ++i) {
        if (s->x[i] == 0.0) {
            continue;
        }
        for (size_t j = 0; j < s->n; ++j) {
            a[j] += s->response[i * s->n + j] * s->x[i];
        }
    }
}

void lag_delassus_solve(lag_delassus *s, const double *gamma, double *a, double *lam)
{
    if (s->rank > 0) {
        solve_rest(s, gamma, a);
        add_multipliers(s, s->x, lam);
    }
    if (s->dependent > 0) {
        remove_excess(s, lam);
    }
    for (size_t i = 0; i < s->kept; ++i) {
        s->x[i] = lam[s->row[i]];
    }
    add_accelerations(s, a);
    if (s->rank > 0) {
        solve_rest(s, gamma, a);
        add_accelerations(s, a);
        add_multipliers(s, s->x, lam);
    }
}
