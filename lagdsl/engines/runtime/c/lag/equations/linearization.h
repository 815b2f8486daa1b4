/* The equations of a motion, linear about a state: what implicit methods decompose in a band. */
#ifndef LAG_LINEARIZATION_H
#define LAG_LINEARIZATION_H

#include "lag/equations/motion.h"

/*
 * The entries that lag_patterns.equations tells, at the state x, its accelerations and multipliers, of the equations with changed signs: -r, g - zd,
 * -s. `context` is a lag_motion.
 */
lag_status lag_motion_linearize(void *context, double t, const double *x, double *entries);

#endif
