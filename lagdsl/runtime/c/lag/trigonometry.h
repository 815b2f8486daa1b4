/*
 * Sine and cosine together, of many arguments at once.
 *
 * Up to LAG_SINCOS_LARGEST the argument is reduced by multiples of pi/2 that are stored in three parts (the first two products
 * are exact), and two polynomials follow, those of fdlibm (k_sin.c, k_cos.c): within one unit in the last place. There are no
 * branches, so that vectors go the same way as single numbers, to the same bits. Beyond, and for what is no number, the C
 * library is asked. -ffast-math breaks the rounding to a whole number.
 */
#ifndef LAG_TRIGONOMETRY_H
#define LAG_TRIGONOMETRY_H

#include <math.h>
#include <stddef.h>
#include <string.h>

#include "lag/lanes.h"

#define LAG_SINCOS_LARGEST 1e5

/* Adding it leaves no room for a fraction: the last bits hold the nearest whole number. */
#define LAG_SINCOS_ROUND 6755399441055744.0

/* The text of both versions, for numbers or vectors (`real`) and their bits. Defines `sine` and `cosine` as bits. */
#define LAG_SINCOS_BODY(real, bits, x, as_bits)                                                                         \
    const real rounded = (x) * 0.63661977236758134308 + LAG_SINCOS_ROUND;                                              \
    const real turns = rounded - LAG_SINCOS_ROUND;                                                                     \
    const real first = (x) - turns * 1.57079632673412561417e+00;                                                       \
    const real second = turns * 6.07710050630396597660e-11;                                                            \
    const real r = first - second;                                                                                     \
    const real rest = ((first - r) - second) - turns * 2.02226624879595063154e-21;                                     \
    const real z = r * r;                                                                                              \
    const real sine_tail = -1.66666666666666324348e-01 + z * (8.33333333332248946124e-03 + z * (-1.98412698298579493134e-04 \
        + z * (2.75573137070700676789e-06 + z * (-2.50507602534068634195e-08 + z * 1.58969099521155010221e-10))));     \
    const real cosine_tail = 4.16666666666666019037e-02 + z * (-1.38888888888741095749e-03 + z * (2.48015872894767294178e-05 \
        + z * (-2.75573143513906633035e-07 + z * (2.08757232129817482790e-09 + z * -1.13596475577881948265e-11))));    \
    const real half = 0.5 * z;                                                                                         \
    const real whole = 1.0 - half;                                                                                     \
    const real near_zero = r + (r * z * sine_tail + rest * whole);                                                     \
    const real near_one = whole + (((1.0 - whole) - half) + (z * z * cosine_tail - r * rest));                         \
    const bits quarter = as_bits(rounded);                                                                             \
    const bits odd = -(quarter & 1u);                                                                                  \
    const bits small = as_bits(near_zero);                                                                             \
    const bits large = as_bits(near_one);                                                                              \
    const bits sine = ((small & ~odd) | (large & odd)) ^ ((quarter & 2u) << 62);                                       \
    const bits cosine = ((large & ~odd) | (small & odd)) ^ (((quarter + 1u) & 2u) << 62)

static inline unsigned long long lag_bits(double x)
{
    unsigned long long bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

static inline void lag_sincos(double x, double *s, double *c)
{
    if (!(fabs(x) <= LAG_SINCOS_LARGEST)) {
        *s = sin(x);
        *c = cos(x);
        return;
    }
    LAG_SINCOS_BODY(double, unsigned long long, x, lag_bits);
    memcpy(s, &sine, sizeof sine);
    memcpy(c, &cosine, sizeof cosine);
}

#if LAG_LANES

#define LAG_AS_LANES_BITS(x) ((lag_lanes_bits)(x))

static inline void lag_lanes_sincos(const lag_lanes *x, lag_lanes *s, lag_lanes *c)
{
    const lag_lanes argument = *x; /* x may be s or c */
    LAG_SINCOS_BODY(lag_lanes, lag_lanes_bits, argument, LAG_AS_LANES_BITS);
    *s = (lag_lanes)sine;
    *c = (lag_lanes)cosine;
    const lag_lanes_bits near = (lag_lanes_bits)((argument <= LAG_SINCOS_LARGEST) & (argument >= -LAG_SINCOS_LARGEST));
    unsigned long long of_lane[LAG_LANES];
    unsigned long long all = ~0ull;
    memcpy(of_lane, &near, sizeof of_lane);
    for (size_t lane = 0; lane < LAG_LANES; ++lane) {
        all &= of_lane[lane];
    }
    for (size_t lane = 0; all == 0 && lane < LAG_LANES; ++lane) {
        if (of_lane[lane] == 0) {
            (*s)[lane] = sin(argument[lane]);
            (*c)[lane] = cos(argument[lane]);
        }
    }
}

/* s[i], c[i] of x[i], each a vector. */
static inline void lag_lanes_sincos_many(
    size_t count, const lag_lanes_memory *x, lag_lanes_memory *s, lag_lanes_memory *c)
{
    for (size_t i = 0; i < count; ++i) {
        const lag_lanes argument = x[i];
        lag_lanes sine;
        lag_lanes cosine;
        lag_lanes_sincos(&argument, &sine, &cosine);
        s[i] = sine;
        c[i] = cosine;
    }
}

static inline void lag_sincos_block(const double *x, double *s, double *c)
{
    lag_lanes argument;
    lag_lanes sine;
    lag_lanes cosine;
    memcpy(&argument, x, sizeof argument);
    lag_lanes_sincos(&argument, &sine, &cosine);
    memcpy(s, &sine, sizeof sine);
    memcpy(c, &cosine, sizeof cosine);
}

/*
 * s[i], c[i] of x[i]; the arrays do not overlap. The last vector starts where it ends with the last number: twice is cheaper
 * than one by one. A few numbers are not worth a vector: the first are needed while the others are still under way.
 */
static inline void lag_sincos_many(size_t count, const double *x, double *s, double *c)
{
    if (count < LAG_LANES) {
        for (size_t i = 0; i < count; ++i) {
            lag_sincos(x[i], s + i, c + i);
        }
        return;
    }
    for (size_t i = 0; i + LAG_LANES <= count; i += LAG_LANES) {
        lag_sincos_block(x + i, s + i, c + i);
    }
    if (count % LAG_LANES != 0) {
        const size_t last = count - LAG_LANES;
        lag_sincos_block(x + last, s + last, c + last);
    }
}

#else

static inline void lag_sincos_many(size_t count, const double *x, double *s, double *c)
{
    for (size_t i = 0; i < count; ++i) {
        lag_sincos(x[i], s + i, c + i);
    }
}

#endif

#endif
