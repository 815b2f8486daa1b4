/* One step of Newton's method in the impulse problem (lag/impulses/impulse.h). */
#ifndef LAG_IMPULSE_STEP_H
#define LAG_IMPULSE_STEP_H

#include "lag/impulses/impulse.h"

/* Doubles of its work. */
size_t lag_impulse_step_memory(const lag_model *model);

/* Chooses the coordinates of the components that these rows move, as what is beside them stays; all of them without rows. */
void lag_impulse_choose(lag_impulse *impulse, const lag_inequalities *rows);

/*
 * impulse->change of the rates in the first order, from momenta, M and rows as they were evaluated, for the chosen coordinates; `held` rates stay if
 * the others can do it, and `rows` act (null: none), whose speeds are those at the `rates` before it (nq); those so far are qd (nq).
 * LAG_NO_FORCES: as lag_friction_problem_solve().
 */
lag_status lag_impulse_step_find(lag_impulse *impulse, const double *held, lag_inequalities *rows, const double *rates, const double *qd);

/* Newton's method from rates at which all was evaluated; speeds of `rows` (or null) are those at impulse->rates. Statuses as the functions of lag/impulses/impulse.h. */
lag_status lag_impulse_iterate(lag_impulse *impulse, double t, double *x, const double *held, lag_inequalities *rows);

/* The coordinate of which the chosen number k is. */
static inline size_t lag_impulse_place_of(const lag_impulse *impulse, size_t k)
{
    return (size_t)impulse->chosen[k];
}

#endif
