#include "lag/run/branch_point.h"

#include <math.h>
#include <string.h>

#include "lag/linalg/arena.h"
#include "lag/linalg/finite.h"
#include "lag/linalg/linalg.h"
#include "lag/linalg/lu.h"
#include "lag/linalg/svd.h"
#include "lag/linalg/vector.h"
#include "lag/run.h"

static const double NEAR = 0.05;
static const double LOOSE = 1e-6;
static const double SETTLED = 1e-8;
static const double LEVEL = 1e-6;
static const double DIFFERENCE = 1e-5;
/* After a step that is longer than this second derivatives are taken anew. */
static const double FAR = 1e-4;
/* Directions of singular values below this part of the largest are round-off. */
static const double SMALL = 1e-14;
/* The golden angle: weights of sums that repeat nowhere. */
static const double GOLDEN = 2.399963229728653;
enum { ITERATIONS = 12 };

size_t lag_branch_point_memory(const lag_model *model)
{
    const size_t m = model->nc;
    const size_t n = model->nq + 1;
    return 2 * lag_motion_size(model) + model->nq + 4 * n + 5 * m + 5 * m * m + 4 * m * n + 4 * n * n + LAG_BRANCH_SUMS * (m + n + n * n) +
           lag_svd_memory(m, n);
}

void lag_branch_point_place(lag_branch_point *s, lag_run *run, double *memory)
{
    const lag_model *model = run->motion.model;
    const size_t m = model->nc;
    const size_t n = model->nq + 1;
    double **const coordinates[] = {&s->point, &s->step, &s->eigen, &s->wanted};
    double **const rows[] = {&s->phi, &s->pivot, &s->other_pivot, &s->right, &s->back};
    double **const among_rows[] = {&s->holding, &s->combinations, &s->vanishing, &s->inner, &s->transposed};
    double **const of_rows[] = {&s->rows, &s->along, &s->moved, &s->slope};
    double **const among_coordinates[] = {&s->free, &s->tangents, &s->normal, &s->vectors};
    memset(s, 0, sizeof *s);
    s->run = run;
    s->origin = lag_take(&memory, lag_motion_size(model));
    s->state = lag_take(&memory, lag_motion_size(model));
    s->still = lag_take(&memory, model->nq);
    for (size_t i = 0; i < 4; ++i) {
        *coordinates[i] = lag_take(&memory, n);
        *of_rows[i] = lag_take(&memory, m * n);
        *among_coordinates[i] = lag_take(&memory, n * n);
    }
    for (size_t i = 0; i < 5; ++i) {
        *rows[i] = lag_take(&memory, m);
        *among_rows[i] = lag_take(&memory, m * m);
    }
    s->sums = lag_take(&memory, LAG_BRANCH_SUMS * m);
    s->slopes = lag_take(&memory, LAG_BRANCH_SUMS * n);
    s->bends = lag_take(&memory, LAG_BRANCH_SUMS * n * n);
    s->memory = memory;
    lag_fill(model->nq, 0.0, s->still);
}

static size_t rows_of(const lag_branch_point *s)
{
    return s->run->motion.model->nc;
}

static size_t width_of(const lag_branch_point *s)
{
    return s->run->motion.model->nq + 1;
}

/* phi, of position rows, and [J b] at the point; 0: no numbers. */
static int look(lag_branch_point *s)
{
    lag_motion *motion = &s->run->motion;
    lag_projection *projection = &s->run->projection;
    const lag_model *model = motion->model;
    const size_t n = model->nq;
    const double *sizes = s->run->natural;
    memcpy(s->state, s->origin, lag_motion_size(model) * sizeof(double));
    for (size_t j = 0; j < n; ++j) {
        s->state[j] = s->point[j] * sizes[j];
    }
    lag_motion_look(motion, s->t + s->pace * s->point[n], s->state);
    motion->at.qd = s->still;
    if (model->velocity_constraint(&motion->at, projection->phi, projection->jacobian) != LAG_OK) {
        return 0;
    }
    for (size_t i = 0; i < model->nc; ++i) {
        const double row = s->run->row_sizes[i];
        for (size_t j = 0; j < n; ++j) {
            s->rows[i * (n + 1) + j] = projection->jacobian[i * n + j] * sizes[j] / row;
        }
        s->rows[i * (n + 1) + n] = projection->phi[i] * s->pace / row;
    }
    if (model->position_constraint(&motion->at, projection->phi, projection->jacobian) != LAG_OK) {
        return 0;
    }
    for (size_t i = 0; i < model->nc; ++i) {
        s->phi[i] = model->position_level[i] ? projection->phi[i] / s->run->row_sizes[i] : 0.0;
    }
    return lag_finite(model->nc, s->phi) && lag_finite(model->nc * (n + 1), s->rows);
}

/* Combinations (count, nc) of the rows, into `moved`. */
static void combine(lag_branch_point *s, size_t count, const double *weights)
{
    const size_t m = rows_of(s);
    const size_t n = width_of(s);
    lag_fill(count * n, 0.0, s->moved);
    for (size_t i = 0; i < m; ++i) {
        for (size_t j = 0; j < n; ++j) {
            const double entry = s->rows[i * n + j];
            for (size_t k = 0; k < count && entry != 0.0; ++k) {
                s->moved[k * n + j] += weights[k * m + i] * entry;
            }
        }
    }
}

/* Row `which` of `basis` (m, m) becomes a direction of its own where none was found: a row of J that is zero has none. */
static void complete(size_t m, size_t which, double *basis)
{
    double *row = basis + which * m;
    double left = 0.0;
    for (size_t i = 0; i < m && !(left > 0.5 / sqrt((double)m)); ++i) {
        lag_fill(m, 0.0, row);
        row[i] = 1.0;
        lag_remove_parts(which, m, basis, row);
        left = sqrt(lag_dot(m, row, row));
    }
    lag_orthonormalize(which, m, basis, row);
}

/* Finds, at the first look, the combinations of rows that vanish, and the directions that the others take and leave open. */
static void take_apart(lag_branch_point *s)
{
    const size_t m = rows_of(s);
    const size_t n = width_of(s);
    size_t large = 0;
    const lag_svd svd = lag_svd_of(m, n, s->rows, s->memory);
    while (large < svd.k && large < s->general && svd.value[large] > NEAR) {
        ++large;
    }
    s->held = large < s->general - 1 ? large : s->general - 1;
    s->lost = s->general - s->held;
    s->open = n - s->held;
    memcpy(s->holding, svd.u, svd.k * m * sizeof(double));
    for (size_t i = s->held; i < s->general; ++i) {
        if (i < svd.k && svd.value[i] > SMALL * svd.value[0]) {
            lag_orthonormalize(i, m, s->holding, s->holding + i * m);
        } else {
            complete(m, i, s->holding);
        }
    }
    memcpy(s->combinations, s->holding + s->held * m, s->lost * m * sizeof(double));
    memcpy(s->along, svd.v, s->held * n * sizeof(double));
    memcpy(s->free, svd.v + s->held * n, s->open * n * sizeof(double));
}

/* Factors the rows that do not vanish, seen in their directions, and finds the tangents that they leave open; 0 if they are singular. */
static int find_tangents(lag_branch_point *s)
{
    const size_t n = width_of(s);
    const size_t held = s->held;
    combine(s, held, s->holding);
    for (size_t i = 0; i < held; ++i) {
        for (size_t j = 0; j < held; ++j) {
            s->inner[i * held + j] = s->transposed[j * held + i] = lag_dot(n, s->moved + i * n, s->along + j * n);
        }
    }
    if (!lag_lu(held, s->inner, s->pivot) || !lag_lu(held, s->transposed, s->other_pivot)) {
        return 0;
    }
    for (size_t f = 0; f < s->open; ++f) {
        for (size_t i = 0; i < held; ++i) {
            s->right[i] = lag_dot(n, s->moved + i * n, s->free + f * n);
        }
        lag_lu_solve(held, s->inner, s->pivot, s->right);
        memcpy(s->tangents + f * n, s->free + f * n, n * sizeof(double));
        for (size_t j = 0; j < held; ++j) {
            lag_axpy(n, -s->right[j], s->along + j * n, s->tangents + f * n);
        }
    }
    return 1;
}

/* The combinations that vanish along the directions of the others, and their slopes along the tangents. */
static void find_slopes(lag_branch_point *s)
{
    const size_t m = rows_of(s);
    const size_t n = width_of(s);
    combine(s, s->lost, s->combinations);
    memcpy(s->vanishing, s->combinations, s->lost * m * sizeof(double));
    for (size_t k = 0; k < s->lost; ++k) {
        for (size_t j = 0; j < s->held; ++j) {
            s->right[j] = lag_dot(n, s->moved + k * n, s->along + j * n);
        }
        lag_lu_solve(s->held, s->transposed, s->other_pivot, s->right);
        for (size_t j = 0; j < s->held; ++j) {
            lag_axpy(m, -s->right[j], s->holding + j * m, s->vanishing + k * m);
        }
    }
    combine(s, s->lost, s->vanishing);
    for (size_t k = 0; k < s->lost; ++k) {
        for (size_t f = 0; f < s->open; ++f) {
            s->slope[k * s->open + f] = lag_dot(n, s->moved + k * n, s->tangents + f * n);
        }
    }
}

/* Everything at the point; 0: there is none of it. */
static int reduce(lag_branch_point *s)
{
    if (!look(s) || !find_tangents(s)) {
        return 0;
    }
    find_slopes(s);
    return lag_finite(s->lost * s->open, s->slope);
}

static size_t sums_of(const lag_branch_point *s)
{
    return s->lost < LAG_BRANCH_SUMS ? s->lost : LAG_BRANCH_SUMS;
}

/* Few combinations stand for themselves. */
static double weight(const lag_branch_point *s, size_t sum, size_t combination)
{
    if (s->lost <= LAG_BRANCH_SUMS) {
        return sum == combination ? 1.0 : 0.0;
    }
    return cos(1.0 + GOLDEN * (double)((sum + 1) * (combination + 1))) / sqrt((double)s->lost);
}

static void add_up(lag_branch_point *s)
{
    const size_t m = rows_of(s);
    lag_fill(LAG_BRANCH_SUMS * m, 0.0, s->sums);
    lag_fill(LAG_BRANCH_SUMS * s->open, 0.0, s->slopes);
    for (size_t sum = 0; sum < sums_of(s); ++sum) {
        for (size_t k = 0; k < s->lost; ++k) {
            lag_axpy(m, weight(s, sum, k), s->vanishing + k * m, s->sums + sum * m);
            lag_axpy(s->open, weight(s, sum, k), s->slope + k * s->open, s->slopes + sum * s->open);
        }
    }
}

/* Second derivatives of the sums along the tangents, (sum, tangent, tangent): what else changes is of second order. */
static int bend(lag_branch_point *s)
{
    const size_t n = width_of(s);
    const size_t open = s->open;
    lag_fill(LAG_BRANCH_SUMS * open * open, 0.0, s->bends);
    memcpy(s->step, s->point, n * sizeof(double));
    for (size_t d = 0; d < open; ++d) {
        for (int sign = 1; sign >= -1; sign -= 2) {
            memcpy(s->point, s->step, n * sizeof(double));
            lag_axpy(n, sign * DIFFERENCE, s->tangents + d * n, s->point);
            const int known = look(s);
            memcpy(s->point, s->step, n * sizeof(double));
            if (!known) {
                return 0;
            }
            combine(s, sums_of(s), s->sums);
            for (size_t sum = 0; sum < sums_of(s); ++sum) {
                for (size_t f = 0; f < open; ++f) {
                    s->bends[(sum * open + d) * open + f] +=
                        sign / (2.0 * DIFFERENCE) * lag_dot(n, s->moved + sum * n, s->tangents + f * n);
                }
            }
        }
    }
    return lag_finite(LAG_BRANCH_SUMS * open * open, s->bends);
}

/* The step along the tangents that makes the slopes of the sums vanish, as well as that can be, of least length: into `wanted` (open). */
static void solve(lag_branch_point *s)
{
    const size_t open = s->open;
    double largest = 0.0;
    lag_fill(open * open, 0.0, s->normal);
    lag_fill(open, 0.0, s->step);
    for (size_t sum = 0; sum < sums_of(s); ++sum) {
        const double *bends = s->bends + sum * open * open;
        for (size_t d = 0; d < open; ++d) {
            s->step[d] -= lag_dot(open, bends + d * open, s->slopes + sum * open);
            for (size_t e = 0; e < open; ++e) {
                s->normal[d * open + e] += lag_dot(open, bends + d * open, bends + e * open);
            }
        }
    }
    lag_symmetric_eigen(open, s->normal, s->eigen, s->vectors);
    for (size_t i = 0; i < open; ++i) {
        largest = fmax(largest, s->eigen[i]);
    }
    lag_fill(open, 0.0, s->wanted);
    for (size_t i = 0; i < open; ++i) {
        double part = 0.0;
        for (size_t d = 0; d < open; ++d) {
            part += s->vectors[d * open + i] * s->step[d];
        }
        for (size_t d = 0; d < open && s->eigen[i] > LOOSE * LOOSE * largest; ++d) {
            s->wanted[d] += s->vectors[d * open + i] * part / s->eigen[i];
        }
    }
}

/* One step of Newton's method from the point, where everything is known; its length, infinite where there is none. */
static double improve(lag_branch_point *s, int anew)
{
    const size_t m = rows_of(s);
    const size_t n = width_of(s);
    add_up(s);
    for (size_t j = 0; j < s->held; ++j) {
        s->back[j] = -lag_dot(m, s->holding + j * m, s->phi);
    }
    lag_lu_solve(s->held, s->inner, s->pivot, s->back);
    if (anew && !bend(s)) {
        return (double)INFINITY;
    }
    solve(s);
    lag_fill(n, 0.0, s->step);
    for (size_t f = 0; f < s->open; ++f) {
        lag_axpy(n, s->wanted[f], s->tangents + f * n, s->step);
    }
    for (size_t j = 0; j < s->held; ++j) {
        lag_axpy(n, s->back[j], s->along + j * n, s->step);
    }
    const double length = sqrt(lag_dot(n, s->step, s->step));
    if (!(length <= 1.0)) {
        return (double)INFINITY;
    }
    lag_axpy(n, 1.0, s->step, s->point);
    return length;
}

/* Height of the combinations that vanish at the point, if they are level there. */
static double height(lag_branch_point *s)
{
    const size_t m = rows_of(s);
    double most = 0.0;
    if (!reduce(s)) {
        return (double)INFINITY;
    }
    for (size_t k = 0; k < s->lost; ++k) {
        most = fmax(most, fabs(lag_dot(m, s->vanishing + k * m, s->phi)));
    }
    for (size_t i = 0; i < s->lost * s->open; ++i) {
        most = fabs(s->slope[i]) <= LEVEL ? most : (double)INFINITY;
    }
    return most;
}

/* Time moves the constraints by their size where its coordinate grows by one. */
static int begin(lag_branch_point *s, double t, const double *x)
{
    const lag_model *model = s->run->motion.model;
    const size_t n = model->nq;
    double speed = 0.0;
    memmove(s->origin, x, lag_motion_size(model) * sizeof(double));
    for (size_t j = 0; j < n; ++j) {
        s->point[j] = x[j] / s->run->natural[j];
    }
    s->t = t;
    s->point[n] = 0.0;
    s->pace = 1.0;
    if (!look(s)) {
        return 0;
    }
    for (size_t i = 0; i < model->nc; ++i) {
        speed = fmax(speed, fabs(s->rows[i * (n + 1) + n]));
    }
    s->pace = speed > 0.0 ? 1.0 / speed : 1.0;
    return look(s);
}

double lag_branch_point_height(lag_branch_point *s, size_t general, double t, const double *x)
{
    double length = 1.0;
    s->general = general;
    if (general == 0 || !begin(s, t, x)) {
        return (double)INFINITY;
    }
    take_apart(s);
    for (int k = 0; k < ITERATIONS && reduce(s); ++k) {
        length = improve(s, length > FAR);
        if (!(length < (double)INFINITY)) {
            return (double)INFINITY;
        }
        if (length <= SETTLED) {
            return height(s);
        }
    }
    return (double)INFINITY;
}
