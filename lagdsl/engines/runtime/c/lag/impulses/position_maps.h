/*
 * Position maps: where masses and bodies are, as functions of q, t, z and w. They are continuous at every instant: positions do not jump.
 */
#ifndef LAG_POSITION_MAPS_H
#define LAG_POSITION_MAPS_H

#include "lag/equations/motion.h"
#include "lag/linalg/arena.h"

typedef struct lag_position_maps {
    lag_motion *motion;
    double *way;   /* (4 nway) */
    double *point; /* (2 nq + nz) */
} lag_position_maps;

void lag_position_maps_place(lag_position_maps *maps, lag_motion *motion, lag_layout *layout);

/*
 * LAG_WAY_JUMP if a map is elsewhere at x with the discretes of now than with `before` (nw) at `stood`, which is x with
 * the states z before the instant. Round-off is what the motion changes in a `moment` [s], as the instant is not known better, and that of
 * numbers of the size `peak` (2 nq + nz).
 */
lag_status lag_position_maps_continue(
    lag_position_maps *maps, double t, const double *x, const double *stood, const double *before, double moment, const double *peak);

#endif
