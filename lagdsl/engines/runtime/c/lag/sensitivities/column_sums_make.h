/* Sums over columns and their equations of stages, for one width of registers: LAG_ATTEMPT_WIDTH doubles, in functions with the attribute LAG_COLUMNS_TARGET. */
#ifndef LAG_COLUMN_SUMS_MAKE_H
#define LAG_COLUMN_SUMS_MAKE_H

#include <string.h>

#include "lag/methods/step_control.h"
#include "lag/sensitivities/stage_equations_make.h"

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

/* The equations along the parameters of a block. */
LAG_ATTEMPT_INLINED void along_parameters(const lag_motion_product *motion, const lag_parameter_entries *entries, size_t block, size_t lanes)
{
    const size_t *lead = entries->lead + block * entries->columns;
    const double *part = entries->lead_part + block * entries->columns;
    for (size_t i = 0; i < motion->by_state.height; ++i) {
        const double *row = motion->by_parameter + i * motion->np;
        size_t lane = 0;
#if defined(__GNUC__)
        for (; lane + LAG_WIDTH <= lanes; lane += LAG_WIDTH) { /* numbers put down one by one would have to be waited for */
            lag_wide own = {0.0};
#pragma GCC unroll 8
            for (size_t k = 0; k < LAG_WIDTH; ++k) {
                own[k] = row[lead[lane + k]];
            }
            lag_wide_to(motion->along + i * lanes + lane, lag_wide_at(part + lane) * own);
        }
#endif
        for (; lane < lanes; ++lane) {
            motion->along[i * lanes + lane] = part[lane] * row[lead[lane]];
        }
    }
    for (size_t k = entries->first[block]; k < entries->first[block + 1]; ++k) {
        const double *column = motion->by_parameter + entries->number[k];
        for (size_t i = 0; i < motion->by_state.height; ++i) {
            motion->along[i * lanes + entries->lane[k]] += entries->part[k] * column[i * motion->np];
        }
    }
}

LAG_ATTEMPT_INLINED void rates_inlined(const lag_motion_product *motion, const lag_parameter_entries *entries, size_t block, size_t lanes,
    const double *state, const double *inputs, double *rates)
{
    const size_t positions = motion->nq * lanes;
    double *sum = motion->sum;
    if (motion->by_parameter != NULL) {
        along_parameters(motion, entries, block, lanes);
    }
    multiply_inlined(&motion->by_state, lanes, state, motion->by_parameter != NULL ? motion->along : NULL, sum);
    if (motion->by_input.width > 0) {
        multiply_inlined(&motion->by_input, lanes, inputs, sum, motion->along);
        sum = motion->along;
    }
    size_t i = 0;
#if defined(__GNUC__)
    for (; i + LAG_WIDTH <= positions; i += LAG_WIDTH) {
        lag_wide_to(rates + i, lag_wide_at(state + positions + i));
    }
#endif
    for (; i < positions; ++i) {
        rates[i] = state[positions + i];
    }
    multiply_inlined(&motion->response, lanes, sum, NULL, rates + positions);
}

/* Of a block: the slopes (stages, n, lanes) where its columns begin become what the stages add to these. */
LAG_ATTEMPT_INLINED void collocate_inlined(const lag_stage_equations *e, size_t lanes, double *slopes)
{
    const size_t stages = e->table->stages;
    const size_t m = e->n - e->nq;
    const size_t coordinates = e->nq * lanes;
    const size_t all = e->n * lanes;
    for (size_t i = 0; i < stages; ++i) {
        const lag_rows_of_columns by_coordinates = {m, e->nq, e->width, e->jacobian + i * m * e->width};
        double *known = e->coordinates + i * coordinates;
        weigh(stages, e->table->matrix[i], e->h, coordinates, all, slopes, NULL, known);
        multiply_inlined(&by_coordinates, lanes, known, slopes + i * all + coordinates, e->right + i * m * lanes);
    }
    substitute_inlined(stages * m, e->matrix, e->pivots, lanes, e->right);
    for (size_t i = 0; i < stages; ++i) {
        double *to = slopes + i * all;
        weigh(stages, e->table->matrix[i], e->h, coordinates, m * lanes, e->right, e->coordinates + i * coordinates, to);
        memcpy(to + coordinates, e->right + i * m * lanes, m * lanes * sizeof(double));
    }
}

LAG_COLUMNS_TARGET static void combine(
    size_t count, const lag_combination *c, const double *h, const double *slope, const double *base, double *out)
{
    lag_combine(count, c, h, slope, base, out);
}

LAG_COLUMNS_TARGET static void dense(const lag_attempt_arrays *at, double *terms)
{
    lag_attempt_dense(at, terms);
}

LAG_ATTEMPT_INLINED void interpolate_inlined(size_t count, const double *terms, double part, const double *base, double *to)
{
    size_t i = 0;
#if defined(__GNUC__)
    for (; i + LAG_WIDTH <= count; i += LAG_WIDTH) {
        lag_wide sum = {0.0};
        for (size_t k = LAG_DOP853_TERMS; k-- > 0;) {
            sum = (sum + lag_wide_at(terms + k * count + i)) * (k % 2 == 0 ? part : 1.0 - part);
        }
        lag_wide_to(to + i, lag_wide_at(base + i) + sum);
    }
#endif
    for (; i < count; ++i) {
        double sum = 0.0;
        for (size_t k = LAG_DOP853_TERMS; k-- > 0;) {
            sum = (sum + terms[k * count + i]) * (k % 2 == 0 ? part : 1.0 - part);
        }
        to[i] = base[i] + sum;
    }
}

/* Sums of squares of a column: of both estimates of its error (Hairer, Norsett and Wanner, section II.10), of it before the step and behind it. */
typedef struct squares {
    double fifth[LAG_ATTEMPT_LANES], third[LAG_ATTEMPT_LANES], before[LAG_ATTEMPT_LANES], behind[LAG_ATTEMPT_LANES];
} squares;

#if defined(__GNUC__)
/* Of as many lanes as a register holds, from `lane` on. */
LAG_ATTEMPT_INLINED void square_wide(const lag_attempt_arrays *at, const double *of_state, size_t lane, squares *to)
{
    const size_t count = at->size * at->lanes;
    const lag_wide none = {0.0};
    lag_wide fifth = none, third = none, before = none, behind = none;
    for (size_t i = 0; i < at->size; ++i) {
        const size_t entry = i * at->lanes + lane;
        const double by = 1.0 / of_state[i];
        lag_wide e5, e3;
        lag_wide_estimates(count, at->slope, entry, &e5, &e3);
        const lag_wide x = lag_wide_at(at->x + entry) * by;
        const lag_wide x_new = lag_wide_at(at->x_new + entry) * by;
        e5 *= by;
        e3 *= by;
        fifth += e5 * e5;
        third += e3 * e3;
        before += x * x;
        behind += x_new * x_new;
    }
    lag_wide_to(to->fifth + lane, fifth);
    lag_wide_to(to->third + lane, third);
    lag_wide_to(to->before + lane, before);
    lag_wide_to(to->behind + lane, behind);
}
#endif

LAG_ATTEMPT_INLINED void square_one(const lag_attempt_arrays *at, const double *of_state, size_t lane, squares *to)
{
    const size_t count = at->size * at->lanes;
    to->fifth[lane] = to->third[lane] = to->before[lane] = to->behind[lane] = 0.0;
    for (size_t i = 0; i < at->size; ++i) {
        const size_t entry = i * at->lanes + lane;
        const double by = 1.0 / of_state[i];
        double e5, e3;
        lag_estimates(count, at->slope, entry, &e5, &e3);
        e5 *= by;
        e3 *= by;
        const double x = at->x[entry] * by;
        const double x_new = at->x_new[entry] * by;
        to->fifth[lane] += e5 * e5;
        to->third[lane] += e3 * e3;
        to->before[lane] += x * x;
        to->behind[lane] += x_new * x_new;
    }
}

LAG_ATTEMPT_INLINED double error_inlined(const lag_attempt_arrays *at, const double *of_state, double relative, const double *extent)
{
    const double size = (double)at->size;
    const double mean = relative * relative / size;
    squares found;
    double most = 0.0;
    size_t lane = 0;
#if defined(__GNUC__)
    for (; lane + LAG_WIDTH <= at->lanes; lane += LAG_WIDTH) {
        square_wide(at, of_state, lane, &found);
    }
#endif
    for (; lane < at->lanes; ++lane) {
        square_one(at, of_state, lane, &found);
    }
    for (size_t k = 0; k < at->lanes; ++k) {
        const double both = found.fifth[k] + 0.01 * found.third[k];
        const double part = at->h[k] * found.fifth[k];
        const double larger = found.behind[k] > found.before[k] ? found.behind[k] : found.before[k];
        const double own = mean * larger;
        const double length = own > extent[k] * extent[k] ? own : extent[k] * extent[k];
        const double square = both > 0.0 ? part * part / (both * size * (length > 0.0 ? length : 1.0)) : 0.0;
        most = square > most ? square : most;
        most = isfinite(both) ? most : (double)INFINITY;
    }
    return sqrt(most);
}

LAG_COLUMNS_TARGET static double error(const lag_attempt_arrays *at, const double *of_state, double relative, const double *extent)
{
    return error_inlined(at, of_state, relative, extent);
}

LAG_COLUMNS_TARGET static void interpolate(size_t count, const double *terms, double part, const double *base, double *to)
{
    interpolate_inlined(count, terms, part, base, to);
}

LAG_COLUMNS_TARGET static void multiply(
    const lag_rows_of_columns *product, size_t lanes, const double *of, const double *base, double *to)
{
    multiply_inlined(product, lanes, of, base, to);
}

LAG_COLUMNS_TARGET static void rates(const lag_motion_product *motion, const lag_parameter_entries *entries, size_t block, size_t lanes,
    const double *state, const double *inputs, double *to)
{
    rates_inlined(motion, entries, block, lanes, state, inputs, to);
}

LAG_COLUMNS_TARGET static int decompose(const lag_stage_equations *equations)
{
    form_inlined(equations);
    return decompose_inlined(equations->table->stages * (equations->n - equations->nq), equations->matrix, equations->pivots);
}

LAG_COLUMNS_TARGET static void collocate(const lag_stage_equations *equations, size_t lanes, double *slopes)
{
    collocate_inlined(equations, lanes, slopes);
}

#endif
