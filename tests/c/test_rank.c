/* A estimate at ranks: rows of a chain, each sharing a coordinate with the next one. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "lag/equations/rank.h"

enum { ROWS = 60, COLUMNS = ROWS + 1, ENTRIES = 2 * ROWS };

static size_t row[ENTRIES], column[ENTRIES], first[ROWS + 1];
static const lag_pattern PATTERN = {ROWS, COLUMNS, ENTRIES, row, column, first};
static const lag_patterns PATTERNS = {.jacobian = &PATTERN};
static double sizes[COLUMNS], row_sizes[ROWS], lasting[ROWS];

static lag_model model_of(const lag_patterns *patterns, size_t rank)
{
    return (lag_model){.version = LAG_MODEL_VERSION, .size = sizeof(lag_model), .nq = COLUMNS, .nc = ROWS, .rank = rank, .patterns = patterns};
}

/* Row i holds i and i + 1, by 0.8 and 0.6. */
static void chain(double *jacobian)
{
    memset(jacobian, 0, ROWS * COLUMNS * sizeof(double));
    for (size_t i = 0; i < ROWS; ++i) {
        jacobian[i * COLUMNS + i] = 0.8;
        jacobian[i * COLUMNS + i + 1] = 0.6;
    }
}

static lag_rank_estimate place(const lag_model *model, double **memory)
{
    lag_rank_estimate estimate;
    *memory = malloc(lag_rank_estimate_memory(model) * sizeof(double));
    CHECK(*memory != NULL);
    lag_rank_estimate_place(&estimate, model, sizes, row_sizes, *memory);
    estimate.lasting = lasting;
    return estimate;
}

static void turns_and_losses_are_seen(const lag_patterns *patterns)
{
    const lag_model model = model_of(patterns, ROWS);
    static double jacobian[ROWS * COLUMNS];
    double *memory = NULL;
    lag_rank_estimate estimate = place(&model, &memory);
    chain(jacobian);
    CHECK(lag_rank_estimate_update(&estimate, jacobian) == LAG_OK);
    jacobian[30 * COLUMNS + 30] = 0.7; /* a little */
    CHECK(lag_rank_estimate_update(&estimate, jacobian) == LAG_OK);
    jacobian[30 * COLUMNS + 30] = jacobian[30 * COLUMNS + 31] = -0.7; /* all around */
    CHECK(lag_rank_estimate_has_turned(&estimate, jacobian));
    CHECK(lag_rank_estimate_update(&estimate, jacobian) == LAG_ATTENTION);
    chain(jacobian);
    CHECK(!lag_rank_estimate_has_turned(&estimate, jacobian));
    CHECK(lag_rank_estimate_update(&estimate, jacobian) == LAG_OK);
    estimate.rank = 0; /* nothing to compare with */
    for (size_t j = 0; j < COLUMNS; ++j) {
        jacobian[12 * COLUMNS + j] *= 0.5;
    }
    CHECK(lag_rank_estimate_update(&estimate, jacobian) == LAG_OK);
    estimate.rank = 0;
    for (size_t j = 0; j < COLUMNS; ++j) { /* hardly a row any more */
        jacobian[12 * COLUMNS + j] *= 0.1;
    }
    CHECK(lag_rank_estimate_update(&estimate, jacobian) == LAG_ATTENTION);
    CHECK(estimate.margin > 0.0 && estimate.margin < 0.05);
    memset(jacobian + 12 * COLUMNS, 0, COLUMNS * sizeof(double));
    CHECK(lag_rank_estimate_margin(&estimate, jacobian) == 0.0);
    free(memory);
}

/* One row less is independent than there are, and nobody says which. */
static void rows_that_follow_are_found(void)
{
    const lag_model model = model_of(NULL, ROWS - 1);
    static double jacobian[ROWS * COLUMNS];
    double *memory = NULL;
    lag_rank_estimate estimate = place(&model, &memory);
    chain(jacobian);
    memcpy(jacobian + 41 * COLUMNS, jacobian + 40 * COLUMNS, COLUMNS * sizeof(double));
    CHECK(lag_rank_estimate_update(&estimate, jacobian) == LAG_OK);
    CHECK(lag_rank_estimate_update(&estimate, jacobian) == LAG_OK);
    memcpy(jacobian + 11 * COLUMNS, jacobian + 10 * COLUMNS, COLUMNS * sizeof(double));
    CHECK(lag_rank_estimate_update(&estimate, jacobian) == LAG_ATTENTION);
    free(memory);
}

/* A row that comes and goes is not looked at. */
static void rows_that_go_are_left_out(void)
{
    const lag_model model = model_of(&PATTERNS, ROWS);
    static double jacobian[ROWS * COLUMNS];
    double *memory = NULL;
    lag_rank_estimate estimate = place(&model, &memory);
    lasting[7] = 0.0;
    chain(jacobian);
    CHECK(lag_rank_estimate_update(&estimate, jacobian) == LAG_OK);
    memset(jacobian + 7 * COLUMNS, 0, COLUMNS * sizeof(double));
    CHECK(lag_rank_estimate_update(&estimate, jacobian) == LAG_OK);
    lasting[7] = 1.0;
    free(memory);
}

/* Two rows turn towards each other in steps of this length, there and back: bounds say the same as pivots do, and margins are below them. */
static void bounds_have_the_verdict_of_pivots(const lag_patterns *patterns, double length)
{
    const lag_model model = model_of(patterns, ROWS);
    static double jacobian[ROWS * COLUMNS];
    double *memory = NULL, *other = NULL;
    lag_rank_estimate bounded = place(&model, &memory);
    lag_rank_estimate computed = place(&model, &other);
    size_t kept = 0;
    size_t lost = 0;
    chain(jacobian);
    for (int k = 0; k < (int)(2.0 / length); ++k) {
        const double part = 0.97 * sin(length * (double)k * 1.6); /* of the way to where both have one column only, the same */
        jacobian[30 * COLUMNS + 30] = cos(0.6435 + 0.9273 * part);
        jacobian[30 * COLUMNS + 31] = sin(0.6435 + 0.9273 * part);
        jacobian[31 * COLUMNS + 31] = cos(0.6435 - 0.6435 * part);
        jacobian[31 * COLUMNS + 32] = sin(0.6435 - 0.6435 * part);
        const double before = bounded.known.margin;
        computed.known.least = 0.0;
        const lag_status status = lag_rank_estimate_update(&computed, jacobian);
        CHECK(lag_rank_estimate_update(&bounded, jacobian) == status);
        CHECK(status != LAG_OK || bounded.margin <= computed.margin + 1e-12);
        kept += status == LAG_OK && k > 0 && bounded.known.margin == before && bounded.margin != computed.margin;
        lost += status != LAG_OK;
    }
    CHECK(kept > 0 && lost > 0);
    free(memory);
    free(other);
}

/* The least pivot of Cholesky's method on the products of these rows, in this order; the others do not count. */
static double least_pivot_of(size_t count, const size_t *which, const double *jacobian)
{
    static double matrix[ROWS][ROWS];
    double least = (double)INFINITY;
    for (size_t i = 0; i < count; ++i) {
        for (size_t j = 0; j <= i; ++j) {
            double sum = 0.0;
            for (size_t k = 0; k < COLUMNS; ++k) {
                sum += jacobian[which[i] * COLUMNS + k] * jacobian[which[j] * COLUMNS + k];
            }
            for (size_t k = 0; k < j; ++k) {
                sum -= matrix[i][k] * matrix[j][k];
            }
            matrix[i][j] = i == j ? sqrt(sum) : sum / matrix[j][j];
            least = i == j && sum < least ? sum : least;
        }
    }
    return least;
}

/* Two rows share columns with all others: they stand in a border beside the band, and pivots are those of the two at the top. */
static void dense_rows_stand_in_a_border(void)
{
    enum { MOST = 2 * ENTRIES };
    static size_t rows[MOST], columns[MOST], begin[ROWS + 1], which[ROWS];
    static double jacobian[ROWS * COLUMNS];
    size_t count = 0;
    chain(jacobian);
    for (size_t j = 0; j < COLUMNS; ++j) {
        jacobian[8 * COLUMNS + j] = j % 2 == 0 ? 0.18 : 0.0;
        jacobian[9 * COLUMNS + j] = j % 2 == 0 ? 0.0 : 0.02 * (double)(j % 9);
    }
    for (size_t i = 0; i < ROWS; ++i) {
        begin[i] = count;
        for (size_t j = 0; j < COLUMNS; ++j) {
            if (i == 8 || i == 9 || jacobian[i * COLUMNS + j] != 0.0) {
                rows[count] = i;
                columns[count++] = j;
            }
        }
        which[i] = i < 2 ? 8 + i : i < 10 ? i - 2 : i;
    }
    begin[ROWS] = count;
    const lag_pattern pattern = {ROWS, COLUMNS, count, rows, columns, begin};
    const lag_patterns patterns = {.jacobian = &pattern};
    const lag_model model = model_of(&patterns, ROWS);
    double *memory = NULL;
    lag_rank_estimate estimate = place(&model, &memory);
    CHECK(estimate.matrix.border == 2);
    CHECK(estimate.matrix.start[ROWS] < 4 * ROWS);
    const double margin = lag_rank_estimate_margin(&estimate, jacobian);
    CHECK(fabs(margin - sqrt(least_pivot_of(ROWS, which, jacobian))) < 1e-12);
    CHECK(lag_rank_estimate_update(&estimate, jacobian) == LAG_OK);
    CHECK(estimate.known.least > 0.0 && estimate.known.least <= margin);
    for (size_t j = 0; j < COLUMNS; ++j) { /* one of the two follows from the other */
        jacobian[9 * COLUMNS + j] = j % 2 == 0 ? -0.18 : 0.0;
    }
    estimate.most = ROWS - 1;
    which[1] = 8;
    CHECK(fabs(lag_rank_estimate_margin(&estimate, jacobian) - sqrt(least_pivot_of(ROWS - 1, which + 1, jacobian))) < 1e-12);
    CHECK(estimate.trial[9] + estimate.trial[8] == 1.0);
    estimate.most = ROWS;
    CHECK(lag_rank_estimate_margin(&estimate, jacobian) < 1e-6);
    free(memory);
}

int main(void)
{
    for (size_t i = 0; i < ROWS; ++i) {
        row[2 * i] = row[2 * i + 1] = i;
        first[i] = 2 * i;
        column[2 * i] = i;
        column[2 * i + 1] = i + 1;
        row_sizes[i] = lasting[i] = 1.0;
    }
    first[ROWS] = ENTRIES;
    for (size_t j = 0; j < COLUMNS; ++j) {
        sizes[j] = 1.0;
    }
    turns_and_losses_are_seen(&PATTERNS);
    turns_and_losses_are_seen(NULL);
    bounds_have_the_verdict_of_pivots(&PATTERNS, 1e-3);
    bounds_have_the_verdict_of_pivots(NULL, 3e-3);
    rows_that_follow_are_found();
    rows_that_go_are_left_out();
    dense_rows_stand_in_a_border();
    (void)printf("rank: ok\n");
    return 0;
}
