/*
 * Sums over columns in lanes, in registers as wide as the processor has them. All widths give the same bits: lanes do not meet, and each number is
 * summed in the order of its terms.
 */
#ifndef LAG_COLUMN_SUMS_H
#define LAG_COLUMN_SUMS_H

#include "lag/sensitivities/stage_equations.h"

/* The first `width` numbers of each of `height` rows, which start `apart` numbers from one another. */
typedef struct lag_rows_of_columns {
    size_t height, width, apart;
    const double *first;
} lag_rows_of_columns;

/*
 * Entries of dp that are not zero: of each column the first (count), with the part zero where there is none; the others block after block, with
 * the first of each (blocks + 1).
 */
typedef struct lag_parameter_entries {
    size_t columns; /* of all blocks but the last */
    size_t *lead;
    double *lead_part;
    size_t *first, *number, *lane;
    double *part;
} lag_parameter_entries;

/* The derivatives of the motion at a state (jacobian() of lag/parallel.h), with arrays for the equations along the columns of one block. */
typedef struct lag_motion_product {
    size_t nq, np, size;                    /* of the state */
    lag_rows_of_columns by_state, by_input; /* by_input of width 0: no column is along inputs */
    lag_rows_of_columns response;
    const double *by_parameter;             /* (equations, np); null: no column is along parameters */
    double *along, *sum;                    /* (equations, lanes) each */
} lag_motion_product;

typedef struct lag_column_sums {
    void (*combine)(size_t count, const lag_combination *c, const double *h, const double *slope, const double *base, double *out); /* lag_combine() */
    void (*dense)(const lag_attempt_arrays *at, double *terms);  /* lag_attempt_dense() */
    /* to (count) = base and the dense output of such terms (7, count) at a part of the step */
    void (*interpolate)(size_t count, const double *terms, double part, const double *base, double *to);
    /*
     * The largest error of a column of a block, measured by the tolerances of the state (size) for a change of order one of what it is differentiated by,
     * which is `extent` (lanes), or by this part of the size of the column where that is larger.
     */
    double (*error)(const lag_attempt_arrays *at, const double *of_state, double relative, const double *extent);
    /* to (height, lanes) = base (null: zero) + product of (width, lanes); `to` is neither of these */
    void (*multiply)(const lag_rows_of_columns *product, size_t lanes, const double *of, const double *base, double *to);
    /* Rates (size, lanes) of one block, whose number is that of its entries, along directions of the state (size, lanes) and of the inputs (nu, lanes). */
    void (*rates)(const lag_motion_product *motion, const lag_parameter_entries *entries, size_t block, size_t lanes, const double *state,
        const double *inputs, double *rates);
    /* The matrix of the equations of stages, decomposed; 0: a pivot is zero or no number. */
    int (*decompose)(const lag_stage_equations *equations);
    /* The slopes (stages, n, lanes) at all stages where the columns of a block begin become what the stages add to these. */
    void (*collocate)(const lag_stage_equations *equations, size_t lanes, double *slopes);
} lag_column_sums;

/* The sums for a processor with so many doubles in a register, or for any. */
const lag_column_sums *lag_column_sums_of(size_t width);

#endif
