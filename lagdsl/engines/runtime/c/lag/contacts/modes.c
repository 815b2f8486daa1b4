#include "lag/contacts/modes.h"

#include <math.h>
#include <string.h>

#include "lag/contacts/modes_problem.h"
#include "lag/linalg/arena.h"

/* A force that is beyond a limit by this part of it is at the limit. */
static const double BEYOND = 1e-10;
/* Friction leaves with others where it bears beyond its force what bounds them all, to this part of their forces; a force below it has no direction. */
static const double SPARED = 1e-9;
/* A closed contact pulls by more than this part of its largest force. */
static const double PULL = 1e-9;
/* In `normal`: a contact that is open and may close. */
static const double CANDIDATE = 2.0;
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
    modes->touched = lag_lay(layout, model->nq + model->nz);
    modes->normal = lag_lay(layout, model->ncontact);
    lag_lay_all(layout, model->nfriction, (double **const[]){&modes->loose, &modes->kinetic, &modes->began, NULL});
    modes->heading = lag_lay(layout, model->nslip);
    lag_lay_all(layout, model->nq, (double **const[]){&modes->force, &modes->qdd, NULL});
    modes->gamma = lag_lay(layout, model->nc);
    lag_loads_place(&modes->loads, model, layout);
}

/* ---- what is looked for ---- */

static void touch(lag_modes *modes, const double *row)
{
    const lag_model *model = modes->motion->model;
    for (size_t j = 0; j < model->nq && model->components != NULL; ++j) {
        if (row[j] != 0.0) {
            modes->touched[model->components[j]] = 1.0;
        }
    }
}

static const double *contact_row(const lag_modes *modes, size_t i)
{
    return modes->contacts->jacobian + i * modes->motion->model->nq;
}

/* 1: contact i pushes, or does nothing, by the measure of its largest forces. */
static int has_admissible_force(const lag_modes *modes, size_t i, double most)
{
    const double force = lag_contacts_multiplier(modes->contacts, i);
    const double size = modes->contacts->sizes.force[i] > 0.0 ? modes->contacts->sizes.force[i] : most;
    return !isnan(modes->frictions->reserve[i]) || force >= -PULL * size;
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
    const double *direction = lag_frictions_direction(frictions, k);
    const int moves = lag_frictions_speed(frictions, k) > lag_frictions_speed_band(frictions, k);
    const int sticks = *lag_frictions_sticks(frictions, k) != 0.0;
    if (!lag_frictions_acts(frictions, k)) {
        return !sticks && !lag_any(lag_frictions_components(frictions, k), direction);
    }
    if (sticks) {
        return !(moves && modes->jumped) && is_within_limit(modes, k);
    }
    return moves && (lag_frictions_components(frictions, k) > 1 || lag_frictions_guard(frictions, k) > 0.0);
}

/* 1: contact i pulls. Sizes of forces may be older than a load that acts since this instant: they are found again before a contact opens. */
static int pulls(const lag_modes *modes, size_t i, double most, double t, const double *x)
{
    return !has_admissible_force(modes, i, most) && lag_contacts_find_forces(modes->contacts, t, x) == LAG_OK && !has_admissible_force(modes, i, most);
}

/* Touches what has to be looked for with closed contacts that were solved with all candidates closed; 1: there is something. */
static int find_touched(lag_modes *modes, double t, const double *x, const double *left)
{
    const lag_model *model = modes->motion->model;
    double most = 1e-300;
    int any = 0;
    lag_fill(model->nq + model->nz, 0.0, modes->touched);
    for (size_t i = 0; i < model->ncontact; ++i) {
        most = fmax(most, modes->normal[i] != 0.0 ? fabs(lag_contacts_multiplier(modes->contacts, i)) : 0.0);
    }
    for (size_t i = 0; i < model->ncontact; ++i) {
        if (modes->normal[i] != 0.0 && ((left != NULL && left[i] != 0.0) || pulls(modes, i, most, t, x))) {
            touch(modes, contact_row(modes, i));
            any = 1;
        }
    }
    for (size_t k = 0; k < model->nfriction; ++k) {
        if ((left != NULL && left[model->ncontact + k] != 0.0) || !is_consistent_mode(modes, k)) {
            touch(modes, lag_modes_slip_row(modes, k));
            any = 1;
        }
    }
    return any;
}

void lag_modes_release_frictions(lag_modes *modes)
{
    lag_fill(modes->motion->model->nfriction, 0.0, modes->motion->w + modes->motion->places.sticks);
    modes->jumped = 1;
}

/* ---- what slides, and what may stick ---- */

static int is_candidate(const lag_modes *modes, size_t contact)
{
    return contact >= modes->motion->model->ncontact || modes->normal[contact] != 0.0;
}

/* Multipliers with the largest least reserve, where there is friction. */
static const double *force_of(const lag_modes *modes)
{
    return modes->motion->model->nfriction > 0 ? modes->reserve.force : modes->motion->lam;
}

/* 1: a contact, or behind them a friction, shares undetermined forces. */
static int shares(const lag_modes *modes, size_t side)
{
    return !isnan(modes->frictions->reserve[side]);
}

/* 1: what shares undetermined forces leaves, as its group has no reserve left, and it is what bounds that. */
static int leaves_group(const lag_modes *modes, size_t side, const double *left)
{
    const lag_model *model = modes->motion->model;
    int leaves = 0;
    for (size_t other = model->ncontact; other < model->ncontact + model->nfriction; ++other) {
        leaves = leaves || (left[other] != 0.0 && shares(modes, other) && modes->reserve.member[other] == modes->reserve.member[side]);
    }
    return leaves && modes->reserve.slack[side] - modes->frictions->reserve[side] <= SPARED * modes->reserve.size[side];
}

/* 1: a contact, or behind them a friction, was found to leave its mode. */
static int leaves_mode(const lag_modes *modes, size_t side, const double *left)
{
    return left != NULL && (shares(modes, side) ? leaves_group(modes, side, left) : left[side] != 0.0);
}

/* Closed contacts that open in any case leave the problem. */
static void open_left(lag_modes *modes, const double *left)
{
    const lag_model *model = modes->motion->model;
    for (size_t i = 0; i < model->ncontact && left != NULL; ++i) {
        double *closed = lag_contacts_flag(modes->contacts, i);
        if (*closed != 0.0 && leaves_mode(modes, i, left)) {
            modes->normal[i] = *closed = 0.0;
        }
    }
}

/* Friction that slides, with its heading; friction that may stick. Neither of both is off. */
static void sort_frictions(lag_modes *modes, const double *left)
{
    const lag_frictions *frictions = modes->frictions;
    const lag_model *model = modes->motion->model;
    for (size_t k = 0; k < model->nfriction; ++k) {
        const int acts = is_candidate(modes, model->friction_contacts[k]) && lag_modes_is_touched(modes, lag_modes_slip_row(modes, k));
        const int stuck = *lag_frictions_sticks(frictions, k) != 0.0;
        const size_t side = model->ncontact + k;
        const int gone = stuck ? leaves_mode(modes, side, left) : left != NULL && left[side] != 0.0;
        const double speed = lag_frictions_speed(frictions, k);
        const int moved = speed > lag_frictions_speed_band(frictions, k) && (!stuck || modes->jumped);
        double force[2] = {0.0, 0.0};
        for (size_t a = 0; a < lag_frictions_components(frictions, k); ++a) {
            force[a] = force_of(modes)[model->friction_rows[lag_modes_first(modes, k) + a]];
        }
        lag_modes_set_heading(modes, k, force, 0.0, 0.0);
        modes->loose[k] = 0.0;
        if (acts && moved && (stuck || !gone || lag_frictions_turns(frictions, k))) {
            lag_modes_set_heading(modes, k, frictions->slip + lag_modes_first(modes, k), speed, 1.0);
        } else if (acts && gone && stuck && !(shares(modes, side) && hypot(force[0], force[1]) <= SPARED * modes->reserve.size[side])) {
            lag_modes_set_heading(modes, k, force, hypot(force[0], force[1]), -1.0);
        } else {
            modes->loose[k] = acts;
        }
        /* what begins to slip goes on with the limit of sliding, if that solves the problem */
        modes->began[k] = acts && !gone && !stuck && lag_frictions_length(frictions, frictions->motion->w + modes->motion->places.direction, k) > 0.0;
    }
}

/* 1: all that sticks bears the forces of the present modes, with the limits that it has with these. */
static int is_consistent(const lag_modes *modes)
{
    int holds = 1;
    for (size_t k = 0; k < modes->motion->model->nfriction; ++k) {
        holds = holds && (*lag_frictions_sticks(modes->frictions, k) == 0.0 || is_within_limit(modes, k));
    }
    return holds;
}

/* Limits and reserves with the forces of the present modes. */
static lag_status evaluate_forces(lag_modes *modes, double t, const double *x)
{
    lag_motion_try(modes->motion, t, x);
    const lag_status status = lag_frictions_evaluate(modes->frictions);
    return status == LAG_OK ? lag_reserve_evaluate(&modes->reserve) : status;
}

/* The problem in what was touched. */
static lag_status find_touched_modes(lag_modes *modes, double t, const double *x, const double *left)
{
    const lag_model *model = modes->motion->model;
    for (size_t i = 0; i < model->ncontact; ++i) {
        modes->normal[i] = modes->normal[i] != 0.0 && lag_modes_is_touched(modes, contact_row(modes, i));
    }
    open_left(modes, left);
    sort_frictions(modes, left);
    lag_status status = lag_modes_solve(modes, t, x);
    for (int k = 0; k < MOST_TIMES && status == LAG_OK && model->nfriction > 0; ++k) {
        status = evaluate_forces(modes, t, x);
        if (status != LAG_OK || is_consistent(modes)) {
            return status;
        }
        status = lag_modes_solve(modes, t, x);
    }
    return model->nfriction > 0 && status == LAG_OK ? LAG_NO_FORCES : status;
}

lag_status lag_modes_find(lag_modes *modes, double t, const double *x, const double *candidates, const double *left)
{
    const lag_model *model = modes->motion->model;
    int any = model->nfriction > 0;
    int tried = 0;
    for (size_t i = 0; i < model->ncontact; ++i) {
        double *closed = lag_contacts_flag(modes->contacts, i);
        modes->normal[i] = candidates[i] != 0.0 && *closed == 0.0 ? CANDIDATE : *closed;
        any = any || modes->normal[i] != 0.0;
        tried = tried || modes->normal[i] == CANDIDATE;
        *closed = modes->normal[i] != 0.0;
    }
    if (!any) {
        return LAG_OK;
    }
    lag_status status = evaluate_forces(modes, t, x);
    if (status == LAG_OK && !find_touched(modes, t, x, left)) {
        return LAG_OK;
    }
    for (size_t i = 0; i < model->ncontact; ++i) {
        double *closed = lag_contacts_flag(modes->contacts, i);
        *closed = modes->normal[i] == CANDIDATE && lag_modes_is_touched(modes, contact_row(modes, i)) ? 0.0 : *closed;
    }
    status = tried && status == LAG_OK ? evaluate_forces(modes, t, x) : status;
    return status == LAG_OK ? find_touched_modes(modes, t, x, left) : status;
}
