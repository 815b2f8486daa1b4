/* Declarations that the files for the rates of a start share. */
#ifndef LAG_INITIAL_RATES_H
#define LAG_INITIAL_RATES_H

#include "lag/initial/initial_scaling.h"

/* Rates that conditions tie, as if they were alone. */
typedef struct lag_rates_part {
    size_t columns;      /* how many */
    double *block;       /* (most, nq) their conditions */
    double *v, *wanted;  /* (nq) */
    double *right;       /* (most) */
    double *free;        /* (nq, nq) rows: what is free still, */
    size_t width;        /* so many */
    double *other;       /* (nq, nq) */
} lag_rates_part;

/* Directions in rates, each of the coordinates of one part. */
typedef struct lag_directions {
    size_t count, end; /* so many, with so many numbers */
    double *part;      /* (nq) whose each is, */
    double *first;     /* (nq) and where its numbers begin, in the order of the columns of the part */
    double *numbers;   /* (nq, nq) */
} lag_directions;

/* Combinations of rows of J that vanish in a singular position. */
typedef struct lag_rates_branch {
    size_t lost;                 /* so many */
    double *part;                /* (nc) whose rows each combines, */
    double *first;               /* (nc) and where its numbers begin, in the order of those rows of the part that act */
    double *numbers;             /* (nc, nc) */
    double *acts;                /* (nc) flags of rows: 1: it acts */
    double *turned;              /* (nq, nc) */
    double *gamma;               /* (nc) */
    double *moved;               /* (nq) */
    const lag_directions *along; /* `free` or `unbound` */
    double *minimizer;
} lag_rates_branch;

typedef struct lag_rates {
    lag_initialization *b;
    size_t conditions;         /* how many: of J, of initial equations, of fixed rates */
    double *right;             /* (most) their right sides */
    double *fixed;             /* (nq) the coordinates of the fixed rates */
    double *v, *wanted;        /* (nq) rates in natural sizes */
    lag_directions free, unbound; /* what is free still, and what constraints and fixed rates leave */
    lag_parts parts;           /* of the conditions */
    double *place;             /* (nq) of each coordinate in its part */
    lag_rates_part its;        /* of one of them after the other */
    lag_rates_branch branch;
    double *part, *change, *force; /* (nq) */
    double *inner, *tied;      /* (nq, nq) M among free directions, and what lag_parts_memory() is for them */
    double *svd;
} lag_rates;

/* True if the start values satisfy all conditions. */
int lag_rates_are_satisfied(const lag_rates *r);
/* Initial equations that rates are to satisfy, behind the rows of J. */
size_t lag_rates_equations(const lag_rates *r);
/* J v + b = 0, the initial equations as they are near the rates of the start, and the fixed rates. */
void lag_rates_state_conditions(lag_rates *r, const double *x);
/* The rates that belong together. */
void lag_rates_find_parts(lag_rates *r);
/* The conditions of a part (rows, columns). */
void lag_rates_gather(const lag_rates *r, size_t which, double *block);

/* Row `row` of J in natural sizes, into the columns of its part (zeros before). */
void lag_rates_row(const lag_rates *r, size_t row, double *line);

/* x (nq) += by times a direction; a direction times x. */
void lag_rates_move(const lag_rates *r, const lag_directions *directions, size_t which, double by, double *x);
double lag_rates_product(const lag_rates *r, const lag_directions *directions, size_t which, const double *x);

/* The rest of the rates: what is free still is nearest to the wanted ones already; the change gets the least kinetic energy. */
void lag_initialization_least_energy(lag_rates *r);

/*
 * In a singular position J leaves rates free that lead off the constraints at once: not along any branch of the motion. The nearest that
 * do not are taken; written ones are kept if that is possible.
 */
void lag_initialization_branch(lag_rates *r);

#endif
