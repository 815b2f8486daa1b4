/*
 * Simulation of a model: steps with error control, projection onto the constraints after each of them, rows at requested times
 * from dense output, events located on it, clocks, and a watch over what must stay true.
 *
 *     lag_run_options options = {.tolerance = 1e-8, .count = 101, .times = times, .rows = rows};
 *     lag_run *run = lag_run_place(malloc(lag_run_size(&Model, &options)), &Model, &options);
 *     lag_status status = lag_run_begin(run, 0.0, NULL);
 *     if (status == LAG_OK) status = lag_run_to(run, 10.0, 0);
 *
 * All state of a run lies in the one block that the caller gives; nothing is allocated, nothing is global, so runs in different
 * threads do not know of each other. The model, the options' arrays and the parameters must outlive it.
 */
#ifndef LAG_RUN_H
#define LAG_RUN_H

#include "lag/methods/accuracy.h"
#include "lag/events/guards.h"
#include "lag/events/clock.h"
#include "lag/run/extremes.h"
#include "lag/events/instant.h"
#include "lag/equations/motion.h"
#include "lag/equations/projection.h"
#include "lag/equations/rank.h"
#include "lag/run/results.h"
#include "lag/run/singular_crossing.h"
#include "lag/run/turns.h"
#include "lag/stepper.h"
#include "lag/methods/stiffness.h"
#include "lag/run/conditions.h"

typedef struct lag_run lag_run;
struct lag_initial;

/* Causes of an instant: the start, guards that were located, clocks and time, inputs that jump, the end. */
typedef enum lag_cause_kind {
    LAG_CAUSE_START,
    LAG_CAUSE_GUARDS,
    LAG_CAUSE_TIME,
    LAG_CAUSE_INPUTS,
    LAG_CAUSE_END
} lag_cause_kind;

typedef struct lag_cause {
    lag_cause_kind kind;
    double h;              /* length of the step that led there */
    const double *changed; /* flags of guards, or null */
} lag_cause;

/* Functions of the caller, all with one context; null where nobody wants them. */
typedef struct lag_run_callbacks {
    void *context;
    lag_inputs *inputs; /* null: constant inputs */
    lag_provide_along *along; /* functions for Jacobians; asked once at most, by large models that need one */
    lag_status (*output)(void *context, lag_run *run, double t, const double *x); /* a row at one of `times` */
    lag_status (*tell)(void *context, lag_run *run, const lag_event_notice *notice); /* events of models with discretes, as they happen */
} lag_run_callbacks;

/* A watch over invariants and assertions. The arrays may be null, the block holds them then. */
typedef struct lag_run_invariants {
    const double *tolerance;      /* (ni) null: not watched */
    double *start, *size, *drift; /* (ni), as an earlier run left them where `continued` */
    int continued;
} lag_run_invariants;

typedef struct lag_run_options {
    double tolerance;         /* of the motion as a whole; 0: 1e-8 */
    const lag_method *method; /* null: lag_dop853, and lag_radau where stability would limit its steps */
    double h_first, h_most;   /* lengths of steps; 0: found by the method, without bound */
    double h_fixed;           /* that of methods which do not choose it */
    double part;              /* projection leaves residuals of this part of the tolerance; 0: 1e-3 */

    const double *p;          /* (np) parameters; null: the defaults */
    const double *u;          /* (nu) constant inputs; null: the defaults */
    lag_run_callbacks callbacks;

    lag_sizes sizes;     /* null: the run finds them at the first state */
    int careful;         /* 1: ranks are looked at, and singular positions crossed (lag/run/singular_crossing.h) */
    lag_lasting lasting;

    /*
     * A contact rests when less than a millionth of the `length` of the experiment is left of a series of impacts; 0: that of
     * the times, or as long as the run is let go.
     */
    double length;

    /* Rows: states (2 nq + nz) at `count` increasing times, where `rows` (count, 2 nq + nz) or a callback `output` is given. */
    size_t count;
    const double *times;
    double *rows;
    lag_results *results; /* whole rows at these times and at events, and what happens; null: not wanted */

    lag_run_invariants invariants;

    /*
     * Attributes of the start in the model, for lag_run_begin() without a state; null: start values move onto the
     * constraints, nothing else.
     */
    const lag_start *start;
    int zeroed; /* 1: the block is zero, as calloc gives it, so that pages of matrices that nobody asks for stay untouched */
} lag_run_options;

/* A change of the method. */
typedef struct lag_change {
    double t;
    int implicit; /* to an implicit one */
} lag_change;

enum { LAG_CHANGES = 16 };

/* Methods that the run has gone over to. */
typedef struct lag_methods {
    lag_stiffness stiffness;
    lag_change change[LAG_CHANGES];
    size_t changes;           /* all; the first LAG_CHANGES are kept */
} lag_methods;

/* A step of which what happens at its end is still to come. */
typedef struct lag_half {
    int open;            /* there is one */
    int own;             /* something happens at its end */
    int corner;          /* a corner is at its end */
    double t;            /* where that is; the end of the step where nothing happens */
    double length, next; /* of the step, as far as the method went; proposed for the next one */
    double left;         /* relations wait for the ticks at t: the time scale of what happens there; 0: none do */
    double *pending;     /* (nindicator + ncontact + nfriction) what happens at its end */
    double *waiting;     /* the same: what waits for the ticks there */
} lag_half;

/* Sizes of changes of order one; the arrays are those of the options, or the block's. */
typedef struct lag_run_sizes {
    int found;                       /* natural sizes are known */
    double *group, *natural, *cap;   /* (2 nq + nz) */
    double *rows;                    /* (nc) of the constraints */
} lag_run_sizes;

/* Ranks of the rows of the constraints, and where the motion crosses positions at which one is lost. */
typedef struct lag_run_ranks {
    lag_rank_estimate estimate;
    double *lasting;          /* (nc) rows that come and go, or depend on others, are 0 */
    unsigned char *dependent; /* (nc) */
    lag_singular singular;    /* where it goes across singular positions */
    const lag_method *behind; /* the method behind one */
} lag_run_ranks;

/* The state that could not be accepted. */
typedef struct lag_lost {
    double *x; /* (2 nq + nz) */
    double t;  /* infinite: none */
} lag_lost;

typedef struct lag_counts {
    size_t row;     /* the next one */
    size_t steps;   /* of this call */
    size_t events;  /* all */
    double begun;   /* time at which the run began */
    double entered; /* time at which it was put into its state from outside */
} lag_counts;

/* The one block of memory. */
typedef struct lag_block {
    double *memory;  /* (numbers) all arrays of the run, one after the other */
    size_t numbers;
    double *p;       /* (np) the parameters, where some are found with the start */
    double *initial; /* lag_initial_memory(), where there is a `start`; nothing of it is remembered */
} lag_block;

struct lag_run {
    lag_run_options options;
    lag_motion motion;
    lag_stepper stepper;
    lag_projection projection;
    lag_accuracy accuracy;
    lag_run_sizes sizes;
    lag_run_ranks ranks;
    lag_conditions conditions;
    lag_guards guards;
    lag_instants instants;
    lag_methods methods;
    lag_clock pace;   /* the ends of steps of fixed length, counted: nothing adds up */
    lag_clock *clock; /* (nclock) */
    lag_turns turns;
    lag_half half;
    lag_counts counts;
    lag_lost lost;
    lag_block block;
    double *point;    /* (2 nq + nz) */
    double *u_before; /* (nu) the inputs before a jump */
};

/* Time and cost of a run. */
typedef struct lag_run_report {
    double t, h, trouble_time;
    const double *x;            /* (2 nq + nz) */
    size_t row;                 /* rows recorded */
    size_t steps;               /* in the last call of lag_run_to; all others count from the beginning */
    lag_step_counts counts;
    size_t projections, events, changes;
    const double *w;            /* (nw) */
    const double *changed;      /* (nindicator + ncontact) 1: the relation, the contact that changed last */
    const double *guilty;       /* (nw) after LAG_EVENT_ITERATION_FAILED, LAG_CHATTER, LAG_PENETRATION, LAG_WAY_JUMP, 1: because of this one */
    const double *doubted;      /* (nindicator) first time at which a relation turned by what may be the method's error; infinite: none */
    size_t fault;               /* after LAG_CONFLICT a reset, after LAG_ASSERTION_FAILED an assertion of a clause */
    double next;                /* time of the next tick of the model's clocks; infinite: none */
    const lag_change *change;   /* the first LAG_CHANGES of them */
    int implicit;               /* the present method is */
} lag_run_report;

/* Bytes of the block for a run, and its layout; the block is aligned as malloc does. */
size_t lag_run_size(const lag_model *model, const lag_run_options *options);
/* Of these, the doubles that its arrays take, without those of which nothing is remembered. The first are the workspace of the model. */
size_t lag_run_numbers(const lag_model *model);
lag_run *lag_run_place(void *block, const lag_model *model, const lag_run_options *options);

/*
 * Starts at time t from x (2 nq + nz), or, where x is null, from the state that lag/initial.h finds from options.start. Clocks strike
 * if it is their instant; the row of this time is recorded. LAG_PROJECTION_FAILED: there is no such state.
 */
lag_status lag_run_begin(lag_run *run, double t, const double *x);

/*
 * The start values of the model at time t into x (2 nq + nz), for the parameters and inputs of the run; then from such values, of which those
 * flagged in `set` (or null) count as written, to a state that satisfies everything: lag_initial_find(), with what it tells. It must
 * have a `start`.
 */
lag_status lag_run_start(lag_run *run, double t, double *x);
lag_status lag_run_find(lag_run *run, double t, const unsigned char *set, double *x, struct lag_initial *told);

/*
 * Goes on from another state, as it is: x (null: the model's start values), with h as the length of the next step (0: to be found).
 * Nothing strikes, nothing is recorded.
 */
lag_status lag_run_move(lag_run *run, double t, const double *x, double h);

/*
 * For callers who step by themselves and leave events to the run, which must be at their state (lag_run_move): what happens at the start;
 * ticks that are due, and whether any would be at t.
 */
lag_status lag_run_enter(lag_run *run);
lag_status lag_run_ticks(lag_run *run);
int lag_run_due(const lag_run *run, double t);

/*
 * Inputs may have jumped at the present time, to which lag_run_to() led with those before: the blow of a speed that they prescribe, and
 * relations that are other now.
 */
lag_status lag_run_jump(lag_run *run);

/* Carries out the events of the end, once, when no further call follows: ticks that are due, then `terminal()`. */
lag_status lag_run_end(lag_run *run);

/* Flags (nc) of rows that depend on others with these parameters and starts (lag/initial.h), beside those that do so in any case. */
void lag_run_depend(lag_run *run, const unsigned char *dependent);

/*
 * On to `stop`, which is hit exactly, in at most so many steps (0: without bound); run->stepper.t and .x are the state then,
 * and at any failure the last good one. Ticks of the model at that very time are left to the next call, or to lag_run_end.
 * LAG_SINGULAR, LAG_NOT_FINITE: no accelerations just behind it; run->stepper.trouble.time tells where. LAG_STEP_TOO_SMALL,
 * LAG_TOO_LONG, LAG_PROJECTION_FAILED, LAG_BRANCH_POINT, LAG_VIOLATED: see lag/status.h. LAG_STOPPED: a `terminate` acted.
 * LAG_EVENT_ITERATION_FAILED and what follows it there: an event failed. Any status that a callback returns but LAG_OK is
 * returned.
 */
lag_status lag_run_to(lag_run *run, double stop, size_t most_steps);

/*
 * The same to each of `stops` (count) from number *passed on, with the changes of inputs that jump there (lag_run_jump). *passed counts them on, so that
 * a call behind LAG_TOO_LONG makes the rest. `most_steps` bounds those to a stop, and no other stop follows where there were as many in all.
 */
lag_status lag_run_over(lag_run *run, const double *stops, size_t count, size_t most_steps, size_t *passed);

/*
 * lag_run_to in pieces, for those who want to see the states within a step before anything happens at its end, and let steps lead
 * beyond what they want to see: the method starts at the present state, on the way to `stop`; one step, of which what is behind
 * the first that happens in it is of no use (run->half); that, and what else follows. A step that failed is taken back, and may be tried with another `stop`.
 */
lag_status lag_run_restart(lag_run *run, double stop);
lag_status lag_run_step(lag_run *run, double stop);
lag_status lag_run_finish(lag_run *run, double stop);

/*
 * One step of fixed length h (lag/fixed.h) with at most two iterations of projection: a bounded cost, no rows. Changes by inputs that were set since
 * the last one happen at its beginning (lag_run_jump). Where something has changed at its end, or time changes something within it, it is done again in
 * pieces, from event to event; ticks at its end belong to it. LAG_TOO_LONG: it takes too many pieces. `memory`: lag_fixed_memory() doubles.
 */
lag_status lag_run_fixed(lag_run *run, double h, lag_status (*step)(const lag_ode *, double, double, double *, double *),
    double *memory);

/* The end of a step of length h from the present; of one after the other, as a whole number of steps from the first. */
double lag_run_end_of_step(lag_run *run, double h);

/*
 * Between two calls: the functions of `model` from now on, another filling of the same equations, such as compiled C after a
 * tape. `workspace` (model->workspace) and the model must outlive the run. If both round alike, the motion is the same to the bit. LAG_BAD_STATE_DATA: it is another model.
 */
lag_status lag_run_change(lag_run *run, const lag_model *model, double *workspace);

void lag_run_tell(const lag_run *run, lag_run_report *report);

/* Why a run ended with a status that is not LAG_OK. */
typedef struct lag_fault {
    double t;         /* where it happened */
    const double *x;  /* (2 nq + nz) the state there */
    /*
     * LAG_SINGULAR: a coordinate whose acceleration is not determined. LAG_MOMENTUM_UNREACHABLE: one of which no rate has the momentum.
     * LAG_NOT_FINITE: the first number of x' that is none. LAG_STEP_TOO_SMALL: the number of x that changes fastest. LAG_PROJECTION_FAILED, LAG_POSITION_JUMP: the row of the constraints that is farthest off. LAG_BRANCH_POINT: the one that has
     * the largest share in the combination that vanishes. LAG_VIOLATED: an assertion, or behind all of them an invariant. LAG_CONFLICT:
     * a reset. LAG_ASSERTION_FAILED: an assertion of a clause. LAG_EVENT_ITERATION_FAILED, LAG_CHATTER, LAG_PENETRATION, LAG_WAY_JUMP: the first
     * entry of lag_run_report.guilty; of the last one, behind all entries, the reset of a state that places a mass elsewhere.
     */
    size_t which;
    double value, limit; /* LAG_PROJECTION_FAILED, LAG_POSITION_JUMP: the residual, in the unit of the row. LAG_VIOLATED: the drift of the invariant and what it may be */
} lag_fault;

void lag_run_explain(lag_run *run, lag_status status, lag_fault *fault);

/*
 * Accelerations and multipliers into run->motion, as rows have them: on singular positions the limits along the motion; what is not
 * determined is no number. `after_event`: x is the state after an event at that time.
 */
void lag_run_solve(lag_run *run, double t, const double *x, int after_event);

/*
 * Any function of the model (lag/evaluate.h) at x at time t, with the present discretes, inputs and parameters, accelerations and multipliers
 * solved, for outputs as in rows; results stand one after the other.
 */
lag_status lag_run_evaluate(lag_run *run, int which, double t, const double *x, double *results);

/* Independent rows at the present state, of those that last, and in general; where some are lost, the row with the largest share in that. They are
 * counted where the estimate of the rank does not show that none is lost. */
size_t lag_run_rank(lag_run *run, size_t *general, size_t *weakest);

/* A step to `stop` does not go beyond this time. */
double lag_run_limit(const lag_run *run, double stop);
/* True if the run will look at states within a step from here to t. */
int lag_run_reads_inside(const lag_run *run, double t);

/* For the parts of a run. */

/* Checks invariants and assertions at x at time t, where the rates are xd; null: not known. LAG_VIOLATED: this state violates one and is the last row. */
lag_status lag_run_watch(lag_run *run, double t, const double *x, const double *xd);
/* The state x at time t is lost: what lag_run_explain() tells of. */
void lag_run_lose(lag_run *run, double t, const double *x);

/* True if runs of the model cross singular positions by themselves. */
int lag_run_crosses(const lag_model *model, const lag_run_options *options);

/* The companion of the motion (lag/run/results.h); null: there is none. */
static inline lag_companion *lag_run_companion(const lag_run *run)
{
    return run->options.results != NULL ? run->options.results->companion : NULL;
}
/* Lets it happen now, if there is anything; the same without the companion. */
lag_status lag_run_instant(lag_run *run, const lag_cause *cause);
lag_status lag_run_carry(lag_run *run, const lag_cause *cause);

/* Keeps the past of delayed expressions up to time t in the last step. */
lag_status lag_run_keep_past(lag_run *run, double t);
/* Records the rows before time t, or up to it, from the last step; the next row, at its time t and state x. */
lag_status lag_run_rows(lag_run *run, double t, int up_to);
lag_status lag_run_row(lag_run *run, double t, const double *x);
/* Time of the next row; infinite: there is none. */
double lag_run_next_row(const lag_run *run);
/*
 * LAG_EVENT_PENDING: something happens within the last step, first at *t; run->guards.changed marks it
 * (see lag/run/scan.h).
 */
lag_status lag_run_happening(lag_run *run, double *t);
/*
 * Corners (run_corners.c). Steps end a moment before a corner; on a straight line over some roundings of time the run passes
 * it, so that no step has a corner inside. The scan looks at corners if the last step may have met one.
 */
lag_status lag_run_face_corners(lag_run *run);
/* lag_run_happening(), where what happens first is a corner at *corner; else at *own. Infinite: nowhere. */
lag_status lag_run_next_corner(lag_run *run, double *own, double *corner);
/* Time at which a step to a corner ends; below, true if the last step ended there. */
double lag_run_before_corner(const lag_run *run, double corner);
int lag_run_is_at_end(const lag_run *run, double corner);
/* True if a corner is so near ahead that no step gets there. */
int lag_run_meets_corner(lag_run *run);
/* Over a corner at the end of the last step, unless something is due before `limit`. */
void lag_run_pass_corner(lag_run *run, double limit);
/* The state on the constraints at a time within the last step. */
lag_status lag_run_inside(lag_run *run, double t, double *x);
/* The run goes back to a time within its last step, on the constraints to round-off: what is left of a rate would be an impact. */
lag_status lag_run_back(lag_run *run, double t);

#endif
