/*
 * Derivatives of maps that the run carries out at an instant, along one direction, by central differences of the sixth order:
 *
 *     F' = (45 (F1 - F-1) - 9 (F2 - F-2) + (F3 - F-3)) / (60 h) ,   Fj = F(x + j h d) ,
 *
 * each from the same memory of the run, which is put back, so that nothing is remembered of what was tried. h is the longest of a few parts of the
 * natural sizes at which all neighbours end in the same modes and the differences of the fourth and the sixth order agree: maps that are linear, as
 * most blows are, keep all digits then. F has a derivative only where its slope on both sides is the same: 4 (F1 - 2 F0 + F-1) - (F2 - 2 F0 + F-2) is
 * -h^4 F'''' of a smooth map, twice the step of a slope, three times that of a value.
 *
 * Source: Fornberg, Math. Comput. 51 (1988) 699, table 1.
 */
#ifndef LAG_DIFFERENCES_H
#define LAG_DIFFERENCES_H

#include <float.h>
#include <math.h>

#include "lag/equations/motion.h"

struct lag_run;

/* Weights of the differences at one, two and three steps. */
enum { LAG_POINTS = 3 };
extern const double lag_sixth[LAG_POINTS];

/* Step as a part of natural sizes at which the error of the sixth order is about that of rounding, for functions that bend along these. */
static inline double lag_differences_step(void)
{
    return ldexp(1.0, -DBL_MANT_DIG / 6);
}

/* Shortest steps, as parts of natural sizes: for maps that are carried out to rounding, and for searches, which end within a tolerance. */
#define LAG_FINEST_STEP ldexp(1.0, -24)
#define LAG_FINEST_STEP_OF_SEARCH ldexp(1.0, -20)

/* A direction of the state and of what it depends on; null: not along these. */
typedef struct lag_displacement {
    double t;
    const double *x, *w, *u, *p, *until; /* (2 nq + nz) (nw) (nu) (np) (ncontact) */
} lag_displacement;

typedef struct lag_differences {
    struct lag_run *run;
    size_t bytes;            /* of the run that are kept, from its address on */
    unsigned char *kept;
    double *p;               /* (np) displaced parameters */
    const double *p_here;    /* those of the run */
    const double *p_sizes;   /* (np) */
    double *value[3][2];     /* values on both sides, */
    double *middle;          /* and between them */
    double *sixth;           /* a derivative */
    double h, finest;        /* step of the values; the shortest one that is tried, as a part of natural sizes */
    lag_inputs *inputs;      /* those of the caller, with their context, */
    void *context;
    const double *u;         /* shifted by so much along this (nu) */
    double by;
} lag_differences;

/* The values, for the run as it is now. LAG_ATTENTION: they belong to other modes. */
typedef lag_status lag_map(void *context, double *values);

/* Doubles for maps of at most `most` values of a run of the model. */
size_t lag_differences_memory(const lag_model *model, size_t most);
void lag_differences_place(lag_differences *d, const lag_model *model, size_t most, double *memory);

/* The run is as it is now at all places; listeners do not hear of what is tried. It ends with lag_differences_end(), which puts it back. */
void lag_differences_begin(lag_differences *d, struct lag_run *run, const double *p_sizes, double finest);
void lag_differences_end(lag_differences *d);
/* Puts it back to where it was at lag_differences_begin(), but for listeners. */
void lag_differences_restore(lag_differences *d);

/* Second derivative of value i, of the values at hand. */
double lag_differences_bend(const lag_differences *d, size_t i);

/* Size of the direction, in natural sizes. */
double lag_differences_extent(const lag_differences *d, const lag_displacement *along);
/* Shifts the inputs by so much along u (nu; null: nothing). */
void lag_differences_shift(lag_differences *d, const double *u, double by);

/*
 * The derivative (count) of `map` along `along`; `sizes` (count) are those of changes of order one of its values, *error what is left of it as a part of
 * these, for a change of order one of what it depends on. LAG_NOT_SMOOTH: there is none.
 */
lag_status lag_differences_along(lag_differences *d, const lag_displacement *along, size_t count, const double *sizes, lag_map *map,
    void *context, double *derivative, double *error);

#endif
