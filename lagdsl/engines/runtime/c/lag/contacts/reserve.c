#include "lag/contacts/reserve.h"

#include <math.h>
#include <string.h>

#include "lag/linalg/arena.h"
#include "lag/linalg/disjoint_sets.h"
#include "lag/linalg/svd.h"
#include "lag/linalg/vector.h"
#include "lag/optimization/margins.h"

/* Unit rows are dependent where a singular value is below this part of the largest, and share forces by more than this. */
static const double RANK = 1e-9;
/* A side has nothing left below this part of the forces of its group. */
static const double NOTHING = 1e-9;

static size_t work_memory(const lag_model *model)
{
    const size_t program = lag_margins_memory(model->nc, model->ncontact + model->nfriction, model->nfriction);
    return lag_larger(program, model->nq * model->nc + lag_svd_memory(model->nq, model->nc));
}

void lag_reserve_place(lag_reserve *reserve, lag_frictions *frictions, lag_layout *layout)
{
    const lag_model *model = frictions->motion->model;
    *reserve = (lag_reserve){.motion = frictions->motion, .frictions = frictions};
    if (model->nfriction == 0) {
        return;
    }
    reserve->forces = lag_lay(layout, model->nc * model->nq);
    lag_lay_all(layout, model->nc, (double **const[]){&reserve->residual, &reserve->length, &reserve->place, &reserve->group, NULL});
    lag_lay_all(layout, model->nq, (double **const[]){&reserve->tied, &reserve->looked, NULL});
    reserve->basis = lag_lay(layout, model->nc * model->nc);
    reserve->empty = lag_lay(layout, model->ncontact + model->nfriction);
    lag_loads_place(&reserve->loads, model, layout);
    reserve->work = lag_lay(layout, work_memory(model));
}

/* ---- sides: contacts, and behind them frictions ---- */

static size_t count_sides(const lag_reserve *r)
{
    return r->motion->model->ncontact + r->motion->model->nfriction;
}

/* Forces that load a side: those of friction. */
static size_t loads_of(const lag_reserve *r, size_t side)
{
    const size_t contacts = r->motion->model->ncontact;
    return side < contacts ? 0 : lag_frictions_components(r->frictions, side - contacts);
}

/* 1: a friction, which sticks. */
static int sticks(const lag_reserve *r, size_t side)
{
    const size_t contacts = r->motion->model->ncontact;
    return side >= contacts && *lag_frictions_sticks(r->frictions, side - contacts) != 0.0;
}

/* The row of the force of a contact; the first of those that load friction. */
static size_t row_of(const lag_reserve *r, size_t side)
{
    const lag_model *model = r->motion->model;
    return side < model->ncontact ? model->contact_rows[side] : model->friction_rows[(size_t)r->frictions->first[side - model->ncontact]];
}

/* The change of the limit of a side with a multiplier. The limit of a contact is its force. */
static double gain_of(const lag_reserve *r, size_t side, size_t row)
{
    const lag_model *model = r->motion->model;
    return side < model->ncontact ? row == model->contact_rows[side] : r->frictions->sticking_gain[(side - model->ncontact) * model->nc + row];
}

/* 1: the side belongs to this group: a contact, or friction that sticks. */
static int is_in(const lag_reserve *r, size_t side, double group)
{
    const size_t row = row_of(r, side);
    return (loads_of(r, side) == 0 || sticks(r, side)) && (r->group[row] == group || (loads_of(r, side) > 1 && r->group[row + 1] == group));
}

/* The force of a side in which reserves are told. */
static double size_of(const lag_reserve *r, size_t side)
{
    const double length = r->length[row_of(r, side)];
    return length > 0.0 ? r->force_size / length : r->force_size;
}

/* ---- groups ---- */

/* Lengths of the rows that act, their forces, with the loads that they bring along, and sets of coordinates at which they act together, or share limits. */
static lag_status find_forces(lag_reserve *r)
{
    const lag_model *model = r->motion->model;
    const size_t n = model->nq;
    lag_status status = model->velocity_constraint(&r->motion->at, r->residual, r->forces);
    status = status == LAG_OK ? lag_loads_evaluate(&r->loads, model, &r->motion->at) : status;
    status = status == LAG_OK ? lag_loads_gain(&r->loads, model, &r->motion->at) : status;
    lag_separate(n, r->tied);
    for (size_t row = 0; row < model->nc && status == LAG_OK; ++row) {
        double *force = r->forces + row * n;
        r->length[row] = sqrt(lag_dot(n, force, force));
        if (r->length[row] > 0.0) {
            lag_loads_add_to_force(&r->loads, model, row, force);
        }
        r->place[row] = (double)(lag_first(n, force) % n);
        lag_join_entries(r->tied, n, force, (size_t)r->place[row]);
    }
    for (size_t side = model->ncontact; side < count_sides(r) && status == LAG_OK; ++side) {
        const size_t row = row_of(r, side);
        const size_t last = row + loads_of(r, side) - 1;
        for (size_t i = 0; i < model->nc && sticks(r, side); ++i) {
            if (gain_of(r, side, i) != 0.0 || i == last) {
                lag_join(r->tied, (size_t)r->place[row], (size_t)r->place[i]);
            }
        }
    }
    return status;
}

/* The multipliers of unit rows in this set of coordinates that act without effect; 1: there are some. */
static int find_basis(lag_reserve *r, size_t set)
{
    const lag_model *model = r->motion->model;
    const size_t n = model->nq;
    double *memory = r->work;
    double *columns = lag_take(&memory, n * model->nc);
    size_t m = 0;
    size_t rank = 0;
    for (size_t row = 0; row < model->nc; ++row) {
        r->group[m] = (double)row; /* the rows that act, for now */
        m += r->length[row] > 0.0 && lag_set_of(r->tied, (size_t)r->place[row]) == set;
    }
    for (size_t j = set; j < n; ++j) {
        const int is_own = lag_set_of(r->tied, j) == set;
        for (size_t k = 0; k < m && is_own; ++k) {
            const size_t row = (size_t)r->group[k];
            columns[rank * m + k] = r->forces[row * n + j] / r->length[row];
        }
        rank += (size_t)is_own;
    }
    const lag_svd svd = lag_svd_of(rank, m, columns, memory);
    rank = lag_svd_rank(&svd, RANK);
    r->undetermined = m - rank;
    lag_fill(r->undetermined * model->nc, 0.0, r->basis);
    for (size_t v = rank; v < m; ++v) {
        for (size_t k = 0; k < m; ++k) {
            const size_t row = (size_t)r->group[k];
            r->basis[(v - rank) * model->nc + row] = svd.v[v * m + k] / r->length[row];
        }
    }
    return r->undetermined > 0;
}

/* 1: rows a and b share forces. */
static int share(const lag_reserve *r, size_t a, size_t b)
{
    double part = 0.0;
    for (size_t v = 0; v < r->undetermined; ++v) {
        part += r->basis[v * r->motion->model->nc + a] * r->basis[v * r->motion->model->nc + b];
    }
    return fabs(part) * r->length[a] * r->length[b] > RANK;
}

/* Rows that share forces have one number, and friction that sticks that of the forces that its limit follows. */
static void find_groups(lag_reserve *r)
{
    const lag_model *model = r->motion->model;
    lag_separate(model->nc, r->group);
    for (size_t a = 0; a < model->nc; ++a) {
        for (size_t b = 0; b < a; ++b) {
            if (share(r, a, b)) {
                lag_join(r->group, a, b);
            }
        }
    }
    for (size_t side = model->ncontact; side < count_sides(r); ++side) {
        for (size_t i = 0; i < loads_of(r, side) * model->nc && sticks(r, side); ++i) {
            const size_t row = row_of(r, side) + i / model->nc;
            const size_t other = i % model->nc;
            if (gain_of(r, side, other) != 0.0 && share(r, row, row) && share(r, other, other)) {
                lag_join(r->group, row, other);
            }
        }
    }
    for (size_t row = model->nc; row-- > 0;) { /* those that share none have none */
        r->group[row] = share(r, row, row) ? (double)(lag_set_of(r->group, row) + 1) : 0.0;
    }
}

/* ---- the program of one group ---- */

/* A side with its limit and its load, by parts of the basis. */
static void add_side(const lag_reserve *r, lag_margins *margins, size_t side)
{
    const lag_model *model = r->motion->model;
    const size_t row = row_of(r, side);
    double *limit = lag_margins_add(margins, loads_of(r, side), size_of(r, side));
    limit[0] = side < model->ncontact ? r->motion->lam[row] : r->frictions->sticking[side - model->ncontact];
    for (size_t v = 0; v < r->undetermined; ++v) {
        const double *part = r->basis + v * model->nc;
        for (size_t i = 0; i < model->nc; ++i) {
            limit[1 + v] += gain_of(r, side, i) * part[i];
        }
        for (size_t k = 0; k < loads_of(r, side); ++k) {
            limit[(1 + k) * (1 + r->undetermined) + 1 + v] = part[row + k];
        }
    }
    for (size_t k = 0; k < loads_of(r, side); ++k) {
        limit[(1 + k) * (1 + r->undetermined)] = r->motion->lam[row + k];
    }
}

/* The size of the forces of a group, those that limits follow included; zero: nothing in it sticks. */
static double find_force_size(const lag_reserve *r, double group)
{
    const lag_model *model = r->motion->model;
    double size = 0.0;
    int any = 0;
    for (size_t side = model->ncontact; side < count_sides(r); ++side) {
        const int sticks = is_in(r, side, group);
        for (size_t row = 0; row < model->nc && sticks; ++row) {
            const int enters = r->group[row] == group || gain_of(r, side, row) != 0.0;
            size = enters ? fmax(size, fabs(r->motion->lam[row]) * r->length[row]) : size;
        }
        any = any || sticks;
    }
    return any ? size : 0.0;
}

/* The reserve of a group, and which of its sides have nothing left. */
static void find_reserve(lag_reserve *r, double group)
{
    lag_margins margins = lag_margins_of(r->undetermined, count_sides(r), r->work);
    size_t number = 0;
    r->force_size = find_force_size(r, group);
    for (size_t side = 0; side < count_sides(r) && r->force_size > 0.0; ++side) {
        if (is_in(r, side, group)) {
            add_side(r, &margins, side);
        }
    }
    const double reserve = margins.sides > 0 ? lag_margins_solve(&margins) : 0.0;
    for (size_t side = 0; side < count_sides(r) && number < margins.sides; ++side) {
        if (is_in(r, side, group)) {
            r->frictions->reserve[side] = reserve * size_of(r, side);
            r->empty[side] = lag_margin_of(&margins, number++) <= NOTHING * size_of(r, side);
        }
    }
}

/* The reserves of the groups in one set of coordinates. */
static void evaluate_set(lag_reserve *r, size_t set)
{
    if (!find_basis(r, set)) {
        return;
    }
    find_groups(r);
    for (size_t row = 0; row < r->motion->model->nc; ++row) {
        if (r->group[row] == (double)(row + 1)) { /* the first of its group */
            find_reserve(r, r->group[row]);
        }
    }
}

lag_status lag_reserve_evaluate(lag_reserve *r)
{
    const lag_model *model = r->motion->model;
    if (model->nfriction == 0) {
        return LAG_OK;
    }
    lag_fill(count_sides(r), (double)NAN, r->frictions->reserve);
    if (!lag_any(model->nfriction, r->motion->w + r->motion->places.sticks)) {
        return LAG_OK;
    }
    const lag_status status = find_forces(r);
    lag_fill(model->nq, 0.0, r->looked);
    for (size_t side = model->ncontact; side < count_sides(r) && status == LAG_OK; ++side) {
        const size_t set = lag_set_of(r->tied, (size_t)r->place[row_of(r, side)]);
        if (sticks(r, side) && r->looked[set] == 0.0) {
            r->looked[set] = 1.0;
            evaluate_set(r, set);
        }
    }
    return status;
}
