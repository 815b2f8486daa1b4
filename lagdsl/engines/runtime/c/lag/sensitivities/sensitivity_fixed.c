/*
 * Columns along one step of fixed length (lag/fixed.h), stage by stage: the derivative of what its formula makes of the state. Stages of the state
 * are found again. Of ROS2 the matrix changes, too:
 *
 *     (1 - gamma h J) dk = d f + gamma h dJ k ,    dJ k = d/de f_x(x + e k) s  at e = 0 ,
 *
 * by differences of the sixth order of rates along columns. Rows within the step are on the cubic of the method.
 */
#include <string.h>

#include "lag/factorization/lu.h"
#include "lag/fixed.h"
#include "lag/linalg/arena.h"
#include "lag/linalg/vector.h"
#include "lag/run.h"
#include "lag/sensitivities/sensitivities.h"

/* Slopes of a step in work.slopes: of its stages, of what its matrix changes, at its end; and the columns there, before they are projected. */
enum { STAGES = 4, BENT = STAGES, BEHIND, END };

/* So many doubles of a block there. */
static size_t count_of(const lag_sensitivities *s, const lag_run *run, size_t block)
{
    return run->stepper.ode->size * lag_columns_lanes(s, block);
}

static double *slot(const lag_sensitivities *s, const lag_run *run, size_t block, size_t i)
{
    return s->work.slopes + block * LAG_DOP853_SLOPES * run->stepper.ode->size * s->columns.lanes + i * count_of(s, run, block);
}

/* Into the rows of q adds factor times the rows of qd of `from`. */
static void add_drift(const lag_sensitivities *s, const lag_run *run, size_t block, double factor, const double *from, double *to)
{
    const size_t rows = run->stepper.ode->nq * lag_columns_lanes(s, block);
    lag_axpy(rows, factor, from + rows, to);
}

/* The columns of a block where the step begins, and `part` (STAGES) of its slopes, into `to`. */
static void combine(const lag_sensitivities *s, const lag_run *run, size_t block, const double *part, double *to)
{
    const size_t count = count_of(s, run, block);
    memcpy(to, lag_columns_before(s, run->stepper.ode->size, block), count * sizeof(double));
    for (size_t i = 0; i < STAGES; ++i) {
        if (part[i] != 0.0) {
            lag_axpy(count, part[i], slot(s, run, block, i), to);
        }
    }
}

/* Rates at the state x along the columns of a block in work.point. */
static lag_status rates_along(lag_sensitivities *s, lag_run *run, size_t block, double t, const double *x, double *to)
{
    const size_t count = count_of(s, run, block);
    const size_t variables = lag_columns_variables(run->motion.model);
    const double *now = s->columns.x + block * variables * s->columns.lanes;
    memcpy(s->work.point + count, now + count, (variables * lag_columns_lanes(s, block) - count) * sizeof(double));
    return lag_columns_rates(s, run, block, t, x, s->work.point, to, NULL);
}

/* The slopes of stage `number` of all blocks, at the state x; `drift`: part of the first slope of rates that positions move by. */
static lag_status stage(lag_sensitivities *s, lag_run *run, double t, const double *x, size_t number, const double *part, double drift)
{
    lag_status status = lag_columns_set_state(s, run, t, x, 0);
    for (size_t block = 0; block < s->columns.blocks && status == LAG_OK; ++block) {
        combine(s, run, block, part, s->work.point);
        if (drift != 0.0) {
            add_drift(s, run, block, drift, slot(s, run, block, 0), s->work.point);
        }
        status = rates_along(s, run, block, t, x, slot(s, run, block, number));
    }
    return status;
}

static lag_status rk4_step(lag_sensitivities *s, lag_run *run, double h)
{
    static const double node[STAGES] = {0.0, 0.5, 0.5, 1.0};
    const lag_stepper *stepper = &run->stepper;
    const size_t n = stepper->ode->size;
    const double part[STAGES] = {h / 6.0, h / 3.0, h / 3.0, h / 6.0};
    double *x = s->work.state_of_stage;
    lag_status status = LAG_OK;
    for (size_t k = 0; k < STAGES && status == LAG_OK; ++k) {
        double before[STAGES] = {0.0};
        const double t = stepper->t_before + node[k] * h;
        memcpy(x, stepper->x_before, n * sizeof(double));
        if (k > 0) {
            before[k - 1] = node[k] * h;
            lag_axpy(n, before[k - 1], s->work.state, x);
        }
        status = run->motion.ode.rates(&run->motion, t, x, s->work.state);
        status = status == LAG_OK ? stage(s, run, t, x, k, before, 0.0) : status;
    }
    for (size_t block = 0; block < s->columns.blocks && status == LAG_OK; ++block) {
        combine(s, run, block, part, slot(s, run, block, END));
    }
    return status;
}

static lag_status leapfrog_step(lag_sensitivities *s, lag_run *run, double h)
{
    const lag_stepper *stepper = &run->stepper;
    const size_t n = stepper->ode->size;
    const size_t nq = stepper->ode->nq;
    const double kick[STAGES] = {0.0};
    const double drift[STAGES] = {h};
    const double part[STAGES] = {0.5 * h, 0.5 * h};
    double *x = s->work.state_of_stage;
    memcpy(x, stepper->x_before, n * sizeof(double));
    lag_axpy(n, h, stepper->f_before, x);
    lag_axpy(nq, 0.5 * h * h, stepper->f_before + nq, x);
    lag_status status = stage(s, run, stepper->t_before, stepper->x_before, 0, kick, 0.0);
    status = status == LAG_OK ? stage(s, run, stepper->t, x, 1, drift, 0.5 * h * h) : status;
    for (size_t block = 0; block < s->columns.blocks && status == LAG_OK; ++block) {
        const double *first = slot(s, run, block, 0);
        double *end = slot(s, run, block, END);
        combine(s, run, block, part, end);
        combine(s, run, block, drift, s->work.point);
        add_drift(s, run, block, 0.5 * h * h, first, s->work.point);
        memcpy(end, s->work.point, nq * lag_columns_lanes(s, block) * sizeof(double));
    }
    return status;
}

/* ---- ROS2 ---- */

static lag_status decompose(const lag_stepper *stepper, const lag_rosenbrock_system *at)
{
    const double h = stepper->t - stepper->t_before;
    const size_t n = stepper->ode->size;
    const lag_status status = stepper->ode->jacobian(stepper->ode->context, stepper->t_before, stepper->x_before, at->matrix);
    for (size_t i = 0; i < n * n; ++i) {
        at->matrix[i] *= -lag_ros2_gamma() * h;
    }
    for (size_t i = 0; i < n; ++i) {
        at->matrix[i * n + i] += 1.0;
    }
    return status != LAG_OK || lag_lu(n, at->matrix, at->pivots) ? status : LAG_SINGULAR;
}

/* d/de of the rates along the columns at x + e k, where the step begins, into the slots BENT. */
static lag_status bend(lag_sensitivities *s, lag_run *run, const double *k)
{
    const lag_stepper *stepper = &run->stepper;
    const size_t n = stepper->ode->size;
    const lag_displacement along = {0.0, k, NULL, NULL, NULL, NULL};
    s->differences.run = run;
    const double extent = lag_differences_extent(&s->differences, &along);
    const double by = extent > 0.0 ? lag_differences_step() / extent : 0.0;
    double *x = s->work.state_of_stage;
    lag_status status = LAG_OK;
    for (size_t block = 0; block < s->columns.blocks; ++block) {
        lag_fill(count_of(s, run, block), 0.0, slot(s, run, block, BENT));
    }
    for (int place = -LAG_POINTS; place <= LAG_POINTS && by > 0.0 && status == LAG_OK; place += place == -1 ? 2 : 1) {
        const double weight = (place > 0 ? lag_sixth[place - 1] : -lag_sixth[-place - 1]) / by;
        memcpy(x, stepper->x_before, n * sizeof(double));
        lag_axpy(n, place * by, k, x);
        status = lag_columns_set_state(s, run, stepper->t_before, x, 0);
        for (size_t block = 0; block < s->columns.blocks && status == LAG_OK; ++block) {
            const size_t count = count_of(s, run, block);
            memcpy(s->work.point, lag_columns_before(s, run->stepper.ode->size, block), count * sizeof(double));
            status = rates_along(s, run, block, stepper->t_before, x, s->work.rates);
            lag_axpy(count, weight, s->work.rates, slot(s, run, block, BENT));
        }
    }
    return status;
}

/* The slopes of stage `number`, without the matrix, become those with it: less so much of the first ones. */
static void solve(lag_sensitivities *s, lag_run *run, const lag_rosenbrock_system *at, size_t number, double less)
{
    const double h = run->stepper.t - run->stepper.t_before;
    const size_t n = run->stepper.ode->size;
    for (size_t block = 0; block < s->columns.blocks; ++block) {
        const size_t lanes = lag_columns_lanes(s, block);
        double *slope = slot(s, run, block, number);
        lag_axpy(n * lanes, lag_ros2_gamma() * h, slot(s, run, block, BENT), slope);
        lag_axpy(n * lanes, -less, slot(s, run, block, 0), slope);
        for (size_t lane = 0; lane < lanes; ++lane) {
            lag_lane_get(lanes, lane, n, slope, at->right);
            lag_lu_solve(n, at->matrix, at->pivots, at->right);
            lag_lane_put(lanes, lane, n, at->right, slope);
        }
    }
}

static lag_status ros2_step(lag_sensitivities *s, lag_run *run, double h)
{
    const lag_stepper *stepper = &run->stepper;
    const size_t n = stepper->ode->size;
    const lag_rosenbrock_system at = s->rosenbrock;
    const double begin[STAGES] = {0.0};
    const double whole[STAGES] = {h};
    const double part[STAGES] = {1.5 * h, 0.5 * h};
    double *x = s->work.state;
    lag_status status = decompose(stepper, &at);
    memcpy(at.k[0], stepper->f_before, n * sizeof(double));
    if (status == LAG_OK) {
        lag_lu_solve(n, at.matrix, at.pivots, at.k[0]);
        status = bend(s, run, at.k[0]);
    }
    status = status == LAG_OK ? stage(s, run, stepper->t_before, stepper->x_before, 0, begin, 0.0) : status;
    if (status != LAG_OK) {
        return status;
    }
    solve(s, run, &at, 0, 0.0);
    memcpy(x, stepper->x_before, n * sizeof(double));
    lag_axpy(n, h, at.k[0], x);
    status = run->motion.ode.rates(&run->motion, stepper->t, x, at.k[1]);
    if (status == LAG_OK) {
        lag_axpy(n, -2.0, at.k[0], at.k[1]);
        lag_lu_solve(n, at.matrix, at.pivots, at.k[1]);
        status = stage(s, run, stepper->t, x, 1, whole, 0.0);
    }
    status = status == LAG_OK ? bend(s, run, at.k[1]) : status;
    if (status == LAG_OK) {
        solve(s, run, &at, 1, 2.0);
    }
    for (size_t block = 0; block < s->columns.blocks && status == LAG_OK; ++block) {
        combine(s, run, block, part, slot(s, run, block, END));
    }
    return status;
}

/* ---- all ---- */

lag_status lag_columns_fixed_step(lag_sensitivities *s, lag_run *run)
{
    const lag_stepper *stepper = &run->stepper;
    const double h = stepper->t - stepper->t_before;
    const size_t height = lag_columns_variables(run->motion.model) * s->columns.lanes;
    const lag_status status = stepper->method == &lag_steps_leapfrog ? leapfrog_step(s, run, h) :
        stepper->method == &lag_steps_ros2 ? ros2_step(s, run, h) : rk4_step(s, run, h);
    for (size_t block = 0; block < s->columns.blocks && status == LAG_OK; ++block) {
        memcpy(s->columns.x + block * height, slot(s, run, block, END), count_of(s, run, block) * sizeof(double));
    }
    return status;
}

lag_status lag_columns_prepare_fixed(lag_sensitivities *s, lag_run *run)
{
    const lag_stepper *stepper = &run->stepper;
    const double begin[STAGES] = {0.0};
    lag_status status = stage(s, run, stepper->t_before, stepper->x_before, 0, begin, 0.0);
    status = status == LAG_OK ? lag_stepper_dense(&run->stepper, stepper->t, s->work.state) : status;
    status = status == LAG_OK ? lag_columns_set_state(s, run, stepper->t, s->work.state, 0) : status;
    for (size_t block = 0; block < s->columns.blocks && status == LAG_OK; ++block) {
        memcpy(s->work.point, slot(s, run, block, END), count_of(s, run, block) * sizeof(double));
        status = rates_along(s, run, block, stepper->t, s->work.state, slot(s, run, block, BEHIND));
    }
    return status;
}

void lag_columns_fixed_dense(const lag_sensitivities *s, const lag_run *run, size_t block, double h, double part, double *to)
{
    const size_t count = count_of(s, run, block);
    const double *before = lag_columns_before(s, run->stepper.ode->size, block);
    const double *end = slot(s, run, block, END);
    const double *slope = slot(s, run, block, 0);
    const double *behind = slot(s, run, block, BEHIND);
    for (size_t i = 0; i < count; ++i) {
        const double change = end[i] - before[i];
        const double bent = (1.0 - 2.0 * part) * change + (part - 1.0) * h * slope[i] + part * h * behind[i];
        to[i] = before[i] + part * change + part * (part - 1.0) * bent;
    }
}
