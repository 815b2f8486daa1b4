/* Sums over columns and their equations of stages, for one width of registers: LAG_ATTEMPT_WIDTH doubles, in functions with the attribute LAG_COLUMNS_TARGET. */
#ifndef LAG_COLUMN_SUMS_MAKE_H
#define LAG_COLUMN_SUMS_MAKE_H

#include <string.h>

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
    const size_t *lead = entries->lead + block * lanes;
    const double *part = entries->lead_part + block * lanes;
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

LAG_ATTEMPT_INLINED void stage_inlined(const lag_motion_product *motion, const lag_columns_stage *of)
{
    const size_t count = motion->size * of->lanes;
    for (size_t block = 0; block < of->blocks; ++block) {
        const double *x = of->x + block * count;
        double *slopes = of->slopes + block * LAG_DOP853_SLOPES * count;
        double *columns = of->columns + block * of->height * of->lanes;
        double *point = of->stage == LAG_DOP853_END ? columns : of->point;
        if (of->stage > 0) {
            lag_combine(count, &lag_dop853_stages[of->stage], of->h, slopes, x, point);
        }
        rates_inlined(motion, of->entries, block, of->lanes, of->stage > 0 ? point : x, columns + count, slopes + of->stage * count);
    }
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

LAG_COLUMNS_TARGET static void errors(const lag_attempt_arrays *at, double *error)
{
    lag_attempt_errors(at, error);
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

/* Adds to the squares (lanes) those of x (size, lanes) by the tolerances of the state. */
LAG_ATTEMPT_INLINED void add_squares(size_t size, size_t lanes, const double *of_state, const double *x, double *squares)
{
    for (size_t i = 0; i < size; ++i) {
        const double by = 1.0 / of_state[i];
        size_t lane = 0;
#if defined(__GNUC__)
        for (; lane + LAG_WIDTH <= lanes; lane += LAG_WIDTH) {
            const lag_wide a = lag_wide_at(x + i * lanes + lane) * by;
            lag_wide_to(squares + lane, lag_wide_at(squares + lane) + a * a);
        }
#endif
        for (; lane < lanes; ++lane) {
            const double a = x[i * lanes + lane] * by;
            squares[lane] += a * a;
        }
    }
}

LAG_ATTEMPT_INLINED void tolerances_inlined(
    const lag_attempt_arrays *at, const double *of_state, double relative, const double *extent, double *to)
{
    double before[LAG_ATTEMPT_LANES] = {0.0};
    double behind[LAG_ATTEMPT_LANES] = {0.0};
    double length[LAG_ATTEMPT_LANES];
    add_squares(at->size, at->lanes, of_state, at->x, before);
    add_squares(at->size, at->lanes, of_state, at->x_new, behind);
    for (size_t lane = 0; lane < at->lanes; ++lane) {
        length[lane] = fmax(extent[lane], relative * sqrt(fmax(before[lane], behind[lane]) / (double)at->size));
    }
    for (size_t i = 0; i < at->size; ++i) {
        for (size_t lane = 0; lane < at->lanes; ++lane) {
            to[i * at->lanes + lane] = length[lane] > 0.0 ? length[lane] * of_state[i] : 1.0;
        }
    }
}

LAG_COLUMNS_TARGET static void interpolate(size_t count, const double *terms, double part, const double *base, double *to)
{
    interpolate_inlined(count, terms, part, base, to);
}

LAG_COLUMNS_TARGET static void tolerances(
    const lag_attempt_arrays *at, const double *of_state, double relative, const double *extent, double *to)
{
    tolerances_inlined(at, of_state, relative, extent, to);
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

LAG_COLUMNS_TARGET static void stage(const lag_motion_product *motion, const lag_columns_stage *of)
{
    stage_inlined(motion, of);
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
