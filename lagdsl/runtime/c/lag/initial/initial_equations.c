/* Initial equations: what they tie together is solved at once, each part as if it were alone. */
#include <math.h>
#include <string.h>

#include "lag/initial/initialization_joint.h"
#include "lag/linalg/arena.h"
#include "lag/linalg/svd.h"

static const double TARGET = 1e-11;
/* Singular values below this part of the largest are those of differences. */
static const double ROUGH = 1e-7;
/* Rates that are corrected by less than this are those that were looked for. */
static const double SETTLED = 1e-9;
enum { TRIES = 12, DESCENTS = 100, ROUNDS = 20 };

/* Of each part of rows and unknowns, by its number. */
typedef struct traits {
    lag_parts whole;
    double *equation, *rated, *parametric; /* it has an initial equation, one that depends on rates, a free parameter; */
    double *open;                          /* written start values give way */
    double *point, *best, *trial;          /* (all) */
    unsigned char *joined;                 /* (nq) */
    double *slopes;                        /* (ne, nq) */
    double *found;                         /* (all) */
    double *memory;                        /* of what is done in turn */
} traits;

static size_t larger(size_t a, size_t b)
{
    return a > b ? a : b;
}

size_t lag_initialization_all_memory(const lag_model *model)
{
    const size_t all = lag_motion_size(model) + model->np;
    const size_t rows = 2 * model->nc + model->ne;
    const size_t search = LAG_NEAREST_OTHERS * all + lag_nearest_configuration_memory(rows, all);
    const size_t ranks = rows * all + all + lag_svd_memory(rows, all);
    const size_t in_turn = larger(lag_parts_memory(rows, all) + larger(search, larger(ranks, lag_levenberg_marquardt_memory(rows, all))),
        larger(lag_initialization_q_memory(model), lag_initialization_qd_memory(model)));
    return lag_joint_memory(model) + lag_parts_memory(rows, all) + 4 * (rows + all) + 4 * all + model->nq + model->ne * model->nq + in_turn;
}

static void place(traits *t, lag_joint *joint, double *memory)
{
    const lag_model *model = joint->b->motion->model;
    const size_t some = joint->all_rows + joint->all;
    memset(t, 0, sizeof *t);
    t->whole = lag_parts_of(joint->all_rows, joint->all, joint->pattern, lag_take(&memory, lag_parts_memory(joint->all_rows, joint->all)));
    t->equation = lag_take(&memory, some);
    t->rated = lag_take(&memory, some);
    t->parametric = lag_take(&memory, some);
    t->open = lag_take(&memory, some);
    t->point = lag_take(&memory, joint->all);
    t->best = lag_take(&memory, joint->all);
    t->trial = lag_take(&memory, joint->all);
    t->found = lag_take(&memory, joint->all);
    t->joined = (unsigned char *)(void *)lag_take(&memory, model->nq);
    t->slopes = lag_take(&memory, model->ne * model->nq);
    t->memory = memory;
    lag_fill(some, 0.0, t->equation);
    lag_fill(some, 0.0, t->rated);
    lag_fill(some, 0.0, t->parametric);
    lag_fill(some, 0.0, t->open);
}

static void classify(traits *t, const lag_joint *joint)
{
    const lag_model *model = joint->b->motion->model;
    const size_t n = model->nq;
    const size_t size = lag_motion_size(model);
    for (size_t i = joint->all_rows - model->ne; i < joint->all_rows; ++i) {
        const size_t part = (size_t)t->whole.row_part[i];
        t->equation[part] = 1.0;
        for (size_t k = n; k < 2 * n; ++k) {
            t->rated[part] = t->rated[part] != 0.0 || joint->pattern[i * joint->all + k] != 0.0;
        }
    }
    for (size_t k = size; k < joint->all; ++k) {
        t->parametric[(size_t)t->whole.column_part[k]] = 1.0;
    }
    for (size_t j = 0; j < n; ++j) {
        t->joined[j] = t->equation[(size_t)t->whole.column_part[j]] != 0.0;
    }
}

/* Rows and unknowns of the parts with initial equations; rates only where one depends on them. */
static void choose(const traits *t, lag_joint *joint)
{
    const lag_initialization *b = joint->b;
    const lag_model *model = b->motion->model;
    const size_t size = lag_motion_size(model);
    joint->rows = joint->count = 0;
    for (size_t i = 0; i < joint->all_rows; ++i) {
        const size_t part = (size_t)t->whole.row_part[i];
        const int rate = i >= b->rows && i < b->rows + model->nc;
        if ((rate ? t->rated : t->equation)[part] != 0.0) {
            joint->row[joint->rows++] = (double)i;
        }
    }
    for (size_t k = 0; k < joint->all; ++k) {
        const size_t part = (size_t)t->whole.column_part[k];
        const int rate = k >= model->nq && k < 2 * model->nq;
        const int held = k < size && (b->fixed[k] != 0.0 || (b->written[k] != 0.0 && t->parametric[part] != 0.0 && t->open[part] == 0.0));
        if ((rate ? t->rated : t->equation)[part] != 0.0 && !held) {
            joint->free[joint->count++] = (double)k;
        }
    }
}

/* ---- the search ---- */

/* Independent parts of the problem, by the unknowns that its rows depend on. */
static lag_parts parts_of(const lag_joint *joint, double *pattern, double *memory)
{
    for (size_t i = 0; i < joint->rows; ++i) {
        for (size_t k = 0; k < joint->count; ++k) {
            pattern[i * joint->count + k] = joint->pattern[(size_t)joint->row[i] * joint->all + (size_t)joint->free[k]];
        }
    }
    return lag_parts_of(joint->rows, joint->count, pattern, memory);
}

/* Beginnings about the start values. */
static void draw(const lag_joint *joint, unsigned long long *seed, size_t which, double *all, double *y)
{
    const lag_initialization *b = joint->b;
    lag_initialization_point(b, seed, which, b->x, all);
    for (size_t k = 0; k < joint->count; ++k) {
        const size_t i = (size_t)joint->free[k];
        const double other = 0.4 * lag_initialization_draw(seed);
        y[k] = i < b->motion->model->nq ? (all[i] - b->x[i]) / b->widths[i] : i < 2 * b->motion->model->nq ? 0.0 : other;
    }
}

/* True if the equations of some part leave a choice at the point where the descent ended. */
static int leaves_choice(const lag_parts *parts, const lag_levenberg_marquardt *minimizer, double *block, double *svd_memory)
{
    for (size_t which = 0; which < parts->count; ++which) {
        size_t first = 0;
        const size_t columns = lag_parts_columns(parts, which, &first);
        const size_t rows = lag_parts_rows(parts, which, &first);
        if (columns == 0 || !lag_parts_block(parts, which, parts->n, minimizer->jacobian, block)) {
            continue;
        }
        const lag_svd svd = lag_svd_of(rows, columns, block, svd_memory);
        if (lag_svd_rank(&svd, ROUGH) < columns) {
            return 1;
        }
    }
    return 0;
}

/* From the start values and, where these do not lead there, from points about them, of which the nearest is taken, part by part. */
static double descend(const traits *t, lag_joint *joint, const lag_parts *parts, const lag_equations *equations, lag_levenberg_marquardt *minimizer)
{
    unsigned long long seed = 20011;
    lag_fill(joint->count, 0.0, t->best);
    lag_descend(minimizer, equations, parts, TARGET, DESCENTS, t->best);
    double smallest = lag_levenberg_marquardt_size(minimizer, equations);
    double nearest = (double)INFINITY;
    const size_t tries = smallest <= LAG_HOLDS ? 0 : TRIES;
    for (size_t k = 0; k < tries; ++k) {
        double distance = 0.0;
        draw(joint, &seed, k, t->point, t->trial);
        lag_descend(minimizer, equations, parts, TARGET, DESCENTS, t->trial);
        const double left = lag_levenberg_marquardt_size(minimizer, equations);
        for (size_t i = 0; i < joint->count; ++i) {
            distance += t->trial[i] * t->trial[i];
        }
        if (fmax(left, LAG_HOLDS) < fmax(smallest, LAG_HOLDS) || (left <= LAG_HOLDS && distance < nearest)) {
            smallest = left;
            nearest = distance;
            memcpy(t->best, t->trial, joint->count * sizeof(double));
        }
    }
    return smallest;
}

/* The nearest point, if more than one is admissible. Returns what is left of the equations. */
static double search(const traits *t, lag_joint *joint)
{
    double *memory = t->memory;
    lag_nearest_configuration nearest;
    lag_levenberg_marquardt minimizer;
    double *room = lag_take(&memory, lag_parts_memory(joint->rows, joint->count));
    const lag_parts parts = parts_of(joint, memory, room);
    const lag_equations equations = {joint->rows, joint->count, lag_joint_evaluate, joint};
    lag_levenberg_marquardt_place(&minimizer, joint->rows, joint->count, memory);
    const double smallest = descend(t, joint, &parts, &equations, &minimizer);
    if (!(smallest <= LAG_HOLDS)) {
        return smallest;
    }
    lag_joint_evaluate(joint, t->best, minimizer.residual, minimizer.jacobian);
    if (!leaves_choice(&parts, &minimizer, minimizer.block, minimizer.svd)) {
        return smallest;
    }
    unsigned long long seed = 20011;
    double *others = lag_take(&memory, LAG_NEAREST_OTHERS * joint->count);
    for (size_t k = 0; k < LAG_NEAREST_OTHERS; ++k) {
        draw(joint, &seed, k, t->point, others + k * joint->count);
    }
    lag_nearest_configuration_place(&nearest, joint->rows, joint->count, memory);
    const double worst = lag_nearest_configuration_search(&nearest, &equations, &parts, others, LAG_HOLDS);
    if (worst <= LAG_HOLDS) {
        memcpy(t->best, nearest.best.point, joint->count * sizeof(double));
    }
    return fmin(worst, smallest);
}

/* Parts with free parameters in which rows are off: there written start values give way, too. Returns whether there are any. */
static int open_parts(const traits *t, lag_joint *joint)
{
    int any = 0;
    lag_joint_residuals(joint, t->best, joint->here);
    for (size_t i = 0; i < joint->rows; ++i) {
        const size_t row = (size_t)joint->row[i];
        const size_t part = (size_t)t->whole.row_part[row];
        if (t->parametric[part] != 0.0 && t->open[part] == 0.0 && !(fabs(joint->here[row]) <= LAG_HOLDS)) {
            t->open[part] = 1.0;
            any = 1;
        }
    }
    return any;
}

/* ---- why there is none ---- */

static void tell(const traits *t, lag_joint *joint)
{
    lag_initialization *b = joint->b;
    double worst = -1.0;
    b->told.fault = LAG_INITIAL_EQUATIONS;
    lag_joint_residuals(joint, t->best, joint->here);
    for (size_t k = 0; k < joint->rows; ++k) {
        const size_t i = (size_t)joint->row[k];
        const double size = isfinite(joint->here[i]) ? fabs(joint->here[i] * joint->scale[i]) : (double)INFINITY;
        if (size > worst) {
            worst = size;
            b->told.which = i < b->rows ? (size_t)b->row[i] : i - b->rows;
            b->told.residual = size;
        }
    }
}

/* So many fixed values are too many, by ranks at the state that was found. */
static void count_excess(const traits *t, lag_joint *joint)
{
    lag_initialization *b = joint->b;
    double *memory = t->memory;
    double *matrix = lag_take(&memory, joint->all_rows * joint->all);
    double *residual = lag_take(&memory, joint->all);
    lag_joint_put(joint, t->best);
    memcpy(joint->origin, joint->at, joint->all * sizeof(double));
    lag_fill(joint->all, 0.0, t->best);
    lag_joint_evaluate(joint, t->best, joint->one, matrix);
    const size_t part = lag_initialization_rank(joint->rows, joint->count, matrix, residual);
    joint->count = joint->all;
    for (size_t k = 0; k < joint->all; ++k) {
        joint->free[k] = (double)k;
    }
    lag_joint_evaluate(joint, t->best, joint->one, matrix);
    const size_t whole = lag_initialization_rank(joint->rows, joint->all, matrix, residual);
    b->told.excess = whole > part ? whole - part : 0;
    b->told.general = joint->all - whole;
}

/* A free parameter that could be changed with the equations satisfied still: nothing decides it. */
static void find_undecided(const traits *t, lag_joint *joint)
{
    lag_initialization *b = joint->b;
    const size_t size = lag_motion_size(b->motion->model);
    double *memory = t->memory;
    double *matrix = lag_take(&memory, joint->rows * joint->count);
    double *chosen = t->trial;
    lag_fill(joint->all, 0.0, chosen);
    lag_joint_evaluate(joint, t->best, joint->one, matrix);
    const lag_svd svd = lag_svd_of(joint->rows, joint->count, matrix, memory);
    const size_t rank = lag_svd_rank(&svd, ROUGH);
    for (size_t k = 0; k < joint->count; ++k) {
        double along = 0.0;
        for (size_t i = rank; i < joint->count; ++i) {
            along += svd.v[i * joint->count + k] * svd.v[i * joint->count + k];
        }
        chosen[(size_t)joint->free[k]] = sqrt(along) <= ROUGH ? 1.0 : 0.0;
    }
    for (size_t k = size; k < joint->all; ++k) {
        if (chosen[k] == 0.0 && b->told.fault == LAG_INITIAL_NONE) {
            b->told.fault = LAG_INITIAL_PARAMETERS;
            b->told.which = (size_t)joint->parameter[k - size];
        }
    }
}

/* ---- rates ---- */

/* Derivatives of the initial equations by rates, in natural sizes. */
static void find_slopes(const traits *t, lag_joint *joint)
{
    const lag_initialization *b = joint->b;
    const lag_model *model = b->motion->model;
    const size_t n = model->nq;
    joint->rows = joint->count = 0;
    for (size_t i = joint->all_rows - model->ne; i < joint->all_rows; ++i) {
        joint->row[joint->rows++] = (double)i;
    }
    for (size_t k = n; k < 2 * n; ++k) {
        joint->free[joint->count++] = (double)k;
    }
    lag_fill(n, 0.0, t->trial);
    lag_joint_evaluate(joint, t->trial, joint->one, t->slopes);
    for (size_t k = 0; k < model->ne * n; ++k) {
        const size_t row = joint->all_rows - model->ne + k / n;
        const size_t rate = n + k % n;
        t->slopes[k] = joint->pattern[row * joint->all + rate] != 0.0 ? t->slopes[k] * b->sizes[rate] / joint->width[rate] : 0.0;
    }
}

/* The nearest rates that satisfy the rows as they are, not as they were near other rates. Returns how far they are. */
static double correct(const traits *t, lag_joint *joint)
{
    const lag_initialization *b = joint->b;
    const size_t n = b->motion->model->nq;
    double *memory = t->memory;
    lag_levenberg_marquardt minimizer;
    double distance = 0.0;
    choose(t, joint);
    size_t count = 0;
    for (size_t k = 0; k < joint->count; ++k) {
        if (joint->free[k] >= (double)n && joint->free[k] < (double)(2 * n)) {
            joint->free[count++] = joint->free[k];
        }
    }
    joint->count = count;
    double *room = lag_take(&memory, lag_parts_memory(joint->rows, joint->count));
    const lag_parts parts = parts_of(joint, memory, room);
    const lag_equations equations = {joint->rows, joint->count, lag_joint_evaluate, joint};
    lag_levenberg_marquardt_place(&minimizer, joint->rows, joint->count, memory);
    lag_fill(count, 0.0, t->trial);
    lag_joint_evaluate(joint, t->trial, minimizer.residual, minimizer.jacobian);
    if (lag_levenberg_marquardt_size(&minimizer, &equations) > TARGET) {
        lag_descend(&minimizer, &equations, &parts, TARGET, DESCENTS, t->trial);
    }
    lag_joint_put(joint, t->trial);
    memcpy(joint->origin, joint->at, joint->all * sizeof(double));
    for (size_t k = 0; k < count; ++k) {
        distance += t->trial[k] * t->trial[k];
    }
    return lag_levenberg_marquardt_size(&minimizer, &equations) <= LAG_HOLDS ? sqrt(distance) : (double)INFINITY;
}

/*
 * Rates at the positions that were found: by the rule of those without initial equations, under these as further conditions. Equations
 * that are not linear in rates are met in turns; where that leads nowhere the rates of the search stay.
 */
static void find_rates(const traits *t, lag_joint *joint, double *x)
{
    lag_initialization *b = joint->b;
    const size_t size = lag_motion_size(b->motion->model);
    double far = (double)INFINITY;
    memcpy(t->found, joint->origin, joint->all * sizeof(double));
    for (int round = 0; round < ROUNDS && far > SETTLED; ++round) {
        find_slopes(t, joint);
        memcpy(x, joint->origin, size * sizeof(double));
        b->slopes = t->slopes;
        b->memory = t->memory;
        lag_initialization_find_qd(b, x);
        if (b->told.fault != LAG_INITIAL_NONE) {
            return;
        }
        memcpy(joint->origin, x, size * sizeof(double));
        far = correct(t, joint);
        memcpy(x, joint->origin, size * sizeof(double));
        if (!isfinite(far)) {
            break;
        }
    }
    if (!(far <= SETTLED)) {
        memcpy(x, t->found, size * sizeof(double));
    }
}

void lag_initialization_find_all(lag_initialization *b, double *x)
{
    const lag_model *model = b->motion->model;
    const size_t size = lag_motion_size(model);
    double *memory = b->memory;
    lag_joint joint;
    traits t;
    lag_joint_place(&joint, b, &memory);
    lag_joint_measure(&joint, memory);
    place(&t, &joint, memory);
    classify(&t, &joint);
    choose(&t, &joint);
    double left = search(&t, &joint);
    if (!(left <= LAG_HOLDS) && open_parts(&t, &joint)) {
        choose(&t, &joint);
        left = search(&t, &joint);
    }
    if (!(left <= LAG_HOLDS)) {
        tell(&t, &joint);
    } else if (joint.parameters > 0) {
        find_undecided(&t, &joint);
    }
    lag_joint_put(&joint, t.best);
    memcpy(joint.origin, joint.at, joint.all * sizeof(double));
    memcpy(x, joint.at, size * sizeof(double));
    if (b->told.fault == LAG_INITIAL_EQUATIONS) {
        count_excess(&t, &joint);
        return;
    }
    if (b->told.fault != LAG_INITIAL_NONE) {
        return;
    }
    b->joined = t.joined;
    b->memory = t.memory;
    lag_initialization_find_q(b, x); /* what initial equations do not decide */
    memcpy(joint.origin, x, size * sizeof(double));
    if (b->told.fault == LAG_INITIAL_NONE) {
        find_rates(&t, &joint, x);
    }
}
