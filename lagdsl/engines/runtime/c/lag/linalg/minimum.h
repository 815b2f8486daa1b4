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
/* Difference of the polynomials through values at the places of a piece; *parabola: error of parabolas through three of them. */
double lag_piece_error(const double *values, double *parabola);

/* The error of values at the places of a piece, as a part of the largest of them. */
double lag_piece_doubt(const double *values);

/* The length of the next piece after one of length w whose values are known up to this part of them: it goes with the fourth power. */
double lag_piece_length(double w, double doubt);

/* The value at a place, with a context of the caller's; 1 ends the search. */
typedef int lag_minimum_function(void *context, double place, double *value);

/*
 * Looks for a minimum below zero between three places, where the function has `values`, known up to an error, and narrows them around it: 1 if a value ended
 * the search. A minimum may lie beyond an end whose value is below the error; not beyond a beginning at which an event has just occurred: `just`.
 */
int lag_minimum_search(lag_minimum_function *function, void *context, const double *places, const double *values, double error, int just);

#endif
