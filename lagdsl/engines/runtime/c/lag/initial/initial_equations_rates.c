/* Rates under initial equations, at the positions that the search found. */
#include <math.h>
#include <string.h>

#include "lag/initial/initial_equations.h"
#include "lag/linalg/arena.h"

/* Rates that are corrected by less than this are those that were looked for. */
static const double SETTLED = 1e-9;
enum { ROUNDS = 20 };

/* Derivatives of the initial equations by rates, in natural sizes. */
static void find_slopes(const lag_joint_parts *t, lag_joint *joint)
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
    const lag_parts whole = lag_parts_of(joint->rows, joint->count, NULL, t->memory);
    lag_joint_evaluate(joint, &whole, t->trial, joint->one, t->slopes);
    for (size_t k = 0; k < model->ne * n; ++k) {
        const size_t row = joint->all_rows - model->ne + k / n;
        const size_t rate = n + k % n;
        t->slopes[k] = joint->pattern[row * joint->all + rate] != 0.0 ? t->slopes[k] * b->sizes[rate] / joint->width[rate] : 0.0;
    }
}

/* The nearest rates that satisfy the rows as they are, not as they were near other rates. Returns how far they are. */
static double correct(const lag_joint_parts *t, lag_joint *joint)
{
    const lag_initialization *b = joint->b;
    const size_t n = b->motion->model->nq;
    double *memory = t->memory;
    lag_levenberg_marquardt minimizer;
    double distance = 0.0;
    lag_joint_choose(t, joint);
    size_t count = 0;
    for (size_t k = 0; k < joint->count; ++k) {
        if (joint->free[k] >= (double)n && joint->free[k] < (double)(2 * n)) {
            joint->free[count++] = joint->free[k];
        }
    }
    joint->count = count;
    double *room = lag_take(&memory, lag_parts_memory(joint->rows, joint->count));
    const lag_parts parts = lag_joint_parts_of(joint, memory, room);
    const lag_equations equations = {lag_joint_evaluate, joint};
    lag_levenberg_marquardt_place(&minimizer, &parts, memory);
    lag_fill(count, 0.0, t->trial);
    lag_joint_evaluate(joint, &parts, t->trial, minimizer.residual, minimizer.jacobian);
    if (lag_levenberg_marquardt_size(&minimizer, &parts) > LAG_JOINT_TARGET) {
        lag_descend(&minimizer, &equations, &parts, LAG_JOINT_TARGET, LAG_DESCENTS, t->trial);
    }
    lag_joint_put(joint, t->trial);
    memcpy(joint->origin, joint->at, joint->all * sizeof(double));
    for (size_t k = 0; k < count; ++k) {
        distance += t->trial[k] * t->trial[k];
    }
    return lag_levenberg_marquardt_size(&minimizer, &parts) <= LAG_HOLDS ? sqrt(distance) : (double)INFINITY;
}

void lag_joint_find_rates(const lag_joint_parts *t, lag_joint *joint, double *x)
{
    lag_initialization *b = joint->b;
    const size_t size = lag_motion_size(b->motion->model);
    double far = (double)INFINITY;
    memcpy(t->found, joint->origin, joint->all * sizeof(double));
    for (int round = 0; round < ROUNDS && far > SETTLED; ++round) {
        find_slopes(t, joint);
        memcpy(x, joint->origin, size * sizeof(double));
        b->equations.slopes = t->slopes;
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
