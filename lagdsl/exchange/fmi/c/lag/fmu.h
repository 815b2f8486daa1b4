/*
 * Data of an exported model beside lag/model.h: its variables as importers see them. A constant of type lag_fmu is generated
 * for each FMU; everything else of the binary is the same for all of them.
 */
#ifndef LAG_FMU_H
#define LAG_FMU_H

#include "lag/model.h"

/* Meaning of a variable; `first` of lag_variable is an index into the array named here. */
typedef enum lag_role {
    LAG_ROLE_TIME,
    LAG_ROLE_PARAMETER,  /* p (np) */
    LAG_ROLE_FREE,       /* p (np): initialization solves for it, from the value that was set as a guess */
    LAG_ROLE_CONSTANT,   /* `constants` of the FMU: structural parameters and constants of the model */
    LAG_ROLE_STATE,      /* x = (q, qd, z) (2 nq + nz) */
    LAG_ROLE_DEPENDENT,  /* entries of x that follow from states: starts until initialization ends, computed from there on */
    LAG_ROLE_DERIVATIVE, /* dx/dt (2 nq + nz) */
    LAG_ROLE_INPUT,      /* u (nu) */
    LAG_ROLE_OUTPUT,     /* y (ny) */
    LAG_ROLE_LOCAL,      /* dependent parameters, then definitions: what model->definition gives (nd) */
    LAG_ROLE_DISCRETE,   /* w (nw) */
    LAG_ROLE_MULTIPLIER, /* lam (nc) */
    LAG_ROLE_INDICATOR,  /* event indicators: instance/events.c tells what they are */
    LAG_ROLE_ENERGY,     /* 0 total, 1 kinetic, 2 potential [J] */
    LAG_ROLE_RESIDUAL,   /* largest residual of the constraints over the sizes of their rows: 0 of positions, 1 of velocities */
    LAG_ROLE_OPTION,     /* see lag_option */
    LAG_ROLE_CLOCK       /* clocks of `sample` (nclock); they have no value */
} lag_role;

/* Settings of the integrator, parameters that every FMU has. */
typedef enum lag_option {
    LAG_OPTION_STEP /* [s] length of fixed steps; 0: steps with error control */
} lag_option;

/*
 * FMI 3 has Integers as Int32, Enumerations as Int64; FMI 2 has both as Integers, and no table with Enumerations. Strings are constants
 * only, `first` of them an index into `texts`.
 */
typedef enum lag_type {
    LAG_TYPE_REAL,
    LAG_TYPE_INTEGER,
    LAG_TYPE_BOOLEAN,
    LAG_TYPE_STRING,
    LAG_TYPE_ENUMERATION,
    LAG_TYPE_CLOCK
} lag_type;

/* When a variable may be set. */
typedef enum lag_setting {
    LAG_SET_NEVER,
    LAG_SET_START,   /* until initialization ends */
    LAG_SET_TUNABLE, /* and at events, between communication points */
    LAG_SET_ALWAYS   /* inputs, and states where the standard lets them be set */
} lag_setting;

/* Its value reference is its index, its name that of the description. An array variable is `count` entries, one after the other. */
typedef struct lag_variable {
    unsigned char role, type, setting;
    size_t first, count;
    const char *name;
} lag_variable;

/* Dependency of an unknown on a known; the numbers are those of FMI 3. */
typedef enum lag_dependence {
    LAG_DEPENDENCE_INDEPENDENT,
    LAG_DEPENDENCE_CONSTANT,
    LAG_DEPENDENCE_FIXED,
    LAG_DEPENDENCE_TUNABLE,
    LAG_DEPENDENCE_DISCRETE,
    LAG_DEPENDENCE_DEPENDENT
} lag_dependence;

/* Entry `element` of a variable depends on entry `other_element` of `other`. Entries count from 1; 0 means all of them. */
typedef struct lag_dependency {
    size_t element, other, other_element;
    unsigned char kind;
} lag_dependency;

/* Smallest and largest value that may be set; both may be infinite. */
typedef struct lag_range {
    double least, most;
} lag_range;

typedef enum lag_kinds { LAG_NO_KIND = 0, LAG_MODEL_EXCHANGE = 1, LAG_CO_SIMULATION = 2 } lag_kinds;

/* Values that no run changes. */
typedef struct lag_constants {
    const double *numbers;
    const char *const *texts; /* those of type String */
} lag_constants;

typedef struct lag_experiment {
    double start, stop, tolerance; /* infinite stop: none given */
} lag_experiment;

/* Properties of inputs beside their variables. */
typedef struct lag_input_kinds {
    const size_t *rates;             /* (nu) the input that is the time derivative of this one; nu: none. Null: none at all */
    const unsigned char *continuous; /* (nu) 1: it has such an input, and may not jump: no blow would follow. Null: none */
    const lag_range *range;          /* (nu) of those that change at events only; null: any */
} lag_input_kinds;

/* Variable i depends as entries [first[i], first[i + 1]) tell; null: not told. */
typedef struct lag_dependencies {
    const size_t *first; /* (nvariable + 1) */
    const lag_dependency *entries;
} lag_dependencies;

/* Entries of an array. */
typedef struct lag_selection {
    size_t count;
    const size_t *entries; /* (count) */
} lag_selection;

/*
 * Coordinates that follow from states: q[coordinates[i]] = sum of term_weight[k] q[term_of[k]] over term_first[i] <= k <
 * term_first[i + 1], + an offset that is constant between events; rates without it. Terms are independent coordinates, or
 * dependent ones that come before.
 */
typedef struct lag_dependents {
    size_t count;
    const size_t *coordinates; /* (count) */
    const size_t *term_first;  /* (count + 1) */
    const size_t *term_of;
    const double *term_weight;
} lag_dependents;

typedef struct lag_fmu {
    const lag_model *model;
    const char *token; /* the guid of FMI 2, the instantiation token of FMI 3 */
    size_t nvariable;
    const lag_variable *variables; /* (nvariable) */
    lag_constants constants;
    const lag_start *start;      /* where the motion starts with the default parameters */
    const double *nominal;       /* (2 nq + nz) */
    lag_experiment experiment;
    lag_sizes sizes;
    lag_lasting lasting;
    const double *row_factors;      /* (nc) multipliers of the variables are those of the model times these; null: one */
    const double *invariant_limits; /* (ni) allowed departures, as parts of the scales; 0: a thousand tolerances */
    unsigned char kinds;            /* a sum of lag_kinds: what it can be instantiated for */
    lag_dependencies dependencies;
    lag_input_kinds inputs;
    const lag_range *parameter_range; /* (np) null: any */
    lag_selection indicators; /* guards (lag/events/guards.h) that are event indicators: not relations that only values set at events change */
    lag_selection states;     /* entries of x that importers integrate */
    lag_dependents dependents;
} lag_fmu;

#endif
