#include "lag/session.h"

#include <string.h>

#include "lag/linalg/arena.h"
#include "lag/sensitivities/run_sensitivities.h"

/* Derivatives of the motion; without a block there are none. */
typedef struct derivatives {
    void *block;
    size_t bytes, count;
    const unsigned *which;
    const char **by;    /* (count) names */
    double *rows, *told; /* (count, width) as the run has them and as rows of results */
    lag_run_sensitivities *along;
} derivatives;

struct lag_session {
    const lag_model *model;
    const lag_start *start;
    double tolerance, length;
    void *block; /* of the run */
    lag_run *run;
    lag_results results;
    double *p, *u;
    double *lasting; /* (nc) */
    derivatives derivatives;
    double events[1 + 3 * LAG_SESSION_EVENTS];
};

/* Notes what happens; its context is the session. */
static lag_status keep_event(void *context, lag_run *run, const lag_event_notice *notice)
{
    lag_session *session = context;
    (void)run;
    if (notice->what == LAG_BEFORE || notice->what == LAG_AFTER) {
        return LAG_OK;
    }
    if (session->events[0] < LAG_SESSION_EVENTS) {
        double *event = session->events + 1 + 3 * (size_t)session->events[0];
        event[0] = notice->t;
        event[1] = (double)notice->what;
        event[2] = (double)notice->which;
        session->events[0] += 1.0;
    }
    return LAG_OK;
}

/* Number of lasting rows that are independent in general. */
static size_t independent(const lag_session *session)
{
    const unsigned char *redundant = session->model->redundant;
    size_t count = 0;
    for (size_t i = 0; i < session->model->nc; ++i) {
        count += session->lasting[i] != 0.0 && !(redundant != NULL && redundant[i]);
    }
    return count;
}

static lag_run_options plan(lag_session *session)
{
    return (lag_run_options){
        .tolerance = session->tolerance,
        .length = session->length,
        .start = session->start,
        .careful = 2,
        .callbacks = {.context = session, .tell = keep_event},
        .p = session->p,
        .u = session->u,
        .lasting = {session->lasting, session->lasting != NULL ? independent(session) : 0}
    };
}

static size_t numbers(const lag_model *model)
{
    return lag_results_width(model) + model->np + model->nu + model->nc + 3;
}

size_t lag_session_size(const lag_model *model, const lag_start *start)
{
    lag_session session = {.model = model, .start = start};
    const lag_run_options options = plan(&session);
    return lag_padded(sizeof session) + lag_padded(numbers(model) * sizeof(double)) + lag_run_size(model, &options);
}

/* Rows of contacts and of dry friction come and go. */
static void find_lasting(lag_session *session)
{
    lag_fill(session->model->nc, 1.0, session->lasting);
    for (size_t i = 0; i < session->model->ncontact; ++i) {
        session->lasting[session->model->contact_rows[i]] = 0.0;
    }
    for (size_t i = 0; i < session->model->nslip; ++i) {
        session->lasting[session->model->friction_rows[i]] = 0.0;
    }
}

/* A run that has not begun. */
static void renew(lag_session *session)
{
    const lag_run_options options = plan(session);
    session->run = lag_run_place(session->block, session->model, &options);
}

/* Start values may depend on parameters; inputs are what the model says without them. */
static void find_default_inputs(lag_session *session)
{
    lag_motion *motion = &session->run->motion;
    const double t = session->start != NULL ? session->start->t : 0.0;
    if (lag_motion_parameters(motion, session->p) == LAG_OK && lag_motion_start(motion, t, session->run->point) == LAG_OK) {
        memcpy(session->u, motion->u, session->model->nu * sizeof(double));
    }
}

lag_session *lag_session_place(void *block, const lag_model *model, const lag_start *start, double tolerance, double length)
{
    char *bytes = block;
    lag_session *session = block;
    double *memory = (double *)(void *)(bytes + lag_padded(sizeof *session));
    memset(block, 0, lag_padded(sizeof *session) + lag_padded(numbers(model) * sizeof(double)));
    session->model = model;
    session->start = start;
    session->tolerance = tolerance;
    session->length = length;
    session->block = bytes + lag_padded(sizeof *session) + lag_padded(numbers(model) * sizeof(double));
    session->results.most_rows = session->results.most_notes = 1;
    session->results.rows = lag_take(&memory, lag_results_width(model));
    session->p = lag_take(&memory, model->np + 1);
    session->u = lag_take(&memory, model->nu + 1);
    session->lasting = lag_take(&memory, model->nc + 1);
    find_lasting(session);
    if (model->np > 0) {
        memcpy(session->p, model->defaults, model->np * sizeof(double));
    }
    renew(session);
    if (model->nu > 0) {
        find_default_inputs(session);
    }
    return session;
}

double *lag_session_parameters(lag_session *session)
{
    return session->p;
}

double *lag_session_inputs(lag_session *session)
{
    return session->u;
}

double *lag_session_lasting(lag_session *session)
{
    return session->lasting;
}

static size_t names_and_rows(const lag_model *model, size_t count)
{
    const size_t doubles = count * (lag_sensitivities_width(model) + lag_results_width(model));
    return lag_padded(count * sizeof(char *)) + lag_padded(doubles * sizeof(double));
}

size_t lag_session_sensitivities_size(const lag_model *model, size_t count)
{
    return names_and_rows(model, count) + lag_run_sensitivities_size(model, count);
}

void lag_session_differentiate(lag_session *session, void *block, size_t count, const unsigned *which)
{
    session->derivatives = (derivatives){.block = block, .count = count, .which = which};
    session->derivatives.bytes = lag_session_sensitivities_size(session->model, count);
}

/* The block anew: nothing of an earlier motion is in it. */
static void place_derivatives(lag_session *session)
{
    const lag_model *model = session->model;
    derivatives *d = &session->derivatives;
    char *bytes = d->block;
    memset(d->block, 0, d->bytes);
    d->by = d->block;
    for (size_t k = 0; k < d->count; ++k) {
        const size_t number = d->which[k];
        d->by[k] = number < model->np ? model->parameters[number].name : model->inputs[number - model->np].name;
    }
    d->rows = (double *)(void *)(bytes + lag_padded(d->count * sizeof(char *)));
    d->told = d->rows + d->count * lag_sensitivities_width(model);
    d->along = lag_run_sensitivities_place(bytes + names_and_rows(model, d->count), model, d->count, d->by, NULL);
}

const double *lag_session_derivatives(lag_session *session)
{
    lag_run *run = session->run;
    const derivatives *d = &session->derivatives;
    const size_t from = lag_sensitivities_width(session->model);
    const size_t to = lag_results_width(session->model);
    if (d->along == NULL || lag_run_sensitivities_get(d->along, run, run->stepper.t, run->stepper.x, d->rows) != LAG_OK) {
        return NULL;
    }
    for (size_t k = 0; k < d->count; ++k) {
        memcpy(d->told + k * to + 1, d->rows + k * from, from * sizeof(double));
    }
    return d->told;
}

lag_status lag_session_begin(lag_session *session, double t)
{
    renew(session);
    session->events[0] = 0.0;
    if (session->derivatives.block == NULL) {
        return lag_run_begin(session->run, t, NULL);
    }
    place_derivatives(session);
    return lag_run_sensitivities_begin(session->derivatives.along, session->run, t, NULL, NULL);
}

lag_status lag_session_to(lag_session *session, double t, size_t most_steps)
{
    session->events[0] = 0.0;
    return lag_run_to(session->run, t, most_steps);
}

const double *lag_session_events(const lag_session *session)
{
    return session->events;
}

int lag_session_fault(lag_session *session, lag_status status)
{
    lag_fault fault;
    if (status == LAG_EVENT_ITERATION_FAILED || status == LAG_CHATTER || status == LAG_PENETRATION || status == LAG_WAY_JUMP) {
        return -1;
    }
    lag_run_explain(session->run, status, &fault);
    return (int)fault.which;
}

const double *lag_session_guilty(const lag_session *session)
{
    lag_run_report report;
    lag_run_tell(session->run, &report);
    return report.guilty;
}

const double *lag_session_row(lag_session *session)
{
    lag_run *run = session->run;
    session->results.row = 0;
    (void)lag_results_row(&session->results, run, run->stepper.t, run->stepper.x);
    return session->results.rows;
}

size_t lag_session_width(const lag_session *session)
{
    return lag_results_width(session->model);
}
