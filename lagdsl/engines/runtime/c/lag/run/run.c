#include "lag/run.h"

#include <math.h>
#include <string.h>

#include "lag/initial.h"
#include "lag/linalg/arena.h"

static const double TOLERANCE = 1e-8;
static const double PART = 1e-3;

int lag_run_crosses(const lag_model *model, const lag_run_options *options)
{
    return options->careful && model->nc > 0;
}

static void lay_instants(lag_instants *instants, lag_guards *guards, lag_motion *motion, lag_projection *projection, lag_clock *clock, lag_layout *layout)
{
    lag_instants_place(instants, motion, projection, clock, layout);
    lag_guards_place(guards, motion, &instants->modes.reserve, &instants->noise, layout);
}

/* Doubles of it. A whole run is too large for the stack of a microcontroller. */
static size_t instants_memory(const lag_model *model)
{
    lag_layout layout = {NULL, 0};
    lag_motion motion = {.model = model};
    lag_projection projection = {0};
    lag_instants instants = {0};
    lag_guards guards = {0};
    lay_instants(&instants, &guards, &motion, &projection, NULL, &layout);
    return layout.count;
}

size_t lag_run_numbers(const lag_model *model)
{
    const size_t size = lag_motion_size(model);
    const lag_ode ode = lag_motion_ode(model);
    return lag_motion_memory(model) + lag_stepper_memory(&ode) + lag_projection_memory(model) +
           lag_rank_estimate_memory(model) + instants_memory(model) + lag_conditions_memory(model) +
           lag_stiffness_memory(size) + 6 * size + 3 * model->nc + 3 * model->ni +
           2 * lag_guard_count(model) + model->np + model->nu + lag_turns_memory(model) + 1;
}

/* Doubles of which nothing is remembered. */
static size_t scratch(const lag_model *model, const lag_run_options *options)
{
    const size_t initial = options->start != NULL ? lag_initial_memory(model) : 0;
    return initial + (lag_run_crosses(model, options) ? lag_singular_memory(model) : 0);
}

size_t lag_run_size(const lag_model *model, const lag_run_options *options)
{
    return lag_padded(sizeof(lag_run)) + lag_padded(model->nclock * sizeof(lag_clock)) +
           (lag_run_numbers(model) + scratch(model, options)) * sizeof(double);
}

static void place_watch(lag_run *run, const lag_model *model, double **memory)
{
    const lag_run_invariants *invariants = &run->options.invariants;
    const size_t ni = model->ni;
    double *own = lag_take(memory, 3 * ni);
    run->conditions.motion = &run->motion;
    run->conditions.known = (lag_known_conditions){0};
    run->conditions.begun = invariants->continued;
    run->conditions.start = invariants->start != NULL ? invariants->start : own;
    run->conditions.size = invariants->size != NULL ? invariants->size : own + ni;
    run->conditions.drift = invariants->drift != NULL ? invariants->drift : own + 2 * ni;
    run->conditions.tolerance = invariants->tolerance;
    run->conditions.value = lag_take(memory, lag_conditions_memory(model));
    run->conditions.scale = run->conditions.value + ni;
    run->conditions.held = run->conditions.scale + ni;
    run->conditions.warned = run->conditions.held + model->na;
}

static lag_status report_event(void *context, const lag_event_notice *notice)
{
    lag_run *run = context;
    lag_event_notice told = *notice;
    const lag_run_callbacks *callbacks = &run->options.callbacks;
    lag_status status = LAG_OK;
    if (run->options.results != NULL) {
        status = lag_results_record_event(run->options.results, run, notice);
    }
    told.row = run->counts.row;
    return status == LAG_OK && callbacks->tell != NULL ? callbacks->tell(callbacks->context, run, &told) : status;
}

/* From the options. */
static void set_instants(lag_run *run)
{
    const lag_run_options *options = &run->options;
    run->instants.noise.tolerance = options->tolerance;
    run->instants.listener.tell = report_event;
    run->instants.listener.context = run;
    run->instants.contacts.length = options->length > 0.0 ? options->length
        : options->count > 1                              ? options->times[options->count - 1] - options->times[0]
                                                          : 0.0;
}

void lag_run_depend(lag_run *run, const unsigned char *dependent)
{
    const lag_model *model = run->motion.model;
    const double *lasting = run->options.lasting.rows;
    run->ranks.estimate.most = lasting != NULL ? run->options.lasting.general : model->rank;
    for (size_t i = 0; i < model->nc; ++i) {
        const int lasts = lasting == NULL || lasting[i] != 0.0;
        const int lost = dependent != NULL && dependent[i] && !(model->redundant != NULL && model->redundant[i]);
        run->ranks.lasting[i] = lasts && !lost;
        run->ranks.estimate.most -= lasts && lost && run->ranks.estimate.most > 0;
    }
}

static void pass(void *context, unsigned place, double t)
{
    lag_run *run = context;
    lag_results *results = run->options.results;
    if (results->extremes != NULL) {
        lag_extremes_pass(results->extremes, run, place, t);
    }
}

lag_run *lag_run_place(void *block, const lag_model *model, const lag_run_options *options)
{
    const size_t size = lag_motion_size(model);
    char *bytes = block;
    if (!options->zeroed) {
        memset(block, 0, lag_run_size(model, options) - scratch(model, options) * sizeof(double));
    }
    lag_run *run = block;
    run->options = *options;
    run->clock = (lag_clock *)(void *)(bytes + lag_padded(sizeof(lag_run)));
    double *memory = (double *)(void *)(bytes + lag_padded(sizeof(lag_run)) + lag_padded(model->nclock * sizeof(lag_clock)));
    run->block.memory = memory;
    run->block.numbers = lag_run_numbers(model);
    run->options.tolerance = options->tolerance > 0.0 ? options->tolerance : TOLERANCE;
    run->options.part = options->part > 0.0 ? options->part : PART;
    lag_motion_place(&run->motion, model, lag_take(&memory, lag_motion_memory(model)));
    run->motion.inputs = options->callbacks.inputs;
    run->motion.context = options->callbacks.context;
    run->motion.along.tell = options->callbacks.along;
    lag_stepper_place(&run->stepper, &run->motion.ode, lag_take(&memory, lag_stepper_memory(&run->motion.ode)));
    run->stepper.method = options->method != NULL ? options->method : &lag_dop853;
    run->stepper.h_fixed = options->h_fixed;
    run->stepper.passing = (lag_passing){options->results != NULL && model->ny > 0 ? pass : NULL, run};
    lag_projection_place(&run->projection, &run->motion, lag_take(&memory, lag_projection_memory(model)));
    run->sizes.group = lag_take(&memory, size);
    run->sizes.natural = lag_take(&memory, size);
    run->sizes.cap = lag_take(&memory, size);
    run->sizes.rows = lag_take(&memory, model->nc);
    run->motion.sizes = run->sizes.natural;
    run->motion.row_sizes = run->sizes.rows;
    lag_rank_estimate_place(&run->ranks.estimate, model, run->sizes.natural, run->sizes.rows, lag_take(&memory, lag_rank_estimate_memory(model)));
    run->ranks.lasting = lag_take(&memory, model->nc);
    run->ranks.dependent = lag_take_flags(&memory, model->nc);
    run->ranks.estimate.lasting = run->ranks.lasting;
    run->block.initial = run->block.memory + run->block.numbers;
    if (lag_run_crosses(model, options)) {
        lag_singular_place(&run->ranks.singular, run, run->block.initial + (options->start != NULL ? lag_initial_memory(model) : 0));
    }
    lag_run_depend(run, model->redundant);
    lag_layout layout = {memory, 0};
    lay_instants(&run->instants, &run->guards, &run->motion, &run->projection, run->clock, &layout);
    memory += layout.count;
    set_instants(run);
    run->accuracy = (lag_accuracy){size, run->sizes.group, run->sizes.natural, run->sizes.cap, lag_take(&memory, size), 0.0};
    run->point = lag_take(&memory, size);
    run->block.p = lag_take(&memory, model->np);
    run->lost.x = lag_take(&memory, size);
    run->lost.t = (double)INFINITY;
    place_watch(run, model, &memory);
    lag_stiffness_place(&run->methods.stiffness, size, lag_take(&memory, lag_stiffness_memory(size)));
    run->half.pending = lag_take(&memory, lag_guard_count(model));
    run->half.waiting = lag_take(&memory, lag_guard_count(model));
    run->u_before = lag_take(&memory, model->nu);
    lag_turns_place(&run->turns, model, lag_take(&memory, lag_turns_memory(model)));
    return run;
}

void lag_run_tell(const lag_run *run, lag_run_report *report)
{
    const lag_stepper *s = &run->stepper;
    *report = (lag_run_report){
        .t = s->t,
        .h = s->h,
        .trouble_time = s->trouble.time,
        .x = s->x,
        .row = run->counts.row,
        .steps = run->counts.steps,
        .counts = s->counts,
        .projections = run->projection.count,
        .events = run->counts.events,
        .changes = run->methods.changes,
        .w = run->motion.w,
        .changed = run->guards.changed,
        .guilty = run->instants.discretes.guilty,
        .doubted = run->guards.doubted,
        .fault = run->instants.clauses.fault,
        .next = lag_instants_next(&run->instants),
        .change = run->methods.change,
        .implicit = s->method->implicit,
    };
}

/* ---- another filling of the same equations ---- */

static int alike(const lag_model *a, const lag_model *b)
{
    return a->version == b->version && a->nq == b->nq && a->nz == b->nz && a->nu == b->nu && a->nw == b->nw && a->np == b->np &&
        a->nc == b->nc && a->ny == b->ny && a->ni == b->ni && a->na == b->na && a->nk == b->nk && a->nindicator == b->nindicator &&
        a->ncontact == b->ncontact && a->ngap == b->ngap && a->nclock == b->nclock && a->nreset == b->nreset &&
        a->nfriction == b->nfriction && a->nslip == b->nslip && a->nload == b->nload &&
        a->ncorner == b->ncorner && a->nway == b->nway && a->nturn == b->nturn && a->ndelay == b->ndelay && a->ncollision == b->ncollision && a->nstop == b->nstop && a->nfail == b->nfail;
}

lag_status lag_run_change(lag_run *run, const lag_model *model, double *workspace)
{
    lag_motion *motion = &run->motion;
    if (!alike(motion->model, model)) {
        return LAG_BAD_STATE_DATA;
    }
    motion->model = model;
    run->ranks.estimate.model = model; /* the one before need not live any longer */
    motion->at.context = model->context;
    motion->at.workspace = workspace;
    return motion->at.p != NULL ? lag_motion_prepare(motion) : LAG_OK;
}
