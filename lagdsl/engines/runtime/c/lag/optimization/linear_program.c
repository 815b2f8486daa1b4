#include "lag/optimization/linear_program.h"

#include <string.h>

#include "lag/linalg/arena.h"
#include "lag/optimization/lemke.h"

size_t lag_linear_program_memory(size_t n, size_t m)
{
    const size_t all = n + m;
    return all * all + 2 * all + lag_lemke_memory(all);
}

int lag_linear_program(size_t n, size_t m, const double *a, const double *b, const double *c, double *x, double *memory)
{
    const size_t all = n + m; /* unknowns, and multipliers of the inequalities */
    double *matrix = lag_take(&memory, all * all);
    double *right = lag_take(&memory, all);
    double *z = lag_take(&memory, all);
    lag_fill(all * all, 0.0, matrix);
    for (size_t j = 0; j < n; ++j) {
        right[j] = -c[j];
        for (size_t i = 0; i < m; ++i) {
            matrix[j * all + n + i] = a[i * n + j];
            matrix[(n + i) * all + j] = -a[i * n + j];
        }
    }
    memcpy(right + n, b, m * sizeof(double));
    const int found = lag_lemke(all, matrix, right, z, memory);
    memcpy(x, z, n * sizeof(double));
    return found;
}
