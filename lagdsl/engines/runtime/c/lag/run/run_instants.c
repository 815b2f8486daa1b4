/* Events of a run, with a report of the state before and after each. */
#include <math.h>
#include <string.h>

#include "lag/linalg/arena.h"
#include "lag/linalg/vector.h"
#include "lag/run.h"

/* A motion by less than this part of the largest rates is slow. */
static const double SLOW = 1e-3;

static int has_instants(const lag_run *run)
{
    return run->motion.model->event != NULL;
}

static lag_status report(lag_run *run, lag_event_kind what)
{
    return lag_instants_report(&run->instants, run->stepper.t, run->stepper.x, what, 0);
}

/* True if relation i turns again, slowly, though since it turned it has been no farther from zero than the motion is known. */
static int is_doubtful(const lag_run *run, size_t i)
{
    const lag_guards *guards = &run->guards;
    const double rate = guards->noise->value[run->motion.model->nindicator + run->motion.model->ncorner + i];
    const double known = lag_guards_known(guards, i);
    return guards->swing[i] <= known && SLOW * run->instants.contacts.length * fabs(rate) <= known;
}

/* Notes relations that may turn by the method's error. */
static void note_doubtful(lag_run *run, const double *changed)
{
    lag_guards *guards = &run->guards;
    const lag_stepper *s = &run->stepper;
    const size_t count = run->motion.model->nindicator;
    const int known = lag_any(count, changed) && lag_noise_update(guards->noise, s->t, s->x) == LAG_OK; /* rounding errors are: it was located */
    for (size_t i = 0; i < count; ++i) {
        guards->doubted[i] = known && changed[i] != 0.0 && is_doubtful(run, i) ? fmin(guards->doubted[i], s->t) : guards->doubted[i];
    }
}

/* An event begins; flags of the relations that it changes, or null. */
static lag_status begin(lag_run *run, const double *changed)
{
    ++run->counts.events;
    run->motion.delays.pieces.level = 0;
    if (changed != NULL) {
        note_doubtful(run, changed);
    }
    return report(run, LAG_BEFORE);
}

/* An event that came to a good end is told. */
static lag_status end(lag_run *run, lag_status status)
{
    if (status != LAG_OK && status != LAG_STOPPED) {
        return status;
    }
    const lag_status told = report(run, LAG_AFTER);
    return told == LAG_OK ? status : told;
}

/* The same for one that has turned the relations: as they lie now, they have not changed. */
static lag_status end_with_relations(lag_run *run, lag_status status)
{
    const double *before = run->instants.instant.stood + run->motion.places.relation;
    const double *truth = run->motion.w + run->motion.places.relation;
    const lag_status ended = end(run, status);
    if (ended != LAG_OK && ended != LAG_STOPPED) {
        return ended;
    }
    for (size_t i = 0; i < run->motion.model->nindicator; ++i) {
        run->guards.swing[i] = truth[i] != before[i] ? 0.0 : run->guards.swing[i];
    }
    lag_noise_hold(run->guards.noise, &run->projection, run->stepper.t, run->stepper.x, run->point, run->guards.held);
    const lag_status seen = lag_guards_begin(&run->guards, run->stepper.t, run->stepper.x);
    return seen == LAG_OK ? ended : seen;
}

static lag_status enter(lag_run *run)
{
    lag_delays_clear(&run->motion.delays);
    const lag_status status = has_instants(run) ? lag_instants_begin(&run->instants, run->stepper.t, run->stepper.x) : LAG_OK;
    if (status == LAG_OK) {
        lag_noise_hold(run->guards.noise, &run->projection, run->stepper.t, run->stepper.x, run->point, run->guards.held);
    }
    if ((status == LAG_OK || status == LAG_STOPPED) && run->motion.model->ndelay > 0) {
        lag_motion_set_state(&run->motion, run->stepper.t, run->stepper.x);
        const lag_status begun = lag_delays_begin(&run->motion.delays, run->stepper.t);
        return begun == LAG_OK ? status : begun;
    }
    return status;
}

/* Of the relations that have changed at the end of a row of inputs, those that turn by the inputs from then on. */
static lag_status keep_turning(lag_run *run, double *changed)
{
    const double until = run->motion.until;
    if (run->stepper.t < until || !lag_any(run->motion.model->nindicator, changed)) {
        return LAG_OK;
    }
    run->motion.until = (double)INFINITY;
    const lag_status status = lag_instants_find_turning(&run->instants, run->stepper.t, run->stepper.x, changed);
    run->motion.until = until;
    return status;
}

static lag_status carry_out(lag_run *run, double h, const double *changed, int ticks)
{
    const lag_model *model = run->motion.model;
    const size_t count = lag_guard_count(model);
    double *x = run->stepper.x;
    lag_instants_after(&run->instants, run->stepper.t, h);
    memmove(run->guards.changed, changed, count * sizeof(double));
    const int any = lag_any(count, changed); /* without, other things than relations and contacts have changed */
    lag_status status = keep_turning(run, run->guards.changed);
    if (status == LAG_OK && !ticks && any && !lag_any(count, run->guards.changed)) {
        return LAG_OK;
    }
    status = status == LAG_OK ? begin(run, run->guards.changed) : status;
    if (status == LAG_OK) {
        status = end_with_relations(run, lag_instants_carry_out(&run->instants, run->stepper.t, x, run->guards.changed, 1, ticks));
    }
    return status;
}

int lag_run_due(const lag_run *run, double t)
{
    return has_instants(run) && lag_instants_due(&run->instants, t);
}

/* *any: forces or inputs that have jumped turn relations, flagged in `changed`, or pull at closed contacts, just behind the present. */
static lag_status find_turned(lag_run *run, int *any)
{
    const lag_model *model = run->motion.model;
    const lag_stepper *s = &run->stepper;
    lag_guards *guards = &run->guards;
    double *contacts = guards->changed + model->nindicator;
    lag_status status = lag_guard_count(model) > 0 ? lag_guards_detect(guards, lag_timed_behind(&run->instants.timed, s->t), s->x) : LAG_OK;
    for (size_t i = 0; i < model->ncontact; ++i) { /* gaps of open contacts do not jump */
        contacts[i] *= run->motion.w[guards->motion->places.contact + i];
    }
    *any = status == LAG_EVENT_PENDING && lag_any(lag_guard_count(model), guards->changed);
    lag_fill(model->ncontact + model->nfriction, 0.0, contacts); /* these follow */
    return status == LAG_EVENT_PENDING ? LAG_OK : status;
}

static lag_status tick(lag_run *run)
{
    lag_stepper *s = &run->stepper;
    int quiet = 0;
    int turned = 0;
    if (!lag_run_due(run, s->t)) {
        return LAG_OK;
    }
    if (run->half.left > 0.0 && run->half.t == s->t) {
        const double h = run->half.left;
        run->half.left = 0.0;
        return carry_out(run, h, run->half.waiting, 1);
    }
    lag_status status = lag_instants_change_unreported(&run->instants, s->t, s->x, &quiet);
    if (status == LAG_OK && quiet) {
        status = find_turned(run, &turned);
    }
    if (status != LAG_OK) {
        return status;
    }
    if (quiet && !turned) {
        return lag_timed_find_next(&run->instants.timed, s->t);
    }
    if (turned) {
        lag_instants_take_back(&run->instants, s->x);
    }
    status = begin(run, NULL);
    lag_fill(lag_guard_count(run->motion.model), 0.0, run->guards.changed);
    return status == LAG_OK ? end_with_relations(run, lag_instants_carry_out(&run->instants, s->t, s->x, run->guards.changed, 0, 1)) : status;
}

/*
 * Inputs that jump now and prescribe a speed: rates follow the momenta with the inputs before, contacts open or strike; 1 in *blown then. It
 * is tried first, as the row before is told with the rates before.
 */
static lag_status apply_input_jump(lag_run *run, int *blown)
{
    lag_motion *motion = &run->motion;
    lag_stepper *s = &run->stepper;
    const size_t n = motion->model->nq;
    const size_t size = lag_motion_size(motion->model);
    if (motion->inputs == NULL) {
        return LAG_OK;
    }
    motion->inputs(motion->context, s->t, 1, run->u_before);
    motion->inputs(motion->context, s->t, 0, motion->u);
    if (lag_same(motion->model->nu, run->u_before, motion->u)) {
        return LAG_OK;
    }
    memcpy(run->point, s->x, size * sizeof(double));
    lag_status status = lag_instants_prescribe(&run->instants, s->t, s->x, run->u_before, 0);
    *blown = !lag_same(n, run->point + n, s->x + n);
    if (status != LAG_OK || !*blown) {
        return status;
    }
    memcpy(s->x, run->point, size * sizeof(double));
    motion->until = s->t;
    status = begin(run, NULL);
    motion->until = (double)INFINITY;
    return status == LAG_OK ? end(run, lag_instants_prescribe(&run->instants, s->t, s->x, run->u_before, 1)) : status;
}

/* All that changes by the inputs of now, and with it what time changes at the same instant, which may turn it back. */
static lag_status follow_inputs(lag_run *run, int blown, int *any)
{
    const lag_model *model = run->motion.model;
    lag_stepper *s = &run->stepper;
    lag_status status = find_turned(run, any);
    status = status == LAG_OK && !*any ? lag_instants_conditions(&run->instants, s->t, s->x, any) : status;
    if (!*any || status != LAG_OK) {
        return status;
    }
    memcpy(run->half.pending, run->guards.changed, lag_guard_count(model) * sizeof(double));
    const int due = lag_timed_due(&run->instants.timed, s->t);
    for (size_t i = 0; i < model->nindicator && due && run->half.left > 0.0 && run->half.t == s->t; ++i) { /* these wait for it */
        run->half.pending[i] = fmax(run->half.pending[i], run->half.waiting[i]);
    }
    run->half.left = due ? 0.0 : run->half.left;
    run->motion.until = blown ? (double)INFINITY : s->t; /* the row before has the inputs before */
    status = begin(run, run->half.pending);
    run->motion.until = (double)INFINITY;
    return status == LAG_OK ? end_with_relations(run, lag_instants_carry_out(&run->instants, s->t, s->x, run->half.pending, 0, due)) : status;
}

static lag_status jump(lag_run *run)
{
    int blown = 0;
    int any = 0;
    run->motion.delays.pieces.level = 0;
    run->motion.until = (double)INFINITY;
    lag_status status = apply_input_jump(run, &blown);
    if (status == LAG_OK && has_instants(run)) {
        status = follow_inputs(run, blown, &any);
    }
    return status == LAG_OK && (blown || any) ? lag_run_watch(run, run->stepper.t, run->stepper.x, NULL) : status;
}

lag_status lag_run_carry(lag_run *run, const lag_cause *cause)
{
    if (cause->kind == LAG_CAUSE_START) {
        return enter(run);
    }
    if (cause->kind == LAG_CAUSE_INPUTS) {
        return jump(run);
    }
    if (cause->kind != LAG_CAUSE_END) {
        return cause->changed != NULL ? carry_out(run, cause->h, cause->changed, cause->kind == LAG_CAUSE_TIME) : tick(run);
    }
    const int ends = has_instants(run) && run->motion.places.terminal < run->motion.model->nw;
    return ends ? end(run, lag_instants_end(&run->instants, run->stepper.t, run->stepper.x)) : LAG_OK;
}

lag_status lag_run_back(lag_run *run, double t)
{
    lag_stepper *s = &run->stepper;
    int moved = 0;
    lag_status status = lag_run_rows(run, t, 0);
    if (status == LAG_OK) {
        status = lag_run_keep_past(run, t);
    }
    if (status == LAG_OK) {
        status = lag_stepper_dense(s, t, run->point);
    }
    if (status == LAG_OK) {
        (void)lag_projection_exact(&run->projection, t, run->point, &moved); /* where it cannot, it is as the method found it */
        memcpy(s->x, run->point, s->ode->size * sizeof(double));
        status = lag_run_companion(run) != NULL ? lag_run_companion(run)->back(run, t) : LAG_OK;
        s->t = t;
    }
    return status;
}
