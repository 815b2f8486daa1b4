/*
 * The rest of the limits of friction where the motion does not determine the forces: for each group of rows that share undetermined forces the
 * largest least one
 *
 *     max s   subject to   J' d = 0,   norm(lam_t + d_t) + s size_t <= R_0(lam_n + d_n),   s size_n <= lam_n + d_n
 *
 * with lam the smallest forces (lag/optimization/margins.h). A contact is a side like friction: it bears its own force, and has no load.
 */
#ifndef LAG_RESERVE_H
#define LAG_RESERVE_H

#include "lag/contacts/friction.h"
#include "lag/equations/feedback.h"

typedef struct lag_reserve {
    lag_motion *motion;
    lag_frictions *frictions;
    double *forces, *residual; /* (nc, nq) (nc) rows of the present mode, with the loads that they bring along */
    double *tied, *looked;   /* (nq) sets of coordinates at which they act together, or share limits; 1: this one was looked at */
    double *place;           /* (nc) a coordinate of each row */
    double force_size;       /* the largest force of the rows of a group, as if they had unit length */
    double *length;          /* (nc) of each row; zero: it does not act */
    double *basis;           /* (undetermined, nc) multipliers in one set without effect, orthonormal as forces of unit rows; */
    size_t undetermined;     /* so many */
    double *group;           /* (nc) of each row; zero: it shares nothing, or does not act */
    double *empty;           /* (ncontact + nfriction) 1: with the forces that have the largest least reserve it has nothing left */
    lag_loads loads;         /* that forces bring along, as those of friction that slides */
    double *work;
} lag_reserve;

void lag_reserve_place(lag_reserve *reserve, lag_frictions *frictions, lag_layout *layout);

/* Fills frictions->reserve for what sticks, and of contacts that share forces with it, at the state that `motion` was solved at last, with frictions looked at. */
lag_status lag_reserve_evaluate(lag_reserve *reserve);

#endif
