/* The sums of column_sums.h for one width of registers: LAG_ATTEMPT_WIDTH doubles, in functions with the attribute LAG_COLUMNS_TARGET. */
#ifndef LAG_COLUMN_SUMS_MAKE_H
#define LAG_COLUMN_SUMS_MAKE_H

#include "lag/sensitivities/column_sums.h"

#if LAG_ATTEMPTS_WIDE
extern const lag_column_sums lag_column_sums_wide, lag_column_sums_widest;
#endif

LAG_ATTEMPT_INLINED void multiply_inlined(
    size_t height, size_t width, size_t lanes, const double *matrix, const double *of, const double *base, double *to)
{
    size_t lane = 0;
#if defined(__GNUC__)
    const lag_wide none = {0.0};
    for (; lane + LAG_WIDTH <= lanes; lane += LAG_WIDTH) {
        size_t i = 0;
        for (; i + 4 <= height; i += 4) { /* four sums, whose terms do not wait for each other */
            const double *row = matrix + i * width;
            const size_t at = i * lanes + lane;
            lag_wide a = base != NULL ? lag_wide_at(base + at) : none;
            lag_wide b = base != NULL ? lag_wide_at(base + at + lanes) : none;
            lag_wide c = base != NULL ? lag_wide_at(base + at + 2 * lanes) : none;
            lag_wide d = base != NULL ? lag_wide_at(base + at + 3 * lanes) : none;
            for (size_t j = 0; j < width; ++j) {
                const lag_wide x = lag_wide_at(of + j * lanes + lane);
                a += row[j] * x;
                b += row[width + j] * x;
                c += row[2 * width + j] * x;
                d += row[3 * width + j] * x;
            }
            lag_wide_to(to + at, a);
            lag_wide_to(to + at + lanes, b);
            lag_wide_to(to + at + 2 * lanes, c);
            lag_wide_to(to + at + 3 * lanes, d);
        }
        for (; i < height; ++i) {
            lag_wide a = base != NULL ? lag_wide_at(base + i * lanes + lane) : none;
            for (size_t j = 0; j < width; ++j) {
                a += matrix[i * width + j] * lag_wide_at(of + j * lanes + lane);
            }
            lag_wide_to(to + i * lanes + lane, a);
        }
    }
#endif
    for (; lane < lanes; ++lane) {
        for (size_t i = 0; i < height; ++i) {
            double sum = base != NULL ? base[i * lanes + lane] : 0.0;
            for (size_t j = 0; j < width; ++j) {
                sum += matrix[i * width + j] * of[j * lanes + lane];
            }
            to[i * lanes + lane] = sum;
        }
    }
}

LAG_COLUMNS_TARGET static void combine(
    size_t count, const lag_combination *c, const double *h, const double *slope, const double *base, double *out)
{
    lag_combine(count, c, h, slope, base, out);
}

LAG_COLUMNS_TARGET static void errors(const lag_attempt_arrays *at, double *error)
{
    lag_attempt_errors(at, error);
}

LAG_COLUMNS_TARGET static void dense(const lag_attempt_arrays *at, double *terms)
{
    lag_attempt_dense(at, terms);
}

LAG_COLUMNS_TARGET static void multiply(
    size_t height, size_t width, size_t lanes, const double *matrix, const double *of, const double *base, double *to)
{
    multiply_inlined(height, width, lanes, matrix, of, base, to);
}

#endif
