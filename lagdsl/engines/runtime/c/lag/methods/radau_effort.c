/*
 * The work of a Radau method, counted in multiplications of an evaluation and told in evaluations of an explicit method.
 *
 * Weights are those of processors with vector registers: loops along rows take AT_ONCE products at once, what waits for the sum before it takes one.
 */
#include <math.h>

#include "lag/methods/radau.h"

/* Sweeps over all entries to keep them and to fill the matrices, as if they were multiplications. */
enum { SWEEPS = 2 };
/* Products in a loop along a row, and directions that are followed, at once. */
enum { AT_ONCE = 4 };
/* Multiplications that a row costs before its loop begins. */
enum { ROW = 6 };
/* Products of complex numbers in those of real ones. */
enum { COMPLEX = 4 };
/*
 * Multiplications around an evaluation of the rates, for each number of the state: of an explicit step with the coefficients of DOP853, 70 for 12
 * evaluations; of an implicit one, and for each of its stages, of a sum over these to the coordinates of the systems, back, and what is done once a step.
 */
enum { EXPLICIT = 6, IMPLICIT = 7, OF_STAGES = 4 };
/* A product of a substitution waits for the sum before it, in a band for memory; one of entries of a row waits for its column. */
enum { WAITS = 2 };
/* Sums over the numbers of the stages for a direction of a Krylov space: to the stages and back, and as long as it becomes orthogonal to others. */
enum { OF_DIRECTION = 8 };
/* Decompositions of the first steps, while their length grows; iterations of a step, commonly, and of one without a guess. */
enum { FEW = 5, ITERATIONS = 2, FROM_NOTHING = 4 };

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

/* Of the matrices, one real and `pairs` complex ones. */
static double decomposition_of(const lag_ode *ode, const lag_band *band, double pairs)
{
    const double m = (double)band->n;
    const double rows = lag_radau_is_sparse(ode) ? m * (double)band->lower : 0.5 * m * m;
    const double products = lag_radau_is_sparse(ode) ? lag_band_operations(band) : m * m * m / 3.0;
    return (1.0 + pairs) * ROW * rows + (1.0 + COMPLEX * pairs) * products / AT_ONCE;
}

/* Of their solutions: a complex product waits as long as a real one. */
static double solution_of(const lag_ode *ode, const lag_band *band, double pairs)
{
    const double m = (double)band->n;
    const double columns = lag_radau_is_sparse(ode) ? (double)lag_band_height(band) : m;
    return (1.0 + pairs) * WAITS * (m * columns + (ode->nq > 0 ? 0.5 * entries_of(ode) : 0.0));
}

double lag_radau_effort(const lag_stepper *s, const lag_step_counts *done)
{
    const lag_ode *ode = s->ode;
    const lag_radau_places at = lag_radau_place(s);
    const double n = (double)ode->size;
    const double stages = (double)at.table->stages;
    const double pairs = 0.5 * (stages - 1.0);
    const lag_band band = lag_radau_band(ode, &at);
    const double solution = solution_of(ode, &band, pairs);
    const double evaluation = entries_of(ode);
    const double implicit = evaluation + (IMPLICIT + OF_STAGES * stages) * n + solution / stages;
    const double jacobian = evaluation * directions_of(ode) / AT_ONCE + SWEEPS * evaluation;
    const double direction = solution + stages * (2.0 * WAITS * evaluation + OF_DIRECTION * n);
    const double all = (double)done->evaluations * implicit + (double)done->decompositions * decomposition_of(ode, &band, pairs) +
        (double)done->jacobians * jacobian + (double)done->directions * direction;
    return all / (evaluation + EXPLICIT * n);
}

double lag_radau_renewal(const lag_stepper *s)
{
    const lag_step_counts renewal = {.jacobians = 1, .decompositions = 1};
    const lag_step_counts iteration = {.evaluations = lag_radau_place(s).table->stages};
    return lag_radau_effort(s, &renewal) / lag_radau_effort(s, &iteration);
}

lag_radau_plan lag_radau_expect(lag_stepper *s)
{
    const double factor = lag_radau.factor / s->method->factor;
    *lag_radau_remembered(s) = (lag_radau_memo){.level = (double)lag_radau_level(s, factor), .trust = 1.0};
    lag_radau_keep_band(lag_radau_remembered(s), s->ode);
    const size_t stages = lag_radau_place(s).table->stages;
    const lag_step_counts look = {.jacobians = 1, .decompositions = 1, .evaluations = FROM_NOTHING * stages + 1};
    const lag_step_counts first = {.jacobians = 1, .decompositions = FEW};
    const lag_step_counts two = {.jacobians = 1, .decompositions = 1, .evaluations = 2 * (ITERATIONS * stages + 1)};
    return (lag_radau_plan){lag_radau_effort(s, &look), lag_radau_effort(s, &first), 0.5 * lag_radau_effort(s, &two)};
}
