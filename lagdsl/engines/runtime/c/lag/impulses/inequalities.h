/*
 * Rows that push one way, and friction under them: gaps and slips, at one instant, at the level of rates or of accelerations. lag/optimization/friction_problem.h
 * has their law; here are the rows, and the momenta or forces that their impulses or forces are.
 */
#ifndef LAG_INEQUALITIES_H
#define LAG_INEQUALITIES_H

#include <math.h>

#include "lag/linalg/arena.h"
#include "lag/model.h"

/* The component of the coordinates that a row (nq) moves. */
static inline size_t lag_row_component(const lag_model *model, const double *row)
{
    size_t j = 0;
    while (j + 1 < model->nq && row[j] == 0.0) {
        ++j;
    }
    return model->components != NULL ? model->components[j] : 0;
}

/* The length of a slip, or of its force, of one component or of two. */
static inline double lag_slip_length(size_t components, const double *x)
{
    return components > 1 ? hypot(x[0], x[1]) : fabs(x[0]);
}

typedef struct lag_inequalities {
    size_t normals, frictions;
    size_t size;          /* normals + components of the slips, whose rows follow those of the normals */
    double *rows;         /* (size, nq) derivatives by qd */
    double *columns;      /* (size, nq) momenta or forces for unit forces of the rows: the rows, less what slips under them */
    double *speed;        /* (size) rates or accelerations to which impulses or forces add */
    double *gap, *restitution; /* (normals) the contact of each, or collision behind them */
    double *friction;     /* (frictions) which each is */
    double *components;   /* (frictions) 1 or 2, */
    double *slip;         /* (frictions) from this row on */
    double *limits;       /* (frictions) of friction, without the part that follows normal forces, */
    double *coefficients; /* (frictions, normals) and this part for unit ones */
    double *force;        /* (size) forces or impulses that were found, */
    double *after, *scale; /* (size) speeds with them, and the magnitudes of what these are sums of */
    double *compliance;   /* (size) what a unit force of each adds to its own speed */
    double *start, *first; /* (size) speeds before a blow, impulses of its compression */
} lag_inequalities;

void lag_inequalities_place(lag_inequalities *inequalities, const lag_model *model, lag_layout *layout);

/* None. Normals come first. */
void lag_inequalities_clear(lag_inequalities *inequalities);

/* One more normal, of this gap, with its row (nq). */
void lag_inequalities_add_normal(lag_inequalities *inequalities, size_t nq, size_t gap, const double *row, double speed, double restitution);

/* One more friction, with the rows (components, nq) of its slip. Its limit and coefficients are zero. */
void lag_inequalities_add_friction(lag_inequalities *inequalities, size_t nq, size_t friction, size_t components, const double *rows, const double *speed);

/* The gap of normal i, the friction that is number i of them. */
static inline size_t lag_gap_of(const lag_inequalities *inequalities, size_t i)
{
    return (size_t)inequalities->gap[i];
}

static inline size_t lag_friction_of(const lag_inequalities *inequalities, size_t i)
{
    return (size_t)inequalities->friction[i];
}

#endif
