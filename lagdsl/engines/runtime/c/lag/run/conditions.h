/* Conditions that must hold along a motion: invariants and assertions of the model. */
#ifndef LAG_CONDITIONS_H
#define LAG_CONDITIONS_H

#include "lag/equations/motion.h"

typedef struct lag_conditions {
    lag_motion *motion;
    int begun;
    double *start, *size, *drift; /* (ni) values at the start; largest scales and departures so far */
    const double *tolerance;      /* (ni) allowed departure, as a part of the scale; null: not watched */
    double *value, *scale, *held; /* (ni) (ni) (na) */
} lag_conditions;

/* Doubles for `value`, `scale` and `held`. */
size_t lag_conditions_memory(const lag_model *model);

/* Looks at the state x at time t. LAG_VIOLATED: the state does not count. */
lag_status lag_conditions_check(lag_conditions *watch, double t, const double *x);

/* Lets the state that was evaluated last count all the same: nothing follows. */
void lag_conditions_count(lag_conditions *watch);

#endif
