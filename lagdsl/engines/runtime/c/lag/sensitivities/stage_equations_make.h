/* Equations of stages decomposed, and solved for columns in lanes, for one width of registers: part of column_sums_make.h. */
#ifndef LAG_STAGE_EQUATIONS_MAKE_H
#define LAG_STAGE_EQUATIONS_MAKE_H

#include "lag/sensitivities/column_sums.h"

/* to (count) = base (null: zero) + h * sum of weights times arrays of so many numbers, which start `apart` numbers from one another. */
LAG_ATTEMPT_INLINED void weigh(
    size_t stages, const double *weight, double h, size_t count, size_t apart, const double *from, const double *base, double *to)
{
    size_t i = 0;
#if defined(__GNUC__)
    for (; i + LAG_WIDTH <= count; i += LAG_WIDTH) {
        lag_wide sum = {0.0};
        for (size_t k = 0; k < stages; ++k) {
            sum += weight[k] * lag_wide_at(from + k * apart + i);
        }
        lag_wide_to(to + i, base != NULL ? lag_wide_at(base + i) + h * sum : h * sum);
    }
#endif
    for (; i < count; ++i) {
        double sum = 0.0;
        for (size_t k = 0; k < stages; ++k) {
            sum += weight[k] * from[k * apart + i];
        }
        to[i] = base != NULL ? base[i] + h * sum : h * sum;
    }
}

LAG_ATTEMPT_INLINED void swap_rows(size_t count, double *a, double *b)
{
    size_t i = 0;
#if defined(__GNUC__)
    for (; i + LAG_WIDTH <= count; i += LAG_WIDTH) {
        const lag_wide kept = lag_wide_at(a + i);
        lag_wide_to(a + i, lag_wide_at(b + i));
        lag_wide_to(b + i, kept);
    }
#endif
    for (; i < count; ++i) {
        const double kept = a[i];
        a[i] = b[i];
        b[i] = kept;
    }
}

#if defined(__GNUC__)
/* Four rows less their parts of the row of pivot k, which is zero up to there, from column `first` on. */
LAG_ATTEMPT_INLINED void subtract_from_four(size_t first, size_t apart, size_t k, const double *pivot_row, double *a)
{
    double *b = a + apart;
    double *c = b + apart;
    double *d = c + apart;
    const double of_a = a[k], of_b = b[k], of_c = c[k], of_d = d[k];
    for (size_t j = first; j < apart; j += LAG_WIDTH) {
        const lag_wide row = lag_wide_at(pivot_row + j);
        lag_wide_to(a + j, lag_wide_at(a + j) - of_a * row);
        lag_wide_to(b + j, lag_wide_at(b + j) - of_b * row);
        lag_wide_to(c + j, lag_wide_at(c + j) - of_c * row);
        lag_wide_to(d + j, lag_wide_at(d + j) - of_d * row);
    }
}
#endif

LAG_ATTEMPT_INLINED void subtract_from_one(size_t first, size_t apart, size_t k, const double *pivot_row, double *a)
{
    size_t j = first;
    const double part = a[k];
#if defined(__GNUC__)
    for (; j + LAG_WIDTH <= apart; j += LAG_WIDTH) {
        lag_wide_to(a + j, lag_wide_at(a + j) - part * lag_wide_at(pivot_row + j));
    }
#endif
    for (; j < apart; ++j) {
        a[j] -= part * pivot_row[j];
    }
}

/* The row from k on with the largest number in column k. */
LAG_ATTEMPT_INLINED size_t find_pivot(size_t n, size_t apart, const double *a, size_t k)
{
    const double *entry = a + k * apart + k;
    double most = fabs(*entry);
    size_t best = k;
    for (size_t i = k + 1; i < n; ++i) {
        entry += apart;
        const double size = fabs(*entry);
        if (size > most) {
            most = size;
            best = i;
        }
    }
    return best;
}

/* A row of the matrix, of stage i, from the row of the Jacobian there, but for the inverse of A. */
LAG_ATTEMPT_INLINED void form_row(const lag_stage_equations *e, size_t i, const double *jacobian, double *to)
{
    const size_t stages = e->table->stages;
    const size_t m = e->n - e->nq;
    for (size_t k = 0; k < stages; ++k) {
        const double by = -e->h * e->table->matrix[i][k];
        for (size_t c = 0; c < m; ++c) {
            to[k * m + c] = c < e->nq ? by * jacobian[c] : 0.0;
        }
    }
    for (size_t c = 0; c < m; ++c) {
        to[i * m + c] -= jacobian[e->nq + c];
    }
    for (size_t c = stages * m; c < lag_stage_rows_apart(stages * m); ++c) {
        to[c] = 0.0;
    }
}

LAG_ATTEMPT_INLINED void form_inlined(const lag_stage_equations *e)
{
    const size_t stages = e->table->stages;
    const size_t m = e->n - e->nq;
    for (size_t i = 0; i < stages; ++i) {
        for (size_t r = 0; r < m; ++r) {
            double *to = e->matrix + (i * m + r) * lag_stage_rows_apart(stages * m);
            form_row(e, i, e->jacobian + (i * m + r) * e->width, to);
            for (size_t k = 0; k < stages; ++k) {
                to[k * m + r] += e->table->slopes[i][k] / e->h;
            }
        }
    }
}

/* P a = L U, by outer products with partial pivoting; one more row is room for that of the pivot. Source: see lag/factorization/lu.c. */
LAG_ATTEMPT_INLINED int decompose_inlined(size_t n, double *a, double *pivot)
{
    const size_t apart = lag_stage_rows_apart(n);
    double *pivot_row = a + n * apart;
    for (size_t k = 0; k < n; ++k) {
        const size_t best = find_pivot(n, apart, a, k);
        const size_t first = (k + 1) / LAG_ATTEMPT_LANES * LAG_ATTEMPT_LANES;
        if (best != k) {
            swap_rows(apart, a + k * apart, a + best * apart);
        }
        pivot[k] = (double)best;
        if (!(fabs(a[k * apart + k]) > 0.0)) {
            return 0;
        }
        for (size_t j = first; j < apart; ++j) {
            pivot_row[j] = j > k ? a[k * apart + j] : 0.0;
        }
        const double by = 1.0 / a[k * apart + k];
        for (size_t i = k + 1; i < n; ++i) {
            a[i * apart + k] *= by;
        }
        size_t i = k + 1;
#if defined(__GNUC__)
        for (; i + 4 <= n; i += 4) {
            subtract_from_four(first, apart, k, pivot_row, a + i * apart);
        }
#endif
        for (; i < n; ++i) {
            subtract_from_one(first, apart, k, pivot_row, a + i * apart);
        }
    }
    return 1;
}

/* Rows are substituted by fours behind the first few: where that of row i begins, or it itself does. */
LAG_ATTEMPT_INLINED size_t first_of_four(size_t n, size_t i)
{
    return i < n % 4 ? i : i - (i - n % 4) % 4;
}

LAG_ATTEMPT_INLINED size_t end_of_four(size_t n, size_t i)
{
    return i < n % 4 ? i + 1 : first_of_four(n, i) + 4;
}

#if defined(__GNUC__)
/* x (n, lanes) less what known numbers from `first` to before `end` add to rows i to i + 3. */
LAG_ATTEMPT_INLINED void subtract_known(
    size_t i, size_t first, size_t end, size_t apart, const double *a, size_t lanes, double *x)
{
    const double *row = a + i * apart;
    double *to = x + i * lanes;
    lag_wide p = lag_wide_at(to), q = lag_wide_at(to + lanes), r = lag_wide_at(to + 2 * lanes), s = lag_wide_at(to + 3 * lanes);
    for (size_t j = first; j < end; ++j) {
        const lag_wide known = lag_wide_at(x + j * lanes);
        p -= row[j] * known;
        q -= row[apart + j] * known;
        r -= row[2 * apart + j] * known;
        s -= row[3 * apart + j] * known;
    }
    lag_wide_to(to, p);
    lag_wide_to(to + lanes, q);
    lag_wide_to(to + 2 * lanes, r);
    lag_wide_to(to + 3 * lanes, s);
}

/* One row of so many lanes less what known numbers from `first` to before `end` add to it. */
LAG_ATTEMPT_INLINED void subtract_known_of_one(size_t i, size_t first, size_t end, const double *row, size_t lanes, double *x)
{
    lag_wide p = lag_wide_at(x + i * lanes);
    for (size_t j = first; j < end; ++j) {
        p -= row[j] * lag_wide_at(x + j * lanes);
    }
    lag_wide_to(x + i * lanes, p);
}

/* The permuted x in as many lanes as a register holds. */
LAG_ATTEMPT_INLINED void substitute_wide(size_t n, size_t apart, const double *a, size_t lanes, double *x)
{
    for (size_t i = 0; i < n; ++i) {
        const size_t first = first_of_four(n, i);
        if (first == i && i >= n % 4) {
            subtract_known(i, 0, i, apart, a, lanes, x);
        }
        subtract_known_of_one(i, i < n % 4 ? 0 : first, i, a + i * apart, lanes, x);
    }
    for (size_t i = n; i-- > 0;) {
        const size_t end = end_of_four(n, i);
        if (end == i + 1 && i >= n % 4) {
            subtract_known(i - 3, end, n, apart, a, lanes, x);
        } else if (i < n % 4) {
            subtract_known_of_one(i, end, n, a + i * apart, lanes, x);
        }
        subtract_known_of_one(i, i + 1, end, a + i * apart, lanes, x);
        lag_wide_to(x + i * lanes, lag_wide_at(x + i * lanes) / a[i * apart + i]);
    }
}
#endif

/* The same in one lane, in the same order. */
LAG_ATTEMPT_INLINED void substitute_one(size_t n, size_t apart, const double *a, size_t lanes, double *x)
{
    for (size_t i = 0; i < n; ++i) {
        for (size_t j = 0; j < i; ++j) {
            x[i * lanes] -= a[i * apart + j] * x[j * lanes];
        }
    }
    for (size_t i = n; i-- > 0;) {
        const size_t end = end_of_four(n, i);
        for (size_t j = end; j < n; ++j) {
            x[i * lanes] -= a[i * apart + j] * x[j * lanes];
        }
        for (size_t j = i + 1; j < end; ++j) {
            x[i * lanes] -= a[i * apart + j] * x[j * lanes];
        }
        x[i * lanes] /= a[i * apart + i];
    }
}

/* x (n, lanes) := a^-1 x. */
LAG_ATTEMPT_INLINED void substitute_inlined(size_t n, const double *a, const double *pivot, size_t lanes, double *x)
{
    const size_t apart = lag_stage_rows_apart(n);
    size_t lane = 0;
    for (size_t k = 0; k < n; ++k) {
        const size_t best = (size_t)pivot[k];
        if (best != k) {
            swap_rows(lanes, x + k * lanes, x + best * lanes);
        }
    }
#if defined(__GNUC__)
    for (; lane + LAG_WIDTH <= lanes; lane += LAG_WIDTH) {
        substitute_wide(n, apart, a, lanes, x + lane);
    }
#endif
    for (; lane < lanes; ++lane) {
        substitute_one(n, apart, a, lanes, x + lane);
    }
}

#endif
