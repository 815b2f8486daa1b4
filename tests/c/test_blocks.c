/* Tests equations/blocks.c (what neither M nor rows tie is a system of its own, and held rates give way to rows) and linalg/disjoint_sets.h. */
#include <string.h>

#include "check.h"
#include "lag/equations/blocks.h"
#include "lag/linalg/disjoint_sets.h"

enum { N = 5, M = 3, MEMORY = 1024 };

/* Coordinates 0 and 2 share M, 1 and 3 a row, which stands twice; 4 is alone. Row 2 is open. */
static const double MASS[N * N] = {2, 0, 1, 0, 0, 0, 3, 0, 0, 0, 1, 0, 4, 0, 0, 0, 0, 0, 5, 0, 0, 0, 0, 0, 7};
static const double ROWS[M * N] = {0, 1, 0, -1, 0, 0, 2, 0, -2, 0, 0, 0, 0, 0, 0};
static const unsigned char REDUNDANT[M] = {0, 1, 0};

static lag_status solve(const double *f, const double *residual, const double *held, double *change)
{
    const lag_model model = {.nq = N, .nc = M, .rank = 2, .nreset = 2, .redundant = REDUNDANT};
    double memory[MEMORY];
    CHECK(lag_blocks_memory(&model) <= MEMORY);
    lag_blocks blocks = lag_blocks_of(&model, MASS, ROWS, memory);
    lag_status status = LAG_OK;
    for (size_t which = 0; which < N; ++which) {
        if (lag_blocks_take(&blocks, which)) {
            const lag_status own = lag_blocks_solve(&blocks, f, residual, held, NULL);
            status = status == LAG_OK ? own : status;
            lag_blocks_scatter(&blocks, blocks.change, change);
        }
    }
    return status;
}

static void blocks_are_what_mass_and_rows_tie(void)
{
    static const size_t sizes[N] = {2, 2, 0, 0, 1};
    const lag_model model = {.nq = N, .nc = M};
    double memory[MEMORY];
    lag_blocks blocks = lag_blocks_of(&model, MASS, ROWS, memory);
    for (size_t which = 0; which < N; ++which) {
        CHECK(lag_blocks_take(&blocks, which) == (sizes[which] > 0) && blocks.n == sizes[which]);
    }
}

static void each_block_solves_its_own_rows(void)
{
    const double f[N] = {3, 8, 5, 8, 14};
    const double residual[M] = {0.5, 1.0, 0.0};
    double change[N];
    CHECK(solve(f, residual, NULL, change) == LAG_OK);
    CHECK_NEAR(change[0], 1.0, 1e-14);
    CHECK_NEAR(change[2], 1.0, 1e-14);
    CHECK_NEAR(change[1] - change[3], -0.5, 1e-14);
    CHECK_NEAR(3.0 * change[1] + 5.0 * change[3], 16.0, 1e-13); /* the row presses both against each other */
    CHECK_NEAR(change[4], 2.0, 1e-14);
}

static void what_is_held_stays_where_rows_permit_it(void)
{
    const double f[N] = {0};
    const double residual[M] = {1.0, 2.0, 0.0};
    const double one[N] = {0, 1, 0, 0, 0};
    const double both[N] = {0, 1, 0, 1, 0};
    double change[N];
    CHECK(solve(f, residual, one, change) == LAG_OK);
    CHECK_NEAR(change[1], 0.0, 1e-14);
    CHECK_NEAR(change[3], 1.0, 1e-14);
    CHECK(solve(f, residual, both, change) == LAG_OK); /* rows before what is held */
    CHECK_NEAR(change[1], -5.0 / 8.0, 1e-14);
    CHECK_NEAR(change[3], 3.0 / 8.0, 1e-14);
}

static void sets_join_and_are_told_by_their_least_number(void)
{
    const double row[N] = {0, 0, 1, 0, -1};
    double sets[N];
    lag_separate(N, sets);
    CHECK(lag_set_of(sets, 4) == 4);
    lag_join(sets, 4, 3);
    lag_join_entries(sets, N, row, 1);
    for (size_t i = 1; i < N; ++i) {
        CHECK(lag_set_of(sets, i) == 1);
    }
    CHECK(lag_set_of(sets, 0) == 0);
}

int main(void)
{
    blocks_are_what_mass_and_rows_tie();
    each_block_solves_its_own_rows();
    what_is_held_stays_where_rows_permit_it();
    sets_join_and_are_told_by_their_least_number();
    puts("blocks: ok");
    return EXIT_SUCCESS;
}
