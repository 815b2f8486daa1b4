#include "lag/run.h"

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

#include "lag/fixed.h"
#include "lag/initial.h"
#include "lag/memory.h"

static const double TOLERANCE = 1e-8;
static const double PART = 1e-3;
/* Steps are at least so many units in the last place of time. */
static const double ULPS = 16.0;
/* A step from which the constraints are out of reach is tried again with this part of its length. */
static const double SHORTER = 0.25;
/* So many steps a run has at least where relations or contacts are looked for. */
static const double LEAST_STEPS = 50.0;

const size_t lag_run_layout[2] = {sizeof(lag_run_options), sizeof(lag_run_report)};

/* Whether it goes across singular positions by itself. */
static int crosses(const lag_model *model, const lag_run_options *options)
{
    return options->careful == 2 && model->nc > 0;
}

size_t lag_run_numbers(const lag_model *model, const lag_run_options *options)
{
    const size_t size = lag_motion_size(model);
    return lag_motion_memory(model) + lag_stepper_memory(size) + lag_projection_memory(model) +
           lag_look_memory(model->nc, model->nq) + lag_alert_memory(model) + lag_instants_memory(model) + lag_watch_memory(model) +
           lag_stiffness_memory(size) + 5 * size + 3 * model->nc + 3 * model->ni + 4 * options->indicators + options->clocks +
           model->nindicator + model->ncontact + 1;
}

/* Doubles of which nothing is remembered. */
static size_t scratch(const lag_model *model, const lag_run_options *options)
{
    const size_t initial = options->start != NULL ? lag_initial_memory(model) : 0;
    return initial + (crosses(model, options) ? lag_singular_memory(model) : 0);
}

static size_t padded(size_t bytes)
{
    return (bytes + 15) / 16 * 16;
}

size_t lag_run_size(const lag_model *model, const lag_run_options *options)
{
    return padded(sizeof(lag_run)) + padded((options->clocks + model->nclock) * sizeof(lag_clock)) +
           (lag_run_numbers(model, options) + scratch(model, options)) * sizeof(double);
}

static void place_watch(lag_run *run, const lag_model *model, double **memory)
{
    const lag_run_options *options = &run->options;
    const size_t ni = model->ni;
    double *own = lag_take(memory, 3 * ni);
    run->watch.motion = &run->motion;
    run->watch.begun = options->continued;
    run->watch.start = options->invariant_start != NULL ? options->invariant_start : own;
    run->watch.size = options->invariant_size != NULL ? options->invariant_size : own + ni;
    run->watch.drift = options->invariant_drift != NULL ? options->invariant_drift : own + 2 * ni;
    run->watch.tolerance = options->invariant_tolerance;
    run->watch.value = lag_take(memory, lag_watch_memory(model));
    run->watch.scale = run->watch.value + ni;
    run->watch.held = run->watch.scale + ni;
}

static lag_status tell(void *context, const lag_happening *happening)
{
    lag_run *run = context;
    lag_happening told = *happening;
    told.row = run->row;
    return run->options.tell != NULL ? run->options.tell(run->options.context, run, &told) : LAG_OK;
}

static void place_instants(lag_run *run, const lag_model *model, double **memory)
{
    const lag_run_options *options = &run->options;
    double *own = lag_take(memory, lag_instants_memory(model));
    lag_instants_place(&run->instants, &run->motion, &run->projection, run->clock + options->clocks, own);
    lag_alert_place(&run->alert, &run->motion, run->instants.contacts.slack, lag_take(memory, lag_alert_memory(model)));
    run->instants.passes.tell = tell;
    run->instants.passes.context = run;
    run->instants.contacts.length = options->length > 0.0 ? options->length
        : options->count > 1                              ? options->times[options->count - 1] - options->times[0]
                                                          : 0.0;
}

void lag_run_depend(lag_run *run, const unsigned char *dependent)
{
    const lag_model *model = run->motion.model;
    const double *lasting = run->options.lasting;
    run->look.most = lasting != NULL ? run->options.general : model->rank;
    for (size_t i = 0; i < model->nc; ++i) {
        const int lasts = lasting == NULL || lasting[i] != 0.0;
        const int lost = dependent != NULL && dependent[i] && !(model->redundant != NULL && model->redundant[i]);
        run->lasting[i] = lasts && !lost;
        run->look.most -= lasts && lost && run->look.most > 0;
    }
    if (crosses(model, &run->options)) {
        lag_singular_count(&run->singular, run->lasting);
    }
}

lag_run *lag_run_place(void *block, const lag_model *model, const lag_run_options *options)
{
    const size_t size = lag_motion_size(model);
    char *bytes = block;
    memset(block, 0, lag_run_size(model, options));
    lag_run *run = block;
    run->options = *options;
    run->clock = (lag_clock *)(void *)(bytes + padded(sizeof(lag_run)));
    double *memory = (double *)(void *)(bytes + padded(sizeof(lag_run)) +
        padded((options->clocks + model->nclock) * sizeof(lag_clock)));
    run->memory = memory;
    run->numbers = lag_run_numbers(model, options);
    run->options.tolerance = options->tolerance > 0.0 ? options->tolerance : TOLERANCE;
    run->options.part = options->part > 0.0 ? options->part : PART;
    run->options.looks = options->looks > 0 ? options->looks : 4;
    lag_motion_place(&run->motion, model, lag_take(&memory, lag_motion_memory(model)));
    run->motion.inputs = options->inputs;
    run->motion.context = options->context;
    lag_stepper_place(&run->stepper, &run->motion.ode, lag_take(&memory, lag_stepper_memory(size)));
    run->stepper.method = options->method != NULL ? options->method : &lag_dop853;
    lag_projection_place(&run->projection, &run->motion, lag_take(&memory, lag_projection_memory(model)));
    run->group = lag_take(&memory, size);
    run->natural = lag_take(&memory, size);
    run->cap = lag_take(&memory, size);
    run->row_sizes = lag_take(&memory, model->nc);
    lag_look_place(&run->look, model, run->natural, run->row_sizes, lag_take(&memory, lag_look_memory(model->nc, model->nq)));
    run->lasting = lag_take(&memory, model->nc);
    run->dependent = (unsigned char *)(void *)lag_take(&memory, model->nc);
    run->look.lasting = run->lasting;
    run->initial = run->memory + run->numbers;
    if (crosses(model, options)) {
        lag_singular_place(&run->singular, run, run->initial + (options->start != NULL ? lag_initial_memory(model) : 0));
    }
    lag_run_depend(run, model->redundant);
    place_instants(run, model, &memory);
    run->accuracy = (lag_accuracy){size, run->group, run->natural, run->cap, lag_take(&memory, size), 0.0};
    run->point = lag_take(&memory, size);
    place_watch(run, model, &memory);
    lag_stiffness_place(&run->stiffness, size, lag_take(&memory, lag_stiffness_memory(size)));
    run->sign = lag_take(&memory, options->indicators);
    run->value = lag_take(&memory, options->indicators);
    run->crossed = lag_take(&memory, options->indicators);
    run->other = lag_take(&memory, options->indicators);
    run->ticked = lag_take(&memory, options->clocks);
    run->pending = lag_take(&memory, model->nindicator + model->ncontact);
    return run;
}

/* Natural sizes, from the options or from the state x. */
static lag_status find_sizes(lag_run *run, double t, const double *x)
{
    const lag_model *model = run->motion.model;
    const lag_run_options *options = &run->options;
    const size_t size = lag_motion_size(model);
    lag_status status = LAG_OK;
    lag_accuracy_groups(model, x, run->group, run->natural, run->cap);
    if (options->group != NULL) {
        memcpy(run->group, options->group, size * sizeof(double));
        memcpy(run->natural, options->natural, size * sizeof(double));
        memcpy(run->cap, options->cap, size * sizeof(double));
    }
    if (model->nc > 0 && options->row_sizes == NULL) {
        lag_motion_look(&run->motion, t, x);
        status = model->velocity_constraint(&run->motion.at, run->projection.phi, run->projection.jacobian);
    }
    for (size_t i = 0; i < model->nc; ++i) {
        double sum = 0.0;
        for (size_t j = 0; j < model->nq; ++j) {
            const double entry = run->projection.jacobian[i * model->nq + j] * run->natural[j];
            sum += entry * entry;
        }
        run->row_sizes[i] = options->row_sizes != NULL ? options->row_sizes[i] : sum > 0.0 ? sqrt(sum) : 1.0;
    }
    memcpy(run->projection.sizes, run->natural, model->nq * sizeof(double));
    lag_projection_limits(&run->projection, options->part * options->tolerance, run->row_sizes);
    run->sized = 1;
    return status;
}

static double least_length(const lag_run *run, double stop)
{
    return ULPS * DBL_EPSILON * fmax(fmax(fabs(run->stepper.t), fabs(stop)), DBL_MIN);
}

/* The method starts (again) at the present state; h is what the stepper proposes. */
static lag_status restart(lag_run *run, const lag_method *method, double span)
{
    lag_stepper *s = &run->stepper;
    if (method == &lag_fitted) {
        method = run->behind;
    }
    run->accuracy.relative = method->factor * run->options.tolerance;
    lag_accuracy_after(&run->accuracy, s->x, s->tolerance);
    return lag_stepper_begin(s, method, span);
}

lag_status lag_run_move(lag_run *run, double t, const double *x, double h)
{
    const lag_model *model = run->motion.model;
    lag_stepper *s = &run->stepper;
    lag_status status = LAG_OK;
    if (run->motion.at.p == NULL) {
        status = lag_motion_parameters(&run->motion, run->options.p != NULL ? run->options.p : model->defaults);
        if (status == LAG_OK) {
            status = lag_motion_start(&run->motion, t, run->point);
        }
        if (run->options.u != NULL) {
            memcpy(run->motion.u, run->options.u, model->nu * sizeof(double));
        }
    }
    memcpy(s->x, x != NULL ? x : run->point, lag_motion_size(model) * sizeof(double));
    s->t = s->t_before = run->event_time = t;
    s->h = h;
    run->half.open = 0;
    run->look.rank = 0;
    return status == LAG_OK && !run->sized ? find_sizes(run, t, s->x) : status;
}

/* From the start values of the model to a state that is one. */
static lag_status find_start(lag_run *run, double t)
{
    lag_initial told = {.dependent = run->dependent};
    int moved = 0;
    if (run->options.start == NULL) {
        return lag_projection_apply(&run->projection, t, run->stepper.x, &moved);
    }
    const lag_status status = lag_initial_find(&run->motion, run->options.start, NULL, t, run->stepper.x, run->initial, &told);
    lag_run_depend(run, run->dependent);
    return status;
}

lag_status lag_run_begin(lag_run *run, double t, const double *x)
{
    lag_stepper *s = &run->stepper;
    int happened = 0;
    lag_status status = lag_run_move(run, t, x, run->options.h_first);
    if (status == LAG_OK && x == NULL) {
        status = find_start(run, t);
    }
    for (size_t i = 0; i < run->options.clocks; ++i) {
        run->clock[i] = lag_clock_of(run->options.first[i], run->options.period[i]);
        lag_clock_seek(&run->clock[i], t);
    }
    while (run->row < run->options.count && run->options.times[run->row] < t) {
        ++run->row;
    }
    run->begun = t;
    if (status == LAG_OK) {
        status = lag_run_enter(run);
    }
    const int stopped = status == LAG_STOPPED;
    status = stopped ? LAG_OK : status;
    if (status == LAG_OK) {
        status = lag_run_signs(run);
    }
    if (status == LAG_OK) {
        status = lag_run_fire(run, 0, &happened);
    }
    if (status == LAG_OK) {
        status = lag_watch_look(&run->watch, t, s->x);
    }
    if (status == LAG_OK) {
        status = lag_run_rows(run, t, 1);
    }
    return status == LAG_OK && stopped ? LAG_STOPPED : status;
}

void lag_run_skip(lag_run *run, size_t row)
{
    run->row = row;
}

void lag_run_tell(const lag_run *run, lag_run_report *report)
{
    const lag_stepper *s = &run->stepper;
    *report = (lag_run_report){
        .t = s->t,
        .h = s->h,
        .trouble_time = s->trouble_time,
        .x = s->x,
        .row = run->row,
        .steps = run->steps,
        .all_steps = s->steps,
        .rejections = s->rejections,
        .evaluations = s->evaluations,
        .jacobians = s->jacobians,
        .decompositions = s->decompositions,
        .projections = run->projection.count,
        .events = run->events,
        .changes = run->changes,
        .w = run->motion.w,
        .changed = run->alert.changed,
        .guilty = run->instants.passes.guilty,
        .slack = run->instants.contacts.slack,
        .fault = run->instants.passes.fault,
        .next = lag_instants_next(&run->instants),
        .change = run->change,
        .implicit = s->method->implicit,
    };
}

/* Back onto the constraints after a step. LAG_OFF: it was too long. */
static lag_status settle(lag_run *run)
{
    lag_stepper *s = &run->stepper;
    int moved = 0;
    lag_status status = lag_projection_apply(&run->projection, s->t, s->x, &moved);
    if (status == LAG_OK && moved) {
        status = lag_stepper_correct(s);
    }
    return status == LAG_OK ? LAG_OK : LAG_OFF;
}

/* The present state is what the next one is compared with. */
static lag_status see(lag_run *run)
{
    run->look.rank = 0;
    lag_motion_look(&run->motion, run->stepper.t, run->stepper.x);
    const lag_status status = run->motion.model->velocity_constraint(&run->motion.at, run->projection.phi, run->projection.jacobian);
    return status == LAG_OK ? lag_look_at(&run->look, run->projection.jacobian) : status;
}

/* Rank after a step that ended on the constraints. LAG_TOO_LONG: it is to be tried with the length *shorter. */
static lag_status look_around(lag_run *run, double limit, double *shorter)
{
    lag_stepper *s = &run->stepper;
    lag_status status = lag_look_at(&run->look, run->projection.jacobian);
    if (status != LAG_ATTENTION || !crosses(run->motion.model, &run->options)) {
        return status;
    }
    status = lag_singular_after(&run->singular, limit, shorter);
    if (status == LAG_ATTENTION && *shorter > s->h_least) {
        lag_stepper_undo(s, *shorter);
        status = LAG_TOO_LONG;
    }
    const lag_status seen = see(run);
    return status == LAG_OK && seen != LAG_ATTENTION ? seen : status;
}

/* What is known of a singular position ahead comes first. */
static lag_status look_ahead(lag_run *run, double limit, int *done)
{
    lag_stepper *s = &run->stepper;
    lag_status status = s->method == &lag_fitted ? restart(run, run->behind, limit - s->t) : LAG_OK;
    if (status == LAG_OK) {
        status = lag_singular_ahead(&run->singular, limit, done);
    }
    if (status == LAG_OK && *done) {
        status = see(run);
        status = status == LAG_ATTENTION ? LAG_OK : status;
    }
    return status;
}

/* One step that ends on the constraints; where that looks dangerous it is taken back. */
static lag_status step_once(lag_run *run, double limit)
{
    lag_stepper *s = &run->stepper;
    for (;;) {
        double shorter = 0.0;
        lag_status status = lag_stepper_step(s, limit);
        if (status != LAG_OK) {
            return status == LAG_STUCK && s->trouble != LAG_OK && s->trouble_time >= s->t ? s->trouble : status;
        }
        const double h = s->t - s->t_before;
        status = settle(run);
        if (status == LAG_OFF && SHORTER * h > s->h_least) {
            lag_stepper_undo(s, SHORTER * h);
            continue;
        }
        if (status == LAG_OK && run->options.careful && run->motion.model->nc > 0) {
            status = look_around(run, limit, &shorter);
        }
        if (status == LAG_TOO_LONG) {
            continue;
        }
        return status;
    }
}

/* The same, with what must stay true. */
static lag_status advance(lag_run *run, double limit)
{
    lag_stepper *s = &run->stepper;
    const double t = s->t;
    int done = 0;
    lag_status status = crosses(run->motion.model, &run->options) ? look_ahead(run, limit, &done) : LAG_OK;
    if (status == LAG_OK && !done) {
        status = step_once(run, limit);
    }
    if (status == LAG_OK) {
        status = lag_watch_look(&run->watch, s->t, s->x);
    }
    if (status != LAG_OK && s->t > t) {
        lag_stepper_undo(s, s->t - s->t_before);
    }
    return status;
}

/* After a step without event: the tolerances follow the motion, the method may change. */
static lag_status follow(lag_run *run, double stop)
{
    lag_stepper *s = &run->stepper;
    if (s->method == &lag_fitted && s->t < stop) {
        return restart(run, run->behind, stop - s->t);
    }
    const lag_method *method = run->options.method == NULL && s->method != &lag_fitted ? lag_stiffness_method(&run->stiffness, s) : s->method;
    if (method == s->method || s->t >= stop) {
        lag_accuracy_after(&run->accuracy, s->x, s->tolerance);
        return LAG_OK;
    }
    if (run->changes < LAG_CHANGES) {
        run->change[run->changes] = (lag_change){s->t, method->implicit};
    }
    ++run->changes;
    return restart(run, method, stop - s->t);
}

/* A step from time t that cannot be made use of is taken back, if there was one. */
static lag_status give_back(lag_run *run, double t, lag_status status)
{
    if (run->stepper.t > t) {
        lag_stepper_undo(&run->stepper, 0.5 * (run->stepper.t - t));
    }
    return status;
}

/* Where in the last step something happens first, the model's at *own, the caller's at *other; infinite: nowhere. */
static lag_status find(lag_run *run, double *own, double *other)
{
    *own = *other = (double)INFINITY;
    lag_status status = lag_run_happening(run, own);
    status = status == LAG_HAPPENS ? LAG_OK : status;
    if (status == LAG_OK && run->options.indicators > 0) {
        status = lag_run_crossing(run, other);
    }
    if (status == LAG_OK && *other < *own) {
        *own = (double)INFINITY;
    } else if (*own < (double)INFINITY) {
        *other = (double)INFINITY;
    }
    return status;
}

/* What happens at the end of a step: the model's, the caller's; clocks before `stop`. */
static lag_status happen(lag_run *run, double stop, const lag_half *half, int *happened)
{
    int fired = 0;
    *happened = half->own;
    lag_instants_after(&run->instants, half->length);
    lag_status status = half->own ? lag_run_event(run, half->length, run->pending) : LAG_OK;
    if (status == LAG_OK && run->stepper.t < stop && lag_run_due(run, run->stepper.t)) {
        *happened = 1;
        status = lag_run_ticks(run);
    }
    if (status == LAG_OK) {
        status = lag_run_fire(run, half->other, &fired);
    }
    *happened = *happened || fired;
    return status == LAG_OK && *happened ? lag_watch_look(&run->watch, run->stepper.t, run->stepper.x) : status;
}

lag_status lag_run_step(lag_run *run, double stop)
{
    lag_stepper *s = &run->stepper;
    lag_half *half = &run->half;
    const double t = s->t;
    double own = (double)INFINITY;
    double other = (double)INFINITY;
    lag_status status = advance(run, fmin(stop, lag_run_instant(run)));
    half->next = s->h;
    half->length = s->t - t;
    if (status == LAG_OK) {
        status = find(run, &own, &other);
    }
    half->t = fmin(fmin(own, other), s->t);
    if (status == LAG_OK) {
        status = lag_run_rows(run, half->t, 0);
    }
    if (status != LAG_OK) {
        return give_back(run, t, status);
    }
    half->own = own < (double)INFINITY;
    half->other = other < (double)INFINITY;
    half->open = 1;
    memcpy(run->pending, run->alert.changed, (run->motion.model->nindicator + run->motion.model->ncontact) * sizeof(double));
    return LAG_OK;
}

lag_status lag_run_finish(lag_run *run, double stop)
{
    lag_stepper *s = &run->stepper;
    lag_half *half = &run->half;
    int happened = 0;
    if (!half->open) {
        return LAG_OK;
    }
    half->open = 0;
    lag_status status = half->own || half->other ? lag_run_back(run, half->t) : LAG_OK;
    if (status != LAG_OK) {
        return give_back(run, s->t_before, status);
    }
    status = happen(run, stop, half, &happened);
    if (status == LAG_OK && happened) {
        s->h = fmin(half->next, s->h_most);
        run->look.rank = 0;
        status = s->t < stop ? restart(run, s->method, stop - s->t) : LAG_OK;
    } else if (status == LAG_OK) {
        status = follow(run, stop);
    }
    return status == LAG_OK ? lag_run_rows(run, s->t, 1) : status;
}

/* What happens at instants is looked for at a few places of a step: none is so long that much would be missed between them. */
static double most_length(const lag_run *run)
{
    const lag_model *model = run->motion.model;
    const double length = run->instants.contacts.length;
    if (run->options.h_most > 0.0) {
        return run->options.h_most;
    }
    return model->nindicator + model->ncontact > 0 && length > 0.0 ? length / LEAST_STEPS : (double)INFINITY;
}

lag_status lag_run_restart(lag_run *run, double stop)
{
    lag_stepper *s = &run->stepper;
    s->h_least = least_length(run, stop);
    if (!(run->options.length > 0.0) && run->options.count < 2) {
        run->instants.contacts.length = fmax(run->instants.contacts.length, stop - run->begun);
    }
    s->h_most = most_length(run);
    run->half.open = 0;
    lag_status status = lag_run_ticks(run);
    if (status == LAG_OK) {
        status = restart(run, s->method, stop - s->t);
    }
    if (status == LAG_OK && run->options.careful && run->motion.model->nc > 0) {
        status = see(run);
        if (crosses(run->motion.model, &run->options) && (status == LAG_OK || status == LAG_ATTENTION)) {
            lag_singular_begin(&run->singular, status == LAG_ATTENTION);
            status = LAG_OK;
        }
    }
    return status;
}

lag_status lag_run_to(lag_run *run, double stop, size_t most_steps)
{
    run->steps = 0;
    if (!(stop > run->stepper.t)) {
        return LAG_OK;
    }
    lag_status status = lag_run_restart(run, stop);
    while (status == LAG_OK && run->stepper.t < stop) {
        if (most_steps > 0 && run->steps >= most_steps) {
            return LAG_TOO_LONG;
        }
        ++run->steps;
        status = lag_run_step(run, stop);
        if (status == LAG_OK) {
            status = lag_run_finish(run, stop);
        }
    }
    return status;
}

/* What happened during a step of fixed length happens at its end. */
static lag_status follow_fixed(lag_run *run, double h)
{
    lag_status status = LAG_OK;
    if (run->motion.model->event == NULL) {
        return status;
    }
    lag_instants_after(&run->instants, h);
    run->instants.contacts.flight = h;
    status = lag_alert_look(&run->alert, run->stepper.t, run->stepper.x);
    if (status == LAG_HAPPENS) {
        status = lag_run_event(run, h, run->alert.changed);
    }
    run->instants.contacts.flight = 0.0;
    return status == LAG_OK ? lag_run_ticks(run) : status;
}

/* The end of a step of length h from t; of one after the other, as a whole number of steps from the first. */
static double end_of_step(lag_clock *pace, double t, double h)
{
    if (pace->period != h || lag_clock_instant(pace, pace->next) != t) {
        *pace = lag_clock_of(t, h);
    }
    ++pace->next;
    return lag_clock_instant(pace, pace->next);
}

lag_status lag_run_fixed(lag_run *run, double h, lag_status (*step)(const lag_ode *, size_t, double, double, double *, double *),
    double *memory)
{
    lag_stepper *s = &run->stepper;
    const unsigned iterations = run->projection.iterations;
    int moved = 0;
    lag_status status = lag_alert_begin(&run->alert, s->t, s->x);
    if (status != LAG_OK) {
        return status;
    }
    status = step(s->ode, run->motion.model->nq, s->t, h, s->x, memory);
    if (status == LAG_OK) {
        s->t_before = s->t;
        s->t = end_of_step(&run->pace, s->t, h);
        run->projection.iterations = 2;
        (void)lag_projection_apply(&run->projection, s->t, s->x, &moved);
        run->projection.iterations = iterations;
    }
    return status == LAG_OK ? follow_fixed(run, h) : status;
}
