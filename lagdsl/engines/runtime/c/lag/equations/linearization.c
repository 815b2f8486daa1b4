/*
 * Columns that share no row along one direction (Curtis, Powell, Reid, J. Inst. Maths Applics 13 (1974) 117). M and J, which multiply accelerations
 * and multipliers, need no directions of their own.
 */
#include "lag/equations/jacobian.h"
#include "lag/equations/motion.h"

#include "lag/linalg/arena.h"
#include "lag/linalg/finite.h"

/* Arrays in lanes: directions of q, qd, z, u, p, then of accelerations and multipliers, and what follows from them. */
typedef struct places {
    double *x, *dqdd, *dlam;
    double *motion, *rows, *rates; /* (nq) (nc) (nz), of all groups, as many at once as there are lanes */
    double *qdd, *lam, *pivot;     /* of the functions of several directions; (nq), (nc), in lanes */
} places;

/* Functions of directions, at the state that they are asked at. */
typedef struct functions {
    size_t lanes;
    lag_arguments at;
    lag_status (*residual)(const lag_arguments *at, double *motion, double *rows);
    lag_status (*state_derivative)(const lag_arguments *at, double *rates);
} functions;

/* Groups of columns, as many as fill all lanes. */
static size_t groups_of(const lag_model *model, size_t lanes)
{
    const lag_patterns *patterns = model->patterns;
    const int told = patterns != NULL && patterns->equations != NULL;
    const size_t state = told ? lag_pattern_groups(2 * model->nq + model->nz, patterns->group) : 0;
    const size_t values = told ? lag_pattern_groups(model->nq + model->nc, patterns->value_group) : 0;
    return (lag_larger(state, values) + lanes - 1) / lanes * lanes;
}

size_t lag_linearization_memory(const lag_model *model, size_t lanes)
{
    return groups_of(model, lanes) * (model->nq + model->nc + model->nz);
}

/* In lag_jacobian_memory(), which has these arrays, too. */
static places place(const lag_model *model, size_t lanes, double *memory)
{
    const size_t groups = groups_of(model, lanes);
    places to;
    to.x = lag_take(&memory, lanes * (2 * model->nq + model->nz + model->nu + model->np));
    to.dqdd = lag_take(&memory, lanes * model->nq);
    to.dlam = lag_take(&memory, lanes * model->nc);
    to.motion = lag_take(&memory, groups * model->nq);
    to.rows = lag_take(&memory, groups * model->nc);
    to.rates = lag_take(&memory, groups * model->nz);
    to.pivot = lag_take(&memory, lanes);
    to.qdd = lag_take(&memory, model->nq);
    to.lam = lag_take(&memory, model->nc);
    return to;
}

static void point_at(const lag_model *model, functions *f, const places *to)
{
    f->at.dq = to->x;
    f->at.dqd = f->at.dq + f->lanes * model->nq;
    f->at.dz = f->at.dqd + f->lanes * model->nq;
    f->at.du = f->at.dz + f->lanes * model->nz;
    f->at.dp = f->at.du + f->lanes * model->nu;
    f->at.dqdd = to->dqdd;
    f->at.dlam = to->dlam;
}

/* The functions of several directions, at the state of the motion. LAG_MISSING: there are none, or they are not to be used here. */
static lag_status find_many(const lag_motion *motion, const lag_along *along, functions *f, places *to)
{
    const lag_tangents *tangents = along->tangents;
    if (tangents == NULL || tangents->lanes < 2 || tangents->residual == NULL) {
        return LAG_MISSING;
    }
    *to = place(motion->model, tangents->lanes, along->memory);
    *f = (functions){tangents->lanes, motion->at, tangents->residual, tangents->state_derivative};
    f->at.context = along->model->context;
    f->at.workspace = along->workspace;
    f->at.kept = NULL;
    point_at(motion->model, f, to);
    if (tangents->motion == NULL) {
        return tangents->primal(&f->at);
    }
    const lag_status status = tangents->motion(&f->at, to->qdd, to->lam, to->pivot);
    return status == LAG_OK && !(to->pivot[0] > lag_smallest_pivot(motion->model)) ? LAG_MISSING : status;
}

/* Functions of the model itself, one direction after the other. */
static void find_one(const lag_motion *motion, functions *f, places *to)
{
    *to = place(motion->model, 1, motion->memory);
    *f = (functions){1, motion->at, motion->model->residual_tangent, motion->model->state_derivative_tangent};
    point_at(motion->model, f, to);
}

/* Directions of the columns from `first` to before `end` whose groups begin at `group`, in lanes of `x`; or zeros again. */
static void set_directions(size_t first, size_t end, const size_t *of, size_t group, size_t lanes, double value, double *x)
{
    for (size_t j = first; j < end; ++j) {
        if (of[j] - group < lanes) { /* no number is negative */
            x[(j - first) * lanes + of[j] - group] = value;
        }
    }
}

/* Entries of rows first and following, in columns from `column` on, which ascend, out of the lanes of `rows` rows along all groups. */
static void take(const lag_pattern *pattern, size_t first, size_t rows, size_t column, size_t columns, const size_t *of, size_t lanes,
    double sign, const double *found, double *entries)
{
    for (size_t i = first; i < first + rows; ++i) {
        size_t k = pattern->first[i];
        while (k < pattern->first[i + 1] && pattern->column[k] < column) {
            ++k;
        }
        for (; k < pattern->first[i + 1] && pattern->column[k] < column + columns; ++k) {
            const size_t group = of[pattern->column[k] - column];
            entries[k] = sign * found[(group / lanes * rows + i - first) * lanes + group % lanes];
        }
    }
}

/* Derivatives by q, qd and z. */
static lag_status by_state(const lag_model *model, const functions *f, const places *to, double *entries)
{
    const lag_pattern *pattern = model->patterns->equations;
    const size_t *of = model->patterns->group;
    const size_t n = lag_motion_size(model);
    const size_t count = lag_pattern_groups(n, of);
    lag_status status = LAG_OK;
    for (size_t group = 0; group < count && status == LAG_OK; group += f->lanes) {
        set_directions(0, n, of, group, f->lanes, 1.0, to->x);
        status = f->residual(&f->at, to->motion + group * model->nq, to->rows + group * model->nc);
        if (status == LAG_OK && model->nz > 0) {
            status = f->state_derivative(&f->at, to->rates + group * model->nz);
        }
        set_directions(0, n, of, group, f->lanes, 0.0, to->x);
    }
    if (status == LAG_OK) {
        take(pattern, 0, model->nq, 0, n, of, f->lanes, -1.0, to->motion, entries);
        take(pattern, model->nq, model->nz, 0, n, of, f->lanes, 1.0, to->rates, entries);
        take(pattern, model->nq + model->nz, model->nc, 0, n, of, f->lanes, -1.0, to->rows, entries);
    }
    return status;
}

/* Of the rates of states by accelerations and multipliers. */
static lag_status of_rates_by_values(const lag_model *model, const functions *f, const places *to, double *entries)
{
    const lag_pattern *pattern = model->patterns->equations;
    const size_t *of = model->patterns->value_group;
    const size_t values = model->nq + model->nc;
    const size_t count = model->nz > 0 ? lag_pattern_groups(values, of) : 0;
    lag_status status = LAG_OK;
    for (size_t group = 0; group < count && status == LAG_OK; group += f->lanes) {
        set_directions(0, model->nq, of, group, f->lanes, 1.0, to->dqdd);
        set_directions(model->nq, values, of, group, f->lanes, 1.0, to->dlam);
        status = f->state_derivative(&f->at, to->rates + group * model->nz);
        set_directions(0, model->nq, of, group, f->lanes, 0.0, to->dqdd);
        set_directions(model->nq, values, of, group, f->lanes, 0.0, to->dlam);
    }
    if (status == LAG_OK && count > 0) {
        take(pattern, model->nq, model->nz, lag_motion_size(model), values, of, f->lanes, 1.0, to->rates, entries);
    }
    return status;
}

/* M, where it is not written out by its products. */
static lag_status take_mass(const lag_motion *motion, const places *to, double *entries)
{
    const lag_model *model = motion->model;
    const lag_pattern *pattern = model->patterns->equations;
    const size_t *of = model->patterns->value_group;
    const size_t n = model->nq;
    const size_t state = lag_motion_size(model);
    if (model->momentum_tangent == NULL) {
        const lag_status status = model->mass_matrix(&motion->at, motion->written.mass);
        for (size_t k = 0; k < pattern->first[n]; ++k) {
            const size_t j = pattern->column[k] - state;
            entries[k] = j < n ? -motion->written.mass[pattern->row[k] * n + j] : entries[k];
        }
        return status;
    }
    const size_t count = lag_pattern_groups(n, of);
    lag_arguments at = motion->at;
    lag_status status = LAG_OK;
    at.dqd = to->dqdd;
    for (size_t group = 0; group < count && status == LAG_OK; ++group) {
        set_directions(0, n, of, group, 1, 1.0, to->dqdd);
        status = model->momentum_tangent(&at, to->motion + group * n);
        set_directions(0, n, of, group, 1, 0.0, to->dqdd);
    }
    if (status == LAG_OK) {
        take(pattern, 0, n, state, n, of, 1, -1.0, to->motion, entries);
    }
    return status;
}

/* J and J'. */
static lag_status take_rows(const lag_motion *motion, const places *to, double *entries)
{
    const lag_model *model = motion->model;
    const lag_pattern *pattern = model->patterns->equations;
    const size_t n = model->nq;
    const size_t state = lag_motion_size(model);
    const size_t rows = n + model->nz;
    const double *jacobian = motion->written.rows[1];
    const lag_status status = model->nc > 0 ? model->velocity_constraint(&motion->at, to->rows, motion->written.rows[1]) : LAG_OK;
    for (size_t k = 0; k < pattern->count; ++k) {
        const size_t i = pattern->row[k];
        const size_t j = pattern->column[k];
        if (i < n && j >= state + n) {
            entries[k] = jacobian[(j - state - n) * n + i];
        } else if (i >= rows && j >= state) {
            entries[k] = j < state + n ? -jacobian[(i - rows) * n + j - state] : 0.0;
        }
    }
    return status;
}

lag_status lag_motion_linearize(void *context, double t, const double *x, double *entries)
{
    lag_motion *motion = context;
    const lag_model *model = motion->model;
    const size_t directions = lag_pattern_groups(lag_motion_size(model), model->patterns->group);
    const lag_along along = lag_motion_functions(motion, directions);
    functions f;
    places to;
    lag_status status = lag_motion_solve(motion, t, x);
    if (status != LAG_OK) {
        return status;
    }
    status = find_many(motion, &along, &f, &to);
    if (status == LAG_MISSING) {
        find_one(motion, &f, &to);
        status = LAG_OK;
    }
    lag_fill((size_t)(to.motion - to.x), 0.0, to.x);
    status = status == LAG_OK ? by_state(model, &f, &to, entries) : status;
    status = status == LAG_OK ? of_rates_by_values(model, &f, &to, entries) : status;
    status = status == LAG_OK ? take_mass(motion, &to, entries) : status;
    status = status == LAG_OK ? take_rows(motion, &to, entries) : status;
    return status == LAG_OK && !lag_finite(model->patterns->equations->count, entries) ? LAG_NOT_FINITE : status;
}
