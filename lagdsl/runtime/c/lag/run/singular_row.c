/* Accelerations and multipliers in rows on singular positions: where J loses rank, they are the limits along the motion. */
#include <math.h>
#include <string.h>

#include "lag/events/event_iteration.h"
#include "lag/linalg/arena.h"
#include "lag/run.h"
#include "lag/linalg/fit_polynomial.h"

enum { NODES = LAG_FIT_NODES };

/* Accelerations are off by some 1e-9 of their size, divided by the smallest singular value of J: from here on that counts. */
static const double BESIDE = 1e-4;
/* Extrapolated with and without a node, a multiplier that has a limit differs by less than this part of its size. */
static const double LIMIT = 1e-3;
/* Sizes below this part of the largest multiplier are round-off. */
static const double SMALL = 1e-6;

static double largest_of(size_t count, size_t stride, const double *values)
{
    double most = 0.0;
    for (size_t i = 0; i < count; ++i) {
        most = fmax(most, fabs(values[i * stride]));
    }
    return most;
}

/* A polynomial with these coefficients. */
static double value_at(size_t count, size_t stride, const double *coefficients, double part)
{
    double value = 0.0;
    for (size_t k = count; k-- > 0;) {
        value = value * part + coefficients[k * stride];
    }
    return value;
}

/* A motion that was fitted from `start` at time t, and the place in it where a row is. */
typedef struct fitted {
    const double *coefficients, *start;
    double t, length, part;
} fitted;

/* Multipliers at the nodes, (NODES, nc); 0: there are none. */
static int solve_at_nodes(lag_singular *s, const fitted *motion, double *multipliers)
{
    lag_motion *solved = &s->run->motion;
    const lag_model *model = solved->model;
    int moved = 0;
    for (size_t i = 0; i < NODES; ++i) {
        const double node = lag_fit_node(i);
        const double time = motion->t + motion->length * node;
        lag_fit_state_at(model->nq, model->nq + model->nz, motion->coefficients, motion->start, motion->length, node, s->state);
        if (lag_projection_exact(&s->run->projection, time, s->state, &moved) != LAG_OK ||
            lag_motion_solve(solved, time, s->state) != LAG_OK) {
            return 0;
        }
        memcpy(multipliers + i * model->nc, solved->lam, model->nc * sizeof(double));
    }
    return 1;
}

/* Multipliers (nc) at the place, from both sides or one; without a limit they are no numbers. */
static void find_limits(lag_singular *s, const fitted *motion, double *limits)
{
    const size_t m = s->run->motion.model->nc;
    double *all = s->multipliers;
    double *fewer = all + NODES * m;
    lag_fill(m, (double)NAN, limits);
    if (!solve_at_nodes(s, motion, all)) {
        return;
    }
    const double least = SMALL * largest_of(NODES * m, 1, all);
    for (size_t i = 0; i < m; ++i) {
        limits[i] = fmax(largest_of(NODES, m, all + i), least);
    }
    memcpy(fewer, all + m, (NODES - 1) * m * sizeof(double));
    lag_fit_interpolate(NODES, m, all);
    lag_fit_interpolate(NODES - 1, m, fewer);
    for (size_t i = 0; i < m; ++i) {
        const double found = value_at(NODES, m, all + i, motion->part);
        const double other = value_at(NODES - 1, m, fewer + i, motion->part);
        limits[i] = fabs(found - other) <= LIMIT * limits[i] ? found : (double)NAN;
    }
}

/* The motion across or out of the position: the last step, or one that begins at the state; 0: none is found. */
static int find_motion(lag_singular *s, double t, const double *x, int after_event, fitted *motion)
{
    const lag_stepper *stepper = &s->run->stepper;
    *motion = (fitted){s->best, x, t, 0.0, 0.0};
    if (!after_event && stepper->method == &lag_branch_switching && t >= stepper->t_before && t <= stepper->t) {
        const double length = stepper->work[1];
        *motion = (fitted){stepper->work + 2, stepper->x_before, stepper->t_before, length, (t - stepper->t_before) / length};
        return 1;
    }
    return lag_fit_beside(s, t, x, &motion->length);
}

void lag_singular_row(lag_singular *s, double t, const double *x, int after_event)
{
    lag_motion *motion = &s->run->motion;
    const size_t n = motion->model->nq;
    fitted from;
    const double margin = lag_singular_margin(s, t, x, s->now);
    const int known = margin <= BESIDE && find_motion(s, t, x, after_event, &from);
    if (known) {
        find_limits(s, &from, s->limits);
    }
    lag_event_iteration_solve(motion, t, x);
    for (size_t j = 0; j < n && known; ++j) {
        motion->qdd[j] = value_at(NODES, n + motion->model->nz, from.coefficients + j, from.part);
    }
    for (size_t i = 0; i < motion->model->nc && known; ++i) {
        motion->lam[i] = margin > LAG_LOST && isnan(s->limits[i]) ? motion->lam[i] : s->limits[i]; /* large, not without end */
    }
}
