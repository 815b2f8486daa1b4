#include "check.h"
#include "lag/initial/nearest_configuration.h"

/*
 * Two problems whose rows and unknowns alternate: x1 x3 = 2 and x1 + x3 = 3, with the solutions (1, 2) and (2, 1), and x0 + 2 x2 = 5,
 * of which (1, 2) is nearest to the origin.
 */
enum { ROWS = 3, UNKNOWNS = 4 };

static void dense(const double *x, double *residual, double *jacobian)
{
    const double entries[ROWS * UNKNOWNS] = {0.0, x[3], 0.0, x[1], 1.0, 0.0, 2.0, 0.0, 0.0, 1.0, 0.0, 1.0};
    residual[0] = x[1] * x[3] - 2.0;
    residual[1] = x[0] + 2.0 * x[2] - 5.0;
    residual[2] = x[1] + x[3] - 3.0;
    for (size_t k = 0; k < ROWS * UNKNOWNS; ++k) {
        jacobian[k] = entries[k];
    }
}

static void evaluate(void *context, const lag_parts *parts, const double *x, double *residual, double *jacobian)
{
    double whole[ROWS * UNKNOWNS];
    (void)context;
    dense(x, residual, whole);
    for (size_t which = 0; which < parts->count; ++which) {
        CHECK(lag_parts_gather(parts, which, UNKNOWNS, whole, lag_parts_block(parts, which, jacobian)));
    }
}

static lag_parts parts_of(double *memory)
{
    const double pattern[ROWS * UNKNOWNS] = {0.0, 1.0, 0.0, 1.0, 1.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 1.0};
    return lag_parts_of(ROWS, UNKNOWNS, pattern, memory);
}

static double *doubles(size_t count)
{
    double *found = calloc(count, sizeof(double));
    CHECK(found != NULL);
    return found;
}

static void blocks_are_packed_in_the_order_of_the_parts(void)
{
    double *memory = doubles(lag_parts_memory(ROWS, UNKNOWNS));
    const lag_parts parts = parts_of(memory);
    const double x[UNKNOWNS] = {5.0, 7.0, 11.0, 13.0};
    const double expected[] = {13.0, 7.0, 1.0, 1.0, 1.0, 2.0};
    double residual[ROWS];
    double jacobian[sizeof expected / sizeof *expected];
    CHECK(parts.count == 2 && lag_parts_entries(&parts) == sizeof expected / sizeof *expected);
    evaluate(NULL, &parts, x, residual, jacobian);
    for (size_t k = 0; k < lag_parts_entries(&parts); ++k) {
        CHECK_NEAR(jacobian[k], expected[k], 0.0);
    }
    free(memory);
}

static void each_part_has_its_nearest_solution(void)
{
    double *room = doubles(lag_parts_memory(ROWS, UNKNOWNS));
    double *memory = doubles(lag_nearest_configuration_memory(ROWS, UNKNOWNS));
    double *guesses = doubles(LAG_NEAREST_GUESSES * UNKNOWNS);
    const lag_parts parts = parts_of(room);
    const lag_equations equations = {evaluate, NULL};
    lag_nearest_configuration nearest;
    unsigned long long seed = 7;
    for (size_t k = 0; k < LAG_NEAREST_GUESSES * UNKNOWNS; ++k) {
        guesses[k] = 3.0 * draw(&seed);
    }
    lag_nearest_configuration_place(&nearest, &parts, memory);
    CHECK(lag_nearest_configuration_search(&nearest, &equations, guesses, 1e-10) <= 1e-10);
    const double *x = nearest.best.point;
    CHECK_NEAR(x[0], 1.0, 1e-10);
    CHECK_NEAR(x[2], 2.0, 1e-10);
    CHECK_NEAR(fmax(x[1], x[3]), 2.0, 1e-10);
    CHECK_NEAR(fmin(x[1], x[3]), 1.0, 1e-10);
    free(guesses);
    free(memory);
    free(room);
}

int main(void)
{
    blocks_are_packed_in_the_order_of_the_parts();
    each_part_has_its_nearest_solution();
    (void)printf("parts: ok\n");
    return EXIT_SUCCESS;
}
