/* Attempts in registers of 256 bits, for processors that have them. */
#define LAG_ATTEMPT_WIDTH 4

#include "lag/methods/attempts_make.h"

#if LAG_ATTEMPTS_WIDE

__attribute__((target("avx"))) void lag_attempts_make_wide(lag_attempts *groups, size_t count)
{
    lag_attempts_make_inlined(groups, count);
}

#endif
