#include "lag/linalg/minimum.h"

#include <math.h>

/* The largest difference of the two polynomials, as a part of the fourth divided difference, about. */
static const double DIFFERENCE = 0.03;
/* The error of a parabola through three samples, as a part of the third. */
static const double THIRD = 0.01;
/* Lengths of pieces change by at most these factors. */
static const double SAFETY = 0.8, LEAST_FACTOR = 0.1, MOST_FACTOR = 4.0;
/* A minimum that is so much nearer to zero than the values so far gets a sample. */
static const double NEARER = 0.3;
/* So many times its error a minimum may be lower than it seems. */
static const double LOWER = 2.0;
/* So far from an end, as a part of the distance to the next sample; below this part of the next value something has just happened. */
static const double BESIDE = 0.25, JUST = 1e-6;
/* A minimum nearer to the beginning than this part of the distance to the next sample is not told from one before it. */
static const double BEGINNING = 0.01;
/* With each sample near a minimum it is known better, by this factor at most; there are at most so many. */
static const double CLEARER = 0.25;
enum { LOOKS = 16 };

/* Three places and the values there. */
typedef struct triple {
    double u[3], v[3];
} triple;

double lag_piece_error(const double *values, double *parabola)
{
    double d[LAG_PIECE_SAMPLES];
    double third = 0.0;
    for (int k = 0; k < LAG_PIECE_SAMPLES; ++k) {
        d[k] = values[k];
    }
    for (int order = 1; order < LAG_PIECE_SAMPLES; ++order) {
        for (int k = LAG_LAST_SAMPLE; k >= order; --k) {
            d[k] = (d[k] - d[k - 1]) / (LAG_SAMPLE_PLACES[k] - LAG_SAMPLE_PLACES[k - order]);
        }
        third = order == LAG_LAST_SAMPLE - 1 ? fmax(fabs(d[LAG_LAST_SAMPLE]), fabs(d[LAG_LAST_SAMPLE - 1])) : third;
    }
    *parabola = DIFFERENCE * fabs(d[LAG_LAST_SAMPLE]) + THIRD * third;
    return DIFFERENCE * fabs(d[LAG_LAST_SAMPLE]);
}

double lag_piece_doubt(const double *values)
{
    double parabola = 0.0;
    double most = 0.0;
    for (int k = 0; k < LAG_PIECE_SAMPLES; ++k) {
        most = fmax(most, fabs(values[k]));
    }
    return most > 0.0 ? lag_piece_error(values, &parabola) / most : 0.0;
}

double lag_piece_length(double w, double doubt)
{
    const double factor = doubt > 0.0 ? SAFETY * pow(LAG_KNOWN_PART / doubt, 0.25) : MOST_FACTOR;
    return w * fmin(MOST_FACTOR, fmax(LEAST_FACTOR, factor));
}

/*
 * True if a minimum of the values, known up to an error, may be below zero; *u and *height are place and value of the minimum of a parabola. If that
 * place lies beyond an end whose value is below the error, *u is a place beside that end.
 */
static int minimum_of(const triple *at, double error, int just, double *u, double *height)
{
    const double *v = at->v;
    const double slope = (v[1] - v[0]) / (at->u[1] - at->u[0]);
    const double bend = ((v[2] - v[1]) / (at->u[2] - at->u[1]) - slope) / (at->u[2] - at->u[0]);
    const double vertex = 0.5 * (at->u[0] + at->u[1]) - 0.5 * slope / bend;
    const int inside = bend > 0.0 && vertex > at->u[0] + (just ? BEGINNING * (at->u[1] - at->u[0]) : 0.0) && vertex < at->u[2];
    const int first = v[0] < v[1] && v[0] < LOWER * error && (!just || v[0] > JUST * v[1]);
    const int last = v[2] < v[1] && v[2] < LOWER * error;
    *u = inside ? vertex
        : first ? at->u[0] + BESIDE * (at->u[1] - at->u[0])
                : at->u[2] - BESIDE * (at->u[2] - at->u[1]);
    *height = v[0] + (*u - at->u[0]) * (slope + bend * (*u - at->u[1]));
    return inside ? *height < fmax(NEARER * fmax(fmin(v[0], fmin(v[1], v[2])), 0.0), LOWER * error) : first || last;
}

static void put(triple *at, int k, double u, double v)
{
    at->u[k] = u;
    at->v[k] = v;
}

/* Three samples around the minimum, of which that at u is one. */
static void narrow(triple *at, double u, double v)
{
    const int before = u < at->u[1];
    if (v <= at->v[1]) {
        put(at, before ? 2 : 0, at->u[1], at->v[1]);
        put(at, 1, u, v);
    } else {
        put(at, before ? 0 : 2, u, v);
    }
}

int lag_minimum_search(lag_minimum_function *function, void *context, const double *places, const double *values, double error, int just)
{
    triple at = {{places[0], places[1], places[2]}, {values[0], values[1], values[2]}};
    double place = 0.0;
    double height = 0.0;
    for (int k = 0; k < LOOKS && minimum_of(&at, error, just, &place, &height); ++k) {
        double value = 0.0;
        if (function(context, place, &value)) {
            return 1;
        }
        error = fmax(fabs(value - height), CLEARER * error);
        narrow(&at, place, value);
    }
    return 0;
}
