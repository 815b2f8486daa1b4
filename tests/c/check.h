/* Checks of the C tests: the first failure ends the program with its place. */
#ifndef CHECK_H
#define CHECK_H

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#define CHECK(condition)                                                                      \
    do {                                                                                      \
        if (!(condition)) {                                                                   \
            (void)fprintf(stderr, "%s:%d: not true: %s\n", __FILE__, __LINE__, #condition);   \
            exit(EXIT_FAILURE);                                                               \
        }                                                                                     \
    } while (0)

#define CHECK_NEAR(x, y, tolerance)                                                                          \
    do {                                                                                                     \
        const double check_x = (x);                                                                          \
        const double check_y = (y);                                                                          \
        if (!(fabs(check_x - check_y) <= (tolerance))) {                                                     \
            (void)fprintf(stderr, "%s:%d: %.17g is not near %.17g\n", __FILE__, __LINE__, check_x, check_y); \
            exit(EXIT_FAILURE);                                                                              \
        }                                                                                                    \
    } while (0)

/* Numbers between -1 and 1, the same in every run. */
static inline double draw(unsigned long long *seed)
{
    *seed = *seed * 6364136223846793005ULL + 1442695040888963407ULL;
    return (double)(*seed >> 11) / 4503599627370496.0 - 1.0;
}

#endif
