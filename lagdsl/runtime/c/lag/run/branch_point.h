/*
 * Branches that meet do so in a saddle of combinations u of the rows: u' J = 0 there. Its height, u' phi, is zero; where it is not, they miss
 * each other by as much and the motion turns away, however sharply.
 *
 * Any number of combinations may vanish at one place: all uprights of a row of parallelograms lie down together. The rows that do not vanish
 * are eliminated along directions that stay as they were at the first look (Lyapunov and Schmidt), so that an iteration costs
 * products of small matrices. The saddle is the same for all combinations: a few sums of them, with weights of both signs, decide where it is.
 *
 * Sources: Golubitsky and Schaeffer, Singularities and Groups in Bifurcation Theory I, 1985, section VII.1; Rheinboldt, Numerical Analysis
 * of Parametrized Nonlinear Equations, 1986.
 */
#ifndef LAG_BRANCH_POINT_H
#define LAG_BRANCH_POINT_H

#include <stddef.h>

#include "lag/model.h"

struct lag_run;

/* So many sums of combinations decide where a saddle is. */
enum { LAG_BRANCH_SUMS = 3 };

/* Time is a coordinate like others: N = nq + 1 of them. */
typedef struct lag_branch_point {
    struct lag_run *run;
    size_t general;                 /* independent rows in general, */
    size_t held, lost, open;        /* those that do not vanish, the others, directions that the first leave open */
    double t, pace;                 /* where time begins, and by how much its coordinate is smaller */
    double *origin, *state;         /* (2 nq + nz) where the search begins; another state */
    double *still;                  /* (nq) zeros */
    double *point, *step;           /* (N) */
    double *phi, *rows;             /* (nc) (nc, N) residuals and [J b], scaled */
    double *holding, *combinations; /* (nc, nc) combinations of rows that do not vanish; those that do, at the first look, */
    double *vanishing;              /* (nc, nc) and here */
    double *along, *free;           /* (nc, N) (N, N) directions of the first; those that they leave open, at the first look, */
    double *tangents;               /* (N, N) and here */
    double *moved;                  /* (nc, N) */
    double *inner, *transposed;     /* (nc, nc) factors of the rows that do not vanish, */
    double *pivot, *other_pivot;    /* (nc) */
    double *right, *back;           /* (nc), the way back onto the rows that do not vanish */
    double *slope;                  /* (nc, N) of the combinations that vanish along the tangents */
    double *sums;                   /* (LAG_BRANCH_SUMS, nc) weights */
    double *slopes, *bends;         /* (LAG_BRANCH_SUMS, N) (LAG_BRANCH_SUMS, N, N) first and second derivatives of the sums */
    double *normal, *vectors;       /* (N, N) */
    double *eigen, *wanted;         /* (N) */
    double *memory;                 /* of singular values */
} lag_branch_point;

/* Doubles for it. */
size_t lag_branch_point_memory(const lag_model *model);

void lag_branch_point_place(lag_branch_point *saddle, struct lag_run *run, double *memory);

/*
 * By how much branches miss each other at the saddle near the state x at time t, as a part of the sizes of the rows; infinite where there is
 * none. `general`: independent rows in general.
 */
double lag_branch_point_height(lag_branch_point *saddle, size_t general, double t, const double *x);

#endif
