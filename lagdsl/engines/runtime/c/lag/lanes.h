/*
 * Several numbers at once, where the compiler knows vectors (GCC, Clang); elsewhere LAG_LANES is 0 and there are none.
 *
 * Every operation is that of a single number, lane by lane: the same bits come out.
 */
#ifndef LAG_LANES_H
#define LAG_LANES_H

#include <stddef.h>

#include "lag/elementary.h"

#if defined(__GNUC__)

/*
 * Numbers in a vector: as many as a register of the machine holds. More would be kept in memory. Between single numbers,
 * registers of 512 bits cost more than they save (Intel, 64-ia-32 optimization manual: while they are at work one of the units
 * for arithmetic is closed to everything else): files of such code define LAG_LANES_AMONG_SINGLES.
 */
#if defined(__AVX512F__) && !defined(LAG_LANES_AMONG_SINGLES)
#define LAG_LANES 8
#define LAG_LANES_EACH(x) {x, x, x, x, x, x, x, x}
#elif defined(__AVX__)
#define LAG_LANES 4
#define LAG_LANES_EACH(x) {x, x, x, x}
#else
#define LAG_LANES 2
#define LAG_LANES_EACH(x) {x, x}
#endif

typedef double lag_lanes __attribute__((vector_size(8 * LAG_LANES)));
typedef unsigned long long lag_lanes_bits __attribute__((vector_size(8 * LAG_LANES)));
typedef long long lag_lanes_truth __attribute__((vector_size(8 * LAG_LANES)));

/* A vector in an array of doubles. */
typedef double lag_lanes_memory __attribute__((vector_size(8 * LAG_LANES), aligned(8), may_alias));

/* All of this is inlined, so how vectors are handed over does not matter. */
#pragma GCC diagnostic ignored "-Wpsabi"

static inline lag_lanes lag_lanes_of(double x)
{
    return (lag_lanes)LAG_LANES_EACH(x);
}

/* One of the functions of a single number, lane by lane. */
#define LAG_LANES_UNARY(name, function)              \
    static inline lag_lanes name(lag_lanes x)        \
    {                                                \
        for (size_t lane = 0; lane < LAG_LANES; ++lane) { \
            x[lane] = function(x[lane]);             \
        }                                            \
        return x;                                    \
    }

#define LAG_LANES_BINARY(name, function)                     \
    static inline lag_lanes name(lag_lanes x, lag_lanes y)   \
    {                                                        \
        for (size_t lane = 0; lane < LAG_LANES; ++lane) {    \
            x[lane] = function(x[lane], y[lane]);            \
        }                                                    \
        return x;                                            \
    }

/* GCC and Clang before 16 do not know it. */
#ifdef __has_builtin
#if __has_builtin(__builtin_elementwise_fma)
#define LAG_HAS_ELEMENTWISE_FMA
#endif
#endif

/* lag_fused() lane by lane; of vectors neither C nor -ffp-contract knows it. */
static inline lag_lanes lag_lanes_fused(lag_lanes x, lag_lanes y, lag_lanes z)
{
#if LAG_FUSES && defined(LAG_HAS_ELEMENTWISE_FMA)
    return __builtin_elementwise_fma(x, y, z);
#elif LAG_FUSES && !defined(__clang__) && LAG_LANES == 8
    return (lag_lanes)__builtin_ia32_vfmaddpd512_mask(x, y, z, (unsigned char)-1, 4);
#elif LAG_FUSES && !defined(__clang__) && LAG_LANES == 4
    return (lag_lanes)__builtin_ia32_vfmaddpd256(x, y, z);
#elif LAG_FUSES
    for (size_t lane = 0; lane < LAG_LANES; ++lane) {
        x[lane] = lag_fused(x[lane], y[lane], z[lane]);
    }
    return x;
#else
    return x * y + z;
#endif
}

LAG_LANES_UNARY(lag_lanes_tan, tan)
LAG_LANES_UNARY(lag_lanes_asin, asin)
LAG_LANES_UNARY(lag_lanes_acos, acos)
LAG_LANES_UNARY(lag_lanes_atan, atan)
LAG_LANES_UNARY(lag_lanes_sinh, sinh)
LAG_LANES_UNARY(lag_lanes_cosh, cosh)
LAG_LANES_UNARY(lag_lanes_tanh, tanh)
LAG_LANES_UNARY(lag_lanes_exp, exp)
LAG_LANES_UNARY(lag_lanes_log, log)
LAG_LANES_UNARY(lag_lanes_sqrt, sqrt)
LAG_LANES_UNARY(lag_lanes_floor, floor)
LAG_LANES_UNARY(lag_lanes_ceil, ceil)
LAG_LANES_BINARY(lag_lanes_pow, pow)
LAG_LANES_BINARY(lag_lanes_atan2, atan2)
LAG_LANES_BINARY(lag_lanes_mod, lag_mod)

/* True if the condition (all bits or none in each lane) holds in all lanes. */
static inline int lag_lanes_all(lag_lanes_truth condition)
{
#if defined(__clang__) || !defined(__x86_64__)
    long long all = condition[0];
    for (size_t lane = 1; lane < LAG_LANES; ++lane) {
        all &= condition[lane];
    }
    return all != 0;
#elif LAG_LANES == 8
    return __builtin_ia32_ptestmq512(condition, condition, (unsigned char)-1) == (unsigned char)-1;
#elif LAG_LANES == 4
    return __builtin_ia32_movmskpd256((lag_lanes)condition) == 15;
#else
    return __builtin_ia32_movmskpd((lag_lanes)condition) == 3;
#endif
}

/* In each lane: `value` if the condition (all bits or none) holds, else `otherwise`. */
static inline lag_lanes lag_lanes_choose(lag_lanes_truth condition, lag_lanes value, lag_lanes otherwise)
{
    const lag_lanes_bits mask = (lag_lanes_bits)condition;
    return (lag_lanes)((mask & (lag_lanes_bits)value) | (~mask & (lag_lanes_bits)otherwise));
}

static inline lag_lanes lag_lanes_number(lag_lanes_truth condition)
{
    return lag_lanes_choose(condition, lag_lanes_of(1.0), lag_lanes_of(0.0));
}

static inline lag_lanes lag_lanes_min(lag_lanes x, lag_lanes y)
{
    return lag_lanes_choose(x <= y, x, y);
}

static inline lag_lanes lag_lanes_max(lag_lanes x, lag_lanes y)
{
    return lag_lanes_choose(x >= y, x, y);
}

static inline lag_lanes lag_lanes_less(lag_lanes x, lag_lanes y)
{
    return lag_lanes_number(x < y);
}

static inline lag_lanes lag_lanes_less_equal(lag_lanes x, lag_lanes y)
{
    return lag_lanes_number(x <= y);
}

static inline lag_lanes lag_lanes_equal(lag_lanes x, lag_lanes y)
{
    return lag_lanes_number(x == y);
}

static inline lag_lanes lag_lanes_not(lag_lanes x)
{
    return lag_lanes_number(x == lag_lanes_of(0.0));
}

static inline lag_lanes lag_lanes_and(lag_lanes x, lag_lanes y)
{
    return lag_lanes_number((x != lag_lanes_of(0.0)) & (y != lag_lanes_of(0.0)));
}

static inline lag_lanes lag_lanes_or(lag_lanes x, lag_lanes y)
{
    return lag_lanes_number((x != lag_lanes_of(0.0)) | (y != lag_lanes_of(0.0)));
}

static inline lag_lanes lag_lanes_select(lag_lanes condition, lag_lanes value, lag_lanes otherwise)
{
    return lag_lanes_choose(condition != lag_lanes_of(0.0), value, otherwise);
}

static inline lag_lanes lag_lanes_abs(lag_lanes x)
{
    return (lag_lanes)((lag_lanes_bits)x & ~(lag_lanes_bits)lag_lanes_of(-0.0));
}

static inline lag_lanes lag_lanes_sign(lag_lanes x)
{
    const lag_lanes zero = lag_lanes_of(0.0);
    return lag_lanes_choose(x > zero, lag_lanes_of(1.0), lag_lanes_choose(x < zero, lag_lanes_of(-1.0), x));
}

#else
#define LAG_LANES 0
#endif

#endif
