/*
 * Cholesky's method for a symmetric, positive semidefinite matrix by its entries that are not zero, each time on the row that has the longest
 * rest: what is left of its diagonal, by a weight of its own. A row costs as much as it has entries, and what elimination adds to them: a chain
 * of rows about as much as it is long, as every other row is chosen first.
 */
#ifndef LAG_PIVOTED_CHOLESKY_H
#define LAG_PIVOTED_CHOLESKY_H

#include <stddef.h>

typedef struct lag_pivoted_cholesky {
    size_t n;
    double *factor;         /* (n, n) at (i, k), i < k: the matrix, of which what is chosen takes its part; then the column of the row chosen first */
    double *beside, *count; /* (n, n) (n) the rows at which each row has entries, of a chosen one those behind it; so many */
    double *left;           /* (n) what is left of the diagonal; of chosen rows its root */
    double *weight;         /* (n) for comparing rows */
    double *chosen;         /* (n) the chosen rows in turn, then the others; */
    size_t alone;           /* the first ones have no entries beside the diagonal */
    double *place;          /* (n) where each stands there, n for rows that are not chosen */
    double *size;           /* (n) of the rests */
    double *heap, *at;      /* (n) (n) rows by these, the longest first; where each is */
    double *mark;           /* (n) the last row, and pivot, in whose list each was seen */
} lag_pivoted_cholesky;

/* Doubles for n rows. */
size_t lag_pivoted_cholesky_memory(size_t n);

/* Without entries; `left` and `weight` are to be filled. */
void lag_pivoted_cholesky_place(lag_pivoted_cholesky *c, size_t n, double *memory);

/* Entries (i, k) and (k, i), which were not there, i and k different. */
void lag_pivoted_cholesky_join(lag_pivoted_cholesky *c, size_t i, size_t k, double entry);

/*
 * Chooses rows and eliminates them until rests are at most the part `excess` of the first; returns how many were chosen. n + 1: a rest is above that, but
 * not above the part `least`.
 */
size_t lag_pivoted_cholesky_factor(lag_pivoted_cholesky *c, double least, double excess);

/* x (n) := L^-1 x and L'^-1 x for the first `rank` chosen rows that are not alone. Others have no part in the latter, and numbers of no use behind the first. */
void lag_pivoted_cholesky_solve_lower(const lag_pivoted_cholesky *c, size_t rank, double *x);
void lag_pivoted_cholesky_solve_upper(const lag_pivoted_cholesky *c, size_t rank, double *x);

/* 1: row i was chosen. */
static inline int lag_pivoted_cholesky_has(const lag_pivoted_cholesky *c, size_t i)
{
    return c->place[i] < (double)c->n;
}

/* The entry of two rows. */
static inline double *lag_pivoted_cholesky_entry(const lag_pivoted_cholesky *c, size_t i, size_t k)
{
    return c->factor + (i < k ? i * c->n + k : k * c->n + i);
}

/* Row number k of those beside row i. */
static inline size_t lag_pivoted_cholesky_beside(const lag_pivoted_cholesky *c, size_t i, size_t k)
{
    return (size_t)c->beside[i * c->n + k];
}

#endif
