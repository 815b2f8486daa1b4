/*
 * The largest least margin of sides, each with a limit and a load of up to two components, affine functions of n unknowns y of either sign:
 *
 *     max s   subject to   norm(load_i(y)) + s size_i <= limit_i(y),   s <= 1
 *
 * by linear programs: a disc is met by tangents, four to begin with, and more where a solution is outside of it.
 */
#ifndef LAG_MARGINS_H
#define LAG_MARGINS_H

#include <stddef.h>

typedef struct lag_margins {
    size_t unknowns, sides;
    double *components; /* (sides) of loads: 0, 1 or 2 */
    double *size;       /* (sides) > 0 */
    double *forms;      /* (sides, 3, 1 + unknowns) the limit, and the components of the load: a number, and its changes with y */
    double *y;          /* (unknowns) */
    double *memory;
} lag_margins;

/* Doubles for so many sides, of which so many have loads. */
size_t lag_margins_memory(size_t unknowns, size_t sides, size_t loaded);

/* Without sides yet, in `memory`, for so many of them at most. */
lag_margins lag_margins_of(size_t unknowns, size_t most, double *memory);

/* One more, whose limit and loads are zero. Returns its forms. */
double *lag_margins_add(lag_margins *margins, size_t components, double size);

/* The margin of a side at y, not divided by its size. */
double lag_margin_of(const lag_margins *margins, size_t side);

/* The largest least margin, and y that has it. */
double lag_margins_solve(lag_margins *margins);

#endif
