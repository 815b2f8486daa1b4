/* Initial equations: what they tie together is solved at once, each part as if it were alone. */
#include <math.h>
#include <string.h>

#include "lag/initial/initial_equations.h"
#include "lag/linalg/arena.h"
#include "lag/linalg/svd.h"

size_t lag_initialization_all_memory(const lag_model *model)
{
    const size_t all = lag_motion_size(model) + model->np;
    const size_t rows = 2 * model->nc + model->ne;
    const size_t search = LAG_NEAREST_GUESSES * all + lag_nearest_configuration_memory(rows, all);
    const size_t ranks = rows * all + all + lag_svd_memory(rows, all);
    const size_t in_turn = lag_larger(lag_parts_memory(rows, all) + 5 * (rows + all) + lag_larger(search, lag_larger(ranks, lag_levenberg_marquardt_memory(rows, all))),
        lag_larger(lag_initialization_q_memory(model), lag_initialization_qd_memory(model)));
    return lag_joint_memory(model) + lag_parts_memory(rows, all) + 4 * (rows + all) + 4 * all + model->nq + model->ne * model->nq + in_turn;
}

static void place(lag_joint_parts *t, lag_joint *joint, double *memory)
{
    const lag_model *model = joint->b->motion->model;
    const size_t some = joint->all_rows + joint->all;
    memset(t, 0, sizeof *t);
    t->whole = lag_parts_of(joint->all_rows, joint->all, joint->pattern, lag_take(&memory, lag_parts_memory(joint->all_rows, joint->all)));
    t->equation = lag_take_flags(&memory, some);
    t->rated = lag_take_flags(&memory, some);
    t->parametric = lag_take_flags(&memory, some);
    t->open = lag_take_flags(&memory, some);
    t->point = lag_take(&memory, joint->all);
    t->best = lag_take(&memory, joint->all);
    t->trial = lag_take(&memory, joint->all);
    t->found = lag_take(&memory, joint->all);
    t->joined = lag_take_flags(&memory, model->nq);
    t->slopes = lag_take(&memory, model->ne * model->nq);
    t->memory = memory;
}

static void classify(lag_joint_parts *t, const lag_joint *joint)
{
    const lag_model *model = joint->b->motion->model;
    const size_t n = model->nq;
    const size_t size = lag_motion_size(model);
    for (size_t i = joint->all_rows - model->ne; i < joint->all_rows; ++i) {
        const size_t part = (size_t)t->whole.row_part[i];
        t->equation[part] = 1;
        for (size_t k = n; k < 2 * n; ++k) {
            t->rated[part] = t->rated[part] || joint->pattern[i * joint->all + k] != 0.0;
        }
    }
    for (size_t k = size; k < joint->all; ++k) {
        t->parametric[(size_t)t->whole.column_part[k]] = 1;
    }
    for (size_t j = 0; j < n; ++j) {
        t->joined[j] = t->equation[(size_t)t->whole.column_part[j]];
    }
}

void lag_joint_choose(const lag_joint_parts *t, lag_joint *joint)
{
    const lag_initialization *b = joint->b;
    const lag_model *model = b->motion->model;
    const size_t size = lag_motion_size(model);
    joint->rows = joint->count = 0;
    for (size_t i = 0; i < joint->all_rows; ++i) {
        const size_t part = (size_t)t->whole.row_part[i];
        const int rate = i >= b->rows && i < b->rows + model->nc;
        if ((rate ? t->rated : t->equation)[part]) {
            joint->row[joint->rows++] = (double)i;
        }
    }
    for (size_t k = 0; k < joint->all; ++k) {
        const size_t part = (size_t)t->whole.column_part[k];
        const int rate = k >= model->nq && k < 2 * model->nq;
        const int held = k < size && (b->starts.fixed[k] != 0.0 || (b->starts.written[k] != 0.0 && !t->open[part]));
        if ((rate ? t->rated : t->equation)[part] && !held) {
            joint->free[joint->count++] = (double)k;
        }
    }
}

lag_parts lag_joint_parts_of(const lag_joint *joint, double *pattern, double *memory)
{
    for (size_t i = 0; i < joint->rows; ++i) {
        for (size_t k = 0; k < joint->count; ++k) {
            pattern[i * joint->count + k] = joint->pattern[(size_t)joint->row[i] * joint->all + (size_t)joint->free[k]];
        }
    }
    return lag_parts_of(joint->rows, joint->count, pattern, memory);
}

/* Parts in which rows are off while written start values are held: there these give way, too. Returns whether there are any. */
static int open_parts(const lag_joint_parts *t, lag_joint *joint)
{
    int any = 0;
    lag_joint_residuals(joint, t->best, joint->here);
    for (size_t i = 0; i < joint->rows; ++i) {
        const size_t row = (size_t)joint->row[i];
        const size_t part = (size_t)t->whole.row_part[row];
        if (!t->open[part] && !(fabs(joint->here[row]) <= LAG_HOLDS)) {
            t->open[part] = 1;
            any = 1;
        }
    }
    return any;
}

void lag_initialization_find_all(lag_initialization *b, double *x)
{
    const lag_model *model = b->motion->model;
    const size_t size = lag_motion_size(model);
    double *memory = b->memory;
    lag_joint joint;
    lag_joint_parts t;
    lag_joint_place(&joint, b, &memory);
    lag_joint_measure(&joint, memory);
    place(&t, &joint, memory);
    classify(&t, &joint);
    lag_joint_choose(&t, &joint);
    double left = lag_joint_search(&t, &joint);
    if (!(left <= LAG_HOLDS) && open_parts(&t, &joint)) {
        lag_joint_choose(&t, &joint);
        left = lag_joint_search(&t, &joint);
    }
    if (!(left <= LAG_HOLDS)) {
        lag_joint_find_worst(&t, &joint);
    } else if (joint.parameters > 0) {
        lag_joint_find_undecided(&t, &joint);
    }
    lag_joint_put(&joint, t.best);
    memcpy(joint.origin, joint.at, joint.all * sizeof(double));
    memcpy(x, joint.at, size * sizeof(double));
    if (b->told.fault == LAG_INITIAL_EQUATIONS) {
        lag_joint_count_excess(&t, &joint);
        return;
    }
    if (b->told.fault != LAG_INITIAL_NONE) {
        return;
    }
    b->equations.joined = t.joined;
    b->memory = t.memory;
    lag_initialization_find_q(b, x); /* what initial equations do not decide */
    memcpy(joint.origin, x, size * sizeof(double));
    if (b->told.fault == LAG_INITIAL_NONE) {
        lag_joint_find_rates(&t, &joint, x);
    }
}
