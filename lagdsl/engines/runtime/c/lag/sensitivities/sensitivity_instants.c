/* Columns at an instant: it is a map, differentiated as a whole (differences.c). */
#include <float.h>
#include <math.h>
#include <string.h>

#include "lag/linalg/arena.h"
#include "lag/linalg/vector.h"
#include "lag/run.h"
#include "lag/sensitivities/sensitivities.h"

/* ---- its values ---- */

/* Sizes of changes of order one of these. */
static void set_sizes(lag_sensitivities *s, const lag_run *run)
{
    const lag_model *model = run->motion.model;
    const size_t n = lag_motion_size(model);
    memcpy(s->instant.sizes, run->sizes.natural, n * sizeof(double));
    for (size_t i = 0; i < model->nw; ++i) {
        s->instant.sizes[n + i] = fmax(fabs(run->motion.w[i]), 1.0);
    }
    lag_fill(model->ncontact, 1.0, s->instant.sizes + n + model->nw);
}

/* ---- its time ---- */

/* True if two times of one instant move apart along a column. */
static int move_apart(double a, double b)
{
    return fabs(a - b) > sqrt(DBL_EPSILON) * fmax(fabs(a), fabs(b));
}

/* Several guards or clocks cause the instant, and their times move apart. */
static void note_one_sided(lag_sensitivities *s, double t)
{
    s->fault.one_sided += 1;
    s->fault.first = fmin(s->fault.first, t);
}

/* Values of the guards that cause the instant, and zeros for the others, which nobody seeks and which may jump. */
static lag_status guard_values(void *context, double *values)
{
    const lag_instant_map *map = context;
    lag_guards *guards = &map->run->guards;
    const lag_status status = lag_guards_detect(guards, map->run->stepper.t, map->run->stepper.x);
    for (size_t i = 0; i < lag_guard_count(map->run->motion.model); ++i) {
        values[i] = map->cause->changed[i] != 0.0 ? guards->value[i] : 0.0;
    }
    return status == LAG_EVENT_PENDING ? LAG_OK : status;
}

/* First instants and periods of clocks, distances of what time changes. */
static lag_status all_scheduled(lag_run *run, double *values)
{
    const lag_model *model = run->motion.model;
    lag_timed *timed = &run->instants.timed;
    run->motion.at.t = run->stepper.t;
    lag_status status = model->nclock > 0 ? model->clock(&run->motion.at, values, values + model->nclock) : LAG_OK;
    if (status == LAG_OK && model->ntimed > 0) {
        status = model->time_event(&run->motion.at, timed->value, timed->told, values + 2 * model->nclock, timed->rate, timed->affine,
            timed->entry);
    }
    return status;
}

/* The same, with zeros for distances that are not due, which may bend. */
static lag_status scheduled_values(void *context, double *values)
{
    const lag_instant_map *map = context;
    const lag_model *model = map->run->motion.model;
    const lag_status status = all_scheduled(map->run, values);
    for (size_t i = 0; i < model->ndistance; ++i) {
        double *distance = values + 2 * model->nclock + i;
        *distance = i == map->distance ? *distance : 0.0;
    }
    return status;
}

/* The displacement along column k, at a fixed time. */
static lag_displacement along_column(lag_sensitivities *s, const lag_model *model, size_t k)
{
    const size_t n = lag_motion_size(model);
    double *one = s->work.one;
    const size_t variables = lag_columns_variables(model);
    lag_columns_get(s, k, 0, variables, s->columns.x, variables, one);
    lag_columns_get(s, k, 0, model->nw, s->columns.w, model->nw, one + variables);
    return (lag_displacement){0.0, one, one + variables, one + n, one + n + model->nu, s->instant.until + k * model->ncontact};
}

/* The distance of what time changes that is at zero, or their number. */
static size_t due_distance(const lag_run *run, const double *distance)
{
    const lag_model *model = run->motion.model;
    size_t due = model->ndistance;
    for (size_t i = 0; i < model->ndistance; ++i) {
        const double until = fabs(distance[i] / run->instants.timed.rate[i]);
        const double least = due < model->ndistance ? fabs(distance[due] / run->instants.timed.rate[due]) : (double)INFINITY;
        due = until < least ? i : due;
    }
    return due;
}

/* dtau of the next tick of a clock, by the derivatives of scheduled_values(). */
static double time_of_tick(const lag_run *run, const double *derivative, size_t clock)
{
    return derivative[clock] + (double)run->instants.clocks.each[clock].next * derivative[run->motion.model->nclock + clock];
}

/* dtau of what is scheduled for now. */
static lag_status find_scheduled(lag_sensitivities *s, lag_instant_map *map)
{
    lag_run *run = map->run;
    const lag_model *model = run->motion.model;
    lag_contacts *contacts = &run->instants.contacts;
    double *derivative = s->instant.behind;
    double error = 0.0;
    size_t due = lag_clocks_due(model->nclock, run->instants.clocks.each, run->stepper.t);
    const int is_clock = due < model->nclock;
    for (size_t i = 0; i < model->ncontact && !is_clock; ++i) {
        if (contacts->until[i] <= run->stepper.t) {
            for (size_t k = 0; k < s->of.count; ++k) {
                s->instant.time[k] = s->instant.until[k * model->ncontact + i];
            }
            return LAG_OK;
        }
    }
    if (!is_clock && model->ndistance == 0) {
        return LAG_OK;
    }
    lag_status status = all_scheduled(run, s->instant.sizes);
    map->distance = is_clock ? model->ndistance : due_distance(run, s->instant.sizes + 2 * model->nclock);
    due = is_clock ? due : map->distance;
    const double rate = is_clock ? 0.0 : run->instants.timed.rate[due];
    lag_fill(2 * model->nclock + model->ndistance, 1.0, s->instant.sizes);
    for (size_t k = 0; k < s->of.count && status == LAG_OK; ++k) {
        const lag_displacement along = along_column(s, model, k);
        const lag_displacement by_law = {0.0, NULL, along.w, NULL, along.p, NULL};
        status = lag_differences_along(&s->differences, &by_law, 2 * model->nclock + model->ndistance, s->instant.sizes, scheduled_values, map,
            derivative, &error);
        s->fault.guard = k;
        s->instant.time[k] = is_clock ? time_of_tick(run, derivative, due) : -derivative[2 * model->nclock + due] / rate;
        for (size_t i = due + 1; i < model->nclock && is_clock && status == LAG_OK; ++i) {
            if (lag_clock_is_due(&run->instants.clocks.each[i], map->t) && move_apart(s->instant.time[k], time_of_tick(run, derivative, i))) {
                note_one_sided(s, map->t);
            }
        }
    }
    return status;
}

/* Rates of the rates along the motion, f_x f + f_t, by differences of them. */
static lag_status find_course(lag_sensitivities *s, lag_run *run, double *course)
{
    const size_t n = run->stepper.ode->size;
    const lag_displacement forward = {1.0, s->instant.f, NULL, NULL, NULL, NULL};
    const double by = lag_differences_step() / lag_differences_extent(&s->differences, &forward);
    double *x = s->work.state_of_stage;
    double *f = s->work.state;
    lag_status status = LAG_OK;
    lag_fill(n, 0.0, course);
    lag_differences_restore(&s->differences);
    for (int k = -1; k <= 1 && status == LAG_OK; k += 2) {
        memcpy(x, run->stepper.x, n * sizeof(double));
        lag_axpy(n, k * by, s->instant.f, x);
        status = run->motion.ode.rates(&run->motion, run->stepper.t + k * by, x, f);
        lag_axpy(n, 0.5 * k / by, f, course);
    }
    return status;
}

/*
 * True if guard i, with this rate and its error, does not clearly pass its border: it would turn back, by its second derivative, before it were farther
 * behind than the tolerance lets it be known.
 */
static int grazes(const lag_instant_map *map, size_t i, double rate, double error, double second)
{
    const double back = rate < 0.0 ? second : -second;
    return !(fabs(rate) > LAG_MOVES_CLEARLY * error) || (back > 0.0 && rate * rate <= 2.0 * back * lag_guards_known(&map->run->guards, i));
}

/* True if one of the guards flagged in `changed`, with these rates, does so; which one is told. */
static lag_status check_guards(lag_sensitivities *s, lag_instant_map *map, const double *changed, const double *rate, double error)
{
    lag_run *run = map->run;
    const size_t guards = lag_guard_count(run->motion.model);
    double *course = s->work.one;
    double *second = s->instant.behind;
    double ignored = 0.0;
    lag_status status = find_course(s, run, course);
    const lag_displacement on = {0.0, course, NULL, NULL, NULL, NULL};
    if (status == LAG_OK) {
        status = lag_differences_along(&s->differences, &on, guards, s->instant.sizes, guard_values, map, second, &ignored);
    }
    for (size_t i = 0; i < guards && status == LAG_OK; ++i) {
        if (changed[i] != 0.0 && grazes(map, i, rate[i], error, second[i] + s->instant.bend[i])) {
            s->fault.guard = i;
            return LAG_GRAZING;
        }
    }
    return status;
}

/* dtau of guards flagged in `changed`: -(g_x s + g_a) / (g_x f + g_t). */
static lag_status find_located(lag_sensitivities *s, lag_instant_map *map, const double *changed)
{
    lag_run *run = map->run;
    const lag_model *model = run->motion.model;
    const size_t guards = lag_guard_count(model);
    const lag_displacement forward = {1.0, s->instant.f, NULL, NULL, NULL, NULL};
    double *along = s->instant.behind;
    double *rate = along + guards;
    double error = 0.0;
    size_t first = guards;
    lag_fill(guards, 1.0, s->instant.sizes);
    lag_status status = lag_differences_along(&s->differences, &forward, guards, s->instant.sizes, guard_values, map, rate, &error);
    error *= lag_differences_extent(&s->differences, &forward);
    for (size_t i = 0; i < guards; ++i) {
        first = changed[i] != 0.0 && first == guards ? i : first;
        s->instant.bend[i] = lag_differences_bend(&s->differences, i);
    }
    status = status == LAG_OK ? check_guards(s, map, changed, rate, error) : status;
    for (size_t k = 0; k < s->of.count && status == LAG_OK && first < guards; ++k) {
        const lag_displacement column = along_column(s, model, k);
        status = lag_differences_along(&s->differences, &column, guards, s->instant.sizes, guard_values, map, along, &error);
        s->fault.guard = k;
        s->instant.time[k] = -along[first] / rate[first];
        for (size_t i = first + 1; i < guards && status == LAG_OK; ++i) {
            if (changed[i] != 0.0 && move_apart(s->instant.time[k], -along[i] / rate[i])) {
                note_one_sided(s, map->t);
            }
        }
    }
    return status;
}

/* ---- all ---- */

/* Columns behind the instant, into instant.behind. */
static lag_status find_behind(lag_sensitivities *s, lag_instant_map *map)
{
    lag_run *run = map->run;
    const lag_model *model = run->motion.model;
    const size_t n = lag_motion_size(model);
    const size_t count = n + model->nw + model->ncontact;
    lag_status status = LAG_OK;
    set_sizes(s, run);
    for (size_t k = 0; k < s->of.count && status == LAG_OK; ++k) {
        const double time = s->instant.time[k];
        double *behind = s->instant.behind + k * count;
        double error = 0.0;
        lag_displacement along = along_column(s, model, k);
        lag_axpy(n, time, s->instant.f, s->work.one);
        along.t = time;
        status = lag_differences_along(&s->differences, &along, count, s->instant.sizes, lag_instant_map_behind, map, behind, &error);
        s->fault.guard = k;
        lag_axpy(n, -time, s->instant.f_after, behind);
        for (size_t i = 0; i < model->nw; ++i) {
            const int own = lag_is_mode(model->kinds[i]) || model->kinds[i] == LAG_KIND_LOAD;
            behind[n + i] = own ? 0.0 : behind[n + i];
        }
    }
    return status;
}

/* The instant as the run itself goes through it. */
static lag_status try_instant(lag_sensitivities *s, lag_instant_map *map)
{
    lag_run *run = map->run;
    const lag_model *model = run->motion.model;
    lag_differences_restore(&s->differences);
    const lag_status status = lag_instant_map_carry(map, &map->events);
    memcpy(s->instant.w_after, run->motion.w, model->nw * sizeof(double));
    memcpy(s->instant.until_after, run->instants.contacts.until, model->ncontact * sizeof(double));
    if (status != LAG_OK && status != LAG_STOPPED) {
        return status;
    }
    return run->motion.ode.rates(&run->motion, run->stepper.t, run->stepper.x, s->instant.f_after);
}

void lag_sensitivities_after(lag_companion *companion)
{
    lag_sensitivities *s = (lag_sensitivities *)(void *)companion;
    const lag_model *model = s->differences.run->motion.model;
    const size_t n = lag_motion_size(model);
    const size_t count = n + model->nw + model->ncontact;
    for (size_t k = 0; k < s->of.count && s->instant.pending; ++k) {
        const double *behind = s->instant.behind + k * count;
        lag_columns_put(s, k, 0, n, behind, s->columns.x, lag_columns_variables(model));
        lag_columns_put(s, k, 0, model->nw, behind + n, s->columns.w, model->nw);
        memcpy(s->instant.until + k * model->ncontact, behind + n + model->nw, model->ncontact * sizeof(double));
    }
    s->instant.pending = 0;
}

/* The instant has ended like this: pieces of the past that follow began at it. */
static lag_status happened(lag_sensitivities *s, const lag_run *run, lag_status status)
{
    if (run->motion.model->ndelay > 0) {
        memcpy(s->past.moved, s->instant.time, s->of.count * sizeof(double));
        s->past.happened = 1;
    }
    return status;
}

lag_status lag_sensitivities_instant(lag_run *run, const lag_cause *cause)
{
    lag_sensitivities *s = lag_sensitivities_of(run);
    lag_instant_map map = {s, run, cause, run->stepper.t, 0, run->motion.model->ndistance};
    const int begins = cause->kind == LAG_CAUSE_START;
    s->work.known.t = (double)NAN;
    if (run->motion.model->event == NULL && (cause->kind != LAG_CAUSE_INPUTS || run->motion.inputs == NULL)) {
        return lag_run_carry(run, cause);
    }
    lag_status status = begins ? LAG_OK : run->motion.ode.rates(&run->motion, run->stepper.t, run->stepper.x, s->instant.f);
    lag_fill(s->of.count, 0.0, s->instant.time);
    if (status != LAG_OK) {
        return status;
    }
    lag_columns_set_delays(s, run, run->stepper.t);
    if (lag_columns_jumps_alone(run, cause)) {
        return happened(s, run, lag_columns_pass_jumps(s, run, cause));
    }
    lag_differences_begin(&s->differences, run, s->scales, LAG_FINEST_STEP);
    status = try_instant(s, &map);
    if (status != LAG_OK) { /* it fails, as it will without columns */
        lag_differences_end(&s->differences);
        return lag_run_carry(run, cause);
    }
    lag_differences_restore(&s->differences);
    if (cause->kind == LAG_CAUSE_GUARDS) {
        status = find_located(s, &map, cause->changed);
    } else if (cause->kind == LAG_CAUSE_TIME) {
        status = find_scheduled(s, &map);
    }
    if (cause->kind == LAG_CAUSE_TIME && cause->changed != NULL) { /* guards at the instant of a tick: beside the motion one of them is first */
        note_one_sided(s, map.t);
    }
    lag_differences_restore(&s->differences);
    status = status == LAG_OK ? find_behind(s, &map) : status;
    lag_differences_end(&s->differences);
    if (status != LAG_OK) {
        s->fault.t = map.t;
        return status;
    }
    s->instant.pending = 1;
    status = lag_run_carry(run, cause);
    lag_sensitivities_after(&s->companion);
    if (begins && (status == LAG_OK || status == LAG_STOPPED)) {
        const lag_status begun = lag_columns_begin_past(s, run);
        return begun == LAG_OK ? status : begun;
    }
    return happened(s, run, status);
}
