/*
 * A state to start from: as near as possible to the start values, with constraints, fixed values and initial equations satisfied.
 *
 * Positions are the nearest in natural sizes at which written start values hold, or, where the others cannot meet the constraints, a written one
 * weighing 100 times another; rates of quaternions turn with what has moved; rates satisfy J v + b = 0 and the fixed
 * ones exactly, then written ones in turn as far as they are independent, the rest by least kinetic energy of the change. With
 * initial equations all are unknowns at once. The search is as thorough as that of `lag run`; it takes far longer than a step.
 *
 * Sources: Nocedal and Wright, Numerical Optimization, 2nd ed., sections 3.1, 10.3, 17.1 and 18.3.
 */
#ifndef LAG_INITIAL_H
#define LAG_INITIAL_H

#include "lag/equations/motion.h"

/* Faults of a start. */
typedef enum lag_initial_fault {
    LAG_INITIAL_NONE,
    LAG_INITIAL_NUMBERS,   /* a start value, or a row at the start values, is no number; `which`: entry of (q, qd, z), then of rows */
    LAG_INITIAL_POSITIONS, /* row `which` cannot be satisfied, */
    LAG_INITIAL_RATES,     /* or the rate that it asks for, or behind all rows the fixed rate of coordinate which - nc, */
    LAG_INITIAL_EQUATIONS, /* `which`: a row of constraints, then of initial equations, the worst */
    LAG_INITIAL_RANK,      /* with these parameters `which` more rows are independent than with those the model was compiled for */
    LAG_INITIAL_SIZES,     /* with these parameters row `which` is so much shorter, `residual`, than others that ranks take it for round-off */
    LAG_INITIAL_PARAMETERS, /* no equation decides the free parameter `which` */
    LAG_INITIAL_BOUNDS     /* the free parameter `which` is found beyond its bounds; `residual` is its value */
} lag_initial_fault;

typedef struct lag_initial {
    lag_initial_fault fault;
    size_t which;
    double residual; /* in its SI unit, as all that is told */
    size_t rank;     /* independent rows near the state that was found */
    int moved;       /* whether start values were changed */
    size_t freedom;  /* rates that the constraints leave free at that state */
    size_t excess;   /* LAG_INITIAL_POSITIONS, LAG_INITIAL_EQUATIONS: so many fixed values are too many, */
    size_t general;  /* of a mechanism that has so many degrees of freedom */
    int given;       /* told by the caller, 1: initial equations are left out */
    /* Room that the caller gives, or null. */
    unsigned char *dependent; /* (nc) 1 for rows that depend on others near that state */
    double *row_sizes;        /* (nc) natural sizes of the rows: as large as their derivatives usually come out */
    double *p;                /* (np) the parameters with those that were found, which the motion has from then on, if some are free */
} lag_initial;

/* Doubles for the search. */
size_t lag_initial_memory(const lag_model *model);

/*
 * x (q, qd, z) at time t, from the start values in it: those of the model, changed where `set` (2 nq + nz; null: nowhere), which then
 * count as written. `start` (null: nothing) is what the model says of them. Parameters and inputs are those of the motion; its discretes
 * become those of the start, contacts open. `told` may be null; `dependent` is all that is
 * read of it. LAG_PROJECTION_FAILED: there is no such state, x is the best that was found.
 */
lag_status lag_initial_find(lag_motion *motion, const lag_start *start, const unsigned char *set, double t, double *x, double *memory,
    lag_initial *told);

#endif
