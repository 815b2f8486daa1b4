/*
 * Modes of contacts and friction just behind an instant, by the problem of accelerations: a gap that is zero with its rate stays closed with a force that
 * pushes, or opens with its acceleration; a slip that is zero stays so with a force within what friction bears at rest, or begins against its force. At the level
 * of accelerations these are the same inequalities as those of rates in a blow (lag/optimization/friction_problem.h). Guards that left their mode, and
 * limits at rest above those of sliding: docs/explanation/hybrid_model.md, part 3 of a pass.
 *
 * Source: Pfeiffer, Glocker, Multibody Dynamics with Unilateral Contacts (1996), chapter 6.
 */
#ifndef LAG_MODES_H
#define LAG_MODES_H

#include "lag/contacts/reserve.h"

typedef struct lag_modes {
    lag_motion *motion;
    lag_contacts *contacts;
    lag_frictions *frictions;
    lag_reserve reserve;
    lag_impulse *impulse;
    lag_inequalities rows;
    double *w;               /* (nw) the discretes without what is looked for */
    int jumped;              /* rates may have jumped at this instant, or slips: what sticks may slip now */
    double *normal;          /* (ncontact) contacts in the problem */
    double *loose;           /* (nfriction) friction that may stick, */
    double *kinetic;         /* (nfriction) that slips with the limit of sliding, */
    double *parting;         /* (nfriction) that slips at its limit, as it left its mode or began to slip at this instant */
    double *heading;         /* (nslip) directions of those that slide */
    double *jacobian, *gamma; /* (nc, nq) (nc) with all rows that may act */
    lag_loads loads;         /* with the forces of the modes before */
} lag_modes;

void lag_modes_place(lag_modes *modes, lag_contacts *contacts, lag_frictions *frictions, lag_layout *layout);

/* Rates have been set: nothing sticks until modes are found. */
void lag_modes_release_frictions(lag_modes *modes);

/*
 * Sets the modes, in w, of contacts flagged in `candidates` (ncontact), which are closed at rest or have met without approach speed, and of all
 * friction, at x at time t. Of those flagged in `left` (ncontact + nfriction, or null) contacts open, whose force passed zero, and friction slips against its
 * force, whose reserve did; one whose slip passed zero may stick.
 * LAG_NO_FORCES: no accelerations satisfy the law: friction wedges.
 */
lag_status lag_modes_find(lag_modes *modes, double t, const double *x, const double *candidates, const double *left);

#endif
