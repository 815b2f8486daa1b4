/*
 * The Radau IIA methods of 3, 5 and 7 stages, from which lag_radau chooses: coefficients, and the stage equations of one
 * step.
 *
 * With stages z (each the distance from the present state), A the Runge-Kutta matrix and h A f = z: the inverse of A is
 * transform * D * inverse, D with the real eigenvalue `mu` and, for each pair of the others, a block
 * ((alpha, beta), (-beta, alpha)).
 *
 * Source: Hairer and Wanner, Solving Ordinary Differential Equations II, 2nd ed., section IV.8; for 5 and 7 stages and the choice
 * among them: the same, Stiff differential equations solved by Radau methods, J. Comput. Appl. Math. 111 (1999) 93.
 */
#ifndef LAG_RADAU_H
#define LAG_RADAU_H

#include "lag/factorization/band.h"
#include "lag/stepper.h"

enum { LAG_RADAU_STAGES = 7, LAG_RADAU_PAIRS = 3, LAG_RADAU_TABLES = 3 };

typedef struct lag_radau_table {
    unsigned stages; /* order of the method: 2 stages - 1 */
    double node[LAG_RADAU_STAGES]; /* the last is 1 */
    double mu, alpha[LAG_RADAU_PAIRS], beta[LAG_RADAU_PAIRS];
    double transform[LAG_RADAU_STAGES][LAG_RADAU_STAGES];
    double inverse[LAG_RADAU_STAGES][LAG_RADAU_STAGES];
    double matrix[LAG_RADAU_STAGES][LAG_RADAU_STAGES]; /* A, */
    double slopes[LAG_RADAU_STAGES][LAG_RADAU_STAGES]; /* and its inverse */
    double error[LAG_RADAU_STAGES]; /* f(x) + error * z / h: the error estimate, times mu / h, before it is filtered */
} lag_radau_table;

/* By increasing order. */
extern const lag_radau_table lag_radau_tables[LAG_RADAU_TABLES];

/* The methods of one order each; lag_radau chooses among them. */
extern const lag_method lag_radau5, lag_radau9, lag_radau13;

/* Vectors of the Krylov space in which stage equations are solved where the Jacobian turns. */
enum { LAG_RADAU_KRYLOV = 12 };

/* Memory of the method between steps, as numbers. */
typedef struct lag_radau_memo {
    double level;      /* the present table */
    double age;        /* steps since it changed */
    double fresh;      /* 1: the Jacobian is that of the present state */
    double usable;     /* 1: there is a Jacobian */
    double served;     /* so many steps were solved with it, or with that before it until the next one is taken, */
    double spent;      /* in so many iterations, its own work among them as iterations */
    double decomposed; /* step length of the decompositions, 0: none */
    double polynomial; /* terms of the dense output of the step before, 0: there is none */
    double turning;    /* for so many more steps the Jacobian is taken as linear in time, 0: as constant in a step */
    double ahead;      /* length of step along which it changes by `change`, 0: not known */
    double before;     /* length of the step that `trend` is from, 0: none */
    double wall;       /* stage equations of a step so long could not be solved, 0: none such */
    double placed;     /* 1: `middle` is that of the Jacobian at hand */
    double lower, upper; /* band of the matrices, in the order of lag_ode.patterns; as wide as they are where these tell nothing */
    double within;     /* error between the ends of the step that was looked at last, as a part of the tolerance, */
    double missed;     /* by how much its stages were missed by their first guess, 0: nothing is known, */
    double unseen;     /* and how many there were since */
    double trust;      /* error of a Newton iterate as a part of the correction before, as seen last, */
    double trusted;    /* and the length of the step where it was seen, 0: nowhere */
} lag_radau_memo;

/*
 * Arrays of a method; n: size of the state, m: rows of the matrices, entries: those of what is decomposed, which is called the Jacobian: df/dx, or
 * that of the equations where the model tells them. Vectors of `size` numbers are what lag_radau_size() says.
 */
typedef struct lag_radau_places {
    lag_radau_memo *memo;
    const lag_radau_table *table;
    double *jacobian;               /* (entries) */
    double *middle;                 /* (entries) what is decomposed: the Jacobian at the start of the step, or at its middle */
    double *matrix;                 /* (m, height, 2) of a band, without coordinates, until it is decomposed; height: that of the band */
    double *factors;                /* (m, height), then (pairs, m, height, 2); of dense matrices in their place, height: m */
    double *pivots;                 /* (1 + pairs, lag_radau_pivots()) */
    double *z, *w, *slope, *dense;  /* (stages, n) */
    double *right;                  /* (stages, n) */
    double *point, *error;          /* (n) */
    double *sides;                  /* (stages, size) right sides of the systems, then their solutions */
    double *reduced;                /* (stages, m) of them, without coordinates */
    double *change;                 /* (entries) of the Jacobian along the step */
    double *bend;                   /* (entries) at the part c of the step it is Jacobian + c change + c (c - 1) bend */
    double *trend;                  /* (entries) its change along the step before, by time */
    double *basis;                  /* (LAG_RADAU_KRYLOV + 3, stages, size) */
} lag_radau_places;

/* True if the equations are decomposed, else df/dx. */
static inline int lag_radau_is_sparse(const lag_ode *ode)
{
    return lag_ode_pattern(ode) != NULL;
}

/* Entries of the Jacobian: those that can be nonzero, or all. */
static inline size_t lag_radau_entries(const lag_ode *ode)
{
    return lag_radau_is_sparse(ode) ? lag_ode_pattern(ode)->count : ode->size * ode->size;
}

/* Numbers of the state that are not coordinates. */
static inline size_t lag_radau_others(const lag_ode *ode)
{
    return ode->size - ode->nq;
}

/* Numbers of a right side and of its solution: those of the state, and the multipliers of equations. */
static inline size_t lag_radau_size(const lag_ode *ode)
{
    return ode->size + (lag_radau_is_sparse(ode) ? ode->nc : 0);
}

/* Rows of the matrices: coordinates have none. */
static inline size_t lag_radau_rows(const lag_ode *ode)
{
    return lag_radau_size(ode) - ode->nq;
}

/* A row behind those of the coordinates has entries from `first` to before `end`, in these columns; null: in all of them. */
typedef struct lag_radau_row {
    size_t first, end;
    const size_t *column;
} lag_radau_row;

static inline lag_radau_row lag_radau_row_of(const lag_ode *ode, size_t i)
{
    const lag_pattern *pattern = lag_ode_pattern(ode);
    const size_t first = (ode->nq + i) * ode->size;
    return pattern != NULL ? (lag_radau_row){pattern->first[i], pattern->first[i + 1], pattern->column}
                           : (lag_radau_row){first, first + ode->size, NULL};
}

/* True for a row that has the rate of a number by itself: all of df/dx, and of the equations those of states. */
static inline int lag_radau_is_rate(const lag_ode *ode, size_t row)
{
    return !lag_radau_is_sparse(ode) || (row >= ode->nq && row < lag_radau_others(ode));
}

/* Lets the memo know the band of the matrices. */
void lag_radau_keep_band(lag_radau_memo *memo, const lag_ode *ode);

size_t lag_radau_memory(const lag_ode *ode);
/* Behind what the explicit method works in, which may be at work while matrices of this one are looked at; written before places are asked for. */
lag_radau_memo *lag_radau_remembered(const lag_stepper *s);
lag_radau_places lag_radau_place(const lag_stepper *s);

/* Result of Newton's method. */
typedef struct lag_radau_outcome {
    int converged;
    int rejected;  /* the error estimate ended the iteration: */
    double error;  /* so large is it, as a part of the tolerance */
    unsigned iterations;
    double rate;   /* of contraction in the last iteration; 0: there was only one */
    double smooth; /* geometric mean of the last two rates */
    double missed; /* how far the first guess was off, as the first iteration says it, as a part of the tolerance */
} lag_radau_outcome;

unsigned lag_radau_iterations(unsigned stages); /* at most */

/* out = matrix in, for as many arrays of n numbers as there are stages. */
void lag_radau_transform(
    size_t n, size_t stages, const double matrix[LAG_RADAU_STAGES][LAG_RADAU_STAGES], const double *in, double *out);

/* Value and slope at a place by weights (stages) of the stages z, for the polynomial that is zero at 0; all as parts of the step. */
void lag_radau_weights(const lag_radau_table *table, double place, double *value, double *slope);

static inline lag_band lag_radau_band(const lag_ode *ode, const lag_radau_places *at)
{
    return (lag_band){lag_radau_rows(ode), (size_t)at->memo->lower, (size_t)at->memo->upper};
}

/* Doubles of a real matrix or its factors, */
static inline size_t lag_radau_matrix(const lag_ode *ode, const lag_radau_memo *memo)
{
    const lag_band band = {lag_radau_rows(ode), (size_t)memo->lower, (size_t)memo->upper};
    return lag_radau_is_sparse(ode) ? lag_band_factors(&band, 1) : band.n * band.n;
}

/* and of how its rows were chosen and lie. */
static inline size_t lag_radau_pivots(const lag_ode *ode)
{
    return 3 * lag_radau_rows(ode) + 1;
}

/* The Jacobian at a state. */
static inline lag_status lag_radau_jacobian(const lag_ode *ode, double t, const double *x, double *jacobian)
{
    return (lag_radau_is_sparse(ode) ? ode->linearize : ode->jacobian)(ode->context, t, x, jacobian);
}

/* The matrices of one real and of complex systems for a step of length h, decomposed. LAG_SINGULAR: one of them is singular. */
lag_status lag_radau_decompose(lag_stepper *s, const lag_radau_places *at, double h);

/* This work in evaluations of the rates by an explicit method, by multiplications; matrices are as large as those at hand. */
double lag_radau_effort(const lag_stepper *s, const lag_step_counts *done);

/* The work of a new Jacobian and its decomposition as a number of iterations of Newton's method. */
double lag_radau_renewal(const lag_stepper *s);

/* The expected work of lag_radau from the present state of another method on, in the same measure. */
typedef struct lag_radau_plan {
    double probe; /* of a look at one step, */
    double begin; /* of the first steps, while their length grows, beside the work of others; */
    double step;  /* of a step */
} lag_radau_plan;

/* It begins with the order that the tolerances allow for. */
lag_radau_plan lag_radau_expect(lag_stepper *s);

/*
 * True if lag_radau, as expected before, solves a step of length h from the present state of another method, with an error below the tolerance: nothing
 * is moved. If lag_radau begins there next, it finds the matrices. `kept` (size) is written.
 */
int lag_radau_reaches(lag_stepper *s, double h, double *kept);

/* The highest order for the tolerances of `s`, each times `factor`: a place in lag_radau_tables. */
size_t lag_radau_level(const lag_stepper *s, double factor);

/* x (n) becomes the solution of the real system for it. */
void lag_radau_solve_real(const lag_ode *ode, const lag_radau_places *at, double *x);

/*
 * Of `count` stages, numbers that are `apart` from one to the next, by their places in the state: those of coordinates; the others, with multipliers
 * behind them; accelerations in the places of their rates. Null: they are zero.
 */
typedef struct lag_radau_stages {
    size_t count, apart;
    const double *coordinates, *others, *accelerations;
} lag_radau_stages;

/*
 * out (stages, size) += factor (stages) times the product of the entries, those of the equations or of df/dx, with these numbers. Rows of coordinates add
 * nothing, nor do the rates of states themselves.
 */
void lag_radau_product(const lag_ode *ode, const double *entries, const double *factor, const lag_radau_stages *of, double *out);

/*
 * The residuals of the rates, x (stages, n), as right sides (stages, size) of the systems: as they are, or times what the equations have in front of
 * the rates.
 */
void lag_radau_take_sides(const lag_ode *ode, const lag_radau_places *at, size_t stages, const double *x, double *sides);

/* Sides (stages, size) become the solutions of the decomposed systems. */
void lag_radau_decomposed(const lag_ode *ode, const lag_radau_places *at, double *sides);

/* Sum over the numbers of the state at the stages, each with `apart` numbers, by the tolerances. */
double lag_radau_inner(const lag_stepper *s, size_t stages, size_t apart, const double *a, const double *b);

/* The same for equations where what they have in front of the rates changes along the step: `sides` are those of its middle. */
void lag_radau_change_sides(const lag_ode *ode, const lag_radau_places *at, const double *residual, double *sides);

/*
 * x (stages, size), which solves the systems with the Jacobian at the middle of the step of length h, becomes the solution with one that changes along
 * it, to a small part of itself. Multipliers follow without a measure. Returns how many directions of a Krylov space that takes.
 */
size_t lag_radau_gmres(const lag_stepper *s, const lag_radau_places *at, double h, double *x);

/*
 * Right sides of the systems, in `sides`, become one correction of the stages w by Newton's method with what is decomposed;
 * its size as a part of the tolerances. Directions of Krylov spaces are added to `directions`.
 */
double lag_radau_correction(const lag_stepper *s, const lag_radau_places *at, double h, size_t *directions);

/* Adds solutions of the systems (stages, size) to w (stages, n), which have no multipliers. */
void lag_radau_add(const lag_ode *ode, size_t stages, const double *sides, double *w);

/*
 * The error estimate (8.19) of a step of length h with the stages z, into `error`; its size as a part of the tolerance. `right` becomes the part of
 * the stages, not filtered.
 */
double lag_radau_error(const lag_stepper *s, const lag_radau_places *at, double h);

/*
 * The stages z of a step of length h, from the first guess that `guess` puts into them: with the Jacobian at hand, and a new
 * one where that fails. `decides`: a step that the error estimate rejects is not solved to the end. Returns any status of the Jacobian that is not
 * LAG_OK.
 */
lag_status lag_radau_solve(lag_stepper *s, const lag_radau_places *at, double h, int decides,
    void (*guess)(const lag_stepper *s, const lag_radau_places *at, double h), lag_radau_outcome *outcome);

/* The step was accepted: whether the Jacobian serves the next one, and how that is to be solved. */
void lag_radau_keep(const lag_stepper *s, const lag_radau_places *at, const lag_radau_outcome *outcome);

/* It was not. */
void lag_radau_fail(const lag_radau_places *at, const lag_radau_outcome *outcome);

#endif
