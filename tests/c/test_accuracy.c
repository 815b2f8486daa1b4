/* Groups, natural sizes and caps: by component and unit. */
#include "check.h"
#include "lag/methods/accuracy.h"

static void check_groups(const size_t *components, const double *expected, const double *sizes)
{
    static const lag_slot coordinates[] = {{"a", "m", 0}, {"b", "rad", 0}, {"c", "m", 0}, {"d", "m", 0}, {"e", "1", 0}};
    static const double start[] = {2.0, 7.0, -3.0, 1e9, 4.0};
    const lag_model model = {.nq = 5, .nz = 1, .coordinates = coordinates, .components = components};
    double group[11], natural[11], cap[11];
    lag_accuracy_groups(&model, start, group, natural, cap);
    for (size_t i = 0; i < 5; ++i) {
        const int angle = i == 1 || i == 4;
        CHECK(group[i] == expected[i] && group[5 + i] == 5.0 + expected[i]);
        CHECK(natural[i] == sizes[i] && natural[5 + i] == sizes[i]);
        CHECK(cap[i] == (angle ? 1.0 : (double)INFINITY) && isinf(cap[5 + i]));
    }
    CHECK(group[10] == 10.0 && natural[10] == 1.0 && isinf(cap[10]));
}

/* A number that nothing couples with the others leaves their tolerances as they are. */
static void test_tolerances(void)
{
    static const lag_slot coordinates[] = {{"a", "m", 0}, {"b", "m", 0}};
    static const size_t apart[] = {0, 1};
    static const double x[] = {0.5, 1e9, 0.25, 1e9};
    const lag_model model = {.nq = 2, .coordinates = coordinates, .components = apart};
    double group[4], natural[4], cap[4], largest[4] = {0}, tolerance[4];
    lag_accuracy_groups(&model, x, group, natural, cap);
    lag_accuracy accuracy = {4, group, natural, cap, largest, 1e-6};
    lag_accuracy_after(&accuracy, x, tolerance);
    CHECK_NEAR(tolerance[0], 0.5e-6, 1e-20);
    CHECK_NEAR(tolerance[1], 1e3, 1e-9);
    CHECK_NEAR(tolerance[2], 0.25e-6, 1e-20);
}

int main(void)
{
    static const size_t apart[] = {0, 0, 0, 1, 2, 0};
    static const double by_unit[] = {0, 1, 0, 0, 4};
    static const double by_both[] = {0, 1, 0, 3, 4};
    static const double sizes_by_unit[] = {1e9, 1, 1e9, 1e9, 1};
    static const double sizes_by_both[] = {3, 1, 3, 1e9, 1};
    check_groups(0, by_unit, sizes_by_unit);
    check_groups(apart, by_both, sizes_by_both);
    test_tolerances();
    return 0;
}
