/* Impacts and contacts against closed forms: what strikes, rests, leaves, and momentum and energy of it. */
#include "check.h"
#include "lag/fixed.h"
#include "lag/run.h"
#include "linear.h"

enum { MOST_TOLD = 4096 };

static struct {
    size_t count;
    lag_event_notice what[MOST_TOLD];
} log_of;

static lag_status note(void *context, lag_run *run, const lag_event_notice *notice)
{
    (void)context;
    (void)run;
    CHECK(log_of.count < MOST_TOLD);
    log_of.what[log_of.count++] = *notice;
    return LAG_OK;
}

static size_t count_of(lag_event_kind what)
{
    size_t count = 0;
    for (size_t i = 0; i < log_of.count; ++i) {
        count += log_of.what[i].what == what;
    }
    return count;
}

static double time_of(lag_event_kind what, size_t number)
{
    for (size_t i = 0; i < log_of.count; ++i) {
        if (log_of.what[i].what == what && number-- == 0) {
            return log_of.what[i].t;
        }
    }
    return (double)NAN;
}

static lag_run *begin(const lag_model *model, lag_status expected)
{
    const lag_run_options options = {.tolerance = 1e-10, .callbacks.tell = note};
    void *block = malloc(lag_run_size(model, &options));
    CHECK(block != NULL);
    lag_run *run = lag_run_place(block, model, &options);
    log_of.count = 0;
    CHECK(lag_run_begin(run, 0.0, NULL) == expected);
    return run;
}

static double kinetic(const lag_run *run)
{
    double sum = 0.0;
    for (size_t i = 0; i < linear.n; ++i) {
        const double rate = run->stepper.x[linear.n + i];
        sum += 0.5 * linear.mass[i] * rate * rate;
    }
    return sum;
}

/* ---- a ball ---- */

static void set_ball(double restitution)
{
    memset(&linear, 0, sizeof linear);
    linear.n = linear.contacts = linear.gaps = 1;
    linear.mass[0] = 2.0;
    linear.force[0] = -20.0; /* g = 10 */
    linear.q[0] = 1.25;      /* lands after 0.5 s with 5 m/s */
    linear.gap[0][0] = 1.0;
    linear.restitution[0] = restitution;
}

/* Impact k is at 0.5 + (e + ... + e^k) s; they accumulate at 0.5 + e/(1 - e) s, where the ball comes to rest. */
static void a_ball_bounces_and_rests(void)
{
    set_ball(0.8);
    const lag_model model = linear_model();
    lag_run *run = begin(&model, LAG_OK);
    CHECK(lag_run_to(run, 6.0, 0) == LAG_OK);
    const size_t impacts = count_of(LAG_IMPACT);
    double t = 0.5;
    double flight = 1.0;
    CHECK(impacts == 62 && count_of(LAG_CLOSED) == 1 && count_of(LAG_OPENED) == 0); /* 5 0.8^62 < 6e-6 < 5 0.8^61 */
    for (size_t k = 0; k < impacts; ++k) {
        CHECK_NEAR(time_of(LAG_IMPACT, k), t, 1e-9);
        flight *= 0.8;
        t += flight;
    }
    CHECK_NEAR(time_of(LAG_CLOSED, 0), 4.5, 1e-11);
    CHECK_NEAR(run->stepper.x[0], 0.0, 1e-12);
    CHECK_NEAR(run->stepper.x[1], 0.0, 1e-12);
    CHECK(run->motion.w[0] == 1.0 && run->motion.w[1] == (double)impacts);
    CHECK(lag_motion_solve(&run->motion, run->stepper.t, run->stepper.x) == LAG_OK);
    CHECK_NEAR(run->motion.lam[0], 20.0, 1e-12);
    free(run);
}

/*
 * A contact that is told to rest late does not end as a crowd of events. The time left after bounce k is 5 0.8^k s, the speed
 * 5 0.8^k m/s; both are below 2.2e-6 from k = 66 on.
 */
static void a_contact_rests_late(void)
{
    set_ball(0.8);
    linear.brief = 2.2e-6;
    const lag_model model = linear_model();
    lag_run *run = begin(&model, LAG_OK);
    CHECK(lag_run_to(run, 6.0, 0) == LAG_OK);
    CHECK(count_of(LAG_IMPACT) == 66 && count_of(LAG_CLOSED) == 1);
    CHECK_NEAR(time_of(LAG_CLOSED, 0), 4.5 - 5.0 * pow(0.8, 66.0), 1e-6);
    free(run);
}

/* A ball that lies on the floor is in contact from the start; one that is in it is refused. */
static void contacts_at_the_start(void)
{
    set_ball(0.5);
    linear.q[0] = 0.0;
    const lag_model model = linear_model();
    lag_run *run = begin(&model, LAG_OK);
    CHECK(run->motion.w[0] == 1.0);
    CHECK(lag_run_to(run, 1.0, 0) == LAG_OK);
    CHECK(log_of.count == 0);
    CHECK_NEAR(run->stepper.x[0], 0.0, 1e-14);
    free(run);
    linear.q[0] = -1e-3;
    run = begin(&model, LAG_PENETRATION);
    CHECK(run->instants.discretes.guilty[0] == 1.0);
    free(run);
    linear.q[0] = 0.0;
    linear.force[0] = 1.0; /* pulled up: nothing to carry */
    run = begin(&model, LAG_OK);
    CHECK(run->motion.w[0] == 0.0);
    free(run);
}

/* Impacts within steps of fixed length; energy never grows. */
static void fixed_steps_bounce(void)
{
    double memory[16];
    set_ball(0.7);
    const lag_model model = linear_model();
    lag_run *run = begin(&model, LAG_OK);
    double energy = 25.0;
    CHECK(lag_fixed_memory(2) <= sizeof memory / sizeof memory[0]);
    for (int i = 0; i < 4000; ++i) {
        CHECK(lag_run_fixed(run, 1e-3, lag_rk4, memory) == LAG_OK);
        const double now = kinetic(run) + 20.0 * run->stepper.x[0];
        CHECK(now < energy + 1e-9);
        CHECK(run->stepper.x[0] > -1e-9);
        energy = fmin(energy, now);
    }
    CHECK_NEAR(time_of(LAG_IMPACT, 0), 0.5, 1e-12);
    CHECK(count_of(LAG_IMPACT) > 5);
    CHECK(fabs(run->stepper.x[0]) < 1e-3 && fabs(run->stepper.x[1]) < 0.02);
    free(run);
}

/* ---- several at once ---- */

/* Balls in a row that touch: the blow goes through, whatever the masses; equal ones hand it on to the last. */
static void a_row_of_balls(void)
{
    for (int equal = 0; equal < 2; ++equal) {
        memset(&linear, 0, sizeof linear);
        linear.n = 4;
        linear.contacts = linear.gaps = 3;
        for (size_t i = 0; i < 4; ++i) {
            linear.mass[i] = equal ? 0.3 : 0.3 + 0.2 * (double)i;
            linear.q[i] = i == 0 ? -0.5 : 0.1 * (double)(i - 1);
        }
        for (size_t i = 0; i < 3; ++i) {
            linear.gap[i][i] = -1.0;
            linear.gap[i][i + 1] = 1.0;
            linear.rest[i] = -0.1;
            linear.restitution[i] = 1.0;
        }
        linear.qd[0] = 2.0;
        const lag_model model = linear_model();
        lag_run *run = begin(&model, LAG_OK);
        CHECK(lag_run_to(run, 0.5, 0) == LAG_OK);
        double momentum = 0.0;
        for (size_t i = 0; i < 4; ++i) {
            momentum += linear.mass[i] * run->stepper.x[4 + i];
        }
        /* a gap is zero within 1e-13 of 1 + the largest number of the state, 2 m/s; where a step ends at the impact that shows */
        CHECK_NEAR(time_of(LAG_IMPACT, 0), 0.2, 1e-13 * 3.0 / 2.0 + 1e-15);
        CHECK_NEAR(momentum, 0.6, 1e-13);
        CHECK_NEAR(kinetic(run), 0.6, 1e-13);
        /* ball after ball: v2 = 2 m1 v1/(m1 + m2) */
        double last = 2.0;
        for (size_t i = 0; i < 3; ++i) {
            last *= 2.0 * linear.mass[i] / (linear.mass[i] + linear.mass[i + 1]);
        }
        CHECK_NEAR(run->stepper.x[7], last, 1e-13);
        free(run);
    }
}

/* A plate (mass 3, inertia 1, corners at -1 and 1) that lands flat is stopped or thrown back as a whole; on one corner it turns. */
static void a_plate_on_two_corners(double tilt, double restitution)
{
    memset(&linear, 0, sizeof linear);
    linear.n = linear.contacts = linear.gaps = 2;
    linear.mass[0] = 3.0;
    linear.mass[1] = 1.0;
    linear.force[0] = -30.0;
    linear.q[0] = 0.2;
    linear.q[1] = tilt;
    linear.gap[0][0] = linear.gap[1][0] = 1.0;
    linear.gap[0][1] = -1.0;
    linear.gap[1][1] = 1.0;
    linear.restitution[0] = linear.restitution[1] = restitution;
    const lag_model model = linear_model();
    lag_run *run = begin(&model, LAG_OK);
    const double t = sqrt(0.04 - 0.2 * fabs(tilt)); /* h0 - |tilt| = 5 t^2 */
    CHECK(lag_run_to(run, t + 1e-9, 0) == LAG_OK);
    CHECK_NEAR(time_of(LAG_IMPACT, 0), t, 1e-12);
    if (tilt == 0.0) {
        CHECK(count_of(LAG_IMPACT) == 2);
        CHECK_NEAR(run->stepper.x[2], restitution * 10.0 * t, 1e-7);
        CHECK_NEAR(run->stepper.x[3], 0.0, 1e-7);
    } else {
        /* impulse p at the lower corner: 1/m + a^2/I = 4/3, p = (1 + e) v/(4/3) */
        const double impulse = (1.0 + restitution) * 10.0 * t * 0.75;
        CHECK_NEAR(run->stepper.x[2], -10.0 * t + impulse / 3.0, 1e-7);
        CHECK_NEAR(run->stepper.x[3], tilt > 0.0 ? -impulse : impulse, 1e-7);
    }
    CHECK(lag_run_to(run, 5.0, 0) == LAG_OK);
    CHECK_NEAR(run->stepper.x[0], 0.0, 1e-9);
    CHECK_NEAR(run->stepper.x[1], 0.0, 1e-9);
    CHECK(run->motion.w[0] == 1.0 && run->motion.w[1] == 1.0);
    free(run);
}

/* ---- with constraints ---- */

/*
 * A lever: q2 = -2 q1 (arms 1 and 2), masses 4 and 1. The second lands on a floor: seen from there the mass is 1 + 4/4 = 2. The rates
 * of both jump, so that the lever keeps together.
 */
static void a_lever_strikes(void)
{
    memset(&linear, 0, sizeof linear);
    linear.n = 2;
    linear.bars = linear.contacts = linear.gaps = 1;
    linear.mass[0] = 4.0;
    linear.mass[1] = 1.0;
    linear.force[1] = -4.0; /* 2 a = -4 */
    linear.bar[0][0] = 2.0;
    linear.bar[0][1] = 1.0;
    linear.gap[0][1] = 1.0;
    linear.q[0] = -0.5;
    linear.q[1] = 1.0;
    linear.restitution[0] = 0.5;
    const lag_model model = linear_model();
    lag_run *run = begin(&model, LAG_OK);
    CHECK(lag_run_to(run, 1.0 + 1e-9, 0) == LAG_OK);
    CHECK_NEAR(time_of(LAG_IMPACT, 0), 1.0, 1e-13);
    CHECK_NEAR(run->stepper.x[3], 1.0, 1e-8);
    CHECK_NEAR(run->stepper.x[2], -0.5, 1e-8);
    CHECK_NEAR(2.0 * run->stepper.x[2] + run->stepper.x[3], 0.0, 1e-15);
    CHECK(lag_run_to(run, 5.0, 0) == LAG_OK);
    CHECK(run->motion.w[0] == 1.0);
    CHECK(lag_motion_solve(&run->motion, run->stepper.t, run->stepper.x) == LAG_OK);
    CHECK_NEAR(run->motion.lam[1], 4.0, 1e-12);
    free(run);
}

int main(void)
{
    a_ball_bounces_and_rests();
    a_contact_rests_late();
    contacts_at_the_start();
    fixed_steps_bounce();
    a_row_of_balls();
    a_plate_on_two_corners(0.0, 0.5);
    a_plate_on_two_corners(0.0, 0.0);
    a_plate_on_two_corners(0.1, 0.3);
    a_plate_on_two_corners(-0.1, 0.0);
    a_lever_strikes();
    (void)printf("impacts: ok\n");
    return EXIT_SUCCESS;
}
