#include <string.h>

#include "check.h"
#include "lag/trigonometry.h"

/* The C library's own error is below one unit in the last place as well. */
static void near_library(double x)
{
    double s;
    double c;
    lag_sincos(x, &s, &c);
    CHECK_NEAR(s, sin(x), 2.5e-16 * fabs(sin(x)));
    CHECK_NEAR(c, cos(x), 2.5e-16 * fabs(cos(x)));
}

static void test_values(void)
{
    unsigned long long seed = 1;
    for (int i = 0; i < 200000; ++i) {
        near_library(draw(&seed));
        near_library(10.0 * draw(&seed));
        near_library(1e5 * draw(&seed));
        near_library(1e9 * draw(&seed));
    }
    for (int k = -60000; k <= 60000; ++k) { /* where one of them nearly vanishes */
        near_library(k * 1.57079632679489661923);
        near_library(k * 0.78539816339744830962);
    }
    near_library(1e-300);
    near_library(5e-324);
    near_library(LAG_SINCOS_LARGEST);
}

static void test_signs_and_what_is_no_number(void)
{
    double s;
    double c;
    lag_sincos(-0.0, &s, &c);
    CHECK(s == 0.0 && c == 1.0);
    lag_sincos(0.0, &s, &c);
    CHECK(s == 0.0 && !signbit(s) && c == 1.0);
    lag_sincos((double)INFINITY, &s, &c);
    CHECK(isnan(s) && isnan(c));
    lag_sincos((double)NAN, &s, &c);
    CHECK(isnan(s) && isnan(c));
}

static void test_many_are_the_single_ones(void)
{
    enum { MOST = 37 };
    unsigned long long seed = 2;
    double x[MOST];
    for (size_t i = 0; i < MOST; ++i) {
        x[i] = (i % 5 == 0 ? 1e6 : 30.0) * draw(&seed);
    }
    for (size_t count = 0; count <= MOST; ++count) {
        double *s = malloc((count + 1) * sizeof(double)); /* exactly as large: the sanitizer sees one step beyond */
        double *c = malloc((count + 1) * sizeof(double));
        CHECK(s != NULL && c != NULL);
        lag_sincos_many(count, x, s, c);
        for (size_t i = 0; i < count; ++i) {
            double sine;
            double cosine;
            lag_sincos(x[i], &sine, &cosine);
            CHECK(memcmp(&sine, s + i, sizeof sine) == 0 && memcmp(&cosine, c + i, sizeof cosine) == 0);
        }
        free(s);
        free(c);
    }
}

int main(void)
{
    test_values();
    test_signs_and_what_is_no_number();
    test_many_are_the_single_ones();
    (void)puts("trigonometry: ok");
    return EXIT_SUCCESS;
}
