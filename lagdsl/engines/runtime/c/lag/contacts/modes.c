/* Modes that stay, and the rows of the problem (modes_problem.c) where they do not. */
#include "lag/contacts/modes.h"

#include <math.h>
#include <string.h>

#include "lag/linalg/arena.h"

/* A force that is beyond a limit by this part of it is at the limit. */
static const double BEYOND = 1e-10;
/* A closed contact pulls by more than this part of its largest force. */
static const double PULL = 1e-9;
/* The problem is solved again, so often, as limits may depend on other forces than its own. */
enum { MOST_TIMES = 20 };

void lag_modes_place(lag_modes *modes, lag_contacts *contacts, lag_frictions *frictions, lag_layout *layout)
{
    const lag_model *model = contacts->motion->model;
    *modes = (lag_modes){.motion = contacts->motion, .contacts = contacts, .frictions = frictions,
        .impulse = contacts->impulse, .jacobian = contacts->motion->written.sought};
    lag_inequalities_place(&modes->rows, model, layout);
    lag_reserve_place(&modes->reserve, frictions, layout);
    modes->w = lag_lay(layout, model->nw);
    modes->normal = lag_lay(layout, model->ncontact);
    lag_lay_all(layout, model->nfriction, (double **const[]){&modes->loose, &modes->kinetic, &modes->parting, NULL});
    modes->heading = lag_lay(layout, model->nslip);
    modes->gamma = lag_lay(layout, model->nc);
    lag_loads_place(&modes->loads, model, layout);
}

void lag_modes_release_frictions(lag_modes *modes)
{
    lag_fill(modes->motion->model->nfriction, 0.0, modes->motion->w + modes->motion->places.sticks);
    modes->jumped = 1;
}

/* ---- modes that solve the problem ---- */

/* 1: contact i pushes, or does nothing, by the measure of its largest forces. */
static int has_admissible_force(const lag_modes *modes, size_t i, double most)
{
    const double force = lag_contacts_multiplier(modes->contacts, i);
    const double size = modes->contacts->sizes.force[i] > 0.0 ? modes->contacts->sizes.force[i] : most;
    return !isnan(modes->frictions->reserve[i]) || force >= -PULL * size;
}

/* 1: contact i pulls. Sizes of forces may be older than a load that acts since this instant: they are found again before a contact opens. */
static int pulls(const lag_modes *modes, size_t i, double most, double t, const double *x)
{
    return !has_admissible_force(modes, i, most) && lag_contacts_find_forces(modes->contacts, t, x) == LAG_OK && !has_admissible_force(modes, i, most);
}

/* 1: friction k, which sticks, is within its limits, as far as some forces of the present modes are. */
static int is_within_limit(const lag_modes *modes, size_t k)
{
    return lag_frictions_guard(modes->frictions, k) >= -BEYOND * modes->frictions->force[k];
}

/* 1: friction k is in a mode that its slip and its force agree with. */
static int is_consistent_mode(const lag_modes *modes, size_t k)
{
    const lag_frictions *frictions = modes->frictions;
    const int moves = lag_frictions_speed(frictions, k) > lag_frictions_speed_band(frictions, k);
    const int sticks = *lag_frictions_sticks(frictions, k) != 0.0;
    if (!lag_frictions_acts(frictions, k)) {
        return !sticks && !lag_any(lag_frictions_components(frictions, k), lag_frictions_direction(frictions, k));
    }
    if (sticks) {
        return !(moves && modes->jumped) && is_within_limit(modes, k);
    }
    return moves && (lag_frictions_components(frictions, k) > 1 || lag_frictions_guard(frictions, k) > 0.0);
}

/* 1: the present modes, with all candidates closed, solve the problem. */
static int is_solved(const lag_modes *modes, double t, const double *x)
{
    const lag_model *model = modes->motion->model;
    double most = 1e-300;
    int holds = 1;
    for (size_t i = 0; i < model->ncontact; ++i) {
        most = fmax(most, modes->normal[i] != 0.0 ? fabs(lag_contacts_multiplier(modes->contacts, i)) : 0.0);
    }
    for (size_t i = 0; i < model->ncontact && holds; ++i) {
        holds = modes->normal[i] == 0.0 || !pulls(modes, i, most, t, x);
    }
    for (size_t k = 0; k < model->nfriction && holds; ++k) {
        holds = is_consistent_mode(modes, k);
    }
    return holds;
}

/* ---- what slides, and what may stick ---- */

/* 1: a contact, or behind them a friction, was found to leave its mode. Of what shares undetermined forces, friction tells, and all leave that have nothing left. */
static int leaves_mode(const lag_modes *modes, size_t side, const double *left)
{
    const lag_model *model = modes->motion->model;
    if (left == NULL || isnan(modes->frictions->reserve[side])) {
        return left != NULL && left[side] != 0.0;
    }
    return modes->reserve.empty[side] != 0.0 && lag_any(model->nfriction, left + model->ncontact);
}

/* Closed contacts that open in any case leave the problem. */
static void open_left(lag_modes *modes, const double *left)
{
    for (size_t i = 0; i < modes->motion->model->ncontact; ++i) {
        if (modes->normal[i] != 0.0 && leaves_mode(modes, i, left)) {
            modes->normal[i] = *lag_contacts_flag(modes->contacts, i) = 0.0;
        }
    }
}

/* Friction that slides, with its heading; friction that may stick. Neither of both is off. */
static void sort_frictions(lag_modes *modes, const double *left)
{
    const lag_frictions *frictions = modes->frictions;
    const lag_model *model = modes->motion->model;
    for (size_t k = 0; k < model->nfriction; ++k) {
        const size_t side = model->ncontact + k;
        const size_t contact = model->friction_contacts[k];
        const int acts = contact >= model->ncontact || modes->normal[contact] != 0.0;
        const int stuck = *lag_frictions_sticks(frictions, k) != 0.0;
        const int gone = stuck ? leaves_mode(modes, side, left) : left != NULL && left[side] != 0.0;
        const double speed = lag_frictions_speed(frictions, k);
        const int moved = speed > lag_frictions_speed_band(frictions, k) && (!stuck || modes->jumped);
        const int slides = acts && moved && (stuck || !gone || lag_frictions_turns(frictions, k));
        const int began = !stuck && lag_frictions_length(frictions, modes->motion->w + modes->motion->places.direction, k) > 0.0;
        lag_modes_set_heading(modes, k, frictions->slip + (size_t)frictions->first[k], slides ? speed : 0.0, 1.0);
        modes->loose[k] = acts && !slides;
        modes->parting[k] = acts && (stuck ? gone : began && !gone);
    }
}

/* Limits and reserves with the forces of the present modes. */
static lag_status evaluate_forces(lag_modes *modes, double t, const double *x)
{
    lag_motion_try(modes->motion, t, x);
    const lag_status status = lag_frictions_evaluate(modes->frictions);
    return status == LAG_OK ? lag_reserve_evaluate(&modes->reserve) : status;
}

/* 1: all that sticks bears the forces of the present modes, with the limits that it has with these. */
static int is_borne(const lag_modes *modes)
{
    int holds = 1;
    for (size_t k = 0; k < modes->motion->model->nfriction; ++k) {
        holds = holds && (*lag_frictions_sticks(modes->frictions, k) == 0.0 || is_within_limit(modes, k));
    }
    return holds;
}

lag_status lag_modes_find(lag_modes *modes, double t, const double *x, const double *candidates, const double *left)
{
    const lag_model *model = modes->motion->model;
    for (size_t i = 0; i < model->ncontact; ++i) {
        double *closed = lag_contacts_flag(modes->contacts, i);
        modes->normal[i] = *closed = candidates[i] != 0.0 || *closed != 0.0;
    }
    if (model->nfriction == 0 && !lag_any(model->ncontact, modes->normal)) {
        return LAG_OK;
    }
    lag_status status = evaluate_forces(modes, t, x);
    const int any = left != NULL && lag_any(model->ncontact + model->nfriction, left);
    if (status != LAG_OK || (!any && is_solved(modes, t, x))) {
        return status;
    }
    open_left(modes, left);
    sort_frictions(modes, left);
    status = lag_modes_solve(modes, t, x);
    for (int k = 0; k < MOST_TIMES && status == LAG_OK && model->nfriction > 0; ++k) {
        status = evaluate_forces(modes, t, x);
        if (status != LAG_OK || is_borne(modes)) {
            return status;
        }
        status = lag_modes_solve(modes, t, x);
    }
    return model->nfriction > 0 && status == LAG_OK ? LAG_NO_FORCES : status;
}
