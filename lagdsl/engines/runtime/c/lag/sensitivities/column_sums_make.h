/* The sums of column_sums.h for one width of registers: LAG_ATTEMPT_WIDTH doubles, in functions with the attribute LAG_COLUMNS_TARGET. */
#ifndef LAG_COLUMN_SUMS_MAKE_H
#define LAG_COLUMN_SUMS_MAKE_H

#include "lag/sensitivities/column_sums.h"

#if LAG_ATTEMPTS_WIDE
extern const lag_column_sums lag_column_sums_wide, lag_column_sums_widest;
#endif

#if defined(__GNUC__)
/* Four rows from row i on, whose sums do not wait for each other. */
LAG_ATTEMPT_INLINED void multiply_four(
    const lag_rows_of_columns *m, size_t i, size_t lanes, size_t lane, const double *of, const double *base, double *to)
{
    const lag_wide none = {0.0};
    const double *row = m->first + i * m->apart;
    const size_t at = i * lanes + lane;
    lag_wide a = base != NULL ? lag_wide_at(base + at) : none;
    lag_wide b = base != NULL ? lag_wide_at(base + at + lanes) : none;
    lag_wide c = base != NULL ? lag_wide_at(base + at + 2 * lanes) : none;
    lag_wide d = base != NULL ? lag_wide_at(base + at + 3 * lanes) : none;
    for (size_t j = 0; j < m->width; ++j) {
        const lag_wide x = lag_wide_at(of + j * lanes + lane);
        a += row[j] * x;
        b += row[m->apart + j] * x;
        c += row[2 * m->apart + j] * x;
        d += row[3 * m->apart + j] * x;
    }
    lag_wide_to(to + at, a);
    lag_wide_to(to + at + lanes, b);
    lag_wide_to(to + at + 2 * lanes, c);
    lag_wide_to(to + at + 3 * lanes, d);
}

LAG_ATTEMPT_INLINED void multiply_one(
    const lag_rows_of_columns *m, size_t i, size_t lanes, size_t lane, const double *of, const double *base, double *to)
{
    const lag_wide none = {0.0};
    lag_wide a = base != NULL ? lag_wide_at(base + i * lanes + lane) : none;
    for (size_t j = 0; j < m->width; ++j) {
        a += m->first[i * m->apart + j] * lag_wide_at(of + j * lanes + lane);
    }
    lag_wide_to(to + i * lanes + lane, a);
}
#endif

LAG_ATTEMPT_INLINED void multiply_inlined(const lag_rows_of_columns *m, size_t lanes, const double *of, const double *base, double *to)
{
    size_t lane = 0;
#if defined(__GNUC__)
    for (; lane + LAG_WIDTH <= lanes; lane += LAG_WIDTH) {
        for (size_t i = 0; i < m->height && m->height < 4; ++i) {
            multiply_one(m, i, lanes, lane, of, base, to);
        }
        for (size_t i = 0; i < m->height && m->height >= 4; i += 4) { /* the last rows may be among the four before */
            multiply_four(m, i + 4 <= m->height ? i : m->height - 4, lanes, lane, of, base, to);
        }
    }
#endif
    for (; lane < lanes; ++lane) {
        for (size_t i = 0; i < m->height; ++i) {
            double sum = base != NULL ? base[i * lanes + lane] : 0.0;
            for (size_t j = 0; j < m->width; ++j) {
                sum += m->first[i * m->apart + j] * of[j * lanes + lane];
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
    const lag_rows_of_columns *product, size_t lanes, const double *of, const double *base, double *to)
{
    multiply_inlined(product, lanes, of, base, to);
}

#endif
