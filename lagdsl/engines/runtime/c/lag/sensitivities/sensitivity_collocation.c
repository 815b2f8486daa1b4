/*
 * The linear equations of the stages of a column, A^-1 z = h (J z + f) with the Jacobian J at each stage and the slopes f where the column begins. Small
 * ones are decomposed, once for all columns. Others are solved by the corrections of the state's Newton iteration, with what was decomposed for its step.
 * They contract as those of the state did.
 */
#include <math.h>
#include <string.h>

#include "lag/elimination/lu.h"
#include "lag/linalg/arena.h"
#include "lag/linalg/linalg.h"
#include "lag/sensitivities/sensitivities.h"

/* Corrections at most: of the state they contract, or the step would not have been accepted. */
enum { MOST = 60 };

/* slope = f + J z at all stages */
static void find_slopes(const lag_stepper *stepper, const lag_radau_places *at, const lag_collocation_system *system)
{
    const lag_ode *ode = stepper->ode;
    const size_t n = ode->size;
    for (size_t stage = 0; stage < at->table->stages; ++stage) {
        const double *jacobian = system->jacobian + stage * lag_radau_entries(ode);
        const double *z = system->z + stage * n;
        double *slope = at->slope + stage * n;
        memcpy(slope, system->slope + stage * n, n * sizeof(double));
        for (size_t i = 0; i < ode->nq; ++i) {
            slope[i] += z[ode->nq + i];
        }
        for (size_t i = 0; i < lag_radau_others(ode); ++i) {
            const lag_radau_row row = lag_radau_row_of(ode, i);
            double sum = 0.0;
            for (size_t k = row.first; k < row.end; ++k) {
                sum += jacobian[k] * z[row.column == NULL ? k - row.first : row.column[k]];
            }
            slope[ode->nq + i] += sum;
        }
    }
}

/* ---- decomposed ---- */

/* d (stages, stages), which is A^-1: h times the slope at node i of the polynomial through 0 at the beginning and z at the nodes. */
static void slopes_of_nodes(const lag_radau_table *table, double d[LAG_RADAU_STAGES][LAG_RADAU_STAGES])
{
    const size_t stages = table->stages;
    for (size_t i = 0; i < stages; ++i) {
        for (size_t k = 0; k < stages; ++k) {
            double product = 1.0 / table->node[k];
            double sum = i == k ? 1.0 / table->node[k] : 0.0;
            for (size_t j = 0; j < stages; ++j) {
                product *= j != k && j != i ? (table->node[i] - table->node[j]) / (table->node[k] - table->node[j]) : 1.0;
                sum += i == k && j != k ? 1.0 / (table->node[k] - table->node[j]) : 0.0;
            }
            d[i][k] = i == k ? sum : product * table->node[i] / (table->node[k] - table->node[i]);
        }
    }
}

/* Subtracts h J of a stage from its rows of the matrix, of so many columns. */
static void subtract_jacobian(const lag_ode *ode, const double *jacobian, double h, size_t width, double *rows)
{
    for (size_t i = 0; i < ode->nq; ++i) {
        rows[i * width + ode->nq + i] -= h;
    }
    for (size_t i = 0; i < lag_radau_others(ode); ++i) {
        const lag_radau_row row = lag_radau_row_of(ode, i);
        for (size_t k = row.first; k < row.end; ++k) {
            rows[(ode->nq + i) * width + (row.column == NULL ? k - row.first : row.column[k])] -= h * jacobian[k];
        }
    }
}

int lag_collocation_decompose(const lag_stepper *stepper, const lag_radau_table *table, const lag_collocation_system *system)
{
    const lag_ode *ode = stepper->ode;
    const size_t n = ode->size;
    const size_t rows = table->stages * n;
    const double h = stepper->t - stepper->t_before;
    double d[LAG_RADAU_STAGES][LAG_RADAU_STAGES];
    slopes_of_nodes(table, d);
    lag_fill(rows * rows, 0.0, system->matrix);
    for (size_t i = 0; i < table->stages; ++i) {
        double *of_stage = system->matrix + i * n * rows;
        for (size_t j = 0; j < n; ++j) {
            for (size_t k = 0; k < table->stages; ++k) {
                of_stage[j * rows + k * n + j] = d[i][k];
            }
        }
        subtract_jacobian(ode, system->jacobian + i * lag_radau_entries(ode), h, rows, of_stage + i * n);
    }
    return lag_lu(rows, system->matrix, system->pivots);
}

static void solve_decomposed(const lag_stepper *stepper, size_t rows, const lag_collocation_system *system)
{
    const double h = stepper->t - stepper->t_before;
    for (size_t i = 0; i < rows; ++i) {
        system->z[i] = h * system->slope[i];
    }
    lag_lu_solve(rows, system->matrix, system->pivots, system->z);
}

/* ---- by corrections ---- */

int lag_columns_collocate(const lag_stepper *stepper, const lag_radau_places *at, const lag_collocation_system *system)
{
    const size_t n = stepper->ode->size;
    const size_t stages = at->table->stages;
    const double h = stepper->t - stepper->t_before;
    double before = (double)INFINITY;
    if (system->matrix != NULL) {
        solve_decomposed(stepper, stages * n, system);
        return 1;
    }
    memset(system->z, 0, stages * n * sizeof(double));
    memset(at->w, 0, stages * n * sizeof(double));
    for (unsigned k = 0; k < MOST; ++k) {
        find_slopes(stepper, at, system);
        const double size = lag_radau_correction(stepper, at, h);
        if (!isfinite(size)) {
            return 0;
        }
        for (size_t i = 0; i < stages * n; ++i) {
            at->w[i] += at->slope[i];
        }
        lag_radau_transform(n, stages, at->table->transform, at->w, system->z);
        const double length = sqrt(lag_radau_inner(stepper, stages, at->w, at->w) / (double)(n > 0 ? stages * n : 1));
        const double rate = size / before;
        const double left = rate < 1.0 ? rate / (1.0 - rate) * size : (double)INFINITY;
        const int settled = rate >= 1.0 && size <= 1e5 * LAG_ROUNDING * length; /* what does not shrink any more is round-off */
        if (size == 0.0 || (k > 0 && left <= 10.0 * LAG_ROUNDING * length) || settled) {
            return 1;
        }
        before = size;
    }
    return 0;
}
