/* A model as a first-order system: x = (q, qd, z), its accelerations those of lag/dynamics.h. */
#ifndef LAG_MOTION_H
#define LAG_MOTION_H

#include "lag/delays/delays.h"
#include "lag/dynamics.h"
#include "lag/ode.h"
#include "lag/parallel.h"

/* First entry of each group in the discretes w of a model; the counts are those of lag_model. */
typedef struct lag_places {
    size_t contact, impacts; /* (ncontact) each */
    size_t sticks, direction; /* (nfriction) (nslip) */
    size_t relation;         /* (nindicator) truths. Turned by event_sides.c; carried over by event_iteration.c, event_contacts.c, refraction.c */
    size_t timed;            /* (ntimed) */
    size_t delay, delay_rate; /* (ndelay) each */
    size_t condition, clock; /* up to `clock`; (nclock) */
    size_t initial, terminal; /* one entry each; nw where the model has none */
    size_t load;             /* (nload) up to the end */
} lag_places;

lag_places lag_places_of(const lag_model *model);

/* Clears what lasts for one pass only: clocks and instants. */
void lag_places_clear(const lag_places *places, double *w);

/* 1: relation i holds with this value of its indicator. */
static inline int lag_relation_holds(const lag_model *model, size_t i, double g)
{
    return g > 0.0 || (g == 0.0 && model->strict[i] == 0);
}

/* The inputs u (nu) at time t; `before`: where one jumps then, its value before the jump is wanted. */
typedef void lag_inputs(void *context, double t, int before, double *u);

/* Results with few entries, in what the model alone writes (lag_arguments.kept). */
typedef struct lag_written {
    double *gaps;                 /* (ngap, nq) of contact() */
    double *rows[2];              /* (nc, nq) J, of position_constraint(); of velocity_constraint() or dynamics(): whoever looks at it does so just before */
    double *mass;                 /* (nq, nq) M */
    double *sought;               /* (nc, nq) J in the problem of accelerations (lag/contacts/modes.h) */
} lag_written;

/*
 * Functions of several directions of derivatives, with what they work in. The model may be another filling of the same equations than that
 * of the motion.
 */
typedef struct lag_along {
    const lag_model *model;
    const lag_tangents *tangents; /* null: there are none */
    double *workspace, *memory;   /* lag_jacobian_workspace() and lag_jacobian_memory() doubles */
} lag_along;

/* Tells them when they are needed first; what it tells must stay. */
typedef void lag_provide_along(void *context, lag_along *told);

/* The way to the Jacobian of a large motion. */
typedef struct lag_motion_along {
    lag_provide_along *tell; /* null: one direction after the other */
    int asked, prepared;  /* it told; its workspace is that of the present parameters */
    lag_along told;
} lag_motion_along;

typedef struct lag_motion {
    const lag_model *model;
    lag_places places;   /* in w */
    lag_arguments at;    /* what was evaluated last; w and p stay until the caller changes them */
    lag_kept kept;       /* for results with few entries */
    double *u, *w;       /* (nu) (nw) */
    double *qdd, *lam;   /* (nq) (nc) at the state that was evaluated last */
    double *memory;      /* lag_jacobian_memory() without tangents */
    lag_written written;
    double *loads;       /* of models with loads that depend on accelerations or multipliers */
    lag_inputs *inputs;  /* null: u stays as it is */
    void *context;       /* of inputs, and of along.tell */
    lag_motion_along along;
    const double *sizes, *row_sizes; /* (nq) (nc) natural sizes, or both null: not known */
    lag_delays delays;
    double until;        /* from this time on inputs are those before a jump */
    lag_ode ode;         /* the system that the methods see; its context is this structure */
    size_t coordinate;   /* of the last singular state */
} lag_motion;

/* Numbers of a state. */
static inline size_t lag_motion_size(const lag_model *model)
{
    return 2 * model->nq + model->nz;
}

/* The system that the methods see, of no motion yet. */
lag_ode lag_motion_ode(const lag_model *model);

/* Doubles for a motion. */
size_t lag_motion_memory(const lag_model *model);

/* Lays out `motion` in `memory`, which is zero; u and w are zero, p the defaults. It must not be moved afterwards. */
void lag_motion_place(lag_motion *motion, const lag_model *model, double *memory);

/* The functions of several directions for the present parameters; without `tangents`, and then of the model itself: there are none, or `directions` are few. */
lag_along lag_motion_functions(lag_motion *motion, size_t directions);

/* Other parameters (np), which must stay: prepares the workspace. */
lag_status lag_motion_parameters(lag_motion *motion, const double *p);

/* The workspace for the parameters as they are now. */
lag_status lag_motion_prepare(lag_motion *motion);

/* The start values of the model into x, those of the inputs into u. Constraints and initial equations are not looked at. */
lag_status lag_motion_start(lag_motion *motion, double t, double *x);

/* The loads into w, as they are at the state, accelerations and multipliers of `at`. */
lag_status lag_motion_take_loads(lag_motion *motion, const lag_arguments *at);

/* Lets `at` be the state x at time t, inputs and delayed values included. */
void lag_motion_set_state(lag_motion *motion, double t, const double *x);

/* The same, with qdd and lam solved. */
lag_status lag_motion_solve(lag_motion *motion, double t, const double *x);

/* The same; qdd and lam are no numbers where there are none. */
void lag_motion_try(lag_motion *motion, double t, const double *x);

/* The same, where its rates xd may be known (or null). */
lag_status lag_motion_know(lag_motion *motion, double t, const double *x, const double *xd);

/* ---- linearization.c ---- */

/*
 * The equations linear about a state, which implicit methods decompose in a band: the entries that lag_patterns.equations tells, at the state x, its
 * accelerations and multipliers, of the equations with changed signs: -r, g - zd, -s. `context` is a lag_motion.
 */
lag_status lag_motion_linearize(void *context, double t, const double *x, double *entries);

#endif
