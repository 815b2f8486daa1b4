/* Events of instances against those of a run: in steps of co-simulation, by event mode, and by importers that integrate by themselves. */
#include "instances.h"
#include "machine_fmu.h"

#include "lag/instance/instance_internal.h"

static const double STOP = 2.0;
static const double TOLERANCE = 1e-9;

/* ---- a run of the same model ---- */

enum { MOST = 1000 };

static struct {
    size_t count;
    double t[MOST];
} events;

static lag_status hear(void *context, lag_run *run, const lag_event_notice *notice)
{
    (void)context;
    (void)run;
    if (notice->what == LAG_BEFORE && events.count < MOST) {
        events.t[events.count++] = notice->t;
    }
    return LAG_OK;
}

/* States at `count` times, with the events on the way. */
static lag_run *reference(size_t count, const double *times, double *rows)
{
    const lag_run_options options = {.tolerance = TOLERANCE, .length = STOP, .sizes = {MACH_GROUP, MACH_SIZES, MACH_CAPS, MACH_ROWS},
        .count = count, .times = times, .rows = rows, .callbacks.tell = hear};
    lag_run *run = lag_run_place(malloc(lag_run_size(&MACHINE, &options)), &MACHINE, &options);
    events.count = 0;
    CHECK(lag_run_begin(run, 0.0, NULL) == LAG_OK);
    CHECK(lag_run_to(run, STOP, 0) == LAG_OK);
    return run;
}

enum { POINTS = 154 };

/* Points that are at no event. */
static void grid(double *times)
{
    for (size_t k = 0; k < POINTS; ++k) {
        times[k] = k + 1 == POINTS ? STOP : 0.01307 * (double)k;
    }
}

static void compare(lag_instance *one, const double *row, double off)
{
    for (size_t i = 0; i < MACH_SIZE; ++i) {
        CHECK_NEAR(get(one, MACH_H + i), row[i], off);
    }
}

/* ---- co-simulation ---- */

static void steps(void)
{
    static double times[POINTS], rows[POINTS * MACH_SIZE];
    grid(times);
    lag_run *run = reference(POINTS, times, rows);
    lag_instance *one = begun(&MACH_FMU, 0.0, STOP, TOLERANCE);
    for (size_t k = 0; k < POINTS; ++k) {
        step_to(one, times[k], 1);
        compare(one, rows + k * MACH_SIZE, 1e-7);
    }
    CHECK(get(one, MACH_CLOSED) == 1.0 && get(one, MACH_BLOWS) == run->motion.w[BLOWS] && get(one, MACH_BLOWS) > 5.0);
    CHECK_NEAR(get(one, MACH_FORCE), 10.0, 1e-9);
    free(one);
    free(run);
}

/* Events are left to event mode; between them steps of any length. */
static void event_mode(void)
{
    static double times[POINTS], rows[POINTS * MACH_SIZE];
    lag_progress told = {.t = 0.0};
    lag_update update;
    size_t count = 0;
    unsigned changes = 0;
    grid(times);
    lag_run *run = reference(POINTS, times, rows);
    lag_instance *one = begun(&MACH_FMU, 0.0, STOP, TOLERANCE);
    for (size_t k = 1; k < POINTS; ++k) {
        while (told.t < times[k]) {
            CHECK_OK(one, lag_instance_step(one, times[k] - told.t, LAG_STOP_EVENTS, &told));
            CHECK(told.early == (told.t < times[k]) && (told.event || !told.early));
            if (told.event) {
                CHECK_NEAR(told.t, count < events.count ? events.t[count] : STOP, 1e-9); /* the run leaves the tick at the stop to its end */
                ++count;
                CHECK_OK(one, lag_instance_update(one, &update));
                changes += update.states_changed != 0;
                CHECK(update.next > told.t && update.next <= told.t + 0.05 + 1e-12);
            }
        }
        compare(one, rows + k * MACH_SIZE, 1e-7);
    }
    CHECK(count == events.count + 1 && changes > 5);
    free(one);
    free(run);
}

/* Every step of the integrator is one; values are those there. */
static void every_step(void)
{
    lag_progress told = {.t = 0.0};
    size_t count = 0;
    lag_instance *one = begun(&MACH_FMU, 0.0, STOP, TOLERANCE);
    while (told.t < STOP) {
        const double before = told.t;
        CHECK_OK(one, lag_instance_step(one, STOP - told.t, LAG_STOP_STEPS, &told));
        CHECK(told.t > before && told.t == get(one, MACH_TIME) && !told.event);
        ++count;
    }
    CHECK(count > events.count);
    free(one);
}

/* ---- importers ---- */

typedef struct importer {
    lag_instance *one;
    double t, next;
    double x[MACH_SIZE];
    size_t events;
} importer;

/* The classical Runge-Kutta method; the result is set. */
static void rk4(importer *own, double h, double *x)
{
    static const double node[4] = {0.0, 0.5, 0.5, 1.0};
    static const double weight[4] = {1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0};
    double slope[MACH_SIZE] = {0.0};
    double at[MACH_SIZE];
    memcpy(x, own->x, sizeof own->x);
    for (size_t k = 0; k < 4; ++k) {
        for (size_t i = 0; i < MACH_SIZE; ++i) {
            at[i] = own->x[i] + node[k] * h * slope[i];
        }
        lag_instance_set_time(own->one, own->t + node[k] * h);
        lag_instance_set_states(own->one, at);
        CHECK_OK(own->one, lag_instance_vector(own->one, LAG_ROLE_DERIVATIVE, slope));
        for (size_t i = 0; i < MACH_SIZE; ++i) {
            x[i] += weight[k] * h * slope[i];
        }
    }
    lag_instance_set_time(own->one, own->t + h);
    lag_instance_set_states(own->one, x);
}

static int crosses(importer *own, const double *before)
{
    double g[2];
    CHECK_OK(own->one, lag_instance_vector(own->one, LAG_ROLE_INDICATOR, g));
    return (g[0] > 0.0) != (before[0] > 0.0) || (g[1] > 0.0) != (before[1] > 0.0);
}

/* One step of at most h, cut at the first event where events are located. */
static void advance(importer *own, double h, int locate)
{
    double before[2];
    double x[MACH_SIZE];
    int event = 0;
    int late = 0;
    lag_instance_set_states(own->one, own->x);
    CHECK_OK(own->one, lag_instance_vector(own->one, LAG_ROLE_INDICATOR, before));
    if (own->t + h >= own->next) {
        h = own->next - own->t;
        late = 1;
    }
    rk4(own, h, x);
    const int crossed = crosses(own, before);
    if (crossed && locate) {
        double left = 0.0;
        double right = h;
        while (right - left > 1e-14) {
            const double middle = 0.5 * (left + right);
            rk4(own, middle, x);
            *(crosses(own, before) ? &right : &left) = middle;
        }
        h = right;
        late = 0;
        rk4(own, h, x);
    }
    own->t = late ? own->next : own->t + h;
    memcpy(own->x, x, sizeof x);
    lag_instance_set_time(own->one, own->t);
    CHECK_OK(own->one, lag_instance_completed(own->one, &event));
    if (event || crossed || late) {
        lag_update update;
        ++own->events;
        CHECK_OK(own->one, lag_instance_update(own->one, &update));
        CHECK_OK(own->one, lag_instance_vector(own->one, LAG_ROLE_STATE, own->x));
        CHECK(!update.terminate && update.next > own->t);
        own->next = update.next;
    }
}

static importer importing(void)
{
    lag_update update;
    importer own = {.one = placed(&MACH_FMU, 0.0, STOP, TOLERANCE)};
    CHECK_OK(own.one, lag_instance_begin(own.one));
    CHECK_OK(own.one, lag_instance_update(own.one, &update));
    CHECK_NEAR(update.next, 0.05, 1e-15);
    CHECK_OK(own.one, lag_instance_vector(own.one, LAG_ROLE_STATE, own.x));
    own.next = update.next;
    return own;
}

static void exchange(void)
{
    static double times[POINTS], rows[POINTS * MACH_SIZE];
    grid(times);
    lag_run *run = reference(POINTS, times, rows);
    importer own = importing();
    for (size_t k = 1; k < POINTS; ++k) {
        while (own.t < times[k] - 1e-13) {
            advance(&own, fmin(0.002, times[k] - own.t), 1);
        }
        compare(own.one, rows + k * MACH_SIZE, 1e-7);
    }
    /* bounces that stay within the dead band are rest */
    CHECK(get(own.one, MACH_CLOSED) == 1.0 && get(own.one, MACH_BLOWS) <= run->motion.w[BLOWS] && get(own.one, MACH_BLOWS) > run->motion.w[BLOWS] - 3.0);
    free(own.one);
    free(run);
}

/* An importer that finds events late: the ball is in the floor by what it moved in one step at most, and comes to rest on it. */
static void coarse(void)
{
    const double h = 0.003;
    importer own = importing();
    while (own.t < STOP) {
        advance(&own, h, 0);
        CHECK(own.x[0] > -2.0 * h && own.x[1] < 0.12);
    }
    CHECK(get(own.one, MACH_CLOSED) == 1.0 && own.events < 300);
    CHECK_NEAR(own.x[0], 0.0, 1e-9);
    CHECK_NEAR(get(own.one, MACH_FORCE), 10.0, 1e-6);
    free(own.one);
}

/* ---- ends ---- */

static int fails;

static lag_status ending(const lag_arguments *at, double *next, double *reset, double *value, double *collision, double *restitution,
    double *stop, double *fail)
{
    const lag_status status = machine_event(at, next, reset, value, collision, restitution, stop, fail);
    stop[0] = !fails && at->w[BEYOND] != 0.0;
    fail[0] = fails && at->w[BEYOND] != 0.0;
    return status;
}

static void ends(void)
{
    static const char *const stops[1] = {"beyond"};
    static const char *const failures[1] = {"too far"};
    lag_model model = MACHINE;
    lag_fmu fmu = MACH_FMU;
    lag_progress told;
    model.nstop = model.nfail = 1;
    model.stops = stops;
    model.failures = failures;
    model.event = ending;
    fmu.model = &model;
    for (fails = 0; fails < 2; ++fails) {
        lag_instance *one = begun(&fmu, 0.0, STOP, TOLERANCE);
        const lag_status status = lag_instance_step(one, 1.0, 0, &told);
        CHECK(status == (fails ? LAG_ASSERTION_FAILED : LAG_OK));
        CHECK(told.early && told.t > 0.05 && told.t < 0.2 && told.terminate == !fails && told.t == get(one, MACH_TIME));
        CHECK_NEAR(get(one, MACH_X), 0.1, 1e-9);
        CHECK(strstr(lag_instance_message(one), fails ? "too far" : "beyond") != NULL);
        free(one);
    }
}

int main(void)
{
    steps();
    event_mode();
    every_step();
    exchange();
    coarse();
    ends();
    (void)printf("instance_events: ok\n");
    return EXIT_SUCCESS;
}
