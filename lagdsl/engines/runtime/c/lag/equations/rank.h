/*
 * Are the constraints about to lose rank, or has J turned so far in one step that they might have lost it on the way? A cheap estimate
 * that says yes too often rather than too seldom.
 *
 * It takes products of rows only, of those that last and depend on no others. Rows that share coordinates stand near to each other, in
 * the order of Cuthill and McKee; then J J' is a band along a chain of loops, and an estimate costs as much as the chain is long. A row that
 * many others share columns with, Kirchhoff's law of a ground, stands in a border beside the band.
 *
 * While J stays near to one whose pivots are known, they are bounded by how far it has moved (Weyl's inequality), and nothing is decomposed.
 *
 * Sources: George and Liu, Computer Solution of Large Sparse Positive Definite Systems, 1981, chapter 4; Higham, Accuracy and Stability of
 * Numerical Algorithms, 2nd ed., section 8.2 (comparison matrices), for a bound of the least singular value of a triangle.
 */
#ifndef LAG_RANK_H
#define LAG_RANK_H

#include "lag/linalg/arena.h"
#include "lag/model.h"

/* A row of size one of which less than this is left beside others follows from them; so does a direction. */
static const double LAG_FOLLOWS = 1e-6;

typedef struct lag_rank_estimate {
    const lag_model *model;
    size_t m, n, most;        /* rows, columns, independent rows */
    size_t rank;              /* at the last state; 0: none */
    double margin;            /* there, the least pivot of J, rows of size one */
    const double *sizes;      /* (n) natural sizes of the coordinates */
    const double *row_sizes;  /* (m) */
    const double *lasting;    /* (m) 0: this row comes and goes and does not count; null: all do */
    double *rows, *now;       /* (entries) J in these sizes, at the last state and now */
    struct {
        double *rows;         /* (entries) J where its pivots were computed last, */
        double margin, least; /* the least one, and less than the least singular value there; 0: unknown */
    } known;
    double *first, *column;   /* (m + 1) (entries) where J can be nonzero, row by row */
    double *order, *reach;    /* (m) rows in their order; the first in that order with which each shares a coordinate */
    struct {
        double *first, *place, *entry; /* (n + 1) (entries) column by column: places of the rows in their order, ascending, and which entry it is */
        double *products;              /* (4 m) of one row with others */
    } columns;
    double *follows, *trial;  /* (m) 1: the row follows from others there, which nobody said; the same now */
    struct {
        double *start, *band; /* (m + 1) where the line of each row begins in the lower half of a symmetric matrix of rows */
        size_t border;        /* so many rows at the end of the order share columns with many others */
    } matrix;
} lag_rank_estimate;

/* Behind the last entry of a row. */
static inline size_t lag_rank_end_of(const lag_rank_estimate *estimate, size_t row)
{
    return lag_index(estimate->first[row + 1]);
}

/* Doubles for it. */
size_t lag_rank_estimate_memory(const lag_model *model);

void lag_rank_estimate_place(lag_rank_estimate *estimate, const lag_model *model, const double *sizes, const double *row_sizes, double *memory);

/* Numbers that estimates compute on the way become zero: they are no part of the state, and depend on who asked last. */
void lag_rank_estimate_clear(lag_rank_estimate *estimate);

/* Pivots of J, rows of size one: below this rank is nearly lost. */
#define LAG_RANK_NEAR 0.1

/*
 * LAG_OK, or LAG_ATTENTION. This is the state that the next estimate starts from, unless J has turned so far since the last one that rank
 * might have been lost on the way.
 */
lag_status lag_rank_estimate_update(lag_rank_estimate *estimate, const double *jacobian);

/* True if J has turned so far, and the least pivot of J, zero where rank is lost; nothing of it is remembered. */
int lag_rank_estimate_has_turned(lag_rank_estimate *estimate, const double *jacobian);
double lag_rank_estimate_margin(lag_rank_estimate *estimate, const double *jacobian);

#endif
