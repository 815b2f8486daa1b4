/* Clauses: relations, resets, clocks, the start and the end, and how they fail. */
#include "check.h"
#include "lag/run.h"
#include "linear.h"

enum { COUNT, BELOW, FIRED, TICK, INITIAL, TERMINAL, DISCRETES };

enum mode { BOUNCE, SAMPLE, ENDS, STOP, REFUSE, CONFLICT, ENDLESS, RESET } mode;

static lag_status below(const lag_arguments *at, double *g)
{
    g[0] = -at->q[linear.n - 1];
    return LAG_OK;
}

static lag_status below_rate(const lag_arguments *at, double *rate, double *acceleration)
{
    rate[0] = -at->qd[linear.n - 1];
    acceleration[0] = -at->qdd[linear.n - 1];
    return LAG_OK;
}

static lag_status now_and_then(const lag_arguments *at, double *first, double *period)
{
    (void)at;
    first[0] = 0.0;
    period[0] = mode == SAMPLE ? 0.1 : 0.3;
    return LAG_OK;
}

/* One pass over what the mode says; `falls`: the relation became true. */
static lag_status pass(const lag_arguments *at, double *next, double *reset, double *value, double *collision,
    double *restitution, double *stop, double *fail)
{
    const double *w = at->w;
    const int falls = w[BELOW] != 0.0 && w[FIRED] == 0.0;
    const double rate = at->qd[linear.n - 1];
    (void)collision;
    (void)restitution;
    memcpy(next, w, DISCRETES * sizeof(double));
    next[FIRED] = w[BELOW];
    reset[0] = reset[1] = value[0] = value[1] = stop[0] = fail[0] = 0.0;
    switch (mode) {
    case BOUNCE:
        reset[0] = falls;
        value[0] = -0.8 * rate;
        next[COUNT] += falls;
        break;
    case SAMPLE:
        next[COUNT] = w[TICK] != 0.0 ? -8.0 * at->q[0] - 4.0 * at->qd[0] : w[COUNT];
        break;
    case ENDS:
        next[COUNT] += w[INITIAL] + 10.0 * w[TERMINAL];
        break;
    case STOP:
        stop[0] = falls;
        break;
    case REFUSE:
        fail[0] = falls;
        break;
    case CONFLICT:
        reset[0] = reset[1] = falls;
        value[0] = 1.0;
        value[1] = 2.0;
        break;
    case ENDLESS:
        next[COUNT] = falls ? 1.0 : w[COUNT] != 0.0 ? 3.0 - w[COUNT] : 0.0; /* 1, 2, 1, 2 ... */
        break;
    case RESET:
        reset[0] = falls;
        value[0] = 3.0;
        break;
    }
    return LAG_OK;
}

static lag_status pushed(const lag_arguments *at, double *mass, double *force, double *jacobian, double *gamma)
{
    const lag_status status = linear_dynamics(at, mass, force, jacobian, gamma);
    force[0] += mode == SAMPLE ? at->w[COUNT] : 0.0;
    return status;
}

/* A ball at height 1.25 with g = 10 (0.5 s, 5 m/s), with or without a lever q2 = -2 q1 at whose end it is. */
static lag_model machine(enum mode what, int lever)
{
    static const lag_slot slots[DISCRETES] = {
        {"n", "1", NULL}, {"h <= 0", "1", NULL}, {"when", "1", NULL}, {"sample", "1", NULL}, {"initial()", "1", NULL},
        {"terminal()", "1", NULL},
    };
    static const unsigned char kinds[DISCRETES] = {
        LAG_KIND_VARIABLE, LAG_KIND_RELATION, LAG_KIND_CONDITION, LAG_KIND_CLOCK, LAG_KIND_INITIAL, LAG_KIND_TERMINAL,
    };
    static const unsigned char strict[1] = {0};
    static size_t places[2];
    static const char *const resets[2] = {"der(h)", "der(h)"};
    static const char *const stops[1] = {"landed"};
    static const char *const failures[1] = {"too low"};
    memset(&linear, 0, sizeof linear);
    linear.n = lever ? 2 : 1;
    linear.bars = lever ? 1 : 0;
    for (size_t i = 0; i < linear.n; ++i) {
        linear.mass[i] = 1.0;
    }
    linear.q[linear.n - 1] = 1.25;
    linear.force[linear.n - 1] = -10.0;
    if (lever) {
        linear.mass[0] = 4.0;
        linear.force[1] = -20.0;
        linear.q[0] = -0.625;
        linear.bar[0][0] = 2.0;
        linear.bar[0][1] = 1.0;
    }
    mode = what;
    lag_model model = linear_model();
    linear_discretes = DISCRETES;
    places[0] = places[1] = 2 * linear.n - 1;
    model.nw = DISCRETES;
    model.nindicator = model.nclock = model.nstop = model.nfail = 1;
    model.nreset = 2;
    model.discretes = slots;
    model.kinds = kinds;
    model.strict = strict;
    model.reset_places = places;
    model.resets = resets;
    model.stops = stops;
    model.failures = failures;
    model.indicator = below;
    model.indicator_rate = below_rate;
    model.clock = now_and_then;
    model.event = pass;
    model.dynamics = pushed;
    return model;
}

static struct {
    size_t count;
    lag_event_notice what[1000];
} told;

static lag_status note(void *context, lag_run *run, const lag_event_notice *notice)
{
    (void)context;
    (void)run;
    if (notice->what != LAG_TICK && told.count < sizeof told.what / sizeof told.what[0]) {
        told.what[told.count++] = *notice;
    }
    return LAG_OK;
}

static lag_run *begin(const lag_model *model, const lag_run_options *options)
{
    void *block = malloc(lag_run_size(model, options));
    CHECK(block != NULL);
    lag_run *run = lag_run_place(block, model, options);
    told.count = 0;
    CHECK(lag_run_begin(run, 0.0, NULL) == LAG_OK);
    return run;
}

static const lag_run_options TOLD = {.tolerance = 1e-10, .callbacks.tell = note};

static void a_clause_bounces(void)
{
    const lag_model model = machine(BOUNCE, 0);
    lag_run *run = begin(&model, &TOLD);
    CHECK(lag_run_to(run, 2.5, 0) == LAG_OK);
    double t = 0.5;
    double flight = 1.0;
    size_t bounces = 0;
    for (size_t i = 0; i < told.count; ++i) {
        if (told.what[i].what == LAG_REINIT) {
            CHECK(told.what[i - 1].what == LAG_TRUE && strcmp(lag_event_notice_name(&model, &told.what[i - 1]), "h <= 0") == 0);
            CHECK(strcmp(lag_event_notice_name(&model, &told.what[i]), "der(h)") == 0);
            CHECK_NEAR(told.what[i].t, t, 1e-11);
            flight *= 0.8;
            t += flight;
            ++bounces;
        }
    }
    CHECK(bounces == 4 && run->motion.w[COUNT] == 4.0);
    /* bounces accumulate at 4.5 s, and a clause does not know how to rest */
    CHECK(lag_run_to(run, 6.0, 0) == LAG_CHATTER);
    CHECK_NEAR(run->stepper.t, 4.5, 1e-4);
    CHECK(run->instants.discretes.guilty[BELOW] == 1.0);
    free(run);
}

/* The force is held between ticks; rows do not matter. Reference: the exact solution of each interval. */
static void a_controller_samples(void)
{
    double last[2][2];
    const double times[5] = {0.0, 0.0321, 0.1, 0.77, 1.0};
    for (int with_rows = 0; with_rows < 2; ++with_rows) {
        const lag_model model = machine(SAMPLE, 0);
        linear.force[0] = 0.0;
        lag_run_options options = TOLD;
        double rows[10];
        if (with_rows) {
            options.count = 5;
            options.times = times;
            options.rows = rows;
        }
        lag_run *run = begin(&model, &options);
        CHECK(lag_run_to(run, 1.0, 0) == LAG_OK);
        memcpy(last[with_rows], run->stepper.x, sizeof last[0]);
        CHECK(lag_instants_next(&run->instants) == 1.0);
        CHECK(lag_run_end(run) == LAG_OK);
        CHECK(lag_instants_next(&run->instants) == 1.1);
        free(run);
    }
    double x = 1.25;
    double v = 0.0;
    for (int k = 0; k < 10; ++k) {
        const double force = -8.0 * x - 4.0 * v;
        x += 0.1 * v + 0.005 * force;
        v += 0.1 * force;
    }
    CHECK_NEAR(last[0][0], x, 1e-13);
    CHECK_NEAR(last[0][1], v, 1e-13);
    CHECK(memcmp(last[0], last[1], sizeof last[0]) == 0);
}

static void the_start_and_the_end(void)
{
    const lag_model model = machine(ENDS, 0);
    lag_run *run = begin(&model, &TOLD);
    CHECK(run->motion.w[COUNT] == 1.0);
    CHECK(lag_run_to(run, 1.0, 0) == LAG_OK);
    CHECK(run->motion.w[COUNT] == 1.0);
    CHECK(lag_run_end(run) == LAG_OK);
    CHECK(run->motion.w[COUNT] == 11.0);
    free(run);
}

static void ends(enum mode what, lag_status expected)
{
    const lag_model model = machine(what, 0);
    lag_run *run = begin(&model, &TOLD);
    CHECK(lag_run_to(run, 1.0, 0) == expected);
    CHECK_NEAR(run->stepper.t, 0.5, 1e-13);
    if (what == STOP) {
        CHECK(told.what[told.count - 2].what == LAG_TERMINATE && told.what[told.count - 1].what == LAG_AFTER);
        CHECK(strcmp(lag_event_notice_name(&model, &told.what[told.count - 2]), "landed") == 0);
        CHECK(strcmp(lag_event_kind_name(LAG_TERMINATE), "terminate") == 0);
    }
    if (what == CONFLICT) {
        CHECK(run->instants.clauses.fault == 1);
    }
    if (what == ENDLESS) {
        CHECK(run->instants.discretes.guilty[COUNT] == 1.0 && run->instants.discretes.guilty[BELOW] == 0.0);
    }
    free(run);
}

/* A rate that is set takes the rest of the mechanism with it. */
static void a_reset_moves_the_lever(void)
{
    const lag_model model = machine(RESET, 1);
    lag_run *run = begin(&model, &TOLD);
    CHECK(lag_run_to(run, 0.5 + 1e-9, 0) == LAG_OK); /* seen from the ball the mass is 2 */
    CHECK_NEAR(told.what[told.count - 2].t, 0.5, 1e-13);
    CHECK_NEAR(run->stepper.x[3], 3.0, 1e-7);
    CHECK_NEAR(run->stepper.x[2], -1.5, 1e-7);
    CHECK_NEAR(2.0 * run->stepper.x[2] + run->stepper.x[3], 0.0, 1e-14);
    free(run);
}

int main(void)
{
    a_clause_bounces();
    a_controller_samples();
    the_start_and_the_end();
    ends(STOP, LAG_STOPPED);
    ends(REFUSE, LAG_ASSERTION_FAILED);
    ends(CONFLICT, LAG_CONFLICT);
    ends(ENDLESS, LAG_EVENT_ITERATION_FAILED);
    a_reset_moves_the_lever();
    (void)printf("clauses: ok\n");
    return EXIT_SUCCESS;
}
