/* Steps between which inputs change: the integral of an input that is held, of a table that jumps, and of many at once. */
#include <math.h>
#include <string.h>

#include "check.h"
#include "lag/hold.h"
#include "oscillator.h"

static lag_status start(const lag_arguments *at, double *q, double *qd, double *z, double *u)
{
    (void)at;
    (void)q;
    (void)qd;
    z[0] = 0.0;
    u[0] = 0.0;
    return LAG_OK;
}

/* z' = u: behind steps with a held input z is the sum of their areas. */
static lag_status rates(const lag_arguments *at, double *zd)
{
    zd[0] = at->u[0];
    return LAG_OK;
}

static lag_status tangent(const lag_arguments *at, double *zd)
{
    zd[0] = at->du[0];
    return LAG_OK;
}

/* There are no coordinates. */
static lag_status no_mass(const lag_arguments *at, double *mass)
{
    (void)at;
    (void)mass;
    return LAG_OK;
}

static lag_status no_constraint(const lag_arguments *at, double *phi, double *jacobian)
{
    (void)at;
    (void)phi;
    (void)jacobian;
    return LAG_OK;
}

static lag_model integrator(void)
{
    lag_model model = OSCILLATOR;
    model.name = "Integrator";
    model.nz = model.nu = 1;
    model.np = 0;
    model.start = start;
    model.mass_matrix = no_mass;
    model.velocity_constraint = no_constraint;
    model.state_derivative = rates;
    model.state_derivative_tangent = tangent;
    return model;
}

typedef struct held {
    double u[1], before[1];
    lag_hold hold;
    void *block;
} held;

static void open(held *own, const lag_model *model, const lag_signals *signals)
{
    const lag_run_options options = {.tolerance = 1e-8, .length = 1.0, .callbacks = {.inputs = lag_hold_tell, .context = &own->hold}};
    own->u[0] = own->before[0] = 0.0;
    own->hold = (lag_hold){.count = 1, .u = own->u, .before = own->before, .signals = signals, .jumped = (double)NAN};
    own->block = malloc(lag_run_size(model, &options));
    CHECK(own->block != NULL);
    own->hold.run = lag_run_place(own->block, model, &options);
    CHECK(lag_run_begin(own->hold.run, 0.0, NULL) == LAG_OK);
}

static double value(const held *own)
{
    return own->hold.run->stepper.x[0];
}

static int is_near(double x, double wanted)
{
    return fabs(x - wanted) <= 1e-12;
}

static void held_over_steps(void)
{
    const lag_model model = integrator();
    held own;
    double area = 0.0;
    open(&own, &model, NULL);
    for (int k = 1; k <= 30; ++k) {
        own.u[0] = (double)(k * k);
        CHECK(lag_hold_step(&own.hold, 0.1, 0) == LAG_OK);
        area += 0.1 * own.u[0];
        CHECK(own.hold.run->stepper.t == k / 10.0); /* nothing adds up: 0.1 + 0.1 + 0.1 is not 0.3 */
        CHECK(is_near(value(&own) / area, 1.0));
    }
    free(own.block);
}

/* 1 up to t = 0.25, then 3 */
static void over_a_jump_of_a_table(void)
{
    const lag_model model = integrator();
    const double times[4] = {0.0, 0.25, 0.25, 9.0};
    const double values[4] = {1.0, 1.0, 3.0, 3.0};
    const lag_signal signal = {.kind = LAG_SIGNAL_LINES, .count = 4, .time = times, .value = values};
    const lag_signals signals = {.count = 1, .signal = &signal};
    const double at[1] = {0.25};
    held own;
    open(&own, &model, &signals);
    own.hold.breaks = 1;
    own.hold.at = at;
    CHECK(lag_hold_step(&own.hold, 0.2, 0) == LAG_OK && is_near(value(&own), 0.2));
    CHECK(lag_hold_step(&own.hold, 0.2, 0) == LAG_OK && is_near(value(&own), 0.25 + 3.0 * 0.15));
    CHECK(own.hold.jumped == 0.25);
    free(own.block);
}

/* In pieces of one step of the method each; one that does not go on stays where it is. */
static void many(void)
{
    const lag_model model = integrator();
    held own[3];
    lag_hold *holds[3];
    int status[3] = {LAG_OK, LAG_STOPPED, LAG_OK};
    double states[3][2];
    for (size_t i = 0; i < 3; ++i) {
        open(&own[i], &model, NULL);
        holds[i] = &own[i].hold;
        own[i].u[0] = (double)i + 1.0;
    }
    lag_holds_step(holds, 3, 0.5, 1, status);
    for (int k = 0; k < 100; ++k) {
        lag_holds_go(holds, 3, 1, status);
    }
    lag_holds_state((const lag_hold *const *)holds, 3, &states[0][0]);
    CHECK(status[0] == LAG_OK && status[1] == LAG_STOPPED && status[2] == LAG_OK);
    CHECK(states[0][0] == 0.5 && states[1][0] == 0.0 && states[2][0] == 0.5);
    CHECK(is_near(states[0][1], 0.5) && states[1][1] == 0.0 && is_near(states[2][1], 1.5));
    lag_holds_to(holds, 3, 0.75, 0, status);
    lag_holds_state((const lag_hold *const *)holds, 3, &states[0][0]);
    CHECK(states[0][0] == 0.75 && is_near(states[2][1], 2.25));
    for (size_t i = 0; i < 3; ++i) {
        free(own[i].block);
    }
}

int main(void)
{
    held_over_steps();
    over_a_jump_of_a_table();
    many();
    puts("hold: ok");
    return EXIT_SUCCESS;
}
