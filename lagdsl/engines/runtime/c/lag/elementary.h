/* Operations of generated code that the C library lacks; conditions are the numbers 0 and 1. */
#ifndef LAG_ELEMENTARY_H
#define LAG_ELEMENTARY_H

#include <math.h>

/*
 * Long functions take compilers long: what was cut into pieces stays so. In loops over several arrays with different steps GCC
 * (seen with 12.2) chooses induction variables that its own alias analysis then misreads, and loses stores.
 */
#if defined(__clang__)
#define LAG_APART __attribute__((noinline))
#elif defined(__GNUC__)
#define LAG_APART __attribute__((noinline, optimize("no-ivopts")))
#else
#define LAG_APART
#endif

/*
 * Long straight code holds more values than there are registers. Each of its reads and writes of the stack is a byte shorter
 * from the frame pointer, and code that is too long for the cache of decoded instructions runs as fast as its bytes are read.
 */
#if defined(__GNUC__) && !defined(__clang__)
#define LAG_LONG __attribute__((optimize("no-omit-frame-pointer", "live-range-shrinkage")))
#else
#define LAG_LONG
#endif

/* One call of a piece of rolled code: which, how often it goes round, and where its tables start. */
typedef struct lag_step {
    int kernel, laps, head, value;
} lag_step;

/* x*y + z, rounded once where the machine does that as fast as a product; with LAG_ALIKE as all machines can. */
#if !defined(LAG_ALIKE) && (defined(__FP_FAST_FMA) || defined(__FMA__) || defined(__ARM_FEATURE_FMA))
#define LAG_FUSES 1
#else
#define LAG_FUSES 0
#endif

static inline double lag_fused(double x, double y, double z)
{
#if LAG_FUSES
    return fma(x, y, z);
#else
    return x * y + z;
#endif
}

/* Not a number for an argument that is not a number. */
static inline double lag_sign(double x)
{
    return x > 0.0 ? 1.0 : x < 0.0 ? -1.0 : x;
}

/* x - floor(x/y)*y, with the sign of y. */
static inline double lag_mod(double x, double y)
{
    return x - floor(x / y) * y;
}

static inline double lag_min(double x, double y)
{
    return x <= y ? x : y;
}

static inline double lag_max(double x, double y)
{
    return x >= y ? x : y;
}

static inline double lag_less(double x, double y)
{
    return x < y ? 1.0 : 0.0;
}

static inline double lag_less_equal(double x, double y)
{
    return x <= y ? 1.0 : 0.0;
}

static inline double lag_equal(double x, double y)
{
    return x == y ? 1.0 : 0.0;
}

static inline double lag_not(double x)
{
    return x == 0.0 ? 1.0 : 0.0;
}

static inline double lag_and(double x, double y)
{
    return x != 0.0 && y != 0.0 ? 1.0 : 0.0;
}

static inline double lag_or(double x, double y)
{
    return x != 0.0 || y != 0.0 ? 1.0 : 0.0;
}

static inline double lag_select(double condition, double value, double otherwise)
{
    return condition != 0.0 ? value : otherwise;
}

#endif
