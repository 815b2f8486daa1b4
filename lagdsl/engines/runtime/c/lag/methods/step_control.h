/*
 * Errors of attempts of DOP853 and the control of the lengths of its steps: of one stepper, or of several in lanes, to the same bits.
 *
 * Source: Hairer and Wanner, Solving Ordinary Differential Equations II, 2nd ed., section IV.2, formula (2.43): with the errors e of this step and
 * f of the last one, a step is followed by one that is 0.8 e^-(1/8 - 0.2 beta) f^beta times as long. Powers are those of 2: the step needs no more
 * digits than the twelve that the series here give, and the power of the C library has no lanes.
 */
#ifndef LAG_STEP_CONTROL_H
#define LAG_STEP_CONTROL_H

#include <float.h>
#include <math.h>

#include "lag/linalg/order.h"
#include "lag/methods/dop853.h"
#include "lag/stepper.h"
#include "lag/trigonometry.h"

/* Weight of the error before. */
static const double LAG_CONTROL_BETA = 0.04;
/* A step is no longer than so many times the last: more would harm the dense output of the step that follows a transient. */
static const double LAG_CONTROL_GROW = 3.0;

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
#define LAG_CONTROL(qualifiers, name, real, bits, truth, as_bits, as_real, chosen, lower, higher)                               \
    qualifiers real name##_log2(real x)                                                                                         \
    {                                                                                                                           \
        const bits exponent = (as_bits(x) + LAG_CONTROL_MIDDLE) >> 52;                                                          \
        const real whole = as_real(exponent | LAG_CONTROL_WHOLE) - (4503599627370496.0 + 1023.0);                               \
        const real part = as_real(as_bits(x) - (exponent << 52) + LAG_CONTROL_ONE);                                             \
        const real s = (part - 1.0) / (part + 1.0);                                                                             \
        const real z = s * s;                                                                                                   \
        const real w = z * z;                                                                                                   \
        const real even = 1.0 + w * (1.0 / 5.0 + w * (1.0 / 9.0 + w * (1.0 / 13.0)));                                           \
        const real odd = 1.0 / 3.0 + w * (1.0 / 7.0 + w * (1.0 / 11.0 + w * (1.0 / 15.0)));                                     \
        return whole + 2.88539008177792681472 * s * (even + z * odd);                                                           \
    }                                                                                                                           \
                                                                                                                                \
    qualifiers real name##_exp2(real x)                                                                                         \
    {                                                                                                                           \
        const real moved = x + LAG_SINCOS_ROUND;                                                                                \
        const real g = 0.69314718055994530942 * (x - (moved - LAG_SINCOS_ROUND));                                               \
        const real w = g * g;                                                                                                   \
        const real even = 1.0 + w * (1.0 / 2.0 + w * (1.0 / 24.0 + w * (1.0 / 720.0 + w * (1.0 / 40320.0 + w * (1.0 / 3628800.0))))); \
        const real odd = 1.0 + w * (1.0 / 6.0 + w * (1.0 / 120.0 + w * (1.0 / 5040.0 + w * (1.0 / 362880.0))));                 \
        return (even + g * odd) * as_real((as_bits(moved) + 1023u) << 52);                                                      \
    }                                                                                                                           \
                                                                                                                                \
    /* Of an error, the part that the next step knows. */                                                                       \
    qualifiers real name##_before(real error)                                                                                   \
    {                                                                                                                           \
        const real none = error * 0.0;                                                                                          \
        return higher(error, none + 1e-4);                                                                                      \
    }                                                                                                                           \
                                                                                                                                \
    /* Growth of the next step by an error alone: one that is lost in rounding counts as much as that. */                       \
    qualifiers real name##_part(real error)                                                                                     \
    {                                                                                                                           \
        const real none = error * 0.0;                                                                                          \
        return LAG_DOP853_SAFETY * name##_exp2(-1.0 / 8.0 * name##_log2(higher(error, none + DBL_EPSILON)));                    \
    }                                                                                                                           \
                                                                                                                                \
    /* Length of the step behind one of length h and this error, for which `proposed` was proposed, after so many rejections. */ \
    qualifiers real name##_next(real h, real proposed, real error, real before, real rejections)                                \
    {                                                                                                                           \
        const real none = error * 0.0;                                                                                          \
        const real own = (0.2 * LAG_CONTROL_BETA - 1.0 / 8.0) * name##_log2(higher(error, none + DBL_EPSILON));                 \
        const real factor = LAG_DOP853_SAFETY * name##_exp2(own + LAG_CONTROL_BETA * name##_log2(before));                      \
        const real bound = lower(none + LAG_CONTROL_GROW, higher(none + LAG_DOP853_SHRINK, factor));                            \
        const truth fresh = rejections == none;                                                                                 \
        const real next = h * chosen(fresh, bound, lower(bound, none + 1.0));                                                   \
        return chosen(fresh & (h < proposed), higher(next, proposed), next);                                                    \
    }                                                                                                                           \
                                                                                                                                \
    /* Length of a step of which h is proposed, where `rest` is left to the limit. */                                           \
    qualifiers real name##_length(real h, real rest)                                                                            \
    {                                                                                                                           \
        return chosen(h * LAG_STRETCH >= rest, rest, h);                                                                        \
    }                                                                                                                           \
                                                                                                                                \
    /* The end of a step of length h from t on. */                                                                              \
    qualifiers real name##_end(real t, real h, real limit)                                                                      \
    {                                                                                                                           \
        return chosen(h >= limit - t, limit, t + h);                                                                            \
    }

LAG_CONTROL(static inline, lag_control, double, unsigned long long, int, lag_bits, lag_of_bits, lag_chosen, lag_lower, lag_higher)

#if defined(__GNUC__)
#define LAG_WIDE_BITS(x) ((lag_wide_bits)(x))
#define LAG_WIDE_REAL(x) ((lag_wide)(x))
LAG_CONTROL(LAG_ATTEMPT_INLINED, lag_wide, lag_wide, lag_wide_bits, lag_wide_truth, LAG_WIDE_BITS, LAG_WIDE_REAL, lag_wide_chosen, lag_wide_lower,
    lag_wide_higher)
#else
LAG_CONTROL(static inline, lag_wide, double, unsigned long long, int, lag_bits, lag_of_bits, lag_chosen, lag_wide_lower, lag_wide_higher)
#endif

/* Estimates of order 5 and of order 3 at i of the error of the new state, as parts of h. */
LAG_ATTEMPT_INLINED void lag_estimates(size_t count, const double *slope, size_t i, double *fifth, double *third)
{
    *fifth = lag_added(count, &lag_dop853_fifth, slope, i, 0.0);
    *third = lag_added(count, &lag_dop853_stages[LAG_DOP853_END], slope, i, lag_added(count, &lag_dop853_third, slope, i, 0.0));
}

#if defined(__GNUC__)
/* The same of several entries. */
LAG_ATTEMPT_INLINED void lag_wide_estimates(size_t count, const double *slope, size_t i, lag_wide *fifth, lag_wide *third)
{
    const lag_combination *step = &lag_dop853_stages[LAG_DOP853_END];
    const lag_wide none = {0.0};
    lag_wide e5 = none;
    lag_wide e3 = lag_wide_added(count, &lag_dop853_third, slope, i, none);
    for (unsigned j = 0; j < step->count; ++j) { /* both are of the same slopes */
        const lag_wide x = lag_wide_at(slope + step->slope[j] * count + i);
        e5 += lag_dop853_fifth.weight[j] * x;
        e3 += step->weight[j] * x;
    }
    *fifth = e5;
    *third = e3;
}
#endif

/* Both estimates together, section II.10, formula (10.17), of lane k into error[k]. */
LAG_ATTEMPT_INLINED void lag_attempt_errors(const lag_attempt_arrays *at, double *error)
{
    const size_t count = at->size * at->lanes;
    const size_t last = at->lanes - 1; /* all ones: i & last is i % lanes, without a division */
    double fifth[LAG_ATTEMPT_LANES] = {0.0};
    double third[LAG_ATTEMPT_LANES] = {0.0};
    size_t i = 0;
#if defined(__GNUC__)
    for (; i + LAG_WIDTH <= count; i += LAG_WIDTH) {
        const lag_wide tolerance = lag_wide_at(at->tolerance + i);
        lag_wide e5, e3;
        lag_wide_estimates(count, at->slope, i, &e5, &e3);
        e5 /= tolerance;
        e3 /= tolerance;
        if (at->lanes >= LAG_WIDTH) {
            double *f = fifth + (i & last);
            double *t = third + (i & last);
            lag_wide_to(f, lag_wide_at(f) + e5 * e5);
            lag_wide_to(t, lag_wide_at(t) + e3 * e3);
            continue;
        }
        for (size_t k = 0; k < LAG_WIDTH; ++k) {
            fifth[k & last] += e5[k] * e5[k];
            third[k & last] += e3[k] * e3[k];
        }
    }
#endif
    for (; i < count; ++i) {
        double e5, e3;
        lag_estimates(count, at->slope, i, &e5, &e3);
        e5 /= at->tolerance[i];
        e3 /= at->tolerance[i];
        fifth[i & last] += e5 * e5;
        third[i & last] += e3 * e3;
    }
    size_t k = 0;
#if defined(__GNUC__)
    const lag_wide none = {0.0};
    for (; k + LAG_WIDTH <= at->lanes; k += LAG_WIDTH) {
        const lag_wide part = lag_wide_at(fifth + k);
        const lag_wide both = part + 0.01 * lag_wide_at(third + k);
        const lag_wide of_both = lag_wide_chosen(both > none, lag_wide_at(at->h + k) * part / lag_wide_sqrt(both * (double)at->size), none);
        lag_wide_to(error + k, lag_wide_chosen(0.0 * both == none, of_both, none + (double)INFINITY));
    }
#endif
    for (; k < at->lanes; ++k) {
        const double both = fifth[k] + 0.01 * third[k];
        const double of_both = both > 0.0 ? at->h[k] * fifth[k] / sqrt(both * (double)at->size) : 0.0;
        error[k] = isfinite(both) ? of_both : (double)INFINITY;
    }
}

/* h |lambda| of lane k into urge[k], from the last stage and the new state, both at the end of the step: section IV.2, (2.38). */
LAG_ATTEMPT_INLINED void lag_attempt_urges(const lag_attempt_arrays *at, double *urge)
{
    const size_t count = at->size * at->lanes;
    const size_t last = at->lanes - 1;
    const double *end = at->slope + LAG_DOP853_END * count;
    const double *stage = at->slope + (LAG_DOP853_STAGES - 1) * count;
    double change[LAG_ATTEMPT_LANES] = {0.0};
    double distance[LAG_ATTEMPT_LANES] = {0.0};
    size_t i = 0;
#if defined(__GNUC__)
    for (; i + LAG_WIDTH <= count && at->lanes >= LAG_WIDTH; i += LAG_WIDTH) {
        const lag_wide tolerance = lag_wide_at(at->tolerance + i);
        const lag_wide by = (lag_wide_at(end + i) - lag_wide_at(stage + i)) / tolerance;
        const lag_wide of = (lag_wide_at(at->x_new + i) - lag_wide_at(at->stage + i)) / tolerance;
        double *c = change + (i & last);
        double *d = distance + (i & last);
        lag_wide_to(c, lag_wide_at(c) + by * by);
        lag_wide_to(d, lag_wide_at(d) + of * of);
    }
#endif
    for (; i < count; ++i) {
        const double by = (end[i] - stage[i]) / at->tolerance[i];
        const double of = (at->x_new[i] - at->stage[i]) / at->tolerance[i];
        change[i & last] += by * by;
        distance[i & last] += of * of;
    }
    size_t k = 0;
#if defined(__GNUC__)
    const lag_wide none = {0.0};
    for (; k + LAG_WIDTH <= at->lanes; k += LAG_WIDTH) {
        const lag_wide by = lag_wide_at(change + k);
        const lag_wide of = lag_wide_at(distance + k);
        lag_wide_to(urge + k, lag_wide_chosen(of > none, lag_wide_at(at->h + k) * lag_wide_sqrt(by / of), none));
    }
#endif
    for (; k < at->lanes; ++k) {
        urge[k] = distance[k] > 0.0 ? at->h[k] * sqrt(change[k] / distance[k]) : 0.0;
    }
}

#endif
