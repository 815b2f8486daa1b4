/*
 * One-step methods that choose the length of their steps. A method remembers nothing that must not change: between two steps
 * the caller may move the state (projection, events), take a step back, or go on with another method.
 *
 * Error control: a step is accepted where the root mean square of the estimated local errors, each as a part of its absolute
 * `tolerance`, is at most 1.
 */
#ifndef LAG_STEPPER_H
#define LAG_STEPPER_H

#include "lag/ode.h"

typedef struct lag_method lag_method;

/* A step that would leave less than this part of itself before the limit is stretched to it. */
static const double LAG_STRETCH = 1.01;

/* The last accepted step, as far as it is known. */
typedef struct lag_last_step {
    double error;    /* 0: none */
    double h;        /* the length that it belongs to */
    double urge;     /* h |lambda| along the step, as an explicit method sees it; 0: not known */
    int dense_ready; /* whether its dense output has been prepared */
} lag_last_step;

/* The work so far. */
typedef struct lag_step_counts {
    size_t steps, rejections, evaluations, jacobians, decompositions;
    size_t directions; /* of Krylov spaces in which linear systems are solved */
} lag_step_counts;

/* The last state at which the system had no rates. */
typedef struct lag_trouble {
    lag_status status; /* LAG_OK: nowhere so far */
    double time;
    double *x;         /* (size) */
} lag_trouble;

/*
 * States that a method evaluates anyway and that lie near the motion, up to terms of the fourth order in the length of the step at least: at its
 * beginning, between, at its end. Methods tell those that they have.
 */
enum { LAG_PASSED_BEGIN, LAG_PASSED_END = 4, LAG_PASSED };

/* The one who wants these states. */
typedef struct lag_passing {
    void (*pass)(void *context, unsigned place, double t); /* told just after one was evaluated at t; null: nobody asks */
    void *context;
} lag_passing;

/* An attempt at a step, of methods that may make it before the step is asked for (lag/methods/attempts.h). */
typedef struct lag_attempt {
    int begun, made;         /* there is one; and its error is known */
    double t, first, limit;  /* the step that it is of: where, what was proposed for it, not beyond this */
    double next, h, t_new;   /* what is proposed now; its length and its end */
    double error;            /* at most 1: the attempt can be the step */
    double urge;             /* of an attempt that can */
    int bare;                /* its stages are not there: who looks inside finds them again */
    int dense;               /* further stages of its dense output are wanted; when it is made: they are there */
    size_t rejections, evaluations; /* that the stepper has not counted yet */
} lag_attempt;

typedef struct lag_stepper {
    const lag_ode *ode;
    const lag_method *method;
    double t;           /* time of x */
    double t_before;    /* start of the last step */
    double h;           /* proposed length of the next step; 0: not known yet */
    double h_least;     /* shorter steps than this are given up */
    double h_most;      /* none is longer */
    double h_fixed;     /* all are so long, where the method does not choose */
    double *x, *f;      /* (size) the state and its derivative */
    double *x_before;   /* (size) at the start of the last step */
    double *f_before;   /* (size) */
    double *tolerance;  /* (size) absolute; may be changed between steps */
    double *work;       /* of the method */
    lag_last_step last;
    int looked;         /* an implicit method has the Jacobian of the present state, found before it began */
    lag_attempt attempt;
    lag_step_counts counts;
    lag_trouble trouble;
    lag_passing passing;
} lag_stepper;

struct lag_method {
    const char *name;
    unsigned order;       /* of the steps; where the method chooses among several: the lowest, */
    unsigned highest_order; /* and the highest */
    unsigned dense_order; /* of the dense output */
    int implicit;         /* needs the Jacobian */
    double factor;        /* local tolerance as a part of the tolerance of the whole motion */
    unsigned error_order; /* of the error estimate, for the first step; 0: there is none, and steps are of the stepper's `h_fixed` */
    size_t (*memory)(const lag_ode *ode);
    void (*begin)(lag_stepper *s);
    lag_status (*step)(lag_stepper *s, double limit);
    lag_status (*prepare_dense)(lag_stepper *s);
    void (*dense)(const lag_stepper *s, double t, double *x);
};

extern const lag_method lag_dop853; /* explicit, order 8 */
extern const lag_method lag_radau;  /* implicit, order 5, 9 or 13, L-stable */
/*
 * The methods of lag/fixed.h with steps of `h_fixed`, without error estimate; the last step is shorter or a little longer, to
 * hit the limit.
 */
extern const lag_method lag_steps_rk4, lag_steps_leapfrog, lag_steps_ros2;

/* Doubles for states of that system, of which size, nq and patterns are read; enough for any method of this runtime. */
size_t lag_stepper_memory(const lag_ode *ode);

/* Lays out `s` in `memory` for the system. The caller sets t, x, tolerance, h_least and h_most, then begins. */
void lag_stepper_place(lag_stepper *s, const lag_ode *ode, double *memory);

/* Start, or start again after x jumped or with another method: evaluates f; finds h where it is 0, within `span`. */
lag_status lag_stepper_begin(lag_stepper *s, const lag_method *method, double span);

/*
 * One accepted step, not beyond `limit` (> t), which is hit exactly. LAG_STEP_TOO_SMALL: even a step of length h_least cannot be
 * accepted; x stays.
 */
lag_status lag_stepper_step(lag_stepper *s, double limit);

/* x was moved a little after the last step: f there. */
lag_status lag_stepper_correct(lag_stepper *s);

/* The last step is taken back; the next will be proposed with length h. */
void lag_stepper_undo(lag_stepper *s, double h);

/* The state at a time within the last step, as the method found it (moves of x afterwards do not count). */
lag_status lag_stepper_dense(lag_stepper *s, double t, double *x);

/* For the methods themselves. */

/* f(t, x), counted; what is not finite is trouble. */
lag_status lag_stepper_rates(lag_stepper *s, double t, const double *x, double *xd);
/* The state that was evaluated last lies at this place of the step. */
void lag_stepper_pass(const lag_stepper *s, unsigned place, double t);
/* Root mean square of error (size) over tolerance; infinite where it is no number. */
double lag_stepper_norm(const lag_stepper *s, const double *error);
/* Length of the next trial: the proposed h, cut or stretched a little to hit the limit. */
double lag_stepper_length(const lag_stepper *s, double h, double limit);
/* The end of a step of length h: the limit itself where it leads there. */
double lag_stepper_end(const lag_stepper *s, double h, double limit);
/* x_new becomes the state at t_new; f_new its derivative. */
void lag_stepper_accept(lag_stepper *s, double t_new, const double *x_new, const double *f_new);

#endif
