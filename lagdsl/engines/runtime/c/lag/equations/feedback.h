/*
 * Loads that depend on the accelerations and multipliers that they cause, as friction under a contact does: entries s of w with
 *
 *     s = L(t, q, qd, z, u, w, p, qdd, lam),   qdd and lam affine in s
 *
 * by Newton's method from s = 0, so that the result is a function of the state alone, up to round-off. Where sliding friction drives its own normal
 * force, the determinant of ds - dL, which is one without friction, passes zero: beyond it no unique force exists (wedging; Painleve's paradox).
 *
 * The derivatives take a solution of the system for each load. Derivatives of an earlier state serve again as long as steps with them contract quickly
 * (the chord method): the product of their inverse with those of this state then lies near one, so that the determinant has kept its sign.
 *
 * Source: Genot, Brogliato, New results on Painleve paradoxes, Eur. J. Mech. A/Solids 18 (1999) 653.
 */
#ifndef LAG_FEEDBACK_H
#define LAG_FEEDBACK_H

#include "lag/linalg/arena.h"
#include "lag/model.h"

/* Loads at a state, and how they and the equations of motion change with what they depend on. */
typedef struct lag_loads {
    double *value;           /* (nload) L */
    double *by_acceleration; /* (nload, nq) */
    double *by_multiplier;   /* (nload, nc) */
    double *motion;          /* (nq, nload) how M qdd - f - J' lam changes with loads, */
    double *by_load;         /* (nload, nload) and L, where it reads loads itself */
    double *unused;          /* other results of load_gain() */
} lag_loads;

/* Doubles for them. */
size_t lag_loads_memory(const lag_model *model);

void lag_loads_place(lag_loads *loads, const lag_model *model, lag_layout *layout);

/* L with its derivatives by qdd and lam; what changes with loads. Nothing in models without loads. */
lag_status lag_loads_evaluate(lag_loads *loads, const lag_model *model, const lag_arguments *at);
lag_status lag_loads_gain(lag_loads *loads, const lag_model *model, const lag_arguments *at);

/* Adds to `force` (nq), that of a row with a unit multiplier, the loads that this multiplier brings along. */
void lag_loads_add_to_force(const lag_loads *loads, const lag_model *model, size_t row, double *force);

/* Doubles for it. */
size_t lag_feedback_memory(const lag_model *model);

/* Doubles for the derivatives of an earlier state, decomposed; all zero: there is none. */
size_t lag_feedback_chord_memory(const lag_model *model);

/*
 * The system with the loads as they are in at->w: accelerations qdd (nq) and multipliers lam (nc). `again`: nothing but loads has changed since
 * the last time.
 */
typedef lag_status lag_solve_with_loads(void *context, const lag_arguments *at, int again, double *qdd, double *lam);

/*
 * qdd and lam with the loads that they cause; at->w does not change. `memory` is lag_feedback_memory() doubles, `chord` what the last call left of
 * lag_feedback_chord_memory() doubles, or null: nothing is known of earlier states.
 * LAG_NO_FORCES: there are none, or they are those beyond wedging, where forces that press make less of themselves. Any status of `solve`.
 */
lag_status lag_feedback_solve(
    const lag_model *model, const lag_arguments *at, lag_solve_with_loads *solve, void *context, double *memory, double *chord, double *qdd,
    double *lam);

#endif
