/*
 * The one place where models and the runtime meet: a model is a structure of type lag_model, a constant of generated C or filled when
 * the program runs.
 *
 * Arrays are dense, row-major, in the order of the name tables, in the SI units told there. Signs: M qdd - J' lam = f, J qdd
 * = gamma. Functions do not allocate, keep no state and write to their results and to the workspace only. A reader checks
 * `version` and `size`. Members that a model lacks are null.
 */
#ifndef LAG_MODEL_H
#define LAG_MODEL_H

#include <stddef.h>

#include "lag/status.h"

#define LAG_MODEL_VERSION 13u

/* One entry of an array. */
typedef struct lag_slot {
    const char *name;   /* as in results: theta, q[1], arm.q */
    const char *unit;   /* coherent SI unit */
    const char *place;  /* file:line of its declaration, or null */
} lag_slot;

/* A start value was written: it is held as long as one that was not can move. A rate is the first of the four of a unit quaternion. */
enum { LAG_WRITTEN = 1, LAG_QUATERNION = 2 };

/*
 * A state to start from, which satisfies everything that the model says of the start, for the default parameters; and what else it says,
 * so that other parameters and start values lead to such a state, too (lag/initial.h). Entries are those of (q, qd, z).
 */
typedef struct lag_start {
    double t;                        /* [s] */
    const double *x;                 /* null: not known */
    const unsigned char *fixed;      /* 1: the start value holds exactly; null: none does */
    const unsigned char *written;    /* LAG_WRITTEN, LAG_QUATERNION, or both; null: none was */
    const double *nominal;           /* what counts as a change of order one; zero, or null: not said */
    const double *minimum, *maximum; /* (nq) where the search stays; null: anywhere */
    const unsigned char *free;       /* (np) 1: the parameter is found with the start, from its value as a guess; null: none is */
    const double *parameter_nominal; /* (np) what counts as a change of order one; zero, or null: not said */
    const double *parameter_minimum, *parameter_maximum; /* (np) where a free parameter may be found; null: anywhere */
} lag_start;

/* Sizes that accuracy is measured by (lag/methods/accuracy.h): those of a change of order one. */
typedef struct lag_sizes {
    const double *group, *natural, *cap; /* (2 nq + nz) each, or none of them */
    const double *row_sizes;             /* (nc) of the constraints */
} lag_sizes;

/* Rows of the constraints that last. */
typedef struct lag_lasting {
    const double *rows; /* (nc) 0: the row comes and goes, as those of contacts; null: all last, */
    size_t general;     /* else so many of those that do are independent in general */
} lag_lasting;

/* Positions of the nonzero elements of a matrix, row by row. */
typedef struct lag_pattern {
    size_t rows, columns, count;
    const size_t *row, *column; /* (count) */
    const size_t *first;        /* (rows + 1) the first of each row, then `count` */
} lag_pattern;

/* Positions of the nonzero elements of matrices; null: anywhere. */
typedef struct lag_patterns {
    const lag_pattern *jacobian; /* J (nc, nq) */
    const lag_pattern *response; /* response (nk, nq) of elimination(), */
    const lag_pattern *coupling; /* and its products with the rows that are kept (nk, nk), the diagonal among them */
    /* of r, zd - g, s by (q, qd, z, qdd, lam) (nq + nz + nc, 3 nq + nz + nc); where it is told implicit methods decompose it, in an order that is told, too: */
    const lag_pattern *equations;
    const size_t *place; /* (nq + nz + nc) of its rows, and of qd, z, lam, with q and qdd under qd: entries lie near the diagonal */
    const size_t *group; /* (2 nq + nz) of q, qd, z: columns of one number share no row, */
    const size_t *value_group; /* (nq + nc) nor do those of qdd and lam; of lam only rows of zd count */
} lag_patterns;

/* Kinds of entries of w, in the order of the entries. */
typedef enum lag_kind {
    LAG_KIND_VARIABLE,  /* a discrete variable; Booleans are 0 and 1 */
    LAG_KIND_CONTACT,   /* 1 closed, 0 open; one for each contact */
    LAG_KIND_IMPACTS,   /* how often it closed or bounced; one for each contact */
    LAG_KIND_STICKS,    /* 1 dry friction holds its slip at zero, 0 it slides; one for each friction */
    LAG_KIND_DIRECTION, /* the sense of a slip, -1, 0 or 1; of two components the speed [as slip] that gives slip at rest a direction */
    LAG_KIND_RELATION,  /* the truth of a relation; one for each indicator */
    LAG_KIND_TIMED,     /* what time alone changes: a truth, the number of a piece */
    LAG_KIND_DELAY,     /* what an expression was some time ago: delayed() tells what it is now; one for each delay */
    LAG_KIND_DELAY_RATE, /* its derivative; one for each delay */
    LAG_KIND_CONDITION, /* the truth of a condition, or a value that `pre` reads, when it was looked at last */
    LAG_KIND_CLOCK,     /* 1 in the first pass of a tick; one for each clock */
    LAG_KIND_INITIAL,   /* 1 in the first pass at the start */
    LAG_KIND_TERMINAL,  /* 1 in the first pass at the end */
    LAG_KIND_LOAD       /* a load that depends on the accelerations and multipliers that it causes: load() tells what it has to be */
} lag_kind;

/*
 * Memory for results with few entries, zero at first and written by the model alone: what it leaves out is zero. Each array is of one function;
 * velocity_constraint() and dynamics(), dynamics() and mass_matrix() may share J and M.
 */
typedef struct lag_kept {
    double *first;
    size_t count;
} lag_kept;

/* Arguments of functions; arrays that a function does not read may be null. */
typedef struct lag_arguments {
    double t;          /* time [s] */
    const double *q;   /* (nq) coordinates */
    const double *qd;  /* (nq) their rates */
    const double *z;   /* (nz) first-order states */
    const double *u;   /* (nu) inputs */
    const double *w;   /* (nw) discretes: see lag_kind */
    const double *p;   /* (np) independent parameters */
    const double *qdd; /* (nq) accelerations */
    const double *lam; /* (nc) multipliers */
    /* directions of derivatives */
    const double *dq;   /* (nq) */
    const double *dqd;  /* (nq) */
    const double *dz;   /* (nz) */
    const double *du;   /* (nu) */
    const double *dp;   /* (np) */
    const double *dqdd; /* (nq) */
    const double *dlam; /* (nc) */
    /* (workspace) owned by the caller, flat and without pointers; its first `prepared` entries hold what prepare() wrote */
    double *workspace;
    const double *times; /* (lanes) instead of t, for functions of several states at once */
    const void *context; /* that of the model */
    const lag_kept *kept; /* null: there is none */
} lag_arguments;

/* True if a result lies in what the model alone writes: entries that are always zero are so. */
static inline int lag_is_kept(const lag_arguments *at, const double *result)
{
    return at->kept != NULL && result >= at->kept->first && result < at->kept->first + at->kept->count;
}

typedef struct lag_model {
    unsigned version; /* LAG_MODEL_VERSION of the header it was compiled with */
    size_t size;      /* sizeof(lag_model) then */
    const char *name;

    size_t nq, nz, nu, nw, np, nc; /* coordinates, states, inputs, discretes, parameters, rows of constraints */
    size_t ny, ni, na, ne;         /* outputs, invariants, assertions, initial equations */
    size_t rank;                   /* largest number of independent rows of J */
    size_t workspace;              /* doubles that the functions need */
    size_t prepared;               /* of these, how many prepare() fills */
    const void *context;           /* what the functions need beside their arguments, which pass it on; null for generated C */

    const lag_slot *coordinates;           /* (nq) */
    const lag_slot *states;                /* (nz) */
    const lag_slot *inputs;                /* (nu) */
    const lag_slot *discretes;             /* (nw) */
    const lag_slot *parameters;            /* (np) */
    const lag_slot *constraints;           /* (nc) */
    const lag_slot *outputs;               /* (ny) */
    const lag_slot *invariants;            /* (ni) */
    const char *const *assertions;         /* (na) messages */
    const double *defaults;                /* (np) */
    const unsigned char *position_level;   /* (nc) 1: the row restricts q itself */
    const unsigned char *redundant;        /* (nc) 1: the row depends on others */

    /* p -> the part of the workspace that depends on p only. Call it first, and again whenever p changes. */
    lag_status (*prepare)(const lag_arguments *at);

    /* ---- the functions, generated ---- */
    /* t p -> q0 (nq), qd0 (nq), z0 (nz), u0 (nu): start values of coordinates, rates and states; default inputs */
    lag_status (*start)(const lag_arguments *at, double *q0, double *qd0, double *z0, double *u0);
    /* t q qd z u w p -> phi (nc), jacobian (nc, nq): phi, zero for rows of velocity level; its Jacobian J */
    lag_status (*position_constraint)(const lag_arguments *at, double *phi, double *jacobian);
    /* t q qd z u w p -> residual (nc), jacobian (nc, nq): J qd + b of every row; J */
    lag_status (*velocity_constraint)(const lag_arguments *at, double *residual, double *jacobian);
    /* t q qd z u w p -> mass (nq, nq): M, symmetric, both halves. Formed from momentum_tangent() where M is not written out */
    lag_status (*mass_matrix)(const lag_arguments *at, double *mass);
    /*
     * t q qd z u w p -> mass (nq, nq), force (nq), jacobian (nc, nq), gamma (nc): M, f, J, gamma. Formed from momentum_tangent()
     * where M is not written out
     */
    lag_status (*dynamics)(const lag_arguments *at, double *mass, double *force, double *jacobian, double *gamma);
    /* t q qd z u w p qdd -> force (nq): M qdd - f, of about the size of T and V */
    lag_status (*inverse_dynamics)(const lag_arguments *at, double *force);
    /* t q qd z u w p qdd lam -> motion (nq), rows (nc): r = M qdd - f - J' lam; s = J qdd - gamma */
    lag_status (*residual)(const lag_arguments *at, double *motion, double *rows);
    /* t q qd z u w p qdd lam, dq dqd dz du dp -> motion (nq), rows (nc): dr, ds along a direction, at fixed qdd and lam */
    lag_status (*residual_tangent)(const lag_arguments *at, double *motion, double *rows);
    /* t q qd z u w p qdd lam -> rates (nz): zd */
    lag_status (*state_derivative)(const lag_arguments *at, double *rates);
    /* t q qd z u w p qdd lam, dq dqd dz du dp dqdd dlam -> rates (nz): dzd */
    lag_status (*state_derivative_tangent)(const lag_arguments *at, double *rates);
    /* t q qd z u w p qdd lam -> y (ny): outputs */
    lag_status (*output)(const lag_arguments *at, double *y);
    /* t q qd z u w p qdd lam, dq dqd dz du dp dqdd dlam -> y (ny): dy */
    lag_status (*output_tangent)(const lag_arguments *at, double *y);
    /* t q qd z u w p -> total, kinetic, potential, jacobi: energy(), T, V, Jacobi integral [J] */
    lag_status (*energies)(const lag_arguments *at, double *total, double *kinetic, double *potential, double *jacobi);
    /* t q qd z u w p -> momentum (nq): dL/dqd */
    lag_status (*momenta)(const lag_arguments *at, double *momentum);
    /* t q qd z u w p -> load (nq), dissipated (nq): power of loads, Q . qd, and of dissipation, dD/dqd . qd, by coordinate [W] */
    lag_status (*power)(const lag_arguments *at, double *load, double *dissipated);
    /*
     * t q qd z u w p qdd lam -> invariant (ni), scale (ni), assertion (na): invariants; largest absolute term of each; of
     * assertions 1 where they hold, else 0, of warnings -1
     */
    lag_status (*monitor)(const lag_arguments *at, double *invariant, double *scale, double *assertion);
    /* t q qd z u w p qdd lam -> residual (ne): residuals of the initial equations */
    lag_status (*initial_equation)(const lag_arguments *at, double *residual);
    /* t q qd z u w p, dq dqd dz du dp -> phi (nc), residual (nc): dphi, d(J qd + b) */
    lag_status (*constraint_tangent)(const lag_arguments *at, double *phi, double *residual);
    /*
     * t q qd z u w p -> qdd (nq), lam (nc), response (nk, nq), lam_response (nk, nc), jacobian (nk, nq), gamma (nk), pivot: with
     * the multipliers of `kept_rows` zero qdd and lam; row by row, what these multipliers add to qdd and to lam; J and gamma of
     * these rows; what is left of the smallest pivot, relatively. Only where the equations are solved while they are expressions
     */
    lag_status (*elimination)(
        const lag_arguments *at, double *qdd, double *lam, double *response, double *lam_response, double *jacobian, double *gamma,
        double *pivot);
    /* t p -> w0 (nw): start values of w. Only in models with discretes */
    lag_status (*discrete_start)(const lag_arguments *at, double *w0);
    /* t q qd z u w p qdd lam -> g (nindicator): indicators of relations. Only in models with discretes */
    lag_status (*indicator)(const lag_arguments *at, double *g);
    /*
     * t q qd z u w p qdd lam, dz du dqdd dlam -> rate (nindicator), acceleration (nindicator): first and second derivatives of
     * indicators along the motion, with dz, du, dqdd and dlam as the rates of states, inputs, accelerations and multipliers; second
     * derivatives of states are those of the equations, those of the others zero. Only in models with discretes
     */
    lag_status (*indicator_rate)(const lag_arguments *at, double *rate, double *acceleration);
    /* t q qd z u w p qdd lam -> next (nw): w with relations as they stand. Only in models with discretes */
    lag_status (*standing)(const lag_arguments *at, double *next);
    /*
     * t q qd z u w p -> gap (ngap), speed (ngap), jacobian (ngap, nq), restitution (ncontact), capture_speed (ncontact), zeno_time
     * (ncontact): gaps, their rates, their Jacobian; restitution, and the rebound speed and the time below which a contact closes,
     * negative where the defaults of the language hold. Only in models with discretes
     */
    lag_status (*contact)(
        const lag_arguments *at, double *gap, double *speed, double *jacobian, double *restitution, double *capture_speed,
        double *zeno_time);
    /* t p -> first (nclock), period (nclock): first instants, periods. Only in models with discretes */
    lag_status (*clock)(const lag_arguments *at, double *first, double *period);
    /*
     * t q qd z u w p qdd lam -> next (nw), reset (nreset), value (nreset), collision (ncollision), restitution (ncollision), stop
     * (nstop), fail (nfail): a pass over the `when` clauses: w after it, and action by action whether it acts. Only in models with
     * discretes
     */
    lag_status (*event)(
        const lag_arguments *at, double *next, double *reset, double *value, double *collision, double *restitution, double *stop,
        double *fail);
    /*
     * t w p -> value (ntimed), told (ntimed), distance (ndistance), rate (ndistance), affine (ndistance), entry (ndistance): what
     * time alone changes: the entries of w as they are at that time; 0 where nothing is told of their changes, 1 for a truth, 2 for
     * a jump; distances, positive up to the next change, and their rates; 1 where they are affine in time between events; the
     * entries that change where they reach zero. Only in models with discretes
     */
    lag_status (*time_event)(
        const lag_arguments *at, double *value, double *told, double *distance, double *rate, double *affine, double *entry);
    /*
     * t q qd z u w p qdd lam -> far (ncorner), solved: distances that pass zero where forces, energies or rates have a corner along
     * the motion; 1 where one of them reads accelerations or multipliers. Only in models with corners
     */
    lag_status (*corner)(const lag_arguments *at, double *far, double *solved);
    /*
     * t q qd z u w p -> way (nway): positions of masses and bodies, rotation matrices of bodies, and cosines and sines of what else
     * the kinetic energy differentiates, as far as they depend on discretes: all of that is continuous in a motion. Only in models
     * in which ways of masses depend on discretes
     */
    lag_status (*way)(const lag_arguments *at, double *way);
    /*
     * t q qd z u w p -> value (nturn), rate (nturn), turn (nturn), entry (nturn): outputs that are known up to multiples of `turn`,
     * or, four in a row with zero there, as a quaternion up to its sign: their values near the start, their rates, and which of the
     * outputs they are. Only in models with outputs that are known up to whole turns
     */
    lag_status (*turn)(const lag_arguments *at, double *value, double *rate, double *turn, double *entry);
    /*
     * t q qd z u w p -> value (ndelay), time (ndelay), direct: what is delayed, as it is now, and by how much [s]; 1 where one of
     * them reads delayed values itself. Only in models with delayed values
     */
    lag_status (*delayed)(const lag_arguments *at, double *value, double *time, double *direct);
    /*
     * t q qd z u w p qdd lam -> slip (nslip), jacobian (nslip, nq), limit (nfriction), sticking (nfriction), gain (nfriction, nc),
     * sticking_gain (nfriction, nc): slips of dry friction and their derivatives by qd, as the rows that hold them are; the forces
     * while it slides, the largest ones while it sticks, and how both change with lam. Only in models with dry friction
     */
    lag_status (*friction)(
        const lag_arguments *at, double *slip, double *jacobian, double *limit, double *sticking, double *gain,
        double *sticking_gain);
    /*
     * t q qd z u w p qdd lam -> load (nload), by_acceleration (nload, nq), by_multiplier (nload, nc): what the entries of w that
     * stand for loads have to be, and how that changes with qdd and lam. Only in models with loads that depend on accelerations or
     * multipliers
     */
    lag_status (*load)(const lag_arguments *at, double *load, double *by_acceleration, double *by_multiplier);
    /*
     * t q qd z u w p qdd lam, dq dqd dz du dp dqdd dlam -> load (nload): dload. Only in models with loads that depend on
     * accelerations or multipliers
     */
    lag_status (*load_tangent)(const lag_arguments *at, double *load);
    /*
     * t q qd z u w p qdd lam -> motion (nq, nload), rates (nz, nload), y (ny, nload), load (nload, nload): how r, zd, y and load
     * change with the entries of w that stand for loads. Only in models with loads that depend on accelerations or multipliers
     */
    lag_status (*load_gain)(const lag_arguments *at, double *motion, double *rates, double *y, double *load);
    /* t q qd z u w p, dqd -> momentum (nq): M dqd. Only where M is not written out */
    lag_status (*momentum_tangent)(const lag_arguments *at, double *momentum);
    /*
     * t q qd z u w p qdd lam -> d (nd): every named value, first those that depend on p only. Only in programs that tell every
     * named value
     */
    lag_status (*definition)(const lag_arguments *at, double *d);
    /* t q qd z u w p qdd lam, dq dqd dz du dp dqdd dlam -> d (nd): dd. Only in programs that tell every named value */
    lag_status (*definition_tangent)(const lag_arguments *at, double *d);
    /* t p, dp -> q (nq), qd (nq), z (nz), u (nu): how the start values change. Only in programs that tell every named value */
    lag_status (*start_tangent)(const lag_arguments *at, double *q, double *qd, double *z, double *u);
    /*
     * t q qd z u w p, dq dqd dz du dp -> total, kinetic, potential, jacobi: how the energies change. Only in programs that tell
     * every named value
     */
    lag_status (*energies_tangent)(const lag_arguments *at, double *total, double *kinetic, double *potential, double *jacobi);
    /*
     * t q qd z u w p qdd lam, dq dqd dz du dp dqdd dlam -> residual (ne): how the residuals of the initial equations change. Only
     * in programs that tell every named value
     */
    lag_status (*initial_equation_tangent)(const lag_arguments *at, double *residual);
    /*
     * t q qd z u w p qdd lam -> motion (nq), rows (nc), phi (nc), residual (nc), rates (nz), y (ny), total, kinetic, potential,
     * jacobi, d (nd): how everything changes with t alone: dr, ds, dphi, d(J qd + b), dzd, dy, the energies, dd. Only in programs
     * that tell every named value
     */
    lag_status (*time_tangent)(
        const lag_arguments *at, double *motion, double *rows, double *phi, double *residual, double *rates, double *y,
        double *total, double *kinetic, double *potential, double *jacobi, double *d);
    /*
     * t q qd z u w p lam -> change (nq), lam_change (nc), pivot: for lam in place of the residuals of the rows: the change of least
     * inertia that takes them away to first order, and its multipliers, with those of `kept_rows` zero; what is left of the
     * smallest pivot, relatively. Only in programs of many coordinates with constraints that are solved while they are expressions
     */
    lag_status (*correction)(const lag_arguments *at, double *change, double *lam_change, double *pivot);
    /*
     * t q qd z u w p -> coriolis (nq, nq), gravity (nq), bias (nq): C by Christoffel's symbols, dV/dq, and d/dt(dL/dqd) - dL/dq at
     * qdd = 0. Only in programs that tell the terms of their equations
     */
    lag_status (*equation_terms)(const lag_arguments *at, double *coriolis, double *gravity, double *bias);
    /*
     * t q qd z u w p qdd -> regressor (nq, ninertial), inertial (ninertial): Y and pi: Y pi is what masses and bodies add to
     * d/dt(dL/dqd) - dL/dq, and the forces of friction. Only in programs that tell the terms of their equations
     */
    lag_status (*regressor)(const lag_arguments *at, double *regressor, double *inertial);
    /*
     * t q qd z u w p -> position (nplace), rotation (naxes), velocity (ntwist), jacobian (ntwist, nq), bias (ntwist): of the chosen
     * frames, then of the chosen points: positions; rotation matrices, row by row; velocities, and of frames angular velocities
     * after them; their derivatives by qd; their rates of change at qdd = 0. Only in programs that tell how chosen frames and
     * points move
     */
    lag_status (*kinematics)(
        const lag_arguments *at, double *position, double *rotation, double *velocity, double *jacobian, double *bias);
    /* ---- end of what is generated ---- */

    const lag_patterns *patterns; /* null: none is told */
    /* (nq + nz) which coordinates and states the equations couple: those of one number; null: all of them */
    const size_t *components;

    size_t nk;               /* rows of constraints whose multipliers elimination() leaves to run time */
    const size_t *kept_rows; /* (nk) ascending */

    /* of models with discretes: gaps are those of the contacts, then those that clauses let collide */
    size_t nindicator, ncontact, ngap, nclock, nreset, ncollision, nstop, nfail, ntimed, ndistance;
    size_t ncorner; /* of models with corners along the motion */
    size_t nway;    /* of models in which ways of masses depend on discretes */
    size_t nturn;   /* of models with outputs that are known up to whole turns */
    size_t ndelay;  /* of models with delayed values */
    size_t nslip, nfriction; /* of models with dry friction: components of slips, frictions */
    size_t nload;   /* of models with loads that depend on accelerations or multipliers */
    const unsigned char *kinds;  /* (nw) a lag_kind each, in their order */
    const unsigned char *strict; /* (nindicator) 0: the relation holds where its indicator is zero, too */
    const unsigned char *jumping; /* (nindicator) 1: energies or rows of constraints may jump with the relation; null: with any */
    const unsigned char *whole_inputs; /* (nu) 1: Integer, Boolean or enumerated, without round-off; null: none is */
    const size_t *contact_rows;  /* (ncontact) rows of constraints that hold while they are closed; with their names */
    const unsigned char *one_way;    /* (ncontact) 1: of a rate in place of a gap; null: none is */
    const char *const *frictions;    /* (nfriction) names */
    const size_t *friction_rows;     /* (nslip) rows of constraints that hold while it sticks */
    const size_t *friction_slips;    /* (nfriction) 1 or 2 components */
    const size_t *friction_contacts; /* (nfriction) the contact under which it acts; ncontact: always */
    size_t nswitched;            /* rows of constraints, of position level, that discretes switch */
    const size_t *switched_rows; /* (nswitched) */
    const size_t *reset_places;  /* (nreset) entries of (q, qd, z) */
    const char *const *resets;   /* (nreset) their names: der(h) */
    const char *const *stops;    /* (nstop) messages */
    const char *const *failures; /* (nfail) messages */

    /* every named value of the model, where it was compiled with them: first those that depend on p only */
    size_t nd;
    const lag_slot *definitions; /* (nd) */

    /* of models that tell their terms and how frames and points move; zero where there are none */
    size_t ninertial, nplace, naxes, ntwist;
} lag_model;

/* Positions of the nonzero elements of J; null: anywhere. */
static inline const lag_pattern *lag_jacobian_pattern(const lag_model *model)
{
    return model->patterns != NULL ? model->patterns->jacobian : NULL;
}

#endif
