/* Relations in passes over clauses: as they stand, and what they are a moment later where they pass zero. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "lag/events/event_iteration.h"
#include "lag/linalg/arena.h"
#include "lag/linalg/vector.h"

/* A relation that passes zero within this part of the moment does so at the event. */
static const double PASSING = 1e-2;
/* So many times between resets in a row, each shorter than the one before, are a series. */
enum { SERIES = 2 };
/*
 * The top of a flight of time T that begins at speed v is v T/4. It is lost where the next event is as deep as this one. Where flights are a
 * small part of the run, an importer that has been exact so far loses one that is not above the depth by a large factor, about.
 */
static const double DEEP = 16.0;
static const double LOW = 1e4;
static const double SHORT = 1e-3;
/* A relation that starts at zero shows within this part of the experiment where it goes. */
static const double SOON = 1e-4;
/* Factor from one look ahead to the next. */
static const double LONGER = 16.0;

static lag_status indicate(lag_event_iteration *iteration, double t, const double *x, double *g)
{
    lag_event_iteration_solve(iteration->motion, t, x);
    return iteration->motion->model->indicator(&iteration->motion->at, g);
}

static int holds(const lag_model *model, size_t i, double g)
{
    return g > 0.0 || (g == 0.0 && model->strict[i] == 0);
}

lag_status lag_event_iteration_stand(lag_event_iteration *iteration, double t, const double *x)
{
    const lag_model *model = iteration->motion->model;
    const lag_status status = model->nindicator > 0 ? indicate(iteration, t, x, iteration->now) : LAG_OK;
    for (size_t i = 0; i < model->nindicator; ++i) {
        iteration->motion->w[iteration->places.relation + i] = holds(model, i, iteration->now[i]);
    }
    return status;
}

/* True if the event has not changed the state so far. */
static int is_same(const lag_event_iteration *iteration, const double *x)
{
    return lag_same(lag_motion_size(iteration->motion->model), x, iteration->from);
}

/* The state so much later, by its rates. */
static void go(lag_event_iteration *iteration, const double *x, double time)
{
    for (size_t i = 0; i < lag_motion_size(iteration->motion->model); ++i) {
        iteration->later[i] = x[i] + time * iteration->rate[i];
    }
}

/*
 * Accelerations are those in the middle of `lookahead`: where a body breaks away under a force that grows, round-off alone gives the one here,
 * or its difference from that of what the body lies on, a sign.
 */
static void take_middle(lag_event_iteration *iteration, double t, const double *x)
{
    lag_motion *motion = iteration->motion;
    const size_t n = motion->model->nq;
    const double half = iteration->lookahead / 2.0;
    go(iteration, x, half);
    if (motion->ode.rates(motion, t + half, iteration->later, iteration->middle) == LAG_OK) {
        memcpy(iteration->rate + n, iteration->middle + n, (lag_motion_size(motion->model) - n) * sizeof(double));
    }
}

void lag_event_iteration_move_on(lag_event_iteration *iteration, double t, const double *x)
{
    lag_motion *motion = iteration->motion;
    if (motion->ode.rates(motion, t, x, iteration->rate) == LAG_OK) {
        take_middle(iteration, t, x);
    } else {
        lag_fill(lag_motion_size(motion->model), 0.0, iteration->rate);
    }
    go(iteration, x, iteration->lookahead);
}

/* True if relation i passes zero here, by its values now and after `lookahead`. */
static int passing(const lag_event_iteration *iteration, size_t i)
{
    const double moved = fabs(iteration->then[i] - iteration->now[i]);
    return moved > iteration->noise->least[i] && fabs(iteration->now[i]) <= PASSING * moved;
}

/* True if relation i passes zero here, back to what it is not. */
static int turns_back(const lag_event_iteration *iteration, size_t i)
{
    const int truth = iteration->motion->w[iteration->places.relation + i] != 0.0;
    return passing(iteration, i) && holds(iteration->motion->model, i, iteration->then[i]) != truth;
}

/*
 * Relations that turn back, and whose change is clear of round-off in `soon`, are what they are then; those in `kept` (flags, or null) stay as they
 * are where it is not. Returns how many are left.
 */
static size_t accept(lag_event_iteration *iteration, const double *kept)
{
    size_t left = 0;
    for (size_t i = 0; i < iteration->motion->model->nindicator; ++i) {
        const int is_known = PASSING * fabs(iteration->soon[i] - iteration->now[i]) > iteration->noise->sigma[i];
        const int is_kept = kept != NULL && kept[i] != 0.0;
        if (turns_back(iteration, i) && is_known) {
            iteration->then[i] = iteration->soon[i];
        } else if (turns_back(iteration, i) && is_kept) {
            iteration->then[i] = -iteration->then[i];
        } else {
            left += (size_t)turns_back(iteration, i);
        }
    }
    return left;
}

static int any_turns_back(const lag_event_iteration *iteration)
{
    size_t i = 0;
    while (i < iteration->motion->model->nindicator && !turns_back(iteration, i)) {
        ++i;
    }
    return i < iteration->motion->model->nindicator;
}

/*
 * A relation that holds for a shorter time than `lookahead`, as a narrow `abs(x - a) < b`, seems to turn back at the event at which it turns: it is
 * looked at again after a time that is just long against round-off. It does not turn back where nothing has changed the state.
 */
static lag_status look_sooner(lag_event_iteration *iteration, double t, const double *x, const double *turned)
{
    const int kept = turned != NULL && is_same(iteration, x);
    lag_status status = LAG_OK;
    double after = iteration->moment;
    size_t left = after < iteration->lookahead && any_turns_back(iteration);
    if (left > 0) {
        lag_noise_find(iteration->noise, t, x);
    }
    while (left > 0 && after < iteration->lookahead && status == LAG_OK) {
        go(iteration, x, after);
        status = indicate(iteration, t + after, iteration->later, iteration->soon);
        left = status == LAG_OK ? accept(iteration, kept ? turned : NULL) : left;
        after *= LONGER;
    }
    return status;
}

static int is_flagged(const double *turned, size_t i)
{
    return turned != NULL && turned[i] != 0.0;
}

/* True if relation i has turned in this event: it was found to, or a pass has turned it. */
static int has_turned(const lag_event_iteration *iteration, const double *turned, size_t i)
{
    const size_t place = iteration->places.relation + i;
    return is_flagged(turned, i) || iteration->motion->w[place] != iteration->stood[place];
}

/*
 * True if relation i is what it is after `lookahead`: it passes zero, or is what it has turned to where it ends at zero itself, as `limit` and `min` do. One
 * that has turned in this event and does not move by more than round-off from then on has not passed it.
 */
static int is_later_one(const lag_event_iteration *iteration, const double *turned, size_t i)
{
    const int truth = iteration->motion->w[iteration->places.relation + i] != 0.0;
    const int is_zero = iteration->then[i] == 0.0 && iteration->now[i] != 0.0;
    const int ends = is_zero && holds(iteration->motion->model, i, 0.0) == truth;
    const int rests = fabs(iteration->then[i] - iteration->now[i]) <= iteration->noise->sigma[i];
    return (passing(iteration, i) && !(rests && has_turned(iteration, turned, i))) || (ends && is_flagged(turned, i));
}

/* True if relation i does not pass zero, and would turn, or has turned in this event, by a value that may be round-off. */
static int is_in_doubt(const lag_event_iteration *iteration, const double *turned, size_t i)
{
    const int truth = iteration->motion->w[iteration->places.relation + i] != 0.0;
    const double now = iteration->now[i];
    const int may_turn = now != 0.0 || iteration->noise->least[i] > 0.0;
    const int turns = may_turn && holds(iteration->motion->model, i, now) != truth;
    return (turns || has_turned(iteration, turned, i)) && !is_later_one(iteration, turned, i);
}

/* Round-off of the relations, and their values before the event into `half`, where one of them may be zero but for that. */
static void weigh(lag_event_iteration *iteration, double t, const double *x, const double *turned)
{
    const size_t count = iteration->motion->model->nindicator;
    size_t i = 0;
    while (i < count && !is_in_doubt(iteration, turned, i) && !(has_turned(iteration, turned, i) && turns_back(iteration, i))) {
        ++i;
    }
    if (i < count) {
        lag_noise_find(iteration->noise, t, x);
        lag_fill(count, (double)INFINITY, iteration->half);
        iteration->motion->at.w = iteration->stood;
        (void)indicate(iteration, t, iteration->from, iteration->half);
        iteration->motion->at.w = iteration->motion->w;
    }
}

/*
 * True if relation i stays what it is: its value is round-off and was so before the event, or it has turned in it and lies where it was found, which a
 * projection may have moved before zero. Values of discretes alone have no round-off.
 */
static int stays(const lag_event_iteration *iteration, const double *turned, size_t i)
{
    const double sigma = iteration->noise->sigma[i];
    const double now = iteration->now[i];
    const double was = iteration->half[i];
    const int turned_so = is_flagged(turned, i) || (sigma > DBL_MIN && has_turned(iteration, turned, i));
    const int is_round_off = fabs(now) <= sigma && (turned_so || fabs(was) <= sigma);
    return is_in_doubt(iteration, turned, i) && (is_round_off || (is_flagged(turned, i) && fabs(now - was) <= sigma));
}

lag_status lag_event_iteration_ahead(lag_event_iteration *iteration, double t, const double *x, const double *turned)
{
    lag_motion *motion = iteration->motion;
    const lag_model *model = motion->model;
    if (model->nindicator == 0) {
        return LAG_OK;
    }
    lag_event_iteration_move_on(iteration, t, x);
    lag_status status = indicate(iteration, t, x, iteration->now);
    if (status == LAG_OK) {
        status = indicate(iteration, t + iteration->lookahead, iteration->later, iteration->then);
    }
    status = status == LAG_OK ? look_sooner(iteration, t, x, turned) : status;
    if (status == LAG_OK) {
        weigh(iteration, t, x, turned);
    }
    for (size_t i = 0; i < model->nindicator; ++i) {
        const int is_later = is_later_one(iteration, turned, i);
        if (!stays(iteration, turned, i)) {
            motion->w[iteration->places.relation + i] = holds(model, i, is_later ? iteration->then[i] : iteration->now[i]);
        }
    }
    return status;
}

/*
 * Relations that are zero at the start, but for round-off, into `soon`: so long after it, with accelerations, that each has moved clearly, but a small
 * part of the experiment at most; zero for those that do not move, and for others.
 */
static void look_further(lag_event_iteration *iteration, double t, const double *x)
{
    const lag_model *model = iteration->motion->model;
    const double *sigma = iteration->noise->sigma;
    size_t left = 0;
    for (size_t i = 0; i < model->nindicator; ++i) {
        iteration->soon[i] = 0.0;
        left += fabs(iteration->now[i]) <= sigma[i];
    }
    for (double after = iteration->lookahead; left > 0 && after < SOON * iteration->contacts->length; after *= LONGER) {
        go(iteration, x, after);
        lag_axpy(model->nq, 0.5 * after * after, iteration->rate + model->nq, iteration->later);
        if (indicate(iteration, t + after, iteration->later, iteration->then) != LAG_OK) {
            return;
        }
        for (size_t i = 0; i < model->nindicator; ++i) {
            const int waits = fabs(iteration->now[i]) <= sigma[i] && iteration->soon[i] == 0.0;
            if (waits && fabs(iteration->then[i] - iteration->now[i]) > LAG_MOVES_CLEARLY * sigma[i]) {
                iteration->soon[i] = iteration->then[i];
                --left;
            }
        }
    }
}

lag_status lag_event_iteration_depart(lag_event_iteration *iteration, double t, double *x, double *turned)
{
    const lag_model *model = iteration->motion->model;
    const double *truth = iteration->motion->w + iteration->places.relation;
    if (model->nindicator == 0) {
        return LAG_OK;
    }
    lag_fill(model->nindicator, 0.0, turned);
    lag_event_iteration_move_on(iteration, t, x);
    lag_status status = indicate(iteration, t, x, iteration->now);
    if (status == LAG_OK) {
        lag_noise_find(iteration->noise, t, x);
    }
    look_further(iteration, t, x);
    for (size_t i = 0; i < model->nindicator && status == LAG_OK; ++i) {
        const double later = iteration->soon[i];
        int refracted = 0;
        int back = 0;
        turned[i] = later != 0.0 && (later > 0.0) != (truth[i] != 0.0);
        if (turned[i] != 0.0) {
            status = lag_event_iteration_cross(iteration, t, x, i, &refracted, &back);
        }
    }
    return status;
}

/*
 * A relation that is zero and waits, as it does not move clearly against its round-off within `lookahead`, moves slowly if it goes twice as far in twice the time:
 * 5 mm at 7000 km that close at 1 cm/s.
 */
static lag_status look_at_lines(lag_event_iteration *iteration, double t, const double *x)
{
    const double half = iteration->lookahead / 2.0;
    go(iteration, x, half);
    const lag_status status = indicate(iteration, t + half, iteration->later, iteration->half);
    for (size_t i = 0; i < iteration->motion->model->nindicator && status == LAG_OK; ++i) {
        const double moved = iteration->soon[i] - iteration->now[i];
        const double by_half = iteration->half[i] - iteration->now[i];
        if (iteration->truth[i] != 0.0 && iteration->then[i] == 0.0 && fabs(moved - 2.0 * by_half) < 0.5 * fabs(moved)) {
            iteration->then[i] = moved;
        }
    }
    return status;
}

/*
 * Values by which relations flagged in `turned` are judged, into `then`: the first one that has moved clearly after a short time, so that a narrow
 * `abs(x - a) < b` is seen; else the one now, zero where it is round-off.
 */
static lag_status look_where_they_go(lag_event_iteration *iteration, double t, const double *x, const double *turned)
{
    const size_t count = iteration->motion->model->nindicator;
    const double *sigma = iteration->noise->sigma;
    double *waits = iteration->truth;
    lag_status status = LAG_OK;
    for (size_t i = 0; i < count; ++i) {
        waits[i] = turned[i];
        iteration->then[i] = fabs(iteration->now[i]) <= sigma[i] ? 0.0 : iteration->now[i];
    }
    for (double after = iteration->moment; after < LONGER * iteration->lookahead && lag_any(count, waits) && status == LAG_OK; after *= LONGER) {
        go(iteration, x, fmin(after, iteration->lookahead));
        status = indicate(iteration, t + fmin(after, iteration->lookahead), iteration->later, iteration->soon);
        for (size_t i = 0; i < count && status == LAG_OK; ++i) {
            if (waits[i] != 0.0 && PASSING * fabs(iteration->soon[i] - iteration->now[i]) > fmax(sigma[i], fabs(iteration->now[i]))) {
                iteration->then[i] = iteration->soon[i];
                waits[i] = 0.0;
            }
        }
    }
    return status == LAG_OK && lag_any(count, waits) ? look_at_lines(iteration, t, x) : status;
}

lag_status lag_event_iteration_reach(lag_event_iteration *iteration, double t, const double *x, double *turned)
{
    const lag_model *model = iteration->motion->model;
    const double *truth = iteration->motion->w + iteration->places.relation;
    if (!lag_any(model->nindicator, turned)) {
        return LAG_OK;
    }
    lag_event_iteration_move_on(iteration, t, x);
    lag_status status = indicate(iteration, t, x, iteration->now);
    lag_noise_find(iteration->noise, t, x);
    status = status == LAG_OK ? look_where_they_go(iteration, t, x, turned) : status;
    for (size_t i = 0; i < model->nindicator && status == LAG_OK; ++i) {
        turned[i] = holds(model, i, iteration->then[i]) == (truth[i] != 0.0) ? 0.0 : turned[i];
    }
    return status;
}

lag_status lag_event_iteration_look_ahead(lag_event_iteration *iteration, double t, const double *x, double ahead)
{
    lag_event_iteration_move_on(iteration, t, x);
    go(iteration, x, ahead);
    const lag_status status = indicate(iteration, t + ahead, iteration->later, iteration->then);
    return status == LAG_OK ? indicate(iteration, t, x, iteration->now) : status;
}

/* True if a relation flagged in `turned`, which stands behind zero, comes back towards it too slowly: by less than `low` depths in a flight. */
static int is_too_deep(lag_event_iteration *iteration, double t, const double *x, const double *turned, double flight, double low)
{
    const lag_motion *motion = iteration->motion;
    const double *truth = motion->w + iteration->places.relation;
    const double *stood = iteration->stood + iteration->places.relation;
    int any = 0;
    const lag_status status = lag_event_iteration_look_ahead(iteration, t, x, iteration->moment);
    for (size_t i = 0; i < motion->model->nindicator && status == LAG_OK; ++i) {
        const double depth = fabs(iteration->now[i]);
        const double rise = (depth - (truth[i] != 0.0 ? iteration->then[i] : -iteration->then[i])) / iteration->moment;
        const int changed = turned[i] != 0.0 && truth[i] != stood[i];
        const int stands = changed && holds(motion->model, i, iteration->now[i]) == (truth[i] != 0.0);
        any = any || (stands && rise > 0.0 && rise * flight < low * depth);
    }
    return any;
}

int lag_event_iteration_sinks(
    lag_event_iteration *iteration, double t, const double *x, const double *turned, lag_crowd *resets, double length)
{
    if (!iteration->acted) {
        return 0;
    }
    const int crowds = lag_crowds(resets, t, length, 1);
    const double flight = resets->ratio * resets->interval;
    const double low = flight < SHORT * length ? LOW : DEEP;
    return crowds || (resets->shrinking >= SERIES && is_too_deep(iteration, t, x, turned, flight, low));
}
