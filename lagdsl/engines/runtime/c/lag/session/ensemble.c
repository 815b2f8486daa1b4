#include "lag/ensemble.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

#include "lag/equations/discretes.h"
#include "lag/session/motions.h"
#include "lag/linalg/finite.h"
#include "lag/linalg/arena.h"
#include "lag/linalg/vector.h"

/* Rows and notes of a run before they are sorted. */
enum { ROWS = 16, NOTES = 64 };

/* Groups of lanes: as many as make the most lanes, of two lanes at least. */
enum { GROUPS = LAG_ATTEMPT_LANES / 2 };

/* Bytes of the longest vector: what starts at a multiple of it is read fastest. */
enum { ALIGNED = 64 };

/* Of the runs of one thread that are under way together. */
static const size_t MOST_BYTES = (size_t)1 << 28;

/* The rows of one run that are kept. */
typedef struct keeper {
    const lag_ensemble *ensemble;
    size_t width, next, kept; /* numbers of a row of the run; place of the time that is waited for; rows so far */
    double *rows;             /* (count, lag_ensemble_width()) */
} keeper;

/* One of the runs that are under way together. */
typedef struct lane {
    lag_run_options options;
    lag_results results;
    keeper kept;
    lag_note notes[NOTES];
    lag_initial told;
    lag_run *run;        /* null: there is none */
    size_t number;       /* of the run */
    int started;         /* it has a start */
    size_t breaks;       /* so many are behind it */
    double goal;         /* the next one, or the stop */
    size_t steps, left;  /* so far, and of the present piece */
    double *rows, *row_sizes, *starts, *x;
    unsigned char *dependent;
    void *block;         /* of the run */
} lane;

/* Memory of one thread: runs in lanes. */
typedef struct crowd {
    const lag_ensemble *ensemble;
    size_t next, end;    /* the next run, and where they end */
    size_t lanes;
    lane *lane;
    size_t each;         /* lanes of a group */
    int opens;           /* between steps nothing but rows, invariants and assertions are looked at: lanes may go on without their runs */
    lag_motions motions[GROUPS];
    lag_attempts attempts[GROUPS];
    lag_stepper *stepper[LAG_ATTEMPT_LANES]; /* that an attempt was made for; null: none */
} crowd;

/* Doubles of a lane beside those of the run: rows, sizes of constraints, start values and the start, flags of constraints. */
static size_t own_memory(const lag_model *model)
{
    return ROWS * lag_results_width(model) + 2 * model->nc + 2 * lag_motion_size(model);
}

static size_t lane_size(const lag_ensemble *ensemble)
{
    return lag_padded(own_memory(ensemble->model) * sizeof(double)) + lag_padded(lag_run_size(ensemble->model, ensemble->options));
}

/* Runs that are under way together, in groups of lanes: those of large models are not, whose matrices would be there several times. */
static size_t lanes_of(const lag_ensemble *ensemble)
{
    const int can = lag_motions_can(ensemble->model, ensemble->states);
    return can && LAG_ATTEMPT_LANES * lane_size(ensemble) <= MOST_BYTES ? LAG_ATTEMPT_LANES : 1;
}

/* Doubles of a group. */
static size_t group_memory(const lag_ensemble *ensemble)
{
    const lag_states *states = ensemble->states;
    const size_t count = lag_motions_memory(ensemble->model, states) + lag_attempts_memory(lag_motion_size(ensemble->model), states->lanes);
    return (count * sizeof(double) + ALIGNED - 1) / ALIGNED * (ALIGNED / sizeof(double));
}

size_t lag_ensemble_width(const lag_model *model)
{
    return lag_motion_size(model) + lag_places_of(model).contact + model->ny;
}

size_t lag_ensemble_size(const lag_ensemble *ensemble)
{
    const size_t lanes = lanes_of(ensemble);
    const size_t together = lanes > 1 ? lanes / ensemble->states->lanes * group_memory(ensemble) : 0;
    return lag_padded(sizeof(crowd)) + lag_padded(lanes * sizeof(lane)) + lanes * lane_size(ensemble) + ALIGNED + together * sizeof(double);
}

/* Keeps the rows at the times that are asked for; a later row of the same time takes the place of the one before. */
static lag_status keep(void *context, lag_results *results)
{
    keeper *k = context;
    const lag_run_options *options = k->ensemble->options;
    const size_t own = lag_ensemble_width(k->ensemble->model);
    for (size_t i = 0; i < results->row; ++i) {
        const double *row = results->rows + i * k->width;
        const int again = k->next > 0 && options->times[k->next - 1] == row[0];
        while (k->next < options->count && options->times[k->next] < row[0]) {
            ++k->next;
        }
        if (k->next < options->count && options->times[k->next] == row[0]) {
            ++k->next;
            ++k->kept;
        } else if (!again) {
            continue;
        }
        lag_copy(own, row + 1, k->rows + (k->kept - 1) * own);
    }
    results->row = results->note = 0;
    return LAG_OK;
}

/* The start x of run i, from `starts`: the model's start values and those that are given. */
static lag_status find_start(const lag_ensemble *ensemble, size_t i, lag_run *run, double *starts, double *x, lag_initial *told)
{
    const lag_model *model = ensemble->model;
    const size_t size = lag_motion_size(model);
    lag_status status = lag_run_start(run, ensemble->t, starts);
    for (size_t k = 0; ensemble->set != NULL && k < size; ++k) {
        starts[k] = ensemble->set[k] ? ensemble->x[i * size + k] : starts[k];
    }
    memcpy(x, starts, size * sizeof(double));
    if (status != LAG_OK) {
        return status;
    }
    if (!lag_finite(size, x) || !lag_finite(model->nu, run->motion.u)) {
        return LAG_NOT_FINITE;
    }
    status = lag_run_find(run, ensemble->t, ensemble->set, x, told);
    if (ensemble->results.found != NULL && model->np > 0) {
        memcpy(ensemble->results.found + i * model->np, run->motion.at.p, model->np * sizeof(double));
    }
    return status == LAG_OK && told->fault != LAG_INITIAL_NONE ? LAG_PROJECTION_FAILED : status;
}

static int is_stopped(const lag_ensemble *ensemble)
{
    return ensemble->stopped != NULL && atomic_load(ensemble->stopped);
}

/* On to where the next step begins, in pieces; *ended: there is none. LAG_TOO_LONG: as many steps as allowed. */
static lag_status approach(const lag_ensemble *ensemble, lane *own, int *ended)
{
    lag_run *run = own->run;
    lag_status status = LAG_OK;
    *ended = 0;
    while (status == LAG_OK && !(*ended || (own->goal > run->stepper.t && own->left > 0))) {
        if (own->goal > run->stepper.t) {
            const size_t left = ensemble->most_steps - own->steps;
            const size_t piece = own->steps > 0 ? ensemble->piece : ensemble->first_piece;
            own->left = left < piece ? left : piece;
            status = own->left > 0 ? lag_run_restart(run, own->goal) : LAG_TOO_LONG;
        } else if (own->breaks < ensemble->breaks) {
            ++own->breaks;
            own->goal = own->breaks < ensemble->breaks ? ensemble->at[own->breaks] : ensemble->stop;
            own->left = 0;
            status = lag_run_jump(run);
        } else {
            *ended = 1;
        }
    }
    return status;
}

/* The run of the lane has ended, or failed. */
static void end(crowd *all, size_t k, lag_status status)
{
    const lag_ensemble *ensemble = all->ensemble;
    lane *own = all->lane + k;
    if (own->started && (status == LAG_OK || status == LAG_STOPPED)) {
        const lag_status last = lag_run_end(own->run);
        status = last == LAG_OK ? status : last;
    }
    (void)keep(&own->kept, &own->results);
    ensemble->results.kept[own->number] = own->kept.kept;
    ensemble->results.ended[own->number] = own->results.any ? own->results.last : (double)NAN;
    ensemble->results.status[own->number] = (int)status;
    if (ensemble->failed != NULL && status != LAG_OK && status != LAG_STOPPED) {
        const lag_initial *told = own->started ? NULL : &own->told;
        ensemble->failed(ensemble->context, own->number, own->run, (int)status, own->starts, own->x, told);
    }
    own->run = NULL;
    all->motions[k / all->each].of[k % all->each] = NULL;
}

/* The next run begins in lane k. */
static void begin(crowd *all, size_t k)
{
    const lag_ensemble *ensemble = all->ensemble;
    const lag_model *model = ensemble->model;
    const size_t size = lag_motion_size(model);
    lane *own = all->lane + k;
    const size_t i = own->number = all->next++;
    own->told = (lag_initial){.given = !ensemble->equations, .dependent = own->dependent, .row_sizes = own->row_sizes};
    lag_fill(model->nc, 1.0, own->row_sizes);
    memset(own->dependent, 0, model->nc);
    own->kept = (keeper){
        .ensemble = ensemble, .width = lag_results_width(model),
        .rows = ensemble->results.rows + i * ensemble->options->count * lag_ensemble_width(model)
    };
    own->results = (lag_results){
        .most_rows = ROWS, .most_notes = NOTES, .rows = own->rows, .notes = own->notes, .full = keep, .context = &own->kept,
        .bare = 1
    };
    own->options = *ensemble->options;
    own->options.p = ensemble->p + i * model->np;
    own->options.u = ensemble->u == NULL ? NULL : ensemble->u + i * model->nu;
    own->options.sizes.natural = ensemble->natural + i * size;
    own->options.sizes.row_sizes = own->row_sizes;
    own->options.results = &own->results;
    own->run = lag_run_place(own->block, model, &own->options);
    own->steps = own->left = own->breaks = 0;
    own->goal = ensemble->breaks > 0 ? ensemble->at[0] : ensemble->stop;
    int ended = 0;
    lag_status status = find_start(ensemble, i, own->run, own->starts, own->x, &own->told);
    own->started = status == LAG_OK;
    status = own->started ? lag_run_begin(own->run, ensemble->t, own->x) : status;
    status = status == LAG_OK ? approach(ensemble, own, &ended) : status;
    if (status != LAG_OK || ended) {
        end(all, k, status);
    } else if (all->lanes > 1) {
        lag_motions_enter(all->motions + k / all->each, k % all->each, &own->run->motion);
    }
}

/* One step of lane k. */
static void step(crowd *all, size_t k)
{
    lane *own = all->lane + k;
    int ended = 0;
    lag_status status = lag_run_step(own->run, own->goal);
    status = status == LAG_OK ? lag_run_finish(own->run, own->goal) : status;
    ++own->steps;
    --own->left;
    status = status == LAG_OK ? approach(all->ensemble, own, &ended) : status;
    if (status != LAG_OK || ended) {
        end(all, k, status);
    }
}

/* Lane k goes on alone to where it can do its next step with others; null: no run is left for it, or no more are wanted. */
static lag_stepper *bring(crowd *all, size_t k)
{
    lane *own = all->lane + k;
    for (;;) {
        if (is_stopped(all->ensemble) || (own->run == NULL && all->next == all->end)) {
            return NULL;
        }
        if (own->run == NULL) {
            begin(all, k);
        } else if (all->lanes > 1 && own->run->stepper.method == &lag_dop853) {
            return &own->run->stepper;
        } else {
            step(all, k);
        }
    }
}

/* The time of the row that the run waits for. */
static double next_row(const lag_run *run)
{
    return run->counts.row < run->options.count ? run->options.times[run->counts.row] : (double)INFINITY;
}

/* Lane k, which has entered, goes on without its run from now on, if that may be. */
static void open_lane(crowd *all, size_t k)
{
    lane *own = all->lane + k;
    lag_run *run = own->run;
    lag_attempts *attempts = all->attempts + k / all->each;
    const size_t place = k % all->each;
    const lag_conditions *conditions = &run->conditions;
    const int watched = conditions->tolerance != NULL;
    if (all->opens && !(watched && (!conditions->begun || lag_any(run->motion.model->na, conditions->warned)))) {
        lag_attempts_open(attempts, place, &run->accuracy);
        lag_motions_open(all->motions + k / all->each, place, conditions);
        attempts->step.row[place] = next_row(run);
        attempts->step.border[place] = run->options.method == NULL ? lag_stiffness_border(&run->methods.stiffness) : (double)INFINITY;
        attempts->step.left[place] = (double)own->left;
    }
}

/* The run of lane k is where the attempt in its lane began, and looks at all of its steps again. */
static void close_lane(crowd *all, size_t k)
{
    lane *own = all->lane + k;
    lag_run *run = own->run;
    lag_attempts *attempts = all->attempts + k / all->each;
    const size_t place = k % all->each;
    if (attempts->step.open[place] != 0.0) {
        const size_t steps = lag_attempts_close(attempts, place, &run->stepper, &run->accuracy);
        lag_motions_close(all->motions + k / all->each, place, &run->conditions);
        own->steps += steps;
        own->left -= steps;
        if (steps > 0 && run->options.method == NULL) {
            lag_stiffness_rest(&run->methods.stiffness);
        }
    }
}

/* The rows within the step of lane k, which has been accepted there. 0: its run has to see to them. */
static int record_inside(crowd *all, size_t k)
{
    lag_run *run = all->lane[k].run;
    lag_attempts *attempts = all->attempts + k / all->each;
    const size_t place = k % all->each;
    lag_lane_steps *step = &attempts->step;
    lag_status status = LAG_OK;
    if (run->motion.model->na > 0) { /* assertions hold at rows, too */
        return 0;
    }
    while (status == LAG_OK && next_row(run) < step->t_new[place]) {
        lag_attempts_inside(attempts, place, next_row(run), run->point);
        status = lag_run_row(run, next_row(run), run->point);
    }
    step->row[place] = next_row(run);
    step->evaluations[place] += LAG_DOP853_SLOPES - LAG_DOP853_END - 1;
    return status == LAG_OK && next_row(run) > step->t_new[place];
}

/* 1: lane k goes on without its run. */
static int goes_on(crowd *all, size_t k)
{
    const lag_lane_steps *step = &all->attempts[k / all->each].step;
    const size_t place = k % all->each;
    if (all->stepper[k] == NULL || (step->accepted[place] == 0.0 && step->refused[place] == 0.0)) {
        return 0;
    }
    return step->refused[place] != 0.0 || step->dense[place] == 0.0 || record_inside(all, k);
}

/* The step that lane k has an attempt of, if it has one; it is tried again where that was none. */
static void settle(crowd *all, size_t k)
{
    lane *own = all->lane + k;
    const size_t group = k / all->each;
    const size_t place = k % all->each;
    if (all->stepper[k] != NULL) {
        close_lane(all, k);
        if (lag_attempts_settle(all->attempts + group, all->stepper[k], place)) {
            lag_motions_tell(all->motions + group, place, &own->run->conditions.known);
            step(all, k);
        }
    }
    all->stepper[k] = NULL;
}

/* Lane k from the attempt that was made for it, if there is one, to the next one, which enters: all of that while its run is at hand. */
static void advance(crowd *all, size_t k)
{
    lane *own = all->lane + k;
    const size_t group = k / all->each;
    if (goes_on(all, k)) {
        return;
    }
    settle(all, k);
    lag_stepper *s = all->stepper[k] = bring(all, k);
    if (s != NULL) {
        lag_attempt_begin(s, lag_run_limit(own->run, own->goal));
        s->attempt.dense = lag_run_looks_inside(own->run, s->attempt.t_new);
        lag_attempts_enter(all->attempts + group, s, k % all->each);
        open_lane(all, k);
    }
}

/* Inputs and discretes of all groups. */
static lag_status take(crowd *all)
{
    lag_status status = LAG_OK;
    for (size_t g = 0; g < all->lanes / all->each && status == LAG_OK; ++g) {
        status = lag_motions_take(all->motions + g);
    }
    return status;
}

/* The step of lane k, without the attempt that has entered; one that is there already is settled. */
static void step_alone(crowd *all, size_t k)
{
    lag_lane_steps *own = &all->attempts[k / all->each].step;
    const size_t place = k % all->each;
    if (all->lanes > 1 && (own->accepted[place] != 0.0 || own->refused[place] != 0.0)) {
        settle(all, k);
        return;
    }
    close_lane(all, k);
    own->used[place] = 0.0;
    all->stepper[k] = NULL;
    step(all, k);
}

/* A step, or an attempt at it, of each lane that has one before it. Returns 0 where there are none. */
static int step_together(crowd *all)
{
    const size_t groups = all->lanes / all->each;
    size_t count = 0;
    if (is_stopped(all->ensemble)) {
        return 0;
    }
    for (size_t k = 0; k < all->lanes; ++k) {
        advance(all, k);
        count += all->stepper[k] != NULL;
    }
    for (size_t g = 0; g < groups && all->lanes > 1; ++g) {
        lag_motions_count(all->motions + g, all->attempts[g].step.accepted);
    }
    if (count > 1 && take(all) == LAG_OK) {
        lag_attempts_make(all->attempts, groups);
        return 1;
    }
    for (size_t k = 0; k < all->lanes; ++k) {
        if (all->stepper[k] != NULL) {
            step_alone(all, k);
        }
    }
    return count > 0;
}

static void place_groups(crowd *all, double *memory)
{
    const lag_ensemble *ensemble = all->ensemble;
    const lag_model *model = ensemble->model;
    const lag_states *states = ensemble->states;
    for (size_t g = 0; g < all->lanes / all->each; ++g, memory += group_memory(ensemble)) {
        lag_attempts *attempts = all->attempts + g;
        lag_motions_place(all->motions + g, model, states, memory);
        lag_attempts_place(attempts, lag_motion_size(model), all->each, states->width, memory + lag_motions_memory(model, states));
        attempts->rates = lag_motions_rates;
        attempts->ends = ensemble->options->invariants.tolerance == NULL ? NULL : lag_motions_monitor;
        attempts->context = all->motions + g;
    }
}

/* Lays out the memory of one thread. */
static crowd *place(const lag_ensemble *ensemble, void *block)
{
    const lag_model *model = ensemble->model;
    const size_t lanes = lanes_of(ensemble);
    char *bytes = block;
    crowd *all = block;
    all->ensemble = ensemble;
    all->lanes = lanes;
    memset(all->stepper, 0, sizeof all->stepper);
    all->lane = (lane *)(void *)(bytes + lag_padded(sizeof(crowd)));
    bytes += lag_padded(sizeof(crowd)) + lag_padded(lanes * sizeof(lane));
    for (size_t k = 0; k < lanes; ++k, bytes += lane_size(ensemble)) {
        lane *own = all->lane + k;
        double *memory = (double *)(void *)bytes;
        own->rows = lag_take(&memory, ROWS * lag_results_width(model));
        own->row_sizes = lag_take(&memory, model->nc);
        own->dependent = lag_take_flags(&memory, model->nc);
        own->starts = lag_take(&memory, lag_motion_size(model));
        own->x = lag_take(&memory, lag_motion_size(model));
        own->block = bytes + lag_padded(own_memory(model) * sizeof(double));
        own->run = NULL;
    }
    all->each = lanes > 1 ? ensemble->states->lanes : 1;
    all->opens = model->nc == 0 && lag_guard_count(model) == 0 && model->ncorner == 0 && model->nturn == 0;
    if (lanes > 1) {
        place_groups(all, (double *)(void *)(bytes + (ALIGNED - (uintptr_t)bytes % ALIGNED) % ALIGNED));
    }
    return all;
}

size_t lag_ensemble_run(const lag_ensemble *ensemble, size_t first, size_t end, void *block)
{
    crowd *all = place(ensemble, block);
    all->next = first;
    all->end = end;
    while (step_together(all)) {
    }
    size_t made = all->next;
    for (size_t k = 0; k < all->lanes; ++k) {
        made = all->lane[k].run != NULL && all->lane[k].number < made ? all->lane[k].number : made;
    }
    return made;
}
