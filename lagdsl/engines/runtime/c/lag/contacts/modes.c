#include "lag/contacts/modes.h"

#include <math.h>
#include <string.h>

#include "lag/linalg/arena.h"
#include "lag/linalg/vector.h"

/* The problem is solved again, so often, as limits may depend on other forces than its own. */
enum { MOST_TIMES = 20 };
/* An acceleration below this part of what it is a sum of is zero. */
static const double NONE = 1e-10;
/* Friction that left its mode bears less than its limit by this part of its largest forces. */
static const double LEFT = 1e-9;
/* In `parting`: it goes on, and its direction has the same bits. */
static const double GOES_ON = 2.0;
/* A slip in a plane begins with this part of its largest terms. */
static const double BEGINNING = 1e-14;

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

static size_t first_of(const lag_modes *modes, size_t k)
{
    return (size_t)modes->frictions->first[k];
}

/* The heading of friction k: along `along` (components) in this sense; zero where it has no length. */
static void set_heading(lag_modes *modes, size_t k, const double *along, double length, double sense)
{
    for (size_t a = 0; a < lag_frictions_components(modes->frictions, k); ++a) {
        modes->heading[first_of(modes, k) + a] = length > 0.0 ? sense * along[a] / length : 0.0;
    }
}

/* ---- the problem ---- */

/*
 * Directions of w (nw) for the present headings: of a slip in a plane only what is missing in the slip itself. Friction that may stick has no load of
 * sliding in the problem (`without`): a slip in a plane that is round-off has a direction.
 */
static void set_directions(const lag_modes *modes, int without, double *w)
{
    const lag_frictions *frictions = modes->frictions;
    for (size_t k = 0; k < modes->motion->model->nfriction; ++k) {
        const size_t count = lag_frictions_components(frictions, k);
        const int moves = lag_frictions_speed(frictions, k) > lag_frictions_speed_band(frictions, k);
        const double part = count == 1 ? 1.0 : moves ? 0.0 : BEGINNING * fmax(lag_frictions_length(frictions, frictions->fast, k), BEGINNING);
        for (size_t a = first_of(modes, k); a < first_of(modes, k) + count; ++a) {
            double *direction = w + modes->motion->places.direction + a;
            const int cancels = without && count > 1 && modes->loose[k] != 0.0;
            *direction = cancels ? -frictions->slip[a] : modes->parting[k] == GOES_ON ? *direction : part * modes->heading[a];
        }
    }
}

/* The rows of the problem act in w (nw), or do not. */
static void set_rows(const lag_modes *modes, int act, double *w)
{
    for (size_t i = 0; i < modes->motion->model->ncontact; ++i) {
        w[modes->motion->places.contact + i] = modes->normal[i] != 0.0 ? act : w[modes->motion->places.contact + i];
    }
    for (size_t k = 0; k < modes->motion->model->nfriction; ++k) {
        w[modes->motion->places.sticks + k] = act * modes->loose[k];
    }
}

/* Rows and biases with all that may act, and loads; afterwards modes->w has what acts without, with the directions that are looked at. */
static lag_status find_rows(lag_modes *modes)
{
    lag_motion *motion = modes->motion;
    lag_status status = lag_loads_evaluate(&modes->loads, motion->model, &motion->at);
    memcpy(modes->w, motion->w, motion->model->nw * sizeof(double));
    set_directions(modes, 1, modes->w);
    set_rows(modes, 1, modes->w);
    motion->at.w = modes->w;
    status = status == LAG_OK ? motion->model->dynamics(&motion->at, modes->impulse->mass, modes->impulse->before, modes->jacobian, modes->gamma) : status;
    set_rows(modes, 0, modes->w);
    status = status == LAG_OK ? lag_loads_gain(&modes->loads, motion->model, &motion->at) : status;
    motion->at.w = motion->w;
    return status;
}

/* A row of the constraints in the problem: its forces bring loads along, beside those that are in modes->w. */
static void add_loads(lag_modes *modes, size_t number, size_t row)
{
    const lag_model *model = modes->motion->model;
    const double lam = modes->motion->lam[row];
    lag_loads_add_to_force(&modes->loads, model, row, modes->rows.columns + number * model->nq);
    for (size_t k = 0; k < model->nload && isfinite(lam); ++k) {
        modes->w[modes->motion->places.load + k] -= modes->loads.by_multiplier[k * model->nc + row] * lam;
    }
}

static void add_contacts(lag_modes *modes)
{
    const lag_model *model = modes->motion->model;
    for (size_t i = 0; i < model->ncontact; ++i) {
        if (modes->normal[i] != 0.0) {
            const size_t row = model->contact_rows[i];
            lag_inequalities_add_normal(&modes->rows, model->nq, i, modes->jacobian + row * model->nq, -modes->gamma[row], 0.0);
            add_loads(modes, modes->rows.size - 1, row);
        }
    }
}

/* Friction with its limit: the part that normal forces of the problem do not change, and the one that they do. */
static void add_frictions(lag_modes *modes)
{
    const lag_frictions *frictions = modes->frictions;
    const lag_model *model = modes->motion->model;
    lag_inequalities *rows = &modes->rows;
    for (size_t k = 0; k < model->nfriction; ++k) {
        const size_t size = rows->size;
        const size_t row = model->friction_rows[first_of(modes, k)];
        const int slides = modes->kinetic[k] != 0.0;
        const double *gain = (slides ? frictions->gain : frictions->sticking_gain) + k * model->nc;
        double limit = slides ? frictions->limit[k] : frictions->sticking[k] - (modes->parting[k] != 0.0 ? LEFT * frictions->force[k] : 0.0);
        double speed[2] = {0.0, 0.0};
        if (modes->loose[k] == 0.0) {
            continue;
        }
        for (size_t i = 0; i < rows->normals; ++i) {
            const size_t normal = model->contact_rows[lag_gap_of(rows, i)];
            limit -= isfinite(modes->motion->lam[normal]) ? gain[normal] * modes->motion->lam[normal] : 0.0;
        }
        for (size_t a = 0; a < lag_frictions_components(frictions, k); ++a) {
            speed[a] = -modes->gamma[row + a];
        }
        lag_frictions_add(frictions, rows, k, modes->jacobian + row * model->nq, speed, gain);
        rows->limits[rows->frictions - 1] = limit;
        for (size_t number = size; number < rows->size; ++number) {
            add_loads(modes, number, row + number - size);
        }
    }
}

/* Solves it with the limits of sliding for friction that is `kinetic`. */
static lag_status solve(lag_modes *modes, double t, const double *x)
{
    const lag_model *model = modes->motion->model;
    lag_inequalities_clear(&modes->rows);
    memcpy(modes->w + modes->motion->places.load, modes->loads.value, model->nload * sizeof(double));
    add_contacts(modes);
    add_frictions(modes);
    return modes->rows.size > 0 ? lag_impulse_accelerate(modes->impulse, t, x, modes->w, &modes->rows) : LAG_OK;
}

/* ---- what follows ---- */

/*
 * Sets the heading of friction `number` of the problem; 1: it slips, by more than a part of what its acceleration is a sum of, and of
 * the one that its limit makes.
 */
static int find_heading(lag_modes *modes, size_t number)
{
    const lag_inequalities *rows = &modes->rows;
    const size_t row = (size_t)rows->slip[number];
    const size_t k = lag_friction_of(rows, number);
    const size_t count = lag_frictions_components(modes->frictions, k);
    const double limit = rows->limits[number] + lag_dot(rows->normals, rows->coefficients + number * rows->normals, rows->force);
    const double scale = fmax(rows->scale[row], rows->scale[row + count - 1]);
    const double compliance = fmax(rows->compliance[row], rows->compliance[row + count - 1]);
    const double length = lag_slip_length(count, rows->after + row);
    const double force = lag_slip_length(count, rows->force + row);
    const double *before = lag_frictions_direction(modes->frictions, k);
    const int accelerates = length > NONE * fmax(scale, compliance * limit);
    const int directed = force > LEFT * modes->frictions->force[k] || lag_any(count, before);
    const int parts = modes->parting[k] != 0.0 && directed && force >= (1.0 - NONE) * limit;
    modes->frictions->compliance[modes->motion->model->ncontact + k] = compliance;
    if (parts && !lag_any(count, before)) { /* its acceleration is small: the force knows the direction */
        set_heading(modes, k, rows->force + row, force, -1.0);
    } else if (parts && !accelerates) {
        set_heading(modes, k, before, lag_slip_length(count, before), 1.0);
        modes->parting[k] = GOES_ON;
    } else {
        set_heading(modes, k, rows->after + row, accelerates ? length : 0.0, 1.0);
    }
    return accelerates || parts;
}

/* Headings of friction that slips; 1: one of them has a limit at rest above that of sliding, and was not `kinetic`. */
static int find_slipping(lag_modes *modes)
{
    const lag_frictions *frictions = modes->frictions;
    int again = 0;
    for (size_t number = 0; number < modes->rows.frictions; ++number) {
        const size_t k = lag_friction_of(&modes->rows, number);
        const int slips = find_heading(modes, number);
        again = again || (slips && modes->kinetic[k] == 0.0 && frictions->sticking[k] > frictions->limit[k]);
        modes->kinetic[k] = slips ? 1.0 : modes->kinetic[k];
    }
    return again;
}

static void set_modes(lag_modes *modes)
{
    const lag_frictions *frictions = modes->frictions;
    const lag_inequalities *rows = &modes->rows;
    for (size_t i = 0; i < rows->normals; ++i) {
        frictions->compliance[lag_gap_of(rows, i)] = rows->compliance[i];
        *lag_contacts_flag(modes->contacts, lag_gap_of(rows, i)) = !(rows->after[i] > NONE * rows->scale[i]);
    }
    set_directions(modes, 0, modes->motion->w);
    for (size_t k = 0; k < modes->motion->model->nfriction; ++k) {
        const int heads = lag_frictions_length(frictions, modes->heading, k) > 0.0;
        const int acts = lag_frictions_acts(frictions, k);
        *lag_frictions_sticks(frictions, k) = acts && modes->loose[k] != 0.0 && !heads;
        if (!acts) {
            lag_fill(lag_frictions_components(frictions, k), 0.0, lag_frictions_direction(frictions, k));
        }
    }
}

/* Sets the modes of what is in `normal` and `loose` by the problem of accelerations. */
static lag_status solve_modes(lag_modes *modes, double t, const double *x)
{
    for (size_t k = 0; k < modes->motion->model->nfriction; ++k) {
        modes->kinetic[k] = modes->parting[k] != 0.0 && lag_frictions_length(modes->frictions, modes->motion->w + modes->motion->places.direction, k) > 0.0;
        if (modes->loose[k] != 0.0) {
            set_heading(modes, k, modes->heading, 0.0, 0.0);
        }
    }
    lag_status status = find_rows(modes);
    int again = 1;
    while (again && status == LAG_OK) {
        status = solve(modes, t, x);
        again = status == LAG_OK && find_slipping(modes);
    }
    if (status == LAG_OK) {
        set_modes(modes);
    }
    return status;
}

/* ---- modes that solve the problem ---- */

/* 1: contact i pushes, or does nothing; one whose forces are shared within a group does as far as friction tells. */
static int has_admissible_force(const lag_modes *modes, size_t i)
{
    return !isnan(modes->frictions->reserve[i]) || lag_contacts_multiplier(modes->contacts, i) >= -lag_contacts_force_noise(modes->contacts, i);
}

/* 1: contact i pulls. Sizes of forces may be older than a load that acts since this instant: they are found again before a contact opens. */
static int pulls(const lag_modes *modes, size_t i, double t, const double *x)
{
    return !has_admissible_force(modes, i) && lag_contacts_find_forces(modes->contacts, t, x) == LAG_OK && !has_admissible_force(modes, i);
}

/* 1: friction k, which sticks, is within its limits, as far as some forces of the present modes are. */
static int is_within_limit(const lag_modes *modes, size_t k)
{
    return lag_frictions_guard(modes->frictions, k) >= -lag_frictions_dead_band(modes->frictions, k);
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
    int holds = 1;
    for (size_t i = 0; i < model->ncontact && holds; ++i) {
        holds = modes->normal[i] == 0.0 || !pulls(modes, i, t, x);
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
        set_heading(modes, k, frictions->slip + (size_t)frictions->first[k], slides ? speed : 0.0, 1.0);
        modes->loose[k] = acts && !slides;
        modes->parting[k] = acts && (stuck ? gone : began && !gone);
    }
}

/* ---- modes ---- */

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
    status = solve_modes(modes, t, x);
    for (int k = 0; k < MOST_TIMES && status == LAG_OK && model->nfriction > 0; ++k) {
        status = evaluate_forces(modes, t, x);
        if (status != LAG_OK || is_borne(modes)) {
            return status;
        }
        status = solve_modes(modes, t, x);
    }
    return model->nfriction > 0 && status == LAG_OK ? LAG_NO_FORCES : status;
}
