/*
 * Members of an instance, for its own files. Numbers that make up its state are in `held` and `kept`, without pointers, and
 * in the run; everything else follows from them.
 */
#ifndef LAG_PARTS_H
#define LAG_PARTS_H

#include "lag/derivatives.h"
#include "lag/instance/instance.h"
#include "lag/run.h"

/* Derivatives of inputs up to this order. */
enum { LAG_INPUT_ORDER = 3 };
enum { LAG_MESSAGE = 512 };

enum { LAG_ROLES = LAG_ROLE_CLOCK + 1 };
/* Of a set of roles. */
#define LAG_BIT(ROLE) (1U << LAG_ROLE_##ROLE)

/*
 * Values that follow from the present state are known by role: with multipliers go the accelerations of the model, in run->motion; those among
 * derivatives are pulled towards the constraints. Two more are not values of variables:
 */
enum {
    LAG_DERIVATIVES = LAG_ROLES, /* what directional derivatives need, in `derivatives`, */
    LAG_PULLED                   /* or what those of pulled accelerations do */
};

typedef struct lag_held {
    double t;               /* [s] the present */
    double start, stop;     /* of the experiment; infinite stop: none given */
    double tolerance;       /* of the importer, */
    double integration;     /* and of the run */
    double about;           /* time at which inputs are `course` */
    double left_at;         /* time of `left`, */
    double left_for;        /* and since inputs were set before that */
    int exchanged;          /* the importer sets the time: inputs are those of trial states until a step is accepted */
    double step;            /* LAG_OPTION_STEP */
    int implicit;           /* fixed steps are those of an implicit method; -1: not decided yet */
    int moving;             /* initialization has ended: states follow starts and parameters no longer */
    int prepared;           /* functions know the parameters */
    int initialized;        /* x follows from what was set */
    int jumped;             /* something was set since the motion went on: rates are others */
    int stopped;            /* the model has ended the simulation */
} lag_held;

/* Values that importers set until initialization ends. */
typedef struct lag_starts {
    double *values;       /* (2 nq + nz) start values that were set, */
    unsigned char *given; /* and flags: this one was */
    double *parameters;   /* (np) free ones are searched from these */
} lag_starts;

typedef struct lag_input_courses {
    double *course;       /* (LAG_INPUT_ORDER + 1, nu) inputs at `about` and their derivatives */
    double *left;         /* (nu) inputs on the left of the present, before any was set there */
    unsigned char *given; /* (nu) flags: this one was set */
} lag_input_courses;

/* Values of variables; those that follow from the present state as far as they are known. */
typedef struct lag_values {
    unsigned known; /* one bit for each role */
    double *of[LAG_ROLES];      /* arrays of all roles but constants and clocks */
    double *unasked;            /* (nc) multipliers of accelerations that are pulled */
    double energy[4], residual[2];
    double slip;                /* the largest residual of rates, each as a part of the rates of its component */
} lag_values;

struct lag_instance {
    const lag_fmu *fmu;
    lag_run *run;
    lag_held held;
    double *kept;           /* (kept_count) the arrays that follow up to `invariant_limits` */
    size_t kept_count;
    double *x;              /* (2 nq + nz) */
    double *p;              /* (np) those of the motion, found ones among them */
    lag_starts starts;
    lag_input_courses inputs;
    double *latched;        /* (guards) so far behind zero a guard that is not armed may go */
    double *armed;          /* (guards) time from which on it is armed; infinite: not yet */
    double *offsets;        /* (ndependent) constant parts of dependent coordinates, until the next event */
    double *invariant_limits; /* (ni) */
    lag_values values;
    lag_derivatives derivatives;
    double *warnings;         /* (na + nfail) 1: to be told */
    double *scratch;          /* of one call: states, and what their derivatives or a step of fixed length need */
    char message[LAG_MESSAGE];
};

/* ---- instance.c ---- */

/* Rate at which state derivatives reduce constraint residuals [1/s]: within a fiftieth of the experiment of the FMU. */
double lag_instance_rate(const lag_instance *instance);
/* The run anew, with the tolerance and the length of the experiment. */
void lag_instance_renew(lag_instance *instance);

/* ---- exchange.c ---- */

/* Offsets of dependent coordinates, those at the present state: behind an event. */
void lag_instance_tie(lag_instance *instance);
/* Dependent entries of x (2 nq + nz) follow from the states; without offsets x is a direction. */
void lag_instance_follow_states(const lag_fmu *fmu, const double *offsets, double *x);

/* ---- instance_messages.c ---- */

/* Says what went wrong and returns it. `format` as that of printf. */
lag_status lag_instance_fail(lag_instance *instance, lag_status status, const char *format, ...);

/* ---- instance_start.c ---- */

/* Change of the start along the direction in `derivatives`, written into its states. */
lag_status lag_instance_start_slopes(lag_instance *instance);

/* ---- variables.c ---- */

/* Lets the values of a role be known, or what derivatives need. */
lag_status lag_instance_evaluate(lag_instance *instance, unsigned role);
/* LAG_VIOLATED: an assertion does not hold now. Invariants begin anew: steps of importers, and of fixed length, have errors of their own. */
lag_status lag_instance_assert(lag_instance *instance);
/* By this factor the value of a variable is that of the model. */
double lag_instance_factor(const lag_instance *instance, lag_role role, size_t index);

/* ---- inputs.c ---- */

/* The inputs at time t, or their derivatives of this order, into u. */
void lag_instance_inputs_at(const lag_instance *instance, size_t order, double t, double *u);
/* Inputs whose derivatives are inputs, too, go as these say. */
void lag_instance_chain_inputs(lag_instance *instance);
/* The run knows the inputs. */
void lag_instance_set_run_inputs(lag_instance *instance);

/* LAG_POSITION_JUMP: an input that may not jump is off its derivatives, from what it was on the left of the present. */
lag_status lag_instance_follow_inputs(lag_instance *instance);
/* The inputs are those on the left of the present. */
void lag_instance_leave_inputs(lag_instance *instance);
/* The run is at the present state: where inputs have jumped, rates follow from the balance of momenta if these prescribe velocities. */
lag_status lag_instance_balance_inputs(lag_instance *instance);

/* ---- events.c ---- */

/* Indicators at the present state, into g. */
lag_status lag_instance_find_indicators(lag_instance *instance);
/* The present state is the one behind an event, with what began there; `status` is how that went. */
lag_status lag_instance_leave_event(lag_instance *instance, lag_status status);
/*
 * At the present state: onto the constraints; what was located there, and what inputs, parameters or a step of the importer have changed,
 * is carried out; clocks tick.
 */
lag_status lag_instance_carry_out(lag_instance *instance);

#endif
