/*
 * An attempt of a step of DOP853, of one system or of several ones in lanes: entry i of lane k is at i * lanes + k. Operations and their
 * order are the same, so that every lane gets the same bits as alone.
 */
#ifndef LAG_DOP853_H
#define LAG_DOP853_H

#include <math.h>
#include <stddef.h>

enum { LAG_DOP853_STAGES = 12, LAG_DOP853_END = 12, LAG_DOP853_SLOPES = 16, LAG_DOP853_DENSE = 4 };
/* Terms of the dense output. */
enum { LAG_DOP853_TERMS = 3 + LAG_DOP853_DENSE };

/* The next step is this part of what the error asks for; one that is tried again is no shorter than this part. */
static const double LAG_DOP853_SAFETY = 0.8;
static const double LAG_DOP853_SHRINK = 0.333;

/* The most lanes that there may be; a power of two, as is every number of lanes. */
enum { LAG_ATTEMPT_LANES = 8 };

/* A sum of slopes, for the state at `node`. */
typedef struct lag_combination {
    double node;
    unsigned count;
    unsigned char slope[13];
    double weight[13];
} lag_combination;

/* 12: the step itself; 13 to 15: further stages of the dense output. */
extern const lag_combination lag_dop853_stages[LAG_DOP853_SLOPES];
extern const lag_combination lag_dop853_fifth, lag_dop853_dense[LAG_DOP853_DENSE];
/* Difference of the new state from the embedded formula of order 3. */
extern const lag_combination lag_dop853_third;

typedef struct lag_attempt_arrays {
    size_t size, lanes;
    const double *x, *tolerance; /* (size, lanes) */
    double *slope;               /* (16, size, lanes), the first that at x */
    double *stage, *x_new;       /* (size, lanes) */
    double t[LAG_ATTEMPT_LANES];   /* of lane k */
    double h[LAG_ATTEMPT_LANES];   /* of lane k % lanes */
} lag_attempt_arrays;

struct lag_stepper;

/* Slopes of the last accepted step, and the state before it; they are there until the next attempt. */
lag_attempt_arrays lag_dop853_last(const struct lag_stepper *s);

/* The state x (size) at this part of a step from `before`, of one lane: numbers of `before` and `terms` are `lanes` apart. */
void lag_dop853_inside(size_t size, size_t lanes, const double *terms, const double *before, double part, double *x);

/* xd (size, lanes) at t (lanes) and x (size, lanes) of stage i; 0: the attempt ends. */
typedef int lag_attempt_rates(void *context, size_t i, const double *t, const double *x, double *xd);

/* 1: there are files for other widths of registers than that of the library. */
#if defined(__x86_64__) && defined(__GNUC__) && defined(__STDC_HOSTED__) && __STDC_HOSTED__
#define LAG_ATTEMPTS_WIDE 1
#else
#define LAG_ATTEMPTS_WIDE 0
#undef LAG_ATTEMPT_WIDTH /* these files have that of the library */
#endif

#if defined(__GNUC__)
#if !LAG_ATTEMPTS_WIDE || !defined(LAG_ATTEMPT_WIDTH)
#define LAG_ATTEMPT_INLINED static inline __attribute__((always_inline))
#elif LAG_ATTEMPT_WIDTH == 8
#define LAG_ATTEMPT_INLINED static inline __attribute__((always_inline, target("avx512f")))
#else
#define LAG_ATTEMPT_INLINED static inline __attribute__((always_inline, target("avx")))
#endif
/* So many numbers are side by side as a register holds: compilers keep longer vectors in memory. */
#if !defined(LAG_ATTEMPT_WIDTH) && defined(__AVX__)
#define LAG_ATTEMPT_WIDTH 4
#elif !defined(LAG_ATTEMPT_WIDTH)
#define LAG_ATTEMPT_WIDTH 2
#endif
enum { LAG_WIDTH = LAG_ATTEMPT_WIDTH };
typedef double lag_wide __attribute__((vector_size(8 * LAG_ATTEMPT_WIDTH), aligned(8), may_alias));
#pragma GCC diagnostic ignored "-Wpsabi" /* all of this is inlined */

LAG_ATTEMPT_INLINED lag_wide lag_wide_at(const double *x)
{
    return *(const lag_wide *)(const void *)x;
}

LAG_ATTEMPT_INLINED void lag_wide_to(double *x, lag_wide value)
{
    *(lag_wide *)(void *)x = value;
}

typedef unsigned long long lag_wide_bits __attribute__((vector_size(8 * LAG_ATTEMPT_WIDTH)));
typedef long long lag_wide_truth __attribute__((vector_size(8 * LAG_ATTEMPT_WIDTH), aligned(8), may_alias));

/* In each place x where the truth (all bits or none) holds, else y. */
LAG_ATTEMPT_INLINED lag_wide lag_wide_chosen(lag_wide_truth truth, lag_wide x, lag_wide y)
{
    const lag_wide_bits mask = (lag_wide_bits)truth;
    return (lag_wide)((mask & (lag_wide_bits)x) | (~mask & (lag_wide_bits)y));
}

LAG_ATTEMPT_INLINED lag_wide lag_wide_size(lag_wide x)
{
    const lag_wide none = {0.0};
    return (lag_wide)((lag_wide_bits)x & ~(lag_wide_bits)-none);
}

/* The root of each number: compilers have a word for that of each kind of register, if any. */
LAG_ATTEMPT_INLINED lag_wide lag_wide_sqrt(lag_wide x)
{
#if defined(__clang__) || !defined(__x86_64__)
    for (size_t k = 0; k < LAG_WIDTH; ++k) {
        x[k] = sqrt(x[k]);
    }
    return x;
#elif LAG_ATTEMPT_WIDTH == 8
    return (lag_wide)__builtin_ia32_sqrtpd512_mask(x, x, (char)-1, 4);
#elif LAG_ATTEMPT_WIDTH == 4
    return (lag_wide)__builtin_ia32_sqrtpd256(x);
#else
    return (lag_wide)__builtin_ia32_sqrtpd(x);
#endif
}

/* Several entries at i of the weighted slopes, added to `sum`. */
LAG_ATTEMPT_INLINED lag_wide lag_wide_added(size_t count, const lag_combination *c, const double *slope, size_t i, lag_wide sum)
{
    for (unsigned j = 0; j < c->count; ++j) {
        sum += c->weight[j] * lag_wide_at(slope + c->slope[j] * count + i);
    }
    return sum;
}

/* out = base + h * sum of the entries at i. */
LAG_ATTEMPT_INLINED void lag_wide_combined(size_t i, const double *h, lag_wide sum, const double *base, double *out)
{
    lag_wide_to(out + i, lag_wide_at(base + i) + lag_wide_at(h + i % LAG_ATTEMPT_LANES) * sum);
}
#else
#define LAG_ATTEMPT_INLINED static inline
enum { LAG_WIDTH = 1 };
typedef double lag_wide;
typedef int lag_wide_truth;

static inline lag_wide lag_wide_at(const double *x)
{
    return *x;
}

static inline void lag_wide_to(double *x, lag_wide value)
{
    *x = value;
}

static inline lag_wide lag_wide_chosen(lag_wide_truth truth, lag_wide x, lag_wide y)
{
    return truth ? x : y;
}

static inline lag_wide lag_wide_size(lag_wide x)
{
    return fabs(x);
}
#endif

/* As lag_lower() and lag_higher(), in each place. */
LAG_ATTEMPT_INLINED lag_wide lag_wide_lower(lag_wide a, lag_wide b)
{
    return lag_wide_chosen(a < b, a, b);
}

LAG_ATTEMPT_INLINED lag_wide lag_wide_higher(lag_wide a, lag_wide b)
{
    return lag_wide_chosen(a > b, a, b);
}

/* The entry at i of the weighted slopes, added to `sum`. */
LAG_ATTEMPT_INLINED double lag_added(size_t count, const lag_combination *c, const double *slope, size_t i, double sum)
{
    for (unsigned j = 0; j < c->count; ++j) {
        sum += c->weight[j] * slope[c->slope[j] * count + i];
    }
    return sum;
}

/* out = base + h * sum of `count` entries; h is as in lag_attempt_arrays. */
LAG_ATTEMPT_INLINED void lag_combine(
    size_t count, const lag_combination *c, const double *h, const double *slope, const double *base, double *out)
{
    size_t i = 0;
#if defined(__GNUC__)
    const lag_wide none = {0.0};
    for (; i + 4 * LAG_WIDTH <= count; i += 4 * LAG_WIDTH) { /* four sums, whose terms do not wait for each other */
        lag_wide sum0 = none;
        lag_wide sum1 = none;
        lag_wide sum2 = none;
        lag_wide sum3 = none;
        for (unsigned j = 0; j < c->count; ++j) {
            const double *from = slope + c->slope[j] * count + i;
            sum0 += c->weight[j] * lag_wide_at(from);
            sum1 += c->weight[j] * lag_wide_at(from + LAG_WIDTH);
            sum2 += c->weight[j] * lag_wide_at(from + 2 * LAG_WIDTH);
            sum3 += c->weight[j] * lag_wide_at(from + 3 * LAG_WIDTH);
        }
        lag_wide_combined(i, h, sum0, base, out);
        lag_wide_combined(i + LAG_WIDTH, h, sum1, base, out);
        lag_wide_combined(i + 2 * LAG_WIDTH, h, sum2, base, out);
        lag_wide_combined(i + 3 * LAG_WIDTH, h, sum3, base, out);
    }
    for (; i + 2 * LAG_WIDTH <= count; i += 2 * LAG_WIDTH) {
        lag_wide sum0 = none;
        lag_wide sum1 = none;
        for (unsigned j = 0; j < c->count; ++j) {
            const double *from = slope + c->slope[j] * count + i;
            sum0 += c->weight[j] * lag_wide_at(from);
            sum1 += c->weight[j] * lag_wide_at(from + LAG_WIDTH);
        }
        lag_wide_combined(i, h, sum0, base, out);
        lag_wide_combined(i + LAG_WIDTH, h, sum1, base, out);
    }
    for (; i + LAG_WIDTH <= count; i += LAG_WIDTH) {
        lag_wide_combined(i, h, lag_wide_added(count, c, slope, i, none), base, out);
    }
#endif
    for (; i < count; ++i) {
        out[i] = base[i] + h[i % LAG_ATTEMPT_LANES] * lag_added(count, c, slope, i, 0.0);
    }
}

/*
 * Terms (7, size, lanes) of the polynomial that Hairer, Norsett and Wanner give at the end of section II.6. The last four are of the same
 * slopes: their sums are found side by side, each in its own order.
 */
LAG_ATTEMPT_INLINED void lag_attempt_dense(const lag_attempt_arrays *at, double *terms)
{
    const lag_combination *c = lag_dop853_dense;
    const size_t count = at->size * at->lanes;
    double *to = terms + 3 * count;
    size_t i = 0;
#if defined(__GNUC__)
    for (; i + LAG_WIDTH <= count; i += LAG_WIDTH) {
        const lag_wide h = lag_wide_at(at->h + i % LAG_ATTEMPT_LANES);
        const lag_wide first = lag_wide_at(at->slope + i);
        const lag_wide change = lag_wide_at(at->x_new + i) - lag_wide_at(at->x + i);
        lag_wide_to(terms + i, change);
        lag_wide_to(terms + count + i, h * first - change);
        lag_wide_to(terms + 2 * count + i, 2.0 * change - h * (lag_wide_at(at->slope + LAG_DOP853_END * count + i) + first));
    }
#endif
    for (; i < count; ++i) {
        const double h = at->h[i % LAG_ATTEMPT_LANES];
        const double change = at->x_new[i] - at->x[i];
        terms[i] = change;
        terms[count + i] = h * at->slope[i] - change;
        terms[2 * count + i] = 2.0 * change - h * (at->slope[LAG_DOP853_END * count + i] + at->slope[i]);
    }
    i = 0;
#if defined(__GNUC__)
    const lag_wide none = {0.0};
    for (; i + LAG_WIDTH <= count; i += LAG_WIDTH) {
        const lag_wide h = lag_wide_at(at->h + i % LAG_ATTEMPT_LANES);
        lag_wide sum0 = none;
        lag_wide sum1 = none;
        lag_wide sum2 = none;
        lag_wide sum3 = none;
        for (unsigned j = 0; j < c->count; ++j) {
            const lag_wide slope = lag_wide_at(at->slope + c->slope[j] * count + i);
            sum0 += c[0].weight[j] * slope;
            sum1 += c[1].weight[j] * slope;
            sum2 += c[2].weight[j] * slope;
            sum3 += c[3].weight[j] * slope;
        }
        lag_wide_to(to + i, none + h * sum0);
        lag_wide_to(to + count + i, none + h * sum1);
        lag_wide_to(to + 2 * count + i, none + h * sum2);
        lag_wide_to(to + 3 * count + i, none + h * sum3);
    }
#endif
    for (; i < count; ++i) {
        for (size_t k = 0; k < LAG_DOP853_DENSE; ++k) {
            to[k * count + i] = 0.0 + at->h[i % LAG_ATTEMPT_LANES] * lag_added(count, c + k, at->slope, i, 0.0);
        }
    }
}

/* fault[k] stays as it is if `count` numbers of lanes are finite in lane k: zero times what is not is no number, and so is every sum with it. */
LAG_ATTEMPT_INLINED void lag_attempt_check(size_t count, size_t lanes, const double *x, double *fault)
{
    const size_t last = lanes - 1;
    size_t i = 0;
#if defined(__GNUC__)
    lag_wide a = {0.0};
    lag_wide b = {0.0};
    const int fits = lanes == LAG_WIDTH || lanes == 2 * LAG_WIDTH;
    for (; i + 2 * LAG_WIDTH <= count && fits; i += 2 * LAG_WIDTH) {
        a += 0.0 * lag_wide_at(x + i);
        b += 0.0 * lag_wide_at(x + i + LAG_WIDTH);
    }
    for (size_t k = 0; k < LAG_WIDTH && fits; ++k) {
        fault[k] += a[k];
        fault[(k + LAG_WIDTH) & last] += b[k];
    }
#endif
    for (; i < count; ++i) {
        fault[i & last] += 0.0 * x[i];
    }
}

/* The same if x[k] is larger than `least`. */
LAG_ATTEMPT_INLINED void lag_attempt_compare(size_t lanes, const double *x, double least, double *fault)
{
    size_t k = 0;
#if defined(__GNUC__)
    const lag_wide none = {0.0};
    for (; k + LAG_WIDTH <= lanes; k += LAG_WIDTH) { /* all bits set are no number */
        const lag_wide_bits sound = (lag_wide_bits)(lag_wide_at(x + k) > none + least);
        lag_wide_to(fault + k, (lag_wide)((lag_wide_bits)lag_wide_at(fault + k) | ~sound));
    }
#endif
    for (; k < lanes; ++k) {
        fault[k] = x[k] > least ? fault[k] : (double)NAN;
    }
}

/* The rates of one stage, of the step or of its dense output. 0: `rates` ended the attempt. */
LAG_ATTEMPT_INLINED int lag_attempt_stage(const lag_attempt_arrays *at, size_t i, lag_attempt_rates *rates, void *context)
{
    const size_t count = at->size * at->lanes;
    double t[LAG_ATTEMPT_LANES];
    lag_combine(count, &lag_dop853_stages[i], at->h, at->slope, at->x, at->stage);
    size_t k = 0;
#if defined(__GNUC__)
    for (; k + LAG_WIDTH <= at->lanes; k += LAG_WIDTH) {
        lag_wide_to(t + k, lag_wide_at(at->t + k) + lag_dop853_stages[i].node * lag_wide_at(at->h + k));
    }
#endif
    for (; k < at->lanes; ++k) {
        t[k] = at->t[k] + lag_dop853_stages[i].node * at->h[k];
    }
    return rates(context, i, t, at->stage, at->slope + i * count);
}

/* All stages and the new state; the slope at its end is left to attempts that are accepted. 0: `rates` ended it. */
LAG_ATTEMPT_INLINED int lag_attempt_stages(const lag_attempt_arrays *at, lag_attempt_rates *rates, void *context)
{
    for (size_t i = 1; i < LAG_DOP853_STAGES; ++i) {
        if (!lag_attempt_stage(at, i, rates, context)) {
            return 0;
        }
    }
    lag_combine(at->size * at->lanes, &lag_dop853_stages[LAG_DOP853_END], at->h, at->slope, at->x, at->x_new);
    return 1;
}

#endif
