/*
 * The linear equations of the stages of the columns of Radau. Small ones are decomposed, once for all columns (lag/sensitivities/stage_equations.h). Others
 * are solved by the corrections of the state's Newton iteration, with what was decomposed for its step. They contract as those of the state did.
 */
#include <math.h>
#include <string.h>

#include "lag/linalg/linalg.h"
#include "lag/sensitivities/sensitivities.h"

/* ---- decomposed ---- */

static lag_status solve_decomposed(lag_sensitivities *s, const lag_stepper *stepper, const lag_radau_table *table)
{
    lag_stage_equations *e = &s->work.collocation.equations;
    e->table = table;
    e->h = stepper->t - stepper->t_before;
    const lag_status status = s->sums->decompose(e) ? LAG_OK : LAG_SINGULAR;
    for (size_t block = 0; block < s->columns.blocks && status == LAG_OK; ++block) {
        lag_columns_sums(s, block)->collocate(e, lag_columns_lanes(s, block), s->work.slopes + block * LAG_DOP853_SLOPES * e->n * s->columns.lanes);
    }
    return status;
}

/* ---- by corrections ---- */

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

/* z of a column. 0: they do not contract. */
static int correct(const lag_stepper *stepper, const lag_radau_places *at, const lag_collocation_system *system)
{
    const size_t n = stepper->ode->size;
    const size_t stages = at->table->stages;
    const double h = stepper->t - stepper->t_before;
    double before = (double)INFINITY;
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

static lag_status solve_by_corrections(lag_sensitivities *s, const lag_stepper *stepper, const lag_radau_places *of_state)
{
    const size_t lanes = s->columns.lanes;
    const size_t rows = of_state->table->stages * stepper->ode->size;
    const lag_collocation_system *system = &s->work.collocation;
    for (size_t k = 0; k < s->of.count; ++k) {
        double *own = s->work.slopes + k / lanes * LAG_DOP853_SLOPES * stepper->ode->size * lanes;
        lag_lane_get(lag_columns_lanes(s, k / lanes), k % lanes, rows, own, system->slope);
        if (!correct(stepper, of_state, system)) {
            return LAG_MISSING;
        }
        lag_lane_put(lag_columns_lanes(s, k / lanes), k % lanes, rows, system->z, own);
    }
    return LAG_OK;
}

lag_status lag_columns_collocate(lag_sensitivities *s, const lag_stepper *stepper, const lag_radau_places *of_state)
{
    return s->work.collocation.equations.matrix != NULL ? solve_decomposed(s, stepper, of_state->table) : solve_by_corrections(s, stepper, of_state);
}
