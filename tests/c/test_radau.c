/* The numbers of the Radau IIA methods against the conditions that define them. */
#include "check.h"
#include "lag/methods/radau.h"

enum { STAGES = LAG_RADAU_STAGES };

/* out = matrix in */
static void multiply(size_t stages, const double matrix[STAGES][STAGES], const double *in, double *out)
{
    for (size_t i = 0; i < stages; ++i) {
        out[i] = 0.0;
        for (size_t j = 0; j < stages; ++j) {
            out[i] += matrix[i][j] * in[j];
        }
    }
}

/* out = inverse of the Runge-Kutta matrix in */
static void apply(const lag_radau_table *table, const double *in, double *out)
{
    double w[STAGES];
    double turned[STAGES];
    multiply(table->stages, table->inverse, in, w);
    turned[0] = table->mu * w[0];
    for (size_t pair = 0; 2 * pair + 1 < table->stages; ++pair) {
        const double *part = w + 2 * pair + 1;
        turned[2 * pair + 1] = table->alpha[pair] * part[0] + table->beta[pair] * part[1];
        turned[2 * pair + 2] = table->alpha[pair] * part[1] - table->beta[pair] * part[0];
    }
    multiply(table->stages, table->transform, turned, out);
}

/* Collocation: what integrates x^(k-1) to x^k / k at the nodes turns the latter into the former. */
static void collocation(const lag_radau_table *table)
{
    double power[STAGES], slope[STAGES];
    for (unsigned k = 1; k <= table->stages; ++k) {
        double error = 0.0;
        for (size_t i = 0; i < table->stages; ++i) {
            power[i] = pow(table->node[i], (double)k);
        }
        apply(table, power, slope);
        for (size_t i = 0; i < table->stages; ++i) {
            CHECK_NEAR(slope[i], (double)k * pow(table->node[i], (double)k - 1.0), 1e-12);
            error += table->error[i] * power[i];
        }
        /* The embedded formula is exact for the same polynomials, with 1/mu as weight of the slope at the start. */
        CHECK_NEAR(error, k == 1 ? -1.0 : 0.0, 1e-12);
    }
}

/* The Runge-Kutta matrix integrates as collocation does, and `slopes` undoes it. */
static void runge_kutta(const lag_radau_table *table)
{
    double power[STAGES], integral[STAGES], slope[STAGES];
    for (unsigned k = 1; k <= table->stages; ++k) {
        for (size_t i = 0; i < table->stages; ++i) {
            power[i] = pow(table->node[i], (double)k - 1.0);
        }
        multiply(table->stages, table->matrix, power, integral);
        multiply(table->stages, table->slopes, integral, slope);
        for (size_t i = 0; i < table->stages; ++i) {
            CHECK_NEAR(integral[i], pow(table->node[i], (double)k) / (double)k, 1e-15);
            CHECK_NEAR(slope[i], power[i], 1e-13);
        }
    }
}

/* Radau: the sum of weights times x^(k-1) is 1/k up to k = 2 stages - 1; the weights are the last row of the Runge-Kutta matrix. */
static void quadrature(const lag_radau_table *table)
{
    const size_t s = table->stages;
    double weight[STAGES] = {0.0};
    double matrix[STAGES][STAGES + 1];
    for (size_t k = 0; k < s; ++k) { /* interpolatory weights, by elimination */
        for (size_t i = 0; i < s; ++i) {
            matrix[k][i] = pow(table->node[i], (double)k);
        }
        matrix[k][s] = 1.0 / (double)(k + 1);
    }
    for (size_t k = 0; k < s; ++k) {
        for (size_t i = 0; i < s; ++i) {
            const double part = i == k ? 0.0 : matrix[i][k] / matrix[k][k];
            for (size_t j = k; j <= s; ++j) {
                matrix[i][j] -= part * matrix[k][j];
            }
        }
    }
    for (size_t i = 0; i < s; ++i) {
        weight[i] = matrix[i][s] / matrix[i][i];
        CHECK(weight[i] > 0.0);
    }
    CHECK(table->node[s - 1] == 1.0);
    for (size_t k = 1; k < 2 * s; ++k) {
        double sum = 0.0;
        for (size_t i = 0; i < s; ++i) {
            sum += weight[i] * pow(table->node[i], (double)k - 1.0);
        }
        CHECK_NEAR(sum, 1.0 / (double)k, 1e-13);
    }
}

int main(void)
{
    for (size_t i = 0; i < LAG_RADAU_TABLES; ++i) {
        CHECK(lag_radau_tables[i].stages == 2 * i + 3);
        collocation(&lag_radau_tables[i]);
        runge_kutta(&lag_radau_tables[i]);
        quadrature(&lag_radau_tables[i]);
    }
    (void)printf("radau: ok\n");
    return EXIT_SUCCESS;
}
