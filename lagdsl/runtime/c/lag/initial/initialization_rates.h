/* Declarations that the two files for the rates of a start share. */
#ifndef LAG_INITIALIZATION_RATES_H
#define LAG_INITIALIZATION_RATES_H

#include "lag/initial/initialization.h"

typedef struct lag_rates {
    lag_initialization *b;
    double *rows;              /* (nc, nq) J, natural sizes */
    double *table, *right;     /* (most + nq, nq) conditions on rates, M behind them; (most) right sides of the conditions */
    double *pattern;           /* (most + nq, nq) */
    size_t conditions;         /* how many: of J, of initial equations, of fixed rates */
    double *v, *wanted;        /* (nq) rates in natural sizes */
    double *free, *unbound;    /* (nq, nq) rows: what is free still, and what constraints and fixed rates leave */
    size_t width, unbound_width;
    lag_parts parts;           /* rates that conditions or M tie */
    double *block;             /* (most + nq, nq) `table` of a part */
    double *its_v, *its_wanted; /* (nq) of a part */
    double *its_right;         /* (most) */
    double *its_free, *other, *inner; /* (nq, nq) */
    size_t its_width, columns; /* of a part */
    double *part, *change;     /* (nq) */
    double *force, *gamma;     /* (nq) (nc) */
    double *act;               /* (nc) rows that act, */
    size_t acting;             /* so many */
    double *turned, *vanishing; /* (nq, acting) (lost, acting) */
    size_t lost;               /* combinations of rows that vanish */
    const double *along;       /* free or unbound, */
    size_t along_width;        /* with so many rows */
    double *minimizer, *svd;
} lag_rates;

/*
 * In a singular position J leaves rates free that lead off the constraints at once: not along any branch of the motion. The nearest that
 * do not are taken; written ones are kept if that is possible.
 */
void lag_initialization_branch(lag_rates *r);

#endif
