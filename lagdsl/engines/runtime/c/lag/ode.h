/* A first-order system x' = f(t, x), as the methods see it. */
#ifndef LAG_ODE_H
#define LAG_ODE_H

#include <stddef.h>

#include "lag/status.h"

typedef struct lag_ode {
    size_t size; /* of x */
    size_t nq;   /* x begins with so many coordinates and their rates: x'[i] = x[nq + i]; 0: of first order */
    void *context;
    /* xd (size) = f(t, x). After a status that is not LAG_OK, a method tries a shorter step. */
    lag_status (*rates)(void *context, double t, const double *x, double *xd);
    /* df/dx (size, size), row by row; null where only explicit methods are used */
    lag_status (*jacobian)(void *context, double t, const double *x, double *jacobian);
} lag_ode;

#endif
