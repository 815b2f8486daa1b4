/*
 * Functions of a model for several states at once, or for several directions of derivatives, in the lanes of vectors.
 *
 * Every array of a state's functions has its entries in groups of `lanes`: entry i of lane k is at i * lanes + k; `times`
 * stands for t. In functions of directions only directions and results are in groups. Operations and their order are those
 * of the functions of one state, so that every lane gets the same bits. All of it is compiled apart from the model, when
 * needed. Arrays on addresses that are multiples of 8 * lanes bytes are faster. `lanes` is 0, and nothing else there, where
 * the compiler has no vectors. Members that a model lacks are null; so may be those that nobody needs beside others.
 */
#ifndef LAG_PARALLEL_H
#define LAG_PARALLEL_H

#include "lag/model.h"

typedef struct lag_states {
    size_t lanes;
    size_t workspace; /* doubles that the functions need; prepare() fills the first ones */
    size_t width;     /* doubles in a register of the processor, as far as whoever made these functions knows */
    lag_status (*prepare)(const lag_arguments *at);
    lag_status (*dynamics)(const lag_arguments *at, double *mass, double *force, double *jacobian, double *gamma);
    lag_status (*elimination)(
        const lag_arguments *at,
        double *qdd,
        double *lam,
        double *response,
        double *lam_response,
        double *jacobian,
        double *gamma,
        double *pivot);
    /* null where there are no states z */
    lag_status (*state_derivative)(const lag_arguments *at, double *rates);
    /* null where nothing is watched */
    lag_status (*monitor)(const lag_arguments *at, double *invariant, double *scale, double *assertion);
} lag_states;

typedef struct lag_tangents {
    size_t lanes;
    size_t workspace; /* doubles that the functions need; prepare() of the model fills the first ones */
    size_t width;     /* as in lag_states */
    /* t q qd z u w p qdd lam: what all directions share, left in the workspace for the functions that follow */
    lag_status (*primal)(const lag_arguments *at);
    /* t q qd z u w p -> the same, and qdd (nq), lam (nc) and pivot as elimination() gives them. Stands for `primal` where it is
     * there: no multiplier is left to run time then. */
    lag_status (*motion)(const lag_arguments *at, double *qdd, double *lam, double *pivot);
    /* directions dq dqd dz du, or dp; M dqdd - J'dlam = -dr, J dqdd = -ds -> dr (nq), ds (nc) */
    lag_status (*residual)(const lag_arguments *at, double *motion, double *rows);
    /* the same -> dqdd (nq), dlam (nc) with the multipliers of kept rows held, ds (nk) of these; and what is left of the
     * smallest pivot. Where it is there, `residual` is so along states only, and only where the model tells lag_patterns.equations. */
    lag_status (*acceleration)(const lag_arguments *at, double *qdd, double *lam, double *rows, double *pivot);
    /* the same and dqdd dlam -> dzd (nz), dy (ny) */
    lag_status (*state_derivative)(const lag_arguments *at, double *rates);
    lag_status (*output)(const lag_arguments *at, double *y);
    /*
     * Of one state, without lanes: t q qd z u w p -> qdd (nq), lam (nc) and pivot as elimination() gives them, and the equations F of r, s and
     * zd differentiated there: response (nq + nz, nq + nc + nz), by_state (nq + nc + nz, 2 nq + nz + nu) by q, qd, z, u, by_parameter
     * (nq + nc + nz, np). Along a direction dx, dp, (dqdd, dzd) is response (by_state dx + by_parameter dp). Only where the model writes them out.
     */
    lag_status (*jacobian)(
        const lag_arguments *at, double *qdd, double *lam, double *pivot, double *response, double *by_state, double *by_parameter);
} lag_tangents;

#endif
