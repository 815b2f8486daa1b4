#include "lag/ensemble.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

#include "lag/equations/motion.h"
#include "lag/linalg/arena.h"
#include "lag/session/lane.h"
#include "lag/session/motions.h"

/* Groups of lanes: as many as make the most lanes, of two lanes at least. */
enum { GROUPS = LAG_ATTEMPT_LANES / 2 };

/* Bytes of the longest vector: what starts at a multiple of it is read fastest. */
enum { ALIGNED = 64 };

/* Of the runs of one thread that are under way together. */
static const size_t MOST_BYTES = (size_t)1 << 28;

/* Memory of one thread: runs in lanes. */
typedef struct crowd {
    const lag_ensemble *ensemble;
    size_t next, end;    /* the next run, and where they end */
    size_t lanes;
    lag_lane *lane;
    size_t each;         /* lanes of a group */
    int opens;           /* between steps nothing but rows, invariants and assertions are looked at: lanes may go on without their runs */
    lag_motions motions[GROUPS];
    lag_attempts attempts[GROUPS];
    lag_stepper *stepper[LAG_ATTEMPT_LANES]; /* that an attempt was made for; null: none */
} crowd;

/* Runs that are under way together, in groups of lanes: those of large models are not, whose matrices would be there several times. */
static size_t lanes_of(const lag_ensemble *ensemble)
{
    const int can = lag_motions_can(ensemble->model, ensemble->states);
    return can && LAG_ATTEMPT_LANES * lag_lane_size(ensemble) <= MOST_BYTES ? LAG_ATTEMPT_LANES : 1;
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
    return lag_padded(sizeof(crowd)) + lag_padded(lanes * sizeof(lag_lane)) + lanes * lag_lane_size(ensemble) + ALIGNED + together * sizeof(double);
}

static int is_stopped(const lag_ensemble *ensemble)
{
    return ensemble->stopped != NULL && atomic_load(ensemble->stopped);
}

/* The run of lane k has made its step, or begun, with this status. */
static void see(crowd *all, size_t k, lag_status status, int ended)
{
    if (status != LAG_OK || ended) {
        lag_lane_end(all->lane + k, all->ensemble, status);
        all->motions[k / all->each].of[k % all->each] = NULL;
    }
}

/* The next run begins in lane k. */
static void begin(crowd *all, size_t k)
{
    lag_lane *own = all->lane + k;
    int ended = 0;
    const lag_status status = lag_lane_begin(own, all->ensemble, all->next++, &ended);
    see(all, k, status, ended);
    if (own->run != NULL && all->lanes > 1) {
        lag_motions_enter(all->motions + k / all->each, k % all->each, &own->run->motion);
    }
}

/* One step of lane k. */
static void step(crowd *all, size_t k)
{
    int ended = 0;
    const lag_status status = lag_lane_step(all->lane + k, all->ensemble, &ended);
    see(all, k, status, ended);
}

/* Lane k goes on alone to where it can do its next step with others; null: no run is left for it, or no more are wanted. */
static lag_stepper *bring(crowd *all, size_t k)
{
    lag_lane *own = all->lane + k;
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

/* Lane k, which has entered, goes on without its run from now on, if that may be. */
static void open_lane(crowd *all, size_t k)
{
    lag_lane *own = all->lane + k;
    lag_run *run = own->run;
    lag_attempts *attempts = all->attempts + k / all->each;
    const size_t place = k % all->each;
    const lag_conditions *conditions = &run->conditions;
    const int watched = conditions->tolerance != NULL;
    if (all->opens && !(watched && (!conditions->begun || lag_any(run->motion.model->na, conditions->warned)))) {
        lag_attempts_open(attempts, place, &run->accuracy);
        lag_motions_open(all->motions + k / all->each, place, conditions);
        attempts->step.row[place] = lag_run_next_row(run);
        attempts->step.border[place] = (double)INFINITY;
        attempts->step.left[place] = (double)own->left;
        if (run->options.method == NULL) {
            const lag_stiffness *stiffness = &run->methods.stiffness;
            attempts->step.border[place] = lag_stiffness_border(stiffness);
            attempts->step.left[place] = fmin((double)own->left, (double)lag_stiffness_steps(stiffness, &run->stepper));
        }
    }
}

/* The run of lane k is where the attempt in its lane began, and looks at all of its steps again. */
static void close_lane(crowd *all, size_t k)
{
    lag_lane *own = all->lane + k;
    lag_run *run = own->run;
    lag_attempts *attempts = all->attempts + k / all->each;
    const size_t place = k % all->each;
    if (attempts->step.open[place] != 0.0) {
        const size_t steps = lag_attempts_close(attempts, place, &run->stepper, &run->accuracy);
        lag_motions_close(all->motions + k / all->each, place, &run->conditions);
        own->steps += steps;
        own->left -= steps;
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
    while (status == LAG_OK && lag_run_next_row(run) < step->t_new[place]) {
        lag_attempts_inside(attempts, place, lag_run_next_row(run), run->point);
        status = lag_run_row(run, lag_run_next_row(run), run->point);
    }
    step->row[place] = lag_run_next_row(run);
    step->evaluations[place] += LAG_DOP853_SLOPES - LAG_DOP853_END - 1;
    return status == LAG_OK && lag_run_next_row(run) > step->t_new[place];
}

/* 1: lane k goes on without its run. */
static int goes_on_in_lanes(crowd *all, size_t k)
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
    lag_lane *own = all->lane + k;
    const size_t group = k / all->each;
    const size_t place = k % all->each;
    if (all->stepper[k] != NULL) {
        close_lane(all, k);
        if (lag_attempts_settle(all->attempts + group, all->stepper[k], place)) {
            lag_motions_conditions(all->motions + group, place, &own->run->conditions.known);
            step(all, k);
        }
    }
    all->stepper[k] = NULL;
}

/* Lane k from the attempt that was made for it, if there is one, to the next one, which enters: all of that while its run is at hand. */
static void advance(crowd *all, size_t k)
{
    lag_lane *own = all->lane + k;
    const size_t group = k / all->each;
    if (goes_on_in_lanes(all, k)) {
        return;
    }
    settle(all, k);
    lag_stepper *s = all->stepper[k] = bring(all, k);
    if (s != NULL) {
        lag_attempt_begin(s, lag_run_limit(own->run, own->goal));
        s->attempt.dense = lag_run_reads_inside(own->run, s->attempt.t_new);
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
    all->lane = (lag_lane *)(void *)(bytes + lag_padded(sizeof(crowd)));
    bytes += lag_padded(sizeof(crowd)) + lag_padded(lanes * sizeof(lag_lane));
    for (size_t k = 0; k < lanes; ++k, bytes += lag_lane_size(ensemble)) {
        lag_lane_place(all->lane + k, ensemble, bytes);
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
