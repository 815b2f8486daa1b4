/*
 * States to start from against closed forms. Points 0 and 1 are bound to circles of radius p, in coordinates (x0, y0, x1, y1); one state
 * of first order follows der(a) = x0 - a; an initial equation, where there is one, lets it be at rest.
 */
#include <string.h>

#include "check.h"
#include "lag/initial.h"
#include "lag/linalg/arena.h"
#include "lag/run.h"

enum { SIZE = 9, N = 4, A = 8 };

static size_t twice; /* 1: the first circle a second time */

static lag_status prepare(const lag_arguments *at)
{
    (void)at;
    return LAG_OK;
}

static lag_status start(const lag_arguments *at, double *q, double *qd, double *z, double *u)
{
    (void)u;
    q[0] = 0.3 * at->p[0];
    q[1] = 0.4 * at->p[0];
    q[2] = -0.8;
    q[3] = 0.6;
    qd[0] = 1.0;
    qd[1] = qd[2] = qd[3] = 0.0;
    z[0] = 5.0;
    return LAG_OK;
}

static void rows(const lag_arguments *at, const double *x, double *value, double *jacobian)
{
    const size_t count = 2 + twice;
    lag_fill(count * N, 0.0, jacobian);
    for (size_t i = 0; i < count; ++i) {
        const size_t j = i == 1 ? 2 : 0;
        value[i] = at->q[j] * x[j] + at->q[j + 1] * x[j + 1];
        jacobian[i * N + j] = 2.0 * at->q[j];
        jacobian[i * N + j + 1] = 2.0 * at->q[j + 1];
    }
}

static lag_status position(const lag_arguments *at, double *phi, double *jacobian)
{
    rows(at, at->q, phi, jacobian);
    phi[0] -= at->p[0] * at->p[0];
    phi[1] -= 1.0;
    if (twice) {
        phi[2] -= at->p[1] * at->p[1];
    }
    return LAG_OK;
}

static lag_status velocity(const lag_arguments *at, double *residual, double *jacobian)
{
    rows(at, at->qd, residual, jacobian);
    for (size_t i = 0; i < 2 + twice; ++i) {
        residual[i] *= 2.0;
    }
    return LAG_OK;
}

/* Mass 1 in x, 4 in y. */
static lag_status mass(const lag_arguments *at, double *m)
{
    (void)at;
    lag_fill((size_t)N * N, 0.0, m);
    for (int i = 0; i < N; ++i) {
        m[i * N + i] = i % 2 == 0 ? 1.0 : 4.0;
    }
    return LAG_OK;
}

static lag_status dynamics(const lag_arguments *at, double *m, double *force, double *jacobian, double *gamma)
{
    double phi[3];
    lag_fill(N, 0.0, force);
    (void)position(at, phi, jacobian);
    for (size_t i = 0; i < 2 + twice; ++i) {
        const size_t j = i == 1 ? 2 : 0;
        gamma[i] = -2.0 * (at->qd[j] * at->qd[j] + at->qd[j + 1] * at->qd[j + 1]);
    }
    return mass(at, m);
}

static lag_status no_rates(const lag_arguments *at, double *rates)
{
    (void)at;
    rates[0] = 0.0;
    return LAG_OK;
}

static lag_status at_rest(const lag_arguments *at, double *residual)
{
    residual[0] = at->q[0] - at->z[0];
    return LAG_OK;
}

static const lag_slot Q[N] = {{"x0", "m", NULL}, {"y0", "m", NULL}, {"x1", "m", NULL}, {"y1", "m", NULL}};
static const lag_slot Z[1] = {{"a", "m", NULL}};
static const lag_slot ROWS[3] = {{"c0", "m2", NULL}, {"c1", "m2", NULL}, {"c2", "m2", NULL}};
static const double P[2] = {1.0, 1.0};
static const unsigned char ONES[3] = {1, 1, 1};
static const unsigned char NONE[3] = {0, 0, 0};
static const size_t ROW[4] = {0, 0, 1, 1};
static const size_t COLUMN[4] = {0, 1, 2, 3};
static const size_t FIRST[3] = {0, 2, 4};
static const lag_pattern PATTERN = {2, 4, 4, ROW, COLUMN, FIRST};
static const lag_patterns PATTERNS = {.jacobian = &PATTERN};

static lag_model model_of(size_t second, size_t equations)
{
    const lag_model model = {.version = LAG_MODEL_VERSION,
        .size = sizeof(lag_model),
        .name = "Circles",
        .nq = N,
        .nz = 1,
        .np = 2,
        .nc = 2 + second,
        .ne = equations,
        .rank = 2,
        .coordinates = Q,
        .states = Z,
        .constraints = ROWS,
        .defaults = P,
        .position_level = ONES,
        .redundant = NONE,
        .patterns = second ? NULL : &PATTERNS,
        .prepare = prepare,
        .start = start,
        .position_constraint = position,
        .velocity_constraint = velocity,
        .mass_matrix = mass,
        .dynamics = dynamics,
        .state_derivative = no_rates,
        .initial_equation = at_rest};
    twice = second;
    return model;
}

/* From the start values of the model, changed where `set`. */
static lag_status find(const lag_model *model, const lag_start *said, const double *p, const double *changed, const unsigned char *set,
    double *x, lag_initial *told)
{
    lag_motion motion;
    double *memory = calloc(lag_motion_memory(model) + lag_initial_memory(model), sizeof(double));
    CHECK(memory != NULL);
    lag_motion_place(&motion, model, memory);
    CHECK(lag_motion_parameters(&motion, p) == LAG_OK);
    CHECK(lag_motion_start(&motion, 0.0, x) == LAG_OK);
    for (size_t i = 0; set != NULL && i < SIZE; ++i) {
        x[i] = set[i] ? changed[i] : x[i];
    }
    const lag_status status = lag_initial_find(&motion, said, set, 0.0, x, memory + lag_motion_memory(model), told);
    free(memory);
    return status;
}

static void nearest_points(void)
{
    const lag_model model = model_of(0, 0);
    double x[SIZE];
    lag_initial told = {.dependent = NULL};
    CHECK(find(&model, NULL, P, NULL, NULL, x, &told) == LAG_OK);
    CHECK_NEAR(x[0], 0.6, 1e-14); /* along the ray from the center; the other point is where it was, to the bit */
    CHECK_NEAR(x[1], 0.8, 1e-14);
    CHECK(x[2] == -0.8 && x[3] == 0.6 && x[A] == 5.0);
    /* rates: the part along the circle in the metric of M, that of (0.8, -0.6): v = e (e' M v0)/(e' M e) */
    const double along = 0.8 / (0.64 + 4.0 * 0.36);
    CHECK_NEAR(x[4], 0.8 * along, 1e-14);
    CHECK_NEAR(x[5], -0.6 * along, 1e-14);
    CHECK(x[6] == 0.0 && x[7] == 0.0);
    CHECK(told.fault == LAG_INITIAL_NONE && told.moved);
    /* another radius: start values follow, the second circle stays */
    const double larger[2] = {2.0, 1.0};
    CHECK(find(&model, NULL, larger, NULL, NULL, x, &told) == LAG_OK);
    CHECK_NEAR(x[0], 1.2, 1e-14);
    CHECK_NEAR(x[1], 1.6, 1e-14);
    CHECK(told.rank == 2);
}

/* A fixed coordinate holds, the other takes the nearer of the two ways; a written rate goes before those that are not. */
static void fixed_and_written(void)
{
    const lag_model model = model_of(0, 0);
    const unsigned char fixed[SIZE] = {1, 0, 0, 0, 0, 0, 0, 0, 0};
    const unsigned char written[SIZE] = {1, 0, 0, 0, 0, 1, 0, 0, 0};
    const unsigned char set[SIZE] = {1, 1, 0, 0, 0, 1, 0, 0, 1};
    const double changed[SIZE] = {-0.28, -0.1, 0.0, 0.0, 0.0, 0.7, 0.0, 0.0, -3.0};
    const lag_start said = {.fixed = fixed, .written = written};
    double x[SIZE];
    CHECK(find(&model, &said, P, changed, set, x, NULL) == LAG_OK);
    CHECK(x[0] == -0.28);
    CHECK_NEAR(x[1], -0.96, 1e-14);
    CHECK(x[5] == 0.7 && x[A] == -3.0);
    CHECK_NEAR(x[4], -0.96 * 0.7 / 0.28, 1e-14);
}

/*
 * The point of the circle nearest to (0.3, 0.4): with y written, y holds; where y weighs 100 times x, it is the root of the secular
 * equation (x, y) = (0.3/(1 + l), 40/(100 + l)). Nominal values weigh as their squares. A distance is flat where it is the smallest: half the digits.
 */
static void weights(void)
{
    const lag_model model = model_of(0, 0);
    const unsigned char written[SIZE] = {0, 1, 0, 0, 0, 0, 0, 0, 0};
    const double nominal[SIZE] = {10.0, 1.0, 1.0, 1.0, 10.0, 1.0, 1.0, 1.0, 1.0};
    const lag_start by_hand = {.written = written};
    const lag_start by_size = {.nominal = nominal};
    double x[SIZE];
    double low = -0.9999;
    double high = 0.0;
    for (int i = 0; i < 200; ++i) {
        const double l = 0.5 * (low + high);
        const double length = hypot(0.3 / (1.0 + l), 40.0 / (100.0 + l));
        low = length > 1.0 ? l : low;
        high = length > 1.0 ? high : l;
    }
    CHECK(find(&model, &by_hand, P, NULL, NULL, x, NULL) == LAG_OK);
    CHECK_NEAR(x[0], sqrt(1.0 - 0.4 * 0.4), 1e-12);
    CHECK(x[1] == 0.4);
    CHECK(find(&model, &by_size, P, NULL, NULL, x, NULL) == LAG_OK);
    CHECK_NEAR(x[0], 0.3 / (1.0 + low), 1e-8);
    CHECK_NEAR(x[1], 40.0 / (100.0 + low), 1e-8);
}

/* From the center of the circle every way is as good: a stationary point that is not the nearest is left. */
static void away_from_the_center(void)
{
    const lag_model model = model_of(0, 0);
    const unsigned char set[SIZE] = {1, 1, 0, 0, 0, 0, 0, 0, 0};
    const double far[SIZE] = {-3.0, 1e-9, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
    const double center[SIZE] = {0.0};
    double x[SIZE];
    CHECK(find(&model, NULL, P, center, set, x, NULL) == LAG_OK);
    CHECK_NEAR(hypot(x[0], x[1]), 1.0, 1e-12);
    CHECK(find(&model, NULL, P, far, set, x, NULL) == LAG_OK);
    CHECK_NEAR(x[0], -1.0, 1e-12);
}

static void equations(void)
{
    const lag_model model = model_of(0, 1);
    const unsigned char fixed[SIZE] = {0, 0, 0, 0, 0, 0, 0, 0, 1};
    const lag_start said = {.fixed = fixed};
    const unsigned char set[SIZE] = {0, 0, 0, 0, 0, 0, 0, 0, 1};
    double changed[SIZE] = {0.0};
    double x[SIZE];
    lag_initial told = {.dependent = NULL};
    CHECK(find(&model, NULL, P, NULL, NULL, x, &told) == LAG_OK);
    CHECK_NEAR(x[A], x[0], 1e-11);
    CHECK_NEAR(hypot(x[0], x[1]), 1.0, 1e-11);
    CHECK_NEAR(x[0] * x[4] + x[1] * x[5], 0.0, 1e-11);
    changed[A] = -0.6;
    CHECK(find(&model, &said, P, changed, set, x, &told) == LAG_OK);
    CHECK(x[A] == -0.6);
    CHECK_NEAR(x[0], -0.6, 1e-10);
    CHECK_NEAR(fabs(x[1]), 0.8, 1e-10);
    changed[A] = 1.5; /* no point of the circle is there */
    CHECK(find(&model, &said, P, changed, set, x, &told) == LAG_PROJECTION_FAILED);
    CHECK(told.fault == LAG_INITIAL_EQUATIONS && told.residual > 1e-3);
}

/* A free radius of the first circle: as large as the fixed point asks for. */
static void free_parameters(void)
{
    const lag_model model = model_of(0, 1);
    const unsigned char fixed[SIZE] = {1, 1, 0, 0, 0, 0, 0, 0, 0};
    const unsigned char set[SIZE] = {1, 1, 0, 0, 0, 0, 0, 0, 0};
    const double changed[SIZE] = {1.2, 0.9};
    const unsigned char first[2] = {1, 0};
    const unsigned char both[2] = {1, 1};
    const double least[2] = {0.0, 0.0};
    const double most[2] = {2.0, 2.0};
    const double low[2] = {1.4, 1.4};
    lag_start said = {.fixed = fixed, .free = first, .parameter_minimum = least, .parameter_maximum = most};
    double x[SIZE];
    double p[2];
    lag_initial told = {.p = p};
    CHECK(find(&model, &said, P, changed, set, x, &told) == LAG_OK);
    CHECK(x[0] == 1.2 && x[1] == 0.9 && p[1] == 1.0);
    CHECK_NEAR(p[0], 1.5, 1e-10);
    CHECK_NEAR(x[A], 1.2, 1e-10);
    said.parameter_maximum = low;
    CHECK(find(&model, &said, P, changed, set, x, &told) == LAG_PROJECTION_FAILED);
    CHECK(told.fault == LAG_INITIAL_BOUNDS && told.which == 0);
    CHECK_NEAR(told.residual, 1.5, 1e-10);
    said.free = both; /* the second radius is in no equation */
    CHECK(find(&model, &said, P, changed, set, x, &told) == LAG_PROJECTION_FAILED);
    CHECK(told.fault == LAG_INITIAL_PARAMETERS && told.which == 1);
    told.p = NULL; /* nobody asks for them: they are held */
    said.free = first;
    CHECK(find(&model, &said, P, changed, set, x, &told) == LAG_PROJECTION_FAILED);
    CHECK(told.fault == LAG_INITIAL_POSITIONS || told.fault == LAG_INITIAL_EQUATIONS);
}

static void faults(void)
{
    const lag_model model = model_of(0, 0);
    const unsigned char fixed[SIZE] = {1, 0, 1, 1, 0, 0, 1, 1, 0};
    const lag_start said = {.fixed = fixed};
    const unsigned char set[SIZE] = {1, 0, 0, 0, 0, 0, 0, 0, 0};
    const unsigned char of_rate[SIZE] = {0, 0, 0, 0, 0, 0, 1, 0, 0};
    double changed[SIZE] = {1.5};
    double x[SIZE];
    lag_initial told = {.dependent = NULL};
    CHECK(find(&model, &said, P, changed, set, x, &told) == LAG_PROJECTION_FAILED); /* beyond the circle */
    CHECK(told.fault == LAG_INITIAL_POSITIONS && told.which == 0);
    CHECK_NEAR(told.residual, 1.25, 1e-6);
    changed[6] = 0.5; /* fixed rates that leave the circle */
    CHECK(find(&model, &said, P, changed, of_rate, x, &told) == LAG_PROJECTION_FAILED);
    CHECK(told.fault == LAG_INITIAL_RATES && (told.which == 1 || told.which == 2 + 2 || told.which == 2 + 3));
    changed[0] = (double)NAN;
    CHECK(find(&model, &said, P, changed, set, x, &told) == LAG_NOT_FINITE);
    CHECK(told.fault == LAG_INITIAL_NUMBERS && told.which == 0);
}

/* The same circle twice has two independent rows; two circles of different size have no common point. */
static void other_ranks(void)
{
    lag_model model = model_of(1, 0);
    const unsigned char set[SIZE] = {0, 0, 1, 0, 0, 0, 0, 0, 0};
    const double changed[SIZE] = {0.0, 0.0, -0.7};
    const double apart[2] = {1.0, 1.3};
    double x[SIZE];
    unsigned char dependent[3] = {7, 7, 7};
    lag_initial told = {.dependent = dependent};
    CHECK(find(&model, NULL, P, changed, set, x, &told) == LAG_OK);
    CHECK(told.rank == 2);
    CHECK(!dependent[0] && !dependent[1] && dependent[2]);
    CHECK_NEAR(x[0], 0.6, 1e-12);
    CHECK(find(&model, NULL, apart, changed, set, x, &told) == LAG_PROJECTION_FAILED);
    CHECK(told.fault == LAG_INITIAL_POSITIONS);
    model.rank = 1;
    CHECK(find(&model, NULL, P, changed, set, x, &told) == LAG_PROJECTION_FAILED);
    CHECK(told.fault == LAG_INITIAL_RANK && told.which == 1);
}

/* A run without a given state begins there, and row 2, which repeats row 0, does not count in it. */
static void of_a_run(void)
{
    const lag_model model = model_of(1, 0);
    const unsigned char written[SIZE] = {0, 1, 0, 0, 0, 0, 0, 0, 0};
    const lag_start said = {.written = written};
    const double larger[2] = {2.0, 2.0};
    const lag_run_options options = {.p = larger, .start = &said, .careful = 1};
    double x[SIZE];
    CHECK(find(&model, &said, larger, NULL, NULL, x, NULL) == LAG_OK);
    lag_run *run = lag_run_place(malloc(lag_run_size(&model, &options)), &model, &options);
    CHECK(lag_run_begin(run, 0.0, NULL) == LAG_OK);
    for (size_t i = 0; i < SIZE; ++i) {
        CHECK(run->stepper.x[i] == x[i]);
    }
    CHECK(run->ranks.dependent[2] && run->ranks.lasting[2] == 0.0 && run->ranks.lasting[0] == 1.0);
    free(run);
}

int main(void)
{
    of_a_run();
    nearest_points();
    fixed_and_written();
    weights();
    away_from_the_center();
    equations();
    free_parameters();
    faults();
    other_ranks();
    (void)printf("initial: ok\n");
    return EXIT_SUCCESS;
}
