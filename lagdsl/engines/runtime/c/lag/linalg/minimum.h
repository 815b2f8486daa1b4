/*
 * Minima of a function of one variable that is known at a few places, and how well it is known between them: the difference of the polynomial of
 * degree three through four values and that of degree four through five.
 */
#ifndef LAG_MINIMUM_H
#define LAG_MINIMUM_H

enum { LAG_PIECE_SAMPLES = 5, LAG_LAST_SAMPLE = LAG_PIECE_SAMPLES - 1 };

/* Places of samples in a piece, as parts of it: no two distances are alike, so that no periodic function seems constant. */
static const double LAG_SAMPLE_PLACES[LAG_PIECE_SAMPLES] = {0.0, 0.2071, 0.4583, 0.7361, 1.0};
/* Values are known where the difference of the polynomials is at most this part of the largest of them. */
static const double LAG_KNOWN_PART = 0.1;
/* With each sample near a minimum it is known better, by this factor at most. */
static const double LAG_CLEARER = 0.25;

/* Three places and the values there. */
typedef struct lag_triple {
    double u[3], v[3];
} lag_triple;

static inline void lag_triple_put(lag_triple *at, int k, double u, double v)
{
    at->u[k] = u;
    at->v[k] = v;
}

/* Difference of the polynomials through values at the places of a piece; *parabola: error of parabolas through three of them. */
double lag_piece_error(const double *values, double *parabola);

/* The error of values at the places of a piece, as a part of the largest of them. */
double lag_piece_doubt(const double *values);

/* The length of the next piece after one of length w whose values are known up to this part of them: it goes with the fourth power. */
double lag_piece_length(double w, double doubt);

/*
 * True if a minimum of the values, known up to an error, may be below zero; *u and *height are place and value of the
 * minimum of a parabola. If that place lies beyond an end whose value is below the error, *u is a place beside that end, but
 * not beside a beginning at which an event has just occurred: `just`.
 */
int lag_minimum_of(const lag_triple *at, double error, int just, double *u, double *height);

/* Three samples around the minimum, of which that at u is one. */
void lag_minimum_narrow(lag_triple *at, double u, double v);

#endif
