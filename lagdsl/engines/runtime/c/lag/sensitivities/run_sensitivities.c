#include "lag/sensitivities/run_sensitivities.h"

#include <string.h>

#include "lag/initial.h"
#include "lag/linalg/arena.h"

static const char START[] = ".start";
static const char RATE[] = "der(";

/* Doubles of the directions. */
static size_t directions(const lag_model *model, size_t count)
{
    return count * (model->np + model->nu + lag_motion_size(model));
}

static size_t own(const lag_model *model, size_t count)
{
    const size_t doubles = directions(model, count) + lag_motion_size(model) + lag_results_width(model);
    return lag_padded(sizeof(lag_run_sensitivities)) + lag_padded(doubles * sizeof(double));
}

size_t lag_run_sensitivities_size(const lag_model *model, size_t count)
{
    return own(model, count) + lag_sensitivities_size(model, count);
}

/* Place of a name of so many characters; `count`: there is none. */
static size_t find(const lag_slot *slots, size_t count, const char *name, size_t length)
{
    size_t i = 0;
    while (i < count && !(strncmp(slots[i].name, name, length) == 0 && slots[i].name[length] == '\0')) {
        ++i;
    }
    return i;
}

/* Entry of x that `theta.start` or `der(theta).start` is the start value of; as many as there are: none. */
static size_t find_start(const lag_model *model, const char *name)
{
    const size_t n = model->nq;
    const size_t size = lag_motion_size(model);
    const size_t all = strlen(name);
    const size_t end = strlen(START);
    const size_t length = all > end ? all - end : 0;
    const size_t open = strlen(RATE);
    if (length == 0 || strcmp(name + length, START) != 0) {
        return size;
    }
    const size_t coordinate = find(model->coordinates, n, name, length);
    if (coordinate < n) {
        return coordinate;
    }
    if (length > open + 1 && strncmp(name, RATE, open) == 0 && name[length - 1] == ')') {
        const size_t rate = find(model->coordinates, n, name + open, length - open - 1);
        if (rate < n) {
            return n + rate;
        }
    }
    return 2 * n + find(model->states, model->nz, name, length);
}

/* Sets the direction of a quantity; 0: there is none. */
static int point(const lag_model *model, const char *name, double *p, double *u, double *start)
{
    const size_t parameter = find(model->parameters, model->np, name, strlen(name));
    const size_t input = find(model->inputs, model->nu, name, strlen(name));
    const size_t entry = find_start(model, name);
    if (parameter < model->np) {
        p[parameter] = 1.0;
    } else if (input < model->nu) {
        u[input] = 1.0;
    } else if (entry < lag_motion_size(model)) {
        start[entry] = 1.0;
    } else {
        return 0;
    }
    return 1;
}

static lag_status forget(void *context, lag_results *results)
{
    (void)context;
    (void)results;
    return LAG_OK;
}

lag_run_sensitivities *lag_run_sensitivities_place(
    void *block, const lag_model *model, size_t count, const char *const *by, const lag_along *along)
{
    static const lag_along none[2] = {{0}, {0}};
    static const lag_sensitivity_rows no_rows = {0};
    const size_t size = lag_motion_size(model);
    lag_run_sensitivities *s = block;
    double *memory = (double *)(void *)((char *)block + lag_padded(sizeof *s));
    double *p = lag_take(&memory, count * model->np);
    double *u = lag_take(&memory, count * model->nu);
    double *start = lag_take(&memory, count * size);
    for (size_t k = 0; k < count; ++k) {
        if (!point(model, by[k], p + k * model->np, u + k * model->nu, start + k * size)) {
            return NULL;
        }
    }
    s->x = lag_take(&memory, size);
    s->results = (lag_results){.most_rows = 1, .most_notes = 1, .notes = &s->note, .full = forget};
    s->results.rows = lag_take(&memory, lag_results_width(model));
    const lag_sensitivity_directions of = {count, p, u, start};
    s->columns = lag_sensitivities_place((char *)block + own(model, count), model, &of, &no_rows, along != NULL ? along : none);
    return s;
}

lag_status lag_run_sensitivities_begin(
    lag_run_sensitivities *s, lag_run *run, double t, const unsigned char *set, const double *values)
{
    lag_initial told = {.dependent = run->ranks.dependent};
    int moved = 0;
    lag_status status = lag_run_start(run, t, s->x);
    for (size_t i = 0; i < lag_motion_size(run->motion.model); ++i) {
        s->x[i] = set != NULL && set[i] ? values[i] : s->x[i];
    }
    if (status == LAG_OK) {
        status = lag_run_move(run, t, s->x, run->options.h_first); /* finds sizes */
    }
    if (status == LAG_OK) {
        status = run->options.start != NULL ? lag_run_find(run, t, set, s->x, &told) : lag_projection_apply(&run->projection, t, s->x, &moved);
    }
    if (status == LAG_OK) {
        status = lag_sensitivities_start(s->columns, run, t, set, values);
    }
    if (run->options.results == NULL) {
        run->options.results = &s->results;
    }
    run->options.results->companion = &s->columns->companion;
    return status == LAG_OK ? lag_run_begin(run, t, s->x) : status;
}

lag_status lag_run_sensitivities_get(lag_run_sensitivities *s, lag_run *run, double t, const double *x, double *derivatives)
{
    return lag_sensitivities_get(s->columns, run, t, x, derivatives);
}

const double *lag_run_sensitivities_of_time(const lag_run_sensitivities *s)
{
    return s->columns->instant.time;
}
