/* The search for a state that satisfies the initial equations. */
#include <math.h>
#include <string.h>

#include "lag/initial/initial_equations.h"
#include "lag/linalg/arena.h"
#include "lag/linalg/svd.h"

enum { TRIES = 12 };

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
        if (lag_svd_rank(&svd, LAG_JOINT_ROUGH) < columns) {
            return 1;
        }
    }
    return 0;
}

/* From the start values and, where these do not lead there, from points about them, of which the nearest is taken, part by part. */
static double descend(const lag_joint_parts *t, lag_joint *joint, const lag_parts *parts, const lag_equations *equations, lag_levenberg_marquardt *minimizer)
{
    unsigned long long seed = 20011;
    lag_fill(joint->count, 0.0, t->best);
    lag_descend(minimizer, equations, parts, LAG_JOINT_TARGET, LAG_JOINT_DESCENTS, t->best);
    double smallest = lag_levenberg_marquardt_size(minimizer, equations);
    double nearest = (double)INFINITY;
    const size_t tries = smallest <= LAG_HOLDS ? 0 : TRIES;
    for (size_t k = 0; k < tries; ++k) {
        double distance = 0.0;
        draw(joint, &seed, k, t->point, t->trial);
        lag_descend(minimizer, equations, parts, LAG_JOINT_TARGET, LAG_JOINT_DESCENTS, t->trial);
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

double lag_joint_search(const lag_joint_parts *t, lag_joint *joint)
{
    double *memory = t->memory;
    lag_nearest_configuration nearest;
    lag_levenberg_marquardt minimizer;
    double *room = lag_take(&memory, lag_parts_memory(joint->rows, joint->count));
    const lag_parts parts = lag_joint_parts_of(joint, memory, room);
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
