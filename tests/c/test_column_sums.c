/* Sums over columns in lanes, and their equations of stages: all widths of registers give the same bits. */
#include <string.h>

#include "check.h"
#include "lag/methods/step_control.h"
#include "lag/sensitivities/column_sums.h"

enum { HEIGHT = 7, WIDTH = 5, APART = 6, MOST = 8, BLOCKS = 2, NQ = 2, SIZE = 5, EQUATIONS = 4, NP = 3 };

/* 1: the processor has registers of so many doubles. */
static int has(size_t width)
{
#if LAG_ATTEMPTS_WIDE
    return width == 2 || (width == 4 && __builtin_cpu_supports("avx")) || (width == 8 && __builtin_cpu_supports("avx512f"));
#else
    return width == 2;
#endif
}

static void draw_all(unsigned long long *seed, size_t count, double *to)
{
    for (size_t i = 0; i < count; ++i) {
        to[i] = draw(seed);
    }
}

static void multiply_plainly(const lag_rows_of_columns *m, size_t lanes, const double *of, const double *base, double *to)
{
    for (size_t i = 0; i < m->height; ++i) {
        for (size_t k = 0; k < lanes; ++k) {
            double sum = base != NULL ? base[i * lanes + k] : 0.0;
            for (size_t j = 0; j < m->width; ++j) {
                sum += m->first[i * m->apart + j] * of[j * lanes + k];
            }
            to[i * lanes + k] = sum;
        }
    }
}

static void test_products(size_t width, size_t lanes)
{
    unsigned long long seed = 1 + width + lanes;
    double matrix[HEIGHT * APART];
    double of[WIDTH * MOST];
    double base[HEIGHT * MOST];
    double plain[HEIGHT * MOST];
    double found[HEIGHT * MOST];
    draw_all(&seed, HEIGHT * APART, matrix);
    draw_all(&seed, WIDTH * MOST, of);
    draw_all(&seed, HEIGHT * MOST, base);
    for (size_t height = 1; height <= HEIGHT; ++height) {
        const lag_rows_of_columns m = {height, WIDTH, APART, matrix};
        for (int based = 0; based < 2; ++based) {
            multiply_plainly(&m, lanes, of, based ? base : NULL, plain);
            lag_column_sums_of(width)->multiply(&m, lanes, of, based ? base : NULL, found);
            CHECK(memcmp(plain, found, height * lanes * sizeof(double)) == 0);
        }
    }
}

/* Rates of column k of a block by plain loops, along dp of several entries: d' = response (by_state d + by_input du + by_parameter dp). */
static void test_rates(size_t width, size_t lanes)
{
    unsigned long long seed = 7 + width + lanes;
    double by[EQUATIONS * (SIZE + 1)];
    double by_parameter[EQUATIONS * NP];
    double response[(SIZE - NQ) * EQUATIONS];
    double state[SIZE * MOST];
    double inputs[MOST];
    double along[EQUATIONS * MOST];
    double sum[EQUATIONS * MOST];
    double rates[SIZE * MOST];
    size_t lead[BLOCKS * MOST];
    double lead_part[BLOCKS * MOST];
    size_t first[BLOCKS + 1] = {0, 0, 1};
    size_t number[1] = {2};
    size_t lane[1] = {0};
    double part[1] = {-0.5};
    const lag_parameter_entries entries = {lanes, lead, lead_part, first, number, lane, part};
    const lag_motion_product motion = {NQ, NP, SIZE, {EQUATIONS, SIZE, SIZE + 1, by}, {EQUATIONS, 1, SIZE + 1, by + SIZE},
        {SIZE - NQ, EQUATIONS, EQUATIONS, response}, by_parameter, along, sum};
    draw_all(&seed, EQUATIONS * (SIZE + 1), by);
    draw_all(&seed, EQUATIONS * NP, by_parameter);
    draw_all(&seed, (SIZE - NQ) * EQUATIONS, response);
    draw_all(&seed, SIZE * MOST, state);
    draw_all(&seed, MOST, inputs);
    draw_all(&seed, BLOCKS * MOST, lead_part);
    for (size_t i = 0; i < BLOCKS * MOST; ++i) {
        lead[i] = i % 2;
    }
    lag_column_sums_of(width)->rates(&motion, &entries, 1, lanes, state, inputs, rates);
    for (size_t k = 0; k < lanes; ++k) {
        for (size_t i = 0; i < NQ; ++i) {
            CHECK(rates[i * lanes + k] == state[(NQ + i) * lanes + k]);
        }
        for (size_t i = NQ; i < SIZE; ++i) {
            double exact = 0.0;
            for (size_t e = 0; e < EQUATIONS; ++e) {
                double f = lead_part[lanes + k] * by_parameter[e * NP + lead[lanes + k]] + (k == 0 ? part[0] * by_parameter[e * NP + 2] : 0.0);
                for (size_t j = 0; j < SIZE; ++j) {
                    f += by[e * (SIZE + 1) + j] * state[j * lanes + k];
                }
                f += by[e * (SIZE + 1) + SIZE] * inputs[k];
                exact += response[(i - NQ) * EQUATIONS + e] * f;
            }
            CHECK(fabs(rates[i * lanes + k] - exact) <= 1e-13);
        }
    }
}

/* Dense output: bits of the narrowest registers. */
static void test_dense(size_t width, size_t lanes)
{
    unsigned long long seed = 3 + width + lanes;
    double terms[LAG_DOP853_TERMS * SIZE * MOST], x[SIZE * MOST];
    double found[SIZE * MOST], plain[SIZE * MOST];
    const size_t count = SIZE * lanes;
    draw_all(&seed, LAG_DOP853_TERMS * SIZE * MOST, terms);
    draw_all(&seed, SIZE * MOST, x);
    lag_column_sums_of(0)->interpolate(count, terms, 0.3, x, plain);
    lag_column_sums_of(width)->interpolate(count, terms, 0.3, x, found);
    CHECK(memcmp(plain, found, count * sizeof(double)) == 0);
    lag_column_sums_of(width)->interpolate(count, terms, 1.0, x, found);
    for (size_t i = 0; i < count; ++i) {
        CHECK_NEAR(found[i], x[i] + terms[i], 1e-15);
    }
}

/* The largest error: that of each column by sizes of its own, (2.10.17) of Hairer, Norsett and Wanner; of the narrowest registers the same bits. */
static void test_error(size_t width, size_t lanes)
{
    unsigned long long seed = 5 + width + lanes;
    double slopes[LAG_DOP853_SLOPES * SIZE * MOST], x[SIZE * MOST], behind[SIZE * MOST], of_state[SIZE], extent[MOST], tolerance[SIZE * MOST];
    lag_attempt_arrays at = {.size = SIZE, .lanes = lanes, .x = x, .x_new = behind, .slope = slopes};
    double error[MOST], most = 0.0;
    draw_all(&seed, LAG_DOP853_SLOPES * SIZE * MOST, slopes);
    draw_all(&seed, SIZE * MOST, x);
    draw_all(&seed, SIZE * MOST, behind);
    for (size_t i = 0; i < MOST; ++i) {
        extent[i] = 100.0 * (double)i; /* some are larger than 1e-5 of the columns by of_state */
        of_state[i % SIZE] = 1e-8 * (double)(1 + i);
        at.h[i] = 0.3;
    }
    for (size_t k = 0; k < lanes; ++k) {
        double before = 0.0, after = 0.0;
        for (size_t i = 0; i < SIZE; ++i) {
            before += pow(x[i * lanes + k] / of_state[i], 2.0);
            after += pow(behind[i * lanes + k] / of_state[i], 2.0);
        }
        for (size_t i = 0; i < SIZE; ++i) {
            tolerance[i * lanes + k] = fmax(extent[k], 1e-5 * sqrt(fmax(before, after) / SIZE)) * of_state[i];
        }
    }
    at.tolerance = tolerance;
    lag_attempt_errors(&at, error);
    for (size_t k = 0; k < lanes; ++k) {
        most = fmax(most, error[k]);
    }
    const double found = lag_column_sums_of(width)->error(&at, of_state, 1e-5, extent);
    CHECK_NEAR(found, most, 1e-13 * most);
    CHECK(found == lag_column_sums_of(0)->error(&at, of_state, 1e-5, extent));
    slopes[0] = (double)NAN;
    CHECK(lag_column_sums_of(width)->error(&at, of_state, 1e-5, extent) == (double)INFINITY);
}

enum { STAGES = LAG_RADAU_STAGES, NZ = 1, M = NQ + NZ, N = NQ + M, ROWS = STAGES * M };

/* h times f (stages, N, lanes) and the Jacobian times z, at stage i in lane k: of coordinates the rates, of the others by the rows of the Jacobian. */
static double slope_of(const lag_stage_equations *e, size_t lanes, const double *f, const double *z, size_t i, size_t row, size_t k)
{
    double sum = f[(i * N + row) * lanes + k] + (row < NQ ? z[(i * N + NQ + row) * lanes + k] : 0.0);
    for (size_t j = 0; j < N && row >= NQ; ++j) {
        sum += e->jacobian[(i * M + row - NQ) * e->width + j] * z[(i * N + j) * lanes + k];
    }
    return e->h * sum;
}

/* The stages solve z = h A (J z + f), with a Jacobian of its own at each of them; all widths agree to the bit. */
static void test_stages(size_t width, size_t lanes, const lag_radau_table *table)
{
    unsigned long long seed = 11 + table->stages + lanes;
    double jacobian[ROWS * (N + 1)], f[STAGES * N * MOST], z[STAGES * N * MOST], plain[STAGES * N * MOST];
    double matrix[(ROWS + 1) * (ROWS + MOST)], pivots[ROWS], coordinates[STAGES * NQ * MOST], right[ROWS * MOST];
    const lag_stage_equations e = {table, NQ, N, 0.3, jacobian, N + 1, matrix, pivots, coordinates, right};
    draw_all(&seed, ROWS * (N + 1), jacobian);
    draw_all(&seed, STAGES * N * MOST, f);
    for (size_t i = 0; i < ROWS; i += M) { /* stiff */
        jacobian[i * (N + 1)] -= 1e4;
    }
    memcpy(plain, f, sizeof f);
    CHECK(lag_column_sums_of(0)->decompose(&e));
    lag_column_sums_of(0)->collocate(&e, lanes, plain);
    memcpy(z, f, sizeof f);
    CHECK(lag_column_sums_of(width)->decompose(&e));
    lag_column_sums_of(width)->collocate(&e, lanes, z);
    CHECK(memcmp(z, plain, table->stages * N * lanes * sizeof(double)) == 0);
    for (size_t i = 0; i < table->stages; ++i) {
        for (size_t row = 0; row < N; ++row) {
            for (size_t k = 0; k < lanes; ++k) {
                double left = z[(i * N + row) * lanes + k];
                for (size_t j = 0; j < table->stages; ++j) {
                    left -= table->matrix[i][j] * slope_of(&e, lanes, f, z, j, row, k);
                }
                CHECK_NEAR(left, 0.0, 1e-12);
            }
        }
    }
    jacobian[0] = (double)NAN;
    CHECK(!lag_column_sums_of(width)->decompose(&e));
}

int main(void)
{
    for (size_t width = 2; width <= MOST; width *= 2) {
        for (size_t lanes = 1; lanes <= MOST && has(width); lanes *= 2) {
            test_products(width, lanes);
            test_rates(width, lanes);
            test_dense(width, lanes);
            test_error(width, lanes);
            for (size_t i = 0; i < LAG_RADAU_TABLES; ++i) {
                test_stages(width, lanes, &lag_radau_tables[i]);
            }
        }
    }
    (void)puts("column_sums: ok");
    return 0;
}
