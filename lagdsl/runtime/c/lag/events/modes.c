#include "lag/events/modes.h"

#include <math.h>
#include <string.h>

#include "lag/linalg/arena.h"
#include "lag/linalg/vector.h"

/* An acceleration below this part of what it is a sum of is zero. */
static const double NONE = 1e-10;
/* Friction that bears this part of its limit beyond its force does not leave with others. */
static const double SPARED = 1e-7;
/* Where limits depend on other forces than those of the problem it is solved again with these, so often. */
enum { MOST_TIMES = 20 };
/* A slip in a plane begins with this part of its largest terms. */
static const double BEGINNING = 1e-14;

size_t lag_modes_memory(const lag_model *model)
{
    const size_t n = model->nq;
    return lag_inequalities_memory(model) + lag_reserve_memory(model) + model->nw + model->ncontact + 3 * model->nfriction + model->nslip + 2 * n + model->nc * (n + 1) +
           model->nload * (1 + 2 * n + model->nc);
}

void lag_modes_place(lag_modes *modes, lag_contacts *contacts, lag_frictions *frictions, double *memory)
{
    const lag_model *model = contacts->motion->model;
    const size_t n = model->nq;
    *modes = (lag_modes){.motion = contacts->motion, .places = lag_places_of(model), .contacts = contacts, .frictions = frictions};
    modes->impulse = contacts->impulse;
    lag_inequalities_place(&modes->rows, model, lag_take(&memory, lag_inequalities_memory(model)));
    lag_reserve_place(&modes->reserve, frictions, lag_take(&memory, lag_reserve_memory(model)));
    modes->w = lag_take(&memory, model->nw);
    modes->normal = lag_take(&memory, model->ncontact);
    modes->loose = lag_take(&memory, model->nfriction);
    modes->kinetic = lag_take(&memory, model->nfriction);
    modes->began = lag_take(&memory, model->nfriction);
    modes->heading = lag_take(&memory, model->nslip);
    modes->force = lag_take(&memory, n);
    modes->qdd = lag_take(&memory, n);
    modes->jacobian = lag_take(&memory, model->nc * n);
    modes->gamma = lag_take(&memory, model->nc);
    modes->loads = lag_take(&memory, model->nload);
    modes->by_load = lag_take(&memory, model->nload * n);
    modes->by_acceleration = lag_take(&memory, model->nload * n);
    modes->by_multiplier = memory;
}

/* ---- what slides, and what may stick ---- */

static int is_candidate(const lag_modes *modes, size_t contact)
{
    return contact >= modes->motion->model->ncontact || modes->normal[contact] != 0.0;
}

/* The first component of a slip, as an offset. */
static size_t first_of(const lag_modes *modes, size_t k)
{
    return (size_t)modes->frictions->first[k];
}

/* The heading of a slip: that of `along` (components), or against it; zero where it has no length. */
static void head(lag_modes *modes, size_t k, const double *along, double length, double sense)
{
    for (size_t a = 0; a < lag_frictions_components(modes->frictions, k); ++a) {
        modes->heading[first_of(modes, k) + a] = length > 0.0 ? sense * along[a] / length : 0.0;
    }
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

/* 1: of those that share undetermined forces, as their group has no reserve left, this one has none. */
static int is_exhausted(const lag_modes *modes, size_t side)
{
    return modes->reserve.slack[side] <= SPARED * modes->reserve.size[side];
}

/* Closed contacts that open in any case leave the problem. */
static void open_left(lag_modes *modes, const double *left)
{
    const lag_model *model = modes->motion->model;
    const int any = left != NULL && lag_any(model->nfriction, left + model->ncontact);
    for (size_t i = 0; i < model->ncontact && left != NULL; ++i) {
        double *closed = lag_contacts_flag(modes->contacts, i);
        if (*closed != 0.0 && (shares(modes, i) ? any && is_exhausted(modes, i) : left[i] != 0.0)) {
            modes->normal[i] = *closed = 0.0;
        }
    }
}

/* Friction that slides, with its heading; friction that may stick. What is off is neither. */
static void sort_frictions(lag_modes *modes, const double *left)
{
    const lag_frictions *frictions = modes->frictions;
    const lag_model *model = modes->motion->model;
    for (size_t k = 0; k < model->nfriction; ++k) {
        const int acts = is_candidate(modes, model->friction_contacts[k]);
        const int stuck = *lag_frictions_sticks(frictions, k) != 0.0;
        const size_t side = model->ncontact + k;
        const int gone = left != NULL && left[side] != 0.0 && !(stuck && shares(modes, side) && !is_exhausted(modes, side));
        const double speed = lag_frictions_speed(frictions, k);
        const int moved = speed > lag_frictions_slow(frictions, k) && (!stuck || modes->jumped);
        double force[2] = {0.0, 0.0};
        for (size_t a = 0; a < lag_frictions_components(frictions, k); ++a) {
            force[a] = force_of(modes)[model->friction_rows[first_of(modes, k) + a]];
        }
        head(modes, k, force, 0.0, 0.0);
        modes->loose[k] = 0.0;
        if (acts && moved && !(gone && !stuck)) {
            head(modes, k, frictions->slip + first_of(modes, k), speed, 1.0);
        } else if (acts && gone && stuck) {
            head(modes, k, force, hypot(force[0], force[1]), -1.0);
        } else {
            modes->loose[k] = acts;
        }
        /* what begins to slip goes on with the limit of sliding, if that solves the problem */
        modes->began[k] = acts && !gone && !stuck && lag_frictions_length(frictions, frictions->motion->w + modes->places.direction, k) > 0.0;
    }
}

/* ---- the problem ---- */

/* Directions of w (nw) for the present headings: of a slip in a plane only what is missing in the slip itself. */
static void direct(const lag_modes *modes, double *w)
{
    const lag_frictions *frictions = modes->frictions;
    for (size_t k = 0; k < modes->motion->model->nfriction; ++k) {
        const size_t count = lag_frictions_components(frictions, k);
        const int moves = lag_frictions_speed(frictions, k) > lag_frictions_slow(frictions, k);
        const double part = count == 1 ? 1.0 : moves ? 0.0 : BEGINNING * fmax(lag_frictions_length(frictions, frictions->fast, k), BEGINNING);
        for (size_t a = 0; a < count; ++a) {
            w[modes->places.direction + first_of(modes, k) + a] = part * modes->heading[first_of(modes, k) + a];
        }
    }
}

/* M, f, J, gamma with the discretes w. */
static lag_status look(lag_modes *modes, const double *w, double *force, double *jacobian, double *gamma)
{
    lag_motion *motion = modes->motion;
    motion->at.w = w;
    const lag_status status = motion->model->dynamics(&motion->at, modes->impulse->mass, force, jacobian, gamma);
    motion->at.w = motion->w;
    return status;
}

/* Rows and biases with all that may act. Afterwards modes->w has what acts without. */
static lag_status find_rows(lag_modes *modes)
{
    const lag_model *model = modes->motion->model;
    double *w = modes->w;
    memcpy(w, modes->motion->w, model->nw * sizeof(double));
    direct(modes, w);
    for (size_t i = 0; i < model->ncontact; ++i) {
        w[modes->places.contact + i] = modes->normal[i] != 0.0 ? 1.0 : w[modes->places.contact + i];
    }
    memcpy(w + modes->places.sticks, modes->loose, model->nfriction * sizeof(double));
    const lag_status status = look(modes, w, modes->force, modes->jacobian, modes->gamma);
    for (size_t i = 0; i < model->ncontact; ++i) {
        w[modes->places.contact + i] = modes->normal[i] != 0.0 ? 0.0 : w[modes->places.contact + i];
    }
    lag_fill(model->nfriction, 0.0, w + modes->places.sticks);
    return status;
}

/* Generalized forces for unit loads, and the loads as they are without the forces of the rows in the problem. */
static lag_status find_loads(lag_modes *modes)
{
    lag_motion *motion = modes->motion;
    const lag_model *model = motion->model;
    const size_t n = model->nq;
    double *load = modes->w + modes->places.load;
    if (model->nload == 0) {
        return LAG_OK;
    }
    lag_status status = model->load(&motion->at, modes->loads, modes->by_acceleration, modes->by_multiplier);
    lag_fill(model->nload, 0.0, load);
    status = status == LAG_OK ? look(modes, modes->w, modes->force, modes->impulse->jacobian, modes->impulse->residual) : status;
    for (size_t k = 0; k < model->nload && status == LAG_OK; ++k) {
        double *force = modes->by_load + k * n;
        load[k] = 1.0;
        status = look(modes, modes->w, force, modes->impulse->jacobian, modes->impulse->residual);
        load[k] = 0.0;
        lag_axpy(n, -1.0, modes->force, force);
    }
    return status;
}

/* A row of the constraints in the problem: its forces bring loads along. */
static void add_loads(lag_modes *modes, size_t number, size_t row)
{
    const lag_model *model = modes->motion->model;
    const double lam = modes->motion->lam[row];
    for (size_t k = 0; k < model->nload; ++k) {
        const double part = modes->by_multiplier[k * model->nc + row];
        lag_axpy(model->nq, part, modes->by_load + k * model->nq, modes->rows.columns + number * model->nq);
        modes->loads[k] -= isfinite(lam) ? part * lam : 0.0;
    }
}

static void add_contacts(lag_modes *modes)
{
    const lag_model *model = modes->motion->model;
    for (size_t i = 0; i < model->ncontact; ++i) {
        if (modes->normal[i] != 0.0) {
            const size_t row = model->contact_rows[i];
            const size_t number = lag_inequalities_add_normal(&modes->rows, model->nq, modes->jacobian + row * model->nq, -modes->gamma[row], 0.0);
            add_loads(modes, number, row);
        }
    }
}

/* What friction k bears: the part that normal forces of the problem do not change, and that they do. */
static void set_limits(lag_modes *modes, size_t k, size_t number)
{
    const lag_frictions *frictions = modes->frictions;
    const lag_model *model = modes->motion->model;
    const int slides = modes->kinetic[k] != 0.0;
    const double *gain = (slides ? frictions->gain : frictions->sticking_gain) + k * model->nc;
    double *coefficients = modes->rows.coefficients + number * modes->rows.normals;
    size_t normal = 0;
    modes->rows.limits[number] = slides ? frictions->limit[k] : frictions->sticking[k];
    for (size_t i = 0; i < model->ncontact; ++i) {
        if (modes->normal[i] != 0.0) {
            const double lam = modes->motion->lam[model->contact_rows[i]];
            coefficients[normal++] = gain[model->contact_rows[i]];
            modes->rows.limits[number] -= isfinite(lam) ? gain[model->contact_rows[i]] * lam : 0.0;
        }
    }
}

static void add_frictions(lag_modes *modes)
{
    const lag_model *model = modes->motion->model;
    for (size_t k = 0; k < model->nfriction; ++k) {
        const size_t count = lag_frictions_components(modes->frictions, k);
        const size_t row = model->friction_rows[first_of(modes, k)];
        double speed[2] = {0.0, 0.0};
        if (modes->loose[k] == 0.0) {
            continue;
        }
        for (size_t a = 0; a < count; ++a) {
            speed[a] = -modes->gamma[row + a];
        }
        const size_t size = modes->rows.size;
        const size_t number = lag_inequalities_add_friction(&modes->rows, model->nq, count, modes->jacobian + row * model->nq, speed);
        set_limits(modes, k, number);
        for (size_t a = 0; a < count; ++a) {
            add_loads(modes, size + a, row + a);
        }
    }
}

/* Solves it with the limits of sliding for friction that is `kinetic`. */
static lag_status solve(lag_modes *modes, double t, const double *x)
{
    const lag_model *model = modes->motion->model;
    lag_inequalities_clear(&modes->rows);
    lag_status status = find_loads(modes);
    if (status != LAG_OK) {
        return status;
    }
    add_contacts(modes);
    add_frictions(modes);
    memcpy(modes->w + modes->places.load, modes->loads, model->nload * sizeof(double));
    return modes->rows.size > 0 ? lag_impulse_accelerate(modes->impulse, t, x, modes->w, &modes->rows, modes->qdd) : LAG_OK;
}

/* ---- what follows ---- */

static int moves(const lag_modes *modes, size_t row)
{
    return fabs(modes->rows.after[row]) > NONE * modes->rows.scale[row];
}

/* 1: the force of friction `number` of the problem, in rows from `row` on, is as large as its limit. */
static int is_at_limit(const lag_modes *modes, size_t number, size_t row, size_t count)
{
    const lag_inequalities *rows = &modes->rows;
    const double limit = rows->limits[number] + lag_dot(rows->normals, rows->coefficients + number * rows->normals, rows->force);
    const double force = count > 1 ? hypot(rows->force[row], rows->force[row + 1]) : fabs(rows->force[row]);
    return force >= (1.0 - NONE) * limit;
}

/* Headings of friction that slips; 1: one of them has a limit at rest above that of sliding, and was not `kinetic`. */
static int find_slipping(lag_modes *modes)
{
    const lag_frictions *frictions = modes->frictions;
    size_t row = modes->rows.normals;
    size_t number = 0;
    int again = 0;
    for (size_t k = 0; k < modes->motion->model->nfriction; ++k) {
        const size_t count = lag_frictions_components(frictions, k);
        if (modes->loose[k] == 0.0) {
            continue;
        }
        const double *after = modes->rows.after + row;
        const double length = count > 1 ? hypot(after[0], after[1]) : fabs(after[0]);
        const int slips = moves(modes, row) || moves(modes, row + count - 1);
        if (slips || modes->began[k] == 0.0 || !is_at_limit(modes, number, row, count)) {
            head(modes, k, after, slips ? length : 0.0, 1.0);
        } else {
            const double *before = lag_frictions_direction(frictions, k);
            head(modes, k, before, count > 1 ? hypot(before[0], before[1]) : fabs(before[0]), 1.0);
        }
        again = again || (slips && modes->kinetic[k] == 0.0 && frictions->sticking[k] > frictions->limit[k]);
        modes->kinetic[k] = slips ? 1.0 : modes->kinetic[k];
        frictions->compliance[k] = fmax(modes->rows.compliance[row], modes->rows.compliance[row + count - 1]);
        row += count;
        ++number;
    }
    return again;
}

static void set_modes(lag_modes *modes)
{
    const lag_frictions *frictions = modes->frictions;
    const lag_model *model = modes->motion->model;
    size_t normal = 0;
    for (size_t i = 0; i < model->ncontact; ++i) {
        if (modes->normal[i] != 0.0) {
            const int opens = modes->rows.after[normal] > 0.0 && moves(modes, normal);
            *lag_contacts_flag(modes->contacts, i) = opens ? 0.0 : 1.0;
            ++normal;
        }
    }
    direct(modes, modes->motion->w);
    for (size_t k = 0; k < model->nfriction; ++k) {
        const int heads = lag_frictions_length(frictions, modes->heading, k) > 0.0;
        const int acts = lag_frictions_acts(frictions, k);
        *lag_frictions_sticks(frictions, k) = acts && modes->loose[k] != 0.0 && !heads;
        if (!acts) {
            lag_fill(lag_frictions_components(frictions, k), 0.0, lag_frictions_direction(frictions, k));
        }
    }
}

/* 1: some forces of the present modes are within the limits that they have with these forces. */
static int is_consistent(const lag_modes *modes)
{
    const lag_frictions *frictions = modes->frictions;
    int holds = 1;
    for (size_t k = 0; k < modes->motion->model->nfriction; ++k) {
        const int sticks = *lag_frictions_sticks(frictions, k) != 0.0;
        holds = holds && (!sticks || lag_frictions_guard(frictions, k) >= -NONE * frictions->force[k]);
    }
    return holds;
}

/* Limits and reserves with the forces of the present modes. */
static lag_status look_at_forces(lag_modes *modes, double t, const double *x)
{
    lag_contacts_solve(modes->contacts, t, x);
    const lag_status status = lag_frictions_look(modes->frictions);
    return status == LAG_OK ? lag_reserve_look(&modes->reserve) : status;
}

static lag_status find(lag_modes *modes, double t, const double *x)
{
    memcpy(modes->kinetic, modes->began, modes->motion->model->nfriction * sizeof(double));
    for (size_t k = 0; k < modes->motion->model->nfriction; ++k) {
        if (modes->loose[k] != 0.0) {
            head(modes, k, modes->heading, 0.0, 0.0);
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

lag_status lag_modes_find(lag_modes *modes, double t, const double *x, const double *candidates, const double *left)
{
    const lag_model *model = modes->motion->model;
    int any = model->nfriction > 0;
    for (size_t i = 0; i < model->ncontact; ++i) {
        modes->normal[i] = candidates[i] != 0.0 || *lag_contacts_flag(modes->contacts, i) != 0.0;
        any = any || modes->normal[i] != 0.0;
    }
    if (!any) {
        return LAG_OK;
    }
    lag_status status = look_at_forces(modes, t, x);
    open_left(modes, left);
    sort_frictions(modes, left);
    status = status == LAG_OK ? find(modes, t, x) : status;
    for (int k = 0; k < MOST_TIMES && status == LAG_OK && model->nfriction > 0; ++k) {
        status = look_at_forces(modes, t, x);
        if (status != LAG_OK || is_consistent(modes)) {
            return status;
        }
        status = find(modes, t, x);
    }
    return model->nfriction > 0 && status == LAG_OK ? LAG_NO_FORCES : status;
}
