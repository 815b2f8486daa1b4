#include "lag/sensitivities/run_sensitivities.h"

#include "lag/initial.h"
#include "lag/linalg/arena.h"

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

/* The rest of the name behind a text; null: it does not begin with it. */
static const char *behind(const char *name, const char *text)
{
    for (; name != NULL && *text != '\0'; ++text) {
        name = *name == *text ? name + 1 : NULL;
    }
    return name;
}

/* Place of the slot with whose name, between `before` and `after`, this one is written; `count`: there is none. */
static size_t find(const lag_slot *slots, size_t count, const char *name, const char *before, const char *after)
{
    size_t i = 0;
    for (; i < count; ++i) {
        const char *rest = behind(behind(behind(name, before), slots[i].name), after);
        if (rest != NULL && *rest == '\0') {
            break;
        }
    }
    return i;
}

/* Sets the direction of a quantity; 0: there is none. */
static int point(const lag_model *model, const char *name, double *p, double *u, double *start)
{
    const size_t n = model->nq;
    const size_t parameter = find(model->parameters, model->np, name, "", "");
    const size_t input = find(model->inputs, model->nu, name, "", "");
    const size_t coordinate = find(model->coordinates, n, name, "", ".start");
    const size_t rate = find(model->coordinates, n, name, "der(", ").start");
    const size_t state = find(model->states, model->nz, name, "", ".start");
    if (parameter < model->np) {
        p[parameter] = 1.0;
    } else if (input < model->nu) {
        u[input] = 1.0;
    } else if (coordinate < n) {
        start[coordinate] = 1.0;
    } else if (rate < n) {
        start[n + rate] = 1.0;
    } else if (state < model->nz) {
        start[2 * n + state] = 1.0;
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
    static const lag_along none[3] = {{0}, {0}, {0}};
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
