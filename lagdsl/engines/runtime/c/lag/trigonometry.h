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

/*
 * The polynomials of z = r^2 (those of FreeBSD's k_sin.c, k_cos.c), as `sine_tail` and `cosine_tail`. With fused sums each
 * is two halves, which wait for nothing but z: it takes half as long. Without, they are Horner's rule, as tapes have them.
 */
#if LAG_FUSES
#define LAG_SINCOS_TAILS(real, z, fused, each)                                                                          \
    const real cube = z * (z * z);                                                                                     \
    const real sine_low = fused(z, fused(z, each(-1.98412698298579493134e-04), each(8.33333333332248946124e-03)),      \
        each(-1.66666666666666324348e-01));                                                                            \
    const real sine_high = fused(z, fused(z, each(1.58969099521155010221e-10), each(-2.50507602534068634195e-08)),     \
        each(2.75573137070700676789e-06));                                                                             \
    const real cosine_low = fused(z, fused(z, each(2.48015872894767294178e-05), each(-1.38888888888741095749e-03)),    \
        each(4.16666666666666019037e-02));                                                                             \
    const real cosine_high = fused(z, fused(z, each(-1.13596475577881948265e-11), each(2.08757232129817482790e-09)),   \
        each(-2.75573143513906633035e-07));                                                                            \
    const real sine_tail = fused(cube, sine_high, sine_low);                                                           \
    const real cosine_tail = fused(cube, cosine_high, cosine_low)
#else
#define LAG_SINCOS_TAILS(real, z, fused, each)                                                                          \
    const real sine_tail = -1.66666666666666324348e-01 + z * (8.33333333332248946124e-03 + z * (-1.98412698298579493134e-04 \
        + z * (2.75573137070700676789e-06 + z * (-2.50507602534068634195e-08 + z * 1.58969099521155010221e-10))));     \
    const real cosine_tail = 4.16666666666666019037e-02 + z * (-1.38888888888741095749e-03 + z * (2.48015872894767294178e-05 \
        + z * (-2.75573143513906633035e-07 + z * (2.08757232129817482790e-09 + z * -1.13596475577881948265e-11))))
#endif

/*
 * The text of both versions, for numbers or vectors (`real`) and their bits. Defines `sine` and `cosine` as bits.
 * fused(x, y, z) is x*y + z, each(x) a number as `real`.
 */
#define LAG_SINCOS_BODY(real, bits, x, as_bits, fused, each)                                                            \
    const real rounded = (x) * 0.63661977236758134308 + LAG_SINCOS_ROUND;                                              \
    const real turns = rounded - LAG_SINCOS_ROUND;                                                                     \
    const real first = (x) - turns * 1.57079632673412561417e+00;                                                       \
    const real second = turns * 6.07710050630396597660e-11;                                                            \
    const real r = first - second;                                                                                     \
    const real rest = ((first - r) - second) - turns * 2.02226624879595063154e-21;                                     \
    const real z = r * r;                                                                                              \
    LAG_SINCOS_TAILS(real, z, fused, each);                                                                            \
    const real half = 0.5 * z;                                                                                         \
    const real whole = 1.0 - half;                                                                                     \
    const real near_zero = r + fused(r * z, sine_tail, rest * whole);                                                  \
    const real near_one = whole + (((1.0 - whole) - half) + fused(z * z, cosine_tail, -(r * rest)));                   \
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
    LAG_SINCOS_BODY(double, unsigned long long, x, lag_bits, lag_fused, (double));
    memcpy(s, &sine, sizeof sine);
    memcpy(c, &cosine, sizeof cosine);
}

#if LAG_LANES

#define LAG_AS_LANES_BITS(x) ((lag_lanes_bits)(x))

/* Inlined by order: handing vectors over in memory takes as long as a third of the work. True in lanes whose arguments vectors serve. */
static inline __attribute__((always_inline)) lag_lanes_truth lag_lanes_sincos_near(lag_lanes x, lag_lanes *s, lag_lanes *c)
{
    LAG_SINCOS_BODY(lag_lanes, lag_lanes_bits, x, LAG_AS_LANES_BITS, lag_lanes_fused, lag_lanes_of);
    *s = (lag_lanes)sine;
    *c = (lag_lanes)cosine;
    return lag_lanes_abs(x) <= lag_lanes_of(LAG_SINCOS_LARGEST);
}

/* Of so many numbers those that vectors do not serve. */
static inline void lag_sincos_far(size_t count, const double *x, double *s, double *c)
{
    for (size_t i = 0; i < count; ++i) {
        if (!(fabs(x[i]) <= LAG_SINCOS_LARGEST)) {
            s[i] = sin(x[i]);
            c[i] = cos(x[i]);
        }
    }
}

/* s[i], c[i] of x[i], each a vector; the arrays do not overlap. One look at all arguments: looking at lanes takes its time. */
static inline __attribute__((always_inline)) void lag_lanes_sincos_many(
    size_t count, const lag_lanes_memory *x, lag_lanes_memory *s, lag_lanes_memory *c)
{
    lag_lanes_truth near = lag_lanes_of(0.0) == lag_lanes_of(0.0);
    for (size_t i = 0; i < count; ++i) {
        lag_lanes sine;
        lag_lanes cosine;
        near &= lag_lanes_sincos_near(x[i], &sine, &cosine);
        s[i] = sine;
        c[i] = cosine;
    }
    if (!lag_lanes_all(near)) {
        lag_sincos_far(count * LAG_LANES, (const double *)x, (double *)s, (double *)c);
    }
}

/* Of a vector of numbers. */
static inline void lag_sincos_block(const double *x, double *s, double *c)
{
    lag_lanes_sincos_many(1, (const lag_lanes_memory *)(const void *)x, (lag_lanes_memory *)(void *)s, (lag_lanes_memory *)(void *)c);
}

/* Of two or more numbers, fewer than a vector holds. */
static inline void lag_sincos_few(size_t count, const double *x, double *s, double *c)
{
    lag_lanes argument = lag_lanes_of(x[0]);
    lag_lanes_memory sine;
    lag_lanes_memory cosine;
    for (size_t i = 1; i < count; ++i) {
        argument[i] = x[i];
    }
    const lag_lanes_memory filled = argument;
    lag_lanes_sincos_many(1, &filled, &sine, &cosine);
    for (size_t i = 0; i < count; ++i) {
        s[i] = sine[i];
        c[i] = cosine[i];
    }
}

/*
 * s[i], c[i] of x[i]; the arrays do not overlap. The last vector starts where it ends with the last number: twice is cheaper
 * than one by one.
 */
static inline void lag_sincos_many(size_t count, const double *x, double *s, double *c)
{
    if (count < LAG_LANES) {
        if (count > 1) {
            lag_sincos_few(count, x, s, c);
        } else if (count == 1) {
            lag_sincos(x[0], s, c);
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
