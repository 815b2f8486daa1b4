/* One value of a model at one state, for callers that ask for it often: what a call needs is laid out once. */
#ifndef LAG_CALL_H
#define LAG_CALL_H

#include "lag/evaluate.h"
#include "lag/equations/jacobian.h"

/*
 * Arguments that the caller gives. Of what is left out, rates are zero, states and inputs are the initial ones, discretes those of the start with
 * relations as they stand, parameters the defaults.
 */
enum { LAG_GIVEN_QD = 1, LAG_GIVEN_Z = 2, LAG_GIVEN_U = 4, LAG_GIVEN_W = 8, LAG_GIVEN_P = 16 };

/* Values that are no function of the model by themselves. */
enum {
    LAG_CALL_SOLVE = LAG_LAST_FUNCTION + 1, /* qdd (nq), lam (nc): lag_forward_dynamics() */
    LAG_CALL_OUTPUT,                        /* y (ny) at these */
    LAG_CALL_RATES_JACOBIAN,                /* d(qd, qdd, zd)/dx (2 nq + nz, x.count): lag_jacobian() */
    LAG_CALL_OUTPUT_JACOBIAN                /* the same, then dy/dx (ny, x.count) */
};

/* Parameters that the workspace was prepared for. */
enum { LAG_PREPARED_NONE, LAG_PREPARED_DEFAULTS, LAG_PREPARED_GIVEN };

/* Everything points into memory of the caller. */
typedef struct lag_call {
    const lag_model *model;
    const lag_tangents *tangents; /* for Jacobians, or null */
    double *memory;               /* lag_jacobian_memory() */
    double *zero;                 /* (nq) zeros */
    double *start;                /* (2 nq + nz + nu) */
    double *standing;             /* (2 nw) */
    double *solved;               /* (nq + nc) */
    double *parameters;           /* (np) those of LAG_PREPARED_GIVEN */
    double *results;
    lag_arguments at;             /* what is given; and the workspace, lag_jacobian_workspace() */
    lag_range x;                  /* variables of Jacobians */
    int what;                     /* a lag_function, or one of the values above */
    int prepared;                 /* LAG_PREPARED_NONE at first */
    double started;               /* time of `start`, if it is known; not a number at first */
    size_t left;                  /* so many calls until one tells LAG_ATTENTION; 0: none does */
    size_t coordinate;            /* of the last singular state */
} lag_call;

/*
 * The value at the state that `at` points at, into `results`; `given` are the LAG_GIVEN that are there. Statuses of lag_evaluate(), lag_forward_dynamics()
 * and lag_jacobian(). LAG_ATTENTION: the value is there, and the count of calls has ended.
 */
lag_status lag_call_once(lag_call *call, int given);

#endif
