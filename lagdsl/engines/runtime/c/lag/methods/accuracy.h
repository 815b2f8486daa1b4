/*
 * From the one tolerance of a motion to absolute tolerances of every number of its state.
 *
 * A number is as accurate as the tolerance times its scale: the largest magnitude seen so far among the numbers of the same group
 * (coordinates of one unit that the equations couple, their rates, one state), at least 1e-4 of the natural size, and for angles at
 * most 1: an angle that has turned a thousand times still enters through its sine. Components that nothing couples do not loosen
 * each other's error control.
 */
#ifndef LAG_ACCURACY_H
#define LAG_ACCURACY_H

#include "lag/linalg/order.h"
#include "lag/model.h"

typedef struct lag_accuracy {
    size_t size;           /* of the state */
    const double *group;   /* (size) numbers of the same kind have the same one, below `size` */
    const double *natural; /* (size) natural sizes */
    const double *cap;     /* (size) largest scales; may be infinite */
    double *largest;       /* (size) magnitudes seen so far, by group */
    double relative;       /* tolerance of one step */
} lag_accuracy;

/* Scales are at least this part of the natural size, and tolerances this part of the number itself. */
static const double LAG_ACCURACY_FLOOR = 1e-4;
static const double LAG_ACCURACY_ROUNDING = 1e-15;

/* Bound of the scale of number i; its least tolerance where it is zero. */
static inline double lag_accuracy_floor(const lag_accuracy *accuracy, size_t i)
{
    return LAG_ACCURACY_FLOOR * accuracy->natural[i];
}

static inline double lag_accuracy_most(const lag_accuracy *accuracy, size_t i)
{
    return lag_higher(accuracy->cap[i], lag_accuracy_floor(accuracy, i));
}

static inline double lag_accuracy_least(const lag_accuracy *accuracy, size_t i)
{
    return LAG_ACCURACY_ROUNDING * accuracy->natural[i];
}

/* Its tolerance; with functions for numbers, or for vectors of them. */
#define LAG_ACCURACY_TOLERANCE(lower, higher, relative, largest, floor, most, least, size) \
    higher((relative) * lower(higher(largest, floor), most), higher(least, LAG_ACCURACY_ROUNDING * (size)))

/* Absolute tolerances (size), now that x was reached. */
void lag_accuracy_after(lag_accuracy *accuracy, const double *x, double *tolerance);

/*
 * Groups by component and unit, natural sizes and caps of a model's state, each (2 nq + nz): angles and numbers have size 1, other
 * coordinates the largest start value of the same group, where all are zero 1.
 */
void lag_accuracy_groups(const lag_model *model, const double *start, double *group, double *natural, double *cap);

#endif
