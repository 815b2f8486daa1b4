/* Everything in a run that is no pointer, and the few pointers that change, as numbers. */
#include "lag/serialization.h"

#include <string.h>

#include "lag/methods/radau.h"

/* Of FNV-1a. */
static const unsigned long long BASIS = 14695981039346656037ULL;
static const unsigned long long PRIME = 1099511628211ULL;
static const size_t WORD = sizeof(unsigned long long);

#define RECORD(member) lag_record_bytes(record, &(member), sizeof(member))

/* Index of the method; `count` if it is not among them. */
static size_t place_of(const lag_method *const *methods, size_t count, const lag_method *method)
{
    size_t i = 0;
    while (i < count && methods[i] != method) {
        ++i;
    }
    return i;
}

static void record_method(const lag_run *run, const lag_method **method, lag_record *record)
{
    const lag_method *const methods[] = {
        NULL, run->options.method, &lag_dop853, &lag_radau, &lag_radau5, &lag_radau9, &lag_radau13, &lag_collocation};
    const size_t count = sizeof methods / sizeof *methods;
    size_t which = place_of(methods, count, *method);
    RECORD(which);
    if (record->saved != NULL) {
        *method = methods[which < count ? which : 0];
    }
}

static void record_parameters(lag_run *run, lag_record *record)
{
    lag_arguments *at = &run->motion.at;
    int prepared = at->p != NULL;
    RECORD(prepared);
    if (record->saved != NULL && !prepared) {
        at->p = NULL;
    } else if (record->saved != NULL && at->p == NULL) {
        at->p = run->options.p != NULL ? run->options.p : run->motion.model->defaults;
    }
}

static void record_stepper(lag_stepper *s, lag_record *record)
{
    RECORD(s->t);
    RECORD(s->t_before);
    RECORD(s->h);
    RECORD(s->h_least);
    RECORD(s->h_most);
    RECORD(s->last.error);
    RECORD(s->last.h);
    RECORD(s->last.urge);
    RECORD(s->last.dense_ready);
    RECORD(s->counts.evaluations);
    RECORD(s->counts.jacobians);
    RECORD(s->counts.decompositions);
    RECORD(s->counts.directions);
    RECORD(s->counts.steps);
    RECORD(s->counts.rejections);
    RECORD(s->trouble.status);
    RECORD(s->trouble.time);
}

static void record_clock(lag_clock *clock, lag_record *record)
{
    RECORD(clock->first);
    RECORD(clock->period);
    RECORD(clock->next);
    RECORD(clock->first_part);
    RECORD(clock->period_part);
    RECORD(clock->denominator);
}

static void record_crowd(lag_crowd *crowd, lag_record *record)
{
    RECORD(crowd->last);
    RECORD(crowd->interval);
    RECORD(crowd->first);
    RECORD(crowd->ratio);
    RECORD(crowd->shrinking);
    RECORD(crowd->dense);
}

static void record_instants(lag_instants *instants, lag_record *record)
{
    RECORD(instants->contacts.length);
    RECORD(instants->contacts.flight);
    RECORD(instants->timed.length);
    RECORD(instants->timed.next);
    RECORD(instants->timed.shown);
    RECORD(instants->instant.moment);
    RECORD(instants->clauses.stopped);
    RECORD(instants->clauses.fault);
    record_crowd(&instants->crowd, record);
    record_crowd(&instants->resets, record);
}

static void record_rest(lag_run *run, lag_record *record)
{
    RECORD(run->motion.coordinate);
    RECORD(run->motion.until);
    RECORD(run->projection.count);
    RECORD(run->accuracy.relative);
    RECORD(run->ranks.estimate.most);
    RECORD(run->ranks.estimate.rank);
    RECORD(run->ranks.estimate.margin);
    RECORD(run->ranks.estimate.known.margin);
    RECORD(run->ranks.estimate.known.least);
    RECORD(run->ranks.singular.distance);
    RECORD(run->ranks.singular.margin);
    RECORD(run->conditions.begun);
    RECORD(run->counts.begun);
    RECORD(run->methods.stiffness.signs);
    RECORD(run->methods.stiffness.wait);
    RECORD(run->methods.stiffness.needed);
    RECORD(run->methods.stiffness.question);
    RECORD(run->methods.stiffness.t);
    RECORD(run->methods.stiffness.before);
    RECORD(run->methods.stiffness.progress);
    RECORD(run->methods.stiffness.spent);
    RECORD(run->methods.stiffness.visit);
    RECORD(run->methods.stiffness.visited);
    RECORD(run->methods.stiffness.looks);
    RECORD(run->methods.stiffness.lost);
    RECORD(run->guards.corners.reach);
    RECORD(run->guards.pieces.reach);
    RECORD(run->guards.pieces.limit);
    RECORD(run->sizes.found);
    RECORD(run->motion.delays.pieces.first);
    RECORD(run->motion.delays.pieces.count);
    RECORD(run->motion.delays.pieces.level);
    RECORD(run->motion.delays.pieces.length);
    RECORD(run->motion.delays.direct);
    RECORD(run->counts.row);
    RECORD(run->counts.steps);
    RECORD(run->counts.events);
    RECORD(run->counts.entered);
    RECORD(run->methods.changes);
    RECORD(run->half.open);
    RECORD(run->half.own);
    RECORD(run->half.corner);
    RECORD(run->half.t);
    RECORD(run->half.length);
    RECORD(run->half.next);
    RECORD(run->half.left);
    for (size_t i = 0; i < LAG_CHANGES; ++i) {
        RECORD(run->methods.change[i].t);
        RECORD(run->methods.change[i].implicit);
    }
}

/* All but what there are several of. */
static void record_members(lag_run *run, lag_record *record)
{
    record_method(run, &run->stepper.method, record);
    record_method(run, &run->ranks.behind, record);
    record_parameters(run, record);
    record_stepper(&run->stepper, record);
    record_clock(&run->pace, record);
    record_instants(&run->instants, record);
    record_rest(run, record);
}

void lag_run_record(lag_run *run, lag_record *record)
{
    const lag_model *model = run->motion.model;
    lag_rank_estimate_clear(&run->ranks.estimate);
    record_members(run, record);
    for (size_t i = 0; i < model->nclock; ++i) {
        record_clock(&run->clock[i], record);
    }
    double *first = run->motion.memory; /* behind the workspace that the run was laid out with */
    lag_record_doubles(record, run->block.numbers - (size_t)(first - run->block.memory), first);
}

/* ---- around it ---- */

static unsigned long long mixed(unsigned long long sum, unsigned long long word)
{
    sum = (sum ^ word) * PRIME;
    return sum ^ (sum >> 32);
}

unsigned long long lag_record_sum(const unsigned char *bytes, size_t count)
{
    unsigned long long sum = mixed(BASIS, count);
    unsigned long long word = 0;
    size_t i = 0;
    for (; i + WORD <= count; i += WORD) {
        memcpy(&word, bytes + i, WORD);
        sum = mixed(sum, word);
    }
    word = 0;
    memcpy(&word, bytes + i, count - i);
    return mixed(sum, word);
}

/* Doubles of a run that are saved. */
static size_t remembered(const lag_model *model)
{
    return lag_run_numbers(model) - model->workspace;
}

unsigned long long lag_run_signature(const lag_model *model, const lag_run_options *options)
{
    const size_t sizes[] = {model->nq, model->nz, model->nu, model->nw, model->np, model->nc, model->ni, model->na, model->nindicator, model->ncontact, model->ngap, model->nclock, model->nreset, model->nk,
        model->nfriction, model->nslip, model->nload, model->ndelay, options->count, remembered(model), sizeof(lag_run)};
    const double one = 1.0; /* how numbers are written */
    unsigned long long sum = mixed(lag_record_sum((const unsigned char *)&one, sizeof one), LAG_MODEL_VERSION);
    for (const char *letter = model->name; *letter != '\0'; ++letter) {
        sum = mixed(sum, (unsigned char)*letter);
    }
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; ++i) {
        sum = mixed(sum, sizes[i]);
    }
    return sum;
}

/* Header of the bytes: signature and checksum. */
typedef struct head {
    unsigned long long signature, sum;
} head;

size_t lag_run_saved_size(const lag_model *model, const lag_run_options *options)
{
    static const lag_run none; /* to be counted, nothing else */
    lag_record record = {NULL, NULL, sizeof(head)};
    lag_record clock = {NULL, NULL, 0};
    (void)options; /* none of them changes what is kept */
    record_members((lag_run *)&none, &record);
    record_clock((lag_clock *)&none.pace, &clock);
    return record.count + model->nclock * clock.count + remembered(model) * sizeof(double);
}

void lag_run_save(const lag_run *run, unsigned char *bytes)
{
    lag_record record = {bytes, NULL, sizeof(head)};
    head first = {lag_run_signature(run->motion.model, &run->options), 0};
    lag_run_record((lag_run *)run, &record); /* which writes to the bytes only */
    first.sum = lag_record_sum(bytes + sizeof first, record.count - sizeof first);
    memcpy(bytes, &first, sizeof first);
}

lag_status lag_run_load(lag_run *run, const unsigned char *bytes)
{
    lag_record record = {NULL, bytes, sizeof(head)};
    head first;
    const size_t size = lag_run_saved_size(run->motion.model, &run->options);
    memcpy(&first, bytes, sizeof first);
    if (first.signature != lag_run_signature(run->motion.model, &run->options) ||
        first.sum != lag_record_sum(bytes + sizeof first, size - sizeof first)) {
        return LAG_BAD_STATE_DATA;
    }
    lag_run_record(run, &record);
    return run->motion.at.p != NULL ? lag_motion_prepare(&run->motion) : LAG_OK;
}
