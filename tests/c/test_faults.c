/* Why runs end, as lag_run_explain() tells it, and inputs that jump: against closed forms. */
#include "check.h"
#include "lag/fixed.h"
#include "lag/run.h"
#include "spring.h"

static lag_run *place(const lag_model *model, const lag_run_options *options)
{
    void *block = malloc(lag_run_size(model, options));
    CHECK(block != NULL);
    return lag_run_place(block, model, options);
}

/* Runs to `stop`; how that ended must be `wanted`. */
static lag_run *run_to(const lag_model *model, const lag_run_options *options, double stop, lag_status wanted)
{
    lag_run *run = place(model, options);
    lag_status status = lag_run_begin(run, 0.0, NULL);
    status = status == LAG_OK ? lag_run_to(run, stop, 2000) : status;
    CHECK(status == wanted);
    return run;
}

/* ---- what must stay true ---- */

/* x^2 + v^2 is an invariant and x is none; x > -2 stays true and x > -0.5 does not. */
static lag_status spring_monitor(const lag_arguments *at, double *invariant, double *scale, double *assertion)
{
    invariant[0] = at->q[0] * at->q[0] + at->qd[0] * at->qd[0];
    invariant[1] = at->q[0];
    scale[0] = scale[1] = 1.0;
    assertion[0] = at->q[0] > -2.0;
    assertion[1] = at->q[0] > -0.5;
    return LAG_OK;
}

static void assertions_are_told(void)
{
    const double tolerance[3] = {1e-3, 1e3, 0.0};
    lag_model model = SPRING;
    lag_fault fault;
    model.ni = model.na = 2;
    model.monitor = spring_monitor;
    const lag_run_options options = {.tolerance = 1e-8, .invariants.tolerance = tolerance};
    lag_run *run = run_to(&model, &options, 10.0, LAG_VIOLATED);
    lag_run_explain(run, LAG_VIOLATED, &fault);
    CHECK(fault.which == 1);
    CHECK(fault.x[0] <= -0.5);                 /* the state that was lost, */
    CHECK_NEAR(fault.x[0], cos(fault.t), 1e-6);
    CHECK(run->stepper.x[0] > -0.5);           /* behind the last good one */
    CHECK(fault.t > 2.0 * acos(-1.0) / 3.0 && run->stepper.t < 2.0 * acos(-1.0) / 3.0);
    free(run);
}

static void invariants_are_told(void)
{
    const double tolerance[3] = {1e-3, 0.25, 0.0};
    lag_model model = SPRING;
    lag_fault fault;
    model.ni = model.na = 2;
    model.monitor = spring_monitor;
    const lag_run_options options = {.tolerance = 1e-8, .invariants.tolerance = tolerance};
    lag_run *run = run_to(&model, &options, 10.0, LAG_VIOLATED);
    lag_run_explain(run, LAG_VIOLATED, &fault);
    CHECK(fault.which == 2 + 1);
    CHECK_NEAR(fault.limit, 0.25, 1e-12);
    CHECK(fault.value > fault.limit);
    CHECK_NEAR(fault.value, 1.0 - cos(fault.t), 1e-6);
    free(run);
}

/* ---- what has no accelerations ---- */

/* z' = -1, and y' = sqrt(z), which is no number behind t = 1. */
static lag_status root_start(const lag_arguments *at, double *q, double *qd, double *z, double *u)
{
    (void)at;
    (void)q;
    (void)qd;
    (void)u;
    z[0] = 1.0;
    z[1] = 0.0;
    return LAG_OK;
}

static lag_status root_rates(const lag_arguments *at, double *rates)
{
    rates[0] = -1.0;
    rates[1] = sqrt(at->z[0]);
    return LAG_OK;
}

/* z' = -1, and y' = y^2: y = 1 / (1 - t). */
static lag_status pole_start(const lag_arguments *at, double *q, double *qd, double *z, double *u)
{
    const lag_status status = root_start(at, q, qd, z, u);
    z[1] = 1.0;
    return status;
}

static lag_status pole_rates(const lag_arguments *at, double *rates)
{
    rates[0] = -1.0;
    rates[1] = at->z[1] * at->z[1];
    return LAG_OK;
}

static lag_model of_two_states(
    lag_status (*start)(const lag_arguments *, double *, double *, double *, double *),
    lag_status (*rates)(const lag_arguments *, double *))
{
    static const lag_slot slots[2] = {{"z", "1", NULL}, {"y", "1", NULL}};
    lag_model model = SPRING;
    model.nq = model.ny = 0;
    model.nz = 2;
    model.states = slots;
    model.start = start;
    model.state_derivative = rates;
    model.energies = NULL;
    return model;
}

static void what_is_no_number_is_told(void)
{
    const lag_model model = of_two_states(root_start, root_rates);
    const lag_run_options options = {.method = &lag_dop853, .tolerance = 1e-6};
    lag_fault fault;
    lag_run *run = run_to(&model, &options, 2.0, LAG_NOT_FINITE);
    lag_run_explain(run, LAG_NOT_FINITE, &fault);
    CHECK(fault.which == 1);
    CHECK(fault.x[0] < 0.0 && fault.t >= run->stepper.t);
    CHECK_NEAR(run->stepper.t, 1.0, 1e-6);
    CHECK_NEAR(run->stepper.x[1], 2.0 / 3.0, 1e-4);
    free(run);
}

static void what_changes_too_fast_is_told(void)
{
    const lag_model model = of_two_states(pole_start, pole_rates);
    const lag_run_options options = {.method = &lag_dop853, .tolerance = 1e-6};
    lag_fault fault;
    lag_run *run = run_to(&model, &options, 2.0, LAG_STEP_TOO_SMALL);
    lag_run_explain(run, LAG_STEP_TOO_SMALL, &fault);
    CHECK(fault.which == 1);
    CHECK_NEAR(fault.t, 1.0, 1e-3);
    CHECK(fault.t == run->stepper.t);
    free(run);
}

static lag_status two_start(const lag_arguments *at, double *q, double *qd, double *z, double *u)
{
    (void)at;
    (void)z;
    (void)u;
    q[0] = q[1] = 1.0;
    qd[0] = qd[1] = 0.0;
    return LAG_OK;
}

/* The second coordinate has no inertia. */
static lag_status half_a_mass(const lag_arguments *at, double *mass)
{
    (void)at;
    mass[0] = 1.0;
    mass[1] = mass[2] = mass[3] = 0.0;
    return LAG_OK;
}

static lag_status without_inertia(const lag_arguments *at, double *mass, double *force, double *jacobian, double *gamma)
{
    (void)jacobian;
    (void)gamma;
    force[0] = -at->q[0];
    force[1] = -at->q[1];
    return half_a_mass(at, mass);
}

static void what_has_no_inertia_is_told(void)
{
    static const lag_slot slots[2] = {{"x", "m", NULL}, {"y", "m", NULL}};
    lag_model model = SPRING;
    const lag_run_options options = {.tolerance = 1e-6};
    lag_fault fault;
    model.nq = 2;
    model.nz = model.ny = 0;
    model.coordinates = slots;
    model.start = two_start;
    model.mass_matrix = half_a_mass;
    model.dynamics = without_inertia;
    lag_run *run = run_to(&model, &options, 1.0, LAG_SINGULAR);
    lag_run_explain(run, LAG_SINGULAR, &fault);
    CHECK(fault.which == 1);
    CHECK(fault.t == 0.0 && fault.x[0] == 1.0 && fault.x[1] == 1.0);
    free(run);
}

/* ---- inputs that jump ---- */

enum { PUSHED, DISCRETES };

/* The input is 0 until t = 1, and 1 from then on; asked for the value before the jump it is still 0 there. */
static void jumping(void *context, double t, int before, double *u)
{
    (void)context;
    u[0] = t > 1.0 || (t == 1.0 && !before) ? 1.0 : 0.0;
}

static lag_status none_are_true(const lag_arguments *at, double *w)
{
    (void)at;
    w[PUSHED] = 0.0;
    return LAG_OK;
}

static lag_status is_pushed(const lag_arguments *at, double *g)
{
    g[0] = at->u[0] - 0.5;
    return LAG_OK;
}

static lag_status is_pushed_rate(const lag_arguments *at, double *rate, double *acceleration)
{
    rate[0] = at->du[0];
    acceleration[0] = 0.0;
    return LAG_OK;
}

static lag_status no_clauses(const lag_arguments *at, double *next, double *reset, double *value, double *collision,
    double *restitution, double *stop, double *fail)
{
    (void)reset;
    (void)value;
    (void)collision;
    (void)restitution;
    (void)stop;
    (void)fail;
    next[PUSHED] = at->w[PUSHED];
    return LAG_OK;
}

/* A free mass that is pushed with 2 N while the relation holds. */
static lag_status push(const lag_arguments *at, double *mass, double *force, double *jacobian, double *gamma)
{
    (void)jacobian;
    (void)gamma;
    force[0] = 2.0 * at->w[PUSHED];
    return spring_mass(at, mass);
}

static lag_status at_rest(const lag_arguments *at, double *q, double *qd, double *z, double *u)
{
    (void)at;
    (void)z;
    q[0] = qd[0] = u[0] = 0.0;
    return LAG_OK;
}

static struct {
    size_t count;
    lag_event_kind what[8];
    double t[8];
} told;

static lag_status hear(void *context, lag_run *run, const lag_event_notice *notice)
{
    (void)context;
    (void)run;
    CHECK(told.count < 8);
    told.t[told.count] = notice->t;
    told.what[told.count++] = notice->what;
    return LAG_OK;
}

/* A mass at rest that is pushed where its input is more than 1/2. */
static lag_model pushed(void)
{
    static const lag_slot slots[1] = {{"u > 0.5", "1", NULL}};
    static const lag_slot inputs[1] = {{"u", "N", NULL}};
    static const unsigned char kinds[1] = {LAG_KIND_RELATION};
    static const unsigned char strict[1] = {1};
    lag_model model = SPRING;
    model.nz = model.ny = 0;
    model.nu = model.nw = model.nindicator = 1;
    model.inputs = inputs;
    model.discretes = slots;
    model.kinds = kinds;
    model.strict = strict;
    model.start = at_rest;
    model.dynamics = push;
    model.energies = NULL;
    model.discrete_start = none_are_true;
    model.indicator = is_pushed;
    model.indicator_rate = is_pushed_rate;
    model.event = no_clauses;
    return model;
}

static void relations_follow_inputs_that_jump(void)
{
    const lag_model model = pushed();
    const lag_run_options options = {.tolerance = 1e-10, .callbacks = {.inputs = jumping, .tell = hear}};
    lag_run *run = place(&model, &options);
    CHECK(lag_run_begin(run, 0.0, NULL) == LAG_OK);
    CHECK(lag_run_to(run, 1.0, 0) == LAG_OK);
    CHECK(run->motion.w[PUSHED] == 0.0 && run->stepper.x[0] == 0.0); /* inputs as they are before the jump */
    CHECK(told.count == 0);
    CHECK(lag_run_jump(run) == LAG_OK);
    CHECK(run->motion.w[PUSHED] == 1.0);
    CHECK(told.count == 3);
    CHECK(told.what[0] == LAG_BEFORE && told.what[1] == LAG_TRUE && told.what[2] == LAG_AFTER);
    CHECK(told.t[0] == 1.0 && told.t[2] == 1.0);
    CHECK(lag_run_jump(run) == LAG_OK); /* nothing jumps a second time */
    CHECK(told.count == 3);
    CHECK(lag_run_to(run, 3.0, 0) == LAG_OK);
    CHECK_NEAR(run->stepper.x[0], 4.0, 1e-9); /* (t - 1)^2 */
    CHECK_NEAR(run->stepper.x[1], 4.0, 1e-9);
    free(run);
}

/* A loop for real time sets inputs between steps: what they change happens as the next one begins. */
static void relations_follow_inputs_between_fixed_steps(void)
{
    double memory[16];
    const lag_model model = pushed();
    const lag_run_options options = {.callbacks.tell = hear};
    lag_run *run = place(&model, &options);
    told.count = 0;
    CHECK(lag_fixed_memory(2) <= sizeof memory / sizeof memory[0]);
    CHECK(lag_run_begin(run, 0.0, NULL) == LAG_OK);
    for (int i = 0; i < 300; ++i) {
        run->motion.u[0] = i < 100 ? 0.0 : 1.0;
        CHECK(lag_run_fixed(run, 0.01, lag_rk4, memory) == LAG_OK);
    }
    CHECK(told.count == 3 && told.what[1] == LAG_TRUE);
    CHECK_NEAR(told.t[1], 1.0, 1e-12);
    CHECK_NEAR(run->stepper.x[0], 4.0, 1e-9); /* (t - 1)^2 */
    CHECK_NEAR(run->stepper.x[1], 4.0, 1e-9);
    free(run);
}

static lag_status push_by_input(const lag_arguments *at, double *mass, double *force, double *jacobian, double *gamma)
{
    (void)jacobian;
    (void)gamma;
    force[0] = 2.0 * at->u[0];
    return spring_mass(at, mass);
}

/* An input that jumps at the end of a step is what it was before in that step. */
static void inputs_jump_between_fixed_steps(void)
{
    double memory[16];
    lag_model model = pushed();
    const lag_run_options options = {.callbacks.inputs = jumping};
    model.dynamics = push_by_input;
    model.event = NULL;
    model.nw = model.nindicator = 0;
    lag_run *run = place(&model, &options);
    CHECK(lag_run_begin(run, 0.0, NULL) == LAG_OK);
    for (int i = 0; i < 300; ++i) {
        CHECK(lag_run_fixed(run, 0.01, lag_rk4, memory) == LAG_OK);
    }
    CHECK_NEAR(run->stepper.x[0], 4.0, 1e-9); /* (t - 1)^2 */
    CHECK_NEAR(run->stepper.x[1], 4.0, 1e-9);
    free(run);
}

int main(void)
{
    assertions_are_told();
    invariants_are_told();
    what_is_no_number_is_told();
    what_changes_too_fast_is_told();
    what_has_no_inertia_is_told();
    relations_follow_inputs_that_jump();
    relations_follow_inputs_between_fixed_steps();
    inputs_jump_between_fixed_steps();
    (void)printf("faults: ok\n");
    return EXIT_SUCCESS;
}
