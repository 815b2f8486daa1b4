#include "lag/linalg/fit_polynomial.h"

#include <math.h>

/* Not too near the start, where positions are hardly told apart from the singular one. */
static const double FIRST = 0.3;

double lag_fit_node(size_t i)
{
    return FIRST + (1.0 - FIRST) * (double)i / (double)(LAG_FIT_NODES - 1);
}

void lag_fit_interpolate(size_t count, size_t width, double *values)
{
    double powers[LAG_FIT_NODES][LAG_FIT_NODES];
    for (size_t i = 0; i < count; ++i) {
        powers[i][0] = 1.0;
        for (size_t k = 1; k < count; ++k) {
            powers[i][k] = powers[i][k - 1] * lag_fit_node(LAG_FIT_NODES - count + i);
        }
    }
    for (size_t k = 0; k < count; ++k) {
        size_t pivot = k;
        for (size_t i = k + 1; i < count; ++i) {
            pivot = fabs(powers[i][k]) > fabs(powers[pivot][k]) ? i : pivot;
        }
        for (size_t j = 0; j < count && pivot != k; ++j) {
            const double kept = powers[k][j];
            powers[k][j] = powers[pivot][j];
            powers[pivot][j] = kept;
        }
        for (size_t j = 0; j < width && pivot != k; ++j) {
            const double kept = values[k * width + j];
            values[k * width + j] = values[pivot * width + j];
            values[pivot * width + j] = kept;
        }
        for (size_t i = k + 1; i < count; ++i) {
            const double factor = powers[i][k] / powers[k][k];
            for (size_t j = k; j < count; ++j) {
                powers[i][j] -= factor * powers[k][j];
            }
            for (size_t j = 0; j < width; ++j) {
                values[i * width + j] -= factor * values[k * width + j];
            }
        }
    }
    for (size_t k = count; k-- > 0;) {
        for (size_t j = 0; j < width; ++j) {
            double value = values[k * width + j];
            for (size_t i = k + 1; i < count; ++i) {
                value -= powers[k][i] * values[i * width + j];
            }
            values[k * width + j] = value / powers[k][k];
        }
    }
}

void lag_fit_state_at(size_t n, size_t width, const double *coefficients, const double *start, double length, double part, double *x)
{
    for (size_t j = 0; j < width; ++j) {
        double once = 0.0;
        double twice = 0.0;
        for (size_t k = LAG_FIT_NODES; k-- > 0;) {
            once = once * part + coefficients[k * width + j] / (double)(k + 1);
            twice = twice * part + coefficients[k * width + j] / (double)((k + 1) * (k + 2));
        }
        x[n + j] = start[n + j] + length * part * once;
        if (j < n) {
            x[j] = start[j] + length * part * (start[n + j] + length * part * twice);
        }
    }
}
