#define LAG_COLUMNS_TARGET

#include "lag/sensitivities/column_sums_make.h"

static const lag_column_sums own = {combine, dense, interpolate, error, multiply, rates, decompose, collocate};

/* The library is one for all processors: wider registers are used where there are some. */
const lag_column_sums *lag_column_sums_of(size_t width)
{
    switch (width) {
#if LAG_ATTEMPTS_WIDE
    case 8: return &lag_column_sums_widest;
    case 4: return &lag_column_sums_wide;
#endif
    default: return &own;
    }
}
