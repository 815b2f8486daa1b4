/* Declarations that the two files for the rates of a start share. */
#ifndef LAG_INITIAL_RATES_H
#define LAG_INITIAL_RATES_H

#include "lag/initial/initial_scaling.h"

/* Rates that conditions or M tie, as if they were alone. */
typedef struct lag_rates_part {
    size_t columns;      /* how many */
    double *block;       /* (most + nq, nq) their `table` */
    double *v, *wanted;  /* (nq) */
    double *right;       /* (most) */
    double *free;        /* (nq, nq) rows: what is free still, */
    size_t width;        /* so many */
    double *other;       /* (nq, nq) */
} lag_rates_part;

/* Combinations of rows that vanish in a singular position. */
typedef struct lag_rates_branch {
    double *act;         /* (nc) rows that act, */
    size_t acting;       /* so many; */
    size_t lost;         /* so many combinations of them vanish */
    double *vanishing;   /* (lost, acting) */
    double *turned;      /* (nq, acting) */
    double *gamma;       /* (nc) */
    const double *along; /* `free` or `unbound`, */
    size_t width;        /* with so many rows */
    double *minimizer;
} lag_rates_branch;

typedef struct lag_rates {
    lag_initialization *b;
    double *rows;              /* (nc, nq) J, natural sizes */
    double *table, *right;     /* (most + nq, nq) conditions on rates, M behind them; (most) right sides of the conditions */
    double *pattern;           /* (most + nq, nq) */
    size_t conditions;         /* how many: of J, of initial equations, of fixed rates */
    double *v, *wanted;        /* (nq) rates in natural sizes */
    double *free, *unbound;    /* (nq, nq) rows: what is free still, and what constraints and fixed rates leave */
    size_t width, unbound_width;
    lag_parts parts;
    lag_rates_part its;        /* of one of them after the other */
    lag_rates_branch branch;
    double *part, *change, *force; /* (nq) */
    double *inner;             /* (nq, nq) */
    double *svd;
} lag_rates;

/*
 * In a singular position J leaves rates free that lead off the constraints at once: not along any branch of the motion. The nearest that
 * do not are taken; written ones are kept if that is possible.
 */
void lag_initialization_branch(lag_rates *r);

#endif
