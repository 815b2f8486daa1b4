/* Singular positions on the way: rank is watched, the motion out of and across them is fitted. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "lag/linalg/eigenvalues.h"
#include "lag/linalg/finite.h"
#include "lag/linalg/arena.h"
#include "lag/run.h"
#include "lag/linalg/singular_value.h"
#include "lag/linalg/svd.h"

/* Singular values of J, rows of size one: where rank counts as lost, where that seems near, and where branches are not told apart any more. */
static const double LOST = LAG_LOST;
static const double NEAR = 0.05;
/* A motion that begins where they are smaller than this is fitted away from there. */
static const double BESIDE = 1e-3;
/* Round-off of a projection exceeds the error of a fit where they are smaller than this, and may lead to another branch. */
static const double BLURRED = 1e-6;
static const double UNDECIDED = 1e-5;
/* J has turned by much in a step where less than this part of a direction is left; so often a step is halved to see whether steadily. */
static const double TURNED = 0.25;
static const double MEETING = 1e-12;
static const double SHORTER = 0.25;
enum { HALVINGS = 6, NODES = 7 };

static size_t larger(size_t a, size_t b)
{
    return a > b ? a : b;
}

/* ---- memory ---- */

size_t lag_singular_memory(const lag_model *model)
{
    const size_t m = model->nc;
    const size_t n = model->nq;
    const size_t k = m < n ? m : n;
    const size_t values = larger(lag_singular_value_memory(m, n), lag_eigenvalues_memory(k));
    return lag_parts_memory(m, n) + 2 * (m + n) + 5 * m * n + k * k + 4 * m + 4 * NODES * (n + model->nz) + 4 * lag_motion_size(model) +
           (2 * NODES + 1) * m + lag_branch_point_memory(model) + larger(values, lag_svd_memory(n, m));
}

void lag_singular_place(lag_singular *s, lag_run *run, double *memory)
{
    const lag_model *model = run->motion.model;
    const size_t m = model->nc;
    const size_t n = model->nq;
    const size_t k = m < n ? m : n;
    const lag_pattern *entries = model->jacobian_pattern;
    memset(s, 0, sizeof *s);
    s->run = run;
    double *for_parts = lag_take(&memory, lag_parts_memory(m, n));
    s->counts = lag_take(&memory, m + n);
    s->before = lag_take(&memory, m * n);
    s->now = lag_take(&memory, m * n);
    s->block = lag_take(&memory, m * n);
    s->other = lag_take(&memory, m * n);
    s->turned = lag_take(&memory, k * k);
    s->kept = lag_take(&memory, m + n);
    s->factors = lag_take(&memory, m * n);
    s->tau = lag_take(&memory, m);
    s->diagonal = lag_take(&memory, m);
    s->pivot = lag_take(&memory, m);
    s->left = lag_take(&memory, m);
    lag_branch_point_place(&s->saddle, run, lag_take(&memory, lag_branch_point_memory(model)));
    double **const along[] = {&s->branch, &s->earlier, &s->coefficients, &s->best};
    double **const states[] = {&s->state, &s->rates, &s->origin, &s->end};
    for (size_t i = 0; i < 4; ++i) {
        *along[i] = lag_take(&memory, NODES * (n + model->nz));
        *states[i] = lag_take(&memory, lag_motion_size(model));
    }
    s->multipliers = lag_take(&memory, 2 * NODES * m);
    s->limits = lag_take(&memory, m);
    s->memory = memory;
    lag_fill(m * n, entries != NULL ? 0.0 : 1.0, s->now);
    for (size_t i = 0; entries != NULL && i < entries->count; ++i) {
        s->now[entries->row[i] * n + entries->column[i]] = 1.0;
    }
    s->parts = lag_parts_of(m, n, s->now, for_parts);
    s->margin = (double)INFINITY;
}

void lag_singular_count(lag_singular *s, const double *lasting)
{
    const lag_model *model = s->run->motion.model;
    lag_fill(model->nc + model->nq, 0.0, s->counts);
    s->general = 0;
    for (size_t i = 0; i < model->nc; ++i) {
        if (!(model->redundant != NULL && model->redundant[i]) && lasting[i] != 0.0) {
            s->counts[(size_t)s->parts.row_part[i]] += 1.0;
            ++s->general;
        }
    }
}

/* ---- looks ---- */

static int jacobian_at(lag_singular *s, double t, const double *x, double *jacobian)
{
    lag_motion *motion = &s->run->motion;
    const lag_model *model = motion->model;
    lag_motion_look(motion, t, x);
    if (model->velocity_constraint(&motion->at, s->run->projection.phi, jacobian) != LAG_OK) {
        return 0;
    }
    for (size_t i = 0; i < model->nc; ++i) {
        for (size_t j = 0; j < model->nq; ++j) {
            jacobian[i * model->nq + j] *= s->run->natural[j] / s->run->row_sizes[i];
        }
    }
    return lag_finite(model->nc * model->nq, jacobian);
}

double lag_singular_margin(lag_singular *s, double t, const double *x, double *jacobian)
{
    double margin = (double)INFINITY;
    if (!jacobian_at(s, t, x, jacobian)) {
        return 0.0;
    }
    for (size_t which = 0; which < s->parts.count; ++which) {
        size_t first = 0;
        const size_t rows = lag_parts_rows(&s->parts, which, &first);
        const size_t columns = lag_parts_columns(&s->parts, which, &first);
        const size_t count = (size_t)s->counts[which];
        if (count > 0) {
            (void)lag_parts_block(&s->parts, which, s->run->motion.model->nq, jacobian, s->block);
            margin = fmin(margin, lag_singular_value(rows, columns, s->block, count - 1, s->memory));
        }
    }
    return margin;
}

/* The row with the largest share in the combination of rows that comes nearest to vanishing; J, scaled, is `now`. */
static size_t weakest_row(lag_singular *s)
{
    const lag_model *model = s->run->motion.model;
    const size_t n = model->nq;
    double *kept = s->left;
    size_t rows = 0;
    size_t weakest = 0;
    for (size_t i = 0; i < model->nc; ++i) {
        if (!(model->redundant != NULL && model->redundant[i]) && s->run->lasting[i] != 0.0) {
            for (size_t j = 0; j < n; ++j) {
                s->block[j * s->general + rows] = s->now[i * n + j];
            }
            kept[rows++] = (double)i;
        }
    }
    if (rows == 0) {
        return 0;
    }
    const lag_svd svd = lag_svd_of(n, rows, s->block, s->memory);
    const double *share = svd.v + (rows - 1) * rows;
    for (size_t k = 1; k < rows; ++k) {
        weakest = fabs(share[k]) > fabs(share[weakest]) ? k : weakest;
    }
    return (size_t)kept[weakest];
}

size_t lag_singular_rank(lag_singular *s, double t, const double *x, size_t *general, size_t *weakest)
{
    const size_t n = s->run->motion.model->nq;
    size_t rank = 0;
    *general = s->general;
    if (!jacobian_at(s, t, x, s->now)) {
        return s->general;
    }
    for (size_t which = 0; which < s->parts.count; ++which) {
        size_t first = 0;
        const size_t rows = lag_parts_rows(&s->parts, which, &first);
        const size_t columns = lag_parts_columns(&s->parts, which, &first);
        if (s->counts[which] > 0.0) {
            (void)lag_parts_block(&s->parts, which, n, s->now, s->block);
            const size_t above = lag_singular_values_above(rows, columns, s->block, LOST, s->memory);
            rank += above < (size_t)s->counts[which] ? above : (size_t)s->counts[which];
        }
    }
    *weakest = weakest_row(s);
    return rank;
}

static double turn_at(lag_singular *s, double t, const double *x)
{
    return jacobian_at(s, t, x, s->now) ? lag_singular_turn(s, s->now) : -(double)INFINITY;
}

/* J at a time within the last step is what turns are seen against. */
static int see_from(lag_singular *s, double t)
{
    s->seen = 0;
    return lag_stepper_dense(&s->run->stepper, t, s->end) == LAG_OK && jacobian_at(s, t, s->end, s->before);
}

/* The time in the last step at which rank was lost, about; infinite where it was not. `before` is J at its beginning. */
static double lost_at(lag_singular *s)
{
    const lag_stepper *stepper = &s->run->stepper;
    double first = stepper->t_before;
    double last = stepper->t;
    double turn = turn_at(s, last, stepper->x);
    if (turn >= TURNED) {
        return (double)INFINITY;
    }
    for (int k = 0; k < HALVINGS; ++k) {
        const double middle = 0.5 * (first + last);
        const int known = lag_stepper_dense(&s->run->stepper, middle, s->end) == LAG_OK;
        const double half = known ? turn_at(s, middle, s->end) : -(double)INFINITY;
        if (half < TURNED) {
            last = middle;
            turn = half;
        } else if (see_from(s, middle)) {
            first = middle;
            turn = last < stepper->t && lag_stepper_dense(&s->run->stepper, last, s->end) == LAG_OK ? turn_at(s, last, s->end)
                                                                                                      : turn_at(s, stepper->t, stepper->x);
        }
        if (turn >= TURNED) {
            if (last >= stepper->t || !see_from(s, last)) {
                return (double)INFINITY;
            }
            first = last;
            last = stepper->t;
            turn = turn_at(s, last, stepper->x);
        }
    }
    return first + (last - first) / (1.0 - fmin(turn, 0.0));
}

/* ---- the way on ---- */

void lag_singular_project(lag_singular *s, double t, double *x)
{
    int moved = 0;
    if (lag_singular_margin(s, t, x, s->now) > BLURRED) {
        (void)lag_projection_apply(&s->run->projection, t, x, &moved); /* where it cannot, it is as it was fitted */
    }
}

/* The fitted motion ends at `limit` at the latest. */
static double cut(lag_singular *s, double t, const double *x, double length, double limit)
{
    if (t + length <= limit) {
        return t + length;
    }
    lag_fit_state(s, x, length, (limit - t) / length, s->end);
    lag_singular_project(s, limit, s->end);
    return limit;
}

/* The fitted motion stands as the last step. */
static lag_status take(lag_singular *s, double t, const double *x, double length, double limit)
{
    lag_run *run = s->run;
    lag_stepper *stepper = &run->stepper;
    const size_t n = run->motion.model->nq;
    const size_t size = stepper->ode->size;
    memcpy(s->origin, x, size * sizeof(double));
    const double end = cut(s, t, s->origin, length, limit);
    run->behind = stepper->method == &lag_branch_switching ? run->behind : stepper->method;
    stepper->method = &lag_branch_switching;
    stepper->work[0] = (double)n;
    stepper->work[1] = length;
    memcpy(stepper->work + 2, s->best, NODES * (size - n) * sizeof(double));
    if (t == stepper->t) {
        memcpy(stepper->f_before, stepper->f, size * sizeof(double));
    }
    memcpy(stepper->x_before, s->origin, size * sizeof(double));
    memcpy(stepper->x, s->end, size * sizeof(double));
    stepper->t_before = t;
    stepper->t = end;
    stepper->h = 0.0;
    stepper->error = stepper->h_of_error = stepper->urge = 0.0;
    stepper->dense_ready = 1;
    ++stepper->steps;
    run->look.rank = 0;
    s->leave = 0;
    s->distance = 0.0;
    s->margin = (double)INFINITY;
    return lag_stepper_correct(stepper);
}

/* The motion across a singular position so far ahead of the state x, if there is one and the motion leads across. */
static int goes_across(lag_singular *s, double t, const double *x, double distance, double limit, double *length)
{
    const size_t n = s->run->motion.model->nq;
    if (t >= limit || !(distance > 0.0)) {
        return 0;
    }
    memcpy(s->end, x, s->run->stepper.ode->size * sizeof(double));
    for (size_t j = 0; j < n; ++j) {
        s->end[j] += distance * x[n + j];
    }
    const double height = lag_branch_point_height(&s->saddle, s->general, t + distance, s->end); /* a first look, much cheaper than a fit */
    if (height > MEETING && height < (double)INFINITY) {
        return 0;
    }
    return lag_fit_across(s, t, x, distance, limit, length) && lag_singular_margin(s, t + *length, s->end, s->now) > LOST;
}

/* True if branches can still be distinguished. If no branches meet, rates grow without bound, which the step control detects. */
static int decided(lag_singular *s, double margin, double t, const double *x, double step)
{
    const lag_stepper *stepper = &s->run->stepper;
    if (margin > UNDECIDED && !(step < stepper->h_least)) {
        return 1;
    }
    return margin > LOST && !(lag_branch_point_height(&s->saddle, s->general, t, x) < (double)INFINITY);
}

void lag_singular_begin(lag_singular *s, int attention)
{
    const lag_stepper *stepper = &s->run->stepper;
    s->distance = 0.0;
    s->margin = (double)INFINITY;
    const double margin = attention ? lag_singular_margin(s, stepper->t, stepper->x, s->now) : (double)INFINITY;
    s->leave = margin <= LOST ? 1 : margin <= BESIDE ? 2 : 0;
}

lag_status lag_singular_ahead(lag_singular *s, double limit, int *done)
{
    const lag_stepper *stepper = &s->run->stepper;
    double length = 0.0;
    const double distance = s->distance;
    const double margin = s->margin;
    const int leave = s->leave;
    s->leave = 0;
    s->distance = 0.0;
    s->margin = (double)INFINITY;
    *done = leave ? (leave == 1 && lag_fit_out(s, stepper->t, stepper->x, limit, &length)) ||
                        lag_fit_beside(s, stepper->t, stepper->x, &length)
                  : goes_across(s, stepper->t, stepper->x, distance, limit, &length);
    if (*done) {
        return take(s, stepper->t, stepper->x, length, limit);
    }
    return decided(s, margin, stepper->t, stepper->x, (double)INFINITY) ? LAG_OK : LAG_BRANCH_POINT;
}

lag_status lag_singular_after(lag_singular *s, double limit, double *shorter)
{
    lag_run *run = s->run;
    lag_stepper *stepper = &run->stepper;
    const double t = stepper->t_before;
    const double step = stepper->t - t;
    double length = 0.0;
    int moved = 0;
    const double before = lag_singular_margin(s, t, stepper->x_before, s->before);
    s->seen = 0;
    *shorter = SHORTER * step;
    const double behind = lag_singular_margin(s, stepper->t, stepper->x, s->now);
    if (fmin(before, behind) < NEAR) { /* branches are told apart by the constraints alone where rank is nearly lost */
        if (lag_projection_exact(&run->projection, stepper->t, stepper->x, &moved) != LAG_OK) {
            return *shorter < stepper->h_least ? LAG_PROJECTION_FAILED : LAG_ATTENTION;
        }
        if (moved && lag_stepper_correct(stepper) != LAG_OK) {
            return LAG_ATTENTION;
        }
    }
    const double lost = lost_at(s);
    if (lost < (double)INFINITY) {
        memcpy(run->point, stepper->x_before, stepper->ode->size * sizeof(double));
        if (goes_across(s, t, run->point, lost - t, limit, &length)) {
            return take(s, t, run->point, length, limit);
        }
        return decided(s, before, t, run->point, *shorter) ? LAG_ATTENTION : LAG_BRANCH_POINT;
    }
    const double now = lag_singular_margin(s, stepper->t, stepper->x, s->now);
    s->distance = now < fmin(NEAR, before) && before < (double)INFINITY ? now * step / (before - now) : 0.0;
    s->margin = now;
    return LAG_OK;
}
