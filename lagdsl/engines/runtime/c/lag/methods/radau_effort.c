/* The work of a Radau method, counted in multiplications and told in evaluations of an explicit one. */
#include <math.h>

#include "lag/methods/radau.h"

/* Sweeps over all entries to keep them and to fill the matrices, as if they were multiplications. */
enum { SWEEPS = 2 };
/* Directions that are followed at once. */
enum { AT_ONCE = 4 };
/*
 * Multiplications around an evaluation of the rates, for each number of the state: of an explicit step with the coefficients of DOP853, 70 for 12
 * evaluations; of an implicit one, and for each of its stages, of a sum over these to the coordinates of the systems, back, and what is done once a step.
 */
enum { EXPLICIT = 6, IMPLICIT = 7, OF_STAGES = 4 };
/* Of a substitution every product waits for the sum before it: four cycles, where others take one. */
enum { WAITS = 4 };
/* Decompositions of the first steps, while their length grows; iterations of a step, commonly. */
enum { FEW = 5, ITERATIONS = 2 };

/* Entries of the Jacobian: there are at least so many multiplications in an evaluation of the rates. */
static double entries_of(const lag_ode *ode)
{
    return fmax((double)(ode->nq + (lag_radau_is_sparse(ode) ? lag_radau_entries(ode) : lag_radau_others(ode) * ode->size)), 1.0);
}

/* Directions that show the Jacobian: groups of columns, and of those of M, or every column. */
static double directions_of(const lag_ode *ode)
{
    const lag_patterns *patterns = ode->patterns;
    return (double)(lag_radau_is_sparse(ode) ?
        lag_pattern_groups(ode->size, patterns->group) + lag_pattern_groups(ode->nq + ode->nc, patterns->value_group) : ode->size);
}

double lag_radau_effort(const lag_stepper *s, const lag_step_counts *done)
{
    const lag_radau_places at = lag_radau_place(s);
    const double n = (double)s->ode->size;
    const double m = (double)lag_radau_rows(s->ode);
    const double stages = (double)at.table->stages;
    const double matrices = 1.0 + 2.0 * (stages - 1.0); /* a product of complex numbers is four */
    const lag_band band = lag_radau_band(s->ode, &at);
    const int banded = lag_radau_is_sparse(s->ode);
    const double decomposition = banded ? lag_band_operations(&band) : m * m * m / 3.0;
    const double of_coordinates = s->ode->nq > 0 ? (double)(band.lower + band.upper + 1) : 0.0;
    const double solution = m * (banded ? (double)lag_band_width(&band) + of_coordinates : n);
    const double evaluation = entries_of(s->ode);
    const double implicit = evaluation + (IMPLICIT + OF_STAGES * stages) * n + WAITS * matrices * solution / stages;
    const double jacobian = evaluation * directions_of(s->ode) / AT_ONCE + SWEEPS * evaluation;
    const double all = (double)done->evaluations * implicit + (double)done->decompositions * matrices * decomposition +
        (double)done->jacobians * jacobian;
    return all / (evaluation + EXPLICIT * n);
}

double lag_radau_trial(lag_stepper *s, size_t steps)
{
    const size_t evaluations = steps * (ITERATIONS * lag_radau_tables[0].stages + 1);
    const lag_step_counts few = {.jacobians = 1, .decompositions = FEW, .evaluations = evaluations};
    *lag_radau_remembered(s) = (lag_radau_memo){.level = 0.0};
    lag_radau_keep_band(lag_radau_remembered(s), s->ode);
    const lag_radau_places at = lag_radau_place(s);
    s->looked = 0;
    ++s->counts.jacobians;
    if (lag_radau_jacobian(s->ode, s->t, s->x, at.jacobian) != LAG_OK) {
        return (double)INFINITY;
    }
    at.memo->fresh = at.memo->usable = 1.0;
    s->looked = 1;
    return lag_radau_effort(s, &few);
}
