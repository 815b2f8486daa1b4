/* The order in which a start is found. */
#include "lag/initial.h"

#include <math.h>
#include <string.h>

#include "lag/equations/entries.h"
#include "lag/initial/initial_scaling.h"
#include "lag/linalg/arena.h"
#include "lag/linalg/svd.h"

size_t lag_initial_memory(const lag_model *model)
{
    const size_t q = lag_larger(lag_initialization_q_memory(model), lag_initialization_qd_memory(model));
    const size_t all = model->ne > 0 ? lag_initialization_all_memory(model) : 0;
    const size_t ranks = lag_larger(lag_initialization_rank_memory(model), lag_initialization_count_memory(model));
    const size_t sizes = lag_initialization_row_sizes_memory(model);
    return model->nc + model->ne == 0 ? 0 : lag_initialization_memory(model) + lag_larger(lag_larger(q, all), lag_larger(ranks, sizes));
}

static size_t first_wrong(size_t count, const double *x)
{
    size_t i = 0;
    while (i < count && isfinite(x[i])) {
        ++i;
    }
    return i;
}

/* A start value or a row there that is no number. */
static int find_no_number(lag_initialization *b)
{
    const lag_model *model = b->motion->model;
    const size_t size = lag_motion_size(model);
    size_t wrong = first_wrong(size, b->starts.x);
    if (wrong == size && model->nc > 0) {
        lag_initialization_positions(b);
        const size_t row = first_wrong(model->nc, b->phi);
        lag_initialization_velocities(b);
        const size_t other = first_wrong(model->nc, b->phi);
        wrong += row < other ? row : other;
    }
    if (wrong == size + model->nc) {
        return 0;
    }
    b->told.fault = LAG_INITIAL_NUMBERS;
    b->told.which = wrong;
    return 1;
}

/* Ranks are those the model was compiled with where nothing is other than then. */
static int as_compiled(const lag_initialization *b, const unsigned char *set)
{
    int alike = lag_initialization_has_defaults(b);
    for (size_t i = 0; alike && set != NULL && i < lag_motion_size(b->motion->model); ++i) {
        alike = !set[i];
    }
    return alike;
}

static void find(lag_initialization *b, const unsigned char *set, double *x)
{
    const lag_model *model = b->motion->model;
    if (b->told.fault != LAG_INITIAL_NONE || find_no_number(b)) {
        return;
    }
    if (model->ne > 0 && !b->told.given) {
        double *memory = b->memory;
        lag_initialization_find_all(b, x);
        b->memory = memory;
    } else {
        lag_initialization_find_q(b, x);
        if (b->told.fault == LAG_INITIAL_NONE) {
            lag_initialization_find_qd(b, x);
        }
    }
    if (b->told.fault == LAG_INITIAL_NONE && model->nc > 0 && !as_compiled(b, set)) {
        lag_initialization_find_rank(b, x);
    }
}

/* Rates that the constraints leave free at x. */
static size_t find_freedom(lag_initialization *b, const unsigned char *set, const double *x)
{
    const size_t n = b->motion->model->nq;
    memcpy(b->q, x, n * sizeof(double));
    lag_initialization_velocities(b);
    return n - lag_initialization_count(b, as_compiled(b, set), b->memory);
}

static void copy(size_t count, const double *x, double *to)
{
    if (to != NULL) {
        memcpy(to, x, count * sizeof(double));
    }
}

static int differ(size_t count, const double *x, const double *y)
{
    size_t i = 0;
    while (i < count && x[i] == y[i]) {
        ++i;
    }
    return i < count;
}

/* A free parameter beyond its bounds. */
static void check_bounds(const lag_model *model, const lag_start *start, lag_initial *found)
{
    const int bounded = start != NULL && start->free != NULL && start->parameter_minimum != NULL && start->parameter_maximum != NULL;
    for (size_t i = 0; i < model->np && bounded && found->p != NULL && found->fault == LAG_INITIAL_NONE; ++i) {
        if (start->free[i] && !(found->p[i] >= start->parameter_minimum[i] && found->p[i] <= start->parameter_maximum[i])) {
            found->fault = LAG_INITIAL_BOUNDS;
            found->which = i;
            found->residual = found->p[i];
        }
    }
}

lag_status lag_initial_find(lag_motion *motion, const lag_start *start, const unsigned char *set, double t, double *x, double *memory,
    lag_initial *told)
{
    const lag_model *model = motion->model;
    lag_initialization b;
    lag_initial found = {.rank = model->rank, .freedom = model->nq};
    if (told != NULL) {
        found.given = told->given;
        found.dependent = told->dependent;
        found.row_sizes = told->row_sizes;
        found.p = told->p;
    }
    for (size_t i = 0; found.dependent != NULL && i < model->nc; ++i) {
        found.dependent[i] = model->redundant != NULL && model->redundant[i];
    }
    lag_status status = LAG_OK;
    if (start != NULL && start->free != NULL && found.p != NULL) { /* they are changed from here on */
        memmove(found.p, motion->at.p, model->np * sizeof(double));
        status = lag_motion_parameters(motion, found.p);
    }
    if (status == LAG_OK && model->nc + model->ne > 0) {
        lag_initialization_place(&b, motion, memory);
        b.told = found;
        status = lag_initialization_at(&b, start, set, t, x);
        if (status == LAG_OK) {
            find(&b, set, x);
            b.told.freedom = find_freedom(&b, set, x);
            copy(model->nc, b.row_sizes, found.row_sizes);
            found = b.told;
            found.moved = differ(lag_motion_size(model), b.starts.x, x);
            check_bounds(model, start, &found);
            status = found.fault == LAG_INITIAL_NONE ? LAG_OK : found.fault == LAG_INITIAL_NUMBERS ? LAG_NOT_FINITE : LAG_PROJECTION_FAILED;
        }
        lag_motion_set_state(motion, t, x);
    }
    if (told != NULL) {
        *told = found;
    }
    return status;
}
