/* The cause of the end of a run, from the state at which it failed. */
#include <math.h>
#include <string.h>

#include "lag/evaluate.h"
#include "lag/linalg/arena.h"
#include "lag/run.h"

void lag_run_lose(lag_run *run, double t, const double *x)
{
    run->lost.t = t;
    memmove(run->lost.x, x, run->stepper.ode->size * sizeof(double));
}

lag_status lag_run_evaluate(lag_run *run, int which, double t, const double *x, double *results)
{
    lag_motion *motion = &run->motion;
    if (which == LAG_OUTPUT) {
        lag_run_solve(run, t, x, t <= run->counts.entered);
    } else {
        lag_motion_try(motion, t, x);
    }
    return lag_evaluate(motion->model, (lag_function)which, &motion->at, results);
}

size_t lag_run_rank(lag_run *run, size_t *general, size_t *weakest)
{
    size_t rows = 0;
    for (size_t i = 0; i < run->motion.model->nc && lag_run_crosses(run->motion.model, &run->options); ++i) {
        rows += (size_t)lag_run_row_counts(run, i);
    }
    *general = rows;
    *weakest = 0;
    const int clear = rows <= run->ranks.estimate.most && lag_singular_margin(&run->ranks.singular, run->stepper.t, run->stepper.x) > LAG_RANK_NEAR;
    /* Singular values of many rows cost the cube of their number. */
    return rows == 0 || clear ? rows : lag_singular_rank(&run->ranks.singular, run->stepper.t, run->stepper.x, general, weakest);
}

/* The place of the largest; what is no number is larger than all others. */
static size_t worst(size_t count, const double *x)
{
    size_t which = 0;
    for (size_t i = 1; i < count; ++i) {
        if (!(x[i] <= x[which]) && !isnan(x[which])) {
            which = i;
        }
    }
    return which;
}

/* Rates at the state of the fault, into run->stepper.f; what does not exist is no number. */
static void find_rates(lag_run *run, const lag_fault *fault)
{
    lag_motion *motion = &run->motion;
    const lag_model *model = motion->model;
    const size_t n = model->nq;
    double *rates = run->stepper.f;
    const lag_status status = lag_motion_solve(motion, fault->t, fault->x);
    memcpy(rates, fault->x + n, n * sizeof(double));
    for (size_t i = 0; i < n; ++i) {
        rates[n + i] = status == LAG_SINGULAR ? (double)NAN : motion->qdd[i];
    }
    if (model->nz > 0) {
        (void)model->state_derivative(&motion->at, rates + 2 * n);
    }
}

static void explain_not_finite(lag_run *run, lag_fault *fault)
{
    const size_t size = run->stepper.ode->size;
    find_rates(run, fault);
    while (fault->which + 1 < size && isfinite(run->stepper.f[fault->which])) {
        ++fault->which;
    }
}

static void explain_stuck(lag_run *run, lag_fault *fault)
{
    lag_stepper *s = &run->stepper;
    find_rates(run, fault);
    for (size_t i = 0; i < s->ode->size; ++i) {
        s->f[i] = fabs(s->f[i]) / s->tolerance[i];
    }
    fault->which = worst(s->ode->size, s->f);
}

/* Of the rows of position level, or of those that discretes switch, the one that is farthest off; a row on rates that was lost. */
static void explain_off(lag_run *run, int switched, lag_fault *fault)
{
    const lag_model *model = run->motion.model;
    if (!switched && run->projection.lost < model->nc) {
        fault->which = run->projection.lost;
        fault->value = fabs(run->projection.phi[fault->which]);
        return;
    }
    const size_t count = switched ? model->nswitched : model->nc;
    double most = -1.0;
    for (size_t k = 0; k < count; ++k) {
        const size_t row = switched ? model->switched_rows[k] : k;
        const double distance =
            model->position_level[row] ? lag_projection_distance(&run->projection, fault->t, fault->x, row) : 0.0;
        if (distance > most || (isnan(distance) && !isnan(most))) {
            most = distance;
            fault->which = row;
            fault->value = fabs(run->projection.phi[row]);
        }
    }
}

static void explain_violated(lag_run *run, lag_fault *fault)
{
    const lag_model *model = run->motion.model;
    lag_conditions *watch = &run->conditions;
    fault->which = model->na + model->ni;
    for (size_t i = model->ni; i-- > 0;) {
        const double drift = fabs(watch->value[i] - watch->start[i]);
        const double limit = watch->tolerance[i] * fmax(watch->size[i], fmax(fabs(watch->start[i]), watch->scale[i]));
        if (!(drift <= limit)) {
            fault->which = model->na + i;
            fault->value = drift;
            fault->limit = limit;
        }
    }
    for (size_t i = model->na; i-- > 0;) {
        fault->which = watch->held[i] == 0.0 ? i : fault->which;
    }
}

/* The first entry that an event could not settle; of a place that jumped, the first reset that has given a state in it another value. */
static void explain_entries(lag_run *run, int placed, lag_fault *fault)
{
    const lag_model *model = run->motion.model;
    const size_t entry = lag_first(model->nw, run->instants.discretes.guilty);
    fault->which = entry < model->nw ? entry : model->nw + model->nreset;
    for (size_t i = placed ? model->nreset : 0; i-- > 0;) {
        const size_t place = model->reset_places[i];
        const int displaces = place >= 2 * model->nq && fault->x[place] != run->instants.instant.from[place];
        fault->which = displaces ? model->nw + i : fault->which;
    }
}

/* Moves the fault to the state at which the accelerations failed. */
static void use_failed_state(const lag_run *run, lag_fault *fault)
{
    const lag_stepper *s = &run->stepper;
    if (s->trouble.status != LAG_OK && s->trouble.time >= s->t) {
        fault->t = s->trouble.time;
        fault->x = s->trouble.x;
    }
}

void lag_run_explain(lag_run *run, lag_status status, lag_fault *fault)
{
    const lag_stepper *s = &run->stepper;
    *fault = (lag_fault){.t = s->t, .x = s->x};
    if ((status == LAG_PROJECTION_FAILED || status == LAG_VIOLATED) && run->lost.t < (double)INFINITY) {
        fault->t = run->lost.t;
        fault->x = run->lost.x;
    }
    switch (status) {
    case LAG_SINGULAR:
        fault->which = run->motion.coordinate;
        use_failed_state(run, fault);
        break;
    case LAG_MOMENTUM_UNREACHABLE:
        fault->which = run->motion.coordinate;
        break;
    case LAG_NOT_FINITE:
        use_failed_state(run, fault);
        explain_not_finite(run, fault);
        break;
    case LAG_STEP_TOO_SMALL:
        explain_stuck(run, fault);
        break;
    case LAG_PROJECTION_FAILED:
    case LAG_POSITION_JUMP:
        explain_off(run, status == LAG_POSITION_JUMP, fault);
        break;
    case LAG_BRANCH_POINT:
        (void)lag_singular_rank(&run->ranks.singular, run->stepper.t, run->stepper.x, &(size_t){0}, &fault->which);
        break;
    case LAG_VIOLATED:
        explain_violated(run, fault);
        break;
    case LAG_EVENT_ITERATION_FAILED:
    case LAG_CHATTER:
    case LAG_PENETRATION:
    case LAG_WAY_JUMP:
        explain_entries(run, status == LAG_WAY_JUMP, fault);
        break;
    case LAG_CONFLICT:
    case LAG_ASSERTION_FAILED:
        fault->which = run->instants.clauses.fault;
        break;
    default:
        break;
    }
}
