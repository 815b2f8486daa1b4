#include "lag/methods/stiffness.h"

#include <math.h>
#include <string.h>

/* The stability region of DOP853 reaches to about -6 on the real axis; accuracy keeps h |lambda| near 1. */
static const double BORDER = 3.5;
/* Below this the explicit method could do steps as long as those of the implicit one. */
static const double EASY = 2.0;
enum { SIGNS = 15, PAUSE = 100, EVERY = 10, BACK = 2, ITERATIONS = 24 };

size_t lag_stiffness_memory(size_t size)
{
    return size * size + 3 * size;
}

void lag_stiffness_place(lag_stiffness *stiffness, size_t size, double *memory)
{
    *stiffness = (lag_stiffness){0, 0, BACK, memory, memory + size * size};
}

/*
 * Rows one after the other, each as the number of its entries that are not zero, their columns, and the entries, in the place of the matrix.
 * Returns 0, and leaves it as it is, where a row would take more than n doubles. `row` (n).
 */
static int pack(size_t n, double *matrix, double *row)
{
    double *to = matrix;
    for (size_t i = 0; i < n; ++i) {
        size_t count = 0;
        for (size_t j = 0; j < n; ++j) {
            count += matrix[i * n + j] != 0.0;
        }
        if (2 * count + 1 > n) {
            return 0;
        }
    }
    for (size_t i = 0; i < n; ++i) {
        size_t count = 0;
        memcpy(row, matrix + i * n, n * sizeof(double));
        for (size_t j = 0; j < n; ++j) {
            if (row[j] != 0.0) {
                to[1 + 2 * count] = (double)j;
                to[2 + 2 * count++] = row[j];
            }
        }
        to[0] = (double)count;
        to += 1 + 2 * count;
    }
    return 1;
}

/* out = matrix in */
static void multiply(size_t n, int packed, const double *matrix, const double *in, double *out)
{
    for (size_t i = 0; i < n; ++i) {
        double sum = 0.0;
        const size_t count = packed ? (size_t)matrix[0] : n;
        for (size_t k = 0; k < count; ++k) {
            sum += packed ? matrix[2 + 2 * k] * in[(size_t)matrix[1 + 2 * k]] : matrix[k] * in[k];
        }
        matrix += packed ? 1 + 2 * count : n;
        out[i] = sum;
    }
}

static double inner(const lag_stepper *s, const double *a, const double *b)
{
    double sum = 0.0;
    for (size_t i = 0; i < s->ode->size; ++i) {
        sum += a[i] / s->tolerance[i] * (b[i] / s->tolerance[i]);
    }
    return sum;
}

double lag_stiffness_fastest(const lag_stiffness *stiffness, const lag_stepper *s, int *decays)
{
    const size_t n = s->ode->size;
    double *v0 = stiffness->v;
    double *v1 = v0 + n;
    double *v2 = v1 + n;
    const int packed = pack(n, stiffness->matrix, v0);
    *decays = 0;
    for (size_t i = 0; i < n; ++i) {
        v0[i] = s->tolerance[i] * (1.0 + 0.618 * (double)(i % 5)) * (i % 2 == 0 ? 1.0 : -1.0);
    }
    for (int k = 0; k < ITERATIONS; ++k) {
        multiply(n, packed, stiffness->matrix, v0, v1);
        const double length = sqrt(inner(s, v1, v1));
        if (!(length > 0.0) || !isfinite(length)) {
            return 0.0;
        }
        for (size_t i = 0; i < n; ++i) {
            v0[i] = v1[i] / length;
        }
    }
    multiply(n, packed, stiffness->matrix, v0, v1);
    multiply(n, packed, stiffness->matrix, v1, v2);
    /* lambda^2 = a lambda + b, in least squares on v2 = a v1 + b v0: one real eigenvalue or a pair */
    const double g11 = inner(s, v1, v1);
    const double g10 = inner(s, v1, v0);
    const double g00 = inner(s, v0, v0);
    const double determinant = g11 * g00 - g10 * g10;
    const double along = g10 / g00;
    if (!(determinant > 1e-12 * g11 * g00)) {
        *decays = along < 0.0;
        return fabs(along);
    }
    const double a = (inner(s, v2, v1) * g00 - inner(s, v2, v0) * g10) / determinant;
    const double b = (inner(s, v2, v0) * g11 - inner(s, v2, v1) * g10) / determinant;
    const double discriminant = 0.25 * a * a + b;
    if (discriminant < 0.0) {
        *decays = -0.5 * a > 0.05 * sqrt(-b);
        return sqrt(-b);
    }
    const double value = 0.5 * a + (a < 0.0 ? -1.0 : 1.0) * sqrt(discriminant);
    *decays = value < 0.0;
    return fabs(value);
}

/* h |lambda| of the exact Jacobian at the present state; 0 where it is not to be had. */
static double exact_urge(lag_stiffness *stiffness, lag_stepper *s, double h, int *decays)
{
    ++s->counts.jacobians;
    *decays = 0;
    if (s->ode->jacobian(s->ode->context, s->t, s->x, stiffness->matrix) != LAG_OK) {
        return 0.0;
    }
    return h * lag_stiffness_fastest(stiffness, s, decays);
}

const lag_method *lag_stiffness_method(lag_stiffness *stiffness, lag_stepper *s)
{
    const double h = s->t - s->t_before;
    int decays = 0;
    if (stiffness->wait > 0) {
        --stiffness->wait;
        return s->method;
    }
    if (!s->method->implicit) {
        stiffness->signs = s->last.urge > BORDER ? stiffness->signs + 1 : 0;
        if (stiffness->signs < SIGNS) {
            return s->method;
        }
        const int stiff = exact_urge(stiffness, s, h, &decays) > BORDER && decays;
        stiffness->signs = 0;
        stiffness->wait = stiff ? EVERY : PAUSE;
        return stiff ? &lag_radau : s->method;
    }
    stiffness->wait = EVERY;
    stiffness->signs = exact_urge(stiffness, s, fmin(s->h, h), &decays) < EASY ? stiffness->signs + 1 : 0;
    if (stiffness->signs < stiffness->needed) {
        return s->method;
    }
    stiffness->signs = 0;
    stiffness->wait = 0;
    stiffness->needed *= 2;
    return &lag_dop853;
}
