/*
 * The point of a constraint set nearest to the origin, which is the declared start.
 *
 * Found by following the problem from there (|y|^2 e + |equations(y)|^2 with e to 0) and by the root finder alone, each made
 * stationary by Newton's method on the set. If the set bends more than half the distance, at the start or at the point
 * found, there may be nearer points. Then further searches begin inside the ball of that distance. Independent parts are
 * searched at the same time, each as if it were alone.
 *
 * Source: Nocedal and Wright, Numerical Optimization, 2nd ed., sections 17.1 (penalty), 18.3 (reduced Hessian) and 3.1 (line search).
 */
#ifndef LAG_NEAREST_CONFIGURATION_H
#define LAG_NEAREST_CONFIGURATION_H

#include "lag/optimization/levenberg_marquardt.h"

/* Points that guesses lead to: of the origin, of the penalties, of further ones, and beyond bends on either side of each. */
enum { LAG_NEAREST_GUESSES = 40, LAG_NEAREST_FOUND = 2 * LAG_NEAREST_GUESSES, LAG_NEAREST_REFINED = 6 };

/* A point with residuals and distances from the origin of each part. */
typedef struct lag_found {
    double *point;             /* (n) */
    double *sizes, *distances; /* (m + n) */
} lag_found;

/* The equations with a row e y more for each column. */
typedef struct lag_relaxed {
    lag_levenberg_marquardt minimizer;
    lag_parts parts;
    double penalty;            /* e */
} lag_relaxed;

/* A step along the set. */
typedef struct lag_nearest_path {
    double *limits;            /* (m + n) of each part: residuals that are none, */
    double *distances;         /* (m + n) distances from the origin, */
    double *moved, *ways, *also; /* (m + n) flags */
    double *steps, *shorter, *opposite, *trial; /* (n) */
} lag_nearest_path;

/* The bend of the set at a point. */
typedef struct lag_nearest_bend {
    double *point;             /* (n) */
    double *before;            /* (entries of the parts) */
    double *square;            /* (m + n + 1) of each part: where its (columns, columns) numbers begin in the next two, */
    double *directions, *bends; /* rows of as many numbers as a part has columns */
    double *widths;            /* (m + n) of each part: so many directions */
    double *weights, *weight;  /* (m) */
    double *hessian, *eigen, *vectors; /* (n, n) (n) (n, n) */
} lag_nearest_bend;

typedef struct lag_nearest_configuration {
    const lag_equations *equations;
    const lag_parts *parts;
    double holds;          /* residuals of a part that are as small as this are none */
    const double *guesses;  /* (LAG_NEAREST_GUESSES, n) further guesses, used as directions once a point is known */
    lag_levenberg_marquardt minimizer;
    lag_relaxed relaxed;
    lag_found found[LAG_NEAREST_FOUND], refined[LAG_NEAREST_REFINED], best;
    size_t count;          /* found */
    lag_nearest_path path;
    lag_nearest_bend bend;
    double *residual, *jacobian; /* (m) (entries of the parts) */
    double *moving, *chosen, *lengths; /* (m + n) of each part */
    double *part;                /* (n) */
    double *svd;
} lag_nearest_configuration;

/* Doubles for parts of m rows and n columns at most. */
size_t lag_nearest_configuration_memory(size_t m, size_t n);
void lag_nearest_configuration_place(lag_nearest_configuration *nearest, const lag_parts *parts, double *memory);

/*
 * Minimizes |y| subject to equations(y) = 0: `best`. If no search leads to residuals below `holds`, `best` is the point of
 * the smallest. Returns the largest of them.
 */
double lag_nearest_configuration_search(lag_nearest_configuration *nearest, const lag_equations *equations, const double *guesses, double holds);

/* For the parts of a search. */

/* A local minimum of |y| subject to the equations from `point`, where they hold up to `limits`; lengths fall monotonically. */
void lag_nearest_configuration_along(lag_nearest_configuration *nearest, double *point);
/* Flags in `moving` the parts in which the set bends by more than half the distance, at the origin or at the best point. Returns whether any does. */
int lag_nearest_configuration_bends(lag_nearest_configuration *nearest);

#endif
