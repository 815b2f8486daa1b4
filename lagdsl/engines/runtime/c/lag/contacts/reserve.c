#include "lag/contacts/reserve.h"

#include <math.h>
#include <string.h>

#include "lag/linalg/arena.h"
#include "lag/linalg/linear_program.h"
#include "lag/linalg/svd.h"
#include "lag/linalg/vector.h"

/* Unit rows are dependent where a singular value is below this part of the largest, and share forces by more than this. */
static const double RANK = 1e-9;
/* A force outside of a disc by less than this part of its limit is in it. */
static const double OUTSIDE = 1e-13;
/* Tangents of a disc: four to begin with, and those that are added. */
enum { FIRST = 4, MORE = 12 };

static size_t most_inequalities(const lag_model *model)
{
    return model->ncontact + (FIRST + MORE + 1) * model->nfriction + 1;
}

static size_t work_memory(const lag_model *model)
{
    const size_t rows = most_inequalities(model);
    const size_t unknowns = 2 * model->nc + 1;
    const size_t program = rows * (unknowns + 2) + 2 * unknowns + lag_linear_program_memory(unknowns, rows);
    return lag_larger(program, model->nq * model->nc + lag_svd_memory(model->nq, model->nc));
}

void lag_reserve_place(lag_reserve *reserve, lag_frictions *frictions, lag_layout *layout)
{
    const lag_model *model = frictions->motion->model;
    const size_t sides = model->ncontact + model->nfriction;
    *reserve = (lag_reserve){.motion = frictions->motion, .frictions = frictions};
    if (model->nfriction == 0) {
        return;
    }
    reserve->jacobian = lag_lay(layout, model->nc * model->nq);
    lag_lay_all(layout, model->nc, (double **const[]){&reserve->residual, &reserve->length, &reserve->group, &reserve->force, NULL});
    reserve->basis = lag_lay(layout, model->nc * model->nc);
    lag_lay_all(layout, sides, (double **const[]){&reserve->slack, &reserve->size, &reserve->member, NULL});
    lag_loads_place(&reserve->loads, model, layout);
    reserve->work = lag_lay(layout, work_memory(model));
}

/* ---- sides: contacts, and behind them frictions ---- */

static int is_contact(const lag_reserve *r, size_t side)
{
    return side < r->motion->model->ncontact;
}

/* The rows of the forces that load a side: those of friction. */
static size_t loads_of(const lag_reserve *r, size_t side)
{
    return is_contact(r, side) ? 0 : lag_frictions_components(r->frictions, side - r->motion->model->ncontact);
}

static size_t row_of(const lag_reserve *r, size_t side)
{
    const lag_model *model = r->motion->model;
    return is_contact(r, side) ? model->contact_rows[side] : model->friction_rows[(size_t)r->frictions->first[side - model->ncontact]];
}

/* Change of the limit of a side with the multiplier of a row: a contact bears its own force. */
static double gain_of(const lag_reserve *r, size_t side, size_t row)
{
    const lag_model *model = r->motion->model;
    return is_contact(r, side) ? (double)(row == row_of(r, side)) : r->frictions->sticking_gain[(side - model->ncontact) * model->nc + row];
}

/* The limit of a side with these forces (nc). */
static double limit_of(const lag_reserve *r, size_t side, const double *force)
{
    const lag_model *model = r->motion->model;
    double limit = is_contact(r, side) ? r->motion->lam[row_of(r, side)] : r->frictions->sticking[side - model->ncontact];
    for (size_t i = 0; i < model->nc; ++i) {
        const double gain = gain_of(r, side, i);
        limit += gain != 0.0 ? gain * (force[i] - r->motion->lam[i]) : 0.0;
    }
    return limit;
}

static double load_of(const lag_reserve *r, size_t side, const double *force)
{
    return is_contact(r, side) ? 0.0 : lag_slip_length(loads_of(r, side), force + row_of(r, side));
}

/* 1: the side belongs to this group: a contact, or friction that sticks. */
static int is_in(const lag_reserve *r, size_t side, double group)
{
    const size_t row = row_of(r, side);
    const int holds = is_contact(r, side) || *lag_frictions_sticks(r->frictions, side - r->motion->model->ncontact) != 0.0;
    return holds && (r->group[row] == group || (loads_of(r, side) > 1 && r->group[row + 1] == group));
}

/* The force of a side in which reserves are told. */
static double size_of(const lag_reserve *r, size_t side)
{
    const double length = r->length[row_of(r, side)];
    return length > 0.0 ? r->force_size / length : r->force_size;
}

/* ---- groups ---- */

/* Lengths of the rows that act. */
static lag_status find_lengths(lag_reserve *r)
{
    const lag_model *model = r->motion->model;
    const size_t n = model->nq;
    const lag_status status = model->velocity_constraint(&r->motion->at, r->residual, r->jacobian);
    for (size_t i = 0; i < model->nc; ++i) {
        r->length[i] = sqrt(lag_dot(n, r->jacobian + i * n, r->jacobian + i * n));
    }
    return status;
}

/* The forces of unit rows that act without effect, with the loads that they bring along; 1: there are some. */
static int find_basis(lag_reserve *r)
{
    const lag_model *model = r->motion->model;
    const size_t n = model->nq;
    double *memory = r->work;
    double *columns = lag_take(&memory, n * model->nc);
    size_t m = 0;
    for (size_t row = 0; row < model->nc; ++row) {
        r->group[m] = (double)row; /* the rows that act, for now */
        m += r->length[row] > 0.0;
    }
    for (size_t k = 0; k < m; ++k) {
        for (size_t j = 0; j < n; ++j) {
            const size_t row = (size_t)r->group[k];
            double force = r->jacobian[row * n + j];
            for (size_t l = 0; l < model->nload; ++l) { /* a force is the negative of how M qdd - f changes */
                force -= r->loads.motion[j * model->nload + l] * r->loads.by_multiplier[l * model->nc + row];
            }
            columns[j * m + k] = force / r->length[row];
        }
    }
    r->undetermined = 0;
    lag_fill(model->nc * model->nc, 0.0, r->basis);
    if (m == 0) {
        return 0;
    }
    const lag_svd svd = lag_svd_of(n, m, columns, memory);
    for (size_t v = lag_svd_rank(&svd, RANK); v < m; ++v) {
        for (size_t k = 0; k < m; ++k) {
            r->basis[r->undetermined * model->nc + (size_t)r->group[k]] = svd.v[v * m + k];
        }
        ++r->undetermined;
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
    return fabs(part) > RANK;
}

/* Rows a and b, and those that share forces with them, have one number from now on, if both share any. */
static void join(lag_reserve *r, size_t a, size_t b)
{
    const double one = r->group[a];
    const double other = r->group[b];
    for (size_t i = 0; i < r->motion->model->nc && one * other > 0.0; ++i) {
        r->group[i] = r->group[i] == other ? one : r->group[i];
    }
}

/* Rows that share forces have one number, and friction that sticks that of the forces that its limit follows. */
static void find_groups(lag_reserve *r)
{
    const lag_model *model = r->motion->model;
    for (size_t a = 0; a < model->nc; ++a) {
        r->group[a] = share(r, a, a) ? (double)(a + 1) : 0.0;
    }
    for (size_t a = 0; a < model->nc; ++a) {
        for (size_t b = 0; b < a; ++b) {
            if (share(r, a, b)) {
                join(r, b, a);
            }
        }
    }
    for (size_t side = model->ncontact; side < model->ncontact + model->nfriction; ++side) {
        const int sticks = *lag_frictions_sticks(r->frictions, side - model->ncontact) != 0.0;
        for (size_t a = 0; a < loads_of(r, side) && sticks; ++a) {
            for (size_t i = 0; i < model->nc; ++i) {
                if (gain_of(r, side, i) != 0.0) {
                    join(r, row_of(r, side) + a, i);
                }
            }
        }
    }
}

/* ---- the program of one group ---- */

/* Inequalities a x <= b of unknowns x = (y+, y-, s), with y the parts of the basis. */
typedef struct program {
    size_t rows, unknowns;
    double least; /* the reserve of the smallest forces, from which s counts: the program has a solution to begin with */
    double *a, *b, *c, *x;
    double *memory;
} program;

static program begin(const lag_reserve *r)
{
    const size_t rows = most_inequalities(r->motion->model);
    double *memory = r->work;
    program p = {.unknowns = 2 * r->undetermined + 1};
    p.a = lag_take(&memory, rows * p.unknowns);
    p.b = lag_take(&memory, rows);
    p.c = lag_take(&memory, p.unknowns);
    p.x = lag_take(&memory, p.unknowns);
    p.memory = memory;
    lag_fill(p.unknowns, 0.0, p.c);
    p.c[p.unknowns - 1] = 1.0;
    return p;
}

static double *add_row(program *p, double size, double right)
{
    double *row = p->a + p->rows * p->unknowns;
    lag_fill(p->unknowns, 0.0, row);
    row[p->unknowns - 1] = size;
    p->b[p->rows++] = right - p->least * size;
    return row;
}

/* Adds `part` times the multiplier of a row of the constraints, as far as it is undetermined, to an inequality. */
static void add_force(const lag_reserve *r, double *inequality, size_t row, double part)
{
    for (size_t v = 0; v < r->undetermined && r->length[row] > 0.0; ++v) {
        const double by = part * r->basis[v * r->motion->model->nc + row] / r->length[row];
        inequality[v] += by;
        inequality[r->undetermined + v] -= by;
    }
}

/* along . (lam_t + d_t) + s size <= R_0 with the forces d. */
static void add_tangent(lag_reserve *r, program *p, size_t side, const double *along)
{
    const size_t row = row_of(r, side);
    const size_t count = loads_of(r, side);
    double *inequality = add_row(p, size_of(r, side), limit_of(r, side, r->motion->lam) - lag_dot(count, along, r->motion->lam + row));
    for (size_t a = 0; a < count; ++a) {
        add_force(r, inequality, row + a, along[a]);
    }
    for (size_t i = 0; i < r->motion->model->nc; ++i) {
        if (gain_of(r, side, i) != 0.0) {
            add_force(r, inequality, i, -gain_of(r, side, i));
        }
    }
}

/* A contact has one inequality, friction one in each sense, in a plane four around its force. */
static void add_side(lag_reserve *r, program *p, size_t side)
{
    const double *force = r->motion->lam + row_of(r, side);
    const size_t count = loads_of(r, side);
    const double length = load_of(r, side, r->motion->lam);
    const int turns = count > 1 && length > 0.0;
    const double along[2] = {turns ? force[0] / length : 1.0, turns ? force[1] / length : 0.0};
    const double ways[FIRST][2] = {{along[0], along[1]}, {-along[0], -along[1]}, {-along[1], along[0]}, {along[1], -along[0]}};
    for (size_t i = 0; i < (count > 0 ? 2 * count : 1); ++i) {
        add_tangent(r, p, side, ways[i]);
    }
}

static void shift(program *p)
{
    p->least = (double)INFINITY;
    for (size_t i = 0; i < p->rows; ++i) {
        p->least = fmin(p->least, p->b[i] / p->a[i * p->unknowns + p->unknowns - 1]);
    }
    for (size_t i = 0; i < p->rows; ++i) {
        p->b[i] -= p->least * p->a[i * p->unknowns + p->unknowns - 1];
    }
}

static int solve(program *p)
{
    for (size_t i = 0; i < p->rows; ++i) {
        p->b[i] = fmax(p->b[i], 0.0);
    }
    return lag_linear_program(p->unknowns, p->rows, p->a, p->b, p->c, p->x, p->memory);
}

/* Multipliers with the solution of the program. */
static void take_forces(lag_reserve *r, const program *p, double group)
{
    const size_t m = r->motion->model->nc;
    for (size_t k = 0; k < m; ++k) {
        if (r->group[k] == group) {
            double change = 0.0;
            for (size_t v = 0; v < r->undetermined; ++v) {
                change += r->basis[v * m + k] * (p->x[v] - p->x[r->undetermined + v]);
            }
            r->force[k] = r->motion->lam[k] + change / r->length[k];
        }
    }
}

/* Tangents where forces of friction in a plane are beyond their discs, less the reserve; 1: some were added. */
static int refine(lag_reserve *r, program *p, double group, double reserve)
{
    const lag_model *model = r->motion->model;
    int added = 0;
    for (size_t side = model->ncontact; side < model->ncontact + model->nfriction; ++side) {
        const double *force = r->force + row_of(r, side);
        const double length = load_of(r, side, r->force);
        if (loads_of(r, side) > 1 && is_in(r, side, group) && length + (reserve - OUTSIDE) * size_of(r, side) > limit_of(r, side, r->force)) {
            const double along[2] = {force[0] / length, force[1] / length};
            add_tangent(r, p, side, along);
            added = 1;
        }
    }
    return added;
}

/* The reserve of a group, and what its sides have left; one in which nothing sticks has none. */
static void find_reserve(lag_reserve *r, double group)
{
    const lag_model *model = r->motion->model;
    const size_t sides = model->ncontact + model->nfriction;
    program p = begin(r);
    int any = 0;
    r->force_size = 0.0;
    for (size_t row = 0; row < model->nc; ++row) {
        int enters = r->group[row] == group;
        for (size_t side = model->ncontact; side < sides; ++side) { /* a limit follows it */
            enters = enters || (gain_of(r, side, row) != 0.0 && is_in(r, side, group));
        }
        r->force_size = enters ? fmax(r->force_size, fabs(r->motion->lam[row]) * r->length[row]) : r->force_size;
    }
    for (size_t side = model->ncontact; side < sides; ++side) {
        any = any || is_in(r, side, group);
    }
    for (size_t side = 0; side < sides && any && r->force_size > 0.0; ++side) {
        if (is_in(r, side, group)) {
            add_side(r, &p, side);
        }
    }
    if (p.rows == 0) {
        return;
    }
    (void)add_row(&p, 1.0, 1.0); /* forces may press against each other as much as they like */
    shift(&p);
    int again = 1;
    for (int k = 0; k <= MORE && again && solve(&p); ++k) {
        take_forces(r, &p, group);
        again = refine(r, &p, group, p.x[p.unknowns - 1] + p.least);
    }
    for (size_t side = 0; side < sides; ++side) {
        if (is_in(r, side, group)) {
            r->frictions->reserve[side] = (p.x[p.unknowns - 1] + p.least) * size_of(r, side);
            r->slack[side] = limit_of(r, side, r->force) - load_of(r, side, r->force);
            r->size[side] = size_of(r, side);
            r->member[side] = group;
        }
    }
}

lag_status lag_reserve_evaluate(lag_reserve *r)
{
    const lag_model *model = r->motion->model;
    if (model->nfriction == 0) {
        return LAG_OK;
    }
    memcpy(r->force, r->motion->lam, model->nc * sizeof(double));
    lag_fill(model->ncontact + model->nfriction, (double)NAN, r->frictions->reserve);
    if (!lag_any(model->nfriction, r->motion->w + r->motion->places.sticks)) {
        return LAG_OK;
    }
    lag_status status = find_lengths(r);
    status = status == LAG_OK ? lag_loads_evaluate(&r->loads, model, &r->motion->at) : status;
    status = status == LAG_OK ? lag_loads_gain(&r->loads, model, &r->motion->at) : status;
    if (status != LAG_OK || !find_basis(r)) {
        return status;
    }
    find_groups(r);
    for (size_t row = 0; row < model->nc; ++row) {
        if (r->group[row] == (double)(row + 1)) { /* the first of its group */
            find_reserve(r, r->group[row]);
        }
    }
    return LAG_OK;
}
