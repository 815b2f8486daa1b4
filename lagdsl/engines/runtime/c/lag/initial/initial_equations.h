/* The files that solve initial equations: what they share of the problem and of its parts. */
#ifndef LAG_INITIAL_EQUATIONS_H
#define LAG_INITIAL_EQUATIONS_H

#include "lag/initial/initial_equations_rows.h"

#define LAG_JOINT_TARGET 1e-11

/* Of each part of rows and unknowns, by its number. */
typedef struct lag_joint_parts {
    lag_parts whole;
    unsigned char *equation, *rated, *parametric; /* it has an initial equation, one that depends on rates, a free parameter; */
    unsigned char *open;                          /* written start values give way */
    double *point, *best, *trial;                 /* (all) */
    unsigned char *joined;                        /* (nq) */
    double *slopes;                               /* (ne, nq) */
    double *found;                                /* (all) */
    double *memory;                               /* of what is done in turn */
} lag_joint_parts;

/* Rows and unknowns of the parts with initial equations; rates only where one depends on them. */
void lag_joint_choose(const lag_joint_parts *t, lag_joint *joint);
/* Independent parts of the problem, by the unknowns that its rows depend on. */
lag_parts lag_joint_parts_of(const lag_joint *joint, double *pattern, double *memory);

/* The nearest point, if more than one is admissible, in `best`. Returns what is left of the equations. */
double lag_joint_search(const lag_joint_parts *t, lag_joint *joint);

/*
 * Rates at the positions that were found: by the rule of those without initial equations, under these as further conditions. Equations
 * that are not linear in rates are met in turns; where that leads nowhere the rates of the search stay.
 */
void lag_joint_find_rates(const lag_joint_parts *t, lag_joint *joint, double *x);

/* Why there is no solution: the row that is farthest from zero; */
void lag_joint_find_worst(const lag_joint_parts *t, lag_joint *joint);
/* so many fixed values are too many, by ranks at the state that was found; */
void lag_joint_count_excess(const lag_joint_parts *t, lag_joint *joint);
/* a free parameter that could be changed with the equations satisfied still: nothing decides it. */
void lag_joint_find_undecided(const lag_joint_parts *t, lag_joint *joint);

#endif
