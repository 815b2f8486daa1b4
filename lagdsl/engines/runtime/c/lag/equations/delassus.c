#include "lag/equations/delassus.h"

#include <math.h>

#include "lag/linalg/linalg.h"
#include "lag/linalg/arena.h"
#include "lag/linalg/order.h"
#include "lag/linalg/vector.h"

/* The same figures as in the NumPy modules: see their file `delassus` for what they mean. */
static const double LEAST_PIVOT = 1e-6;
static const double LARGEST_EXCESS = 1e-10;
static const double SHORT_RESPONSE = 1e-3;

size_t lag_left_rows_kept(const lag_model *model)
{
    return model->nk * (2 * model->nq + model->nc);
}

lag_left_rows lag_left_rows_place(const lag_model *model, const lag_kept *kept, double **memory)
{
    double *first = kept != NULL ? kept->first : NULL;
    double **sparse = kept != NULL ? &first : memory;
    lag_left_rows rows;
    rows.response = lag_take(sparse, model->nk * model->nq);
    rows.lam_response = lag_take(sparse, model->nk * model->nc);
    rows.jacobian = lag_take(sparse, model->nk * model->nq);
    rows.gamma = lag_take(memory, model->nk);
    return rows;
}

size_t lag_delassus_memory(size_t m, size_t kept)
{
    return kept > 0 ? lag_pivoted_cholesky_memory(kept) + kept * kept + kept * m + 2 * kept : 0;
}

void lag_delassus_place(
    lag_delassus *s, size_t n, size_t m, size_t kept, const size_t *row, const lag_patterns *patterns, double *memory)
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
    s->patterns = patterns != NULL ? *patterns : (lag_patterns){NULL, NULL, NULL, NULL, NULL, NULL, NULL};
    s->work.part = lag_take(&memory, kept);
    s->work.x = lag_take(&memory, kept);
    lag_pivoted_cholesky_place(&s->factor, kept, lag_take(&memory, lag_pivoted_cholesky_memory(kept)));
    s->gram = lag_take(&memory, kept * kept);
    s->excess = lag_take(&memory, kept * m);
}

/* Row i of J times y (n). */
static inline double along(const lag_delassus *s, size_t i, const double *y)
{
    const lag_pattern *entries = s->patterns.jacobian;
    const double *row = s->jacobian + i * s->n;
    double sum = 0.0;
    if (entries == NULL) {
        for (size_t j = 0; j < s->n; ++j) {
            sum += row[j] * y[j];
        }
        return sum;
    }
    for (size_t k = entries->first[s->row[i]]; k < entries->first[s->row[i] + 1]; ++k) {
        sum += row[entries->column[k]] * y[entries->column[k]];
    }
    return sum;
}

/* True if kept row i of J has an entry that is not zero. */
static int holds(const lag_delassus *s, size_t i)
{
    const lag_pattern *entries = s->patterns.jacobian;
    const size_t end = entries != NULL ? entries->first[s->row[i] + 1] : s->n;
    size_t k = entries != NULL ? entries->first[s->row[i]] : 0;
    while (k < end && s->jacobian[i * s->n + (entries != NULL ? entries->column[k] : k)] == 0.0) {
        ++k;
    }
    return k < end;
}

size_t lag_delassus_weigh(lag_delassus *s, const unsigned char *redundant)
{
    size_t rank = 0;
    for (size_t i = 0; i < s->kept; ++i) {
        const int counts = redundant == NULL || redundant[s->row[i]] == 0;
        s->factor.left[i] = along(s, i, s->response + i * s->n);
        rank += counts && (s->factor.left[i] != 0.0 || holds(s, i));
    }
    return rank;
}

/* The squares of the factors that make the diagonal of S comparable: one, but for rows that are short. */
static void compare(lag_delassus *s)
{
    double longest = 0.0;
    for (size_t i = 0; i < s->kept; ++i) {
        longest = lag_higher(s->factor.left[i], longest);
    }
    const double least = SHORT_RESPONSE * SHORT_RESPONSE * longest;
    for (size_t i = 0; i < s->kept; ++i) {
        s->factor.weight[i] = s->factor.left[i] > 0.0 ? 1.0 / lag_higher(s->factor.left[i], least) : 0.0;
    }
}

/* Entries of S beside the diagonal that are not zero. */
static void form(lag_delassus *s)
{
    const lag_pattern *couplings = s->patterns.coupling;
    for (size_t i = 0; i < s->kept; ++i) {
        const size_t first = couplings != NULL ? couplings->first[i] : 0;
        const size_t end = couplings != NULL ? couplings->first[i + 1] : i;
        for (size_t e = first; e < end; ++e) {
            const size_t k = couplings != NULL ? couplings->column[e] : e;
            const double entry = k < i ? along(s, i, s->response + k * s->n) : 0.0;
            if (entry != 0.0) {
                lag_pivoted_cholesky_join(&s->factor, i, k, entry);
            }
        }
    }
}

/* Adds to lam (m) what a multiplier x of kept row i is and adds to the others. */
static inline void add_multiplier(const lag_delassus *s, size_t i, double x, double *lam)
{
    const size_t others = s->kept < s->m ? s->m : 0;
    for (size_t j = 0; j < others; ++j) {
        lam[j] += s->lam_response[i * s->m + j] * x;
    }
    lam[s->row[i]] += x;
}

/* Adds to a (n) what it adds to the accelerations. */
static inline void add_acceleration(const lag_delassus *s, size_t i, double x, double *a)
{
    const lag_pattern *responses = s->patterns.response;
    const double *response = s->response + i * s->n;
    const size_t end = responses != NULL ? responses->first[i + 1] : s->n;
    for (size_t e = responses != NULL ? responses->first[i] : 0; e < end && x != 0.0; ++e) {
        const size_t j = responses != NULL ? responses->column[e] : e;
        a[j] += response[j] * x;
    }
}

/* Each row beyond the rank, less the independent ones that give the same. */
static void find_direction(lag_delassus *s, size_t own, double *direction)
{
    const lag_pivoted_cholesky *factor = &s->factor;
    lag_fill(s->kept, 0.0, s->work.x);
    for (size_t e = 0; e < (size_t)factor->count[own]; ++e) {
        const size_t i = lag_pivoted_cholesky_beside(factor, own, e);
        s->work.x[i] = lag_pivoted_cholesky_has(factor, i) ? -*lag_pivoted_cholesky_entry(factor, own, i) : 0.0;
    }
    lag_pivoted_cholesky_solve_upper(factor, s->rank, s->work.x);
    s->work.x[own] = 1.0;
    lag_fill(s->m, 0.0, direction);
    for (size_t i = 0; i < s->kept; ++i) {
        add_multiplier(s, i, s->work.x[i], direction);
    }
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
        find_direction(s, (size_t)s->factor.chosen[s->rank + i], s->excess + i * s->m);
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
        const size_t own = (size_t)s->factor.chosen[i];
        if (holds(s, own) || adds(s, own)) {
            s->factor.chosen[s->rank + s->dependent++] = (double)own;
        }
    }
}

/* S is round-off. Rows whose multipliers add to no others keep zero. */
static lag_status factor_nothing(lag_delassus *s)
{
    s->dependent = 0;
    for (size_t i = 0; i < s->kept; ++i) {
        if (adds(s, i)) {
            s->factor.chosen[s->dependent++] = (double)i;
        }
    }
    return find_excess(s) ? LAG_OK : LAG_MISSING;
}

lag_status lag_delassus_factor(lag_delassus *s, size_t rank)
{
    s->rank = rank;
    s->dependent = s->kept - rank;
    if (rank == 0) {
        return factor_nothing(s);
    }
    compare(s);
    form(s);
    if (lag_pivoted_cholesky_factor(&s->factor, LEAST_PIVOT, LARGEST_EXCESS) != rank) {
        return LAG_MISSING;
    }
    forget_zero_rows(s);
    return find_excess(s) ? LAG_OK : LAG_MISSING;
}

/* Multipliers work.x that give what is missing to gamma, of the chosen rows that stand beside others. */
static void solve_rest(lag_delassus *s, const double *gamma, const double *a)
{
    const lag_pivoted_cholesky *factor = &s->factor;
    for (size_t k = factor->alone; k < s->rank; ++k) {
        const size_t i = (size_t)factor->chosen[k];
        s->work.x[i] = gamma[i] - along(s, i, a);
    }
    lag_pivoted_cholesky_solve_lower(factor, s->rank, s->work.x);
    lag_pivoted_cholesky_solve_upper(factor, s->rank, s->work.x);
}

/* The multiplier of row i, which stands beside no others, with its refinement. */
static void solve_alone(const lag_delassus *s, size_t i, const double *gamma, double *a, double *lam)
{
    const double left = s->factor.left[i];
    for (int k = 0; k < 2; ++k) {
        const double x = (gamma[i] - along(s, i, a)) / left / left;
        add_acceleration(s, i, x, a);
        add_multiplier(s, i, x, lam);
    }
}

void lag_delassus_solve(lag_delassus *s, const double *gamma, double *a, double *lam)
{
    const double *chosen = s->factor.chosen;
    const size_t alone = s->rank > 0 ? s->factor.alone : 0;
    for (size_t k = 0; k < alone; ++k) {
        solve_alone(s, (size_t)chosen[k], gamma, a, lam);
    }
    if (s->rank > alone) {
        solve_rest(s, gamma, a);
    }
    for (size_t k = alone; k < s->rank; ++k) {
        add_multiplier(s, (size_t)chosen[k], s->work.x[(size_t)chosen[k]], lam);
    }
    if (s->dependent > 0) {
        remove_excess(s, lam);
    }
    for (size_t k = alone; k < s->rank + s->dependent; ++k) {
        add_acceleration(s, (size_t)chosen[k], lam[s->row[(size_t)chosen[k]]], a);
    }
    if (s->rank > alone) {
        solve_rest(s, gamma, a);
    }
    for (size_t k = alone; k < s->rank; ++k) {
        add_acceleration(s, (size_t)chosen[k], s->work.x[(size_t)chosen[k]], a);
        add_multiplier(s, (size_t)chosen[k], s->work.x[(size_t)chosen[k]], lam);
    }
}
