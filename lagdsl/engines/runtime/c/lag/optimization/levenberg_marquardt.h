/*
 * Damped Gauss-Newton for equations with more, fewer or dependent rows. Levenberg's damping with steps of minimum norm, so that dependent
 * rows and singular positions pass. Independent parts of the equations are damped, accepted and finished each for itself, at the same
 * time: a machine with a hundred loops has a hundred small problems, not one large one.
 *
 * Source: Nocedal and Wright, Numerical Optimization, 2nd ed., section 10.3.
 */
#ifndef LAG_LEVENBERG_MARQUARDT_H
#define LAG_LEVENBERG_MARQUARDT_H

#include <stddef.h>

#include "lag/linalg/linalg.h"

/* Numbers of rows and columns are kept as doubles: a workspace is of one type. */
typedef struct lag_parts {
    size_t m, n, count;                 /* rows, columns, parts */
    double *row_part, *column_part;     /* (m) (n) which part it belongs to */
    double *row, *column;               /* (m) (n) ordered by parts */
    double *first_row, *first_column;   /* (count + 1) where those of a part begin, room for m + n + 1 */
    double *first_entry;                /* (count + 1) the same of its block (rows, columns) in a matrix of all parts */
} lag_parts;

/* Iterations that descend to round-off. */
enum { LAG_DESCENTS = 100 };
/* A step for central differences of such equations. */
static const double LAG_DIFFERENCE = 1e-6;

/*
 * Equations, scaled to be of order one: residual (m) and Jacobian at x (n), which is written part by part: the block of each one begins at
 * its `first_entry`, rows and columns in the order of the part. So memory grows with the parts, not with their square. Values that do
 * not exist are not numbers.
 */
typedef struct lag_equations {
    void (*evaluate)(void *context, const lag_parts *parts, const double *x, double *residual, double *jacobian);
    void *context;
} lag_equations;

typedef struct lag_levenberg_marquardt {
    double *residual, *jacobian; /* (m) (entries of the parts) where it ended */
    double *sizes;               /* (m + n) norms of the residuals of each part, infinite where one is no number */
    double *other, *others_jacobian, *other_sizes;
    double *trial;               /* (n) */
    double *damping, *active;    /* (m + n) */
    double *right, *part;        /* (m) (n) */
    double *svd;
} lag_levenberg_marquardt;

/* Doubles for parts of m rows and n columns. */
size_t lag_parts_memory(size_t m, size_t n);

/* Every column of `pattern` (m, n), 0 where an entry vanishes everywhere, in a part with the rows it shares entries with. Null: one part. */
lag_parts lag_parts_of(size_t m, size_t n, const double *pattern, double *memory);

/* The same for entries that are told one by one: at first every row and column is a part of its own. */
lag_parts lag_parts_begin(size_t m, size_t n, double *memory);
void lag_parts_join(lag_parts *parts, size_t row, size_t column);
void lag_parts_end(lag_parts *parts);

/* Fills what follows from the parts of rows and columns and their count. */
void lag_parts_order(lag_parts *parts);

/* x (n) becomes `point` in the chosen parts (flags). */
void lag_parts_mix(const lag_parts *parts, const double *chosen, const double *point, double *x);

/* Rows of a part, and where its first stands in `row`; the same of columns. */
static inline size_t lag_parts_rows(const lag_parts *parts, size_t which, size_t *first)
{
    *first = (size_t)parts->first_row[which];
    return (size_t)parts->first_row[which + 1] - *first;
}

static inline size_t lag_parts_columns(const lag_parts *parts, size_t which, size_t *first)
{
    *first = (size_t)parts->first_column[which];
    return (size_t)parts->first_column[which + 1] - *first;
}

/* The entries of all parts. */
static inline size_t lag_parts_entries(const lag_parts *parts)
{
    return (size_t)parts->first_entry[parts->count];
}

/* The block of a part in a matrix of all parts. */
static inline double *lag_parts_block(const lag_parts *parts, size_t which, double *matrix)
{
    return matrix + (size_t)parts->first_entry[which];
}

/* The entries of a matrix with `width` columns that are a part's, tightly packed. Returns 0 where one is no number. */
int lag_parts_gather(const lag_parts *parts, size_t which, size_t width, const double *matrix, double *block);

/* Euclidean norm of each part's entries of x: (m) of rows, (n) of columns; infinite where one is no number. */
void lag_parts_norms(const lag_parts *parts, int of_rows, const double *x, double *norms);

/* Doubles for parts of m rows and n columns at most. */
size_t lag_levenberg_marquardt_memory(size_t m, size_t n);
void lag_levenberg_marquardt_place(lag_levenberg_marquardt *minimizer, const lag_parts *parts, double *memory);

/*
 * Reduces the residuals from `point` (n) on, which becomes the result, until they are below `target`, stall or `iterations` are used up;
 * below `target` it goes on as long as whole steps halve them.
 */
void lag_descend(lag_levenberg_marquardt *minimizer, const lag_equations *equations, const lag_parts *parts, double target, unsigned iterations,
    double *point);

/* Euclidean norm of all residuals where it ended; infinite where one is no number. */
double lag_levenberg_marquardt_size(const lag_levenberg_marquardt *minimizer, const lag_parts *parts);

#endif
