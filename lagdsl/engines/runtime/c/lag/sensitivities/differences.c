#include "lag/sensitivities/differences.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "lag/linalg/arena.h"
#include "lag/linalg/vector.h"
#include "lag/run.h"
#include "lag/run/scan.h"

enum { ROUNDINGS = 64 };
const double lag_sixth[LAG_POINTS] = {45.0 / 60.0, -9.0 / 60.0, 1.0 / 60.0};

static size_t kept_bytes(const lag_model *model)
{
    return lag_padded(sizeof(lag_run)) + lag_padded(model->nclock * sizeof(lag_clock)) + lag_run_numbers(model) * sizeof(double);
}

size_t lag_differences_memory(const lag_model *model, size_t most)
{
    return kept_bytes(model) / sizeof(double) + 1 + model->np + (2 * LAG_POINTS + 2) * most;
}

void lag_differences_place(lag_differences *d, const lag_model *model, size_t most, double *memory)
{
    d->bytes = kept_bytes(model);
    d->kept = (unsigned char *)(void *)lag_take(&memory, d->bytes / sizeof(double) + 1);
    d->p = lag_take(&memory, model->np);
    for (int k = 0; k < LAG_POINTS; ++k) {
        d->value[k][0] = lag_take(&memory, most);
        d->value[k][1] = lag_take(&memory, most);
    }
    d->middle = lag_take(&memory, most);
    d->sixth = lag_take(&memory, most);
}

/* Copies the run, but for the past of delayed values, which stays as it is at an instant. */
static void copy(const lag_differences *d, unsigned char *to, const unsigned char *from)
{
    const lag_delay_pieces *pieces = &d->run->motion.delays.pieces;
    const size_t past = lag_delay_pieces_memory(pieces->n) * sizeof(double);
    const size_t first = past > 0 ? (size_t)((const unsigned char *)pieces->begin - (const unsigned char *)d->run) : d->bytes;
    memcpy(to, from, first);
    memcpy(to + first + past, from + first + past, d->bytes - first - past);
}

static void put_back(lag_differences *d)
{
    copy(d, (unsigned char *)d->run, d->kept);
    d->run->motion.at.p = d->p_here;
    (void)lag_motion_prepare(&d->run->motion); /* a workspace elsewhere is none of the memory that was kept */
}

void lag_differences_begin(lag_differences *d, lag_run *run, const double *p_sizes, double finest)
{
    d->run = run;
    d->finest = finest;
    d->p_here = run->motion.at.p;
    d->p_sizes = p_sizes;
    copy(d, d->kept, (const unsigned char *)run);
}

void lag_differences_end(lag_differences *d)
{
    put_back(d);
}

void lag_differences_restore(lag_differences *d)
{
    put_back(d);
    d->run->instants.listener.tell = NULL;
    d->run->options.results = NULL;
}

/* Inputs of the caller, shifted. */
static void shifted(void *context, double t, int before, double *u)
{
    const lag_differences *d = context;
    d->inputs(d->context, t, before, u);
    lag_axpy(d->run->motion.model->nu, d->by, d->u, u);
}

void lag_differences_shift(lag_differences *d, const double *u, double by)
{
    lag_motion *motion = &d->run->motion;
    if (u == NULL || !lag_any(motion->model->nu, u)) {
        return;
    }
    lag_axpy(motion->model->nu, by, u, motion->u);
    if (motion->inputs != NULL) {
        d->inputs = motion->inputs;
        d->context = motion->context;
        d->u = u;
        d->by = by;
        motion->inputs = shifted;
        motion->context = d;
    }
}

/*
 * Moves the present time, and what is scheduled for now with it. `behind`: it goes on by so much more, so that what time changes has changed there.
 */
static void displace_time(lag_run *run, double by, double behind)
{
    const lag_model *model = run->motion.model;
    const double here = run->stepper.t;
    const double t = here + by + (model->ndistance > 0 ? behind + LAG_SCAN_ULPS * DBL_EPSILON * fabs(here) : 0.0);
    for (size_t i = 0; i < model->nclock; ++i) {
        lag_clock *clock = &run->instants.clocks.each[i];
        if (lag_clock_is_due(clock, here)) {
            clock->first = t - (double)clock->next * clock->period;
            clock->denominator = 0.0;
        }
    }
    run->instants.timed.next = run->instants.timed.next <= here ? t : run->instants.timed.next;
    run->half.t = run->half.t == here ? t : run->half.t;
    run->stepper.t = t;
}

/* Moves the run along the direction, at one of the places of step h. */
static lag_status displace(lag_differences *d, const lag_displacement *along, double by, double h, double step)
{
    lag_run *run = d->run;
    const lag_model *model = run->motion.model;
    if (along->t != 0.0) { /* instants bend with the square of the displacement; even terms leave central differences as they are */
        const double places = by / h;
        displace_time(run, by * along->t, step * fabs(h * along->t) * places * places);
    }
    for (size_t i = 0; i < lag_motion_size(model) && along->x != NULL; ++i) {
        run->stepper.x[i] += by * along->x[i];
    }
    for (size_t i = 0; i < model->nw && along->w != NULL; ++i) {
        run->motion.w[i] += by * along->w[i];
    }
    if (along->w != NULL && model->ndelay > 0) {
        lag_delays_displace(&run->motion.delays, along->w + run->motion.places.delay, by);
    }
    lag_differences_shift(d, along->u, by);
    for (size_t i = 0; i < model->ncontact && along->until != NULL; ++i) {
        run->instants.contacts.until[i] += by * along->until[i];
    }
    if (along->p == NULL || !lag_any(model->np, along->p)) {
        return LAG_OK;
    }
    for (size_t i = 0; i < model->np; ++i) {
        d->p[i] = d->p_here[i] + by * along->p[i];
    }
    return lag_motion_parameters(&run->motion, d->p);
}

static double largest_part(size_t count, const double *x, const double *sizes, double most)
{
    for (size_t i = 0; i < count && x != NULL; ++i) {
        const double size = sizes != NULL && sizes[i] > 0.0 ? sizes[i] : 1.0;
        most = fmax(most, fabs(x[i]) / size);
    }
    return most;
}

double lag_differences_extent(const lag_differences *d, const lag_displacement *along)
{
    const lag_run *run = d->run;
    const lag_model *model = run->motion.model;
    const lag_stepper *s = &run->stepper;
    const double *natural = run->sizes.found ? run->sizes.natural : run->options.sizes.natural;
    const double length = run->instants.contacts.length;
    const double moment = length > 0.0 ? length / 16.0 : fmax(s->t - s->t_before, run->half.length); /* what depends on time shows in this */
    double most = largest_part(lag_motion_size(model), along->x, natural, 0.0);
    most = largest_part(model->np, along->p, d->p_sizes, most);
    most = largest_part(model->nw, along->w, NULL, most);
    most = largest_part(model->nu, along->u, NULL, most);
    return along->t != 0.0 && moment > 0.0 ? fmax(most, fabs(along->t) / moment) : most;
}

/* Values at all places of step h. */
static lag_status sample(lag_differences *d, const lag_displacement *along, double h, double step, lag_map *map, void *context)
{
    d->h = h;
    lag_differences_restore(d);
    lag_status status = displace(d, along, 0.0, h, step);
    status = status == LAG_OK ? map(context, d->middle) : status;
    for (int k = 0; k < 2 * LAG_POINTS && status == LAG_OK; ++k) {
        const double by = (k % 2 == 0 ? h : -h) * (k / 2 + 1);
        lag_differences_restore(d);
        status = displace(d, along, by, h, step);
        status = status == LAG_OK ? map(context, d->value[k / 2][k % 2]) : status;
    }
    return status;
}

/* Differences of value i at so many steps. */
static double apart(const lag_differences *d, size_t i, int steps)
{
    return d->value[steps - 1][0][i] - d->value[steps - 1][1][i];
}

static double of_sixth_order(const lag_differences *d, size_t i, double h)
{
    return (lag_sixth[2] * apart(d, i, 3) + lag_sixth[1] * apart(d, i, 2) + lag_sixth[0] * apart(d, i, 1)) / h;
}

static double of_fourth_order(const lag_differences *d, size_t i, double h)
{
    return (8.0 * apart(d, i, 1) - apart(d, i, 2)) / (12.0 * h);
}

/* The step of the slope, or of value i itself over the distance, as far as it is more than rounding. */
static double broken(const lag_differences *d, size_t i)
{
    const double inner = d->value[0][0][i] + d->value[0][1][i] - 2.0 * d->middle[i];
    const double outer = d->value[1][0][i] + d->value[1][1][i] - 2.0 * d->middle[i];
    const double rounding = ROUNDINGS * DBL_EPSILON * fabs(d->middle[i]);
    return fmax(fabs(4.0 * inner - outer) - rounding, 0.0) / (3.0 * d->h);
}

double lag_differences_bend(const lag_differences *d, size_t i)
{
    const double outer = d->value[2][0][i] + d->value[2][1][i];
    const double inner = d->value[0][0][i] + d->value[0][1][i];
    return (outer - inner) / (8.0 * d->h * d->h);
}

lag_status lag_differences_along(lag_differences *d, const lag_displacement *along, size_t count, const double *sizes, lag_map *map,
    void *context, double *derivative, double *error)
{
    const double extent = lag_differences_extent(d, along);
    *error = (double)INFINITY;
    if (!(extent > 0.0)) {
        lag_fill(count, 0.0, derivative);
        *error = 0.0;
        return LAG_OK;
    }
    for (double step = 16.0 * lag_differences_step(); step >= d->finest; step /= 16.0) {
        const double h = step / extent;
        const lag_status status = sample(d, along, h, step, map, context);
        double bent = 0.0;
        int breaks = 0;
        for (size_t i = 0; i < count && status == LAG_OK; ++i) {
            const double size = sizes[i] > 0.0 ? sizes[i] : 1.0;
            d->sixth[i] = of_sixth_order(d, i, h);
            bent = fmax(bent, fabs(d->sixth[i] - of_fourth_order(d, i, h)) / (size * extent));
            breaks = breaks || !(broken(d, i) <= lag_differences_step() * (size * extent + fabs(d->sixth[i])));
        }
        if (status != LAG_OK || breaks) {
            continue;
        }
        const double left = bent * sqrt(bent) + DBL_EPSILON / step;
        if (left < *error) {
            *error = left;
            memcpy(derivative, d->sixth, count * sizeof(double));
        }
        if (bent * sqrt(bent) <= DBL_EPSILON / step) {
            break;
        }
    }
    return *error < (double)INFINITY ? LAG_OK : LAG_NOT_SMOOTH;
}
