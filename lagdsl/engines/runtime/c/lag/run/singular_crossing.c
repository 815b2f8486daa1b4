/* Singular positions along the motion: the rank is estimated, steps lead up to them, and the motion across is fitted (lag/run/collocation.c). */
#include "lag/run/singular_crossing.h"

#include <math.h>
#include <string.h>

#include "lag/equations/entries.h"
#include "lag/linalg/arena.h"
#include "lag/linalg/finite.h"
#include "lag/linalg/svd.h"
#include "lag/linalg/vector.h"
#include "lag/run.h"

enum { NODES = LAG_COLLOCATION_NODES, HALVINGS = 7 };

/* Margins of the rank: where it counts as lost, where that seems near, and where branches are not told apart any more. */
static const double LOST = 1e-7, NEAR = 0.05, UNDECIDED = 1e-5;
/* A motion that begins below this margin is fitted, and a row has the accelerations of a fitted motion, as those of the state magnify its errors. */
static const double BESIDE = 1e-3;
/* Round-off of a projection exceeds the error of a fitted motion below this, and may lead to another branch. */
static const double BLURRED = 1e-6;
/* A step in which rank was lost is tried again with this part of its length. */
static const double SHORTER = 0.25;
/* A combination of rows that vanishes prescribes no rate if its own is below this part of the largest of all rows. */
static const double LEVEL = 1e-3;
/* A multiplier that has a limit differs, extrapolated with and without a node, by less than this part of its size; round-off passes. */
static const double LIMIT = 1e-3, SMALL = 1e-6;

size_t lag_singular_memory(const lag_model *model)
{
    const size_t m = model->nc;
    return m * model->nq + 2 * m + NODES * (2 * (model->nq + model->nz) + m) + 3 * lag_motion_size(model) + lag_svd_memory(model->nq, m);
}

void lag_singular_place(lag_singular *s, lag_run *run, double *memory)
{
    const lag_model *model = run->motion.model;
    const size_t entries = model->nc * model->nq, width = model->nq + model->nz, size = lag_motion_size(model);
    double **const arrays[] = {&s->rows, &s->phi, &s->drift, &s->values, &s->coefficients, &s->multipliers, &s->state, &s->rates, &s->largest};
    const size_t sizes[] = {entries, model->nc, model->nc, NODES * width, NODES * width, NODES * model->nc, size, size, size};
    *s = (lag_singular){.run = run, .distance = -1.0, .margin = (double)INFINITY};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; ++i) {
        *arrays[i] = lag_take(&memory, sizes[i]);
    }
    s->memory = memory;
}

/* ---- looks ---- */

/* J as it was evaluated last. */
static const double *jacobian_of(const lag_singular *s)
{
    return s->run->motion.written.rows[1];
}

static int jacobian_at(lag_singular *s, double t, const double *x)
{
    lag_motion *motion = &s->run->motion;
    lag_motion_set_state(motion, t, x);
    return lag_projection_evaluate(&s->run->projection, 1) == LAG_OK && lag_entries_finite(motion->model, jacobian_of(s));
}

double lag_singular_margin(lag_singular *s, double t, const double *x)
{
    return jacobian_at(s, t, x) ? lag_rank_estimate_margin(&s->run->ranks.estimate, jacobian_of(s)) : 0.0;
}

int lag_run_row_counts(const lag_run *run, size_t row)
{
    const unsigned char *redundant = run->motion.model->redundant;
    return !(redundant != NULL && redundant[row]) && run->ranks.lasting[row] != 0.0;
}

size_t lag_singular_rows(lag_singular *s, double t, const double *x)
{
    lag_run *run = s->run;
    const lag_model *model = run->motion.model;
    double *phi = run->projection.phi;
    size_t count = 0;
    int known = jacobian_at(s, t, x);
    for (size_t i = 0; i < model->nc; ++i) {
        if (lag_run_row_counts(run, i)) {
            s->drift[count++] = phi[i] / run->sizes.rows[i];
        }
    }
    known = known && lag_projection_evaluate(&run->projection, 0) == LAG_OK;
    for (size_t i = 0, column = 0; i < model->nc && known; ++i) {
        if (lag_run_row_counts(run, i)) {
            for (size_t j = 0; j < model->nq; ++j) {
                s->rows[j * count + column] = jacobian_of(s)[i * model->nq + j] * run->sizes.natural[j] / run->sizes.rows[i];
            }
            s->phi[column++] = model->position_level[i] ? phi[i] / run->sizes.rows[i] : 0.0;
        }
    }
    return known ? count : 0;
}

size_t lag_singular_rank(lag_singular *s, double t, const double *x, size_t *general, size_t *weakest)
{
    const size_t rows = *general = lag_singular_rows(s, t, x);
    const lag_svd svd = lag_svd_of(s->run->motion.model->nq, rows, s->rows, s->memory);
    double most = -1.0;
    size_t rank = 0;
    for (size_t i = 0, row = 0; row < rows; ++i) {
        if (lag_run_row_counts(s->run, i)) {
            const double share = fabs(svd.v[(rows - 1) * rows + row++]);
            *weakest = share > most ? i : *weakest;
            most = fmax(most, share);
        }
    }
    while (rank < svd.k && svd.value[rank] > LOST) {
        ++rank;
    }
    return rank;
}

/* True if rank is lost and nothing drives the rates beyond all bounds there, which steps notice by themselves. */
static int is_undetermined(lag_singular *s, double margin, double t, const double *x)
{
    const size_t n = s->run->motion.model->nq;
    double most = 0.0;
    memcpy(s->state, x, s->run->stepper.ode->size * sizeof(double));
    lag_fill(n, 0.0, s->state + n);
    const size_t rows = lag_singular_rows(s, t, s->state);
    const lag_svd svd = lag_svd_of(n, rows, s->rows, s->memory);
    for (size_t i = 0; i < rows; ++i) {
        most = fmax(most, fabs(s->drift[i]));
    }
    return margin <= LOST || (rows > 0 && fabs(lag_dot(rows, svd.v + (rows - 1) * rows, s->drift)) <= LEVEL * most);
}

/* The time in the last step at which rank was lost, about; infinite where J turns steadily. */
static double lost_at(lag_singular *s)
{
    lag_stepper *stepper = &s->run->stepper;
    const double step = stepper->t - stepper->t_before;
    double first = stepper->t_before;
    double part = 1.0;
    while (first < stepper->t) {
        const double last = fmin(first + part * step, stepper->t);
        memcpy(s->state, stepper->x, stepper->ode->size * sizeof(double));
        const int known = last == stepper->t || lag_stepper_dense(stepper, last, s->state) == LAG_OK;
        if (known && jacobian_at(s, last, s->state) && !lag_rank_estimate_has_turned(&s->run->ranks.estimate, jacobian_of(s))) {
            (void)lag_rank_estimate_update(&s->run->ranks.estimate, jacobian_of(s));
            first = last;
        } else if (part > ldexp(1.0, -HALVINGS)) {
            part *= 0.5;
        } else {
            return 0.5 * (first + last);
        }
    }
    return (double)INFINITY;
}

/* ---- the way on ---- */

void lag_singular_project(lag_singular *s, double t, double *x)
{
    int moved = 0;
    if (lag_singular_margin(s, t, x) > BLURRED) {
        (void)lag_projection_exact(&s->run->projection, t, x, &moved); /* where it cannot, it is as it was fitted */
    }
}

/* The fitted motion, up to `limit`, stands as the last step. */
static lag_status take(lag_singular *s, double length, double limit)
{
    lag_run *run = s->run;
    lag_stepper *stepper = &run->stepper;
    const size_t n = run->motion.model->nq;
    const size_t size = stepper->ode->size;
    run->ranks.behind = stepper->method;
    run->ranks.estimate.rank = 0;
    stepper->method = &lag_collocation;
    stepper->work[0] = (double)n;
    stepper->work[1] = length;
    memcpy(stepper->work + 2, s->coefficients, NODES * (size - n) * sizeof(double));
    memcpy(stepper->f_before, stepper->f, size * sizeof(double));
    memcpy(stepper->x_before, stepper->x, size * sizeof(double));
    stepper->t_before = stepper->t;
    stepper->t = fmin(stepper->t + length, limit);
    lag_collocation.dense(stepper, stepper->t, stepper->x);
    lag_singular_project(s, stepper->t, stepper->x);
    stepper->h = 0.0;
    stepper->last = (lag_last_step){0.0, 0.0, 0.0, 1};
    ++stepper->counts.steps;
    return lag_stepper_correct(stepper);
}

void lag_singular_begin(lag_singular *s, int attention)
{
    const lag_stepper *stepper = &s->run->stepper;
    s->margin = (double)INFINITY;
    s->distance = attention && lag_singular_margin(s, stepper->t, stepper->x) <= BESIDE ? 0.0 : -1.0;
}

lag_status lag_singular_ahead(lag_singular *s, double limit, int *done)
{
    const lag_stepper *stepper = &s->run->stepper;
    const double margin = s->margin;
    const double length = s->distance >= 0.0 ? lag_collocation_fit(s, stepper->t, stepper->x, s->distance) : 0.0;
    *done = length > 0.0;
    s->distance = -1.0;
    s->margin = (double)INFINITY;
    if (*done) {
        return take(s, length, limit);
    }
    return margin <= UNDECIDED && is_undetermined(s, margin, stepper->t, stepper->x) ? LAG_BRANCH_POINT : LAG_OK;
}

lag_status lag_singular_after(lag_singular *s, double *shorter)
{
    lag_run *run = s->run;
    lag_stepper *stepper = &run->stepper;
    const double step = stepper->t - stepper->t_before;
    const double behind = lag_singular_margin(s, stepper->t, stepper->x);
    const double before = lag_singular_margin(s, stepper->t_before, stepper->x_before);
    int moved = 0;
    run->ranks.estimate.rank = 0;
    (void)lag_rank_estimate_update(&run->ranks.estimate, jacobian_of(s)); /* of the state before */
    *shorter = SHORTER * step;
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
        s->distance = lost - stepper->t_before;
        s->margin = before;
        const int last = *shorter < stepper->h_least;
        return last && is_undetermined(s, before, stepper->t_before, stepper->x_before) ? LAG_BRANCH_POINT : LAG_ATTENTION;
    }
    s->margin = lag_singular_margin(s, stepper->t, stepper->x);
    s->distance = s->margin < fmin(NEAR, before) ? s->margin * step / (before - s->margin) : -1.0;
    return LAG_OK;
}

/* ---- rows ---- */

/* Multipliers into motion.lam at a part of the motion from `start` at time t, from both sides or one; without a limit they are no numbers. */
static void find_limits(lag_singular *s, const double *coefficients, double t, const double *start, double length, double part)
{
    lag_motion *motion = &s->run->motion;
    const size_t m = motion->model->nc;
    double largest = 0.0;
    int moved = 0;
    int known = 1;
    for (size_t i = 0; i < NODES && known; ++i) {
        const double time = t + length * lag_collocation_node(i);
        lag_collocation_state(motion->model, coefficients, start, length, lag_collocation_node(i), s->state);
        known = lag_projection_exact(&s->run->projection, time, s->state, &moved) == LAG_OK && lag_motion_solve(motion, time, s->state) == LAG_OK;
        memcpy(s->multipliers + i * m, motion->lam, m * sizeof(double));
    }
    for (size_t i = 0; i < NODES * m; ++i) {
        largest = fmax(largest, fabs(s->multipliers[i]));
    }
    for (size_t row = 0; row < m; ++row) {
        double at_nodes[NODES], all[NODES], fewer[NODES];
        double size = SMALL * largest;
        for (size_t i = 0; i < NODES; ++i) {
            at_nodes[i] = s->multipliers[i * m + row];
            size = fmax(size, fabs(at_nodes[i]));
        }
        lag_collocation_interpolate(0, 1, at_nodes, all);
        lag_collocation_interpolate(1, 1, at_nodes, fewer);
        const double found = lag_collocation_value(1, all, part);
        const double off = fabs(found - lag_collocation_value(1, fewer, part));
        motion->lam[row] = known && off <= LIMIT * size ? found : (double)NAN;
    }
}

void lag_singular_row(lag_singular *s, double t, const double *x, int after_event)
{
    const lag_stepper *stepper = &s->run->stepper;
    lag_motion *motion = &s->run->motion;
    const size_t n = motion->model->nq;
    const size_t m = motion->model->nc;
    const double margin = lag_singular_margin(s, t, x);
    const int inside = !after_event && stepper->method == &lag_collocation && t >= stepper->t_before && t <= stepper->t;
    const double *coefficients = inside ? stepper->work + 2 : s->coefficients;
    const double length = margin > BESIDE ? 0.0 : inside ? stepper->work[1] : lag_collocation_fit(s, t, x, 0.0);
    const double part = inside && length > 0.0 ? (t - stepper->t_before) / length : 0.0;
    if (length > 0.0) {
        find_limits(s, coefficients, t - part * length, inside ? stepper->x_before : x, length, part);
        memcpy(s->multipliers, motion->lam, m * sizeof(double));
    }
    lag_motion_try(motion, t, x);
    for (size_t j = 0; j < n && length > 0.0; ++j) {
        motion->qdd[j] = lag_collocation_value(n + motion->model->nz, coefficients + j, part);
    }
    for (size_t i = 0; i < m && length > 0.0; ++i) {
        motion->lam[i] = margin > LOST && isnan(s->multipliers[i]) ? motion->lam[i] : s->multipliers[i]; /* large, not without end */
    }
}
