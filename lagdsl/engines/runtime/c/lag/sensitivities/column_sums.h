/*
 * Sums over columns in lanes, in registers as wide as the processor has them. All widths give the same bits: lanes do not meet, and each number is
 * summed in the order of its terms.
 */
#ifndef LAG_COLUMN_SUMS_H
#define LAG_COLUMN_SUMS_H

#include "lag/methods/dop853.h"

/* The first `width` numbers of each of `height` rows, which start `apart` numbers from one another. */
typedef struct lag_rows_of_columns {
    size_t height, width, apart;
    const double *first;
} lag_rows_of_columns;

typedef struct lag_column_sums {
    void (*combine)(size_t count, const lag_combination *c, const double *h, const double *slope, const double *base, double *out); /* lag_combine() */
    void (*errors)(const lag_attempt_arrays *at, double *error); /* lag_attempt_errors() */
    void (*dense)(const lag_attempt_arrays *at, double *terms);  /* lag_attempt_dense() */
    /* to (height, lanes) = base (null: zero) + product of (width, lanes); `to` is neither of these */
    void (*multiply)(const lag_rows_of_columns *product, size_t lanes, const double *of, const double *base, double *to);
} lag_column_sums;

/* Those of this processor. */
const lag_column_sums *lag_column_sums_here(void);

#endif
