#include "lag/run/turns.h"

#include <math.h>
#include <string.h>

#include "lag/linalg/arena.h"
#include "lag/run.h"

/* Parts of a turn: on shorter ways the nearest value is the right one; */
static const double SHORT = 1.0 / 6.0;
/* on longer ones the mean of both rates tells the way, where it is that near to a value that the model allows, */
static const double NEAR = 1.0 / 16.0;
/* and where both rates lead as far, up to this part, over a piece of this part of the way. */
static const double STEADY = 1.0 / 8.0;
/* A quaternion turns less than this in one piece. */
static const double SMALL = 0.25;
/* A piece is halved so often at most. */
enum { MOST_HALVES = 30, QUATERNION = 4 };

size_t lag_turns_memory(const lag_model *model)
{
    return model->nturn > 0 ? 1 + 6 * model->nturn + model->ny + lag_motion_size(model) : 0;
}

void lag_turns_place(lag_turns *turns, const lag_model *model, double *memory)
{
    const size_t n = model->nturn;
    memset(turns, 0, sizeof *turns);
    if (n == 0) {
        return;
    }
    turns->at = lag_take(&memory, 1);
    turns->value = lag_take(&memory, n);
    turns->rate = lag_take(&memory, n);
    turns->now = lag_take(&memory, n);
    turns->pace = lag_take(&memory, n);
    turns->size = lag_take(&memory, n);
    turns->entry = lag_take(&memory, n);
    turns->counted = lag_take(&memory, model->ny);
    turns->inside = memory;
    lag_fill(model->ny, 0.0, turns->counted);
    lag_turns_clear(turns);
}

void lag_turns_clear(lag_turns *turns)
{
    if (turns->at != NULL) {
        *turns->at = (double)NAN;
    }
}

static lag_status evaluate(lag_run *run, double t, const double *x)
{
    lag_turns *turns = &run->turns;
    lag_motion_set_state(&run->motion, t, x);
    return run->motion.model->turn(&run->motion.at, turns->now, turns->pace, turns->size, turns->entry);
}

/* The parts of a quaternion on the side on which it was; their rates, too. */
static void align_quaternion(size_t first, const double *before, const double *entry, double *parts, double *rates)
{
    double along = 0.0;
    for (size_t k = 0; k < QUATERNION; ++k) {
        const size_t place = entry != NULL ? (size_t)entry[first + k] : first + k;
        along += parts[place] * before[first + k];
    }
    for (size_t k = 0; k < QUATERNION && along < 0.0; ++k) {
        const size_t place = entry != NULL ? (size_t)entry[first + k] : first + k;
        parts[place] = -parts[place];
        if (rates != NULL) {
            rates[place] = -rates[place];
        }
    }
}

/* The value that differs by whole turns and is nearest to the expected one. */
static double nearest(double value, double expected, double turn)
{
    const double turned = turn * nearbyint((expected - value) / turn);
    return isfinite(turned) ? value + turned : value;
}

/* The values of now as they continue those before over the time h; 0: that is not certain over so long a piece of the whole way. */
static int is_continued(lag_turns *turns, size_t n, double h, double whole)
{
    int certain = 1;
    for (size_t i = 0; i < n; ++i) {
        if (turns->size[i] == 0.0) {
            align_quaternion(i, turns->value, NULL, turns->now, turns->pace);
            for (size_t end = i + QUATERNION; i < end; ++i) {
                certain = certain && !(h * fmax(fabs(turns->rate[i]), fabs(turns->pace[i])) > SMALL);
            }
            --i;
            continue;
        }
        const double turn = turns->size[i];
        const double expected = turns->value[i] + 0.5 * h * (turns->rate[i] + turns->pace[i]);
        turns->now[i] = nearest(turns->now[i], isfinite(expected) ? expected : turns->value[i], turn);
        const int brief = !(h * fmax(fabs(turns->rate[i]), fabs(turns->pace[i])) > SHORT * turn);
        const int steady = h * fabs(turns->rate[i] - turns->pace[i]) <= STEADY * turn && fabs(turns->now[i] - expected) <= NEAR * turn;
        certain = certain && (brief || (steady && h <= STEADY * whole));
    }
    return certain;
}

/* Values that are no numbers now stay as they were. */
static void take(lag_turns *turns, size_t n, double t)
{
    for (size_t i = 0; i < n; ++i) {
        turns->value[i] = isfinite(turns->now[i]) || !isfinite(turns->value[i]) ? turns->now[i] : turns->value[i];
        turns->rate[i] = isfinite(turns->pace[i]) ? turns->pace[i] : 0.0;
    }
    *turns->at = t;
}

static void flag_counted(lag_turns *turns, size_t n)
{
    for (size_t i = 0; i < n; ++i) {
        turns->counted[(size_t)turns->entry[i]] = 1.0;
    }
}

/* The model at a time on the way to (t, x). */
static lag_status evaluate_at(lag_run *run, double time, double t, const double *x)
{
    if (time == t) {
        return evaluate(run, t, x);
    }
    const lag_status status = lag_stepper_dense(&run->stepper, time, run->turns.inside);
    return status == LAG_OK ? evaluate(run, time, run->turns.inside) : status;
}

lag_status lag_run_count_turns(lag_run *run, double t, const double *x)
{
    lag_turns *turns = &run->turns;
    const lag_stepper *s = &run->stepper;
    const size_t n = run->motion.model->nturn;
    if (n == 0) {
        return LAG_OK;
    }
    const double begin = *turns->at;
    if (!(t > begin)) { /* the first state, another one, or what an event made of it */
        const lag_status status = evaluate(run, t, x);
        if (status == LAG_OK) {
            (void)(isfinite(begin) && is_continued(turns, n, 0.0, 0.0));
            take(turns, n, t);
            flag_counted(turns, n);
        }
        return status;
    }
    const int known = begin >= s->t_before && t <= s->t; /* the states between are known */
    double piece = t - begin;
    while (*turns->at < t) {
        const double from = *turns->at;
        int certain = 0;
        for (int k = 0; k <= MOST_HALVES && !certain; ++k, piece *= 0.5) {
            const double to = from + piece < t - 1e-3 * piece ? from + piece : t;
            const lag_status status = evaluate_at(run, to, t, x);
            if (status != LAG_OK) {
                return status;
            }
            certain = is_continued(turns, n, to - from, t - begin) || !known || k == MOST_HALVES;
            if (certain) {
                take(turns, n, to);
            }
        }
        piece *= 4.0; /* twice what was certain */
    }
    return LAG_OK;
}

lag_status lag_run_count_step(lag_run *run)
{
    const double t = run->half.t;
    if (run->motion.model->nturn > 0 && *run->turns.at == t) { /* rows were wanted */
        return LAG_OK;
    }
    if (run->motion.model->nturn == 0 || t == run->stepper.t) {
        return lag_run_count_turns(run, t, run->stepper.x);
    }
    const lag_status status = lag_stepper_dense(&run->stepper, t, run->point);
    return status == LAG_OK ? lag_run_count_turns(run, t, run->point) : status;
}

void lag_run_unwind(const lag_run *run, double *outputs)
{
    const lag_turns *turns = &run->turns;
    for (size_t i = 0; turns->at != NULL && isfinite(*turns->at) && i < run->motion.model->nturn; ++i) {
        if (turns->size[i] == 0.0) {
            align_quaternion(i, turns->value, turns->entry, outputs, NULL);
            i += QUATERNION - 1;
        } else {
            double *output = outputs + (size_t)turns->entry[i];
            *output = nearest(*output, turns->value[i], turns->size[i]);
        }
    }
}
