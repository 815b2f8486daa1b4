/* Assertions of the level of warnings (run/conditions.c): each entering is told once, and the motion goes on. */
#include <string.h>

#include "check.h"
#include "lag/run.h"
#include "spring.h"

enum { ASSERTIONS = 4 };

/* ---- what is found ---- */

static void each_is_found_where_it_ceases_to_hold(void)
{
    lag_model model = SPRING;
    model.na = ASSERTIONS;
    lag_motion motion = {.model = &model};
    double *memory = calloc(lag_conditions_memory(&model), sizeof *memory);
    CHECK(memory != NULL && lag_conditions_memory(&model) == 2 * ASSERTIONS);
    lag_conditions watch = {.motion = &motion, .held = memory, .warned = memory + ASSERTIONS};
    static const double held[ASSERTIONS] = {1.0, -1.0, 1.0, -1.0};
    memcpy(watch.held, held, sizeof held);
    CHECK(lag_conditions_assert(&watch) == LAG_OK);
    CHECK(lag_conditions_warning(&watch, 0) == 1);
    CHECK(lag_conditions_warning(&watch, 2) == 3);
    CHECK(lag_conditions_warning(&watch, 4) == ASSERTIONS);
    CHECK(lag_conditions_warning(&watch, 0) == ASSERTIONS); /* both are told */
    watch.held[1] = 1.0;
    CHECK(lag_conditions_warning(&watch, 0) == ASSERTIONS);
    watch.held[1] = -1.0;
    CHECK(lag_conditions_warning(&watch, 0) == 1); /* it held in between */
    watch.held[2] = 0.0;
    CHECK(lag_conditions_assert(&watch) == LAG_VIOLATED && lag_conditions_warning(&watch, 0) == ASSERTIONS);
    free(memory);
}

/* ---- a whole run of x = cos(t) ---- */

/* Warnings of x < 0.5 and of x > -2, which holds; an error of x > -3. */
static lag_status spring_monitor(const lag_arguments *at, double *invariant, double *scale, double *assertion)
{
    (void)invariant;
    (void)scale;
    assertion[0] = at->q[0] < 0.5 ? 1.0 : -1.0;
    assertion[1] = at->q[0] > -2.0 ? 1.0 : -1.0;
    assertion[2] = at->q[0] > -3.0 ? 1.0 : 0.0;
    return LAG_OK;
}

typedef struct told {
    size_t count;
    double t[8];
} told;

static lag_status hear(void *context, lag_run *run, const lag_event_notice *notice)
{
    told *heard = context;
    (void)run;
    CHECK(notice->what == LAG_WARNING && notice->which == 0 && heard->count < 8);
    heard->t[heard->count++] = notice->t;
    return LAG_OK;
}

static lag_run *run_of(const lag_model *model, told *heard, const double *tolerance)
{
    const lag_run_options options = {
        .tolerance = 1e-8, .h_most = 0.01, .invariants.tolerance = tolerance, .callbacks = {.context = heard, .tell = hear}};
    void *block = malloc(lag_run_size(model, &options));
    CHECK(block != NULL);
    lag_run *run = lag_run_place(block, model, &options);
    CHECK(lag_run_begin(run, 0.0, NULL) == LAG_OK);
    return run;
}

static void a_run_tells_each_entering_and_goes_on(void)
{
    static const double tolerance[1] = {0.0};
    const double pi = acos(-1.0);
    lag_model model = SPRING;
    told heard = {0};
    model.na = 3;
    model.monitor = spring_monitor;
    lag_run *run = run_of(&model, &heard, tolerance);
    CHECK(lag_run_to(run, 12.0, 0) == LAG_OK && run->stepper.t == 12.0);
    CHECK(heard.count == 3 && heard.t[0] == 0.0);
    for (size_t k = 1; k < 3; ++k) {
        const double entered = (2.0 * (double)k - 1.0 / 3.0) * pi;
        CHECK(heard.t[k] >= entered - 1e-6 && heard.t[k] < entered + 0.011); /* behind the step that enters */
    }
    free(run);
}

static void nothing_is_told_where_nothing_is_watched(void)
{
    lag_model model = SPRING;
    told heard = {0};
    model.na = 3;
    model.monitor = spring_monitor;
    lag_run *run = run_of(&model, &heard, NULL);
    CHECK(lag_run_to(run, 12.0, 0) == LAG_OK && heard.count == 0);
    free(run);
}

int main(void)
{
    each_is_found_where_it_ceases_to_hold();
    a_run_tells_each_entering_and_goes_on();
    nothing_is_told_where_nothing_is_watched();
    return 0;
}
