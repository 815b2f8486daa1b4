/*
 * Derivative of a function of one number at zero, by central differences of sixth order. Their step is found: small enough for the function,
 * and large enough for its round-off, as the variable of a function says little about either. The one that starts at 1e-20 beside another one of 1
 * changes their sum by nothing, and a circle of 0.1 mm at 1 m bends within a part of 1e-4.
 *
 * Source: Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I (2nd ed., 1993), section II.9, on extrapolation in h^2.
 */
#ifndef LAG_SLOPE_H
#define LAG_SLOPE_H

typedef struct lag_slope {
    double unit;  /* steps begin with a part of this, */
    double most;  /* and end at the same part of this */
    double here;  /* the function at zero */
    double noise; /* round-off of the function */
    double value; /* the derivative */
    int shows;    /* 1: the function changes by more than its round-off */
} lag_slope;

/* Finds slope->value of g(context, by) at by = 0; not a number where there is none. */
void lag_slope_find(lag_slope *slope, double (*g)(void *context, double by), void *context);

#endif
