/* Disjoint sets of the numbers below n: each number points at one of its set that is not larger, the least one at itself. */
#ifndef LAG_DISJOINT_SETS_H
#define LAG_DISJOINT_SETS_H

#include <stddef.h>

/* Each number is alone. */
static inline void lag_separate(size_t n, double *sets)
{
    for (size_t i = 0; i < n; ++i) {
        sets[i] = (double)i;
    }
}

/* The least number of the set of i. */
static inline size_t lag_set_of(const double *sets, size_t i)
{
    while ((size_t)sets[i] != i) {
        i = (size_t)sets[i];
    }
    return i;
}

/* The sets of i and k are one from now on. */
static inline void lag_join(double *sets, size_t i, size_t k)
{
    const size_t one = lag_set_of(sets, i);
    const size_t other = lag_set_of(sets, k);
    sets[one > other ? one : other] = (double)(one < other ? one : other);
}

/* The same of i and all numbers at which x (n) is not zero. */
static inline void lag_join_entries(double *sets, size_t n, const double *x, size_t i)
{
    for (size_t k = 0; k < n; ++k) {
        if (x[k] != 0.0) {
            lag_join(sets, i, k);
        }
    }
}

#endif
