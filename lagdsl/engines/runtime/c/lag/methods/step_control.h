/*
 * The control of the lengths of steps of DOP853: of one stepper, or of several in lanes, by the same text and to the same bits.
 *
 * Source: Hairer and Wanner, Solving Ordinary Differential Equations II, 2nd ed., section IV.2, formula (2.43): with the errors e of this step and
 * f of the last one, a step is followed by one that is 0.8 e^-(1/8 - 0.2 beta) f^beta times as long. Powers are those of 2: the step needs no more
 * digits than the twelve that the series here give, and the power of the C library has no lanes.
 */
#ifndef LAG_STEP_CONTROL_H
#define LAG_STEP_CONTROL_H

#include <math.h>

#include "lag/methods/dop853.h"
#include "lag/stepper.h"
#include "lag/trigonometry.h"

/* Weight of the error before. */
static const double LAG_CONTROL_BETA = 0.04;
/* A step is no longer than so many times the last: more would harm the dense output of the step that follows a transient. */
static const double LAG_CONTROL_GROW = 3.0;
/* The least error that counts: what is smaller lets the step grow as far as it may, */
static const double LAG_CONTROL_NONE = 1e-16;
/* and the least one that the next step knows of. */
static const double LAG_CONTROL_BEFORE = 1e-4;

static inline double lag_of_bits(unsigned long long bits)
{
    double x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

static inline double lag_chosen(int truth, double x, double y)
{
    return truth ? x : y;
}

/* Bits of 1, and what is added to those of x so that the exponent is that of a number between the roots of 1/2 and of 2. */
#define LAG_CONTROL_ONE 0x3FF0000000000000u
#define LAG_CONTROL_MIDDLE 0x00095F619980C433u
/* Adding it moves a small whole number to the last bits. */
#define LAG_CONTROL_WHOLE 0x4330000000000000u

/*
 * The functions for numbers or vectors (`real`), their bits and the truths of comparisons.
 *
 * log2: by the series of the area tangent, up to its power 15. exp2: by that of the exponential function, up to its power 10. Each is two halves
 * that wait for nothing but the square of the square.
 */
#define LAG_CONTROL(qualifiers, name, real, bits, truth, as_bits, as_real, chosen)                                            \
    qualifiers real name##_log2(real x)                                                                                    \
    {                                                                                                                      \
        const bits exponent = (as_bits(x) + LAG_CONTROL_MIDDLE) >> 52;                                                      \
        const real whole = as_real(exponent | LAG_CONTROL_WHOLE) - (4503599627370496.0 + 1023.0);                           \
        const real part = as_real(as_bits(x) - (exponent << 52) + LAG_CONTROL_ONE);                                         \
        const real s = (part - 1.0) / (part + 1.0);                                                                        \
        const real z = s * s;                                                                                              \
        const real w = z * z;                                                                                              \
        const real even = 1.0 + w * (1.0 / 5.0 + w * (1.0 / 9.0 + w * (1.0 / 13.0)));                                       \
        const real odd = 1.0 / 3.0 + w * (1.0 / 7.0 + w * (1.0 / 11.0 + w * (1.0 / 15.0)));                                 \
        return whole + 2.88539008177792681472 * s * (even + z * odd);                                                      \
    }                                                                                                                      \
                                                                                                                           \
    qualifiers real name##_exp2(real x)                                                                                    \
    {                                                                                                                      \
        const real moved = x + LAG_SINCOS_ROUND;                                                                           \
        const real g = 0.69314718055994530942 * (x - (moved - LAG_SINCOS_ROUND));                                          \
        const real w = g * g;                                                                                              \
        const real even = 1.0 + w * (1.0 / 2.0 + w * (1.0 / 24.0 + w * (1.0 / 720.0 + w * (1.0 / 40320.0 + w * (1.0 / 3628800.0))))); \
        const real odd = 1.0 + w * (1.0 / 6.0 + w * (1.0 / 120.0 + w * (1.0 / 5040.0 + w * (1.0 / 362880.0))));             \
        return (even + g * odd) * as_real((as_bits(moved) + 1023u) << 52);                                                  \
    }                                                                                                                      \
                                                                                                                           \
    qualifiers real name##_lower(real a, real b)                                                                           \
    {                                                                                                                      \
        return chosen(a < b, a, b);                                                                                        \
    }                                                                                                                      \
                                                                                                                           \
    qualifiers real name##_higher(real a, real b)                                                                          \
    {                                                                                                                      \
        return chosen(a > b, a, b);                                                                                        \
    }                                                                                                                      \
                                                                                                                           \
    /* What an error lets steps grow by, up to some power. */                                                              \
    qualifiers real name##_part(real error)                                                                                \
    {                                                                                                                      \
        const real none = error * 0.0;                                                                                     \
        return LAG_DOP853_SAFETY * name##_exp2(-1.0 / 8.0 * name##_log2(name##_higher(error, none + LAG_CONTROL_NONE)));    \
    }                                                                                                                      \
                                                                                                                           \
    /* Length of the step behind one of length h and this error, for which `proposed` was proposed, after so many rejections. */ \
    qualifiers real name##_next(real h, real proposed, real error, real before, real rejections)                           \
    {                                                                                                                      \
        const real none = error * 0.0;                                                                                     \
        const real own = (0.2 * LAG_CONTROL_BETA - 1.0 / 8.0) * name##_log2(name##_higher(error, none + LAG_CONTROL_NONE)); \
        const real factor = LAG_DOP853_SAFETY * name##_exp2(own + LAG_CONTROL_BETA * name##_log2(before));                  \
        const real bound = name##_lower(none + LAG_CONTROL_GROW, name##_higher(none + LAG_DOP853_SHRINK, factor));          \
        const truth fresh = rejections == none;                                                                            \
        const real next = h * chosen(fresh, bound, name##_lower(bound, none + 1.0));                                        \
        return chosen(fresh & (h < proposed), name##_higher(next, proposed), next);                                         \
    }                                                                                                                      \
                                                                                                                           \
    /* Length of a step of which h is proposed, where `rest` is left to the limit. */                                      \
    qualifiers real name##_length(real h, real rest)                                                                       \
    {                                                                                                                      \
        return chosen(h * LAG_STRETCH >= rest, rest, h);                                                                   \
    }                                                                                                                      \
                                                                                                                           \
    /* The end of a step of length h from t on. */                                                                         \
    qualifiers real name##_end(real t, real h, real limit)                                                                 \
    {                                                                                                                      \
        return chosen(h >= limit - t, limit, t + h);                                                                       \
    }

LAG_CONTROL(static inline, lag_control, double, unsigned long long, int, lag_bits, lag_of_bits, lag_chosen)

#if defined(__GNUC__)
#define LAG_WIDE_BITS(x) ((lag_wide_bits)(x))
#define LAG_WIDE_REAL(x) ((lag_wide)(x))
LAG_CONTROL(LAG_ATTEMPT_INLINED, lag_wide, lag_wide, lag_wide_bits, lag_wide_truth, LAG_WIDE_BITS, LAG_WIDE_REAL, lag_wide_chosen)
#else
LAG_CONTROL(static inline, lag_wide, double, unsigned long long, int, lag_bits, lag_of_bits, lag_chosen)
#endif

#endif
