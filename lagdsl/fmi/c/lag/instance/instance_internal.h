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

typedef enum lag_phase {
    LAG_PHASE_START,  /* until initialization ends: states follow starts and parameters */
    LAG_PHASE_MOTION
} lag_phase;

/* Values that are known at the present state: one bit each. */
enum {
    LAG_KNOWN_MOTION = 1,    /* accelerations and multipliers of the model, in run->motion */
    LAG_KNOWN_RATES = 2,     /* derivatives, those of rates pulled towards the constraints */
    LAG_KNOWN_OUTPUTS = 4,
    LAG_KNOWN_LOCALS = 8,
    LAG_KNOWN_ENERGIES = 16,
    LAG_KNOWN_RESIDUALS = 32,
    LAG_KNOWN_INDICATORS = 64,
    LAG_KNOWN_DERIVATIVES = 128, /* what derivatives need, in `derivatives`, */
    LAG_KNOWN_PULLED = 256       /* or what those of pulled accelerations do */
};

typedef struct lag_held {
    double t;               /* [s] the present */
    double start, stop;     /* of the experiment; infinite stop: none given */
    double tolerance;       /* of the importer, */
    double integration;     /* and of the run */
    double last, span;      /* time of the last completed step, and its length */
    double latched_at;      /* time at which `latched` were taken */
    double about;           /* time at which inputs are `course` */
    double followed;        /* time of the last point of `paths`, */
    int following;          /* if there is one; importers that set the time have none */
    double left_at;         /* time of `left`, */
    double left_for;        /* and since inputs were set before that */
    int exchanged;          /* the importer sets the time: inputs are those of trial states until a step is accepted */
    double step;            /* LAG_OPTION_STEP */
    int implicit;           /* fixed steps are those of an implicit method; -1: not decided yet */
    double limit;           /* of residuals; an importer that keeps to it asks for projections now and then, and no more */
    double since;           /* completed steps since the last projection */
    lag_phase phase;
    int prepared;           /* functions know the parameters */
    int initialized;        /* x follows from what was set */
    int jumped;             /* something was set since the motion went on: rates are others */
    int polynomial;         /* inputs have derivatives */
    int entered;            /* event mode: nothing has been looked at yet */
    int tied;               /* `offsets` belong to the present state */
    int stopped;            /* the model has ended the simulation, */
    size_t ending;          /* by this `terminate` */
} lag_held;

/* An input on its path at a communication point. */
typedef struct lag_path {
    double value, rate, acceleration;
} lag_path;

struct lag_instance {
    const lag_fmu *fmu;
    lag_run *run;
    lag_held held;
    double *kept;           /* (kept_count) the arrays that follow up to `offsets` */
    size_t kept_count;
    double *x;              /* (2 nq + nz) */
    double *p;              /* (np) those of the motion, found ones among them */
    double *guess;          /* (np) those that were set: free ones are searched from them */
    double *begin, *given;  /* (2 nq + nz) start values that were set, and flags: this one was */
    double *course;         /* (LAG_INPUT_ORDER + 1, nu) inputs at `about` and their derivatives */
    double *given_inputs;   /* (nu) flags: this one was set */
    lag_path *paths;        /* (nu) */
    double *left;           /* (nu) inputs on the left of the present, before any was set there */
    double *largest;        /* (ncorner) magnitudes of distances of corners seen since they stand as they do */
    double *latched;        /* (relations, contacts, corners) what is nearer to zero than this had changed already at the last event */
    double *widened;        /* (relations, contacts) factors of margins, beyond one: errors of the importer, as events without effect tell */
    double *resting;        /* (relations) those that rest at zero at the last event are known to this only; zero: it moves */
    double *side;           /* (ncorner) 1, -1: the side of zero on which the distance of this corner was at the last event; 0: none yet */
    double *offsets;        /* (ndependent) constant parts of dependent coordinates, until the next event */
    /* what follows from these */
    unsigned known;
    double *xd, *y, *local, *g; /* (2 nq + nz) (ny) (nd) (indicators) */
    double *room;           /* (relations, contacts, corners) what is left until each changes; negative: it has changed */
    double *far;            /* (ncorner) distances of corners, as looked at last */
    double *unasked;        /* (nc) multipliers of accelerations that are pulled */
    double *point, *tangent; /* (2 nq + nz) */
    double *entry;          /* as many as the longest variable has */
    double energy[4], residual[2];
    double slip;            /* the largest residual of rates, each as a part of the rates of its component */
    double *invariant_limits;   /* (ni) */
    unsigned char *written;     /* (2 nq + nz) 1: this start was set */
    double *initial_memory;     /* lag_initial_memory() */
    double *fixed_memory;   /* lag_fixed_memory() */
    lag_derivatives derivatives;
    double *slopes;         /* lag_instance_slopes() */
    char message[LAG_MESSAGE];
};

/* Numbers of its state, and of the present inputs. */
static inline size_t lag_instance_order(const lag_instance *instance)
{
    return lag_motion_size(instance->fmu->model);
}

/* Options that determine the size of a run. */
static inline lag_run_options lag_instance_plan(void)
{
    return (lag_run_options){.careful = 1};
}

/* ---- instance.c ---- */

/* Number of relations, contacts and corners. */
static inline size_t lag_instance_watched(const lag_fmu *fmu)
{
    return fmu->model->nindicator + fmu->model->ncontact + fmu->model->ncorner;
}

/* Doubles of `kept`. */
size_t lag_instance_kept(const lag_fmu *fmu);
/* Rate at which state derivatives reduce constraint residuals [1/s]: within a fiftieth of the experiment of the FMU. */
double lag_instance_rate(const lag_instance *instance);
/* The run anew, with the tolerance and the length of the experiment. */
void lag_instance_renew(lag_instance *instance);

/* ---- dependent_coordinates.c ---- */

/* Offsets of dependent coordinates at the present state, unless they are known. */
void lag_instance_tie(lag_instance *instance);
/* Dependent entries of x follow from the states; lag_instance_tie() comes before these are changed. */
void lag_instance_follow_states(lag_instance *instance);
/* The same in a direction x (2 nq + nz) from a state. */
void lag_instance_follow_direction(const lag_fmu *fmu, double *x);
/* Entries of x (2 nq + nz) that are states of the FMU. */
void lag_instance_gather_states(const lag_fmu *fmu, const double *x, double *states);

/* ---- instance_messages.c ---- */

/* Says what went wrong and returns it. `format` as that of printf. */
lag_status lag_instance_fail(lag_instance *instance, lag_status status, const char *format, ...);
/* The same in the words of the runtime; LAG_OK stays. */
lag_status lag_instance_judge(lag_instance *instance, lag_status status);
/* If `status` is that of a `terminate`, notes that the simulation ends, with its message. */
void lag_instance_note_stop(lag_instance *instance, lag_status status);

/* ---- instance_start.c ---- */

/* In the start phase: the state that follows from what was set, with what happens there. */
lag_status lag_instance_settle(lag_instance *instance);

/* ---- lazy_evaluation.c ---- */

/* Functions know the parameters, states follow from the starts. */
lag_status lag_instance_ready(lag_instance *instance);
/* Lets all of these be known. */
lag_status lag_instance_know(lag_instance *instance, unsigned what);
/* LAG_VIOLATED: an assertion does not hold at x at time t. */
lag_status lag_instance_assert(lag_instance *instance, double t, const double *x);

/* ---- corner_indicators.c ---- */

/* The first corner among all that is watched: they come after relations and contacts. */
static inline size_t lag_instance_first_corner(const lag_instance *instance)
{
    return instance->fmu->model->nindicator + instance->fmu->model->ncontact;
}

/* Room of corners at x at time t. */
lag_status lag_instance_look_at_corners(lag_instance *instance, double t, const double *x, double *room);
/* An event at x at time t: corners that have been passed are on the other side from now on. */
lag_status lag_instance_face_corners(lag_instance *instance, double t, const double *x);
/* The importer is at the state looked at last: magnitudes follow. */
void lag_instance_pass_corners(lag_instance *instance);

/* ---- variables.c ---- */

/* By this the value of a variable is that of the model. */
double lag_instance_factor(const lag_instance *instance, lag_role role, size_t index);

/* ---- directional.c ---- */

/* Doubles of `slopes`. */
size_t lag_instance_slopes(const lag_model *model);

/* ---- start_derivatives.c ---- */

/*
 * Change of the start along the direction in `derivatives`, written into its states; below, the doubles of `slopes` that
 * this takes.
 */
lag_status lag_instance_start_slopes(lag_instance *instance);
size_t lag_instance_start_slopes_memory(const lag_model *model);

/* ---- input_polynomials.c ---- */

/* The inputs at time t, into u. */
void lag_instance_inputs_at(const lag_instance *instance, double t, double *u);
/* The course of the inputs about t, so that their values can be set there. */
void lag_instance_inputs_about(lag_instance *instance, double t);
/* Values of so many inputs at the present. */
void lag_instance_set_inputs(lag_instance *instance, size_t first, size_t count, const double *values);
/* Inputs whose derivatives are inputs, too, go as these say. */
void lag_instance_chain_inputs(lag_instance *instance);
/* The run knows the inputs. */
void lag_instance_tell_inputs(lag_instance *instance);

/* ---- input_paths.c ---- */

/*
 * The inputs of a communication point are set: LAG_POSITION_JUMP if one that may not jump is off its derivatives since the last point, or jumps at an
 * instant. Where an importer sets the time, only the latter is judged.
 */
lag_status lag_instance_follow_inputs(lag_instance *instance);

/* The inputs are those on the left of the present. */
void lag_instance_leave_inputs(lag_instance *instance);
/*
 * The run is at the present state, and inputs have jumped: rates follow if these prescribe velocities, as far as the balance of
 * momenta tells.
 */
lag_status lag_instance_balance_inputs(lag_instance *instance);

/* ---- event_indicators.c ---- */

/* Relations and contacts, in this order. */
size_t lag_instance_crossing_count(const lag_instance *instance);
/* Their values at x at time t; then value number `which`, which passes zero downward when the relation or contact changes. */
lag_status lag_instance_look_at_crossings(lag_instance *instance, double t, const double *x);
double lag_instance_crossing_value(const lag_instance *instance, size_t which);
/* Round-off of that, as far as it is known: more than zero. */
double lag_instance_round_off(const lag_instance *instance, size_t which);
/* The dead band around zero: round-off, or more for an importer whose errors have shown. */
double lag_instance_margin(const lag_instance *instance, size_t which);
/* An event at this value had no effect: the importer is less exact than it has told. */
void lag_instance_widen(lag_instance *instance, size_t which);
/* 1: a relation that changes where its value is zero: `>=` or `<=` that does not hold, `>` or `<` that does. */
int lag_instance_changes_at_zero(const lag_instance *instance, size_t which);
/* The value with its margin, which passes zero where an importer is to have the event. */
double lag_instance_room(const lag_instance *instance, size_t which);
/* Indicators at the present state, into g. */
lag_status lag_instance_find_indicators(lag_instance *instance);
/* 1: a relation that the motion does not change. */
int lag_instance_is_held(const lag_instance *instance, size_t which);
/* Sign of an indicator while nothing changes: 1, or -1 for relations that do not hold and corners that are below zero. */
double lag_instance_side(const lag_instance *instance, size_t which);
/* A value that is behind zero now is no event until it goes further. */
lag_status lag_instance_latch(lag_instance *instance, double t, const double *x);
/* Releases values that are farther from zero than their margin; updates the magnitudes. */
lag_status lag_instance_release(lag_instance *instance);

/* ---- event_mode.c ---- */

/*
 * At the present state: onto the constraints; what was located there, and what inputs, parameters or a step of the importer have changed,
 * is carried out; clocks tick.
 */
lag_status lag_instance_carry_out(lag_instance *instance);

#endif
