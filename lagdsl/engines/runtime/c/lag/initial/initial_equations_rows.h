/* Initial equations, with what they tie together: positions, rates, states and parameters are solved at once. */
#ifndef LAG_INITIAL_EQUATIONS_ROWS_H
#define LAG_INITIAL_EQUATIONS_ROWS_H

#include "lag/initial/initial_scaling.h"

/*
 * Unknowns are numbered as in (q, qd, z), then come the free parameters; rows are those of position level, then all constraints as rates
 * see them, then the initial equations.
 */
typedef struct lag_joint {
    lag_initialization *b;
    size_t all_rows, all;        /* rows; unknowns */
    size_t parameters;           /* free ones */
    double *parameter;           /* (parameters) which they are */
    double *origin, *width;      /* (all) where y is zero; steps of order one */
    double *scale;               /* (all_rows) */
    double *pattern;             /* (all_rows, all) 1: the row depends on the unknown */
    size_t rows, count;          /* of the problem that is solved: so many rows, unknowns */
    double *row, *free;          /* (all_rows) (all) which they are */
    double *at;                  /* (all) */
    double *one, *other, *here;  /* (all_rows) */
    double *y;                   /* (all) */
    double *qdd, *lam;           /* (nq) (nc) */
} lag_joint;

/* Doubles that last while a start is found, and which of the parameters are unknowns. */
size_t lag_joint_memory(const lag_model *model);
void lag_joint_place(lag_joint *joint, lag_initialization *b, double **memory);

/* All rows and unknowns are those of the problem. */
void lag_joint_take_all(lag_joint *joint);
/* Scales of rows, and which unknowns they depend on, from the start values and points about them. `memory`: (all_rows, all) and parts of them */
void lag_joint_measure(lag_joint *joint, double *memory);
/* The model at y; parameters are prepared. */
void lag_joint_put(const lag_joint *joint, const double *y);
/* All rows there, in their scales. */
void lag_joint_residuals(const lag_joint *joint, const double *y, double *residual);
/* The rows and unknowns of the problem: for lag_equations. */
void lag_joint_evaluate(void *context, const lag_parts *parts, const double *y, double *residual, double *jacobian);

#endif
