#include "lag/contacts/modes_problem.h"

#include <math.h>
#include <string.h>

#include "lag/linalg/arena.h"
#include "lag/linalg/vector.h"

/* An acceleration below this part of what it is a sum of is zero. */
static const double NONE = 1e-10;
/* In `began`: it goes on, and its direction has the same bits. */
static const double GOES_ON = 2.0;
/* A slip in a plane begins with this part of its largest terms. */
static const double BEGINNING = 1e-14;

int lag_modes_is_touched(const lag_modes *modes, const double *row)
{
    const lag_model *model = modes->motion->model;
    return model->components == NULL || modes->touched[lag_row_component(model, row)] != 0.0;
}

void lag_modes_set_heading(lag_modes *modes, size_t k, const double *along, double length, double sense)
{
    for (size_t a = 0; a < lag_frictions_components(modes->frictions, k); ++a) {
        modes->heading[lag_modes_first(modes, k) + a] = length > 0.0 ? sense * along[a] / length : 0.0;
    }
}

/* ---- the problem ---- */

/* Directions of w (nw) for the present headings: of a slip in a plane only what is missing in the slip itself. */
static void set_directions(const lag_modes *modes, double *w)
{
    const lag_frictions *frictions = modes->frictions;
    for (size_t k = 0; k < modes->motion->model->nfriction; ++k) {
        const size_t count = lag_frictions_components(frictions, k);
        if (!lag_modes_is_touched(modes, lag_modes_slip_row(modes, k))) {
            continue;
        }
        const int moves = lag_frictions_speed(frictions, k) > lag_frictions_speed_band(frictions, k);
        const double part = count == 1 ? 1.0 : moves ? 0.0 : BEGINNING * fmax(lag_frictions_length(frictions, frictions->fast, k), BEGINNING);
        for (size_t a = 0; a < count && modes->began[k] != GOES_ON; ++a) {
            w[modes->motion->places.direction + lag_modes_first(modes, k) + a] = part * modes->heading[lag_modes_first(modes, k) + a];
        }
    }
}

/* Friction that may stick has no load of sliding in the problem: a slip in a plane that is round-off has a direction. */
static void leave_out_loads(const lag_modes *modes, double *w)
{
    const lag_frictions *frictions = modes->frictions;
    for (size_t k = 0; k < modes->motion->model->nfriction; ++k) {
        const size_t count = lag_frictions_components(frictions, k);
        for (size_t a = 0; a < count && count > 1 && modes->loose[k] != 0.0; ++a) {
            w[modes->motion->places.direction + lag_modes_first(modes, k) + a] = -frictions->slip[lag_modes_first(modes, k) + a];
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
        const int sought = lag_modes_is_touched(modes, lag_modes_slip_row(modes, k));
        w[modes->motion->places.sticks + k] = sought ? act * modes->loose[k] : w[modes->motion->places.sticks + k];
    }
}

/* Rows and biases with all that may act. Afterwards modes->w has what acts without. */
static lag_status find_rows(lag_modes *modes)
{
    lag_motion *motion = modes->motion;
    memcpy(modes->w, motion->w, motion->model->nw * sizeof(double));
    set_directions(modes, modes->w);
    leave_out_loads(modes, modes->w);
    set_rows(modes, 1, modes->w);
    motion->at.w = modes->w;
    const lag_status status = motion->model->dynamics(&motion->at, modes->impulse->mass, modes->force, modes->jacobian, modes->gamma);
    motion->at.w = motion->w;
    set_rows(modes, 0, modes->w);
    return status;
}

/* Loads, and what they change with the directions that are looked at. */
static lag_status find_loads(lag_modes *modes)
{
    lag_motion *motion = modes->motion;
    lag_status status = lag_loads_evaluate(&modes->loads, motion->model, &motion->at);
    motion->at.w = modes->w;
    status = status == LAG_OK ? lag_loads_gain(&modes->loads, motion->model, &motion->at) : status;
    motion->at.w = motion->w;
    return status;
}

/* A row of the constraints in the problem: its forces bring loads along, beside those that are in modes->w. */
static void add_loads(lag_modes *modes, size_t number, size_t row)
{
    const lag_model *model = modes->motion->model;
    const lag_loads *loads = &modes->loads;
    const double lam = modes->motion->lam[row];
    for (size_t k = 0; k < model->nload; ++k) {
        const double part = loads->by_multiplier[k * model->nc + row];
        for (size_t j = 0; j < model->nq; ++j) { /* how M qdd - f changes: a force is its negative */
            modes->rows.columns[number * model->nq + j] -= part * loads->motion[j * model->nload + k];
        }
        modes->w[modes->motion->places.load + k] -= isfinite(lam) ? part * lam : 0.0;
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

/* The limit of friction k: the part that normal forces of the problem do not change, and the one that they do. */
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
        const size_t row = model->friction_rows[lag_modes_first(modes, k)];
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
    memcpy(modes->w + modes->motion->places.load, modes->loads.value, model->nload * sizeof(double));
    add_contacts(modes);
    add_frictions(modes);
    return modes->rows.size > 0 ? lag_impulse_accelerate(modes->impulse, t, x, modes->w, &modes->rows, modes->qdd) : LAG_OK;
}

/* ---- what follows ---- */

static int is_accelerated(const lag_modes *modes, size_t row)
{
    return fabs(modes->rows.after[row]) > NONE * modes->rows.scale[row];
}

static double limit_of(const lag_inequalities *rows, size_t number)
{
    return rows->limits[number] + lag_dot(rows->normals, rows->coefficients + number * rows->normals, rows->force);
}

/* 1: it slips: by more than a part of what its acceleration is a sum of, and of the one that its limit makes. */
static int begins_to_slip(const lag_modes *modes, size_t number, size_t row, size_t count, double length)
{
    const lag_inequalities *rows = &modes->rows;
    const double scale = fmax(rows->scale[row], rows->scale[row + count - 1]);
    const double compliance = fmax(rows->compliance[row], rows->compliance[row + count - 1]);
    return length > NONE * fmax(scale, compliance * limit_of(rows, number));
}

/* 1: the force of friction `number` of the problem, in rows from `row` on, is as large as its limit. */
static int is_at_limit(const lag_modes *modes, size_t number, size_t row, size_t count)
{
    const lag_inequalities *rows = &modes->rows;
    return lag_slip_length(count, rows->force + row) >= (1.0 - NONE) * limit_of(rows, number);
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
        const double length = lag_slip_length(count, after);
        const int slips = begins_to_slip(modes, number, row, count, length);
        if (slips || modes->began[k] == 0.0 || !is_at_limit(modes, number, row, count)) {
            lag_modes_set_heading(modes, k, after, slips ? length : 0.0, 1.0);
        } else {
            const double *before = lag_frictions_direction(frictions, k);
            lag_modes_set_heading(modes, k, before, lag_slip_length(count, before), 1.0);
            modes->began[k] = GOES_ON;
        }
        again = again || (slips && modes->kinetic[k] == 0.0 && frictions->sticking[k] > frictions->limit[k]);
        modes->kinetic[k] = slips ? 1.0 : modes->kinetic[k];
        frictions->compliance[modes->motion->model->ncontact + k] = fmax(modes->rows.compliance[row], modes->rows.compliance[row + count - 1]);
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
            const int opens = modes->rows.after[normal] > 0.0 && is_accelerated(modes, normal);
            frictions->compliance[i] = modes->rows.compliance[normal];
            *lag_contacts_flag(modes->contacts, i) = opens ? 0.0 : 1.0;
            ++normal;
        }
    }
    set_directions(modes, modes->motion->w);
    for (size_t k = 0; k < model->nfriction; ++k) {
        if (!lag_modes_is_touched(modes, lag_modes_slip_row(modes, k))) {
            continue;
        }
        const int heads = lag_frictions_length(frictions, modes->heading, k) > 0.0;
        const int acts = lag_frictions_acts(frictions, k);
        *lag_frictions_sticks(frictions, k) = acts && modes->loose[k] != 0.0 && !heads;
        if (!acts) {
            lag_fill(lag_frictions_components(frictions, k), 0.0, lag_frictions_direction(frictions, k));
        }
    }
}

lag_status lag_modes_solve(lag_modes *modes, double t, const double *x)
{
    memcpy(modes->kinetic, modes->began, modes->motion->model->nfriction * sizeof(double));
    for (size_t k = 0; k < modes->motion->model->nfriction; ++k) {
        if (modes->loose[k] != 0.0) {
            lag_modes_set_heading(modes, k, modes->heading, 0.0, 0.0);
        }
    }
    lag_status status = find_rows(modes);
    status = status == LAG_OK ? find_loads(modes) : status;
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
