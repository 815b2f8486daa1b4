/* Conditions that must hold along a motion: invariants and assertions of the model. */
#ifndef LAG_CONDITIONS_H
#define LAG_CONDITIONS_H

#include <math.h>

#include "lag/equations/motion.h"
#include "lag/linalg/order.h"

/* Values known already at the state x at time t, in lanes: of each array numbers of one state are `lanes` apart. */
typedef struct lag_known_conditions {
    size_t lanes;
    const double *t, *x;                 /* x is null where nothing is known */
    const double *value, *scale, *held;  /* (ni) (ni) (na) */
} lag_known_conditions;

typedef struct lag_conditions {
    lag_motion *motion;
    lag_known_conditions known;   /* for the next look */
    int begun;
    double *start, *size, *drift; /* (ni) values at the start; largest scales and departures so far */
    const double *tolerance;      /* (ni) allowed departure, as a part of the scale; null: not watched */
    double *value, *scale, *held; /* (ni) (ni) (na) */
    double *warned;               /* (na) 1: it does not hold, and that was told */
} lag_conditions;

/* Distance of an invariant from its start, and its scale: the largest term that it has had. */
static inline double lag_conditions_drift(double value, double start)
{
    return fabs(value - start);
}

static inline double lag_conditions_size(double start, double scale, double before)
{
    return lag_higher(lag_higher(fabs(start), scale), before);
}

/* Doubles for `value`, `scale`, `held` and `warned`. */
size_t lag_conditions_memory(const lag_model *model);

/* Looks at the state x at time t, where the rates are xd; null: not known. LAG_VIOLATED: the state does not count. */
lag_status lag_conditions_check(lag_conditions *watch, double t, const double *x, const double *xd);

/*
 * The first assertion from number `from` on that is a warning, does not hold where the watch looked last, and held before; na: there is none. Each is
 * found once.
 */
size_t lag_conditions_warning(lag_conditions *watch, size_t from);

/* LAG_VIOLATED: an assertion does not hold where the watch looked last, and is no warning. */
lag_status lag_conditions_assert(const lag_conditions *watch);

/* Lets the state that was evaluated last count all the same: nothing follows. */
void lag_conditions_count(lag_conditions *watch);

#endif
