/* Parts of lag/contacts/modes.h: the problem of accelerations, and what follows from its solution. */
#ifndef LAG_MODES_PROBLEM_H
#define LAG_MODES_PROBLEM_H

#include "lag/contacts/modes.h"

/*
 * Sets the modes, in w, of contacts in modes->normal and of friction that is touched, from headings and `began`: LAG_NO_FORCES where no accelerations
 * satisfy the law.
 */
lag_status lag_modes_solve(lag_modes *modes, double t, const double *x);

/* The heading of slip k: along `along` (components) in this sense; zero where it has no length. */
void lag_modes_set_heading(lag_modes *modes, size_t k, const double *along, double length, double sense);

/* 1: modes of the component of this row (nq) are looked for. */
int lag_modes_is_touched(const lag_modes *modes, const double *row);

/* The first component of slip k, as an offset; its row (nq). */
static inline size_t lag_modes_first(const lag_modes *modes, size_t k)
{
    return (size_t)modes->frictions->first[k];
}

static inline const double *lag_modes_slip_row(const lag_modes *modes, size_t k)
{
    return modes->frictions->jacobian + lag_modes_first(modes, k) * modes->motion->model->nq;
}

#endif
