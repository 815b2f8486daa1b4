/*
 * Motion out of and across singular positions, where several branches of the constraint set meet: fitted, not integrated.
 *
 * J is scaled to rows of size one. Near a lost rank the derivatives of rates and states are polynomials in time that agree with the
 * equations at collocation points behind the position, whose states are projected onto the constraints. Whether branches meet there is
 * told by the height of the saddle of the combination of rows that vanishes.
 *
 * Sources: Hairer, Norsett and Wanner, Solving Ordinary Differential Equations I, 2nd ed., section II.7; Rheinboldt, Numerical Analysis
 * of Parametrized Nonlinear Equations, 1986, chapter 5.
 */
#ifndef LAG_SINGULAR_H
#define LAG_SINGULAR_H

#include "lag/run.h"

/* Doubles for lag_run_across(). */
size_t lag_singular_memory(const lag_model *model);

#endif
