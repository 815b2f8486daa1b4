/* Attempts in registers of 512 bits, for processors that have them. */
#define LAG_ATTEMPT_WIDTH 8

#include "lag/methods/attempts_make.h"

#if LAG_ATTEMPTS_WIDE

__attribute__((target("avx512f"))) void lag_attempts_make_widest(lag_attempts *groups, size_t count)
{
    lag_attempts_make_inlined(groups, count);
}

#endif
