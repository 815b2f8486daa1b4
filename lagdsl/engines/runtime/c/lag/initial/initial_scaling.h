/* Declarations that the files behind lag/initial.h share: start values with their weights, constraints in natural sizes. */
#ifndef LAG_INITIAL_SCALING_H
#define LAG_INITIAL_SCALING_H

#include "lag/initial.h"
#include "lag/initial/nearest_configuration.h"
#include "lag/linalg/svd.h"

/* Residuals, as a part of the row's size, below which a constraint counts as met. */
#define LAG_HOLDS 1e-7
/* Rows of J that are shorter than this part of the largest are zero but for round-off. */
static const double LAG_NO_ROW = 1e-12;
/* A part of J whose largest singular value is below this has no content but round-off. */
static const double LAG_CONTENT = 1e-3;

/* (2 nq + nz) the start values x, with flags of them and what they weigh. */
typedef struct lag_start_values {
    double *x;
    double *widths;          /* 1/sqrt(weight) */
    double *written, *fixed; /* flags */
} lag_start_values;

/* Coordinates and rates that initial equations tie. */
typedef struct lag_tied {
    unsigned char *joined; /* (nq) or null: 1: they decide this coordinate, with what they tie to it */
    const double *slopes;  /* (ne, nq) or null: how they change with rates, in natural sizes */
} lag_tied;

/* Inputs and discretes of the motion, set aside. */
typedef struct lag_set_aside {
    double *u, *w; /* (nu) (nw) */
} lag_set_aside;

typedef struct lag_initialization {
    lag_motion *motion;
    const lag_start *start;
    double t;
    size_t rows;                 /* of position level */
    double *row;                 /* (rows) which they are */
    lag_start_values starts;
    double *sizes, *row_sizes;   /* (2 nq + nz) (nc) natural ones */
    double *phi, *jacobian;      /* (nc) (nc, nq) as they were evaluated last */
    double *q, *qd, *z;          /* (nq) (nq) (nz) where the functions are asked */
    lag_set_aside aside;
    double *still;               /* (nq + nc) zeros */
    double *lengths;             /* lag_initialization_lengths() of rows at several points */
    double *largest;             /* (entries of J) their largest sizes */
    lag_tied equations;
    double *memory;              /* of each part in turn */
    lag_initial told;
} lag_initialization;

/* Rows of position level. */
size_t lag_initialization_rows(const lag_model *model);

/* Doubles without `memory`. */
size_t lag_initialization_memory(const lag_model *model);
void lag_initialization_place(lag_initialization *b, lag_motion *motion, double *memory);

/* Sizes, weights and discretes for the start values x at time t, of which those flagged in `set` (or null) were changed. */
lag_status lag_initialization_at(lag_initialization *b, const lag_start *start, const unsigned char *set, double t, const double *x);

/* Doubles for lengths of rows, and what finding their sizes needs of `memory`. */
size_t lag_initialization_lengths(const lag_model *model);
size_t lag_initialization_row_sizes_memory(const lag_model *model);

/*
 * Sizes of the rows, at the start values q and points about them, contacts closed; rows that are zero there are looked at with
 * other truths of the discretes. Rows that are zero but for the round-off of others have the size of the largest of their component.
 * LAG_INITIAL_SIZES: parameters that are not those of the model make a row so short that ranks would take it for round-off.
 */
void lag_initialization_find_row_sizes(lag_initialization *b, const double *q);

/* 1: the parameters are those of the model. */
int lag_initialization_has_defaults(const lag_initialization *b);

/* Parameters were changed: they are prepared, and discretes are those of the start with them. */
void lag_initialization_parameters(lag_initialization *b);

/* phi or J qd + b, and J, at q and qd of `b`; no numbers where there are none. */
void lag_initialization_positions(lag_initialization *b);
void lag_initialization_velocities(lag_initialization *b);

/* Point number `which` about q, ever wider apart, within the bounds of the coordinates; the same in every run. `seed` goes on. */
void lag_initialization_point(const lag_initialization *b, unsigned long long *seed, size_t which, const double *q, double *point);

/* A number of normal distribution, about. */
double lag_initialization_draw(unsigned long long *seed);

/* 1: rows that last, of contacts none, and are independent in general, are clearly so in J as it was evaluated last. */
int lag_initialization_is_regular(lag_initialization *b, double *memory);

/* The part of the largest singular value of a part's rows that is round-off, where it is `least` of rows with content. */
double lag_initialization_least(const lag_svd *svd, double least);

/* The block of a part of J as it was evaluated last, in natural sizes; `row`: the rows that are told apart, or null: all. */
void lag_initialization_gather(const lag_initialization *b, const lag_parts *parts, size_t which, const double *row, double *block);

/* Independent rows of J as it was evaluated last; `as_compiled`: those in general are those of the model. Both take lag_initialization_count_memory(). */
size_t lag_initialization_count(lag_initialization *b, int as_compiled, double *memory);
size_t lag_initialization_count_memory(const lag_model *model);

/* Independent ones of the rows (count, width), whose numbers stand in `matrix`; `memory`: lag_svd_memory(). None where one is no number. */
size_t lag_initialization_rank(size_t count, size_t width, const double *matrix, double *memory);

/* The parts of lag_initial_find(): each changes x or says in `told` what stands in the way. Their doubles. */
size_t lag_initialization_q_memory(const lag_model *model);
void lag_initialization_find_q(lag_initialization *b, double *x);
size_t lag_initialization_qd_memory(const lag_model *model);
void lag_initialization_find_qd(lag_initialization *b, double *x);
size_t lag_initialization_all_memory(const lag_model *model);
void lag_initialization_find_all(lag_initialization *b, double *x);
size_t lag_initialization_rank_memory(const lag_model *model);
/* Independent rows near x in general. */
void lag_initialization_find_rank(lag_initialization *b, const double *x);

#endif
