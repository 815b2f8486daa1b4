/*
 * The linear equations of the stages of the columns of Radau. Small ones are decomposed, once for all columns (lag/sensitivities/stage_equations.h). Others
 * are solved by the corrections of the state's Newton iteration, with what was decomposed for its step. They contract as those of the state did.
 */
#include <math.h>
#include <string.h>

#include "lag/linalg/arena.h"
#include "lag/linalg/linalg.h"
#include "lag/linalg/vector.h"
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

/* Residuals of the equations of the stages at z, as right sides of the systems. */
static void find_sides(const lag_stepper *stepper, const lag_radau_places *at, const lag_collocation_system *system)
{
    const lag_ode *ode = stepper->ode;
    const size_t n = ode->size;
    const size_t size = lag_radau_size(ode);
    const size_t stages = at->table->stages;
    const double h = stepper->t - stepper->t_before;
    const double one = 1.0;
    lag_radau_transform(size, stages, at->table->slopes, system->z, system->sides);
    for (size_t stage = 0; stage < stages; ++stage) {
        const double *z = system->z + stage * size;
        double *side = system->sides + stage * size;
        double *rates = at->slope + stage * n;
        for (size_t i = 0; i < n; ++i) {
            rates[i] = side[i] / h - system->slope[stage * n + i];
        }
        for (size_t i = 0; i < ode->nq; ++i) {
            side[i] = z[ode->nq + i] - rates[i];
        }
        for (size_t i = 0; i < lag_radau_rows(ode); ++i) {
            side[ode->nq + i] = lag_radau_is_rate(ode, i) ? -rates[ode->nq + i] : 0.0;
        }
        const lag_radau_stages of = {1, 0, z, z, rates};
        lag_radau_product(ode, system->jacobian + stage * lag_radau_entries(ode), &one, &of, side);
    }
    lag_radau_transform(size, stages, at->table->inverse, system->sides, at->sides);
}

/* z of a column. 0: they do not contract. */
static int correct(const lag_stepper *stepper, const lag_radau_places *at, const lag_collocation_system *system)
{
    const size_t n = stepper->ode->size;
    const size_t size = lag_radau_size(stepper->ode);
    const size_t stages = at->table->stages;
    double before = (double)INFINITY;
    size_t directions = 0; /* the work of columns tells nothing of the method for the state */
    lag_fill(stages * size, 0.0, system->z);
    lag_fill(stages * size, 0.0, system->w);
    for (unsigned k = 0; k < MOST; ++k) {
        find_sides(stepper, at, system);
        const double change = lag_radau_correction(stepper, at, stepper->t - stepper->t_before, &directions);
        if (!isfinite(change)) {
            return 0;
        }
        lag_axpy(stages * size, 1.0, at->sides, system->w);
        lag_radau_transform(size, stages, at->table->transform, system->w, system->z);
        const double length = sqrt(lag_radau_inner(stepper, stages, size, system->w, system->w) / (double)(n > 0 ? stages * n : 1));
        const double rate = change / before;
        const double left = rate < 1.0 ? rate / (1.0 - rate) * change : (double)INFINITY;
        const int settled = rate >= 1.0 && change <= 1e5 * LAG_ROUNDING * length; /* what does not shrink any more is round-off */
        if (change == 0.0 || (k > 0 && left <= 10.0 * LAG_ROUNDING * length) || settled) {
            return 1;
        }
        before = change;
    }
    return 0;
}

static lag_status solve_by_corrections(lag_sensitivities *s, const lag_stepper *stepper, const lag_radau_places *of_state)
{
    const size_t lanes = s->columns.lanes;
    const size_t n = stepper->ode->size;
    const size_t rows = of_state->table->stages * n;
    const lag_collocation_system *system = &s->work.collocation;
    for (size_t k = 0; k < s->of.count; ++k) {
        double *own = s->work.slopes + k / lanes * LAG_DOP853_SLOPES * n * lanes;
        lag_lane_get(lag_columns_lanes(s, k / lanes), k % lanes, rows, own, system->slope);
        if (!correct(stepper, of_state, system)) {
            return LAG_MISSING;
        }
        for (size_t stage = 0; stage < of_state->table->stages; ++stage) { /* without multipliers */
            memcpy(system->slope + stage * n, system->z + stage * lag_radau_size(stepper->ode), n * sizeof(double));
        }
        lag_lane_put(lag_columns_lanes(s, k / lanes), k % lanes, rows, system->slope, own);
    }
    return LAG_OK;
}

lag_status lag_columns_collocate(lag_sensitivities *s, const lag_stepper *stepper, const lag_radau_places *of_state)
{
    return s->work.collocation.equations.matrix != NULL ? solve_decomposed(s, stepper, of_state->table) : solve_by_corrections(s, stepper, of_state);
}
