/* A first-order system x' = f(t, x), as the methods see it. */
#ifndef LAG_ODE_H
#define LAG_ODE_H

#include "lag/model.h"

typedef struct lag_ode {
    size_t size; /* of x */
    size_t nq;   /* x begins with so many coordinates and their rates: x'[i] = x[nq + i]; 0: of first order */
    void *context;
    /* xd (size) = f(t, x). After a status that is not LAG_OK, a method tries a shorter step. */
    lag_status (*rates)(void *context, double t, const double *x, double *xd);
    /* df/dx (size, size), row by row; null where only explicit methods are used */
    lag_status (*jacobian)(void *context, double t, const double *x, double *jacobian);
    /* `rates` of these: where rows of df/dx behind those of the coordinates can be nonzero; null: anywhere */
    const lag_patterns *patterns;
    /* these entries of df/dx, in their order; null where they are not told */
    lag_status (*entries)(void *context, double t, const double *x, double *entries);
} lag_ode;

/* The entries of df/dx that are known by their places; null: all are. */
static inline const lag_pattern *lag_ode_pattern(const lag_ode *ode)
{
    return ode->patterns != NULL ? ode->patterns->rates : NULL;
}

/* Directions that show them all: groups of columns, or every column. */
static inline size_t lag_pattern_directions(const lag_patterns *patterns, size_t columns)
{
    size_t count = 0;
    for (size_t j = 0; j < columns && patterns != NULL && patterns->rates != NULL; ++j) {
        count = patterns->group[j] >= count ? patterns->group[j] + 1 : count;
    }
    return count > 0 ? count : columns;
}

#endif
