/*
 * The linear equations of the stages of a column, decomposed once for all columns:
 *
 *     A^-1 z = h (J z + f)
 *
 * with the Jacobian J at each stage and the slopes f where the column begins. Coordinates are eliminated first, as for the state
 * (lag/methods/radau_systems.c): z = h A (v + f) of them in the rows of the others leaves
 *
 *     (A^-1 / h - J_v - h J_q A) v = f + h J_q A f_q .
 */
#ifndef LAG_STAGE_EQUATIONS_H
#define LAG_STAGE_EQUATIONS_H

#include "lag/methods/dop853.h"
#include "lag/methods/radau.h"

/* n: size of the state; m: numbers of it that are not coordinates. */
typedef struct lag_stage_equations {
    const lag_radau_table *table;
    size_t nq, n;
    double h;
    double *jacobian;        /* (stages, m, width) of the others, by n first columns of */
    size_t width;
    double *matrix, *pivots; /* (stages m + 1, lag_stage_rows_apart()) (stages m) */
    double *coordinates;     /* (stages, nq, lanes) */
    double *right;           /* (stages, m, lanes) */
} lag_stage_equations;

/* Numbers from one row of a matrix of so many rows to the next: whole registers. */
static inline size_t lag_stage_rows_apart(size_t rows)
{
    return (rows + LAG_ATTEMPT_LANES - 1) / LAG_ATTEMPT_LANES * LAG_ATTEMPT_LANES;
}

#endif
