/* The search for a state that satisfies the initial equations. */
#include <math.h>
#include <string.h>

#include "lag/initial/initial_equations.h"
#include "lag/linalg/arena.h"
#include "lag/linalg/finite.h"
#include "lag/linalg/svd.h"

enum { TRIES = 12 };

/* Beginnings about the start values. */
static void draw(const lag_joint *joint, unsigned long long *seed, size_t which, double *all, double *y)
{
    const lag_initialization *b = joint->b;
    lag_initialization_point(b, seed, which, b->starts.x, all);
    for (size_t k = 0; k < joint->count; ++k) {
        const size_t i = (size_t)joint->free[k];
        const double other = 0.4 * lag_initialization_draw(seed);
        y[k] = i < b->motion->model->nq ? (all[i] - b->starts.x[i]) / b->starts.widths[i] : i < 2 * b->motion->model->nq ? 0.0 : other;
    }
}

/* True if the equations of some part leave a choice at the point where the descent ended. */
static int leaves_choice(const lag_parts *parts, const lag_levenberg_marquardt *minimizer)
{
    for (size_t which = 0; which < parts->count; ++which) {
        size_t first = 0;
        const size_t columns = lag_parts_columns(parts, which, &first);
        const size_t rows = lag_parts_rows(parts, which, &first);
        const double *block = lag_parts_block(parts, which, minimizer->jacobian);
        if (columns == 0 || !lag_finite(rows * columns, block)) {
            continue;
        }
        const lag_svd svd = lag_svd_of(rows, columns, block, minimizer->svd);
        if (lag_svd_rank(&svd, LAG_ROUGH_RANK) < columns) {
            return 1;
        }
    }
    return 0;
}

/* The solutions found: for each part the norm of its residuals and its distance from the start values, and whether it is looked for elsewhere. */
typedef struct lag_descents {
    double *sizes, *distances, *others; /* (rows + unknowns) */
    double *open, *better;              /* flags */
} lag_descents;

static void place_descents(lag_descents *found, const lag_joint *joint, double *memory)
{
    double **const in_parts[] = {&found->sizes, &found->distances, &found->others, &found->open, &found->better};
    for (size_t i = 0; i < sizeof in_parts / sizeof *in_parts; ++i) {
        *in_parts[i] = lag_take(&memory, joint->rows + joint->count);
    }
}

/* Parts that the start values do not lead to a solution, or to one farther away than their natural sizes: there may be a nearer one. */
static int find_open(const lag_joint_parts *t, const lag_joint *joint, const lag_parts *parts, lag_descents *found)
{
    const lag_initialization *b = joint->b;
    const size_t n = b->motion->model->nq;
    const size_t size = lag_motion_size(b->motion->model);
    int any = 0;
    for (size_t i = 0; i < parts->count; ++i) {
        found->open[i] = !(found->sizes[i] <= LAG_HOLDS);
    }
    for (size_t k = 0; k < joint->count; ++k) {
        const size_t i = (size_t)joint->free[k];
        const int placed = i < n || (i >= 2 * n && i < size);
        if (placed && fabs(t->best[k]) * joint->width[i] > b->sizes[i]) {
            found->open[(size_t)parts->column_part[k]] = 1.0;
        }
    }
    for (size_t i = 0; i < parts->count; ++i) {
        any = any || found->open[i] != 0.0;
    }
    return any;
}

/* Takes over the open parts of t->trial that satisfy their equations better, or as well and nearer to the start values. */
static void take_better(const lag_joint_parts *t, const lag_parts *parts, const lag_levenberg_marquardt *minimizer, lag_descents *found)
{
    lag_parts_norms(parts, 0, t->trial, found->others);
    for (size_t i = 0; i < parts->count; ++i) {
        const double left = fmax(minimizer->sizes[i], LAG_HOLDS);
        const double before = fmax(found->sizes[i], LAG_HOLDS);
        const int nearer = left <= LAG_HOLDS && found->others[i] < found->distances[i];
        found->better[i] = found->open[i] != 0.0 && (left < before || (left == before && nearer));
        if (found->better[i] != 0.0) {
            found->sizes[i] = minimizer->sizes[i];
            found->distances[i] = found->others[i];
        }
    }
    lag_parts_mix(parts, found->better, t->trial, t->best);
}

/* From the start values and, in parts where these do not lead to what is near, from points about them, of which the nearest is taken. */
static double descend(const lag_joint_parts *t, lag_joint *joint, const lag_parts *parts, const lag_equations *equations,
    lag_levenberg_marquardt *minimizer, lag_descents *found)
{
    unsigned long long seed = 20011;
    double sum = 0.0;
    lag_fill(joint->count, 0.0, t->best);
    lag_descend(minimizer, equations, parts, LAG_JOINT_TARGET, LAG_DESCENTS, t->best);
    memcpy(found->sizes, minimizer->sizes, parts->count * sizeof(double));
    lag_parts_norms(parts, 0, t->best, found->distances);
    const size_t tries = find_open(t, joint, parts, found) ? TRIES : 0;
    for (size_t k = 0; k < tries; ++k) {
        draw(joint, &seed, k, t->point, t->trial);
        lag_descend(minimizer, equations, parts, LAG_JOINT_TARGET, LAG_DESCENTS, t->trial);
        take_better(t, parts, minimizer, found);
    }
    for (size_t i = 0; i < parts->count; ++i) {
        sum += found->sizes[i] * found->sizes[i];
    }
    return sqrt(sum);
}

double lag_joint_search(const lag_joint_parts *t, lag_joint *joint)
{
    double *memory = t->memory;
    lag_nearest_configuration nearest;
    lag_levenberg_marquardt minimizer;
    double *room = lag_take(&memory, lag_parts_memory(joint->rows, joint->count));
    const lag_parts parts = lag_joint_parts_of(joint, memory, room);
    const lag_equations equations = {lag_joint_evaluate, joint};
    lag_descents found;
    place_descents(&found, joint, lag_take(&memory, 5 * (joint->rows + joint->count)));
    lag_levenberg_marquardt_place(&minimizer, &parts, memory);
    const double smallest = descend(t, joint, &parts, &equations, &minimizer, &found);
    if (!(smallest <= LAG_HOLDS)) {
        return smallest;
    }
    lag_joint_evaluate(joint, &parts, t->best, minimizer.residual, minimizer.jacobian);
    if (!leaves_choice(&parts, &minimizer)) {
        return smallest;
    }
    unsigned long long seed = 20011;
    double *guesses = lag_take(&memory, LAG_NEAREST_GUESSES * joint->count);
    for (size_t k = 0; k < LAG_NEAREST_GUESSES; ++k) {
        draw(joint, &seed, k, t->point, guesses + k * joint->count);
    }
    lag_nearest_configuration_place(&nearest, &parts, memory);
    const double worst = lag_nearest_configuration_search(&nearest, &equations, guesses, LAG_HOLDS);
    if (worst <= LAG_HOLDS) {
        memcpy(t->best, nearest.best.point, joint->count * sizeof(double));
    }
    return fmin(worst, smallest);
}
