/*
 * The past of some expressions: polynomials in Chebyshev's form, piece by piece. All expressions have the same pieces.
 * Source: Trefethen, Approximation Theory and Approximation Practice, chapters 3 and 7.
 */
#ifndef LAG_PIECES_H
#define LAG_PIECES_H

#include <stddef.h>

#include "lag/status.h"

/* Degree of a piece: that of the dense output of every method, at least; its coefficients; these, and a place beside the nodes. */
enum { LAG_DELAY_DEGREE = 8, LAG_DELAY_TERMS, LAG_DELAY_SAMPLES };
/* Pieces of which the run takes the memory. Where they do not suffice, neighbours become one if the tolerance admits it. */
enum { LAG_DELAY_PIECES = 4096 };
/* Jumps of derivatives of lower order are followed; level 0 is a jump of the value itself. */
enum { LAG_DELAY_SMOOTH = 10 };

/* Places in a piece, x in [-1, 1]: Chebyshev's nodes from the end to the beginning, then one beside them that judges the polynomial. */
extern const double lag_delay_places[LAG_DELAY_SAMPLES];

typedef struct lag_delay_pieces {
    size_t n;              /* expressions */
    size_t first, count;   /* pieces from `first` up to `count`; none: nothing has been */
    int level;             /* of the place at which the next one begins */
    double length;         /* what is older is not read any more [s] */
    double *begin, *order; /* (LAG_DELAY_PIECES + 1) where each begins, behind the last one where it ends; the level there */
    double *terms;         /* (LAG_DELAY_PIECES, n, LAG_DELAY_TERMS) */
    double *size;          /* (n) largest magnitudes so far */
    double *limit;         /* (n) errors that the tolerance admits */
    double *sample;        /* (LAG_DELAY_SAMPLES, n) the expressions in the next piece */
} lag_delay_pieces;

/* Doubles for n expressions. */
size_t lag_delay_pieces_memory(size_t n);
void lag_delay_pieces_place(lag_delay_pieces *pieces, size_t n, double *memory);

/* The end of the last piece. */
static inline double lag_delay_end(const lag_delay_pieces *pieces)
{
    return pieces->begin[pieces->count];
}

/* The last piece that begins at time t or before; the first one where none does. */
size_t lag_delay_piece(const lag_delay_pieces *pieces, double t);

/* Expression i in a piece at time t. */
double lag_delay_value(const lag_delay_pieces *pieces, size_t piece, size_t i, double t, double *rate);

/* Its second derivative. */
double lag_delay_bend(const lag_delay_pieces *pieces, size_t piece, size_t i, double t);

/* True if expression i jumps where a piece begins. */
int lag_delay_is_jump(const lag_delay_pieces *pieces, size_t piece, size_t i);

/*
 * `sample` as the next piece, up to `end`, tried: it counts if lag_delay_add() is called. `tolerance` is a part of the sizes. Returns the
 * largest error in parts of what that admits.
 */
double lag_delay_try(lag_delay_pieces *pieces, double tolerance, double end);
/* LAG_LONG_PAST: there is no place for another one. */
lag_status lag_delay_add(lag_delay_pieces *pieces);

/* Forgets pieces that begin at time t or later. */
void lag_delay_cut(lag_delay_pieces *pieces, double t);

#endif
