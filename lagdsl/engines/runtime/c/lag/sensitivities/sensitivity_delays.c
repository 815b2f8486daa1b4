/*
 * Columns of delayed values. With y(t) delayed by T the column of what is read at time t is
 *
 *     d = sigma(t - T) - y'(t - T) dT ,    sigma = dy/da at a fixed time ,
 *
 * and sigma has a past as y has: polynomials piece by piece (lag/delays/pieces.h), beside them dtau of the instant at which a piece begins. Where a jump of y
 * comes back, at its time behind by T, dtau is that of the jump and dT together.
 */
#include <math.h>
#include <string.h>

#include "lag/linalg/arena.h"
#include "lag/linalg/vector.h"
#include "lag/run.h"
#include "lag/sensitivities/sensitivities.h"

/* The shortest piece is this part of a step: where a delay moves, columns have the slopes of pieces in them, which are less exact than the pieces. */
enum { PARTS = 8 };

size_t lag_columns_past_memory(const lag_model *model, size_t count)
{
    const size_t n = (model->ndelay + 1) * count;
    return model->ndelay == 0 ? 0 :
        lag_delay_pieces_memory(n) + count * (1 + model->ndelay) + lag_motion_size(model) + 3 * model->ndelay;
}

void lag_columns_past_place(lag_columns_past *past, const lag_model *model, size_t count, double *memory)
{
    if (model->ndelay == 0) {
        return;
    }
    past->moved = lag_take(&memory, count);
    past->delays = lag_take(&memory, count * model->ndelay);
    past->state = lag_take(&memory, lag_motion_size(model));
    past->values = lag_take(&memory, model->ndelay);
    past->derivative = lag_take(&memory, model->ndelay);
    past->times = lag_take(&memory, model->ndelay);
    lag_delay_pieces_place(&past->pieces, (model->ndelay + 1) * count, memory);
}

/* Number of what is remembered of delay i along column k; behind all delays there is dtau. */
static size_t place_of(const lag_sensitivities *s, size_t i, size_t k)
{
    return i * s->of.count + k;
}

/* ---- the present ---- */

void lag_columns_set_delays(lag_sensitivities *s, lag_run *run, double t)
{
    const lag_delays *delays = &run->motion.delays;
    const lag_delay_pieces *pieces = &s->past.pieces;
    const lag_model *model = run->motion.model;
    if (model->ndelay == 0 || pieces->count == 0) {
        return;
    }
    const lag_places places = lag_places_of(model);
    for (size_t i = 0; i < model->ndelay; ++i) {
        const double at = t - delays->time[i];
        const size_t piece = lag_delays_piece(delays, pieces, i, at);
        const size_t of_run = lag_delays_piece(delays, &delays->pieces, i, at);
        double rate = 0.0;
        (void)lag_delay_value(&delays->pieces, of_run, i, at, &rate);
        const double bend = lag_delay_bend(&delays->pieces, of_run, i, at);
        for (size_t k = 0; k < s->of.count; ++k) {
            const double later = s->past.delays[place_of(s, i, k)];
            double slope = 0.0;
            const double value = lag_delay_value(pieces, piece, place_of(s, i, k), at, &slope) - rate * later;
            const double change = slope - bend * later;
            lag_columns_put(s, k, places.delay + i, 1, &value, s->columns.w, model->nw);
            lag_columns_put(s, k, places.delay_rate + i, 1, &change, s->columns.w, model->nw);
        }
    }
}

/* ---- the past ---- */

/* Derivatives (ndelay) of the expressions at time t and state x along one column, which stands with its discretes in work.one. */
static lag_status expressions_along(lag_sensitivities *s, lag_run *run, double t, const double *x)
{
    lag_motion *motion = &run->motion;
    const lag_model *model = motion->model;
    const size_t n = lag_motion_size(model);
    const lag_arguments at = motion->at;
    lag_inputs *const inputs = motion->inputs;
    void *const context = motion->context;
    const double *one = s->work.one;
    const double *w = one + lag_columns_variables(model);
    const lag_displacement along = {0.0, one, w, one + n, one + n + model->nu, NULL};
    const int moves = lag_any(model->np, along.p);
    s->differences.run = run;
    const double extent = lag_differences_extent(&s->differences, &along);
    const double by = extent > 0.0 ? lag_differences_step() / extent : 0.0;
    lag_status status = LAG_OK;
    lag_fill(model->ndelay, 0.0, s->past.derivative);
    memcpy(s->work.w, motion->w, model->nw * sizeof(double));
    memcpy(s->work.u, motion->u, model->nu * sizeof(double));
    memcpy(s->past.times, motion->delays.time, model->ndelay * sizeof(double));
    for (int k = -LAG_POINTS; k <= LAG_POINTS && by > 0.0 && status == LAG_OK; k += k == -1 ? 2 : 1) {
        memcpy(s->work.state, x, n * sizeof(double));
        lag_axpy(n, k * by, one, s->work.state);
        lag_axpy(model->nw, k * by, w, motion->w);
        lag_delays_displace(&motion->delays, w + motion->places.delay, k * by);
        lag_differences_shift(&s->differences, along.u, k * by);
        for (size_t i = 0; i < model->np && moves; ++i) {
            s->differences.p[i] = at.p[i] + k * by * along.p[i];
        }
        status = moves ? lag_motion_parameters(motion, s->differences.p) : LAG_OK;
        lag_motion_set_state(motion, t, s->work.state);
        status = status == LAG_OK ? lag_delays_evaluate(&motion->delays, s->past.values) : status;
        lag_axpy(model->ndelay, (k > 0 ? lag_sixth[k - 1] : -lag_sixth[-k - 1]) / by, s->past.values, s->past.derivative);
        lag_delays_displace(&motion->delays, NULL, 0.0);
        memcpy(motion->delays.time, s->past.times, model->ndelay * sizeof(double)); /* a moved delay is in the columns */
        motion->inputs = inputs;
        motion->context = context;
        memcpy(motion->w, s->work.w, model->nw * sizeof(double));
        memcpy(motion->u, s->work.u, model->nu * sizeof(double));
    }
    const lag_status back = moves ? lag_motion_parameters(motion, at.p) : LAG_OK;
    return status != LAG_OK ? status : back;
}

/* The derivatives of all expressions along all columns at time t in the last step, and dtau of where it began, into `values`. */
static lag_status sample_columns(lag_sensitivities *s, lag_run *run, double t, double *values)
{
    const lag_stepper *stepper = &run->stepper;
    const lag_model *model = run->motion.model;
    const size_t variables = lag_columns_variables(model);
    const size_t lanes = s->columns.lanes;
    const double inside = fmin(fmax(t, stepper->t_before), stepper->t);
    lag_status status = LAG_OK;
    for (size_t block = 0; block < s->columns.blocks && status == LAG_OK; ++block) {
        double *found = s->columns.inside + block * variables * lanes;
        memcpy(found, s->columns.x + block * variables * lanes, variables * lag_columns_lanes(s, block) * sizeof(double));
        status = lag_columns_dense(s, run, block, inside, found);
        if (block == 0 && status == LAG_OK) {
            status = lag_stepper_dense(&run->stepper, inside, s->past.state);
            lag_columns_set_delays(s, run, t);
        }
        for (size_t k = block * lanes; k < (block + 1) * lanes && k < s->of.count && status == LAG_OK; ++k) {
            lag_columns_get(s, k, 0, variables, s->columns.inside, variables, s->work.one);
            lag_columns_get(s, k, 0, model->nw, s->columns.w, model->nw, s->work.one + variables);
            status = expressions_along(s, run, t, s->past.state);
            for (size_t i = 0; i < model->ndelay; ++i) {
                values[place_of(s, i, k)] = s->past.derivative[i];
            }
            values[place_of(s, model->ndelay, k)] = s->past.moved[k];
        }
    }
    return status;
}

/* A change of order one counts as a column of that size. */
static void set_sizes(lag_sensitivities *s, const lag_run *run)
{
    const lag_delay_pieces *of_run = &run->motion.delays.pieces;
    for (size_t i = 0; i < of_run->n; ++i) {
        for (size_t k = 0; k < s->of.count; ++k) {
            double *size = &s->past.pieces.size[place_of(s, i, k)];
            *size = fmax(*size, s->columns.extent[k] * of_run->size[i]);
        }
    }
}

lag_status lag_columns_keep_past(lag_run *run, double t)
{
    lag_sensitivities *s = lag_sensitivities_of(run);
    lag_delay_pieces *pieces = &s->past.pieces;
    lag_status status = LAG_OK;
    if (run->motion.model->ndelay == 0 || pieces->count == 0) {
        return LAG_OK;
    }
    lag_delay_cut(pieces, run->stepper.t_before);
    pieces->level = s->past.happened ? 1 : pieces->level;
    pieces->length = run->motion.delays.pieces.length;
    set_sizes(s, run);
    double h = t - lag_delay_end(pieces);
    const double least = h / PARTS;
    while (status == LAG_OK && lag_delay_end(pieces) < t) {
        const double a = lag_delay_end(pieces);
        const double b = a + h * (1.0 + 1.0 / (2 * PARTS)) < t ? a + h : t;
        const double half = 0.5 * (b - a);
        for (size_t j = 0; j < LAG_DELAY_SAMPLES && status == LAG_OK; ++j) {
            status = sample_columns(s, run, j == 0 ? b : a + half * (1.0 + lag_delay_places[j]), pieces->sample + j * pieces->n);
        }
        if (status == LAG_OK && lag_delay_try(pieces, run->accuracy.relative, b) > 1.0 && half >= least && a + half > a) {
            h = half;
        } else if (status == LAG_OK) {
            status = lag_delay_add(pieces);
            h *= 2.0;
        }
    }
    s->past.happened = 0;
    return status;
}

/* The delays themselves. */
static lag_status delay_times(void *context, double *values)
{
    lag_run *run = context;
    lag_delays *delays = &run->motion.delays;
    lag_motion_set_state(&run->motion, run->stepper.t, run->stepper.x);
    const lag_status status = lag_delays_evaluate(delays, delays->now);
    memcpy(values, delays->time, delays->pieces.n * sizeof(double));
    return status;
}

lag_status lag_columns_begin_past(lag_sensitivities *s, lag_run *run)
{
    lag_delay_pieces *pieces = &s->past.pieces;
    const lag_model *model = run->motion.model;
    const lag_places places = lag_places_of(model);
    const size_t n = lag_motion_size(model);
    const double t = run->stepper.t;
    lag_status status = LAG_OK;
    double error = 0.0;
    if (model->ndelay == 0) {
        return LAG_OK;
    }
    lag_differences_begin(&s->differences, run, s->scales, LAG_FINEST_STEP);
    lag_fill(model->ndelay, 1.0, s->instant.sizes);
    for (size_t k = 0; k < s->of.count && status == LAG_OK; ++k) {
        double *one = s->work.one;
        lag_columns_get(s, k, 0, lag_columns_variables(model), s->columns.x, lag_columns_variables(model), one);
        const lag_displacement along = {0.0, NULL, NULL, NULL, one + n + model->nu, NULL};
        status = lag_differences_along(&s->differences, &along, model->ndelay, s->instant.sizes, delay_times, run, s->past.derivative, &error);
        for (size_t i = 0; i < model->ndelay; ++i) {
            s->past.delays[place_of(s, i, k)] = s->past.derivative[i];
            for (size_t j = 0; j < LAG_DELAY_SAMPLES; ++j) {
                lag_columns_get(s, k, places.delay + i, 1, s->columns.w, model->nw, &pieces->sample[j * pieces->n + place_of(s, i, k)]);
                pieces->sample[j * pieces->n + place_of(s, model->ndelay, k)] = 0.0;
            }
        }
        s->past.moved[k] = 0.0;
    }
    lag_differences_end(&s->differences);
    pieces->first = pieces->count = 0;
    pieces->begin[0] = t - 2.0 * run->motion.delays.pieces.length;
    pieces->level = LAG_DELAY_SMOOTH;
    (void)lag_delay_try(pieces, 0.0, t);
    s->past.happened = 1;
    return status == LAG_OK ? lag_delay_add(pieces) : status;
}

/* ---- jumps that come back ---- */

int lag_columns_jumps_alone(const lag_run *run, const lag_cause *cause)
{
    const lag_instants *instants = &run->instants;
    const lag_model *model = run->motion.model;
    const double t = run->stepper.t;
    int waits = 0;
    for (size_t i = 0; i < model->ncontact; ++i) {
        waits = waits || instants->contacts.until[i] <= t;
    }
    return model->ndelay > 0 && cause->kind == LAG_CAUSE_TIME && cause->changed == NULL && !waits && instants->timed.next > t &&
        lag_clocks_due(model->nclock, instants->clocks.each, t) == model->nclock;
}

/* dtau of the jumps that come back now. */
static void find_times(lag_sensitivities *s, const lag_run *run)
{
    const lag_delays *delays = &run->motion.delays;
    const lag_delay_pieces *pieces = &s->past.pieces;
    const size_t n = delays->pieces.n;
    const double later = lag_timed_behind(&run->instants.timed, run->stepper.t);
    int any = 0;
    for (size_t i = 0; i < n; ++i) {
        if (!(delays->jumps.ahead[i] + delays->time[i] <= later)) {
            continue;
        }
        const size_t piece = lag_delay_piece(pieces, delays->jumps.ahead[i]);
        for (size_t k = 0; k < s->of.count; ++k) {
            double rate = 0.0;
            const double moved = lag_delay_value(pieces, piece, place_of(s, n, k), delays->jumps.ahead[i], &rate) + s->past.delays[place_of(s, i, k)];
            if (any && fabs(moved - s->instant.time[k]) > sqrt(DBL_EPSILON) * fmax(fabs(moved), fabs(s->instant.time[k]))) {
                s->fault.one_sided += 1;
                s->fault.first = fmin(s->fault.first, run->stepper.t);
            }
            s->instant.time[k] = moved;
        }
        any = 1;
    }
}

lag_status lag_columns_pass_jumps(lag_sensitivities *s, lag_run *run, const lag_cause *cause)
{
    const lag_model *model = run->motion.model;
    const lag_places places = lag_places_of(model);
    const size_t n = lag_motion_size(model);
    const size_t variables = lag_columns_variables(model);
    double *f = s->instant.f;
    memcpy(s->instant.w_after, run->motion.w, model->nw * sizeof(double));
    memcpy(s->past.state, run->stepper.x, n * sizeof(double));
    find_times(s, run);
    lag_status status = lag_run_carry(run, cause);
    if (status != LAG_OK) {
        return status;
    }
    const int same = lag_same(n, s->past.state, run->stepper.x) && lag_same(places.delay, s->instant.w_after, run->motion.w);
    status = run->motion.ode.rates(&run->motion, run->stepper.t, run->stepper.x, s->instant.f_after);
    lag_axpy(n, -1.0, s->instant.f_after, f);
    for (size_t k = 0; k < s->of.count && status == LAG_OK; ++k) {
        if (!same && s->instant.time[k] != 0.0) { /* it turns relations or blows */
            s->fault.t = run->stepper.t;
            s->fault.guard = k;
            return LAG_NOT_SMOOTH;
        }
        lag_columns_get(s, k, 0, n, s->columns.x, variables, s->work.one);
        lag_axpy(n, s->instant.time[k], f, s->work.one);
        lag_columns_put(s, k, 0, n, s->work.one, s->columns.x, variables);
    }
    return status;
}
