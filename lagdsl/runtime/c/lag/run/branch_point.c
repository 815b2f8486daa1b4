/*
 * Branches that meet do so in a saddle of a combination u of the rows: u'J = 0 there. Its height, u'phi, is zero; where it is not, they miss
 * each other by as much and the motion turns away, however sharply.
 */
#include <math.h>
#include <string.h>

#include "lag/linalg/finite.h"
#include "lag/linalg/arena.h"
#include "lag/run.h"
#include "lag/linalg/svd.h"

static const double NEAR = 0.05;
static const double LOOSE = 1e-6;
static const double SETTLED = 1e-8;
static const double LEVEL = 1e-6;
static const double DIFFERENCE = 1e-5;
enum { ITERATIONS = 12 };

/* A search: time is a coordinate like others, scaled so that the constraints move by their size. */
typedef struct branch_point {
    lag_singular *s;
    double t, pace;
    const double *x;     /* the state it starts from */
    size_t held, lost;   /* combinations of rows that do not vanish, and those that do */
} branch_point;

static double product(size_t n, const double *a, const double *b)
{
    double sum = 0.0;
    for (size_t i = 0; i < n; ++i) {
        sum += a[i] * b[i];
    }
    return sum;
}

/* phi, of position rows, into `left` and [J b] into `wide` (nc, nq + 1), scaled, at a point; 0: no numbers. */
static int rows_at(const branch_point *it, const double *point)
{
    lag_singular *s = it->s;
    lag_motion *motion = &s->run->motion;
    lag_projection *projection = &s->run->projection;
    const lag_model *model = motion->model;
    const size_t n = model->nq;
    const double *sizes = s->run->natural;
    memcpy(s->state, it->x, lag_motion_size(model) * sizeof(double));
    for (size_t j = 0; j < n; ++j) {
        s->state[j] = point[j] * sizes[j];
    }
    lag_motion_look(motion, it->t + it->pace * point[n], s->state);
    motion->at.qd = s->still;
    if (model->velocity_constraint(&motion->at, projection->phi, projection->jacobian) != LAG_OK) {
        return 0;
    }
    for (size_t i = 0; i < model->nc; ++i) {
        const double row = s->run->row_sizes[i];
        for (size_t j = 0; j < n; ++j) {
            s->wide[i * (n + 1) + j] = projection->jacobian[i * n + j] * sizes[j] / row;
        }
        s->wide[i * (n + 1) + n] = projection->phi[i] * it->pace / row;
    }
    if (model->position_constraint(&motion->at, projection->phi, projection->jacobian) != LAG_OK) {
        return 0;
    }
    for (size_t i = 0; i < model->nc; ++i) {
        s->left[i] = model->position_level[i] ? projection->phi[i] / s->run->row_sizes[i] : 0.0;
    }
    return lag_finite(model->nc, s->left) && lag_finite(model->nc * (n + 1), s->wide);
}

/* Finds the combinations of rows that vanish and the directions that the others leave free; 0 if too many vanish. */
static int take_apart(branch_point *it)
{
    lag_singular *s = it->s;
    const size_t m = s->run->motion.model->nc;
    const size_t n = s->run->motion.model->nq + 1;
    size_t large = 0;
    for (size_t i = 0; i < m; ++i) {
        for (size_t j = 0; j < n; ++j) {
            s->tall[j * m + i] = s->wide[i * n + j];
        }
    }
    const lag_svd rows = lag_svd_of(n, m, s->tall, s->memory);
    while (large < rows.k && large < s->general && rows.value[large] > NEAR) {
        ++large;
    }
    it->held = large < s->general - 1 ? large : s->general - 1;
    it->lost = s->general - it->held;
    if (it->lost > LAG_MOST_LOST) {
        return 0;
    }
    memcpy(s->holding, rows.v, it->held * m * sizeof(double));
    memcpy(s->vanishing, rows.v + it->held * m, it->lost * m * sizeof(double));
    const lag_svd columns = lag_svd_of(m, n, s->wide, s->memory);
    memcpy(s->free, columns.v + it->held * n, (n - it->held) * n * sizeof(double));
    return 1;
}

/* u'[J b] (lost, nq + 1) for those that vanish, added with a factor. */
static void add_slope(const branch_point *it, double factor, double *slope)
{
    const lag_singular *s = it->s;
    const size_t m = s->run->motion.model->nc;
    const size_t n = s->run->motion.model->nq + 1;
    for (size_t k = 0; k < it->lost; ++k) {
        for (size_t i = 0; i < m; ++i) {
            for (size_t j = 0; j < n; ++j) {
                slope[k * n + j] += factor * s->vanishing[k * m + i] * s->wide[i * n + j];
            }
        }
    }
}

/* Second derivatives of the combinations that vanish, (direction, combination, column). */
static int bend(const branch_point *it)
{
    lag_singular *s = it->s;
    const size_t n = s->run->motion.model->nq + 1;
    for (size_t d = 0; d < n; ++d) {
        double *slope = s->slopes + d * LAG_MOST_LOST * n;
        const double kept = s->point[d];
        lag_fill(LAG_MOST_LOST * n, 0.0, slope);
        for (int sign = 1; sign >= -1; sign -= 2) {
            s->point[d] = kept + sign * DIFFERENCE;
            if (!rows_at(it, s->point)) {
                s->point[d] = kept;
                return 0;
            }
            add_slope(it, sign / (2.0 * DIFFERENCE), slope);
        }
        s->point[d] = kept;
    }
    return 1;
}

/* Newton's equations for u'[J b] = 0 along what is free, where the rows that do not vanish hold. Returns their number. */
static size_t state_lines(const branch_point *it, const double *phi, const double *slope)
{
    lag_singular *s = it->s;
    const size_t m = s->run->motion.model->nc;
    const size_t n = s->run->motion.model->nq + 1;
    size_t line = 0;
    for (; line < it->held; ++line) {
        s->wanted[line] = product(m, s->holding + line * m, phi);
        for (size_t j = 0; j < n; ++j) {
            double sum = 0.0;
            for (size_t i = 0; i < m; ++i) {
                sum += s->holding[line * m + i] * s->tall[j * m + i];
            }
            s->lines[line * n + j] = sum;
        }
    }
    for (size_t k = 0; k < it->lost; ++k) {
        for (size_t i = 0; i < n - it->held; ++i, ++line) {
            s->wanted[line] = product(n, s->free + i * n, slope + k * n);
            for (size_t d = 0; d < n; ++d) {
                s->lines[line * n + d] = product(n, s->free + i * n, s->slopes + (d * LAG_MOST_LOST + k) * n);
            }
        }
    }
    return line;
}

/* Height of the combinations that vanish at the point, if they are level there. */
static double height(const branch_point *it)
{
    lag_singular *s = it->s;
    const size_t m = s->run->motion.model->nc;
    const size_t n = s->run->motion.model->nq + 1;
    double *slope = s->lines;
    double most = 0.0;
    if (!rows_at(it, s->point)) {
        return (double)INFINITY;
    }
    lag_fill(it->lost * n, 0.0, slope);
    add_slope(it, 1.0, slope);
    for (size_t i = 0; i < it->lost * n; ++i) {
        if (!(fabs(slope[i]) <= LEVEL)) {
            return (double)INFINITY;
        }
    }
    for (size_t k = 0; k < it->lost; ++k) {
        most = fmax(most, fabs(product(m, s->vanishing + k * m, s->left)));
    }
    return most;
}

/* One step of Newton's method; its length, infinite where there is none. */
static double improve(branch_point *it)
{
    lag_singular *s = it->s;
    const size_t m = s->run->motion.model->nc;
    const size_t n = s->run->motion.model->nq + 1;
    double *phi = s->step + n;
    double *slope = phi + m;
    if (!rows_at(it, s->point) || !take_apart(it)) {
        return (double)INFINITY;
    }
    memcpy(phi, s->left, m * sizeof(double));
    lag_fill(LAG_MOST_LOST * n, 0.0, slope);
    add_slope(it, 1.0, slope);
    if (!bend(it)) {
        return (double)INFINITY;
    }
    const size_t lines = state_lines(it, phi, slope);
    if (!lag_finite(lines * n, s->lines)) {
        return (double)INFINITY;
    }
    const lag_svd svd = lag_svd_of(lines, n, s->lines, s->memory);
    lag_svd_solve(&svd, s->wanted, LOOSE, 0.0, s->step);
    const double length = sqrt(product(n, s->step, s->step));
    for (size_t j = 0; j < n && length <= 1.0; ++j) {
        s->point[j] -= s->step[j];
    }
    return length <= 1.0 ? length : (double)INFINITY;
}

double lag_branch_point_height(lag_singular *s, double t, const double *x)
{
    const lag_model *model = s->run->motion.model;
    const size_t n = model->nq;
    branch_point it = {s, t, 0.0, x, 0, 0};
    double speed = 0.0;
    if (s->general == 0) {
        return (double)INFINITY;
    }
    memcpy(s->origin, x, lag_motion_size(model) * sizeof(double));
    it.x = s->origin;
    for (size_t j = 0; j < n; ++j) {
        s->point[j] = x[j] / s->run->natural[j];
    }
    s->point[n] = 0.0;
    it.pace = 1.0;
    if (!rows_at(&it, s->point)) {
        return (double)INFINITY;
    }
    for (size_t i = 0; i < model->nc; ++i) {
        speed = fmax(speed, fabs(s->wide[i * (n + 1) + n]));
    }
    it.pace = speed > 0.0 ? 1.0 / speed : 1.0;
    for (int k = 0; k < ITERATIONS; ++k) {
        const double length = improve(&it);
        if (!(length < (double)INFINITY)) {
            return (double)INFINITY;
        }
        if (length <= SETTLED) {
            return height(&it);
        }
    }
    return (double)INFINITY;
}
