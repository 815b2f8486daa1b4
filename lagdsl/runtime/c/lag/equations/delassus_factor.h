/* S = L L' of lag/equations/delassus.h, by the entries that are not zero. */
#ifndef LAG_DELASSUS_FACTOR_H
#define LAG_DELASSUS_FACTOR_H

#include "lag/equations/delassus.h"

/* Row i of J times y (n). */
static inline double lag_delassus_along(const lag_delassus *system, size_t i, const double *y)
{
    const lag_pattern *entries = system->patterns.entries;
    const double *row = system->jacobian + i * system->n;
    double sum = 0.0;
    if (entries == NULL) {
        for (size_t j = 0; j < system->n; ++j) {
            sum += row[j] * y[j];
        }
        return sum;
    }
    for (size_t k = entries->first[system->row[i]]; k < entries->first[system->row[i] + 1]; ++k) {
        sum += row[entries->column[k]] * y[entries->column[k]];
    }
    return sum;
}

/*
 * Chooses rows in turn, each that with the longest rest, and eliminates them; then come those of which nothing is left. Returns how many were
 * chosen; `kept` + 1: a rest is neither long enough nor round-off.
 */
size_t lag_delassus_eliminate(lag_delassus *system);

/* x (kept) := L^-1 x and L'^-1 x for the chosen rows. Others have no part in the latter, and numbers of no use behind the first. */
void lag_delassus_solve_lower(const lag_delassus *system, double *x);
void lag_delassus_solve_upper(const lag_delassus *system, double *x);

/* The entry of L for a row that was not chosen, or later, and a chosen one beside it. */
static inline double *lag_delassus_entry(const lag_delassus *system, size_t i, size_t k)
{
    return system->factor + (i < k ? i * system->kept + k : k * system->kept + i);
}

/* Row number k of those beside row i. */
static inline size_t lag_delassus_beside(const lag_delassus *system, size_t i, size_t k)
{
    return (size_t)system->beside[i * system->kept + k];
}

#endif
