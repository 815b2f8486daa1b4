/*
 * Forward sensitivities: how a motion changes with parameters, inputs and start values. A column s = dx/da of each of them goes with the state,
 *
 *     s' = f_x s + f_a ,
 *
 * by the exact Jacobians of the model and by the method of the state itself, stage by stage, so that it is the derivative of the computed
 * motion; a step is accepted where its error is within the tolerance relative to the column, too. Behind a step it satisfies the linearized
 * constraints, as the state does the constraints. At an instant, whose time tau changes by dtau = -(g_x s + g_a) / (g_x f + g_t) of the guard
 * g that leaves its mode, or as clocks and parameters say,
 *
 *     s+ = dR (s + f- dtau, dtau, a) - f+ dtau ,
 *
 * with the rates f- and f+ before and behind it by the equations, and R all that the run does there: impulses with friction, clauses, changes of
 * mode. R is differentiated as a whole (lag/sensitivities/differences.h), with the modes that it ends in; neighbours must end in the same ones.
 *
 * Sources: Hindmarsh and others, ACM Trans. Math. Softw. 31 (2005) 363 (forward sensitivities, their error control); Rozenvasser, Automation
 * and Remote Control 28 (1967) 1052 (at instants); Hairer and Wanner, Solving Ordinary Differential Equations II, 2nd ed., section IV.8.
 */
#ifndef LAG_SENSITIVITIES_H
#define LAG_SENSITIVITIES_H

#include <stdint.h>

#include "lag/methods/dop853.h"
#include "lag/equations/feedback.h"
#include "lag/equations/projection.h"
#include "lag/linalg/vector.h"
#include "lag/methods/radau.h"
#include "lag/run/results.h"
#include "lag/sensitivities/column_sums.h"
#include "lag/sensitivities/differences.h"

struct lag_run;

/* Rates along columns in models with loads (sensitivity_loads.c): the equations at a state, and what unit loads cause. */
typedef struct lag_loads_along {
    lag_loads loads;
    lag_system system;
    double *mass, *jacobian;                     /* (nq, nq) (nc, nq) */
    double *force, *gamma, *qdd, *lam;           /* (nq) (nc) each */
    double *qdd_by_load, *lam_by_load;           /* (nload, nq) (nload, nc) */
    double *slope, *pivot, *change;              /* (nload, nload) decomposed, (nload) each */
    double *system_memory;
} lag_loads_along;

size_t lag_loads_along_memory(const lag_model *model);
void lag_loads_along_place(lag_loads_along *a, const lag_model *model, double *memory);
/* The equations of the motion at x; then rates (2 nq + nz) and outputs (ny; null: not wanted) along a direction of q, qd, z, u, p. */
lag_status lag_loads_along_set_state(lag_loads_along *a, lag_motion *motion, double t, const double *x);
lag_status lag_loads_along_rates(lag_loads_along *a, const lag_motion *motion, const double *direction, double *rates, double *y);

/* Quantities that the motion is differentiated by: `count` directions of the parameters, of constant shifts of inputs, and of the start values of the model. */
typedef struct lag_sensitivity_directions {
    size_t count;
    const double *p;     /* (count, np) */
    const double *u;     /* (count, nu) */
    const double *start; /* (count, 2 nq + nz) */
} lag_sensitivity_directions;

/*
 * Functions of several directions, and the motion with its derivatives (jacobian() of its tangents). Without tangents the functions of the model follow
 * one direction after the other.
 */
typedef struct lag_sensitivity_functions {
    lag_along states, parameters, motion;
    int prepared[3]; /* their workspaces are those of the present parameters */
} lag_sensitivity_functions;

/* Rows beside those of lag_results, in buffers of the caller; null: not wanted. */
typedef struct lag_sensitivity_rows {
    double *rows;  /* (most_rows, count, lag_sensitivities_width()): of x, of the discrete variables, of the outputs */
    double *times; /* (most_notes, count) of the instants of notes */
} lag_sensitivity_rows;

/*
 * Columns in blocks of so many lanes: entry i of column k of a block is at i * lanes + k; unused ones are zero. The last block may have fewer lanes than the
 * others; it begins where it would with as many.
 */
typedef struct lag_columns {
    size_t lanes, blocks, last; /* lanes of all blocks but the last, and of this one */
    double *x;        /* (blocks, 2 nq + nz + nu + np, lanes) s at time t, and the directions of inputs and parameters */
    double *w;        /* (blocks, nw, lanes) of discretes */
    double *before;   /* (blocks, 2 nq + nz, lanes) s where the last step began */
    double *inside;   /* (blocks, 2 nq + nz + nu + np, lanes) at a time within it */
    lag_parameter_entries entries;
    int shifted;      /* some column is along inputs */
    size_t moving;    /* so many columns are along parameters, */
    double *of_parameters, *p; /* (moving) these, and (2 nq + nz + nu + np, moving) their directions of p alone */
    double *extent;   /* (blocks, lanes) of the directions, in natural sizes: a change by one of these is this much of order one */
    double t, t_before;
    double rejected;  /* error of the step from there that was rejected last; infinite: none was */
    double t_dense;   /* the end of the step whose dense output is ready; no number: of none */
} lag_columns;

/* The linear equations of the stages of Radau, decomposed or solved by corrections. */
typedef struct lag_collocation_system {
    lag_stage_equations equations; /* matrix null: they are too many */
    double *jacobian;              /* (stages, entries) as Radau keeps them; decomposed: df/dx of one stage */
    double *slope;                 /* (stages, n) where the column begins, */
    double *z;                     /* (stages, lag_radau_size()) and what the stages add to it, */
    double *w;                     /* the same in transformed coordinates */
    double *sides;                 /* what the equations of the stages lack */
} lag_collocation_system;

/* Arrays of ROS2. */
typedef struct lag_rosenbrock_system {
    double *matrix, *pivots; /* (n, n) (n) decomposed */
    double *right, *k[2];    /* (n) each: of a column; stages of the state */
} lag_rosenbrock_system;

/* Columns of delayed values (sensitivity_delays.c). */
typedef struct lag_columns_past {
    lag_delay_pieces pieces; /* of the expressions along every column, then dtau of the place at which a piece begins: (ndelay + 1, count) */
    double *moved;           /* (count) dtau of the last instant, */
    int happened;            /* which was just now */
    double *delays;          /* (ndelay, count) derivatives of the delays themselves */
    double *state;           /* (2 nq + nz) */
    double *values, *derivative, *times; /* (ndelay) each */
} lag_columns_past;

size_t lag_columns_past_memory(const lag_model *model, size_t count);
void lag_columns_past_place(lag_columns_past *past, const lag_model *model, size_t count, double *memory);

/* Results of jacobian() at the present state, in memory that holds nothing else. */
typedef struct lag_motion_derivatives {
    double *qdd, *lam, *response, *by_state, *by_parameter;
    lag_kept kept;
    lag_arguments at; /* the state that they are asked for at, with this memory */
    lag_motion_product product;
    int known; /* it is that of the present state */
} lag_motion_derivatives;

/* The stage, the first or the last, whose slopes are those at time t (no number: none) and at the state x (2 nq + nz), and will be as long as nothing happens. */
typedef struct lag_known_slopes {
    size_t stage;
    double t, *x;
} lag_known_slopes;

/* Arrays of one step. */
typedef struct lag_columns_work {
    double *state, *state_of_stage; /* (2 nq + nz) each */
    double *states;   /* (16, 2 nq + nz) at the stages of DOP853 */
    double *slopes;   /* (blocks, 16, 2 nq + nz, lanes), of Radau the stages */
    double *terms;    /* (blocks, 7, 2 nq + nz, lanes) of the dense output */
    double *point;    /* (2 nq + nz + nu + np, lanes) directions at a stage */
    double *rates, *y; /* (2 nq + nz, lanes) (ny, lanes) */
    lag_loads_along loads;
    lag_motion_derivatives motion;
    lag_known_slopes known;
    double *one_rates; /* (2 nq + nz + ny, lanes) */
    double *by_state, *outputs_by_state; /* (2 nq + nz, 2 nq + nz + nu) (ny, 2 nq + nz + nu) where there are more columns */
    double *by_parameter, *outputs_by_parameter; /* (2 nq + nz, moving) (ny, moving) */
    double *one;      /* (2 nq + nz + nu + np + nw) of a single column, its discretes behind */
    double *u, *w;    /* (nu) (nw) */
    lag_collocation_system collocation;
} lag_columns_work;

/* An instant. */
typedef struct lag_columns_instant {
    double *f, *f_after;     /* (2 nq + nz) rates before it and behind it */
    double *w_after, *until_after; /* (nw) (ncontact) */
    double *time;            /* (count) dtau */
    double *until;           /* (count, ncontact) of the ends of bounces too short to follow */
    double *behind;          /* (count, 2 nq + nz + nw + ncontact) columns behind it: of the state, the discretes and the ends of bounces */
    double *sizes;           /* of values of maps */
    double *bend;            /* second derivatives of guards along the rates */
    int pending;             /* they are still to become the columns */
} lag_columns_instant;

/* An instant as a map (sensitivity_map.c). */
typedef struct lag_instant_map {
    struct lag_sensitivities *s;
    struct lag_run *run;
    const struct lag_cause *cause;
    double t;
    uint64_t events; /* what happens at it, as a sum over notices */
    size_t distance; /* of what time changes, the one that is due, or their number */
} lag_instant_map;

/* The instant behind which there is no derivative. */
typedef struct lag_columns_fault {
    double t;
    size_t guard;   /* LAG_GRAZING: the guard; LAG_NOT_SMOOTH: number of the column */
    size_t one_sided; /* so many instants at which several guards leave their modes at times that part */
    double first;   /* time of the first of them */
} lag_columns_fault;

typedef struct lag_sensitivities {
    lag_companion companion; /* the first member */
    lag_sensitivity_directions of;
    lag_sensitivity_rows results;
    lag_columns columns;
    lag_columns_work work;
    lag_columns_past past;
    lag_columns_instant instant;
    lag_sensitivity_functions along;
    lag_rosenbrock_system rosenbrock;
    lag_differences differences;
    const lag_column_sums *sums;         /* in the registers of the processor, */
    const lag_column_sums *of_blocks[2]; /* and in those that the lanes of all blocks but the last fill, and those of this one */
    size_t discretes;        /* so many of them have places in a row */
    lag_columns_fault fault;
    double *scales;          /* (np) sizes of the parameters */
    unsigned char *chosen;   /* (2 nq + nz) start values that count as written */
} lag_sensitivities;

/* Doubles of a row of one column. */
size_t lag_sensitivities_width(const lag_model *model);
/*
 * Bytes of the block for the sensitivities of a run, and its layout; it is zero, and aligned as malloc does. Arrays that `of`, `rows`
 * and `along` point at must outlive it; `along` (3) are the functions of several directions, of q, qd, z, u and of p, and the derivatives of the
 * motion; without tangents there are none.
 */
size_t lag_sensitivities_size(const lag_model *model, size_t count);
lag_sensitivities *lag_sensitivities_place(void *block, const lag_model *model, const lag_sensitivity_directions *of, const lag_sensitivity_rows *rows,
    const lag_along *along);
/* Why there are no more derivatives, and how many instants have several. */
void lag_sensitivities_fault(const lag_sensitivities *s, lag_columns_fault *fault);

/*
 * Columns at the start at time t: of the state that lag_run_find() finds for the run, which has not begun, from the start values of the model with
 * those of `values` in place of the flagged ones (2 nq + nz; null: none). LAG_NOT_SMOOTH: its neighbours have none.
 */
lag_status lag_sensitivities_start(lag_sensitivities *s, struct lag_run *run, double t, const unsigned char *set, const double *values);

/* Derivatives (count, lag_sensitivities_width()) at a fixed time t of the state x there: the present one of the run, or one within its last step. */
lag_status lag_sensitivities_get(lag_sensitivities *s, struct lag_run *run, double t, const double *x, double *derivatives);
/* The columns at the present, as in a row of them (count, lag_sensitivities_width()). */
lag_status lag_sensitivities_row(struct lag_run *run, double *row);
/* Inputs that callers set go along u (count, nu) from now on. */
void lag_sensitivities_inputs(lag_sensitivities *s, const lag_model *model, const double *u);
/* All columns between two calls as bytes, and back, into sensitivities of the same directions; signature and checksum are the caller's. */
size_t lag_sensitivities_saved_size(const lag_sensitivities *s, const lag_model *model);
void lag_sensitivities_save(const lag_sensitivities *s, const lag_model *model, unsigned char *bytes);
void lag_sensitivities_load(lag_sensitivities *s, const lag_model *model, const unsigned char *bytes);

/* ---- for its own parts ---- */

/* Sensitivities of a run that has some. */
lag_sensitivities *lag_sensitivities_of(const struct lag_run *run);
/* Lets the columns follow the last step, projected as the state is. */
lag_status lag_sensitivities_step(struct lag_run *run);
/* Goes through the instant, and sums what happens there. */
lag_status lag_instant_map_carry(const lag_instant_map *map, uint64_t *events);
/* A lag_map: state, discretes and ends of bounces behind it. LAG_ATTENTION: something else happens there, or it ends in other modes. */
lag_status lag_instant_map_behind(void *context, double *values);
/* True if discretes of this kind are modes, which do not move with a column. */
int lag_is_mode(unsigned char kind);
/* Of the companion: a row, a note, the way back to a time within the last step. */
lag_status lag_columns_row(struct lag_run *run, size_t number, double t, const double *x);
void lag_columns_note(struct lag_companion *companion, size_t number);
lag_status lag_columns_back(struct lag_run *run, double t);
/* Carries out what happens at an instant, with the columns, */
lag_status lag_sensitivities_instant(struct lag_run *run, const struct lag_cause *cause);
/* which are those behind it from now on. */
void lag_sensitivities_after(lag_companion *companion);

/*
 * The slopes of all columns (blocks, 16, n, lanes), at the stages of the last step where these begin, become what the stages add to them. The Jacobians
 * at the stages are there. LAG_SINGULAR; LAG_MISSING: corrections do not contract.
 */
lag_status lag_columns_collocate(lag_sensitivities *s, const lag_stepper *stepper, const lag_radau_places *of_state);

/* Entries of a direction: q, qd, z, u, p. */
size_t lag_columns_variables(const lag_model *model);
/* Lanes of a block, and the sums for so many. */
static inline size_t lag_columns_lanes(const lag_sensitivities *s, size_t block)
{
    return block + 1 < s->columns.blocks ? s->columns.lanes : s->columns.last;
}
static inline const lag_column_sums *lag_columns_sums(const lag_sensitivities *s, size_t block)
{
    return s->of_blocks[block + 1 == s->columns.blocks];
}
/* The columns (size, lanes) of a block where the last step began. */
static inline double *lag_columns_before(const lag_sensitivities *s, size_t size, size_t block)
{
    return s->columns.before + block * size * s->columns.lanes;
}
/* Entries from `row` on of one column into such blocks, which are `height` rows high, or out of them. */
void lag_columns_put(const lag_sensitivities *s, size_t column, size_t row, size_t count, const double *from, double *blocks, size_t height);
void lag_columns_get(const lag_sensitivities *s, size_t column, size_t row, size_t count, const double *blocks, size_t height, double *to);
/* The parameters, and their directions, are these from now on. */
void lag_columns_follow_parameters(lag_sensitivities *s, const lag_model *model);
/* Step of differences along the discretes w (nw); 0: they stay. */
double lag_columns_step(lag_sensitivities *s, struct lag_run *run, const double *w);
/* The state x at time t is that of the rates along columns, and of their outputs, that are asked for next. */
lag_status lag_columns_set_state(lag_sensitivities *s, struct lag_run *run, double t, const double *x, int outputs);
/* d/dt (q, qd, z) (2 nq + nz, lanes) along the directions (2 nq + nz + nu + np, lanes) of a block at x, and outputs (ny, lanes; null: not wanted). */
lag_status lag_columns_rates(lag_sensitivities *s, struct lag_run *run, size_t block, double t, const double *x, const double *directions,
    double *rates, double *y);
/* The Jacobian at stage i, at x, which is looked at, as work.collocation keeps it. */
lag_status lag_columns_jacobian(lag_sensitivities *s, struct lag_run *run, double t, const double *x, size_t i);
/*
 * Lets the directions (blocks, 2 nq + nz + nu + np, lanes) of all columns at the state x on the constraints satisfy these to first order, as
 * lag_projection_apply() lets the state satisfy them.
 */
lag_status lag_columns_project(lag_sensitivities *s, struct lag_run *run, double t, const double *x, double *directions);
/* Columns of delayed values at time t, into those of the discretes. */
void lag_columns_set_delays(lag_sensitivities *s, struct lag_run *run, double t);
/* The motion begins; its last step up to time t is the past of delayed values. */
lag_status lag_columns_begin_past(lag_sensitivities *s, struct lag_run *run);
lag_status lag_columns_keep_past(struct lag_run *run, double t);
/* True if nothing but jumps of delayed values causes the instant; carries it out then, with the columns. LAG_NOT_SMOOTH: it turns something. */
int lag_columns_jumps_alone(const struct lag_run *run, const struct lag_cause *cause);
lag_status lag_columns_pass_jumps(lag_sensitivities *s, struct lag_run *run, const struct lag_cause *cause);
/* Lets the columns follow a step of fixed length; slopes for its cubic, which is found at a part of the step of length h then. */
lag_status lag_columns_fixed_step(lag_sensitivities *s, struct lag_run *run);
lag_status lag_columns_prepare_fixed(lag_sensitivities *s, struct lag_run *run);
void lag_columns_fixed_dense(const lag_sensitivities *s, const struct lag_run *run, size_t block, double h, double part, double *to);
/* Columns of a block at a time within the last step, into `to` (2 nq + nz, lanes). */
lag_status lag_columns_dense(lag_sensitivities *s, struct lag_run *run, size_t block, double t, double *to);

#endif
