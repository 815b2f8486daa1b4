/* What the parts of lag/initial.h share: the start values with their weights, and the constraints in natural sizes. */
#ifndef LAG_BEGINNING_H
#define LAG_BEGINNING_H

#include "lag/initial.h"
#include "lag/nearest.h"

/* Residuals, as a part of the row's size, below which a constraint counts as met. */
#define LAG_HOLDS 1e-7

typedef struct lag_beginning {
    lag_motion *motion;
    const lag_start *start;
    double t;
    size_t rows;                 /* of position level */
    double *row;                 /* (rows) which they are */
    double *x;                   /* (2 nq + nz) the start values */
    double *sizes, *row_sizes;   /* (2 nq + nz) (nc) natural ones */
    double *widths;              /* (2 nq + nz) 1/sqrt(weight) */
    double *written, *fixed;     /* (2 nq + nz) flags */
    double *phi, *jacobian;      /* (nc) (nc, nq) */
    double *q, *qd, *z;          /* (nq) (nq) (nz) where the functions are asked */
    double *u, *w;               /* (nu) (nw) set aside */
    double *still;               /* (nq + nc) zeros */
    double *lengths;             /* of rows at several points */
    double *pattern;             /* (nc, nq) 1: the entry of J is not zero everywhere */
    unsigned char *joined;       /* (nq) or null: 1: initial equations decide this coordinate, with what they tie to it */
    const double *slopes;        /* (ne, nq) or null: how initial equations change with rates, in natural sizes */
    double *memory;              /* of each part in turn */
    lag_initial told;
} lag_beginning;

/* Doubles without `memory`. */
size_t lag_beginning_memory(const lag_model *model);
void lag_beginning_place(lag_beginning *b, lag_motion *motion, double *memory);

/* Sizes, weights and discretes for the start values x at time t, of which those flagged in `set` (or null) were changed. */
lag_status lag_beginning_at(lag_beginning *b, const lag_start *start, const unsigned char *set, double t, const double *x);

/* Parameters were changed: they are prepared, and discretes are those of the start with them. */
void lag_beginning_parameters(lag_beginning *b);

/* phi or J qd + b, and J, at q and qd of `b`; no numbers where there are none. */
void lag_beginning_positions(lag_beginning *b);
void lag_beginning_velocities(lag_beginning *b);

/* Point number `which` about q, ever wider apart, within the bounds of the coordinates; the same in every run. `seed` goes on. */
void lag_beginning_point(const lag_beginning *b, unsigned long long *seed, size_t which, const double *q, double *point);

/* A number of normal distribution, about. */
double lag_beginning_draw(unsigned long long *seed);

/* Independent ones of the rows (count, width), whose numbers stand in `matrix`; `memory`: lag_svd_memory(). None where one is no number. */
size_t lag_beginning_rank(size_t count, size_t width, const double *matrix, double *memory);

/* The parts of lag_initial_find(): each changes x or says in `told` what stands in the way. Their doubles. */
size_t lag_beginning_q_memory(const lag_model *model);
void lag_beginning_find_q(lag_beginning *b, double *x);
size_t lag_beginning_qd_memory(const lag_model *model);
void lag_beginning_find_qd(lag_beginning *b, double *x);
size_t lag_beginning_all_memory(const lag_model *model);
void lag_beginning_find_all(lag_beginning *b, double *x);
size_t lag_beginning_rank_memory(const lag_model *model);
/* Independent rows near x in general. */
void lag_beginning_find_rank(lag_beginning *b, const double *x);

#endif
