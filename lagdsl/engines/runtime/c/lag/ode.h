/* A first-order system x' = f(t, x), as the methods see it. */
#ifndef LAG_ODE_H
#define LAG_ODE_H

#include "lag/model.h"

typedef struct lag_ode {
    size_t size; /* of x */
    size_t nq;   /* x begins with so many coordinates and their rates: x'[i] = x[nq + i]; 0: of first order */
    size_t nc;   /* multipliers of the equations that tell f */
    void *context;
    /* xd (size) = f(t, x). After a status that is not LAG_OK, a method tries a shorter step. */
    lag_status (*rates)(void *context, double t, const double *x, double *xd);
    /* df/dx (size, size), row by row; null where only explicit methods are used */
    lag_status (*jacobian)(void *context, double t, const double *x, double *jacobian);
    /* `equations` of these: entries of equations in x, the rates behind those of the coordinates, and multipliers, that tell f; null: none are told */
    const lag_patterns *patterns;
    /* these entries, in their order, of the equations with changed signs: of -r, g - zd and -s; null where they are not told */
    lag_status (*linearize)(void *context, double t, const double *x, double *entries);
} lag_ode;

/* The entries of the equations; null: these are not told. */
static inline const lag_pattern *lag_ode_pattern(const lag_ode *ode)
{
    return ode->patterns != NULL ? ode->patterns->equations : NULL;
}

/* Groups of so many columns. */
static inline size_t lag_pattern_groups(size_t columns, const size_t *group)
{
    size_t count = 0;
    for (size_t j = 0; j < columns; ++j) {
        count = group[j] >= count ? group[j] + 1 : count;
    }
    return count;
}

#endif
