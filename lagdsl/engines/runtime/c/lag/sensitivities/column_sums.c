#define LAG_COLUMNS_TARGET

#include "lag/sensitivities/column_sums_make.h"

static const lag_column_sums own = {combine, errors, dense, multiply, rates, stage};

/* The library is one for all processors: wider registers are used where there are some. */
const lag_column_sums *lag_column_sums_here(void)
{
#if LAG_ATTEMPTS_WIDE
    if (__builtin_cpu_supports("avx512f")) {
        return &lag_column_sums_widest;
    }
    if (__builtin_cpu_supports("avx")) {
        return &lag_column_sums_wide;
    }
#endif
    return &own;
}
