/* Sums in registers of 256 bits, for processors that have them. */
#define LAG_ATTEMPT_WIDTH 4
#define LAG_COLUMNS_TARGET __attribute__((target("avx")))

#include "lag/methods/dop853.h"

#if LAG_ATTEMPTS_WIDE

#include "lag/sensitivities/column_sums_make.h"

const lag_column_sums lag_column_sums_wide = {combine, dense, interpolate, error, multiply, rates, decompose, collocate};

#endif
