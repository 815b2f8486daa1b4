#include "lag/equations/rank.h"

#include <math.h>
#include <string.h>

#include "lag/equations/entries.h"
#include "lag/linalg/arena.h"
#include "lag/linalg/vector.h"

/*
 * With x' J1 J0' x above this part of x' J0 J0' x for all x, no combination of rows vanishes on the straight way from J0 to J1:
 * x' (J0 + s (J1 - J0)) J0' x > 0.
 */
static const double LEFT = 0.25;

/* Rows that come and go, or follow from others, say nothing. */
static int counts(const lag_rank_estimate *estimate, size_t row)
{
    const int redundant = estimate->model->redundant != NULL && estimate->model->redundant[row];
    return !redundant && estimate->follows[row] == 0.0 && (estimate->lasting == NULL || estimate->lasting[row] != 0.0);
}

/* So many of the rows that count follow from others, although nobody said which. */
static size_t redundant_rows(const lag_rank_estimate *estimate)
{
    size_t count = 0;
    for (size_t i = 0; i < estimate->m; ++i) {
        count += (size_t)counts(estimate, i);
    }
    return count > estimate->most ? count - estimate->most : 0;
}

/*
 * The row at place i with the rows up to there, from the first on with which it shares a column: `sums` of a with b, `others` of b with a,
 * `of_b` of b with b, in one walk over the entries of its columns.
 */
static void take_products(const lag_rank_estimate *estimate, size_t i, const double *a, const double *b, double *sums, double *others, double *of_b)
{
    const size_t row = lag_index(estimate->order[i]);
    const size_t reach = lag_index(estimate->reach[i]);
    lag_fill(i + 1 - reach, 0.0, sums + reach);
    lag_fill(i + 1 - reach, 0.0, others + reach);
    lag_fill(i + 1 - reach, 0.0, of_b + reach);
    for (size_t k = lag_index(estimate->first[row]); k < lag_rank_end_of(estimate, row); ++k) {
        const size_t column = lag_index(estimate->column[k]);
        const int some = a[k] != 0.0 || b[k] != 0.0; /* most of a dense row is zero */
        const size_t end = some ? lag_index(estimate->columns.first[column + 1]) : 0;
        for (size_t e = lag_index(estimate->columns.first[column]); e < end && estimate->columns.place[e] <= (double)i; ++e) {
            const size_t j = lag_index(estimate->columns.place[e]);
            const size_t other = lag_index(estimate->columns.entry[e]);
            sums[j] += a[k] * b[other];
            others[j] += b[k] * a[other];
            of_b[j] += b[k] * b[other];
        }
    }
}

/* Of the row at place i of a with rows of a. */
static void take_squares(const lag_rank_estimate *estimate, size_t i, const double *a, double *sums)
{
    const size_t row = lag_index(estimate->order[i]);
    const size_t reach = lag_index(estimate->reach[i]);
    lag_fill(i + 1 - reach, 0.0, sums + reach);
    for (size_t k = lag_index(estimate->first[row]); k < lag_rank_end_of(estimate, row); ++k) {
        const size_t column = lag_index(estimate->column[k]);
        const size_t end = a[k] != 0.0 ? lag_index(estimate->columns.first[column + 1]) : 0;
        for (size_t e = lag_index(estimate->columns.first[column]); e < end && estimate->columns.place[e] <= (double)i; ++e) {
            sums[lag_index(estimate->columns.place[e])] += a[k] * a[lag_index(estimate->columns.entry[e])];
        }
    }
}

/* x . y in sums of which none waits for another. */
static double dot(size_t count, const double *x, const double *y)
{
    double first = 0.0;
    double second = 0.0;
    double third = 0.0;
    double fourth = 0.0;
    size_t k = 0;
    for (; k + 4 <= count; k += 4) {
        first += x[k] * y[k];
        second += x[k + 1] * y[k + 1];
        third += x[k + 2] * y[k + 2];
        fourth += x[k + 3] * y[k + 3];
    }
    return (first + second) + (third + fourth) + lag_dot(count - k, x + k, y + k);
}

/* The line of place i of the lower half, to be indexed by places. */
static double *line_of(const lag_rank_estimate *estimate, size_t i)
{
    return estimate->matrix.band + lag_index(estimate->matrix.start[i]) - lag_index(estimate->reach[i]);
}

/* Entry (i, j) of the triangle, j < i, by the entries of both lines before it, from place `from` on. */
static double entry_of(const lag_rank_estimate *estimate, size_t i, size_t j, size_t from)
{
    const size_t reach = lag_index(estimate->reach[i]) > from ? lag_index(estimate->reach[i]) : from;
    const size_t other = lag_index(estimate->reach[j]);
    const size_t both = other > reach ? other : reach;
    const double *line = line_of(estimate, i);
    const double *above = line_of(estimate, j);
    return (line[j] - dot(j - both, line + both, above + both)) / above[j];
}

/* The line of place i from place `from` on, its pivot last, which is returned. */
static double eliminate_line(const lag_rank_estimate *estimate, size_t i, size_t from)
{
    const size_t reach = lag_index(estimate->reach[i]);
    double *line = line_of(estimate, i);
    for (size_t j = reach > from ? reach : from; j < i; ++j) {
        line[j] = entry_of(estimate, i, j, from);
        line[i] -= line[j] * line[j];
    }
    return line[i];
}

/* The row at place i follows from others: it stands for itself alone. */
static void leave_out(lag_rank_estimate *estimate, size_t i)
{
    const size_t reach = lag_index(estimate->reach[i]);
    double *line = line_of(estimate, i);
    estimate->follows[lag_index(estimate->order[i])] = 1.0;
    lag_fill(i - reach, 0.0, line + reach);
    line[i] = 1.0;
    for (size_t r = estimate->m - estimate->matrix.border; r < estimate->m; ++r) {
        if (r > i && i >= lag_index(estimate->reach[r])) {
            line_of(estimate, r)[i] = 0.0;
        }
    }
}

/* Of the square of the border's determinant, in its triangle, the part that is left where the row at place i stands before it: 1 - y' S^-1 y. */
static double part_left(const lag_rank_estimate *estimate, size_t i)
{
    const size_t begin = estimate->m - estimate->matrix.border;
    double *solved = estimate->columns.products; /* the triangle's inverse times y */
    double part = 1.0;
    for (size_t r = begin; r < estimate->m; ++r) {
        double *line = line_of(estimate, r);
        const int apart = i < lag_index(estimate->reach[r]);
        const double y = apart ? 0.0 : entry_of(estimate, r, i, 0);
        if (!apart) {
            line[i] = y;
        }
        solved[r - begin] = (y - lag_dot(r - begin, line + begin, solved)) / line[r];
        part -= solved[r - begin] * solved[r - begin];
    }
    return part;
}

/* Takes y y' of the row at place i from the matrix of which the border has the triangle, by hyperbolic rotations. */
static void take_from_border(const lag_rank_estimate *estimate, size_t i)
{
    const size_t begin = estimate->m - estimate->matrix.border;
    double *y = estimate->columns.products;
    for (size_t r = begin; r < estimate->m; ++r) {
        y[r - begin] = i < lag_index(estimate->reach[r]) ? 0.0 : line_of(estimate, r)[i];
    }
    for (size_t k = begin; k < estimate->m; ++k) {
        double *pivot = line_of(estimate, k) + k;
        const double sine = y[k - begin] / *pivot;
        const double cosine = sqrt((1.0 - sine) * (1.0 + sine));
        *pivot *= cosine;
        for (size_t r = k + 1; r < estimate->m; ++r) {
            double *entry = line_of(estimate, r) + k;
            *entry = (*entry - sine * y[r - begin]) / cosine;
            y[r - begin] = cosine * y[r - begin] - sine * *entry;
        }
    }
}

/* The part that a row leaves of itself beside those before it; `spare`: so many more may follow from others. False: none is left. */
static int is_left(lag_rank_estimate *estimate, size_t i, double pivot, size_t *spare, double *least)
{
    if (*spare > 0 && pivot <= LAG_FOLLOWS * LAG_FOLLOWS) {
        --*spare;
        leave_out(estimate, i);
        return 1;
    }
    *least = pivot < *least ? pivot : *least;
    return pivot > 0.0;
}

/*
 * Cholesky's method within the band, without up to `spare` rows that follow from others. Returns the smallest pivot; zero where the matrix is
 * not positive definite.
 *
 * The rows of the border come first, and last in the band: the pivot of another row is that of the band times the part of the determinant
 * that it leaves to the border. So pivots are those of dense rows at the top, which fill nothing where they stand.
 */
static double least_pivot(lag_rank_estimate *estimate, size_t spare)
{
    const size_t begin = estimate->m - estimate->matrix.border;
    double least = (double)INFINITY;
    for (size_t i = begin; i < estimate->m; ++i) {
        const double pivot = eliminate_line(estimate, i, begin);
        double *own = line_of(estimate, i) + i;
        *own = sqrt(pivot);
        if (!is_left(estimate, i, pivot, &spare, &least)) {
            return 0.0;
        }
    }
    for (size_t i = 0; i < begin; ++i) {
        const double alone = eliminate_line(estimate, i, 0);
        double *own = line_of(estimate, i) + i;
        *own = sqrt(alone);
        const double pivot = alone > 0.0 && begin < estimate->m ? alone * part_left(estimate, i) : alone;
        if (!is_left(estimate, i, pivot, &spare, &least)) {
            return 0.0;
        }
        take_from_border(estimate, i);
    }
    return least;
}

/* Products of rows in `sums`, up to place i, become its line of the matrix. Of each row that does not count with itself one. */
static void put_line(const lag_rank_estimate *estimate, size_t i, const double *sums, const double *counted)
{
    const size_t reach = lag_index(estimate->reach[i]);
    double *line = estimate->matrix.band + lag_index(estimate->matrix.start[i]);
    for (size_t j = reach; j <= i; ++j) {
        line[j - reach] = counted[i] != 0.0 && counted[j] != 0.0 ? sums[j] : i == j ? 1.0 : 0.0;
    }
}

/* The products of rows a with rows b, made symmetric, less this part of those of b. */
static void multiply(const lag_rank_estimate *estimate, const double *a, const double *b, double part)
{
    const size_t m = estimate->m;
    double *sums = estimate->columns.products, *others = sums + m, *of_b = others + m, *counted = of_b + m;
    for (size_t i = 0; i < m; ++i) {
        counted[i] = (double)counts(estimate, lag_index(estimate->order[i]));
        take_products(estimate, i, a, b, sums, others, of_b);
        for (size_t j = lag_index(estimate->reach[i]); j <= i; ++j) {
            sums[j] = 0.5 * (sums[j] + others[j]) - part * of_b[j];
        }
        put_line(estimate, i, sums, counted);
    }
}

/* Products of rows a. */
static void square(const lag_rank_estimate *estimate, const double *a)
{
    const size_t m = estimate->m;
    double *sums = estimate->columns.products, *counted = sums + m;
    for (size_t i = 0; i < m; ++i) {
        counted[i] = (double)counts(estimate, lag_index(estimate->order[i]));
        take_squares(estimate, i, a, sums);
        put_line(estimate, i, sums, counted);
    }
}

static void scale(lag_rank_estimate *estimate, const double *jacobian)
{
    const size_t n = estimate->n;
    for (size_t i = 0; i < estimate->m; ++i) {
        for (size_t k = lag_index(estimate->first[i]); k < lag_index(estimate->first[i + 1]); ++k) {
            const size_t j = lag_index(estimate->column[k]);
            estimate->now[k] = jacobian[i * n + j] * estimate->sizes[j] / estimate->row_sizes[i];
        }
    }
}

/* True if J is that of the last state. */
static int has_stayed(const lag_rank_estimate *estimate)
{
    return lag_same(lag_entries_count(estimate->model), estimate->now, estimate->rows);
}

int lag_rank_estimate_has_turned(lag_rank_estimate *estimate, const double *jacobian)
{
    scale(estimate, jacobian);
    multiply(estimate, estimate->now, estimate->rows, LEFT);
    return !(least_pivot(estimate, 0) > 0.0);
}

double lag_rank_estimate_margin(lag_rank_estimate *estimate, const double *jacobian)
{
    double *follows = estimate->follows;
    scale(estimate, jacobian);
    estimate->follows = estimate->trial;
    lag_fill(estimate->m, 0.0, estimate->follows);
    square(estimate, estimate->now);
    const double least = least_pivot(estimate, redundant_rows(estimate));
    estimate->follows = follows;
    return sqrt(least);
}

/*
 * A number below the least singular value of the triangle in the band: 1 / sqrt of the largest sums of rows and columns of the inverse of its
 * comparison matrix.
 */
static double least_value(lag_rank_estimate *estimate)
{
    double *of_row = estimate->columns.products + 2 * estimate->m, *of_column = of_row + estimate->m;
    double rows = 0.0;
    double columns = 0.0;
    lag_fill(estimate->m, 1.0, of_column);
    for (size_t i = 0; i < estimate->m; ++i) {
        const size_t reach = lag_index(estimate->reach[i]);
        const double *line = estimate->matrix.band + lag_index(estimate->matrix.start[i]);
        double sum = 1.0;
        for (size_t j = reach; j < i; ++j) {
            sum += fabs(line[j - reach]) * of_row[j];
        }
        of_row[i] = sum / line[i - reach];
        rows = fmax(rows, of_row[i]);
    }
    for (size_t i = estimate->m; i-- > 0;) {
        const size_t reach = lag_index(estimate->reach[i]);
        const double *line = estimate->matrix.band + lag_index(estimate->matrix.start[i]);
        of_column[i] /= line[i - reach];
        columns = fmax(columns, of_column[i]);
        for (size_t j = reach; j < i; ++j) {
            of_column[j] += fabs(line[j - reach]) * of_column[i];
        }
    }
    return 1.0 / sqrt(rows * columns);
}

/* Length of the difference of J and x, in the rows that count. */
static double distance(const lag_rank_estimate *estimate, const double *x)
{
    double sum = 0.0;
    for (size_t i = 0; i < estimate->m; ++i) {
        const size_t end = counts(estimate, i) ? lag_rank_end_of(estimate, i) : 0;
        for (size_t k = lag_index(estimate->first[i]); k < end; ++k) {
            const double by = estimate->now[k] - x[k];
            sum += by * by;
        }
    }
    return sqrt(sum);
}

/*
 * True if J is so near to where its pivots are known that they are above LAG_RANK_NEAR, and that it cannot have turned on the way from the last
 * state. With s the least singular value there and J moved by d from there, x J is at least (1 - d / s) as long as it was, for all x.
 * Twice as much as LEFT remains: round-off does not decide.
 */
static int is_near_known(lag_rank_estimate *estimate)
{
    if (!(estimate->known.least > 0.0)) {
        return 0;
    }
    const double moved = distance(estimate, estimate->known.rows);
    const double step = distance(estimate, estimate->rows);
    const double margin = (1.0 - moved / estimate->known.least) * estimate->known.margin;
    if (!(margin > LAG_RANK_NEAR && step <= (1.0 - 2.0 * LEFT) * (estimate->known.least - moved - step))) {
        return 0;
    }
    estimate->margin = margin;
    return 1;
}

lag_status lag_rank_estimate_update(lag_rank_estimate *estimate, const double *jacobian)
{
    const size_t entries = lag_entries_count(estimate->model);
    scale(estimate, jacobian);
    if (estimate->rank > 0 && estimate->margin > LAG_RANK_NEAR && has_stayed(estimate)) { /* Kirchhoff's laws have constants only */
        return LAG_OK;
    }
    if (estimate->rank > 0 && is_near_known(estimate)) {
        memcpy(estimate->rows, estimate->now, entries * sizeof(double));
        return LAG_OK;
    }
    if (estimate->rank > 0 && lag_rank_estimate_has_turned(estimate, jacobian)) {
        return LAG_ATTENTION;
    }
    estimate->margin = lag_rank_estimate_margin(estimate, jacobian);
    estimate->rank = estimate->most;
    memcpy(estimate->rows, estimate->now, entries * sizeof(double));
    memcpy(estimate->follows, estimate->trial, estimate->m * sizeof(double));
    estimate->known.margin = estimate->margin;
    estimate->known.least = estimate->margin > LAG_RANK_NEAR && !lag_any(estimate->m, estimate->follows) ? least_value(estimate) : 0.0;
    memcpy(estimate->known.rows, estimate->now, entries * sizeof(double));
    return estimate->margin > LAG_RANK_NEAR ? LAG_OK : LAG_ATTENTION;
}
