#include "lag/contacts/reserve_program.h"

#include <math.h>

#include "lag/linalg/arena.h"
#include "lag/linalg/linear_program.h"

/* A force outside of a disc by less than this part of its limit is in it. */
static const double OUTSIDE = 1e-13;
/* Tangents of a disc: four to begin with, and those that are added. */
enum { FIRST = 4, MORE = 12 };

static size_t most_rows(const lag_model *model)
{
    return model->ncontact + 2 * model->nfriction + (FIRST + MORE) * model->nfriction + 1;
}

/* Unknowns of the program: forces in either sense, and the reserve. */
static size_t most_unknowns(const lag_model *model)
{
    return 2 * model->nc + 1;
}

size_t lag_reserve_program_memory(const lag_model *model)
{
    const size_t rows = most_rows(model);
    const size_t unknowns = most_unknowns(model);
    return rows * (unknowns + 2) + 2 * unknowns + lag_linear_program_memory(unknowns, rows);
}

/* The active row of a row of the constraints; `count` where it does not act. */
static size_t active_of(const lag_reserve *r, size_t row)
{
    size_t k = 0;
    while (k < r->count && (size_t)r->active[k] != row) {
        ++k;
    }
    return k;
}

static double group_of(const lag_reserve *r, size_t row)
{
    const size_t k = active_of(r, row);
    return k < r->count ? r->group[k] : 0.0;
}

/* Inequalities a x <= b of unknowns x = (d+, d-, s) by active rows of the group. */
typedef struct program {
    size_t rows, unknowns;
    double *a, *b, *c, *x;
    double *memory;
} program;

static program begin(const lag_reserve *r)
{
    const lag_model *model = r->motion->model;
    double *memory = r->work;
    program p = {.unknowns = 2 * r->count + 1};
    p.a = lag_take(&memory, most_rows(model) * p.unknowns);
    p.b = lag_take(&memory, most_rows(model));
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
    p->b[p->rows++] = right;
    return row;
}

/* Adds `part` times the multiplier of a row of the constraints, as far as it is undetermined, to an inequality. */
static void add_force(const lag_reserve *r, double *row, size_t constraint, double part)
{
    const size_t m = r->count;
    const size_t k = active_of(r, constraint);
    for (size_t j = 0; j < m && k < m; ++j) {
        const double by = part * r->shared[k * m + j] / r->length[k];
        row[j] += by;
        row[m + j] -= by;
    }
}

/* The force of a row of the constraints in which reserves are told. */
static double size_of(const lag_reserve *r, size_t constraint)
{
    const size_t k = active_of(r, constraint);
    return k < r->count ? r->force_size / r->length[k] : r->force_size;
}

static double size_of_friction(const lag_reserve *r, size_t k)
{
    return size_of(r, r->motion->model->friction_rows[(size_t)r->frictions->first[k]]);
}

/* along . (lam_t + d_t) + s size <= R_0 with the forces d. */
static void add_tangent(lag_reserve *r, program *p, size_t k, const double *along)
{
    const lag_frictions *frictions = r->frictions;
    const lag_model *model = r->motion->model;
    const size_t *rows = model->friction_rows + (size_t)frictions->first[k];
    const double *gain = frictions->sticking_gain + k * model->nc;
    const size_t components = lag_frictions_components(frictions, k);
    double right = frictions->sticking[k];
    for (size_t a = 0; a < components; ++a) {
        right -= along[a] * r->motion->lam[rows[a]];
    }
    double *row = add_row(p, size_of_friction(r, k), right);
    for (size_t a = 0; a < components; ++a) {
        add_force(r, row, rows[a], along[a]);
    }
    for (size_t i = 0; i < model->nc; ++i) {
        if (gain[i] != 0.0) {
            add_force(r, row, i, -gain[i]);
        }
    }
}

static void add_friction(lag_reserve *r, program *p, size_t k)
{
    const size_t *rows = r->motion->model->friction_rows + (size_t)r->frictions->first[k];
    const double length = lag_frictions_force(r->frictions, k);
    double along[2] = {1.0, 0.0};
    if (lag_frictions_components(r->frictions, k) > 1 && length > 0.0) {
        along[0] = r->motion->lam[rows[0]] / length;
        along[1] = r->motion->lam[rows[1]] / length;
    }
    const double sides[FIRST][2] = {{along[0], along[1]}, {-along[0], -along[1]}, {-along[1], along[0]}, {along[1], -along[0]}};
    for (size_t i = 0; i < (lag_frictions_components(r->frictions, k) > 1 ? FIRST : 2); ++i) {
        add_tangent(r, p, k, sides[i]);
    }
}

/* The reserve begins with that of the smallest forces, so that the program has a solution to begin with. */
static double shift(program *p)
{
    double least = (double)INFINITY;
    for (size_t i = 0; i < p->rows; ++i) {
        least = fmin(least, p->b[i] / p->a[i * p->unknowns + p->unknowns - 1]);
    }
    return least;
}

static int solve(program *p, double least)
{
    double *b = p->b;
    for (size_t i = 0; i < p->rows; ++i) {
        b[i] = fmax(b[i] - least * p->a[i * p->unknowns + p->unknowns - 1], 0.0);
    }
    const int found = lag_linear_program(p->unknowns, p->rows, p->a, b, p->c, p->x, p->memory);
    for (size_t i = 0; i < p->rows; ++i) {
        b[i] += least * p->a[i * p->unknowns + p->unknowns - 1];
    }
    return found;
}

/* Multipliers with the solution of the program. */
static void take_forces(lag_reserve *r, const program *p, double group)
{
    const size_t m = r->count;
    for (size_t k = 0; k < m; ++k) {
        if (r->group[k] == group) {
            double change = 0.0;
            for (size_t j = 0; j < m; ++j) {
                change += r->shared[k * m + j] * (p->x[j] - p->x[m + j]);
            }
            r->force[(size_t)r->active[k]] = r->motion->lam[(size_t)r->active[k]] + change / r->length[k];
        }
    }
}

static int is_in(const lag_reserve *r, size_t k, double group)
{
    const size_t row = r->motion->model->friction_rows[(size_t)r->frictions->first[k]];
    const size_t other = row + lag_frictions_components(r->frictions, k) - 1;
    return *lag_frictions_sticks(r->frictions, k) != 0.0 && (group_of(r, row) == group || group_of(r, other) == group);
}

/* The limit of friction k with the forces of the program, and the length of its own force. */
static double limit_of(const lag_reserve *r, size_t k, double *length)
{
    const lag_model *model = r->motion->model;
    const size_t row = model->friction_rows[(size_t)r->frictions->first[k]];
    const double *gain = r->frictions->sticking_gain + k * model->nc;
    double limit = r->frictions->sticking[k];
    for (size_t i = 0; i < model->nc; ++i) {
        limit += gain[i] != 0.0 ? gain[i] * (r->force[i] - r->motion->lam[i]) : 0.0;
    }
    *length = lag_slip_length(lag_frictions_components(r->frictions, k), r->force + row);
    return limit;
}

/* Tangents where forces of friction in a plane are beyond their discs, less the reserve; 1: some were added. */
static int refine(lag_reserve *r, program *p, double group, double reserve)
{
    const lag_frictions *frictions = r->frictions;
    int added = 0;
    for (size_t k = 0; k < r->motion->model->nfriction; ++k) {
        if (lag_frictions_components(frictions, k) > 1 && is_in(r, k, group)) {
            const size_t *rows = r->motion->model->friction_rows + (size_t)frictions->first[k];
            double length = 0.0;
            const double limit = limit_of(r, k, &length);
            if (length + reserve * size_of_friction(r, k) > limit + OUTSIDE * size_of_friction(r, k)) {
                const double along[2] = {r->force[rows[0]] / length, r->force[rows[1]] / length};
                add_tangent(r, p, k, along);
                added = 1;
            }
        }
    }
    return added;
}

static void keep(lag_reserve *r, double group, double reserve)
{
    const lag_model *model = r->motion->model;
    for (size_t i = 0; i < model->ncontact; ++i) {
        const size_t row = model->contact_rows[i];
        if (group_of(r, row) == group) {
            r->frictions->reserve[i] = reserve * size_of(r, row);
            r->slack[i] = r->force[row];
            r->size[i] = size_of(r, row);
            r->member[i] = group;
        }
    }
    for (size_t k = 0; k < model->nfriction; ++k) {
        if (is_in(r, k, group)) {
            double length = 0.0;
            const double limit = limit_of(r, k, &length);
            r->frictions->reserve[model->ncontact + k] = reserve * size_of_friction(r, k);
            r->slack[model->ncontact + k] = limit - length;
            r->size[model->ncontact + k] = size_of_friction(r, k);
            r->member[model->ncontact + k] = group;
        }
    }
}

void lag_reserve_find(lag_reserve *r, double group)
{
    const lag_model *model = r->motion->model;
    program p = begin(r);
    int any = 0;
    r->force_size = 0.0;
    for (size_t k = 0; k < r->count; ++k) {
        const size_t row = (size_t)r->active[k];
        int enters = r->group[k] == group;
        for (size_t f = 0; f < model->nfriction; ++f) { /* a limit follows it */
            enters = enters || (r->frictions->sticking_gain[f * model->nc + row] != 0.0 && is_in(r, f, group));
        }
        r->force_size = enters ? fmax(r->force_size, fabs(r->motion->lam[row]) * r->length[k]) : r->force_size;
    }
    for (size_t k = 0; k < model->nfriction; ++k) {
        if (is_in(r, k, group)) {
            add_friction(r, &p, k);
            any = 1;
        }
    }
    for (size_t i = 0; i < model->ncontact && any; ++i) {
        if (group_of(r, model->contact_rows[i]) == group) {
            double *row = add_row(&p, size_of(r, model->contact_rows[i]), r->motion->lam[model->contact_rows[i]]);
            add_force(r, row, model->contact_rows[i], -1.0);
        }
    }
    if (!any || !(r->force_size > 0.0)) {
        return;
    }
    (void)add_row(&p, 1.0, 1.0); /* forces may press against each other as much as they like */
    const double least = shift(&p);
    for (int k = 0; k <= MORE && solve(&p, least); ++k) {
        take_forces(r, &p, group);
        if (!refine(r, &p, group, p.x[p.unknowns - 1] + least)) {
            break;
        }
    }
    keep(r, group, p.x[p.unknowns - 1] + least);
}
